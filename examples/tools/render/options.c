/* options.c - the table of options, checks of those that exclude each other, --list. */
#include "render.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>values ---------------------------------------------------------------------------------------------------- */

static int take_plan(void *to, const char *name, const char *text, kit_error *err)
{
    options *const o = to;
    static const char *const wanted[] = { "visibility:", "light:", "bounce:", "objects:" };
    enum { WANTED = (int)(sizeof wanted / sizeof *wanted) };
    char *end;
    for (o->planned = 0; o->planned < WANTED; ++o->planned) {
        const size_t n = strlen(wanted[o->planned]);
        if (strncmp(text, wanted[o->planned], n)) continue;
        o->plan[0] = strtod(text + n, &end);
        if (end == text + n || !(o->plan[0] >= 0 && o->plan[0] < 1e6)) break;
        o->plan_relative = *end == '%';
        end += o->plan_relative;
        if (*end && *end != ':') break;
        const char *budget = *end ? end + 1 : "0";
        o->plan[1] = strtod(budget, &end);
        o->plan_in_ms = end > budget && !strcmp(end, "ms");
        if (end == budget || (*end && !o->plan_in_ms) || !(o->plan[1] >= 0 && o->plan[1] < 1e6)) break;
        ++o->planned;
        return 0;
    }
    return kit_fail(err, "%s %s: must be visibility:ERROR, light:ERROR, bounce:ERROR or objects:ERROR, where ERROR "
                         "may end in %%, perhaps :BUDGET or :BUDGETms behind", name, text);
}

int render_plans_light(const options *o)
{
    return o->planned - 1 == SSGI_PLAN_WANTED_LIGHT || o->planned - 1 == SSGI_PLAN_WANTED_BOUNCE;
}

int render_numbered(char *out, size_t size, const char *path, int k)
{
    const char *at = strchr(path, '%'), *end = at ? at + 1 : "";
    const int wide = kit_digits(&end, 9);
    if (*end != 'd' || (end > at + 1 && !wide) || strchr(end, '%')) return 0;
    const int n = snprintf(out, size, "%.*s%0*d%s", (int)(at - path), path, wide, k, end + 1);
    return !out || (n > 0 && (size_t)n < size);
}

/* ---- >>table ---------------------------------------------------------------------------------------------------- */

static int take_radius(void *to, const char *name, const char *text, kit_error *err)
{
    options *const o = to;
    o->guess = !strcmp(text, "guess");
    if (!o->guess) return kit_number(name, text, 1e-12, KIT_MOST, &o->radius, err);
    o->radius = 0;
    return 0;
}

static const char usage[] = "render MODEL | NAME | random:SEED | --gbuffer FRAME.exr  [options]\n"
                            "  render model.glb --out ao.png\n"
                            "  render room --truth 256 --out truth.exr\n"
                            "  render room --method hsao --set samples=8,blur=1 --score truth.exr --time 20\n"
                            "  render cornell --method ssdo --light point:0,5,-2.8,20,20,20 --out lit.png\n"
                            "  render room --save-gbuffer frame.exr\n"
                            "  render --gbuffer frame.exr --out ao.png\n"
                            "  render --list | --list hsao | --version";
