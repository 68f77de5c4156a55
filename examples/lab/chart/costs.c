/* costs.c - what each pass and each choice costs in instructions and fetches, read off the SPIR-V that glslang makes of
   the texts. Declared in costs.h.

   Counts are static: of the text as it stands, loops counted once, before any optimiser. Beside them the most texels
   that a pixel fetches (kit_fetches). A choice that is off costs nothing: set while what it belongs to is off, it
   leaves the text as it is, byte for byte; which do so is listed. */
#include "lab/chart/costs.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kit/kit_gl.h"
#include "lab/measure/folder.h"
#include "lab/page/page.h"
#include "tools/glsl/choices.h"

#define COSTS "build/costs"
enum { MOST_COSTS = 2048 };

/* Of a stage of a variant with a choice. text: its hash. */
typedef struct tally {
    int variant, choice, stage, texels, instructions, fetches, branches, loops;
    uint64_t text;
} tally;

static const char *const stage_endings[SSGI_GL_STAGES] = { "vert", "frag", "tesc", "tese", "geom" };

/* NULL: there is no such text. */
static char *cost_text(const ssgi_gl_desc *d, int at)
{
    const size_t n = ssgi_gl_emit(NULL, 0, d, at);
    char *text = n ? malloc(n + 1) : NULL;
    if (text) ssgi_gl_emit(text, n + 1, d, at);
    return text;
}

static ssgi_gl_desc cost_desc(int v, int c)
{
    variant of;
    variant_at(&of, v);
    of.desc.text.dialect = SSGI_GL_DIALECT_450;
    return with_choice(of.desc, c);
}

/* The text's file is COSTS/HASH.STAGE, its SPIR-V's that and .spv. */
static void cost_path(char path[128], const tally *k, const char *ending)
{
    snprintf(path, 128, COSTS "/%016llx.%s%s", (unsigned long long)k->text, stage_endings[k->stage], ending);
}

/* Adds a text to n costs, and writes it, unless another has the same or its SPIR-V is there from before. Returns how
   many texts that are, -1 = failed. */
static int cost_add(tally *costs, int n, int v, int c, int at, const char *text, kit_error *err)
{
    const ssgi_gl_desc d = cost_desc(v, c);
    char path[128];
    int same = 0;
    costs[n] = (tally){ .variant = v, .choice = c, .stage = at, .texels = kit_fetches(&d),
                        .text = kit_hash(KIT_HASH + (uint64_t)at, text, strlen(text)) };
    while (costs[same].text != costs[n].text) ++same;
    cost_path(path, &costs[n], ".spv");
    if (same < n || !access(path, F_OK)) return 0;
    cost_path(path, &costs[n], "");
    return kit_file_write(path, text, strlen(text), err) ? -1 : 1;
}

/* A stage of a variant with a choice, if it differs from that without: n and texts grow. */
static int cost_stage(tally *costs, int *n, int *texts, int v, int c, int at, kit_error *err)
{
    const ssgi_gl_desc d = cost_desc(v, c);
    ssgi_gl_desc base = cost_desc(v, 0);
    base.text.fetch = d.text.fetch;                          /* the caller's text is in every text, read or not */
    char *text = cost_text(&d, at), *was = c ? cost_text(&base, at) : NULL;
    int written = 0;
    if (text && !(was && !strcmp(text, was))) written = cost_add(costs, (*n)++, v, c, at, text, err);
    if (written > 0) *texts += written;
    free(text);
    free(was);
    return written < 0 ? -1 : 0;
}

/* Writes every text that differs from its pass's base; how many costs there are, and texts that were written. The
   vertex stages of passes over the picture are all the same triangle and left out. */
static int costs_write(tally *costs, int *texts, kit_error *err)
{
    int n = 0;
    *texts = 0;
    variant of;
    for (int v = 0; variant_at(&of, v); ++v) {
        const int pass = of.desc.pass,
                  first = pass == SSGI_GL_PASS_SURFELS || pass == SSGI_GL_PASS_SPLAT ? 0 : 1;
        for (int c = 0; c < choices_count; ++c)
            for (int at = first; at < SSGI_GL_STAGES && n < MOST_COSTS; ++at)
                if (cost_stage(costs, &n, texts, v, c, at, err)) return -1;
    }
    return n;
}

