/* count.c - counts instructions by walking through them. Scalar instructions are executed as far as their operands are
   known, so that a loop with a constant count is walked as often as it runs. A register is known or unknown. A mask of
   lanes is known, unknown, or unknown but not empty: in a block a wave has a lane or more. */
#include "lab/cost/count.h"
#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- the text ---------------------------------------------------------------------------------------------------- */

enum { VCC = 106, M0 = 124, EXEC = 126, REGISTERS = 128, LANES = 256, MOST_OPERANDS = 4 };

typedef enum operand_kind { NOTHING, NUMBER, REGISTER } operand_kind;
typedef struct operand { operand_kind kind; int first, count; uint32_t number; } operand;

typedef enum class { VECTOR, TRANSCENDENTAL, FETCH, BUFFER, SCALAR_LOAD, EXPORT, SCALAR, BRANCH, END } class;

typedef struct instruction {
    const char *line;
    char name[32];
    class class;
    operand operand[MOST_OPERANDS];
    int operands, target, loop;             /* target: index of a branch's target; loop: of its inner loop's start */
    int bytes;                              /* bytes that a fetch brings to each lane */
} instruction;

typedef struct program {
    instruction *at;
    int count, labels;
    int *label, *last;                      /* by block: its first instruction; by a loop's first: its last */
} program;

static int starts(const char *text, const char *with) { return !strncmp(text, with, strlen(with)); }

static operand read_operand(const char *text)
{
    static const struct { const char *name; int first, count; } named[] = {
        { "vcc_lo", VCC, 1 }, { "vcc_hi", VCC + 1, 1 }, { "vcc", VCC, 2 }, { "exec_lo", EXEC, 1 },
        { "exec_hi", EXEC + 1, 1 }, { "exec", EXEC, 2 }, { "m0", M0, 1 }
    };
    operand o = { NOTHING, 0, 0, 0 };
    char *end;
    for (size_t i = 0; i < sizeof named / sizeof *named; ++i)
        if (starts(text, named[i].name)) {
            o.kind = REGISTER;
            o.first = named[i].first;
            o.count = named[i].count;
            return o;
        }
    if ((*text == 's' || *text == 'v') && (text[1] == '[' || isdigit((unsigned char)text[1]))) {      /* s3, s[2:3] */
        o.kind = REGISTER;
        o.first = (int)strtol(text + 1 + (text[1] == '['), &end, 10);
        o.count = *end == ':' ? (int)strtol(end + 1, NULL, 10) - o.first + 1 : 1;
        o.first += *text == 'v' ? REGISTERS : 0;
    } else if (isdigit((unsigned char)text[*text == '-'])) {
        const float real = strtof(text, NULL);
        o.kind = NUMBER;
        o.number = (uint32_t)strtoll(text, &end, 0);
        if (*end == '.') memcpy(&o.number, &real, sizeof real);
    }
    if (o.kind == REGISTER && (o.first < 0 || o.count < 1 || o.first + o.count > REGISTERS + LANES)) o.kind = NOTHING;
    return o;
}

static class class_of(const char *name)
{
    static const struct { const char *name; class class; } begins[] = {
        { "v_rcp_", TRANSCENDENTAL }, { "v_rsq_", TRANSCENDENTAL }, { "v_sqrt_", TRANSCENDENTAL },
        { "v_sin_", TRANSCENDENTAL }, { "v_cos_", TRANSCENDENTAL }, { "v_exp_", TRANSCENDENTAL },
        { "v_log_", TRANSCENDENTAL }, { "v_nop", SCALAR }, { "v_", VECTOR }, { "image_store", EXPORT },
        { "image_", FETCH },
        { "buffer_load", BUFFER }, { "tbuffer_load", BUFFER }, { "global_load", BUFFER }, { "flat_load", BUFFER },
        { "s_load", SCALAR_LOAD }, { "s_buffer_load", SCALAR_LOAD }, { "exp", EXPORT }, { "s_cbranch", BRANCH },
        { "s_branch", BRANCH }, { "s_endpgm", END }
    };
    for (size_t i = 0; i < sizeof begins / sizeof *begins; ++i)
        if (starts(name, begins[i].name)) return begins[i].class;
    return SCALAR;
}

