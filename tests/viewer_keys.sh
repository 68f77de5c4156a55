# viewer_keys.sh - the part of viewer.sh that sits before the window: every key that --help lists is pressed, and what
# it changes is looked for in the line that the window prints for build/render; files are dropped; the size follows the
# time; the printed line draws the window's picture. Uses its check, near and $work.

begin() {    # ARGUMENTS: a window of its own
    : >$work/printed
    (cd $work && exec ../../build/viewer "$@" >printed 2>said) &
    viewer=$!
    lines=0
    build/press wait
}
soon() {    # COMMAND: until it succeeds; no longer than the window lives, or has spent 30 s of processor meanwhile
    most=$(($(ps -o cputimes= -p $viewer || echo 0) + 30))
    for i in $(seq 6000); do
        "$@" && return
        spent=$(ps -o cputimes= -p $viewer) && [ "$spent" -le $most ] || return
        sleep 0.02
    done
}
printed() { [ "$(wc -l <$work/printed)" -ge $lines ]; }
stored() { saved=$(ls $work/ssgi-*.png 2>/dev/null); [ -s "$saved" ]; }
end() { build/press "${1:-q}"; wait $viewer; ended=$?; }
busy() { awk '{ print ($14 + $15) * 10 }' /proc/$viewer/stat 2>/dev/null || echo 0; }    # ms of processor so far
ask() {    # the line after these keys into $line; what it took the window, in ms of processor, into $took
    build/press "$@"
    from=$(busy)
    build/press w
    lines=$((lines + 1))
    soon printed
    took=$(($(busy) - from))
    line=$(sed -n ${lines}p $work/printed)
}
value() { printf '%s\n' "$line" | sed -n "s/.* --$1 \\([^ ]*\\).*/\\1/p"; }
pressed=
press() {    # KEY OPTION AWK WHAT: pressed, the option's value "b" is to "a" before as AWK says; "" = it has none
    before=$(value "$2")
    pressed="$pressed $1"
    ask "$1"
    check "viewer, key $1: $4: --$2 '$before', then '$(value "$2")'" \
        "$(awk -v a="$before" -v b="$(value "$2")" "BEGIN { split(a, p, /[:,]/); split(b, q, /[:,]/); print ($3) }")"
}
saw() {    # KEY, whether it did what it should, WHAT
    pressed="$pressed $1"
    check "viewer, key $1: $3" "$2"
}
picture() { rm -f $work/ssgi-*.png; build/press "$@" o; soon stored; }
differ() { build/rmse "$1" "$2" 2>/dev/null | awk '{ print ($1 > 0.004) } END { if (!NR) print 1 }'; }

# ---- settings and light, by the line
begin room --size 320x180 --scale 1 --panel 0
ask
methods=$(build/render --list | sed '/^settings/,$d' | awk '{ print $1 }')
press bracketleft radius 'b < a && b > 0.85 * a' smaller
press bracketright radius 'b > a' larger
press b set 'a !~ /behind/ && b ~ /thickness=constant/' 'what is behind'
press d set 'b ~ /normal=depth/' 'normals of depth'
press t set 'a ~ /history=1/ && b !~ /history/' 'history off'
ask t
press i light 'q[3] > p[3]' 'sun higher'
press k light 'q[3] < p[3]' 'sun lower'
press j light 'atan2(q[2], q[4]) > atan2(p[2], p[4])' 'sun to the left'
press l light 'atan2(q[2], q[4]) < atan2(p[2], p[4])' 'sun to the right'
press minus light 'q[5] < p[5] && q[7] < p[7]' 'sun weaker'
press equal light 'q[5] > p[5] && q[7] > p[7]' 'sun stronger'
press u light 'a != "" && b == ""' 'no sun'
ask u
press 9 env-strength 'b < a' 'sky weaker'
press 0 env-strength 'b > a' 'sky stronger'
press comma env-turn 'b == a + 15' 'sky to the left'
ask comma
press period env-turn 'b == a - 15' 'sky to the right'
skies=
for i in 1 2 3 4 5 6; do press y env 'a != b' 'next sky'; skies="$skies $(value env)"; done
check "viewer, skies:$skies" "$([ "$skies" = ' probe windows street white  sky' ] && echo 1)"
found=
for m in $methods; do ask m; found="$found$(value method)
"; done
pressed="$pressed m"
check 'viewer, key m: all of build/render --list' \
    "$([ "$(printf %s "$found" | sort)" = "$(printf '%s\n' $methods | sort)" ] && echo 1)"
