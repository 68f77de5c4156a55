/* shared.c - a table of rows: things of several kinds of scenes. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
const kit_row kit_rows_shared[] = {
/* ---- >>seats and tables ----------------------------------------------------------------------------------------- */
{ "chair", THING, "", "w=.19~.24 d=.19~.23 s=.42~.47 top=.78~1.05 r=.014~.022 back=0|1|2", "", "" },
{ "legs", ROD, "4: w*sx*.9 0 d*sz*.9", "sx*.02 0 sz*.02 0 s 0 r", "wood", "" },
{ "rungs", ROD, "2: 0 s*.3+.05*i 0", "-w*.9 0 -d*.9+1.8*d*i w*.9 0 -d*.9+1.8*d*i r*.6", "wood", ".8" },
{ "seat", CUSHION, "", "0 s 0 w .02 d .3 8", "cloth", "" },
{ "posts", ROD, "2: w*sx*.9 s -d*.9", "0 0 0 0 top-s -.05 r", "wood", "" },
{ "slats", BOX, "3~5: 0 s+.1+(top-s-.1)*t -d*.9-.03", "-w*.9 -.02 -.008 w*.9 .025 .008 0", "wood", "back=0" },
{ "spindles", ROD, "5~8: -w*.8+1.6*w*u s -d*.9", "0 0 0 0 top-s -.05 .006", "wood", "back=1" },
{ "rail", BOX, "0 top -d*.9-.05", "-w -.06 -.012 w .01 .012 .005", "wood", "" },
{ "panel", CUSHION, "0 (s+top)/2 -d*.9-.02", "0 0 0 w (top-s)*.4 .025 .3 8", "cloth", "back=2" },

{ "stool", THING, "", "r=.14~.2 h=.42~.75 leg=.012~.02", "", "" },
{ "legs", ROD, "4: r*sx*.8 0 r*sz*.8", "0 0 0 -sx*.05 h -sz*.05 leg", "metal", "" },
{ "ring", RING, "0 h*.35 0", "0 0 0 r*.95 .008", "metal", "" },
{ "seat", TURNED, "0 h 0", "0 0 r 0 r .03 r*.9 .045 0 .045", "wood", "" },

{ "table", THING, "", "w=.5~1 d=.35~.55 h=.7~.78 r=.02~.04 full=.2~1 kind=0|0|1", "", "" },
{ "top", BOX, "0 h 0", "-w -.035 -d w 0 d .006", "wood", "" },
{ "legs", BOX, "4: (w-.06)*sx 0 (d-.06)*sz", "-r 0 -r r h-.035 r .004", "wood", "kind=0" },
{ "apron", BOX, "2: 0 h-.1 (d-.06)*(2*i-1)", "-w+.06 0 -.01 w-.06 .065 .01 0", "wood", "kind=0" },
{ "foot", TURNED, "", ".25 0 .25 .03 .04 .06 .035 h-.06 .15 h-.035", "metal", "kind=1" },
{ "things", PART, "1~10: -w*.85~w*.85 h+.001 -d*.8~d*.8 0~360 0 .8~1.2 clear .07",
  "small|small|small|bottle|books_flat|cup|bowl|vase", "", "full" },

{ "bench", THING, "", "w=.6~1.1 s=.4~.47", "", "" },
{ "feet", BOX, "2: w*.8*(2*i-1) 0 0", "-.03 0 -.2 .03 s .2 0", "metal", "" },
{ "seat", BOX, "4: 0 s -.18+.12*i", "-w 0 -.05 w .03 .05 0", "wood", "" },
{ "back", BOX, "3: 0 s+.12+.11*i -.22-.02*i 0 -10", "-w 0 -.012 w .09 .012 0", "wood", ".7" },
{ "stays", ROD, "2: w*.8*(2*i-1) s -.2", "0 0 0 0 .4 -.07 .018", "metal", ".8" },

/* ---- >>small things ---------------------------------------------------------------------------------------------- */
{ "small", THING, "", "h=.04~.14 r=.02~.06 of=0|1|2|3", "", "" },
{ "box", BOX, "", "-r 0 -r*.7 r h r*.7 .002", "paper", "of=0" },
{ "can", TURNED, "", "0 0 r*.7 0 r*.7 h*1.2 0 h*1.2", "paint", "of=1" },
{ "ball", BALL, "", "0 r 0 r r r 8", "bloom", "of=2" },
{ "block", BOX, "", "-r*1.6 0 -r r*1.6 h*.5 r .004", "metal", "of=3" },

