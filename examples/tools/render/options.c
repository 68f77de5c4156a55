/* options.c - parses the command line, checks which options exclude each other, prints --help and --list. */
#include "render.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* in parts, because C99 only guarantees strings of 4095 characters */
static const char *const usage[] = {
    "usage: render MODEL | NAME | random:SEED | --gbuffer FRAME.exr  [options]\n"
    "  render model.glb --out ao.png\n"
    "  render room --truth 256 --out truth.exr\n"
    "  render room --method hsao --set samples=8,blur=1 --score truth.exr --time 20\n"
    "  render cornell --method ssdo --light point:0,5,-2.8,20,20,20 --out lit.png\n"
    "  render room --save-gbuffer frame.exr\n"
    "  render --gbuffer frame.exr --out ao.png\n"
    "  render --list | --list hsao | --version\n",
    "what to draw\n"
    "  MODEL                 An OBJ, glTF, GLB, PLY, FBX or another file that Assimp reads (without\n"
    "                        libassimp-dev: OBJ alone). A model that lies far from 0 is drawn about its\n"
    "                        middle; --camera, --light and saved frames keep its own coordinates.\n"
    "  NAME, random:SEED     A built-in scene, or a scene by seed: --list names them.\n"
    "  --gbuffer F.exr       A captured frame. It has Z (view depth above 0) and may have N.X N.Y N.Z\n"
    "                        (in view space; without them normals are computed from depth), albedo.R ..,\n"
    "                        direct.R .., farther depth layers layer1.Z .., and for thickness= back.Z,\n"
    "                        front2.Z and back2.Z. The camera and the radius in its header are the\n"
    "                        defaults of --camera, --up, --fovy or --ortho-height, and --radius. Files of\n"
    "                        --save-gbuffer have them, and so have those that\n"
    "                        examples/tools/capture/capture.py makes of a depth buffer and its\n"
    "                        projection. Of Blender's multilayer EXR the passes Depth, Normal, DiffCol\n"
    "                        and DiffDir are read; its normals are of the world and need --camera.\n"
    "  --layer NAME          The view layer of a frame that has several.\n"
    "  --channel Z=NAME      Channel NAME of a frame is its Z; likewise N.X and the others.\n"
    "  --camera ex,ey,ez,tx,ty,tz\n"
    "                        The eye and the target.\n"
    "  --up x,y,z            The direction that is up [0,1,0; of Blender's frames 0,0,1].\n"
    "  --near N, --far F     The planes, as view depths. An orthographic near plane may lie behind the\n"
    "                        eye (below 0).\n"
    "  --size WxH            The size of the picture in pixels.\n"
    "  --fovy DEGREES        The vertical angle of view. Of a frame whose data window is not its display\n"
    "                        window: that of the display window.\n"
    "  --ortho-height UNITS  An orthographic camera: the height of its picture in units of the scene.\n"
    "  --ground              A square under the mesh.\n"
    "  --flat                The mesh has the normals of its faces. Without it, it has the normals of its\n"
    "                        file, or those of its faces where the file has none.\n",
    "  --env NAME            The environment's radiance, for lit methods: F.exr or F.hdr (latitude and\n"
    "                        longitude), sky, probe, windows, street or white. Scenes by seed have their\n"
    "                        own light unless --env or --light is given.\n"
    "  --env-turn DEGREES    Turns the environment anticlockwise, seen from above.\n"
    "  --env-strength F      Multiplies the environment by F.\n"
    "  --light point:x,y,z,r,g,b\n"
    "                        A point light: its place and its radiant intensity.\n"
    "  --light sun:x,y,z,r,g,b\n"
    "                        A sun: the direction to it, and the irradiance of a surface that faces it.\n"
    "                        There may be up to 16 lights.\n"
    "  --sequence FRAMES.txt A line a frame: FRAME.exr ex,ey,ez,tx,ty,tz[,ux,uy,uz], or FRAME.exr alone\n"
    "                        where it has its camera. Frames may have motion.X and motion.Y: how many\n"
    "                        pixels away a point was in the frame before, +y down. --out has a %04d. All\n"
    "                        frames are read, and must have one size and the same channels, before the\n"
    "                        first picture is written. The first one's radius is that of all.\n"
    "  --frames N --orbit DEGREES\n"
    "                        So many pictures of a scene, so far apart about the target. Each is written\n"
    "                        when it is drawn; where one fails, those before it stay.\n"
    "  --slide X,Y,Z         The first object that casts stands so far from its place; with --frames it\n"
    "                        moves so far a frame.\n"
    "  --still N             The last of N frames of a view that stays, for methods that keep history.\n",
    "how\n"
    "  --method NAME         [hsao] --list names all methods, --list NAME the settings of one.\n"
    "  --set key=value,..    Settings of the method.\n"
    "  --radius R            The distance of the farthest occluder, in units of the scene [the scene's or\n"
    "                        the frame's own].\n"
    "  --radius guess        How far apart the tops of the scene's mesh are.\n"
    "  --plan WHAT:ERROR[:BUDGET]\n"
    "                        WHAT is visibility, light, bounce or objects (occlusion between them). Draws\n"
    "                        by the cheapest method whose predicted error is ERROR or less. BUDGET is a\n"
    "                        cost in 16-sample SSAOs, or in milliseconds of an RX 6800: 0.3ms. Light and\n"
    "                        bounce depend on --env and --light.\n"
    "  --truth RAYS          Ground truth of the quantity that --method computes, by so many rays a pixel\n"
    "                        (dss-scatter: thousands of samples), with the normals of the mesh, or with\n"
    "                        --flat those of its faces.\n"
    "  --floor RAYS          Instead of a method: rays against the sheet that the frame's pixels make.\n"
    "                        The sheet has no thickness, and nothing that it hides occludes. Methods\n"
    "                        that guess what is hidden may have a smaller error.\n"
    "  --context osmesa | egl | egl-es\n"
    "                        The source of the GL context [osmesa, or egl where there is none].\n",
    "what comes out\n"
    "  --out F.exr | F.png   Y is ambient visibility. Of lit methods R G B is the light, and an EXR has\n"
    "                        irradiance.R .. and bounce.R .., too; a PNG has R G B in sRGB.\n"
    "  --colours             --out of a method of visibility is that times the surfaces' colours, R G B.\n"
    "  --backdrop            --out shows the environment where there is no surface.\n"
    "  --score REF.exr       Prints RMSE, bias, p95 and SSIM against a reference, and each of them for\n"
    "                        edges (within 3 pixels of a jump in depth), for the border (nearer to it\n"
    "                        than the radius is long) and for the interior.\n"
    "  --time N              Prints the median GL time of each pass over N frames.\n"
    "  --save-gbuffer F.exr  The G-buffer, as --gbuffer reads it, with the camera, the radius, and the\n"
    "                        channels that layers= and thickness= of --set read.\n"
    "  --json                Prints figures for programs.\n"
    "  --version             Prints the version of the library.\n"
};

