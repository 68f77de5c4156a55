/* command.c - the picture of the left half as a line for build/render. */
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

/* As a shell reads it. */
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

static void add_numbers(line *l, const char *option, const float *a, const float *b)
{
    add(l, " %s ", option);
    for (int i = 0; i < (b ? 6 : 3); ++i) add(l, "%s%.9g", i ? "," : "", (double)(i < 3 ? a[i] : b[i - 3]));
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
        add(l, " --light %s:%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", at->kind == KIT_SUN ? "sun" : "point", (double)at->at[0],
            (double)at->at[1], (double)at->at[2], (double)at->colour[0], (double)at->colour[1], (double)at->colour[2]);
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
    add_numbers(&l, "--camera", c->eye, c->target);
    add_numbers(&l, "--up", c->up, NULL);
    if (c->fovy > 0) add(&l, " --fovy %.9g", (double)c->fovy);
    else add(&l, " --ortho-height %.9g", (double)c->ortho_height);
    add(&l, " --size %dx%d", v->drawn[0], v->drawn[1]);
    if (s->method.lit) add_light(&l, v);
    else if (v->colours) add(&l, " --colours");
    if (v->slid[0] != 0 || v->slid[1] != 0 || v->slid[2] != 0) add_numbers(&l, "--slide", v->slid, NULL);
    if (s->method.set.history && s->frames.since > 1)
        add(&l, " --still %u", s->frames.since < VIEWER_STILL ? s->frames.since : (unsigned)VIEWER_STILL);
    add(&l, " --out picture.png");
    puts(l.text);
    fflush(stdout);
    panel_say(v, "the line for build/render is on standard output");
}