/* Returns the bytes that a fetch brings to a lane: four for each channel of dmask, or two if d16 packs two. */
static int fetched_bytes(const char *line, size_t length)
{
    const char *mask = strstr(line, "dmask:"), *half = strstr(line, " d16");
    int bytes = 0;
    if (!mask || mask > line + length) return 0;
    for (long m = strtol(mask + 6, NULL, 0); m; m >>= 1) bytes += m & 1 ? 4 : 0;
    return half && half < line + length ? bytes / 2 : bytes;
}

static void read_instruction(instruction *t, const char *line)
{
    const size_t length = strcspn(line, ";\n"), name = strcspn(line, " \n");
    memset(t, 0, sizeof *t);
    t->line = line;
    t->target = t->loop = -1;
    memcpy(t->name, line, name < sizeof t->name ? name : sizeof t->name - 1);
    t->class = class_of(t->name);
    t->bytes = t->class == FETCH ? fetched_bytes(line, length) : 0;
    const char *at = line + name;
    while (t->operands < MOST_OPERANDS && at < line + length) {
        at += strspn(at, " ");
        if (at >= line + length) break;
        if (t->class == BRANCH && starts(at, "BB")) t->target = (int)strtol(at + 2, NULL, 10);
        t->operand[t->operands++] = read_operand(at);
        at += strcspn(at, ",;\n");
        if (*at != ',') break;
        ++at;
    }
}

static int read_program(program *p, const char *text, const char **bad)
{
    int room = 0;
    memset(p, 0, sizeof *p);
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        line += strspn(line, " \t");
        if (starts(line, "BB")) {
            const int block = (int)strtol(line + 2, NULL, 10);
            while (p->labels <= block) {
                p->label = realloc(p->label, (size_t)(p->labels + 1) * sizeof *p->label);
                p->label[p->labels++] = -1;
            }
            p->label[block] = p->count;
        } else if (*line && *line != '\n' && *line != ';') {
            if (p->count == room) p->at = realloc(p->at, (size_t)(room = room ? 2 * room : 256) * sizeof *p->at);
            read_instruction(&p->at[p->count++], line);
        }
    }
    for (int i = 0; i < p->count; ++i) {
        instruction *t = &p->at[i];
        if (t->class != BRANCH) continue;
        if (t->target < 0 || t->target >= p->labels || p->label[t->target] < 0) return *bad = t->line, -1;
        t->target = p->label[t->target];
    }
    p->last = calloc((size_t)p->count + 1, sizeof *p->last);
    for (int i = 0; i < p->count; ++i)
        if (p->at[i].target >= 0 && p->at[i].target <= i) p->last[p->at[i].target] = i;
    for (int i = 0; i < p->count; ++i)                      /* an outer loop begins before its inner loops */
        for (int k = i; p->last[i] && k <= p->last[i]; ++k) p->at[k].loop = i;
    return 0;
}

/* ---- scalar values ----------------------------------------------------------------------------------------------- */

/* SOME: a mask that is not 0. An unknown value has a number, too, by which it is recognised after a move. */
typedef enum known { UNKNOWN, KNOWN, SOME } known;
typedef struct value { known known; uint64_t number; } value;
typedef struct machine {
    known known[REGISTERS + LANES];
    uint32_t number[REGISTERS + LANES];
    value condition;
    uint64_t *names;                        /* the number that the next unknown value gets */
} machine;

static value unknown(machine *m) { return (value) { UNKNOWN, ++*m->names }; }

