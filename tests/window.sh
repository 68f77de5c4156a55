# window.sh - what viewer.sh, hosts.sh and vulkan.sh share: counted checks, pictures compared, Xvfb. Before they read
# this they set work, a folder that is made anew.
export LIBGL_ALWAYS_SOFTWARE=1
rm -rf $work
mkdir -p $work report
passed=0 failed=0 x=

check() {    # WHAT, whether it is so
    if [ "$2" = 1 ]; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAILED: $1"; fi
}
near() {    # WHAT A B MOST [GAMMA]: their RMSE; A's values to the power of GAMMA first
    rmse=$(build/rmse "$2" "$3" $5) || rmse=none
    echo "  $1: RMSE $rmse"
    check "$1: RMSE $rmse, at most $4" "$(awk -v a="$rmse" -v b="$4" 'BEGIN { print (a != "none" && a + 0 <= b + 0) }')"
}
skip() { echo "skipped: $1"; }
finish() {
    [ -n "$x" ] && kill "$x" 2>/dev/null
    echo "$passed passed, $failed failed"
    exit $((failed > 0))
}
open_window() {    # sets DISPLAY; without Xvfb all that follows is skipped
    if ! command -v Xvfb >/dev/null; then skip 'all windows, Xvfb is missing (apt-get install xvfb)'; finish; fi
    Xvfb -displayfd 3 -screen 0 1280x800x24 -nolisten tcp 3>$work/display 2>/dev/null &
    x=$!
    for i in $(seq 100); do [ -s $work/display ] && break; sleep 0.2; done
    DISPLAY=:$(cat $work/display)
    export DISPLAY
    if [ "$DISPLAY" = : ]; then skip 'all windows, Xvfb does not start'; finish; fi
}
