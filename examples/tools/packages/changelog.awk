# changelog.awk - CHANGES at the end of ssgi.h as Markdown: awk -f changelog.awk ssgi.h >CHANGELOG.md
# Names are marked as code. Lines of code and of the table "old -> new" stand in blocks of code.
function marked(line,    count, words, i, word, from, to) {
    count = split(line, words, " ")
    line = ""
    for (i = 1; i <= count; ++i) {
        word = words[i]
        from = to = ""
        while (word ~ /^[("]/) { from = from substr(word, 1, 1); word = substr(word, 2) }
        while (word ~ /[]).,;:"]$/) { to = substr(word, length(word)) to; word = substr(word, 1, length(word) - 1) }
        if (word ~ /^[A-Za-z0-9_.*]+$/ && word ~ /[._]/ && word !~ /^[0-9.]+$/) word = "`" word "`"
        line = line (i > 1 ? " " : "") from word to
    }
    return line
}
function block(now) { if (now != inside) print "```"; inside = now }
BEGIN { print "# Changes" }
/^   CHANGES in [0-9]/ { block(0); sub(/^   CHANGES in /, "## "); print "\n" $0 "\n"; blank = ""; on = 1; next }
!on { next }
{ last = sub(/ *\*\/$/, ""); sub(/^   /, "") }
/^$/ { blank = blank "\n"; next }
{
    code = /^   / || ($2 == "->" && !/[;,]/)
    if (!code) block(0)
    printf "%s", blank
    if (code) block(1)
    blank = ""
    print code ? $0 : marked($0)
}
last { block(0); exit }
