/* light.c - the sections on light and on deep screen space: the demo's pictures; a chart, the effect of layers, cameras
   and points, and that of harmonics; the effect of surfel size, epsilon, levels and other choices. Declared in
   chart.h. */
#include "lab/chart/chart.h"

enum { PROBE_STRIDE = 14 };
_Static_assert(ON_STRIDE(PROBE_STRIDE), "noise is probed where there is no truth");

const section lit_demo = { .name = "lit", .sets = "lit-demo", .width = 480, .height = 270, .rounds = 2,
                           .probe_times = 4, .probe_stride = PROBE_STRIDE, .range = 0.2, .crop_times = 4, .beside = 1 };
const section lit_chart = { .name = "lit", .csv = "chart-lit.csv", .sets = "lit", .width = 320, .height = 180,
                            .stride = LIT_STRIDE, .rounds = CHART_ROUNDS, .probe_times = 4,
                            .probe_stride = PROBE_STRIDE };
const section deep_demo = { .name = "deep", .sets = "deep-demo", .width = 320, .height = 180, .rounds = 1,
                            .of = { OF_DEEP, OF_DEEP_LIT }, .range = 0.3 };
const section deep_chart = { .name = "deep", .csv = "chart-deep.csv", .sets = "deep", .width = 320, .height = 180,
                             .stride = LIT_STRIDE, .rounds = QUICK_ROUNDS, .of = { OF_DEEP, OF_DEEP_LIT } };
