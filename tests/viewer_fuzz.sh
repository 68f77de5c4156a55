#!/bin/sh
# viewer_fuzz.sh - the viewer under sanitizers, given arguments and files that are damaged by chance. viewer.sh runs a
# few, make viewer-test FUZZ=300 so many; or by hand, where there is a display:
#
#   sh tests/viewer_fuzz.sh build/viewer-sanitized 300 [SEED]
#
# Whatever it is given, the viewer ends by itself: with status 0, a picture and nothing said, or with status 2, one line
# and no picture. Every eighth run draws; the others name an environment that is not there, so that they end when all
# else is read.
viewer=$1 runs=$2 seed=${3:-1}
work=build/viewer-fuzz
rm -rf $work
mkdir -p $work/folder
export LC_ALL=C KIT_THREADS=2 GALLIVM_PERF=nopt LP_NATIVE_VECTOR_WIDTH=128 LIBGL_ALWAYS_SOFTWARE=1
export UBSAN_OPTIONS=print_stacktrace=1
findings=0 drawn=0 refused=0 state=$seed run=0

pick() {    # one of its arguments, into $picked
    state=$(((state * 1103515245 + 12345) % 2147483648))
    shift $((state / 65536 % $#))
    picked=$1
}

# A triangle below two nodes, its buffer in the file and beside it; a pentagon that is concave and a triangle, twice.
cp tests/triangle.gltf $work/a.gltf
one='\000\000\200?' zero='\000\000\000\000'
printf "$one$zero$zero$zero$one$zero$zero$zero$one\\000\\001\\002" >$work/b.bin
sed 's/"data:[^"]*"/"b.bin"/' $work/a.gltf >$work/b.gltf
cat >$work/a.obj <<'END'
mtllib a.mtl
v 0 0 0
v 4 0 0
v 4 4 0
v 2 1 0
v 0 4 0
vn 0 0 1
usemtl red # one
o first
f 1//1 2//1 3//1 4 \
 5
g second
f -5/1/1 -4 -3
END
printf 'newmtl red\nKd 1 0.5 .25\nnewmtl red # 2\nKd 1e0\n' >$work/a.mtl
cat >$work/a.ply <<'END'
ply
format ascii 1.0
element vertex 5
property float x
property float y
property float z
property uchar red
element face 2
property list uchar int vertex_indices
end_header
0 0 0 9
4 0 0 255
4 4 0 0
2 1 0 7
0 4 0 128
5 0 1 2 3 4
3 4 1 0
END
long=$(printf '%5000s' '' | tr ' ' x)
mkfifo $work/pipe.gltf $work/pipe.obj
: >$work/empty.gltf
head -c 3000 /dev/urandom >$work/noise.obj
cp $work/noise.obj $work/noise.gltf

damage() {    # FILE SEED: a copy; every second one with another value for one of its numbers, each in turn, ...
    awk -v seed="$2" '
    function below(n) { return int(rand() * n) }
    function other() {
        if (match(after, /-?[0-9][0-9.e]*/))
            after = substr(after, 1, RSTART - 1) value[1 + below(values)] substr(after, RSTART + RLENGTH)
    }
    { all = all $0 "\n" }
    END {
        srand(seed)
        values = split("-1 0 1 2 3 4 255 2147483647 2147483648 4294967296 18446744073709551616 1e15 1e38 1e39 " \
                       "1e400 -1e38 1e-46 nan inf -inf 0x10 1.5 5120 5121 5123 5125 5126 null true [] {} \"\" [0] " \
                       "{\"a\":1} - . e 1e 999999999999999999999999999999999999999999999999999999999", value, " ")
        if (seed % 2) {
            for (numbers = split(all, part, /[0-9][0-9.e]*/) - 1; n < int(seed / 2) % numbers; n++)
                at += length(part[n + 1]) + match(substr(all, at + length(part[n + 1]) + 1), /[^0-9.e]/) - 1
            before = substr(all, 1, at); after = substr(all, at + 1)
            other()
            printf "%s%s", before, after
            exit
        }
        for (faults = 1 + below(3); faults > 0; faults--) {    # ... the others with up to three faults
            at = 1 + below(length(all)); how = below(8)
            before = substr(all, 1, at - 1); after = substr(all, at)
            if (how < 4) other()
            else if (how == 4) after = substr(after, 1 + below(40))
            else if (how == 5) after = substr("{}[]\",:0-9eE+. /\\#A", 1 + below(20), 1) substr(after, 2)
            else if (how == 6) after = sprintf("%c", 128 + below(127)) after
            else after = substr(after, 1, below(60)) after
            all = before after
        }
        printf "%s", all
    }' "$1"
}

option_value() {    # of an option, good or bad, into $picked; 1 if it has none
    case $1 in --command | --ground | --keys) return 1 ;; esac
    pick own own own own own own own any
    case $picked$1 in
    own--method | own--right) pick ssao hsao hsao-march ssdo ssdo-points s3ho ssbn dss dss-lit aof truth ;;
    own--set) pick thickness=slabs thickness=back,half=0 normal=depth history=0 history=1,history=0 margin=1 layers=2 \
                   steps=0 steps=1e9 bogus=1 = , half history= ;;
    own--light) pick sun:1,1,1,1,1,1 sun:0,0,0,1,1,1 point:0,2,0,1,1,1 point:1,2 sun:nan,0,1,1,1,1 lamp ;;
    own--env-turn | own--env-strength | own--fovy | own--ortho-height | own--orbit) pick 0 1 45 -20 1e9 nan 1e-30 x ;;
    own--scale) pick auto 1 0.5 0.1 0 2 x ;;
    own--colours) pick 0 1 2 ;;
    own--slide) pick 0,0,0 1,0,0 1e12,0,0 1e13,0,0 1,2 nan,0,0 ;;
    own--env) pick sky white street none "$work/folder" "$work/a.obj" "$work/noise.obj" ;;
    own--frames) pick 1 2 3 4 0 -1 1.5 1e3 99999999999999999999 ;;
    own--panel) pick 0 1 2 -1 ;;
    own--radius) pick 1 0.1 1e-45 1e-40 1e-6 1e6 1e15 1e16 1e40 1e-50 nan inf -inf 0 -0 -1 0x10 1, ;;
    own--camera) pick 1,2,3,4,5,6 2,1,0,0,0,0 1e15,0,0,-1e15,0,0 1e-40,0,0,0,0,0 0,9,0,0,0,0 1,1,1,1,1,1 \
                      1e15,1,1,1e15,1,2 -1e15,9e14,9e14,0,0,1 1,2,3,4,5 1,2,3,4,5,6,7 nan,0,0,0,0,0 0,0,inf,0,0,0 \
                      1e30,0,0,0,0,0 1,2,3,4,5, ,,,,, ;;
    own--up) pick 0,1,0 1e-40,0,0 1e15,1,0 0,0,0 nan,0,1 0,0,inf 1,2 1,2,3,4 0,1e-45,1e-45 ;;
    own--size) pick 16x16 20x16 15x16 0x0 -5x7 16x x16 16x16x 100000x100000 16384x16384 4294967312x16 16x4294967312 \
                    99999999999999999999x16 1e2x16 ;;
    *) pick nan inf '' 0 -1 1e40 99999999999999999999 hsao '%s%n' "$long" 1,2,3 "$work/folder" ' ' --size "
