/* fuzz_files.c - reads damaged pictures under the sanitizers: EXR files by the kit and by OpenEXR (every compression,
   rows and tiles), and Radiance files, with bytes changed, taken out, doubled, or exchanged with another file's.

     build/fuzz-files 600 [seed]           for so many seconds
     build/fuzz-files 5000x [seed]         so many of them

   Each is read within seconds, or refused in a sentence that names it, and then the picture is untouched. If not:
   status 1, and the damaged file stays in its folder. */
#include "kit/kit.h"
#include "others.h"

#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SAMPLES = 64, ROOM = 1 << 16, SECONDS = 30 };

static struct { unsigned char *data; size_t size; int hdr; } sample[SAMPLES];
static int samples;
static long cameras;
static char path[2][512];                       /* .exr, .hdr */
static uint64_t state;

static uint32_t random_below(uint32_t n)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)((state >> 32) * n >> 32);
}

_Noreturn static void stop(const char *what, const char *why)
{
    printf("fuzz-files: %s: %s\n", what, why);
    exit(1);
}

/* ---- samples ------------------------------------------------------------------------------------------------- */

static void keep(int hdr)
{
    kit_error err;
    char *data;
    if (samples == SAMPLES || kit_file_read(&data, &sample[samples].size, path[hdr], &err))
        stop(path[hdr], "no sample");
    sample[samples].data = (unsigned char *)data;
    sample[samples++].hdr = hdr;
}

/* Returns a texel: smooth in the left half, noise in the right, so that some chunks compress, and some do not. */
static float texel(int i, int width)
{
    return i % width < width / 2 ? (float)(i / width) / 8 : (float)random_below(1u << 24) / 65536;
}

/* Writes an EXR file by the kit. orthographic: 0, 1; below 0: the header has no camera */
static void by_the_kit(int width, int height, const char *names, int orthographic)
{
    const kit_header header = { .has = orthographic < 0 ? 0 : KIT_HEADER_ALL, .orthographic = orthographic, .height = 2,
                                .world_to_camera = { 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, -3, -2, -1, 1 }, .radius = 3 };
    kit_image image;
    kit_error err = { "" };
    if (kit_image_new(&image, width, height, names, &err)) stop("sample", err.text);
    for (int i = 0; i < width * height * image.channels; ++i) image.data[i] = texel(i, width);
    if (kit_exr_write_frame(&image, &header, path[0], &err)) stop("sample", err.text);
    kit_image_free(&image);
    keep(0);
}

static void by_others(int width, int height, int compression, int tile)
{
    ImfRgba *pixels = malloc(sizeof *pixels * (size_t)(width * height));
    for (int i = 0; pixels && i < width * height; ++i)
        pixels[i] = others_pixel(texel(i, width), texel(i + 7, width), 0.25f, 1);
    if (!pixels || others_write(path[0], width, height, compression, tile, pixels)) stop("sample", ImfErrorMessage());
    free(pixels);
    keep(0);
}

/* Writes a Radiance file: rows without a code, or each of the four components in runs of three. */
static void radiance(int width, int height, int coded)
{
    static unsigned char bytes[ROOM];
    size_t n = (size_t)snprintf((char *)bytes, sizeof bytes, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1\n\n-Y %d "
                                "+X %d\n", height, width);
    for (int y = 0; y < height; ++y) {
        const unsigned char head[4] = { 2, 2, (unsigned char)(width >> 8), (unsigned char)width };
        memcpy(bytes + n, head, sizeof head);
        n += coded ? sizeof head : 0;
        for (int x = 0; x < 4 * width; x += coded ? 3 : 1) {
            if (coded) bytes[n++] = 128 + 3;
            bytes[n++] = (unsigned char)(128 + random_below(100));
        }
    }
    kit_error err;
    if (kit_file_write(path[1], bytes, n, &err)) stop("sample", err.text);
    keep(1);
}

static void make_samples(void)
{
    by_the_kit(1, 1, "Y", -1);
    by_the_kit(8, 37, "Y", -1);
    by_the_kit(33, 20, "R,G,B,irradiance.R,irradiance.G,irradiance.B,bounce.R,bounce.G,bounce.B", -1);
    by_the_kit(17, 33, "Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B", 0);
    by_the_kit(5, 3, "Z", 0);
    by_the_kit(5, 3, "Z", 1);
    for (int c = IMF_NO_COMPRESSION; c <= IMF_B44A_COMPRESSION; ++c) {
        by_others(29, 35, c, 0);
        by_others(29, 35, c, 16);
    }
    radiance(5, 7, 0);
    radiance(9, 6, 1);
    radiance(300, 4, 1);
}

/* ---- damage -------------------------------------------------------------------------------------------------- */

/* Returns a random place in a file. Half of them are in its first bytes, where the header is. */
static size_t place(size_t size)
{
    const size_t head = size < 600 ? size : 600;
    return random_below(2) ? random_below((uint32_t)head) : random_below((uint32_t)size);
}

