/* lit.c - what report.c shows of light: pictures for the demo, a chart, and what layers, cameras and points buy. Included by report.c, which opens stages and
   measures them. */

/* ---- >>tables ------------------------------------------------------------------------------------------------------ */

static const lit sun_and_sky = { "sky", "sun:-1,0.45,0.85,4.4,3.9,3.3", 4, 384, 0.4f, { 450, 194, 192, 108 } };
static const lit sky_boxes   = { "sky", NULL, 4, 1024, 1, { 0 } };
static const lit sky_alone   = { "sky", NULL, 0, 1024, 1, { 0 } };
static const lit lamp        = { NULL, "point:0,5,-2.8,10,10,10", 0, 128, 2, { 172, 225, 192, 108 } };

#define BOXES_VIEW "bunny", BUNNY, 1, { -0.1f, 1.1f, 4.4f }, { 0, -0.25f, 0 }, 32, 0.6f

static const entry sun_entries[] = {
    { "SSAO",             "ssao", "",            1 },
    { "SSDO",             "ssdo", "bounce=none", 1 },
    { "SSDO with bounce", "ssdo", "",            1 },
    { "SSDO with bounce, 4 cameras", "ssdo", "views=4", 1 }
};
static const entry lamp_entries[] = {
    { "no bounce", "ssdo", "bounce=none", 1 },
    { "bounce",    "ssdo", "",            1 }
};

static const entry deep_entries[] = {       /* rows of one label make one curve */
    { "1 layer",             "ssdo", "samples=8",                                   0 },
    { "1 layer",             "ssdo", "",                                            1 },
    { "1 layer",             "ssdo", "samples=32",                                  0 },
    { "1 layer",             "ssdo", "samples=64",                                  1 },
    { "2 layers",            "ssdo", "samples=8,layers=2",                          0 },
    { "2 layers",            "ssdo", "layers=2",                                    1 },
    { "2 layers",            "ssdo", "samples=32,layers=2",                         0 },
    { "2 layers",            "ssdo", "samples=64,layers=2",                         1 },
    { "4 cameras",           "ssdo", "samples=8,views=4",                           0 },
    { "4 cameras",           "ssdo", "views=4",                                     1 },
    { "4 cameras",           "ssdo", "samples=32,views=4",                          0 },
    { "4 cameras",           "ssdo", "samples=64,views=4",                          1 },
    { "2 layers, 4 cameras", "ssdo", "layers=2,views=4,view_layers=2",              0 },
    { "2 layers, 4 cameras", "ssdo", "samples=64,layers=2,views=4,view_layers=2",   0 }
};
static const entry extension_entries[] = {
    { "1 layer",                             "ssdo", "",                               1 },
    { "2 layers",                            "ssdo", "layers=2",                       1 },
    { "4 layers",                            "ssdo", "layers=4",                       1 },
    { "4 cameras",                           "ssdo", "views=4",                        1 },
    { "2 layers, 4 cameras of 2 layers",     "ssdo", "layers=2,views=4,view_layers=2", 1 },
    { "1 layer, 4 points a direction",       "ssdo", "steps=4",                        1 },
    { "4 layers, 4 points a direction",      "ssdo", "layers=4,steps=4",               1 }
};
static const entry cost_entries[] = {
    { "ambient visibility",                "ssao", "blur=0",                           1 },
    { "harmonics",                         "ssdo", "environment=sh,bounce=none,blur=0", 1 },
    { "map",                               "ssdo", "bounce=none,blur=0",               1 },
    { "map, bounce, of the last frame",    "ssdo", "reuse=1,blur=0",                   1 },
    { "harmonics, bounce, of the last frame", "ssdo", "environment=sh,reuse=1,blur=0", 1 }
};

