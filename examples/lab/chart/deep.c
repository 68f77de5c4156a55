/* deep.c - what report.c shows of deep screen space: its effects beside screen space and the truth; what size, epsilon,
   levels and the other choices buy; what happens while the camera turns away or moves; where the time goes. Declared in
   report.h. */
#include "lab/report.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* boxes are added, where their upper y is above their lower one */
typedef struct deep_view { view view; float box[4][6]; otherwise otherwise; } deep_view;

#define DEEP_LIGHT "sky", { "sun:-1,0.45,0.85,4.4,3.9,3.3" }, 4, 1, 0
#define PLAINLY    { 0, 0, 0, 0, NULL }
#define WHOLLY     { 1, 0, 0, 0, NULL }
static const lit deep_sky    = { DEEP_LIGHT, 128, 0.4f, NO_CROPS };
static const lit deep_lamp   = { NULL, { "point:0,5,-2.8,60,60,60" }, 0, 1, 0, 128, 0.5f, NO_CROPS };
static const lit deep_behind = { NULL, { "sun:1,0.5,-0.6,4,4,4" }, 0, 0, 0, 200, 1.5f, NO_CROPS };
static const lit deep_white  = { "white", { NULL }, 0, 0, 0, 64, 1, NO_CROPS };

#define BUNNY_VIEW(name, ground, radius, lit) \
    { name, BUNNY, ground, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, radius, lit }, NO_BOX
#define NO_BOX    { { 0 } }
#define BUNNY_AO  { BUNNY_VIEW("bunny-on-floor", 1, 0.6f, NULL), PLAINLY }
/* as ssdo has it: less the farther within the radius */
#define FADING    { BUNNY_VIEW("light-fading", 1, 0.6f, &deep_sky), PLAINLY }
#define WHOLE_LIGHT { BUNNY_VIEW("light-whole", 1, 0.6f, &deep_sky), WHOLLY }      /* as dss-lit has it */
#define LOBE      { { "gloss", "cornell", 0, { 0 }, { 0 }, 0, 1.5f, &deep_lamp }, NO_BOX, { 1, GLOSS, 8, 0, NULL } }
#define OF_MARBLE { BUNNY_VIEW("marble", 0, 10, &deep_behind), { 0, SCATTER, 0, 0.05f, "marble" } }
#define OWN_VIEW(scene) { { scene, scene, 0, { 0 }, { 0 }, 0, 0, NULL }, NO_BOX, PLAINLY }

/* The eye turns from what occludes, the box, which leaves the picture; the ground beside it stays. */
enum { TURNS = 9, MOST_FRAMES = 5 };
static const float turn_eye[3] = { 0.35f, 0.9f, 2.8f }, turn_from = -8, turn_to = 21,
                   ground_bounds[2][3] = { { 0.16f, -0.1f, -0.15f }, { 0.5f, 0.1f, 0.2f } };
#define TURN_BOX { { -0.6f, 0.001f, -0.15f, 0, 1, 0.15f } }

static const entry deep_two[]     = { { "hsao", "hsao", "", 1 }, { "dss", "dss", "", 1 } };
static const entry deep_lit[]     = { { "dss-lit", "dss-lit", "size=0.03", 1 } };
static const entry deep_mirror[]  = { { "dss-gloss", "dss-gloss", "exponent=8", 1 } };
#define COARSE "size=0.03"
#define MARBLE "material=marble,unit=0.05,levels=7,epsilon=0.02"
static const entry deep_beside[]  = { { "hsao", "hsao", "", 1 }, { "dss", "dss", COARSE, 1 } };
static const entry deep_under[]   = { { "dss-scatter", "dss-scatter", MARBLE, 1 } };

