/* sweeps.c - what is swept: methods, and the causes of failure, each a scene and one thing in it that changes. Declared
   in sweeps.h. */
#include "lab/stability/sweeps.h"
#include <math.h>
#include <string.h>
#include "lab/stability/maths.h"

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

const swept sweeps_method[] = {
    { "ssao",       "ssao",       "",                             SCREEN,         3840 },
    { "hsao-fast",  "hsao-fast",  "",                             SCREEN,         3840 },
    { "hsao",       "hsao",       "",                             SCREEN,         3840 },
    { "hsao-back",  "hsao",       "thickness=back",                  THIN,           3840 },
    { "hsao-best",  "hsao-best",  "",                             SCREEN,         3840 },
    { "hsao-march", "hsao-march", "",                             SCREEN,         1920 },
    { "ssdo",       "ssdo",       "bounce=none",                  LIGHT | TURNED, 1920 },
    { "s3ho",       "s3ho",       "indirect=none",                LIGHT | TURNED, 1920 },
    { "ssbn",       "ssbn",       "",                             LIGHT | TURNED, 1920 },
    { "hsao-fast-history", "hsao-fast", "history=1",             KEPT,           1920 },
    { "hsao-history", "hsao-history", "",                        KEPT,           1920 },
    { "hsao-2x10-history", "hsao", "steps=10,history=1",          KEPT,           1920 },
    { "ssdo-history", "ssdo",    "bounce=none,history=1",        KEPT | KEPT_LIGHT, 1920 },
    { "ssdo-fast-history", "ssdo-fast", "bounce=none,history=1", KEPT_LIGHT,     1920 },
    /* at full size, with the reach that a close look wants, 0.7 image heights; 4 levels reach 0.18 */
    { "dss",        "dss",        "levels=6,half=0",              OF_SURFELS,       1280 },
    { "dss-lit",    "dss-lit",    "size=0.03",                    TURNED,         1280 },
    { "aof",        "aof",        "resolution=8,radii=8,rays=64", FIELD,          1920 }
};
const int sweeps_methods = sizeof sweeps_method / sizeof *sweeps_method;
_Static_assert(sizeof sweeps_method / sizeof *sweeps_method <= MOST_METHODS, "more methods than MOST_METHODS");

/* ---- >>looks: what a frame of each cause shows ------------------------------------------------------------------- */

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

static void tilt(look *l, double value, int frame)
{
    const float a = (float)value * DEGREE;
    (void)frame;
    camera(l, 0, 3 * cosf(a), 3 * sinf(a), 0, 0, 0, 30);
    set(l->up, 0, sinf(a), -cosf(a));
    set(l->where[0], -1, -0.1f, -0.8f);
    set(l->where[1], 1, 0.1f, 0.8f);
}

static void tilt_wall(look *l, double value, int frame)
{
    tilt(l, value, frame);
    set_box(l->box[0], 0.35f, 0.001f, -1, 0.55f, 0.6f, 1);
    set(l->where[0], -0.3f, -0.1f, -0.6f);
    set(l->where[1], 0.351f, 0.6f, 0.6f);
}

/* Rolled by ten degrees: what is thinner than a pixel is seen here and there. */
static void pole(look *l, double value, int frame)
{
    const float w = 0.5f * (float)value * 2 * 4 * tanf(15 * DEGREE) / (float)l->height;
    (void)frame;
    camera(l, 0, 10, 4, 0, 10, 0, 30);
    set(l->up, 0.1763f, 1, 0);
    l->radius = 0.4f;
    set_box(l->box[0], -4, 6, -1.7f, 4, 14, -1.5f);
    set_box(l->box[1], -w, 7, -w, w, 13, w);
    set(l->where[0], -0.8f, 9.3f, -1.6f);
    set(l->where[1], 0.8f, 10.7f, -1.4f);
}

