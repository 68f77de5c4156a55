/* arguments.c - parses the command line. An option that build/render has, too, has the same name and values. */
#include "viewer.h"
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static int take_scene(void *to, const char *text, kit_error *err)
{
    asked *const a = to;
    if (a->scene) return kit_fail(err, "%s: only one scene can be shown (%s is one already)", text, a->scene);
    a->scene = text;
    return 0;
}

static int take_size(void *to, const char *name, const char *text, kit_error *err)
{
    int size[2];
    if (kit_size(name, text, 16, 16384, size, err)) return -1;
    if (size[0] * size[1] > 33554432) return kit_fail(err, "%s %s: must have 33554432 pixels at most", name, text);
    memcpy(((asked *)to)->size, size, sizeof size);
    return 0;
}

static int take_scale(void *to, const char *name, const char *text, kit_error *err)
{
    asked *const a = to;
    a->scale = 0;
    return strcmp(text, "auto") && kit_number(name, text, 0.1, 1, &a->scale, err)
               ? kit_fail(err, "%s %s: must be auto or a number in 0.1..1", name, text)
               : 0;
}

static const char usage[] = "viewer [MODEL | NAME | random:SEED]  [options]";
#define TO(member) .at = offsetof(asked, member)
static const kit_option table[] = {
    { "MODEL", NULL, "A file that Assimp reads: OBJ, glTF, GLB, PLY, FBX and others.", .kind = KIT_TOLD },
    { "NAME", NULL, "A built-in scene [room]; build/render --list names them.", .kind = KIT_TOLD },
    { "--method", "NAME", "Any method of build/render --list [ssdo].", .kind = KIT_TEXT, TO(method) },
    { "--set", "key=value,..", "Settings of the methods that have them; history is 1 where there is one.",
      .kind = KIT_LIST, TO(set), .most = VIEWER_WISHES, .said = offsetof(asked, sets), .empty = 1 },
    { "--right", "METHOD | truth", "What the right half shows.", .kind = KIT_TEXT, TO(right) },
    { "--radius", "R", "The distance of the farthest occluder, in scene units [the scene's own].",
      .kind = KIT_NUMBER, TO(radius), .least = 1e-12, .most = KIT_MOST },
    { "--env", "NAME", "F.exr, F.hdr, sky, probe, windows, street or white.", .kind = KIT_TEXT, TO(env) },
    { "--env-turn", "DEGREES", "Turns it anticlockwise.", .kind = KIT_NUMBER, TO(turn), .least = -360, .most = 360 },
    { "--env-strength", "F", "Multiplies it.", .kind = KIT_NUMBER, TO(strength), .most = 1e6 },
    { "--light", "point:x,y,z,r,g,b | sun:x,y,z,r,g,b", "Up to 16. Without --env and --light a scene by seed has "
                                                        "its own light, all others the sky and a sun.",
      .kind = KIT_LIST, TO(light), .most = KIT_MAX_LIGHTS, .said = offsetof(asked, lights) },
    { "--ground", NULL, "A square under the mesh.", .kind = KIT_FLAG, TO(ground) },
    { "--camera", "ex,ey,ez,tx,ty,tz", "The eye and the target.",
      .kind = KIT_NUMBERS, TO(place), .least = 6, .said = offsetof(asked, camera) },
    { "--up", "x,y,z", "The direction that is up.",
      .kind = KIT_NUMBERS, TO(upward), .least = 3, .said = offsetof(asked, up) },
    { "--fovy", "DEGREES", "The vertical angle of view.", .kind = KIT_NUMBER, TO(fovy), .least = 0.1, .most = 179 },
    { "--ortho-height", "UNITS", "An orthographic camera: the height of its picture.",
      .kind = KIT_NUMBER, TO(ortho_height), .least = 1e-12, .most = KIT_MOST },
    { "--orbit", "DEGREES", "The camera turns so far a frame.",
      .kind = KIT_NUMBER, TO(orbit), .least = -360, .most = 360 },
    { "--slide", "X,Y,Z", "The first object that casts stands so far from its place.",
      .kind = KIT_NUMBERS, TO(slide), .least = 3 },
    { "--size", "WxH", "The size of the window [1280x720].", .kind = KIT_TAKEN, .take = take_size },
    { "--scale", "auto | F", "The share of the window's sides that is drawn, 0.1..1. auto: while the view moves, so "
                             "much that a frame takes a quarter of a second at most. At rest all of it is drawn, "
                             "and the mean of 32 frames is shown [auto; with --shot 1].",
      .kind = KIT_TAKEN, .take = take_scale },
    { "--colours", "0 | 1", "1: visibility is shown on the scene's colours [1].",
      .kind = KIT_WHOLE, TO(colours), .most = 1 },
    { "--panel", "0 | 1", "1: the times of the passes are shown [1; with --shot 0].",
      .kind = KIT_WHOLE, TO(panel), .most = 1 },
    { "--keys", NULL, "Starts with the list of keys.", .kind = KIT_FLAG, TO(keys) },
    { "--shot", "F.png", "Saves a picture of the window and ends.", .kind = KIT_TEXT, TO(shot) },
    { "--frames", "N", "Draws N frames before that.", .kind = KIT_WHOLE, TO(frames), .least = 1, .most = 1000000 },
    { "--command", NULL, "At the end, prints the line that has build/render draw the left half.",
      .kind = KIT_FLAG, TO(command) },
    { .about = "keys" },
    { "drag", NULL, "Orbit; right drag: pan; wheel: zoom.", .kind = KIT_TOLD },
    { "drop", NULL, "A model, or .hdr .exr as the sky.", .kind = KIT_TOLD },
    { NULL }
};

int viewer_help(int argc, char **argv)
{
    if (!kit_help(argc, argv, usage, table)) return 0;
    for (const key *k = keys; k->code && strcmp(argv[1], "--version"); ++k) printf("  %-10s %s\n", k->label, k->about);
    return 1;
}

int arguments(viewer *v, asked *to, int argc, char **argv)
{
    *to = (asked){ .scale = -1, .panel = -1, .strength = -1, .colours = v->colours, .frames = v->frames,
                   .size = { v->size[0], v->size[1] } };
    if (kit_options(to, table, argc, argv, take_scene, &v->err)) return -1;
    if (to->fovy > 0 && to->ortho_height > 0) return kit_fail(&v->err, "--ortho-height: cannot go with --fovy");
    if (!to->env && (to->turn != 0 || to->strength >= 0))
        return kit_fail(&v->err, "%s: needs --env", to->turn != 0 ? "--env-turn" : "--env-strength");
    if (!to->scene) to->scene = "room";
    v->pace.fixed = to->scale >= 0 ? to->scale : to->shot ? 1 : 0;
    v->panel = to->panel >= 0 ? to->panel : !to->shot;
    v->light.turn = to->turn;
    v->light.strength = to->strength >= 0 ? to->strength : 1;
    v->orbit = to->orbit;
    v->asked_radius = (float)to->radius;
    v->ground = to->ground;
    v->help = to->keys;
    v->command = to->command;
    v->shot = to->shot;
    v->frames = to->frames;
    v->colours = to->colours;
    memcpy(v->size, to->size, sizeof v->size);
    return *to->scene ? 0 : kit_fail(&v->err, "the scene's name is empty");
}
