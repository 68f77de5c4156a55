/* library.c - the GLSL of ssgi_gl.h as files, for an editor's colours and checks: make glsl-out DIR=d writes them,
   make glsl-in DIR=d reads them back into the header, which stays what is shipped.

     build/library out ssgi_gl.h DIR        a file a room: DIR/fetch.glsl, DIR/visibility.glsl ..
     build/library in ssgi_gl.h DIR

   Each file is GLSL as it stands. Its head declares all that the room reads, writes and needs of other rooms, and has
   the commands that compile it: plainly, and with -D of each main function. Macros of choices (SSGI_BANDS) begin as one
   text of the room has them; more -D change them. Between the lines "//@@ .." is the room: each entry of the library
   behind a line "//@ NAME", the name that other functions use, between #if and #endif where it has a condition or not
   every stage can compile it. Comments between entries are kept. Below are copies of the functions that it needs. Both
   ways are exact: out and in again leaves the header as it was. */
#include "kit/kit.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../../ssgi_gl.h"
#include "choices.h" /* last: its names are short */

enum { LINE = 256, ROOMS = 32 };

static const char first_line[] = "static const ssgi_gl__code ssgi_gl__library[] = {\n", room_mark[] = "/* ==== >>",
                  entry_mark[] = "//@ ", body_mark[] = "//@@ the room\n", tail_mark[] = "\n//@@ of other rooms\n";

/* A text that grows. */
typedef struct text { char *data; size_t size, room; int failed; } text;

static void put(text *t, const char *s, size_t n)
{
    if (t->size + n + 1 > t->room) {
        const size_t room = 2 * (t->size + n + 1);
        char *data = realloc(t->data, room);
        if (!data) t->failed = 1;
        if (!data) return;
        t->data = data;
        t->room = room;
    }
    memcpy(t->data + t->size, s, n);
    t->size += n;
    t->data[t->size] = 0;
}

static void puts_to(text *t, const char *s) { put(t, s, strlen(s)); }

/* The library's lines in the header: from behind the first one to before the last. */
static int library_of(const char **from, const char **to, const char *header, const char *path, kit_error *err)
{
    const char *at = strstr(header, first_line);
    *from = at ? at + strlen(first_line) : NULL;
    *to = at ? strstr(*from, "\n};\n") : NULL;
    if (!*to) return kit_fail(err, "%s: has no library of GLSL (%.*s)", path, (int)strlen(first_line) - 1, first_line);
    ++*to;
    return 0;
}

/* A room's file, from its first line. */
static int room_path(char path[4096], const char *folder, const char *line)
{
    const char *name = line + strlen(room_mark);
    const int length = (int)strspn(name, "abcdefghijklmnopqrstuvwxyz_");
    const int n = snprintf(path, 4096, "%s/%.*s.glsl", folder, length, name);
    return length > 0 && n > 0 && n < 4096;
}

/* ---- out --------------------------------------------------------------------------------------------------------- */

/* The lines of GLSL in a C string's source, up to the end of its literals on this line. */
static int unquoted(text *out, const char *line, const char *end)
{
    const char *at = memchr(line, '"', (size_t)(end - line));
    if (!at) return 0;
    for (++at; at < end && *at != '"'; ++at) {
        if (*at != '\\') put(out, at, 1);
        else if (*++at == 'n') put(out, "\n", 1);
        else if (*at == '"' || *at == '\\') put(out, at, 1);
        else return 0;
    }
    return at < end && *at == '"';
}

/* ---- the head of a room, and its tail: functions of other rooms -------------------------------------------------- */

enum { CODES = SSGI_GL__CODES, ROWS = SSGI_GL__ROWS };

typedef struct head {
    char own[CODES]; /* 1: an entry of this room */
    char code[CODES], row[ROWS], field[SSGI_GL__FIELDS], fact[SSGI_GL__FACTS]; /* 1: is declared */
    int deep;          /* inside another room's function */
    ssgi_gl_desc base; /* its values are the macros' */
    text macros, declared, defined, reads, writes, needs;
} head;


