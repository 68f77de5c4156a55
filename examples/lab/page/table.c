/* table.c - writes rows as tables, with one list of columns for CSV and the page. Declared in table.h. */
#include "lab/page/table.h"
#include <math.h>
#include <string.h>
#include "kit/kit_gl.h"
#include "lab/measure/csv.h"
#include "lab/page/page.h"

/* ---- >>columns --------------------------------------------------------------------------------------------------- */

typedef struct column { int of; const char *head, *key, *about; size_t offset; int digits, sign; } column;
#define AT(member) offsetof(row, member)
static const column columns[] = {
    { OF_BAKE, "triangles", "triangles", "of the occluder", AT(figure[TRIANGLES]), 0, 0 },
    { OF_BAKE, "texels", "resolution", "along the side of a face of the cube map", AT(figure[RESOLUTION]), 0, 0 },
    { OF_BAKE, "radii", "radii", "distances sampled along each direction", AT(figure[RADII]), 0, 0 },
    { OF_BAKE, "rays", "rays", "a sample", AT(figure[BAKE_RAYS]), 0, 0 },
    { OF_BAKE, "threads", "threads", "of the bake", AT(figure[THREADS]), 0, 0 },
    { OF_FIELD | OF_BAKE, "kB", "kilobytes", "of all fields, 1000 bytes each", AT(figure[BYTES]), 1, 0 },
    { OF_BAKE, "work, MB", "work_megabytes", "memory of the bake, free again afterwards", AT(figure[WORK]), 1, 0 },
    { OF_FIELD | OF_BAKE, "bake, s", "bake_seconds", "the clock's, of all fields' bakes", AT(figure[SECONDS]), 2, 0 },
    { OF_FIELD | OF_BAKE, "b. median", "baked_median",
      "error of occlusion that the bake reports, at receivers that took no part in it: half are off by less; of "
      "several fields the worst", AT(figure[BAKED_MEDIAN]), 4, 0 },
    { OF_FIELD | OF_BAKE, "b. p95", "baked_p95", "the same: 95 % of them", AT(figure[BAKED_P95]), 4, 0 },
    { OF_FIELD | OF_BAKE, "b. most", "baked_most", "the same: all of them", AT(figure[BAKED_MOST]), 4, 0 },
    { OF_DEEP | OF_DEEP_LIT, "surfels", "surfels",
      "how many discs the triangles became", AT(figure[SURFELS]), 0, 0 },
    { OF_DEEP | OF_DEEP_LIT, "splats", "splat_pixels",
      "texels that splats cover at all levels, over the picture's pixels; predicted", AT(figure[SPLATS]), 1, 0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_FIELD | OF_DEEPS, "bytes", "bytes",
      "moved per pixel, all passes, each texel of a pass's inputs and outputs once", AT(bytes), 0, 0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_FIELD | OF_DEEPS, "time", "relative_time",
      "GL time relative to one unblurred 16-sample ssao", AT(relative), 2, 0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_FIELD | OF_DEEPS, "ms", "ms",
      "GL time, milliseconds", AT(ms), 1, 0 },
    { OF_FIELD, "median", "median", "half of the pixels are off by less", AT(figure[MEDIAN]), 4, 0 },
    { OF_AO | OF_FIELD | OF_DEEP, "RMSE", "rmse",
      "root mean square difference to the truth", AT(score.rmse), 4, 0 },
    { OF_AO | OF_FIELD | OF_DEEP, "share", "share", "RMSE over the RMSE of having no AO", AT(share), 3, 0 },
    { OF_PEER, "fitted", "share_fitted",
      "the share after the best fit of two numbers to this picture", AT(figure[FITTED]), 3, 0 },
    { OF_AO | OF_FIELD | OF_DEEP, "bias", "bias",
      "mean difference to the truth; below 0: too dark", AT(score.bias), 4, 1 },
    { OF_AO | OF_FIELD | OF_DEEP, "p95", "p95", "95 % of the pixels are off by less", AT(score.p95), 4, 0 },
    { OF_PHASES, "model", "model_error",
      "RMSE of the mean over the phases of the noise, less the noise that is left in it", AT(split[1]), 4, 0 },
    { OF_PHASES, "noise", "noise",
      "root of a pixel's variance over the phases of the noise, its mean over the pixels", AT(split[2]), 4, 0 },
    { OF_FIELD, "most", "most", "the worst pixel", AT(figure[MOST]), 3, 0 },
    { OF_LIT | OF_DEEP_LIT, "radiance", "radiance",
      "RMSE of outgoing radiance over the truth's mean", AT(error[0]), 4, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "radiance_bias",
      "mean difference of radiance over the truth's mean", AT(bias[0]), 4, 1 },
    { OF_LIT | OF_DEEP_LIT, "irradiance", "irradiance",
      "RMSE of irradiance over the truth's mean", AT(error[1]), 4, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "irradiance_bias",
      "mean difference of irradiance over the truth's mean", AT(bias[1]), 4, 1 },
    { OF_LIT | OF_DEEP_LIT, "bounce", "bounce", "RMSE of the bounce over the truth's mean bounce", AT(error[2]), 3, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "bounce_bias",
      "mean difference of the bounce over the truth's mean bounce", AT(bias[2]), 3, 1 },
    { OF_SPLIT, "irradiance", "irradiance_phases",
      "RMSE of irradiance over the truth's mean, over all phases of the noise", AT(split[0]), 4, 0 },
    { OF_SPLIT, "bias error", "irradiance_bias_error",
      "RMSE of the mean over the phases of the noise, less the noise that is left in it", AT(split[1]), 4, 0 },
    { OF_SPLIT, "noise", "irradiance_noise",
      "root of a pixel's variance over the phases of the noise, its mean over the pixels", AT(split[2]), 4, 0 },
    { OF_SPLIT, "hue, deg", "hue_degrees",
      "mean angle between the rgb of the mean picture and of the truth, weighted by the truth's luminance",
      AT(split[3]), 2, 0 },
    { OF_SPLIT, "in shade", "hue_in_shade_degrees",
      "the same over pixels that occluders keep 5 % or more of their light from", AT(split[4]), 2, 0 },
    { OF_AO | OF_LIT | OF_DEEP, "SSIM", "ssim",
      "structural similarity with the truth, 1 = the same", AT(score.ssim), 4, 0 }
};

