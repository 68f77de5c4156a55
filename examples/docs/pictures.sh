#!/bin/sh
# pictures.sh - pictures of README, METHODS.md and TUNING.md: make pictures [ONLY=radius]. A picture is its name, a crop
# of 1280x720, by how much that is enlarged (without a filter), if it has several rows how many panels a row has, and
# another size than 1280x720; then its panels, each a label and what build/render is given. Of --frames a panel is the
# last frame.
set -e
cd "$(dirname "$0")/../.."
command -v montage >/dev/null || sh examples/kit/install.sh imagemagick fonts-dejavu-core
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

draw() {    # label, flags
    count=$((count + 1))
    panel=$work/$name-$(printf %02d $count).png
    case $2 in
        *--frames*)
            build/render $2 --size "$size" --out "$work/frame-%04d.png" >/dev/null
            mv "$(ls "$work"/frame-* | tail -n 1)" "$panel" && rm -f "$work"/frame-* ;;
        *) build/render $2 --size "$size" --out "$panel" >/dev/null ;;
    esac
    convert "$panel" -crop "$crop" +repage -scale "$scale" -set label "$1" "$panel"
}

finish() {
    montage "$work/$name"-*.png -font DejaVu-Sans -pointsize 15 -background white \
        -tile "${row:-$count}x" -geometry +3+3 -depth 8 "examples/docs/pictures/$name.png"
    echo "examples/docs/pictures/$name.png"
}

while IFS='|' read -r first second third fourth fifth; do
    case $third:$first in
        ?*:*) name=$first crop=$second scale=$third row=$fourth size=${fifth:-1280x720} count=0 ;;
        :) case $name in *"$ONLY"*) finish ;; esac ;;
        *) case $name in *"$ONLY"*) draw "$first" "$second" ;; esac ;;
    esac
done <<'ROWS'
lit|1280x720+0+0|33%
light without occlusion|room --method ssdo --env sky --radius 0.001
ssdo, one bounce|room --method ssdo --env sky
ray tracing, one bounce|room --method ssdo --env sky --truth 32

radius|420x280+560+250|100%
0.125|room --radius 0.125
0.5, the default of this scene|room
2|room --radius 2

half|210x140+560+420|200%
FULL, hsao-best|grass --method hsao-best
HALF, the default|grass
QUARTER|grass --method hsao-quarter

counts|210x140+620+330|200%
1 slice of 4 samples|room --set slices=1,samples=4
2 slices of 8, the default|room
4 slices of 24|room --set slices=4,samples=24

filter|210x140+620+330|200%
radius 0, at full resolution|room --set resolution=full,blur=0
radius 1|room --set blur=1
radius 2, the default|room

history|210x140+620+330|200%
one frame of hsao-history|room --method hsao-history
its 16th frame|room --method hsao-history --still 16
ray tracing|room --truth 256

moving|170x112+405+198|200%|4
hsao-history, frame 17|casters --method hsao-history --slide 0.03,0,0 --frames 17
hsao-history, frame 21|casters --method hsao-history --slide 0.03,0,0 --frames 21
hsao-history, frame 25|casters --method hsao-history --slide 0.03,0,0 --frames 25
hsao-history, frame 29|casters --method hsao-history --slide 0.03,0,0 --frames 29
the same without history|casters --method hsao-history --set history=0 --slide 0.03,0,0 --frames 17
the same without history|casters --method hsao-history --set history=0 --slide 0.03,0,0 --frames 21
the same without history|casters --method hsao-history --set history=0 --slide 0.03,0,0 --frames 25
the same without history|casters --method hsao-history --set history=0 --slide 0.03,0,0 --frames 29
ray tracing|casters --truth 256 --slide 0.48,0,0
ray tracing|casters --truth 256 --slide 0.60,0,0
ray tracing|casters --truth 256 --slide 0.72,0,0
ray tracing|casters --truth 256 --slide 0.84,0,0

thickness|420x280+640+400|100%
DEFAULT|plates
BACK|plates --set thickness=back
ray tracing|plates --truth 256

bleeding|230x220+180+120|100%||640x360
ssdo without a bounce|cornell --method ssdo --light sun:0.9,0.35,0.8,4,4,4 --env white --env-strength 0.15 --radius 3 --set bounce=none
ssdo|cornell --method ssdo --light sun:0.9,0.35,0.8,4,4,4 --env white --env-strength 0.15 --radius 3
ray tracing|cornell --method ssdo --light sun:0.9,0.35,0.8,4,4,4 --env white --env-strength 0.15 --radius 3 --truth 64

normal-rays|120x90+340+240|200%||640x360
the horizon alone|pebbles --method hsao-march --set directions=8,samples=18,normal_rays=0
with a normal ray for each direction|pebbles --method hsao-march --set directions=8,samples=18,normal_rays=1
ray tracing|pebbles --truth 64

hidden|240x170+80+60|100%||640x360
hsao-best|columns --method hsao-best
dss-best|columns --method dss-best
ray tracing|columns --truth 64

decay|240x140+200+220|100%|2|640x360
aof, 0.2 above the ground|sphere --method aof --slide 0,0.2,0
ray tracing|sphere --method aof --slide 0,0.2,0 --truth 64
aof, 0.8 above the ground|sphere --method aof --slide 0,0.8,0
ray tracing|sphere --method aof --slide 0,0.8,0 --truth 64

ROWS
