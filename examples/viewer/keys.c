/* keys.c - a table of keys, and the functions that they call. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

static int methods(void)
{
    kit_method m;
    int count = 0;
    while (kit_method_at(&m, count)) ++count;
    return count;
}

/* Moves along the list of methods by `by`; for the right half the ground truth comes after the last method. */
static void method(press p)
{
    viewer *v = p.v;
    side *s = &v->side[p.shift && v->split_on];
    const int count = methods(), all = count + (s != v->side), at = s->truth ? count : s->method.number;
    const int next = (at + (int)p.key->by + all) % all;
    kit_method m;
    char text[sizeof v->note];
    v->restart = 1;
    if (next == count) s->truth = 1;
    else method_choose(v, s, next, 0);
    if (!kit_method_at(&m, next)) m = (kit_method){ .name = "truth", .about = "ray-traced" };
    snprintf(text, sizeof text, "%s: %s  (%d of %d)", m.name, m.about, next + 1, all);
    panel_say(v, text);
}

static void wish_both(viewer *v, const char *text)
{
    if (wish(v, text)) {
        panel_say(v, v->err.text);
        return;
    }
    for (int i = 0; i < 2; ++i)
        if (!v->side[i].truth) method_choose(v, &v->side[i], v->side[i].method.number, 0);
    v->restart = 1;
    panel_say(v, text);
}

/* Sets the next value of a setting that is a choice, or of one that is 0 or 1. */
static void next_value(press p)
{
    viewer *v = p.v;
    const char *name = p.key->setting;
    const kit_method *m = &v->side[0].method;
    kit_setting s;
    char text[200];
    if (!setting_of(&s, m, name)) {
        snprintf(text, sizeof text, "%s has no setting %s", m->name, name);
        panel_say(v, text);
        return;
    }
    const int next = (int)s.value + 1 > (int)s.most ? (int)s.least : (int)s.value + 1;
    snprintf(text, sizeof text, "%s=%d", name, next);       /* kit_method_set takes the number of a word, too */
    wish_both(v, text);
}

static void radius(press p)
{
    p.v->radius *= (float)p.key->by;
    p.v->restart = 1;
}

/* ---- >>halves ---------------------------------------------------------------------------------------------------- */

static void split(press p)
{
    viewer *v = p.v;
    side *right = &v->side[1];
    if (!v->split_on) {
        v->split_on = 1;
        right->truth = 0;
        method_choose(v, right, v->side[0].method.number, 0);
    } else if (!right->truth) right->truth = 1;
    else v->split_on = right->truth = 0;
    v->restart = 1;
}

static void split_moved(press p)
{
    p.v->split = fminf(fmaxf(p.v->split + (float)p.key->by, 0.05f), 0.95f);
    p.v->mean = 0;
}

static void error(press p)
{
    p.v->error = !p.v->error;
    p.v->moved = 1;
}

static void colours(press p)
{
    p.v->colours = !p.v->colours;
    p.v->mean = 0;
}

/* ---- >>light ----------------------------------------------------------------------------------------------------- */

static void say_light(viewer *v, const char *text)
{
    char line[400];
    snprintf(line, sizeof line, "%s%s%s", text, v->side[0].method.lit ? "" : "; not seen: no light in ",
             v->side[0].method.lit ? "" : v->side[0].method.name);
    panel_say(v, line);
}

static void say_sun(viewer *v)
{
    const kit_light *s = sun_of(v);
    char text[200];
    snprintf(text, sizeof text, "sun from %.0f, %.0f degrees high, strength %.2f",
             atan2((double)s->at[0], (double)s->at[2]) * 180 / KIT_PI,
             asin(fmin(fmax((double)s->at[1], -1), 1)) * 180 / KIT_PI, (double)s->colour[0]);
    say_light(v, text);
}

