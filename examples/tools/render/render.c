/* render.c - renders one picture of a scene, or of a captured frame, with one method; the truth of it; scores and
   times.

      build/render SCENE.obj --method hsao --radius 0.5 --out ao.exr
      build/render room --truth 256 --out truth.exr
      build/render room --method hsao --set steps=8,blur=1 --score truth.exr --time 20
      build/render --gbuffer frame.exr --fovy 60 --radius 1 --out ao.png
      build/render cornell --method ssdo --light point:0,5,-2.8,20,20,20 --out lit.png
      build/render SCENE.obj --method ssdo --env probe.hdr --set layers=2 --out lit.exr
      build/render SCENE.obj --plan visibility:0.03 --out ao.exr
      build/render room --set history=1 --frames 16 --orbit 0.2 --out frames/%04d.exr
      build/render --help | --list | --list hsao

   Bad input: one line on stderr that names it, status 2, nothing written; of --sequence and --frames each picture is
   written as it is drawn, once the list and all of its frames have been read. */
#include "kit/kit_gl.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char usage[] =
    "usage: render SCENE.obj | NAME | --gbuffer FRAME.exr   [options]\n"
    "  render SCENE.obj --method hsao --radius 0.5 --out ao.png\n"
    "  render room --truth 256 --out truth.exr\n"
    "  render room --method hsao --set steps=8,blur=1 --score truth.exr --time 20\n"
    "  render cornell --method ssdo --light point:0,5,-2.8,20,20,20 --out lit.png\n"
    "  render --gbuffer frame.exr --fovy 60 --radius 1 --out ao.png\n"
    "  render --list | --list hsao\n"
    "what to draw\n"
    "  --gbuffer F.exr       a captured frame: Z (view depth > 0), N.X N.Y N.Z (view space); perhaps albedo.R ..,\n"
    "                        direct.R .., farther depth layers layer1.Z ..; back.Z, front2.Z, back2.Z (behind=);\n"
    "                        --camera tells where it was taken\n"
    "  --camera ex,ey,ez,tx,ty,tz  --up x,y,z  --near N  --far F  --size WxH\n"
    "  --fovy DEGREES | --ortho-height UNITS\n"
    "  --ground              a square under the mesh\n"
    "  --env F.exr | F.hdr | sky | probe | windows | street | white     radiance, latitude-longitude; lit methods\n"
    "  --light point:x,y,z,r,g,b | sun:x,y,z,r,g,b   radiant intensity; way to the sun, irradiance facing it; up to "
    "16\n"
    "  --sequence FRAMES.txt  a line a frame: FRAME.exr ex,ey,ez,tx,ty,tz[,ux,uy,uz]; perhaps with motion.X motion.Y,\n"
    "                        pixels from where a point was in the frame before, +y down; --out has a %04d. All are\n"
    "                        read, and must have one size and the same channels, before the first picture is written\n"
    "  --frames N --orbit DEGREES   of a scene: so many pictures, so far apart about the target; each is written as\n"
    "                        it is drawn, and those before it stay where one cannot be\n"
    "  --slide X,Y,Z         --frames: the first object that casts moves so far a frame, world units\n"
    "how\n"
    "  --method NAME         [hsao]; --list names all, --list NAME the settings of one with their defaults\n"
    "  --set key=value,..    settings of the method\n"
    "  --radius R            farthest occluder, scene units   [the scene's own]\n"
    "  --plan WHAT:ERROR[:BUDGET]   visibility, light, bounce or objects (occlusion between them): the cheapest\n"
    "                        method that is predicted to err by ERROR; BUDGET in 16-sample ssaos\n"
    "  --truth RAYS          the ray-traced reference of --method's quantity (dss-scatter: thousands of samples)\n"
    "  --floor RAYS          the exact answer from the depth buffer instead of a method\n"
    "  --context osmesa | egl | egl-es   [osmesa]\n"
    "what comes out\n"
    "  --out F.exr | F.png   Y = ambient visibility; lit: R G B, irradiance.R .., bounce.R .. (PNG: R G B, sRGB)\n"
    "  --score REF.exr       RMSE, bias, p95 and SSIM against a reference; then edges (within 3 pixels of a jump in\n"
    "                        depth), border (nearer to it than the radius is long) and interior apart\n"
    "  --time N              median GL time of each pass over N frames\n"
    "  --save-gbuffer F.exr  the G-buffer, as --gbuffer takes it\n"
    "  --json                machine-readable\n";

typedef struct options {
    const char *scene, *gbuffer, *method, *set[32], *score, *out, *save, *context, *env, *light[KIT_MAX_LIGHTS];
    const char *listed, *sequence;
    int frames, sets, lights, ground, planned, list, help, json, truth, floor, time, has_camera, has_up;
    float camera[6], up[3], slide[3];
    double fovy, ortho_height, znear, zfar, radius, plan[2], orbit;
    int width, height;
} options;

static int fail(const char *text)
{
    fprintf(stderr, "render: %s\n", text);
    return 2;
}

