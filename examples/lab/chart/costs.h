/* costs.h - what each pass and each choice costs in instructions and fetches. Writes costs.csv. */
#ifndef LAB_COSTS_H
#define LAB_COSTS_H

#include "lab/page/units.h"

int costs_chart(FILE *html, const char *out, kit_error *err);

#endif
