/* sweeps.c - the methods that are swept, and the causes of failure, each a scene and one thing in it that changes. They
   are lines of methods.csv and causes.csv. Declared in sweeps.h. */
#include "lab/stability/sweeps.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/measure/line.h"
#include "lab/stability/maths.h"

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

swept sweeps_method[MOST_METHODS];
int sweeps_methods;

/* ---- >>looks: the scene of a frame, for each cause --------------------------------------------------------------- */

static void set(float v[3], float x, float y, float z) { v[0] = x; v[1] = y; v[2] = z; }
static void set_box(float b[6], float x0, float y0, float z0, float x1, float y1, float z1)
{
    set(b, x0, y0, z0);
    set(b + 3, x1, y1, z1);
}
static void camera(look *l, float x, float y, float z, float tx, float ty, float tz, float fovy)
{
    set(l->eye, x, y, z);
    set(l->target, tx, ty, tz);
    l->fovy = fovy;
}

static void tilt(look *l)
{
    const float a = l->value * DEGREE;
    camera(l, 0, 3 * cosf(a), 3 * sinf(a), 0, 0, 0, 30);
    set(l->up, 0, sinf(a), -cosf(a));
    set_box(l->where, -1, -0.1f, -0.8f, 1, 0.1f, 0.8f);
}

static void tilt_wall(look *l)
{
    tilt(l);
    set_box(l->box[0], 0.35f, 0.001f, -1, 0.55f, 0.6f, 1);
    set_box(l->where, -0.3f, -0.1f, -0.6f, 0.351f, 0.6f, 0.6f);
}

/* A pole, with a camera that rolls by ten degrees, so that a pole thinner than a pixel shows only here and there. */
static void pole(look *l)
{
    const float w = 0.5f * l->value * 2 * 4 * tanf(15 * DEGREE) / (float)l->height;
    camera(l, 0, 10, 4, 0, 10, 0, 30);
    set(l->up, 0.1763f, 1, 0);
    l->radius = 0.4f;
    set_box(l->box[0], -4, 6, -1.7f, 4, 14, -1.5f);
    set_box(l->box[1], -w, 7, -w, w, 13, w);
    set_box(l->where, -0.8f, 9.3f, -1.6f, 0.8f, 10.7f, -1.4f);
}

static void rail(look *l)
{
    const float w = 0.5f * l->value * 2 * 2.9f * tanf(15 * DEGREE) / (float)l->height;
    camera(l, 0, 1.5f, 2.5f, 0, 0, 0, 30);
    set(l->up, 0.1763f, 1, 0);
    l->radius = 0.4f;
    set_box(l->box[0], -2, 0.2f - w, -w, 2, 0.2f + w, w);
    set_box(l->where, -0.8f, -0.1f, -0.5f, 0.8f, 0.01f, 0.4f);
}

static void screen(look *l)
{
    camera(l, 0, 10, 0, 0, 10, -6, 12);
    l->radius = 0.15f;
    l->znear = 0.05f;
    set_box(l->box[0], -8, 6, -6.2f, 8, 14, -6);
    set_box(l->box[1], -8, 6, -6 + l->radius * l->value, 0, 14, -5.98f + l->radius * l->value);
    set_box(l->where, 0, 9.5f, -6.1f, 2 * l->radius, 10.5f, -5.99f);
}

/* Two sheets side by side, half a radius before a wall. The part of the wall that is seen between them is scored. */
static void slot(look *l)
{
    const float half = 0.5f * 0.3f * l->value;
    camera(l, 0, 10, 0, 0, 10, -6, 12);
    l->radius = 0.3f;
    l->znear = 0.05f;
    set_box(l->box[0], -8, 6, -5.85f, -half, 14, -5.847f);
    set_box(l->box[1], half, 6, -5.85f, 8, 14, -5.847f);
    set_box(l->box[2], -8, 6, -6.2f, 8, 14, -6);
    set_box(l->where, -half, 9.5f, -6.1f, half, 10.5f, -5.99f);
}

static void of_pixels(look *l)
{
    l->scene = "room";
    l->pixels = l->value;
}

/* Scores the ground along a box' side, as far as it is seen beside an edge: of the picture, or of a screen. */
static void along(look *l, float side, float edge, float z0, float z1)
{
    set_box(l->where, side > edge ? side : edge, -0.1f, z0, (side > edge ? side : edge) + 0.4f, 0.01f, z1);
}

