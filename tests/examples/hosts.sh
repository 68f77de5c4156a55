#!/bin/sh
# hosts.sh - builds and runs the pages of examples/hosts as their first comments say, under Xvfb or without a window:
#
#   make hosts-test                  ONLY="glfw sdl": those
#
# All draw the same boxes with the same camera. In ambient light alone, on white boxes, the picture is the ambient
# visibility, and must be build/render's. In sunlight alone nothing may be dimmed. Windows change their size before a
# picture is taken. Hosts that cannot run here are named as skipped.
work=build/hosts/test
only=" $* "
. tests/window.sh

wanted() { [ "$only" = '  ' ] || [ "${only#* $1 }" != "$only" ]; }

# build HOST PAGE FLAGS..: builds with every compiler that is there, and keeps the first one's program. Returns 1 if
# libraries are missing.
build() {
    host=$1 compilers=
    line=$(sed -e :a -e '/\\$/N; s/\\\n *//; ta' "$2" | sed -n "s/^ *c[c+]* \(.*\) -o $1 && .*/\1/p")
    case $2 in *.c) names='gcc clang' ;; *) names='g++ clang++' ;; esac
    shift 2
    for c in $names; do command -v $c >/dev/null && compilers="$compilers $c"; done
    for c in $compilers; do
        said=$($c -Wall -Wextra "$@" -Werror $line -o $work/$host-$c 2>&1)
        check "$host: $c: $said" "$([ -x $work/$host-$c ] && echo 1)"
        [ -x $work/$host ] || cp $work/$host-$c $work/$host 2>/dev/null
    done
    [ -x $work/$host ]
}
strict='-Wpedantic -Wconversion -Wshadow -Wdouble-promotion -std=c11'

# sides HOST PICTURE.ppm: counts the colours of the background and of boxes with six sides in the sun.
sides() {
    colours=$(tail -c +16 "$2" | od -An -v -w3 -tx1 | sort -u | wc -l)
    check "$1: $colours colours of sides in the sun alone: ambient light is dimmed, and no other" \
        "$([ "$colours" -gt 2 ] && [ "$colours" -lt 8 ] && echo 1)"
}

make_boxes $work/boxes.obj
place=0,6,8,0,0,0
for normal in gbuffer depth; do
    build/render $work/boxes.obj --camera $place --fovy 45 --near 0.1 --far 100 --size 960x540 --radius 1 \
        --set normal=$normal --out $work/$normal.png
done
most=0.006

python=
for p in python3 /usr/bin/python3; do $p -c 'import moderngl, cffi' 2>/dev/null && python=$p && break; done
if wanted python; then
    if [ -z "$python" ]; then skip 'python, its packages are missing (apt-get install python3-moderngl python3-cffi)'
    else
        $python examples/hosts/python.py $work/python.pgm
        near 'python' $work/python.pgm $work/depth.png $most
    fi
fi

# Browser pages, which use the package as npm installs it. in_browser HOST PACKAGE: whether such a page can run here.
in_browser() {
    if ! [ -d build/hosts/node_modules/$2 ]; then skip "$1, npm could not install $2"
    elif ! [ -e build/npm/ssgi.wasm ]; then skip "$1, clang or wasm-ld is missing (apt-get install clang lld)"
    elif ! [ -d build/web-deps/node_modules/puppeteer-core ]; then skip "$1, npm could not install puppeteer-core"
    elif ! command -v chromium >/dev/null || ! command -v node >/dev/null; then
        skip "$1, no browser or no node (apt-get install chromium nodejs)"
    else
        rm -rf build/hosts/node_modules/ssgi && mkdir build/hosts/node_modules/ssgi &&
            tar -xzf build/ssgi-*.tgz --strip-components=1 -C build/hosts/node_modules/ssgi
        return
    fi
    return 1
}
# shown HOST FOLDER PAGE#HASH PICTURE.png ..: takes pictures
shown() {
    host=$1
    shift
    said=$(node tests/pages/hosts.mjs "$@")
    check "$host: the console says: $said" "$([ -z "$said" ] && echo 1)"
}

if wanted babylon && in_browser babylon babylonjs; then
    cp examples/hosts/babylon.html examples/hosts/boxes.mjs build/hosts
    shown babylon build/hosts 'babylon.html' $work/babylon.png 'babylon.html#white' $work/white.png
    near 'babylon' $work/white.png $work/depth.png $most 2.2
fi

