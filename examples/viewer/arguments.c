/* arguments.c - parses the command line. An option that build/render has, too, has the same name and values. */
#include "viewer.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int numbers(const char *text, double *out, int count)
{
    char *end = NULL;
    for (int i = 0; i < count; ++i, text = end + 1) {
        out[i] = strtod(text, &end);
        if (end == text || *end != (i + 1 < count ? ',' : 0) || !(fabs(out[i]) <= KIT_MOST)) return -1;
    }
    return 0;
}

static int between(const char *text, double least, double most, double *out)
{
    char *end;
    const double value = strtod(text, &end);
    if (end == text || *end || !(value >= least && value <= most)) return -1;
    *out = value;
    return 0;
}

static int whole_between(const char *text, int least, int most, int *out)
{
    double value;
    if (between(text, least, most, &value) || value != floor(value) || strspn(text, "0123456789") != strlen(text))
        return -1;
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

void usage(void)
{
    fputs("usage: viewer [MODEL | NAME | random:SEED]  [options]\n"
          "  MODEL                  a file that Assimp reads: OBJ, glTF, GLB, PLY, FBX and others\n"
          "  NAME                   a built-in scene  [room]; build/render --list names them\n"
          "  --method NAME          any method of build/render --list  [ssdo]\n"
          "  --set key=value,..     settings of the methods that have them; history is 1 where there is one\n"
          "  --right METHOD | truth\n"
          "                         what the right half shows\n"
          "  --radius R             the distance of the farthest occluder, in scene units  [the scene's own]\n"
          "  --env NAME             F.exr, F.hdr, sky, probe, windows, street or white\n"
          "  --env-turn DEGREES     turns it anticlockwise;  --env-strength F  multiplies it\n"
          "  --light point:x,y,z,r,g,b | sun:x,y,z,r,g,b\n"
          "                         up to 16  [without --env and --light: a scene by seed has its own light,\n"
          "                         all others the sky and a sun]\n"
          "  --ground               a square under the mesh\n"
          "  --camera ex,ey,ez,tx,ty,tz  --up x,y,z  --fovy DEGREES | --ortho-height UNITS\n"
          "  --orbit DEGREES        the camera turns so far a frame\n"
          "  --slide X,Y,Z          the first object that casts stands so far from its place\n"
          "  --size WxH             the size of the window  [1280x720]\n"
          "  --scale auto | F       the share of the window's sides that is drawn, 0.1..1. auto: while the\n"
          "                         view moves, so much that a frame takes a quarter of a second at most. At\n"
          "                         rest all of it is drawn, and the mean of 32 frames is shown\n"
          "                         [auto; with --shot 1]\n"
          "  --colours 0 | 1        1: visibility is shown on the scene's colours  [1]\n"
          "  --panel 0 | 1          1: the times of the passes are shown  [1; with --shot 0]\n"
          "  --keys                 starts with the list of keys\n"
          "  --shot F.png           saves a picture of the window and ends;  --frames N  draws N frames before\n"
          "  --command              at the end, prints the line that has build/render draw the left half\n"
          "  --help, -h             prints this;  --version  prints the version of the library\n"
          "keys\n"
          "  drag       orbit; right drag: pan; wheel: zoom\n"
          "  drop       a model, or .hdr .exr as the sky\n",
          stdout);
    for (const key *k = keys; k->code; ++k) printf("  %-10s %s\n", k->label, k->about);
}

static int must(viewer *v, int good, const char *name, const char *value, const char *what)
{
    return good ? 0 : kit_fail(&v->err, "%s '%s': must %s", name, value, what);
}

static int take_size(viewer *v, const char *name, const char *value)
{
    return must(v, !size_of(value, v->size), name, value, "be WxH, each 16..16384, of 33554432 pixels at most");
}

static int take_place(viewer *v, asked *to, const char *name, const char *value)
{
    if (!strcmp(name, "--camera")) {
        to->camera = 1;
        return must(v, !numbers(value, to->place, 6), name, value,
                    "be six numbers with commas between, each within 1e12 of 0");
    }
    to->up |= !strcmp(name, "--up");
    return must(v, !numbers(value, strcmp(name, "--up") ? to->slide : to->upward, 3), name, value,
                "be three numbers with commas between, each within 1e12 of 0");
}

static int take_scale(viewer *v, const char *name, const char *value)
{
    v->pace.fixed = 0;
    if (!strcmp(value, "auto")) return 0;
    return must(v, !between(value, 0.1, 1, &v->pace.fixed), name, value, "be auto or a number in 0.1..1");
}

/* Takes an option whose value is one or more numbers, each within its limits. */
static int take_number(viewer *v, asked *to, const char *name, const char *value)
{
    const struct {
        const char *name;
        double least, most, *to;
    } numbers[] = { { "--env-turn", -360, 360, &v->light.turn },
                    { "--env-strength", 0, 1e6, &v->light.strength },
                    { "--orbit", -360, 360, &v->orbit },
                    { "--fovy", 0.1, 179, &to->fovy },
                    { "--ortho-height", 1e-12, KIT_MOST, &to->ortho_height } };

    const struct {
        const char *name;
        int least, most, *to;
    } wholes[] = { { "--frames", 1, 1000000, &v->frames },
                   { "--panel", 0, 1, &v->panel },
                   { "--colours", 0, 1, &v->colours } };

    char what[80];
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; ++i)
        if (!strcmp(name, numbers[i].name)) {
            snprintf(what, sizeof what, "be a number in %g..%g", numbers[i].least, numbers[i].most);
            return must(v, !between(value, numbers[i].least, numbers[i].most, numbers[i].to), name, value, what);
        }
    for (size_t i = 0; i < sizeof wholes / sizeof *wholes; ++i)
        if (!strcmp(name, wholes[i].name)) {
            snprintf(what, sizeof what, "be a whole number in %d..%d", wholes[i].least, wholes[i].most);
            return must(v, !whole_between(value, wholes[i].least, wholes[i].most, wholes[i].to), name, value, what);
        }
    return kit_fail(&v->err, "%s: there is no such option (--help names all)", name);
}