static int is_named(const char *name, const char *word, size_t n)
{
    return strlen(name) == n && !memcmp(name, word, n);
}

static int code_of(const char *name)
{
    int i = CODES - 1;
    while (i >= 0 && strcmp(ssgi_gl__library[i].name, name)) --i;
    return i;
}

static void put_all(text *t, int count, const char *const *parts)
{
    for (int i = 0; i < count; ++i) puts_to(t, parts[i]);
}
#define PUT(t, ...) \
    put_all(t, (int)(sizeof(const char *[]){ __VA_ARGS__ } / sizeof(char *)), (const char *const[]){ __VA_ARGS__ })

static void put_macro(text *t, const char *name)
{
    puts_to(t, "SSGI_");
    for (; *name; ++name) put(t, (char[]){ (char)(*name >= 'a' && *name <= 'z' ? *name - 32 : *name) }, 1);
}

/* Defines a field's macros, once. */
static void need_macro(head *h, const char *word, size_t n)
{
    const ssgi_gl__field *const row = ssgi_gl__field_named(word, n);
    const ssgi_gl_choice *const field = row ? &row->choice : NULL;
    int fact = 0;
    while (!field && fact < SSGI_GL__FACTS && !ssgi_gl__is(ssgi_gl__facts[fact].name, word, n)) ++fact;
    char *const had = field ? &h->field[row - ssgi_gl__fields] : fact < SSGI_GL__FACTS ? &h->fact[fact] : NULL;
    const char *const name = field ? field->name : fact < SSGI_GL__FACTS ? ssgi_gl__facts[fact].name : "",
                      *s = field ? field->values : "";
    char number[24];
    if (!had || (*had)++) return;
    snprintf(number, sizeof number, " %d\n",
             field ? ssgi_gl__get(&h->base, field->offset) : ssgi_gl__fact(name, strlen(name), &h->base));
    puts_to(&h->macros, "#ifndef ");
    put_macro(&h->macros, name);
    puts_to(&h->macros, "\n#define ");
    put_macro(&h->macros, name);
    PUT(&h->macros, number, "#endif\n");
    for (int value = 0; (n = ssgi_gl__word(&s)) != 0; ++value, s += n) {
        snprintf(number, sizeof number, " %d\n", value);
        puts_to(&h->macros, "#define ");
        put_macro(&h->macros, name);
        puts_to(&h->macros, "_");
        put(&h->macros, s, n);
        puts_to(&h->macros, number);
    }
}

/* A condition of a table of C, by GLSL's macros. */
static void put_condition(head *h, text *t, const char *s)
{
    const ssgi_gl_choice *field = NULL;
    int compared = 0;
    for (size_t n; *s; s += n) {
        n = ssgi_gl__letter(*s) ? ssgi_gl__word(&s) : 0;
        if (n && compared && field) {
            put_macro(t, field->name);
            puts_to(t, "_");
            put(t, s, n);
        } else if (n) {
            const ssgi_gl__field *const row = ssgi_gl__field_named(s, n);
            field = row ? &row->choice : NULL;
            need_macro(h, s, n);
            put_macro(t, field ? field->name : "");
        }
        if (n) compared = 0;
        else compared |= *s == '=' || *s == '<' || *s == '>';
        if (!n) put(t, s, n = 1);
    }
}

/* Calls seen with each of our names in lines of GLSL; not those in comments. */
static void each_name(const char *s, const char *end, void (*seen)(void *to, const char *name, size_t n), void *to)
{
    while (s < end) {
        const char *const from = s;
        while (s < end && ssgi_gl__letter(*s)) ++s;
        if (s - from > 5) seen(to, from, (size_t)(s - from));
        if (s == from) ++s;
        if (s[-1] == '/' && s < end && *s == '/') s = memchr(s, '\n', (size_t)(end - s));
    }
}

