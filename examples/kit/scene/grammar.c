/* grammar.c - builds scenes from rows: draws places, numbers and sizes of things by chances that follow from names.
   Declared in kit_seed.h, which explains the columns. */
#include "kit/kit_seed.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VARIABLES = 256, NUMBERS = 64, ALTERNATIVES = 24, DEEPEST = 24, CLAIMS = 1024, TRIES = 16 };
/* No thing is begun after so many triangles, and a model that would exceed them is left out. */
enum { MOST_TRIANGLES = 220000, MOST_MODEL = 60000 };

typedef struct claim { double at[3], radius; } claim;

enum { MODELS_KEPT = 24 };

typedef struct kept { const char *name; int length; kit_mesh mesh; } kept;

typedef struct walk {
    kit_plot *p;
    kit_error *err;
    int models;
    kept model[MODELS_KEPT];               /* models read so far */
    const kit_row *row;                    /* for error messages */
    int variables, deep, claims;
    uint32_t thing;                        /* seed of the colours of the thing that is being built */
    kit_variable variable[VARIABLES];
    claim claim[CLAIMS];
} walk;

/* ---- >>chances --------------------------------------------------------------------------------------------------- */

static uint32_t mixed(uint32_t key, uint32_t with)
{
    uint32_t x = (key ^ with) + 0x9e3779b9u * (with + 1);
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

static uint32_t mixed_text(uint32_t key, const char *text, size_t length)
{
    uint32_t x = 2166136261u;
    for (size_t i = 0; i < length; i++) x = (x ^ (unsigned char)text[i]) * 16777619u;
    return mixed(key, x);
}

static double chance_of(uint32_t key) { return (double)key * 0x1p-32; }

/* ---- >>numbers --------------------------------------------------------------------------------------------------- */

/* an expression that is being read; drawn: number of random numbers drawn so far */
typedef struct reading {
    const kit_variable *variable;
    int variables;
    const char *at;
    uint32_t key, drawn;
    const char *why, *where;               /* the first fault; NULL: there is none */
} reading;

static void wrong(walk *w, const char *why, const char *at)
{
    if (!*w->err->text) kit_fail(w->err, "row '%s': %s at '%.20s'", w->row ? w->row->name : "", why, at);
}

static void misread(reading *r, const char *why, const char *at)
{
    if (r->why) return;
    r->why = why;
    r->where = at;
}

static double alternatives(reading *r);

#define LETTERS "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"

static int word_length(const char *at) { return (int)strspn(at, LETTERS); }

static double called(int function, double a, double b)
{
    switch (function) {
    case 0: return sin(a * KIT_PI / 180);
    case 1: return cos(a * KIT_PI / 180);
    case 2: return tan(a * KIT_PI / 180);
    case 3: return fabs(a);
    case 4: return floor(a);
    case 5: return a >= 0;
    case 6: return fmax(a, b);
    default: return pow(a, b);
    }
}

static double named(reading *r)
{
    static const char *const functions[] = { "sin", "cos", "tan", "abs", "int", "from", "max", "pow" };
    const char *const word = r->at;
    const int length = word_length(word);
    r->at += length;
    if (*r->at == '(') {
        ++r->at;
        const double a = alternatives(r), b = *r->at == ',' ? ++r->at, alternatives(r) : 0;
        if (*r->at == ')') ++r->at;
        for (int k = 0; k < (int)(sizeof functions / sizeof *functions); k++)
            if (!strncmp(word, functions[k], (size_t)length) && !functions[k][length]) return called(k, a, b);
    }
    for (int k = r->variables; k-- > 0;) {
        const kit_variable *v = &r->variable[k];
        if (v->length == length && !memcmp(v->name, word, (size_t)length)) return v->value;
    }
    misread(r, "no such number or function", word);
    return 0;
}

static double primary(reading *r)
{
    double v = 0;
    if (*r->at == '-') {
        ++r->at;
        return -primary(r);
    }
    if (*r->at == '(') {
        ++r->at;
        v = alternatives(r);
        if (*r->at != ')') misread(r, "a bracket is open", r->at);
        else ++r->at;
        return v;
    }
    if (strchr("0123456789.", *r->at) && *r->at) {
        double part = 1;
        for (; *r->at >= '0' && *r->at <= '9'; ++r->at) v = 10 * v + (*r->at - '0');
        if (*r->at == '.')
            for (++r->at; *r->at >= '0' && *r->at <= '9'; ++r->at) v += (*r->at - '0') * (part /= 10);
        return v;
    }
    if (word_length(r->at)) return named(r);
    misread(r, "no number", r->at);
    r->at += strcspn(r->at, " ");
    return 0;
}

static double product(reading *r)
{
    double v = primary(r);
    while (*r->at == '*' || *r->at == '/') {
        const char op = *r->at++;
        const double by = primary(r);
        v = op == '*' ? v * by : v / by;
    }
    return v;
}

static double sum(reading *r)
{
    double v = product(r);
    while (*r->at == '+' || *r->at == '-') {
        const char op = *r->at++;
        const double by = product(r);
        v = op == '+' ? v + by : v - by;
    }
    return v;
}

static double drawn(reading *r)
{
    const double low = sum(r);
    if (*r->at != '~') return low;
    ++r->at;
    const double high = sum(r);
    return low + (high - low) * chance_of(mixed(r->key, ++r->drawn));
}

static double compared(reading *r)
{
    const double v = drawn(r);
    if (!*r->at || !strchr("<>=", *r->at)) return v;
    const char op = *r->at++;
    const double to = drawn(r);
    return op == '<' ? v < to : op == '>' ? v > to : fabs(v - to) < 1e-9;
}

static double alternatives(reading *r)
{
    double of[ALTERNATIVES];
    int count = 1;
    of[0] = compared(r);
    while (*r->at == '|' && count < ALTERNATIVES) {
        ++r->at;
        of[count++] = compared(r);
    }
    return count == 1 ? of[0] : of[(int)(count * chance_of(mixed(r->key, ++r->drawn)))];
}

const char *kit_expression(double *out, const char **text, const kit_variable *variable, int variables, uint32_t key,
                           const char **where)
{
    reading r = { .variable = variable, .variables = variables, .at = *text, .key = key };
    *out = alternatives(&r);
    if (*r.at && !strchr(" :", *r.at)) misread(&r, "more than a number", r.at);
    *text = r.at + strcspn(r.at, " :");
    *where = r.where;
    return r.why;
}

/* Reads one number from a row's text; *text moves past it. */
static double number(walk *w, const char **text, uint32_t key)
{
    const char *where;
    double v;
    const char *const why = kit_expression(&v, text, w->variable, w->variables, key, &where);
    if (why) wrong(w, why, where);
    return v;
}

/* Reads the numbers of a text up to a word that begins a rule, and returns how many there are. */
static int numbers(walk *w, double out[NUMBERS], const char *text, uint32_t key)
{
    int count = 0;
    for (text += strspn(text, " "); *text && count < NUMBERS; text += strspn(text, " "), count++)
        out[count] = number(w, &text, mixed(key, (uint32_t)count));
    return count;
}

static void set(walk *w, const char *name, int length, double value)
{
    if (w->variables == VARIABLES) wrong(w, "too many variables", name);
    else w->variable[w->variables++] = (kit_variable){ name, length, value };
}

/* ---- >>things ---------------------------------------------------------------------------------------------------- */

static const kit_row *const tables[] = { kit_rows_shared,  kit_rows_rooms,    kit_rows_streets, kit_rows_halls,
                                         kit_rows_foliage, kit_rows_machines, kit_rows_scans,   kit_rows_terrain };

static const kit_row *thing_named(const char *name, size_t length)
{
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++)
        for (const kit_row *rows = tables[k]; rows->name; rows++)
            if (rows->verb == THING && !strncmp(rows->name, name, length) && !rows->name[length]) return rows;
    return NULL;
}

