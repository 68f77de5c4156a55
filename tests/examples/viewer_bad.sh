# viewer_bad.sh - a part of viewer.sh: inputs that the viewer refuses, limits of time, and sanitizers. Uses its check
# and $work.

refused() {    # WORDS ARGUMENT ..: the viewer ends with status 2, one line with these words, no picture
    words=$1
    shift
    rm -f $work/none.png
    (ulimit -t 100; ASAN_OPTIONS=exitcode=99 build/viewer-sanitized "$@" --shot $work/none.png >$work/out 2>$work/said)
    status=$?
    check "viewer $*: status $status, \"$(head -c 300 $work/said)\", not 2 and one line that says \"$words\"" \
        "$(test $status = 2 && test "$(wc -l <$work/said)" = 1 && grep -qF -e "$words" $work/said \
               && ! test -e $work/none.png && ! test -s $work/out && echo 1)"
}

refused "the scene's name is empty" ''
while IFS='|' read -r arguments words; do
    refused "$words" $arguments </dev/null
done <<'END'
no-such-scene|neither a file that can be read nor a built-in scene (room,
room boxes|only one scene can be shown (room is one already)
room --camera 1e16,0,0,0,0,0|its numbers must be in -1e+12..1e+12
room --camera 1,2,3,1,2,3|eye and target must differ
room --camera 0,9,0,0,0,0|must not be zero or along the view direction
room --up 0,0,0|must not be zero or along the view direction
room --size 15x64|--size 15x64: must be WxH, each 16..16384
room --size 16384x16384|--size 16384x16384: must have 33554432 pixels at most
room --radius 0|--radius 0: must be a number in 1e-12..1e+12
room --frames 0|--frames 0: must be a whole number in 1..1000000
room --method truth|--method truth: there is no such method; the nearest are
room --right bogus|--method bogus: there is no such method; the nearest are
room --set bogus=1|--set bogus=1: method ssdo has no such setting
room --light lamp|light lamp: must be point:
room --env sky --env-strength -1|--env-strength -1: must be a number in 0..1e+06
room --env-turn 20|--env-turn: needs --env
room --fovy 40 --ortho-height 3|--ortho-height: cannot go with --fovy
room --fovy 180|--fovy 180: must be a number in 0.1..179
room --scale 2|--scale 2: must be auto or a number in 0.1..1
room --colours 2|--colours 2: must be a whole number in 0..1
plane --slide 1,0,0|no object that casts
END

# A mesh of 4,000 primitives, used by 4,000 nodes, must not take long: in seconds of processor, with much room for any
# machine.
if build/viewer tests/examples/triangle.gltf --env none 2>&1 | grep -q 'reads OBJ alone'; then
    skip 'viewer, models but OBJ: Assimp is missing (apt-get install libassimp-dev)'
else
    awk -v n=4000 '
        function often(what,   i) { for (i = 1; i < n; i++) printf "%s,", what }
        /"children":\[1\]/ { printf "\"nodes\":[{\"children\":["
                             for (i = 1; i < n; i++) printf "%d,", i
                             print i "]}," }
        /^\{"mesh":0,"translation"/ { often("{\"mesh\":0}"); print "" }
        /"primitives"/ { match($0, /\{"attributes.*"mode":4\}/); printf "\"meshes\":[{\"primitives\":["
                         often(substr($0, RSTART, RLENGTH)); print substr($0, RSTART) }
        !/"children"|"primitives"/' tests/examples/triangle.gltf >$work/often.gltf
    (ulimit -t 20; build/viewer $work/often.gltf --env none 2>$work/said)
    check "viewer, a mesh 4,000 times in 20 s: $(cat $work/said)" "$(grep -q ' or 262144 meshes' $work/said && echo 1)"
fi

build/viewer --help >$work/out 2>$work/said
check 'viewer --help: status 0, on standard output' "$(test $? = 0 && grep -q '^usage: viewer' $work/out \
    && ! test -s $work/said && echo 1)"
for option in --help -h --version "plane --right truth --size 32x24 --shot $work/a.png"; do
    build/viewer $option >/dev/full 2>$work/said
    check "viewer $option >/dev/full: status 2, one line" \
        "$(test $? = 2 && test "$(wc -l <$work/said)" = 1 && grep -q 'standard output' $work/said && echo 1)"
done

# The truth is traced on another thread. Mesa's own threads are left out, as Mesa is not built for this sanitizer.
for m in hsao ssdo; do
    TSAN_OPTIONS='exitcode=66 ignore_noninstrumented_modules=1 detect_deadlocks=0' GALLIVM_PERF=nopt \
        LP_NATIVE_VECTOR_WIDTH=128 build/viewer-threads boxes --method $m-fast --right truth \
        --env $work/dim.hdr --frames 9 --panel 1 --size 32x24 --shot $work/a.png >$work/out 2>$work/said
    status=$?
    check "viewer, $m beside the truth under ThreadSanitizer: status $status" "$(test $status = 0 \
        && ! test -s $work/said && grep -q '^RMSE 0' $work/out && echo 1)"
    [ $status = 0 ] || grep -A12 -m3 WARNING $work/said
done

runs=${FUZZ:-30}
sh tests/examples/viewer_fuzz.sh build/viewer-sanitized "$runs" >$work/out
echo "  viewer, damaged files and arguments: $(tail -n 1 $work/out)"
check "viewer, damaged files and arguments: $(grep -a -A9 FINDING $work/out | head -n 40)" \
    "$(tail -n 1 $work/out | grep -q ' 0 findings$' && echo 1)"
