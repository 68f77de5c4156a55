/* rmse.c - prints the RMSE between two pictures, PNG, PPM or PGM, over all channels, with values 0..1; for window.sh.
   GAMMA: A's values are first taken to that power: 2.2 for a picture encoded for screens.

      build/rmse A B [GAMMA] */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

int main(int argc, char **argv)
{
    int w[2], h[2], n;
    double sum = 0;
    unsigned char *p[2];
    const double gamma = argc == 4 ? strtod(argv[3], NULL) : 1;
    if ((argc != 3 && argc != 4) || !(gamma > 0)) { fputs("usage: rmse A B [GAMMA]\n", stderr); return 2; }
    for (int i = 0; i < 2; ++i) {
        p[i] = stbi_load(argv[1 + i], &w[i], &h[i], &n, 3);
        if (!p[i]) { fprintf(stderr, "rmse: %s: %s\n", argv[1 + i], stbi_failure_reason()); return 2; }
    }
    if (w[0] != w[1] || h[0] != h[1]) {
        fprintf(stderr, "rmse: %dx%d against %dx%d\n", w[0], h[0], w[1], h[1]);
        return 2;
    }
    for (int i = 0; i < 3 * w[0] * h[0]; ++i) sum += pow(pow(p[0][i] / 255.0, gamma) - p[1][i] / 255.0, 2);
    printf("%.5f\n", sqrt(sum / (3.0 * w[0] * h[0])));
    free(p[0]);
    free(p[1]);
    return 0;
}
