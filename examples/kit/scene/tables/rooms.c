/* rooms.c - a table of rows: furnished rooms. The columns are explained in kit_seed.h. */
#include "kit/kit_seed.h"

/* clang-format off */
/* W, D: half of the room's width and depth; H: height; use: living, sleeping, working, cooking, washing, a workshop */
const kit_row kit_rows_rooms[] = {
{ "rooms", THING, "", "W=1.6~3.3 D=1.5~2.7 H=2.3~3.2 use=0|0|1|1|2|2|3|3|4|5|5 messy=0~1", "", "" },
{ "stand", STAND, "", "-W+.25 -D+.25 W-.25 D-.25", "", "" },
{ "ceiling_height", CEILING, "", "H", "", "" },
{ "floor", BOX, "", "-W-.2 -.2 -D-.2 W+.2 0 D+.2 0", "floor", "" },
{ "boards", BOX, "W*2/.14: -W+2*W*t 0 0", "-.066 0 -D .066 .004 D 0", "floor", ".5" },
{ "ceiling", BOX, "0 H 0", "-W-.2 0 -D-.2 W+.2 .2 D+.2 0", "white", "" },
{ "beams", BOX, "3~6: 0 H -D+2*D*t", "-W -.18 -.07 W 0 .07 0", "wood", ".25" },
{ "sides", PART, "4: 0 0 0 90*i", "side l=(i=0)*W+(i=2)*W+(i=1)*D+(i=3)*D e=(i=0)*D+(i=2)*D+(i=1)*W+(i=3)*W", "", "" },
{ "light", PART, "-.5~.5 H -.5~.5", "pendant", "", ".8" },
{ "rug", BOX, "-W*.3~W*.3 .004 -D*.3~D*.3 -8~8", "-1.2~-.7 0 -.9~-.5 .7~1.2 .012 .5~.9 .004", "cloth", ".5" },

{ "sofa", MODEL, "0~2: -W*.6~W*.6 0 -D*.5~D*.6 0~360 0 1 clear .8",
  "sofa2|winchesterSofa|couch|mid-century-sofa|rattanSofa|simple_sofa|clear_sofa|futon-couch|sofa3|burlap_sofa", "",
  "use=0" },
{ "armchairs", MODEL, "0~3: -W*.8~W*.8 0 -D*.8~D*.8 0~360 0 1 clear .5",
  "armchair2|winchesterArmchair|modernArmchair|mid-century-chair|armchair1|fotel|armchair|rattanArmchair|antiqueChair",
  "", "(use<2)*.8" },
{ "dining", PUT, "0~1: -W*.5~W*.5 0 -D*.4~D*.4 -90|0|90 0 1 clear .9", "dining", "", "(use=0)+(use=3)" },
{ "bed", MODEL, "1~2: -W*.7~W*.7 0 -D+1.15 0|0|180 0 1 clear 1",
  "bed1|bed2|iron_bed|juniorBed|captains-bed|day_bed_frame|bunkBed|hospital-bed|bed3", "", "use=1" },
{ "cot", MODEL, "-W*.8~W*.8 0 -D*.8~D*.8 0|90 0 1 clear .6", "crib|babyRockingBed|mezzanine-bed|changing-table", "",
  "(use=1)*.4" },
{ "desks", PUT, "2~5: -W*.8~W*.8 0 -D*.8~D*.8 0|90|180|270 0 1 clear .75", "workplace", "", "use=2" },
{ "island", MODEL, "-.5~.5 0 -.4~.4 0|90 0 1 clear .8", "kitchenIsland|islandExtension|table|white_kitchen_table", "",
  "(use=3)*.7" },
{ "bath", MODEL, "-W*.6~W*.6 0 -D+.5 0 0 1 clear .8", "bath_jay_hardy|islandBath|corner_bathtub", "", "use=4" },
{ "benches", PUT, "1~3: -W*.7~W*.7 0 -D*.7~D*.7 0|90 0 1 clear .8", "workbench", "", "use=5" },
{ "free", MODEL, "0~3: -W*.8~W*.8 0 -D*.8~D*.8 0~360 0 1 clear .4",
  "piano|table_football|treadmill|indoor-bike|stroller|clothes-horse|wheelchair|step-ladder-metal|electricGuitar|"
  "tableTennisBat|child_swing|step-ladder-wood|clothes-rack|hanging-clothes2|punching-ball|baby_high_chair|puff", "",
  ".5" },
{ "chairs", PUT, "0~5: -W*.85~W*.85 0 -D*.85~D*.85 0~360 0 1 clear .3", "chair|stool|chair_model|chair_model", "", "" },
{ "plants", PUT, "0~3: W*.85*(-1|1) 0 D*.85*(-1|1) 0~360 0 .6~1 clear .3", "plant", "", "" },
{ "floor_things", PUT, "messy*14: -W*.9~W*.9 .001 -D*.9~D*.9 0~360 0 1 clear .18",
  "carton|carton|crate|books_flat|small|litter|litter|bowl|sack", "", "" },
{ "someone", PUT, "-W*.7~W*.7 0 -D*.7~D*.7 0~360 0 1 clear .35", "people", "", ".2" },

/* One wall at z = -e, of half length l, seen from inside, and the things beside it. */
{ "side", THING, "", "l=2 e=2 hole=0|1|1|2 a=-l*.4~l*.4 b=.5~1 low=.7~1 high=H-.5~H-.25", "", "" },
{ "wall", BOX, "0 0 -e", "-l-.2 0 -.15 l+.2 H 0 0", "wall", "hole=0" },
{ "left", BOX, "0 0 -e", "-l-.2 0 -.15 a-b H 0 0", "wall", "hole>0" },
{ "right", BOX, "0 0 -e", "a+b 0 -.15 l+.2 H 0 0", "wall", "hole>0" },
{ "above", BOX, "0 0 -e", "a-b high -.15 a+b H 0 0", "wall", "hole>0" },
{ "below", BOX, "0 0 -e", "a-b 0 -.15 a+b low 0 0", "wall", "hole=1" },
{ "window", PART, "a low -e", "window w=b h=high-low", "", "hole=1" },
{ "door", MODEL, "a 0 -e+.02 0 0", "exterior-door-02|exterior-door-03|door|puerta|glass_door|screen-door", "", "hole=2"
  },
{ "beyond", BOX, "a 0 -e-1.4", "-b-1 0 -.1 b+1 H 0 0", "wall", "hole=2" },
{ "skirting", BOX, "0 0 -e", "-l 0 0 l .09 .014 .003", "white", "(hole<2)*.7" },
{ "tiles", BOX, "8: -l+2*l*t .9 -e", "-l/8.3 0 0 l/8.3 .5 .008 .002", "white", "((use=3)+(use=4))*(hole=0)" },
{ "curtains", PART, "2: a+b*1.1*(2*i-1) high+.05 -e+.09", "cloth_hung w=b*.5~b*.8 h=high-low+.2~high-.02", "",
  "(hole=1)*.6" },
{ "blind", BOX, "(high-low)/.05*.3~(high-low)/.05: a high-.05*i -e+.03 0 -25", "-b 0 -.018 b .002 .018 0", "white",
  "(hole=1)*.25" },
{ "radiator", MODEL, "a .1 -e+.08", "modernRadiator|radiator2|radiator3|bathroomRadiator", "", "(hole=1)*.7" },
{ "shelving", PUT, "0~2: -l+.6~l-.6 0 -e+.2 0 0 1 clear .55", "shelf", "", "(hole<2)*(1-(use=4)*.7)" },
{ "cabinets", MODEL, "0~3: -l+.5~l-.5 0 -e+.32 0 0 1 clear .52",
  "wardrobe|wardrobe2|cupboard|dresserWithDrawers|bookcase|full-bookcase|wardrobe1|dressing-table|chest|"
  "televisionCabinet|tvStand|bedsideTable|drawersCabinet|kids_shelves|fireplace1|filing-cabinet|office_box", "",
  "(hole<2)*(use<3)" },
{ "kitchen", MODEL, "2~6: -l+.35+.65*i 0 -e+.32 0 0 1 clear .3",
  "kitchenLowerCabinet|lowerCabinet|sinkCabinet|drawersCabinet|kitchenSink|stove|oven|refrigerator|largeFridge|"
  "highCabinet|fridge|doubleOven|washing_machine|clothes_washing_machine", "", "(use=3)*(hole<2)*.8" },
{ "uppers", MODEL, "1~4: -l+.4+.62*i 1.4 -e+.2",
  "upperCabinet|glassDoorCabinet|kitchenUpperCabinet|upperShelves|rangeHood|smallUpperCabinet", "", "(use=3)*(hole=0)"
  },
{ "washing", MODEL, "1~2: -l+.5~l-.5 0 -e+.35 0 0 1 clear .4",
  "washbasin|modernToilet|toiletsUnit|bidet|bathroom_vanity|modernVanity|washbasin_jay_hardy|small_lavatory|"
  "clothes_washing_machine|radiatorAndTowels|showerStall", "", "(use=4)*(hole<2)" },
{ "tools", MODEL, "1~3: -l+.5~l-.5 0 -e+.4 0 0 1 clear .5",
  "utility-shelving|workbench|electric_water_heater_big|barrel|furnace|mower|lockedLocker|bicycle|wheelbarrow|"
  "gaz_water_heater|step-ladder-wood|trunk-large", "", "(use=5)*(hole<2)" },
{ "pegs", BOX, "4~16: -l*.8~l*.8 1.3~1.9 -e -25~25", "-.012 -.25~-.1 0 .012 .05~.1 .03 0", "metal", "(use=5)*(hole=0)"
  },
{ "pictures", PART, "0~4: -l+.5~l-.5 1.4~1.7 -e 0 0 1 clear .5", "picture", "", "(hole<2)*(use<4)" },
{ "boards", PUT, "0~2: -l+.6~l-.6 1.3~1.7 -e+.13 0 0 1 clear .5", "wall_board", "", "(hole=0)*.7" },
{ "coats", PART, "2~6: -l*.5+.25*i 1.5 -e+.12 0~30", "cloth_hung w=.3 h=.6~1 waves=2", "", "(hole=0)*.2" },
{ "wires", WIRE, "0~2", "-l~l .3~H-.2 -e+.02 -l~l .3~H-.2 -e+.02 .05~.4 .006", "metal", ".35" },

{ "window", THING, "", "w=.8 h=1.2 bars=1|1|2|3", "", "" },
{ "frame", BOX, "2: w*(2*i-1) 0 0", "-.05 0 -.12 .05 h .02 .005", "white", "" },
{ "rails", BOX, "2: 0 h*i 0", "-w -.04 -.12 w .04 .02 .005", "white", "" },
{ "mullions", BOX, "bars: -w+2*w*(i+1)/(n+1) 0 -.07", "-.02 0 -.02 .02 h .02 0", "white", "" },
{ "cross", BOX, "bars: 0 h*(i+1)/(n+1) -.07", "-w -.015 -.015 w .015 .015 0", "white", "" },
{ "sill", BOX, "", "-w-.1 -.05 0 w+.1 -.01 .18 .006", "white", "" },
{ "pots", PART, "0~4: -w*.8~w*.8 -.009 .09 0~360 0 .4~.6 clear .08", "plant|vase|cup|small|bottle", "", "" },

{ "pendant", THING, "", "l=.3~1 r=.12~.3 of=0|1|2", "", "" },
{ "cord", ROD, "", "0 0 0 0 -l 0 .005 6", "metal", "" },
{ "shade", TURNED, "0 -l 0", "r 0 r*.95 0 r*.3 r*.8 r*.25 r*.85 r*.9 .02 r 0", "cloth", "of=0" },
{ "ball", BALL, "0 -l 0", "0 0 0 r*.6 r*.6 r*.6 12", "white", "of=1" },
{ "hoops", RING, "5~9: 0 -l+.07*(i-n/2) 0", "0 0 0 r*.9 .007", "metal", "of=2" },
{ "light", LAMP, "0 -l-.3 0", "0 0 0", "", "" },

{ "dining", THING, "", "w=.5~.85 d=.4~.5", "", "" },
{ "table", PART, "", "table w=w d=d h=.74 full=1", "", "" },
{ "chairs", PART, "2~6: (w*.5)*sx 0 (d+.12~d+.3)*sz 90-90*sz+-20~20", "chair", "", "" },

{ "chair_model", THING, "", "", "", "" },
{ "one", MODEL, "",
  "chair|chair2|oakChair|silla2|osakaChair|thonet|cafe-chair|dining-chair|kitchenChair|tubular_chair|"
  "office_chair|office-chair|bar-stool|plasticChair|chair3|plaidChair|foldingChair|designChair", "", "" },

{ "workplace", THING, "", "", "", "" },
{ "table", PART, "", "table w=.6~.8 d=.35~.4 h=.73 full=.9", "", "" },
{ "screen", BOX, "0~1: -.25~.25 .75 -.12 -20~20", "-.26 .1 -.015 .26 .45 .015 .006", "glass", "" },
{ "foot", BOX, "0 .735 -.12", "-.1 0 -.08 .1 .015 .08 0", "glass", "" },
{ "keys", BOX, "0 .735 .12 -6~6", "-.2 0 -.06 .2 .02 .06 .004", "glass", "" },
{ "machine", MODEL, "-.3~.3 .735 -.1 -20~20",
  "laptop|apple_pc|desk_lamp1|desklamp|phone|inkjet_and_scanner_printer|apple-ibook-2001", "", ".7" },
{ "chair", MODEL, "-.1~.1 0 .55~.8 150~210", "office_chair|office-chair|armchair1|classSeat|chair4", "", ".9" },
{ "bin", TURNED, "-.5 0 .1", "0 0 .12 0 .15 .3 .14 .3 .11 .01 0 .01", "metal", ".6" },

{ "workbench", THING, "", "w=.7~1.1", "", "" },
{ "table", PART, "", "table w=w d=.35 h=.88 r=.05 full=1 kind=0", "", "" },
{ "shelf", BOX, "", "-w+.05 .2 -.3 w-.05 .23 .3 0", "wood", "" },
{ "below", PART, "0~5: -w*.8~w*.8 .231 -.2~.2 0~360 0 .7 clear .15", "carton|crate|small|bottle", "", "" },
{ "vice", BOX, "-w*.6 .88 .25", "-.06 0 -.1 .06 .14 .1 .01", "metal", ".7" },
{ "tool", MODEL, "0~3: -w*.7~w*.7 .885 -.2~.2 0~360 0 1 clear .12",
  "marteau|perceuse-electrique|meuleuse-electrique|scie-egoine|radio|fireExtinguisher", "", "" },

{ "shelf", THING, "", "w=.3~.6 h=1~2.1 d=.13~.18 n=3~6 steel=0|0|1", "", "" },
{ "sides", BOX, "2: w*(2*i-1) 0 0", "-.012 0 -d .012 h d 0", "wood", "steel=0" },
{ "posts", BOX, "4: w*sx 0 d*sz", "-.015 0 -.015 .015 h .015 0", "metal", "steel=1" },
{ "back", PANE, "0 0 -d+.004", "-w 0 0 w h 0", "wood", "(steel=0)*.7" },
{ "boards", PART, "n+1: 0 h*i/(n+.2) 0", "shelf_board high=h/(n+.2)", "", "" },
{ "shelf_board", THING, "", "w=.5 d=.15 high=.35 of=0|0|1|2", "", "" },
{ "board", BOX, "", "-w 0 -d w .02 d 0", "wood", "" },
{ "books", PART, "0 .021 -.01", "books l=w*1.2~w*1.9 h=high*.8 d=d", "", "of=0" },
{ "things", PART, "1~6: -w*.85~w*.85 .021 -d*.5~d*.5 0~360 0 .8 clear .08", "small|bottle|cup|vase|books_flat|bowl",
  "", "of=1" },
{ "boxes", PART, "1~3: -w*.7+w*.7*i .021 0 -6~6", "carton w=w*.22 h=high*.5~high*.8 d=d*.8 open=0", "", "of=2" },

{ "wall_board", THING, "", "w=.3~.6 d=.1~.13", "", "" },
{ "board", BOX, "", "-w 0 -d w .025 d 0", "wood", "" },
{ "brackets", BOX, "2: w*.7*(2*i-1) 0 0", "-.01 -.14 -d .01 0 -d+.02 0", "metal", "" },
{ "books", PART, "-w*.3 .026 0", "books l=w*1.1 h=.26 d=d", "", ".6" },
{ "things", PART, "1~5: -w*.9~w*.9 .026 -d*.4~d*.4 0~360 0 .7 clear .09", "small|cup|vase|plant|bottle", "", "" },

{ "picture", THING, "", "w=.12~.45 h=.12~.4", "", "" },
{ "frame", BOX, "2: w*(2*i-1) 0 0", "-.018 -h .002 .018 h .03 .004", "wood", "" },
{ "bars", BOX, "2: 0 h*(2*i-1) 0", "-w-.018 -.018 .002 w+.018 .018 .03 .004", "wood", "" },
{ "sheet", PANE, "0 0 .01", "-w -h 0 w h 0", "paper", "" },

{ "litter", THING, "", "", "", "" },
{ "one", MODEL, "",
  "sneakers|basketball|toyTrain|radio|suitcase|backpack|skateboard|briefcase|teddyBear|shopping-basket|caballito|"
  "tricycle|cat|dog|speaker2|tableFan|office_box|clothes-basket|wood_logs|gift", "", "" },

{ NULL, 0, NULL, NULL, NULL, NULL } };
