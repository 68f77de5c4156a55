/* test_files.c - files in and out, scores, objects, threads: the kit's util.c, image.c, places.c, mesh.c, scene.c and
   light.c. fuzz_files.c reads damaged pictures under sanitizers. */
#include "others.h"
#include "owned.h"
#include "shell.h"

#include <math.h>
#include <OpenEXR/openexr.h>
#include <sys/stat.h>

static void put(const char *name, const void *bytes, size_t size)
{
    CHECK(!kit_file_write(in_folder(name), bytes, size, NULL), "%s cannot be made", name);
}

/* Reads a file of less than 64 kB into bytes. Returns its size. */
static size_t get(const char *name, char bytes[65536])
{
    FREED char *data = NULL;
    size_t size;
    if (kit_file_read(&data, &size, in_folder(name), NULL) || size > 65536) return 0;
    memcpy(bytes, data, size);
    return size;
}

/* Checks that a call failed with one line that names the file. */
static void check_error(int result, const kit_error *err, const char *name, const char *about)
{
    CHECK(result == -1, "%s: accepted", about);
    CHECK(strstr(err->text, name) != NULL, "%s: the error does not name %s: \"%s\"", about, name, err->text);
    CHECK(strlen(err->text) > strlen(in_folder(name)) + 3 && !strchr(err->text, '\n'), "%s: not one clear line: \"%s\"",
          about, err->text);
}

/* ---- EXR --------------------------------------------------------------------------------------------------------- */

static float sample(int c, int i)               /* a value that reveals an exchanged channel, row or bit */
{
    static const float odd[] = { 0, -0.0f, 1e-42f, 3.4e38f, -INFINITY, INFINITY };
    if (i % 11 < 6) return odd[(i + c) % 6];
    return (float)sin(i * 0.7 + c) * 100;
}

static void sample_image(kit_image *image, int width, int height, const char *names)
{
    kit_error err = {{0}};
    if (!CHECK(!kit_image_new(image, width, height, names, &err), "%s", err.text)) exit(1);
    for (int c = 0; c < image->channels; ++c)
        for (int i = 0; i < width * height; ++i) image->data[c * width * height + i] = i == 5 + c ? NAN : sample(c, i);
}

static void exr_round_trip(void)
{
    static const char *const names[] = { "Z", "N.Y", "A", "layer1.N.X", "R", "G", "B" };  /* not in the file's order */
    OWN(kit_image) a = { 0 }, b = { 0 };
    kit_error err = {{0}};
    size_t size = 53 * 37 * sizeof(float);      /* 37 rows, so that the last ZIP chunk has 5 */
    sample_image(&a, 53, 37, "Z,N.Y,A,layer1.N.X,R,G,B");
    CHECK(!kit_exr_write(&a, in_folder("a.exr"), &err), "%s", err.text);
    if (!CHECK(!kit_exr_read(&b, in_folder("a.exr"), &err), "%s", err.text)) return;
    CHECK(b.width == 53 && b.height == 37 && b.channels == 7, "%d x %d, %d channels", b.width, b.height, b.channels);
    for (int c = 0; c < 7; ++c) {
        const float *channel = kit_image_channel(&b, names[c]);
        CHECK(channel && !memcmp(channel, kit_image_channel(&a, names[c]), size), "channel %s differs", names[c]);
    }
    CHECK(!kit_image_channel(&b, "N"), "a channel was found by half its name");
    kit_image_free(&b);
    kit_image_free(&b);
}

/* Returns the value of a part's pixel, 1000 part + 20 y + x; the parts' windows differ. */
static float of_part(int part, int x, int y) { return (float)(1000 * part + 20 * y + x); }

static const struct { const char *name, *view, *channel, *read; int min[2], max[2]; } several[] = {
    { "colour", "right", "R", "R", { 2, 1 }, { 9, 6 } },  { "left", "left", "Z", NULL, { 0, 0 }, { 9, 6 } },
    { "depth", "right", "Z", "Z", { 4, 3 }, { 12, 4 } },  { "albedo", "right", "R", "albedo.R", { 3, 2 }, { 5, 8 } },
};
enum { SEVERAL = (int)(sizeof several / sizeof *several) };

static void write_several(const char *path)
{
    exr_context_t context = NULL;
    const exr_attr_v2f_t centre = {{{ 0, 0 }}};
    exr_chunk_info_t chunk;
    float row[16];
    int part, result = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, NULL);
    for (int i = 0; i < SEVERAL; ++i) {
        const exr_attr_box2i_t all = { .max = {{{ 19, 9 }}} },
                               window = { .min = {{{ several[i].min[0], several[i].min[1] }}},
                                          .max = {{{ several[i].max[0], several[i].max[1] }}} };
        result |= exr_add_part(context, several[i].name, EXR_STORAGE_SCANLINE, &part);
        result |= exr_initialize_required_attr(context, i, &all, &window, 1, &centre, 1, EXR_LINEORDER_INCREASING_Y,
                                               EXR_COMPRESSION_NONE);
        result |= exr_attr_set_string(context, i, "view", several[i].view);
        result |= exr_add_channel(context, i, several[i].channel, EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LINEAR, 1, 1);
        if (!i) result |= exr_attr_set_float(context, i, "ssgi.orthoHeight", 10);
    }
    result |= exr_write_header(context);
    for (int i = 0; i < SEVERAL; ++i)
        for (int y = several[i].min[1]; y <= several[i].max[1]; ++y) {
            for (int x = several[i].min[0]; x <= several[i].max[0]; ++x) row[x - several[i].min[0]] = of_part(i, x, y);
            result |= exr_write_scanline_chunk_info(context, i, y, &chunk);
            result |= exr_write_scanline_chunk(context, i, y, row,
                                               sizeof *row * (size_t)(several[i].max[0] - several[i].min[0] + 1));
        }
    result |= exr_finish(&context);
    CHECK(!result, "the file of parts could not be made: %s", exr_get_default_error_message(result));
}

static void exr_of_parts(void)
{
    OWN(kit_image) image = { 0 };
    kit_header header;
    kit_error err = {{0}};
    write_several(in_folder("parts.exr"));
    if (!CHECK(!kit_exr_read(&image, in_folder("parts.exr"), &err), "%s", err.text)) return;
    CHECK(image.width == 11 && image.height == 8 && image.channels == 3, "%d x %d of %d channels", image.width,
          image.height, image.channels);
    for (int i = 0; i < SEVERAL; ++i) {
        const float *is = several[i].read ? kit_image_channel(&image, several[i].read) : NULL;
        if (!CHECK(is || !several[i].read, "there is no %s", several[i].read)) continue;
        for (int k = 0; is && k < 11 * 8; ++k) {
            const int x = 2 + k % 11, y = 1 + k / 11,
                      in = x >= several[i].min[0] && x <= several[i].max[0] && y >= several[i].min[1]
                        && y <= several[i].max[1];
            CHECK(is[k] == (in ? of_part(i, x, y) : 0), "%s at %d, %d: %g", several[i].read, x, y, (double)is[k]);
        }
    }
    /* 8 of 10 rows, each 1 high; columns 2 to 12 of 0 to 19, rows 1 to 8 of 0 to 9 */
    CHECK(!kit_exr_header(&header, KIT_HEADER_WINDOW, in_folder("parts.exr"), &err) && header.height == 8
              && header.centre[0] == -2.5f && header.centre[1] == 0,
          "its window: %g high, at %g, %g", (double)header.height, (double)header.centre[0], (double)header.centre[1]);
}

/* Cuts a file after every step-th byte, and checks that the reader refuses each with one line. */
static void cut(const char *name, size_t step, int (*read)(kit_image *image, const char *path, kit_error *err))
{
    static char bytes[65536];
    kit_image untouched = { .width = -7 };
    const size_t size = get(name, bytes);
    CHECK(size > step, "%s is not there", name);
    for (size_t n = 1; n < size; n += step) {
        kit_error err = {{0}};
        put("cut", bytes, n);
        check_error(read(&untouched, in_folder("cut"), &err), &err, "cut", name);
        if (!CHECK(untouched.width == -7 && !untouched.data, "%zu of %zu bytes of %s: the picture was touched", n, size,
                   name))
            return;
    }
}

static void exr_truncated(void)
{
    OWN(kit_image) a = { 0 };
    sample_image(&a, 19, 40, "Y,Z");
    CHECK(!kit_exr_write(&a, in_folder("a.exr"), NULL), "cannot write");
    cut("a.exr", 29, kit_exr_read);
}