/* Sets variables by "name=number ..", with chances by key; a variable that was set since index from keeps its value. */
static void assign(walk *w, const char *text, uint32_t key, int from)
{
    for (text += strspn(text, " "); *text; text += strspn(text, " ")) {
        const char *const name = text, *const sign = strchr(text, '=');
        const int length = word_length(name);
        int known = 0;
        if (!length || !sign || sign != name + length) {
            wrong(w, "not name=number", text);
            return;
        }
        text = sign + 1;
        const double value = number(w, &text, mixed_text(key, name, (size_t)length));
        for (int k = from; k < w->variables; k++)
            known |= w->variable[k].length == length && !memcmp(w->variable[k].name, name, (size_t)length);
        if (!known) set(w, name, length, value);
    }
}

static void make_row(walk *w, const kit_row *row, uint32_t key);

static void make_thing(walk *w, const kit_row *thing, const char *given, uint32_t key)
{
    const int variables = w->variables;
    const uint32_t outer = w->thing;
    if (w->deep == DEEPEST) return;
    ++w->deep;
    w->thing = key;
    if (given) assign(w, given, key, w->variables);
    assign(w, thing->numbers, key, variables);
    for (const kit_row *row = thing + 1; row->name && row->verb != THING; row++)
        make_row(w, row, mixed_text(key, row->name, strlen(row->name)));
    w->variables = variables;
    w->thing = outer;
    --w->deep;
}