static value get(machine *m, const operand *o, int wide)
{
    if (o->kind == NUMBER) return (value) { KNOWN, wide ? (uint64_t)(int64_t)(int32_t)o->number : o->number };
    if (o->kind != REGISTER) return unknown(m);
    const int r = o->first;
    if (!wide) return (value) { m->known[r], m->number[r] };
    if (r + 1 >= REGISTERS || m->known[r] != m->known[r + 1]) return unknown(m);
    return (value) { m->known[r], m->number[r] | (uint64_t)m->number[r + 1] << 32 };
}

static void put(machine *m, const operand *o, value v)
{
    for (int i = 0; o->kind == REGISTER && i < o->count; ++i) {
        m->known[o->first + i] = i < 2 ? v.known : UNKNOWN;
        m->number[o->first + i] = (uint32_t)(v.number >> (i ? 32 : 0));
    }
}

typedef enum doing {
    MOVE, ADD, SUBTRACT, MULTIPLY, SHIFT_LEFT, SHIFT_RIGHT, SHIFT_SIGNED, AND, AND_NOT, OR, OR_NOT, XOR, NOT, LEAST,
    MOST, LEAST_UNSIGNED, MOST_UNSIGNED, MAGNITUDE, SHIFT_ADD, WHOLE, SELECT, COMPARE
} doing;

/* How an instruction sets the scalar condition code by its result. */
typedef enum tells { KEEPS, CARRY, NOT_ZERO } tells;

static const struct operation { const char *name; doing doing; tells tells; } operations[] = {
    { "s_mov_", MOVE, KEEPS }, { "s_movk_", MOVE, KEEPS }, { "s_add_", ADD, CARRY }, { "s_addk_", ADD, CARRY },
    { "s_sub_", SUBTRACT, CARRY }, { "s_mul_i32", MULTIPLY, KEEPS }, { "s_mulk_", MULTIPLY, KEEPS },
    { "s_lshl_", SHIFT_LEFT, NOT_ZERO }, { "s_lshr_", SHIFT_RIGHT, NOT_ZERO }, { "s_ashr_", SHIFT_SIGNED, NOT_ZERO },
    { "s_and_", AND, NOT_ZERO }, { "s_andn2_", AND_NOT, NOT_ZERO }, { "s_or_", OR, NOT_ZERO },
    { "s_orn2_", OR_NOT, NOT_ZERO }, { "s_xor_", XOR, NOT_ZERO }, { "s_not_", NOT, NOT_ZERO },
    { "s_min_i32", LEAST, CARRY }, { "s_max_i32", MOST, CARRY }, { "s_min_u32", LEAST_UNSIGNED, CARRY },
    { "s_max_u32", MOST_UNSIGNED, CARRY }, { "s_abs_i32", MAGNITUDE, NOT_ZERO }, { "s_lshl1_add_", SHIFT_ADD, CARRY },
    { "s_lshl2_add_", SHIFT_ADD, CARRY }, { "s_lshl3_add_", SHIFT_ADD, CARRY }, { "s_lshl4_add_", SHIFT_ADD, CARRY },
    { "s_wqm_", WHOLE, NOT_ZERO }, { "s_cselect_", SELECT, KEEPS }, { "s_cmp_", COMPARE, KEEPS },
    { "s_cmpk_", COMPARE, KEEPS }
};

static uint64_t calculate(doing what, const char *name, uint64_t a, uint64_t b)
{
    const int32_t x = (int32_t)(uint32_t)a, y = (int32_t)(uint32_t)b;
    switch (what) {
    case ADD: return a + b;
    case SUBTRACT: return a - b;
    case MULTIPLY: return a * b;
    case SHIFT_LEFT: return a << (b & 63);
    case SHIFT_RIGHT: return a >> (b & 63);
    case SHIFT_SIGNED: return (uint64_t)(int64_t)(x >> (b & 31));
    case AND: return a & b;
    case AND_NOT: return a & ~b;
    case OR: return a | b;
    case OR_NOT: return a | ~b;
    case XOR: return a ^ b;
    case NOT: return ~a;
    case LEAST: return x < y ? a : b;
    case MOST: return x > y ? a : b;
    case LEAST_UNSIGNED: return a < b ? a : b;
    case MOST_UNSIGNED: return a > b ? a : b;
    case MAGNITUDE: return x < 0 ? (uint64_t)-(int64_t)x : a;
    case SHIFT_ADD: return (a << (name[6] - '0')) + b;
    default: return a;
    }
}

