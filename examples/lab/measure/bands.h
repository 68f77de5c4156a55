/* bands.h - what of a difference between two pictures is seen as mottling: its size in bands of frequency, where a
   surface is smooth and in shade. */
#ifndef LAB_BANDS_H
#define LAB_BANDS_H

#include "lab/measure/stage.h"

/* Band k lies between Gaussians of so many pixels, of the first between the picture as it is and one: 1.2, 3, 8, 20. */
enum { BANDS = 4 };

/* Where the eye looks for mottling: a surface is seen, the 5x5 pixels about it lie in its tangent plane to a pixel's
   footprint, its visibility is below SHADED, and the picture's border is BORDER pixels away or more. */
#define SHADED 0.97f
enum { BORDER = 24 };
/* on: 1 there, else 0; weight: that blurred by each sigma. */
typedef struct shaded { int width, height; size_t pixels; float *on, *weight[BANDS]; } shaded;
/* visibility: a picture without noise. -1: there is no such pixel, too. */
int  shaded_find(shaded *m, const stage *s, const kit_image *visibility, kit_error *err);
/* The same by hsao-best of 8 directions; no pixels: nowhere. whole: the frame, all of it. */
int  shaded_seen(shaded *m, const stage *s, const kit_image *whole, kit_error *err);
void shaded_free(shaded *m);

/* RMS over those pixels of each band of a - b, channel Y; seen: of the second and third together, in which the eye
   finds patterns first. NAN: not known. */
typedef struct bands { double rms[BANDS], seen; } bands;
extern const bands bands_unknown;
/* picture: NULL, or the second and third band as 0.5 + 16 times it, to be looked at. */
/* Noise: half of the squared differences of two phases of a run, whose first one's picture is given. */
int  bands_noise(bands *out, const stage *s, kit_run *run, const shaded *m, const kit_image *picture, kit_error *err);
/* The same of a picture beside the truth, as kit_truth_pair has it: the truth's own noise is left out. Where chance
   has a mean square below 0 its root is negative: bands_mean takes the mean of such figures. */
double bands_mean(const double *rms, int count);
int  bands_off(bands *out, const shaded *m, const kit_image *a, const kit_image *pair, kit_error *err);
int  bands_of(bands *out, kit_image *picture, const shaded *m, const kit_image *a, const kit_image *b, kit_error *err);

#endif