void render_usage(FILE *to)
{
    for (size_t i = 0; i < sizeof usage / sizeof *usage; ++i) fputs(usage[i], to);
}

/* ---- >>values ---------------------------------------------------------------------------------------------------- */

/* Reads numbers in world units, up to KIT_MOST, so that floats can compute with them. */
int render_numbers(const char *name, const char *text, double *out, int count, kit_error *err)
{
    double v[9];
    const char *at = text;
    for (int i = 0; i < count; ++i) {
        char *end;
        v[i] = strtod(at, &end);
        if (end == at || *end != (i + 1 < count ? ',' : 0))
            return kit_fail(err, "%s %s: must be %d numbers with commas between", name, text, count);
        if (!(fabs(v[i]) <= KIT_MOST))
            return kit_fail(err, "%s %s: its numbers must be in -%g..%g", name, text, KIT_MOST, KIT_MOST);
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

static int take_plan(options *o, const char *name, const char *text, kit_error *err)
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
        o->plan_in_ms = end > budget && !strcmp(end, "ms");
        if (end == budget || (*end && !o->plan_in_ms) || !(o->plan[1] >= 0 && o->plan[1] < 1e6)) break;
        ++o->planned;
        return 0;
    }
    return kit_fail(err, "%s %s: must be visibility:ERROR, light:ERROR, bounce:ERROR or objects:ERROR, perhaps "
                         ":BUDGET or :BUDGETms behind", name, text);
}

