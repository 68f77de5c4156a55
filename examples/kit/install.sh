#!/bin/sh
# Installs the Debian packages that examples and tests need: as root or through sudo; otherwise says which are missing.
need="gcc make pkg-config libosmesa6-dev libopenexr-dev libstb-dev glslang-tools glmark2-data"
missing=
for p in $need "$@"; do
    dpkg-query -W -f '${Status}' "$p" 2>/dev/null | grep -q 'ok installed' || missing="$missing $p"
done
[ -z "$missing" ] && exit 0
if ! command -v apt-get >/dev/null 2>&1; then
    command -v dpkg-query >/dev/null 2>&1 || { echo "note: not a Debian system; wanted:$missing" >&2; exit 0; }
fi
if [ "$(id -u)" = 0 ]; then
    sudo=
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
    sudo=sudo
else
    echo "please install:$missing   (apt-get install$missing)" >&2
    exit 1
fi
echo "installing:$missing"
log=$(mktemp)
install() {
    $sudo apt-get update &&
        DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y --no-install-recommends $missing
}
install >"$log" 2>&1 || {
    tail -5 "$log" >&2
    rm -f "$log"
    echo "could not install:$missing" >&2
    exit 1
}
rm -f "$log"
