#!/bin/sh
# viewer.sh - the viewer's window under Xvfb, beside build/render's picture of the same:
#
#   make viewer-test
#
# What cannot be run here is named as skipped. FUZZ: how many damaged files and arguments the viewer gets.
work=build/viewer-test
. tests/window.sh
open_window

# A yard of boxes: as an OBJ with normals and colours, as a glTF of one box and many nodes, below one that is turned by
# a quaternion and one that is turned back by a matrix.
awk -v obj=$work/yard.obj -v mtl=$work/yard.mtl -v gltf=$work/yard.gltf '
function box(x, y, z, a, b, c, of,   i, k, f, normals) {
    for (i = 0; i < 8; i++) printf("v %g %g %g\n", i % 2 ? a : x, int(i / 2) % 2 ? b : y, int(i / 4) ? c : z) > obj
    print "usemtl " of > obj
    split("1 5 7 3,2 4 8 6,1 2 6 5,3 7 8 4,1 3 4 2,5 6 8 7", f, ",")
    for (i = 1; i <= 6; i++) {
        split(f[i], k, " ")
        printf("f %d//%d %d//%d %d//%d %d//%d\n", n + k[1], i, n + k[2], i, n + k[3], i, n + k[4], i) > obj
    }
    n += 8
    nodes = nodes sprintf(",\n{\"mesh\":0,\"translation\":[%g,%g,%g],", x, y, z)
    nodes = nodes sprintf("\"scale\":[%g,%g,%g]}", a - x, b - y, c - z)
    children = children (boxes ? "," : "") 2 + boxes++
}
function chance() { s = s * 16807 % 2147483647; return s % 1000 / 1000 }
BEGIN {
    print "mtllib yard.mtl\nvn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1" > obj
    print "newmtl ground\nKa 0.6 0.58 0.52\nKd 0.5 0.48 0.42\nnewmtl stone\nKa 0.6 0.57 0.5\nKd 0.54 0.52 0.45" > mtl
    print "newmtl brick\nKa 0.5 0.3 0.22\nKd 0.5 0.3 0.22" > mtl
    s = 7
    box(-6, -0.2, -6, 6, 0, 6, "ground")
    for (i = 0; i < 6; i++) {
        c = -4 + 1.6 * i
        box(c, 0, -3, c + 0.5, 2.4, -2.5, "stone")
        box(c - 0.1, 0, -3.1, c + 0.6, 0.2, -2.4, "stone")
    }
    box(-4.3, 2.4, -3.3, 5, 2.8, -2.2, "stone")
    for (i = 0; i < 4; i++) box(-5, 0.25 * i, -4.4 - 0.4 * i, 5, 0.25 * (i + 1), -4 - 0.4 * i, "stone")
    for (i = 0; i < 26; i++) {
        c = -3.5 + 7 * chance(); d = -1.5 + 4 * chance(); h = 0.2 + 0.9 * chance(); w = 0.2 + 0.4 * chance()
        box(c, 0, d, c + w, h, d + w, "brick")
    }
    printf "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" > gltf
    printf "{\"children\":[1],\"rotation\":[0,0.70710678,0,0.70710678]},\n" > gltf
    printf("{\"children\":[%s],\"matrix\":[0,0,1,0,0,1,0,0,-1,0,0,0,0,0,0,1]}%s],\n", children, nodes) > gltf
    print "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],\"accessors\":[" > gltf
    print "{\"bufferView\":0,\"componentType\":5126,\"count\":8,\"type\":\"VEC3\"}," > gltf
    print "{\"bufferView\":1,\"componentType\":5121,\"count\":36,\"type\":\"SCALAR\"}],\"bufferViews\":[" > gltf
    print "{\"buffer\":0,\"byteLength\":96},{\"buffer\":0,\"byteOffset\":96,\"byteLength\":36}]," > gltf
    print "\"buffers\":[{\"byteLength\":132,\"uri\":\"data:application/octet-stream;base64," \
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAAAAAAAAAAAAAAAAIA/AACAPwAAAAAAAIA/AAAAAAAAgD8A" \
        "AIA/AACAPwAAgD8AAIA/AAQGAAYCAQMHAQcFAAEFAAUEAgYHAgcDAAIDAAMBBAUHBAcG\"}]}" > gltf
}'
place=3.5,3.2,6.5,0.3,0.7,-0.8
size=480x270

