/* xegtao.h - XeGTAO as chains of make cost-peers, and its published times beside those of the model. */
#ifndef COST_XEGTAO_H
#define COST_XEGTAO_H

#include "lab/cost/passes.h"

/* Adds the chains, if xegtao.sh has compiled their passes. */
int xegtao_add(work *w, kit_error *err);
/* Writes the chains' rows as examples/docs/figures has them, if their passes are not here. */
void xegtao_keep(FILE *f);
/* Prints the published times beside the model's, if the passes are here, and adds them to a record. */
int xegtao_published(FILE *record, const work *w, kit_error *err);

#endif
