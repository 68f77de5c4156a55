/* show.c - tables of what passes and chains cost. Declared in show.h. */
#include "lab/cost/show.h"
#include <math.h>
#include <string.h>

/* ---- sums -------------------------------------------------------------------------------------------------------- */

sum sum_of(const work *w, const cost_chain *c, int family)
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
        s.endless += of->report.loops;
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
    return p->vertices ? splat_ms(w, p, family, how, d, SPLATS * texels / (p->vertices / QUAD), SURFELS, which)
                       : model(d, &l, which);
}

double chain_ms(const work *w, const cost_chain *c, int family, way how, const device *d)
{
    bound which;
    double ms = 0;
    for (int i = 0; i < c->passes; ++i) ms += pass_ms(w, &c->pass[i], family, how, d, &which);
    return ms;
}

/* The family whose instructions a device executes, as far as it is compiled for; -1: it is not. */
static int family_of(const work *w, const device *d)
{
    for (int i = 0; i < w->families; ++i) if (!strcmp(w->family[i], d->family)) return i;
    return -1;
}

/* ---- tables on stdout -------------------------------------------------------------------------------------------- */

static void print_heads(const work *w, const char *first, int family)
{
    char title[128];
    snprintf(title, sizeof title, "%s, %s", w->family[family], w->driver);
    printf("\n%-34s%14s%12s%20s\n%-27s%7s%7s%9s%6s%6s%6s%7s%7s%6s%6s%6s", title, "VALU", "transc.", "bytes", first,
           "busy", "calm", "weighed", "busy", "calm", "SMEM", "fetch", "in", "out", "VGPRs", "waves");
    for (int i = 0; i < devices_count; ++i)
        if (family_of(w, &devices[i]) == family) printf("  %s, ms (busy, calm)", devices[i].name);
    puts("");
}

static void print_counts(const char *name, const counts of[WAYS], double in, double out, int vgprs, int waves)
{
    const counts *busy = &of[BUSY], *calm = &of[CALM];
    printf("%-26s %7.0f%7.0f%9.0f%6.0f%6.0f%6.0f%7.1f%7.1f%6.1f%6d%6d", name, busy->vector, calm->vector,
           of[WEIGHED].vector, busy->transcendental, calm->transcendental, busy->scalar_loads, busy->fetches, in, out,
           vgprs, waves);
}

/* "0.39 (0.44, 0.30)" */
static void print_ms(const double ms[WAYS]) { printf("  %6.3f (%.3f, %.3f)", ms[WEIGHED], ms[BUSY], ms[CALM]); }

static void print_trouble(int spilled, int scratch)
{
    if (spilled || scratch) printf("  SPILLED %d, SCRATCH %d", spilled, scratch);
}

static void show_chain(const work *w, const cost_chain *c, int family)
{
    const sum s = sum_of(w, c, family);
    print_counts(c->name, s.way, s.bytes_in, s.bytes_out, s.vgprs, s.waves);
    for (int k = 0; k < devices_count; ++k) {
        double ms[WAYS];
        if (family_of(w, &devices[k]) != family) continue;
        for (way how = BUSY; how < WAYS; ++how) ms[how] = chain_ms(w, c, family, how, &devices[k]);
        print_ms(ms);
    }
    if (s.splats) fputs("  counts less splats", stdout);
    print_trouble(s.spilled, s.scratch);
    puts("");
}

static void show_pass(const work *w, const cost_pass *p, int family)
{
    const compiled *of = &w->program[p->program].of[family];
    const double texels = (double)p->width * p->height;
    char name[64];
    snprintf(name, sizeof name, "  %s, %dx%d", p->name, p->width, p->height);
    print_counts(name, of->way, p->bytes_in / texels, p->bytes_out / texels, of->vgprs, of->waves);
    for (int k = 0; k < devices_count; ++k) {
        bound which[WAYS];
        double ms[WAYS];
        if (family_of(w, &devices[k]) != family) continue;
        for (way how = BUSY; how < WAYS; ++how) ms[how] = pass_ms(w, p, family, how, &devices[k], &which[how]);
        print_ms(ms);
        printf(" %s", bound_names[which[WEIGHED]]);
    }
    if (p->vertices)
        printf("  counts of a splat's fragment; a surfel has %d vertices of %.0f VALU", p->vertices, of->vertex);
    print_trouble(of->spilled, of->scratch);
    if (of->report.loops) fputs("  *", stdout);
    if (of->untold) fputs("  BODIES ARE NOT TOLD APART: weighed is busy", stdout);
    if (of->report.unknown) printf("  unknown conditions: %d", of->report.unknown);
    puts("");
}

/* Loops whose end no instruction tells, once a pass. */
static void show_assumptions(const work *w)
{
    for (int i = 0; i < w->programs; ++i) {
        const cost_program *p = &w->program[i];
        int again = 0, known = 0;
        for (int k = 0; k < i; ++k) again |= w->program[k].of[0].report.loops && !strcmp(w->program[k].pass, p->pass);
        if (again || !p->of[0].report.loops) continue;
        printf("* %s: nothing tells when its loop at BB%d ends: ", p->pass, p->of[0].report.endless[0]);
        for (int k = 0; k < assumptions_count; ++k) {
            if (strcmp(assumptions[k].pass, p->pass)) continue;
            printf("%d turns busy, %d calm: %s\n", assumptions[k].turns[BUSY], assumptions[k].turns[CALM],
                   assumptions[k].why);
            known = 1;
        }
        if (!known) puts("IT IS COUNTED ONCE");
    }
}