static void exr_bad(void)
{
    static const char *const bad[][2] = {
        { "absent.exr", "" }, { "folder.exr", "" }, { "empty.exr", "" }, { "deep.exr", "deep EXR" }
    };
    int part;
    exr_context_t context = NULL;               /* linked, because OpenEXR removes files without pixels */
    mkdir(in_folder("folder.exr"), 0777);
    put("empty.exr", "", 0);
    exr_start_write(&context, in_folder("deep"), EXR_WRITE_FILE_DIRECTLY, NULL);
    exr_add_part(context, "x", EXR_STORAGE_DEEP_SCANLINE, &part);
    exr_initialize_required_attr_simple(context, 0, 4, 4, EXR_COMPRESSION_ZIPS);
    exr_add_channel(context, 0, "Z", EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LINEAR, 1, 1);
    exr_write_header(context);
    CHECK(!link(in_folder("deep"), in_folder("deep.exr")), "no deep file");
    exr_finish(&context);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_image untouched = { .width = -7 };
        kit_error err = {{0}};
        check_error(kit_exr_read(&untouched, in_folder(bad[i][0]), &err), &err, bad[i][0], bad[i][0]);
        CHECK(untouched.width == -7 && strstr(err.text, bad[i][1]), "%s: \"%s\"", bad[i][0], err.text);
    }
}

/* Changes the file's data window to width x height from (0, 0). */
static void claim(const char *name, int32_t width, int32_t height)
{
    static char bytes[65536];
    const int32_t window[4] = { 0, 0, width - 1, height - 1 };
    const size_t size = get(name, bytes);
    for (size_t i = 0; i + 60 < size; ++i)      /* "dataWindow", "box2i", 16, min, max */
        if (!memcmp(bytes + i, "dataWindow", 11)) memcpy(bytes + i + 11 + 6 + 4, window, sizeof window);
    put(name, bytes, size);
}

/* Checks that pictures by OpenEXR's C++ are read in every compression, in rows and in tiles. If a header claims more
   pixels than its bytes can hold, it must be refused before memory is allocated. */
static void exr_claims(void)
{
    enum { WIDE = 36, HIGH = 20 };
    ImfRgba pixels[WIDE * HIGH];
    kit_image image, untouched = { .width = -7 };
    kit_error err = {{0}};
    for (int i = 0; i < WIDE * HIGH; ++i)
        pixels[i] = others_pixel((float)(i % WIDE), (float)(i / WIDE), 1, 1);
    for (int c = IMF_NO_COMPRESSION; c <= IMF_B44A_COMPRESSION; ++c)
        for (int tile = 0; tile <= 16; tile += 16) {
            if (!CHECK(!others_write(in_folder("one.exr"), WIDE, HIGH, c, tile, pixels), "%s", ImfErrorMessage())
                || !CHECK(!kit_exr_read(&image, in_folder("one.exr"), &err), "compression %d, tiles of %d: %s", c, tile,
                          err.text)) continue;
            const float *r = kit_image_channel(&image, "R"), *g = kit_image_channel(&image, "G");
            double off = 0;
            for (int i = 0; i < WIDE * HIGH; ++i)
                off = fmax(off, fabs((double)r[i] - i % WIDE) + fabs((double)g[i] - i / WIDE));
            CHECK(image.width == WIDE && image.height == HIGH && off < (c >= IMF_B44_COMPRESSION ? 1 : 1e-6),
                  "compression %d, tiles of %d: off by %g", c, tile, off);
            kit_image_free(&image);
            claim("one.exr", 16384, 16384);
            check_error(kit_exr_read(&untouched, in_folder("one.exr"), &err), &err, "one.exr", "a claim");
            CHECK(untouched.width == -7 && strstr(err.text, "claims 16384 x 16384"), "compression %d, tiles of %d: "
                  "\"%s\"", c, tile, err.text);
        }
    others_write(in_folder("dwa.exr"), WIDE, HIGH, IMF_DWAA_COMPRESSION, 0, pixels);
    check_error(kit_exr_read(&untouched, in_folder("dwa.exr"), &err), &err, "dwa.exr", "its compression");
}

/* Overwrites bytes of a file, so many bytes after the first place of a text. Returns 0 if the text is not in it. */
static int patch(const char *name, const char *text, size_t after, const void *bytes, size_t count)
{
    static char file[65536];
    const size_t size = get(name, file), length = strlen(text);
    for (size_t i = 0; i + length + after + count < size; ++i)
        if (!memcmp(file + i, text, length)) {
            memcpy(file + i + length + after, bytes, count);
            put(name, file, size);
            return 1;
        }
    return 0;
}

static int frame_written(const char *name, const kit_header *header)
{
    OWN(kit_image) image = { 0 };
    kit_error err = {{0}};
    sample_image(&image, 8, 6, "Z");
    const int ok = CHECK(!kit_exr_write_frame(&image, header, in_folder(name), &err), "%s", err.text);
    return ok;
}

/* Returns the distance in pixels between points that pixel (x, y) of a and (x + dx, y + dy) of b show. */
static double astray(const kit_camera *a, const kit_camera *b, int dx, int dy)
{
    double most = 0;
    for (int k = 0; k < 9; ++k) {
        float p[3], q[3], side[3];
        const int x = k % 3 * 4, y = k / 3 * 3;
        kit_camera_point(a, x, y, 2, p);
        kit_camera_point(a, x + 1, y, 2, side);
        kit_camera_point(b, x + dx, y + dy, 2, q);
        const double pixel = hypot(hypot((double)(side[0] - p[0]), (double)(side[1] - p[1])), (double)(side[2] - p[2]));
        for (int i = 0; i < 3; ++i) most = fmax(most, fabs((double)(p[i] - q[i])) / pixel);
    }
    return most;
}

/* Checks a camera as the standard words it, worked out by hand; then written and read back, for cameras all around; and
   with a data window that is a part of the display window. */
static void exr_camera(void)
{
    static const int32_t shown[4] = { -8, -2, 23, 9 };             /* 32 x 12 pixels, of which the file has 8 x 6 */
    static const float by_hand[16] = { 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 0, -3, -2, -1, 1 };
    static const kit_camera east = { .eye = { 1, 2, 3 }, .target = { 5, 2, 3 }, .up = { 0, 1, 0 }, .fovy = 90,
                                     .width = 8, .height = 6 };
    kit_header header = { .has = KIT_HEADER_RADIUS, .radius = 0.25f }, back;
    kit_error err = {{0}};
    double worst = 0;
    kit_camera_to_header(&header, &east);
    for (int i = 0; i < 16; ++i)
        CHECK(fabsf(header.world_to_camera[i] - by_hand[i]) < 1e-6f, "number %d: %g, not %g", i,
              (double)header.world_to_camera[i], (double)by_hand[i]);
    if (!frame_written("east.exr", &header)) return;
    float width = 0;
    static char bytes[65536];
    const size_t size = get("east.exr", bytes);
    for (size_t i = 0; i + 60 < size; ++i)
        if (!memcmp(bytes + i, "screenWindowWidth\0float", 24)) memcpy(&width, bytes + i + 28, 4);
    CHECK(fabsf(width - 8 / 3.0f) < 1e-6f, "90 degrees, 8 x 6: a screen window %g wide", (double)width);
    for (int k = 0; k < 200; ++k) {
        const double far = pow(10, k % 7 - 2), a = k * 0.7, b = sin(k * 1.3) * 1.5;
        kit_camera c = { .target = { 1, 2, 3 }, .up = { 0.1f, 1, 0.2f }, .width = 8, .height = 6 }, was;
        c.eye[0] = (float)(1 + far * cos(a) * cos(b));
        c.eye[1] = (float)(2 + far * sin(b));
        c.eye[2] = (float)(3 + far * sin(a) * cos(b));
        if (k % 2) c.ortho_height = (float)far; else c.fovy = (float)(1 + k * 0.8);
        for (int i = 0; i < 2 && k % 3; ++i) c.shift[i] = (float)(k % 5 - 2 - i);
        was = c;
        memset(&header, 0, sizeof header);
        kit_camera_to_header(&header, &c);
        if (!frame_written("c.exr", &header)
            || !CHECK(!kit_exr_header(&back, KIT_HEADER_ALL, in_folder("c.exr"), &err), "%s", err.text)) return;
        CHECK(back.has == (KIT_HEADER_PLACE | KIT_HEADER_WINDOW), "has %d", back.has);
        c = (kit_camera){ .width = 8, .height = 6 };
        kit_camera_from_header(&c, &back);
        const double off = astray(&was, &c, 0, 0);
        CHECK(off < 0.02, "camera %d: %.4f pixels astray", k, off);
        worst = fmax(worst, off);
        if (!patch("c.exr", "displayWindow", 11, shown, sizeof shown)
            || !CHECK(!kit_exr_header(&back, KIT_HEADER_ALL, in_folder("c.exr"), &err), "%s", err.text)) return;
        kit_camera part = { .width = 8, .height = 6 };
        kit_camera_from_header(&part, &back);
        /* the whole picture, from the part's angle: by width, by height */
        was = c;
        was.width = 32;
        was.height = 12;
        const double half = tan((double)c.fovy * acos(-1) / 360);
        if (k % 2 == 0) was.fovy = (float)(360 / acos(-1) * atan(half * 8 / 6 * 12 / 32));
        const double scale = k % 2 ? 12 / 6.0 : 32 / 8.0;
        for (int i = 0; i < 2; ++i) was.shift[i] = (float)((double)c.shift[i] * scale);
        const double cut = astray(&part, &was, 8, 2);
        CHECK(cut < 0.02, "camera %d, a part of the picture: %.4f pixels astray", k, cut);
    }
    t_note("cameras read back: %.1e pixels astray at most", worst);
}

