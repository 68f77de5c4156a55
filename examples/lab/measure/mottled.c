/* mottled.c - a row's noise and error in bands of frequency. Declared in mottled.h. */
#include "lab/measure/mottled.h"

int mottled_open(mottled *m, const stage *s, kit_error *err)
{
    *m = (mottled){ .pair = { .data = NULL } };
    return shaded_seen(&m->smooth, s, err) || (!s->lit && stage_pair(&m->pair, s, err)) ? -1 : 0;
}

void mottled_close(mottled *m)
{
    shaded_free(&m->smooth);
    kit_image_free(&m->pair);
}

int mottled_bands(bands *noise, bands *off, const mottled *m, stage *s, kit_run *run, const kit_image *picture,
                  kit_error *err)
{
    *noise = *off = bands_unknown;
    if (!m->smooth.pixels) return 0;
    return bands_off(off, &m->smooth, picture, &m->pair, err) || bands_noise(noise, s, run, &m->smooth, picture, err)
               ? -1
               : 0;
}

int mottled_row(row *r, const mottled *m, stage *s, kit_error *err)
{
    kit_image picture = { 0 };
    kit_run run;
    bands noise, off;
    if (!m->smooth.pixels) return 0;
    if (stage_run(&run, s, r->method, r->settings, s->radius, err)) return -1;
    const int failed = stage_settled(&picture, s, &run, 0, 0, err)
                    || mottled_bands(&noise, &off, m, s, &run, &picture, err);
    for (int k = 0; k < BANDS && !failed; ++k) {
        r->figure[NOISE_BAND + k] = 1e3 * noise.rms[k];
        r->figure[ERROR_BAND + k] = 1e3 * off.rms[k];
    }
    kit_image_free(&picture);
    kit_run_close(&run);
    return failed ? -1 : 0;
}
