#!/bin/sh
# Installs the Debian packages that examples and tests need, as root or by sudo; else it lists the missing packages. One
# kind of context without a window suffices: OSMesa's or, where that is missing (Mesa dropped it in 25.1), EGL's with
# Mesa's rasteriser.
need="gcc make pkg-config libopenexr-dev libstb-dev glslang-tools glmark2-data"
lacking() {
    for p in "$@"; do
        dpkg-query -W -f '${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || printf ' %s' "$p"
    done
}
missing=$(lacking $need "$@")
osmesa=$(lacking libosmesa6-dev) egl=$(lacking libegl-dev libegl-mesa0 libgl1-mesa-dri)
[ -n "$osmesa" ] && [ -n "$egl" ] || osmesa= egl=
[ -z "$missing$egl" ] && exit 0
wanted="$missing$osmesa${egl:+ (or, where there is none,$egl)}"
if ! command -v apt-get >/dev/null 2>&1; then
    command -v dpkg-query >/dev/null 2>&1 || { echo "note: not a Debian system; wanted:$wanted" >&2; exit 0; }
fi
if [ "$(id -u)" = 0 ]; then
    sudo=
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
    sudo=sudo
else
    echo "please install:$wanted   (apt-get install$missing$osmesa)" >&2
    exit 1
fi
echo "installing:$wanted"
log=$(mktemp)
get() { DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y --no-install-recommends "$@"; }
install() {
    $sudo apt-get update && { get $missing $osmesa || { [ -n "$egl" ] && get $missing $egl; }; }
}
install >"$log" 2>&1 || {
    tail -5 "$log" >&2
    rm -f "$log"
    echo "could not install:$wanted" >&2
    exit 1
}
rm -f "$log"