static void rail(look *l, double value, int frame)
{
    const float w = 0.5f * (float)value * 2 * 2.9f * tanf(15 * DEGREE) / (float)l->height;
    (void)frame;
    camera(l, 0, 1.5f, 2.5f, 0, 0, 0, 30);
    set(l->up, 0.1763f, 1, 0);
    l->radius = 0.4f;
    set_box(l->box[0], -2, 0.2f - w, -w, 2, 0.2f + w, w);
    set(l->where[0], -0.8f, -0.1f, -0.5f);
    set(l->where[1], 0.8f, 0.01f, 0.4f);
}

static void screen(look *l, double value, int frame)
{
    (void)frame;
    camera(l, 0, 10, 0, 0, 10, -6, 12);
    l->radius = 0.15f;
    l->znear = 0.05f;
    set_box(l->box[0], -8, 6, -6.2f, 8, 14, -6);
    set_box(l->box[1], -8, 6, -6 + l->radius * (float)value, 0, 14, -5.98f + l->radius * (float)value);
    set(l->where[0], 0, 9.5f, -6.1f);
    set(l->where[1], 2 * l->radius, 10.5f, -5.99f);
}

/* Two sheets side by side, half a radius before a wall; of the wall what is seen between them is scored. */
static void slot(look *l, double value, int frame)
{
    const float half = 0.5f * 0.3f * (float)value;
    (void)frame;
    camera(l, 0, 10, 0, 0, 10, -6, 12);
    l->radius = 0.3f;
    l->znear = 0.05f;
    set_box(l->box[0], -8, 6, -5.85f, -half, 14, -5.847f);
    set_box(l->box[1], half, 6, -5.85f, 8, 14, -5.847f);
    set_box(l->box[2], -8, 6, -6.2f, 8, 14, -6);
    set(l->where[0], -half, 9.5f, -6.1f);
    set(l->where[1], half, 10.5f, -5.99f);
}

static void of_pixels(look *l, double value, int frame)
{
    (void)frame;
    l->scene = "room";
    l->pixels = (float)value;
}

/* The ground along a box' side, as far as it is seen beside an edge: the picture's, or that of a screen in front. */
static void along(look *l, float side, float edge, float z0, float z1)
{
    set(l->where[0], side > edge ? side : edge, -0.1f, z0);
    set(l->where[1], (side > edge ? side : edge) + 0.4f, 0.01f, z1);
}

static void off_screen(look *l, double value, int frame)
{
    const float edge = -1.77f, side = edge - 0.5f * (float)value;
    (void)frame;
    camera(l, 0, 3, 2.2f, 0, 0, 0, 30);
    l->radius = 0.5f;
    set_box(l->box[0], side - 0.6f, 0.001f, -0.4f, side, 0.6f, 0.4f);
    along(l, side, edge, -0.3f, 0.3f);
}

/* The camera turns to the right: a box whose last 0.15 were in the picture leaves it. */
static void turned_off(look *l, double value, int frame)
{
    const float pixel = 2 * 3.72f * tanf(15 * DEGREE) / (float)l->height, side = -1.62f;
    off_screen(l, 0, frame);
    l->target[0] = (float)value * (float)frame * pixel;
    set_box(l->box[0], side - 0.6f, 0.001f, -0.4f, side, 0.6f, 0.4f);
    along(l, side, side, -0.3f, 0.3f);
}

static void behind(look *l, double value, int frame)
{
    const float edge = -0.26f, side = edge - 0.5f * (float)value;
    (void)frame;
    camera(l, 1.2f, 1, 4, 0.1f, 0.2f, 0, 26);
    l->radius = 0.5f;
    set_box(l->box[0], side - 0.5f, 0.001f, -0.5f, side, 0.6f, 0.1f);
    set_box(l->box[1], -2.5f, 0.001f, 0.95f, 0.1f, 0.9f, 1);
    along(l, side, edge, -0.4f, 0);
}

static void near_plane(look *l, double value, int frame)
{
    const float front = -0.5f - 0.5f * (float)value;
    (void)frame;
    camera(l, 0, 0.35f, 0, 0, 0.2f, -2, 60);
    l->radius = 0.5f;
    l->znear = 0.5f;
    set_box(l->box[0], 0.1f, 0.001f, front - 0.4f, 0.5f, 0.45f, front);
    set(l->where[0], -0.3f, -0.1f, -0.85f);
    set(l->where[1], 0.08f, 0.01f, -0.55f);
}

