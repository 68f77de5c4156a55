# viewer_keys.sh - a part of viewer.sh: presses every key that --help lists and looks for its effect in the line that
# the window prints for build/render; drops files; checks that the size follows the frame time, and that the printed
# line draws the window's picture. Uses its check, near and $work.

begin() {    # ARGUMENTS: opens a new window
    : >$work/printed
    (cd $work && exec ../../build/viewer "$@" >printed 2>said) &
    viewer=$!
    lines=0
    build/press wait
}
soon() {    # COMMAND: waits until it succeeds, while the window lives and has spent less than 30 s of processor
    most=$(($(ps -o cputimes= -p $viewer || echo 0) + 30))
    for i in $(seq 1200); do
        "$@" && return
        spent=$(ps -o cputimes= -p $viewer) && [ "$spent" -le $most ] || return
        sleep 0.1
    done
}
shown() {    # PATTERN: whether it matches the title, which is written four times a second
    title=$(build/press title)
    case $title in $1) ;; *) false ;; esac
}
printed() { [ "$(wc -l <$work/printed)" -ge $lines ]; }
stored() { saved=$(ls $work/ssgi-*.$1 2>/dev/null); [ -s "$saved" ]; }
end() { build/press "${1:-q}"; wait $viewer; ended=$?; }
ask() {    # puts the line printed after these keys into $line
    build/press "$@" w
    lines=$((lines + 1))
    soon printed
    line=$(sed -n ${lines}p $work/printed)
}
value() { printf '%s\n' "$line" | sed -n "s/.* --$1 \\([^ ]*\\).*/\\1/p"; }
picture() { rm -f $work/ssgi-*.png; build/press "$@" o; soon stored png; }
grabbed() { build/press "$@" wait wait grab:$work/grab.ppm; saved=$work/grab.ppm; }
differ() { build/rmse "$1" "$2" 2>/dev/null | awk '{ print ($1 > 0.001) } END { if (!NR) print 1 }'; }
wait_for() { for i in $(seq "$1"); do build/press wait; done; }

# ---- settings, light and camera, by the line: KEYS joined by +, the option, and an AWK condition on its value: "a"
# before the keys, "b" after them, "" = no value. p and q hold the parts of a and b.
pressed=
begin room --size 160x90 --scale 1 --panel 0
ask
home=$(value camera)
while read -r keys option is what; do
    before=$(value "$option")
    pressed="$pressed $(echo "$keys" | tr + ' ')"
    ask $(echo "$keys" | tr + ' ')
    check "viewer, $keys: $what: --$option '$before', then '$(value "$option")'" "$(
        awk -v a="$before" -v b="$(value "$option")" -v home="$home" \
            "BEGIN { split(a, p, /[:,]/); split(b, q, /[:,]/); print ($(echo "$is" | sed 's/_/ /g')) }")"
