#!/bin/sh
# figures.sh - measures every figure of the documents again, in parts; make figures and make figures-check call it.
#     sh examples/lab/figures.sh [PART ..]    [all parts whose figures are not of the present code]
#     sh examples/lab/figures.sh --hash       the hash of the present code
#     sh examples/lab/figures.sh --check      names the parts whose figures are of other code; the status is then 1
# A part that was stopped goes on with what it had measured, if nothing was built in between. examples/docs/figures/
# parts.csv keeps of which code and commit the figures of each part are, and how many minutes it took.
set -e
record=examples/docs/figures/parts.csv

# The parts, their minutes on two cores, and the targets that make them.
parts='
cost       1 cost
cost-peers 1 cost-peers
quiet      3 quiet
failures   5 failures
fields     3 chart OF=fields
deep       3 chart OF=deep
lit        3 chart OF=lit
ambient   30 chart OF=ambient
stability 30 stability
papers    25 papers
light      5 light
plan      20 chart OF=plan
seeds     65 seeds
'

# Prints two hashes of the shaders of all chains and of the code of ssgi.h: without the planner's room, on which only its
# own figures depend, and with it. Comments and line breaks do not count.
hashes() {
    folder=$(mktemp -d)
    build/glsl-text --chain all --450 "$folder" >/dev/null
    rm -f "$folder"/manifest.json "$folder"/debug*
    awk '/^\/\* ==== / { plan = />>plan / } !plan' ssgi.h >"$folder/ssgi.h"
    without=$(hash_of "$folder")
    cp ssgi.h "$folder"
    echo "$without $(hash_of "$folder")"
    rm -r "$folder"
}
hash_of() {
    cat "$1"/* | awk 'BEGIN { RS = "\001" } {
        gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, " ")
        gsub(/\/\/[^\n]*/, "")
        gsub(/[ \n]+/, " ")
        print
    }' | sha256sum | cut -c1-12
}

read -r code plan <<END
$(hashes)
END
case $1 in
--hash) echo "$code"; exit ;;
--check)
    test -e "$record" || record=/dev/null
    echo "$parts" | awk -v other="$code" -v plan="$plan" '
        FILENAME != "-" { split($0, field, ","); code[field[1]] = field[2]; next }
        NF && (now = $1 == "plan" ? plan : other) && code[$1] != now {
            print "figures-check: " $1 " is of code " (code[$1] ? code[$1] : "(none)") ", not of " now
            wrong = 1
        }
        END { exit wrong }' "$record" -
    exit ;;
esac

for part in "$@"; do
    echo "$parts" | grep -q "^$part " || {
        echo "figures: PART=$part: there is none (have:$(echo "$parts" | awk '{ printf " %s", $1 }'))" >&2
        exit 2
    }
done
due=$(echo "$parts" | while read -r name rest; do
    case $name in plan) hash=$plan ;; *) hash=$code ;; esac
    case " $* " in
    "  ") test -z "$name" || grep -qs "^$name,$hash," "$record" || echo "$name $hash $rest" ;;
    *" $name "*) echo "$name $hash $rest" ;;
    esac
done)
left=$(echo "$due" | awk '{ sum += $3 } END { print sum + 0 }')
echo "figures: code $code: $(echo "$due" | grep -c .) parts, about $left minutes on two cores"
echo "$due" | while read -r name hash minutes how; do
    test -n "$name" || continue
    echo "figures: $name, about $minutes of the $left minutes that are left"
    begun=$(date +%s)
    # shellcheck disable=SC2086
    ${MAKE:-make} --no-print-directory $how PART= PAPER= METHOD= SCENE= QUICK= ONLY= </dev/null
    { echo part,code,commit,minutes
      { grep -sv "^part,\|^$name," "$record" || true
        echo "$name,$hash,$(git log -1 --format=%h 2>/dev/null),$((($(date +%s) - begun) / 60 + 1))"
      } | sort
    } >"$record.part"
    mv "$record.part" "$record"
    left=$((left - minutes))
done
test ! -s report/index.html || node examples/lab/page/figures.mjs report
