/* fetches.c - how many texels a pixel fetches at most, and how many operations it takes, read off the text that the
   library emits. Declared in kit_gl.h.

   The text is cut into tokens and walked from main on: each call costs what the function costs, a branch the dearer way
   through it, a loop as much as all its rounds. Conditions that hang on constants, on arguments that are constants or
   on loop counters are decided, so that a loop over the layers of depth knows which is the last. Bounds that no text
   tells (u_ssgi_lights) count as one round. */
#include "kit/kit_gl.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

typedef struct token { const char *at; int length; } token;
/* What is known of an int: its value, or the loops (a bit each) whose counters it hangs on. */
typedef struct value { int known; long v; unsigned loops; } value;
typedef struct name { token id; value is; } name;
typedef struct function { token id; int open, body; } function;      /* ( and { */
/* The most fetched on the ways out of a statement: on to the next one, to the loop's next round, out of the function.
   NEVER: there is none. */
typedef struct flow { double on, round, out; } flow;
enum { NEVER = -1, MOST_NAMES = 256, MOST_FUNCTIONS = 256, DEEPEST = 64 };

typedef struct walk {
    token    *t;
    /* names from frame on are those of the function that is walked */
    int       count, names, frame, globals, functions, loops, depth;
    int       operations;                  /* 1: counts operators, constructors and calls of GLSL's own functions */
    unsigned  asked;                       /* loops whose counters a decision hung on */
    name      name[MOST_NAMES];
    function  function[MOST_FUNCTIONS];
} walk;

static const flow nothing = { 0, NEVER, NEVER };
static flow statement(walk *w, int i, int *end);
static double expression(walk *w, int a, int b);

static double most(double a, double b) { return a > b ? a : b; }
static double after(double before, double more) { return more < 0 ? NEVER : before + more; }

/* ---- >>tokens ---------------------------------------------------------------------------------------------------- */

static int cut(walk *w, const char *s)
{
    static const char *const pairs = "== != <= >= && || ++ -- += -= *= /= << >> |= &= ^= ";
    int line = 1;
    w->t = malloc((strlen(s) + 1) * sizeof *w->t);
    if (!w->t) return -1;
    while (*s) {
        const char *from = s;
        if (*s == '\n' || isspace((unsigned char)*s)) { line = *s == '\n' || line; ++s; continue; }
        if ((*s == '#' && line) || !strncmp(s, "//", 2)) { s += strcspn(s, "\n"); continue; }
        if (!strncmp(s, "/*", 2)) { s = strstr(s + 2, "*/"); if (!s) break; s += 2; continue; }
        line = 0;
        if (isalpha((unsigned char)*s) || *s == '_') while (isalnum((unsigned char)*s) || *s == '_') ++s;
        else if (isdigit((unsigned char)*s)) while (isalnum((unsigned char)*s) || *s == '.') ++s;
        else {
            ++s;
            for (const char *p = pairs; *p; p += 3) if (!strncmp(p, from, 2)) { ++s; break; }
        }
        w->t[w->count++] = (token){ from, (int)(s - from) };
    }
    return 0;
}

static int same(token a, token b) { return a.length == b.length && !memcmp(a.at, b.at, (size_t)a.length); }
static int is(const walk *w, int i, const char *s)
{
    return i >= 0 && i < w->count && (int)strlen(s) == w->t[i].length && !memcmp(w->t[i].at, s, strlen(s));
}
static int begins(token t, const char *s) { return t.length >= (int)strlen(s) && !memcmp(t.at, s, strlen(s)); }
static int is_name(const walk *w, int i)
{
    return i < w->count && (isalpha((unsigned char)*w->t[i].at) || *w->t[i].at == '_');
}

/* Behind the bracket that closes the one at i. */
static int closed(const walk *w, int i)
{
    int depth = 0;
    for (; i < w->count; ++i) {
        if (is(w, i, "(") || is(w, i, "[") || is(w, i, "{")) ++depth;
        if ((is(w, i, ")") || is(w, i, "]") || is(w, i, "}")) && !--depth) return i + 1;
    }
    return w->count;
}