/* Depths of 4.9 times a power of two, so that nothing but depth's precision changes. */
static void stored(look *l, double value, int frame, int format)
{
    l->scene = "boxes";
    l->scale = (float)(value / 4.89);
    l->znear = 0.1f;
    l->zfar = 4e5f;
    l->format = frame ? format : EXACT;
}
static void half_float(look *l, double value, int frame) { stored(l, value, frame, HALF); }
static void unorm24(look *l, double value, int frame)    { stored(l, value, frame, UNORM24); }
static void float32(look *l, double value, int frame)    { stored(l, value, frame, FLOAT32); }
static void reversed32(look *l, double value, int frame) { stored(l, value, frame, REVERSED32); }

static void moved(look *l, double value, int frame)
{
    l->scene = "casters";
    l->aside = (float)value * (float)frame;
}

static void closer(look *l, double value, int frame)
{
    l->scene = "casters";
    l->nearer = 1 - powf(1 - 0.01f * (float)value, (float)frame);
}

static void sun(look *l, double value, int frame)
{
    const float a = (40 + (float)value * (float)frame) * DEGREE;
    l->scene = "boxes";
    set(l->sun, cosf(a), 0.8f, sinf(a));
}

static void lit_within(look *l, double value, int frame)
{
    sun(l, value, frame);
    l->within = 1;
}

static void switched(look *l, double value, int frame)
{
    (void)value;
    lit_within(l, 0, frame);
    l->dimmed = frame < CHANGED ? 0 : 0.95f;
}
static void trembling(look *l, double value, int frame)
{
    lit_within(l, 0, frame);
    l->dimmed = frame & 1 ? 0.01f * (float)value : 0;
}

static void turning(look *l, double value, int frame)
{
    const float a = (20 + (float)value * (float)frame) * DEGREE, size = 1.4f, c = size * cosf(a), s = size * sinf(a);
    const float m[16] = { c, 0, -s, 0, 0, size, 0, 0, s, 0, c, 0, 0, 0.36f * size + 0.01f, 0, 1 };
    l->scene = "casters";
    l->only = "table";
    memcpy(l->placed, m, sizeof m);
    camera(l, 1.5f, 2.3f, 3.3f, 0, 0.35f, 0, 30);
    set(l->where[0], -1.1f, -0.1f, -1.1f);
    set(l->where[1], 1.1f, 2, 1.1f);
}

static void sized(look *l, double value, int frame)
{
    (void)frame;
    l->scene = "room";
    l->width = (int)value;
    l->height = l->width * 9 / 16;
    l->stride = l->width / 160;
}

static void rolled(look *l, double value, int frame)
{
    const float a = (float)value * (float)frame * DEGREE;
    l->scene = "casters";
    set(l->up, sinf(a), cosf(a), 0);
}

/* A box on a floor, so many pixels from the middle; went: since the frame before. */
static void box_at(look *l, float pixels, float went)
{
    const float pixel = 2 * 5 * tanf(15 * DEGREE) / (float)l->height, x = pixels * pixel;
    l->went = went * pixel;
    camera(l, 0, 3, 4, 0, 0.2f, 0, 30);
    l->radius = 0.6f;
    set_box(l->box[0], x - 0.4f, 0.001f, -0.4f, x + 0.4f, 0.7f, 0.4f);
}
static void slid(look *l, double value, int frame)
{
    box_at(l, (float)value * (float)(frame - CHANGED), (float)value);
}
/* What was not there before has not moved. */
static void appeared(look *l, double value, int frame)
{
    (void)value;
    box_at(l, frame < CHANGED ? 1000 : 0, 0);
}
static void vanished(look *l, double value, int frame)
{
    (void)value;
    box_at(l, frame < CHANGED ? -20 : 20, frame == CHANGED ? 40 : 0);
}
/* Nothing says that it is another view: the worst that a cut can do. */
static void jumped(look *l, double value, int frame)
{
    (void)value;
    l->scene = "casters";
    l->aside = frame < CHANGED ? 0 : 40;
    l->nearer = frame < CHANGED ? 0 : 0.3f;
}

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

