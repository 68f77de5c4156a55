/* costs.c - what each pass and each choice costs in instructions and fetches, read off the SPIR-V that glslang makes of
   the texts. Declared in costs.h.

   Counts are static: of the text as it stands, loops counted once, before any optimiser. Beside them the most texels
   that a pixel fetches (kit_fetches). A choice that is off costs nothing:
   set while what it belongs to is off, it leaves the text as it is, byte for byte; which do so is listed. */
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
    ssgi_gl_desc d = variants[v].desc;
    d.dialect = SSGI_GL_450;
    return with_choice(d, c);
}

/* Writes every text that differs from its pass's base, each once, unless its SPIR-V is there from before; how many
   costs there are. The vertex stages of passes over the picture are all the same triangle and left out. */
static int costs_write(tally *costs, int *texts, kit_error *err)
{
    int n = 0;
    *texts = 0;
    for (int v = 0; v < variants_count; ++v)
        for (int c = 0; c < choices_count; ++c)
            for (int at = variants[v].desc.pass == SSGI_GL_SURFELS || variants[v].desc.pass == SSGI_GL_SPLAT ? 0 : 1;
                 at < SSGI_GL_STAGES && n < MOST_COSTS; ++at) {
                ssgi_gl_desc base = cost_desc(v, 0), d = cost_desc(v, c);
                base.fetch = d.fetch;                      /* the caller's text is in every text, read or not */
                char *text = cost_text(&d, at), *was = c ? cost_text(&base, at) : NULL, path[128];
                if (text && !(was && !strcmp(text, was))) {
                    tally *k = &costs[n++];
                    int i = 0, failed = 0;
                    *k = (tally){ v, c, at, kit_fetches(&d), 0, 0, 0, 0,
                        kit_hash(KIT_HASH + (uint64_t)at, text, strlen(text)) };
                    while (costs[i].text != k->text) ++i;
                    snprintf(path, sizeof path, COSTS "/%016llx.%s.spv", (unsigned long long)k->text,
                             stage_endings[at]);
                    if (i == n - 1 && access(path, F_OK)) {
                        path[strlen(path) - 4] = 0;
                        failed = kit_file_write(path, text, strlen(text), err);
                        ++*texts;
                    }
                    if (failed) { free(text); free(was); return -1; }
                }
                free(text);
                free(was);
            }
    return n;
}

static int cost_read(tally *k, kit_error *err)
{
    char path[128], *data;
    size_t size;
    const uint32_t *word;
    int inside = 0;
    snprintf(path, sizeof path, COSTS "/%016llx.%s.spv", (unsigned long long)k->text, stage_endings[k->stage]);
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

static void cost_title(char out[64], int v)          /* without Markdown's marks */
{
    size_t n = 0;
    for (const char *c = variants[v].title; *c && n < 63; ++c) if (*c != '`') out[n++] = *c;
    out[n] = 0;
}

static void cost_html(FILE *f, const tally *k, const tally *base)
{
    char title[64];
    cost_title(title, k->variant);
    fprintf(f, "<tr%s><td>%s<td>%s%s", k->choice ? "" : " class=\"first\"", k->choice ? "" : title,
            k->choice ? choices[k->choice].name : "defaults", k->stage == SSGI_GL_FRAGMENT ? "" : ", ");
    if (k->stage != SSGI_GL_FRAGMENT) fputs(stage_endings[k->stage], f);
    fprintf(f, "<td>%d<td>", k->instructions);
    if (base) fprintf(f, "%+d", k->instructions - base->instructions);
    fprintf(f, "<td>%d<td>%d<td>%d<td>%d\n", k->fetches, k->texels, k->branches, k->loops);
}

/* A table of all passes at their defaults, one of every choice, and costs.csv. */
int costs_chart(FILE *html, const char *out, kit_error *err)
{
    static const char *const head = "<div class=\"wide\"><table>\n<tr><th>pass<th>choice<th title=\"in SPIR-V, loops "
                                    "once, not optimised\">instructions<th title=\"to the defaults\">more"
                                    "<th title=\"instructions that fetch or sample\">fetching<th title=\"the most that "
                                    "a pixel fetches, all loops\">texels a pixel<th>branches<th>loops\n";
    static tally costs[MOST_COSTS];
    page csv;
    char title[64];
    int count, texts, missing;
    if (folder_make(COSTS, err)) return -1;
    count = costs_write(costs, &texts, err);
    if (count < 0) return -1;
    missing = costs_count(costs, count, texts, err);
    if (missing < 0) return -1;
    fputs("<h2>Instructions and fetches</h2>\n", html);
    if (missing) { fputs("<p class=\"faint\">Not counted: glslangValidator is missing.</p>\n", html); return 0; }
    fprintf(html,
            "<p>Of each pass as emitted for GLSL 4.50, in SPIR-V by glslang, before any optimiser: static counts, "
            "loops once; texels a pixel: with all loops. "
            "<a href=\"costs.csv\">costs.csv</a></p>\n%s",
            head);
    if (page_open(&csv, err)) return -1;
    fputs("pass,choice,stage,instructions,fetch_instructions,texels_a_pixel,branches,loops\n", csv.file);
    for (int i = 0; i < count; ++i) {
        cost_title(title, costs[i].variant);
        fprintf(csv.file, "\"%s\",\"%s\",%s,%d,%d,%d,%d,%d\n", title, choices[costs[i].choice].name,
                stage_endings[costs[i].stage], costs[i].instructions, costs[i].fetches, costs[i].texels,
                costs[i].branches, costs[i].loops);
        if (!costs[i].choice) cost_html(html, &costs[i], NULL);
    }
    fputs("</table></div>\n<details><summary>With one choice each</summary>\n", html);
    fputs(head, html);
    for (int i = 0; i < count; ++i) {
        const tally *base = NULL;
        for (int k = 0; k < i && costs[i].choice; ++k)
            if (!costs[k].choice && costs[k].variant == costs[i].variant && costs[k].stage == costs[i].stage)
                base = &costs[k];
        cost_html(html, &costs[i], base);
    }
    fputs("</table></div>\n</details>\n<details><summary>What is off costs nothing</summary>\n<p>Each choice below was "
          "set alone, and the text stayed the same byte for byte, because it waits for one of those in "
          "brackets.</p>\n<dl>\n",
          html);
    for (int v = 0; v < variants_count; ++v) {
        cost_title(title, v);
        fprintf(html, "<dt>%s<dd>", title);
        if (!costs_waiting(html, v)) fputs("nothing waits", html);
        fputc('\n', html);
    }
    fputs("</dl>\n</details>\n", html);
    return page_close(&csv, out, "costs.csv", err);
}