{ "bottle", THING, "", "h=.2~.34 r=.03~.045", "", "" },
{ "glass", TURNED, "", "0 0 r 0 r h*.6 r*.35 h*.75 r*.3 h 0 h", "glass", "" },

{ "cup", THING, "", "r=.03~.045 h=.07~.12", "", "" },
{ "side", TURNED, "", "0 0 r*.7 0 r h r*.92 h r*.62 .008 0 .008", "white", "" },
{ "ear", RING, "0 0 0 0 90", "r+.012 0 -h*.5 .022 .005", "white", ".7" },

{ "bowl", THING, "", "r=.08~.17 h=.06~.1", "", "" },
{ "side", TURNED, "", "0 0 r*.4 0 r*.8 h*.5 r h r*.95 h r*.75 h*.55 r*.35 .01 0 .01", "paint", "" },
{ "fruit", BALL, "0~7: -r*.5~r*.5 h*.7 -r*.5~r*.5 0 0 .8~1.2", "0 0 0 .035 .033 .035 8", "bloom", "" },

{ "vase", THING, "", "r=.05~.12 h=.2~.5 neck=.3~.7 lip=.4~.9 stems=0~9", "", "" },
{ "side", TURNED, "", "0 0 r*.6 0 r h*.35 r*.9 h*.6 r*neck h*.85 r*lip h r*lip*.9 h r*neck*.85 h*.84 r*.8 h*.6",
  "stone", "" },
{ "twig", PART, "stems: 0 h*.9 0 0~360 5~35", "twig l=.2~.5", "", ".5" },

{ "twig", THING, "", "l=.2~.5", "", "" },
{ "stem", ROD, "", "0 0 0 0 l 0 .003 5", "leaf", "" },
{ "leaves", LEAF, "2~7: 0 l*(.3+.7*t) 0 0~360 -40~10", ".04 .08 .9 3 1", "leaf", "" },
{ "flower", BALL, "0 l 0", "0 0 0 .02 .014 .02 6", "bloom", ".5" },

{ "books", THING, "", "l=.3~.9 h=.2~.3 d=.16~.24 n=6~30", "", "" },
{ "book", BOX, "l/.034: -l/2+l*t 0 0 0 0", "-.014~-.009 0 -d*.9~-d*.6 .009~.014 h*.7~h 0 .001", "paper", ".92" },

{ "books_flat", THING, "", "n=1~5", "", "" },
{ "book", BOX, "n: 0 .03*i 0 -20~20", "-.1 0 -.075 .1 .028 .075 .002", "paper", "" },

{ "plant", THING, "", "r=.1~.2 h=.5~1.5 n=6~18 wide=.05~.14", "", "" },
{ "pot", TURNED, "", "0 0 r*.7 0 r r*1.6 r*.9 r*1.6 r*.85 r*1.45 0 r*1.45", "stone", "" },
{ "stem", ROD, "1~4: 0 r*1.4 0 0~360 0~14", "0 0 0 0 h*.6 0 .01 6", "bark", "" },
{ "leaf", LEAF, "n*2: 0 r*1.4+(h*.6)*t 0 137.5*i -75~-5", "wide h*.35 .6~1.5 5 1", "leaf", "" },

{ "crate", THING, "", "w=.2~.45 h=.25~.5 d=.18~.35", "", "" },
{ "slats", BOX, "6: 0 h*(t-.08) d*(2*(i-2*int(i/2))-1)", "-w 0 -.009 w h*.22 .009 0", "wood", "" },
{ "ends", BOX, "2: w*(2*i-1) 0 0", "-.009 0 -d .009 h d 0", "wood", "" },
{ "floor", BOX, "", "-w 0 -d w .015 d 0", "wood", "" },
{ "posts", BOX, "4: (w-.02)*sx 0 (d-.02)*sz", "-.02 0 -.02 .02 h .02 0", "wood", "" },
{ "load", BALL, "0~14: -w*.7~w*.7 h*.35~h*.7 -d*.7~d*.7", "0 0 0 .06 .055 .06 8", "bloom", "" },