int render_plans_light(const options *o)
{
    return o->planned - 1 == SSGI_PLAN_WANTED_LIGHT || o->planned - 1 == SSGI_PLAN_WANTED_BOUNCE;
}

/* Returns the number of digits with which a text begins, and moves *at past them; 0: none, or it is above most. */
static int digits(const char **at, int most)
{
    int v = 0;
    for (; **at >= '0' && **at <= '9'; ++*at) v = v > most ? v : 10 * v + (**at - '0');
    return v > most ? 0 : v;
}

int render_numbered(char *out, size_t size, const char *path, int k)
{
    const char *at = strchr(path, '%'), *end = at ? at + 1 : "";
    const int wide = digits(&end, 9);
    if (*end != 'd' || (end > at + 1 && !wide) || strchr(end, '%')) return 0;
    const int n = snprintf(out, size, "%.*s%0*d%s", (int)(at - path), path, wide, k, end + 1);
    return !out || (n > 0 && (size_t)n < size);
}

/* ---- >>table ---------------------------------------------------------------------------------------------------- */

static int take_size(options *o, const char *name, const char *text, kit_error *err)
{
    const char *at = text;
    const int width = digits(&at, 16384), cross = *at == 'x', height = cross ? (++at, digits(&at, 16384)) : 0;
    if (!width || !height || *at) return kit_fail(err, "%s %s: must be WxH, each 1..16384", name, text);
    o->width = width;
    o->height = height;
    return 0;
}

static int take_radius(options *o, const char *name, const char *text, kit_error *err)
{
    o->guess = !strcmp(text, "guess");
    if (!o->guess) return number(name, text, 1e-12, KIT_MOST, &o->radius, err);
    o->radius = 0;
    return 0;
}

/* An option: the function that takes its value, or the member of options that gets it. FLAG: no value; NUMBERS: `least`
   of them; LIST: appended to at most `most`, with member `said` as count; else `said`, unless 0, becomes 1. */