/* Chooses one of "a|b|c", which ends at a blank: name gets it, and its length is returned; *text moves past all. */
static size_t one_of(const char **text, const char **name, uint32_t key)
{
    const size_t all = strcspn(*text, " ");
    int count = 1, which;
    for (size_t i = 0; i < all; i++) count += (*text)[i] == '|';
    which = (int)(count * chance_of(mixed(key, 77)));
    for (*name = *text; which > 0; which--) *name += strcspn(*name, "|") + 1;
    *text += all;
    return strcspn(*name, "| ");
}

/* Adds all triangles from first on as one thing that the camera may look at. */
static void add_sight(walk *w, size_t first)
{
    const kit_mesh *m = &w->p->b.scene.mesh;
    float low[3], high[3];
    double reach = 0;
    if (m->triangles == first || w->p->sights == KIT_SIGHTS) return;
    for (size_t k = 3 * first; k < 3 * m->triangles; k++)
        for (size_t i = 0; i < 3; i++) {
            const float v = m->position[3 * k + i];
            low[i] = k == 3 * first ? v : fminf(low[i], v);
            high[i] = k == 3 * first ? v : fmaxf(high[i], v);
        }
    kit_sight *s = &w->p->sight[w->p->sights];
    for (int i = 0; i < 3; i++) {
        const double side = (double)high[i] - (double)low[i];
        s->at[i] = 0.5 * ((double)low[i] + (double)high[i]);
        reach += 0.25 * side * side;
    }
    s->reach = fmin(6, fmax(0.3, sqrt(reach)));
    if (reach < 30 * 30) w->p->sights++;
}

static void put_thing(walk *w, const kit_row *row, uint32_t key)
{
    const char *text = row->numbers, *name;
    const size_t length = one_of(&text, &name, key), first = w->p->b.scene.mesh.triangles;
    const kit_row *const thing = thing_named(name, length);
    if (!thing) {
        wrong(w, "no such thing", name);
        return;
    }
    if (row->verb == PUT) {
        if (first > MOST_TRIANGLES) return;
        kit_begin_object(&w->p->b, thing->name, -1);
    }
    make_thing(w, thing, text, key);
    if (row->verb == PUT) add_sight(w, first);
}

/* ---- >>models ---------------------------------------------------------------------------------------------------- */

static const kit_mesh *model_of(walk *w, const char *name, int length)
{
    kit_mesh mesh;
    for (int k = 0; k < w->models; k++)
        if (w->model[k].length == length && !memcmp(w->model[k].name, name, (size_t)length)) return &w->model[k].mesh;
    if (kit_catalogue_read(&mesh, name, length, w->err)) return NULL;
    if (w->models == MODELS_KEPT) kit_mesh_free(&w->model[--w->models].mesh);
    w->model[w->models] = (kept){ name, length, mesh };
    return &w->model[w->models++].mesh;
}

