/* fields_demo.c - what report.c's demo shows of ambient occlusion fields: occluders that move, how many texels, inside
   of the hull. Declared in fields.h. */
#include <string.h>
#include "lab/chart/fields.h"
#include "lab/chart/fields_stage.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

static const entry moving_entries[]   = { AOF("casters", "resolution=8", 1) };
static const entry pedestal_entries[] = { AOF("4 x 4", "resolution=4", 1), AOF("8 x 8", "resolution=8", 1) };
static const entry sunk_entries[] = {
    AOF("A_0 as measured", "resolution=8", 1),
    AOF("A_0 = 1, p = 2", "resolution=8,inside=1,power=2", 1)
};

typedef struct field_part {
    const char *title, *about;
    setup setup;
    const entry *entries;
    int count, crop[MOST_CROPS][4];
} field_part;
#define MOVING(name, time) \
    { WHOLE(name, "casters"), NO_SPOTS, NO_BOXES, time, 128 }, WITH_COUNT(moving_entries), { { 0 } }
static const field_part field_parts[] = {
    { "Fields: occluders that move",
      "Cubes, balls, tori, cones and tables, one field a shape, of 8 x 8 texels a face. At rest,",
      MOVING("occluders-0", 0) },
    { NULL, "a third of a period later,", MOVING("occluders-1", 1 / 3.0) },
    { "Fields: how many texels",
      "The bunny on a box before a wall, its field of 4 x 4 and of 8 x 8 texels a face.",
      { { "pedestal", BUNNY, 0, { -1.9f, 0.9f, 4.3f }, { 0, -0.25f, 0 }, 34, 0, NULL },
        NO_SPOTS,
        { { -1.3f, -1.6f, -0.9f, 1.3f, -0.99f, 1.1f },
          { -5, -1.6f, -1.3f, 5, 3, -1.2f },
          { -5, -1.8f, -1.3f, 5, -1.6f, 6 } },
        0,
        256 },
      WITH_COUNT(pedestal_entries),
      { { 108, 114, 107, 54 }, { 70, 4, 107, 54 } } },
    { "Fields: inside of the hull",
      "A table and a torus, half of each in the ground: between a table's legs, and in a ring, there is ground inside "
      "of the convex hull, where occlusion goes to A_0.",
      { { "sunk", "casters", 0, { 0.6f, 2.6f, 3.6f }, { 0, 0, 0.1f }, 34, 0, NULL },
        { { "torus", 1.4f, { 1, 0.05f, 0.1f } }, { "table", 1.6f, { -0.7f, 0.02f, 0 } } },
        NO_BOXES,
        0,
        128 },
      WITH_COUNT(sunk_entries),
      { { 0 } } }
};
static const char *const demo_title = "Ambient occlusion fields";
enum { FIELD_PARTS = COUNT(field_parts),
    FIELD_DEMO_ROWS = 2 * COUNT(moving_entries) + COUNT(pedestal_entries) + COUNT(sunk_entries) };
static row demo_rows[FIELD_DEMO_ROWS];

/* What white light from everywhere leaves of the colours. */
static int dimmed(kit_image *out, const stage *s, const kit_image *visibility, kit_error *err)
{
    static const char *const names[3] = { "albedo.R", "albedo.G", "albedo.B" };
    const size_t pixels = (size_t)s->frame.width * (size_t)s->frame.height;
    if (kit_image_new(out, s->frame.width, s->frame.height, "R,G,B", err)) return -1;
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < pixels; ++i)
            out->data[c * pixels + i] = kit_image_channel(&s->frame, names[c])[i] * visibility->data[i];
    return 0;
}

enum { CROP_TIMES = 3, DEMO_WIDTH = 320, DEMO_HEIGHT = 180 };

/* One figure: the colours under white light, and the visibility's difference to the truth; without a row it is the
   truth. whole: what is shown. */
static int demo_figure(FILE *record, const char *out, kit_image *whole, const stage *s, pictured *p,
                       const kit_image *visibility, const row *r, kit_error *err)
{
    const double range = 0.2;
    char note[64];
    if (dimmed(whole, s, visibility, err) || pictures_save(whole, "R,G,B", 1, out, p->slug, ".png", err)) return -1;
    if (r) snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
    else snprintf(note, sizeof note, "%d rays a pixel", s->rays);
    if (r && pictures_difference(visibility, &s->truth, (float)range, out, p->slug, err)) return -1;
    page_figure(record, p->slug, p->label, note, whole->width, whole->height, r != NULL);
    if (!r) page_key(record, range);
    return 0;
}

/* The truth and the fields' pictures: whole, then in part. */
static int demo_figures(FILE *record, const char *out, const stage *s, const field_part *part, const row *all,
                        const kit_image *picture, kit_error *err)
{
    kit_image whole[1 + MOST_ENTRIES];
    pictured p[1 + MOST_ENTRIES];
    for (int i = 0; i <= part->count; ++i) {
        p[i].label = i ? all[i - 1].label : "ray-traced truth";
        p[i].picture = &whole[i];
        snprintf(p[i].slug, sizeof p[i].slug, "aof-%s-", part->setup.view.name);
        pictures_slug(p[i].slug + strlen(p[i].slug), i ? p[i].label : "truth");
        if (demo_figure(record, out, &whole[i], s, &p[i], i ? &picture[i - 1] : &s->truth, i ? &all[i - 1] : NULL, err))
            return -1;
    }
    for (int k = 0; k < MOST_CROPS && part->crop[k][2]; ++k)
        if (pictures_crops(record, out, p, part->count + 1, k, part->crop[k], 1, CROP_TIMES, err)) return -1;
    for (int i = 0; i <= part->count; ++i) kit_image_free(&whole[i]);
    return 0;
}

/* One part of the page; its rows, and one of no AO. */
static int demo_part(FILE *record, const char *out, const field_part *part, row *all, kit_error *err)
{
    kit_image picture[MOST_ENTRIES];
    stage s;
    if (fields_open(&s, &part->setup, DEMO_WIDTH, DEMO_HEIGHT, err)
        || fields_measure(all, &s, part->entries, part->count, picture, err))
        return -1;
    if (part->title) page_heading(record, 2, "%s", part->title);
    if (fields_about(record, &s, part->about, err) || demo_figures(record, out, &s, part, all, picture, err)) return -1;
    for (int i = 0; i < part->count; ++i) {
        all[i].scene = part->setup.view.name;
        kit_image_free(&picture[i]);
    }
    stage_close(&s);
    return 0;
}

int fields_demo(FILE *record, const char *out, kit_error *err)
{
    row *rows = demo_rows;
    for (int k = 0; k < FIELD_PARTS; ++k) {
        const field_part *part = &field_parts[k];
        row all[MOST_ENTRIES + 1];
        if (demo_part(record, out, part, all, err)) return -1;
        for (int i = 0; i < part->count; ++i) *rows++ = all[i];
        if (k + 1 < FIELD_PARTS && !field_parts[k + 1].title) continue;
        if (table_page(record, "rows", all, part->count + 1, err)) return -1;
    }
    return 0;
}

void fields_demo_text(FILE *f) { table_titled(f, demo_title, demo_rows, FIELD_DEMO_ROWS); }