/* The first of these one-character tokens from i on, outside of brackets, not beyond end. */
static int next_of(const walk *w, int i, int end, const char *which)
{
    while (i < end && !(w->t[i].length == 1 && strchr(which, *w->t[i].at))) {
        if (is(w, i, "(") || is(w, i, "[") || is(w, i, "{")) i = closed(w, i);
        else ++i;
    }
    return i < end ? i : end;
}

/* ---- >>values ---------------------------------------------------------------------------------------------------- */

static value look_up(const walk *w, token id)
{
    for (int i = w->names; i-- > w->frame;) if (same(w->name[i].id, id)) return w->name[i].is;
    for (int i = w->globals; i-- > 0;) if (same(w->name[i].id, id)) return w->name[i].is;
    return (value){ 0, 0, 0 };
}

static void learn(walk *w, token id, value is) { if (w->names < MOST_NAMES) w->name[w->names++] = (name){ id, is }; }

static int rank_of(const walk *w, int i)
{
    static const char *const by_rank[] = { "||", "&&", "==", "!=", "<", ">", "<=", ">=", "<<", ">>", "+", "-",
        "*", "/", "%" };
    static const int rank[] = { 1, 2, 3, 3, 4, 4, 4, 4, 5, 5, 6, 6, 7, 7, 7 };
    for (int k = 0; k < 15; ++k) if (is(w, i, by_rank[k])) return rank[k];
    return 0;
}

static value combined(const walk *w, int op, value a, value b)
{
    const unsigned loops = a.loops | b.loops;
    if (is(w, op, "&&") && ((a.known && !a.v) || (b.known && !b.v))) return (value){ 1, 0, 0 };
    if (is(w, op, "||") && ((a.known && a.v) || (b.known && b.v))) return (value){ 1, 1, 0 };
    if (!a.known || !b.known) return (value){ 0, 0, loops };
    if ((is(w, op, "/") || is(w, op, "%")) && !b.v) return (value){ 0, 0, loops };
    const long x = a.v, y = b.v;
    const long v = is(w, op, "||") ? x || y : is(w, op, "&&") ? x && y : is(w, op, "==") ? x == y
        : is(w, op, "!=") ? x != y : is(w, op, "<") ? x < y : is(w, op, ">") ? x > y : is(w, op, "<=") ? x <= y
        : is(w, op, ">=") ? x >= y : is(w, op, "<<") ? x << (y & 31) : is(w, op, ">>") ? x >> (y & 31)
        : is(w, op, "+") ? x + y : is(w, op, "-") ? x - y : is(w, op, "*") ? x * y : is(w, op, "/") ? x / y : x % y;
    return (value){ 1, v, 0 };
}

static value value_of(const walk *w, int *i, int end, int rank)
{
    value a = { 0, 0, 0 };
    if (*i >= end) return a;
    if (is(w, *i, "-") || is(w, *i, "!")) {
        const int minus = is(w, (*i)++, "-");
        a = value_of(w, i, end, 8);
        a.v = minus ? -a.v : !a.v;
    } else if (is(w, *i, "(")) {
        const int last = closed(w, *i) - 1;
        int from = *i + 1;
        a = value_of(w, &from, last, 0);
        if (from < last) a.known = 0;
        *i = last + 1;
    } else if (is_name(w, *i)) {
        a = look_up(w, w->t[(*i)++]);
    } else {
        char *stop;
        a.v = strtol(w->t[*i].at, &stop, 0);
        a.known = stop == w->t[*i].at + w->t[*i].length || (*stop == 'u' && stop + 1 == w->t[*i].at + w->t[*i].length);
        ++*i;
    }
    /* a call, an element, a member: not known */
    while (*i < end && (is(w, *i, "(") || is(w, *i, "[") || is(w, *i, "."))) {
        a.known = 0;
        *i = is(w, *i, ".") ? *i + 2 : closed(w, *i);
    }
    for (int r; *i < end && (r = rank_of(w, *i)) > rank;) {
        const int op = (*i)++;
        a = combined(w, op, a, value_of(w, i, end, r));
    }
    return a;
}