#define DEPTHS   { 1.2225, 78.24, 1251.84, 5007.36, 10014.72, 20029.44, 40058.88, 80117.76 }
#define SLIDING  { -0.8, -0.6, -0.4, -0.2, -0.001, 0.2, 0.4, 0.6, 0.8 }
const cause sweeps_cause[] = {
    { .name = "tilt",
      .title = "View tilt, a bare plane",
      .across = "tilt of the view against the plane's normal, degrees",
      .kind = ERROR, .of = AMBIENT, .width = 240, .rays = 16, .at = tilt,
      .value = { 0.001, 30, 50, 65, 75, 80, 84, 87, 89 },
      .about = "A plane occludes nothing of itself: all that is seen is false." },
    { .name = "tilt-wall",
      .title = "View tilt, a plane and a wall",
      .across = "tilt of the view against the plane's normal, degrees",
      .kind = ERROR, .of = AMBIENT, .width = 240, .rays = 128, .at = tilt_wall,
      .value = { 0.001, 30, 50, 65, 75, 80, 84, 87, 89 },
      .about = "A low wall along the line of sight; both are scored." },
    { .name = "pole",
      .title = "Thickness: a pole before a far wall",
      .across = "thickness of the pole, pixels",
      .kind = ERROR, .of = AMBIENT | THIN, .width = 240, .rays = 64, .log = 1, .at = pole,
      .value = { 0.1, 0.3, 1, 2, 4, 10, 20 },
      .about = "The wall is almost four radii behind: it is open, and darkness around the pole is a halo." },
    { .name = "rail",
      .title = "Thickness: a rail above a floor",
      .across = "thickness of the rail, pixels",
      .kind = ERROR, .of = AMBIENT | THIN, .width = 240, .rays = 128, .log = 1, .at = rail,
      .value = { 0.1, 0.3, 1, 2, 4, 10, 20 },
      .about = "Half a radius above the floor: its occlusion goes with its thickness." },
    { .name = "halo",
      .title = "Distance behind a depth discontinuity",
      .across = "distance of the wall behind the screen's edge, radii",
      .kind = ERROR, .of = AMBIENT | THIN, .width = 240, .rays = 128, .log = 1, .at = screen,
      .value = { 0.1, 0.3, 0.6, 1, 1.5, 3, 10, 30 },
      .about = "A screen before a wall; of the wall two radii beside the edge are scored. Beyond one radius it is "
               "open." },
    { .name = "slot",
      .title = "Through a slot between two sheets",
      .across = "width of the slot, radii",
      .kind = ERROR, .of = AMBIENT | THIN, .width = 240, .rays = 128, .log = 1, .at = slot,
      .value = { 0.2, 0.4, 0.8, 1.6, 3.2 },
      .about = "Sheets a hundredth of the radius thick, half a radius before a wall, which is scored: taken for as "
               "thick as they are wide, they darken it." },
    { .name = "radius",
      .title = "Radius, from a tenth of a pixel to the whole screen",
      .across = "radius, pixels at the middle of the room",
      .kind = ERROR, .of = AMBIENT, .width = 240, .rays = 64, .log = 1, .at = of_pixels,
      .value = { 0.1, 0.3, 1, 3, 10, 30, 80, 240 },
      .about = "Room." },
    { .name = "off-screen",
      .title = "Sliding off the screen",
      .across = "how far the box is off the screen, radii",
      .kind = ERROR, .of = AMBIENT | FIELD, .width = 240, .rays = 128, .at = off_screen,
      .value = SLIDING,
      .about = "A box slides off; the ground beside it, or beside the picture's border, is scored. Of aof: occlusion "
               "at any distance, against its own truth, here and below." },
    { .name = "turned-off",
      .title = "Sliding off the screen as the camera turns",
      .across = "pixels a frame",
      .kind = SECOND, .of = AMBIENT, .width = 240, .rays = 128, .log = 1, .at = turned_off,
      .value = { 0.25, 0.5, 1, 2, 4, 8 },
      .about = "The last of a box leaves the picture: what is expected beyond the border is to follow it, not to "
               "flicker. The ground beside the box." },
    { .name = "hidden",
      .title = "Sliding behind another",
      .across = "how far the box is behind the screen's edge, radii",
      .kind = ERROR, .of = AMBIENT | FIELD, .width = 240, .rays = 128, .at = behind,
      .value = SLIDING,
      .about = "A box slides behind a screen in front; the ground beside it, or beside the screen's edge, is scored." },
    { .name = "near-plane",
      .title = "Crossing the near plane",
      .across = "front of the box before the near plane, radii",
      .kind = ERROR, .of = AMBIENT | FIELD, .width = 240, .rays = 128, .at = near_plane,
      .value = { 1.2, 0.8, 0.4, 0.1, -0.1, -0.3, -0.5, -0.7, -0.9 },
      .about = "A box comes toward the camera, is cut open, and is gone at -0.8; the ground beside it is scored." },
    { .name = "depth-16f",
      .title = "View depth stored as 16 bits of float",
      .across = "view depth",
      .kind = PRECISION, .of = AMBIENT, .width = 160, .log = 1, .at = half_float,
      .value = DEPTHS,
      .about = "Boxes, near plane at 0.1; the radius is of the same number of pixels at all depths, and only "
               "precision changes. To the picture with exact depth." },
    { .name = "depth-24",
      .title = "View depth as 24 bits of window depth",
      .across = "view depth",
      .kind = PRECISION, .of = AMBIENT, .width = 160, .log = 1, .at = unorm24,
      .value = DEPTHS,
      .about = "The same." },
    { .name = "depth-32f",
      .title = "View depth as 32 bits of window depth, float",
      .across = "view depth",
      .kind = PRECISION, .of = AMBIENT, .width = 160, .log = 1, .at = float32,
      .value = DEPTHS,
      .about = "The same." },
    { .name = "depth-reversed",
      .title = "View depth as 32 bits of reversed window depth, float",
      .across = "view depth",
      .kind = PRECISION, .of = AMBIENT, .width = 160, .log = 1, .at = reversed32,
      .value = DEPTHS,
      .about = "The same." },
    { .name = "camera",
      .title = "The camera moves sideways",
      .across = "pixels a frame",
      .kind = DEVIATION, .of = AMBIENT | FIELD, .width = 160, .rays = 128, .log = 1, .at = moved,
      .value = { 0.1, 0.25, 0.5, 1, 2, 4 },
      .about = "Two dozen shapes. Places that all frames show, between four pixels each." },
    { .name = "dolly",
      .title = "The camera comes closer",
      .across = "percent of the distance a frame",
      .kind = DEVIATION, .of = AMBIENT | FIELD, .width = 160, .rays = 128, .log = 1, .at = closer,
      .value = { 0.1, 0.3, 1, 3 },
      .about = "The same, for surfels that pop." },
    { .name = "light",
      .title = "The sun turns",
      .across = "degrees a frame",
      .kind = LIT_SECOND, .of = TURNED, .width = 160, .rays = 256, .log = 1, .at = sun,
      .value = { 0.25, 0.5, 1, 2, 4, 8 },
      .about = "Three boxes under the sky and a soft sun, in the environment." },
    { .name = "rotation",
      .title = "An object turns",
      .across = "degrees a frame",
      .kind = SECOND, .of = AMBIENT | FIELD, .width = 160, .rays = 256, .log = 1, .at = turning,
      .value = { 0.25, 0.5, 1, 2, 4, 8 },
      .about = "A table on a ground; places move with it." },
    { .name = "kept-camera",
      .title = "Over frames: the camera moves sideways",
      .across = "pixels a frame",
      .kind = FOLLOWS, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = moved,
      .value = { 1e-4, 0.1, 0.25, 0.5, 1, 2, 4 },
      .about = "Two dozen shapes, sixteen frames; the first value stands still. Under white light ssdo is all but "
               "hsao: the same slices." },
    { .name = "kept-dolly",
      .title = "Over frames: the camera comes closer",
      .across = "percent a frame",
      .kind = FOLLOWS, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = closer,
      .value = { 0.1, 0.3, 1 },
      .about = "The same." },
    { .name = "kept-roll",
      .title = "Over frames: the camera rolls",
      .across = "degrees a frame",
      .kind = FOLLOWS, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = rolled,
      .value = { 0.1, 0.3, 1 },
      .about = "The same." },
    { .name = "kept-slide",
      .title = "Over frames: a box slides over a floor",
      .across = "pixels a frame",
      .kind = FOLLOWS, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = slid,
      .value = { 0.1, 0.25, 0.5, 1, 2, 4 },
      .about = "Without motion vectors." },
    { .name = "kept-appear",
      .title = "Over frames: a box appears",
      .across = "frames after",
      .kind = AFTER, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = appeared,
      .value = { 1, 2, 3, 5, 8 },
      .about = "Without motion vectors." },
    { .name = "kept-jump",
      .title = "Over frames: a box is elsewhere at once",
      .across = "frames after",
      .kind = AFTER, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = vanished,
      .value = { 1, 2, 3, 5, 8 },
      .about = "Without motion vectors." },
    { .name = "kept-trail-appear",
      .title = "Over frames: a box appears, what is left of the light that was",
      .across = "frames after",
      .kind = TRAIL, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = appeared,
      .value = { 1, 2, 3, 5, 8 },
      .about = "Where the truth changed by more than 0.05." },
    { .name = "kept-trail-jump",
      .title = "Over frames: a box is elsewhere at once, what is left of what was",
      .across = "frames after",
      .kind = TRAIL, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = vanished,
      .value = { 1, 2, 3, 5, 8 },
      .about = "Where the truth changed by more than 0.05." },
    { .name = "kept-held-appear",
      .title = "Over frames: a box appears, pixels that hold what was",
      .across = "frames after",
      .kind = HELD, .of = KEPT, .width = 320, .rays = 64, .log = 1, .at = appeared,
      .value = { 1, 2, 3, 4, 8 },
      .about = "Pixel by pixel, where the truth changed by more than 0.05." },
    { .name = "kept-held-jump",
      .title = "Over frames: a box is elsewhere at once, pixels that hold what was",
      .across = "frames after",
      .kind = HELD, .of = KEPT, .width = 320, .rays = 64, .log = 1, .at = vanished,
      .value = { 1, 2, 3, 4, 8 },
      .about = "The same." },
    { .name = "kept-slide-told",
      .title = "Over frames: a box slides over a floor, with motion vectors",
      .across = "pixels a frame",
      .kind = FOLLOWS, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = slid, .told = 1,
      .value = { 0.1, 0.25, 0.5, 1, 2, 4 },
      .about = "The box's own; of all else 0." },
    { .name = "kept-held-appear-told",
      .title = "Over frames: a box appears, pixels that hold what was, with motion vectors",
      .across = "frames after",
      .kind = HELD, .of = KEPT, .width = 320, .rays = 64, .log = 1, .at = appeared, .told = 1,
      .value = { 1, 2, 3, 4, 8 },
      .about = "They are 0: what was not there before has not moved." },
    { .name = "kept-held-jump-told",
      .title = "Over frames: a box is elsewhere at once, pixels that hold what was, with motion vectors",
      .across = "frames after",
      .kind = HELD, .of = KEPT, .width = 320, .rays = 64, .log = 1, .at = vanished, .told = 1,
      .value = { 1, 2, 3, 4, 8 },
      .about = "The box's own; of all else 0." },
    { .name = "kept-flicker",
      .title = "Over frames: deviation while the camera moves sideways",
      .across = "pixels a frame",
      .kind = DEVIATION, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = moved,
      .value = { 0.1, 0.25, 0.5, 1 },
      .about = "Eight frames, after eight that are not counted." },
    { .name = "kept-cut",
      .title = "Over frames: another view that nobody tells of",
      .across = "frames after",
      .kind = AFTER, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = jumped,
      .value = { 1, 2, 3, 5, 8 },
      .about = "A cut that is told of starts anew." },
    { .name = "kept-newly",
      .title = "Over frames: what the frame before did not show",
      .across = "pixels a frame",
      .kind = NEWLY, .of = KEPT, .width = 160, .rays = 64, .log = 1, .at = moved,
      .value = { 1, 2, 4, 8 },
      .about = "Two dozen shapes, the camera moves sideways: beside silhouettes, and at the picture's border." },
    { .name = "kept-light",
      .title = "Over frames: the sun turns",
      .across = "degrees a frame",
      .kind = FOLLOWS, .of = KEPT_LIGHT, .width = 160, .rays = 64, .log = 1, .at = lit_within,
      .value = { 1e-4, 0.5, 2, 8 },
      .about = "Three boxes under the sky and a soft sun; the first value stands still. Nothing tells that light "
               "changed: what is seen is its lag." },
    { .name = "kept-switch",
      .title = "Over frames: the sun goes out",
      .across = "frames after",
      .kind = AFTER, .of = KEPT_LIGHT, .width = 160, .rays = 64, .log = 1, .at = switched,
      .value = { 1, 2, 3, 5, 8 },
      .about = "The same, and nineteen parts of twenty of the sun are gone at once." },
    { .name = "kept-tremble",
      .title = "Over frames: the sun flickers",
      .across = "percent that each second frame lacks",
      .kind = FOLLOWS, .of = KEPT_LIGHT, .width = 160, .rays = 64, .log = 1, .at = trembling,
      .value = { 3, 10, 30, 90 },
      .about = "The same: light that flickers must be seen to." },
    { .name = "resolution",
      .title = "Resolution at constant angular radius",
      .across = "pixels across",
      .kind = ERROR, .of = AMBIENT, .width = 160, .rays = 128, .log = 1, .at = sized,
      .value = { 160, 320, 640, 1280, 1920, 3840 },
      .about = "Room, from 160 x 90 to 3840 x 2160." },
    { .name = "sh-open",
      .title = "Ringing of a sun as harmonics: an open surface",
      .across = "angle of the sun to the normal, degrees",
      .kind = ERROR, .curves = maths_ringing_open,
      .about = "Irradiance over that of an open surface that faces the sun.",
      .number = "most negative irradiance",
      .up = "irradiance" },
    { .name = "sh-shade",
      .title = "Ringing of a sun as harmonics: in shade",
      .across = "angle of the sun to the normal, degrees",
      .kind = ERROR, .curves = maths_ringing_in_shade,
      .about = "The same where a cone of 30 degrees is seen, 45 degrees off the normal, and nothing else.",
      .number = "most negative irradiance",
      .up = "irradiance" },
    { .name = "hull",
      .title = "Through the hull of a field's occluder",
      .across = "place along the line, in sizes of the table",
      .kind = ERROR, .curves = maths_hull,
      .about = "Occlusion by a table, on a line between its legs, facing up.",
      .number = "largest error",
      .up = "occlusion" },
    { .name = "hull-steps",
      .title = "Through the hull of a field's occluder: steps",
      .across = "place along the line, in sizes of the table",
      .kind = ERROR, .curves = maths_hull_steps,
      .about = "What a hundredth of the table's size adds.",
      .number = "largest step",
      .up = "step of occlusion" },
    { .name = "surfels",
      .title = "Surfel counts with the camera's distance",
      .across = "distance of the camera, times the nearest",
      .kind = ERROR, .log = 1, .curves = maths_popping,
      .about = "Two dozen shapes; how many surfels a step of 1 % of the distance adds or takes. Areas alone would "
               "add 2 %.",
      .number = "largest change",
      .up = "change of the count, a share of it" }
};
const int sweeps_causes = sizeof sweeps_cause / sizeof *sweeps_cause;
_Static_assert(sizeof sweeps_cause / sizeof *sweeps_cause <= MOST_CAUSES, "more causes than MOST_CAUSES");

look sweeps_look(const cause *c, double value, int frame)
{
    look l = { .scene = "plane", .width = c->width, .height = c->width * 9 / 16, .stride = 1, .rays = c->rays };
    c->at(&l, value, frame);
    l.told = c->told;
    return l;
}
