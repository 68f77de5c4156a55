/* model.h - milliseconds on named devices, by a model that can be worked out by hand. None of them is measured. */
#ifndef COST_MODEL_H
#define COST_MODEL_H

/* A device: figures that its maker publishes, and rates of its parts.

     alu      one vector instruction a lane and clock; transcendental ones take four clocks, at the same time if the
              device has a unit for them (apart), else in addition
     tex      fetches a clock and compute unit, up to 8 bytes; of 16 bytes (measured by sebbbi's perftest)
     hide     the time of one wave, which waits 320 cycles for each fetch, divided by the waves that share its SIMD
     memory   each byte once

   A pass takes as long as the slowest of the four. */
typedef struct device {
    const char *name, *family;             /* family: the GPU family whose instructions it executes */
    int units, simds, lanes;               /* compute units; SIMDs of each unit; lanes of each SIMD */
    double gigahertz, gigabytes;           /* highest clock in GHz; memory rate in GB a second */
    double fetches, wide_fetches;
    int apart;
} device;

extern const device devices[];
extern const int devices_count;             /* those of which tables have columns; others have published times alone */
const device *device_of(const char *name);  /* NULL: there is none */

/* The work of a pass. Instructions and fetches are those of one pixel; bytes those of the whole pass; waves: how many
   share a SIMD. */
typedef struct load {
    double pixels, vector, transcendental, fetches, wide_fetches, bytes;
    int waves;
} load;

typedef enum bound { ALU, TEX, HIDE, MEMORY, BOUNDS } bound;
extern const char *const bound_names[BOUNDS];

/* Returns the milliseconds that a device takes for a load; *which: the longest of the four times. */
double model(const device *d, const load *l, bound *which);

/* Modelled over published milliseconds: their geometric mean, the least and the most. */
typedef struct trust { double mean, least, most; } trust;
trust trust_of(const double *modelled, const double *published, int count);

#endif
