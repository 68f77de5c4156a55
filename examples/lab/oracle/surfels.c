/* surfels.c - deep screen space [DSS14] step by step: what discs lose, what sums count twice, what the centre's form
   factor, enlarged surfels, sub-buffers and the smoothing add; and what remedies would bring. Declared in oracle.h. */
#include "lab/oracle/oracle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PUBLISHED "half=0,epsilon=0.1,levels=5,span=0,overhang=centroid,enlarge=1,combine=add,near_samples=1"
enum { LEVELS = 5, FAN = 6, FINE = 256, SURFEL_RAYS = 64, COLUMNS = 8, CELLS = 32 };

/* What a pixel has by each way, before it is put into 0..1. */
enum { TRIANGLES, TRIANGLES_SHARED, NEAREST, EXACT, EXACT_SHARED, CENTRE, ENLARGED, INTERLEAVED, NEAR4, NEAR16, SHARED,
       FADED_APART, LEVELS_HIDE, SECOND, BY_CELLS, WAYS };
static double added(double sum) { return fmin(sum, 1); }
static double shared(double sum) { return 1 - exp(-sum); }
static const struct { const char *name; double (*put)(double sum); } ways[WAYS] = {
    [TRIANGLES]        = { "every triangle that faces, added", added },
    [TRIANGLES_SHARED] = { "the same, 1 - exp(-sum)", shared },
    [NEAREST]          = { "discs, the nearest alone", added },
    [EXACT]            = { "discs, exact form factors, added", added },
    [EXACT_SHARED]     = { "the same, 1 - exp(-sum)", shared },
    [CENTRE]           = { "form factors of centres, within reach, added", added },
    [ENLARGED]         = { "the same, enlarged by 2^l", added },
    [INTERLEAVED]      = { "the same, of a pixel's own sub-buffers", added },
    [NEAR4]            = { "tried: 4 points near, added", added },
    [NEAR16]           = { "tried: 16 points near, added", added },
    [SHARED]           = { "tried: 4 points near, 1 - exp(-sum)", shared },
    [FADED_APART]      = { "tried: 4 points near, 1 at most, then faded", added },
    [LEVELS_HIDE]      = { "tried: 4 points near, levels hide each other", added },
    [SECOND]           = { "tried: centres, Bunnell's second pass", added },
    [BY_CELLS]         = { "tried: centres, 32 directions apart", added }
};

typedef struct job {
    oracle      *o;
    ssgi_surfel *surfel;
    size_t       surfels;
    ssgi_trace   discs;
    double       epsilon, *truth, *way[WAYS];
    float       *open;                     /* of each surfel: how much of its hemisphere */
} job;

