/* show.h - sums over a chain's passes, and what is printed and written of them. */
#ifndef COST_SHOW_H
#define COST_SHOW_H

#include "lab/cost/model.h"
#include "lab/cost/passes.h"
#include <stdio.h>

/* Scenes by seed have so many surfels at 1920x1080, and on a texel that is gathered so many texels of splats of
   occlusion: means of 0 to 20, which have 8 to 142 (build/render random:N --size 1920x1080 --method dss-best --set
   levels=4 --time 1 says both). Other effects are taken to have as many. */
#define SPLATS 55.0
#define SURFELS 33e3
enum { QUAD = 6 };                          /* vertices of a surfel on a level */

/* Milliseconds on a device, of one pass or of all; of a pass that splats, where so many texels are covered. Each of
   these is read and written, as if no cache kept it. */
double splat_ms(const work *w, const cost_pass *p, int family, way how, const device *d, double texels, double surfels,
                bound *which);
double pass_ms(const work *w, const cost_pass *p, int family, way how, const device *d, bound *which);
double chain_ms(const work *w, const cost_chain *c, int family, way how, const device *d);

/* Lines of all passes and chains; on stdout: what of these is read first, an engine's budget, and what
   is in no csv; passes: of each. */
void write_costs(FILE *f, const work *w);
void show_costs(const csv *c, int passes);
void show_notes(const work *w, int passes);

#endif
