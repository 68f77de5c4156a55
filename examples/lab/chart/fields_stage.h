/* fields_stage.h - rigid occluders on a stage, and rows of their fields, for the sections on ambient occlusion
   fields. */
#ifndef LAB_FIELDS_STAGE_H
#define LAB_FIELDS_STAGE_H

#include "lab/measure/measure.h"

/* spot: the place of an object of the scene "casters". setup: a view of rigid occluders. All objects without a spot are
   hidden in the ground; without any spot all stay. box: added to the scene, and casts nothing. */
typedef struct spot { const char *name; float size, at[3]; } spot;
typedef struct setup {
    view   view;
    spot   spot[2];
    float  box[3][6];
    double time;                           /* milliseconds that kit_scene_move takes */
    int    rays;
} setup;

#define WHOLE(name, scene)  { name, scene, 0, { 0 }, { 0 }, 0, 0, NULL }
#define CLOSE(name)         { name, "casters", 0, { 1.5f, 2.3f, 3.3f }, { 0, 0.35f, 0 }, 34, 0, NULL }
#define NO_BOXES            { { 0 } }
#define NO_SPOTS            { { NULL, 0, { 0 } } }

void fields_place(float to_world[16], float size, const float at[3]);
int  fields_open(stage *s, const setup *f, int width, int height, kit_error *err);
/* Fills in the desc of the bake that a method's settings ask for. */
int  fields_desc(ssgi_field_desc *d, const char *settings, kit_error *err);
/* Adds a bake to a row, which may be blank or have other bakes: adds memory and time, keeps the largest error. */
int  fields_baked(row *r, const kit_mesh *shape, const ssgi_field_desc *d, kit_error *err);
/* Draws occlusion by the entries' fields: fills a row for each entry and one of no AO, and gives their pictures. */
int  fields_measure(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err);

#endif
