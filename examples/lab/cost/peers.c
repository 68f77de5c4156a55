/* peers.c - makes chains of other libraries' effects, which peers.mjs writes. Declared in peers.h. */
#include "lab/cost/peers.h"
#include <string.h>
#include "lab/measure/csv.h"
#include "lab/measure/script.h"

#define OUT "build/peers/cost"

/* Returns a format of so many bytes a texel. */
static VkFormat format_of(double bytes)
{
    return bytes < 2 ? VK_FORMAT_R8_UNORM : bytes > 8 ? VK_FORMAT_R32G32B32A32_SFLOAT
         : bytes > 4 ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R8G8B8A8_UNORM;
}

static int add_pass(work *w, cost_chain *c, const csv *all, int row, kit_error *err)
{
    char path[64];
    size_t size;
    cost_pass p = { .name = "", .width = (int)csv_number(all, row, "width"),
                    .height = (int)csv_number(all, row, "height"), .bytes_in = csv_number(all, row, "bytes_in"),
                    .bytes_out = csv_number(all, row, "bytes_out") };
    cost_program made = { .pass = "", .relaxed = 1, .stages = 2, .formats = 1,
                          .format = { format_of(p.bytes_out / ((double)p.width * p.height)) },
                          .kind = { VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT } };
    if (c->passes == MOST_PASSES) return kit_fail(err, "%s: has more than %d passes", c->name, MOST_PASSES);
    for (int k = 0; k < 2; ++k) {
        snprintf(path, sizeof path, OUT "/%.16s.cost.%s", csv_text(all, row, "number"), k ? "frag" : "vert");
        if (kit_file_read(&made.text[k], &size, path, err)) return -1;
    }
    if ((p.program = work_program(w, &made, err)) < 0) return -1;
    c->pass[c->passes++] = p;
    return 0;
}

int peers_add(work *w, kit_error *err)
{
    const kit_camera camera = { .fovy = 45, .width = WIDTH, .height = HEIGHT, .znear = 0.1f, .zfar = 50,
                                .eye = { 0, 1, 4 }, .up = { 0, 1, 0 } };
    const int ran = script_run(OUT, &camera, 0.5f, 4, 0, err);
    cost_chain *c = NULL;
    char name[128];
    if (ran < 0) return -1;
    if (!ran) return kit_fail(err, "node cannot run " SCRIPT ": make peers");
    const csv all = csv_read(OUT, "manifest.csv");
    for (int i = 0; i < all.rows; ++i) {
        const char *kind = csv_text(&all, i, "kind");
        if (!strcmp(kind, "peer")) {
            snprintf(name, sizeof name, "%s / %s", csv_text(&all, i, "name"), csv_text(&all, i, "settings"));
            if (!(c = work_chain(w, name, err))) return -1;
        }
        if (strcmp(kind, "pass") || csv_number(&all, i, "shown") > 0 || !c) continue;
        if (add_pass(w, c, &all, i, err)) return -1;
    }
    return 0;
}