/* Numbers of the world; beyond that floats leave no room to compute with them. */
static int numbers(const char *name, const char *text, float *out, int count, kit_error *err)
{
    const float most = 1e12f;
    float v[9];
    const char *at = text;
    for (int i = 0; i < count; ++i) {
        char *end;
        v[i] = strtof(at, &end);
        if (end == at || *end != (i + 1 < count ? ',' : 0))
            return kit_fail(err, "%s %s: must be %d numbers with commas between", name, text, count);
        if (!(fabsf(v[i]) <= most))
            return kit_fail(err, "%s %s: its numbers must be in -%g..%g", name, text, (double)most, (double)most);
        at = end + 1;
    }
    memcpy(out, v, (size_t)count * sizeof *v);
    return 0;
}

static int number(const char *name, const char *text, double least, double most, double *out, kit_error *err)
{
    char *end;
    double v = strtod(text, &end);
    if (end == text || *end || !(v >= least && v <= most))
        return kit_fail(err, "%s %s: must be a number in %g..%g", name, text, least, most);
    *out = v;
    return 0;
}

static int whole(const char *name, const char *text, int least, int most, int *out, kit_error *err)
{
    double v;
    if (number(name, text, least, most, &v, err)) return -1;
    if (v != floor(v)) return kit_fail(err, "%s %s: must be a whole number", name, text);
    *out = (int)v;
    return 0;
}

static int plan_of(options *o, const char *text, kit_error *err)
{
    static const char *const wanted[] = { "visibility:", "light:", "bounce:", "objects:" };
    enum { WANTED = (int)(sizeof wanted / sizeof *wanted) };
    char *end;
    for (o->planned = 0; o->planned < WANTED; ++o->planned) {
        const size_t n = strlen(wanted[o->planned]);
        if (strncmp(text, wanted[o->planned], n)) continue;
        o->plan[0] = strtod(text + n, &end);
        if (end == text + n || !(o->plan[0] >= 0 && o->plan[0] < 1e6) || (*end && *end != ':')) break;
        const char *budget = *end ? end + 1 : "0";
        o->plan[1] = strtod(budget, &end);
        if (end == budget || *end || !(o->plan[1] >= 0 && o->plan[1] < 1e6)) break;
        ++o->planned;
        return 0;
    }
    return kit_fail(err, "--plan %s: must be visibility:ERROR, light:ERROR, bounce:ERROR or objects:ERROR, perhaps "
                         ":BUDGET behind", text);
}

/* Of light, which the planned method may bring by ambient visibility. */
static int plans_light(const options *o)
{
    return o->planned - 1 == SSGI_PLAN_LIGHT || o->planned - 1 == SSGI_PLAN_BOUNCE;
}

/* The number that a text begins with, of digits alone; 0: there is none, or it is above most. */
static int digits(const char **at, int most)
{
    int v = 0;
    for (; **at >= '0' && **at <= '9'; ++*at) v = v > most ? v : 10 * v + (**at - '0');
    return v > most ? 0 : v;
}

/* "WxH" */
static int size_of(options *o, const char *text, kit_error *err)
{
    const char *at = text;
    const int width = digits(&at, 16384), cross = *at == 'x', height = cross ? (++at, digits(&at, 16384)) : 0;
    if (!width || !height || *at) return kit_fail(err, "--size %s: must be WxH, each 1..16384", text);
    o->width = width;
    o->height = height;
    return 0;
}

/* A path whose one %d, or %04d, is replaced by a number; 0 if it has none, or does not fit. */
static int numbered(char *out, size_t size, const char *path, int k)
{
    const char *at = strchr(path, '%'), *end = at ? at + 1 : "";
    const int wide = digits(&end, 9);
    if (*end != 'd' || (end > at + 1 && !wide) || strchr(end, '%')) return 0;
    const int n = snprintf(out, size, "%.*s%0*d%s", (int)(at - path), path, wide, k, end + 1);
    return !out || (n > 0 && (size_t)n < size);
}

/* Whether the usage has an option of that name. */
static int is_option(const char *name)
{
    const size_t n = strlen(name);
    for (const char *at = usage; (at = strstr(at, name)) != NULL; ++at)
        if (at[-1] == ' ' && strchr(" \n", at[n])) return 1;
    return 0;
}

