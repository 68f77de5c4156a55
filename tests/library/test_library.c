/* test_library.c - the library of GLSL as source: every condition names a field, and every loop ends; and the tables by
   which descs are resolved. */
#include "own.h"

enum { CODES = SSGI_GL__CODES, ROWS = SSGI_GL__ROWS };

/* Returns 1 if a condition consists of fields, facts of the pass, signs, and behind a comparison a value of its field.
   In GLSL these are macros, SSGI_FIELD and SSGI_FIELD_VALUE. Passes have no order: they are only equal or not. */
static int condition(const char *s, const char *end, int glsl)
{
    static const ssgi_gl_desc none;
    static const char *const signs[] = { "&&", "||", "==", "!=", "<", ">", "!", "(", ")" };
    const ssgi_gl_choice *field = NULL;
    int compared = 0, terms = 0;
    while (s < end) {
        size_t n = 0, k = 0;
        if (*s == ' ') { ++s; continue; }
        while (s + n < end && ssgi_gl__letter(s[n])) ++n;
        const int macro = n > 5 && !strncmp(s, "SSGI_", 5);
        if (n && compared) {
            const size_t group = field && macro ? strlen(field->name) : 0;
            if (!field || ssgi_gl__value(field, s, n) < 0 || ssgi_gl__value(field, s, n) > field->most) return 0;
            if (*field->values ? macro != glsl : macro) return 0;
            if (macro && (n < group + 7 || s[5 + group] != '_' || !ssgi_gl__is(field->name, s, 5 + group))) return 0;
            compared = 0;
        } else if (n) {
            const ssgi_gl__field *const row = ssgi_gl__field_named(s, n);
            field = row ? &row->choice : NULL;
            if (macro != glsl || (!field && ssgi_gl__fact(s, n, &none) < 0)) return 0;
            ++terms;
        } else {
            while (k < 9 && strncmp(s, signs[k], strlen(signs[k]))) ++k;
            if (k == 9 || compared) return 0;
            compared = k >= 2 && k <= 5;
            if (k >= 4 && k <= 5 && field && !strcmp(field->name, "pass")) return 0;
            n = strlen(signs[k]);
        }
        s += n;
    }
    return terms > 0 && !compared;
}

