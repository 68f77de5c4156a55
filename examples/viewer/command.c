/* command.c - writes the command line of build/render that draws the image of the left half. */
#include "viewer.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

typedef struct line {
    char text[16384];
    size_t used;
} line;

#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
static void
add(line *l, const char *format, ...)
{
    va_list list;
    if (l->used >= sizeof l->text) return;
    va_start(list, format);
    l->used += (size_t)vsnprintf(l->text + l->used, sizeof l->text - l->used, format, list);
    va_end(list);
}

/* Adds a word, quoted as a shell needs it. */
static void add_word(line *l, const char *word)
{
    const char *plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+";
    if (*word && !word[strspn(word, plain)]) {
        add(l, " %s", word);
        return;
    }
    add(l, " '");
    for (; *word; ++word)
        if (*word == '\'') add(l, "'\\''");
        else add(l, "%c", *word);
    add(l, "'");
}

static void add_numbers(line *l, const char *before, const float v[3])
{
    add(l, "%s%.9g,%.9g,%.9g", before, (double)v[0], (double)v[1], (double)v[2]);
}

/* Adds a point, in the coordinates of the scene's file. */
static void add_place(line *l, const viewer *v, const char *before, const float at[3])
{
    const double *origin = v->scene.mesh.origin;
    for (int i = 0; i < 3; ++i)
        add(l, "%s%.*g", i ? "," : before, origin[i] != 0 ? 17 : 9, origin[i] + (double)at[i]);
}

static void add_light(line *l, const viewer *v)
{
    const kit_lighting *now = &v->light.now;
    const int dark = !*v->light.env && !now->lights;
    if (*v->light.env || dark) {
        add(l, " --env");
        add_word(l, dark ? "white" : v->light.env);
    }
    if (dark) add(l, " --env-strength 0");
    else if (*v->light.env) {
        if (v->light.turn != 0) add(l, " --env-turn %.9g", v->light.turn);
        if (v->light.strength != 1) add(l, " --env-strength %.9g", v->light.strength);
        add(l, " --backdrop");
    }
    for (int i = 0; i < now->lights; ++i) {
        const kit_light *at = &now->light[i];
        if (at->kind == KIT_POINT) add_place(l, v, " --light point:", at->at);
        else add_numbers(l, " --light sun:", at->at);
        add_numbers(l, ",", at->colour);
    }
}

void command_print(viewer *v)
{
    static line l;
    const kit_camera *c = &v->camera;
    const side *s = &v->side[0];
    char set[1024];
    l.used = 0;
    add(&l, "build/render");
    add_word(&l, v->path);
    if (v->ground) add(&l, " --ground");
    add(&l, " --method %s", s->method.name);
    kit_method_text(set, sizeof set, &s->method);
    if (*set) add(&l, " --set %s", set);
    if (!s->method.between) add(&l, " --radius %.9g", (double)v->radius);
    add_place(&l, v, " --camera ", c->eye);
    add_place(&l, v, ",", c->target);
    add_numbers(&l, " --up ", c->up);
    if (c->fovy > 0) add(&l, " --fovy %.9g", (double)c->fovy);
    else add(&l, " --ortho-height %.9g", (double)c->ortho_height);
    add(&l, " --size %dx%d", v->drawn[0], v->drawn[1]);
    if (s->method.lit) add_light(&l, v);
    else if (v->colours) add(&l, " --colours");
    if (v->slid[0] != 0 || v->slid[1] != 0 || v->slid[2] != 0) add_numbers(&l, " --slide ", v->slid);
    if (s->method.set.history && s->frames.since > 1)
        add(&l, " --still %u", s->frames.since < VIEWER_STILL ? s->frames.since : (unsigned)VIEWER_STILL);
    add(&l, " --out picture.png");
    puts(l.text);
    fflush(stdout);
    panel_say(v, "the line for build/render is on standard output");
}