static int parse(options *o, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->method = "hsao";
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        int bad = 0;
        if (strncmp(a, "--", 2)) {
            if (o->scene) return kit_fail(err, "%s: only one scene can be given (%s is one already)", a, o->scene);
            o->scene = a;
            continue;
        }
        if (!strcmp(a, "--help")) { o->help = 1; continue; }
        if (!strcmp(a, "--list")) {
            o->list = 1;
            if (v && *v != '-') { o->listed = v; ++i; }
            continue;
        }
        if (!strcmp(a, "--json")) { o->json = 1; continue; }
        if (!strcmp(a, "--ground")) { o->ground = 1; continue; }
        if (!v)
            return kit_fail(err, "%s: %s", a,
                            is_option(a) ? "needs a value" : "there is no such option (--help names all)");
        if (!*v && strcmp(a, "--set")) return kit_fail(err, "%s: its value is empty", a);
        ++i;
        if (!strcmp(a, "--gbuffer")) o->gbuffer = v;
        else if (!strcmp(a, "--sequence")) o->sequence = v;
        else if (!strcmp(a, "--frames")) bad = whole(a, v, 1, 9999, &o->frames, err);
        else if (!strcmp(a, "--orbit")) bad = number(a, v, -360, 360, &o->orbit, err);
        else if (!strcmp(a, "--slide")) bad = numbers(a, v, o->slide, 3, err);
        else if (!strcmp(a, "--method")) o->method = v;
        else if (!strcmp(a, "--score")) o->score = v;
        else if (!strcmp(a, "--out")) o->out = v;
        else if (!strcmp(a, "--save-gbuffer")) o->save = v;
        else if (!strcmp(a, "--context")) o->context = v;
        else if (!strcmp(a, "--set")) {
            if (o->sets == 32) return kit_fail(err, "--set %s: at most 32 of them", v);
            o->set[o->sets++] = v;
        } else if (!strcmp(a, "--env")) o->env = v;
        else if (!strcmp(a, "--light")) {
            if (o->lights == KIT_MAX_LIGHTS) return kit_fail(err, "--light %s: at most %d of them", v, KIT_MAX_LIGHTS);
            o->light[o->lights++] = v;
        } else if (!strcmp(a, "--camera")) {
            bad = numbers(a, v, o->camera, 6, err);
            o->has_camera = 1;
        } else if (!strcmp(a, "--up")) {
            bad = numbers(a, v, o->up, 3, err);
            o->has_up = 1;
        } else if (!strcmp(a, "--fovy")) bad = number(a, v, 0.1, 179, &o->fovy, err);
        else if (!strcmp(a, "--ortho-height")) bad = number(a, v, 1e-12, 1e12, &o->ortho_height, err);
        else if (!strcmp(a, "--near")) bad = number(a, v, 1e-12, 1e12, &o->znear, err);
        else if (!strcmp(a, "--far")) bad = number(a, v, 1e-12, 1e12, &o->zfar, err);
        else if (!strcmp(a, "--plan")) bad = plan_of(o, v, err);
        else if (!strcmp(a, "--radius")) bad = number(a, v, 1e-12, 1e12, &o->radius, err);
        else if (!strcmp(a, "--truth")) bad = whole(a, v, 1, 65536, &o->truth, err);
        else if (!strcmp(a, "--floor")) bad = whole(a, v, 1, 65536, &o->floor, err);
        else if (!strcmp(a, "--time")) bad = whole(a, v, 1, 100000, &o->time, err);
        else if (!strcmp(a, "--size")) bad = size_of(o, v, err);
        else return kit_fail(err, "%s: there is no such option (--help names all)", a);
        if (bad) return -1;
    }
    if (o->list || o->help) return 0;
    if (o->sequence && (o->scene || o->gbuffer || o->has_camera || o->frames))
        return kit_fail(err, "--sequence %s: names its frames and cameras itself", o->sequence);
    if (o->sequence) o->gbuffer = o->sequence;
    if (o->frames && !o->scene) return kit_fail(err, "--frames: is of a scene; frames that are files are a --sequence");
    if ((o->slide[0] != 0 || o->slide[1] != 0 || o->slide[2] != 0) && !o->frames)
        return kit_fail(err, "--slide: moves an object from frame to frame: needs --frames");
    for (int i = 0; i < 3; ++i)
        if (fabs((double)o->slide[i]) * o->frames > 1e14)
            return kit_fail(err, "--slide: in %d frames the object would be beyond 1e14", o->frames);
    if ((o->sequence || o->frames) && (o->truth || o->floor || o->score || o->time || o->save || o->planned))
        return kit_fail(err, "%s: writes a method's pictures alone", o->frames ? "--frames" : "--sequence");
    if ((o->sequence || o->frames) && !numbered(NULL, 0, o->out ? o->out : "", 0))
        return kit_fail(err, "--out %s: a picture a frame needs a %%04d in it", o->out ? o->out : "");
    if (!o->scene && !o->gbuffer) return kit_fail(err, "a scene or --gbuffer must be given");
    if (o->scene && o->gbuffer) return kit_fail(err, "--gbuffer %s: cannot go with a scene (%s)", o->gbuffer, o->scene);
    if (o->planned && (o->sets || o->floor || o->truth))
        return kit_fail(err,
                        "--plan: chooses the method and its settings: --set, --truth and --floor cannot go with it");
    if (plans_light(o) && !o->env) return kit_fail(err, "--plan: light and bounce need --env");
    if (o->planned - 1 == SSGI_PLAN_OBJECTS && o->gbuffer)
        return kit_fail(err, "--plan objects: needs a scene; a frame has no objects to bake");
    if (o->truth && o->floor) return kit_fail(err, "--floor: cannot go with --truth");
    if (o->gbuffer && o->truth)
        return kit_fail(err, "--truth: needs a scene; a frame has no geometry to trace (--floor traces what it holds)");
    const char *from = o->sequence ? "--sequence" : "--gbuffer";
    if (o->gbuffer && !(o->fovy > 0) && !(o->ortho_height > 0))
        return kit_fail(err, "%s %s: needs --fovy or --ortho-height", from, o->gbuffer);
    if (o->gbuffer && !(o->radius > 0)) return kit_fail(err, "%s %s: needs --radius", from, o->gbuffer);
    if (o->gbuffer && o->width) return kit_fail(err, "--size: a frame has its own");
    if (o->fovy > 0 && o->ortho_height > 0) return kit_fail(err, "--ortho-height: cannot go with --fovy");
    if (o->znear > 0 && o->zfar > 0 && !(o->znear < o->zfar))
        return kit_fail(err, "--far %g: must be beyond --near %g", o->zfar, o->znear);
    if ((o->truth || o->floor) && o->time) return kit_fail(err, "--time: only a method has GL times");
    if (!o->out && !o->score && !o->time && !o->save)
        return kit_fail(err, "nothing to do: give --out, --score, --time or --save-gbuffer");
    if (o->out) {
        const char *dot = strrchr(o->out, '.');
        if (!dot || (strcmp(dot, ".exr") && strcmp(dot, ".png")))
            return kit_fail(err, "--out %s: must end in .exr or .png", o->out);
    }
    if (o->save) {
        const char *dot = strrchr(o->save, '.');
        if (!dot || strcmp(dot, ".exr")) return kit_fail(err, "--save-gbuffer %s: must end in .exr", o->save);
        if (o->out && !strcmp(o->out, o->save)) return kit_fail(err, "--save-gbuffer %s: is --out's file", o->save);
    }
    return 0;
}

