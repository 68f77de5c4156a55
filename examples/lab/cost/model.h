/* model.h - milliseconds of named devices, by a model that can be worked out by hand. None of it is measured. */
#ifndef COST_MODEL_H
#define COST_MODEL_H

/* Of a device: what its maker prints of it, and how fast its parts are.

     alu      vector instructions, a lane and clock each; transcendental ones at a quarter of that, beside the others
              where a device has a unit for them (apart), else in their place
     tex      fetches a clock and compute unit, of 8 bytes at most; of 16 bytes (sebbbi's perftest)
     hide     the time of one wave, which waits 320 cycles for each fetch, over the waves that share its place
     memory   each byte once

   A pass takes as long as the slowest of the four. */
typedef struct device {
    const char *name, *family;             /* family: whose instructions it executes */
    int units, simds, lanes;               /* compute units; of each its SIMDs, and the lanes of one */
    double gigahertz, gigabytes;           /* the clock at best; of memory, a second */
    double fetches, wide_fetches;
    int apart;
} device;

extern const device devices[];
extern const int devices_count;

/* What a pass asks for: of a pixel, but waves, which share a SIMD, and bytes, which are of the pass. */
typedef struct load {
    double pixels, vector, transcendental, fetches, wide_fetches, bytes;
    int waves;
} load;

typedef enum bound { ALU, TEX, HIDE, MEMORY, BOUNDS } bound;
extern const char *const bound_names[BOUNDS];

/* Milliseconds; *which: what takes so long. */
double model(const device *d, const load *l, bound *which);

#endif