static value value_in(const walk *w, int a, int b)
{
    value v = value_of(w, &a, b, 0);
    if (a < b) v.known = 0;
    return v;
}

static value decided(walk *w, int a, int b)
{
    const value v = value_in(w, a, b);
    if (!v.known) w->asked |= v.loops;
    return v;
}

/* ---- >>walking --------------------------------------------------------------------------------------------------- */

/* What a call of the function named at i costs beside its arguments. */
static double call(walk *w, int i)
{
    const token id = w->t[i];
    const int last = closed(w, i + 1) - 1, names = w->names, frame = w->frame;
    double cost = 0;
    int own = 0;
    if (begins(id, "ssgi_custom_") || begins(id, "texelFetch") || same(id, (token){ "texture", 7 })
        || same(id, (token){ "textureLod", 10 })) return !w->operations;
    if (w->depth == DEEPEST) return 0;
    for (int k = 0; k < w->functions; ++k) {
        const function *f = &w->function[k];
        int arg = i + 2, end = 0, now = names;
        if (!same(f->id, id)) continue;
        own = 1;
        /* its parameters, as these arguments say */
        for (int p = f->open + 1; !is(w, p - 1, ")"); p = next_of(w, p, w->count, ",)") + 1) {
            const int comma = next_of(w, p, w->count, ",)"), stop = next_of(w, arg, last, ",");
            w->names = names;
            value v = arg < last ? value_in(w, arg, stop) : (value){ 0, 0, 0 };
            w->names = now;
            learn(w, w->t[comma - 1], v);
            now = w->names;
            arg = stop + 1;
        }
        w->frame = names;
        ++w->depth;
        const flow f_ = statement(w, f->body, &end);
        --w->depth;
        cost = most(cost, most(f_.on, f_.out));
        w->names = names;
        w->frame = frame;
    }
    return own ? cost : w->operations;
}

static double expression(walk *w, int a, int b)
{
    double cost = 0;
    for (int i = a, condition = a; i < b;) {
        if (is(w, i, "?")) {
            const int end = next_of(w, i, b, ",");
            int colon = i + 1;
            for (int open = 1; colon < end && open; ++colon) {
                if (is(w, colon, "(") || is(w, colon, "[")) colon = closed(w, colon) - 1;
                else open += is(w, colon, "?") - is(w, colon, ":");
            }
            const value v = decided(w, condition, i);
            const double yes = v.known && !v.v ? 0 : expression(w, i + 1, colon - 1);
            const double no = v.known && v.v ? 0 : expression(w, colon, end);
            cost += most(yes, no);
            i = end;
        } else if (is(w, i, "(") || is(w, i, "[")) {
            cost += expression(w, i + 1, closed(w, i) - 1);
            if (is(w, i, "(") && i > a && is_name(w, i - 1)) cost += call(w, i - 1);
            i = closed(w, i);
        } else {
            const char c = *w->t[i].at;
            cost += w->operations && (rank_of(w, i) > 0 || c == '!' || (strchr("+-*/", c) && w->t[i].length == 2));
            if (is(w, i, ",") || (w->t[i].at[w->t[i].length - 1] == '=' && !rank_of(w, i))) condition = i + 1;
            ++i;
        }
    }
    return cost;
}

static flow in_turn(flow a, flow b)
{
    return (flow){ after(a.on, b.on), most(a.round, after(a.on, b.round)), most(a.out, after(a.on, b.out)) };
}

