/* spread.c - statistics of one figure over many scenes. Declared in spread.h. */
#include "lab/measure/spread.h"
#include <math.h>
#include <stdlib.h>
#include "kit/kit.h"

spread spread_of(const double *value, int count)
{
    double known[MOST_SPREAD], squares = 0;
    spread s = { 0, 0, -1, 0, (double)NAN, (double)NAN, (double)NAN };
    for (int i = 0; i < count; ++i) {
        if (isnan(value[i]) || s.count == MOST_SPREAD) continue;
        known[s.count++] = value[i];
        s.mean += value[i];
        s.above += value[i] > 1;
        if (s.worst < 0 || value[i] > s.most) { s.most = value[i]; s.worst = i; }
    }
    s.mean = s.count ? s.mean / s.count : (double)NAN;
    for (int i = 0; i < s.count; ++i) squares += (known[i] - s.mean) * (known[i] - s.mean);
    if (s.count > 1) s.half = 1.96 * sqrt(squares / (s.count - 1) / s.count);
    if (s.count) s.median = kit_median(known, s.count);
    return s;
}