static void conditions(void)
{
    int count = 0;
    for (int i = 0; i < CODES; ++i) {
        const ssgi_gl__code *c = &ssgi_gl__library[i];
        int depth = 0;
        CHECK(strlen(c->text) <= 4095, "%s: %zu characters are more than a C99 string may have", c->name,
              strlen(c->text));
        for (const char *line = c->text, *end; *line; line = end + 1) {
            end = strchr(line, '\n');
            if (!CHECK(end, "%s does not end its last line", c->name)) break;
            const char *mark = memchr(line, '#', (size_t)(end - line)), *from = NULL;
            const int length = (int)(end - line);
            if (!mark) continue;
            if (!strncmp(line, "#if ", 4)) { from = line + 4; ++depth; }
            else if (!strncmp(line, "#elif ", 6)) from = line + 6;
            else if (!strncmp(line, "#endif\n", 7)) --depth;
            else CHECK(!strncmp(line, "#else\n", 6), "%s: no directive: %.*s", c->name, length, line);
            CHECK(depth >= 0 && depth <= (int)sizeof((ssgi_gl__reader *)0)->state
                      && (depth || line[1] == 'e'),
                  "%s: depth %d: %.*s", c->name, depth, length, line);
            if (from)
                CHECK(condition(from, end, 1), "%s: names no field, or no value of it: %.*s", c->name, length, line);
            count += from != NULL;
        }
        CHECK(!depth, "%s: %d #endif are missing", c->name, depth);
        CHECK(!c->when || condition(c->when, c->when + strlen(c->when), 1), "%s: when %s", c->name, c->when);
    }
    for (int i = 0; i < ROWS; ++i) {
        const char *when = ssgi_gl__rows[i].when;
        CHECK(!when || condition(when, when + strlen(when), 0), "row %s: %s", ssgi_gl__rows[i].io.name, when);
    }
    for (int i = 0; i < SSGI_GL_PASSES * SSGI_GL__VARIANTS; ++i) {
        const ssgi_gl__pass *row = &ssgi_gl__passes[i / SSGI_GL__VARIANTS];
        const char *when = row->variant[i % SSGI_GL__VARIANTS].when;
        CHECK(!when || condition(when, when + strlen(when), 0), "pass %s: %s", row->name, when);
    }
    for (int i = 0; i < SSGI_GL__FIELDS; ++i) {
        const ssgi_gl_choice *f = &ssgi_gl__fields[i].choice;
        int words = *f->values != 0;
        for (const char *s = f->values; *s; ++s) words += *s == ' ';
        CHECK(!words || words == f->most + 1,
              "desc.%s has %d values with names and a limit of %d (ssgi_gl.h, >>desc, ssgi_gl__fields)", f->name, words,
              f->most);
    }
    static const struct { const char *text; int glsl;
    } none[] = { { "thn", 0 },
                 { "search == SLICE", 0 },
                 { "resolution ==", 0 },
                 { "pass < SSDO", 0 },
                 { "resolution", 1 },
                 { "SSGI_RESOLUTION", 0 },
                 { "SSGI_FADE == SSGI_FALLOFF_NONE", 1 },
                 { "SSGI_FADE == NONE", 1 },
                 { "SSGI_THN", 1 },
                 { "SSGI_FADE ==", 1 } };
    for (int i = 0; ssgi_gl__limits[i].when; ++i)
        CHECK(condition(ssgi_gl__limits[i].when, strchr(ssgi_gl__limits[i].when, 0), 0), "when %s",
              ssgi_gl__limits[i].when);
    for (size_t i = 0; i < sizeof none / sizeof *none; ++i)
        CHECK(!condition(none[i].text, none[i].text + strlen(none[i].text), none[i].glsl), "%s is taken", none[i].text);
    t_note("%d conditions in %d entries", count, CODES);
}

/* Checks that a texture has one unit, and that fetches at u_ssgi_origin, which have a layer, are of textures of yours.
   Names that do not exist, and what nothing names, are found by group text. */
static void textures(void)
{
    for (int r = 0; r < ROWS; ++r) {
        const ssgi_gl_io *const io = &ssgi_gl__rows[r].io;
        char at[80];
        int fetched = 0;
        for (int k = 0; k < r; ++k)
            CHECK(io->kind != SSGI_GL_IO_TEXTURE || io->slot == ssgi_gl__rows[k].io.slot
                      || strcmp(io->name, ssgi_gl__rows[k].io.name), "texture %s has two units", io->name);
        snprintf(at, sizeof at, "%s, p + u_ssgi_origin, 0", io->name);
        for (int i = 0; i < CODES; ++i) fetched |= strstr(ssgi_gl__library[i].text, at) != NULL;
        CHECK(!fetched || ssgi_gl__rows[r].bytes == 1 || strstr(io->type, "DMS") || strstr(io->type, "Array"),
              "%s is fetched at u_ssgi_origin and no texture of yours", io->name);
    }
}

/* Returns whether every line that sets a name contains one of two words, and there is such a line. */
static int set_by(const char *text, const char *name, const char *word, const char *other)
{
    char is[40], line[160];
    int lines = 0;
    snprintf(is, sizeof is, " %s = ", name);
    for (const char *s = text; (s = strstr(s, is)) != NULL; ++s, ++lines) {
        const char *from = s;
        while (from > text && from[-1] != '\n') --from;
        snprintf(line, sizeof line, "%.*s", (int)strcspn(from, "\n"), from);
        if (!strstr(line, word) && !strstr(line, other)) return 0;
    }
    return lines > 0;
}

/* Returns whether a loop's bound is limited whatever textures and the frame hold: a literal, a constant or an array's
   length; a name that is clamped by a constant or by the rows of a texture; a count that is one of two constants or a
   call's result; the reach of a clamped level. */