typedef struct deep_part { const char *title, *about; deep_view see; const entry *entries; int count; } deep_part;
#define PART(entries, count) entries, count
static const deep_part deep_demos[] = {
    { "Deep screen space: ambient occlusion",
      "Discs of all triangles, seen or not, take from the ambient light of the pixels around them. Bunny on a floor.",
      BUNNY_AO, PART(deep_two, COUNT(deep_two)) },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce; all within the radius counts whole. Surfels of 0.03.",
      WHOLE_LIGHT, PART(deep_lit, COUNT(deep_lit)) },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, met by a lobe of exponent 8. Nothing here does that in screen space.", LOBE,
      PART(deep_mirror, COUNT(deep_mirror)) },
    { "Deep screen space: scattering under the surface",
      "A bunny of marble, 4 cm high, lit from behind. Nothing here does that in screen space. Truth: the dipole over "
      "samples on all of the mesh.",
      OF_MARBLE, PART(deep_under, COUNT(deep_under)) },
    { "Deep screen space: what the picture does not show",
      "Beside the picture: along its left side stands a wall, off the picture.",
      { { "off-screen", "plane", 0, { 0.15f, 0.9f, 2 }, { 1.2f, 0.1f, 0 }, 30, 0.6f, NULL },
        { { -0.2f, 0.001f, -4, 0, 1, 1.5f } },
        PLAINLY },
      PART(deep_beside, COUNT(deep_beside)) },
    { NULL,
      "Hidden: a box behind a screen.",
      { { "hidden", "plane", 0, { 0, 1, 4 }, { 0.15f, 0.15f, 0 }, 26, 0.6f, NULL },
        { { -0.75f, 0.001f, -0.4f, -0.02f, 0.6f, 0.2f }, { -1.2f, 0.001f, 1.2f, 0, 0.75f, 1.24f } },
        PLAINLY },
      PART(deep_beside, COUNT(deep_beside)) },
    { NULL,
      "At grazing angle: of a box the side that occludes is seen edge-on.",
      { { "grazing", "plane", 0, { 0, 0.45f, 3.2f }, { 0.1f, 0.3f, 0 }, 24, 0.6f, NULL },
        { { -0.6f, 0.001f, -0.8f, 0, 0.7f, 0.4f } },
        PLAINLY },
      PART(deep_beside, COUNT(deep_beside)) }
};

#define DSS(label, settings, quick) { label, "dss", settings, quick }
static const entry deep_ao[] = { /* rows of one label make one curve */
                                 { "ssao", "ssao", "samples=8", 0 },
                                 { "ssao", "ssao", "", 1 },
                                 { "hsao", "hsao-fast", "", 1 },
                                 { "hsao", "hsao", "", 1 },
                                 { "hsao", "hsao-best", "", 1 },
                                 DSS("dss", "size=0.06", 0),
                                 DSS("dss", "size=0.03", 1),
                                 DSS("dss", "", 1),
                                 DSS("dss, epsilon 0.02, 4 levels", "size=0.03,epsilon=0.02,levels=4", 0)
};
static const entry deep_figure8[] = {
    DSS("epsilon", COARSE ",levels=4,epsilon=0.2", 1),  DSS("epsilon", COARSE ",levels=4,epsilon=0.1", 1),
    DSS("epsilon", COARSE ",levels=4,epsilon=0.02", 1), DSS("levels", COARSE ",epsilon=0.1,levels=1", 0),
    DSS("levels", COARSE ",epsilon=0.1,levels=2", 1),   DSS("levels", COARSE ",epsilon=0.1,levels=6", 0)
};
static const entry deep_choices[] = { DSS("defaults", COARSE, 1),
                                      DSS("every triangle", COARSE ",keep_small=1", 0),
                                      DSS("no growth off screen: as published", COARSE ",offscreen_growth=0", 0),
                                      DSS("from the near plane on", COARSE ",near_depth=0", 0),
                                      DSS("near_samples: the centre alone", COARSE ",near_samples=1", 0),
                                      DSS("no smoothing", COARSE ",smooth=0", 0),
                                      DSS("smoothing compares normals", COARSE ",filter_normals=1", 0),
                                      DSS("by tessellation", COARSE ",way=capture", 0),
                                      DSS("by geometry shader", COARSE ",way=direct", 0) };
static const entry deep_lights[] = { { "dss-lit", "dss-lit", COARSE, 1 },
                                     { "dss-lit", "dss-lit", "", 0 },
                                     { "dss-lit, epsilon 0.02", "dss-lit", COARSE ",epsilon=0.02,levels=4", 0 },
                                     { "dss-lit, no sky on surfels", "dss-lit", COARSE ",sky=0", 0 } };
static const entry deep_ssdos[] = { { "ssdo", "ssdo-fast", "", 0 },
                                    { "ssdo", "ssdo", "", 1 },
                                    { "ssdo", "ssdo-best", "", 0 },
                                    { "ssdo, 4 cameras", "ssdo-points", "views=4", 0 } };
static const entry deep_mirrors[] = { { "dss-gloss", "dss-gloss", "exponent=8,size=0.06", 0 },
                                      { "dss-gloss", "dss-gloss", "exponent=8,size=0.03", 1 },
                                      { "dss-gloss, epsilon 0.02", "dss-gloss", "exponent=8,size=0.03,epsilon=0.02",
                                        0 } };
static const entry deep_marbles[] = { { "dss-scatter", "dss-scatter", MARBLE, 1 },
                                      { "dss-scatter, 5 levels", "dss-scatter", MARBLE ",levels=5", 0 },
                                      { "dss-scatter, epsilon 0.1", "dss-scatter", MARBLE ",epsilon=0.1", 0 },
                                      { "dss-scatter, shares of triangles", "dss-scatter",
                                        MARBLE ",keep_small=0", 1 } };