if wanted playcanvas && in_browser playcanvas playcanvas; then
    cp examples/hosts/playcanvas.html examples/hosts/boxes.mjs build/hosts
    shown playcanvas build/hosts 'playcanvas.html' $work/playcanvas.png 'playcanvas.html#white' $work/white.png \
        'playcanvas.html#white,pane' $work/pane.png
    near 'playcanvas' $work/white.png $work/depth.png $most 2.2
    panes=$(build/rmse $work/pane.png $work/white.png)
    check "playcanvas: the pane changes it by $panes" "$(is "$panes > 0.1 && $panes < 0.2")"
fi

# by_vite HOST HASH..: bundles a page, which must import no module of node's, and draws it with each hash.
by_vite() {
    page=$1
    shift
    mkdir -p build/hosts/$page && cp examples/hosts/$page.html build/hosts/$page/index.html
    cp examples/hosts/boxes.mjs build/hosts/$page
    said=$(cd build/hosts/$page && ../node_modules/.bin/vite build 2>&1)
    check "$page: vite: $said" \
        "$(echo "$said" | grep -q 'built in' && ! echo "$said" | grep -qi externalized && echo 1)"
    shown $page build/hosts/$page/dist $(for of in "$@"; do echo "index.html#$of $work/$page-$of.png"; done)
}

if wanted three && in_browser three vite; then
    by_vite three white white,reversed white,samples white,glass sun sun,none ssdo ssdo,bounce ssdo,none
    cp tests/pages/types.ts build/hosts/three
    said=$(cd build/hosts/three && ../node_modules/.bin/tsc --noEmit --strict --skipLibCheck --target es2022 \
        --module esnext --moduleResolution bundler types.ts 2>&1)
    check "three: tsc: $said" "$([ -z "$said" ] && echo 1)"
    for of in white white,reversed; do near "three, $of" $work/three-$of.png $work/depth.png $most; done
    near 'three, four samples' $work/three-white,samples.png $work/depth.png 0.02
    check 'three: the sun is dimmed' "$(cmp -s $work/three-sun.png $work/three-sun,none.png && echo 1)"
    cp tests/pages/three.html build/hosts/three-pass.html
    shown 'three, beside RenderPass' build/hosts three-pass.html $work/three-pass.png
    for pair in 'white,glass white' 'ssdo ssdo,none' 'ssdo,bounce ssdo'; do
        set -- $pair
        by=$(build/rmse $work/three-$1.png $work/three-$2.png)
        check "three: $1 is $2 but for $by" "$(is "$by > 0.01")"
    done
fi

# A later effect draws the sky by depth, so that wrong depth is seen in the picture.
if wanted postprocessing && in_browser postprocessing postprocessing; then
    by_vite postprocessing white white,render sun,render sun,render,none
    for of in white white,render; do near "postprocessing, $of" $work/postprocessing-$of.png $work/depth.png $most; done
    check 'postprocessing: the sun is dimmed by SSGIRenderPass' \
        "$(cmp -s $work/postprocessing-sun,render.png $work/postprocessing-sun,render,none.png && echo 1)"
fi

# Its rows run down, so the dither has another pattern: two such patterns differ by more than two renderers do.
if wanted three-webgpu && in_browser three-webgpu vite; then
    by_vite three-webgpu white white,reversed white,history sun sun,none
    for of in white white,reversed white,history; do
        near "three-webgpu, $of" $work/three-webgpu-$of.png $work/gbuffer.png 0.02
    done
    check 'three-webgpu: history draws what one frame does' \
        "$(cmp -s $work/three-webgpu-white.png $work/three-webgpu-white,history.png || echo 1)"
    check 'three-webgpu: the sun is dimmed' \
        "$(cmp -s $work/three-webgpu-sun.png $work/three-webgpu-sun,none.png && echo 1)"
fi

# in_both_lights HOST NORMALS: draws a host of boxes.h in sky and sun; in the sky alone, beside build/render's picture
# with such normals; in the sun alone.
in_both_lights() {
    $work/$1 $work/$1.ppm
    $work/$1 $work/$1-sky.ppm 0 1
    $work/$1 $work/$1-sun.ppm 1 0
    near "$1" $work/$1-sky.ppm $work/$2.png $most 2.2
    sides $1 $work/$1-sun.ppm
}

open_window

# Hosts with a window: name, libraries for pkg-config, normals of the host, Debian packages.
while read -r host libraries normals packages; do
    if ! wanted $host; then continue
    elif ! pkg-config --exists $(echo $libraries | tr + ' '); then
        skip "$host, its libraries are missing (apt-get install $packages)"
    elif build $host examples/hosts/$host.c $strict; then
        case $host in
        raylib)
            $work/raylib $work/raylib.png 2>/dev/null
            near raylib $work/raylib.png $work/$normals.png $most 2.2 ;;
        *) in_both_lights $host $normals ;;
        esac
    fi