/* Checks that malformed attributes are named; those that were not asked for are not read. */
static void exr_camera_bad(void)
{
    static const int32_t none[4] = { 5, 5, 4, 4 };
    static const float nan_ = NAN, two = 2, below = -1, endless = INFINITY, huge = 1e9f;
    static const float wide[2] = { 0, 1e9f };
    static const struct { const char *at; size_t after; const void *bytes; size_t count; const char *word; int part; }
        bad[] = {
        { "worldToCamera", 10, &nan_, 4, "worldToCamera", KIT_HEADER_PLACE },
        { "worldToCamera", 10, &two, 4, "worldToCamera", KIT_HEADER_PLACE },
        { "worldToCamera", 10 + 4 * 3, &two, 4, "worldToCamera", KIT_HEADER_PLACE },
        { "worldToCamera", 10 + 4 * 12, &endless, 4, "worldToCamera", KIT_HEADER_PLACE },
        { "worldToCamera", 1, "what", 4, "worldToCamera", KIT_HEADER_PLACE },
        { "screenWindowWidth", 11, &nan_, 4, "screenWindowWidth", KIT_HEADER_WINDOW },
        { "screenWindowWidth", 11, &huge, 4, "screenWindowWidth", KIT_HEADER_WINDOW },
        { "screenWindowCenter", 9, &nan_, 4, "screenWindowCenter", KIT_HEADER_WINDOW },
        { "screenWindowCenter", 9, wide, 8, "screenWindowCenter", KIT_HEADER_WINDOW },
        { "pixelAspectRatio", 11, &two, 4, "pixelAspectRatio", KIT_HEADER_WINDOW },
        { "displayWindow", 11, none, 16, "", KIT_HEADER_WINDOW },
        { "ssgi.radius", 11, &nan_, 4, "ssgi.radius", KIT_HEADER_RADIUS },
        { "ssgi.radius", 1, "ratio", 5, "ssgi.radius", KIT_HEADER_RADIUS },
        { "ssgi.orthoHeight", 11, &below, 4, "ssgi.orthoHeight", KIT_HEADER_WINDOW } };
    kit_camera camera = { .eye = { 0, 1, 2 }, .up = { 0, 1, 0 }, .width = 8, .height = 6 };
    kit_header back = { .has = -7 };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_header header = { .has = KIT_HEADER_RADIUS, .radius = 1 };
        kit_error err = {{0}};
        camera.fovy = strstr(bad[i].at, "ortho") ? 0 : 50;
        camera.ortho_height = 3;
        kit_camera_to_header(&header, &camera);
        if (!frame_written("bad.exr", &header)
            || !CHECK(patch("bad.exr", bad[i].at, bad[i].after, bad[i].bytes, bad[i].count), "%s is not in it",
                      bad[i].at))
            return;
        check_error(kit_exr_header(&back, KIT_HEADER_ALL, in_folder("bad.exr"), &err), &err, "bad.exr", bad[i].at);
        CHECK(strstr(err.text, bad[i].word) && back.has == -7, "case %zu: \"%s\"", i, err.text);
        if (*bad[i].word)
            CHECK(!kit_exr_header(&back, KIT_HEADER_ALL & ~bad[i].part, in_folder("bad.exr"), &err),
                  "case %zu, not asked for: \"%s\"", i, err.text);
        back.has = -7;
    }
    const kit_header mirrored = { .has = KIT_HEADER_PLACE,
                                  .world_to_camera = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 } };
    kit_error err = {{0}};
    if (!frame_written("bad.exr", &mirrored)) return;
    check_error(kit_exr_header(&back, KIT_HEADER_ALL, in_folder("bad.exr"), &err), &err, "bad.exr", "a mirror");
    if (!frame_written("bare.exr", NULL)) return;
    CHECK(!kit_exr_header(&back, KIT_HEADER_ALL, in_folder("bare.exr"), &err) && !back.has, "a frame without: %d, %s",
          back.has, err.text);
}