/* Adds a model, scaled, as an object of its own. */
static void add_model(kit_build *b, const kit_mesh *m, double scale, const char *name, int length)
{
    char title[64];
    snprintf(title, sizeof title, "%.*s", length, name);
    kit_begin_object(b, title, -1);
    for (size_t t = 0; t < m->triangles; t++) {
        kit_vertex v[3];
        for (size_t k = 0; k < 9; k++) {
            v[k / 3].p[k % 3] = scale * (double)m->position[9 * t + k];
            v[k / 3].n[k % 3] = (double)m->normal[9 * t + k];
        }
        kit_colour(b, (double)m->albedo[3 * t], (double)m->albedo[3 * t + 1], (double)m->albedo[3 * t + 2]);
        kit_triangle(b, &v[0], &v[1], &v[2]);
    }
}

static void put_model(walk *w, const kit_row *row, uint32_t key)
{
    const char *text = row->numbers, *name;
    const int length = (int)one_of(&text, &name, key);
    const size_t first = w->p->b.scene.mesh.triangles;
    double height[NUMBERS];
    const int given = numbers(w, height, text, key);
    if (first > MOST_TRIANGLES || *w->err->text) return;
    const kit_mesh *const m = model_of(w, name, length);
    if (!m || m->triangles > MOST_MODEL) return;
    add_model(&w->p->b, m, given ? height[0] / (double)m->upper[1] : 1, name, length);
    add_sight(w, first);
}

/* ---- >>shapes ---------------------------------------------------------------------------------------------------- */

/* clang-format off */
static const struct palette { const char *name; int count; float colour[6][3]; } palettes[] = {
    { "wall",   6, { { .75f, .73f, .68f }, { .62f, .58f, .5f }, { .5f, .56f, .6f }, { .7f, .55f, .45f },
                     { .8f, .8f, .78f }, { .55f, .6f, .5f } } },
    { "brick",  4, { { .45f, .2f, .14f }, { .5f, .3f, .2f }, { .55f, .45f, .35f }, { .38f, .25f, .22f } } },
    { "stone",  5, { { .6f, .54f, .44f }, { .5f, .49f, .46f }, { .7f, .68f, .64f }, { .42f, .38f, .34f },
                     { .55f, .45f, .36f } } },
    { "wood",   5, { { .42f, .27f, .15f }, { .3f, .18f, .1f }, { .6f, .45f, .28f }, { .22f, .13f, .08f },
                     { .5f, .36f, .22f } } },
    { "metal",  5, { { .5f, .5f, .52f }, { .2f, .2f, .22f }, { .62f, .6f, .56f }, { .3f, .34f, .38f },
                     { .45f, .32f, .2f } } },
    { "paint",  6, { { .6f, .15f, .1f }, { .1f, .25f, .5f }, { .75f, .6f, .1f }, { .15f, .4f, .25f },
                     { .7f, .7f, .7f }, { .8f, .4f, .1f } } },
    { "cloth",  6, { { .5f, .1f, .12f }, { .15f, .2f, .4f }, { .6f, .55f, .45f }, { .3f, .4f, .3f },
                     { .7f, .68f, .65f }, { .45f, .25f, .4f } } },
    { "floor",  5, { { .45f, .33f, .22f }, { .5f, .5f, .48f }, { .3f, .29f, .28f }, { .62f, .58f, .5f },
                     { .35f, .22f, .14f } } },
    { "road",   3, { { .12f, .12f, .13f }, { .2f, .2f, .2f }, { .32f, .31f, .3f } } },
    { "leaf",   6, { { .12f, .3f, .07f }, { .2f, .4f, .1f }, { .1f, .22f, .1f }, { .3f, .38f, .12f },
                     { .45f, .3f, .08f }, { .16f, .34f, .16f } } },
    { "bark",   3, { { .2f, .14f, .09f }, { .3f, .25f, .2f }, { .42f, .4f, .36f } } },
    { "bloom",  5, { { .75f, .2f, .3f }, { .8f, .7f, .2f }, { .6f, .3f, .65f }, { .8f, .8f, .78f },
                     { .85f, .45f, .15f } } },
    { "soil",   5, { { .3f, .22f, .14f }, { .45f, .36f, .25f }, { .2f, .26f, .1f }, { .6f, .5f, .36f },
                     { .35f, .33f, .3f } } },
    { "glass",  2, { { .1f, .13f, .16f }, { .3f, .36f, .4f } } },
    { "white",  1, { { .8f, .8f, .8f } } },
    { "paper",  4, { { .78f, .75f, .68f }, { .6f, .2f, .15f }, { .2f, .3f, .45f }, { .25f, .35f, .2f } } },
};
/* clang-format on */

