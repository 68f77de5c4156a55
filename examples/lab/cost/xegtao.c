/* xegtao.c - XeGTAO's passes as xegtao.sh compiles them, and the times that others have published. Declared in
   xegtao.h. */
#include "lab/cost/xegtao.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/cost/show.h"
#include "lab/page/page.h"

#define OUT      "build/xegtao"
#define NAME     "cost-peers-published.csv"
#define RECORD   "examples/docs/figures/cost-peers.csv"
#define README   "XeGTAO's README"

/* A pass: the pixels that a thread writes, and the bytes that each pixel reads and writes. Depths are of 16 bits and
   have five levels, normals of 32 bits, visibility and edges of 8 bits each. */
#define LEVELS (2.0 * 341 / 256)
typedef struct part { const char *name; int across, down; double bytes_in, bytes_out; } part;
static const part before = { "PrefilterDepths16x16", 2, 2, 4, LEVELS }, after = { "DenoiseLastPass", 2, 1, 2, 1 };
static const struct { const char *chain; part gather; } presets[] = {
    { "XeGTAO / Medium, one denoising pass", { "GTAOMedium", 1, 1, LEVELS + 4, 2 } },
    { "XeGTAO / High, one denoising pass", { "GTAOHigh", 1, 1, LEVELS + 4, 2 } }
};
enum { MEDIUM, HIGH, PRESETS };

static const struct { const char *device, *source; int preset, height; double ms; } times[] = {
    { "RX 6800 XT", "bevy#11292 (a port)", HIGH, 1080, .256 },
    { "RTX 3070", README, HIGH, 2160, 1.4 },
    { "RTX 2060", README, HIGH, 1080, .56 },
    { "GTX 1050", README, HIGH, 1080, 2.2 },
    { "GTX 1050", README, MEDIUM, 1080, 1.5 },
    { "i7-1195G7", README, HIGH, 1080, 2.39 }
};
enum { TIMES = sizeof times / sizeof *times };

static int add_part(work *w, cost_chain *c, const part *of, kit_error *err)
{
    const double pixels = (double)WIDTH * HEIGHT;
    cost_program made = { .pass = "", .stages = 1 };
    cost_pass p = { .name = "", .width = WIDTH / of->across, .height = HEIGHT / of->down,
                    .bytes_in = of->bytes_in * pixels, .bytes_out = of->bytes_out * pixels };
    char path[64];
    snprintf(path, sizeof path, OUT "/%s.comp.spv", of->name);
    if (spirv_read(&made.stage[0], path, err) || (p.program = work_program(w, &made, err)) < 0) return -1;
    c->pass[c->passes++] = p;
    return 0;
}

static int is_here(void) { return !access(OUT "/DenoiseLastPass.comp.spv", R_OK); }

int xegtao_add(work *w, kit_error *err)
{
    for (int i = 0; i < PRESETS && is_here(); ++i) {
        cost_chain *c = work_chain(w, presets[i].chain, err);
        if (!c || add_part(w, c, &before, err) || add_part(w, c, &presets[i].gather, err) ||
            add_part(w, c, &after, err)) return -1;
    }
    return 0;
}

void xegtao_keep(FILE *f)
{
    char *text;
    size_t size;
    if (is_here() || kit_file_read(&text, &size, RECORD, NULL)) return;
    for (char *line = strtok(text, "\n"); line; line = strtok(NULL, "\n"))
        if (strstr(line, ",\"XeGTAO / ")) fprintf(f, "%s\n", line);
    free(text);
}

int xegtao_published(FILE *record, const work *w, kit_error *err)
{
    static const char keys[] = "device,effect,height,published ms,source,modelled ms,ratio";
    double modelled[TIMES], published[TIMES];
    page table;
    if (!is_here()) return 0;
    if (page_open(&table, err)) return -1;
    fprintf(table.file, "%s\n", keys);
    for (int i = 0; i < TIMES; ++i) {
        const cost_chain *c = w->chain;
        while (strcmp(c->name, presets[times[i].preset].chain)) ++c;
        published[i] = times[i].ms;
        modelled[i] = chain_ms(w, c, 0, BUSY, device_of(times[i].device)) * pow(times[i].height / (double)HEIGHT, 2);
        fprintf(table.file, "%s,\"%s\",%d,%g,%s,%.3f,%.2f\n", times[i].device, c->name, times[i].height, published[i],
                times[i].source, modelled[i], modelled[i] / published[i]);
    }
    fflush(table.file);
    const csv c = csv_of(strdup(table.text), NAME);
    const trust t = trust_of(modelled, published, TIMES);
    csv_put(stdout, &c, keys, NULL, 1);
    printf("modelled over published: geometric mean %.2f, from %.2f to %.2f\n", t.mean, t.least, t.most);
    return page_csv(record, "rows", &table, "report", NAME, err);
}
