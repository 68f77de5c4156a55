/* peers.h - effects of other libraries as chains. */
#ifndef COST_PEERS_H
#define COST_PEERS_H

#include "lab/cost/passes.h"

/* Has peers.mjs (make peers) write down the passes of each effect at WIDTH x HEIGHT, and adds these as chains. */
int peers_add(work *w, kit_error *err);

#endif