/* Turns the sun by degrees about the vertical, and upwards. */
static void turn_sun(viewer *v, double about, double up)
{
    light_changed(v);
    kit_light *s = sun_of(v);
    const double a = atan2((double)s->at[0], (double)s->at[2]) + about * KIT_PI / 180;
    const double h = fmin(fmax(asin(fmin(fmax((double)s->at[1], -1), 1)) + up * KIT_PI / 180, -1.5), 1.5);
    s->at[0] = (float)(sin(a) * cos(h));
    s->at[1] = (float)sin(h);
    s->at[2] = (float)(cos(a) * cos(h));
    say_sun(v);
}

static void sun_about(press p) { turn_sun(p.v, p.key->by, 0); }

static void sun_up(press p) { turn_sun(p.v, 0, p.key->by); }

static void sun_scaled(press p)
{
    light_changed(p.v);
    for (int c = 0; c < 3; ++c) sun_of(p.v)->colour[c] *= (float)p.key->by;
    say_sun(p.v);
}

static void sun(press p)
{
    viewer *v = p.v;
    kit_lighting *l = &v->light.now;
    int i = 0;
    light_changed(v);
    while (i < l->lights && l->light[i].kind != KIT_SUN) ++i;
    if (i == l->lights) {
        sun_of(v);
        say_sun(v);
        return;
    }
    --l->lights;
    memmove(&l->light[i], &l->light[i + 1], (size_t)(l->lights - i) * sizeof l->light[0]);
    say_light(v, "no sun");
}

static void next_sky(press p)
{
    viewer *v = p.v;
    static const char *const names[] = { "sky", "probe", "windows", "street", "white", "" };

    enum { NAMES = (int)(sizeof names / sizeof *names) };

    char text[200];
    int i = 0;
    while (i < NAMES && strcmp(names[i], v->light.env)) ++i;
    v->light.asked = 1;
    if (env_open(v, names[i < NAMES ? (i + 1) % NAMES : 0])) {
        panel_say(v, v->err.text);
        return;
    }
    snprintf(text, sizeof text, "environment: %.180s", *v->light.env ? v->light.env : "none");
    say_light(v, text);
}

static void by_sky(viewer *v, double turn, double factor)
{
    char text[200];
    v->light.turn = fmod(v->light.turn + turn, 360);
    v->light.strength = fmin(v->light.strength * factor, 1e6);
    v->light.asked = 1;
    if (env_adjusted(v)) {
        panel_say(v, v->err.text);
        return;
    }
    snprintf(text, sizeof text, "environment turned by %.0f, strength %.2f", v->light.turn, v->light.strength);
    say_light(v, text);
}

static void sky_about(press p) { by_sky(p.v, p.key->by, 1); }

static void sky_scaled(press p) { by_sky(p.v, 0, p.key->by); }

/* ---- >>the rest -------------------------------------------------------------------------------------------------- */

void slide_to(viewer *v, const float to[3])
{
    float by[3];
    if (!memcmp(to, v->slid, sizeof by)) return;
    truth_stop(&v->truth);
    draw_forget(v);
    for (int i = 0; i < 3; ++i) by[i] = to[i] - v->slid[i];
    if (kit_scene_slide(&v->scene, by, 1, &v->err)) {
        panel_say(v, v->err.text);
        v->slides = 0;
        return;
    }
    memcpy(v->slid, to, sizeof v->slid);
    v->moved = 1;
}

static void back(press p)
{
    viewer *v = p.v;
    static const float nowhere[3];
    memcpy(v->camera.eye, v->home.eye, sizeof v->home.eye);
    memcpy(v->camera.target, v->home.target, sizeof v->home.target);
    v->camera.ortho_height = v->home.ortho_height;
    v->circles = v->slides = 0;
    v->phase = 0;
    slide_to(v, nowhere);
    v->moved = 1;
}

static void circle(press p) { p.v->circles = !p.v->circles; }

static void slide(press p) { p.v->slides = !p.v->slides; }

static void save_png(press p)
{
    draw_window(p.v);
    picture_save(p.v, 0);
}

static void save_exr(press p) { picture_save(p.v, 1); }

static void command(press p) { p.v->asks = 1; }

static void panel(press p) { p.v->panel = !p.v->panel; }

static void help(press p) { p.v->help = !p.v->help; }