" ;;
    esac
}

finding() {
    findings=$((findings + 1))
    echo "FINDING $1 (run $run, seed $seed): viewer $said"
    head -40 $work/err
}

while [ $run -lt "$runs" ]; do
    run=$((run + 1))
    fault=$((seed * 100003 + run))
    leaks=1 draws=$((run % 8 == 0))
    if [ $draws = 1 ]; then pick whole whole whole a.gltf a.obj
    else pick a.gltf b.gltf a.gltf b.gltf a.ply a.ply a.obj a.mtl other; fi
    case $picked in
    a.ply) damage $work/a.ply $fault >$work/c.ply; scene=$work/c.ply ;;
    *.gltf) damage $work/$picked $fault >$work/c.gltf; scene=$work/c.gltf ;;
    a.obj) damage $work/a.obj $fault >$work/c.obj; scene=$work/c.obj ;;
    a.mtl)
        damage $work/a.mtl $fault >$work/d.mtl
        sed s/a.mtl/d.mtl/ $work/a.obj >$work/c.obj
        scene=$work/c.obj ;;
    whole) pick $work/a.gltf $work/b.gltf $work/a.obj $work/a.ply plane; scene=$picked ;;
    other)
        pick '' nowhere $work/folder $work/pipe.gltf $work/pipe.obj /dev/zero $work/empty.gltf $work/noise.obj \
             $work/noise.gltf "$long" "$long.gltf" .gltf x.gltf '%s%n' -x
        scene=$picked ;;
    esac
    if [ $draws = 1 ]; then pick 1 2; else pick 0 0 0 1 2 3; fi
    options=$picked
    set -- "$scene"
    while [ "$options" -gt 0 ]; do
        options=$((options - 1))
        pick --method --right --set --set --light --env-turn --env-strength --fovy --ortho-height --orbit --scale \
             --colours --slide --radius --radius --camera --camera --up --size --frames --panel --env --command \
             --ground --keys other
        [ "$picked" != other ] || pick --bogus '' - -- --method=hsao
        set -- "$@" "$picked"
        if option_value "$picked"; then set -- "$@" "$picked"; fi
    done
    if [ $draws = 1 ]; then set -- "$@" --size 24x16 --shot $work/out.png; leaks=0         # GL keeps what it has
    else set -- "$@" --shot $work/out.png --env $work/none.exr; fi
    said="$*"
    rm -f $work/out.png
    (ulimit -t 60; ASAN_OPTIONS=exitcode=99:detect_leaks=$leaks "$viewer" "$@" >$work/out 2>$work/err)
    status=$?
    lines=$(wc -l <$work/err)
    if [ $status = 0 ]; then
        drawn=$((drawn + 1))
        [ "$lines" = 0 ] && [ -s $work/out.png ] || finding 'status 0 with words, or without a picture'
    elif [ $status = 2 ]; then
        refused=$((refused + 1))
        [ "$lines" = 1 ] && grep -q '^viewer: .\{9,\}' $work/err && [ ! -e $work/out.png ] ||
            finding 'status 2 without one line, or with a picture'
    else finding "status $status"
    fi
done
echo "$runs runs: $drawn drew, $refused were refused, $findings findings"
exit $((findings > 0))