typedef struct option {
    const char *name;
    enum { TAKEN, FLAG, TEXT, WHOLE, NUMBER, NUMBERS, LIST } kind;
    size_t      at;                  /* offset of an int, const char *, int, double, double[], const char *[] by kind */
    double      least, most;
    size_t      said;
    int       (*take)(options *o, const char *name, const char *text, kit_error *err);
} option;
#define TO(member) offsetof(options, member)
static const option table[] = {
    { "--help", FLAG, TO(help), 0, 0, 0, NULL },
    { "-h", FLAG, TO(help), 0, 0, 0, NULL },
    { "--version", FLAG, TO(version), 0, 0, 0, NULL },
    { "--json", FLAG, TO(json), 0, 0, 0, NULL },
    { "--ground", FLAG, TO(ground), 0, 0, 0, NULL },
    { "--flat", FLAG, TO(flat), 0, 0, 0, NULL },
    { "--colours", FLAG, TO(colours), 0, 0, 0, NULL },
    { "--backdrop", FLAG, TO(backdrop), 0, 0, 0, NULL },
    { "--gbuffer", TEXT, TO(gbuffer), 0, 0, 0, NULL },
    { "--sequence", TEXT, TO(sequence), 0, 0, 0, NULL },
    { "--frames", WHOLE, TO(frames), 1, 9999, 0, NULL },
    { "--still", WHOLE, TO(still), 1, 9999, 0, NULL },
    { "--orbit", NUMBER, TO(orbit), -360, 360, 0, NULL },
    { "--slide", NUMBERS, TO(slide), 3, 0, TO(has_slide), NULL },
    { "--method", TEXT, TO(method), 0, 0, 0, NULL },
    { "--score", TEXT, TO(score), 0, 0, 0, NULL },
    { "--out", TEXT, TO(out), 0, 0, 0, NULL },
    { "--save-gbuffer", TEXT, TO(save), 0, 0, 0, NULL },
    { "--context", TEXT, TO(context), 0, 0, 0, NULL },
    { "--set", LIST, TO(set), 0, RENDER_SETS, TO(sets), NULL },
    { "--layer", TEXT, TO(layer), 0, 0, 0, NULL },
    { "--channel", LIST, TO(channel), 0, RENDER_SETS, TO(channels), NULL },
    { "--env", TEXT, TO(env), 0, 0, 0, NULL },
    { "--env-turn", NUMBER, TO(turn), -360, 360, 0, NULL },
    { "--env-strength", NUMBER, TO(strength), 0, 1e6, 0, NULL },
    { "--light", LIST, TO(light), 0, KIT_MAX_LIGHTS, TO(lights), NULL },
    { "--camera", NUMBERS, TO(camera), 6, 0, TO(has_camera), NULL },
    { "--up", NUMBERS, TO(up), 3, 0, TO(has_up), NULL },
    { "--fovy", NUMBER, TO(fovy), 0.1, 179, 0, NULL },
    { "--ortho-height", NUMBER, TO(ortho_height), 1e-12, KIT_MOST, 0, NULL },
    { "--near", NUMBER, TO(znear), -KIT_MOST, KIT_MOST, TO(has_near), NULL },
    { "--far", NUMBER, TO(zfar), 1e-12, KIT_MOST, 0, NULL },
    { "--plan", TAKEN, 0, 0, 0, 0, take_plan },
    { "--radius", TAKEN, 0, 0, 0, 0, take_radius },
    { "--truth", WHOLE, TO(truth), 1, 65536, 0, NULL },
    { "--floor", WHOLE, TO(floor), 1, 65536, 0, NULL },
    { "--time", WHOLE, TO(time), 1, 100000, 0, NULL },
    { "--size", TAKEN, 0, 0, 0, 0, take_size }
};

/* Takes an option and its value, which may be missing. Returns the number of arguments taken; -1: refused. */
static int take(options *o, const char *name, const char *text, kit_error *err)
{
    const option *t = table, *const end = table + sizeof table / sizeof *table;
    while (t < end && strcmp(name, t->name)) ++t;
    if (t == end) return kit_fail(err, "%s: there is no such option (--help names all)", name);
    void *const member = (char *)o + t->at;
    int *const said = (int *)(void *)((char *)o + t->said);
    int failed = 0;
    if (t->kind == FLAG) return *(int *)member = 1;
    if (!text) return kit_fail(err, "%s: needs a value", name);
    if (!*text && strcmp(name, "--set")) return kit_fail(err, "%s: its value is empty", name);
    if (t->said && t->kind != LIST) *said = 1;
    switch (t->kind) {
    case TEXT:    memcpy(member, &text, sizeof text); break;
    case WHOLE:   failed = whole(name, text, (int)t->least, (int)t->most, member, err); break;
    case NUMBER:  failed = number(name, text, t->least, t->most, member, err); break;
    case NUMBERS: failed = render_numbers(name, text, member, (int)t->least, err); break;
    case LIST:
        if (*said >= (int)t->most) return kit_fail(err, "%s %s: at most %g of them", name, text, t->most);
        ((const char **)member)[(*said)++] = text;
        break;
    default: failed = t->take(o, name, text, err);
    }
    return failed ? -1 : 2;
}

/* ---- >>options that exclude each other --------------------------------------------------------------------------- */