static void unwritable(void)
{
    OWN(kit_image) a = { 0 };
    kit_error err = {{0}};
    char text[200];
    shell(text, sizeof text, "rm -rf *%s%s", "", "");
    sample_image(&a, 8, 8, "Y");
    check_error(kit_exr_write(&a, in_folder("none/a.exr"), &err), &err, "none/a.exr", "a folder that does not exist");
    check_error(kit_png_write(&a, "Y", 0, in_folder("none/a.png"), &err), &err, "none/a.png",
                "a folder that does not exist");
    put("old.png", "old", 3);
    check_error(kit_png_write(&a, "Y,Q", 0, in_folder("old.png"), &err), &err, "old.png", "an absent channel");
    check_error(kit_png_write(&a, "Y,Y", 0, in_folder("old.png"), &err), &err, "old.png", "two channels");
    CHECK(!shell(text, sizeof text, "cat old.png%s%s", "", "") && !strcmp(text, "old"), "the old file is gone");
    mkdir(in_folder("taken.exr"), 0777);
    check_error(kit_exr_write(&a, in_folder("taken.exr"), &err), &err, "taken.exr", "a folder of that name");
    if (!access("/dev/full", W_OK)) CHECK(kit_exr_write(&a, "/dev/full", &err) == -1, "/dev/full was replaced");
    kit_image twice = a;                        /* OpenEXR itself refuses two channels of one name */
    twice.channels = 2;
    memcpy(twice.name[1], twice.name[0], sizeof twice.name[0]);
    put("old.exr", "old", 3);
    check_error(kit_exr_write(&twice, in_folder("old.exr"), &err), &err, "old.exr", "a channel twice");
    CHECK(!shell(text, sizeof text, "cat old.exr && ls | tr '\\n' ,%s%s", "", "")
              && !strcmp(text, "oldold.exr,old.png,taken.exr,"), "another is left, or the old one is gone: %s", text);
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

static void fuzzed(void)
{
    char said[4096];
    CHECK(!shell(said, sizeof said, "TMPDIR=. '%s/build/fuzz-files' 800x%s", t_root, ""), "%s", said);
}

/* Checks that the page replaces the parts of full runs, here of the papers and of scenes by seed, and keeps the others
   to the byte. A record that cannot be read changes nothing. The mean of three scenes' 0.3, 0.5, 1.3 is 0.7, its
   standard error sqrt(0.56 / 2 / 3) = 0.3055. */
static void figures(void)
{
#define OTHER "\n## Where methods fail\n\nold sweeps, to the byte\n"
#define RECORD(name, entries) "ssgi_record({\"name\":\"" name "\",\"kind\":\"full\",\"command\":\"make " name "\",\"" \
    "commit\":\"c0\",\"cores\":2,\"processor\":\"p\",\"driver\":\"d\",\"entries\":[" entries "null]})\n"
#define ROW(seed, kind, share) \
    #seed ",judged," kind ",visibility,\\\"hsao, half size\\\",hsao,samples=6," #share ",0\\n"
    static const char old[] = "# Figures\nan old head\n" OTHER "\n## The papers' own tables and figures\n\nold\n",
        papers[] = RECORD("papers", "{\"level\":3,\"heading\":\"Table 1: times\"},{\"table\":\"paper\",\"csv\":\"paper,"
                          "figure,row,kind,head,text\\nA01,Table 1,0,claim,agrees,faster\\n"
                          "A01,Table 1,0,claim,differs,x\\nA01,Table 1,0,claim,agrees,y\\n\"},"),
        chart[] = RECORD("chart", "{\"table\":\"seeds\",\"csv\":\"seed,set,kind,what,label,method,settings,share,"
                         "bias\\n"
                         ROW(1001, "rooms", 0.3) ROW(1002, "streets", 0.5) ROW(1008, "rooms", 1.3) "\"},"
                         "{\"level\":2,\"heading\":\"What a scene needs\"},"
                         "{\"table\":\"rows\",\"csv\":\"what,good,pairs\\nall,3,4\\n\"},");
    /* Only the row whose method and settings were measured is written anew. */
    static const char readme[] = "<!-- judged scenes, by make figures -->\n| method | ms | error |\n|---|--:|--:|\n"
                                 "| `hsao`, `samples=6` | 0.1 | **0.5** |\n| `hsao` | 0.2 | 0.3 |\n\n| error |\n";
    char said[8192];
    if (!has("node")) return;
    shell(said, sizeof said, "mkdir -p examples/docs report%s%s", "", "");
    put("examples/docs/FIGURES.md", old, sizeof old - 1);
    put("report/papers.js", papers, sizeof papers - 1);
    put("report/chart.js", "ssgi_record({\"name\":\"chart\"", 27);
    CHECK(shell(said, sizeof said, "node '%s/examples/lab/page/figures.mjs'%s", t_root, "") == 2
              && strstr(said, "chart.js"), "%s", said);
    CHECK(!shell(said, sizeof said, "cat examples/docs/FIGURES.md%s%s", "", "") && !strcmp(said, old), "\"%s\"", said);
    put("report/chart.js", chart, sizeof chart - 1);
    put("README.md", readme, sizeof readme - 1);
    CHECK(!shell(said, sizeof said, "node '%s/examples/lab/page/figures.mjs' && cat examples/docs/FIGURES.md "
                 "README.md%s", t_root, "")
              && strstr(said, OTHER)
              && !strstr(said, "old\n") && !strstr(said, "an old head")
              && strstr(said, "*`make papers`, commit c0, 2 cores (p), d*")
              && strstr(said, "| [A01] Table 1: times | 2 | 1 | 0 |\n| all | 2 | 1 | 0 |")
              && strstr(said, "| hsao, half size, `hsao`: `samples=6` | | | 0.700 &plusmn; 0.599 | 0.500 | "
                               "1.300, rooms-1008 | 1 | | | | 0.800 | 0.500 | | |\n")
              && strstr(said, "| all | 3 of 4 |\n")         /* the plan, which has a record of its own, too */
              && strstr(said, "| `hsao`, `samples=6` | 0.1 | **0.700** |\n| `hsao` | 0.2 | 0.3 |\n\n| error |"),
          "%s", said);
#undef OTHER
#undef RECORD
#undef ROW
}

/* Checks that README's charts and tables are those of the csv, and the charts on white, as the page around them may be
   dark. A line's name stands at the method without settings, else at the least error; for a sweep at its end. */
static void charts(void)
{
    static const char *const lines =
        "const { ssgi_report: report } = require(process.argv[2] + \"/examples/lab/page/report.js\");"
        "const rows = [[\"hsao\", \"hsao\", \"\", 1, 4], [\"hsao\", \"hsao\", \"thickness=slabs\", 2, 3],"
        "    [\"dss\", \"dss-fast\", \"\", 3, 6], [\"dss\", \"dss\", \"\", 4, 5],"
        "    [\"dss\", \"dss-best\", \"\", 5, 4],"
        "    [\"hsao, two slabs\", \"hsao\", \"thickness=slabs\", 6, 3],"
        "    [\"hsao, two slabs\", \"hsao-best\", \"thickness=slabs\", 7, 2],"
        "    [\"another\", \"another\", \"half\", 8, 2], [\"another\", \"another\", \"full\", 9, 3],"
        "    [\"turned\", \"ssao\", \"\", 10, 1], [\"turned\", \"ssao\", \"\", 11, 2]]"
        "    .map(([label, method, settings, x, y]) => ({ label, method, settings, x, y }));"
        "const Plot = new Proxy({}, { get: (_, mark) => (data, options) => ({ mark, data, options }) });"
        "const { marks } = report.scatter(Plot, rows, { x: \"x\", y: \"y\" });"
        "const at = marks.filter(({ mark }) => mark === \"text\").flatMap(({ data }) => data.map(({ x }) => x))"
        "    .sort((a, b) => a - b).join();"
        "if (at !== \"1,4,6,8,11\") throw new Error(at);";
    char said[4096];
    CHECK(!shell(said, sizeof said, "cd '%s' && find examples -name '*.svg' | grep -c . && ! find examples -name "
                 "'*.svg' | xargs grep -L '^<svg [^>]*><rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>' | "
                 "grep .%s", t_root, ""), "has no ground: %s", said);
    if (!has("node")) return;
    write_text("lines.js", lines);
    CHECK(!shell(said, sizeof said, "node lines.js '%s'%s", t_root, ""), "lines have their names at %s", said);
    CHECK(!shell(said, sizeof said, "d=$PWD && cd '%s' && node examples/lab/page/figures.mjs --csv \"$d\" && "
                 "diff README.md \"$d\" && diff examples/docs/BENCH.md \"$d\" && rm \"$d\"/*.md%s", t_root, ""),
          "tables are not of the csv (node examples/lab/page/figures.mjs --csv): %s", said);
    if (shell(said, sizeof said, "test -d '%s/build/page/node_modules/linkedom'%s", t_root, "")) {
        t_note("Observable Plot is not there: charts are not drawn (make page-deps)");
        return;
    }
    CHECK(!shell(said, sizeof said, "d=$PWD && cd '%s' && for f in \"$d\"/*.svg; do "
                 "cmp \"$f\" examples/docs/pictures/${f##*/} || exit 1; done%s", t_root, ""), "%s", said);
}

/* ---- HDR --------------------------------------------------------------------------------------------------------- */

#define RADIANCE "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"

/* Checks the channels of a row of 8 pixels: red a run of 8, green 8 literals, blue two runs; and the same file, cut. */
static void hdr(void)
{
    static const char coded[] = RADIANCE "-Y 1 +X 8\n\2\2\0\10\210\200\10\0\20\40\60\100\120\140\160"
                                         "\204\1\204\2\210\201";
    OWN(kit_image) image = { 0 };
    kit_error err = {{0}};
    put("a.hdr", coded, sizeof coded - 1);
    if (!CHECK(!kit_hdr_read(&image, in_folder("a.hdr"), &err), "%s", err.text)) return;
    const float *r = kit_image_channel(&image, "R"), *g = kit_image_channel(&image, "G"),
                *b = kit_image_channel(&image, "B");
    CHECK(image.width == 8 && image.height == 1 && r[0] == 1 && r[7] == 1 && g[3] == 0.375f && b[3] == 1 / 128.0f
              && b[4] == 2 / 128.0f, "%g %g %g %g %g", (double)r[0], (double)r[7], (double)g[3], (double)b[3],
          (double)b[4]);
    cut("a.hdr", 1, kit_hdr_read);
}

/* Checks files that are no Radiance picture, that claim more than they hold, or end within a row of runs. */
static void hdr_bad(void)
{
    static const struct { const char *text; size_t size; const char *says; } bad[] = {
#define HDR_BAD(text, says) { text, sizeof text - 1, says }
        HDR_BAD("", "empty"),
        HDR_BAD("#?RADIANC\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n1234", "not a Radiance"),
        HDR_BAD(RADIANCE "+Y 1 +X 1\n1234", "-Y HEIGHT +X WIDTH"),
        HDR_BAD(RADIANCE "-Y 13000 +X 13000\n\2\2", "claims 13000 x 13000 pixels, which its"),
        HDR_BAD(RADIANCE "-Y 1 +X 8\n\2\2\0\10\0\0\210\0\210\0\210\0", "ends too early"),
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_image untouched = { .width = -7 };
        kit_error err = {{0}};
        put("bad.hdr", bad[i].text, bad[i].size);
        check_error(kit_hdr_read(&untouched, in_folder("bad.hdr"), &err), &err, "bad.hdr", bad[i].says);
        CHECK(untouched.width == -7 && strstr(err.text, bad[i].says), "\"%s\" instead of \"%s\"", err.text,
              bad[i].says);
    }
}

/* ---- scores ------------------------------------------------------------------------------------------------------ */

enum { PLACES_W = 64, PLACES_H = 48, PLACES = PLACES_W * PLACES_H };

/* Returns the view depth at which a pixel's ray meets the plane n.P = d: of a camera of 60 degrees, or of an
   orthographic one 3 units high; 0 = nowhere. */
static double depth_of_plane(int i, int perspective, const double n[3], double d)
{
    const double scale = perspective ? tan(acos(-1) / 6) : 1.5;
    const double x = (2 * (i % PLACES_W + 0.5) - PLACES_W) / PLACES_H * scale;
    const double y = (PLACES_H - 2 * (i / PLACES_W + 0.5)) / PLACES_H * scale;
    const double z = perspective ? d / (n[0] * x + n[1] * y - n[2]) : (n[0] * x + n[1] * y - d) / n[2];
    return z > 0 && z < 1e6 ? z : 0;
}

/* Counts how many pixels of each kind a row has: [0] left of a column, [1] in all. */
static void places_in_row(int count[2][KIT_PLACES], const kit_image *places, int y, int column)
{
    memset(count, 0, 2 * sizeof *count);
    for (int x = 0; x < PLACES_W; ++x)
        for (int k = 0; k < KIT_PLACES; ++k) {
            const int is = places->data[k * PLACES + y * PLACES_W + x] > 0;
            count[0][k] += is && x < column;
            count[1][k] += is;
        }
}

static void places(void)
{
    static const double facing[3] = { 0, 0, 1 }, floor_[3] = { 0, 1, 0 }, wall[3] = { 0.05, 0, 1 };
    static const char *const channel = "Y";
    kit_camera camera = { .target = { 0, 0, -1 }, .up = { 0, 1, 0 }, .ortho_height = 3, .width = PLACES_W,
                          .height = PLACES_H };
    OWN(kit_image) frame = { 0 }, out = { 0 }, a = { 0 }, b = { 0 };
    kit_error err = {{0}};
    kit_score_place place[KIT_PLACES];
    int row[2][KIT_PLACES];
    kit_image_new(&frame, PLACES_W, PLACES_H, "Z", NULL);
    for (int perspective = 0; perspective < 2; ++perspective) {
        camera.fovy = perspective ? 60 : 0;
        for (int tilt = 0; tilt < 89; tilt += 11) {                      /* two planes that fold by up to 88 degrees */
            const double at = tilt * acos(-1) / 180, n[3] = { 0.3 * sin(at), sin(at), cos(at) };
            int edges = 0;
            for (int i = 0; i < PLACES; ++i) {
                const double z = depth_of_plane(i, perspective, n, -4 * n[2]);
                const double w = depth_of_plane(i, perspective, wall, -5);
                frame.data[i] = (float)(!perspective ? fmax(z, w) : z > 0 && z < w ? z : w);
            }
            if (!CHECK(!kit_image_places(&out, &frame, &camera, 0.02f, &err), "%s", err.text)) return;
            for (int i = 0; i < PLACES; ++i) edges += out.data[i] > 0;
            CHECK(!edges, "a plane at %d degrees that meets a wall, perspective %d: %d pixels are edges", tilt,
                  perspective, edges);
            kit_image_free(&out);
        }
        for (int step = 0; step < 2; ++step) {                           /* depth jumps: 1.2 and 0.8 of the threshold */
            for (int i = 0; i < PLACES; ++i)
                frame.data[i] = (float)depth_of_plane(i, perspective, facing, -4)
                              + (i % PLACES_W < 40 ? 0 : step ? 0.08f : 0.12f);
            kit_image_places(&out, &frame, &camera, 2, NULL);
            places_in_row(row, &out, 24, 40);
            CHECK(row[1][KIT_EDGE] == (step ? 0 : 6) && row[0][KIT_EDGE] == (step ? 0 : 3), "perspective %d: beside a "
                  "jump %d pixels are edges, %d of them before it", perspective, row[1][KIT_EDGE], row[0][KIT_EDGE]);
            kit_image_free(&out);
        }
    }
    for (int i = 0; i < PLACES; ++i) frame.data[i] = (float)depth_of_plane(i, 1, floor_, -1);
    for (int y = 0; y < PLACES_H; ++y) frame.data[y * PLACES_W + 30] = 1;      /* a rail, one pixel wide */
    kit_image_places(&out, &frame, &camera, 0.2f, NULL);
    places_in_row(row, &out, 44, 30);
    CHECK(row[1][KIT_EDGE] == 7 && row[0][KIT_EDGE] == 3, "across a rail of a pixel %d are edges", row[1][KIT_EDGE]);
    places_in_row(row, &out, 10, 30);
    CHECK(row[1][KIT_EDGE] == 1 && row[1][KIT_BORDER] + row[1][KIT_INTERIOR] == 0, "above the horizon there is more");
    places_in_row(row, &out, 24, 10);
    CHECK(!row[0][KIT_EDGE], "a floor's horizon is an edge");
    kit_image_free(&out);

    /* the radius, 0.5 at depth 4, is 0.5 / 4 / tan(30 degrees) * 24 = 5.196 pixels long: centres 0.5 .. 4.5 are near */
    for (int i = 0; i < PLACES; ++i) frame.data[i] = 4;
    kit_image_places(&out, &frame, &camera, 0.5f, NULL);
    places_in_row(row, &out, 24, 32);
    CHECK(row[0][KIT_BORDER] == 5 && row[1][KIT_BORDER] == 10 && row[1][KIT_INTERIOR] == 54,
          "%d pixels are near the left border", row[0][KIT_BORDER]);
    kit_image_new(&a, PLACES_W, PLACES_H, channel, NULL);
    kit_image_new(&b, PLACES_W, PLACES_H, channel, NULL);
    for (int i = 0; i < PLACES; ++i) a.data[i] = out.data[KIT_BORDER * PLACES + i] > 0 ? -0.2f : 0.1f;
    CHECK(!kit_score_places(place, &a, &b, &channel, 1, &out, &err), "%s", err.text);
    const double border = PLACES - 54.0 * 38, inside = 54 * 38;
    CHECK(fabs(place[KIT_BORDER].score.rmse - 0.2) < 1e-7 && fabs(place[KIT_BORDER].score.bias + 0.2) < 1e-7
          && fabs(place[KIT_INTERIOR].score.bias - 0.1) < 1e-7, "border %g, %+g",
          place[KIT_BORDER].score.rmse, place[KIT_BORDER].score.bias);
    CHECK(fabs(place[KIT_BORDER].area - border / PLACES) < 1e-9
          && fabs(place[KIT_BORDER].error - 4 * border / (4 * border + inside)) < 1e-6,
          "the border has %g of the pixels, %g of the error", place[KIT_BORDER].area, place[KIT_BORDER].error);
    CHECK(!place[KIT_EDGE].score.pixels && !(place[KIT_EDGE].error > 0), "no edge has error %g", place[KIT_EDGE].error);
}

static void score(void)
{
    OWN(kit_image) a = { 0 }, b = { 0 }, image = { 0 };
    kit_score s;
    kit_error err = {{0}};
    float mask[20];
    kit_image_new(&a, 5, 4, "Y", NULL);
    kit_image_new(&b, 5, 4, "Y", NULL);
    for (int i = 0; i < 20; ++i) {              /* differences 0, 0.01 ... 0.19, the last one negative */
        a.data[i] = 0.5f + 0.01f * (float)i;
        b.data[i] = 0.5f;
        mask[i] = i < 2 ? 1.0f : 0.0f;
    }
    a.data[19] = 0.5f - 0.19f;
    CHECK(!kit_score_channel(&s, &a, &b, "Y", NULL, &err), "%s", err.text);
    CHECK(fabs(s.rmse - sqrt(0.247 / 20)) < 1e-7, "rmse %.9g", s.rmse);        /* 0.01^2 (1 + 4 + ... + 19^2) = 0.247 */
    CHECK(fabs(s.bias - (1.71 - 0.19) / 20) < 1e-7, "bias %.9g", s.bias);
    CHECK(fabs(s.p95 - 0.18) < 1e-6 && s.pixels == 20, "p95 %.9g of %zu", s.p95, s.pixels);
    CHECK(!kit_score_channel(&s, &a, &b, "Y", mask, &err) && s.pixels == 2 && fabs(s.bias - 0.005) < 1e-7,
          "masked: bias %.9g of %zu", s.bias, s.pixels);
    a.data[0] = NAN;
    b.data[3] = NAN;
    a.data[4] = b.data[4] = INFINITY;
    CHECK(!kit_score_channel(&s, &a, &b, "Y", NULL, &err) && s.pixels == 18, "%zu pixels are numbers", s.pixels);
    CHECK(isfinite(s.rmse) && isfinite(s.ssim), "rmse %g, ssim %g", s.rmse, s.ssim);
    mask[1] = 0;
    s.pixels = 77;
    CHECK(kit_score_channel(&s, &a, &b, "Y", mask, &err) == -1 && s.pixels == 77, "no pixel at all was accepted");
    CHECK(kit_score_channel(&s, &a, &b, "Q", NULL, &err) == -1 && strstr(err.text, "Q"), "\"%s\"", err.text);
    kit_image_new(&image, 4, 5, "Y", NULL);
    CHECK(kit_score_channel(&s, &a, &image, "Y", NULL, &err) == -1 && strstr(err.text, "5 x 4"), "\"%s\"", err.text);
    kit_image_free(&image);

    b.data[0] = 0.5f;
    CHECK(!kit_image_difference(&image, &a, &b, "Y", 0.1f, &err), "%s", err.text);
    const float *r = kit_image_channel(&image, "R"), *g = kit_image_channel(&image, "G"),
                *bl = kit_image_channel(&image, "B");
    CHECK(r[0] == 0 && g[0] == 0, "NaN is not black");
    CHECK(r[4] > 0.9f && fabsf(r[4] - g[4]) < 0.01f && fabsf(r[4] - bl[4]) < 0.01f,
          "no difference is %g %g %g, not near-white", (double)r[4], (double)g[4], (double)bl[4]);
    CHECK(r[15] > 2 * bl[15] && bl[19] > 2 * r[19], "brighter is not red or darker not blue");
    CHECK(r[15] == r[14] && g[2] > g[7], "the range is not kept");
    kit_image_free(&image);
    CHECK(kit_image_difference(&image, &a, &b, "Y", 0, &err) == -1, "a range of 0 was accepted");
}

static double plain_ssim(const kit_image *a, const kit_image *b)               /* SSIM by its definition, by pixel */
{
    double total = 0;
    int w = a->width, h = a->height;
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            double m[6] = { 0 };
            for (int v = -5; v <= 5; ++v)
                for (int u = -5; u <= 5; ++u) {
                    if (x + u < 0 || x + u >= w || y + v < 0 || y + v >= h) continue;
                    double g = exp(-(u * u + v * v) / 4.5), p = (double)a->data[(y + v) * w + x + u],
                           q = (double)b->data[(y + v) * w + x + u];
                    m[0] += g; m[1] += g * p; m[2] += g * q; m[3] += g * p * p; m[4] += g * q * q; m[5] += g * p * q;
                }
            for (int k = 1; k < 6; ++k) m[k] /= m[0];
            total += (2 * m[1] * m[2] + 1e-4) / (m[1] * m[1] + m[2] * m[2] + 1e-4)
                   * (2 * (m[5] - m[1] * m[2]) + 9e-4) / (m[3] - m[1] * m[1] + m[4] - m[2] * m[2] + 9e-4);
        }
    return total / w / h;
}

