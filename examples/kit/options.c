/* options.c - a program's command line as a table: it is parsed, and --help prints it. Declared in kit.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../../ssgi.h"
#include "kit/kit.h"

int kit_help(int argc, char **argv, const char *usage, const kit_option *table)
{
    enum { INDENT = 26, MOST = 100 };
    const char *const asked = argc == 2 ? argv[1] : "";
    if (!strcmp(asked, "--version")) return printf("ssgi %d.%d\n", SSGI_VERSION_MAJOR, SSGI_VERSION_MINOR) > 0;
    if (strcmp(asked, "--help") && strcmp(asked, "-h")) return 0;
    printf("usage: %s\n", usage);
    for (const kit_option *o = table; o->name || o->about; ++o) {
        char head[200];
        snprintf(head, sizeof head, "%s%s%s", o->name ? o->name : "", o->value ? " " : "", o->value ? o->value : "");
        if (o->name && printf("  %-*s ", INDENT - 3, head) > INDENT) printf("\n%*s", INDENT, "");
        kit_print_words(o->about, o->name ? INDENT : 0, o->name ? INDENT : 0, MOST);
    }
    return 1;
}

int kit_numbers(const char *name, const char *text, double *out, int count, kit_error *err)
{
    double v[9];
    const char *at = text;
    for (int i = 0; i < count; ++i) {
        char *end;
        v[i] = strtod(at, &end);
        if (end == at || *end != (i + 1 < count ? ',' : 0))
            return kit_fail(err, "%s %s: must be %d numbers with commas between", name, text, count);
        if (!(fabs(v[i]) <= KIT_MOST))
            return kit_fail(err, "%s %s: its numbers must be in -%g..%g", name, text, KIT_MOST, KIT_MOST);
        at = end + 1;
    }
    memcpy(out, v, (size_t)count * sizeof *v);
    return 0;
}

int kit_number(const char *name, const char *text, double least, double most, double *out, kit_error *err)
{
    char *end;
    const double v = strtod(text, &end);
    if (end == text || *end || !(v >= least && v <= most))
        return kit_fail(err, "%s %s: must be a number in %g..%g", name, text, least, most);
    *out = v;
    return 0;
}

int kit_whole(const char *name, const char *text, int least, int most, int *out, kit_error *err)
{
    double v = 0;
    if (kit_number(name, text, least, most, &v, NULL) || v != floor(v))
        return kit_fail(err, "%s %s: must be a whole number in %d..%d", name, text, least, most);
    *out = (int)v;
    return 0;
}

int kit_digits(const char **at, int most)
{
    int v = 0;
    for (; **at >= '0' && **at <= '9'; ++*at) v = v > most ? v : 10 * v + (**at - '0');
    return v > most ? 0 : v;
}

int kit_size(const char *name, const char *text, int least, int most, int out[2], kit_error *err)
{
    const char *at = text;
    const int width = kit_digits(&at, most), cross = *at == 'x', height = cross ? (++at, kit_digits(&at, most)) : 0;
    if (width < least || height < least || *at)
        return kit_fail(err, "%s %s: must be WxH, each %d..%d", name, text, least, most);
    out[0] = width;
    out[1] = height;
    return 0;
}

int kit_option_take(void *to, const kit_option *table, const char *name, const char *text, kit_error *err)
{
    const kit_option *o = table;
    while ((o->name || o->about) && (!o->name || o->kind == KIT_TOLD || strcmp(name, o->name))) ++o;
    if (!o->name) return kit_fail(err, "%s: there is no such option (--help names all)", name);
    void *const member = (char *)to + o->at;
    int *const said = (int *)(void *)((char *)to + o->said);
    const int least = (int)o->least, most = (int)o->most;
    int failed = 0;
    if (o->kind == KIT_FLAG) return *(int *)member = 1;
    if (!text) return kit_fail(err, "%s: needs a value", name);
    if (!*text && !o->empty) return kit_fail(err, "%s: its value is empty", name);
    if (o->said && o->kind != KIT_LIST) *said = 1;
    switch (o->kind) {
    case KIT_TEXT:    memcpy(member, &text, sizeof text); break;
    case KIT_WHOLE:   failed = kit_whole(name, text, least, most, member, err); break;
    case KIT_NUMBER:  failed = kit_number(name, text, o->least, o->most, member, err); break;
    case KIT_NUMBERS: failed = kit_numbers(name, text, member, least, err); break;
    case KIT_SIZE:    failed = kit_size(name, text, least, most, member, err); break;
    case KIT_LIST:
        if (*said >= most) return kit_fail(err, "%s %s: at most %d of them", name, text, most);
        ((const char **)member)[(*said)++] = text;
        break;
    default: failed = o->take(to, name, text, err);
    }
    return failed ? -1 : 2;
}

int kit_options(void *to, const kit_option *table, int argc, char **argv,
                int (*other)(void *to, const char *text, kit_error *err), kit_error *err)
{
    for (int i = 1, taken; i < argc; i += taken) {
        const int named = *argv[i] == '-' || !other;
        taken = named ? kit_option_take(to, table, argv[i], i + 1 < argc ? argv[i + 1] : NULL, err) : 1;
        if (taken < 0 || (!named && other(to, argv[i], err))) return -1;
    }
    return 0;
}