static int check_frames(const options *o, kit_error *err)
{
    const int many = o->sequence || o->frames;
    if (o->frames && !o->scene) return kit_fail(err, "--frames: needs a scene; for frames in files use --sequence");
    if (o->has_slide && !o->scene)
        return kit_fail(err, "--slide: needs a scene; a frame has no objects");
    if (o->still && (many || o->truth || o->floor || o->time))
        return kit_fail(err, "--still: cannot go with %s", o->frames   ? "--frames"
                                                           : many     ? "--sequence"
                                                           : o->truth ? "--truth"
                                                           : o->floor ? "--floor"
                                                                      : "--time");
    for (int i = 0; i < 3; ++i)
        if (fabs(o->slide[i]) * o->frames > 1e14)
            return kit_fail(err, "--slide: in %d frames the object would be beyond 1e14", o->frames);
    if (many && (o->truth || o->floor || o->score || o->time || o->save || o->planned))
        return kit_fail(err, "%s: only writes a method's pictures", o->frames ? "--frames" : "--sequence");
    if (many && !render_numbered(NULL, 0, o->out ? o->out : "", 0))
        return kit_fail(err, "--out %s: needs a %%04d, for one picture a frame", o->out ? o->out : "");
    return 0;
}

/* Checks the options of scenes, and those of frames that replace a scene. */
static int check_source(const options *o, kit_error *err)
{
    if (!o->scene && !o->gbuffer) return kit_fail(err, "a scene or --gbuffer must be given");
    if (o->scene && o->gbuffer) return kit_fail(err, "--gbuffer %s: cannot go with a scene (%s)", o->gbuffer, o->scene);
    if (o->planned && (o->sets || o->floor || o->truth))
        return kit_fail(err,
                        "--plan: chooses the method and its settings: --set, --truth and --floor cannot go with it");
    if (render_plans_light(o) && !o->env && !(o->scene && kit_scene_seeded(o->scene)))
        return kit_fail(err, "--plan: light and bounce need --env");
    if (!o->env && (o->turn != 0 || o->strength != 1 || o->backdrop))
        return kit_fail(err, "--%s: needs --env", o->backdrop    ? "backdrop"
                                                  : o->turn != 0 ? "env-turn"
                                                                 : "env-strength");
    if (o->planned - 1 == SSGI_PLAN_WANTED_OBJECTS && o->gbuffer)
        return kit_fail(err, "--plan objects: needs a scene; a frame has no objects to bake");
    if (o->truth && o->floor) return kit_fail(err, "--floor: cannot go with --truth");
    if (o->gbuffer && o->truth)
        return kit_fail(err, "--truth: needs a scene; a frame has no geometry to trace (see --floor)");
    if (o->gbuffer && o->flat)
        return kit_fail(err, "--flat: needs a scene; for a frame use --set normal=depth");
    if (o->gbuffer && o->guess) return kit_fail(err, "--radius guess: needs a scene; a frame has no mesh");
    if (!o->gbuffer && (o->layer || o->channels))
        return kit_fail(err, "--%s: needs a frame (--gbuffer)", o->layer ? "layer" : "channel");
    if (o->gbuffer && o->width) return kit_fail(err, "--size: a frame has its own");
    if (o->fovy > 0 && o->ortho_height > 0) return kit_fail(err, "--ortho-height: cannot go with --fovy");
    if (o->has_near && o->zfar > 0 && !(o->znear < o->zfar))
        return kit_fail(err, "--far %g: must be beyond --near %g", o->zfar, o->znear);
    if (o->has_near && !(o->znear > 0) && !(o->ortho_height > 0 && o->scene))
        return kit_fail(err, "--near %g: must be above 0: only a scene's orthographic camera (--ortho-height) sees "
                             "behind its eye", o->znear);
    return 0;
}