{ "carton", THING, "", "w=.15~.35 h=.15~.45 d=.12~.3 open=0|0|1", "", "" },
{ "body", BOX, "", "-w 0 -d w h d 0", "wood", "open=0" },
{ "sides", PANE, "2: 0 0 0 180*i", "-w 0 d w h d", "wood", "open=1" },
{ "ends", PANE, "2: 0 0 0 90+180*i", "-d 0 w d h w", "wood", "open=1" },
{ "flaps", LEAF, "2: 0 h d*(2*i-1) 180-180*i -40~30", "2*w d*.9 .05 1 0", "wood", "open=1" },

{ "barrel", THING, "", "r=.24~.32 h=.7~.95", "", "" },
{ "body", TURNED, "", "0 0 r*.9 0 r h*.3 r h*.7 r*.9 h r*.85 h r*.85 h-.03 0 h-.03", "wood", "" },
{ "hoops", RING, "3: 0 h*(.15+.35*i) 0", "0 0 0 r .012", "metal", "" },

{ "sack", THING, "", "w=.2~.32 h=.12~.2", "", "" },
{ "body", CUSHION, "", "0 h*.5 0 w h*.5 w*.7 .5 10", "cloth", "" },

{ "cloth_hung", THING, "", "w=.3~.9 h=.5~1.5 waves=2~7", "", "" },
{ "rod", ROD, "", "-w/2-.05 0 0 w/2+.05 0 0 .01", "metal", ".6" },
{ "cloth", CLOTH, "", "w h waves .03~.07", "cloth", "" },

{ "ladder", THING, "", "h=1.6~3.4 w=.18~.25", "", "" },
{ "rails", ROD, "2: w*(2*i-1) 0 0 0 -12", "0 0 0 0 h 0 .018", "metal", "" },
{ "rungs", ROD, "h/.28: 0 .28*i*.978+.2 -.28*i*.208-.04", "-w 0 0 w 0 0 .012", "metal", "" },

{ "railing", THING, "", "l=1~3 h=.85~1.05 gap=.1~.22 r=.008~.014", "", "" },
{ "top", BOX, "", "-l/2 h-.03 -.03 l/2 h .03 .005", "wood", "" },
{ "foot", ROD, "0 .1 0", "-l/2 0 0 l/2 0 0 r*1.3", "metal", "" },
{ "bars", ROD, "l/gap: -l/2+l*t 0 0", "0 .1 0 0 h-.03 0 r 6", "metal", "" },
{ "posts", BOX, "2: l/2*(2*i-1) 0 0", "-.03 0 -.03 .03 h+.06 .03 .006", "wood", "" },

{ "fence", THING, "", "l=1.6~3 h=.7~1.6 kind=0|1|2 gap=.09~.2", "", "" },
{ "posts", BOX, "2: l/2*(2*i-1) -.2 0", "-.045 0 -.045 .045 h+.3 .045 0", "bark", "" },
{ "beams", BOX, "2: 0 h*(.25+.5*i) .04", "-l/2 0 -.02 l/2 .07 .02 0", "bark", "" },
{ "pales", BOX, "l/gap: -l/2+l*t 0 .07", "-.035 .03~.08 -.01 .035 h*.94~h .01 0", "wood", "kind=0" },
{ "rails", ROD, "4: 0 h*(.2+.2*i) .05 0 0", "-l/2 0 0 l/2 -.04~.04 0 .03 7", "bark", "kind=1" },
{ "mesh", ROD, "l/.11: -l/2+l*t 0 .05", "0 0 0 0 h 0 .004 5", "metal", "kind=2" },
{ "weft", ROD, "h/.13: 0 h*t .05", "-l/2 0 0 l/2 0 0 .004 5", "metal", "kind=2" },

{ "steps", THING, "", "n=3~9 w=.8~2 rise=.15~.19 run=.26~.34", "", "" },
{ "step", BOX, "n: 0 0 run*(n-1-i)", "-w 0 -.02 w rise*(i+1) run .006", "stone", "" },

{ "pile", THING, "", "n=4~20 r=.5~1.2 s=.1~.3", "", "" },
{ "stones", ROCK, "n: -r~r s*.2~s*.6 -r~r 0~360 -40~40 .5~1.4", "s s*.6 s*.8 .5 8 0|1", "stone", "" },