void show_costs(const work *w, int passes)
{
    for (int family = 0; family < w->families; ++family) {
        print_heads(w, passes ? "chain, a pixel; pass, a texel" : "chain, a pixel", family);
        for (int i = 0; i < w->chains; ++i) {
            const cost_chain *c = &w->chain[i];
            if (c->passes) show_chain(w, c, family);
            for (int k = 0; k < c->passes && passes; ++k)
                if (*c->pass[k].name) show_pass(w, &c->pass[k], family);
        }
    }
    show_assumptions(w);
    for (int i = 0; i < w->chains; ++i)
        if (!w->chain[i].passes) printf("%s: not counted: %s\n", w->chain[i].name, w->chain[i].lacks.text);
}

/* Programs of a chain, each once; bytes of their texts; milliseconds until they are compiled for a family. */
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

void show_budget(const work *w)
{
    size_t text;
    double ms;
    printf("\n%-27s%9s%10s%9s", "budget", "programs", "text, kB", "ms*");
    for (int i = 0; i < SIZES; ++i) printf("   %4dx%d", sizes[i][0], sizes[i][1]);
    puts("   MB of targets");
    for (int i = 0; i < w->chains; ++i) {
        const cost_chain *c = &w->chain[i];
        if (!c->passes) continue;
        const int programs = programs_of(w, c, 0, &text, &ms);
        printf("%-26s %9d%10.1f%9.0f", c->name, programs, (double)text / 1e3, ms);
        for (int k = 0; k < SIZES; ++k) printf("%12.1f", c->targets[k] / 1e6);
        puts("");
    }
    printf("* of processor here, for glslang and RADV (%s) to compile them\n", w->family[0]);
}

const char *const kind_names[KINDS] = { "ambient occlusion", "light" };

/* ---- a ranking --------------------------------------------------------------------------------------------------- */

/* Whether a chain is cheaper by instructions and by the model, in every family and on every device, in every way. */
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

/* 0: ambient occlusion, 1: light; -1: not ranked: what it costs depends on how many objects or surfels there are. */
static int kind_of(const cost_chain *c)
{
    int light = 0;
    for (int i = 0; i < c->passes; ++i) {
        if (c->pass[i].vertices || !*c->pass[i].name || !strcmp(c->pass[i].name, "field")) return -1;
        light |= !strcmp(c->pass[i].name, "ssdo") || !strcmp(c->pass[i].name, "s3ho");
    }
    return c->passes ? light : -1;
}

static double busy_instructions(const work *w, const cost_chain *c) { return sum_of(w, c, 0).way[BUSY].vector; }

int ranking(const work *w, int kind, rank order[MOST_CHAINS])
{
    int count = 0;
    for (int i = 0; i < w->chains; ++i) {
        const cost_chain *c = &w->chain[i];
        if (kind_of(c) != kind) continue;
        int at = count++;
        for (; at && busy_instructions(w, order[at - 1].chain) > busy_instructions(w, c); --at)
            order[at] = order[at - 1];
        order[at].chain = c;
    }
    for (int i = 0; i < count; ++i) {
        int from = count;
        while (from > i + 1 && is_cheaper(w, order[i].chain, order[from - 1].chain)) --from;
        order[i].than = from < count ? order[from].chain : NULL;
    }
    return count;
}

void show_ranking(const work *w)
{
    for (int kind = 0; kind < KINDS; ++kind) {
        rank order[MOST_CHAINS];
        const int count = ranking(w, kind, order);
        if (count > 1) printf("\n%s: cheaper by instructions and by the model, in every family, busy, calm and "
                              "weighed\n", kind_names[kind]);
        for (int i = 0; i + 1 < count; ++i)
            if (order[i].than)
                printf("%-26s than %s and what follows it\n", order[i].chain->name, order[i].than->name);
    }
}

/* ---- csv --------------------------------------------------------------------------------------------------------- */

/* The first of those that a chain is cheaper than, all of them: "" where there is none, or it is not ranked. */
static const char *than_of(const work *w, const cost_chain *c)
{
    rank order[MOST_CHAINS];
    for (int kind = 0; kind < KINDS; ++kind)
        for (int i = ranking(w, kind, order); i-- > 0;)
            if (order[i].chain == c && order[i].than) return order[i].than->name;
    return "";
}

const char *const way_names[WAYS] = { "busy", "calm", "weighed", "weighed 16x4" };

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
    if (p) fputs(",,,,,,,,,\n", f);
    else {
        const int programs = programs_of(w, c, family, &text, &ms);
        fprintf(f, ",%d,%zu", programs, text);
        for (int k = 0; k < SIZES; ++k) fprintf(f, ",%.0f", c->targets[k]);
        fprintf(f, ",%.1f,%d,\"%s\"\n", ms, s.splats, than_of(w, c));
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
    fputs(",bound,programs,text_bytes", f);
    for (int k = 0; k < SIZES; ++k) fprintf(f, ",targets_%d", sizes[k][1]);
    fputs(",compile_ms,splats,cheaper_than\n", f);
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->chains; ++i) {
            const cost_chain *c = &w->chain[i];
            if (c->passes) write_row(f, w, family, c, NULL);
            for (int k = 0; k < c->passes; ++k) write_row(f, w, family, c, &c->pass[k]);
        }
}

void write_recorded(FILE *f, const work *w)
{
    fputs("family,driver,chain,pass,busy,calm,weighed,weighed 16x4,transcendental_busy,vgprs\n", f);
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->chains; ++i) {
            const sum s = sum_of(w, &w->chain[i], family);
            if (!w->chain[i].passes) continue;
            fprintf(f, "%s,%s,\"%s\",", w->family[family], w->driver, w->chain[i].name);
            for (way how = BUSY; how < WAYS; ++how) fprintf(f, ",%.1f", s.way[how].vector);
            fprintf(f, ",%.1f,%d\n", s.way[BUSY].transcendental, s.vgprs);
        }
}
