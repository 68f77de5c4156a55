/* against.c - compares the costs of a run of make cost with the csv of another run. Declared in against.h. */
#include "lab/cost/against.h"
#include <math.h>
#include <string.h>

enum { MOST_REGISTERS = 128 };
static const double most_more = 1.03;

static int read_then(csv *then, const char *path, kit_error *err)
{
    *then = csv_read(".", path);
    return then->rows ? 0 : kit_fail(err, "%s: cannot be read, or has no rows", path);
}

/* Returns the row of then for the whole chain of row of now; -1: there is none, or that row is of a single pass. */
static int row_of(const csv *then, const csv *now, int row)
{
    for (int i = 0; i < then->rows && !*csv_text(now, row, "pass"); ++i)
        if (!strcmp(csv_text(then, i, "family"), csv_text(now, row, "family"))
            && !strcmp(csv_text(then, i, "chain"), csv_text(now, row, "chain")) && !*csv_text(then, i, "pass"))
            return i;
    return -1;
}

/* Prints an old and a new value, if both are known and differ by at least least. Returns whether they do. */
static int show(const csv *now, int row, const csv *then, int was_row, const char *key, double least)
{
    const double is = csv_number(now, row, key), was = csv_number(then, was_row, key);
    if (!(fabs(is - was) >= least)) return 0;
    printf("  %s %.4g -> %.4g (%+.1f %%)", key, was, is, 100 * (is / was - 1));
    return 1;
}

int against_show(const csv *now, const char *path, kit_error *err)
{
    static const struct { const char *key; double least; } keys[] = {
        { "busy", 0.06 }, { "calm", 0.06 }, { "weighed", 0.06 }, { "weighed 16x4", 0.06 }, { "vgprs", 1 },
        { "RX 6800 weighed", 0.0005 }, { "RX 480 weighed", 0.0005 }
    };
    csv then;
    int changed = 0;
    if (read_then(&then, path, err)) return -1;
    printf("\nagainst %s\n", path);
    for (int row = 0; row < now->rows; ++row) {
        const int was = row_of(&then, now, row);
        int differs = 0;
        for (size_t k = 0; k < sizeof keys / sizeof *keys && was >= 0; ++k)
            differs |= show(now, row, &then, was, keys[k].key, keys[k].least);
        if (differs) printf("  %s, %s\n", csv_text(now, row, "family"), csv_text(now, row, "chain"));
        changed += differs;
    }
    if (!changed) puts("nothing has changed");
    return 0;
}

/* Compares a chain's costs with its recorded ones and prints each fault. Returns how many there are. */
static int check_chain(const csv *now, int row, const csv *then, int was, const char *path)
{
    const char *family = csv_text(now, row, "family"), *chain = csv_text(now, row, "chain");
    const double spilled = csv_number(now, row, "spilled"), scratch = csv_number(now, row, "scratch"),
                 registers = csv_number(now, row, "vgprs"), recorded = csv_number(then, was, "vgprs");
    int more = 0;
    if (spilled > 0 || scratch > 0)
        printf("%s, %s: %g registers are spilled, %g bytes of scratch\n", family, chain, spilled, scratch);
    if (registers > MOST_REGISTERS)
        printf("%s, %s: %g registers, more than %d%s\n", family, chain, registers, MOST_REGISTERS,
               registers <= recorded ? ", as is recorded" : "");
    for (int k = 0; k < 2; ++k) {
        const char *key = k ? "calm" : "busy";
        const double is = csv_number(now, row, key), had = csv_number(then, was, key);
        if (is <= most_more * had) continue;
        printf("%s, %s: %.0f instructions %s; %s has %.0f. At most 3 %% more, or make cost-record\n", family, chain, is,
               key, path, had);
        more = 1;
    }
    return (spilled > 0 || scratch > 0) + (registers > MOST_REGISTERS && registers > recorded) + more;
}

int against_check(const csv *now, const char *path, kit_error *err)
{
    csv then;
    int wrong = 0, chains = 0;
    if (read_then(&then, path, err)) return -1;
    if (strcmp(csv_text(&then, 0, "driver"), csv_text(now, 0, "driver"))) {
        printf("another compiler: %s has rows of %s, this is %s\n", path, csv_text(&then, 0, "driver"),
               csv_text(now, 0, "driver"));
        return 0;
    }
    for (int row = 0; row < now->rows; ++row) {
        const int was = row_of(&then, now, row);
        if (*csv_text(now, row, "pass")) continue;
        ++chains;
        if (was < 0)
            printf("%s, %s: has no row in %s: make cost-record\n", csv_text(now, row, "family"),
                   csv_text(now, row, "chain"), path);
        wrong += was < 0 ? 1 : check_chain(now, row, &then, was, path);
    }
    printf("cost: %d chains of all families: %d faults\n", chains, wrong);
    return wrong;
}
