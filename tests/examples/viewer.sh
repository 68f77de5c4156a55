#!/bin/sh
# viewer.sh - compares the viewer's window under Xvfb with build/render's picture:
#
#   make viewer-test
#
# Tests that cannot run here are named as skipped. FUZZ: how many damaged files and arguments the viewer gets.
work=build/viewer-test
. tests/window.sh
open_window
make_boxes $work/boxes.obj
place=3.5,3.2,6.5,0.3,0.7,-0.8
size=240x136

if [ ! -x build/viewer ]; then skip 'viewer, GLFW is missing (apt-get install libglfw3-dev)'
else
    { printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n'; printf '\200\220\240\201%.0s' $(seq 32); } \
        >$work/dim.hdr
    build/viewer room --method hsao --colours 0 --orbit 0.5 --frames 6 --size $size --shot $work/a.png
    build/render room --set history=1 --orbit 0.5 --frames 6 --size $size --out $work/h%d.png
    near 'viewer, hsao over six frames about the target' $work/a.png $work/h5.png 0.001
    set -- --method hsao --set history=0 --size $size --radius 0.6
    build/viewer $work/boxes.obj "$@" --colours 0 --camera $place --shot $work/a.png
    build/render $work/boxes.obj "$@" --camera $place --out $work/b.png
    near 'viewer, visibility of an .obj' $work/a.png $work/b.png 0.001
    moved=13487434.75,-6.5,-3741689.25
    at=$(echo $place,$moved | awk -F, -v OFS=, '{ print $1 + $7, $2 + $8, $3 + $9, $4 + $7, $5 + $8, $6 + $9 }' \
        OFMT=%.12g)
    awk -v by=$moved 'BEGIN { split(by, o, ",") }
        $1 == "v" { $0 = sprintf("v %.9f %.9f %.9f", $2 + o[1], $3 + o[2], $4 + o[3]) } { print }' \
        $work/boxes.obj >$work/far.obj
    build/viewer $work/far.obj "$@" --colours 0 --camera $at --shot $work/a.png --command 2>$work/said >$work/line
    near 'viewer, hsao of an .obj far from 0' $work/a.png $work/b.png 0.001
    check 'viewer, an .obj far from 0 is said' "$(grep -c 'it lies far from 0' $work/said)"
    sh -c "$(sed "s|picture.png|$work/g.png|" $work/line) 2>/dev/null"
    near 'viewer, the line for build/render of an .obj far from 0' $work/g.png $work/a.png 0.001

    for option in '--panel 1' --keys --ground; do
        build/viewer $work/boxes.obj --size $size --method hsao --shot $work/a.png $option
        build/viewer $work/boxes.obj --size $size --method hsao --shot $work/g.png
        check "viewer, $option" "$(cmp -s $work/a.png $work/g.png || echo 1)"
    done
    is=$(build/viewer room --method hsao --colours 0 --set history=0 --right truth --size 240x136 --shot $work/a.png |
        sed -n 's/^RMSE //p')
    build/render room --size 240x136 --truth 16 --out $work/truth.exr
    be=$(build/render room --size 240x136 --score $work/truth.exr | sed -n 's/.*: RMSE \([0-9.]*\).*/\1/p')
    echo "  viewer, error to its own truth: $is; build/render: $be"
    check 'viewer, error to the truth' "$(is "${is:-0} * ${be:-0} > 0 && (${is:-0} - ${be:-0}) ^ 2 < 9e-6")"
    if [ -x build/press ]; then . tests/examples/viewer_keys.sh
    else skip 'viewer, keys and drops: python3-xlib is missing (apt-get install python3-xlib)'; fi
    . tests/examples/viewer_bad.sh
fi

finish