static const entry deep_effects[] = { { "ambient occlusion", "dss", "way=capture", 1 },
                                      { "directional occlusion, a bounce", "dss-lit", "way=capture", 1 },
                                      { "one specular bounce", "dss-gloss", "way=capture", 1 },
                                      { "scattering", "dss-scatter", "way=capture," MARBLE, 1 } };
static const entry deep_watched[] = { { "hsao", "hsao", "", 1 },
                                      { "ssdo", "ssdo", "bounce=none", 1 },
                                      { "dss", "dss", COARSE, 1 } };
static const entry deep_moved[] = { { "hsao", "hsao", "", 1 },
                                    { "ssao", "ssao", "", 0 },
                                    { "dss", "dss", COARSE, 1 },
                                    { "dss, every triangle", "dss", COARSE ",keep_small=1", 0 } };

/* The same reach, radius sqrt(1 / epsilon - 1) 2^(levels - 1): 16^2 (1/0.1 - 1) = 1/0.000433839 - 1. half: of the
   picture's width and height, brought to full size bilinearly. */
typedef struct full { entry entry; int half; } full;
static const full deep_figure9[] = { { DSS("5 levels", COARSE ",levels=5,epsilon=0.1", 1), 0 },
                                     { DSS("full size, 1 level", COARSE ",levels=1,epsilon=0.000433839", 1), 0 },
                                     { DSS("half size, 1 level", COARSE ",levels=1,epsilon=0.000433839", 1), 1 },
                                     { DSS("half size, 5 levels", COARSE ",levels=5,epsilon=0.1", 0), 1 } };

typedef struct growth { const char *label, *settings; int width, quick; } growth;
static const growth deep_growth[] = { { "surfels", "size=0.06", 320, 1 },
                                      { "surfels", COARSE, 320, 1 },
                                      { "surfels", "size=0.015", 320, 0 },
                                      { "pixels", COARSE, 160, 1 },
                                      { "pixels", COARSE, 320, 0 },
                                      { "pixels", COARSE, 640, 0 },
                                      { "levels", COARSE ",epsilon=0.1,levels=1", 320, 1 },
                                      { "levels", COARSE ",epsilon=0.1,levels=2", 320, 0 },
                                      { "levels", COARSE ",epsilon=0.1,levels=4", 320, 1 },
                                      { "levels", COARSE ",epsilon=0.1,levels=6", 320, 0 } };

typedef struct deep_table {
    const char *title, *about;
    deep_view see;
    const entry *entries;
    int count, quick;
    const char *svg;
} deep_table;
static const deep_table deep_tables[] = { /* one without title goes on with the table before it */
                                          { "Deep screen space: speed against accuracy, bunny", "Bunny on a floor.",
                                            BUNNY_AO, PART(deep_ao, COUNT(deep_ao)), 1, "chart-deep.svg" },
                                          { "Deep screen space: speed against accuracy, room", "Room.",
                                            OWN_VIEW("room"), PART(deep_ao, COUNT(deep_ao)), 0, "chart-deep-room.svg" },
                                          { "Deep screen space: epsilon and levels",
                                            "The paper's figure 8: epsilon and levels, surfels of 0.03.", BUNNY_AO,
                                            PART(deep_figure8, COUNT(deep_figure8)), 0, "chart-deep-figure8.svg" },
                                          { "Deep screen space: other choices",
                                            "Bunny on a floor, surfels of 0.03; one choice at a time.", BUNNY_AO,
                                            PART(deep_choices, COUNT(deep_choices)), 0, NULL },
                                          { "Deep screen space: light",
                                            "Bunny and four boxes under the sky and a sun, one bounce. Of ssdo: what "
                                            "is within the radius weighted by 1 - t/radius, in its truth, too;",
                                            FADING, PART(deep_ssdos, COUNT(deep_ssdos)), 1, NULL },
                                          { NULL, "of dss-lit: all whole, in its truth, too.", WHOLE_LIGHT,
                                            PART(deep_lights, COUNT(deep_lights)), 1, NULL },
                                          { "Deep screen space: one specular bounce",
                                            "Open box under a point light, a lobe of exponent 8. Irradiance stands for "
                                            "the lobe's radiance.",
                                            LOBE, PART(deep_mirrors, COUNT(deep_mirrors)), 0, NULL },
                                          { "Deep screen space: scattering",
                                            "A bunny of marble, 4 cm high, lit from behind. Irradiance stands for the "
                                            "radiance that leaves it.",
                                            OF_MARBLE, PART(deep_marbles, COUNT(deep_marbles)), 0, NULL }
};

