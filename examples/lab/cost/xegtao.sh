#!/bin/sh
# xegtao.sh - compiles the passes of XeGTAO, from a checkout of github.com/GameTechDev/XeGTAO (version 1.30), to SPIR-V
# in build/xegtao. make cost-peers XEGTAO=FOLDER calls it.
#     sh examples/lab/cost/xegtao.sh FOLDER
# glslang has no matrices of halves, so arithmetic is of 32 bits; nor swizzles of whole numbers, which sed writes anew.
set -e
from=$1/Source/Rendering/Shaders out=build/xegtao
command -v glslangValidator >/dev/null || sh examples/kit/install.sh glslang-tools
mkdir -p $out
for file in XeGTAO.h XeGTAO.hlsli vaGTAO.hlsl; do
    sed 's/% \([248]\)\.xx/% \1/; s/ 1\.xxxx/ 1.0.xxxx/' "$from/$file" >$out/$file
done
: >$out/vaNoise.hlsl
printf '#define VA_SATURATE saturate\nSamplerState g_samplerPointClamp : register(s0);\n' >$out/vaShared.hlsl
for pass in PrefilterDepths16x16 GTAOMedium GTAOHigh DenoiseLastPass; do
    glslangValidator -D -V -S comp -e main --source-entrypoint CS$pass --stb comp 16 --suavb comp 32 --ssb comp 48 \
        -DXE_GTAO_HILBERT_LUT_AVAILABLE -DXE_GTAO_USE_HALF_FLOAT_PRECISION=0 -o $out/$pass.comp.spv $out/vaGTAO.hlsl
done