static int bounded(const char *text, const char *bound)
{
    static const char *const constants[] = { "more", "layers", "count" };
    bound += *bound == '-';
    for (size_t k = 0; k < sizeof constants / sizeof *constants; ++k) if (!strcmp(bound, constants[k])) return 1;
    return strcspn(bound, "abcdefghijklmnopqrstuvwxyz") == strlen(bound) || strstr(bound, ".channel.length()")
           || set_by(text, bound, ", SSGI_", ", textureSize(")
           || (set_by(text, bound, " = (1 << level) >> 1;", " = (1 << level) >> 1;")
               && set_by(text, "level", ", SSGI_", ", textureSize("));
}

/* Returns a loop that might not end with some textures or frame; NULL: all loops end. A loop counts up by a literal, or
   over the bits of an integer; anything else that moves its counter is clamped to 0 or more. */
static const char *endless(const char *text)
{
    char i[16], from[24], test[80], step[16], of[16], less[3], bound[64], counted[2][40], by[16];
    if (strstr(text, "while (") || strstr(text, "do {")) return text;
    for (const char *s = text, *move; (s = strstr(s, "for (")) != NULL; ++s) {
        if (sscanf(s, "for (int %15[a-z] = %23[^;]; %79[^;]; %15[^)]", i, from, test, step) != 4) return s;
        snprintf(counted[0], sizeof counted[0], "++%s", i);
        snprintf(counted[1], sizeof counted[1], "%s += 2", i);
        if ((strcmp(step, counted[0]) && strcmp(step, counted[1])) || !bounded(text, from)) return s;
        const int bits = sscanf(test, "%*[a-z] >> uint(%15[a-z]) %2[!=] 0u", of, less) == 2;
        if (!bits && sscanf(test, "%15[a-z] %2[<=] %63[^& ]", of, less, bound) != 3) return s;
        if (strcmp(of, i) || (!bits && (*less != '<' || !bounded(text, bound)))) return s;
        snprintf(counted[0], sizeof counted[0], " %s ", i);
        for (move = s + strlen("for (int i"); (move = strstr(move, counted[0])) != NULL; ++move) {
            const char *const sign = move + strlen(counted[0]);
            if (!strchr("+-*/", *sign) || sign[1] != '=' || move[-1] == ';') continue;
            if (sscanf(sign, "+= %15[a-z];", by) != 1 || !set_by(text, by, "clamp(", "clamp(")) return move;
        }
    }
    return NULL;
}

static void loops(void)
{
    int count = 0;
    for (int i = 0; i < CODES; ++i) {
        const char *const text = ssgi_gl__library[i].text, *const loop = endless(text);
        CHECK(!loop,
              "%s: a loop might not end: clamp its limit by a constant or the rows of its texture: %.*s",
              ssgi_gl__library[i].name, loop ? (int)strcspn(loop, "\n") : 0, loop);
        for (const char *s = text; (s = strstr(s, "for (")) != NULL; ++s) ++count;
    }
    static const char *const none[] = { "for (int i = 0; i < u_ssgi_lights; ++i) {\n",
                                        "for (int i = 0; i < n; ++i) {\n",
                                        "while (x > 0) {\n",
                                        "int n = u_ssgi_lights;\nfor (int i = 0; i < n; ++i) {\n",
                                        "for (int i = 3; i > 0; --i) {\n",
                                        "for (int i = 0; i < 3; i += u_ssgi_lights) {\n",
                                        "for (int i = -u_ssgi_lights; i < 3; ++i) {\n",
                                        "for (int i = 0; i < 3; ++i) {\n    i += int(x.w);\n",
                                        "int n = int(x.w);\nfor (int i = 0; i < 3; ++i) i += n;\n",
                                        "int n = clamp(x, 0, 3);\nfor (int i = 0; i < 3; ++i) i -= n;\n" };
    for (size_t i = 0; i < sizeof none / sizeof *none; ++i) CHECK(endless(none[i]), "%s is taken", none[i]);
    t_note("%d loops", count);
}

