/* report.c - prints results as text or JSON: scores, times, the plan. */
#include "render.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const group_names[GROUPS] = { "radiance", "irradiance", "bounce" };

static const char *const place_names[KIT_PLACES] = { "edge", "border", "interior" };

int render_score(result *r, const char *path, const kit_camera *camera, double radius, kit_error *err)
{
    static const char *const names[10] = {
        "Y", "R", "G", "B", "irradiance.R", "irradiance.G", "irradiance.B", "bounce.R", "bounce.G", "bounce.B"
    };
    kit_image reference, none = { 0 }, places = { 0 };
    int status = 0;
    const float *mask = kit_image_channel(&r->frame, "Z");
    if (kit_exr_read(&reference, path, err)) return -1;
    /* a reference may have grey as three equal channels R, G and B */
    for (int c = 0; c < reference.channels && !r->lit && !kit_image_channel(&reference, "Y"); ++c)
        if (!strcmp(reference.name[c], "R")) snprintf(reference.name[c], sizeof reference.name[c], "Y");
    for (int i = r->lit; i < (r->lit ? 10 : 1); ++i)
        if (!kit_image_channel(&reference, names[i]) || reference.width != r->picture.width
            || reference.height != r->picture.height) {
            kit_fail(err, "--score %s: must have channel %s and %dx%d pixels", path, names[i], r->picture.width,
                     r->picture.height);
            kit_image_free(&reference);
            return -1;
        }
    if (kit_image_new(&none, reference.width, reference.height, r->lit ? KIT_LIT_CHANNELS : "Y", err)
        || kit_image_places(&places, &r->frame, camera, (float)radius, err)) status = -1;
    if (!status && !r->lit) for (size_t i = 0; i < (size_t)none.width * (size_t)none.height; ++i) none.data[i] = 1.0f;
    for (int g = 0; g < (r->lit ? GROUPS : 1) && !status; ++g) {
        const char *const *channels = r->lit ? names + 1 + 3 * g : names;
        const int count = r->lit ? 3 : 1;
        kit_score nothing;
        status = kit_score_channels(&r->score[g], &r->picture, &reference, channels, count, mask, err)
                         || kit_score_channels(&nothing, &none, &reference, channels, count, mask, err)
                     ? -1
                     : 0;
        if (!status) r->nothing[g] = r->lit ? -nothing.bias : nothing.rmse;
        if (!status) status = kit_score_places(r->place[g], &r->picture, &reference, channels, count, &places, err);
    }
    kit_image_free(&places);
    kit_image_free(&none);
    kit_image_free(&reference);
    return status;
}

/* Returns the milliseconds in which back faces were drawn for a run. */
static double slabs_ms(const kit_run *run) { return run->gbuffer->slab_ms[0] + run->gbuffer->slab_ms[1]; }

/* ---- >>JSON ------------------------------------------------------------------------------------------------------ */

/* Prints a member of a JSON object; before is ", ", or "" for the first member. */
static void json_text(const char *before, const char *key, const char *value)
{
    printf("%s\"%s\": ", before, key);
    kit_json_string(stdout, value);
}

static void json_value(const char *before, const char *key, double value, int decimals)
{
    printf("%s\"%s\": ", before, key);
    kit_json_number(stdout, value, decimals);
}

static void json_choice(const ssgi_plan *plan, int wanted)
{
    char settings[256], text[320];
    const char *method = kit_plan_text(settings, plan, wanted);
    snprintf(text, sizeof text, "%s%s%s", method ? method : "nothing", method && *settings ? " " : "",
             method ? settings : "");
    json_value("{", "error", (double)plan->error, -6);
    if (plan->unoccluded > 0) json_value(", ", "relative", (double)(plan->error / plan->unoccluded), -6);
    json_value(", ", "cost", (double)plan->cost, -6);
    json_text(", ", "method", text);
}

static void json_plan(const options *o, const ssgi_plan *plan)
{
    printf(", \"plan\": ");
    json_choice(plan, o->planned - 1);
    json_text(", ", "cost_unit", o->plan_in_ms || !(o->plan[1] > 0) ? "ms" : "ssaos");
    json_value(", ", "meets", plan->meets, 0);
    json_text(", ", "why", plan->why);
    for (int k = 1; k < 3; ++k) {
        if ((k > 1 ? plan->dearer : plan->cheaper) < 0) continue;
        printf(", \"%s\": ", k > 1 ? "dearer" : "cheaper");
        json_choice(&plan[k], o->planned - 1);
        printf("}");
    }
    printf("}");
}

static void json_settings(const kit_method *m, const kit_run *run)
{
    kit_setting s;
    printf(", \"settings\": {");
    for (int i = 0; kit_method_setting(&s, m, i); ++i) {
        const int lacking = !strcmp(s.key, "normal") && !run->gbuffer->normal;
        json_value(i ? ", " : "", s.key, lacking ? 1 : s.value, -9);
    }
    printf("}");
    json_value(", ", "margin_pixels", run->margin, 0);
    json_text(", ", "context", kit_gl_name());
    if (!m->between) return;
    json_value(", ", "occluders", run->occluders, 0);
    json_value(", ", "field_bytes", (double)run->field_bytes, 0);
}

