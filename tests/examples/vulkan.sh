#!/bin/sh
# vulkan.sh - draws chains by Vulkan on the processor (lavapipe) and compares them with the kit's pictures by GL. The
# validation layer must have no message:
#
#   make vulkan-test
#
# build/vulkan-replay draws the files of build/capture, with the kit's formats; build/vulkan draws a saved frame.
work=build/vulkan-test
. tests/window.sh

lacks=
layer=/usr/share/vulkan/explicit_layer.d/VkLayer_khronos_validation.json
for i in /usr/share/vulkan/icd.d/lvp_icd*.json; do lavapipe=$i; done
for h in vulkan/vulkan_raii.hpp nlohmann/json.hpp; do
    echo "#include <$h>" | ${CXX:-c++} -std=c++20 -x c++ -E - >/dev/null 2>&1 || lacks="$lacks $h"
done
[ -e "$lavapipe" ] || lacks="$lacks lavapipe"
[ -e $layer ] || lacks="$lacks VK_LAYER_KHRONOS_validation"
command -v glslangValidator >/dev/null || lacks="$lacks glslangValidator"
if [ -n "$lacks" ]; then
    skip "everything: no$lacks"
    finish
fi
${MAKE:-make} -s --no-print-directory build/capture build/glsl-text build/render build/vulkan build/vulkan-replay ||
    exit 1

export VK_DRIVER_FILES=$lavapipe VK_ICD_FILENAMES=$lavapipe
export ASAN_OPTIONS=detect_leaks=0                          # lavapipe leaks some bytes

number() { case $1 in [0-9]*.[0-9]*) echo "$1" ;; *) echo 9 ;; esac; }          # 9 for nan and for no output
capture() {    # NAME SCENE METHOD ..
    build/capture $work/"$@" && sh examples/tools/glsl/translate.sh "$work/$1" spv >$work/log && return
    cat $work/log
    return 1
}
replay() {    # CAPTURE [TEXTS ..]: $rmse, $quiet
    rmse=$(build/vulkan-replay "$@" 2>$work/messages) && quiet=1 || quiet=0
    head -c 2000 $work/messages
    rmse=$(number "$rmse")
}
while read -r name arguments; do
    rmse=9 quiet=0
    capture "$name" $arguments </dev/null && replay "$work/$name"
    echo "  $name: $arguments: RMSE $rmse"
    check "$name: RMSE $rmse, at most 0.0005; no message: $quiet" "$(is "$rmse <= 0.0005 && $quiet")"
done <<'END'
hsao        room hsao
hsao-full   room hsao set resolution=full
history     casters hsao set history=1 frames 6
ssdo        room ssdo
ssdo-lights cornell ssdo light point:0,5,-2.8,20,20,20
s3ho        room s3ho
aof         casters aof set occluders=all,field_resolution=4,rays=16
dss         casters dss
debug       room debug
END

