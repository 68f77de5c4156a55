/* deep_stage.c - views for deep screen space, and rows of them without the floor. Declared in deep_stage.h. */
#include "lab/chart/deep_stage.h"
#include <string.h>
#include "lab/page/page.h"

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

int deep_measure(row *rows, stage *s, const char *scene, const entry *entries, int count, int rounds,
                 kit_image *pictures, kit_error *err)
{
    int kept = 0;
    row all[MOST_ROWS];
    if (measure_entries(all, s, entries, count, rounds, 0, pictures, err)) return -1;
    for (int i = 0; i < count + s->givens; ++i) {
        if (!strcmp(all[i].method, "floor")) continue;
        all[i].of = s->lit ? OF_DEEP_LIT : OF_DEEP;
        all[i].scene = scene;
        rows[kept++] = all[i];
    }
    return kept;
}

void deep_about(FILE *record, const stage *s, const char *about)
{
    page_paragraph(record, "%s %zu triangles, %d x %d pixels, radius %g. Truth: %d %s%s.", about,
                   s->scene.mesh.triangles, s->frame.width, s->frame.height, (double)s->radius, s->rays,
                   s->otherwise.kind == SCATTER ? "thousand samples" : "rays a pixel",
                   s->stride > 1 ? ", every second pixel of every second row" : "");
}
