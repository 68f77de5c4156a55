/* arguments.c - the command line. */
#include "viewer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int floats(const char *text, float *out, int count)       /* none farther from 0 than scenes are */
{
    char *end = NULL;
    for (int i = 0; i < count; ++i, text = end + 1) {
        out[i] = strtof(text, &end);
        if (end == text || *end != (i + 1 < count ? ',' : 0) || !(fabs((double)out[i]) <= VIEWER_FARTHEST))
            return -1;
    }
    return 0;
}

static int word(const char *text, const char *const *words, int count)
{
    for (int i = 0; i < count; ++i) if (!strcmp(text, words[i])) return i;
    return -1;
}

static int method_named(const char *name)
{
    for (int i = 0; i < METHODS; ++i) if (!strcmp(name, methods[i].name)) return i;
    return strcmp(name, "truth") ? -1 : TRUTH;
}

static int whole_between(const char *text, int least, int most, int *out)
{
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || value < least || value > most) return -1;
    *out = (int)value;
    return 0;
}

static int size_of(const char *text, int size[2])
{
    char width[8] = "";
    const char *x = strchr(text, 'x');
    if (!x || x - text >= (int)sizeof width) return -1;
    memcpy(width, text, (size_t)(x - text));
    return whole_between(width, 16, 16384, &size[0]) || whole_between(x + 1, 16, 16384, &size[1])
           || size[0] * size[1] > 33554432;
}

const char usage[] =
    "usage: viewer MODEL | NAME   [options]; h in the window lists its keys\n"
    "  MODEL: a file of OBJ, glTF, GLB, PLY, FBX or what else Assimp reads\n"
    "  --method ssao | hsao | hsao-march | ssdo | ssdo-points | s3ho   [hsao]\n"
    "  --right METHOD | truth     beside it\n"
    "  --preset fast | balanced | best   --behind auto | constant | solid | width | back | slabs\n"
    "  --normal gbuffer | depth\n"
    "  --radius R  --history  --env sky | FILE  --ground  --size WxH  --camera ex,ey,ez,tx,ty,tz  --up x,y,z\n"
    "  --shot F.png   a picture of the window, then the end   --frames N   so many frames before it   --keys\n";

static int must(viewer *v, int good, const char *name, const char *value, const char *what)
{
    return good ? 0 : kit_fail(&v->err, "%s '%s': must %s", name, value, what);
}

/* An option with its value, "" where there is none. */
static int option(viewer *v, asked *to, const char *name, const char *value)
{
    static const char *const normals[] = { "gbuffer", "depth" };
    half *left = &v->half[0], *right = &v->half[1];
    if (!strcmp(name, "--method")) {
        left->method = method_named(value);
        return must(v, left->method >= 0 && left->method != TRUTH, name, value,
                    "be ssao, hsao, hsao-march, ssdo, ssdo-points or s3ho");
    }
    if (!strcmp(name, "--right")) {
        v->split_on = v->error = 1;
        right->method = method_named(value);
        return must(v, right->method >= 0, name, value, "be a method or truth");
    }
    if (!strcmp(name, "--preset")) {
        left->preset = right->preset = word(value, presets, 3);
        return must(v, left->preset >= 0, name, value, "be fast, balanced or best");
    }
    if (!strcmp(name, "--behind")) {
        v->behind = word(value, behinds, BEHINDS);
        return must(v, v->behind >= 0, name, value, "be auto, constant, solid, width, back or slabs");
    }
    if (!strcmp(name, "--normal")) {
        v->from_depth = word(value, normals, 2);
        return must(v, v->from_depth >= 0, name, value, "be gbuffer or depth");
    }
    if (!strcmp(name, "--radius"))
        return must(v, !floats(value, to->radius, 1) && *to->radius > 0, name, value,
                    "be a number above 0, at most 1e15");
    if (!strcmp(name, "--camera")) {
        to->camera = 1;
        return must(v, !floats(value, to->place, 6), name, value,
                    "be six numbers with commas between, each within 1e15 of 0");
    }
    if (!strcmp(name, "--up")) {
        to->up = 1;
        return must(v, !floats(value, to->upward, 3), name, value,
                    "be three numbers with commas between, each within 1e15 of 0");
    }
    if (!strcmp(name, "--size"))
        return must(v, !size_of(value, to->size), name, value, "be WxH, each 16..16384, of 33554432 pixels at most");
    if (!strcmp(name, "--frames"))
        return must(v, !whole_between(value, 1, 1000000, &v->frames), name, value, "be a whole number in 1..1000000");
    if (!strcmp(name, "--panel"))
        return must(v, !whole_between(value, 0, 1, &v->panel), name, value, "be 0 or 1");
    if (!strcmp(name, "--env")) {
        v->env = value;
        return must(v, *value, name, value, "name an environment or its file");
    }
    if (!strcmp(name, "--shot")) {
        v->shot = value;
        return must(v, *value, name, value, "name a file");
    }
    return kit_fail(&v->err, "%s: there is no such option (--help names all)", name);
}

int arguments(viewer *v, asked *to, int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i];
        if (!strcmp(a, "--help") || !strcmp(a, "-h")) to->help = 1;
        else if (!strcmp(a, "--history")) v->history = 1;
        else if (!strcmp(a, "--ground")) to->ground = 1;
        else if (!strcmp(a, "--keys")) v->help = 1;
        else if (*a == '-') { if (option(v, to, a, i + 1 < argc ? argv[i + 1] : "")) return -1; ++i; }
        else if (!to->scene) to->scene = a;
        else return kit_fail(&v->err, "%s: only one scene can be shown (%s is one already)", a, to->scene);
    }
    if (to->help || to->scene) return 0;
    return kit_fail(&v->err, "a scene must be given: a model's file or a built-in name (--help says more)");
}