done <<'END'
bracketleft     radius  b<a&&b>0.85*a                       smaller
bracketright    radius  b>a                                 larger
b               set     a!~/behind/&&b~/thickness=constant/ the thickness of surfaces
d               set     b~/normal=depth/                    normals of depth
t               set     a~/history=1/&&b!~/history/         history off
t               set     b~/history=1/                       history on
i               light   q[3]>p[3]                           sun higher
k               light   q[3]<p[3]                           sun lower
j               light   atan2(q[2],q[4])>atan2(p[2],p[4])   sun to the left
l               light   atan2(q[2],q[4])<atan2(p[2],p[4])   sun to the right
minus           light   q[5]<p[5]&&q[7]<p[7]                sun weaker
equal           light   q[5]>p[5]&&q[7]>p[7]                sun stronger
u               light   a!=""&&b==""                        no sun
u               light   b~/^sun:/                           the sun again
9               env-strength    b<a                         sky weaker
0               env-strength    b>a                         sky stronger
comma           env-turn        b==a+15                     sky to the left
comma           env-turn        b==a+15                     and further
period          env-turn        b==a-15                     sky to the right
y               env     b=="probe"                          next sky
y               env     b=="windows"                        next sky
y               env     b=="street"                         next sky
y               env     b=="white"                          next sky
y               env     b==""                               no sky
y               env     b=="sky"                            the first sky
n               method  a!=b                                the method before
m               method  a!=b                                next method
r               camera  a==b                                camera where it was
drag:40,10      camera  a!=b                                a drag turns it
turn:3          camera  a!=b                                the wheel moves it
r               camera  b==home                             camera back
a+wait          camera  a!=b                                camera circles
a               camera  a!=b                                camera stands,
wait            camera  a==b                                and stays
v+wait          slide   b!=""                               an object moves
v               slide   a!=b                                it stands,
wait            slide   a==b&&b!=""                         and stays
r               slide   b==""                               object back
f               size    b=="80x45"                          half size
f               size    b=="40x23"                          a quarter
f+f             size    b=="160x90"                         whole
size:200x120+wait   size    b=="200x120"                    another size
END
methods=$(build/render --list | sed '/^settings/,$d' | awk '/^[a-z]/ { print $1 }')
found=
for m in $methods; do ask m; found="$found$(value method)
"; done
check 'viewer, key m: all of build/render --list' \
    "$([ "$(printf %s "$found" | sort)" = "$(printf '%s\n' $methods | sort)" ] && echo 1)"
soon shown 'room - ssdo - 200x120 - *[0-9] ms'
check "viewer, the title: $title" "$(shown 'room - ssdo - 200x120 - *[0-9] ms' && echo 1)"
end q
check "viewer, key q: status $ended" "$([ $ended = 0 ] && echo 1)"

# ---- effects seen in the picture alone: KEYS, how they are seen, what differs from the picture before
begin room --size 240x136 --scale 1 --panel 0 --method hsao --set history=0
picture
while read -r keys seen what; do
    keys=$(echo "$keys" | tr + ' ')
    pressed="$pressed $keys"
    mv "$saved" $work/before
    $seen $keys
    check "viewer, $keys: $what" "$(differ "$saved" $work/before)"
    [ "$what" != 'the split moves back' ] || grabbed wait
done <<'END'
c               picture visibility alone
s+M             picture the right half has another method
Left+Left+Left+Left     picture the split moves
Right+Right+Right+Right picture the split moves back
h               grabbed the keys are shown
h               grabbed and go
g               grabbed the panel is shown
e+wait          grabbed the error is shown
END
soon shown '*hsao | hsao-fast *'
check "viewer, key M: of the right half: $title" "$(shown '*hsao | hsao-fast *' && echo 1)"
build/press N x
soon shown '*hsao | hsao *'
check "viewer, key N: of the right half: $title" "$(shown '*hsao | hsao *' && echo 1)"
soon stored exr
check 'viewer, key x: an EXR' "$([ -s "$saved" ] && echo 1)"
end Escape
check "viewer, key Escape: status $ended" "$([ $ended = 0 ] && echo 1)"

pressed="$pressed N x o q w Escape "
listed=$(build/viewer --help | sed '1,/^keys/d' | awk '!/^  (drag|drop)/ { print $1; if ($2 ~ /^[A-Z]$/) print $2 }')
for k in $listed; do
    case $k in
    '[') k=bracketleft ;; ']') k=bracketright ;; -) k=minus ;; '=') k=equal ;; ,) k=comma ;; .) k=period ;;
    left) k=Left ;; right) k=Right ;; escape) k=Escape ;;
    esac
    case "$pressed " in *" $k "*) ;; *) check "viewer, key $k is listed, but not tried here" 0 ;; esac
done

