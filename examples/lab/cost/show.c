/* show.c - prints tables of the costs of passes and chains. Declared in show.h. */
#include "lab/cost/show.h"
#include <math.h>
#include <string.h>

/* ---- sums -------------------------------------------------------------------------------------------------------- */

/* A chain's sums for a family, counts for each pixel. Without splats: their number depends on the scene. */
typedef struct sum {
    counts way[WAYS];
    double bytes_in, bytes_out;             /* for a pixel */
    int vgprs, waves, spilled, scratch, splats;
} sum;

static sum sum_of(const work *w, const cost_chain *c, int family)
{
    sum s = { .waves = 99 };
    for (int i = 0; i < c->passes; ++i) {
        const cost_pass *p = &c->pass[i];
        const compiled *of = &w->program[p->program].of[family];
        const double pixels = (double)WIDTH * HEIGHT, share = (double)p->width * p->height / pixels;
        if (of->vgprs > s.vgprs) s.vgprs = of->vgprs;
        if (of->waves < s.waves) s.waves = of->waves;
        s.spilled += of->spilled;
        s.scratch += of->scratch;
        if (p->vertices) { ++s.splats; continue; }
        for (way how = BUSY; how < WAYS; ++how) counts_add(&s.way[how], &of->way[how], share);
        s.bytes_in += p->bytes_in / pixels;
        s.bytes_out += p->bytes_out / pixels;
    }
    return s;
}

double splat_ms(const work *w, const cost_pass *p, int family, way how, const device *d, double texels, double surfels,
                bound *which)
{
    const compiled *of = &w->program[p->program].of[family];
    const counts *c = &of->way[how];
    const double bytes = 2 * p->bytes_out / ((double)p->width * p->height);
    const load l = { texels, c->vector + of->vertex * p->vertices * surfels / texels, c->transcendental, c->fetches,
                     c->wide_fetches, bytes * texels, of->waves };
    return model(d, &l, which);
}

double pass_ms(const work *w, const cost_pass *p, int family, way how, const device *d, bound *which)
{
    const compiled *of = &w->program[p->program].of[family];
    const counts *c = &of->way[how];
    const double texels = (double)p->width * p->height;
    const load l = { texels, c->vector, c->transcendental, c->fetches, c->wide_fetches, p->bytes_in + p->bytes_out,
                     of->waves };
    if (!p->vertices) return model(d, &l, which);
    return splat_ms(w, p, family, how, d, MEAN_SPLATS * texels / (p->vertices / QUAD), MEAN_SURFELS, which);
}

double chain_ms(const work *w, const cost_chain *c, int family, way how, const device *d)
{
    bound which;
    double ms = 0;
    for (int i = 0; i < c->passes; ++i) ms += pass_ms(w, &c->pass[i], family, how, d, &which);
    return ms;
}

/* Returns the family whose instructions a device executes; -1: nothing was compiled for it. */
static int family_of(const work *w, const device *d)
{
    for (int i = 0; i < w->families; ++i) if (!strcmp(w->family[i], d->family)) return i;
    return -1;
}

/* ---- facts that are not in the csv ------------------------------------------------------------------------------- */

/* Prints the loops whose end no instruction tells and for which no turns are assumed. */
static void show_endless(const work *w)
{
    for (int i = 0; i < w->programs; ++i) {
        const cost_program *p = &w->program[i];
        int known = !p->of[0].report.loops;
        for (int k = 0; k < assumptions_count; ++k) known |= !strcmp(assumptions[k].pass, p->pass);
        if (!known)
            printf("%s: nothing tells when its loop at BB%d ends: IT IS COUNTED ONCE\n", p->pass,
                   p->of[0].report.endless[0]);
    }
}

void show_notes(const work *w, int passes)
{
    show_endless(w);
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->programs; ++i) {
            const compiled *of = &w->program[i].of[family];
            const char *pass = w->program[i].pass;
            if (of->untold) printf("%s, %s: BODIES ARE NOT TOLD APART: weighed is busy\n", w->family[family], pass);
            if (of->report.unknown && passes)
                printf("%s, %s: unknown conditions: %d\n", w->family[family], pass, of->report.unknown);
        }
    for (int i = 0; i < w->chains; ++i)
        if (!w->chain[i].passes) printf("%s: not counted: %s\n", w->chain[i].name, w->chain[i].lacks.text);
}

/* ---- csv --------------------------------------------------------------------------------------------------------- */

/* Returns how many programs a chain has, each counted once; *text: bytes of their shaders; *ms: time to compile
   them. */
static int programs_of(const work *w, const cost_chain *c, int family, size_t *text, double *ms)
{
    int count = 0;
    *text = 0;
    *ms = 0;
    for (int i = 0; i < c->passes; ++i) {
        const cost_program *p = &w->program[c->pass[i].program];
        int again = 0;
        for (int k = 0; k < i; ++k) again |= c->pass[k].program == c->pass[i].program;
        if (again) continue;
        ++count;
        *ms += 1e3 * (p->seconds + p->of[family].seconds);
        for (int k = 0; k < p->stages; ++k) *text += p->text[k] ? strlen(p->text[k]) : 0;
    }
    return count;
}

/* Returns whether chain a is cheaper than b by instructions and model: on every family and device, in every way. */
static int is_cheaper(const work *w, const cost_chain *a, const cost_chain *b)
{
    for (int family = 0; family < w->families; ++family) {
        const sum x = sum_of(w, a, family), y = sum_of(w, b, family);
        for (way how = BUSY; how < WAYS; ++how) {
            if (x.way[how].vector >= y.way[how].vector) return 0;
            for (int k = 0; k < devices_count; ++k)
                if (family_of(w, &devices[k]) == family &&
                    chain_ms(w, a, family, how, &devices[k]) >= chain_ms(w, b, family, how, &devices[k])) return 0;
        }
    }
    return 1;
}