/* Sets a colour of a palette; key: of the copy, whose shade differs a little from other copies'. */
static void paint(walk *w, const char *name, uint32_t key)
{
    if (!*name) return;
    for (size_t k = 0; k < sizeof palettes / sizeof *palettes; k++) {
        const struct palette *const p = &palettes[k];
        const uint32_t of = mixed_text(w->thing, name, strlen(name));
        const float *const c = p->colour[(int)(chance_of(of) * p->count)];
        const double by = 0.9 + 0.15 * chance_of(mixed(of, 1)) + 0.1 * (chance_of(mixed(key, 99)) - 0.5);
        if (strcmp(p->name, name)) continue;
        kit_colour(&w->p->b, fmin(0.9, by * (double)c[0]), fmin(0.9, by * (double)c[1]), fmin(0.9, by * (double)c[2]));
        return;
    }
    wrong(w, "no such paint", name);
}

static void make_turned(kit_build *b, const double *v, int count)
{
    const double widest = fmax(fmax(v[0], v[2]), count > 4 ? v[4] : 0);
    for (int k = 0; k + 3 < count; k += 2) {
        const kit_moulding m = { v[k], v[k + 1], v[k + 2], v[k + 3], 0 };
        kit_turned(b, &m, 1, widest < 0.03 ? 8 : widest < 0.2 ? 14 : 24);
    }
}

static void make_pane(kit_build *b, const double *v)
{
    double c[4][3];
    const int level = fabs(v[1] - v[4]) < 1e-9;
    for (int k = 0; k < 4; k++) {
        const int far = k == 1 || k == 2, last = k > 1;
        c[k][0] = far ? v[3] : v[0];
        c[k][1] = last ? v[4] : v[1];
        c[k][2] = (level ? last : far) ? v[5] : v[2];
    }
    kit_quad(b, (const double(*)[3])c);
}

/* Writes a point of cloth; shape: width, height, waves, depth. */
static void cloth_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * s[2] * u, deep = s[3] * (0.35 + 0.65 * v);
    out->p[0] = s[0] * (u - 0.5);
    out->p[1] = -s[1] * v;
    out->p[2] = deep * sin(a + 1.5 * v);
    out->n[0] = -deep * cos(a + 1.5 * v) * 2 * KIT_PI * s[2] / s[0];
    out->n[1] = 0;
    out->n[2] = 1;
    kit_unit(out->n);
}

typedef struct rock { const double *v; unsigned seed; } rock;

static void rock_point(const rock *r, double u, double v, double p[3])
{
    kit_vertex ball;
    const double one = 1;
    kit_sphere_surface(&one, u, v, &ball);
    const double *const d = ball.n, lump = kit_fractal(r->seed, 1.4 * d[0], 1.4 * d[1], 1.4 * d[2], 3),
                 cleft = exp(-8 * fabs(kit_noise(r->seed + 7, 1.2 * d[0], 1.2 * d[1], 1.2 * d[2])));
    for (int i = 0; i < 3; i++) p[i] = r->v[i] * d[i] * (1 + r->v[3] * (0.5 * lump - 0.7 * cleft + 0.25));
}

static void rock_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const rock *const r = shape;
    const double e = 0.004, s = v > 0.5 ? -e : e;
    double at_u[3], at_v[3];
    rock_point(r, u, v, out->p);
    rock_point(r, u + e, v, at_u);
    rock_point(r, u, v + s, at_v);
    for (int i = 0; i < 3; i++) {
        at_u[i] -= out->p[i];
        at_v[i] -= out->p[i];
    }
    kit_cross(at_v, at_u, out->n);
    if (!kit_unit(out->n) || v <= 0 || v >= 1) {
        memcpy(out->n, out->p, sizeof out->n);
        if (!kit_unit(out->n)) out->n[1] = 1;
    }
    if (kit_dot(out->n, out->p) < 0)
        for (int i = 0; i < 3; i++) out->n[i] = -out->n[i];
}

