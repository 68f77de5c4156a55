/* foliage.c - a table of rows: gardens, woods, meadows. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* kind: a garden, a wood, a meadow, beds in rows, a courtyard, dry land */
const kit_row kit_rows_foliage[] = {
{ "foliage", THING, "", "kind=0|0|1|1|2|3|4|5 bumps=0|0|.2|.6 dense=.4~1", "", "" },
{ "stand", STAND, "", "-9 -9 9 9", "", "" },
{ "ground", GROUND, "", "-40 -40 40 40 90 bumps*(1-(kind=4)) 5 3", "soil", "" },
{ "sights", SIGHT, "12: -5~5 g+.3~g+1.6 -5~5", "0 0 0 .8~2.4", "", "" },
{ "trees", PUT, "dense*(4+6*(kind=1)): -8~8 g -8~8 0~360 0 1 clear 1", "tree", "", "1-(kind=5)*.7" },
{ "firs", PUT, "0~5: -12~12 g -12~12 0~360 0 1 clear 1", "fir", "", "(kind=1)*.6+.15" },
{ "far_trees", PUT, "4: 22*sin(360*t) g 22*cos(360*t) 0~360", "tree d=2 full=2 s=.3", "", ".4" },
{ "bushes", PUT, "dense*16: -7~7 g -7~7 0~360 0 1 clear .5", "bush", "", "" },
{ "tufts", PUT, "dense*190: -6~6 g -6~6 0~360 0 1", "tuft", "", "1-(kind=4)*.7" },
{ "lawn", PUT, "0~4: -3~3 g -3~3", "lawn", "", ".5" },
{ "flowers", PUT, "dense*16: -6~6 g -6~6", "flowers", "", ".7" },
{ "stones", PUT, "dense*18: -8~8 g -8~8 0~360 0 1 clear .35", "stone", "", ".8" },
{ "beds", PUT, "6: -4~4 0 -5+2*i", "bed", "", "kind=3" },
{ "hedges", PUT, "2~7: -7~7 g -7~7 0|90 0 1 clear 1", "hedge", "", "((kind=0)+(kind=4))*.7" },
{ "fences", PUT, "6: -6+2.2*i 0 -7~-5 0", "fence l=2.2", "", "(1-(kind=1))*.5" },
{ "side_fence", PUT, "5: 6~7 0 -5+2.2*i 90", "fence l=2.2", "", "(kind=0)*.6" },
{ "wall", BOX, "0 -.2 -9", "-9 0 -.15 9 2~2.8 .15 .02", "brick", "((kind=0)+(kind=4))*.7" },
{ "paving", BOX, "120: -5+.85*(i-12*int(i/12)) 0 -4+.85*int(i/12) -2~2", "-.4 0 -.4 .4 .01~.04 .4 .01", "stone",
  "kind=4" },
{ "pergola", PUT, "-3~3 0 -3~3 0~90 0 1 clear 1.5", "pergola", "", "((kind=0)+(kind=4))*.5" },
{ "cacti", PUT, "3~9: -7~7 g -7~7 0~360 0 1 clear .5", "cactus_tall", "", "kind=5" },
{ "litter", LEAF, "dense*320: -6~6 g+.01 -6~6 0~360 -12~12", ".05 .08 .6 2 1", "leaf", ".5" },
{ "logs", ROD, "0~4: -6~6 g+.12 -6~6 0~360", "-1 0 0 1 .1 0 .09~.18 9", "bark", ".5" },
{ "pots", PUT, "0~8: -5~5 g -5~5 0~360 0 1 clear .4", "plant", "", "((kind=4)+(kind=0))*.8+.1" },
{ "models", PUT, "1~5: -6~6 g -6~6 0~360 0 1 clear .7", "garden_model", "", "" },
{ "benches", PUT, "0~3: -5~5 g -5~5 0~360 0 1 clear 1", "bench", "", "" },

{ "lawn", THING, "", "n=700~1800 l=.05~.14", "", "" },
{ "blade", LEAF, "n: -2~2 g -2~2 0~360 -85~-45", ".008 l .4~1.2 2 1", "leaf", "" },

{ "bed", THING, "", "w=1.6~3 h=.2~.7 of=0|1|2", "", "" },
{ "soil", CUSHION, "", "0 0 0 w .18 .45 .5 10", "soil", "" },
{ "edge", BOX, "2: 0 0 .5*(2*i-1)", "-w 0 -.03 w .2 .03 .01", "wood", ".6" },
{ "plants", PART, "w*7: -w+2*w*t .12 -.25~.25 0~360", "twig l=h*.7~h*1.2", "", "of=0" },
{ "heads", PART, "w*3: -w+2*w*t .15 -.1~.1 0~360", "bush r=.2 n=40~70 s=.12", "", "of=1" },
{ "canes", ROD, "w*5: -w+2*w*t .1 0 0 -6~6", "0 0 0 0 1.6 0 .012 6", "wood", "of=2" },
{ "climbers", LEAF, "w*40: -w~w .2~1.7 -.1~.1 0~360 -60~60", ".1 .12 .8 2 1", "leaf", "of=2" },

{ "hedge", THING, "", "l=1~2 h=.5~1.4 w=.25~.4 s=.06~.1", "", "" },
{ "core", CUSHION, "0 h/2 0", "0 0 0 l*.97 h*.48 w*.9 .2 8", "leaf", "" },
{ "front", LEAF, "l*h*320: -l~l 0~h w*(2*(i-2*int(i/2))-1) 0~360 -80~80", "s*.6 s .8 2 1", "leaf", "" },
{ "top", LEAF, "l*200: -l~l h -w~w 0~360 -70~40", "s*.6 s .8 2 1", "leaf", "" },

{ "pergola", THING, "", "", "", "" },
{ "posts", BOX, "4: 1.3*sx 0 1*sz", "-.06 0 -.06 .06 2.3 .06 .01", "wood", "" },
{ "beams", BOX, "2: 0 2.3 1*(2*i-1)", "-1.7 0 -.04 1.7 .14 .04 0", "wood", "" },
{ "slats", BOX, "9: -1.5+3*u 2.44 0", "-.025 0 -1.3 .025 .1 1.3 0", "wood", "" },
{ "vine", LEAF, "160~500: -1.6~1.6 2.3~2.7 -1.2~1.2 0~360 -80~30", ".1 .13 .8 2 1", "leaf", "" },

{ "cactus_tall", THING, "", "h=.6~2.2 r=.1~.2", "", "" },
{ "trunk", TURNED, "", "r*.8 -.1 r h*.5 r*.95 h*.9 r*.5 h*.98 0 h", "leaf", "" },
{ "arms", ROD, "0~3: 0 h*.4~h*.6 0 0~360", "0 0 0 0 .06 r*2.6 r*.5 9", "leaf", "" },
{ "spikes", LEAF, "90: r*sin(40*i) h*t r*cos(40*i) 40*i", ".006 .06 .05 1 1", "wood", "" },

{ "garden_model", THING, "", "", "", "" },
{ "one", MODEL, "",
  "palm|yuccaPlant|bluePineSnow|sabalPalmeto|christmas_tree|mediumIndoorPlant|decorativePlant|plant|bulldog|"
  "dog-house|wheelbarrow|relaxChair|childSwing|deckChair|stoneLantern|flowerBox|plantie|bamboo|cypress|rabbit|"
  "chicken|garden-hut|ext_table|sandpit|female01|orchids|hedge|spider_plant", "", "" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