static void off_screen(look *l)
{
    const float edge = -1.77f, side = edge - 0.5f * l->value;
    camera(l, 0, 3, 2.2f, 0, 0, 0, 30);
    l->radius = 0.5f;
    set_box(l->box[0], side - 0.6f, 0.001f, -0.4f, side, 0.6f, 0.4f);
    along(l, side, edge, -0.3f, 0.3f);
}

/* Turns the camera to the right, until a box of which the last 0.15 were in the picture has left it. */
static void turned_off(look *l)
{
    const float pixel = 2 * 3.72f * tanf(15 * DEGREE) / (float)l->height, side = -1.62f;
    off_screen(l);
    l->target[0] = l->value * (float)l->frame * pixel;
    set_box(l->box[0], side - 0.6f, 0.001f, -0.4f, side, 0.6f, 0.4f);
    along(l, side, side, -0.3f, 0.3f);
}

static void behind(look *l)
{
    const float edge = -0.26f, side = edge - 0.5f * l->value;
    camera(l, 1.2f, 1, 4, 0.1f, 0.2f, 0, 26);
    l->radius = 0.5f;
    set_box(l->box[0], side - 0.5f, 0.001f, -0.5f, side, 0.6f, 0.1f);
    set_box(l->box[1], -2.5f, 0.001f, 0.95f, 0.1f, 0.9f, 1);
    along(l, side, edge, -0.4f, 0);
}

static void near_plane(look *l)
{
    const float front = -0.5f - 0.5f * l->value;
    camera(l, 0, 0.35f, 0, 0, 0.2f, -2, 60);
    l->radius = 0.5f;
    l->znear = 0.5f;
    set_box(l->box[0], 0.1f, 0.001f, front - 0.4f, 0.5f, 0.45f, front);
    set_box(l->where, -0.3f, -0.1f, -0.85f, 0.08f, 0.01f, -0.55f);
}

/* Makes depths of 4.9 times a power of two, so that only the precision of stored depth changes. */
static void stored(look *l)
{
    l->scene = "boxes";
    l->scale = l->value / 4.89f;
    l->znear = 0.1f;
    l->zfar = 4e5f;
    if (!l->frame) l->format = EXACT;
}

static void moved(look *l)
{
    l->scene = "casters";
    l->aside = l->value * (float)l->frame;
}

static void closer(look *l)
{
    l->scene = "casters";
    l->nearer = 1 - powf(1 - 0.01f * l->value, (float)l->frame);
}

static void sun_at(look *l, float degrees)
{
    l->scene = "boxes";
    set(l->sun, cosf(degrees * DEGREE), 0.8f, sinf(degrees * DEGREE));
}

static void sun(look *l) { sun_at(l, 40 + l->value * (float)l->frame); }

static void lit_within(look *l)
{
    sun(l);
    l->within = 1;
}

static void switched(look *l)
{
    sun_at(l, 40);
    l->within = 1;
    l->dimmed = l->frame < CHANGED ? 0 : 0.95f;
}

static void trembling(look *l)
{
    sun_at(l, 40);
    l->within = 1;
    l->dimmed = l->frame & 1 ? 0.01f * l->value : 0;
}

/* Lights a scene by a sun alone, and scores the floor beside the left side of a box of that height. */
static void sunny(look *l, float x, float y, float lamp, float height)
{
    camera(l, -2, 2, 2, -0.1f, 0, 0, 12);
    l->stride = 2;
    set(l->sun, x, y, 0);
    l->lamp = lamp;
    l->radius = 0.6f;
    l->within = 1;
    set_box(l->box[0], 0, 0.001f, -0.5f, 0.3f, height, 0.5f);
    set_box(l->where, -0.4f, -0.1f, -0.3f, -0.001f, 0.01f, 0.3f);
}

/* A sunlit wall sends light to the floor before it, while the camera turns behind the wall. */
static void emitter(look *l)
{
    sunny(l, -1, 1, -1, 0.3f);
    l->bounced = 1;
    l->orbit = l->value;
}

/* The same, and a black screen rises between the wall and the floor, too low to shade the wall from a high sun. */
static void leak(look *l)
{
    sunny(l, -0.4f, 1, -1, 0.5f);
    l->bounced = 1;
    l->black = 2;
    set_box(l->box[1], -0.22f, 0, -0.5f, -0.2f, 0.001f + 0.5f * l->value, 0.5f);
    set_box(l->where, -0.5f, -0.1f, -0.3f, -0.221f, 0.01f, 0.3f);
}