/* Which entries a main function reaches. */
static void reach(void *to, const char *name, size_t n)
{
    char *const reached = to;
    for (int i = 0; i < CODES; ++i) {
        const ssgi_gl__code *const code = &ssgi_gl__library[i];
        if (reached[i] || !is_named(code->name, name, n)) continue;
        reached[i] = 1;
        each_name(code->text, code->text + strlen(code->text), reach, reached);
    }
}

/* A desc, of those that tests compile, that draws with a main function. Returns its stage, or -1. */
/* Gives fields that a pass does not look at, and whose 0 means something else wherever one does, their default: all of
   a file is compiled. */
static void fill_defaults(ssgi_gl_desc *desc)
{
    for (int k = 0; k < SSGI_GL__FIELDS; ++k) {
        const size_t at = ssgi_gl__fields[k].choice.offset;
        int value = 0, zeros = 0;
        for (int pass = 0; pass < SSGI_GL_PASSES; ++pass) {
            ssgi_gl_desc d;
            memset(&d, 0, sizeof d);
            d.pass = (ssgi_gl_pass)pass;
            if (!ssgi_gl__holds(ssgi_gl__fields[k].looks, &d)) continue;
            d = ssgi_gl_resolve(&d);
            zeros += !ssgi_gl__get(&d, at);
            if (!value) value = ssgi_gl__get(&d, at);
        }
        if (!zeros && !ssgi_gl__get(desc, at)) memcpy((char *)desc + at, &value, sizeof value);
    }
}

static int desc_of(ssgi_gl_desc *desc, const char *main_)
{
    static struct { ssgi_gl_desc desc; int stage; char known; } found[CODES];
    const int at = code_of(main_);
    variant v;
    for (int i = 0; at >= 0 && !found[at].known && variant_at(&v, i); ++i)
        for (int c = 0; c < choices_count && !found[at].known; ++c) {
            const ssgi_gl_desc own = with_choice(v.desc, c);
            ssgi_gl__program p;
            if (ssgi_gl_check(&own, NULL) != SSGI_OK) continue;
            const ssgi_gl_desc d = ssgi_gl_resolve(&own);
            ssgi_gl__link_all(&p, &d, SSGI_GL_STAGES);
            for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
                if (p.mains[stage] && !strcmp(p.mains[stage], main_)) {
                    found[at].desc = p.d;
                    found[at].stage = stage;
                    found[at].known = 1;
                }
        }
    if (at < 0 || !found[at].known) return -1;
    *desc = found[at].desc;
    return found[at].stage;
}

static const char *const stages[SSGI_GL_STAGES] = { "vert", "frag", "tesc", "tese", "geom" };

/* Of what main functions of the room is an entry that not every stage can compile, in the other stages or in fragments?
   Returns 0 for an entry that all can. */
static int put_stage(text *t, const head *h, const ssgi_gl__code *code)
{
    static const char *const words[] = { "gl_FragCoord", "dFd", "flat out ", "gl_Vert", "gl_Inst", "gl_Pos", "EmitV" };
    char reached[CODES] = { 0 };
    int fragments = 0, others = 0, mains = 0;
    if (!strncmp(code->name, "main_", 5)) return 0;
    reach(reached, code->name, strlen(code->name));
    for (int i = 0; i < CODES; ++i)
        for (int k = 0; k < 7 && reached[i]; ++k)
            if (strstr(ssgi_gl__library[i].text, words[k])) ++*(k < 2 ? &fragments : &others);
    for (int i = 0; i < CODES && fragments + others; ++i) {
        const char *const main_ = ssgi_gl__library[i].name;
        char reaches[CODES] = { 0 };
        ssgi_gl_desc d;
        if (!h->own[i] || strncmp(main_, "main_", 5) || desc_of(&d, main_) == SSGI_GL_STAGE_FRAGMENT) continue;
        reach(reaches, main_, strlen(main_));
        if (!fragments && !reaches[code - ssgi_gl__library]) continue;
        PUT(t, !mains++ ? "#if " : fragments ? " && " : " || ", fragments ? "!defined " : "defined ", main_);
    }
    if (mains) puts_to(t, "\n");
    return mains;
}

