/* against.c - a run beside the rows of another. Declared in against.h. */
#include "lab/cost/against.h"
#include "lab/measure/csv.h"
#include <math.h>
#include <string.h>

enum { MOST_REGISTERS = 128 };
static const double most_more = 1.03;

static csv read_csv(const char *path, kit_error *err)
{
    csv_folder = ".";
    const csv c = csv_read(path);
    if (!c.rows) kit_fail(err, "%s: cannot be read, or has no rows", path);
    return c;
}

/* The row of a whole chain; -1: there is none. */
static int row_of(const csv *c, const char *family, const char *chain)
{
    for (int i = 0; i < c->rows; ++i)
        if (!strcmp(csv_text(c, i, "family"), family) && !strcmp(csv_text(c, i, "chain"), chain) &&
            !*csv_text(c, i, "pass")) return i;
    return -1;
}

static double then_vector(const csv *then, int row, way how) { return csv_number(then, row, way_names[how]); }

/* Per cent. */
static double change(double now, double then) { return then > 0 ? 100 * (now / then - 1) : 0; }

/* The first device's milliseconds, weighed, of a family. */
static double ms_of(const work *w, const cost_chain *c, int family, const csv *then, int row, double *before)
{
    char key[64];
    for (int k = 0; k < devices_count; ++k) {
        if (strcmp(devices[k].family, w->family[family])) continue;
        snprintf(key, sizeof key, "%s weighed", devices[k].name);
        *before = csv_number(then, row, key);
        return chain_ms(w, c, family, WEIGHED, &devices[k]);
    }
    return *before = (double)NAN;
}

/* Whether instructions or registers are others than a row's; weighed ones alone are of other shares. */
static int differs(const sum *s, const csv *then, int row)
{
    int other = s->vgprs != (int)csv_number(then, row, "vgprs");
    for (way how = BUSY; how < WAYS; ++how) other |= fabs(s->way[how].vector - then_vector(then, row, how)) >= 0.06;
    return other;
}

int against_show(const work *w, const char *path, kit_error *err)
{
    const csv then = read_csv(path, err);
    int changed = 0;
    if (!then.rows) return -1;
    printf("\nagainst %s\n", path);
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->chains; ++i) {
            const cost_chain *c = &w->chain[i];
            const sum s = sum_of(w, c, family);
            const int row = row_of(&then, w->family[family], c->name);
            double before;
            if (!c->passes || row < 0 || !differs(&s, &then, row)) continue;
            const double ms = ms_of(w, c, family, &then, row, &before);
            printf("%-10s %-22s VALU", w->family[family], c->name);
            for (way how = BUSY; how <= WEIGHED; ++how) {
                const double was = then_vector(&then, row, how), is = s.way[how].vector;
                if (was >= 0) printf(" %s %.0f -> %.0f (%+.1f %%),", way_names[how], was, is, change(is, was));
            }
            printf(" VGPRs %.0f -> %d", csv_number(&then, row, "vgprs"), s.vgprs);
            if (before > 0) printf(", %.3f -> %.3f ms", before, ms);
            puts("");
            ++changed;
        }
    if (!changed) puts("nothing has changed");
    return 0;
}

/* A chain beside its row; -1: it has none. Returns how much is wrong with it. */
static int check_chain(const work *w, const cost_chain *c, int family, const csv *then, int row, const char *path)
{
    const sum s = sum_of(w, c, family);
    const char *name = w->family[family];
    const double busy = then_vector(then, row, BUSY), calm = then_vector(then, row, CALM);
    const int registers = (int)csv_number(then, row, "vgprs"), many = s.vgprs > MOST_REGISTERS;
    const int more = s.way[BUSY].vector > most_more * busy || s.way[CALM].vector > most_more * calm;
    if (s.spilled || s.scratch)
        printf("%s, %s: %d registers are spilled, %d bytes of scratch\n", name, c->name, s.spilled, s.scratch);
    if (many)
        printf("%s, %s: %d registers, more than %d%s\n", name, c->name, s.vgprs, MOST_REGISTERS,
               s.vgprs <= registers ? ", as is recorded" : "");
    if (more)
        printf("%s, %s: %.0f instructions busy, %.0f calm; %s has %.0f, %.0f. At most 3 %% more, or make cost-record\n",
               name, c->name, s.way[BUSY].vector, s.way[CALM].vector, path, busy, calm);
    return (s.spilled || s.scratch) + (many && s.vgprs > registers) + more;
}

int against_check(const work *w, const char *path, kit_error *err)
{
    const csv then = read_csv(path, err);
    int wrong = 0;
    if (!then.rows) return -1;
    if (strcmp(csv_text(&then, 0, "driver"), w->driver)) {
        printf("another compiler: %s has rows of %s, this is %s\n", path, csv_text(&then, 0, "driver"), w->driver);
        return 0;
    }
    for (int family = 0; family < w->families; ++family)
        for (int i = 0; i < w->chains; ++i) {
            const cost_chain *c = &w->chain[i];
            const int row = row_of(&then, w->family[family], c->name);
            if (!c->passes) continue;
            if (row < 0) printf("%s, %s: has no row in %s: make cost-record\n", w->family[family], c->name, path);
            wrong += row < 0 ? 1 : check_chain(w, c, family, &then, row, path);
        }
    printf("cost: %d chains of %d programs, %d families: %d faults\n", w->chains, w->programs, w->families, wrong);
    return wrong;
}