static void lamp(look *l)
{
    l->scene = "boxes";
    set(l->sun, 0.8f, 0.8f, 0.6f);
    l->lamp = l->value;
    l->within = 1;
}

/* A floor between two blocks sees so many degrees of the sky, with the lamp in their middle. */
static void slit(look *l)
{
    const float half = 0.4f * tanf(0.5f * l->value * DEGREE);
    sunny(l, 0, 1, 1.5f, 0.4f);
    l->sun[0] = 1e-4f;
    camera(l, 0, 3, 2, 0, 0, 0, 16);
    set_box(l->box[0], -half - 1, 0.001f, -1, -half, 0.4f, 1);
    set_box(l->box[1], half, 0.001f, -1, half + 1, 0.4f, 1);
    set_box(l->where, -0.4f * half, -0.1f, -0.2f, 0.4f * half, 0.01f, 0.2f);
}

/* The shadow of a plate that lies on the floor: by the sun's height, and by the size of the shadow map. */
static void contact(look *l, float degrees, int size)
{
    sunny(l, cosf(degrees * DEGREE), sinf(degrees * DEGREE), -1, 0.01f);
    l->stride = 1;
    l->fovy = 6;
    l->where[0] = -0.0087f / tanf(degrees * DEGREE);
    snprintf(l->set, sizeof l->set, ",shadow_size=%d", size);
}
static void contact_angle(look *l) { contact(l, l->value, 128); }
static void contact_size(look *l)  { contact(l, 30, (int)l->value); }

/* Thin slabs over each other. */
static void stacked(look *l)
{
    camera(l, 2, 2, 3, 0, 0.3f, 0, 40);
    l->radius = 2;
    for (int k = 0; k < (int)l->value; ++k) {
        const float y = 0.1f * (float)(k + 1);
        set_box(l->box[k], -0.5f, y, -0.5f, 0.5f, y + 0.02f, 0.5f);
    }
    set_box(l->where, -1.5f, -0.1f, -1.5f, 1.5f, 0.01f, 1.5f);
}

static void counted(look *l)
{
    l->scene = "casters";
    snprintf(l->set, sizeof l->set, ",directions=%d", (int)l->value);
}

static void turning(look *l)
{
    const float a = (20 + l->value * (float)l->frame) * DEGREE, size = 1.4f, c = size * cosf(a), s = size * sinf(a);
    const float m[16] = { c, 0, -s, 0, 0, size, 0, 0, s, 0, c, 0, 0, 0.36f * size + 0.01f, 0, 1 };
    l->scene = "casters";
    l->only = "table";
    memcpy(l->placed, m, sizeof m);
    camera(l, 1.5f, 2.3f, 3.3f, 0, 0.35f, 0, 30);
    set_box(l->where, -1.1f, -0.1f, -1.1f, 1.1f, 2, 1.1f);
}

static void sized(look *l)
{
    l->scene = "room";
    l->width = (int)l->value;
    l->height = l->width * 9 / 16;
    l->stride = l->width / 160;
}

static void rolled(look *l)
{
    const float a = l->value * (float)l->frame * DEGREE;
    l->scene = "casters";
    set(l->up, sinf(a), cosf(a), 0);
}

/* Puts a box on a floor, so many pixels from the middle. went: pixels that it moved since the frame before. */
static void box_at(look *l, float pixels, float went)
{
    const float pixel = 2 * 5 * tanf(15 * DEGREE) / (float)l->height, x = pixels * pixel;
    l->went = went * pixel;
    camera(l, 0, 3, 4, 0, 0.2f, 0, 30);
    l->radius = 0.6f;
    set_box(l->box[0], x - 0.4f, 0.001f, -0.4f, x + 0.4f, 0.7f, 0.4f);
}
static void slid(look *l) { box_at(l, l->value * (float)(l->frame - CHANGED), l->value); }
/* A box appears at frame CHANGED. It was not there before, so its motion is 0. */
static void appeared(look *l) { box_at(l, l->frame < CHANGED ? 1000 : 0, 0); }
static void vanished(look *l) { box_at(l, l->frame < CHANGED ? -20 : 20, l->frame == CHANGED ? 40 : 0); }
/* Cuts to another view, of which nothing tells the method: the worst case of a cut. */
static void jumped(look *l)
{
    l->scene = "casters";
    l->aside = l->frame < CHANGED ? 0 : 40;
    l->nearer = l->frame < CHANGED ? 0 : 0.3f;
}

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