/* The words that a setting takes, the default one in brackets. */
static void list_words(char *out, size_t size, const kit_setting *s)
{
    const char *word = s->choices;
    size_t used = 0;
    for (int k = 0; *word && used < size; ++k) {
        const int n = (int)strcspn(word, " "), ours = k == (int)s->value;
        used += (size_t)snprintf(out + used, size - used, "%s%s%.*s%s", k ? " " : "", ours ? "[" : "", n, word,
                                 ours ? "]" : "");
        word += n + (word[n] == ' ');
    }
}

/* All methods and scenes, a line each; or the settings of one method. */
static int list(const char *name, kit_error *err)
{
    kit_method m;
    kit_setting s;
    const char *about, *scene;
    int found = 0;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        if (name && strcmp(name, m.name)) continue;
        found = 1;
        printf("%-12s %s\n", m.name, m.about);
        for (int k = 0; name && kit_method_setting(&s, &m, k); ++k) {
            char values[160];
            if (s.choices) list_words(values, sizeof values, &s);
            else snprintf(values, sizeof values, "%g in %g..%g", s.value, s.least, s.most);
            printf("  %-16s %-28s %s\n", s.key, values, s.about);
        }
    }
    if (!found) return kit_fail(err, "--list %s: there is no method of that name (--list names all)", name);
    if (name) return 0;
    puts("settings of one: --list NAME\n\nbuilt-in scenes");
    for (int i = 0; (scene = kit_scene_builtin(i, &about)) != NULL; ++i) printf("%-12s %s\n", scene, about);
    return 0;
}

static void camera_of(kit_camera *c, const options *o)
{
    if (o->has_camera) { memcpy(c->eye, o->camera, sizeof c->eye); memcpy(c->target, o->camera + 3, sizeof c->target); }
    if (o->has_up) memcpy(c->up, o->up, sizeof c->up);
    if (o->fovy > 0) { c->fovy = (float)o->fovy; c->ortho_height = 0; }
    if (o->ortho_height > 0) { c->fovy = 0; c->ortho_height = (float)o->ortho_height; }
    if (o->znear > 0) c->znear = (float)o->znear;
    if (o->zfar > 0) c->zfar = (float)o->zfar;
    if (o->width) { c->width = o->width; c->height = o->height; }
}

static int camera_check(const kit_camera *c, kit_error *err)
{
    double n = 0, u = 0, d = 0;
    for (int i = 0; i < 3; ++i) {
        const double f = (double)c->target[i] - (double)c->eye[i], up = (double)c->up[i];
        n += f * f;
        u += up * up;
        d += f * up;
    }
    if (!(n > 0)) return kit_fail(err, "--camera: eye and target must differ");
    if (!(u > 0) || d * d > n * u * 0.999999)
        return kit_fail(err, "--up: must not be zero or along the view direction");
    return 0;
}

/* The picture, its foreground mask, and what was measured: of ambient visibility; or of radiance, irradiance and
   bounce, their three channels together. */
enum { GROUPS = 3 };
static const char *const group_names[GROUPS] = { "radiance", "irradiance", "bounce" };
static const char *const place_names[KIT_PLACES] = { "edge", "border", "interior" };
typedef struct result {
    kit_image        picture, frame;
    const kit_run   *run;
    const ssgi_plan *plan;
    double          *ms;
    int              frames, lit;
    kit_score        score[GROUPS];
    kit_score_place  place[GROUPS][KIT_PLACES];
    double           nothing[GROUPS];          /* lit: mean of the reference */
} result;

