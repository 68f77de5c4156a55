/* terrain.c - a table of rows: rocky land and things on it. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* kind: hills, a shore of boulders, crags, a ruin, dunes */
const kit_row kit_rows_terrain[] = {
{ "terrain", THING, "", "kind=0|1|2|2|3|4 high=.5~2.5 wide=5~12 dense=.4~1", "", "" },
{ "stand", STAND, "", "-12 -12 12 12", "", "" },
{ "ground", GROUND, "", "-60 -60 60 60 260 high wide 5", "soil", "" },
{ "near", SIGHT, "4: -6~6 g+.3 -6~6", "0 0 0 1~2.5", "", "" },
{ "boulders", PUT, "dense*16: -12~12 g -12~12 0~360 0 1 clear 1", "boulder", "", "1-(kind=4)*.6" },
{ "crags", PUT, "2~7: -16~16 g -16~16 0~360 0 1 clear 2", "crag", "", "(kind=2)+.15" },
{ "stones", PUT, "dense*46: -9~9 g -9~9 0~360 0 .4~1.6 clear .3", "stone", "", "" },
{ "shingle", ROCK, "dense*260: -6~6 g+.02 -6~6 0~360", ".03~.14 .02~.08 .03~.12 .4 5 0|1", "stone", ".7" },
{ "scree", PUT, "0~8: -9~9 g -9~9 0~360 0 1 clear .6", "pile s=.15~.5", "", "" },
{ "tufts", PUT, "dense*40: -8~8 g -8~8", "tuft", "", ".8" },
{ "bushes", PUT, "0~6: -9~9 g -9~9 0~360 0 1 clear .7", "bush n=100~220 s=.06~.1", "", ".5" },
{ "firs", PUT, "0~9: -16~16 g -16~16 0~360 0 1 clear .8", "fir", "", "(kind<3)*.5" },
{ "bare_trees", PUT, "0~4: -9~9 g -9~9 0~360 0 1 clear .8", "tree full=0 h=2~4", "", ".5" },
{ "columns", PUT, "2~7: -6~6 g -6~6 0~360 0 1 clear .7", "broken_column", "", "(kind=3)+.1" },
{ "walls", PUT, "2~6: -7~7 g -7~7 0~180 0 1 clear 1", "dry_wall", "", "(kind=3)+.25" },
{ "fence", PUT, "4: -5+2.4*i g 3~5 -5~5", "fence l=2.4 kind=1", "", "(kind=0)*.5" },
{ "menhirs", PUT, "0~6: -8~8 g -8~8 0~360 -8~8 1 clear .8", "menhir", "", ".35" },
{ "hut", MODEL, "-6~6 g -6~6 0~360 0 1 clear 2.5", "childHut|garden-hut|campingTent|barnum|dog-house", "", ".35" },
{ "logs", ROD, "0~5: -8~8 g+.15 -8~8 0~360 -8~8", "-1.2 0 0 1.2 .1 0 .1~.2 9", "bark", ".6" },
{ "models", MODEL, "0~3: -6~6 g -6~6 0~360 0 1 clear .8",
  "rowboat|wood_logs|deer|horse|male02|female03|bicycle|barrel|rock1|rock2|rock3|sleepingBag", "", "" },
{ "slabs", BOX, "dense*14: -9~9 g-.1 -9~9 0~360 -14~14", "-.8~-.3 0 -.7~-.3 .3~.8 .15~.4 .3~.7 .03", "stone",
  "(kind=2)*.6+(kind=1)*.4" },

{ "boulder", THING, "", "s=.4~1.6 edges=0|0|1", "", "" },
{ "body", ROCK, "0 s*.3 0 0~360 -20~20", "s*.8~s*1.3 s*.6~s s*.8~s*1.1 .3~.8 20-12*edges edges", "stone", "" },
{ "chips", ROCK, "2~9: s*1.3*sin(360*t) s*.04 s*1.2*cos(360*t) 0~360", "s*.08~s*.25 s*.1 s*.08~s*.2 .5 6 1", "stone",
  "" },

{ "crag", THING, "", "s=1.6~4", "", "" },
{ "parts", ROCK, "3~6: -s*.5~s*.5 s*.1~s*.6 -s*.5~s*.5 0~360 -30~30", "s*.4~s*.8 s*.5~s s*.4~s*.7 .5~1 26", "stone", ""
  },
{ "edges", ROCK, "2~6: -s*.8~s*.8 0 -s*.8~s*.8 0~360 -30~30", "s*.2~s*.5 s*.2~s*.4 s*.2~s*.4 .5 8 1", "stone", "" },

{ "menhir", THING, "", "h=1~2.6", "", "" },
{ "body", ROCK, "0 h*.4 0 0~360", "h*.2~h*.3 h*.6 h*.12~h*.2 .3~.6 14 0|1", "stone", "" },

{ "dry_wall", THING, "", "l=1~2 rows=3~7 s=.14~.2", "", "" },
{ "stones", BOX,
  "rows*int(l*5): -l+2*l*((i-int(l*5)*int(i/int(l*5)))+.3~.7)/int(l*5) s*int(i/int(l*5))-.05 -.03~.03 -7~7",
  "-.2~-.14 0 -.2~-.15 .14~.2 s*.9 .15~.2 .02", "stone", ".97" },
{ "fallen", ROCK, "2~9: -l*1.2~l*1.2 .05 .3~.7 0~360", ".12 .09 .12 .4 6 1", "stone", "" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
