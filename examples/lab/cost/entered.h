/* entered.h - measures which bodies pixels enter, on scenes by seed. */
#ifndef COST_ENTERED_H
#define COST_ENTERED_H

#include <stdio.h>
#include "kit/kit.h"

/* Draws the scenes by any GL and writes shares.csv: a row for each body of a method and each tile. */
int entered_write(FILE *f, kit_error *err);

#endif