static void quit(press p) { glfwSetWindowShouldClose(p.v->window, 1); }

static void next_size(press p)
{
    viewer *v = p.v;
    char text[100];
    v->pace.fixed = !(v->pace.fixed > 0) ? 1 : v->pace.fixed > 0.3 ? v->pace.fixed / 2 : 0;
    v->restart = 1;
    if (v->pace.fixed > 0) snprintf(text, sizeof text, "size: %g of the window's, fixed", v->pace.fixed);
    else snprintf(text, sizeof text, "size: as there is time for");
    panel_say(v, text);
}

const key keys[] = { { GLFW_KEY_M, "m M", "next method: left, right half", method, 1, NULL },
                     { GLFW_KEY_N, "n N", "method before: left, right half", method, -1, NULL },
                     { GLFW_KEY_S, "s", "split: off, a method, the truth", split, 0, NULL },
                     { GLFW_KEY_LEFT, "left", "split to the left", split_moved, -0.02, NULL },
                     { GLFW_KEY_RIGHT, "right", "split to the right", split_moved, 0.02, NULL },
                     { GLFW_KEY_E, "e", "error to the truth", error, 0, NULL },
                     { GLFW_KEY_LEFT_BRACKET, "[", "smaller radius", radius, 1 / 1.1, NULL },
                     { GLFW_KEY_RIGHT_BRACKET, "]", "larger radius", radius, 1.1, NULL },
                     { GLFW_KEY_B, "b", "the thickness of surfaces (thickness=)", next_value, 0, "thickness" },
                     { GLFW_KEY_D, "d", "normals: given, of depth (normal=)", next_value, 0, "normal" },
                     { GLFW_KEY_T, "t", "history on, off (history=)", next_value, 0, "history" },
                     { GLFW_KEY_C, "c", "visibility: on colours, alone", colours, 0, NULL },
                     { GLFW_KEY_U, "u", "sun on, off", sun, 0, NULL },
                     { GLFW_KEY_J, "j", "sun to the left", sun_about, 5, NULL },
                     { GLFW_KEY_L, "l", "sun to the right", sun_about, -5, NULL },
                     { GLFW_KEY_I, "i", "sun higher", sun_up, 5, NULL },
                     { GLFW_KEY_K, "k", "sun lower", sun_up, -5, NULL },
                     { GLFW_KEY_MINUS, "-", "sun weaker", sun_scaled, 0.8, NULL },
                     { GLFW_KEY_EQUAL, "=", "sun stronger", sun_scaled, 1.25, NULL },
                     { GLFW_KEY_Y, "y", "next environment, or none", next_sky, 0, NULL },
                     { GLFW_KEY_COMMA, ",", "environment to the left", sky_about, 15, NULL },
                     { GLFW_KEY_PERIOD, ".", "environment to the right", sky_about, -15, NULL },
                     { GLFW_KEY_9, "9", "environment weaker", sky_scaled, 0.8, NULL },
                     { GLFW_KEY_0, "0", "environment stronger", sky_scaled, 1.25, NULL },
                     { GLFW_KEY_R, "r", "camera and object back", back, 0, NULL },
                     { GLFW_KEY_A, "a", "camera circles", circle, 0, NULL },
                     { GLFW_KEY_V, "v", "an object moves", slide, 0, NULL },
                     { GLFW_KEY_F, "f", "size: by time, whole, 1/2, 1/4", next_size, 0, NULL },
                     { GLFW_KEY_O, "o", "PNG of the window, without text", save_png, 0, NULL },
                     { GLFW_KEY_X, "x", "EXR of the left half", save_exr, 0, NULL },
                     { GLFW_KEY_W, "w", "build/render's line, printed", command, 0, NULL },
                     { GLFW_KEY_G, "g", "panel", panel, 0, NULL },
                     { GLFW_KEY_H, "h", "these keys", help, 0, NULL },
                     { GLFW_KEY_Q, "q", "quit", quit, 0, NULL },
                     { GLFW_KEY_ESCAPE, "escape", "quit", quit, 0, NULL },
                     { 0, NULL, NULL, NULL, 0, NULL } };
