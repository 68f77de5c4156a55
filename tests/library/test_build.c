/* test_build.c - the headers as a compiler and a newcomer meet them: warnings, linking, the documentation's code, NaN
   and hostile inputs under sanitizers. */
#include <math.h>
#include "kit/kit_gl.h"
#include "shell.h"

#define MSVC "--target=x86_64-pc-windows-msvc -ffreestanding -isystem \"$root/examples/tools/wasm/libc\""
#define WARNINGS "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror"

static double implementation_seconds;          /* gcc's seconds of processor for both implementations at -O2 */

/* Checks that every compiler compiles the headers both ways by each standard, and links the address of every declared
   function. gcc with T_ALL also optimises, as some warnings need that (variables that may be unset, overflow). The
   other compilers make programs with T_ALL and otherwise only check syntax. The implementation follows a plain include,
   as in a host whose headers include ssgi_gl.h. */
static void compilers(void)
{
    static const struct {
        const char *whole, *one;
    } modes[] = { { "gcc -std=c11 -xc", "gcc -std=c99 -ffast-math -xc" },
                  { "clang -Wcomma -std=c99 -xc", "clang -std=c11 -xc" },
                  { "g++ -std=c++11 -xc++", "g++ -std=c++20 -xc++" },
                  { "clang++ -std=c++20 -xc++", "clang++ -std=c++11 -xc++" } };
    char text[4000], compiler[40], compile[200];
    int ran = 0;
    write_text("implementation.c",
               "#include \"ssgi_gl.h\"\n#define SSGI_IMPLEMENTATION\n#define SSGI_GL_IMPLEMENTATION\n"
               "#include \"ssgi_gl.h\"\n");
    write_text("head.c", "#include \"ssgi_gl.h\"\ntypedef void (*any)(void);\n#define AT(name) (any)name,\n"
                         "static any const all[] = {\n");
    write_text("main.c", "};\nint main(void) { return !all[sizeof all / sizeof *all - 1]; }\n");
    CHECK(!shell(text, sizeof text,
                 "cat ssgi.h ssgi_gl.h | sed -n 's/^SSGI_DEF [^(]*[ *]\\(ssgi_[a-z0-9_]*\\)(.*/    AT(\\1)/p' | "
                 "sort -u >names && test $(wc -l <names) -gt 100 && cat head.c names main.c >all.c && "
                 "{ echo '#define SSGI_STATIC'; cat implementation.c; sed 1d all.c; } >static.c%s%s", "", ""),
          "no list of functions: %s", text);
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; ++i) {
        snprintf(compiler, sizeof compiler, "%.*s", (int)strcspn(modes[i].whole, " "), modes[i].whole);
        if (!has(compiler)) continue;
        const char *const optimised = i ? "" : t_all() ? "-O2" : "-O0";
        snprintf(compile, sizeof compile, "%s %s " WARNINGS " -I.", modes[i].whole, optimised);
        ++ran;
        if (i && !t_all()) {
            CHECK(!shell(text, sizeof text, "%s -fsyntax-only static.c%s", compile, "") && !text[0], "%s: %s",
                  modes[i].whole, text);
            continue;
        }
        const char *const object = i ? "other.o" : "implementation.o";         /* the object to be linked from here
                                                                                  on */
        const double before = t_spent(1);
        const int failed = shell(text, sizeof text, "%s -c implementation.c -o %s", compile, object)
                        || text[0];
        if (!i) implementation_seconds = t_spent(1) - before;
        /* Tables of constants are in .rodata, or in .data.rel.ro if they have addresses. */
        CHECK(i || !shell(text, sizeof text, "size -A implementation.o >sections && ! grep -E '%s[1-9]' sections%s",
                          "^[.]t?(data|bss)([.]rel([.]local)?)? +", ""),
              "both headers keep state, in variables: %s", text);
        CHECK(!failed
                  && !shell(text, sizeof text,
                            "%s all.c -x none %s -lm -o two && ./two", compile, object)
                  && !text[0],
              "%s: %s", modes[i].whole, text);
        CHECK(!shell(text, sizeof text, "%s %s " WARNINGS " -I. static.c -o one -lm && ./one", modes[i].one, optimised)
                  && !text[0],
              "%s, SSGI_STATIC: %s", modes[i].one, text);
    }
    CHECK(ran >= 2, "only %d compilers were there", ran);
}

/* Checks that ssgi_gl.h's code without ssgi.h's is refused in a line, unless the file says where ssgi.h's is. */
static void alone(void)
{
    char text[4000];
    write_text("alone.c", "#define SSGI_GL_IMPLEMENTATION\n#include \"ssgi_gl.h\"\n");
    CHECK(shell(text, sizeof text, "gcc -std=c99 " WARNINGS " -I. -fsyntax-only alone.c%s%s", "", "")
              && strstr(text, "error: #error \"SSGI_GL_IMPLEMENTATION: define SSGI_IMPLEMENTATION, too, or "
                              "SSGI_IMPLEMENTED_ELSEWHERE if another file does\"")
              && !strstr(strstr(text, "error: ") + 1, "error: "),
          "without ssgi.h's code: %s", text);
    CHECK(!shell(text, sizeof text, "gcc -std=c99 " WARNINGS " -DSSGI_IMPLEMENTED_ELSEWHERE -I. -fsyntax-only alone.c"
                 "%s%s", "", "") && !text[0], "with ssgi.h's code elsewhere: %s", text);
}