static void ssim(void)
{
    OWN(kit_image) a = { 0 }, b = { 0 };
    kit_score s;
    double before = 1;
    kit_image_new(&a, 300, 40, "Y", NULL);      /* a picture wider than one strip of columns */
    kit_image_new(&b, 300, 40, "Y", NULL);
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 300 * 40; ++i) {
            a.data[i] = 0.5f + 0.3f * (float)sin(0.1 * (i % 300)) * (float)cos(0.2 * (i / 300));
            b.data[i] = a.data[i] + 0.05f * (float)k * t_uniform(-1, 1);
        }
        CHECK(!kit_score_channel(&s, &a, &b, "Y", NULL, NULL), "no score");
        CHECK(k ? s.ssim < before - 0.05 : s.ssim == 1, "ssim %.9g after %.9g", s.ssim, before);
        CHECK(fabs(s.ssim - plain_ssim(&a, &b)) < 1e-9, "ssim %.12g, by its definition %.12g", s.ssim,
              plain_ssim(&a, &b));
        before = s.ssim;
    }
}

/* ---- OBJ --------------------------------------------------------------------------------------------------------- */

static int obj(kit_mesh *mesh, const char *text, kit_error *err)
{
    put("a.obj", text, strlen(text));
    return kit_mesh_obj(mesh, NULL, NULL, in_folder("a.obj"), err);
}