static void need(void *to, const char *name, size_t n);

/* An entry of another room: a function's first line goes into the head, all of it into the tail; anything else into
   the head. */
static void declare(head *h, const ssgi_gl__code *code)
{
    text opening = { 0 }, lines = { 0 };
    int inside = 0, functions = 0;
    if (put_stage(&opening, h, code)) puts_to(&lines, "#endif\n");
    if (code->when) PUT(&opening, "#if ", code->when, "\n");
    if (code->when) puts_to(&lines, "#endif\n");
    text signature = { 0 };
    for (const char *line = code->text, *end; *line; line = end) {
        end = strchr(line, '\n') + 1;
        const size_t n = (size_t)(end - line), brace = strcspn(line, "{");
        const int function = brace < n && ssgi_gl__letter(*line) && strcspn(line, "(") < brace
                          && strcspn(line, "=") > brace;
        if (!inside && function) {
            put(&signature, line, brace - 1);
            puts_to(&signature, ";\n");
            inside = ++functions && !memchr(line, '}', n);
        } else if (!inside && strncmp(line, "//", 2)) put(&signature, line, n);
        else if (*line == '}') inside = 0;
    }
    ++h->deep;
    each_name(code->text, code->text + strlen(code->text), need, h);
    if (code->when) each_name(code->when, code->when + strlen(code->when), need, h);
    --h->deep;
    const char *const open = opening.data ? opening.data : "", *const close = lines.data ? lines.data : "";
    PUT(&h->declared, open, signature.data ? signature.data : "", close);
    if (functions) PUT(&h->defined, "\n", open, code->text, close);
    h->declared.failed |= opening.failed | lines.failed | signature.failed;
    free(opening.data), free(lines.data), free(signature.data);
}

static void list(text *t, const char *name)
{
    for (const char *s = t->data; s && *s; s += *s == ' ') {
        const size_t n = strcspn(s, " ");
        if (is_named(name, s, n)) return;
        s += n;
    }
    PUT(t, t->size ? " " : "", name);
}

static void need_row(head *h, const ssgi_gl__row *row)
{
    static const char *const words[] = { "uniform ", "uniform ", "out ", "", "in ", "out " }; /* by ssgi_gl_io.kind */
    static const char *const of_stage[] = { NULL, NULL, "!defined main_levels && !defined main_points && "
                                                        "!defined main_strip", NULL,
                                            "!defined main_levels && !defined main_points && !defined main_strip",
                                            "defined main_buffer || defined main_points" };
    const int kind = row->io.kind;
    if (kind == SSGI_GL_IO_CONSTANT || h->row[row - ssgi_gl__rows]++) return;
    if (of_stage[kind]) PUT(&h->declared, "#if ", of_stage[kind], "\n");
    if (row->when) {
        text condition = { 0 };
        put_condition(h, &condition, row->when);
        PUT(&h->declared, "#if ", condition.data ? condition.data : "0", "\n");
        free(condition.data);
    }
    PUT(&h->declared, words[kind], row->io.type, " ", row->io.name, ";\n");
    for (int i = 0; i < (of_stage[kind] != NULL) + (row->when != NULL); ++i) puts_to(&h->declared, "#endif\n");
    if (!h->deep)
        list(kind == SSGI_GL_IO_OUTPUT || kind == SSGI_GL_IO_CAPTURE ? &h->writes : &h->reads, row->io.name);
}

