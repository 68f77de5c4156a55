/* settings.c - sets the methods of both halves, and the user's settings in each shown method that has them. */
#include "viewer.h"
#include <stdio.h>
#include <string.h>

int setting_of(kit_setting *out, const kit_method *m, const char *name)
{
    for (int i = 0; kit_method_setting(out, m, i); ++i)
        if (!strcmp(out->key, name)) return 1;
    return 0;
}

int wish(viewer *v, const char *text)
{
    const size_t name = strcspn(text, "=") + 1;
    int i = 0;
    while (i < v->wishes && strncmp(v->wish[i], text, name)) ++i;
    if (i == VIEWER_WISHES || strlen(text) >= sizeof v->wish[i])
        return kit_fail(&v->err, "--set %.60s: is too long, or one too many", text);
    snprintf(v->wish[i], sizeof v->wish[i], "%s", text);
    v->wishes += i == v->wishes;
    return 0;
}

int method_choose(viewer *v, side *s, int number, int strict)
{
    kit_setting setting;
    kit_method m;
    if (!kit_method_at(&m, number)) return kit_fail(&v->err, "there is no method %d", number);
    if (setting_of(&setting, &m, "history")) kit_method_set(&m, "history=1", NULL);
    for (int i = 0; i < v->wishes; ++i)
        if (kit_method_set(&m, v->wish[i], strict ? &v->err : NULL) && strict) return -1;
    s->method = m;
    s->truth = 0;
    v->restart = 1;
    return 0;
}