static double area(const kit_mesh *m, size_t first, size_t end)
{
    double sum = 0;
    for (size_t t = first; t < end; ++t) {
        const float *p = m->position + 9 * t;
        double u[3], v[3], n[3];
        for (int i = 0; i < 3; ++i) { u[i] = (double)p[3 + i] - (double)p[i]; v[i] = (double)p[6 + i] - (double)p[i]; }
        for (int i = 0; i < 3; ++i) n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        sum += 0.5 * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return sum;
}

static const char quirks[] =
    "\xEF\xBB\xBF# C:\\scenes\\\r\n"                      /* a comment ends in a backslash: no continuation */
    "mtllib my materials.mtl   # all of them\r\n"
    "v\t0\t0  0\r\n"
    "  v 1. +0 -.0e0 1.0\r\n"
    "v 1e0 10E-1 0 0.5 0.5 0.5 # coloured\r\n"
    "v 0 1.00000000000000000000000000000 0\r\n"
    "vt 0 0\r\nvn 0 0 -2\r\nvn 0 0 0\r\n"
    "usemtl Material #25\r\n"
    "f 1/1/1 2//1 3/1/2 4/1#quad: 2 triangles\r\n"       /* normals: two given, one of length 0, none */
    "l 1 2\r\np 1\r\ng x\r\ns off\r\nnonsense \x01\xff\r\n"
    "usemtl twice # the later one\r\n"
    "f -4 \\\r\n -3 \\\n -2\r\n"                          /* continued */
    "f 1 2 2\nf 1 1 1\n"                                  /* no area */
    "usemtl nobody\n"
    "f 5 6 7 8 9 10\n"                                    /* concave; its corners come later */
    "v 0 0 5\nv 4 0 5\nv 4 4 5\nv 2 1 5\nv 1 1 5\nv 0 4 5\n"
    "f -6 -5 -4";                                         /* no line end */

static void obj_quirks(void)
{
    static const char mtl[] = "newmtl twice\nKd 1 1 1\nnewmtl Material #25\r\nmap_Kd x.png\r\nKd\t1.5 .25 -1 # "
                              "clamped\r\n\nnewmtl twice\nKd 0.5\nnewmtl last";
    static const float first[] = { 0, 0, 0, 1, 0, 0, 1, 1, 0 };
    OWN(kit_mesh) m = { 0 };
    kit_error err = {{0}};
    put("my materials.mtl", mtl, strlen(mtl));
    if (!CHECK(!obj(&m, quirks, &err), "%s", err.text)) return;
    CHECK(m.triangles == 2 + 1 + 4 + 1, "%zu triangles, not 8", m.triangles);
    if (m.triangles == 8) {
        for (int i = 0; i < 9; ++i)
            CHECK(m.position[i] == first[i], "number %d of the first triangle is %g", i, (double)m.position[i]);
        const float *n = m.normal;
        CHECK(n[2] == -1 && n[5] == -1 && n[8] == 1 && n[17] == 1, "normals %g %g (given) %g (length 0) %g (none)",
              (double)n[2], (double)n[5], (double)n[8], (double)n[17]);
        CHECK(m.albedo[0] == 1 && m.albedo[1] == 0.25f && m.albedo[2] == 0, "Material #25 is %g %g %g",
              (double)m.albedo[0], (double)m.albedo[1], (double)m.albedo[2]);
        CHECK(m.albedo[6] == 0.5f && m.albedo[8] == 0.5f, "twice is %g", (double)m.albedo[6]);
        CHECK(m.albedo[9] == 0.8f, "an unknown material is %g", (double)m.albedo[9]);
        CHECK(fabs(area(&m, 3, 7) - 8.5) < 1e-6, "the concave polygon covers %g instead of 8.5", area(&m, 3, 7));
        for (size_t t = 3; t < 7; ++t)
            CHECK(m.normal[9 * t + 2] == 1, "triangle %zu of the concave polygon is turned over", t);
        CHECK(m.lower[2] == 0 && m.upper[2] == 5 && m.upper[0] == 4, "bounds");
    }
    kit_mesh_free(&m);
    CHECK(!m.position && !m.triangles, "something is left after kit_mesh_free");
}

static void obj_bad(void)
{
#define CORNERS "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
    static const struct { const char *text, *says; } bad[] = {
        { CORNERS "f\n", "line 4: a face needs at least 3 corners" },
        { CORNERS "f 1 2 4\n", "line 4: there is no vertex 4" },
        { CORNERS "\\\n\nf -4 2 3\n", "line 6: there is no vertex -4" },  /* a continued empty line counts as two */
        { CORNERS "f 1//1 2//1 3//1\n", "line 4: there is no vn 1" },
        { CORNERS "f 1 2 3/", "line 4: a face needs corners such as" },
        { "v 0 0\n", "line 1: v needs 3 numbers, but the line ends" },
        { "v 0 0 nan\n", "line 1: v needs 3 numbers, not \"nan\"" },
        { "v 0 0 1e39\n", "line 1: a number is too large" },
        { "v 0 0 -1e16\n", "line 1: a coordinate of -1e+16: must be within 1e+15 of 0" },
        { CORNERS "mtllib bad.mtl\nf 1 2 3\n", "bad.mtl line 2: Kd needs 1 or 3 numbers" },
        { CORNERS "f 1 1 2\n", "no triangles" },
        { "", "is empty" },
    };
    put("bad.mtl", "newmtl a\nKd 1 nan 1\n", 20);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_mesh m = { .triangles = 77 };
        kit_error err = {{0}};
        int result = obj(&m, bad[i].text, &err);
        CHECK(result == -1 && m.triangles == 77, "\"%s\" was accepted or the mesh touched", bad[i].text);
        CHECK(strstr(err.text, folder) && strstr(err.text, bad[i].says), "\"%s\": \"%s\"", bad[i].text, err.text);
        CHECK(kit_mesh_obj(&m, NULL, NULL, in_folder("a.obj"), NULL) == -1, "NULL for the error");
    }
    kit_mesh m;
    kit_error err = {{0}};
    check_error(kit_mesh_obj(&m, NULL, NULL, folder, &err), &err, "directory", "a directory");
    check_error(kit_mesh_obj(&m, NULL, NULL, in_folder("absent.obj"), &err), &err, "absent.obj", "an absent file");
    CHECK(!obj(&m, "mtllib absent.mtl\nusemtl x\n" CORNERS "f 1 2 3\n", &err) && m.albedo[0] == 0.8f, "no MTL: \"%s\"",
          err.text);
    kit_mesh_free(&m);
    CHECK(!obj(&m, "v 0 0 0\rv 1 0 0\rv 0 1 0\r# no face f 1 2 3\rf 1 2 3", &err) && m.triangles == 1,
        "lines that end in CR: \"%s\"", err.text);
    kit_mesh_free(&m);
}