#define TO(member) .at = offsetof(options, member)
static const kit_option table[] = {
    { .about = "what to draw" },
    { "MODEL", NULL, "An OBJ, glTF, GLB, PLY, FBX or another file that Assimp reads (without libassimp-dev: OBJ "
                     "alone). A model that lies far from 0 is drawn about its middle; --camera, --light and saved "
                     "frames keep its own coordinates.", .kind = KIT_TOLD },
    { "NAME, random:SEED", NULL, "A built-in scene, or a scene by seed: --list names them.", .kind = KIT_TOLD },
    { "--gbuffer", "F.exr", "A captured frame. It has Z (view depth above 0) and may have N.X N.Y N.Z (in view "
                            "space; without them normals are computed from depth), albedo.R .., direct.R .., "
                            "farther depth layers layer1.Z .., and for thickness= back.Z, front2.Z and back2.Z. The "
                            "camera and the radius in its header are the defaults of --camera, --up, --fovy or "
                            "--ortho-height, and --radius. Files of --save-gbuffer have them, and so have those "
                            "that examples/tools/capture/capture.py makes of a depth buffer and its projection. Of "
                            "Blender's multilayer EXR the passes Depth, Normal, DiffCol and DiffDir are read; its "
                            "normals are of the world and need --camera.", .kind = KIT_TEXT, TO(gbuffer) },
    { "--layer", "NAME", "The view layer of a frame that has several.", .kind = KIT_TEXT, TO(layer) },
    { "--channel", "Z=NAME", "Channel NAME of a frame is its Z; likewise N.X and the others.",
      .kind = KIT_LIST, TO(channel), .most = RENDER_SETS, .said = offsetof(options, channels) },
    { "--camera", "ex,ey,ez,tx,ty,tz", "The eye and the target.",
      .kind = KIT_NUMBERS, TO(camera), .least = 6, .said = offsetof(options, has_camera) },
    { "--up", "x,y,z", "The direction that is up [0,1,0; of Blender's frames 0,0,1].",
      .kind = KIT_NUMBERS, TO(up), .least = 3, .said = offsetof(options, has_up) },
    { "--near", "N", "The near plane, as a view depth. An orthographic one may lie behind the eye (below 0).",
      .kind = KIT_NUMBER, TO(znear), .least = -KIT_MOST, .most = KIT_MOST, .said = offsetof(options, has_near) },
    { "--far", "F", "The far plane, as a view depth.", .kind = KIT_NUMBER, TO(zfar), .least = 1e-12, .most = KIT_MOST },
    { "--size", "WxH", "The size of the picture in pixels.", .kind = KIT_SIZE, TO(size), .least = 1, .most = 16384 },
    { "--fovy", "DEGREES", "The vertical angle of view. Of a frame whose data window is not its display window: "
                           "that of the display window.", .kind = KIT_NUMBER, TO(fovy), .least = 0.1, .most = 179 },
    { "--ortho-height", "UNITS", "An orthographic camera: the height of its picture in units of the scene.",
      .kind = KIT_NUMBER, TO(ortho_height), .least = 1e-12, .most = KIT_MOST },
    { "--ground", NULL, "A square under the mesh.", .kind = KIT_FLAG, TO(ground) },
    { "--flat", NULL, "The mesh has the normals of its faces. Without it, it has the normals of its file, or those "
                      "of its faces where the file has none.", .kind = KIT_FLAG, TO(flat) },
    { "--env", "NAME", "The environment's radiance, for lit methods: F.exr or F.hdr (latitude and longitude), sky, "
                       "probe, windows, street or white. Scenes by seed have their own light unless --env or "
                       "--light is given.", .kind = KIT_TEXT, TO(env) },
    { "--env-turn", "DEGREES", "Turns the environment anticlockwise, seen from above.",
      .kind = KIT_NUMBER, TO(turn), .least = -360, .most = 360 },
    { "--env-strength", "F", "Multiplies the environment by F.", .kind = KIT_NUMBER, TO(strength), .most = 1e6 },
    { "--light", "point:x,y,z,r,g,b", "A point light: its place and its radiant intensity.",
      .kind = KIT_LIST, TO(light), .most = KIT_MAX_LIGHTS, .said = offsetof(options, lights) },
    { "--light", "sun:x,y,z,r,g,b", "A sun: the direction to it, and the irradiance of a surface that faces it. "
                                    "There may be up to 16 lights.", .kind = KIT_TOLD },
    { "--sequence", "FRAMES.txt", "A line a frame: FRAME.exr ex,ey,ez,tx,ty,tz[,ux,uy,uz], or FRAME.exr alone where "
                                  "it has its camera. Frames may have motion.X and motion.Y: how many pixels away a "
                                  "point was in the frame before, +y down. --out has a %04d. All frames are read, "
                                  "and must have one size and the same channels, before the first picture is "
                                  "written. The first one's radius is that of all.", .kind = KIT_TEXT, TO(sequence) },
    { "--frames", "N", "So many pictures of a scene, so far apart about the target. Each is written when it is "
                       "drawn; where one fails, those before it stay.",
      .kind = KIT_WHOLE, TO(frames), .least = 1, .most = 9999 },
    { "--orbit", "DEGREES", "The angle between two of --frames.",
      .kind = KIT_NUMBER, TO(orbit), .least = -360, .most = 360 },
    { "--slide", "X,Y,Z", "The first object that casts stands so far from its place; with --frames it moves so far "
                          "a frame.",
      .kind = KIT_NUMBERS, TO(slide), .least = 3, .said = offsetof(options, has_slide) },
    { "--still", "N", "The last of N frames of a view that stays, for methods that keep history.",
      .kind = KIT_WHOLE, TO(still), .least = 1, .most = 9999 },
    { .about = "how" },
    { "--method", "NAME", "[hsao] --list names all methods, --list NAME the settings of one.",
      .kind = KIT_TEXT, TO(method) },
    { "--set", "key=value,..", "Settings of the method.",
      .kind = KIT_LIST, TO(set), .most = RENDER_SETS, .said = offsetof(options, sets), .empty = 1 },
    { "--radius", "R", "The distance of the farthest occluder, in units of the scene [the scene's or the frame's "
                       "own].", .kind = KIT_TAKEN, .take = take_radius },
    { "--radius", "guess", "How far apart the tops of the scene's mesh are.", .kind = KIT_TOLD },
    { "--plan", "WHAT:ERROR[:BUDGET]", "WHAT is visibility, light, bounce or objects (occlusion between them). "
                                       "Draws by the cheapest method whose predicted error is ERROR or less: an RMSE "
                                       "(of light over its mean), or with 40% a part of the RMSE without occlusion. "
                                       "BUDGET is in milliseconds of an RX 6800 at 1920x1080 (0.3ms), or in 16-sample "
                                       "SSAOs there. Light and bounce depend on --env and --light. If no method meets "
                                       "ERROR, it draws by the cheapest within 5 % of the best, and the exit status "
                                       "is 1.",
      .kind = KIT_TAKEN, .take = take_plan },
    { "--truth", "RAYS", "Ground truth of the quantity that --method computes, by so many rays a pixel "
                         "(dss-scatter: thousands of samples), with the normals of the mesh, or with --flat those "
                         "of its faces.", .kind = KIT_WHOLE, TO(truth), .least = 1, .most = 65536 },
    { "--floor", "RAYS", "Instead of a method: rays against the sheet that the frame's pixels make. The sheet has "
                         "no thickness, and nothing that it hides occludes. Methods that guess what is hidden may "
                         "have a smaller error.", .kind = KIT_WHOLE, TO(floor), .least = 1, .most = 65536 },
    { "--context", "osmesa | egl | egl-es", "The source of the GL context [osmesa, or egl where there is none].",
      .kind = KIT_TEXT, TO(context) },
    { .about = "what comes out" },
    { "--out", "F.exr | F.png", "Y is ambient visibility. Of lit methods R G B is the light, and an EXR has "
                                "irradiance.R .. and bounce.R .., too; a PNG has R G B in sRGB.",
      .kind = KIT_TEXT, TO(out) },
    { "--colours", NULL, "--out of a method of visibility is that times the surfaces' colours, R G B.",
      .kind = KIT_FLAG, TO(colours) },
    { "--backdrop", NULL, "--out shows the environment where there is no surface.", .kind = KIT_FLAG, TO(backdrop) },
    { "--score", "REF.exr", "Prints RMSE, bias, p95 and SSIM against a reference, and each of them for edges "
                            "(within 3 pixels of a jump in depth), for the border (nearer to it than the radius is "
                            "long) and for the interior.", .kind = KIT_TEXT, TO(score) },
    { "--time", "N", "Prints the median GL time of each pass over N frames.",
      .kind = KIT_WHOLE, TO(time), .least = 1, .most = 100000 },
    { "--save-gbuffer", "F.exr", "The G-buffer, as --gbuffer reads it, with the camera, the radius, and the "
                                 "channels that layers= and thickness= of --set read.", .kind = KIT_TEXT, TO(save) },
    { "--json", NULL, "Prints figures for programs.", .kind = KIT_FLAG, TO(json) },
    { NULL }
};

int render_help(int argc, char **argv) { return kit_help(argc, argv, usage, table); }

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
    if (o->gbuffer && o->size[0]) return kit_fail(err, "--size: a frame has its own");
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
            if ((taken = kit_option_take(o, table, a, v, err)) < 0) return -1;
        } else if (o->scene) {
            return kit_fail(err, "%s: only one scene can be given (%s is one already)", a, o->scene);
        } else o->scene = a;
    }
    if (o->list) return 0;
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