static int score_of(result *r, const char *path, const kit_camera *camera, double radius, kit_error *err)
{
    static const char *const names[10] = {
        "Y", "R", "G", "B", "irradiance.R", "irradiance.G", "irradiance.B", "bounce.R", "bounce.G", "bounce.B"
    };
    kit_image reference, none = { 0 }, places = { 0 };
    int status = 0;
    const float *mask = kit_image_channel(&r->frame, "Z");
    if (kit_exr_read(&reference, path, err)) return -1;
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

/* What drawing back faces took for a run. */
static double slabs_ms(const kit_run *run) { return run->gbuffer->slab_ms[0] + run->gbuffer->slab_ms[1]; }

/* ---- >>report ---------------------------------------------------------------------------------------------------- */

/* Members of an object: the first has before = "". */
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

static void json_plan(const ssgi_plan *plan)
{
    printf(", \"plan\": {");
    json_value("", "error", (double)plan->error, -6);
    json_value(", ", "cost", (double)plan->cost, -6);
    json_value(", ", "meets", plan->meets, 0);
    json_text(", ", "why", plan->why);
    printf("}");
}

static void json_settings(const kit_method *m, const kit_run *run)
{
    kit_setting s;
    printf(", \"settings\": {");
    for (int i = 0; kit_method_setting(&s, m, i); ++i) json_value(i ? ", " : "", s.key, s.value, -9);
    printf("}");
    json_value(", ", "margin_pixels", run->margin, 0);
    json_value(", ", "fetches", run->fetches, -6);
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
        json_value(", ", "fetches", kit_fetches(d), 0);
        printf("}");
    }
    printf("]");
    if (slabs_ms(r->run) > 0) json_value(", ", "slabs_ms", slabs_ms(r->run), 4);
}

/* A group's error over that of no AO; lit: the mean that it is a share of. */
static double share_of(const result *r, int g)
{
    return r->nothing[g] > 0 ? r->score[g].rmse / r->nothing[g] : 0;
}

/* The score of a group, then its edges, border and interior apart. */
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

/* what: the method, or what was asked for in its place */
static void report_json(const options *o, const kit_method *m, const char *what, const result *r, double radius)
{
    json_text("{", "source", o->gbuffer ? o->gbuffer : o->scene);
    json_text(", ", "method", what);
    json_value(", ", "radius", radius, -9);
    json_value(", ", "width", r->picture.width, 0);
    json_value(", ", "height", r->picture.height, 0);
    if (r->plan) json_plan(r->plan);
    if (r->run) json_settings(m, r->run);
    if (o->time && r->run) json_times(r);
    for (int g = 0; g < (r->lit ? GROUPS : 1) && o->score; ++g) json_score(r, g);
    printf("}\n");
}

