/* keys.c - what keys do, and the table of them. */
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

/* The method by so many in the list; that of the right half may be the truth, behind the last. */
static void by_method(viewer *v, int shift, int by)
{
    side *s = &v->side[shift && v->split_on];
    const int count = methods(), all = count + (s != v->side), at = s->truth ? count : s->method.number;
    const int next = (at + by + all) % all;
    kit_method m;
    char text[sizeof v->note];
    v->restart = 1;
    if (next == count) s->truth = 1;
    else method_choose(v, s, next, 0);
    if (!kit_method_at(&m, next)) m = (kit_method){ .name = "truth", .about = "ray-traced" };
    snprintf(text, sizeof text, "%s: %s  (%d of %d)", m.name, m.about, next + 1, all);
    panel_say(v, text);
}

static void next_method(viewer *v, int shift) { by_method(v, shift, 1); }

static void last_method(viewer *v, int shift) { by_method(v, shift, -1); }

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

/* The next value of a setting that is a choice, or 0 and 1. */
static void next_value(viewer *v, const char *name)
{
    const kit_method *m = &v->side[0].method;
    kit_setting s;
    char text[200];
    if (!setting_of(&s, m, name)) {
        snprintf(text, sizeof text, "%s has no setting %s", m->name, name);
        panel_say(v, text);
        return;
    }
    const int next = (int)s.value + 1 > (int)s.most ? (int)s.least : (int)s.value + 1;
    snprintf(text, sizeof text, "%s=%d", name, next);       /* a choice takes the number of its word, too */
    wish_both(v, text);
}

static void thickness(viewer *v, int shift)
{
    (void)shift;
    next_value(v, "thickness");
}

static void normals(viewer *v, int shift)
{
    (void)shift;
    next_value(v, "normal");
}

static void history(viewer *v, int shift)
{
    (void)shift;
    next_value(v, "history");
}

static void by_radius(viewer *v, float factor)
{
    v->radius *= factor;
    v->restart = 1;
}

static void less_radius(viewer *v, int shift)
{
    (void)shift;
    by_radius(v, 1 / 1.1f);
}

static void more_radius(viewer *v, int shift)
{
    (void)shift;
    by_radius(v, 1.1f);
}

/* ---- >>halves ---------------------------------------------------------------------------------------------------- */

static void split(viewer *v, int shift)
{
    side *right = &v->side[1];
    (void)shift;
    if (!v->split_on) {
        v->split_on = 1;
        right->truth = 0;
        method_choose(v, right, v->side[0].method.number, 0);
    } else if (!right->truth) right->truth = 1;
    else v->split_on = right->truth = 0;
    v->restart = 1;
}

static void by_split(viewer *v, float by)
{
    v->split = fminf(fmaxf(v->split + by, 0.05f), 0.95f);
    v->mean = 0;
}

static void split_left(viewer *v, int shift)
{
    (void)shift;
    by_split(v, -0.02f);
}

static void split_right(viewer *v, int shift)
{
    (void)shift;
    by_split(v, 0.02f);
}

static void error(viewer *v, int shift)
{
    (void)shift;
    v->error = !v->error;
    v->moved = 1;
}

