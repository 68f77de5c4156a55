#!/bin/sh
# translate.sh FOLDER TARGET.. - translates the Vulkan shaders that make glsl wrote into FOLDER.
#
#  spv     FOLDER/hsao.vulkan.frag.spv ..: SPIR-V for Vulkan, of every stage, by glslangValidator
#  wgsl    FOLDER/hsao.vulkan.frag.wgsl ..: by tint, from an npm package; compact: without names of most variables
#  hlsl    by spirv-cross: shader model 5.0, register t4 is binding 4
#  msl     by spirv-cross: Metal 2.1, texture(4) is binding 4
#
# The last three have only vertex, fragment and compute stages. y of their NDC points up, so their vertex stages negate
# it; row 0 of a target is then the same as in Vulkan. A line for each target says how many files there are; a failure
# is named, status 1.
folder=$1
tint=$(dirname "$0")/../../../build/tint/twgsl
work=$(mktemp -d) || exit 2
cores=$(getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2)
trap 'rm -rf "$work"' EXIT

has() {                                     # TOOL HOW
    command -v "$1" >/dev/null 2>&1 || { echo "translate: $1 is missing: $2" >&2; exit 2; }
}

# Runs glslangValidator for each file, because one call takes the stages of only one program. On a terminal it shows how
# many are done, and the seconds that are left.
compile() {                                 # TO FLAGS HOW MANY
    xargs -P "$cores" -I{} sh -c 'glslangValidator -V $3 "$1" -o "$2/$(basename "$1").spv" >"$2/log.$$" ||
            cat "$2/log.$$" >&2
        rm -f "$2/log.$$"
        [ ! -t 2 ] || { done=$(ls "$2" | grep -c "spv$") && passed=$(($(date +%s) - $5)) &&
            printf "\r  glslangValidator: %d of %d, %d s left   " "$done" "$4" $((passed * ($4 - done) / done)) >&2; }
        ' sh {} "$1" "$2" "$3" "$(date +%s)"
    [ ! -t 2 ] || echo >&2
}

# Compiles the vertex stages with y up, the fragment and the compute stages into a folder, once.
turn() {                                    # TO FLAGS
    [ ! -e "$1" ] || return 0
    mkdir "$1"
    for f in "$folder"/*.vulkan.*vert "$folder"/*.vulkan.*frag "$folder"/*.vulkan.*comp; do
        [ -e "$f" ] || continue
        case $f in
            *.frag|*.comp) cp "$f" "$work" ;;
            *) grep -q gl_Position "$f" && sed 's/^\( *\)gl_Position = .*;$/&\n\1gl_Position.y = -gl_Position.y;/' \
                   "$f" >"$work/$(basename "$f")" ;;            # else tessellation follows, which these languages lack
        esac
    done
    find "$work" -maxdepth 1 -name '*.vert' -o -name '*.frag' -o -name '*.comp' >"$work/list"
    of=$(wc -l <"$work/list")
    compile "$1" "$2" "$of" <"$work/list"
}

count() {                                   # NAME ENDING OF
    got=$(ls "$folder" | grep -c "\.vulkan\..*\.$2\$")
    echo "$folder: $1 $got of $3"
    [ "$got" = "$3" ] || status=1
}

shift
status=0
has glslangValidator 'apt-get install glslang-tools'
for target in "$@"; do
    rm -f "$folder"/*.vulkan.*."$target"
    case $target in
        spv)
            ls "$folder"/*.vulkan.*vert "$folder"/*.vulkan.*frag "$folder"/*.vulkan.*tes[ce] "$folder"/*.vulkan.*geom \
                "$folder"/*.vulkan.*comp 2>/dev/null >"$work/list"
            compile "$folder" '' "$(wc -l <"$work/list")" <"$work/list"
            count 'SPIR-V' spv "$(wc -l <"$work/list")" ;;
        wgsl)
            has node 'apt-get install nodejs npm'
            if [ ! -s "$tint.cjs" ] || [ ! -s "$tint.wasm" ]; then
                has npm 'apt-get install nodejs npm'
                mkdir -p "${tint%/*}" &&
                    (cd "${tint%/*}" && npm pack --silent @babylonjs/core@9.31.0 >/dev/null &&
                        tar xzf babylonjs-core-9.31.0.tgz --strip-components=3 package/assets/twgsl &&
                        mv twgsl.js twgsl.cjs && rm babylonjs-core-9.31.0.tgz) ||
                    { echo 'translate: npm cannot bring @babylonjs/core@9.31.0, which has tint' >&2; exit 2; }
            fi
            turn "$work/small" -Os
            (cd "$work/small" && ls *.spv) | (tint=$(realpath "$tint") script=$(realpath "$(dirname "$0")/wgsl.mjs")
                cd "$work/small" && xargs -P "$cores" -n 150 node "$script" "$tint" "$of")
            mv "$work"/small/*.wgsl "$folder"
            count WGSL wgsl "$of" ;;
        hlsl|msl)
            has spirv-cross 'apt-get install spirv-cross'
            turn "$work/up" ''
            how='--msl --msl-version 20100 --msl-decoration-binding'
            [ "$target" = msl ] || how='--hlsl --shader-model 50'
            for f in "$work"/up/*.spv; do
                name=$(basename "$f" .spv)
                spirv-cross "$f" $how --output "$folder/$name.$target" || {
                    echo "$name: not as $target" >&2
                    continue
                }
                # In HLSL spirv-cross prefixes the members of a block with a number that differs in each shader.
                sed -i -E 's/\b_[0-9]+_(u_ssgi_)/\1/g' "$folder/$name.$target"
            done
            count "$(echo "$target" | tr a-z A-Z)" "$target" "$of" ;;
        *) echo "translate: $target: there are spv, wgsl, hlsl, msl" >&2; exit 2 ;;
    esac
done
exit $status
