/* looks.c - the scene of a frame, for each cause: rows of looks.csv. Declared in sweeps.h. */
#include <stddef.h>
#include <string.h>
#include "lab/measure/line.h"
#include "lab/stability/sweeps.h"

enum { MOST_NAMES = 16 };
/* A frame that is being made. name: of numbers, those of rows that set no member included. */
typedef struct making {
    look *look;
    int names, boxes;
    kit_variable name[MOST_NAMES];
} making;

static line rows = { SWEEPS_FOLDER, .file = "looks" };

/* ---- >>looks ----------------------------------------------------------------------------------------------------- */

static void numbers(const making *m, float *v, int count)
{
    const char *at = line_cell(&rows, "to"), *where;
    for (int k = 0; k < count; ++k, at += *at == ' ') {
        double is;
        if (kit_expression(&is, &at, m->name, m->names, 0, &where)) line_fault(&rows, "to");
        v[k] = (float)is;
    }
    if (*at) line_fault(&rows, "to");
}

#define REAL(member, count) { #member, offsetof(look, member), count, 0 }
#define WHOLE(member) { #member, offsetof(look, member), 1, 1 }
static const struct { const char *name; size_t at; int count, whole; } members[] = {
    REAL(placed, 16), REAL(eye, 3), REAL(target, 3), REAL(up, 3), REAL(fovy, 1), REAL(znear, 1), REAL(zfar, 1),
    REAL(scale, 1), REAL(aside, 1), REAL(nearer, 1), REAL(roll, 1), REAL(orbit, 1), REAL(radius, 1), REAL(pixels, 1),
    REAL(where, 6), REAL(sun, 3), REAL(dimmed, 1), REAL(lamp, 1), REAL(went, 1), WHOLE(black), WHOLE(bounced),
    WHOLE(format), WHOLE(width), WHOLE(height), WHOLE(stride), WHOLE(within)
};

static void name_number(making *m, const char *name, double is)
{
    if (m->names == MOST_NAMES) line_fault(&rows, "sets");
    m->name[m->names++] = (kit_variable){ name, (int)strlen(name), is };
}

/* Sets the member of a row, or names its number. */
static void set_number(making *m, const char *name)
{
    float v[16];
    size_t k = 0;
    while (k < sizeof members / sizeof *members && strcmp(members[k].name, name)) ++k;
    if (k == sizeof members / sizeof *members) {
        numbers(m, v, 1);
        name_number(m, name, (double)*v);
        return;
    }
    char *const to = (char *)m->look + members[k].at;
    numbers(m, v, members[k].count);
    const int whole = (int)*v;
    memcpy(to, members[k].whole ? (const void *)&whole : v, (size_t)members[k].count * sizeof *v);
}

static void make(making *m, const char *name)
{
    look *const l = m->look;
    const int was = rows.at;
    for (rows.at = 0; rows.at < rows.of.rows; ++rows.at) {
        const char *sets = line_cell(&rows, "sets"), *to = line_cell(&rows, "to");
        if (strcmp(line_cell(&rows, "look"), name)) continue;
        if (!strcmp(sets, "like")) make(m, to);
        else if (!strcmp(sets, "scene")) l->scene = to;
        else if (!strcmp(sets, "only")) l->only = to;
        else if (!strcmp(sets, "box") && m->boxes < BOXES) numbers(m, l->box[m->boxes++], 6);
        else if (!strcmp(sets, "set")) {
            if (to[strlen(to) - 1] == '=') snprintf(l->set, sizeof l->set, "%s%d", to, (int)l->value);
            else snprintf(l->set, sizeof l->set, "%s", to);
        } else set_number(m, sets);
    }
    rows.at = was;
}

int looks_has(const char *name)
{
    if (!rows.of.rows) line_open(&rows);
    return line_find(&rows, "look", name, strlen(name));
}

look sweeps_look(const cause *c, double value, int frame)
{
    look l = { .scene = "plane", .width = c->width, .height = c->width * 9 / 16, .stride = 1, .rays = c->rays,
               .value = (float)value, .frame = frame, .told = c->told, .format = c->format };
    making m = { .look = &l };
    name_number(&m, "v", (double)l.value);
    name_number(&m, "f", frame);
    name_number(&m, "h", l.height);
    name_number(&m, "format", l.format);
    make(&m, c->look);
    return l;
}