static void text_times(const result *r)
{
    double sum = 0;
    for (int i = 0; i < r->run->passes; ++i) {
        printf("%-8s %9.3f ms, %d fetches a pixel\n", ssgi_gl_pass_name(r->run->pass[i].desc.pass), r->ms[i],
               kit_fetches(&r->run->pass[i].desc));
        sum += r->ms[i];
    }
    if (slabs_ms(r->run) > 0)
        printf("%-8s %9.3f ms: the scene's back faces, not in the sum\n", "slabs", slabs_ms(r->run));
    if (r->run->margin)
        printf("margin   %d pixels on each side: a G-buffer of %dx%d\n", r->run->margin, r->run->wide.width,
               r->run->wide.height);
    printf("%-8s %9.3f ms, %.1f fetches a pixel; medians of %d frames, %dx%d, %s\n", "all", sum, r->run->fetches,
           r->frames, r->picture.width, r->picture.height, kit_gl_name());
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

static void report(const options *o, const kit_method *m, const result *r, double radius)
{
    const char *what = o->truth                                          ? "truth"
                       : o->floor                                        ? "floor"
                       : r->plan && r->plan->method == SSGI_PLAN_NOTHING ? "nothing"
                                                                         : m->name;
    if (o->json) report_json(o, m, what, r, radius); else report_text(o, what, r);
}

/* ---- >>job: what is asked for, and what it takes ----------------------------------------------------------------- */

typedef struct job {
    options      o;
    kit_method   method;
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_run      run;
    kit_frames   frames;
    kit_lighting lighting;
    kit_world    world;
    ssgi_plan    plan;
    double       radius;
    result       r;
} job;

static int open_settings(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_lighting *l = &j->lighting;
    if (kit_method_find(&j->method, o->method, err)) return -1;
    for (int i = 0; i < o->sets; ++i) if (kit_method_set(&j->method, o->set[i], err)) return -1;
    for (; l->lights < o->lights; ++l->lights)
        if (kit_light_parse(&l->light[l->lights], o->light[l->lights], err)) return -1;
    if (o->env && kit_env_read(&l->env, o->env, err)) return -1;
    if (!j->method.lit && !o->planned && (o->env || o->lights))
        return kit_fail(err, "%s: method %s is not lit; ssdo is", o->env ? "--env" : "--light", j->method.name);
    if ((j->method.lit || j->method.between) && o->floor)
        return kit_fail(err, "--floor: is of ambient visibility within a radius; this method has none");
    if (j->method.lit && !o->planned && !o->gbuffer && !o->env && !o->lights)
        return kit_fail(err, "--method %s: needs light: --env sky, --env FILE or --light sun:..", j->method.name);
    j->r.lit = j->method.lit;
    j->radius = o->radius;
    return kit_gl_open(o->context, err);
}

static int open_frame(kit_gbuffer *g, const options *o, int lit, kit_error *err)
{
    kit_camera camera = { .target = { 0, 0, -1 }, .up = { 0, 1, 0 } };
    kit_image frame;
    kit_error why;
    int failed;
    camera_of(&camera, o);
    if (camera_check(&camera, err) || kit_exr_read(&frame, o->gbuffer, err)) return -1;
    camera.width = frame.width;
    camera.height = frame.height;
    failed = kit_gbuffer_from_frame(g, &frame, &camera, &why);
    kit_image_free(&frame);
    if (failed) return kit_fail(err, "--gbuffer %s: %s", o->gbuffer, why.text);
    if (!lit || g->direct || o->planned || o->env || o->lights) return 0;
    kit_gbuffer_free(g);
    return kit_fail(err, "--gbuffer %s: --method %s needs light: direct.R .., --env sky, --env FILE or --light sun:..",
                    o->gbuffer, o->method);
}

static int open_scene(job *j, kit_error *err)
{
    kit_camera camera;
    if (kit_scene_load(&j->scene, j->o.scene, j->o.ground, err)) return -1;
    camera = j->scene.camera;
    camera_of(&camera, &j->o);
    if (camera_check(&camera, err) || kit_gbuffer_from_scene(&j->gbuffer, &j->scene, &camera, NULL, err)) return -1;
    if (!(j->radius > 0)) j->radius = (double)j->scene.radius;
    j->world.scene = &j->scene;
    return 0;
}

/* The planned method takes the place of --method's; nothing to do is a picture already. */
static int plan_it(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_image *picture = &j->r.picture;
    ssgi_plan_scene numbers;
    const char *why = "";
    if (kit_plan_numbers(&numbers, &j->gbuffer, &j->world, (float)j->radius, o->planned - 1, err)) return -1;
    numbers.error = (float)o->plan[0];
    numbers.budget = (float)o->plan[1];
    if (ssgi_plan_make(&j->plan, &numbers, &why) != SSGI_OK) return kit_fail(err, "%s", why);
    j->r.plan = &j->plan;
    if (!o->json) printf("%s; cost %.2f\n", j->plan.why, (double)j->plan.cost);
    if (j->plan.method == SSGI_PLAN_NOTHING) {
        if (kit_image_new(picture, j->gbuffer.viewport[2], j->gbuffer.viewport[3], "Y", err)) return -1;
        for (int i = 0; i < picture->width * picture->height; ++i) picture->data[i] = 1;
    } else if (kit_plan_method(&j->method, &j->plan, o->planned - 1, err)) return -1;
    j->r.lit = j->method.lit || plans_light(o);
    return 0;
}

/* Deep screen space, whose blockers and senders count whole within the radius. */
static int trace_deep(job *j, kit_error *err)
{
    const kit_method *m = &j->method;
    const kit_camera *camera = &j->gbuffer.camera;
    const float radius = (float)j->radius;
    ssgi_dipole dipole;
    if (m->set.unit > 0) {
        const kit_material *of = kit_material_of(m->set.material);
        if (ssgi_dipole_set(&dipole, of->sigma_s, of->sigma_a, of->eta, NULL) != SSGI_OK)
            return kit_fail(err, "--set material=%s: has no dipole", of->name);
        return kit_truth_scatter(&j->r.picture, &j->scene, camera, &j->lighting, &dipole,
                                 (float)m->set.unit, 1000 * (size_t)j->o.truth, 1, err);
    }
    if (!strcmp(m->name, "dss-gloss"))
        return kit_truth_gloss(&j->r.picture, &j->scene, camera, &j->lighting, radius, KIT_ATTENUATION_NONE,
                               m->set.exponent, j->o.truth, 1, err);
    return kit_truth_lit(&j->r.picture, &j->scene, camera, &j->lighting, radius, KIT_ATTENUATION_NONE, 1, j->o.truth,
                         1, err);
}

static int trace(job *j, kit_error *err)
{
    static const int falloffs[] = { KIT_ATTENUATION_LINEAR, KIT_ATTENUATION_SQUARE };
    const kit_method *m = &j->method;
    const kit_camera *camera = &j->gbuffer.camera;
    const int rays = j->o.truth, hard = m->set.hard;
    const int attenuation = hard ? KIT_ATTENUATION_NONE : falloffs[m->set.falloff];
    if (rays && !strncmp(m->name, "dss-", 4)) return trace_deep(j, err);
    if (rays && j->r.lit) {
        const int vpls = m->set.vpls > 0,
                  bounce = m->set.bounce || m->set.indirect || vpls;
        const int all = m->set.suns || vpls;    /* these see as far as shadow maps do */
        return kit_truth_lit(&j->r.picture, &j->scene, camera, &j->lighting, all ? INFINITY : (float)j->radius,
                             all ? KIT_ATTENUATION_NONE : attenuation, bounce, rays, 1, err);
    }
    if (rays && m->between) return kit_truth_objects(&j->r.picture, &j->scene, camera, rays, 1, err);
    if (rays) return kit_truth_ao(&j->r.picture, &j->scene, camera, (float)j->radius, attenuation, rays, 1, err);
    return kit_floor_ao(&j->r.picture, &j->r.frame, camera, (float)j->radius, attenuation, j->o.floor, 1, err);
}

static int draw(job *j, kit_error *err)
{
    const int frames = j->o.time;
    kit_run *run = &j->run;
    if (kit_run_open(run, &j->gbuffer, &j->method, (float)j->radius, &j->world, err)) return -1;
    kit_run_draw(run, 0);
    j->r.run = run;
    if (frames) {
        j->r.frames = frames;
        j->r.ms = calloc((size_t)run->passes * (size_t)(frames + 1), sizeof *j->r.ms);
        if (!j->r.ms) return kit_fail(err, "out of memory");
        for (int f = 0; f < frames; ++f) {
            kit_run_draw(run, 1);
            for (int i = 0; i < run->passes; ++i) j->r.ms[run->passes + i * frames + f] = run->pass[i].ms;
        }
        for (int i = 0; i < run->passes; ++i)
            j->r.ms[i] = kit_median(j->r.ms + run->passes + i * frames, frames);
    }
    return kit_run_read(&j->r.picture, run, err);
}

/* As its ending says, EXR or PNG. */
static int write_picture(const kit_image *picture, int lit, const char *path, kit_error *err)
{
    return strcmp(strrchr(path, '.'), ".png") ? kit_exr_write(picture, path, err)
                                              : kit_png_write(picture, lit ? "R,G,B" : "Y", lit, path, err);
}

/* ---- >>frames: --sequence, --frames ------------------------------------------------------------------------------ */

/* A line of a sequence: a frame, and where it was taken. */
typedef struct line { const char *frame; float camera[6], up[3]; int has_up, number; } line;
typedef struct sequence { char *text; line *line; int lines; } sequence;

static void sequence_free(sequence *s)
{
    free(s->text);
    free(s->line);
    memset(s, 0, sizeof *s);
}

/* What a line's text says; 0: it is blank, -1: it is wrong. */
static int parse_line(line *l, char *text)
{
    float v[9] = { 0 };
    int commas = 0;
    text += strspn(text, " \t");
    if (!*text) return 0;
    char *camera = text + strcspn(text, " \t");
    if (*camera) *camera++ = 0;
    camera += strspn(camera, " \t");
    for (const char *c = camera; *c; ++c) commas += *c == ',';
    if (numbers("camera", camera, v, commas == 8 ? 9 : 6, NULL)) return -1;
    l->frame = text;
    memcpy(l->camera, v, sizeof l->camera);
    memcpy(l->up, v + 6, sizeof l->up);
    l->has_up = commas == 8;
    return 1;
}

/* Lines end in CR, LF or both, and count from 1 as an editor counts them, blank ones too. */
static int sequence_read(sequence *s, const char *path, kit_error *err)
{
    size_t size;
    int number = 0, room = 1;
    if (kit_file_read(&s->text, &size, path, err)) return -1;
    for (size_t i = 0; i < size; ++i) room += s->text[i] == '\n' || s->text[i] == '\r';
    s->line = calloc((size_t)room, sizeof *s->line);
    if (!s->line) return kit_fail(err, "--sequence %s: out of memory", path);
    for (char *at = s->text, *end = at + size, *next; at < end; at = next) {
        line *l = &s->line[s->lines];
        const size_t length = strcspn(at, "\r\n");
        l->number = ++number;
        if (at + length < end && !at[length])
            return kit_fail(err, "--sequence %s: line %d: holds a zero byte", path, number);
        next = at + length + (at[length] == '\r' && at[length + 1] == '\n') + 1;
        at[length] = 0;
        const int found = parse_line(l, at);
        if (found < 0)
            return kit_fail(err, "--sequence %s: line %d: must be FRAME.exr ex,ey,ez,tx,ty,tz[,ux,uy,uz]", path,
                            number);
        s->lines += found;
    }
    return s->lines ? 0 : kit_fail(err, "--sequence %s: names no frame", path);
}

/* The G-buffer of a line. */
static int open_line(kit_gbuffer *g, const job *j, const line *l, kit_error *err)
{
    const options *o = &j->o;
    options of = *o;
    kit_error why;
    of.gbuffer = l->frame;
    of.has_camera = 1;
    memcpy(of.camera, l->camera, sizeof of.camera);
    if (l->has_up) memcpy(of.up, l->up, sizeof of.up);
    of.has_up |= l->has_up;
    if (!open_frame(g, &of, j->method.lit, &why)) return 0;
    return kit_fail(err, "--sequence %s: line %d: %s", o->sequence, l->number, why.text);
}

/* In what a frame differs from the first one, where a method may ask for it; NULL: in nothing. Motion may be missing:
   a first frame has none. */
static const char *unlike(const kit_gbuffer *g, const kit_gbuffer *first)
{
    return g->width != first->width || g->height != first->height ? "size"
           : g->layers != first->layers                           ? "depth layers"
           : !g->albedo != !first->albedo                         ? "albedo.R .."
           : !g->direct != !first->direct                         ? "direct.R .."
           : !g->back != !first->back                             ? "back.Z"
           : !g->slabs != !first->slabs                           ? "front2.Z"
                                                                  : NULL;
}

/* Every frame is read, and the method made ready on the first one, before anything is written. */
static int sequence_check(job *j, const sequence *s, kit_error *err)
{
    kit_gbuffer first = { 0 }, g;
    int failed = open_line(&first, j, &s->line[0], err)
              || kit_frames_next(&j->frames, &first, &j->method, (float)j->radius, &j->world, NULL, err);
    kit_frames_close(&j->frames);
    for (int k = 1; k < s->lines && !failed; ++k) {
        const line *l = &s->line[k];
        failed = open_line(&g, j, l, err);
        if (failed) break;
        const char *what = unlike(&g, &first);
        if (what)
            failed = kit_fail(err, "--sequence %s: line %d: %s: must be like the first frame in %s", j->o.sequence,
                              l->number, l->frame, what);
        kit_gbuffer_free(&g);
        kit_progress("frames read", (double)k / s->lines);
    }
    kit_progress("frames read", 1);
    kit_gbuffer_free(&first);
    return failed;
}

/* The first object that casts, moved on by a frame; the first frame has it as it was. */
static int slide(kit_scene *scene, const float by[3], int frame, kit_error *err)
{
    float to[16];
    int k = 0;
    if (!(by[0] != 0 || by[1] != 0 || by[2] != 0)) return 0;
    while (k < scene->objects && !scene->object[k].casts) ++k;
    if (k == scene->objects) return kit_fail(err, "--slide: scene %s has no object that casts", scene->name);
    if (!frame) return 0;
    memcpy(to, scene->object[k].to_world, sizeof to);
    for (int i = 0; i < 3; ++i) to[12 + i] += by[i];
    return kit_scene_place(scene, k, to, err);
}

/* The G-buffer of frame k. */
static int open_next(kit_gbuffer *g, job *j, const sequence *s, const kit_camera *from, int k, kit_error *err)
{
    kit_camera camera = *from;
    if (j->o.sequence) return open_line(g, j, &s->line[k], err);
    kit_camera_orbit(&camera, from, j->o.orbit * k);
    return slide(&j->scene, j->o.slide, k, err) || kit_gbuffer_from_scene(g, &j->scene, &camera, NULL, err);
}

/* Frame k, drawn and written. */
static int play_frame(job *j, kit_gbuffer *g, int k, kit_error *err)
{
    char path[4096];
    kit_image picture;
    if (!numbered(path, sizeof path, j->o.out, k)) return kit_fail(err, "--out %s: is too long", j->o.out);
    if (kit_frames_next(&j->frames, g, &j->method, (float)j->radius, &j->world, NULL, err)) return -1;
    kit_run_draw(j->frames.now, 0);
    if (kit_run_read(&picture, j->frames.now, err)) return -1;
    const int failed = write_picture(&picture, j->r.lit, path, err);
    kit_image_free(&picture);
    return failed;
}

/* A picture a frame, written as it is drawn; each run takes over the last one's history. */
static int play(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_gbuffer shown[2] = { { 0 } };
    sequence s = { 0 };
    if (open_settings(j, err)) return -1;
    int failed = o->sequence ? sequence_read(&s, o->sequence, err) || sequence_check(j, &s, err) : open_scene(j, err);
    const kit_camera from = j->gbuffer.camera;
    const int count = o->sequence ? s.lines : o->frames;
    for (int k = 0; k < count && !failed; ++k) {
        kit_gbuffer *g = &shown[k & 1];
        failed = open_next(g, j, &s, &from, k, err) || play_frame(j, g, k, err);
        kit_gbuffer_free(&shown[!(k & 1)]);
        kit_progress("frames", (k + 1.0) / count);
    }
    kit_progress("frames", 1);
    kit_frames_close(&j->frames);
    for (int k = 0; k < 2; ++k) kit_gbuffer_free(&shown[k]);
    sequence_free(&s);
    return failed ? -1 : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int do_job(job *j, kit_error *err)
{
    const options *o = &j->o;
    result *r = &j->r;
    if (o->sequence || o->frames) return play(j, err);
    if (open_settings(j, err) || (o->gbuffer ? open_frame(&j->gbuffer, o, j->method.lit, err) : open_scene(j, err))
        || kit_gbuffer_read(&r->frame, &j->gbuffer, err)) return -1;
    if (o->planned && plan_it(j, err)) return -1;
    if (o->truth || o->floor) {
        if (trace(j, err)) return -1;
    } else if (!r->picture.data && (o->out || o->score || o->time) && draw(j, err)) return -1;
    const int dims = r->lit && r->picture.channels == 1;       /* a plan may light by ambient visibility */
    if (dims && kit_light_by(&r->picture, &j->gbuffer, &j->world, (float)j->radius, err)) return -1;
    if (o->score && score_of(r, o->score, &j->gbuffer.camera, j->radius, err)) return -1;
    if (o->save && kit_exr_write(&r->frame, o->save, err)) return -1;
    if (o->out && write_picture(&r->picture, r->lit, o->out, err)) return -1;
    report(o, &j->method, r, j->radius);
    return 0;
}

static void end_job(job *j)
{
    free(j->r.ms);
    if (j->r.run) kit_run_close(&j->run);
    kit_fields_free();
    kit_gbuffer_free(&j->gbuffer);
    kit_image_free(&j->r.picture);
    kit_image_free(&j->r.frame);
    kit_image_free(&j->lighting.env);
    kit_scene_free(&j->scene);
    kit_gl_close();
}

int main(int argc, char **argv)
{
    static job j;
    kit_error err = { "" };
    int failed;
    kit_streams_open();
    if (argc < 2) { fputs(usage, stderr); return 2; }
    j.world.lighting = &j.lighting;
    failed = parse(&j.o, argc, argv, &err);
    if (!failed && j.o.help) fputs(usage, stdout);
    else if (!failed && j.o.list) failed = list(j.o.listed, &err);
    else if (!failed) failed = do_job(&j, &err);
    if (failed) return fail(err.text);
    if (kit_streams_close(&err)) return fail(err.text);
    if (!j.o.list && !j.o.help) end_job(&j);
    return 0;
}
