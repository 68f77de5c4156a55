# Prints names in the headers' comments and in README.md that the headers do not have; then the status is 1.
#    awk -f tests/library/names.awk ssgi.h ssgi_gl.h look=1 ssgi.h ssgi_gl.h README.md
# The first reading collects identifiers, members of structs, and passes. The second one looks at comments, also those
# in GLSL: at ssgi_*, SSGI_*, paths as desc.gather.samples, headings of groups, and the word that follows "pass".

BEGIN {
    split("a alone and are around as before between chain does draws ignore in is looks names of reads tell that turn " \
          "use which with write writes", all, " ") # words behind "pass" that name no pass
    for (i in all) words[all[i]] = 1
    split("SSGI_GL_KIND_WORD SSGI_NAME", all, " ")
    for (i in all) words[all[i]] = 1
}
FNR == 1 { inside = over = 0 }
/^   CHANGES in/ { over = 1 } # names of earlier versions
over { next }
FILENAME ~ /\.md$/ { check($0, FNR); next }

# Splits a line into code and comment. A comment is looked at when it ends. In a string, which is GLSL, // begins one.
{
    line = $0
    code = ""
    while (line != "") {
        mark = inside ? "*/" : line ~ /^ *"/ ? "//" : "/*"
        at = index(line, mark)
        part = at ? substr(line, 1, at - 1) : line
        line = at ? substr(line, at + 2) : ""
        if (inside) comment = comment " " part
        else code = code part
        if (at && mark == "//") { check(line, FNR); line = "" }
        else if (at && inside) { check(comment, begins); inside = 0 }
        else if (at) { inside = 1; comment = ""; begins = FNR }
    }
}

!look {
    for (rest = code; match(rest, /[A-Za-z_][A-Za-z_0-9]*/); rest = substr(rest, RSTART + RLENGTH))
        known[substr(rest, RSTART, RLENGTH)] = 1
    if (match(code, /SSGI_GL__PASS\([A-Z0-9_]+, "[a-z0-9_]+"/)) { split(code, word, "\""); pass[word[2]] = 1 }
    if (code ~ /^typedef struct [a-z_]+ \{/) { split(code, word, " "); of = word[3]; struct_[of] = 1 }
    else if (code ~ /^}/) of = ""
    else if (of != "" && code ~ /;/) {
        gsub(/\[[^]]*\]|^ *(const )?/, "", code)
        type = code
        sub(/ .*/, "", type)
        if (match(code, /\(\*[a-z_]+\)/)) code = substr(code, RSTART + 2, RLENGTH - 3)
        n = split(code, word, ",")
        for (i = 1; i <= n; ++i) { sub(/;.*/, "", word[i]); sub(/.*[ *]/, "", word[i]); member[of, word[i]] = type }
    }
}

function bad(name, line) { printf "%s:%d: %s\n", FILENAME, line, name; wrong = 1 }

# Returns whether a path of members exists in one of several structs.
function leads(structs, path, n, all, steps, i, k, at, parts) {
    n = split(structs, all, " ")
    steps = split(path, parts, ".")
    for (i = 1; i <= n; ++i) {
        at = all[i]
        for (k = 1; k <= steps && (at, parts[k]) in member; ++k) at = member[at, parts[k]]
        if (k > steps) return 1
    }
    return 0
}

function check(text, line, name, root, path, structs, rest, i, of) {
    if (!look) return
    if (match(text, /---- desc\.[a-z.]+:/)) {
        of = substr(text, RSTART + 10, RLENGTH - 11)
        if (member["ssgi_gl_desc", of] != "ssgi_gl_" of "_desc") bad("desc." of, line)
    }
    for (rest = text; match(rest, /(^| )pass(es)? \(?(but )?[a-z][a-z_0-9]*/); rest = substr(rest, RSTART + RLENGTH)) {
        name = substr(rest, RSTART, RLENGTH)
        sub(/.* \(?/, "", name)
        if (!(name in pass) && !(name in words)) bad("pass " name, line)
    }
    for (; match(text, /[A-Za-z_][A-Za-z_0-9]*((\.|->)[a-z][a-z_0-9]*)*/); text = substr(text, RSTART + RLENGTH)) {
        name = substr(text, RSTART, RLENGTH)
        root = path = name
        gsub(/->/, ".", path)
        sub(/[.-].*/, "", root)
        if (!sub(/^[^.]*\./, "", path)) path = ""
        structs = root in struct_ ? root : root == "desc" ? "ssgi_gl_desc ssgi_surfel_desc ssgi_field_desc" : ""
        for (i = 1; i <= 3; ++i) {
            of = (i == 3 ? "ssgi_" : "ssgi_gl_") root (i == 1 ? "_desc" : "")
            if (of in struct_) structs = structs " " of
        }
        if (path != "" && structs != "" && !leads(structs, path)) bad(name, line)
        if (root ~ /^(.?_?ssgi_|SSGI_).*[^_]$/ && path != "h" && !(root in known) && !(root in words)) bad(root, line)
    }
}

END { exit wrong }
