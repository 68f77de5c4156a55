#!/bin/sh
# dist.sh FOLDER VERSION - a release's files, into FOLDER. The same tree gives the same bytes, whenever it is made.
#
#   ssgi-VERSION.tar.gz            the headers, with files for CMake, Meson and pkg-config
#   ssgi-shaders-VERSION.tar.gz    the shaders of ten methods in GLSL, GLSL ES, Vulkan's GLSL, SPIR-V, WGSL, HLSL and
#                                  MSL, with manifest.json, which says how they are drawn
#   ssgi-npm-VERSION.tgz, ssgi-wgsl-npm-VERSION.tgz     the packages of make npm
#   vcpkg/, conan/                 a port and a recipe, which fetch the first archive from URL
#   CHANGELOG.md, SHA256SUMS
#
# URL: where the files will lie; by default where they are. METHODS: of the shaders. What cannot be made here, for lack
# of a program, is left out, and a line says so.
to=$1 version=$2
packages=examples/tools/packages
work=$(mktemp -d) || exit 2
trap 'rm -rf "$work"' EXIT
rm -rf "$to" && mkdir -p "$to" || exit 2
URL=${URL:-file://$(realpath "$to")}
# The time that all files get: this commit's.
time=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || echo 0)}

left_out() { echo "dist: left out: $1: $(tail -n 1 "$work/why")"; }
filled() { sed "s|@VERSION@|$version|g; s|@URL@|$URL|g; s|@SHA256@|$sha256|g; s|@SHA512@|$sha512|g" "$1"; }
sum() { "$1" "$archive" | cut -d' ' -f1; }
pack() {                                    # FOLDER: as an archive, into $to
    (cd "$work" && tar --format=ustar --sort=name --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX \
        --mtime="@$time" -cf - "$1") | gzip -n9 >"$to/$1.tar.gz" || exit 2
}

awk -f $packages/changelog.awk ssgi.h >"$to/CHANGELOG.md" || exit 2
headers=ssgi-$version archive=$to/ssgi-$version.tar.gz
mkdir "$work/$headers" && cp ssgi.h ssgi_gl.h LICENSE "$to/CHANGELOG.md" "$work/$headers" || exit 2
for f in CMakeLists.txt meson.build ssgi.pc ssgi-config.cmake ssgi-config-version.cmake; do
    filled $packages/$f >"$work/$headers/$f" || exit 2
done
pack "$headers"
sha256=$(sum sha256sum) sha512=$(sum sha512sum)
for f in vcpkg/portfile.cmake vcpkg/vcpkg.json conan/conanfile.py; do
    mkdir -p "$to/${f%/*}" && filled $packages/$f >"$to/$f" || exit 2
done

shaders=ssgi-shaders-$version chains=
for method in ${METHODS:-hsao-fast hsao hsao-best hsao-quarter hsao-history ssdo s3ho ssbn dss aof}; do
    chains="$chains --chain $method"
done
build/glsl-text $chains --330 --300es --vulkan "$work/$shaders" >/dev/null || exit 2
command -v glslangValidator >/dev/null && command -v spirv-cross >/dev/null ||
    sh examples/kit/install.sh glslang-tools spirv-cross || true
translate() { sh examples/tools/glsl/translate.sh "$work/$shaders" "$@" >"$work/why" 2>&1; }
translate spv wgsl hlsl msl || for language in spv wgsl hlsl msl; do
    translate $language && continue
    rm -f "$work/$shaders"/*.$language
    left_out "shaders in $language"
done
cp LICENSE "$work/$shaders"
pack "$shaders"

if ${MAKE:-make} -s --no-print-directory npm >"$work/why" 2>&1; then
    cp build/ssgi-*.tgz "$to/ssgi-npm-$version.tgz" && cp build/wgsl/ssgi-*.tgz "$to/ssgi-wgsl-npm-$version.tgz"
else left_out 'the npm packages'; fi
(cd "$to" && find . -type f ! -name SHA256SUMS | sed 's|^\./||' | LC_ALL=C sort | xargs sha256sum >"$work/sums" &&
    mv "$work/sums" SHA256SUMS && wc -c $(cut -c67- SHA256SUMS) | sed '$d')