static flow block(walk *w, int i, int *end)
{
    flow all = nothing;
    const int names = w->names;
    while (i < w->count && !is(w, i, "}")) {
        const int here = next_of(w, i, w->count, "=;"), stop = next_of(w, i, w->count, ";{") + 1,
            there = next_of(w, stop, w->count, "=;");
        /* what the next statement overwrites */
        int dead = is(w, here, "=") && is(w, there, "=") && here - i == there - stop;
        for (int k = 0; dead && k < here - i; ++k) dead = same(w->t[i + k], w->t[stop + k]);
        if (dead) { i = stop; continue; }
        const flow f = statement(w, i, &i);
        if (all.on >= 0) all = in_turn(all, f);
    }
    w->names = names;
    *end = i + 1;
    return all;
}

static flow branches(walk *w, int i, int *end)
{
    const int last = closed(w, i + 1);
    const value v = decided(w, i + 2, last - 1);
    flow all = { expression(w, i + 2, last - 1), NEVER, NEVER }, yes = statement(w, last, end), no = nothing;
    if (is(w, *end, "else")) no = statement(w, *end + 1, end);
    if (v.known) return in_turn(all, v.v ? yes : no);
    return in_turn(all, (flow){ most(yes.on, no.on), most(yes.round, no.round), most(yes.out, no.out) });
}

/* All rounds. Where nothing hangs on the counter each is as the first. */
static flow loop(walk *w, int i, int *end)
{
    const int last = closed(w, i + 1), first = next_of(w, i + 2, last, ";"), second = next_of(w, first + 1, last, ";");
    const int set = next_of(w, i + 2, first, "="), bounds = first + 3 < second;
    const value from = bounds ? value_in(w, set + 1, first) : (value){ 0, 0, 0 };
    const unsigned bit = 1u << (w->loops++ & 31);
    const int names = w->names;
    int to_end = first + 3;
    while (to_end < second && !is(w, to_end, "&&")) ++to_end;
    const value to = bounds ? decided(w, first + 3, to_end) : (value){ 0, 0, 0 };
    const value by = is(w, second + 2, "+=") ? value_in(w, second + 3, last - 1) : (value){ 1, 1, 0 };
    const long step = by.known && by.v > 0 ? by.v : 1, past = to.v + is(w, first + 2, "<=");
    const long rounds = from.known && to.known ? (past > from.v ? (past - from.v + step - 1) / step : 0) : 1;
    flow all = nothing, f;
    learn(w, w->t[set > i + 2 ? set - 1 : i], (value){ 0, 0, bit });
    const int counter = w->names - 1;
    const unsigned asked = w->asked;
    w->asked = 0;
    f = statement(w, last, end);
    const double test = expression(w, first + 1, second);
    const int hangs = (w->asked & bit) && from.known && to.known;
    w->asked = (w->asked & ~bit) | asked;
    for (long k = 0; k < rounds && all.on >= 0; ++k) {
        int again;
        if (hangs) {
            w->name[counter].is = (value){ 1, from.v + k * step, 0 };
            f = statement(w, last, &again);
        }
        all.out = most(all.out, after(all.on + test, f.out));
        all.on = after(all.on + test, most(f.on, f.round));
    }
    w->names = names;
    --w->loops;
    return all;
}