/* Takes an option with its value, "" if it has none. */
static int option(viewer *v, asked *to, const char *name, const char *value)
{
    const struct {
        const char *name, **to, *what;
    } texts[] = { { "--method", &to->method, "name a method" },
                  { "--right", &to->right, "name a method, or truth" },
                  { "--env", &to->env, "name an environment or file" },
                  { "--shot", &v->shot, "name a file" } };

    for (size_t i = 0; i < sizeof texts / sizeof *texts; ++i)
        if (!strcmp(name, texts[i].name)) {
            *texts[i].to = value;
            return must(v, *value, name, value, texts[i].what);
        }
    if (!strcmp(name, "--set")) {
        if (to->sets == VIEWER_WISHES) return kit_fail(&v->err, "--set: at most %d of them", VIEWER_WISHES);
        to->set[to->sets++] = value;
        return 0;
    }
    if (!strcmp(name, "--light")) {
        if (to->lights == KIT_MAX_LIGHTS) return kit_fail(&v->err, "--light: at most %d of them", KIT_MAX_LIGHTS);
        to->light[to->lights++] = value;
        return 0;
    }
    if (!strcmp(name, "--radius")) {
        double radius = 0;
        if (must(v, !between(value, 1e-12, KIT_MOST, &radius), name, value, "be a number in 1e-12..1e12")) return -1;
        v->asked_radius = (float)radius;
        return 0;
    }
    if (!strcmp(name, "--camera") || !strcmp(name, "--up") || !strcmp(name, "--slide"))
        return take_place(v, to, name, value);
    if (!strcmp(name, "--size")) return take_size(v, name, value);
    if (!strcmp(name, "--scale")) return take_scale(v, name, value);
    return take_number(v, to, name, value);
}

/* Takes an option without a value. */
static int alone(viewer *v, asked *to, const char *name)
{
    if (!strcmp(name, "--help") || !strcmp(name, "-h")) to->help = 1;
    else if (!strcmp(name, "--version")) to->version = 1;
    else if (!strcmp(name, "--ground")) v->ground = 1;
    else if (!strcmp(name, "--keys")) v->help = 1;
    else if (!strcmp(name, "--command")) v->command = 1;
    else return 0;
    return 1;
}

int arguments(viewer *v, asked *to, int argc, char **argv)
{
    v->pace.fixed = -1;
    v->panel = -1;
    v->light.strength = -1;
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i];
        if (alone(v, to, a)) continue;
        if (*a == '-') {
            if (option(v, to, a, i + 1 < argc ? argv[i + 1] : "")) return -1;
            ++i;
        } else if (!to->scene) to->scene = a;
        else return kit_fail(&v->err, "%s: only one scene can be shown (%s is one already)", a, to->scene);
    }
    if (v->panel < 0) v->panel = !v->shot;
    if (v->pace.fixed < 0) v->pace.fixed = v->shot ? 1 : 0;
    if (to->help || to->version) return 0;
    if (to->fovy > 0 && to->ortho_height > 0) return kit_fail(&v->err, "--ortho-height: cannot go with --fovy");
    if (!to->env && (v->light.turn != 0 || v->light.strength >= 0))
        return kit_fail(&v->err, "%s: needs --env", v->light.turn != 0 ? "--env-turn" : "--env-strength");
    if (v->light.strength < 0) v->light.strength = 1;
    if (!to->scene) to->scene = "room";
    return *to->scene ? 0 : kit_fail(&v->err, "the scene's name is empty");
}
