/* rows.c - makes a row without results. Declared in rows.h. */
#include "lab/measure/rows.h"
#include <math.h>

row row_blank(int of, const char *scene, const char *label, const char *method, const char *settings)
{
    const double none = (double)NAN;
    row r = { .scene = scene,
              .label = label,
              .method = method,
              .settings = settings,
              .bytes = none,
              .relative = none,
              .ms = none,
              .share = none,
              .score = { none, none, none, none, 0 },
              .of = of };
    for (int k = 0; k < 3; ++k) r.error[k] = r.bias[k] = none;
    for (int k = 0; k < SPLITS; ++k) r.split[k] = none;
    for (int k = 0; k < FIGURES; ++k) r.figure[k] = none;
    return r;
}