/* Returns the next column after c (-1: the first) of one of these kinds; -1 past the last. Milliseconds of a software
   rasteriser are left out, as they would mislead. Columns without a head are in CSV alone. */
static int next_key(int c, int of)
{
    while (++c < COUNT(columns))
        if (columns[c].of & of && !(columns[c].offset == offsetof(row, ms) && kit_gl_is_software())) return c;
    return -1;
}

static double figure_of(const row *r, int c)
{
    double v;
    memcpy(&v, (const char *)r + columns[c].offset, sizeof v);
    return v;
}

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

void table_csv(FILE *f, const row *rows, int count, int head)
{
    /* all lit rows make one table, all rows of fields another, all rows of deep screen space a third */
    const int of = rows->of & OF_AO       ? OF_PHASES | (rows->of & (OF_AO | OF_PEER))
                   : rows->of & OF_FIELDS ? OF_FIELDS
                   : rows->of & OF_DEEPS  ? OF_DEEPS
                                          : OF_LIT | OF_SPLIT;
    if (head) {
        fputs("scene,label,method,settings", f);
        for (int c = -1; (c = next_key(c, of)) >= 0;) fprintf(f, ",%s", columns[c].key);
        fputs(",pixels\n", f);
    }
    for (int i = 0; i < count; ++i) {
        const char *const names[] = { rows[i].scene, rows[i].label, rows[i].method, rows[i].settings };
        for (int k = 0; k < 4; ++k) { if (k) fputc(',', f); csv_quote(f, names[k]); }
        for (int c = -1; (c = next_key(c, of)) >= 0;) csv_figure(f, ",%.6g", figure_of(&rows[i], c));
        fprintf(f, ",%zu\n", rows[i].score.pixels);
    }
}

int table_page(FILE *f, const char *kind, const row *rows, int count, kit_error *err)
{
    page own;
    if (page_open(&own, err)) return -1;
    table_csv(own.file, rows, count, 1);
    page_table(f, kind, &own);
    return 0;
}

void table_columns(FILE *f)
{
    fputs("{\"columns\":[", f);
    for (int c = 0; c < COUNT(columns); ++c)
        fprintf(f, "%s[\"%s\",\"%s\",\"%s\",%d,%d]", c ? ",\n" : "", columns[c].key,
                columns[c].head ? columns[c].head : "", columns[c].about, columns[c].digits, columns[c].sign);
    fputs("]},\n", f);
}
