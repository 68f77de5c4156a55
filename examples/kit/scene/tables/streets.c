/* streets.c - a table of rows: streets, squares, alleys, yards. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* road: half of the road's width; half: from its middle to the houses; R: half of its length; kind: a street, an alley,
   a square */
const kit_row kit_rows_streets[] = {
{ "streets", THING, "",
  "kind=0|0|0|1|2 road=(kind=0)*(2.8~5) half=(kind=0)*(road+1.8~road+3.5)+(kind=1)*(1.3~2.6)+(kind=2)*(9~15) "
  "R=16~28 pave=.12~.17 style=0|1|2|3 dense=.3~1", "", "" },
{ "stand", STAND, "", "-half+.6 -R*.9 half-.6 R*.9", "", "" },
{ "ground", PANE, "", "-90 0 -90 90 0 90", "road", "" },
{ "pavements", BOX, "2: (half+road)/2*(2*i-1) 0 0", "-(half-road)/2 0 -R-9 (half-road)/2 pave R+9 .02", "stone",
  "kind=0" },
{ "slabs", PART, "2: 0 0 0 180*i", "slabs", "", "(kind=0)*.7" },
{ "setts", BOX, "260: -half*.9+2*half*.9*(i-20*int(i/20))/19 0 -8+1.2*int(i/20) -3~3",
  "-.19 0 -.5 .19 .012~.03 .5 .008", "stone", "(kind>0)*.8" },
{ "marks", BOX, "R/3: 0 0 -R+2*R*t", "-.07 0 -1.2 .07 .006 1.2 0", "white", "kind=0" },
{ "crossing", BOX, "7: -road+2*road*t 0 4", "-.25 0 -1.4 .25 .007 1.4 0", "white", "(kind=0)*.5" },
{ "covers", TURNED, "3: -road*.7~road*.7 0 -R*.6~R*.6", "0 0 .33 0 .33 .012 .28 .014 0 .012", "metal", "kind<2" },
{ "houses", PART, "2: 0 0 0 90+180*i", "row", "", "" },
{ "ends", PART, "2: 0 0 0 180*i", "row half=R+2 R=half", "", "" },
{ "cars", PUT, "dense*9: (road-1)*(-1|1) 0 -R*.8+R*1.6*t (0|180)+-3~3 0 1 clear 2.2", "car", "", "kind=0" },
{ "driving", PUT, "0~3: 1.4*(-1|1) 0 -R*.7~R*.7 0|180 0 1 clear 2.2", "car", "", "kind=0" },
{ "parked", PUT, "0~5: -half*.7~half*.7 0 -half*.7~half*.7 0~360 0 1 clear 2.4", "car", "", "kind=2" },
{ "kerb", PUT, "dense*26: (road+.4~half-.5)*(-1|1) pave+.005 -R*.8~R*.8 90*(-1|1)+-9~9 0 1 clear .5", "street_thing",
  "", "kind=0" },
{ "standing", PUT, "dense*22: -half*.85~half*.85 .005 -R*.7~R*.7 0~360 0 1 clear .5", "street_thing", "", "kind>0" },
{ "lamps", PUT, "4: (road+.35)*(2*(i-2*int(i/2))-1) pave -R*.6+R*.6*int(i/2) -90*(2*(i-2*int(i/2))-1)", "post_lamp",
  "", "(kind=0)*.9" },
{ "trees", PUT, "dense*7: (road+.9)*(-1|1) pave -R*.7~R*.7 0~360 0 1 clear 1.2", "tree h=3~6 full=2~4 s=.14~.22", "",
  "(1-(kind=1))*.5" },
{ "square_trees", PUT, "0~5: -half*.7~half*.7 0 -half*.7~half*.7 0~360 0 1 clear 1.5", "tree h=3~6 full=2~4 s=.14~.22",
  "", "kind=2" },
{ "fountain", MODEL, "-2~2 0 -2~2 0 0 1.5 clear 2.5", "fountain|stoneLantern|childHut", "", "(kind=2)*.6" },
{ "cables", PUT, "0~6: 0 0 -R*.6~R*.6", "overhead", "", "(kind<2)*.7" },

{ "slabs", THING, "", "s=.45~.8", "", "" },
{ "slab", BOX, "90: road+.2+(half-road-.2)*(i-3*int(i/3)+.5)/3 pave -10+.68*int(i/3)",
  "-(half-road)/6.4 0 -.33 (half-road)/6.4 .004~.02 .33 .006", "stone", "" },

{ "overhead", THING, "", "y=4.5~7 of=0|0|1|2", "", "" },
{ "cable", WIRE, "", "-half y -1~1 half y -1~1 .1~.6 .012", "metal", "" },
{ "flags", PANE, "half*3: -half+2*half*t y-.25 0", "-.12 -.3 0 .12 0 0", "bloom", "of=1" },
{ "washing", CLOTH, "half*1.5: -half*.8+1.6*half*t y-.3 0", ".4~.8 .5~1 1 .03", "cloth", "of=2" },
{ "lamp", BALL, "0 y-.5 0", "0 0 0 .15 .12 .15 10", "metal", "of=0" },

/* A row of houses along x, at z = -half, facing +z. */
{ "row", THING, "", "w=3~5", "", "" },
{ "house", PUT, "(R+8)/w: -R-6+(2*R+12)*t 0 -half", "house w=(R+6)/n", "", "" },

{ "house", THING, "",
  "w=4 floors=2~6 fh=2.6~3.3 bays=int(w*.55~w*.9) kind_h=0|1|2|3 deep=6~9 shop=0|0|1 h=fh*int(floors)+.4 "
  "sillw=w/bays*.3~w/bays*.36 balcony=0~1.2 inset=.08~.3", "", "" },
{ "core", BOX, "", "-w 0 -deep w h -inset 0", "wall", "" },
{ "plinth", BOX, "", "-w .005 -inset w .5 .05 .01", "stone", "" },
{ "piers", BOX, "bays+1: -w+2*w*u 0 -inset", "-w/bays*.3 0 0 w/bays*.3 h inset .0", "wall", "" },
{ "bands", BOX, "floors: 0 fh*(i+1)-.35 -inset", "-w 0 0 w .75 inset .0", "wall", "" },
{ "storeys", PART, "floors: 0 fh*i+.4 -inset", "storey ground=(i=0)*shop", "", "" },
{ "cornice", BOX, "3: 0 h-.3+.12*i -inset", "-w -.06 0 w .06 inset+.1+.09*i 0", "stone", "" },
{ "roof", PRISM, "0 h -deep/2 0 -90", ".2 -w 0 w 0 w 1.2 0 2.4 -w 1.2", "brick", "kind_h=1" },
{ "gable", PRISM, "-w h 0", "2.2 0 0 2*w 0 2*w -.3 0 -.3", "brick", "kind_h=2" },
{ "chimneys", BOX, "0~3: -w*.8~w*.8 h -deep*.7~-2", "-.35 0 -.3 .35 .8~1.6 .3 0", "brick", "" },
{ "antenna", ROD, "0~2: -w*.8~w*.8 h -deep*.6~-1", "0 0 0 0 1~2.5 0 .02", "metal", "" },
{ "downpipe", ROD, "0~1: (w-.2)*(-1|1) 0 .09", "0 0 0 0 h 0 .05", "metal", "" },
{ "unit", MODEL, "0~3: -w*.8~w*.8 2.5~h*.8 .18", "external-unity-air-conditioning", "", ".4" },
{ "sign", BOX, "-w*.5~w*.5 2.9~3.8 0", "-.03 -.4 .05 .03 .4 1 .01", "paint", "shop*.7" },

{ "storey", THING, "", "ground=0 of=0|1|1|2 wh=fh*.5~fh*.62 low=.75~.95", "", "" },
{ "windows", PART, "bays: -w+2*w*t low .0", "house_window w=w/bays*.66 h=wh", "", "ground=0" },
{ "front", PART, "bays: -w+2*w*t .0 .0", "shop_window w=w/bays*.66", "", "ground=1" },
{ "awning", LEAF, "0~1: 0 fh*.92 inset 0 12~35", "w*1.8 1.1 .2 3 0", "cloth", "ground=1" },

{ "house_window", THING, "", "w=.6 h=1.4 shut=0~1", "", "" },
{ "glass", PANE, "", "-w 0 .012 w h .012", "glass", "" },
{ "frame", BOX, "3: w*(i-1)*.95 0 .01", "-.03 0 0 .03 h .05 0", "white", "" },
{ "cross", BOX, "2: 0 h*(.02+.64*i) .01", "-w -.02 0 w .025 .05 0", "white", "" },
{ "sill", BOX, "0 0 inset", "-w -.08 -.05 w 0 .09 .01", "stone", "" },
{ "shutters", BOX, "2: (w+.26)*(2*i-1) 0 inset", "-.24 0 0 .24 h .04 .005", "paint", "(shut<.4)*.9" },
{ "louvres", BOX, "2*9: (w+.26)*(2*(i-2*int(i/2))-1) h*int(i/2)/9+.06 inset+.03 0 -25", "-.21 0 0 .21 .012 .05 0",
  "paint", "shut<.2" },
{ "lintel", BOX, "0 h inset", "-w-.1 0 -.04 w+.1 .16 .07 .01", "stone", ".5" },
{ "balcony", PART, "0 -.12 inset", "balcony w=w+.2", "", "(balcony>.75)*.7" },
{ "box", BOX, "0 -.02 inset+.02", "-w*.8 0 0 w*.8 .18 .2 .01", "wood", "(balcony<.2)*.6" },
{ "flowers", PART, "4: -w*.7+1.4*w*t .15 inset+.12", "flowers l=.25 r=.1 n=6", "", "(balcony<.2)*.3" },

{ "balcony", THING, "", "w=.9 d=.7~1.1", "", "" },
{ "slab", BOX, "", "-w -.1 0 w .02 d 0", "stone", "" },
{ "bars", ROD, "w*2/.14: -w+2*w*t .02 d-.03", "0 0 0 0 .95 0 .01 6", "metal", "" },
{ "sides", ROD, "10: w*(2*(i-2*int(i/2))-1) .02 d*(int(i/2)+.5)/5", "0 0 0 0 .95 0 .01 6", "metal", "" },
{ "rail", BOX, "0 .95 d-.03", "-w 0 -.03 w .05 .03 0", "metal", "" },
{ "things", PART, "0~3: -w*.7~w*.7 .025 d*.3~d*.7 0~360 0 .8 clear .2", "plant|chair|crate", "", "" },

{ "shop_window", THING, "", "w=1", "", "" },
{ "glass", PANE, "", "-w .5 .02 w fh*.75 .02", "glass", "" },
{ "bars", BOX, "3: w*(i-1)*.96 0 .01", "-.035 0 0 .035 fh*.75 .07 0", "wood", "" },
{ "base", BOX, "", "-w 0 0 w .5 .1 .02", "wood", "" },
{ "board", BOX, "0 fh*.76 0", "-w 0 0 w .4 inset+.05 .01", "paint", "" },

{ "car", THING, "", "", "", "" },
{ "one", MODEL, "",
  "peugeot-308|renault-scenic|suv|chevrolet|van|smart-car|VW-new-beetle|concept-sedan-01v1|suv|van|peugeot-308", "", ""
  },

{ "street_thing", THING, "", "of=0|0|0|1|1|2|3|4|5|6", "", "" },
{ "model", MODEL, "",
  "park-trashcan|fire-hydrant|bench|painted-bench|concrete-bench|classic-lamppost|recycling-bin|bicycle|scooter|"
  "scooter2|farola1|cone|residential-trashcan|letters_box|bike|park-light|motorbike|stroller", "", "of=0" },
{ "person", PART, "", "people", "", "of=1" },
{ "bench", PART, "", "bench", "", "of=2" },
{ "planter", PART, "", "planter", "", "of=3" },
{ "cafe", PART, "", "cafe", "", "of=4" },
{ "goods", PART, "3: -.5~.5 0 -.4~.4 0~360 0 1 clear .3", "crate|carton|barrel", "", "of=5" },
{ "bollards", TURNED, "3: -1+i 0 0", ".07 0 .07 .75 .05 .85 0 .88", "metal", "of=6" },

{ "planter", THING, "", "w=.3~.7", "", "" },
{ "box", BOX, "", "-w 0 -.25 w .45 .25 .02", "stone", "" },
{ "bush", PART, "0 .4 0", "bush r=.3 n=90~160", "", "" },

{ "cafe", THING, "", "", "", "" },
{ "table", PART, "", "table w=.3 d=.3 h=.72 kind=1", "", "" },
{ "chairs", PART, "2~4: .5*sx 0 .3*sz -90*sx+-20~20", "chair", "", "" },
{ "shade", TURNED, "", ".03 0 .03 2.3 1.3 2 0 2.5", "cloth", ".4" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
