/* fields_stage.h - what the pages on ambient occlusion fields share: rigid occluders put up on a stage, and rows of
   their fields. */
#ifndef LAB_FIELDS_STAGE_H
#define LAB_FIELDS_STAGE_H

#include "lab/measure/measure.h"

/* Where an object of "casters" is put; a view of what is rigid. spot: all other objects are hidden in the ground (none:
   all stay). box: added, cast nothing. */
typedef struct spot { const char *name; float size, at[3]; } spot;
typedef struct setup {
    view   view;
    spot   spot[2];
    float  box[3][6];
    double time;                           /* of kit_scene_move */
    int    rays;
} setup;

#define WHOLE(name, scene)  { name, scene, 0, { 0 }, { 0 }, 0, 0, NULL }
#define CLOSE(name)         { name, "casters", 0, { 1.5f, 2.3f, 3.3f }, { 0, 0.35f, 0 }, 34, 0, NULL }
#define NO_BOXES            { { 0 } }
#define NO_SPOTS            { { NULL, 0, { 0 } } }

void fields_place(float to_world[16], float size, const float at[3]);
int  fields_open(stage *s, const setup *f, int width, int height, kit_error *err);
/* What a method's settings ask of a bake. */
int  fields_desc(ssgi_field_desc *d, const char *settings, kit_error *err);
/* Adds a bake to a row that is blank or has others: memory and time add up, of errors the worst stays. */
int  fields_baked(row *r, const kit_mesh *shape, const ssgi_field_desc *d, kit_error *err);
/* Occlusions and their fields: fills a row an entry, and one of no AO, beside the entries' pictures. */
int  fields_measure(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err);

#endif