press n method 'a != b' 'the method before'
ask m
press r camera 'a == b' 'camera where it was'
ask drag:40,10
check "viewer, a drag: $(value camera)" "$([ "$(value camera)" != "$before" ] && echo 1)"
turned=$(value camera)
ask turn:3
check "viewer, the wheel: $(value camera)" "$([ "$(value camera)" != "$turned" ] && echo 1)"
ask r
check "viewer, key r: $(value camera)" "$([ "$(value camera)" = "$before" ] && echo 1)"
build/press a wait
ask
saw a "$([ "$(value camera)" != "$before" ] && echo 1)" 'the camera circles'
ask a wait
turned=$(value camera)
ask wait
check 'viewer, key a: stands again' "$([ "$(value camera)" = "$turned" ] && echo 1)"
press v camera 'a == b' 'an object moves'
ask wait v
moved=$(value slide)
ask wait
check "viewer, key v: moves, then stands: $moved" "$([ -n "$moved" ] && [ "$(value slide)" = "$moved" ] && echo 1)"
ask r
check "viewer, key r: the object is back" "$([ -z "$(value slide)" ] && echo 1)"
press f size 'b == "160x90"' 'half size'
press f size 'b == "80x45"' 'a quarter'
ask f f
check "viewer, key f: whole: $(value size)" "$([ "$(value size)" = 320x180 ] && echo 1)"
ask size:400x240 wait
check "viewer, another size: $(value size)" "$([ "$(value size)" = 400x240 ] && echo 1)"
pressed="$pressed w"
title=$(build/press title)
check "viewer, the title: $title" "$(printf %s "$title" | grep -qE '^room - ssdo - 400x240 - [0-9.]+ ms$' && echo 1)"
end q
saw q "$([ $ended = 0 ] && echo 1)" "status $ended"

# ---- what only the picture shows
begin room --size 320x180 --scale 1 --panel 0 --method hsao --set history=0
picture
cp "$saved" $work/colours.png
picture c
saw c "$(differ "$saved" $work/colours.png)" 'visibility alone'
cp "$saved" $work/alone.png
saw o "$([ -s "$saved" ] && echo 1)" 'a PNG'
picture s M
saw s "$(differ "$saved" $work/alone.png)" 'the right half has another method'
saw M "$([ "$(build/press wait title | sed 's/.*hsao | \([^ ]*\).*/\1/')" = hsao-fast ] && echo 1)" 'of the right half'
cp "$saved" $work/half.png
for k in Left Right; do picture $k $k $k $k; saw $k "$(differ "$saved" $work/half.png)" 'the split moves'; done
build/press N wait wait
saw N "$([ "$(build/press wait title | sed 's/.*hsao | \([^ ]*\).*/\1/')" = hsao ] && echo 1)" 'of the right half'
rm -f $work/ssgi-*.exr
build/press x wait wait
saw x "$([ -s "$(ls $work/ssgi-*.exr)" ] && echo 1)" 'an EXR'
grabbed() { build/press wait grab:$1; }
build/press wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait wait
grabbed $work/plain.ppm
for k in h g; do
    build/press $k
    grabbed $work/text.ppm
    saw $k "$(differ $work/text.ppm $work/plain.ppm)" 'text is shown'
    [ $k = g ] || build/press $k
done
build/press e wait wait wait
grabbed $work/error.ppm
saw e "$(build/rmse $work/error.ppm $work/text.ppm | awk '{ print ($1 > 0) }')" 'the error is shown'
build/press e g wait
picture
grabbed $work/text.ppm
check 'viewer, the saved name is on the screen' "$(differ $work/text.ppm $work/plain.ppm)"
end Escape
saw Escape "$([ $ended = 0 ] && echo 1)" "status $ended"

