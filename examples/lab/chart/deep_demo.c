/* deep_demo.c - what report.c's demo shows of deep screen space: its effects beside screen space and the truth.
   Declared in deep.h. */
#include <string.h>
#include "lab/chart/deep.h"
#include "lab/chart/deep_stage.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

static const entry deep_two[]     = { { "hsao", "hsao", "", 1 }, { "dss", "dss", "", 1 } };
static const entry deep_lit[]     = { { "dss-lit", "dss-lit", "size=0.03", 1 } };
static const entry deep_mirror[]  = { { "dss-gloss", "dss-gloss", "exponent=8", 1 } };
static const entry deep_beside[]  = { { "hsao", "hsao", "", 1 }, { "dss", "dss", COARSE, 1 } };
static const entry deep_under[]   = { { "dss-scatter", "dss-scatter", MARBLE, 1 } };

typedef struct deep_part { const char *title, *about; deep_view see; const entry *entries; int count; } deep_part;
static const deep_part deep_demos[] = {
    { "Deep screen space: ambient occlusion",
      "Discs of all triangles, seen or not, take from the ambient light of the pixels around them. Bunny on a floor.",
      BUNNY_AO, WITH_COUNT(deep_two) },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce; all within the radius counts whole. Surfels of 0.03.",
      WHOLE_LIGHT, WITH_COUNT(deep_lit) },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, met by a lobe of exponent 8. Nothing here does that in screen space.", LOBE,
      WITH_COUNT(deep_mirror) },
    { "Deep screen space: scattering under the surface",
      "A bunny of marble, 4 cm high, lit from behind. Nothing here does that in screen space. Truth: the dipole over "
      "samples on all of the mesh.",
      OF_MARBLE, WITH_COUNT(deep_under) },
    { "Deep screen space: what the picture does not show",
      "Beside the picture: along its left side stands a wall, off the picture.",
      { { "off-screen", "plane", 0, { 0.15f, 0.9f, 2 }, { 1.2f, 0.1f, 0 }, 30, 0.6f, NULL },
        { { -0.2f, 0.001f, -4, 0, 1, 1.5f } },
        PLAINLY },
      WITH_COUNT(deep_beside) },
    { NULL,
      "Hidden: a box behind a screen.",
      { { "hidden", "plane", 0, { 0, 1, 4 }, { 0.15f, 0.15f, 0 }, 26, 0.6f, NULL },
        { { -0.75f, 0.001f, -0.4f, -0.02f, 0.6f, 0.2f }, { -1.2f, 0.001f, 1.2f, 0, 0.75f, 1.24f } },
        PLAINLY },
      WITH_COUNT(deep_beside) },
    { NULL,
      "At grazing angle: of a box the side that occludes is seen edge-on.",
      { { "grazing", "plane", 0, { 0, 0.45f, 3.2f }, { 0.1f, 0.3f, 0 }, 24, 0.6f, NULL },
        { { -0.6f, 0.001f, -0.8f, 0, 0.7f, 0.4f } },
        PLAINLY },
      WITH_COUNT(deep_beside) }
};
enum { DEEP_DEMOS = COUNT(deep_demos) };
static deep_set demo_sets[DEEP_DEMOS];

/* A picture, exposed where it is of light, and its difference to the truth; or the truth itself. */
static int deep_figure(FILE *record, const char *out, const stage *s, const char *name, const char *label,
                       const char *note, const kit_image *from, kit_error *err)
{
    const double range = 0.3;
    const int is_truth = from == &s->truth;
    kit_image shown = *from, truth = s->truth;
    char slug[160];
    snprintf(slug, sizeof slug, "deep-%s-", name);
    pictures_slug(slug + strlen(slug), label);
    if (s->lit
        && (pictures_exposed(&shown, from, s->lit->exposure, NULL, 1, err)
            || pictures_exposed(&truth, &s->truth, s->lit->exposure, NULL, 1, err)))
        return -1;
    if (pictures_save(&shown, s->lit ? "R,G,B" : "Y", s->lit != NULL, out, slug, ".png", err)) return -1;
    page_figure(record, slug, label, note, from->width, from->height, !is_truth);
    if (is_truth) page_key(record, range);
    else if (pictures_difference(&shown, &truth, (float)range, out, slug, err)) return -1;
    if (s->lit) { kit_image_free(&shown); kit_image_free(&truth); }
    return 0;
}

/* One part: its pictures, and its rows behind those that the set has. */
static int deep_part_of(FILE *record, const char *out, const deep_part *part, deep_set *set, kit_error *err)
{
    const char *name = part->see.view.name;
    row *rows = set->row + set->count;
    kit_image picture[MOST_ENTRIES];
    char note[64];
    stage s;
    if (deep_load(&s, &part->see, err)) return -1;
    const int scatters = s.otherwise.kind == SCATTER;
    if (scatters) s.rays /= 2;
    if (stage_show(&s, &part->see.view, DEEP_WIDTH, DEEP_HEIGHT, err)) return -1;
    const int count = deep_measure(rows, &s, name, part->entries, part->count, 1, picture, err);
    if (count < 0) return -1;
    deep_about(record, &s, part->about);
    snprintf(note, sizeof note, scatters ? "%d thousand samples" : "%d rays a pixel", s.rays);
    if (deep_figure(record, out, &s, name, scatters ? "dipole over samples" : "ray-traced truth", note, &s.truth, err))
        return -1;
    for (int i = 0; i < part->count; ++i) {
        snprintf(note, sizeof note, "time %.1f, error %.3f", rows[i].relative, rows[i].share);
        if (deep_figure(record, out, &s, name, rows[i].label, note, &picture[i], err)) return -1;
        kit_image_free(&picture[i]);
    }
    set->count += count;
    stage_close(&s);
    return 0;
}

int deep_demo(FILE *record, const char *out, kit_error *err)
{
    deep_set *set = NULL;
    for (int k = 0; k < DEEP_DEMOS; ++k) {
        const deep_part *part = &deep_demos[k];
        if (part->title) {
            set = set ? set + 1 : demo_sets;
            set->title = part->title;
            set->count = 0;
            page_heading(record, 2, "%s", part->title);
        }
        if (deep_part_of(record, out, part, set, err)) return -1;
        if (k + 1 == DEEP_DEMOS || deep_demos[k + 1].title)
            if (table_page(record, "rows", set->row, set->count, err)) return -1;
    }
    return 0;
}

void deep_demo_text(FILE *f)
{
    for (int k = 0; k < DEEP_DEMOS; ++k) table_titled(f, demo_sets[k].title, demo_sets[k].row, demo_sets[k].count);
}