/* Adds a rock. v: the numbers of its row; if facets is not 0 the rock has flat sides. */
static void make_rock(kit_build *b, const double *v, uint32_t key)
{
    const rock r = { v, key & 0xffffff };
    const int cells = v[4] > 2 ? (int)v[4] : 8;
    const size_t first = b->scene.mesh.triangles;
    kit_patch(b, 2 * cells, cells, rock_surface, &r);
    for (size_t t = first; t < b->scene.mesh.triangles && v[5] > 0; t++) {
        const float *const p = b->scene.mesh.position + 9 * t;
        double n[3];
        if (!kit_face(p, n)) continue;
        for (int i = 0; i < 9; i++) b->scene.mesh.normal[9 * t + (size_t)i] = (float)n[i % 3];
    }
}

static double height_of(const void *of, double x, double z)
{
    const double *const g = of;
    return g[5] > 0 ? g[5] * kit_fractal((unsigned)g[4], x / g[6], 0.5, z / g[6], (int)fmax(1, g[7])) : 0;
}

double kit_ground_at(const kit_plot *p, double x, double z) { return height_of(p->ground, x, z); }

static void make_ground(walk *w, const double *v, int count, uint32_t key)
{
    double *const g = w->p->ground;
    memcpy(g, v, (size_t)(count < 8 ? count : 8) * sizeof *v);
    g[4] = key % 100000;
    if (g[5] > 0) kit_height_field(&w->p->b, v, (int)v[4], (int)v[4], height_of, g);
    else kit_level(&w->p->b, v[0], v[1], v[2], v[3], 0);
}

/* Transforms a point from the axes of the thing that is being built to the world's. */
static void to_world(const kit_frame *f, const double in[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        out[i] = f->scale > 0 ? f->at[i] : in[i];
        for (int k = 0; k < 3 && f->scale > 0; k++) out[i] += f->scale * f->turn[i][k] * in[k];
    }
}

/* Handles a row that sets a property of the scene; returns 0 for a row of a shape. */
static int note(walk *w, const kit_row *row, const double *v, int count, uint32_t key)
{
    kit_plot *const p = w->p;
    double at[3];
    switch (row->verb) {
    case GROUND: make_ground(w, v, count, key); return 1;
    case STAND: memcpy(p->stand, v, sizeof p->stand); return 1;
    case CEILING: p->ceiling = v[0]; return 1;
    case LAMP:
        to_world(&p->b.frame, v, at);
        if (p->lamps < KIT_LAMPS) memcpy(p->lamp[p->lamps++], at, sizeof at);
        return 1;
    case SIGHT:
        to_world(&p->b.frame, v, at);
        if (p->sights < KIT_SIGHTS) p->sight[p->sights++] = (kit_sight){ { at[0], at[1], at[2] }, v[3] };
        return 1;
    default: return 0;
    }
}

static void make_shape(walk *w, const kit_row *row, uint32_t key)
{
    static const int least[] = { [BOX] = 6, [ROD] = 7, [TURNED] = 4, [BALL] = 6, [CUSHION] = 7, [RING] = 5, [WIRE] = 8,
                                 [PRISM] = 7, [LEAF] = 3, [PANE] = 6, [CLOTH] = 4, [ROCK] = 4, [GROUND] = 5, [LAMP] = 3,
                                 [STAND] = 4, [CEILING] = 1, [SIGHT] = 4 };
    kit_build *const b = &w->p->b;
    double v[NUMBERS] = { 0 };
    const int count = numbers(w, v, row->numbers, key);
    if (count < least[row->verb]) {
        wrong(w, "too few numbers", row->numbers);
        return;
    }
    paint(w, row->paint, key);
    if (note(w, row, v, count, key)) return;
    const kit_frame moved = row->verb == BALL || row->verb == CUSHION || row->verb == RING
                              ? kit_enter(b, v[0], v[1], v[2], 0, 1)
                              : b->frame;
    const double ends[2][3] = { { v[0], v[1], v[2] }, { v[3], v[4], v[5] } };
    switch (row->verb) {
    case BOX:
        if (v[6] > 0) kit_bevelled(b, v[0], v[1], v[2], v[3], v[4], v[5], v[6]);
        else kit_box(b, v[0], v[1], v[2], v[3], v[4], v[5]);
        break;
    case ROD: kit_tube(b, ends, 2, v[6], v[7] > 2 ? (int)v[7] : v[6] < 0.012 ? 6 : v[6] < 0.06 ? 10 : 18); break;
    case TURNED: make_turned(b, v, count); break;
    case BALL: kit_cushion(b, v + 3, 1, v[6] > 2 ? (int)v[6] : 10); break;
    case CUSHION: kit_cushion(b, v + 3, v[6], v[7] > 2 ? (int)v[7] : 10); break;
    case RING: kit_patch(b, v[3] < 0.1 ? 16 : 32, 8, kit_torus_surface, v + 3); break;
    case WIRE: kit_cable(b, ends[0], ends[1], v[6], v[7], 6); break;
    case PRISM: kit_prism(b, (const double(*)[2])(v + 1), (count - 1) / 2, v[0]); break;
    case LEAF: kit_leaf(b, v[0], v[1], v[2], v[3] > 0 ? (int)v[3] : 2, v[4] > 0); break;
    case PANE: make_pane(b, v); break;
    case CLOTH: kit_patch(b, (int)(10 * v[2]) + 2, 10, cloth_surface, v); break;
    case ROCK: make_rock(b, v, key); break;
    default: wrong(w, "no verb", row->name);
    }
    if (row->verb == BALL || row->verb == CUSHION || row->verb == RING) kit_leave(b, moved);
}

