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

/* Rolled by ten degrees: what is thinner than a pixel is seen here and there. */
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

/* Two sheets side by side, half a radius before a wall; of the wall what is seen between them is scored. */
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

/* The ground along a box' side, as far as it is seen beside an edge: the picture's, or that of a screen in front. */
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

/* The camera turns to the right: a box whose last 0.15 were in the picture leaves it. */
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

/* Depths of 4.9 times a power of two, so that nothing but depth's precision changes. */
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

/* A box on a floor, so many pixels from the middle; went: since the frame before. */
static void box_at(look *l, float pixels, float went)
{
    const float pixel = 2 * 5 * tanf(15 * DEGREE) / (float)l->height, x = pixels * pixel;
    l->went = went * pixel;
    camera(l, 0, 3, 4, 0, 0.2f, 0, 30);
    l->radius = 0.6f;
    set_box(l->box[0], x - 0.4f, 0.001f, -0.4f, x + 0.4f, 0.7f, 0.4f);
}
static void slid(look *l) { box_at(l, l->value * (float)(l->frame - CHANGED), l->value); }
/* What was not there before has not moved. */
static void appeared(look *l) { box_at(l, l->frame < CHANGED ? 1000 : 0, 0); }
static void vanished(look *l) { box_at(l, l->frame < CHANGED ? -20 : 20, l->frame == CHANGED ? 40 : 0); }
/* Nothing says that it is another view: the worst that a cut can do. */
static void jumped(look *l)
{
    l->scene = "casters";
    l->aside = l->frame < CHANGED ? 0 : 40;
    l->nearer = l->frame < CHANGED ? 0 : 0.3f;
}

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

