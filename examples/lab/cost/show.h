/* show.h - sums the costs over a chain's passes, and prints tables of them. */
#ifndef COST_SHOW_H
#define COST_SHOW_H

#include "lab/cost/model.h"
#include "lab/cost/passes.h"
#include <stdio.h>

/* MEAN_SURFELS: how many a scene has at 1920x1080; MEAN_SPLATS: texels of occlusion splats for each gathered one. Means
   of seeds 0 to 20, where splats are 8 to 142 (build/render random:N --size 1920x1080 --method dss-best --set levels=4
   --time 1 prints both). Other effects are taken to have as many. */
#define MEAN_SPLATS 55.0
#define MEAN_SURFELS 33e3
enum { QUAD = 6 };                          /* vertices that draw a surfel on one level of the pyramid */

/* Return milliseconds on a device: of a pass that splats so many texels, of any pass, of a chain. Each splatted texel
   is read and written, as if there were no cache. */
double splat_ms(const work *w, const cost_pass *p, int family, way how, const device *d, double texels, double surfels,
                bound *which);
double pass_ms(const work *w, const cost_pass *p, int family, way how, const device *d, bound *which);
double chain_ms(const work *w, const cost_chain *c, int family, way how, const device *d);

/* Write rows of all passes and chains as csv. On stdout: the columns that are read first, an engine's budget, and facts
   that are not in the csv; passes: also a row for each pass. */
void write_costs(FILE *f, const work *w);
void show_costs(const csv *c, int passes);
void show_notes(const work *w, int passes);

#endif