/* Checks that comments name only things that exist. Puts old names back, to see that they are found. */
static void names(void)
{
    static const char *const stale[][2] = {
        { "desc\\.filter\\.quantity: the", "desc.quantity: the" }, { "desc->input\\.cap_table", "desc->cap_table" },
        { "desc->shader\\.dialect", "desc->dialect" },              { "_desc\\.surfel\\.overhang", "_desc.overhang" },
        { "---- desc\\.filter:", "---- desc.filter.kind:" },      { "passes thickness and", "passes (but width," },
        { "ssgi_gl_step\\.width", "ssgi_gl_step.viewport" },       { "SSGI_THICKNESS_SLABS for", "SSGI_SLABS for" },
        { "ssgi_gl_frame_history except", "ssgi_gl_history except" }
    };
    char text[4000], line[400];
    CHECK(!shell(text, sizeof text, "f='ssgi.h ssgi_gl.h' && awk -f '%s/tests/library/names.awk' $f look=1 $f "
                 "'%s/README.md'",
                 t_root, t_root), "no such name: %s", text);
    for (size_t i = 0; i < sizeof stale / sizeof *stale; ++i) {
        snprintf(line, sizeof line,
                 "sed 's/%s/%s/' ssgi_gl.h >stale.h && ! cmp -s stale.h ssgi_gl.h && f='ssgi.h stale.h' "
                 "&& ! awk -f '%s/tests/library/names.awk' $f look=1 $f",
                 stale[i][0], stale[i][1], t_root);
        CHECK(!shell(text, sizeof text, "%s%s", line, ""), "%s is taken: %s", stale[i][1], text);
    }
}

/* Compiles behind the macros of many hosts, behind windows.h, and in MSVC's dialect. -Wpedantic limits literals to
   4,095 characters, a quarter of MSVC's limit. */
static void hosts(void)
{
    static const struct {
        const char *compiler, *how;
    } modes[] = { { "gcc", "-std=c99 -include \"$root/tests/library/macros.h\"" },
                  { "clang++", "-std=c++17 -xc++ " MSVC },           /* the modes from here on are for T_ALL */
                  { "g++", "-std=c++11 -xc++ -include \"$root/tests/library/macros.h\"" },
                  { "x86_64-w64-mingw32-gcc", "-std=c99 -include windows.h" },
                  { "x86_64-w64-mingw32-g++", "-std=c++17 -xc++ -include windows.h" },
                  { "clang", "-std=c11 " MSVC },
                  { "aarch64-linux-gnu-gcc", "-std=c99" },
                  { "arm-linux-gnueabihf-gcc", "-std=c11" },
                  { "riscv64-linux-gnu-gcc", "-std=c99" } };
    char text[4000], line[400];
    for (size_t i = 0; i < (t_all() ? sizeof modes / sizeof modes[0] : 2); ++i) {
        if (!has(modes[i].compiler)) continue;
        snprintf(line, sizeof line, "%s -fsyntax-only " WARNINGS " -I. %s", modes[i].compiler, modes[i].how);
        CHECK(!shell(text, sizeof text, "root='%s' && %s implementation.c", t_root, line) && !text[0],
              "%s: %s", line, text);
    }
}

static void order_of_passes(void)
{
    char text[4000];
    CHECK(!shell(text, sizeof text, "sh '%s/tests/library/order.sh' '%s'", t_root, t_root),
          "the order of passes: something compares passes by it: %s", text);
}