/* ---- >>copies ---------------------------------------------------------------------------------------------------- */

/* Claims a disc about a place of the thing that is being built; returns 0 if it meets a claimed one. */
static int clear(walk *w, const double place[3], double radius)
{
    double at[3];
    const double by = w->p->b.frame.scale > 0 ? w->p->b.frame.scale : 1, r = by * radius;
    to_world(&w->p->b.frame, place, at);
    for (int k = 0; k < w->claims; k++) {
        const claim *const c = &w->claim[k];
        if (fabs(c->at[1] - at[1]) < 0.2 && hypot(c->at[0] - at[0], c->at[2] - at[2]) < c->radius + r) return 0;
    }
    if (w->claims < CLAIMS) w->claim[w->claims++] = (claim){ { at[0], at[1], at[2] }, r };
    return 1;
}

enum { X, Y, Z, TURN, TILT, SCALE, PLACES };

/* Finds a place for a copy of a row's thing; returns 0 if all places that it tried are claimed. */
static int find_place(walk *w, const char *at, uint32_t key, double place[PLACES])
{
    static const int order[PLACES] = { X, Z, Y, TURN, TILT, SCALE };
    const char *word[PLACES] = { NULL }, *text = at + strspn(at, " "), *free_of = NULL;
    const int variables = w->variables;
    for (int k = 0; *text && !free_of; text += strcspn(text, " "), text += strspn(text, " "), k++) {
        if (!strncmp(text, "clear ", 6)) free_of = text + 6;
        else if (k < PLACES) word[k] = text;
    }
    for (int attempt = 0; attempt < (free_of ? TRIES : 1); attempt++) {
        const uint32_t draw = mixed(key, (uint32_t)attempt);
        w->variables = variables;
        for (int k = 0; k < PLACES; k++) {
            const int which = order[k];
            const char *from = word[which];
            place[which] = from ? number(w, &from, mixed(draw, (uint32_t)which)) : which == SCALE;
            if (which == X) set(w, "x", 1, place[X]);
            if (which != Z) continue;
            set(w, "z", 1, place[Z]);
            const double flat[3] = { place[X], 0, place[Z] };
            double world[3];
            to_world(&w->p->b.frame, flat, world);
            set(w, "g", 1, kit_ground_at(w->p, world[0], world[2]) - world[1]);
        }
        if (!free_of) return 1;
        const char *text_radius = free_of;
        if (clear(w, place, number(w, &text_radius, mixed(draw, 50)))) return 1;
    }
    return 0;
}

static void make_copy(walk *w, const kit_row *row, const char *at, uint32_t key)
{
    double place[PLACES];
    kit_build *const b = &w->p->b;
    if (*at && !find_place(w, at, mixed(key, 1), place)) return;
    const kit_frame before = *at ? kit_enter_tilted(b, place, place[TURN], place[TILT], place[SCALE])
                                 : b->frame;
    if (row->verb == PUT || row->verb == PART) put_thing(w, row, mixed(key, 2));
    else if (row->verb == MODEL) put_model(w, row, mixed(key, 2));
    else make_shape(w, row, mixed(key, 2));
    if (*at) kit_leave(b, before);
}