/* Declares what a name stands for: a field of the desc, another room's entry, a function of yours, a row. */
/* Functions of yours, desc.text.fetch, return something here, so that a room links. */
static void need(void *to, const char *name, size_t n)
{
    static const char *const yours[][2] = {
        { "ssgi_custom_depth", "float ssgi_custom_depth(ivec2 texel, int layer) { return 1.0; }\n" },
        { "ssgi_custom_normal", "vec3 ssgi_custom_normal(ivec2 texel) { return vec3(0.0); }\n" },
        { "ssgi_custom_harmonic", "vec3 ssgi_custom_harmonic(int i, vec3 position) { return vec3(0.0); }\n" },
        { "ssgi_custom_object", "uint ssgi_custom_object(ivec2 texel) { return 0u; }\n" },
        { "ssgi_custom_surfel",
          "vec3 ssgi_custom_surfel(vec3 position, vec3 normal, vec3 colour) { return colour; }\n" },
        { "ssgi_custom_reach", "float ssgi_custom_reach(vec3 position, vec3 normal, float radius, vec3 colour, float "
                               "epsilon) { return 0.0; }\n" },
        { "ssgi_custom_effect", "vec4 ssgi_custom_effect(vec3 position, vec3 normal, float radius, vec3 colour, vec3 "
                                "P, vec3 n) { return vec4(0.0); }\n" },
        { "SSGI_KERNEL_TABLE", "uniform vec4 SSGI_KERNEL_TABLE[64]; // the emitter prints its numbers\n" }
    };
    head *const h = to;
    need_macro(h, name, n);
    for (int i = 0; i < CODES; ++i) {
        if (!is_named(ssgi_gl__library[i].name, name, n) || h->own[i] || h->code[i]++) continue;
        if (!h->deep) list(&h->needs, ssgi_gl__library[i].name);
        declare(h, &ssgi_gl__library[i]);
    }
    for (size_t i = 0; i < sizeof yours / sizeof *yours; ++i)
        if (is_named(yours[i][0], name, n) && (!h->declared.data || !strstr(h->declared.data, yours[i][1])))
            puts_to(&h->declared, yours[i][1]);
    for (int i = 0; i < ROWS; ++i)
        if (is_named(ssgi_gl__rows[i].io.name, name, n)) need_row(h, &ssgi_gl__rows[i]);
}

static void put_wrapped(text *out, const char *title, const text *words)
{
    size_t width = strlen(title);
    puts_to(out, title);
    for (const char *s = words->data ? words->data : "nothing"; *s; s += *s == ' ') {
        const size_t n = strcspn(s, " ");
        if (width + 1 + n > 118) puts_to(out, "\n//        ");
        width = width + 1 + n > 118 ? 10 + 1 + n : width + 1 + n;
        puts_to(out, " ");
        put(out, s, n);
        s += n;
    }
    puts_to(out, "\n");
}