static int cost_read(tally *k, kit_error *err)
{
    char path[128], *data;
    size_t size;
    const uint32_t *word;
    int inside = 0;
    cost_path(path, k, ".spv");
    if (kit_file_read(&data, &size, path, err)) return -1;
    word = (const uint32_t *)(void *)data;
    for (size_t i = 5; i < size / 4 && word[i] >> 16; i += word[i] >> 16) {
        enum {
            LINE = 8,
            FUNCTION = 54,
            PARAMETER,
            FUNCTION_END,
            VARIABLE = 59,
            FIRST_IMAGE = 87,
            LAST_IMAGE = 98,
            LOOP = 246,
            SELECTION,
            LABEL,
            BRANCH_IF = 250,
            SWITCH
        };
        const uint32_t op = word[i] & 0xffff;
        if (op == FUNCTION || op == FUNCTION_END) inside = op == FUNCTION;
        else
            k->instructions += inside && op != LINE && op != PARAMETER && op != VARIABLE && op != LOOP
                               && op != SELECTION && op != LABEL;
        k->loops += op == LOOP;
        k->branches += op == BRANCH_IF || op == SWITCH;
        k->fetches += op >= FIRST_IMAGE && op <= LAST_IMAGE;
    }
    free(data);
    return k->instructions ? 0 : kit_fail(err, "%s: is no SPIR-V", path);
}

/* glslang over those texts, and the counts of all. 1: there is no glslang. */
static int costs_count(tally *costs, int count, int texts, kit_error *err)
{
    char line[1024], problem[512] = "";
    int done = 0;
    FILE *f;
    if (system("command -v glslangValidator > /dev/null 2>&1")) return 1;
    f = popen("cd " COSTS " && ls | grep -v spv | xargs -P 2 -I{} glslangValidator -G --aml --amb -o {}.spv {} 2>&1 && "
                          "rm -f *.vert *.frag *.tes[ce] *.geom",
              "r");
    if (!f) return kit_fail(err, "glslangValidator cannot be run: %s", strerror(errno));
    kit_progress("instructions", 0);
    while (fgets(line, sizeof line, f)) {
        if (!strncmp(line, "ERROR", 5) && !*problem) snprintf(problem, sizeof problem, "%.400s", line);
        kit_progress("instructions", fmin(0.99, (double)++done / texts));
    }
    kit_progress("instructions", 1);
    if (pclose(f) || *problem) return kit_fail(err, COSTS ": glslangValidator: %s", *problem ? problem : "failed");
    for (int i = 0; i < count; ++i) if (cost_read(&costs[i], err)) return -1;
    return 0;
}

/* ---- >>off: choices that wait for another one -------------------------------------------------------------------- */

/* Of the text with two choices; 0: they do not go together. */
static uint64_t cost_key(int v, int a, int b)
{
    const ssgi_gl_desc d = with_choice(cost_desc(v, b), a);
    return ssgi_gl_check(&d, NULL) == SSGI_OK ? ssgi_gl_key(&d) : 0;
}

/* "rays (march)": rays changes no byte until march is chosen. Returns how many wait. */
static int costs_waiting(FILE *f, int v)
{
    uint64_t alone[MOST_CHOICES], both;
    int n = 0;
    for (int b = 0; b < choices_count; ++b) alone[b] = cost_key(v, b, 0);
    for (int c = 1; c < choices_count; ++c) {
        const ssgi_gl_desc base = cost_desc(v, 0), d = cost_desc(v, c);
        int same = alone[c] == alone[0], wakes = 0;
        for (int at = 0; at < SSGI_GL_STAGES && same; ++at) {
            char *was = cost_text(&base, at), *is = cost_text(&d, at);
            same = !was == !is && !(was && strcmp(was, is));
            free(was);
            free(is);
        }
        for (int b = 1; b < choices_count && same; ++b) {
            if (choices[b].offset == choices[c].offset || !alone[b] || !(both = cost_key(v, c, b)) || both == alone[b])
                continue;
            fprintf(f, "%s%s", wakes ? ", " : n ? "; " : "", wakes ? "" : choices[c].name);
            fprintf(f, "%s%s", wakes ? "" : " (", choices[b].name);
            if (!wakes++) ++n;
        }
        if (wakes) fputc(')', f);
    }
    return n;
}

/* ---- >>writing --------------------------------------------------------------------------------------------------- */