/* ---- objects ----------------------------------------------------------------------------------------------------- */

static void obj_objects(void)
{
    static const char nine[] =
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nv 6 5 5\nv 5 6 5\nv 1 -0 -1e-60\nv 1 1 0\nv 2 0 0\n";
    static const struct { const char *text, *numbers, *names; } files[] = {
        { "o a\ng x\nf 1 2 3\ng y\no b b # it\nf 4 5 6\no a\nf 7 8 9\n", "121", "a,b b" },
        { "f 1 2 3\no unused\no b\nf 4 5 6\nf 7 8 9\n", "122", "default,b" },
        { "o a\ng x # 1\nf 1 2 3\ng y z\nf 4 5 6\ng x\nf 7 8 9\n", "121", "x,y z" },
        { "o a\nf 1 2 3\nf 4 5 6\nf 7 8 9\n", "121", "part 1,part 2" },            /* 2 and 7 are at one place */
    };
    static char text[40000];
    kit_error err = {{0}};
    kit_object *object;
    kit_mesh m;
    int objects;
    for (size_t k = 0; k < sizeof files / sizeof *files; ++k) {
        char names[200] = "";
        snprintf(text, sizeof text, "%s%s", nine, files[k].text);
        put("a.obj", text, strlen(text));
        if (!CHECK(!kit_mesh_obj(&m, &object, &objects, in_folder("a.obj"), &err) && m.triangles == 3, "%s", err.text))
            return;
        for (int i = 0; i < objects; ++i)
            snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i ? "," : "", object[i].name);
        CHECK(!strcmp(names, files[k].names), "file %zu: objects %s", k, names);
        for (size_t t = 0; t < 3; ++t)
            CHECK((int)m.object[t] == files[k].numbers[t] - '0', "file %zu: triangle %zu is object %u", k, t,
                  (unsigned)m.object[t]);
        free(object);
        kit_mesh_free(&m);
    }
}

static void add_cube(char *text, const char *name, double x, double y, double z, double size, double height)
{
    text += strlen(text) + (size_t)sprintf(text + strlen(text), "o %s\n", name);
    for (int k = 0; k < 8; ++k)
        text += sprintf(text, "v %g %g %g\n", x + (k & 1 ? size : 0), y + (k & 2 ? height : 0), z + (k & 4 ? size : 0));
    sprintf(text, "f -8 -4 -2 -6\nf -7 -5 -1 -3\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -6 -5 -7\nf -4 -3 -1 -2\n");
}

static void objects_cast_and_move(void)
{
    /* a quarter turn about y, twice the size */
    static const float where[16] = { 0, 0, -2, 0,  0, 2, 0, 0,  2, 0, 0, 0,  20, 1, 5, 1 };
    static const int casts[6] = { 0, 1, 0, 1, 1, 0 };
    static const float grey[3] = { 0.5f, 0.5f, 0.5f };
    char text[4000] = "";
    kit_error err = {{0}};
    OWN(kit_scene) s = { 0 };
    add_cube(text, "room", 0, 0, 0, 10, 10);
    add_cube(text, "cube", 1, 0, 2, 1, 1);
    add_cube(text, "sheet", 5, 0, 0, 4, 0.003);
    /* it sticks out of the room, which holds three of the five others */
    add_cube(text, "pillar", 9, 0, 4, 2, 5);
    add_cube(text, "book", 3, 0, 5, 1, 1);
    put("a.obj", text, strlen(text));
    if (!CHECK(!kit_scene_load(&s, in_folder("a.obj"), 1, &err), "%s", err.text)) return;
    if (!CHECK(s.objects == 6 && s.shapes == 6 && !strcmp(s.object[5].name, "floor"), "%d objects, %d shapes",
               s.objects, s.shapes))
        return;
    for (int k = 0; k < 6; ++k)
        CHECK(s.object[k].casts == casts[k], "%s: casts %d", s.object[k].name, s.object[k].casts);

    const size_t floats = 9 * s.mesh.triangles;
    FREED float *was = malloc(floats * sizeof *was);
    memcpy(was, s.mesh.position, floats * sizeof *was);
    CHECK(!kit_scene_place(&s, 1, where, &err), "%s", err.text);
    int wrong = 0, others = 0;
    for (size_t i = 0; i < 3 * s.mesh.triangles; ++i) {
        const float *p = was + 3 * i, *q = s.mesh.position + 3 * i, *n = s.mesh.normal + 3 * i;
        if (s.mesh.object[i / 3] != 2) others += memcmp(p, q, 3 * sizeof *p) != 0;
        else
            wrong += q[0] != 2 * p[2] + 20 || q[1] != 2 * p[1] + 1 || q[2] != 5 - 2 * p[0]
                     || fabsf(fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]) - 1) > 1e-6f || n[0] * (q[0] - 25) < 0;
    }
    const kit_object *o = &s.object[1];
    CHECK(!wrong && !others, "%d corners are wrong, %d of others moved", wrong, others);
    CHECK(o->lower[0] == 24 && o->upper[0] == 26 && o->lower[1] == 1 && o->upper[1] == 3 && o->lower[2] == 1
              && o->upper[2] == 3,
          "bounds from %g to %g", (double)o->lower[0], (double)o->upper[0]);
    for (int k = 0; k < 6; ++k) {
        float bad[16];
        memcpy(bad, where, sizeof bad);
        /* 0, 2: a shear, 1: mirrored, 3: no place, 5: not finite */
        bad[k < 4 ? 5 * k : 13] = k == 3 ? 2 : k == 5 ? INFINITY : k ? -2 : 1;
        if (k == 4) bad[5] = bad[8] = 2.1f;                                         /* scaled by more on two axes */
        CHECK(kit_scene_place(&s, 1, bad, &err) == -1 && o->lower[0] == 24 && strstr(err.text, "cube"),
              "place %d was accepted: \"%s\"", k, err.text);
    }
    CHECK(kit_scene_place(&s, 6, where, &err) == -1 && kit_scene_place(&s, -1, where, NULL) == -1,
          "an object that is not there was placed");
    CHECK(!kit_scene_place(&s, 0, where, &err) && s.mesh.upper[1] == 21, "the mesh is %g high, not 21",
          (double)s.mesh.upper[1]);

    /* inside the cube, without an object in it; around all but the floor */
    static const float corners[2][2][3] = { { { 24.5f, 1.5f, 1.5f }, { 25, 2, 2 } },
                                            { { -20, -1, -20 }, { 60, 60, 60 } } };
    for (int k = 0; k < 2; ++k) CHECK(!kit_scene_add_box(&s, corners[k][0], corners[k][1], grey, &err), "%s", err.text);
    if (CHECK(s.objects == 8, "%d objects", s.objects))
        CHECK(s.object[1].casts && s.object[3].casts && s.object[6].casts && !s.object[7].casts,
              "the cube around a box casts %d, the box %d, one around all %d", s.object[1].casts, s.object[6].casts,
              s.object[7].casts);
    kit_scene_free(&s);

    if (!CHECK(!kit_scene_load(&s, "casters", 0, &err), "%s", err.text)) return;
    CHECK(s.objects == 25 && s.shapes == 6, "casters: %d objects of %d shapes", s.objects, s.shapes);
    double deepest = 1, least = 1, most = 0, rest = 0;
    for (int t = 0; t <= 20; ++t) {
        kit_scene_move(&s, t / 20.0);
        for (int k = 1; k < s.objects; ++k) {
            double moved = 0;
            o = &s.object[k];
            deepest = fmin(deepest, (double)o->lower[1]);
            for (int i = 0; i < 16; ++i) moved = fmax(moved, fabs((double)(o->to_world[i] - o->loaded[i])));
            if (t == 5) least = fmin(least, moved), most = fmax(most, moved);
            if (t % 20 == 0) rest = fmax(rest, moved);
        }
    }
    CHECK(deepest > 0 && least > 0.1 && rest < 1e-5, "casters: down to %g, moved by %g to %g, after a period by %g",
          deepest, least, most, rest);
    t_note("casters moved by %.2f to %.2f, after a period by %.1e", least, most, rest);
}

/* Returns the greatest error of a truth between objects, seen from above: the ball occludes the plane by 1 / (1 +
   rho^2)^1.5; if the plane casts, it occludes the ball by (1 - n.y) / 2. */
