/* fields_stage.h - rows of the fields of rigid occluders, on a stage of occlusion between objects. */
#ifndef LAB_FIELDS_STAGE_H
#define LAB_FIELDS_STAGE_H

#include "lab/measure/measure.h"

/* Fills in the desc of the bake that a method's settings ask for. */
int  fields_desc(ssgi_field_desc *d, const char *settings, kit_error *err);
/* Adds a bake to a row, which may be blank or have other bakes: adds memory and time, keeps the largest error. */
int  fields_baked(row *r, const kit_mesh *shape, const ssgi_field_desc *d, kit_error *err);
/* Draws occlusion by the entries' fields: fills a row for each entry and one of no AO, and gives their pictures. */
int  fields_measure(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err);

#endif