/* Checks that a field of a few triangles has the same bytes if programs of other optimisation bake it. */
static void optimised(void)
{
    static const char *const program =
        "#define SSGI_STATIC\n#define SSGI_IMPLEMENTATION\n#include \"ssgi.h\"\n#include <stdio.h>\n"
        "int main(void) {\n"
        "    static float tri[9 * 60], work[1 << 16]; static uint32_t texels[6 * 6 * 6 * 4]; static unsigned char "
        "file[8192]; size_t i, n;\n"
        "    ssgi_field_desc desc = { 0 }; ssgi_field f;\n"
        "    uint32_t state = 1;\n"
        "    for (i = 0; i < 9 * 60; ++i) { state = state * 1664525u + 1013904223u; tri[i] = (float)(state >> 8) / "
        "16777216.0f; }\n"
        "    desc.resolution = desc.radii = 4; desc.rays = 32;\n"
        "    if (ssgi_field_bake_size(&desc, 60) > sizeof work || ssgi_field_bake(&f, texels, work, sizeof work, "
        "&desc, tri, 12, NULL, 60, NULL) != SSGI_OK) return 1;\n"
        "    n = ssgi_field_save(file, sizeof file, &f);\n"
        "    return n < 100 || fwrite(file, 1, n, stdout) != n;\n"
        "}\n";
    static const char *const modes[] = { "gcc -O0", "gcc -O2", "clang -O2" };
    char text[4000], present[200];
    int ran = 0;
    write_text("bake.c", program);
    for (size_t i = 0; i < sizeof modes / sizeof modes[0]; ++i) {
        snprintf(present, sizeof present, "command -v %.*s", (int)strcspn(modes[i], " "), modes[i]);
        if (shell(text, sizeof text, "%s%s", present, "")) continue;
        CHECK(!shell(text, sizeof text, "%s -ffp-contract=off -I. bake.c -o bake -lm && ./bake >%s", modes[i],
                     ran ? "other.field && cmp first.field other.field" : "first.field"),
              "%s: %s", modes[i], text);
        ++ran;
    }
    CHECK(ran >= 2, "only %d compilers were there", ran);
}

/* Returns gcc's seconds of processor for both implementations; 0 if it fails. */
static double compiled(const char *how)
{
    char text[400];
    const double before = t_spent(1);
    return shell(text, sizeof text, "gcc %s -c -I. implementation.c -o time.o%s", how, "") ? 0 : t_spent(1) - before;
}

/* Compares the time to optimise the headers with the time to parse them and to compile plain code on the same machine.
   Takes the least of a few tries, as the machine may be busy. */
static void compile_time(void)
{
    double best[2] = { 1e9, implementation_seconds > 0 ? implementation_seconds : 1e9 };
    for (int i = 0; i < 4 && (!i || best[1] >= 7.3 * best[0]); ++i)
        for (int k = 0; k < (i ? 2 : 1); ++k) {
            const double took = compiled(k ? "-O2" : "-O0");
            if (!CHECK(took > 0, "does not compile")) return;
            best[k] = took < best[k] ? took : best[k];
        }
    CHECK(best[1] < 7.3 * best[0], "both implementations at -O2 take %.1f times as long as at -O0", best[1] / best[0]);
    t_note("both implementations at -O2 take %.1f times as long as at -O0", best[1] / best[0]);
}

/* Compiles the text between two marks, with comment stars, as the body of a program. Adds it to snippets.cpp, too. */
static int snippet(const char *file, const char *from, const char *to, const char *before, const char *after,
                   char *output, size_t size)
{
    char *all = read_text(file), *a = all ? strstr(all, from) : NULL, *b = a ? strstr(a + strlen(from), to) : NULL,
         *program;
    int status = -1;
    snprintf(output, size, "%s: no text between \"%s\" and \"%s\"", file, from, to);
    if (a && b) {
        a = strchr(a + strlen(from), '\n');
        *b = 0;
        program = malloc(strlen(a) + strlen(before) + strlen(after) + 1);
        if (program) {
            sprintf(program, "%s%s%s", before, a, after);
            write_text("snippet.c", program);
            status = shell(output, size,
                           "{ echo '#define main main_'$((n = $(grep -c undef snippets.cpp)))_; cat snippet.c; "
                           "echo '#undef main'; } >>snippets.cpp && "
                           "gcc -std=c99 -Wall -Wextra -Werror -I. snippet.c implementation.o -lm -o snippet && "
                           "./snippet%s%s", "", "");
        }
        free(program);
    }
    free(all);
    return status;
}