if [ ! -x build/viewer ]; then skip 'viewer, GLFW is missing (apt-get install libglfw3-dev)'
else
    { printf '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n'; printf '\200\220\240\201%.0s' $(seq 32); } \
        >$work/dim.hdr
    plain='--colours 0 --set history=0'
    for m in ssao hsao hsao-march 'hsao back' 'hsao slabs' 'hsao solid'; do
        set -- $m
        name=$1 thickness=$2
        build/viewer room --method "$name" --set thickness=${thickness:-default} $plain --size $size --shot $work/a.png
        build/render room --method "$name" --set thickness=${thickness:-default} --size $size --out $work/b.png
        near "viewer, $m" $work/a.png $work/b.png 0.001
    done
    for m in ssdo s3ho; do
        build/viewer room --method $m --env sky --set history=0 --size $size --shot $work/a.png
        build/render room --method $m --env sky --size $size --out $work/b.png
        near "viewer, $m" $work/a.png $work/b.png 0.001
    done
    build/viewer room --method hsao --colours 0 --orbit 0.5 --frames 6 --size $size --shot $work/a.png
    build/render room --set history=1 --orbit 0.5 --frames 6 --size $size --out $work/h%d.png
    near 'viewer, hsao over six frames about the target' $work/a.png $work/h5.png 0.001
    build/render $work/yard.obj --camera $place --fovy 45 --size $size --radius 0.6 --out $work/b.png
    for ending in obj gltf; do
        if build/viewer $work/yard.$ending --env none 2>&1 | grep -q 'reads OBJ alone'; then
            skip "viewer, .$ending, Assimp is missing (apt-get install libassimp-dev)"
            continue
        fi
        set -- $work/yard.$ending --method hsao $plain --camera $place --size $size --radius 0.6
        build/viewer "$@" --shot $work/a.png
        near "viewer, hsao of an .$ending" $work/a.png $work/b.png 0.001
        build/viewer "$@" --ground --shot $work/g.png
        check "viewer, --ground under an .$ending" "$(cmp -s $work/a.png $work/g.png || echo 1)"
        moved=13487434.75,-6.5,-3741689.25          # an .obj's vertices, a .gltf's root
        at=$(echo $place,$moved | awk -F, -v OFS=, '{ print $1 + $7, $2 + $8, $3 + $9, $4 + $7, $5 + $8, $6 + $9 }' \
            OFMT=%.12g)
        sed "s/\"children\":\[1\],/&\"translation\":[$moved],/" $work/yard.$ending | awk -v by=$moved '
            BEGIN { split(by, o, ",") }
            $1 == "v" { $0 = sprintf("v %.9f %.9f %.9f", $2 + o[1], $3 + o[2], $4 + o[3]) } { print }' \
            >$work/far.$ending
        build/viewer $work/far.$ending --method hsao $plain --camera $at --size $size --radius 0.6 --shot $work/a.png \
            --command 2>$work/said >$work/line
        near "viewer, hsao of an .$ending far from 0" $work/a.png $work/b.png 0.001
        check "viewer, an .$ending far from 0 is said" "$(grep -c 'it lies far from 0' $work/said)"
        sh -c "$(sed "s|picture.png|$work/g.png|" $work/line) 2>/dev/null"
        near "viewer, the line for build/render of an .$ending far from 0" $work/g.png $work/a.png 0.001
    done
    for option in '--panel 1' --keys; do
        build/viewer room --size $size --method hsao --shot $work/a.png $option
        build/viewer room --size $size --method hsao --shot $work/g.png
        check "viewer, $option" "$(cmp -s $work/a.png $work/g.png || echo 1)"
    done
    is=$(build/viewer room --method hsao $plain --right truth --size 240x136 --shot $work/a.png | sed -n 's/^RMSE //p')
    build/render room --size 240x136 --truth 16 --out $work/truth.exr
    be=$(build/render room --size 240x136 --score $work/truth.exr | sed -n 's/.*: RMSE \([0-9.]*\).*/\1/p')
    echo "  viewer, error to its own truth: $is; build/render: $be"
    close=$(awk -v a="$is" -v b="$be" 'BEGIN { print (a * b > 0 && (a - b) ^ 2 < 9e-6) }')
    check 'viewer, error to the truth' "$close"
    if [ -x build/press ]; then . tests/viewer_keys.sh
    else skip 'viewer, keys and drops: python3-xlib is missing (apt-get install python3-xlib)'; fi
    . tests/viewer_bad.sh
fi

finish