listed=$(build/viewer --help | sed '1,/^keys/d' | awk '!/^  (drag|drop)/ { print $1; if ($2 ~ /^[A-Z]$/) print $2 }')
for k in $listed; do
    case $k in
    '[') k=bracketleft ;; ']') k=bracketright ;; -) k=minus ;; '=') k=equal ;; ,) k=comma ;; .) k=period ;;
    left) k=Left ;; right) k=Right ;; escape) k=Escape ;;
    esac
    case "$pressed " in *" $k "*) ;; *) check "viewer, key $k is listed, but not tried here" 0 ;; esac
done

# ---- files that are dropped
begin room --size 320x180 --scale 1 --panel 0 --set history=0
ask
whole=$line
cp tests/triangle.gltf "$work/it's a triangle.gltf"
printf 'nothing' >$work/broken.glb
printf '#?RADIANCE\nFORMAT' >$work/broken.hdr
printf 'v 0 0 0\n' >$work/empty.obj
rm -f $work/absent.ply
for f in broken.glb broken.hdr empty.obj absent.ply; do
    ask "drop:$PWD/$work/$f"
    check "viewer, drop of $f: $(tail -n 1 $work/said)" \
        "$(tail -n 1 $work/said | grep -q "^viewer: .*$f" && [ "$line" = "$whole" ] && echo 1)"
done
check "viewer, drops that fail: a line each: $(cat $work/said)" "$([ "$(wc -l <$work/said)" = 4 ] && echo 1)"
ask "drop:$PWD/$work/dim.hdr"
check "viewer, drop of a sky: $(value env)" "$([ "$(value env)" = "$PWD/$work/dim.hdr" ] && echo 1)"
if build/viewer tests/triangle.gltf --env none 2>&1 | grep -q 'reads OBJ alone'; then
    skip 'viewer, drop of a glTF: Assimp is missing (apt-get install libassimp-dev)'
    ask "drop:$PWD/$work/yard.obj"
else
    ask "drop:$PWD/$work/it%27s%20a%20triangle.gltf"
    check "viewer, drop of a model: $line" "$(printf %s "$line" | grep -qF "it'\\''s a triangle.gltf'" && echo 1)"
    ask "drop:$PWD/$work/yard.obj"
fi
check "viewer, drop of an OBJ: $line" "$(printf %s "$line" | grep -qF "$work/yard.obj" && echo 1)"
end

# ---- the size that there is time for
took_of() { printf '%s\n' "$1" | sed -n 's/.* - \([0-9.]*\) ms.*/\1/p'; }    # TITLE: ms of its frame
middle() { printf '%s\n' "$@" | sort -n | sed -n 5p; }
for m in dss ssdo; do
    begin room --size 1280x720 --panel 0 --method $m
    build/press a wait wait wait wait wait wait wait wait
    waited= drawn=
    for i in 1 2 3 4 5 6 7 8 9; do
        drawn="$drawn $(took_of "$(build/press wait title)")"
        ask i
        waited="$waited $took"
    done
    small=$(value size)
    check "viewer, $m: a window of 1280x720 is drawn at $small" "$([ -n "$small" ] && echo 1)"
    echo "  viewer, $m: while it moves, a window of 1280x720 is drawn at $small, frames take$drawn ms;"
    echo "    keys are answered after$waited ms of processor"
    check "viewer, $m: frames take 100 to 250 ms, or less of the whole window: the middle of$drawn" \
        "$(middle $drawn | awk -v size=$small '{ print ($1 <= 250 && ($1 >= 100 || size == "1280x720")) }')"
    check "viewer, $m: keys take 500 ms of all processors at most: the middle of$waited" \
        "$(middle $waited | awk -v n="$(nproc)" '{ print ($1 <= 500 * n) }')"
    [ $m = ssdo ] || end
done
build/press size:320x180 wait wait wait wait wait wait wait wait wait wait i wait wait wait wait
ask
check "viewer, of a window of 320x180 a larger share is drawn: $(value size)" \
    "$(awk -v a="$small" -v b="$(value size)" 'BEGIN { print (a + 0 == 1280 || b / 320 > a / 1280) }')"
