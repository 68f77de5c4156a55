/* views.c - reads views of scenes from csv. Declared in views.h. */
#include "lab/measure/views.h"
#include <stdlib.h>
#include <string.h>

static void read_light(view *v, lit *is, const line *l)
{
    *is = (lit){ .env = line_text(l, "env"), .boxes = line_whole(l, "boxes"), .bounce = line_whole(l, "bounce"),
                 .local = line_whole(l, "local"), .rays = v->rays, .exposure = line_real(l, "exposure") };
    line_split(l, "light", is->light, MOST_SUNS);
    if (is->env || is->light[0]) v->lit = is;
}

/* Reads the parts of the picture that are shown enlarged, and what is put into the scene. */
static void read_parts(view *v, const line *l)
{
    const char *crop[MOST_CROPS] = { NULL }, *at[MOST_SPOTS] = { NULL }, *solid[MOST_SOLIDS] = { NULL };
    line_split(l, "crops", crop, MOST_CROPS);
    line_split(l, "spots", at, MOST_SPOTS);
    line_split(l, "solids", solid, MOST_SOLIDS);
    for (int k = 0; k < MOST_CROPS && crop[k]; ++k) {
        int *c = v->crop[k];
        if (sscanf(crop[k], "%d %d %d %d", &c[0], &c[1], &c[2], &c[3]) != 4) line_fault(l, "crops");
    }
    for (int k = 0; k < MOST_SPOTS && at[k]; ++k) {
        spot *s = &v->spot[k];
        if (sscanf(at[k], "%15s %f %f %f %f", s->name, &s->size, &s->at[0], &s->at[1], &s->at[2]) != 5)
            line_fault(l, "spots");
    }
    for (int k = 0; k < MOST_SOLIDS && solid[k]; ++k) line_reals(l, "solids", solid[k], v->solid[k], 9);
}

void view_read(view *v, lit *light, const line *l)
{
    const char *kind = line_cell(l, "kind");
    *v = (view){ .name = line_text(l, "name"), .path = line_text(l, "scene"), .ground = line_whole(l, "ground"),
                 .fovy = line_real(l, "fovy"), .radius = line_real(l, "radius"), .rays = line_whole(l, "rays"),
                 .between = line_whole(l, "between"), .time = atof(line_cell(l, "time")),
                 .package = line_text(l, "package"),
                 .otherwise = { line_whole(l, "hard"), !*kind ? 0 : *kind == 'g' ? GLOSS : SCATTER,
                                line_real(l, "exponent"), line_real(l, "unit"), line_text(l, "material") } };
    if (!v->name) v->name = line_text(l, "view");
    if (!v->name || !v->path) line_fault(l, "scene");
    if (!strcmp(v->path, "bunny")) v->path = BUNNY;
    line_reals(l, "eye", line_cell(l, "eye"), v->eye, 3);
    line_reals(l, "target", line_cell(l, "target"), v->target, 3);
    read_light(v, light, l);
    read_parts(v, l);
}