/* Compares by an instruction such as s_cmp_ge_i32 or v_cmpx_ge_i32_e32. Comparisons of floats stay unknown. */
static value compare(const char *name, value a, value b)
{
    const char *relation = strchr(name + 2, '_') + 1;
    const int is_signed = starts(relation + 2, "_i"), whole = is_signed || starts(relation + 2, "_u");
    const int64_t x = is_signed ? (int32_t)(uint32_t)a.number : (int64_t)a.number;
    const int64_t y = is_signed ? (int32_t)(uint32_t)b.number : (int64_t)b.number;
    value v = { whole && a.known == KNOWN && b.known == KNOWN ? KNOWN : UNKNOWN, 0 };
    if (starts(relation, "eq")) v.number = x == y;
    else if (starts(relation, "lg") || starts(relation, "ne")) v.number = x != y;
    else if (starts(relation, "gt")) v.number = x > y;
    else if (starts(relation, "ge")) v.number = x >= y;
    else if (starts(relation, "lt")) v.number = x < y;
    else if (starts(relation, "le")) v.number = x <= y;
    else v.known = UNKNOWN;
    return v;
}

/* Combines masks that are known in part: 0 "and" anything is 0, a mask without itself is 0, and a mask that is not
   empty stays so under "or". */
static value combine(machine *m, doing what, const char *name, value a, value b, uint64_t all)
{
    const int a_is_0 = a.known == KNOWN && !a.number, b_is_0 = b.known == KNOWN && !b.number;
    const int a_is_all = a.known == KNOWN && a.number == all, b_is_all = b.known == KNOWN && b.number == all;
    const int same = a.known != KNOWN && b.known != KNOWN && a.number == b.number;
    const value zero = { KNOWN, 0 };
    if (a.known == KNOWN && b.known == KNOWN) return (value) { KNOWN, calculate(what, name, a.number, b.number) & all };
    if (what == MOVE) return a;
    if (what == AND && (a_is_0 || b_is_0)) return zero;
    if (what == AND && (a_is_all || same)) return b;
    if (what == AND && b_is_all) return a;
    if (what == AND_NOT && (a_is_0 || b_is_all || same)) return zero;
    if (what == AND_NOT && b_is_0) return a;
    if (what == OR && (a_is_0 || same)) return b;
    if (what == OR && b_is_0) return a;
    value v = unknown(m);
    if ((what == OR && (a.known == SOME || b.known == SOME)) || (what == WHOLE && a.known == SOME)) v.known = SOME;
    return v;
}

static value told(value v) { return (value) { v.known == UNKNOWN ? UNKNOWN : KNOWN, v.known == SOME || v.number }; }

