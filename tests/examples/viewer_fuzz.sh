#!/bin/sh
# viewer_fuzz.sh - gives the viewer, under sanitizers, randomly damaged arguments and files. viewer.sh runs a few, make
# viewer-test FUZZ=300 so many. By hand, with a display:
#
#   sh tests/examples/viewer_fuzz.sh build/viewer-sanitized 300 [SEED]
#
# In every case the viewer must end by itself: with status 0, a picture and no output, or with status 2, one line and no
# picture. Every eighth run draws. The others name an environment that does not exist, so that they end after all else
# is read.
viewer=$1 runs=$2 seed=${3:-1}
work=build/viewer-fuzz
rm -rf $work
mkdir -p $work/folder
export LC_ALL=C KIT_THREADS=2 GALLIVM_PERF=nopt LP_NATIVE_VECTOR_WIDTH=128 LIBGL_ALWAYS_SOFTWARE=1
export UBSAN_OPTIONS=print_stacktrace=1
findings=0 drawn=0 refused=0 run=0

# ---- the corpus: a triangle below two nodes; a pentagon that is concave and a triangle, twice; options and values
cp tests/examples/triangle.gltf $work/a.gltf
cat >$work/a.obj <<'END'
mtllib c.mtl
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
mkfifo $work/pipe.gltf
: >$work/empty.gltf
head -c 3000 /dev/urandom >$work/noise.obj
cat >$work/values <<END
--method ssao hsao-march ssdo ssdo-points s3ho ssbn dss dss-lit aof truth
--right hsao ssdo dss truth nobody
--set thickness=slabs thickness=back,resolution=full normal=depth history=1,history=0 layers=2 samples=1e9 bogus=1 = ,
--light sun:1,1,1,1,1,1 sun:0,0,0,1,1,1 point:0,2,0,1,1,1 point:1,2 sun:nan,0,1,1,1,1 lamp
--env sky street none $work/folder $work/a.obj $work/noise.obj
--env-turn 0 45 -20 1e9 nan x
--env-strength 0 1 -20 1e9 nan 1e-30
--fovy 0 45 1e9 nan 1e-30
--ortho-height 0 1 -20 1e9 nan 1e-30
--orbit 0 1 -20 1e9 nan x
--scale auto 1 0.5 0 2 x
--slide 0,0,0 1,0,0 1e12,0,0 1e13,0,0 1,2 nan,0,0
--frames 1 3 0 -1 1.5 1e3 99999999999999999999
--radius 1 1e-45 1e-40 1e-6 1e6 1e15 1e40 nan -inf 0 -1 0x10 1,
--camera 1,2,3,4,5,6 1e15,0,0,-1e15,0,0 1e-40,0,0,0,0,0 1,1,1,1,1,1 1e15,1,1,1e15,1,2 1,2,3,4,5 nan,0,0,0,0,0 ,,,,,
--up 0,1,0 1e-40,0,0 1e15,1,0 0,0,0 nan,0,1 1,2 0,1e-45,1e-45
--size 16x16 20x16 15x16 -5x7 16x 16x16x 16384x16384 4294967312x16 99999999999999999999x16 1e2x16
--command
--ground
--bogus 1 %s%n $(printf '%5000s' '' | tr ' ' x)
END

# A line for each run: the file, damaged or not, and up to three options. Every eighth run draws.
awk -v seed="$seed" -v runs="$runs" -v folder=$work/ '
    function below(n) { return int(rand() * n) }
    { row[NR] = $0 }
    END {
        srand(seed)
        files = split("a.gltf a.gltf a.obj a.mtl", damaged, " ")
        others = split("nowhere folder pipe.gltf empty.gltf noise.obj .gltf", other, " ")
        for (run = 1; run <= runs; run++) {
            line = run % 8 == 0 ? "plane" : below(5) ? damaged[1 + below(files)] : folder other[1 + below(others)]
            for (options = below(run % 8 == 0 ? 2 : 4); options > 0; options--) {
                n = split(row[1 + below(NR)], word, " ")
                line = line " " word[1] (n > 1 ? " " word[2 + below(n - 1)] : "")
            }
            print line
        }
    }' $work/values >$work/runs

damage() {    # FILE SEED: a copy with up to three faults, most of them a changed number
    awk -v seed="$2" '
    function below(n) { return int(rand() * n) }
    { all = all $0 "\n" }
    END {
        srand(seed)
        values = split("-1 0 1 255 2147483647 2147483648 4294967296 18446744073709551616 1e15 1e38 1e39 1e400 1e-46 " \
                       "nan inf 0x10 1.5 5121 5123 5126 null true [] {} \"\" [0] {\"a\":1} - . 1e", value, " ")
        for (faults = 1 + below(3); faults > 0; faults--) {
            at = 1 + below(length(all)); how = below(8)
            before = substr(all, 1, at - 1); after = substr(all, at)
            if (how < 5) sub(/-?[0-9][0-9.e]*/, value[1 + below(values)], after)
            else if (how == 5) after = substr(after, 1 + below(40))
            else if (how == 6) after = sprintf("%c", 33 + below(222)) substr(after, 2)
            else after = substr(after, 1, below(60)) after
            all = before after
        }
        printf "%s", all
    }' "$1"
}
finding() {
    findings=$((findings + 1))
    echo "FINDING $1 (run $run, seed $seed): viewer $said"
    head -40 $work/err
}

while read -r scene options; do
    run=$((run + 1))
    cp $work/a.mtl $work/c.mtl
    case $scene in
    a.*)
        cp $work/a.obj $work/c.obj
        damage $work/$scene $((seed * 100003 + run)) >$work/c.${scene#a.}
        case $scene in *.gltf) scene=$work/c.gltf ;; *) scene=$work/c.obj ;; esac ;;
    esac
    set -- "$scene" $options
    if [ $((run % 8)) = 0 ]; then set -- "$@" --size 24x16 --shot $work/out.png; leaks=0    # GL keeps some memory
    else set -- "$@" --shot $work/out.png --env $work/none.exr; leaks=1; fi
    said="$*"
    rm -f $work/out.png
    (ulimit -t 60; ASAN_OPTIONS=exitcode=99:detect_leaks=$leaks "$viewer" "$@" >$work/out 2>$work/err </dev/null)
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
done <$work/runs
echo "$run runs: $drawn drew, $refused were refused, $findings findings"
exit $((findings > 0))