typedef struct lit_table { const char *title, *about; view view; const entry *entries; int count; } lit_table;
static const lit_table lit_demos[] = {
    { "Light: a sky and a sun", "Bunny and four boxes under the built-in sky and a sun with shadows.", { BOXES_VIEW, &sun_and_sky }, sun_entries, COUNT(sun_entries) },
    { "Light: one lamp, one bounce", "Open box under a point light with shadows, no environment.", { "cornell", "cornell", 0, { 0 }, { 0 }, 0, 0, &lamp }, lamp_entries, COUNT(lamp_entries) }
};
static const lit_table lit_tables[] = {
    { "Light: speed against accuracy", "Bunny and four boxes under the sky, one bounce.", { BOXES_VIEW, &sky_boxes }, deep_entries, COUNT(deep_entries) },
    { "What light costs", "The same scene; 16 directions, no filter.", { BOXES_VIEW, &sky_boxes }, cost_entries, COUNT(cost_entries) },
    { "What is hidden: columns", "Made to need more than one depth layer: coloured columns behind white ones, a box beside the picture.", { "columns", "columns", 0, { 0 }, { 0 }, 0, 0, &sky_alone }, extension_entries, COUNT(extension_entries) },
    { "What is hidden: plates", "Made to need more: thin plates, bars and hoops over a floor.", { "plates", "plates", 0, { 0 }, { 0 }, 0, 0, &sky_alone }, extension_entries, COUNT(extension_entries) },
    { "What is hidden: room", "Not made for it: its walls, floor and ceiling are sheets, where layers and cameras want closed solids, and cameras stand outside.", { "room", "room", 0, { 0 }, { 0 }, 0, 0, &sky_alone }, extension_entries, COUNT(extension_entries) }
};
enum { LIT_DEMOS = COUNT(lit_demos), LIT_TABLES = COUNT(lit_tables) };
typedef struct lit_row_set { row row[MOST_ROWS]; int count; } lit_row_set;

/* ---- >>pages ------------------------------------------------------------------------------------------------------- */