/* Executes a scalar instruction. One that is not in the table makes its result unknown. */
static void execute(machine *m, const instruction *t)
{
    const int wide = strstr(t->name, "_b64") != NULL || strstr(t->name, "_u64") != NULL;
    const uint64_t all = wide ? ~(uint64_t)0 : 0xffffffffu;
    const operand exec = { REGISTER, EXEC, 2, 0 };
    const operand *to = &t->operand[0];
    if (strstr(t->name, "_saveexec_")) {                    /* s_and_saveexec_b64 to, mask; s_andn2_: mask & ~exec */
        const value was = get(m, &exec, 1), mask = get(m, &t->operand[1], 1);
        const value now = starts(t->name, "s_and_") ? combine(m, AND, "", mask, was, all)
                        : starts(t->name, "s_andn2_") ? combine(m, AND_NOT, "", mask, was, all)
                        : starts(t->name, "s_or_") ? combine(m, OR, "", mask, was, all) : unknown(m);
        put(m, to, was);
        put(m, &exec, now);
        m->condition = told(now);
        return;
    }
    for (size_t i = 0; i < sizeof operations / sizeof *operations; ++i) {
        const struct operation *o = &operations[i];
        if (!starts(t->name, o->name)) continue;
        const int in_place = !strcmp(o->name, "s_addk_") || !strcmp(o->name, "s_mulk_");
        const int compares = o->doing == COMPARE;
        const value a = get(m, &t->operand[compares || in_place ? 0 : 1], wide);
        const value b = get(m, &t->operand[compares || in_place ? 1 : 2], wide);
        value v;
        if (compares) {
            m->condition = compare(t->name, a, b);
            return;
        }
        if (o->doing == SELECT) {
            v = m->condition.known != KNOWN ? unknown(m) : m->condition.number ? a : b;
            put(m, to, v);
            return;
        }
        v = o->doing == MOVE || o->doing == NOT || o->doing == MAGNITUDE || o->doing == WHOLE
          ? combine(m, o->doing, t->name, a, a, all) : combine(m, o->doing, t->name, a, b, all);
        put(m, to, v);
        if (o->tells == NOT_ZERO) m->condition = told(v);
        if (o->tells == CARRY) m->condition = unknown(m);
        return;
    }
    if (starts(t->name, "s_bitcmp")) { m->condition = unknown(m); return; }
    put(m, to, unknown(m));
    if (!starts(t->name, "s_waitcnt") && !starts(t->name, "s_clause") && !starts(t->name, "s_nop") &&
        !starts(t->name, "s_load") && !starts(t->name, "s_buffer_load")) m->condition = unknown(m);
}

/* Executes a vector instruction. Its result is unknown, with two exceptions: a choice between two numbers, of which the
   busy walk takes the greater and the calm one the lesser, and comparisons with that number. Compilers write so how
   often a loop runs if some pixels leave it out. */
static void execute_vector(machine *m, const instruction *t, way how)
{
    const operand exec = { REGISTER, EXEC, 2, 0 };
    const operand *o = t->operand;
    value v = unknown(m);
    if (starts(t->name, "v_cndmask_b32") && o[1].kind == NUMBER && o[2].kind == NUMBER) {
        const int first = ((int32_t)o[1].number > (int32_t)o[2].number) == (how == BUSY);
        v = (value) { KNOWN, first ? o[1].number : o[2].number };
    } else if (starts(t->name, "v_cmp")) {
        const int over = starts(t->name, "v_cmpx") && o[0].kind == REGISTER && t->operands == 2;
        const value is = compare(t->name, get(m, &o[over ? 0 : 1], 0), get(m, &o[over ? 1 : 2], 0));
        if (is.known == KNOWN) v = is.number ? get(m, &exec, 1) : (value) { KNOWN, 0 };
        if (starts(t->name, "v_cmpx")) put(m, &exec, v);
        if (over) return;
    }
    put(m, &o[0], v);
    if (strstr(t->name, "_co_") || starts(t->name, "v_div_scale") || starts(t->name, "v_mad_u64") ||
        starts(t->name, "v_mad_i64")) put(m, &o[1], unknown(m));
}

/* ---- the walk ---------------------------------------------------------------------------------------------------- */

enum { MOST_TURNS = 4096 };

typedef struct walk {
    const program *program;
    walk_report *report;
    way how;
    int assumed;                            /* turns to assume for a loop with an unknown end */
    int *body, bodies;                      /* for CALM: by branch, the number (from 1) of the body that it skips */
    int enters;                             /* for CALM: the body to enter; 0: none, and bodies get numbers */
    int *turns;                             /* turns of each loop so far, by its first instruction */
    char *endless;                          /* 1 for a loop whose end is unknown, by its first instruction */
    char *met;                              /* 1 for a branch with an unknown condition that is counted */
    long left;                              /* instructions after which the walk fails as endless */
    int again;                              /* 1: a loop's end turned out unknown: the walk starts again */
} walk;