static double ball_and_plane(int ball, int plane, kit_image *y)
{
    kit_error err = {{0}};
    OWN(kit_scene) s = { 0 };
    double worst = 0;
    if (!CHECK(!kit_scene_load(&s, "sphere", 0, &err) && s.objects == 2 && s.object[1].casts && !s.object[0].casts,
               "%s", err.text))
        return 1;
    const kit_camera above = {
        .eye = { 0, 10, 0 }, .up = { 0, 0, -1 }, .ortho_height = 0.4f, .width = 80, .height = 4
    };
    s.object[0].casts = plane;
    s.object[1].casts = ball;
    if (!CHECK(!kit_truth_objects(y, &s, &above, 4096, 1, &err), "%s", err.text)) return 1;
    for (int i = 0; i < 80 * 4; ++i) {
        float p[3];
        kit_camera_point(&above, i % 80, i / 80, 10, p);
        const double rho = hypot((double)p[0], (double)p[2]), is = 1 - (double)y->data[i];
        const double should = rho > 1 ? ball * pow(1 + rho * rho, -1.5) : plane * (1 - sqrt(1 - rho * rho)) / 2;
        if (fabs(rho - 1) > 0.03) worst = fmax(worst, fabs(is - should));
    }
    kit_image_free(y);
    return worst;
}

static void truth_of_objects(void)
{
    OWN(kit_image) y = { 0 };
    for (int k = 0; k < 4; ++k) {
        const double worst = ball_and_plane(k & 1, k >> 1, &y);
        CHECK(worst < (k ? 0.006 : 1e-6), "a ball that casts %d, a plane that casts %d: off by %g", k & 1, k >> 1,
              worst);
        t_note("a ball that casts %d, a plane that casts %d: off by %.1e", k & 1, k >> 1, worst);
    }
}

/* ---- environments ------------------------------------------------------------------------------------------------ */

/* Returns the luminance of the irradiance over pi from a direction's hemisphere. peak: the brightest texel; step: the
   largest difference between neighbouring texels. */
static double facing(const kit_image *env, const float to[3], double *peak, double *step)
{
    static const double weight[3] = { 0.2126, 0.7152, 0.0722 };
    const size_t w = (size_t)env->width, texels = w * (size_t)env->height;
    double sum = 0;
    *peak = *step = 0;
    for (size_t i = 0; i < texels; ++i) {
        const double y = (double)(i / w) + 0.5, pi = acos(-1);
        float d[3];
        kit_env_direction(env, (double)(i % w) + 0.5, y, d);
        const double cosine = fmax(0, (double)(d[0] * to[0] + d[1] * to[1] + d[2] * to[2])),
                     area = 2 * pi / env->width / env->height * sin(pi * y / env->height);
        for (size_t c = 0; c < 3; ++c) {
            const double v = (double)env->data[c * texels + i];
            sum += cosine * area * weight[c] * v;
            *peak = fmax(*peak, v);
            *step = fmax(*step, fmax(fabs(v - (double)env->data[c * texels + i / w * w + (i + 1) % w]),
                                     i < texels - w ? fabs(v - (double)env->data[c * texels + i + w]) : 0));
        }
    }
    return sum;
}

static void environments(void)
{
    static const struct {
        const char *name;
        double up, least, most, step;       /* up: irradiance facing up; most: the brightest texel */
    } built_in[] = { { "sky", 1.0103, 3, 6, 0.45 },
                     { "probe", 1, 150, 300, 0.45 },
                     { "windows", 1, 8, 14, 0.95 },
                     { "street", 1, 800, 2000, 0.95 },
                     { "white", 1, 1, 1, 0.45 } };
    static const float up[3] = { 0, 1, 0 };
    kit_image env = { 0 };
    kit_error err = {{0}};
    double peak, step;
    for (size_t i = 0; i < sizeof built_in / sizeof *built_in; ++i) {
        if (!CHECK(!kit_env_read(&env, built_in[i].name, &err), "%s", err.text)) return;
        const double is = facing(&env, up, &peak, &step);
        CHECK(fabs(is - built_in[i].up) < 5e-4, "%s: irradiance over pi is %.4f facing up", built_in[i].name, is);
        CHECK(peak >= built_in[i].least && peak <= built_in[i].most && step < built_in[i].step * peak,
              "%s: peak %g, steps of %g", built_in[i].name, peak, step);
        t_note("%s: %.4f facing up, peak %.1f, steps up to %.1f", built_in[i].name, is, peak, step);
        kit_image_free(&env);
    }
    CHECK(kit_env_read(&env, "dusk", &err) == -1 && strstr(err.text, "dusk") && strstr(err.text, "probe"), "\"%s\"",
          err.text);

    const kit_light sun = { KIT_SUN, { 0.6f, -0.48f, 0.64f }, { 3, 2, 1 } };
    for (int k = 0; k < 2; ++k) {                       /* 0: on a black ground; 1: on white */
        if (k && !CHECK(!kit_env_read(&env, "white", &err), "%s", err.text)) return;
        if (!CHECK(!kit_env_add_sun(&env, &sun, 3, &err), "%s", err.text)) return;
        const double is = facing(&env, sun.at, &peak, &step) - k,
                     should = (0.2126 * 3 + 0.7152 * 2 + 0.0722) / acos(-1);
        CHECK(fabs(is / should - 1) < 1e-3, "a sun brings %.5f, not %.5f", is, should);
        t_note("a sun's disc: irradiance off by %.1e", is / should - 1);
        kit_image_free(&env);
    }
    CHECK(kit_env_add_sun(&env, &sun, 0.1, &err) == -1 && kit_env_add_sun(&env, &sun, (double)NAN, NULL) == -1
              && !env.data,
          "a sun smaller than a texel: \"%s\"", err.text);
}

/* ---- threads ----------------------------------------------------------------------------------------------------- */

static void count_visit(void *context, int i) { ++((unsigned char *)context)[i]; }

static void parallel(void)
{
    static const int counts[] = { 0, 1, 7, 100003 };
    static const char *const threads[] = { "1", "3", "16", "nonsense" };
    static unsigned char visits[100003];
    for (int k = 0; k < 16; ++k) {
        const int count = counts[k / 4];
        int wrong = 0;
        memset(visits, 0, sizeof visits);
        setenv("KIT_THREADS", threads[k % 4], 1);
        kit_parallel(k % 2 ? "counting" : NULL, count, count_visit, visits);
        for (int i = 0; i < 100003; ++i) wrong += visits[i] != (i < count);
        CHECK(wrong == 0, "%d of %d indices were not visited once (KIT_THREADS=%s)", wrong, count, threads[k % 4]);
    }
    unsetenv("KIT_THREADS");
}

void test_files(void)
{
    if (!folder_begin()) return;
    RUN("an EXR read back is what was written: every bit, every channel", exr_round_trip);
    RUN("parts of an EXR are one picture, but for those of another view; its camera is the whole's", exr_of_parts);
    RUN("an EXR cut off anywhere is one clear error", exr_truncated);
    RUN("absent, empty and deep pictures, and folders, are clear errors", exr_bad);
    RUN("whatever packs an EXR, it is read, and refused where it claims more than it can hold", exr_claims);
    RUN("a frame's camera is written as OpenEXR's standard has it, and read back; so is that of a part", exr_camera);
    RUN("a malformed camera is an error that names the attribute, unless nobody asks", exr_camera_bad);
    RUN("what cannot be written leaves nothing behind and the old file alone", unwritable);
    RUN("damaged pictures neither crash nor trip a sanitizer", fuzzed);
    RUN("README's charts stand on white, and are drawn of the csv beside them, as its tables and BENCH's are", charts);
    RUN("figures of full runs take their parts of the page, others stay; of a broken record none", figures);
    RUN("a Radiance HDR gives the values of its format, a cut one an error", hdr);
    RUN("a Radiance HDR that is wrong, or claims more than it holds, is a clear error", hdr_bad);
    RUN("scores and difference colours agree with figures worked out by hand", score);
    RUN("edges, border and interior: tilted planes and folds are no edges, jumps and rails are", places);
    RUN("SSIM agrees with its definition", ssim);
    RUN("an OBJ with every quirk gives exactly its triangles", obj_quirks);
    RUN("a bad OBJ is an error that names file, line and fault", obj_bad);
    RUN("objects of an OBJ are told apart by o, by g, by what hangs together", obj_objects);
    RUN("rooms and sheets do not cast; what is placed elsewhere is there, all else as it was", objects_cast_and_move);
    RUN("truth between objects: a ball on a plane, casting or not", truth_of_objects);
    RUN("built-in environments are as bright as they say, with soft edges; a sun's disc brings the sun's light",
        environments);
    RUN("threads visit each index exactly once", parallel);
    folder_end();
}
