# viewer_bad.sh - the part of viewer.sh on what the viewer refuses, what it may cost, and what sanitizers see. Uses its
# check and $work.

refused() {    # WORDS ARGUMENT ..: status 2, one line with the words, no picture
    words=$1
    shift
    rm -f $work/none.png
    (ulimit -t 100; ASAN_OPTIONS=exitcode=99 build/viewer-sanitized "$@" --shot $work/none.png >$work/out 2>$work/said)
    status=$?
    check "viewer $*: status $status, \"$(head -c 300 $work/said)\", not 2 and one line that says \"$words\"" \
        "$(test $status = 2 && test "$(wc -l <$work/said)" = 1 && grep -qF -e "$words" $work/said \
               && ! test -e $work/none.png && ! test -s $work/out && echo 1)"
}

refused 'neither a file that can be read nor a built-in scene (room,' no-such-scene
refused "the scene's name is empty" ''
refused 'only one scene can be shown (room is one already)' room boxes
refused '--bogus: there is no such option' room --bogus 1
for camera in nan,0,0,0,0,0 0,0,inf,0,0,0 1e16,0,0,0,0,0 1,2,3,4,5 1,2,3,4,5,6,7; do
    refused 'must be six numbers with commas between, each within 1e12 of 0' room --camera $camera
done
refused 'eye and target must differ' room --camera 1,2,3,1,2,3
refused 'must not be zero or along the view direction' room --camera 0,9,0,0,0,0
refused 'must not be zero or along the view direction' room --up 0,0,0
for size in 100000x100000 16384x16384 15x64 64x 64x64x 4294967360x64; do
    refused 'must be WxH, each 16..16384, of 33554432 pixels at most' room --size $size
done
for radius in nan inf 0 -1 1x; do
    refused "--radius '$radius': must be a number in 1e-12..1e12" room --radius $radius
done
refused "--frames '0': must be a whole number in 1..1000000" room --frames 0
refused '--method truth: there is no such method; the nearest are' room --method truth
refused '--method bogus: there is no such method; the nearest are' room --right bogus
refused '--set bogus=1: method ssdo has no such setting' room --set bogus=1
refused '--set steps=0: must be a whole number' room --method hsao --set steps=0
refused 'must be key=value' room --set steps
refused 'light lamp: must be point:' room --light lamp
refused "--env-strength '-1': must be a number in 0..1e+06" room --env sky --env-strength -1
refused '--env-turn: needs --env' room --env-turn 20
refused '--ortho-height: cannot go with --fovy' room --fovy 40 --ortho-height 3
refused "--fovy '180': must be a number in 0.1..179" room --fovy 180
refused "--scale '2': must be auto or a number in 0.1..1" room --scale 2
refused "--colours '2': must be a whole number in 0..1" room --colours 2
refused "--slide '1,2': must be three numbers" room --slide 1,2
refused 'no object that casts' plane --slide 1,0,0

damaged() {    # WORDS SED: what is said of the triangle with this change
    sed "$2" tests/triangle.gltf >$work/bad.gltf
    check "$2 changes the triangle" "$(cmp -s tests/triangle.gltf $work/bad.gltf || echo 1)"
    refused "$1" $work/bad.gltf
}

# Small files that may not take long: 100,000 nodes; a mesh of 4,000 primitives that 4,000 nodes have. In seconds of a
# processor, with so much to spare that any machine has them.
larger() {    # NODES PRIMITIVES: the triangle, so often in a mesh that so many nodes have
    awk -v nodes="$1" -v primitives="$2" '
    function often(what, n, i) { for (i = 1; i < n; i++) printf "%s,", what }
    /"children":\[1\]/ { printf "\"nodes\":[{\"children\":["
                         for (i = 1; i < nodes; i++) printf "%d,", i
                         print i "]}," }
    /^\{"mesh":0,"translation"/ { often("{\"mesh\":0}", nodes); print "" }
    /"primitives"/ { match($0, /\{"attributes.*"mode":4\}/); printf "\"meshes\":[{\"primitives\":["
                     often(substr($0, RSTART, RLENGTH), primitives); print substr($0, RSTART) }
    !/"children"|"primitives"/' tests/triangle.gltf
}

# Models are read by Assimp, in a process of its own: what it refuses, what it passes on, what it fails on.
if build/viewer tests/triangle.gltf --env none 2>&1 | grep -q 'reads OBJ alone'; then
    skip 'viewer, models but OBJ: Assimp is missing (apt-get install libassimp-dev)'
else
    damaged 'is glTF that cannot be read: it is damaged, or of a version' '$s/}$//'
    damaged 'cannot be read: GLTF: No scene' 's/"scenes":\[[^]]*\]}\]/"scenes":[]/'
    damaged 'out of bounds (3) for "nodes"' 's/"children":\[2\]/"children":[3]/'
    damaged 'recursive reference' 's/"children":\[2\]/"children":[0]/'
    damaged 'a vertex is not within 1e+15 of 0' 's/2\.5,-3e0/2.5,1e39/'
    damaged 'a vertex is not within 1e+15 of 0' 's/2\.5,-3e0/2.5,1e16/'
    damaged 'a vertex is not within 1e+15 of 0' 's/,AACAPwAA/,AADAfwAA/'
    damaged 'out of bounds (1) for "materials"' 's/"material":0/"material":1/'
    damaged 'fails on: it may be damaged' 's/"byteOffset":0/&,"sparse":{}/'
    damaged 'out of range' 's/"count":3,"type":"VEC3","b/"count":2147483648,"type":"VEC3","b/'
    damaged 'no triangles in it' 's/"byteStride":12/"byteStride":8/'
    damaged 'cannot be read: Mesh "meshes[0]" has no faces' 's/AAEC"/AAED"/'
    damaged 'could not open referenced file "absent.bin"' 's/"data:[^"]*"/"absent.bin"/'
    damaged 'needs the extension KHR_mesh_quantization, which is not read' \
        's/^{/&"extensionsRequired":["KHR_texture_transform","KHR_mesh_quantization"],/'
    larger 100000 1 >$work/many.gltf
    larger 4000 4000 >$work/often.gltf
    (ulimit -t 20; build/viewer $work/many.gltf --env none 2>$work/said)
    check "viewer, 100,000 nodes in 20 s: $(cat $work/said)" \
        "$(grep -q '^viewer: environment none' $work/said && echo 1)"
    (ulimit -t 20; build/viewer $work/often.gltf --env none 2>$work/said)
    check "viewer, a mesh 4,000 times in 20 s: $(cat $work/said)" "$(grep -q ' or 262144 meshes' $work/said && echo 1)"
fi

build/viewer --help >$work/out 2>$work/said
check 'viewer --help: status 0, on standard output' "$(test $? = 0 && grep -q '^usage: viewer' $work/out \
    && ! test -s $work/said && echo 1)"
for option in --help '-h' "plane --right truth --size 32x24 --shot $work/a.png"; do
    build/viewer $option >/dev/full 2>$work/said
    check "viewer $option >/dev/full: status 2, one line" \
        "$(test $? = 2 && test "$(wc -l <$work/said)" = 1 && grep -q 'standard output' $work/said && echo 1)"
done

# The truth is traced on another thread. Mesa's own threads are not looked at: they were not built for it.
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
sh tests/viewer_fuzz.sh build/viewer-sanitized "$runs" >$work/out
echo "  viewer, damaged files and arguments: $(tail -n 1 $work/out)"
check "viewer, damaged files and arguments: $(grep -a -A9 FINDING $work/out | head -n 40)" \
    "$(tail -n 1 $work/out | grep -q ' 0 findings$' && echo 1)"