static void count_one(counts *c, const instruction *t)
{
    switch (t->class) {
    case TRANSCENDENTAL: ++c->transcendental; ++c->vector; break;
    case VECTOR: ++c->vector; break;
    case FETCH: ++c->fetches; c->wide_fetches += t->bytes > 8; break;
    case SCALAR_LOAD: ++c->scalar_loads; break;
    case BUFFER: case EXPORT: break;
    default: ++c->scalar; break;
    }
}

static double weight(const counts *c) { return c->vector + 3 * c->transcendental + c->fetches + 0.01 * c->scalar; }

void counts_add(counts *to, const counts *c, double times)
{
    for (size_t i = 0; i < sizeof *c / sizeof(double); ++i) (&to->vector)[i] += times * (&c->vector)[i];
}

/* Returns 1 if a branch's condition holds, 0 if not, -1 if that is not known. */
static int condition_of(machine *m, const instruction *t)
{
    const operand exec = { REGISTER, EXEC, 2, 0 }, vcc = { REGISTER, VCC, 2, 0 };
    if (!strcmp(t->name, "s_branch")) return 1;
    const int of_zero = strstr(t->name, "z") && !strstr(t->name, "nz");
    if (strstr(t->name, "_scc"))
        return m->condition.known != KNOWN ? -1 : (int)m->condition.number == (t->name[strlen(t->name) - 1] == '1');
    const value c = told(get(m, strstr(t->name, "_exec") ? &exec : &vcc, 1));
    return c.known != KNOWN ? -1 : of_zero ? !c.number : (int)c.number;
}

static int walk_on(walk *w, machine *m, counts *c, int from, int stop);

/* Walks both sides of a branch to an else whose condition is unknown but the same for all lanes, and keeps the more
   expensive side (CALM: the cheaper one). Returns where both sides meet; if one leaves the loop, the other is kept. */
static int walk_both(walk *w, machine *m, counts *c, int at, int join)
{
    const instruction *t = &w->program->at[at];
    machine then = *m, other = *m;
    counts of_then = { 0 }, of_other = { 0 };
    const int met_then = walk_on(w, &then, &of_then, at + 1, join);
    const int met_other = walk_on(w, &other, &of_other, t->target, join);
    const int calm = w->how == CALM && t->loop >= 0;
    int takes_then = (weight(&of_then) >= weight(&of_other)) != calm;
    if (met_then != join) takes_then = 0;
    if (met_other != join) takes_then = 1;
    counts_add(c, takes_then ? &of_then : &of_other, 1);
    *m = takes_then ? then : other;
    for (int r = 0; r < REGISTERS + LANES; ++r)
        if (then.known[r] != other.known[r] || then.number[r] != other.number[r]) m->known[r] = UNKNOWN;
    return join;
}

/* Returns whether a branch over a body is taken if its condition is unknown. Only branches that a calm wave reaches
   have a number. The others, such as those inside a body that is not entered, skip nothing. */
static int skips_body(walk *w, int at)
{
    if (w->how != CALM || w->program->at[at].loop < 0) return 0;
    if (!w->enters && !w->body[at]) w->body[at] = ++w->bodies;
    return w->body[at] && w->body[at] != w->enters;
}

/* Counts a branch, and returns the index of the instruction that is executed after it. */
static int walk_branch(walk *w, machine *m, counts *c, int at)
{
    const program *p = w->program;
    const instruction *t = &p->at[at];
    const operand exec = { REGISTER, EXEC, 2, 0 };
    const int holds = condition_of(m, t), on_lanes = strstr(t->name, "_exec") != NULL;
    value some = get(m, &exec, 1);
    const value none = { KNOWN, 0 };
    some.known = SOME;
    if (holds >= 0) return holds ? t->target : at + 1;
    const int leaves = t->loop >= 0 && t->target > p->last[t->loop];
    if (leaves || t->target <= at) {                        /* while its condition is unknown, a loop goes on */
        if (on_lanes) put(m, &exec, some);
        return t->target <= at ? t->target : at + 1;
    }
    if (!on_lanes && !w->met[at]++) ++w->report->unknown;
    const instruction *end = &p->at[t->target - 1];
    if (!on_lanes && !strcmp(end->name, "s_branch") && end->target > t->target)
        return walk_both(w, m, c, at, end->target);
    const int skips = skips_body(w, at);
    if (on_lanes) put(m, &exec, skips == (strstr(t->name, "execz") != NULL) ? none : some);
    return skips ? t->target : at + 1;
}