static void colours(viewer *v, int shift)
{
    (void)shift;
    v->colours = !v->colours;
    v->mean = 0;
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

/* Degrees about the vertical, and up. */
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

static void scale_sun(viewer *v, float by)
{
    light_changed(v);
    for (int c = 0; c < 3; ++c) sun_of(v)->colour[c] *= by;
    say_sun(v);
}

static void sun_left(viewer *v, int shift)
{
    (void)shift;
    turn_sun(v, 5, 0);
}

static void sun_right(viewer *v, int shift)
{
    (void)shift;
    turn_sun(v, -5, 0);
}

static void sun_up(viewer *v, int shift)
{
    (void)shift;
    turn_sun(v, 0, 5);
}

static void sun_down(viewer *v, int shift)
{
    (void)shift;
    turn_sun(v, 0, -5);
}

static void weaker_sun(viewer *v, int shift)
{
    (void)shift;
    scale_sun(v, 0.8f);
}

static void stronger_sun(viewer *v, int shift)
{
    (void)shift;
    scale_sun(v, 1.25f);
}

static void sun(viewer *v, int shift)
{
    kit_lighting *l = &v->light.now;
    int i = 0;
    (void)shift;
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

static void next_sky(viewer *v, int shift)
{
    static const char *const names[] = { "sky", "probe", "windows", "street", "white", "" };

    enum { NAMES = (int)(sizeof names / sizeof *names) };

    char text[200];
    int i = 0;
    (void)shift;
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

static void sky_left(viewer *v, int shift)
{
    (void)shift;
    by_sky(v, 15, 1);
}

static void sky_right(viewer *v, int shift)
{
    (void)shift;
    by_sky(v, -15, 1);
}

static void weaker_sky(viewer *v, int shift)
{
    (void)shift;
    by_sky(v, 0, 0.8);
}

static void stronger_sky(viewer *v, int shift)
{
    (void)shift;
    by_sky(v, 0, 1.25);
}

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

static void back(viewer *v, int shift)
{
    static const float nowhere[3];
    (void)shift;
    memcpy(v->camera.eye, v->home.eye, sizeof v->home.eye);
    memcpy(v->camera.target, v->home.target, sizeof v->home.target);
    v->camera.ortho_height = v->home.ortho_height;
    v->circles = v->slides = 0;
    v->phase = 0;
    slide_to(v, nowhere);
    v->moved = 1;
}

static void circle(viewer *v, int shift)
{
    (void)shift;
    v->circles = !v->circles;
}

static void slide(viewer *v, int shift)
{
    (void)shift;
    v->slides = !v->slides;
}

static void save_png(viewer *v, int shift)
{
    (void)shift;
    draw_window(v);
    picture_save(v, 0);
}

static void save_exr(viewer *v, int shift)
{
    (void)shift;
    picture_save(v, 1);
}

static void command(viewer *v, int shift)
{
    (void)shift;
    v->asks = 1;
}

static void panel(viewer *v, int shift)
{
    (void)shift;
    v->panel = !v->panel;
}

static void help(viewer *v, int shift)
{
    (void)shift;
    v->help = !v->help;
}

static void quit(viewer *v, int shift)
{
    (void)shift;
    glfwSetWindowShouldClose(v->window, 1);
}

static void next_size(viewer *v, int shift)
{
    char text[100];
    (void)shift;
    v->pace.fixed = !(v->pace.fixed > 0) ? 1 : v->pace.fixed > 0.3 ? v->pace.fixed / 2 : 0;
    v->restart = 1;
    if (v->pace.fixed > 0) snprintf(text, sizeof text, "size: %g of the window's, fixed", v->pace.fixed);
    else snprintf(text, sizeof text, "size: as there is time for");
    panel_say(v, text);
}

const key keys[] = { { GLFW_KEY_M, "m M", "next method: left, right half", next_method },
                     { GLFW_KEY_N, "n N", "method before: left, right half", last_method },
                     { GLFW_KEY_S, "s", "split: off, a method, the truth", split },
                     { GLFW_KEY_LEFT, "left", "split to the left", split_left },
                     { GLFW_KEY_RIGHT, "right", "split to the right", split_right },
                     { GLFW_KEY_E, "e", "error to the truth", error },
                     { GLFW_KEY_LEFT_BRACKET, "[", "smaller radius", less_radius },
                     { GLFW_KEY_RIGHT_BRACKET, "]", "larger radius", more_radius },
                     { GLFW_KEY_B, "b", "the thickness of surfaces (thickness=)", thickness },
                     { GLFW_KEY_D, "d", "normals: given, of depth (normal=)", normals },
                     { GLFW_KEY_T, "t", "history on, off (history=)", history },
                     { GLFW_KEY_C, "c", "visibility: on colours, alone", colours },
                     { GLFW_KEY_U, "u", "sun on, off", sun },
                     { GLFW_KEY_J, "j", "sun to the left", sun_left },
                     { GLFW_KEY_L, "l", "sun to the right", sun_right },
                     { GLFW_KEY_I, "i", "sun higher", sun_up },
                     { GLFW_KEY_K, "k", "sun lower", sun_down },
                     { GLFW_KEY_MINUS, "-", "sun weaker", weaker_sun },
                     { GLFW_KEY_EQUAL, "=", "sun stronger", stronger_sun },
                     { GLFW_KEY_Y, "y", "next environment, or none", next_sky },
                     { GLFW_KEY_COMMA, ",", "environment to the left", sky_left },
                     { GLFW_KEY_PERIOD, ".", "environment to the right", sky_right },
                     { GLFW_KEY_9, "9", "environment weaker", weaker_sky },
                     { GLFW_KEY_0, "0", "environment stronger", stronger_sky },
                     { GLFW_KEY_R, "r", "camera and object back", back },
                     { GLFW_KEY_A, "a", "camera circles", circle },
                     { GLFW_KEY_V, "v", "an object moves", slide },
                     { GLFW_KEY_F, "f", "size: by time, whole, 1/2, 1/4", next_size },
                     { GLFW_KEY_O, "o", "PNG of the window, without text", save_png },
                     { GLFW_KEY_X, "x", "EXR of the left half", save_exr },
                     { GLFW_KEY_W, "w", "build/render's line, printed", command },
                     { GLFW_KEY_G, "g", "panel", panel },
                     { GLFW_KEY_H, "h", "these keys", help },
                     { GLFW_KEY_Q, "q", "quit", quit },
                     { GLFW_KEY_ESCAPE, "escape", "quit", quit },
                     { 0, NULL, NULL, NULL } };