static void make_row(walk *w, const kit_row *row, uint32_t key)
{
    const char *at = row->at, *odds = row->odds, *colon = strchr(at, ':');
    const int variables = w->variables;
    w->row = row;
    if (*odds && !(chance_of(mixed(key, 3)) < number(w, &odds, mixed(key, 4)))) return;
    const int count = colon ? (int)number(w, &at, mixed(key, 5)) : 1;
    if (colon) at = colon + 1;
    at += strspn(at, " ");
    for (int i = 0; i < count && !*w->err->text && !w->p->b.failed; i++) {
        if (colon) {
            set(w, "i", 1, i);
            set(w, "n", 1, count);
            set(w, "t", 1, (i + 0.5) / count);
            set(w, "u", 1, count > 1 ? (double)i / (count - 1) : 0.5);
            set(w, "sx", 2, i & 1 ? 1 : -1);
            set(w, "sz", 2, i & 2 ? 1 : -1);
        }
        make_copy(w, row, at, mixed(mixed(key, 6), (uint32_t)i));
        w->row = row;
        w->variables = variables;
    }
}

/* Checks that the things or models that a row names exist. */
static int check_row(const kit_row *row, kit_error *err)
{
    for (const char *name = row->numbers; *name && *name != ' ';) {
        const int length = (int)strcspn(name, "| ");
        const int there = row->verb == MODEL ? kit_catalogue_has(name, length)
                                             : thing_named(name, (size_t)length) != NULL;
        if (!there) return kit_fail(err, "row '%s': there is no '%.*s'", row->name, length, name);
        name += length + (name[length] == '|');
    }
    return 0;
}

int kit_check_rows(kit_error *err)
{
    for (size_t k = 0; k < sizeof tables / sizeof *tables; k++)
        for (const kit_row *row = tables[k]; row->name; row++)
            if ((row->verb == PUT || row->verb == PART || row->verb == MODEL) && check_row(row, err)) return -1;
    return 0;
}

void kit_build_thing(kit_plot *p, const char *thing, uint32_t seed, kit_error *err)
{
    walk *const w = calloc(1, sizeof *w);
    const kit_row *const row = thing_named(thing, strlen(thing));
    if (!w || !row) {
        free(w);
        kit_fail(err, w ? "no table has '%s'" : "no memory for '%s'", thing);
        return;
    }
    w->p = p;
    w->err = err;
    w->row = row;
    make_thing(w, row, NULL, seed);
    for (int k = 0; k < w->models; k++) kit_mesh_free(&w->model[k].mesh);
    free(w);
}

double kit_build_model(kit_plot *p, const char *name, uint32_t seed, kit_error *err)
{
    kit_mesh m;
    if (kit_catalogue_read(&m, name, (int)strlen(name), err)) return 0;
    double half[3], squares = 0;
    for (int i = 0; i < 3; i++) {
        half[i] = 0.5 * ((double)m.upper[i] - (double)m.lower[i]);
        squares += half[i] * half[i];
    }
    const double by = 1 / sqrt(squares);
    kit_begin_object(&p->b, "floor", -1);
    kit_level(&p->b, -20, -20, 20, 20, 0);
    p->stand[0] = p->stand[1] = -12;
    p->stand[2] = p->stand[3] = 12;
    p->sight[p->sights++] = (kit_sight){ { 0, by * half[1], 0 }, 1 };
    /* a model is often hollow in the middle, so the camera may also look at points on its surface */
    for (uint32_t k = 0; k < 6 && m.triangles; k++) {
        const float *const at = m.position + 9 * (size_t)((double)m.triangles * chance_of(mixed(seed, k)));
        p->sight[p->sights++] = (kit_sight){ { by * (double)at[0], by * (double)at[1], by * (double)at[2] }, 0.4 };
    }
    add_model(&p->b, &m, by, name, (int)strlen(name));
    kit_mesh_free(&m);
    return 1 / by;
}