/* The part of a picture in crop (NULL: all), each pixel times x times: exposed R, G, B and their luminance Y. */
static int exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times, kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    static const float weight[3] = { 0.2126f, 0.7152f, 0.0722f };
    const int all[4] = { 0, 0, picture->width, picture->height };
    size_t i = 0;
    if (!crop) crop = all;
    if (kit_image_new(out, crop[2] * times, crop[3] * times, "R,G,B,Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x, ++i)
            for (size_t c = 0; c < 3; ++c) {
                const float v = exposure * kit_image_channel(picture, names[c])[(size_t)(crop[1] + y / times) * (size_t)picture->width + (size_t)(crop[0] + x / times)];
                out->data[c * (size_t)out->width * (size_t)out->height + i] = v;
                out->data[3 * (size_t)out->width * (size_t)out->height + i] += weight[c] * v;
            }
    return 0;
}

/* What stands under a heading: scene, radius, resolution, truth, and how far the truth itself is off, by tracing some of it with more rays. */
static int lit_about(FILE *html, stage *s, const lit_table *t, kit_error *err)
{
    kit_image probe;
    row noise;
    memset(&noise, 0, sizeof noise);
    if (trace(&probe, s, 4 * s->lit->rays, 23, err) || score(&noise, s, &probe, err)) return -1;
    kit_image_free(&probe);
    fprintf(html, "<h2>%s</h2>\n<p>%s %zu triangles, %d x %d pixels, radius %g, linear attenuation. Truth: %d rays a pixel; its own error, over the means: radiance %.4f, irradiance %.4f, bounce %.3f.</p>\n",
            t->title, t->about, s->scene.mesh.triangles, s->truth.width, s->truth.height, (double)s->radius, s->lit->rays, noise.error[0], noise.error[1], noise.error[2]);
    return 0;
}

static int lit_demo(FILE *html, const char *out, const lit_table *t, row *rows, int *count, kit_error *err)
{
    enum { TIMES = 3 };
    const double range = 0.2;
    kit_image picture[MOST_ROWS], whole, part, luminance, difference;
    stage s;
    page crops;
    char slug[128], note[64];
    if (stage_open(&s, &t->view, 720, 405, err) || measure(rows, &s, t->entries, t->count, QUICK_ROUNDS, picture, err) || lit_about(html, &s, t, err) || page_open(&crops, err)) return -1;
    *count = t->count + s.givens;
    fprintf(html, "<p>Exposure %g, clamped at 1, sRGB; the environment itself is not drawn. Differences are of exposed luminance.</p>\n<div class=\"grid\">\n", (double)s.lit->exposure);
    if (exposed(&luminance, &s.truth, s.lit->exposure, NULL, 1, err)) return -1;
    for (int i = -1; i < *count; ++i) {             /* the truth, what is given, methods */
        const int at = i < s.givens ? t->count + i : i - s.givens;
        const kit_image *from = i < 0 ? &s.truth : i < s.givens ? &s.given[i].picture : &picture[at];
        const char *label = i < 0 ? "ray-traced truth" : rows[at].label;
        if (exposed(&whole, from, s.lit->exposure, NULL, 1, err) || exposed(&part, from, s.lit->exposure, s.lit->crop, TIMES, err)) return -1;
        snprintf(slug, sizeof slug, "lit-%s-", t->view.name);
        slug_of(slug + strlen(slug), label);
        if (i < 0) snprintf(note, sizeof note, "%d rays a pixel", s.lit->rays);
        else if (isnan(rows[at].relative)) snprintf(note, sizeof note, "error %.3f", rows[at].share);
        else snprintf(note, sizeof note, "time %.2f, error %.3f", rows[at].relative, rows[at].share);
        if (save(&whole, "R,G,B", 1, out, slug, ".png", err) || save(&part, "R,G,B", 1, out, slug, "-crop.png", err)) return -1;
        figure_html(html, slug, label, note, whole.width, whole.height, i >= 0);
        if (i < 0) key_html(html, range);
        fputs("</figure>\n", html);
        if (i >= 0) {
            if (kit_image_difference(&difference, &whole, &luminance, "Y", (float)range, err) || save(&difference, "R,G,B", 0, out, slug, "-difference.png", err)) return -1;
            kit_image_free(&difference);
        }
        strcat(slug, "-crop");
        figure_html(crops.file, slug, label, "", part.width, part.height, 0);
        fputs("</figure>\n", crops.file);
        kit_image_free(&whole);
        kit_image_free(&part);
    }
    fflush(crops.file);
    fputs("</div>\n<div class=\"grid crops\">\n", html);
    fwrite(crops.text, 1, crops.size, html);
    fprintf(html, "</div>\n<p class=\"faint\">%d x %d pixels of each, from %d, %d on, every pixel as %d x %d.</p>\n<h3>Figures</h3>\n", s.lit->crop[2], s.lit->crop[3], s.lit->crop[0], s.lit->crop[1], TIMES, TIMES);
    fclose(crops.file);
    free(crops.text);
    table_html(html, rows, *count);
    for (int i = 0; i < t->count; ++i) kit_image_free(&picture[i]);
    for (int i = 0; i < *count; ++i) rows[i].scene = t->view.name;
    kit_image_free(&luminance);
    stage_close(&s);
    return 0;
}

static int lit_chart(FILE *html, const options *o, lit_row_set *sets, kit_error *err)
{
    stage s;
    page csv;
    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < LIT_TABLES; ++k) {
        const lit_table *t = &lit_tables[k];
        entry entries[MOST_ENTRIES];
        lit_row_set *set = &sets[k];
        int count = 0;
        for (int i = 0; i < t->count; ++i) if (t->entries[i].quick || !o->quick) entries[count++] = t->entries[i];
        if (stage_open(&s, &t->view, 640, 360, err) || measure(set->row, &s, entries, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS, NULL, err) || lit_about(html, &s, t, err)) return -1;
        set->count = count + s.givens;
        stage_close(&s);
        for (int i = 0; i < set->count; ++i) set->row[i].scene = t->view.name;
        if (!k && chart_of(html, o->out, "chart-lit.svg", t->title, set->row, set->count, (double)NAN, err)) return -1;
        table_html(html, set->row, set->count);
        table_csv(csv.file, set->row, set->count, !k);
    }
    return page_close(&csv, o->out, "chart-lit.csv", err);
}