/* A room's file around its body; from .. to: its lines in the header. */
static void put_file(text *out, const char *file, head *h, const text *body)
{
    text commands = { 0 };
    for (int i = CODES - 1; i >= 0; --i)
        if (h->own[i] && !strncmp(ssgi_gl__library[i].name, "main_", 5)) desc_of(&h->base, ssgi_gl__library[i].name);
    fill_defaults(&h->base);
    each_name(body->data, body->data + body->size, need, h);
    for (int i = 0; i < CODES; ++i) {
        const char *const name = ssgi_gl__library[i].name;
        ssgi_gl_desc d;
        const int stage = !h->own[i] || strncmp(name, "main_", 5) ? -1 : desc_of(&d, name);
        if (stage < 0) continue;
        PUT(&commands, "//     glslangValidator -l -S ", stages[stage], " -D", name);
        for (int k = 0; k < SSGI_GL__FIELDS; ++k) {
            const int value = ssgi_gl__get(&d, ssgi_gl__fields[k].choice.offset);
            char number[24];
            /* What the pass does not look at stays as the base has it, since the whole file is compiled. */
            if (!h->field[k] || (!value && !ssgi_gl__holds(ssgi_gl__fields[k].looks, &d))
                || value == ssgi_gl__get(&h->base, ssgi_gl__fields[k].choice.offset)) continue;
            snprintf(number, sizeof number, "=%d", value);
            puts_to(&commands, " -D");
            put_macro(&commands, ssgi_gl__fields[k].choice.name);
            puts_to(&commands, number);
        }
        for (int k = 0; k < SSGI_GL__FACTS; ++k) {
            const char *const fact = ssgi_gl__facts[k].name;
            const int value = ssgi_gl__fact(fact, strlen(fact), &d);
            if (!h->fact[k] || value == ssgi_gl__fact(fact, strlen(fact), &h->base)) continue;
            puts_to(&commands, " -D");
            put_macro(&commands, fact);
            puts_to(&commands, value ? "=1" : "=0");
        }
        PUT(&commands, " ", file, "\n");
    }
    PUT(out, "#version 450\n// ", file, ", of ssgi_gl.h. make glsl-in reads what stands between the lines of //@@.\n");
    PUT(out, "//     glslangValidator -S frag ", file, "\n", commands.data ? commands.data : "");
    put_wrapped(out, "// reads:", &h->reads);
    put_wrapped(out, "// writes:", &h->writes);
    put_wrapped(out, "// needs:", &h->needs);
    PUT(out, h->macros.data ? h->macros.data : "", h->declared.data ? h->declared.data : "", body_mark, "\n");
    put(out, body->data, body->size);
    PUT(out, tail_mark, h->defined.data ? h->defined.data : "");
    out->failed |= h->macros.failed | h->declared.failed | h->defined.failed | h->reads.failed | h->writes.failed
                 | h->needs.failed | commands.failed | body->failed;
    free(h->macros.data), free(h->declared.data), free(h->defined.data), free(h->reads.data), free(h->writes.data);
    free(h->needs.data), free(commands.data);
}

static int write_room(const char *path, const char *from, const char *to, kit_error *err)
{
    text body = { 0 }, out = { 0 };
    head h;
    int failed = 0, open = 0;
    char name[LINE], when[LINE];
    memset(&h, 0, sizeof h);
    desc_of(&h.base, "main_occlusion"); /* for rooms that draw nothing */
    for (const char *line = from; line < to; line = strchr(line, '\n') + 1)
        for (int i = 0; i < CODES && sscanf(line, "{ \"%255[^\"]\",", name) == 1; ++i)
            h.own[i] |= !strcmp(ssgi_gl__library[i].name, name);
    for (const char *line = from, *end; line < to && !failed; line = end) {
        end = strchr(line, '\n') + 1;
        if (sscanf(line, "{ \"%255[^\"]\", %255[^,], __LINE__ + 1,", name, when) == 2) {
            const int i = code_of(name), main_ = !strncmp(name, "main_", 5);
            PUT(&body, entry_mark, name, "\n");
            if (main_) PUT(&body, "#ifdef ", name, "\n");
            open = main_ || (i >= 0 && put_stage(&body, &h, &ssgi_gl__library[i]));
            if (strcmp(when, "NULL")) {
                when[strlen(when) - 1] = 0;
                PUT(&body, "#if ", when + 1, "\n");
                ++open;
            }
        } else if (!strncmp(line, "    \"", 5)) {
            if (!unquoted(&body, line, end)) failed = kit_fail(err, "%s: entry %s: is no string", path, name);
            for (int i = 0; i < open && !strncmp(end - 4, " },\n", 4); ++i) puts_to(&body, "#endif\n");
        } else put(&body, line, (size_t)(end - line));
    }
    const char *const slash = strrchr(path, '/');
    put_file(&out, slash ? slash + 1 : path, &h, &body);
    if (!failed && out.failed) failed = kit_fail(err, "out of memory");
    if (!failed) failed = kit_file_write(path, out.data, out.size, err);
    free(body.data);
    free(out.data);
    return failed;
}

