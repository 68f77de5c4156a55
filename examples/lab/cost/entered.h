/* entered.h - which bodies pixels enter, measured on scenes by seed. */
#ifndef COST_ENTERED_H
#define COST_ENTERED_H

#include <stdio.h>
#include "kit/kit.h"

/* Draws them, by whatever GL there is, and writes a csv: a row a body of a method and a tile. */
int entered_write(FILE *f, kit_error *err);

#endif