static void documentation(void)
{
    static const char *const head = "#include \"ssgi_gl.h\"\n#include <stdio.h>\n#include <stdlib.h>\n"
                                    "#include <string.h>\nint main(void) {\n";
    static const char *const view = "    float m[16] = { 1,0,0,0, 0,1,0,0, 0,0,-1,-1, 0,0,-1,0 }; ssgi_view view; "
                                    "ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, 64, 64, NULL);\n";
    static const char *const used[][2] = {
        { "bias",
          "\n    (void)why; return !(lift > 0.06f && lift < 0.08f && bias > patch && bias < 1.3f * patch); }\n" },
        { "kernel", "\n    (void)view; return !(up > 0.666f && up < 0.668f); }\n" },
        { "sh", "\n    (void)view; return !(irradiance > 3.140f && irradiance < 3.142f); }\n" },
        { "tessellate", "\n    (void)view; free(uvw); return !(level == 9 && points == 75); }\n" },
        { "cap", "\n    (void)view; return !(share > 0.1 && share < 0.2 && table[0] == 0 && table[1023] == 1); }\n" },
        { "reflection",
          "\n    (void)view; (void)why; return !(lit > 0.4f && lit < 1 && gloss > 0.4f && gloss < 1); }\n" },
        { "field", "\n    (void)view; float o = ssgi_field_occlusion(&field, NULL, point, normal); free(texels);\n"
                   "    return !(o > 0.05f && o < 0.3f); }\n" },
        { "plan", "\n    (void)view; return !(plan.meets && plan.method == SSGI_PLAN_METHOD_NOTHING); }\n" }
    };
    /* code before the snippets: the input of a plan, a plane of 3000 points without occlusion */
    static const char *const given =
        "    static float hsao[3000], best[3000], solid[3000], slabs[3000], fast[3000], position[9000], normal[9000],\n"
        "        floor[9] = { 0, 0, 0, 1, 0, 0, 0, 0, -1 }, radius = 0.5f;\n"
        "    static double memory[500]; ssgi_trace trace; ssgi_gl_desc desc; memset(&desc, 0, sizeof desc);\n"
        "    ssgi_trace_build(&trace, memory, sizeof memory, floor, 12, NULL, 1, NULL);\n"
        "    for (int i = 0; i < 3000; ++i)\n"
        "        hsao[i] = best[i] = solid[i] = slabs[i] = fast[i] = normal[3 * i + 1] = 1;\n";
    /* code before the snippets: a GL that only counts calls */
    static const char *const gl =
        "#include \"ssgi_gl.h\"\n#ifndef GL_FRAMEBUFFER\ntypedef unsigned GLuint, GLenum; static int draws, bound;\n"
        "enum { GL_UNIFORM_BUFFER, GL_DYNAMIC_DRAW, GL_TEXTURE0 };\n#define GL_FRAMEBUFFER 0x8D40\n"
        "#define glBufferData(a, size, data, d) ((void)(data))\n#define glUseProgram(p) ((void)(p))\n"
        "#define glBindFramebuffer(t, f) ((void)(f))\n#define glViewport(x, y, w, h) ((void)(w))\n"
        "#define glActiveTexture(u) ((void)(u))\n#define glBindTexture(t, n) ((void)(n), ++bound)\n"
        "#define glDrawArraysInstanced(m, first, n, times) ((void)(times), ++draws)\n#endif\n";
    char text[4000], both[2000], mark[40];
    write_text("snippets.cpp", "");
    int status = snippet("ssgi.h", "   QUICK USE", "   CONVENTIONS", head, "    return 0;\n}\n", text, sizeof text);
    CHECK(!status && strstr(text, "a pixel is"), "ssgi.h's usage: %s", text);
    snprintf(both, sizeof both, "%s%s", head, view);
    status = snippet("ssgi_gl.h", "   QUICK USE", "   HOW A PASS", both,
                     "    free(text); return frame.radius != 0.5f;\n}\n", text, sizeof text);
    CHECK(!status && strstr(text, "unit 0: t_ssgi_depth"), "ssgi_gl.h's usage: %s", text);
    strcat(both, "    const char *why = \"\";\n");
    for (size_t i = 0; i < sizeof used / sizeof *used; ++i) {
        char before[3000];
        snprintf(before, sizeof before, "%s%s", both, strcmp(used[i][0], "plan") ? "" : given);
        snprintf(mark, sizeof mark, "/* >>%s in use", used[i][0]);
        status = snippet("ssgi.h", mark, "*/", before, used[i][1], text, sizeof text);
        CHECK(!status, "ssgi.h's usage of >>%s: %s", used[i][0], text);
    }
    status = snippet(
        "README.md", "<!-- usage -->\n```c", "```\n<!-- /usage -->", gl,
        "int main(void) {\n    float m[16] = { 1,0,0,0, 0,1,0,0, 0,0,-1,-1, 0,0,-1,0 }; GLuint names[32] = "
        "{ 0 };\n    draw_ao(m, names, names, names, names);\n    return !(draws == 3 && bound == 6); }\n",
        text, sizeof text);
    CHECK(!status, "README.md's usage: %s", text);
    snprintf(mark, sizeof mark, "%zu", sizeof used / sizeof *used);
    CHECK(!shell(text, sizeof text, "test $(grep -c ' in use (compiled' ssgi.h) = %s%s", mark, ""),
          "ssgi.h says of others than %s usages that they are compiled", mark);
    if (has("g++"))
        CHECK(!shell(text, sizeof text, "for s in c++11 c++20; do g++ -std=$s -Wall -Wextra -Werror -fsyntax-only -I. "
                     "snippets.cpp || exit 1; done%s%s", "", ""), "usages as C++: %s", text);
    CHECK(!shell(text, sizeof text,
                 "awk 'length($0) > 120 || NR > 200 { print \"line \" NR; bad = 1 } END { exit bad }' '%s/README.md'%s",
                 t_root, ""),
          "README.md: 200 lines of 120 columns are enough: %s", text);
    CHECK(!shell(text, sizeof text,
                 "cd '%s' && for f in README.md examples/docs/*.md; do "
                 "for l in $(grep -o '](%s)' $f | tr -d '()]' | cut -d'#' -f1); do "
                 "test -e \"$(dirname $f)/$l\" || { echo \"$f: $l\"; exit 1; }; done; done",
                 t_root, "[^)]*"),
          "a link leads nowhere: %s", text);
    CHECK(!shell(text, sizeof text,
                 "cd '%s' && awk '{ line = $0 } /^#+ / { s = tolower($0); sub(/^#+ /, \"\", s); "
                 "gsub(/[^a-z0-9 _-]/, \"\", s); gsub(/ /, \"-\", s); has[FILENAME \"#\" s] } "
                 "{ while (match(line, /\\]\\(%s\\)/)) { from[++n] = FILENAME; "
                 "to[n] = substr(line, RSTART + 2, RLENGTH - 3); line = substr(line, RSTART + RLENGTH) } } "
                 "END { for (i in to) { at = from[i]; if (to[i] !~ /^#/) sub(/[^\\/]*$/, \"\", at); at = at to[i]; "
                 "sub(/examples.docs.[.][.].[.][.]./, \"\", at); if (!(at in has)) { print from[i] \": \" to[i]; "
                 "bad = 1 } } exit bad || n < 40 }' README.md examples/docs/*.md", t_root, "[^):]*#[^)]*"),
          "a link leads to no heading: %s", text);
    CHECK(!shell(text, sizeof text,
                 "here=$PWD && cd '%s' && make -pqn deps 2>/dev/null >$here/rules; "
                 "for t in $(grep -ohE '(`|^    )make [a-z][a-z-]*%s' README.md examples/docs/*.md | "
                 "awk '{ print $2 }' | sort -u); do test -e $t || "
                 "grep -q \"^$t:\" $here/rules || { echo \"make $t\"; exit 1; }; done", t_root, ""),
          "a document names a target that there is not: %s", text);
    if (has("node"))
        CHECK(!shell(text, sizeof text,
                     "for f in README.md examples/docs/INTEGRATE.md examples/tools/packages/npm.md; do "
                     "rm -f code*.mjs && awk '/^```js$/ { on = \"code\" ++n \".mjs\"; next } /^```/ { on = \"\" } "
                     "on { print >on }' \"%s/$f\" && ls code*.mjs >js && "
                     "while read -r m; do node --check $m%s || exit 1; done <js || exit 1; done", t_root, ""),
              "JavaScript of a document cannot be read: %s", text);
    /* figures: decimals except versions and those in code; "3 of 4" from the chart on */
    CHECK(!shell(text, sizeof text,
                 "cd '%s' && { sed -E '/^    /d; s/((GL|ES|From|Mesa|Version) |ssgi-)[0-9.]+//g' README.md | "
                 "grep -oE '[0-9]+\\.[0-9]+'; sed -n '/^## Speed/,$p' README.md | tr '\\n' ' ' | "
                 "grep -oE '[0-9]+ of [0-9]+'; } | sort -u | "
                 "while read -r n; do grep -E \"(^|[^0-9.])$(echo \"$n\" | sed 's/[.]/[.]/')([^0-9.]|%s)\" "
                 "examples/docs/FIGURES.md examples/docs/BENCH.md examples/docs/FAILURES.md >/dev/null || "
                 "{ echo \"$n\"; exit 1; }; done", t_root, "$"),
          "README.md has a figure that FIGURES.md, BENCH.md and FAILURES.md of examples/docs have not: %s", text);
    CHECK(!shell(text, sizeof text,
                 "cd '%s/examples/docs' && awk '{ line = $0; while (match(line, /[0-9]+[.][0-9]+/)) { "
                 "x = substr(line, RSTART, RLENGTH); line = substr(line, RSTART + RLENGTH); found = FILENAME ~ /^F/; "
                 "if (found) all[x]; half = 0.501 * 10 ^ -(length(x) - index(x, \".\")); "
                 "for (k in all) if (k - x < half && x - k < half) found = 1; "
                 "if (!found) { print x; bad = 1 } } } END { exit bad }' FAILURES.md LIMITS.md%s", t_root, ""),
          "LIMITS.md has a figure that FAILURES.md has not, whose figures may have more decimals: %s", text);
    CHECK(!shell(text, sizeof text,
                 "'%s/build/glsl-text' --passes ssgi_gl.h >passes.md && diff '%s/examples/docs/PASSES.md' passes.md",
                 t_root, t_root),
          "examples/docs/PASSES.md is not what build/glsl-text --passes prints (make passes): %s", text);
    CHECK(!shell(text, sizeof text, "grep -q 'v0.5 ' '%s/ssgi.h' && grep -q 'v0.5 ' '%s/ssgi_gl.h'", t_root,
                 t_root)
              && SSGI_VERSION == 500 && SSGI_VERSION_MAJOR == 0 && SSGI_VERSION_MINOR == 5,
          "the headers' first lines and SSGI_VERSION disagree");
    CHECK(!shell(text, sizeof text,
                 "cd '%s' && set -x && grep 'Version 0.5:' README.md && grep \"in $(wc -l <examples/minimal.c) lines\" "
                 "README.md && grep \"^[*][*]three.js[*][*], r$(sed -n 's/.*\"three\": \">=0.%s.*/\\1/p' "
                 "examples/tools/packages/package.json) or later\" README.md && grep MIT LICENSE && "
                 "grep 'public domain' LICENSE", t_root, "\\([0-9]*\\)"),
          "README.md has another version, length of minimal.c, three.js or licence: %s", text);
    /* Checks that the header's script, by the tables of renames, leaves no old name above them: it turns 0.3 into
       0.4. */
    CHECK(!shell(
              text, sizeof text,
              "sed -n '/^      awk/,/>renames/p' ssgi.h >five && sed 's/0[.]4/0.3/; s/0[.]5/0.4/' five >four && "
              "sed -s '/^   CHANGES in/,$d' ssgi.h ssgi_gl.h >both && for s in five four; do sh $s && "
              "sed -n 's|^s/..\\([A-Za-z_0-9]*\\)..*|\\1|p' renames.sed | { grep _ || true; } >old && "
              "{ test ! -s old || ! grep -wnf old both; } || exit 1; done && sh five && "
              "echo desc.gather.steps desc.gather.samples desc.gather.directions desc.gather.half | "
              "sed -f renames.sed | grep -x 'desc.gather.samples desc.gather.directions desc.gather.slices "
              "desc.gather.resolution' && sh four && "
              "echo '%s' | sed -f renames.sed | grep '^%s$'",
              "chain.desc.steps = SSGI_GL_WIDTH;", "chain.desc.gather.steps = SSGI_GL_PASS_THICKNESS;"),
          "CHANGES: %s", text);
}