end
# ---- what a view that stays becomes; a radius of nothing leaves the scene's own colours, which are few
shown() {    # PATTERN: the window's title is so
    title=$(build/press title)
    case $title in $1) ;; *) false ;; esac
}
reaches() {    # PATTERN SECONDS FRAMES: after so many seconds at most; or where frames are slow, after so many of them
    was=$(took_of "$(build/press title)")
    from=$(date +%s%N)
    soon shown "$1"
    waited=$((($(date +%s%N) - from) / 1000000))
    echo "  viewer, at rest: '$title' after $waited ms"
    case $title in $1) so=1 ;; *) so=0 ;; esac
    check "viewer: '$title' after $waited ms; $1 is wanted after $2 s, or $3 frames" \
        "$(echo $so $waited $was $(took_of "$title") | awk -v most=$(($2 * 1000)) -v frames=$3 \
            '{ print ($1 && ($2 <= most || $2 <= 1000 + frames * ($3 > $4 ? $3 : $4))) }')"
}
colours() { tail -c $((3 * 640 * 360)) "$1" | od -An -v -tu1 -w3 | sort -u | wc -l; }
set -- room --size 640x360 --panel 0 --method hsao --set history=0 --radius 1e-6
begin "$@" --scale 1
build/press wait wait wait grab:$work/frame.ppm
end
begin "$@"
reaches '*640x360 - * - mean of 32' 10 32
build/press wait grab:$work/mean.ppm
end
few=$(colours $work/frame.ppm) many=$(colours $work/mean.ppm)
echo "  viewer, at rest: the mean has $many colours, a frame $few"
check "viewer, at rest: the mean has $many colours, a frame $few" "$([ $many -gt $((2 * few)) ] && echo 1)"
begin room --size 1280x720 --panel 0
reaches '*1280x720 - * - mean of [4-9]*' 10 4
build/press drag:40,10
reaches '* ms' 1 1
reaches '*1280x720 - * - mean of *' 2 2
build/press i
reaches '* ms' 1 1
end
begin room --size 1280x720 --panel 0 --method ssdo-best --scale 0.25
ask
check "viewer, --scale 0.25: $(value size)" "$([ "$(value size)" = 320x180 ] && echo 1)"
end

# ---- the printed line
again() {    # NAME MOST ARGUMENTS: the window's picture beside the line's
    name=$1 most=$2
    shift 2
    (cd $work && ../../build/viewer "$@" --command --shot again.png >printed 2>said)
    line=$(tail -n 1 $work/printed)
    sh -c "$(printf %s "$line" | sed "s| --out .*| --out $work/repeated.png|; s|yard.obj|$work/yard.obj|")" \
        >$work/out 2>&1 || cat $work/out
    near "viewer, the line of $name" $work/again.png $work/repeated.png "$most"
}
begin casters --size 320x180 --scale 1 --panel 0
build/press m n drag:90,20 wait drag:-40,0 turn:2 i i 9 wait wait wait wait wait wait wait wait wait wait
ask
picture
cp "$saved" $work/again.png
sh -c "$(printf %s "$line" | sed "s| --out .*| --out $work/repeated.png|")" >$work/out 2>&1 || cat $work/out
near 'viewer, the line of a window after keys, drags and the wheel' $work/again.png $work/repeated.png 0.003
end
for m in $methods; do
    case $m in dss*) scene=boxes ;; *) scene=casters ;; esac
    again "$m" 0.001 $scene --method $m --size 240x136 --frames 5
done
again 'a model, its light and an object elsewhere' 0.001 yard.obj --ground --method ssdo --camera $place --up 0.1,1,0 \
    --fovy 50 --env street --env-turn 77 --env-strength 2.5 --light sun:1,2,3,1,0.8,0.6 --light point:0,2,0,3,2,1 \
    --slide 0.4,0,0.3 --radius 0.7 --set thickness=slabs,bounce=none --size 240x136 --frames 9
again 'an orthographic view' 0.001 casters --method s3ho --ortho-height 9 --size 240x136 --frames 3
again 'visibility alone' 0.001 casters --method hsao --colours 0 --set history=0 --size 240x136
again 'a scene with its own light' 0.001 random:streets:3 --method ssdo --size 240x136 --frames 2