static int write_rooms(const char *from, const char *to, const char *folder, kit_error *err)
{
    char path[4096];
    if (strncmp(from, room_mark, strlen(room_mark)))
        return kit_fail(err, "line 1 of the library: stands before the first room");
    for (const char *line = from, *next; line < to; line = next) {
        next = strstr(line + 1, room_mark);
        if (!next || next > to) next = to;
        if (!room_path(path, folder, line)) return kit_fail(err, "%s: is no room's name", path);
        if (write_room(path, line, next, err)) return -1;
    }
    return 0;
}

/* ---- in ---------------------------------------------------------------------------------------------------------- */

static void quoted(text *out, const char *line, size_t length)
{
    puts_to(out, "    \"");
    for (size_t i = 0; i < length; ++i) {
        if (line[i] == '"' || line[i] == '\\') puts_to(out, "\\");
        put(out, line + i, 1);
    }
    puts_to(out, "\\n\"");
}

/* Is every #if of an entry closed? Returns the line that is wrong, counted from 0, or -1. */
static int unclosed(const char *lines, const char *end)
{
    int depth = 0, number = 0, opened = 0;
    for (const char *line = lines; line < end; line = strchr(line, '\n') + 1, ++number) {
        if (!strncmp(line, "#if", 3) && !depth++) opened = number;
        else if (!strncmp(line, "#endif\n", 7) && --depth < 0) return number;
        else if ((!strncmp(line, "#el", 3)) && !depth) return number;
    }
    return depth ? opened : -1;
}

/* Is all of an entry between one #if and its #endif, without #else? */
static int encloses(const char *lines, const char *end)
{
    int depth = 0;
    if (strncmp(lines, "#if", 3)) return 0;
    for (const char *line = lines; line < end; line = strchr(line, '\n') + 1) {
        if (!strncmp(line, "#if", 3)) ++depth;
        else if (!strncmp(line, "#el", 3) && depth == 1) return 0;
        else if (!strncmp(line, "#endif\n", 7) && !--depth) return line + 7 == end;
    }
    return 0;
}

static void put_entry(text *out, const char *lines, const char *end)
{
    for (const char *line = lines, *stop; line < end; line = stop + 1) {
        stop = strchr(line, '\n');
        quoted(out, line, (size_t)(stop - line));
        puts_to(out, stop + 1 < end ? "\n" : " },\n");
    }
}

static size_t lines_between(const char *from, const char *to)
{
    size_t count = 0;
    for (; from < to; ++from) count += *from == '\n';
    return count;
}

static int read_room(text *out, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, err)) return -1;
    const int text_ends = size && data[size - 1] == '\n' && !memchr(data, 0, size);
    int failed = text_ends ? 0 : kit_fail(err, "%s: is no text that ends its last line", path);
    char *body = text_ends ? strstr(data, body_mark) : NULL, *const tail = body ? strstr(body, tail_mark) : NULL;
    if (!failed && !tail) failed = kit_fail(err, "%s: has no lines \"//@@ ..\" around the room", path);
    if (!failed) {
        body += strlen(body_mark) + (body[strlen(body_mark)] == '\n');
        tail[0] = 0;
    }
    int number = failed ? 0 : (int)lines_between(data, body);
    for (char *line = body, *end; !failed && *line; line = end) {
        end = strchr(line, '\n') + 1;
        ++number;
        if (strncmp(line, entry_mark, strlen(entry_mark))) {
            put(out, line, (size_t)(end - line));
            continue;
        }
        const size_t name = strlen(entry_mark);
        char *stop = end;                      /* the entry ends before a blank line that an entry or comment follows */
        while (*stop && !(stop[0] == '\n' && (!stop[1] || !strncmp(stop + 1, entry_mark, name) || stop[1] == '/'))) {
            char *next = strchr(stop, '\n') + 1;
            ++number;
            stop = next;
        }
        const int first = number - (int)lines_between(end, stop), wrong = unclosed(end, stop);
        if (stop == end) failed = kit_fail(err, "%s: line %d: an entry without text", path, number);
        else if (wrong >= 0)
            failed = kit_fail(err, "%s: line %d: #if and #endif are not in pairs", path, first + 1 + wrong);
        else {
            const char *from = end, *to = stop, *when = NULL;
            if (encloses(from, to) && (!strncmp(from, "#ifdef main_", 12) || !strncmp(from, "#if defined main_", 17)
                                      || !strncmp(from, "#if !defined main_", 18)))
                from = strchr(from, '\n') + 1, to -= strlen("#endif\n");
            if (encloses(from, to)) {
                when = from + strlen("#if ");
                from = strchr(from, '\n') + 1, to -= strlen("#endif\n");
            }
            puts_to(out, "{ \"");
            put(out, line + name, (size_t)(end - line) - name - 1);
            puts_to(out, when ? "\", \"" : "\", NULL");
            if (when) put(out, when, (size_t)(from - when) - 1);
            puts_to(out, when ? "\", __LINE__ + 1,\n" : ", __LINE__ + 1,\n");
            put_entry(out, from, to);
        }
        end = stop;
    }
    free(data);
    return failed;
}

