/* bands.h - how much of the difference between two pictures is seen as mottling: its size in bands of frequency, on
   smooth surfaces in shade. */
#ifndef LAB_BANDS_H
#define LAB_BANDS_H

#include "lab/measure/stage.h"

/* Band k lies between blurs k - 1 and k, of sigmas 1.2, 3, 8, 20 pixels; band 0 begins with the unblurred picture. */
enum { BANDS = 4 };

/* A pixel counts if it shows a surface, the 5x5 pixels around it lie in its tangent plane to within a pixel's
   footprint, its visibility is below SHADED, and it is at least BORDER pixels away from the picture's border. */
#define SHADED 0.97f
enum { BORDER = 24 };
/* The pixels of a frame that count. on: 1 at these, else 0; weight: on, blurred by each sigma. */
typedef struct shaded { int width, height; size_t pixels; float *on, *weight[BANDS]; } shaded;
/* Finds the pixels that count. visibility: a picture without noise. Returns -1 also if there are none. */
int  shaded_find(shaded *m, const stage *s, const kit_image *visibility, kit_error *err);
/* Finds them by visibility of hsao-best with 8 slices, before stage_compare. Returns 0 also if there are none. */
int  shaded_seen(shaded *m, const stage *s, kit_error *err);
void shaded_free(shaded *m);

/* The RMS of each band of a difference a - b of visibility, over these pixels. seen: that of bands 1 and 2 together, in
   which the eye notices patterns first. NAN: not known. */
typedef struct bands { double rms[BANDS], seen; } bands;
extern const bands bands_unknown;
/* A run's noise, from half of the squared differences of two phases. picture: that of the first phase. */
int  bands_noise(bands *out, const stage *s, kit_run *run, const shaded *m, const kit_image *picture, kit_error *err);
/* bands_off: a picture's error against two truths of kit_truth_pair, from which the truth's own noise cancels. By
   chance a mean square may be below 0; then its root counts as negative. bands_mean averages such figures. */
double bands_mean(const double *rms, int count);
int  bands_off(bands *out, const shaded *m, const kit_image *a, const kit_image *pair, kit_error *err);
int  bands_of(bands *out, const shaded *m, const kit_image *a, const kit_image *b, kit_error *err);

#endif