/* Checks by a Debian of stubs that a missing package is asked of apt-get, by sudo if not root. */
static void installed(void)
{
    char text[4000];
    write_text("stub", "#!/bin/sh\ncase ${0##*/} in id) echo ${ID:-0};; dpkg-query) exit 1;; sudo) test \"$1\" = -n || "
               "{ echo \"sudo $*\" >>asked; \"$@\"; };; *) echo \"$*\" >>asked;; esac\n");
    for (int k = 0; k < 2; ++k)
        CHECK(!shell(text, sizeof text,
                     "chmod +x stub && rm -f asked && for of in id dpkg-query apt-get sudo; do ln -sf stub $of; done "
                     "&& export PATH=\"$PWD:$PATH\" ID=%s && sh '%s/examples/kit/install.sh' nameless && "
                     "grep 'install -y .* nameless' asked && "
                     "test $ID = $(grep -c '^sudo .* install' asked)", k ? "1" : "0", t_root),
              "%s: %s", k ? "by sudo" : "as root", text);
}

/* Checks README's sentences about scenes by seed and costs, which are worked out anew of the csv. $2, $4 and $6 are the
   fields of the csv in quotes. */
static void measured(void)
{
    static const char *const work =
        "FNR == 1 { ++file; for (n = split($0, head, \",\"); n; --n) column[head[n]] = n; next }\n"
        "{ n = split($7, v, \",\"); name = $2 \", \" $6 }\n"
        "file == 1 && $1 ~ /,judged,.*,visibility,$/ && (name == \"hsao, \" || v[3] > 0) {\n"
        "    split($1, at, \",\"); ++count[name]; sum[name] += v[2]; if (v[2] > worst[name]) worst[name] = v[2]\n"
        "    if (name == \"hsao, \") own[at[1]] = v[2]\n"
        "    else { if (name ~ /Neural/ && v[2] < own[at[1]]) neural[at[1]]\n"
        "           if (name ~ /GTAONode/) { node = name; if (v[3] < own[at[1]]) fitted[at[1]] } } }\n"
        "$3 ~ /^,,1920,1080,/ && (file == 2 && $2 == \"hsao\" || file == 3 && $2 ~ /GTAONode/) {\n"
        "    split($3, v, \",\"); k = file == 2; if (k in ms) next\n"
        "    ms[k] = v[column[\"RX 6800 weighed\"] - 2]; deck[k] = v[column[\"Steam Deck weighed\"] - 2] }\n"
        "file == 4 { n = split($0, v, \",\"); x = v[n]; if (!low || x < low) low = x; if (x > high) high = x }\n"
        "END {\n"
        "    split(\"one two three four five six\", few, \" \")\n"
        "    for (k in sum) if (k != \"hsao, \" && (!best || sum[k] / count[k] < sum[best] / count[best])) best = k\n"
        "    for (k in neural) ++a; for (k in fitted) ++b; h = \"hsao, \"\n"
        "    printf \"it removes %.0f %% of the error\\n\", 100 - 100 * sum[h] / count[h]\n"
        "    printf \"on average over %d scenes\\nmean of %d generated scenes\\n\", count[h], count[h]\n"
        "    printf \"three.js\\047 %s comes closest, with %.0f %%\\n\", best ~ /GTAONode/ ? \"GTAONode\" : best, "
        "100 - 100 * sum[best] / count[best]\n"
        "    printf \"`hsao` has an error of %.3f, and GTAONode one of %.3f\\n\", worst[h], worst[node]\n"
        "    printf \"On %s scene n8ao\\047s neural mode had a smaller error, \", few[a]\n"
        "    printf \"and on %s scenes GTAONode after fitting\\n\", few[b]\n"
        "    printf \"gives `hsao` %.3f ms and GTAONode %.3f ms on an AMD RX 6800\\n\", ms[1], ms[0]\n"
        "    printf \"the estimate for `hsao` is %.3f ms\\n[%.2f to %.2f times]\\n\", deck[1], low, high\n"
        "}\n";
    char text[4000];
    write_text("measured.awk", work);
    CHECK(!shell(text, sizeof text,
                 "tr -s '\\n ' ' ' <'%s/README.md' >readme && cd '%s/examples/docs/figures' && awk -F '\"' -f "
                 "$OLDPWD/measured.awk seeds.csv cost.csv cost-peers.csv cost-peers-published.csv >$OLDPWD/told && "
                 "cd - >/dev/null && test $(wc -l <told) = 9 && while read -r line; do grep -qF -e \"$line\" readme || "
                 "{ echo \"$line\"; exit 1; }; done <told", t_root, t_root),
          "README.md does not say what the csv of examples/docs/figures do: %s", text);
}