static int check_results(const options *o, kit_error *err)
{
    const char *out = o->out ? strrchr(o->out, '.') : NULL, *save = o->save ? strrchr(o->save, '.') : NULL;
    if ((o->truth || o->floor) && o->time) return kit_fail(err, "--time: only a method has GL times");
    if (!o->out && !o->score && !o->time && !o->save)
        return kit_fail(err, "nothing to do: give --out, --score, --time or --save-gbuffer");
    if (o->out && (!out || (strcmp(out, ".exr") && strcmp(out, ".png"))))
        return kit_fail(err, "--out %s: must end in .exr or .png", o->out);
    if (o->save && (!save || strcmp(save, ".exr")))
        return kit_fail(err, "--save-gbuffer %s: must end in .exr", o->save);
    if (o->save && o->out && !strcmp(o->out, o->save))
        return kit_fail(err, "--save-gbuffer %s: is --out's file", o->save);
    return 0;
}

/* ---- >>parse ----------------------------------------------------------------------------------------------------- */

int render_parse(options *o, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->method = "hsao";
    o->strength = 1;
    for (int i = 1, taken; i < argc; i += taken) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        taken = 1;
        if (!strcmp(a, "--list")) {            /* a name may follow */
            o->list = 1;
            if (v && *v != '-') o->listed = v, taken = 2;
        } else if (*a == '-') {
            if ((taken = take(o, a, v, err)) < 0) return -1;
        } else if (o->scene) {
            return kit_fail(err, "%s: only one scene can be given (%s is one already)", a, o->scene);
        } else o->scene = a;
    }
    if (o->list || o->help || o->version) return 0;
    if (o->sequence && (o->scene || o->gbuffer || o->has_camera || o->frames))
        return kit_fail(err, "--sequence %s: names its frames and cameras itself", o->sequence);
    if (o->sequence) o->gbuffer = o->sequence;
    return check_frames(o, err) || check_source(o, err) || check_results(o, err) ? -1 : 0;
}

/* ---- >>list ------------------------------------------------------------------------------------------------------ */

/* Writes the words that a setting takes, with the default in brackets. */
static void list_words(char *out, size_t size, const kit_setting *s)
{
    size_t used = 0;
    for (int k = 0; k <= (int)s->most && used < size; ++k) {
        char word[64];
        const int ours = k == (int)s->value;
        kit_setting_word(word, sizeof word, s, k);
        used += (size_t)snprintf(out + used, size - used, "%s%s%s%s", k ? " " : "", ours ? "[" : "", word,
                                 ours ? "]" : "");
    }
}

int render_list(const char *name, kit_error *err)
{
    kit_method m;
    kit_setting s;
    const char *about, *scene;
    int found = 0;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        if (name && strcmp(name, m.name)) continue;
        found = 1;
        printf("%-12s ", m.name);
        kit_print_words(m.about, 13, 13, 100);
        for (int k = 0; name && kit_method_setting(&s, &m, k); ++k) {
            char values[160];
            if (s.choices) list_words(values, sizeof values, &s);
            else snprintf(values, sizeof values, "%g in %g..%g", s.value, s.least, s.most);
            printf("  %-21s %s\n%24s", s.key, values, "");
            kit_print_words(s.about, 24, 24, 100);
        }
    }
    if (name && !strcmp(name, "models"))
        for (; (scene = kit_scene_model(found)) != NULL; ++found) puts(scene);
    if (!found) return kit_fail(err, "--list %s: there is no method of that name (--list names all)", name);
    if (name) return 0;
    puts("settings of one: --list NAME\n\nbuilt-in scenes");
    for (int i = 0; (scene = kit_scene_builtin(i, &about)) != NULL; ++i) printf("%-12s %s\n", scene, about);
    puts("\nscenes by seed, with their own light: random:SEED, random:KIND:SEED; kinds");
    for (int i = 0; (scene = kit_scene_kind(i, &about)) != NULL; ++i) printf("%-12s %s\n", scene, about);
    puts("\nmodels of Debian's packages, on a floor: model:NAME, model:NAME:SEED; names: --list models");
    return 0;
}