# ---- dropped files
begin room --size 96x54 --scale 1 --panel 0 --set history=0
ask
whole=$line
cp tests/examples/triangle.gltf "$work/it's a triangle.gltf"
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
for drop in "dim.hdr $work/dim.hdr" "it%27s%20a%20triangle.gltf it'\\''s a triangle.gltf'" \
    "boxes.obj $work/boxes.obj"; do
    ask "drop:$PWD/$work/${drop%% *}"
    if tail -n 1 $work/said | grep -q 'reads OBJ alone'; then
        skip 'viewer, drop of a glTF: Assimp is missing (apt-get install libassimp-dev)'
    else check "viewer, drop of ${drop%% *}: $line" "$(printf %s "$line" | grep -qF "${drop#* }" && echo 1)"; fi
done
end

# ---- the size fits the frame time; a view at rest is refined
# A title ends with "WxH - MS ms".
begin room --size 1280x720 --panel 0 --method ssdo
build/press a
paced() {    # whether a frame takes 100 to 250 ms, or less and shows the whole window
    title=$(build/press wait title)
    small=$(echo "$title" | sed 's/.* - \([0-9]*\)x.*/\1/') ms=$(echo "$title" | sed 's/.* - \([0-9.]*\) ms.*/\1/')
    [ "$(is "$ms <= 250 && ($ms >= 100 || $small == 1280)")" = 1 ]
}
soon paced && so=1 || so=0
check "viewer, while it moves: a frame takes 100 to 250 ms, or less of the whole window: $title" $so
build/press size:320x180
larger() {    # whether a larger share of the window is drawn
    title=$(build/press wait i title)
    [ "$(is "$small == 1280 || $(echo "$title" | sed 's/.* - \([0-9]*\)x.*/\1/') / 320 > $small / 1280")" = 1 ]
}
soon larger && so=1 || so=0
check "viewer, of a window of 320x180 a larger share is drawn than $small of 1280: $title" $so
end
begin room --size 640x360 --panel 0
while read -r key pattern; do
    build/press $key
    soon shown "$pattern" && so=1 || so=0
    check "viewer, at rest or not: '$title', not '$pattern'" $so
done <<'END'
wait *640x360 - * - mean of 32
drag:40,10 *[0-9] ms
wait *640x360 - * - mean of *
i *[0-9] ms
END
end

# ---- the printed line
repeated() {    # NAME MOST PICTURE: compares the picture that the line in $line draws with the window's
    sh -c "$(printf %s "$line" | sed "s| --out .*| --out $work/repeated.png|; s| boxes.obj| $work/boxes.obj|")" \
        >$work/out 2>&1 || cat $work/out
    near "viewer, the line of $1" "$3" $work/repeated.png "$2"
}
begin casters --size 160x90 --scale 1 --panel 0
build/press m n drag:90,20 wait drag:-40,0 turn:2 i i 9
wait_for 10
ask
picture
repeated 'a window after keys, drags and the wheel' 0.003 "$saved"
end
{
    for m in $methods; do
        case $m in dss*) scene=boxes ;; *) scene=casters ;; esac
        echo "$scene --method $m --frames 2"
    done
    echo "boxes.obj --ground --method ssdo --camera $place --up 0.1,1,0 --fovy 50 --env street --env-turn 77" \
        "--env-strength 2.5 --light sun:1,2,3,1,0.8,0.6 --light point:0,2,0,3,2,1 --slide 0.4,0,0.3 --radius 0.7" \
        "--set thickness=slabs,bounce=none --frames 9"
    echo "casters --method s3ho --ortho-height 9 --frames 3"
    for t in back slabs solid; do echo "room --method hsao --colours 0 --set history=0,thickness=$t"; done
    echo "random:streets:3 --method ssdo --frames 2"
} >$work/lines
while read -r words; do
    (cd $work && ../../build/viewer $words --size 120x68 --command --shot again.png >printed 2>said </dev/null)
    line=$(tail -n 1 $work/printed)
    repeated "$words" 0.001 $work/again.png
done <$work/lines
line=$(build/viewer room --scale 0.25 --size 240x136 --command --shot $work/again.png)
check "viewer, --scale 0.25: $line" "$([ "$(value size)" = 60x34 ] && echo 1)"