static const struct { const char *name; void (*at)(look *l); } looks[] = {
    { "tilt", tilt }, { "tilt-wall", tilt_wall }, { "pole", pole }, { "rail", rail }, { "screen", screen },
    { "slot", slot }, { "of-pixels", of_pixels }, { "off-screen", off_screen }, { "turned-off", turned_off },
    { "behind", behind }, { "near-plane", near_plane }, { "stored", stored }, { "moved", moved },
    { "closer", closer }, { "sun", sun }, { "lit-within", lit_within }, { "switched", switched },
    { "trembling", trembling }, { "turning", turning }, { "sized", sized }, { "rolled", rolled }, { "slid", slid },
    { "appeared", appeared }, { "vanished", vanished }, { "jumped", jumped }, { "emitter", emitter },
    { "leak", leak }, { "lamp", lamp }, { "slit", slit }, { "contact-angle", contact_angle },
    { "contact-size", contact_size }, { "stacked", stacked }, { "counted", counted }
};
static const struct { const char *name; int (*curves)(result *r, kit_error *err); } of_maths[] = {
    { "ringing-open", maths_ringing_open }, { "ringing-in-shade", maths_ringing_in_shade }, { "hull", maths_hull },
    { "hull-steps", maths_hull_steps }, { "popping", maths_popping }
};

cause sweeps_cause[MOST_CAUSES];
int sweeps_causes;

/* Returns the groups of methods in a line's column of. */
static int groups(const line *l)
{
    int of = 0;
    for (const char *at = line_cell(l, "of"); *at; at += strcspn(at, "+"), at += *at == '+')
        of |= 1 << line_word(l, "of", "screen light surfels field thin turned kept kept-light bounced shadowed counted "
                                      "far", at, strcspn(at, "+"));
    return of;
}

static void read_cause(cause *c, const line *l)
{
    const char *placed = line_cell(l, "look"), *kind = line_cell(l, "kind"), *depth = line_cell(l, "depth"),
               *at = line_cell(l, "values");
    char *end;
    *c = (cause){ .name = line_cell(l, "name"), .title = line_cell(l, "title"), .across = line_cell(l, "across"),
                  .about = line_cell(l, "about"), .holds = line_cell(l, "holds"), .bounds = line_cell(l, "bounds"),
                  .number = line_text(l, "number"), .up = line_text(l, "up"), .of = groups(l),
                  .width = line_whole(l, "width"), .rays = line_whole(l, "rays"), .log = line_whole(l, "log"),
                  .told = line_whole(l, "told") };
    c->kind = line_word(l, "kind", "error precision deviation second lit-second follows after newly trail held "
                                   "shades", kind, strlen(kind));
    if (*depth)
        c->format = EXACT + line_word(l, "depth", "exact half unorm24 float32 reversed32", depth, strlen(depth));
    for (size_t i = 0; i < sizeof looks / sizeof *looks; ++i) if (!strcmp(looks[i].name, placed)) c->at = looks[i].at;
    for (size_t i = 0; i < sizeof of_maths / sizeof *of_maths; ++i)
        if (!strcmp(of_maths[i].name, placed)) c->curves = of_maths[i].curves;
    for (int i = 0; i < MOST_VALUES && *at; ++i, at = end) c->value[i] = strtod(at, &end);
    if (*at || (!c->curves && !(c->at && c->of && c->width > 0 && *line_cell(l, "values")))) line_fault(l, "look");
}

void sweeps_load(void)
{
    line m = { SWEEPS_FOLDER, .file = "methods" }, l = { SWEEPS_FOLDER, .file = "causes" };
    for (line_open(&m), sweeps_methods = 0; m.at < m.of.rows; ++m.at) {
        if (sweeps_methods == MOST_METHODS) line_fault(&m, "label");
        sweeps_method[sweeps_methods++] = (swept){ line_cell(&m, "label"), line_cell(&m, "method"),
                                                   line_cell(&m, "settings"), groups(&m), line_whole(&m, "widest") };
    }
    for (line_open(&l), sweeps_causes = 0; l.at < l.of.rows; ++l.at) {
        if (sweeps_causes == MOST_CAUSES) line_fault(&l, "name");
        read_cause(&sweeps_cause[sweeps_causes++], &l);
    }
}

look sweeps_look(const cause *c, double value, int frame)
{
    look l = { .scene = "plane", .width = c->width, .height = c->width * 9 / 16, .stride = 1, .rays = c->rays,
               .value = (float)value, .frame = frame, .told = c->told, .format = c->format };
    c->at(&l);
    return l;
}
