/* spread.h - what many scenes say together of one figure: its mean and how certain that is, its median, its worst. */
#ifndef LAB_SPREAD_H
#define LAB_SPREAD_H

enum { MOST_SPREAD = 1000 };                 /* values */
/* count: of what is known. half: of the mean's 95 % interval, 1.96 standard errors; NAN of one alone. worst: which of
   the values is most; -1 = there is none. above: how many exceed 1. */
typedef struct spread { int count, above, worst; double mean, half, median, most; } spread;

/* Of count values, at most MOST_SPREAD; NAN is not known. */
spread spread_of(const double *value, int count);
/* Of those whose group is one alone; worst counts among all. */
spread spread_in(const double *value, const int *group, int one, int count);

#endif