enum {
    DEEP_WIDTH = 320,
    DEEP_HEIGHT = 180,
    PAPER_SIDE = 512,
    DEEP_ROUNDS = 2,
    DEEP_RAYS = 128,
    DEEP_TABLES = COUNT(deep_tables),
    DEEP_DEMOS = COUNT(deep_demos),
    FULL_SET = DEEP_TABLES,
    TURN_SET,
    MOTION_SET,
    STAGE_SET,
    GROWTH_SET,
    DEEP_SETS,
    MOST_DEEP = TURNS * COUNT(deep_watched)
};
typedef struct deep_set { const char *title; row row[MOST_DEEP]; int count; } deep_set;
static deep_set demo_sets[DEEP_DEMOS], sets[DEEP_SETS];

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

static int deep_load(stage *s, const deep_view *v, kit_error *err)
{
    static const float grey[3] = { 0.7f, 0.7f, 0.7f };
    if (stage_load(s, &v->view, err)) return -1;
    s->otherwise = v->otherwise;
    if (!s->lit) s->rays = DEEP_RAYS;
    for (int i = 0; i < COUNT(v->box) && v->box[i][4] > v->box[i][1]; ++i)
        if (kit_scene_add_box(&s->scene, v->box[i], v->box[i] + 3, grey, err)) return -1;
    return 0;
}

static int deep_open(stage *s, const deep_view *v, kit_error *err)
{
    return deep_load(s, v, err) || stage_show(s, &v->view, DEEP_WIDTH, DEEP_HEIGHT, err) ? -1 : 0;
}

/* Measured as the others are, but without the floor, and shown with other columns. Returns how many rows, -1 =
   failed. */
static int deep_measure(row *rows, stage *s, const char *scene, const entry *entries, int count, int rounds,
                        kit_image *pictures, kit_error *err)
{
    int kept = 0;
    row all[MOST_ROWS];
    if (measure(all, s, entries, count, rounds, 0, pictures, err)) return -1;
    for (int i = 0; i < count + s->givens; ++i) {
        if (!strcmp(all[i].method, "floor")) continue;
        all[i].of = s->lit ? OF_DEEP_LIT : OF_DEEP;
        all[i].scene = scene;
        rows[kept++] = all[i];
    }
    return kept;
}

/* A row that is not scored as measured ones are. */
static row unscored(int of, const char *scene, const entry *e)
{
    row r = blank(of, scene, e->label, e->settings);
    r.method = e->method;
    for (int k = 0; k < 3; ++k) r.error[k] = r.bias[k] = (double)NAN;
    return r;
}

static int drawn(kit_image *out, stage *s, const entry *e, kit_error *err)
{
    kit_run run;
    if (run_open(&run, s, e->method, e->settings, s->radius, err)) return -1;
    kit_run_draw(&run, 0);
    if (kit_run_read(out, &run, err) || (s->lit && !run.lit && light_by(out, s, err))) return -1;
    kit_run_close(&run);
    return 0;
}

static void deep_about(FILE *html, const stage *s, const char *about)
{
    fprintf(html, "<p>%s %zu triangles, %d x %d pixels, radius %g. ", about, s->scene.mesh.triangles, s->frame.width,
            s->frame.height, (double)s->radius);
    fprintf(html,
            s->otherwise.kind == SCATTER ? "Truth: %d thousand samples%s.</p>\n" : "Truth: %d rays a pixel%s.</p>\n",
            s->rays, s->stride > 1 ? ", every second pixel of every second row" : "");
}

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

static int deep_figure(FILE *html, const char *out, const stage *s, const char *name, const char *label,
                       const char *note, const kit_image *from, int difference, kit_error *err)
{
    const double range = 0.3;
    kit_image shown, truth, coloured;
    char slug[160];
    snprintf(slug, sizeof slug, "deep-%s-", name);
    slug_of(slug + strlen(slug), label);
    if (s->lit
        && (exposed(&shown, from, s->lit->exposure, NULL, 1, err)
            || exposed(&truth, &s->truth, s->lit->exposure, NULL, 1, err)))
        return -1;
    if (save(s->lit ? &shown : from, s->lit ? "R,G,B" : "Y", s->lit != NULL, out, slug, ".png", err)) return -1;
    figure_html(html, slug, label, note, from->width, from->height, difference);
    if (difference) {
        if (kit_image_difference(&coloured, s->lit ? &shown : from, s->lit ? &truth : &s->truth, "Y", (float)range, err)
            || save(&coloured, "R,G,B", 0, out, slug, "-difference.png", err))
            return -1;
        kit_image_free(&coloured);
    } else key_html(html, range);
    fputs("</figure>\n", html);
    if (s->lit) { kit_image_free(&shown); kit_image_free(&truth); }
    return 0;
}

