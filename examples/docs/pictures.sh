#!/bin/sh
# pictures.sh - pictures of README, METHODS.md and TUNING.md: make pictures [ONLY=radius]. A picture is its name, a crop
# of 1280x720, by how much that is enlarged (without a filter) and, if it has several rows, how many panels a row has;
# then its panels, each a label and what build/render is given. Of --frames a panel is the last frame.
set -e
cd "$(dirname "$0")/../.."
command -v montage >/dev/null || sh examples/kit/install.sh imagemagick fonts-dejavu-core
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT

draw() {    # label, flags
    count=$((count + 1))
    panel=$work/$name-$(printf %02d $count).png
    case $2 in
        *--frames*)
            build/render $2 --size 1280x720 --out "$work/frame-%04d.png" >/dev/null
            mv "$(ls "$work"/frame-* | tail -n 1)" "$panel" && rm -f "$work"/frame-* ;;
        *) build/render $2 --size 1280x720 --out "$panel" >/dev/null ;;
    esac
    convert "$panel" -crop "$crop" +repage -scale "$scale" -set label "$1" "$panel"
}

finish() {
    montage "$work/$name"-*.png -font DejaVu-Sans -pointsize 15 -background white -tile "${row:-$count}x" -geometry +3+3 \
        -depth 8 "examples/docs/pictures/$name.png"
    echo "examples/docs/pictures/$name.png"
}

while IFS='|' read -r first second third fourth; do
    case $third:$first in
        ?*:*) name=$first crop=$second scale=$third row=$fourth count=0 ;;
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

ROWS