static void cost_html(FILE *f, const tally *k, const tally *base)
{
    variant of;
    variant_at(&of, k->variant);
    fprintf(f, "<tr%s><td>%s<td>%s%s", k->choice ? "" : " class=\"first\"", k->choice ? "" : of.title,
            k->choice ? choices[k->choice].name : "defaults", k->stage == SSGI_GL_STAGE_FRAGMENT ? "" : ", ");
    if (k->stage != SSGI_GL_STAGE_FRAGMENT) fputs(stage_endings[k->stage], f);
    fprintf(f, "<td>%d<td>", k->instructions);
    if (base) fprintf(f, "%+d", k->instructions - base->instructions);
    fprintf(f, "<td>%d<td>%d<td>%d<td>%d\n", k->fetches, k->texels, k->branches, k->loops);
}

static const char *const table_head =
    "<div class=\"wide\"><table>\n<tr><th>pass<th>choice<th title=\"in SPIR-V, loops once, not optimised\">instructions"
    "<th title=\"to the defaults\">more<th title=\"instructions that fetch or sample\">fetching"
    "<th title=\"the most that a pixel fetches, all loops\">texels a pixel<th>branches<th>loops\n";

/* All passes at their defaults. */
static void defaults_html(FILE *html, const tally *costs, int count)
{
    fprintf(html,
            "<p>Of each pass as emitted for GLSL 4.50, in SPIR-V by glslang, before any optimiser: static counts, "
            "loops once; texels a pixel: with all loops. "
            "<a href=\"costs.csv\">costs.csv</a></p>\n%s",
            table_head);
    for (int i = 0; i < count; ++i) if (!costs[i].choice) cost_html(html, &costs[i], NULL);
    fputs("</table></div>\n", html);
}

/* Every choice, beside its pass at its defaults. */
static void choices_html(FILE *html, const tally *costs, int count)
{
    fprintf(html, "<details><summary>With one choice each</summary>\n%s", table_head);
    for (int i = 0; i < count; ++i) {
        const tally *base = NULL;
        for (int k = 0; k < i && costs[i].choice; ++k)
            if (!costs[k].choice && costs[k].variant == costs[i].variant && costs[k].stage == costs[i].stage)
                base = &costs[k];
        cost_html(html, &costs[i], base);
    }
    fputs("</table></div>\n</details>\n", html);
}

static void waiting_html(FILE *html)
{
    fputs("<details><summary>What is off costs nothing</summary>\n<p>Each choice below was "
          "set alone, and the text stayed the same byte for byte, because it waits for one of those in "
          "brackets.</p>\n<dl>\n",
          html);
    variant of;
    for (int v = 0; variant_at(&of, v); ++v) {
        fprintf(html, "<dt>%s<dd>", of.title);
        if (!costs_waiting(html, v)) fputs("nothing waits", html);
        fputc('\n', html);
    }
    fputs("</dl>\n</details>\n", html);
}

static int costs_csv(const tally *costs, int count, const char *out, kit_error *err)
{
    page csv;
    if (page_open(&csv, err)) return -1;
    fputs("pass,choice,stage,instructions,fetch_instructions,texels_a_pixel,branches,loops\n", csv.file);
    for (const tally *k = costs; k < costs + count; ++k) {
        variant of;
        variant_at(&of, k->variant);
        fprintf(csv.file, "\"%s\",\"%s\",%s,%d,%d,%d,%d,%d\n", of.title, choices[k->choice].name,
                stage_endings[k->stage], k->instructions, k->fetches, k->texels, k->branches, k->loops);
    }
    return page_close(&csv, out, "costs.csv", err);
}

int costs_chart(FILE *html, const char *out, kit_error *err)
{
    static tally costs[MOST_COSTS];
    int texts;
    if (folder_make(COSTS, err)) return -1;
    const int count = costs_write(costs, &texts, err), missing = count < 0 ? -1 : costs_count(costs, count, texts, err);
    if (missing < 0) return -1;
    fputs("<h2>Instructions and fetches</h2>\n", html);
    if (missing) { fputs("<p class=\"faint\">Not counted: glslangValidator is missing.</p>\n", html); return 0; }
    defaults_html(html, costs, count);
    choices_html(html, costs, count);
    waiting_html(html);
    return costs_csv(costs, count, out, err);
}