static void json_times(const result *r)
{
    json_value(", ", "frames", r->frames, 0);
    printf(", \"passes\": [");
    for (int i = 0; i < r->run->passes; ++i) {
        const ssgi_gl_desc *d = &r->run->pass[i].desc;
        json_text(i ? ", {" : "{", "pass", ssgi_gl_pass_name(d->pass));
        json_value(", ", "ms", r->ms[i], 4);
        printf("}");
    }
    printf("]");
    if (slabs_ms(r->run) > 0) json_value(", ", "slabs_ms", slabs_ms(r->run), 4);
}

/* Returns a group's error over that of no occlusion; for light, its error over the mean of the ground truth. */
static double share_of(const result *r, int g)
{
    return r->nothing[g] > 0 ? r->score[g].rmse / r->nothing[g] : 0;
}

/* Prints the score of a group, then those of its edges, border and interior. */
static void json_score(const result *r, int g)
{
    const kit_score *s = &r->score[g];
    printf(", \"%s\": {", !r->lit ? "score" : group_names[g]);
    json_value("", "rmse", s->rmse, 6);
    json_value(", ", "bias", s->bias, 6);
    json_value(", ", "p95", s->p95, 6);
    json_value(", ", "ssim", s->ssim, 6);
    json_value(", ", r->lit ? "mean" : "share", r->lit ? r->nothing[g] : share_of(r, g), 6);
    json_value(", ", "pixels", (double)s->pixels, 0);
    for (int k = 0; k < KIT_PLACES; ++k) {
        const kit_score_place *place = &r->place[g][k];
        printf(", \"%s\": {", place_names[k]);
        json_value("", "rmse", place->score.rmse, 6);
        json_value(", ", "bias", place->score.bias, 6);
        json_value(", ", "error_share", place->error, 6);
        json_value(", ", "pixel_share", place->area, 6);
        printf("}");
    }
    printf("}");
}

/* Prints the whole result as JSON. what: the method, or the option that replaced it. */
static void report_json(const options *o, const kit_method *m, const char *what, const result *r, double radius)
{
    json_text("{", "source", o->gbuffer ? o->gbuffer : o->scene);
    json_text(", ", "method", what);
    json_value(", ", "radius", radius, -9);
    json_value(", ", "width", r->picture.width, 0);
    json_value(", ", "height", r->picture.height, 0);
    if (r->plan) json_plan(o, r->plan);
    if (r->run) json_settings(m, r->run);
    if (o->time && r->run) json_times(r);
    for (int g = 0; g < (r->lit ? GROUPS : 1) && o->score; ++g) json_score(r, g);
    printf("}\n");
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void text_times(const result *r)
{
    double sum = 0;
    for (int i = 0; i < r->run->passes; ++i) {
        printf("%-8s %9.3f ms\n", ssgi_gl_pass_name(r->run->pass[i].desc.pass), r->ms[i]);
        sum += r->ms[i];
    }
    if (r->run->surfels) {
        const double pixels = (double)r->picture.width * r->picture.height;
        printf("surfels   %zu, whose splats cover %.1f texels a pixel of the picture, by level:", r->run->surfels,
               r->run->splat_pixels / pixels);
        for (int l = 0; l < SSGI_SPLAT_LEVELS && r->run->level_pixels[l] > 0; ++l)
            printf(" %.1f", r->run->level_pixels[l] / pixels);
        puts("");
    }
    if (slabs_ms(r->run) > 0)
        printf("%-8s %9.3f ms: the scene's back faces, not in the sum\n", "slabs", slabs_ms(r->run));
    if (r->run->margin)
        printf("margin   %d pixels on each side: a G-buffer of %dx%d\n", r->run->margin, r->run->wide.width,
               r->run->wide.height);
    printf("%-8s %9.3f ms; medians of %d frames, %dx%d, %s\n", "all", sum, r->frames, r->picture.width,
           r->picture.height, kit_gl_name());
}

static void text_score(const options *o, const char *what, const result *r, int g)
{
    const kit_score *s = &r->score[g];
    printf("%s against %s", what, o->score);
    if (r->lit)
        printf(", %s: RMSE %.5f (%.3f of its mean %.5f)", group_names[g], s->rmse, share_of(r, g), r->nothing[g]);
    else printf(": RMSE %.5f (%.3f of no AO's)", s->rmse, share_of(r, g));
    printf(", bias %+.5f, p95 %.5f, SSIM %.4f over %zu pixels\n", s->bias, s->p95, s->ssim, s->pixels);
    for (int k = 0; k < KIT_PLACES; ++k) {
        const kit_score_place *place = &r->place[g][k];
        printf("  %-8s RMSE %.5f, bias %+.5f, %.3f of the squared error on %.3f of the pixels\n", place_names[k],
               place->score.rmse, place->score.bias, place->error, place->area);
    }
}

static void report_text(const options *o, const char *what, const result *r)
{
    if (o->time && r->run) text_times(r);
    for (int g = 0; g < (r->lit ? GROUPS : 1) && o->score; ++g) text_score(o, what, r, g);
}

void render_report(const options *o, const kit_method *m, const result *r, double radius)
{
    const char *what = o->truth                                          ? "truth"
                       : o->floor                                        ? "floor"
                       : r->plan && r->plan->method == SSGI_PLAN_METHOD_NOTHING ? "nothing"
                                                                         : m->name;
    if (o->json) report_json(o, m, what, r, radius); else report_text(o, what, r);
}