done <<'END'
glfw    glfw3       gbuffer libglfw3-dev
forward glfw3       gbuffer libglfw3-dev
sdl     sdl2+glesv2 depth   libsdl2-dev libgles-dev
raylib  raylib      depth   libraylib-dev, from trixie on
END

# The pane is half green in front of all that it covers.
if wanted vtk; then
    vtk=$(cd /usr/include && ls -d vtk-9* 2>/dev/null | sed -n '1s/vtk-//p')
    if [ -z "$vtk" ]; then skip 'vtk, VTK 9 is missing (apt-get install libvtk9-dev)'
    else
        sed "s/-9\.1/-$vtk/g" examples/hosts/vtk.cpp >build/hosts/vtk.cpp
        if build vtk build/hosts/vtk.cpp -Iexamples/hosts; then
            $work/vtk $work/boxes.obj $place 1 $work/vtk
            near 'vtk' $work/vtk.png $work/depth.png $most
            panes=$(build/rmse $work/vtk-pane.png $work/vtk.png)
            check "vtk: the pane changes it by $panes" "$(is "$panes > 0.1 && $panes < 0.3")"
        fi
    fi
fi

# Blender's frame, drawn by build/render, and Cycles' own occlusion beside the truth of build/render.
if wanted blender; then
    if ! command -v blender >/dev/null; then skip 'blender, it is missing (apt-get install blender)'
    else
        at="--camera $place --fovy 45 --radius 1"
        said=$(blender --background --factory-startup --python-exit-code 1 --python examples/hosts/blender.py -- \
            $work/boxes.obj $work 2>&1) || echo "$said" | tail -3
        build/render --gbuffer $work/frame.exr $at --out $work/blender.png
        near 'blender, its frame' $work/blender.png $work/gbuffer.png 0.01
        said=$(build/render $work/boxes.obj $at --near 0.1 --far 100 --size 960x540 --set falloff=none --truth 64 \
            --score $work/ao0001.exr | head -1)
        echo "  blender, the truth against Cycles': $said"
        check "blender: Cycles' occlusion is not the truth's: $said" "$(echo "$said" | awk '{
            sub(/.*RMSE /, ""); rmse = $1 + 0; sub(/.*bias /, ""); off = $1 + 0
            print (rmse < 0.04 && off < 0.005 && off > -0.005) }')"
    fi
fi

if wanted openscenegraph; then
    if ! pkg-config --exists openscenegraph-osgViewer; then
        skip 'openscenegraph, OpenSceneGraph is missing (apt-get install libopenscenegraph-dev)'
    elif build openscenegraph examples/hosts/openscenegraph.cpp; then
        $work/openscenegraph $work/boxes.obj $place 1 $work/openscenegraph 2>$work/openscenegraph.txt
        near 'openscenegraph' $work/openscenegraph-ao.png $work/depth.png $most
        check 'openscenegraph: its picture changes' \
            "$(cmp -s $work/openscenegraph-before.png $work/openscenegraph-after.png || echo 1)"
    fi
fi

# Not in Godot, which is not here: its arithmetic and its calls.
if wanted godot; then
    if [ -z "$python" ]; then skip 'godot, cffi is missing (apt-get install python3-cffi)'
    else
        build/glsl-text --chain hsao,normal=unsigned,compute=all --vulkan $work/godot >/dev/null
        said=$($python tests/examples/godot.py $work/godot 2>&1)
        check "godot: $said" "$([ "$said" = '4 dispatches' ] && echo 1)"
        said=$(glslangValidator -V $work/godot/multiply.comp -o $work/godot/multiply.spv 2>&1)
        check "godot, its own shader: $said" "$([ -e $work/godot/multiply.spv ] && echo 1)"
    fi
fi

# Its rows run down, so the dither has another pattern, as in three-webgpu.
if wanted ogre; then
    if ! pkg-config --exists OGRE; then skip 'ogre, Ogre 1 is missing (apt-get install libogre-1.12-dev)'
    elif build ogre examples/hosts/ogre.cpp; then
        OGRE_PLUGIN_DIR=$(pkg-config --variable=plugindir OGRE) $work/ogre $work/ogre.png
        near 'ogre' $work/ogre.png $work/gbuffer.png 0.02
    fi
fi
finish