/* Returns 0 for ambient occlusion, 1 for light; -1: not ranked, as its cost depends on objects' or surfels' number. */
static int kind_of(const cost_chain *c)
{
    int light = 0;
    for (int i = 0; i < c->passes; ++i) {
        if (c->pass[i].vertices || !*c->pass[i].name || !strcmp(c->pass[i].name, "aof")) return -1;
        light |= !strcmp(c->pass[i].name, "ssdo") || !strcmp(c->pass[i].name, "s3ho");
    }
    return c->passes ? light : -1;
}

static double busy_instructions(const work *w, const cost_chain *c) { return sum_of(w, c, 0).way[BUSY].vector; }

/* Returns the name of a chain that this one is cheaper than (is_cheaper), as it is than all of its kind with more
   instructions. Of such chains it has the fewest instructions. "": there is none. */
static const char *than_of(const work *w, const cost_chain *c)
{
    const cost_chain *than = NULL;
    double most = busy_instructions(w, c);
    for (int i = 0; i < w->chains; ++i)
        if (kind_of(&w->chain[i]) == kind_of(c) && !is_cheaper(w, c, &w->chain[i]))
            most = fmax(most, busy_instructions(w, &w->chain[i]));
    for (int i = 0; i < w->chains; ++i) {
        const cost_chain *other = &w->chain[i];
        const double busy = busy_instructions(w, other);
        if (kind_of(c) < 0 || kind_of(other) != kind_of(c) || busy <= most) continue;
        if (!than || busy < busy_instructions(w, than)) than = other;
    }
    return than ? than->name : "";
}

static const char *const way_names[WAYS] = { "busy", "calm", "weighed", "weighed 16x4" };

static void write_row(FILE *f, const work *w, int family, const cost_chain *c, const cost_pass *p)
{
    const sum s = sum_of(w, c, family);
    const compiled *of = p ? &w->program[p->program].of[family] : NULL;
    const counts *way_of = p ? of->way : s.way, *busy = &way_of[BUSY];
    const double texels = p ? (double)p->width * p->height : 1;
    size_t text;
    double ms;
    bound which = BOUNDS;
    fprintf(f, "%s,%s,\"%s\",%s,%d,%d", w->family[family], w->driver, c->name, p ? p->name : "",
            p ? p->width : WIDTH, p ? p->height : HEIGHT);
    for (way how = BUSY; how < WAYS; ++how) fprintf(f, ",%.1f", way_of[how].vector);
    fprintf(f, ",%.1f,%.1f,%.1f,%.2f,%.2f,%.2f,%d,%d,%d,%d", busy->transcendental, way_of[CALM].transcendental,
            busy->scalar_loads, busy->fetches, p ? p->bytes_in / texels : s.bytes_in,
            p ? p->bytes_out / texels : s.bytes_out, p ? of->vgprs : s.vgprs, p ? of->waves : s.waves,
            p ? of->spilled : s.spilled, p ? of->scratch : s.scratch);
    for (int k = 0; k < devices_count; ++k) {
        const int here = family_of(w, &devices[k]) == family;
        for (way how = BUSY; how < WAYS; ++how) {
            if (!here) fputc(',', f);
            else fprintf(f, ",%.4f", p ? pass_ms(w, p, family, how, &devices[k], &which)
                                       : chain_ms(w, c, family, how, &devices[k]));
        }
    }
    fprintf(f, ",%s", p && which < BOUNDS ? bound_names[which] : "");
    if (p) fputs(",,,,,,\n", f);
    else {
        const int programs = programs_of(w, c, family, &text, &ms);
        fprintf(f, ",%d,%zu,%.0f,%.1f,%d,\"%s\"\n", programs, text, c->targets, ms, s.splats, than_of(w, c));
    }
}

void write_costs(FILE *f, const work *w)
{
    fputs("family,driver,chain,pass,width,height", f);
    for (way how = BUSY; how < WAYS; ++how) fprintf(f, ",%s", way_names[how]);
    fputs(",transcendental_busy,transcendental_calm,scalar_loads,fetches,bytes_in,bytes_out,vgprs,waves,spilled,"
          "scratch", f);
    for (int k = 0; k < devices_count; ++k)
        for (way how = BUSY; how < WAYS; ++how) fprintf(f, ",%s %s", devices[k].name, way_names[how]);
    fputs(",bound,programs,text_bytes,targets_1080,compile_ms,splats,cheaper_than\n", f);
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->chains; ++i) {
            const cost_chain *c = &w->chain[i];
            if (c->passes) write_row(f, w, family, c, NULL);
            for (int k = 0; k < c->passes; ++k) write_row(f, w, family, c, &c->pass[k]);
        }
}

void show_costs(const csv *c, int passes)
{
    char keys[1024] = "family,chain,pass,width,height,busy,calm,weighed,transcendental_busy,scalar_loads,fetches,"
                      "bytes_in,bytes_out,vgprs,waves,spilled,scratch";
    for (int k = 0; k < devices_count; ++k)
        snprintf(keys + strlen(keys), sizeof keys - strlen(keys), ",%s %s", devices[k].name, way_names[WEIGHED]);
    if (passes) strcat(keys, ",bound");
    csv_put(stdout, c, keys, passes ? NULL : "bound", 1); /* chains have no bound */
    puts("");
    csv_put(stdout, c, "family,chain,programs,text_bytes,compile_ms,targets_1080,splats,"
                       "cheaper_than", "bound", 1);
}
