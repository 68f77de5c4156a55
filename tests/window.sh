# window.sh - shared by viewer.sh, hosts.sh and vulkan.sh: counted checks, comparison of pictures, Xvfb, boxes. They set
# work, a folder that is made anew, before they read this.
export LIBGL_ALWAYS_SOFTWARE=1
rm -rf $work
mkdir -p $work report
passed=0 failed=0 x=

check() {    # NAME OK: passes if OK is 1
    if [ "$2" = 1 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $1"; fi
}
is() { awk "BEGIN { print ($*) ? 1 : 0 }"; }
near() {    # NAME A B MOST [GAMMA]: their RMSE is at most MOST; A is first taken to the power of GAMMA
    rmse=$(build/rmse "$2" "$3" $5) || rmse=9
    echo "  $1: RMSE $rmse"
    check "$1: RMSE $rmse, at most $4" "$(is "$rmse <= $4")"
}
skip() { echo "skipped: $1"; }
finish() {
    [ -n "$x" ] && kill "$x" 2>/dev/null
    echo "$passed passed, $failed failed"
    exit $((failed > 0))
}
open_window() {    # sets DISPLAY; without Xvfb the tests are skipped
    if ! command -v Xvfb >/dev/null; then skip 'all windows, Xvfb is missing (apt-get install xvfb)'; finish; fi
    Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp -noreset 3>$work/display 2>/dev/null &
    x=$!
    for i in $(seq 100); do [ -s $work/display ] && break; sleep 0.2; done
    DISPLAY=:$(cat $work/display)
    export DISPLAY
    if [ "$DISPLAY" = : ]; then skip 'all windows, Xvfb does not start'; finish; fi
}
make_boxes() {    # FILE: the boxes of examples/hosts/boxes.h as an OBJ with normals
    awk '
    function box(x, y, z, a, b, c,   i, k, f) {
        for (i = 0; i < 8; i++) printf("v %g %g %g\n", i % 2 ? a : x, int(i / 2) % 2 ? b : y, int(i / 4) ? c : z)
        split("1 5 7 3,2 4 8 6,1 2 6 5,3 7 8 4,1 3 4 2,5 6 8 7", f, ",")
        for (i = 1; i <= 6; i++) {
            split(f[i], k, " ")
            printf("f %d//%d %d//%d %d//%d %d//%d\n", n + k[1], i, n + k[2], i, n + k[3], i, n + k[4], i)
        }
        n += 8
    }
    BEGIN {
        print "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1"
        box(-4.5, -0.2, -4.5, 4.5, 0, 4.5)
        for (i = 1; i < 25; i++) {
            x = 1.5 * (i % 5 - 2); z = 1.5 * (int(i / 5) - 2)
            a = 0.35 + 0.05 * (i * 3 % 8); b = 0.4 + 0.4 * (i * 7 % 5); c = 0.35 + 0.05 * (i * 5 % 7)
            box(x - a, 0, z - c, x + a, b, z + c)
        }
    }' >"$1"
}
