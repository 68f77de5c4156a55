/* halls.c - a table of rows: halls of columns, arches, galleries, beams. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* W: half of the nave's width; A: a side aisle's width; H: height; L: half of the length; bay: between columns */
const kit_row kit_rows_halls[] = {
{ "halls", THING, "",
  "W=2.2~4.5 A=1.6~3 H=4.5~9 L=7~14 bay=2~3.6 kind=0|0|1|1|2|3 r=.2~.42 cap=H*.5~H*.66 style=0|1|2", "", "" },
{ "stand", STAND, "", "-W-A*.7 -L+.8 W+A*.7 L-.8", "", "" },
{ "ceiling_height", CEILING, "", "H", "", "" },
{ "floor", BOX, "", "-W-A-.3 -.3 -L-.3 W+A+.3 0 L+.3 0", "floor", "" },
{ "tiles", BOX, "180: -W+2*W*(i-9*int(i/9)+.5)/9 0 -8+.8*int(i/9)", "-W/9.3 0 -.38 W/9.3 .004~.012 .38 .003", "stone",
  ".7" },
{ "walls", PART, "2: 0 0 0 90+180*i", "hall_wall e=W+A", "", "" },
{ "ends", PART, "2: 0 0 0 180*i", "hall_end", "", "" },
{ "ceiling", BOX, "0 H 0", "-W-A-.3 0 -L W+A+.3 .3 L 0", "wall", "" },
{ "beams", BOX, "L*2/bay: 0 H -L+2*L*t", "-W-A -.4~-.3 -.14 W+A 0 .14 .01", "wood", "kind>0" },
{ "rafters", BOX, "(W+A)*2/.6: -W-A+2*(W+A)*t H-.02 0", "-.05 -.16 -L .05 0 L 0", "wood", "(kind=1)*.6" },
{ "coffers", BOX, "(W+A)*2/1.1: -W-A+2*(W+A)*t H-.02 0", "-.12 -.3 -L .12 0 L .01", "stone", "(kind=3)*.8" },
{ "trusses", PUT, "L*2/bay: 0 H-.35 -L+2*L*t", "truss", "", "kind=2" },
{ "columns", PUT, "2*int(L*2/bay): W*(2*(i-2*int(i/2))-1) 0 -L+bay*(int(i/2)+.5) 0", "column h=cap", "", "" },
{ "arcades", PART, "2: 0 cap 0 90+180*i", "arcade", "", "1-(kind=2)" },
{ "gallery", PUT, "2: 0 cap+.9 0 90+180*i", "gallery", "", "(H-cap>2.2)*.4" },
{ "benches", PUT, "0~14: (W*.5)*(-1|1) 0 -L*.8+L*1.6*t -90|90|0|180 0 1 clear .9", "bench", "", ".6" },
{ "rows", PUT, "12: W*.5*(2*(i-2*int(i/2))-1) 0 -L*.6+1.1*int(i/2) 0 0 1 clear .5", "bench w=W*.35", "", ".4" },
{ "things", PUT, "3~16: -W-A*.6~W+A*.6 0 -L*.85~L*.85 0~360 0 1 clear .6", "hall_thing", "", "" },
{ "chandeliers", PUT, "1~4: 0 H -L+2*L*t", "chandelier", "", ".7" },
{ "stairs", PUT, "(W+A*.4)*(-1|1) 0 -L+1.6 0|180 0 1 clear 1", "steps n=6~12", "", ".4" },
{ "spiral", MODEL, "(W+A*.5)*(-1|1) 0 L*.5~L*.7 0~360 0 1 clear 1", "spiralStaircase", "", ".25" },
{ "banners", PART, "0~8: W*(2*(i-2*int(i/2))-1)*.93 cap+.8 -L*.7+L*1.4*t 90", "cloth_hung w=.5~.9 h=1~2", "", ".4" },
{ "cars", PUT, "0~8: -W*.9~W*.9 0 -L*.8~L*.8 0|90|180 0 1 clear 2", "car", "", "(kind=2)*.4" },
{ "dais", BOX, "3: 0 .16*i -L+1.2", "-W*.9+.25*i 0 -1 W*.9-.25*i .16 1.6-.3*i .01", "stone", ".5" },

{ "hall_wall", THING, "", "e=5 w=.5~.9 low=1~2.2 high=H*.5~H*.75", "", "" },
{ "wall", BOX, "0 0 -e", "-L 0 -.3 L H 0 0", "wall", "" },
{ "panels", BOX, "int(L*2/bay)+1: -L+bay*i 0 -e", "-r*.9 0 0 r*.9 H-.1 .18 .02", "stone", "" },
{ "dado", BOX, "0 0 -e", "-L 0 0 L .9 .06 .01", "wood", ".5" },
{ "cornice", BOX, "2: 0 cap+.1+.14*i -e", "-L 0 0 L .12 .12+.1*i .02", "stone", "" },
{ "windows", PART, "int(L*2/bay): -L+bay*(i+.5) low -e+.01", "hall_window h=high-low", "", "" },
{ "niches", PUT, "0~4: -L*.8~L*.8 0 -e+.5 0 0 1 clear .7", "statue", "", ".5" },

{ "hall_window", THING, "", "w=.7 h=2 of=0|1", "", "" },
{ "glass", PANE, "", "-w 0 0 w h 0", "glass", "" },
{ "jambs", BOX, "2: w*(2*i-1) 0 0", "-.12 -.1 0 .12 h .14 .02", "stone", "" },
{ "sill", BOX, "", "-w-.2 -.14 0 w+.2 0 .22 .02", "stone", "" },
{ "bars", BOX, "3: -w+2*w*(i+1)/4 0 0", "-.025 0 0 .025 h .05 0", "metal", "" },
{ "cross", BOX, "4: 0 h*(i+.5)/4 0", "-w -.02 0 w .02 .05 0", "metal", "" },
{ "arch", PART, "0 h 0", "arch R=w d=.16", "", "" },

/* An arch: a ring of stones over an opening, from one side to the other. */
{ "arch", THING, "", "R=1 d=.4 n=13 deep=.22", "", "" },
{ "stone", BOX, "n: R*cos(180*t) R*sin(180*t) 0 0 0", "-.02 -.02 0 .02 .02 .01 0", "stone", "0" },
{ "wedge", PART, "n: 0 0 0", "wedge a=180*(i+.5)/n", "", "" },
{ "wedge", THING, "", "a=90", "", "" },
{ "body", PRISM, "0 0 -d/2+d 0 -90",
  "d -(R+deep)*cos(a-90/n) (R+deep)*sin(a-90/n) -(R+deep)*cos(a+90/n) (R+deep)*sin(a+90/n) -R*cos(a+90/n) "
  "R*sin(a+90/n) -R*cos(a-90/n) R*sin(a-90/n)", "stone", "" },

{ "hall_end", THING, "", "w=.8 h=2.4", "", "" },
{ "wall", BOX, "0 0 -L", "-W-A-.3 0 -.3 W+A+.3 H 0 0", "wall", "" },
{ "door", MODEL, "0 .3 -L+.1", "double_door|double_door_2|door", "", "" },
{ "window", PART, "2: W*.6*(2*i-1) 1.6~2.4 -L+.01", "hall_window h=H*.4", "", "" },

{ "column", THING, "", "h=4 of=style flutes=0|12|16", "", "" },
{ "base", BOX, "", "-r*1.5 0 -r*1.5 r*1.5 .18 r*1.5 .02", "stone", "" },
{ "foot", TURNED, "0 .18 0", "r*1.4 0 r*1.4 .06 r*1.15 .1 r*1.25 .16 r .22", "stone", "of<2" },
{ "shaft", TURNED, "0 .38 0", "r 0 r*.98 (h-.9)*.4 r*.84 h-.9", "stone", "of<2" },
{ "flute", ROD, "flutes: r*.93*sin(360*t) .4 r*.93*cos(360*t)",
  "0 0 0 -r*.14*sin(360*t) h-.95 -r*.14*cos(360*t) r*.13 6", "stone", "of=0" },
{ "neck", TURNED, "0 h-.5 0", "r*.84 0 r*.95 .04 r*.86 .1 r*1.3 .32", "stone", "of<2" },
{ "pier", BOX, "0 .18 0", "-r 0 -r r h-.4 r .05", "stone", "of=2" },
{ "capital", BOX, "0 h-.2 0", "-r*1.45 0 -r*1.45 r*1.45 .2 r*1.45 .03", "stone", "" },

/* Arches over one of the two rows of columns, at z = -W. */
{ "arcade", THING, "", "h=(bay-2*r)/2*.9", "", "" },
{ "arches", PART, "int(L*2/bay)-1: -L+bay*(i+1) .1 -W-.2", "arch R=bay/2-r d=.4 deep=.25", "", "1-(kind=1)" },
{ "lintel", BOX, "0 0 -W", "-L 0 -.25 L .5 .25 .02", "stone", "kind=1" },
{ "wall", BOX, "0 bay/2-r+.35 -W", "-L 0 -.2 L H-cap-(bay/2-r)-.35 .2 0", "wall", "(H-cap)>bay" },
{ "string", BOX, "0 bay/2-r+.3 -W+.2", "-L 0 0 L .12 .12 .02", "stone", "" },

{ "gallery", THING, "", "", "", "" },
{ "floor", BOX, "0 0 -W", "-L -.2 -A L 0 .3 0", "wood", "" },
{ "posts", TURNED, "L*2/.35: -L+2*L*t 0 -W+.2", ".05 0 .03 .2 .06 .4 .025 .7 .04 .85", "stone", "" },
{ "rail", BOX, "0 .85 -W+.2", "-L 0 -.07 L .1 .07 .01", "wood", "" },

{ "truss", THING, "", "m=.05~.1", "", "" },
{ "low", BOX, "", "-W-A -m -m W+A m m 0", "metal", "" },
{ "sides", ROD, "2", "(W+A)*(2*i-1) 0 0 0 .3 0 m", "metal", "" },
{ "ties", ROD, "8: -W-A+2*(W+A)*t 0 0", "0 0 0 .3*sx .33 0 m*.6", "metal", "" },

{ "chandelier", THING, "", "r=.4~.9 l=H*.25~H*.45 n=6~12", "", "" },
{ "chain", ROD, "", "0 0 0 0 -l 0 .012 6", "metal", "" },
{ "ring", RING, "0 -l 0", "0 0 0 r .025", "metal", "" },
{ "arms", ROD, "n: 0 -l 0 360*t", "0 .3 0 0 0 r .012 6", "metal", "" },
{ "candles", ROD, "n: r*sin(360*t) -l r*cos(360*t)", "0 0 0 0 .14 0 .018 6", "white", "" },
{ "light", LAMP, "0 -l-.2 0", "0 0 0", "", "" },

{ "statue", THING, "", "h=.6~1.2 s=.25~.4", "", "" },
{ "plinth", BOX, "", "-s 0 -s s h s .03", "stone", "" },
{ "cap", BOX, "0 h 0", "-s-.05 0 -s-.05 s+.05 .07 s+.05 .01", "stone", "" },
{ "figure", MODEL, "0 h+.07 0 -20~20",
  "male01|female01|girlStanding|horse|deer|vase5|male02|mannequinMale|bunny .9~1.7", "", "" },

{ "hall_thing", THING, "", "of=0|0|1|1|2|3|4|5|6", "", "" },
{ "statue", PART, "", "statue", "", "of=0" },
{ "person", PART, "", "people", "", "of=1" },
{ "table", PART, "", "dining", "", "of=2" },
{ "plant", PART, "", "plant h=1~1.8 r=.25", "", "of=3" },
{ "piano", MODEL, "", "pianoAQueue|japanese_style_screen|candelabre|fountain|bookcase|box_room|poolTable|table_tennis",
  "", "of=4" },
{ "stuff", PART, "4: -.5~.5 0 -.5~.5 0~360 0 1 clear .25", "crate|barrel|carton|vase|chair", "", "of=5" },
{ "rail", PART, "", "railing", "", "of=6" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