static void set(ssgi_gl_desc *d, const ssgi_gl_choice *c, int value)
{
    memcpy((char *)d + c->offset, &value, sizeof value);
}

/* Checks the tables for other languages: they have all members, and a 0 gives the shader of the default. */
static void reflection(void)
{
    const size_t ints = offsetof(ssgi_gl_desc, shader.version) / sizeof(int),
                 gap = (offsetof(ssgi_gl_desc, shader) - offsetof(ssgi_gl_desc, filter)
                        - sizeof(ssgi_gl_filter_desc)) / sizeof(int);       /* before desc.shader, for its pointers */
    const ssgi_gl_choice *c, *k;
    char seen[sizeof(ssgi_gl_desc) / sizeof(int)] = { 0 };
    size_t count = 0, end[2] = { 0, 0 };
    int resolved = 0;
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i, ++count)
        CHECK(c->offset % sizeof(int) == 0 && c->offset / sizeof(int) < ints && !seen[c->offset / sizeof(int)]++,
              "desc.%s is there twice, or out of place", c->field);
    CHECK((count == ints - gap || count == ints - gap - 1)                 /* and a gap before the pointers */
              && !ssgi_gl_choice_at(-1) && !ssgi_gl_choice_at(1 << 30),
          "%zu fields of %zu ints", count, ints);
    for (int i = 0; i < ROWS; ++i) {
        const ssgi_gl_io *io = &ssgi_gl__rows[i].io;
        if (io->kind != SSGI_GL_IO_PARAM) continue;
        CHECK(io->offset == end[io->slot], "%s is at %zu, the one before ends at %zu", io->name, io->offset,
              end[io->slot]);
        end[io->slot] = io->offset + ssgi_gl__rows[i].bytes;
    }
    CHECK((end[0] + 15) / 16 * 16 == sizeof(ssgi_gl_frame) && end[1] == sizeof(ssgi_gl_views),
          "members end at %zu and %zu", end[0], end[1]);
    CHECK(!strcmp(ssgi_gl_member_at(0)->name, "u_ssgi_project") && !ssgi_gl_member_at(-1) && !ssgi_gl_member_at(99),
          "members");
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int i = 1; (c = ssgi_gl_choice_at(i)) != NULL; ++i)
            for (int j = i; j > 0 && (k = ssgi_gl_choice_at(j)) != NULL; j = j == i ? (i * 7 + pass) % i : 0) {
                ssgi_gl_desc d, r, again;
                memset(&d, 0, sizeof d);
                d.pass = pass;
                d.light.environment = pass == SSGI_GL_PASS_SSDO ? SSGI_GL_ENVIRONMENT_SH : 0;
                d.shader.fetch = "float ssgi_custom_depth(ivec2 texel, int layer) { return 1.0; }";
                set(&d, k, k->most);
                set(&d, c, c->most);
                if (ssgi_gl_check(&d, NULL) != SSGI_OK) continue;
                r = ssgi_gl_resolve(&d);
                again = ssgi_gl_resolve(&r);
                CHECK(ssgi_gl_check(&r, NULL) == SSGI_OK && ssgi_gl_key(&r) == ssgi_gl_key(&d)
                          && !memcmp(&again, &r, sizeof r),
                      "%s, %s, %s: what zeros mean gives another shader", ssgi_gl_pass_name(pass), c->name, k->name);
                ++resolved;
            }
    CHECK(resolved > 500, "%d descs", resolved);
}

/* ---- how fields are resolved ------------------------------------------------------------------------------------- */

/* Returns a random desc that is accepted; one field in three is set. */
static ssgi_gl_desc any_desc(int pass)
{
    for (;;) {
        ssgi_gl_desc d;
        memset(&d, 0, sizeof d);
        for (int i = 1; i < SSGI_GL__FIELDS; ++i) {
            const ssgi_gl_choice *const c = &ssgi_gl__fields[i].choice;
            if (!t_below(3)) set(&d, c, (int)t_below((uint32_t)(c->most < 8 ? c->most : 8) + 1));
        }
        d.pass = (ssgi_gl_pass)pass;
        d.shader.fetch = "float ssgi_custom_depth(ivec2 texel, int layer) { return 1.0; }";
        if (ssgi_gl_check(&d, NULL) == SSGI_OK) return d;
    }
}

