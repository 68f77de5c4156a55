/* deep_stage.h - views of deep screen space. */
#ifndef LAB_DEEP_STAGE_H
#define LAB_DEEP_STAGE_H

#include "lab/chart/section.h"

/* A view for deep screen space. box[k] is added to the scene if its upper y is above its lower y. */
typedef struct deep_view { view view; float box[4][6]; otherwise otherwise; } deep_view;
enum { DEEP_WIDTH = 320, DEEP_HEIGHT = 180 };

extern const lit deep_sky, deep_lamp, deep_behind;
#define PLAINLY    { 0, 0, 0, 0, NULL }
#define WHOLLY     { 1, 0, 0, 0, NULL }
#define BUNNY_VIEW(name, ground, radius, lit) \
    { name, BUNNY, ground, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, radius, lit }, NO_BOX
#define NO_BOX    { { 0 } }
#define BUNNY_AO  { BUNNY_VIEW("bunny-on-floor", 1, 0.6f, NULL), PLAINLY }
/* Light that fades: as in ssdo, an occluder counts less the farther away it is within the radius. */
#define FADING    { BUNNY_VIEW("light-fading", 1, 0.6f, &deep_sky), PLAINLY }
#define WHOLE_LIGHT { BUNNY_VIEW("light-whole", 1, 0.6f, &deep_sky), WHOLLY }      /* as in dss-lit */
#define LOBE      { { "gloss", "cornell", 0, { 0 }, { 0 }, 0, 1.5f, &deep_lamp }, NO_BOX, { 1, GLOSS, 8, 0, NULL } }
#define OF_MARBLE { BUNNY_VIEW("marble", 0, 10, &deep_behind), { 0, SCATTER, 0, 0.05f, "marble" } }
#define OWN_VIEW(scene) { { scene, scene, 0, { 0 }, { 0 }, 0, 0, NULL }, NO_BOX, PLAINLY }

#define COARSE "size=0.03"
#define MARBLE "material=marble,unit=0.05,levels=7,epsilon=0.02"

int  deep_load(stage *s, const deep_view *v, kit_error *err);
int  deep_open(stage *s, const deep_view *v, kit_error *err);

#endif