#define DEPTHS   { 1.2225, 78.24, 1251.84, 5007.36, 10014.72, 20029.44, 40058.88, 80117.76 }
#define SLIDING  { -0.8, -0.6, -0.4, -0.2, -0.001, 0.2, 0.4, 0.6, 0.8 }
const cause sweeps_cause[] = {
    { "tilt", "View tilt, a bare plane", "tilt of the view against the plane's normal, degrees",
      "A plane occludes nothing of itself: all that is seen is false.",
      ERROR, AMBIENT, 240, 16, 0, tilt, .value = { 0.001, 30, 50, 65, 75, 80, 84, 87, 89 } },
    { "tilt-wall", "View tilt, a plane and a wall", "tilt of the view against the plane's normal, degrees",
      "A low wall along the line of sight; both are scored.",
      ERROR, AMBIENT, 240, 128, 0, tilt_wall, .value = { 0.001, 30, 50, 65, 75, 80, 84, 87, 89 } },
    { "pole", "Thickness: a pole before a far wall", "thickness of the pole, pixels",
      "The wall is almost four radii behind: it is open, and darkness around the pole is a halo.",
      ERROR, AMBIENT | THIN, 240, 64, 1, pole, .value = { 0.1, 0.3, 1, 2, 4, 10, 20 } },
    { "rail", "Thickness: a rail above a floor", "thickness of the rail, pixels",
      "Half a radius above the floor: its occlusion goes with its thickness.",
      ERROR, AMBIENT | THIN, 240, 128, 1, rail, .value = { 0.1, 0.3, 1, 2, 4, 10, 20 } },
    { "halo", "Distance behind a depth discontinuity", "distance of the wall behind the screen's edge, radii",
      "A screen before a wall; of the wall two radii beside the edge are scored. Beyond one radius it is open.",
      ERROR, AMBIENT | THIN, 240, 128, 1, screen, .value = { 0.1, 0.3, 0.6, 1, 1.5, 3, 10, 30 } },
    { "slot", "Through a slot between two sheets", "width of the slot, radii",
      "Sheets a hundredth of the radius thick, half a radius before a wall, which is scored: taken for as thick as "
      "they are wide, they darken it.",
      ERROR, AMBIENT | THIN, 240, 128, 1, slot, .value = { 0.2, 0.4, 0.8, 1.6, 3.2 } },
    { "radius", "Radius, from a tenth of a pixel to the whole screen", "radius, pixels at the middle of the room",
      "Room.",
      ERROR, AMBIENT, 240, 64, 1, of_pixels, .value = { 0.1, 0.3, 1, 3, 10, 30, 80, 240 } },
    { "off-screen", "Sliding off the screen", "how far the box is off the screen, radii",
      "A box slides off; the ground beside it, or beside the picture's border, is scored. Of aof: occlusion at any "
      "distance, against its own truth, here and below.",
      ERROR, AMBIENT | FIELD, 240, 128, 0, off_screen, .value = SLIDING },
    { "turned-off", "Sliding off the screen as the camera turns", "pixels a frame",
      "The last of a box leaves the picture: what is expected beyond the border is to follow it, not to flicker. The "
      "ground beside the box.",
      SECOND, AMBIENT, 240, 128, 1, turned_off, .value = { 0.25, 0.5, 1, 2, 4, 8 } },
    { "hidden", "Sliding behind another", "how far the box is behind the screen's edge, radii",
      "A box slides behind a screen in front; the ground beside it, or beside the screen's edge, is scored.",
      ERROR, AMBIENT | FIELD, 240, 128, 0, behind, .value = SLIDING },
    { "near-plane", "Crossing the near plane", "front of the box before the near plane, radii",
      "A box comes toward the camera, is cut open, and is gone at -0.8; the ground beside it is scored.",
      ERROR, AMBIENT | FIELD, 240, 128, 0, near_plane, .value = { 1.2, 0.8, 0.4, 0.1, -0.1, -0.3, -0.5, -0.7, -0.9 } },
    { "depth-16f", "View depth stored as 16 bits of float", "view depth",
      "Boxes, near plane at 0.1; the radius is of the same number of pixels at all depths, and only precision "
      "changes. To the picture with exact depth.",
      PRECISION, AMBIENT, 160, 0, 1, stored, .value = DEPTHS, .format = HALF },
    { "depth-24", "View depth as 24 bits of window depth", "view depth",
      "The same.",
      PRECISION, AMBIENT, 160, 0, 1, stored, .value = DEPTHS, .format = UNORM24 },
    { "depth-32f", "View depth as 32 bits of window depth, float", "view depth",
      "The same.",
      PRECISION, AMBIENT, 160, 0, 1, stored, .value = DEPTHS, .format = FLOAT32 },
    { "depth-reversed", "View depth as 32 bits of reversed window depth, float", "view depth",
      "The same.",
      PRECISION, AMBIENT, 160, 0, 1, stored, .value = DEPTHS, .format = REVERSED32 },
    { "camera", "The camera moves sideways", "pixels a frame",
      "Two dozen shapes. Places that all frames show, between four pixels each.",
      DEVIATION, AMBIENT | FIELD, 160, 128, 1, moved, .value = { 0.1, 0.25, 0.5, 1, 2, 4 } },
    { "dolly", "The camera comes closer", "percent of the distance a frame",
      "The same, for surfels that pop.",
      DEVIATION, AMBIENT | FIELD, 160, 128, 1, closer, .value = { 0.1, 0.3, 1, 3 } },
    { "light", "The sun turns", "degrees a frame",
      "Three boxes under the sky and a soft sun, in the environment.",
      LIT_SECOND, TURNED, 160, 256, 1, sun, .value = { 0.25, 0.5, 1, 2, 4, 8 } },
    { "rotation", "An object turns", "degrees a frame",
      "A table on a ground; places move with it.",
      SECOND, AMBIENT | FIELD, 160, 256, 1, turning, .value = { 0.25, 0.5, 1, 2, 4, 8 } },
    { "kept-camera", "Over frames: the camera moves sideways", "pixels a frame",
      "Two dozen shapes, sixteen frames; the first value stands still. Under white light ssdo is all but hsao: the "
      "same slices.",
      FOLLOWS, KEPT, 160, 64, 1, moved, .value = { 1e-4, 0.1, 0.25, 0.5, 1, 2, 4 } },
    { "kept-dolly", "Over frames: the camera comes closer", "percent a frame",
      "The same.",
      FOLLOWS, KEPT, 160, 64, 1, closer, .value = { 0.1, 0.3, 1 } },
    { "kept-roll", "Over frames: the camera rolls", "degrees a frame",
      "The same.",
      FOLLOWS, KEPT, 160, 64, 1, rolled, .value = { 0.1, 0.3, 1 } },
    { "kept-slide", "Over frames: a box slides over a floor", "pixels a frame",
      "Without motion vectors.",
      FOLLOWS, KEPT, 160, 64, 1, slid, .value = { 0.1, 0.25, 0.5, 1, 2, 4 } },
    { "kept-appear", "Over frames: a box appears", "frames after",
      "Without motion vectors.",
      AFTER, KEPT, 160, 64, 1, appeared, .value = { 1, 2, 3, 5, 8 } },
    { "kept-jump", "Over frames: a box is elsewhere at once", "frames after",
      "Without motion vectors.",
      AFTER, KEPT, 160, 64, 1, vanished, .value = { 1, 2, 3, 5, 8 } },
    { "kept-trail-appear", "Over frames: a box appears, what is left of the light that was", "frames after",
      "Where the truth changed by more than 0.05.",
      TRAIL, KEPT, 160, 64, 1, appeared, .value = { 1, 2, 3, 5, 8 } },
    { "kept-trail-jump", "Over frames: a box is elsewhere at once, what is left of what was", "frames after",
      "Where the truth changed by more than 0.05.",
      TRAIL, KEPT, 160, 64, 1, vanished, .value = { 1, 2, 3, 5, 8 } },
    { "kept-held-appear", "Over frames: a box appears, pixels that hold what was", "frames after",
      "Pixel by pixel, where the truth changed by more than 0.05.",
      HELD, KEPT, 320, 64, 1, appeared, .value = { 1, 2, 3, 4, 8 } },
    { "kept-held-jump", "Over frames: a box is elsewhere at once, pixels that hold what was", "frames after",
      "The same.",
      HELD, KEPT, 320, 64, 1, vanished, .value = { 1, 2, 3, 4, 8 } },
    { "kept-slide-told", "Over frames: a box slides over a floor, with motion vectors", "pixels a frame",
      "The box's own; of all else 0.",
      FOLLOWS, KEPT, 160, 64, 1, slid, .value = { 0.1, 0.25, 0.5, 1, 2, 4 }, .told = 1 },
    { "kept-held-appear-told", "Over frames: a box appears, pixels that hold what was, with motion vectors",
      "frames after",
      "They are 0: what was not there before has not moved.",
      HELD, KEPT, 320, 64, 1, appeared, .value = { 1, 2, 3, 4, 8 }, .told = 1 },
    { "kept-held-jump-told", "Over frames: a box is elsewhere at once, pixels that hold what was, with motion vectors",
      "frames after",
      "The box's own; of all else 0.",
      HELD, KEPT, 320, 64, 1, vanished, .value = { 1, 2, 3, 4, 8 }, .told = 1 },
    { "kept-flicker", "Over frames: deviation while the camera moves sideways", "pixels a frame",
      "Eight frames, after eight that are not counted.",
      DEVIATION, KEPT, 160, 64, 1, moved, .value = { 0.1, 0.25, 0.5, 1 } },
    { "kept-cut", "Over frames: another view that nobody tells of", "frames after",
      "A cut that is told of starts anew.",
      AFTER, KEPT, 160, 64, 1, jumped, .value = { 1, 2, 3, 5, 8 } },
    { "kept-newly", "Over frames: what the frame before did not show", "pixels a frame",
      "Two dozen shapes, the camera moves sideways: beside silhouettes, and at the picture's border.",
      NEWLY, KEPT, 160, 64, 1, moved, .value = { 1, 2, 4, 8 } },
    { "kept-light", "Over frames: the sun turns", "degrees a frame",
      "Three boxes under the sky and a soft sun; the first value stands still. Nothing tells that light changed: "
      "what is seen is its lag.",
      FOLLOWS, KEPT_LIGHT, 160, 64, 1, lit_within, .value = { 1e-4, 0.5, 2, 8 } },
    { "kept-switch", "Over frames: the sun goes out", "frames after",
      "The same, and nineteen parts of twenty of the sun are gone at once.",
      AFTER, KEPT_LIGHT, 160, 64, 1, switched, .value = { 1, 2, 3, 5, 8 } },
    { "kept-tremble", "Over frames: the sun flickers", "percent that each second frame lacks",
      "The same: light that flickers must be seen to.",
      FOLLOWS, KEPT_LIGHT, 160, 64, 1, trembling, .value = { 3, 10, 30, 90 } },
    { "resolution", "Resolution at constant angular radius", "pixels across",
      "Room, from 160 x 90 to 3840 x 2160.",
      ERROR, AMBIENT, 160, 128, 1, sized, .value = { 160, 320, 640, 1280, 1920, 3840 } },
    { "sh-open", "Ringing of a sun as harmonics: an open surface", "angle of the sun to the normal, degrees",
      "Irradiance over that of an open surface that faces the sun.",
      .curves = maths_ringing_open, .number = "most negative irradiance", .up = "irradiance" },
    { "sh-shade", "Ringing of a sun as harmonics: in shade", "angle of the sun to the normal, degrees",
      "The same where a cone of 30 degrees is seen, 45 degrees off the normal, and nothing else.",
      .curves = maths_ringing_in_shade, .number = "most negative irradiance", .up = "irradiance" },
    { "hull", "Through the hull of a field's occluder", "place along the line, in sizes of the table",
      "Occlusion by a table, on a line between its legs, facing up.",
      .curves = maths_hull, .number = "largest error", .up = "occlusion" },
    { "hull-steps", "Through the hull of a field's occluder: steps", "place along the line, in sizes of the table",
      "What a hundredth of the table's size adds.",
      .curves = maths_hull_steps, .number = "largest step", .up = "step of occlusion" },
    { "surfels", "Surfel counts with the camera's distance", "distance of the camera, times the nearest",
      "Two dozen shapes; how many surfels a step of 1 % of the distance adds or takes. Areas alone would add 2 %.",
      .curves = maths_popping, .log = 1, .number = "largest change", .up = "change of the count, a share of it" }
};
const int sweeps_causes = sizeof sweeps_cause / sizeof *sweeps_cause;
_Static_assert(sizeof sweeps_cause / sizeof *sweeps_cause <= MOST_CAUSES, "more causes than MOST_CAUSES");

look sweeps_look(const cause *c, double value, int frame)
{
    look l = { .scene = "plane", .width = c->width, .height = c->width * 9 / 16, .stride = 1, .rays = c->rays,
               .value = (float)value, .frame = frame, .told = c->told, .format = c->format };
    c->at(&l);
    return l;
}
