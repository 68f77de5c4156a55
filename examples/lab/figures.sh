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
cost       6 cost
cost-peers 2 cost-peers
quiet      4 quiet
failures   5 failures
fields     5 chart OF=fields
deep      12 chart OF=deep
lit       20 chart OF=lit
ambient   25 chart OF=ambient
stability 30 stability
papers    25 papers
light     25 light
plan      20 chart OF=plan
seeds     60 seeds
'

# The figures depend on the shaders of all chains and on the code of ssgi.h. Comments and line breaks do not count.
code() {
    folder=$(mktemp -d)
    build/glsl-text --chain all --450 "$folder" >/dev/null
    rm "$folder/manifest.json"
    cat "$folder"/* ssgi.h | awk 'BEGIN { RS = "\001" } {
        gsub(/\/\*([^*]|\*+[^*\/])*\*+\//, " ")
        gsub(/\/\/[^\n]*/, "")
        gsub(/[ \n]+/, " ")
        print
    }' | sha256sum | cut -c1-12
    rm -r "$folder"
}

case $1 in
--hash) code; exit ;;
--check)
    now=$(code)
    touch "$record"
    echo "$parts" | awk -v now="$now" '
        FILENAME != "-" { split($0, field, ","); code[field[1]] = field[2]; next }
        NF && code[$1] != now {
            print "figures-check: " $1 " is of code " (code[$1] ? code[$1] : "(none)") ", not of " now
            wrong = 1
        }
        END { exit wrong }' "$record" -
    exit ;;
esac

hash=$(code)
for part in "$@"; do
    echo "$parts" | grep -q "^$part " || {
        echo "figures: PART=$part: there is none (have:$(echo "$parts" | awk '{ printf " %s", $1 }'))" >&2
        exit 2
    }
done
due=$(echo "$parts" | while read -r name rest; do
    case " $* " in
    "  ") test -z "$name" || grep -qs "^$name,$hash," "$record" || echo "$name $rest" ;;
    *" $name "*) echo "$name $rest" ;;
    esac
done)
left=$(echo "$due" | awk '{ sum += $2 } END { print sum + 0 }')
echo "figures: code $hash: $(echo "$due" | grep -c .) parts, about $left minutes on two cores"
echo "$due" | while read -r name minutes how; do
    test -n "$name" || continue
    echo "figures: $name, about $minutes of the $left minutes that are left"
    begun=$(date +%s)
    # shellcheck disable=SC2086
    ${MAKE:-make} --no-print-directory $how PART= PAPER= METHOD= SCENE= QUICK= ONLY= </dev/null
    { echo part,code,commit,minutes
      { grep -v "^part,\|^$name," "$record" || true
        echo "$name,$hash,$(git log -1 --format=%h 2>/dev/null),$((($(date +%s) - begun) / 60 + 1))"
      } | sort
    } >"$record.part"
    mv "$record.part" "$record"
    left=$((left - minutes))
done
test ! -s report/index.html || node examples/lab/page/figures.mjs report