/* Checks that rules read the desc as given, and other rules' results only where they say so. So their order does not
   matter: at most one rule of a field holds, and none depends on itself. */
static void rules_have_no_order(void)
{
    enum { ORDERS = 10, DESCS = 400 };
    static ssgi_gl__rule drawn[ORDERS][SSGI_GL__RULES];
    t_seed(74);
    for (int k = 0; k < ORDERS; ++k)
        for (int i = 0; i < SSGI_GL__RULES; ++i) {         /* Each rule is put before a random earlier one. */
            const int at = (int)t_below((uint32_t)i + 1);
            drawn[k][i] = drawn[k][at];
            drawn[k][at] = ssgi_gl__rules[i];
        }
    for (int n = 0; n < DESCS; ++n) {
        const ssgi_gl_desc d = any_desc(n % SSGI_GL_PASSES), want = ssgi_gl_resolve(&d);
        for (int k = 0; k < ORDERS; ++k) {
            const ssgi_gl_desc got = ssgi_gl__resolve(&d, drawn[k], SSGI_GL__RULES);
            CHECK(!memcmp(&got, &want, sizeof got), "%s: rules in another order give another desc",
                  ssgi_gl_pass_name(d.pass));
        }
        for (int i = 0; i < SSGI_GL__RULES; ++i)
            for (int k = 0; k < i; ++k) {
                const ssgi_gl__rule *const a = &ssgi_gl__rules[i], *const b = &ssgi_gl__rules[k];
                const ssgi_gl__asked first = { &d, a->after, ssgi_gl__rules, SSGI_GL__RULES },
                                     second = { &d, b->after, ssgi_gl__rules, SSGI_GL__RULES };
                CHECK(a->field != b->field || !ssgi_gl__asks(a->when, &first) || !ssgi_gl__asks(b->when, &second),
                      "two rules of a field hold: %s; %s", a->when, b->when);
            }
    }
}

/* Checks that fields of the camera, of your textures and of the language belong to all passes. For other fields their
   row, or a rule, says which passes look at them. For other passes they are 0, so #if lines need not ask for the
   pass. */
static void fields_have_their_passes(void)
{
    for (int i = 1; i < SSGI_GL__FIELDS; ++i) {
        const ssgi_gl__field *const f = &ssgi_gl__fields[i];
        int told = f->looks || !strncmp(f->choice.field, "input.", 6) || !strncmp(f->choice.field, "shader.", 7);
        int seen = 0;
        for (int k = 0; k < SSGI_GL__RULES; ++k) told |= ssgi_gl__rules[k].field == f->choice.offset;
        CHECK(told, "desc.%s: its row in ssgi_gl__fields (ssgi_gl.h, >>desc) does not say which passes look at it",
              f->choice.field);
        for (int n = 0; n < 64 * SSGI_GL_PASSES && !seen; ++n) {
            const ssgi_gl_desc d = any_desc(n % SSGI_GL_PASSES);
            seen = !f->looks || ssgi_gl__holds(f->looks, &d);
        }
        CHECK(seen, "desc.%s: no pass looks at it by its row: %s", f->choice.field, f->looks);
    }
}

void test_library(void)
{
    if (!every_pass_has_a_row()) return;
    RUN("tables name every field of a desc and every member of the blocks; what zeros mean gives the same text",
        reflection);
    RUN("the rules by which fields are resolved may stand in any order", rules_have_no_order);
    RUN("every field says which passes look at it", fields_have_their_passes);
    RUN("every #if names fields of the desc and their values", conditions);
    RUN("every loop ends, whatever textures and the frame hold", loops);
    RUN("a texture has one unit, and only your textures have an origin", textures);
}