/* Walks from an instruction to stop, or to the end of the program. Returns the index at which it ended. */
static int walk_on(walk *w, machine *m, counts *c, int from, int stop)
{
    const program *p = w->program;
    int at = from, previous = -1;
    while (at != stop && at < p->count && w->left-- > 0 && !w->again) {
        const instruction *t = &p->at[at];
        if (p->last[at] && t->loop == at) {
            if (previous < at) w->turns[at] = 0;            /* the loop is entered from above, not turned */
            if (++w->turns[at] > MOST_TURNS) { w->endless[at] = 1; w->again = 1; break; }
            if (w->endless[at] && w->turns[at] > w->assumed) { previous = at; at = p->last[at] + 1; continue; }
        }
        previous = at;
        if (t->class == END) return p->count;
        count_one(c, t);
        if (t->class == BRANCH) { at = walk_branch(w, m, c, at); continue; }
        if (t->class == SCALAR || t->class == SCALAR_LOAD) execute(m, t);
        if (t->class == VECTOR || t->class == TRANSCENDENTAL) execute_vector(m, t, w->how);
        if (t->class == FETCH || t->class == BUFFER) put(m, &t->operand[0], unknown(m));
        ++at;
    }
    return at;
}

/* Walks from the first instruction to the end, in one of the ways, and counts. */
static int walk_all(walk *w, counts *c, way how, int enters, const int turns[2])
{
    const int count = w->program->count;
    w->how = how;
    w->enters = enters;
    w->assumed = turns[how];
    memset(w->met, 0, (size_t)count);
    w->report->unknown = 0;
    do {
        uint64_t names = 1;
        machine m = { .names = &names };
        m.known[EXEC] = m.known[EXEC + 1] = SOME;
        m.number[EXEC] = (uint32_t)names;
        memset(c, 0, sizeof *c);
        if (how == CALM && !enters) memset(w->body, w->bodies = 0, (size_t)count * sizeof *w->body);
        w->again = 0;
        w->left = 20000000;
        if (walk_on(w, &m, c, 0, -1) < count && !w->again) return -1;
    } while (w->again);
    return 0;
}

int count_instructions(counted *c, const char *text, const int turns[2], const char **bad)
{
    program p;
    walk w = { .program = &p, .report = &c->report };
    *bad = "";
    memset(c, 0, sizeof *c);
    int failed = read_program(&p, text, bad);
    const size_t count = (size_t)p.count + 1;
    w.turns = calloc(count, sizeof *w.turns);
    w.body = calloc(count, sizeof *w.body);
    w.endless = calloc(count, 1);
    w.met = calloc(count, 1);
    failed = failed || walk_all(&w, &c->calm, CALM, 0, turns);
    c->bodies = w.bodies;
    for (int i = 0; i < w.bodies && i < MOST_BODIES && !failed; ++i) {
        failed = walk_all(&w, &c->body[i], CALM, i + 1, turns);
        counts_add(&c->body[i], &c->calm, -1);
    }
    failed = failed || walk_all(&w, &c->busy, BUSY, 0, turns);
    for (int i = 0; i < p.count; ++i)
        if (w.endless[i] && c->report.loops < MOST_LOOPS)
            for (int b = 0; b < p.labels; ++b)
                if (p.label[b] == i) { c->report.endless[c->report.loops++] = b; break; }
    free(w.turns);
    free(w.body);
    free(w.endless);
    free(w.met);
    free(p.at);
    free(p.label);
    free(p.last);
    return failed;
}