int deep_demo(FILE *html, const char *out, kit_error *err)
{
    deep_set *set = NULL;
    for (int k = 0; k < DEEP_DEMOS; ++k) {
        const deep_part *part = &deep_demos[k];
        const char *name = part->see.view.name;
        kit_image picture[MOST_ENTRIES];
        char note[64];
        stage s;
        int count;
        if (part->title) {
            set = set ? set + 1 : demo_sets;
            set->title = part->title;
            set->count = 0;
            fprintf(html, "<h2>%s</h2>\n", part->title);
        }
        row *rows = set->row + set->count;
        if (deep_load(&s, &part->see, err)) return -1;
        if (s.otherwise.kind == SCATTER) s.rays /= 2;
        if (stage_show(&s, &part->see.view, DEEP_WIDTH, DEEP_HEIGHT, err)) return -1;
        count = deep_measure(rows, &s, name, part->entries, part->count, 1, picture, err);
        if (count < 0) return -1;
        deep_about(html, &s, part->about);
        fputs("<div class=\"grid\">\n", html);
        snprintf(note, sizeof note, s.otherwise.kind == SCATTER ? "%d thousand samples" : "%d rays a pixel", s.rays);
        if (deep_figure(html, out, &s, name, s.otherwise.kind == SCATTER ? "dipole over samples" : "ray-traced truth",
                        note, &s.truth, 0, err))
            return -1;
        for (int i = 0; i < part->count; ++i) {
            snprintf(note, sizeof note, "time %.1f, error %.3f", rows[i].relative, rows[i].share);
            if (deep_figure(html, out, &s, name, rows[i].label, note, &picture[i], 1, err)) return -1;
            kit_image_free(&picture[i]);
        }
        fputs("</div>\n", html);
        set->count += count;
        stage_close(&s);
        if (k + 1 == DEEP_DEMOS || deep_demos[k + 1].title) table_html(html, set->row, set->count);
    }
    return 0;
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

/* Appends a table to the count rows that there are; how many there are then, -1 = failed. */
static int deep_table_of(FILE *html, const deep_table *t, const options *o, row *rows, int count, kit_error *err)
{
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int all = chosen(entries, t->entries, t->count, o);
    stage s;
    if (!all || (o->quick && !t->quick)) return count;
    if (!rows) return 1;
    if (deep_load(&s, &t->see, err)) return -1;
    if (s.otherwise.kind == SCATTER) s.rays *= 4;
    if (s.lit) s.stride = LIT_STRIDE;
    if (stage_show(&s, &t->see.view, DEEP_WIDTH, DEEP_HEIGHT, err)) return -1;
    const int more = deep_measure(rows + count, &s, t->see.view.name, entries, all,
                                  t->svg     ? QUICK_ROUNDS
                                  : o->quick ? 1
                                             : DEEP_ROUNDS,
                                  picture, err);
    if (more < 0) return -1;
    deep_about(html, &s, t->about);
    if (thumbs(html, o->out, &s, rows + count, picture, all, err)) return -1;
    for (int i = 0; i < all; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + more;
}

/* A picture of half the width and height brought to full size. */
static int doubled(kit_image *out, const kit_image *small, kit_error *err)
{
    if (kit_image_new(out, 2 * small->width, 2 * small->height, "Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) {                      /* 9 3 3 1 sixteenths */
                const int near_x = k & 1   ? 0
                                   : x % 2 ? 1
                                           : -1,
                          near_y = k & 2   ? 0
                                   : y % 2 ? 1
                                           : -1,
                          at_x = x / 2 + near_x, at_y = y / 2 + near_y;
                const int px = at_x < 0              ? 0
                               : at_x < small->width ? at_x
                                                     : small->width - 1,
                          py = at_y < 0               ? 0
                               : at_y < small->height ? at_y
                                                      : small->height - 1;
                sum += (k & 1 ? 0.75 : 0.25) * (k & 2 ? 0.75 : 0.25) * (double)small->data[py * small->width + px];
            }
            out->data[y * out->width + x] = (float)sum;
        }
    return 0;
}

static int full_sizes_of(FILE *html, int quick, row *rows, kit_error *err)
{
    int count = 0;
    static const deep_view see = BUNNY_AO;
    kit_run run[COUNT(deep_figure9)];
    stage s, half;
    if (deep_open(&s, &see, err)) return -1;
    half = s;
    kit_camera camera = s.gbuffer.camera;
    camera.width /= 2;
    camera.height /= 2;
    if (kit_gbuffer_from_scene(&half.gbuffer, &s.scene, &camera, NULL, err)) return -1;
    for (int i = 0; i < COUNT(deep_figure9); ++i) {
        const full *f = &deep_figure9[i];
        kit_image picture, whole;
        if (quick && !f->entry.quick) continue;
        row *r = &rows[count];
        *r = unscored(OF_DEEP, see.view.name, &f->entry);
        if (run_open(&run[count], f->half ? &half : &s, r->method, r->settings, s.radius, err)) return -1;
        kit_run_draw(&run[count], 1);
        if (kit_run_read(&picture, &run[count], err) || (f->half && doubled(&whole, &picture, err))
            || score(r, &s, f->half ? &whole : &picture, err))
            return -1;
        r->of = OF_DEEP;
        kit_image_free(&picture);
        if (f->half) kit_image_free(&whole);
        ++count;
    }
    if (clock_runs(rows, &s, run, count, quick ? 1 : DEEP_ROUNDS, err)) return -1;
    deep_about(html, &s,
               "The paper's figure 9: all reach as far; half sizes are brought to full size bilinearly, which is not "
               "in their times; their splats are of their own pixels.");
    kit_gbuffer_free(&half.gbuffer);
    stage_close(&s);
    return count;
}

/* Scores the ground beside the box alone, the same at each step. */
static int turns_of(FILE *html, int quick, row *rows, kit_error *err)
{
    static const char *const names[3] = { "irradiance.R", "irradiance.G", "irradiance.B" };
    const int steps = quick ? 5 : TURNS;
    int methods = 0;
    for (int k = 0; k < steps; ++k) {
        /* small steps where it leaves */
        const float to_go = 1 - (float)k / (float)(steps - 1), angle = turn_to + (turn_from - turn_to) * to_go * to_go,
                    a = angle * 0.0174532925f;
        deep_view see = { { "turn", "plane", 0, { 0 }, { 0 }, 30, 0.6f, &deep_white }, TURN_BOX, PLAINLY };
        kit_score none;
        stage s;
        memcpy(see.view.eye, turn_eye, sizeof turn_eye);
        see.view.target[0] = turn_eye[0] + 2.8f * sinf(a);
        see.view.target[2] = turn_eye[2] - 2.8f * cosf(a);
        if (deep_open(&s, &see, err)) return -1;
        float *mask = calloc((size_t)s.frame.width * (size_t)s.frame.height, sizeof *mask);
        const float *z = kit_image_channel(&s.frame, "Z");
        if (!mask) return kit_fail(err, "out of memory");
        for (int i = 0; i < s.frame.width * s.frame.height; ++i) {
            float p[3];
            if (!(z[i] > 0)) continue;
            kit_camera_point(&s.gbuffer.camera, i % s.frame.width, i / s.frame.width, (double)z[i], p);
            mask[i] = 1;
            for (int c = 0; c < 3; ++c) if (p[c] < ground_bounds[0][c] || p[c] > ground_bounds[1][c]) mask[i] = 0;
        }
        if (kit_score_channels(&none, &s.given[0].picture, &s.truth, names, 3, mask, err)) return -1;
        methods = 0;
        for (int m = 0; m < COUNT(deep_watched); ++m) {
            const entry *e = &deep_watched[m];
            kit_image picture;
            if (quick && !e->quick) continue;
            row *r = &rows[methods++ * steps + k];
            *r = unscored(OF_TURN, "turn", e);
            if (drawn(&picture, &s, e, err) || kit_score_channels(&r->score, &picture, &s.truth, names, 3, mask, err))
                return -1;
            r->figure[DEGREES] = r->relative = (double)(angle - turn_from);
            r->share = r->score.rmse / none.rmse;
            kit_image_free(&picture);
        }
        if (k + 1 == steps)
            deep_about(html, &s,
                       "A tall box on a plane leaves the picture while the camera turns to the right; the ground "
                       "beside it stays, and is what is scored. White light from everywhere.");
        free(mask);
        stage_close(&s);
    }
    return methods * steps;
}

/* What a picture holds at a place, between four pixels; 0 if the frame shows something else there. */
static int held(double *value, const kit_image *picture, const kit_image *frame, const kit_camera *camera,
                const float p[3])
{
    float to_view[16], projection[16];
    double v[3], at[2], sum = 0;
    const float *z = kit_image_channel(frame, "Z");
    kit_camera_matrices(camera, to_view, projection);
    for (int r = 0; r < 3; ++r)
        v[r] = (double)(to_view[r] * p[0] + to_view[4 + r] * p[1] + to_view[8 + r] * p[2] + to_view[12 + r]);
    if (!(v[2] < 0)) return 0;
    at[0] = (0.5 - 0.5 * (double)projection[0] * v[0] / v[2]) * frame->width - 0.5;
    at[1] = (0.5 + 0.5 * (double)projection[5] * v[1] / v[2]) * frame->height - 0.5;
    const int x = (int)floor(at[0]), y = (int)floor(at[1]);
    if (x < 0 || y < 0 || x + 1 >= frame->width || y + 1 >= frame->height) return 0;
    for (int k = 0; k < 4; ++k) {
        const int i = (y + (k >> 1)) * frame->width + x + (k & 1);
        if (!(fabs((double)z[i] + v[2]) < -0.02 * v[2])) return 0;
        sum += (k & 1 ? at[0] - x : 1 - at[0] + x) * (k & 2 ? at[1] - y : 1 - at[1] + y) * (double)picture->data[i];
    }
    *value = sum;
    return 1;
}

/* The places that frame 0 shows, in all frames: the truth's pictures first, then a method's, one after the other. */
static int motion_of(FILE *html, int quick, row *rows, kit_error *err)
{
    const int frames = quick ? 3 : MOST_FRAMES;
    const float step = 0.01f;
    static kit_image pictures[1 + COUNT(deep_moved)][MOST_FRAMES], frame[MOST_FRAMES];
    kit_camera camera[MOST_FRAMES];
    const entry *shown[COUNT(deep_moved)];
    double sum[1 + COUNT(deep_moved)] = { 0 };
    size_t places = 0;
    int methods = 0;
    for (int m = 0; m < COUNT(deep_moved); ++m) if (deep_moved[m].quick || !quick) shown[methods++] = &deep_moved[m];
    for (int k = 0; k < frames; ++k) {
        deep_view see = BUNNY_AO;
        stage s;
        see.view.eye[0] += step * (float)k;
        see.view.target[0] += step * (float)k;
        if (deep_open(&s, &see, err)) return -1;
        for (int m = 0; m < methods; ++m) if (drawn(&pictures[1 + m][k], &s, shown[m], err)) return -1;
        camera[k] = s.gbuffer.camera;
        pictures[0][k] = s.truth;
        frame[k] = s.frame;
        memset(&s.truth, 0, sizeof s.truth);
        memset(&s.frame, 0, sizeof s.frame);
        if (!k)
            fprintf(html,
                    "<p>Bunny on a floor, %d x %d pixels, radius %g. %d frames; camera and target move to the right by "
                    "%g each, about a pixel.</p>\n",
                    frame[0].width, frame[0].height, (double)s.radius, frames, (double)step);
        stage_close(&s);
    }
    for (int i = 0; i < frame[0].width * frame[0].height; ++i) {
        const float z = kit_image_channel(&frame[0], "Z")[i];
        double square[1 + COUNT(deep_moved)] = { 0 }, mean[1 + COUNT(deep_moved)] = { 0 };
        float p[3];
        int known = z > 0;
        kit_camera_point(&camera[0], i % frame[0].width, i / frame[0].width, (double)z, p);
        for (int k = 0; k < frames && known; ++k)
            for (int m = 0; m <= methods && known; ++m) {
                double v = 0;
                known = held(&v, &pictures[m][k], &frame[k], &camera[k], p);
                mean[m] += v / frames;
                square[m] += v * v;
            }
        if (!known) continue;
        for (int m = 0; m <= methods; ++m) sum[m] += fmax(0, square[m] - frames * mean[m] * mean[m]) / (frames - 1);
        ++places;
    }
    for (int m = 0; m < methods; ++m) {
        row *r = &rows[m];
        *r = unscored(OF_MOTION, "bunny-on-floor", shown[m]);
        r->score.pixels = places;
        r->figure[FLICKER] = sqrt(sum[1 + m] / (double)places);
        r->figure[FLICKER_TRUE] = sqrt(sum[0] / (double)places);
        r->figure[FLICKER_ADDED] = sqrt(fmax(0, sum[1 + m] - sum[0]) / (double)places);
    }
    for (int k = 0; k < frames; ++k) {
        kit_image_free(&frame[k]);
        for (int m = 0; m <= methods; ++m) kit_image_free(&pictures[m][k]);
    }
    return methods;
}

/* Times alone, no truth: entries on one picture. How many rows. */
static int deep_costs(row *rows, const deep_view *v, int width, int height, const entry *entries, int count, int of,
                      int rounds, kit_error *err)
{
    kit_run run[COUNT(deep_growth)];
    stage s;
    if (deep_load(&s, v, err) || stage_look(&s, &v->view, width, height, err)) return -1;
    for (int i = 0; i < count; ++i) {
        rows[i] = unscored(of, v->view.name, &entries[i]);
        rows[i].figure[PICTURE] = 1e-3 * s.frame.width * s.frame.height;
        if (run_open(&run[i], &s, entries[i].method, entries[i].settings, s.radius, err)) return -1;
        kit_run_draw(&run[i], 1);
    }
    if (clock_runs(rows, &s, run, count, rounds, err)) return -1;
    stage_close(&s);
    return count;
}

static int growth_of(int quick, row *rows, kit_error *err)
{
    int count = 0;
    static const deep_view see = BUNNY_AO;
    for (int i = 0; i < COUNT(deep_growth); ++i) {
        const growth *g = &deep_growth[i];
        const entry e = { g->label, "dss", g->settings, 1 };
        if (quick && !g->quick) continue;
        if (deep_costs(&rows[count++], &see, g->width, g->width * 9 / 16, &e, 1, OF_GROWTH, quick ? 1 : DEEP_ROUNDS,
                       err)
            < 0)
            return -1;
    }
    return count;
}

static const char *deep_title(int k)
{
    static const char *const titles[] = { "Deep screen space: full size, half size",
                                          "Deep screen space: the camera turns away",
                                          "Deep screen space: the camera moves",
                                          "Deep screen space: where the time goes",
                                          "Deep screen space: what costs grow with" };
    return k < DEEP_TABLES ? deep_tables[k].title : titles[k - DEEP_TABLES];
}

static int deep_unit(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    static const deep_view lights = WHOLE_LIGHT;
    int count = 0;
    if (rows) fprintf(html, "<h2>%s</h2>\n", deep_title(k));
    if (k < DEEP_TABLES) {
        for (int j = k; deep_tables[k].title && j < DEEP_TABLES && (j == k || !deep_tables[j].title) && count >= 0; ++j)
            count = deep_table_of(html, &deep_tables[j], o, rows, count, err);
        return count;
    }
    if (!asked(o, "dss") || (o->quick && k != TURN_SET && k != STAGE_SET)) return 0;
    if (!rows) return 1;
    if (k == STAGE_SET)
        fprintf(html,
                "<p>The paper's test: bunny, floor and four boxes, some 69,000 triangles, %d x %d pixels; surfels by "
                "tessellation, captured. Shares of one frame's time.</p>\n",
                PAPER_SIDE / thrift, PAPER_SIDE / thrift);
    if (k == GROWTH_SET) fputs("<p>Bunny on a floor; one thing grows at a time.</p>\n", html);
    return k == FULL_SET     ? full_sizes_of(html, o->quick, rows, err)
           : k == TURN_SET   ? turns_of(html, o->quick, rows, err)
           : k == MOTION_SET ? motion_of(html, o->quick, rows, err)
           : k == STAGE_SET  ? deep_costs(rows, &lights, PAPER_SIDE, PAPER_SIDE, deep_effects,
                                         o->quick ? 1 : COUNT(deep_effects), OF_STAGES, 1, err)
                             : growth_of(o->quick, rows, err);
}

int deep_units(const options *o) { return planned(deep_unit, DEEP_SETS, o); }

int deep_chart(FILE *html, const options *o, kit_error *err)
{
    int shown = 0;
    page csv;
    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < DEEP_SETS; ++k) {
        deep_set *set = &sets[k];
        const char *svg = k < DEEP_TABLES ? deep_tables[k].svg : k == TURN_SET ? "chart-deep-turn.svg" : NULL;
        set->title = deep_title(k);
        set->count = unit(html, o, "deep", k, deep_unit, set->row, err);
        if (set->count < 0) return -1;
        if (!set->count) continue;
        if (svg
            && chart_of(html, o->out, svg, set->title, k == TURN_SET ? &turn_words : &ao_words, set->row, set->count,
                        (double)NAN, err))
            return -1;
        table_html(html, set->row, set->count);
        table_csv(csv.file, set->row, set->count, !shown++);
    }
    return page_close(&csv, o->out, "chart-deep.csv", err);
}

static void text_of(FILE *f, const deep_set *set, int count)
{
    for (int k = 0; k < count; ++k) {
        if (!set[k].count) continue;
        fprintf(f, "\n%s\n", set[k].title);
        table_text(f, set[k].row, set[k].count);
    }
}

void deep_demo_text(FILE *f) { text_of(f, demo_sets, DEEP_DEMOS); }

void deep_chart_text(FILE *f) { text_of(f, sets, DEEP_SETS); }