{ "people", THING, "", "", "", "" },
{ "one", MODEL, "",
  "male01|male02|male03|female01|female03|male-01-suit|mannequinMale|boyStanding|girlStanding|holdingMale01|"
  "holdingFemale02", "", "" },

/* ---- >>plants of the open ---------------------------------------------------------------------------------------- */
{ "tuft", THING, "", "n=14~50 l=.12~.5 r=.08~.2", "", "" },
{ "blades", LEAF, "n: -r~r 0 -r~r 0~360 -80~-35 .6~1.2", ".012 l .5~1.4 3 1", "leaf", "" },

{ "flowers", THING, "", "n=5~18 l=.2~.6 r=.1~.3", "", "" },
{ "one", PART, "n: -r~r 0 -r~r 0~360 0~16 .7~1.2", "twig l=l*.7~l*1.1", "", "" },

{ "bush", THING, "", "r=.3~.8 n=260~800 s=.07~.16", "", "" },
{ "twigs", ROD, "12: 0 0 0 0~360 10~70", "0 0 0 0 r 0 .008 5", "bark", "" },
{ "leaves", PART, "n: 0 r*.35 0 137.508*i -90~90", "bush_leaf d=r*.6~r l=s*.7~s*1.4", "", "" },

{ "bush_leaf", THING, "", "d=.5 l=.08", "", "" },
{ "leaf", LEAF, "0 0 d 0~360 -70~70", "l*.6 l .7 2 1", "leaf", "" },

{ "tree", THING, "", "h=2.5~7 r=h*.022~h*.04 many=2|3|3 s=.1~.26 full=3~8 spread=25~55", "", "" },
{ "trunk", PART, "", "limb l=h*.38 r=r d=3", "", "" },
{ "roots", ROD, "3~5: 0 0 0 72*i", "0 .08 0 0 -.03 r*3.5 r*.4 6", "bark", "" },

{ "limb", THING, "", "l=1 r=.05 d=2 many=3 s=.1 full=5 spread=35", "", "" },
{ "wood", TURNED, "", "r -.01 r*.85 l*.5 r*.65 l", "bark", "" },
{ "fork", PART, "many: 0 l*.98 0 360*t+-40~40 spread*.6~spread*1.2", "limb l=l*.6~l*.85 r=r*.62 d=d-1", "", "d>0" },
{ "side", PART, "1~2: 0 l*.4~l*.8 0 0~360 40~75", "limb l=l*.4~l*.6 r=r*.4 d=d-1", "", "(d>0)*.6" },
{ "leaves", LEAF, "full*6: 0 l*.1~l*1.15 0 0~360 -90~60", "s*.8 s*.9~s*1.7 .3~1.1 2 1", "leaf", "d<2" },

{ "fir", THING, "", "h=2~5 n=9~16 r=h*.2~h*.3", "", "" },
{ "trunk", TURNED, "", "h*.03 0 h*.012 h*.7 0 h", "bark", "" },
{ "tier", PART, "n: 0 h*(.12+.86*t) 0 40*i", "fir_tier l=r*(1-t*.9)", "", "" },
{ "fir_tier", THING, "", "l=.8", "", "" },
{ "branch", LEAF, "9~13: 0 0 0 360*t+-9~9 10~26", "l*.5 l*.85~l .35 3 1", "leaf", "" },

{ "stone", THING, "", "s=.12~.5 flat=.5~1 rough=.2~.7 edges=0|0|1", "", "" },
{ "body", ROCK, "0 s*flat*.5 0 0~360", "s*.8~s*1.3 s*flat s rough 12-6*edges edges", "stone", "" },

{ "post_lamp", THING, "", "h=2.8~5 arm=.3~1.2", "", "" },
{ "post", TURNED, "", ".12 0 .12 .2 .06 .3 .045 h 0 h", "metal", "" },
{ "arm", ROD, "0 h 0", "0 0 0 0 .15 arm .025", "metal", "" },
{ "head", CUSHION, "0 h+.13 arm", "0 0 0 .1 .05 .22 .4 8", "metal", "" },
{ "light", LAMP, "0 h-.05 arm", "0 0 0", "", "" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