/* Checks that each row of tests/promises.csv has its promise in README.md, where line breaks count as spaces, and its
   test in a file under tests/ that is named by its group. */
static void promises(void)
{
    char text[4000];
    write_text("promises.awk",
               "FNR == 1 && FILENAME == \"readme\" { readme = $0; next }\n"
               "NR == 2 { next }\n"
               "!/^\".*\"$/ || NF != 3 { print \"line \" FNR \" has other than three fields\"; bad = 1; next }\n"
               "{ promise = substr($1, 2); group = $2; test = substr($3, 1, length($3) - 1)\n"
               "  if (!(group in all)) {\n"
               "      list = \"cat \" tests \"/*/*\" group \"*\"; all[group] = \"\"\n"
               "      while ((list | getline line) > 0) all[group] = all[group] line \"\\n\"\n"
               "      close(list) }\n"
               "  if (!index(readme, promise)) { print \"not in README.md: \" promise; bad = 1 }\n"
               "  if (!index(all[group], test)) { print \"no test of \" group \": \" test; bad = 1 } }\n"
               "END { exit bad || FNR < 100 }\n");
    CHECK(!shell(text, sizeof text,
                 "r='%s' && tr -s '\\n ' ' ' <\"$r/README.md\" >readme && awk -v tests=\"$r/tests\" -F '%s' "
                 "-f promises.awk readme \"$r/tests/promises.csv\"", t_root, "\",\""),
          "tests/promises.csv: %s", text);
}

