/* starve.c - what reads and writes pictures, when memory runs out: each allocation fails in its turn, those of OpenEXR,
   zlib and the C library too, for malloc is this program's own.

     build/starve FOLDER [how many allocations are passed over at a time, 1]

   Each ends in one sentence that names the file and memory, or in the right picture: never in a hang, with another
   picture, with a file half written or left over. The last line is "N failures, M wrong"; status 1 if any is. */
#include "kit/kit.h"
#include "others.h"

#include <dirent.h>
#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *data, size_t size);

static long until;                              /* allocations until the one that fails; 0: none will */

static int fails(void)
{
    if (!until || --until) return 0;
    errno = ENOMEM;
    return 1;
}

void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *data, size_t size) { return fails() ? NULL : __libc_realloc(data, size); }

enum { WIDE = 20, HIGH = 40, SECONDS = 10, MOST_WRONG = 5 };     /* 40 rows: three chunks; seconds of a hang */

static kit_image picture;

static int write_exr(kit_image *none, const char *path, kit_error *err)
{
    (void)none;
    return kit_exr_write(&picture, path, err);
}

/* What the header says, as if it were pixels. */
static int read_header(kit_image *image, const char *path, kit_error *err)
{
    kit_header header;
    if (kit_exr_header(&header, KIT_HEADER_ALL, path, err)) return -1;
    *image = (kit_image){ .width = (int)(sizeof header / sizeof(float)), .height = 1, .channels = 1 };
    image->data = __libc_malloc(sizeof header);
    memcpy(image->data, &header, sizeof header);
    return 0;
}

static int write_png(kit_image *none, const char *path, kit_error *err)
{
    (void)none;
    return kit_png_write(&picture, "R,G,B", 1, path, err);
}

/* Half floats. DWAA: what the C core of OpenEXR 3.1 does not decompress. PXR24: what it takes for ZIP, and finds as
   long as that would be, when the header lacks that line. */
static int write_others(const char *path, int compression)
{
    ImfRgba pixels[WIDE * HIGH];
    for (int i = 0; i < WIDE * HIGH; ++i) pixels[i] = others_pixel((float)i, (float)(i % WIDE), 0.5f, 1);
    return others_write(path, WIDE, HIGH, compression, 0, pixels);
}

static const struct work {
    const char *file;
    int       (*run)(kit_image *image, const char *path, kit_error *err);
    int         writes;
} works[] = { { "out.exr", write_exr, 1 },      { "out.png", write_png, 1 },       { "in.exr", kit_exr_read, 0 },
              { "pxr24.exr", kit_exr_read, 0 }, { "dwaa.exr", kit_exr_read, 0 }, { "in.hdr", kit_hdr_read, 0 },
              { "frame.exr", read_header, 0 } };
enum { WORKS = sizeof works / sizeof *works };

/* Of a file, or of the picture that was read: what it should be again. */
static uint64_t result_of(const struct work *work, const kit_image *image)
{
    char *data;
    size_t size;
    uint64_t hash;
    if (!work->writes)
        return kit_hash(kit_hash(KIT_HASH, image->name, sizeof image->name), image->data,
                        sizeof(float) * (size_t)image->channels * (size_t)image->width * (size_t)image->height);
    if (kit_file_read(&data, &size, work->file, NULL)) return 0;
    hash = kit_hash(KIT_HASH, data, size);
    free(data);
    return hash;
}

static int files_here(void)
{
    DIR *here = opendir(".");
    int count = 0;
    while (here && readdir(here)) ++count;
    if (here) closedir(here);
    return count;
}

/* In a process of its own: 0 = right, 1 = wrong, 2 = there are fewer allocations than this. */
static int one(const struct work *work, long failing, uint64_t right)
{
    static const char old[] = "old";
    kit_image image = { .width = -7 };
    kit_error err = { "" };
    if (work->writes && kit_file_write(work->file, old, sizeof old, NULL)) return 1;
    const int files = files_here();
    until = failing;
    const int failed = work->run(&image, work->file, &err);
    const int reached = !until;
    until = 0;
    const char *wrong = NULL;
    if (files_here() != files) wrong = "a file was left over or is gone";
    else if (!failed && result_of(work, &image) != right) wrong = "the result is another";
    else if (failed && work->writes && result_of(work, &image) != kit_hash(KIT_HASH, old, sizeof old))
        wrong = "the old file was touched";
    else if (failed && (image.width != -7 || image.data)) wrong = "the picture was touched";
    else if (failed && (strncmp(err.text, work->file, strlen(work->file)) || !strstr(err.text, "memory")))
        wrong = "not a sentence on the file and memory";
    if (wrong) printf("%s, allocation %ld: %s: \"%s\"\n", work->file, failing, wrong, err.text);
    fflush(stdout);
    return wrong ? 1 : reached ? 0 : 2;
}

static int in_child(const struct work *work, long failing, uint64_t right, const sigset_t *ended)
{
    static const struct timespec limit = { SECONDS, 0 };
    int status;
    fflush(stdout);
    const pid_t child = fork();
    if (child < 0) return 1;
    if (!child) _exit(one(work, failing, right));
    if (sigtimedwait(ended, NULL, &limit) < 0) kill(child, SIGKILL);
    if (waitpid(child, &status, 0) != child) return 1;
    if (WIFEXITED(status)) return WEXITSTATUS(status);
    printf("%s, allocation %ld: %s\n", work->file, failing, WTERMSIG(status) == SIGKILL ? "hangs" : "crashes");
    return 1;
}

int main(int argc, char **argv)
{
    static const char hdr[] = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x40\x20\x81\x80\x40\x20\x81";
    static const kit_header header = { .has = KIT_HEADER_ALL, .height = 2, .radius = 3, .orthographic = 1,
                                       .world_to_camera = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1 } };
    const long step = argc > 2 ? atol(argv[2]) : 1;
    kit_error err = { "" };
    sigset_t ended;
    int failures = 0, wrong = 0;
    if (argc < 2 || step < 1 || chdir(argv[1])) { fputs("usage: starve FOLDER [step]\n", stderr); return 2; }
    sigemptyset(&ended);
    sigaddset(&ended, SIGCHLD);
    sigprocmask(SIG_BLOCK, &ended, NULL);
    int bad = kit_image_new(&picture, WIDE, HIGH, "R,G,B", &err);
    for (int i = 0; i < 3 * WIDE * HIGH && !bad; ++i) picture.data[i] = (float)(i % 97) / 97;
    bad = bad || kit_exr_write(&picture, "in.exr", &err) || kit_exr_write_frame(&picture, &header, "frame.exr", &err)
       || write_others("dwaa.exr", IMF_DWAA_COMPRESSION)
       || write_others("pxr24.exr", IMF_PXR24_COMPRESSION)
       || kit_file_write("in.hdr", hdr, sizeof hdr - 1, &err);
    for (int w = 0; w < WORKS && !bad; ++w) {
        kit_image image = { 0 };
        if ((bad = works[w].run(&image, works[w].file, &err)) != 0) break;
        const uint64_t right = result_of(&works[w], &image);
        kit_image_free(&image);
        for (long failing = 1; wrong < MOST_WRONG; failing += step) {
            const int is = in_child(&works[w], failing, right, &ended);
            if (is == 2) break;
            ++failures;
            wrong += is;
        }
    }
    kit_image_free(&picture);
    if (bad) { fprintf(stderr, "starve: %s\n", err.text); return 2; }
    printf("%d failures, %d wrong\n", failures, wrong);
    return wrong != 0;
}