static double dot(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void cross(const float a[3], const float b[3], float out[3])
{
    for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* In the plane of a unit normal, as ssgi_form of the header has them. */
static void axes_of(const float m[3], float a[3], float b[3])
{
    const float flat[3] = { m[1], -m[0], 0 }, steep[3] = { 0, m[2], -m[1] };
    memcpy(a, fabsf(m[2]) < 0.7f ? flat : steep, sizeof flat);
    const float unit = 1 / (float)sqrt(dot(a, a));
    for (int k = 0; k < 3; ++k) a[k] *= unit;
    cross(m, a, b);
}

/* ---- >>rays ------------------------------------------------------------------------------------------------------ */

/* What all that faces a ray takes from it, and what the nearest of those does. */
static void along(const job *j, int discs, const float from[3], const float d[3], double *nearest, double *all)
{
    const ssgi_trace *trace = discs ? &j->discs : &j->o->trace;
    ssgi_hit hit = { 0 };
    *nearest = *all = 0;
    while (ssgi_trace_closest(&hit, trace, from, d, hit.t, j->o->radius)) {
        const double weight = 1 - (double)(hit.t / j->o->radius);
        float n[3], e[3], f[3];
        if (discs) memcpy(n, j->surfel[hit.triangle / FAN].normal, sizeof n);
        else {
            const float *c = j->o->position + 9 * (size_t)hit.triangle;
            for (int k = 0; k < 3; ++k) e[k] = c[3 + k] - c[k], f[k] = c[6 + k] - c[k];
            cross(e, f, n);
        }
        if (!(dot(n, d) < 0)) continue;
        if (*nearest <= 0) *nearest = weight;
        *all += weight;
    }
}

static void trace_pixel(const job *j, int i)
{
    const oracle_pixel *q = &j->o->pixel[i];
    double seen = 0, sum[2] = { 0, 0 };
    for (int r = 0; r < ORACLE_RAYS; ++r) {
        ssgi_hit hit;
        float d[3];
        double nearest, all;
        oracle_ray(d, (uint32_t)i, r, q->n);
        if (ssgi_trace_closest(&hit, &j->o->trace, q->lifted, d, 0, j->o->radius))
            seen += 1 - (double)(hit.t / j->o->radius);
        along(j, 0, q->lifted, d, &nearest, &all);
        sum[0] += all;
        along(j, 1, q->lifted, d, &nearest, &all);
        sum[1] += nearest;
    }
    j->truth[i] = seen / ORACLE_RAYS;
    j->way[TRIANGLES][i] = j->way[TRIANGLES_SHARED][i] = sum[0] / ORACLE_RAYS;
    j->way[NEAREST][i] = sum[1] / ORACLE_RAYS;
}

/* Bunnell's first pass, exactly: what surfels hide of a surfel. */
static void open_surfel(void *context, int i)
{
    const job *j = context;
    const ssgi_surfel *s = &j->surfel[i];
    double sum = 0;
    float from[3];
    for (int k = 0; k < 3; ++k) from[k] = s->position[k] + 0.02f * s->radius * s->normal[k];
    for (int r = 0; r < SURFEL_RAYS; ++r) {
        float d[3];
        double nearest, all;
        oracle_ray(d, (uint32_t)i, r * (ORACLE_RAYS / SURFEL_RAYS), s->normal);
        along(j, 1, from, d, &nearest, &all);
        sum += all;
    }
    j->open[i] = (float)fmax(0, 1 - sum / SURFEL_RAYS);
}

/* ---- >>sums of surfels ------------------------------------------------------------------------------------------- */

/* main_splat of the header: the form factor of a disc by so many points over it where it is near, 1: by its centre. */
static double form_of(const float v[3], const float n[3], const float m[3], double rr, int points, double near)
{
    const double dd = fmax(dot(v, v), 1e-30), away = -dot(v, m);
    double form = 0, turn[2] = { 1, 0 };
    float a[3], b[3];
    if (!(away > 0)) return 0;
    if (points < 2 || dd > near * near * rr) return fmax(dot(v, n), 0) / (dd * (dd + rr)) * rr * away;
    axes_of(m, a, b);
    for (int i = 0; i < points; ++i) {
        const double r = sqrt((i + 0.5) / points * rr), was = turn[0];
        float w[3];
        for (int k = 0; k < 3; ++k) w[k] = v[k] + a[k] * (float)(turn[0] * r) + b[k] * (float)(turn[1] * r);
        const double ww = fmax(dot(w, w), 1e-30);
        form += fmax(dot(w, n), 0) / (ww * (ww + rr / points));
        turn[0] = -0.73736888 * was - 0.67549029 * turn[1];     /* by the golden angle */
        turn[1] = 0.67549029 * was - 0.73736888 * turn[1];
    }
    return form / points * rr * away;
}

static uint32_t scramble(uint32_t x)
{
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return x >> 22 ^ x;
}

/* Whether a surfel meets a pixel on a level: ssgi_interleave and ssgi_shell of the header. */
static int meets(const ssgi_surfel *s, int x, int y, int l)
{
    const int mask = (1 << l) - 1, seed = (int)(s->seed * 16777216.0f);
    const uint32_t h = scramble((uint32_t)(x >> l) * 747796405u + (uint32_t)(y >> l) * 2891336453u + (uint32_t)mask);
    return ((x ^ (int)h ^ seed) & mask) == 0 && ((y ^ (int)(h >> 8) ^ (seed >> 8)) & mask) == 0;
}

/* Of 8 x 4 cells that have as much of the hemisphere by the cosine each: disc to square [Shirley and Chiu 1997]. */
static int cell_of(const float v[3], const float s[3], const float t[3])
{
    const double length = sqrt(dot(v, v)), x = dot(v, s) / length, y = dot(v, t) / length, r = sqrt(x * x + y * y);
    const int wide = fabs(x) > fabs(y);
    const double main = wide ? x : y, turn = 4 / KIT_PI * atan2(wide ? y : x, fabs(main)),
                 along_main = main < 0 ? -r : r, across = r * turn;
    const double u = wide ? along_main : across, w = wide ? across : along_main;
    const int column = (int)fmin((u + 1) / 2 * COLUMNS, COLUMNS - 1), rows = CELLS / COLUMNS;
    return (int)fmin((w + 1) / 2 * rows, rows - 1) * COLUMNS + column;
}

static void sum_pixel(const job *j, int i)
{
    const oracle_pixel *q = &j->o->pixel[i];
    double way[WAYS] = { 0 }, cell[CELLS][2] = { { 0 } }, level[LEVELS] = { 0 }, four = 0, left = 1;
    float s[3], t[3];
    axes_of(q->n, s, t);
    for (size_t f = 0; f < j->surfels; ++f) {
        const ssgi_surfel *e = &j->surfel[f];
        const float *m = e->normal, v[3] = { e->position[0] - q->p[0], e->position[1] - q->p[1],
                                             e->position[2] - q->p[2] };
        const double d = sqrt(dot(v, v)), rr = (double)e->radius * (double)e->radius,
                     reach = ssgi_surfel_reach((double)e->radius, 1, j->epsilon), fade = 1 - d / (double)j->o->radius;
        int l = 0;
        if (!(fade > 0)) continue;
        way[EXACT] += form_of(v, q->n, m, rr, FINE, 8) * fade;
        const double form = form_of(v, q->n, m, rr, 1, 4), form4 = form_of(v, q->n, m, rr, 4, 4);
        way[SECOND] += form * fade * (double)j->open[f];
        if (d > ldexp(reach, LEVELS - 1)) continue;
        while (d > ldexp(reach, l)) ++l;
        const double enlarged = form_of(v, q->n, m, ldexp(rr, 2 * l), 1, 4) * fade;
        way[CENTRE] += form * fade;
        way[ENLARGED] += ldexp(enlarged, -2 * l);
        if (meets(e, q->x, j->o->g.height - 1 - q->y, l)) way[INTERLEAVED] += enlarged;
        way[NEAR4] += form4 * fade;
        way[NEAR16] += form_of(v, q->n, m, rr, 16, 4) * fade;
        four += form4;
        level[l] += form4 * fade;
        double *in = cell[cell_of(v, s, t)];
        in[0] += form * CELLS;
        in[1] += form * fade * CELLS;
    }
    way[EXACT_SHARED] = way[EXACT];
    way[SHARED] = way[NEAR4];
    way[FADED_APART] = way[NEAR4] / fmax(four, 1);
    for (int l = 0; l < LEVELS; ++l) left *= fmax(1 - level[l], 0);
    way[LEVELS_HIDE] = 1 - left;
    for (int k = 0; k < CELLS; ++k) way[BY_CELLS] += cell[k][1] / fmax(cell[k][0], 1) / CELLS;
    for (int w = EXACT; w < WAYS; ++w) j->way[w][i] = way[w];
}

static void diagnose_pixel(void *context, int i)
{
    trace_pixel(context, i);
    sum_pixel(context, i);
}

/* ---- >>pictures, tables ------------------------------------------------------------------------------------------ */

/* Octagons of the discs' areas: corners and the tree's memory for the caller to free. */
static int trace_discs(job *j, float **corner, void **memory, kit_error *err)
{
    const size_t size = ssgi_trace_size(FAN * j->surfels);
    const char *why = "out of memory";
    *corner = malloc(9 * FAN * j->surfels * sizeof(float));
    *memory = malloc(size);
    if (!*corner || !*memory) return kit_fail(err, "%s", why);
    for (size_t f = 0; f < j->surfels; ++f) {
        const ssgi_surfel *e = &j->surfel[f];
        const double r = (double)e->radius * sqrt(KIT_PI / sqrt(8));
        float a[3], b[3], at[8][3];
        axes_of(e->normal, a, b);
        for (int c = 0; c < 8; ++c)
            for (int k = 0; k < 3; ++k)
                at[c][k] = e->position[k] + (float)(r * cos(c * KIT_PI / 4)) * a[k]
                         + (float)(r * sin(c * KIT_PI / 4)) * b[k];
        for (size_t c = 0; c < FAN; ++c) {
            float *to = *corner + 9 * (FAN * f + c);
            memcpy(to, at[0], sizeof at[0]);
            memcpy(to + 3, at[c + 1], 2 * sizeof at[0]);
        }
    }
    return ssgi_trace_build(&j->discs, *memory, size, *corner, 12, NULL, FAN * j->surfels, &why) == SSGI_OK
             ? 0 : kit_fail(err, "%s", why);
}

/* A method's picture at the pixels, as occlusion. keep: its surfels are the job's. */
static int draw(double *out, job *j, int keep, const char *method, const char *set, kit_error *err)
{
    const kit_world world = { &j->o->scene, NULL };
    kit_image picture;
    kit_method m;
    kit_run run;
    if (kit_method_find(&m, method, err) || kit_method_set(&m, set, err)
        || kit_run_open(&run, &j->o->g, &m, j->o->radius, &world, err))
        return -1;
    if (keep && (j->surfel = malloc((run.surfels + 1) * sizeof *j->surfel))) {
        j->epsilon = (double)run.frame.epsilon;
        j->surfels = run.surfels;
        glBindBuffer(GL_ARRAY_BUFFER, run.buffers[0]);
        glGetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(run.surfels * sizeof *j->surfel), j->surfel);
    }
    kit_run_draw(&run, 0);
    const int failed = kit_run_read(&picture, &run, err);
    kit_run_close(&run);
    if (failed) return -1;
    for (int i = 0; i < j->o->pixels; ++i) out[i] = 1 - (double)oracle_value(j->o, &picture, i, "Y");
    kit_image_free(&picture);
    return 0;
}

static const struct { const char *name, *method, *set; } pictures[] = {
    { "drawn, unsmoothed", "dss", PUBLISHED ",smooth=0" },
    { "drawn: as published", "dss", PUBLISHED },
    { "the library's surfels alone, span=0", "dss", "half=0,epsilon=0.1,levels=5,span=0" },
    { "the library's dss: what is near by slices", "dss", "" },
    { "hsao", "hsao", NULL },
    { "hsao-best", "hsao-best", NULL }
};
enum { PICTURES = (int)(sizeof pictures / sizeof *pictures) };

static void show(const job *j, double *const drawn[PICTURES], const double *none, double size)
{
    const int count = j->o->pixels;
    double worst = 0;
    int off = 0;
    for (int w = 0; w < WAYS; ++w)
        for (int i = 0; i < count; ++i) j->way[w][i] = ways[w].put(j->way[w][i]);
    for (int i = 0; i < count; ++i) {
        const double apart = fabs(j->way[INTERLEAVED][i] - drawn[0][i]);
        worst = fmax(worst, apart);
        off += apart > 1e-3;
    }
    printf("\n%s, size %g: %zu surfels, %d pixels of %d rays, radius %g\n", j->o->scene.name, size, j->surfels, count,
           ORACLE_RAYS, (double)j->o->radius);
    for (int w = 0; w < NEAR4; ++w) oracle_row(ways[w].name, j->way[w], j->truth, none, count);
    printf("  the GPU's beside these: %d pixels off by more than 0.001, the worst by %.5f\n", off, worst);
    for (int k = 0; k < PICTURES; ++k) oracle_row(pictures[k].name, drawn[k], j->truth, none, count);
    for (int w = NEAR4; w < WAYS; ++w) oracle_row(ways[w].name, j->way[w], j->truth, none, count);
    fflush(stdout);
}

int surfels_diagnosis(oracle *o, double size, kit_error *err)
{
    const size_t count = (size_t)o->pixels;
    double *all = calloc((2 + WAYS + PICTURES) * count, sizeof *all), *drawn[PICTURES];
    job j = { .o = o, .truth = all };
    void *memory = NULL;
    float *corner = NULL;
    int failed = all ? 0 : kit_fail(err, "out of memory");
    for (size_t w = 0; w < WAYS && all; ++w) j.way[w] = all + (2 + w) * count;
    for (int k = 0; k < PICTURES && !failed; ++k) {
        const char *set = pictures[k].set;
        char text[256] = "";
        if (set) snprintf(text, sizeof text, "size=%g%s%s", size, *set ? "," : "", set);
        drawn[k] = all + (2 + WAYS + (size_t)k) * count;
        failed = draw(drawn[k], &j, !k, pictures[k].method, text, err);
    }
    if (!failed && !(j.open = malloc((j.surfels + 1) * sizeof *j.open))) failed = kit_fail(err, "out of memory");
    failed = failed || trace_discs(&j, &corner, &memory, err);
    if (!failed) {
        kit_parallel("surfels", (int)j.surfels, open_surfel, &j);
        kit_parallel("pixels", o->pixels, diagnose_pixel, &j);
        show(&j, drawn, all + count, size);
    }
    free(all);
    free(j.open);
    free(j.surfel);
    free(memory);
    free(corner);
    return failed ? -1 : 0;
}
