/* deep_stage.c - views for deep screen space. Declared in deep_stage.h. */
#include "lab/chart/deep_stage.h"

enum { DEEP_RAYS = 128 };
#define DEEP_LIGHT "sky", { "sun:-1,0.45,0.85,4.4,3.9,3.3" }, 4, 1, 0
const lit deep_sky    = { DEEP_LIGHT, 128, 0.4f, NO_CROPS };
const lit deep_lamp   = { NULL, { "point:0,5,-2.8,60,60,60" }, 0, 1, 0, 128, 0.5f, NO_CROPS };
const lit deep_behind = { NULL, { "sun:1,0.5,-0.6,4,4,4" }, 0, 0, 0, 200, 1.5f, NO_CROPS };

int deep_load(stage *s, const deep_view *v, kit_error *err)
{
    static const float grey[3] = { 0.7f, 0.7f, 0.7f };
    if (stage_load(s, &v->view, err)) return -1;
    s->otherwise = v->otherwise;
    if (!s->lit) s->rays = DEEP_RAYS;
    for (int i = 0; i < COUNT(v->box) && v->box[i][4] > v->box[i][1]; ++i)
        if (kit_scene_add_box(&s->scene, v->box[i], v->box[i] + 3, grey, err)) return -1;
    return 0;
}

int deep_open(stage *s, const deep_view *v, kit_error *err)
{
    return deep_load(s, v, err) || stage_show(s, &v->view, DEEP_WIDTH, DEEP_HEIGHT, err) ? -1 : 0;
}