static void fuzz(void)
{
    char text[4000];
    int status = shell(text, sizeof text,
                       "gcc -O1 -DSSGI_STATIC -I. -fsanitize=address,undefined -fno-sanitize-recover=all "
                       "'%s/tests/library/fuzz.c' -o fuzz -lm && ./fuzz 24000%s", t_root, "");
    CHECK(!status, "random inputs under address and undefined-behaviour sanitizers: %s", text);
}

/* A way to compile a program of tests/, the command that runs it for another processor, and its arguments. */
typedef struct program_mode {
    const char *how, *run, *arguments;
} program_mode;

/* Compiles and runs a program in each way; without T_ALL in the first two. Names a way whose program cannot run. */
static void programs(const char *name, const program_mode *mode, size_t count)
{
    char text[4000], line[400];
    for (size_t i = 0; i < (t_all() ? count : 2); ++i) {
        snprintf(line, sizeof line, "echo 'int main(void) { return 0; }' | %s -xc - -o empty && %s ./empty",
                 mode[i].how, mode[i].run);
        if (shell(text, sizeof text, "%s%s", line, "")) {
            t_note("%s %s: not tried, nothing can be made or run by it here", mode[i].how, mode[i].run);
            continue;
        }
        snprintf(line, sizeof line, "%s '%s/tests/library/%s.c' -o program -lm && %s ./program %s", mode[i].how, t_root,
                 name, mode[i].run, mode[i].arguments);
        CHECK(!shell(text, sizeof text, "%s%s", line, ""), "%s: %s", line, text);
    }
}