static flow statement(walk *w, int i, int *end)
{
    if (is(w, i, "{")) return block(w, i + 1, end);
    if (is(w, i, "if")) return branches(w, i, end);
    if (is(w, i, "for")) return loop(w, i, end);
    if (is(w, i, "while")) {                                       /* how often nobody knows */
        const flow test = { expression(w, i + 2, closed(w, i + 1) - 1), NEVER, NEVER };
        const flow f = in_turn(test, statement(w, closed(w, i + 1), end));
        return (flow){ most(f.on, f.round), NEVER, f.out };
    }
    const int stop = next_of(w, i, w->count, ";");
    const double cost = expression(w, i, stop);
    *end = stop + 1;
    if (is(w, i, "return") || is(w, i, "discard")) return (flow){ NEVER, NEVER, cost };
    if (is(w, i, "continue") || is(w, i, "break")) return (flow){ NEVER, cost, NEVER };
    return (flow){ cost, NEVER, NEVER };
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

/* The functions and the constants of a text. */
static void learn_text(walk *w)
{
    for (int i = 0; i < w->count; ++i) {
        if (is(w, i, "const") && is(w, i + 1, "int"))
            for (int k = i + 2; is_name(w, k) && is(w, k + 1, "=");) {
                const int stop = next_of(w, k + 2, w->count, ",;");
                w->globals = w->names;
                learn(w, w->t[k], value_in(w, k + 2, stop));
                k = stop + 1;
                if (is(w, stop, ";")) break;
            }
        if (is_name(w, i) && is(w, i + 1, "(") && is(w, closed(w, i + 1), "{") && w->functions < MOST_FUNCTIONS)
            w->function[w->functions++] = (function){ w->t[i], i + 1, closed(w, i + 1) };
        if (is(w, i, "(") || is(w, i, "{")) i = closed(w, i) - 1;
    }
    w->globals = w->frame = w->names;
}

static char *text_of(const ssgi_gl_desc *desc, int stage)
{
    const size_t n = ssgi_gl_emit(NULL, 0, desc, stage);
    char *text = n ? malloc(n + 1) : NULL;
    if (text) ssgi_gl_emit(text, n + 1, desc, stage);
    return text;
}

/* smooth reaches as far as its last level deals out; how many levels there are, pass sum's text says. */
static long reach_of(const ssgi_gl_desc *desc)
{
    static const char *const line = "const int SSGI_LEVELS = ";
    ssgi_gl_desc sum = *desc;
    char *text, *at;
    long levels = 1;
    sum.pass = SSGI_GL_PASS_SUM;
    text = text_of(&sum, SSGI_GL_STAGE_FRAGMENT);
    if (text && (at = strstr(text, line)) != NULL) levels = strtol(at + strlen(line), NULL, 10);
    free(text);
    return 1L << (levels - 1) >> 1;
}

static int counted(const ssgi_gl_desc *desc, int operations)
{
    const int stage = desc->pass != SSGI_GL_PASS_SURFELS ? SSGI_GL_STAGE_FRAGMENT
                    : desc->surfel.tessellate ? SSGI_GL_STAGE_TESS_EVALUATION : SSGI_GL_STAGE_VERTEX;
    walk *w = calloc(1, sizeof *w);
    char *text = text_of(desc, stage);
    double cost = 0;
    if (w && text && !cut(w, text)) {
        int end;
        w->operations = operations;
        learn_text(w);
        if (desc->pass == SSGI_GL_PASS_SMOOTH) learn(w, (token){ "reach", 5 }, (value){ 1, reach_of(desc), 0 });
        for (int k = 0; k < w->functions; ++k)
            if (same(w->function[k].id, (token){ "main", 4 })) {
                const flow f = statement(w, w->function[k].body, &end);
                cost = most(cost, most(f.on, f.out));
            }
    }
    if (w) free(w->t);
    free(w);
    free(text);
    return (int)cost;
}

/* The last ones are kept: each frame asks for those of the frame before. */
static int kept_count(const ssgi_gl_desc *desc, int operations)
{
    enum { KEPT = 256 };
    static struct { uint64_t key; int count; } kept[KEPT];
    static int next;
    uint64_t key = kit_hash(kit_hash(KIT_HASH, desc, sizeof *desc), &operations, sizeof operations);
    if (desc->text.fetch) key = kit_hash(key, desc->text.fetch, strlen(desc->text.fetch));
    for (int i = 0; i < KEPT; ++i) if (kept[i].key == key) return kept[i].count;
    const int count = counted(desc, operations);
    kept[next].key = key;
    kept[next].count = count;
    next = (next + 1) % KEPT;
    return count;
}

int kit_fetches(const ssgi_gl_desc *desc) { return kept_count(desc, 0); }
int kit_operations(const ssgi_gl_desc *desc) { return kept_count(desc, 1); }