static size_t damage(unsigned char *data, size_t size)
{
    static const uint32_t numbers[] = { 0, 1, 127, 128, 255, 32767, 65536, 0x7fffffff, 0x80000000, 0xffffffff,
                                        0x7f800000 };
    const size_t at = place(size), n = 1 + random_below(random_below(4) ? 4 : 64);
    const size_t here = n < size - at ? n : size - at;
    const uint32_t number = numbers[random_below(sizeof numbers / sizeof *numbers)];
    switch (random_below(6)) {
    case 0: data[at] ^= (unsigned char)(1u << random_below(8)); return size;
    case 1: data[at] = (unsigned char)(data[at] + random_below(9) - 4); return size;
    case 2: memcpy(data + at, &number, here < 4 ? here : 4); return size;
    case 3: return random_below(4) || at < 8 ? size : at;                       /* cut off */
    case 4:                                                                    /* taken out */
        memmove(data + at, data + at + here, size - at - here);
        return size - here ? size - here : size;
    default: {                                                                 /* another file's bytes */
        const int other = (int)random_below((uint32_t)samples);
        const size_t from = place(sample[other].size), left = sample[other].size - from;
        memcpy(data + at, sample[other].data + from, here < left ? here : left);
        return size;
    }
    }
}

static void too_long(int number)
{
    static const char text[] = "fuzz-files: a picture takes too long\n";
    (void)number;
    if (write(1, text, sizeof text - 1) > 0) _exit(1);
    _exit(1);
}

/* Checks that a header's camera can be drawn with, or is refused with a sentence. */
static void read_header(const char *now)
{
    kit_header header = { .has = -7 };
    kit_camera camera = { .eye = { 1, 0, 0 }, .up = { 0, 1, 0 }, .fovy = 50, .width = 4, .height = 3, .znear = 1,
                          .zfar = 2 };
    float matrix[2][16];
    kit_error err = { "" };
    if (kit_exr_header(&header, KIT_HEADER_ALL, now, &err)) {
        if (header.has != -7) stop(now, "the header was touched");
        if (strncmp(err.text, now, strlen(now)) || strlen(err.text) < strlen(now) + 5) stop(now, err.text);
        return;
    }
    cameras += header.has != 0;
    kit_camera_from_header(&camera, &header);
    kit_camera_matrices(&camera, matrix[0], matrix[1]);
    for (int i = 0; i < 32; ++i) if (!isfinite(matrix[i / 16][i % 16])) stop(now, "a camera that is none");
    if (!(camera.fovy > 0 ? camera.fovy < 180 : camera.ortho_height > 0)) stop(now, "a window that is none");
    if (header.has & KIT_HEADER_RADIUS && !(header.radius > 0)) stop(now, "a radius that is none");
}

/* Reads a picture, EXR or Radiance. Returns 1 if that succeeds. */
static int read_one(int hdr)
{
    kit_image image = { .width = -7 };
    kit_error err = { "" };
    const char *now = path[hdr];
    alarm(SECONDS);
    const int failed = hdr ? kit_hdr_read(&image, now, &err) : kit_exr_read(&image, now, &err);
    if (!hdr) read_header(now);
    alarm(0);
    if (failed) {
        if (image.width != -7 || image.data) stop(now, "the picture was touched");
        if (strncmp(err.text, now, strlen(now)) || strlen(err.text) < strlen(now) + 5) stop(now, err.text);
        return 0;
    }
    double sum = 0;
    for (size_t i = 0, n = (size_t)image.width * (size_t)image.height * (size_t)image.channels; i < n; ++i)
        sum += (double)image.data[i];
    if (image.width < 1 || image.height < 1 || image.channels < 1 || (hdr && !(sum >= 0))) stop(now, "nonsense");
    kit_image_free(&image);
    return 1;
}

static void fuzz(double seconds, long most)
{
    static unsigned char data[ROOM];
    const double began = kit_seconds();
    long tried = 0, read = 0;
    signal(SIGALRM, too_long);
    make_samples();
    for (; tried < most && kit_seconds() - began < seconds; ++tried) {
        const int which = (int)random_below((uint32_t)samples), hdr = sample[which].hdr;
        size_t size = sample[which].size;
        memcpy(data, sample[which].data, size);
        for (uint32_t k = random_below(4) + 1; k--;) size = damage(data, size);
        FILE *file = fopen(path[hdr], "wb");
        if (!file || fwrite(data, 1, size, file) != size || fclose(file)) stop(path[hdr], "cannot be written");
        read += read_one(hdr);
    }
    for (int i = 0; i < samples; ++i) free(sample[i].data);
    printf("%ld damaged pictures of %d: %ld read, %ld refused; %ld cameras\n", tried, samples, read, tried - read,
           cameras);
}

int main(int argc, char **argv)
{
    char *end = NULL;
    const double n = argc > 1 ? strtod(argv[1], &end) : 0;
    const char *const temporary = getenv("TMPDIR");
    char folder[256];
    if (!(n > 0)) {
        fputs("usage: fuzz-files SECONDS | Nx [seed]\n", stderr);
        return 2;
    }
    state = argc > 2 ? strtoull(argv[2], NULL, 0) : 1;
    snprintf(folder, sizeof folder, "%s/fuzz-files-XXXXXX", temporary && *temporary ? temporary : "/tmp");
    if (!mkdtemp(folder)) stop(folder, "no folder can be made");
    snprintf(path[0], sizeof path[0], "%s/a.exr", folder);
    snprintf(path[1], sizeof path[1], "%s/a.hdr", folder);
    fuzz(*end == 'x' ? 1e9 : n, *end == 'x' ? (long)n : 2000000000);
    unlink(path[0]);
    unlink(path[1]);
    rmdir(folder);
    return 0;
}