/* A .glsl in the folder that is no room's would be lost without a word. */
static int no_strangers(const char *from, const char *to, const char *folder, kit_error *err)
{
    DIR *files = opendir(folder);
    int failed = files ? 0 : kit_fail(err, "%s: cannot be read: %s", folder, strerror(errno));
    for (struct dirent *file; !failed && (file = readdir(files)) != NULL;) {
        const size_t length = strlen(file->d_name);
        char path[4096];
        int known = length < 5 || strcmp(file->d_name + length - 5, ".glsl");
        for (const char *line = from; line < to && !known; line = strchr(line, '\n') + 1)
            known = !strncmp(line, room_mark, strlen(room_mark)) && room_path(path, folder, line)
                 && !strcmp(strrchr(path, '/') + 1, file->d_name);
        if (!known)
            failed = kit_fail(err, "%s/%s: is no room of the header: a new room begins with its \"%s..\" line there",
                              folder, file->d_name, room_mark);
    }
    if (files) closedir(files);
    return failed;
}

/* Rooms come in the header's order. */
static int read_rooms(text *out, const char *from, const char *to, const char *folder, kit_error *err)
{
    if (no_strangers(from, to, folder, err)) return -1;
    for (const char *line = from; line < to; line = strchr(line, '\n') + 1) {
        char path[4096];
        if (strncmp(line, room_mark, strlen(room_mark))) continue;
        if (!room_path(path, folder, line) || read_room(out, path, err)) return -1;
    }
    return out->failed ? kit_fail(err, "out of memory") : 0;
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    char *header = NULL;
    const char *from, *to;
    size_t size;
    text out = { 0 };
    const int in = argc == 4 && !strcmp(argv[1], "in");
    if (argc != 4 || (!in && strcmp(argv[1], "out"))) {
        fputs("usage: library out|in ssgi_gl.h DIR: writes the header's GLSL as files, or reads them back\n", stderr);
        return 2;
    }
    int failed = kit_file_read(&header, &size, argv[2], &err) || library_of(&from, &to, header, argv[2], &err);
    if (!failed && !in && mkdir(argv[3], 0777) && errno != EEXIST)
        failed = kit_fail(&err, "%s: cannot be made: %s", argv[3], strerror(errno));
    if (!failed && !in) failed = write_rooms(from, to, argv[3], &err);
    if (!failed && in) {
        put(&out, header, (size_t)(from - header));
        failed = read_rooms(&out, from, to, argv[3], &err);
        puts_to(&out, to);
        failed = failed || kit_file_write(argv[2], out.data, out.size, &err);
    }
    if (failed) fprintf(stderr, "library: %s\n", err.text);
    free(header);
    free(out.data);
    return failed ? 2 : 0;
}
