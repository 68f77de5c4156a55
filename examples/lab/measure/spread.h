/* spread.h - statistics of one figure over many scenes: its mean and the interval of that, its median, its worst. */
#ifndef LAB_SPREAD_H
#define LAB_SPREAD_H

enum { MOST_SPREAD = 1000 };                 /* values */
/* Statistics of one figure. count: of known values. half: of the mean's 95 % interval, 1.96 standard errors; NAN for a
   single value. worst: the index of the largest value; -1 = there is none. above: how many values exceed 1. */
typedef struct spread { int count, above, worst; double mean, half, median, most; } spread;

/* Returns the statistics of count values, at most MOST_SPREAD; NAN: a value is not known. */
spread spread_of(const double *value, int count);

#endif