/* From version 18 on, clang with -ffast-math assumes that a test of an argument's bits for NaN is never true. */
static void not_numbers(void)
{
    static const program_mode modes[] = { { "gcc -O1 -ffast-math -DSSGI_STATIC", "", "" },
                                          { "clang-19 -O1 -ffast-math -DSSGI_STATIC", "", "" },
                                          { "clang-19 -O3 -ffast-math -DSSGI_STATIC", "", "" },
                                          { "clang -O2 -ffast-math -DSSGI_STATIC", "", "" },
                                          { "gcc -O2 -ffast-math -DSSGI_STATIC", "", "" },
                                          { "gcc -O1 -DSSGI_STATIC", "", "" } };
    programs("nan", modes, sizeof modes / sizeof *modes);
}

/* Compilers for ARM64 fuse multiply and add by default, others do if they may use the processor's own instructions. */
static void closed_meshes(void)
{
    static const program_mode modes[] = { { "gcc -O2 -march=native", "", "1000" },
                                          { "gcc -O3 -march=native -ffast-math", "", "1000" },
                                          { "clang -O2 -march=native -ffast-math", "", "5000" },
                                          { "clang-19 -O3 -march=native", "", "1000" },
                                          { "gcc -O2", "", "1000" },
                                          { "aarch64-linux-gnu-gcc -O2 -static", "qemu-aarch64", "300" } };
    char text[400];
    if (shell(text, sizeof text, "gcc -march=native -dM -E -xc /dev/null | grep -qE '__FMA__|%s'%s",
              "__ARM_FEATURE_FMA", ""))
        t_note("this processor does not fuse multiply and add");
    programs("leaks", modes, sizeof modes / sizeof *modes);
}

/* Other versions of clang-format make another layout, so only 14 is asked. */
static void formatted(void)
{
    char text[4000];
    if (!has("clang-format")) return;
    if (shell(text, sizeof text, "clang-format --version | grep 'version 14\\.'%s%s", "", "")) {
        t_note("clang-format is not of version 14: not tried");
        return;
    }
    CHECK(!shell(text, sizeof text, "cd '%s' && clang-format --dry-run --Werror ssgi.h ssgi_gl.h%s", t_root, ""),
          "make format would change a header: %s", text);
    CHECK(!shell(text, sizeof text, "! grep -nE '.{121}' '%s/ssgi.h' '%s/ssgi_gl.h'", t_root, t_root),
          "longer than 120 columns: %s", text);
}

/* Lines of each folder around the headers, without data and documents: new lines are paid for by others that go. A
   bound is lowered when its folder shrinks, and raised by the lines of a new feature alone. */
static void surroundings(void)
{
    static const struct { const char *folders; int most; } rows[] = {
        { "tests", 25881 },         { "examples/lab", 15097 },
        { "examples/kit", 16143 },  { "examples/tools", 5746 },
        { "Makefile", 557 },        { "examples/web examples/viewer examples/hosts", 10025 }
    };
    char text[400];
    if (shell(text, sizeof text, "p=$(git -C '%s' rev-parse --show-prefix 2>/dev/null) && test -z \"$p\"%s", t_root,
              "")) {
        t_note("no repository of its own: not counted");
        return;
    }
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i)
        CHECK(!shell(text, sizeof text,
                     "cd '%s' && git ls-files %s | grep -vE '[.](png|jpg|svg|csv|wasm|hdr|exr)$' | tr '\\n' '\\0' | "
                     "xargs -0 cat | wc -l", t_root, rows[i].folders) && atoi(text) > 0 && atoi(text) <= rows[i].most,
              "%s: %d lines, at most %d", rows[i].folders, atoi(text), rows[i].most);
}

void test_build(void)
{
    if (!folder_begin()) return;
    RUN("both headers compile without a warning and link, as C99, C11, C++11 and C++20, whole and static", compilers);
    RUN("ssgi_gl.h's code without ssgi.h's is a sentence where it is compiled", alone);
    RUN("both headers compile behind a hundred macros of hosts, behind windows.h, and in MSVC's dialect", hosts);
    RUN("both headers are as make format leaves them, in 120 columns", formatted);
    RUN("the code in the headers' comments and in the README compiles as C99, C++11 and C++20, and runs",
        documentation);
    RUN("comments and the README name fields, functions and passes that there are", names);
    RUN("README's sentences have the numbers of the scenes by seed and of the costs", measured);
    RUN("each promise of README has a test", promises);
    RUN("a package that is missing is installed by apt-get, with sudo", installed);
    RUN("what surrounds the headers does not grow", surroundings);
    RUN("no function takes NaN or infinity for a number, by whatever rules of arithmetic", not_numbers);
    RUN("no ray leaves a closed mesh between its triangles, by whatever rules of arithmetic", closed_meshes);
    if (t_all()) {                                 /* these tests compile the library many times */
        RUN("random inputs and chains neither crash nor trip a sanitizer", fuzz);
        RUN("a baked field has the same bytes at any optimisation", optimised);
        RUN("the order of passes in their enum means nothing", order_of_passes);
        RUN("an optimiser is quick with both implementations", compile_time);
    }
    folder_end();
}
