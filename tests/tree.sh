#!/bin/sh
# tree.sh - fails if a room of examples/ calls one above it, or if files of the kit call each other in a circle. nm
# lists the symbols that each object file defines and needs.
#
#   make tree                  of the kit, build/render and build/report
#   sh tests/tree.sh FILE.o .. of these
#
# A room is a folder. Rooms of the same height do not call each other.
edges=$(mktemp) || exit 2
trap 'rm -f "$edges"' EXIT
for f in "$@"; do nm -P -g "$f" | awk -v f="$f" '{ print ($2 == "U" ? "asks" : "has"), f, $1 }'; done | sort | awk '
    # Returns the height of a file, by its folder; in the laboratory, from below: measure, page, chart, papers, commands
    function height(f) {
        return f ~ /^build\/examples\/lab\/papers\// ? 9 : f ~ /^build\/examples\/lab\/chart\// ? 8 \
             : f ~ /^build\/examples\/lab\/page\// ? 7 : f ~ /^build\/examples\/lab\/measure\// ? 6 \
             : f ~ /^build\/examples\/lab\// ? 10 : f ~ /^build\/examples\// ? 5 : f ~ /^build\/kit\/run\// ? 4 \
             : f ~ /^build\/kit\/gl\// ? 3 : f ~ /^build\/kit\/trace\// ? 2 : f ~ /^build\/kit\/scene\// ? 1 : 0
    }
    function room(f) { sub(/[^\/]*$/, "", f); sub(/kit\/scene\/.*/, "kit/scene/", f); return f }
    $1 == "asks" { asked[++asks] = $2 " " $3 }
    $1 == "has" { where[$3] = $2 }
    END {
        for (i = 1; i <= asks; ++i) {
            split(asked[i], a, " ")
            to = where[a[2]]
            if (to == "" || to == a[1]) continue
            up = height(to) - height(a[1])
            if (up > 0 || (!up && room(to) != room(a[1]))) { print "up: " a[1] " calls " a[2] " of " to; bad = 1 }
            if (height(a[1]) < 5) print "edge " a[1] " " to
        }
        exit bad
    }' >"$edges"
bad=$?
grep '^up: ' "$edges" >&2
circle=$(sed -n 's/^edge //p' "$edges" | sort -u | tsort 2>&1 >/dev/null) || bad=1
test -z "$circle" || { echo "circle: $circle" >&2; bad=1; }
test -s "$edges" || { echo 'tree: nm names no call at all' >&2; bad=1; }
test $bad = 0 && echo "tree: $# files of examples/ call none above them, and the kit's none in a circle"
exit $bad
