/* scans.c - a table of rows: figures by scanners and sculptors, and their surroundings. The columns are explained in
   kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* kind: a gallery, a garden, a dig, a table top, shelves */
const kit_row kit_rows_scans[] = {
{ "scans", THING, "", "kind=0|0|1|2|3|4 W=2.5~4.5 H=2.8~4 rough=0|0|.1|.25", "", "" },
{ "stand", STAND, "", "-W+.2 -W+.2 W-.2 W-.2", "", "" },
{ "ground", GROUND, "", "-30 -30 30 30 120 rough*(kind=2)+.05*(kind=1) 1.5 4", "soil", "(kind=1)+(kind=2)" },
{ "floor", BOX, "", "-W-4 -.2 -W-4 W+4 0 W+4 0", "floor", "(kind=0)+(kind>2)" },
{ "tiles", BOX, "196: -W+W/7*(i-14*int(i/14)+.5) 0 -W+W/7*(int(i/14)+.5)",
  "-W/14.3 0 -W/14.3 W/14.3 .003~.01 W/14.3 .003", "stone", "(kind=0)*.6" },
{ "back", BOX, "2: 0 0 0 90*i", "-W 0 -W-.2 W H -W 0", "wall", "(kind=0)+(kind>2)" },
{ "coving", BOX, "2: 0 H-.2 0 90*i", "-W 0 -W W .2 -W+.12 .03", "white", "(kind=0)*.6" },
{ "beams", BOX, "0~6: 0 H -W+2*W*t", "-W -.2 -.05 W 0 .05 0", "wood", "(kind=0)*.5" },
{ "pictures", PART, "1~4: -W*.8~W*.8 1.2~1.7 -W 0 0 1 clear .6", "picture w=.3~.8 h=.3~.6", "", "kind=0" },
{ "figures", PUT, "2~6: -W*.75~W*.75 g -W*.75~W*.75 0~360 0 1 clear .6", "exhibit", "", "kind<3" },
{ "main", PUT, "", "exhibit", "", "kind<3" },
{ "table", PUT, "", "table w=.9~1.2 d=.5~.7 h=.75 full=0 kind=0", "", "kind=3" },
{ "on_table", PUT, "5~14: -.9~.9 .751 -.5~.5 0~360 0 1 clear .14", "relic", "", "kind=3" },
{ "shelves", PUT, "2~3: -W*.7+1.5*i 0 -W+.25", "niche_shelf", "", "kind=4" },
{ "before", PUT, "1~3: -W*.5~W*.5 0 -W*.2~W*.5 0~360 0 1 clear .6", "exhibit", "", "kind=4" },
{ "rubble", PUT, "10~45: -W~W g -W~W 0~360 0 .3~1 clear .12", "stone", "", "kind=2" },
{ "piles", PUT, "0~5: -W~W g -W~W 0~360 0 1 clear .7", "pile", "", "(kind=2)*.9" },
{ "drums", PUT, "0~5: -W~W g -W~W 0~360 0 1 clear .6", "broken_column", "", "(kind=2)+(kind=1)*.4" },
{ "hedges", PUT, "2~6: -W~W 0 -W-1~-W*.7 0|90 0 1 clear .8", "hedge", "", "kind=1" },
{ "trees", PUT, "0~3: -W-2~W+2 0 -W-3~-W 0~360 0 1 clear 1", "tree", "", "kind=1" },
{ "path", BOX, "60: -1.2+.6*(i-5*int(i/5)) g -W+.62*int(i/5) -4~4", "-.28 -.1 -.28 .28 .02~.06 .28 .01", "stone",
  "kind=1" },
{ "tufts", PUT, "0~20: -W~W g -W~W", "tuft", "", "(kind=1)+(kind=2)*.5" },
{ "seats", PUT, "0~2: -W*.8~W*.8 0 -W*.5~W*.8 0~360 0 1 clear .8", "bench", "", "kind<2" },
{ "ropes", PUT, "0~3: -W*.5~W*.5 0 -W*.3~W*.5 0~360 0 1 clear .9", "rope", "", "(kind=0)*.7" },
{ "boxes", PUT, "0~6: -W*.9~W*.9 0 -W*.9~W*.9 0~360 0 1 clear .35", "crate|carton", "", "(kind=0)+(kind=4)" },
{ "cloths", PART, "0~2: -W*.8~W*.8 H-.4 -W+.15", "cloth_hung w=1~1.8 h=1.6~2.2", "", "(kind=0)*.4" },
{ "lamp", LAMP, "0~4: -W*.6~W*.6 H-.4 -W*.3~W*.8", "0 0 0", "", "" },

{ "exhibit", THING, "", "h=0|.15|.5|.9|1.1 s=.25~.45 round=0|0|1", "", "" },
{ "plinth", BOX, "", "-s 0 -s s h s .02", "stone", "(h>0)*(round=0)" },
{ "cap", BOX, "0 h 0", "-s-.04 -.06 -s-.04 s+.04 0 s+.04 .01", "stone", "(h>.2)*(round=0)*.6" },
{ "drum", TURNED, "", "0 0 s*1.1 0 s*1.1 .08 s .12 s h-.06 s*1.1 h 0 h", "stone", "(h>0)*round" },
{ "figure", PART, "0 h 0 -60~60", "figure", "", "" },

{ "figure", THING, "", "of=0|0|0|1|1|2|3|4|5", "", "" },
{ "person", MODEL, "",
  "male01|male02|male03|female01|female02|female03|sitMale03|sitFemale01|lyingDownMale02|girlSittingGround|"
  "mannequinBrunette|boySitting|holdingFemale03|male-01-suit", "", "of=0" },
{ "beast", MODEL, "", "horse|bulldog|siameseCat|deer|rabbit|dog|chicken|teddyBear|horse2 .5~1.3", "", "of=1" },
{ "bunny", MODEL, "", "bunny|bunny|spider|wuson .4~1.1", "", "of=2" },
{ "stone", ROCK, "0 .35 0 0~360", ".2~.4 .35~.7 .2~.4 .5~1.1 26", "stone", "of=3" },
{ "vase", PART, "0 0 0 0 0 1.5~2.4", "vase stems=0", "", "of=4" },
{ "knot", PART, "", "totem", "", "of=5" },

/* a totem: balls, rings and eggs that intersect */
{ "totem", THING, "", "n=3~7 r=.14~.25", "", "" },
{ "blobs", ROCK, "n: -.06~.06 r+r*1.5*i*.7 -.06~.06 0~360 -30~30", "r*.8~r*1.3 r*.9 r*.8~r*1.3 .3~.7 18", "stone", "" },
{ "rings", RING, "0~3: 0 r+r*i 0 0~360 0~90", "0 0 0 r*1.2 r*.2", "stone", "" },
{ "arms", ROD, "0~4: 0 r*1.5+r*i 0 0~360 30~120", "0 0 0 0 r*2.4 0 r*.35 12", "stone", "" },

{ "relic", THING, "", "of=0|0|1|2|3|4|5", "", "" },
{ "beast", MODEL, "", "bunny|deer|rabbit|teddyBear|siameseCat|horse|vase2|vase3|old_jar|jar|teapot|caballito .12~.4",
  "", "of=0" },
{ "stone", ROCK, "0 .06 0 0~360", ".05~.1 .05~.09 .05~.1 .4~1 16", "stone", "of=1" },
{ "vase", PART, "", "vase h=.15~.35 r=.05~.1", "", "of=2" },
{ "bowl", PART, "", "bowl", "", "of=3" },
{ "totem", PART, "0 0 0 0 0 .25", "totem", "", "of=4" },
{ "books", PART, "", "books_flat", "", "of=5" },

{ "niche_shelf", THING, "", "w=.5~.7 n=3~4 h=.5", "", "" },
{ "boards", BOX, "n+1: 0 h*i 0", "-w 0 -.2 w .04 .2 0", "wood", "" },
{ "sides", BOX, "3: w*(i-1) 0 0", "-.03 0 -.2 .03 h*n .2 0", "wood", "" },
{ "back", PANE, "0 0 -.19", "-w 0 0 w h*n 0", "wood", "" },
{ "things", PART, "n*2: -w*.5+w*(i-2*int(i/2)) .041+h*int(i/2) 0 -60~60", "relic", "", "" },

{ "rope", THING, "", "", "", "" },
{ "posts", TURNED, "3: -.9+.9*i 0 0", ".14 0 .14 .03 .025 .05 .025 .9 .05 .93 0 .97", "metal", "" },
{ "ropes", WIRE, "2", "-.9+.9*i .85 0 .9*i .85 0 .2 .02", "cloth", "" },

{ "broken_column", THING, "", "r=.25~.4 h=.4~2.4 lying=0|0|90", "", "" },
{ "drum", TURNED, "0 r*(lying>0) 0 0~360 lying", "0 0 r 0 r*.95 h 0 h+.08", "stone", "" },
{ "flutes", ROD, "14: r*.93*sin(360*t) r*(lying>0) r*.93*cos(360*t)", "0 0 0 0 h 0 r*.12 6", "stone", "(lying=0)*.7" },
{ "base", BOX, "", "-r*1.3 -.05 -r*1.3 r*1.3 .15 r*1.3 .02", "stone", "lying=0" },
{ "capital", BOX, "0 h 0 0~30 0~12", "-r*1.3 0 -r*1.3 r*1.3 .25 r*1.3 .04", "stone", "(lying=0)*.5" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
