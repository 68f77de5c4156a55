/* peers.h - adds effects of other libraries as chains of make cost. */
#ifndef COST_PEERS_H
#define COST_PEERS_H

#include "lab/cost/passes.h"

/* Runs peers.mjs (make peers), which writes down each effect's passes at WIDTH x HEIGHT, and adds them as chains. */
int peers_add(work *w, kit_error *err);

#endif