# Compute stages draw the bits of the fragment stages, from the same capture, in formats of ALL and of BASIC.
while read -r name formats arguments; do
    differ=none quiet=0 rmse=9
    capture "$name" $arguments </dev/null && replay "$work/$name" "out=$work/$name.drawn" &&
        KIT_COMPUTE=$formats capture "$name-compute" $arguments </dev/null &&
        ls $work/$name-compute/*.comp >$work/log && [ ! -e $work/$name-compute/1-*.frag ] &&
        replay "$work/$name" "$work/$name-compute" "out=$work/$name.computed" &&
        differ=$(cmp -l "$work/$name.drawn" "$work/$name.computed" | wc -l)
    bytes=$(wc -c <"$work/$name.computed")
    echo "  $name: $formats: $arguments: $differ of $bytes bytes differ by compute stages"
    check "$name: compute: $differ of $bytes bytes differ; no message: $quiet; RMSE $rmse" \
        "$([ "$differ" = 0 ] && [ "$bytes" -gt 200000 ] && is "$rmse <= 0.0005 && $quiet")"
done <<'END'
hsao        ALL   room hsao
hsao-full   BASIC room hsao set resolution=full
history     ALL   casters hsao set history=1 frames 6
ssdo        BASIC room ssdo
bounce      ALL   room ssdo set bounce=solid-angle,history=1 frames 3
s3ho        BASIC room s3ho
debug       ALL   room debug
END

# With the constant (constant_id 2) at 10, shaders of 6 samples draw the same as shaders of 10; without it they do not.
capture steps-6 room hsao set samples=6 && capture steps-10 room hsao set samples=10
replay $work/steps-10 $work/steps-6 2=10
special=$rmse
replay $work/steps-10 $work/steps-6
echo "  steps by a constant: RMSE $special, without it $rmse"
check "steps by a constant: RMSE $special, at most 0.0005; without it $rmse, more" \
    "$(is "$special <= 0.0005 && $rmse > 0.001")"

# The host draws a saved frame.
build/glsl-text --chain hsao,depth=LINEAR,precise=1 --spv $work/host >$work/log &&
    build/render room --size 320x180 --save-gbuffer $work/frame.exr >$work/log &&
    build/vulkan $work/host $work/frame.exr 45 0.5 $work/host.exr validate &&
    rmse=$(build/render --gbuffer $work/frame.exr --fovy 45 --radius 0.5 --score $work/host.exr |
        sed -n 's/.*: RMSE \([0-9.]*\) .*/\1/p') || rmse=none
rmse=$(number "$rmse")
echo "  build/vulkan on a saved frame: RMSE $rmse"
check "build/vulkan on a saved frame: RMSE $rmse, at most 0.0005" "$(is "$rmse <= 0.0005")"
build/glsl-text --chain hsao,depth=LINEAR,precise=1,dense=1,block_set=2,texture_set=2 --spv $work/dense >$work/log &&
    build/vulkan $work/dense $work/frame.exr 45 0.5 $work/dense.exr validate && cmp $work/dense.exr $work/host.exr &&
    same=1 || same=0
check "other sets and dense bindings draw the same picture, without a message" $same
build/glsl-text --chain hsao,depth=LINEAR,precise=1,compute=ALL,group_width=16,group_height=4 --spv $work/group \
    >$work/log && build/vulkan $work/group $work/frame.exr 45 0.5 $work/group.exr validate &&
    cmp $work/group.exr $work/host.exr && same=1 || same=0
check "compute stages of 16x4 groups draw the same picture, without a message" $same
build/glsl-text --chain hsao,depth=LINEAR --spv $work/byte >$work/log &&
    build/glsl-text --chain hsao,depth=LINEAR,compute=BASIC,group_width=5,group_height=3 --spv $work/basic >$work/log &&
    build/vulkan $work/byte $work/frame.exr 45 0.5 $work/byte.exr &&
    build/vulkan $work/basic $work/frame.exr 45 0.5 $work/basic.exr validate && cmp $work/byte.exr $work/basic.exr &&
    same=1 || same=0
check "RGBA8 and RGBA16F of SSGI_GL_COMPUTE_BASIC hold what R8 and RG16F do" $same
refused() {    # FOLDER FRAME WORD [RADIUS]
    said=$(build/vulkan $work/$1 $work/$2 45 ${4:-0.5} $work/no.exr 2>&1)
    status=$?
    lines=$(echo "$said" | wc -l)
    case $said in *$3*) named=1 ;; *) named=0 ;; esac
    check "$1 $2: status $status, $said" "$([ $status$named$lines = 211 ] && [ ! -e $work/no.exr ] && echo 1)"
}
refused host none.exr none.exr
refused host frame.exr radius -1
refused nowhere frame.exr nowhere/manifest.json
refused hsao frame.exr depth=LINEAR
build/glsl-text --chain ssdo,bounce=none,depth=LINEAR --spv $work/lit >$work/log
refused lit frame.exr ENVIRONMENT

finish
