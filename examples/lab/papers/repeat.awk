# repeat.awk - measures the figures of PAPERS.md's tables again that stand below commands: each that differs is printed,
# and the status is then 1.
#    awk -f examples/lab/papers/repeat.awk [-v long=1] [-v at=BUILD] [-v folder=FOLDER] examples/docs/PAPERS.md
# A block of commands has two words in capitals at most. The one that is the first column's head stands for the cells of
# that column, the other one for the other heads. If a cell has several names in backticks, the figure is their mean. A
# remark shows the line that the last command prints: N is the figure, .. is any text, and "HEAD: " in front of it says
# which column it is of. A block that begins with "# long" is run with long=1. The commands are those of BUILD [the
# current folder], run in FOLDER [a new one].

BEGIN {
    if (!at) "pwd" | getline at
    if (!folder) "mktemp -d" | getline made
    if (!folder) folder = made
}
function fail(line, text) { print FILENAME ":" line ": " text; wrong = 1 }

# A remark's part as a regular expression.
function literal(text) {
    gsub(/[(+*?[\]|^$]/, "[&]", text)
    gsub(/\.\./, "\001", text)
    gsub(/\./, "[.]", text)
    gsub(/\001/, ".*", text)
    return text
}
# What a cell stands for: its names in backticks, else all of it.
function names(text, list,    count, part, i) {
    count = split(text, part, "`")
    list[1] = text
    for (i = 2; i < count; i += 2) list[i / 2] = part[i]
    return count < 3 ? 1 : int(count / 2)
}
# The word in capitals that is not the rows'.
function other(    i, text) {
    for (i = 1; i <= commands; ++i)
        for (text = command[i]; match(text, /[A-Z][A-Z]+/); text = substr(text, RSTART + RLENGTH))
            if (substr(text, RSTART, RLENGTH) != word) return substr(text, RSTART, RLENGTH)
    return ""
}
# What is printed for a column.
function remark_of(head,    i) {
    if (across != "") return shown[1]
    for (i = 1; i <= remarks; ++i) if (index(shown[i], head ": ") == 1) return substr(shown[i], length(head) + 3)
    return ""
}
# The figure that the last command prints. Those before it run once, in a folder of their own.
function measure(row, column, remark,    i, text, line, lines, begin, end, value, before) {
    for (i = 1; i <= commands; ++i) {
        before = before (i > 1 ? " && " text " >/dev/null" : "")
        text = command[i]
        gsub(word, row, text)
        if (across != "") gsub(across, column, text)
        gsub(/build\//, at "/build/", text)
    }
    if (!(before in place)) {
        place[before] = "cd " folder " && mkdir -p " ++places " && cd " places
        system(place[before] before)
    }
    begin = end = remark
    sub(/N.*/, "", begin)
    sub(/.*N/, "", end)
    begin = literal(begin)
    text = place[before] " && " text " 2>&1"
    if (!(text in printed)) {
        while ((text | getline line) > 0) printed[text] = printed[text] line "\n"
        close(text)
    }
    before = split(printed[text], lines, "\n")
    for (i = 1; i <= before; ++i)
        if (match(lines[i], begin "[-+]?[0-9][0-9.]*" literal(end))) {
            value = substr(lines[i], RSTART, RLENGTH)
            sub("^" begin, "", value)
            return value + 0
        }
    return ""
}
# A figure may differ from the mean of those that are measured by 1 % and by half of its last digit.
function judge(r, c,    rows, columns, i, j, row, column, sum, found, digits, off) {
    rows = names(cell[r, 1], row)
    columns = across != "" ? names(head[c], column) : 1
    for (i = 1; i <= rows; ++i)
        for (j = 1; j <= columns; ++j) {
            found = measure(row[i], column[j], remark_of(head[c]))
            if (found == "") return fail(at_line[r], cell[r, 1] ", " head[c] ": the commands print no such figure")
            sum += found / (rows * columns)
        }
    ++measured
    digits = index(cell[r, c], ".") ? length(cell[r, c]) - index(cell[r, c], ".") : 0
    off = sum - cell[r, c]
    if (off * off > (0.5001 * 10 ^ -digits + 0.01 * (sum < 0 ? -sum : sum)) ^ 2)
        fail(at_line[r], cell[r, 1] ", " head[c] ": " cell[r, c] ", and is " sprintf("%.*f", digits, sum))
}
function table_ends(    c, r) {
    for (c = 2; c <= heads && (!slow || long); ++c)
        for (r = 1; r <= rows_of_table; ++r) if (cell[r, c] ~ /^[-+.0-9]+$/) judge(r, c)
    commands = heads = 0
}

/^```sh/ {
    inside = 1
    commands = remarks = heads = slow = 0
    next
}
/^```/ { inside = 0 }
inside && /^# long/ { slow = 1; next }
inside {
    text = $0
    while (text ~ /\\$/ && (getline more) > 0) { sub(/\\$/, "", text); sub(/^ +/, "", more); text = text more }
    i = index(text, "# ")
    if (i) {
        shown[++remarks] = substr(text, i + 2)
        text = substr(text, 1, i - 1)
    }
    if (text ~ /[^ ]/) command[++commands] = text
    next
}
commands && /^\|/ {
    count = split($0, part, "|") - 2
    for (i = 1; i <= count; ++i) gsub(/^ +| +$|\*/, "", part[i + 1])
    if (!heads) {
        heads = count
        rows_of_table = 0
        for (i = 1; i <= count; ++i) head[i] = part[i + 1]
        word = head[1]
        across = other()
    } else if (part[2] !~ /^-+$/) {
        at_line[++rows_of_table] = FNR
        for (i = 1; i <= count; ++i) cell[rows_of_table, i] = part[i + 1]
    }
    next
}
heads { table_ends() }
END {
    if (heads) table_ends()
    if (!measured) fail(FNR, "no figure was measured")
    print measured " figures were measured again"
    if (made) system("rm -rf " made)
    exit wrong
}
