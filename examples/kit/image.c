/* image.c - float pictures: EXR in and out, HDR in, PNG out, scores, difference colours. */
#include "kit/kit.h"

#include <errno.h>
#include <math.h>
#include <OpenEXR/ImfCRgbaFile.h>
#include <OpenEXR/openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zlib.h>

enum { ZIP_LEVEL = 4 };                    /* a few per cent larger than zlib's own 6, twice as fast */

/* A PNG's bytes through zlib: what stb has for it ends the program when memory does. */
static unsigned char *png_deflate(unsigned char *data, int size, int *packed, int level)
{
    uLongf bytes = compressBound((uLong)size);
    unsigned char *out = malloc(bytes);
    (void)level;
    if (out && compress2(out, &bytes, data, (uLong)size, ZIP_LEVEL) != Z_OK) {
        free(out);
        out = NULL;
    }
    *packed = (int)bytes;
    return out;
}

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG                      /* for the tests, which read back what was written */
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS png_deflate
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif


/* ---- pictures ----------------------------------------------------------------------------------------------- */

static int image_alloc(kit_image *image, int width, int height, int channels, const char *what, kit_error *err)
{
    size_t pixels = (size_t)(width > 0 ? width : 0) * (size_t)(height > 0 ? height : 0);
    if (width <= 0 || height <= 0 || width > 65536 || height > 65536 || pixels > ((size_t)1 << 30) / (size_t)channels)
        return kit_fail(err, "%s: a picture of %d x %d with %d channels is not supported", what, width, height,
                        channels);
    float *data = calloc(pixels * (size_t)channels, sizeof *data);
    if (!data)
        return kit_fail(err, "%s: no memory for a picture of %d x %d with %d channels", what, width, height, channels);
    memset(image, 0, sizeof *image);
    image->width = width;
    image->height = height;
    image->channels = channels;
    image->data = data;
    return 0;
}

static size_t image_pixels(const kit_image *image) { return (size_t)image->width * (size_t)image->height; }

int kit_image_new(kit_image *image, int width, int height, const char *names, kit_error *err)
{
    char   name[KIT_MAX_CHANNELS][32] = {{0}};
    int    channels = 0;
    for (const char *p = names;; ++p) {
        size_t length = strcspn(p, ",");
        if (length == 0 || length >= sizeof name[0] || channels == KIT_MAX_CHANNELS)
            return kit_fail(err, "channels \"%s\": at most %d names of 1 to 31 characters, separated by commas", names,
                            KIT_MAX_CHANNELS);
        memcpy(name[channels], p, length);
        for (int c = 0; c < channels; ++c)
            if (!strcmp(name[c], name[channels]))
                return kit_fail(err, "channels \"%s\": %s comes twice", names, name[c]);
        ++channels;
        p += length;
        if (!*p) break;
    }
    if (image_alloc(image, width, height, channels, "new picture", err)) return -1;
    memcpy(image->name, name, sizeof name);
    return 0;
}

void kit_image_free(kit_image *image)
{
    free(image->data);
    memset(image, 0, sizeof *image);
}

float *kit_image_channel(const kit_image *image, const char *name)
{
    for (int c = 0; c < image->channels; ++c)
        if (!strcmp(image->name[c], name)) return image->data + (size_t)c * image_pixels(image);
    return NULL;
}

/* ---- EXR ---------------------------------------------------------------------------------------------------- */

/* What went wrong in OpenEXR: its first complaint (the later ones are consequences), and whether memory ran out, which
   it may pass over: a header then lacks a line, and is taken for another. They are the thread's, because no callback is
   told whose they are, and a context that is asked may wait for the lock that it complains under. */
static _Thread_local struct { char complaint[256]; int starved; } exr_trouble;

static void exr_complaint(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context, (void)code;
    if (!exr_trouble.complaint[0]) snprintf(exr_trouble.complaint, sizeof exr_trouble.complaint, "%s", message);
}

static void *exr_allocate(size_t bytes)
{
    void *data = malloc(bytes);
    if (!data) exr_trouble.starved = 1;
    return data;
}

/* user: what the callbacks below get. */
static exr_context_initializer_t exr_initializer(void *user)
{
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    memset(&exr_trouble, 0, sizeof exr_trouble);
    errno = 0;
    start.error_handler_fn = exr_complaint;
    start.alloc_fn = exr_allocate;
    start.free_fn = free;
    start.user_data = user;
    return start;
}

/* The older interface's memory, and zlib's, does not come from the context; when zlib has none, OpenEXR takes the file
   for a damaged one. errno tells. */
static int exr_fail(kit_error *err, const char *path, const char *why)
{
    if (exr_trouble.starved || errno == ENOMEM) why = "there is not enough memory for it";
    return kit_fail(err, "%s: %s", path, why);
}

static int exr_fail_result(kit_error *err, const char *path, exr_result_t result)
{
    return exr_fail(err, path,
                    exr_trouble.complaint[0] ? exr_trouble.complaint : exr_get_default_error_message(result));
}

typedef struct exr_source { int file; size_t size; } exr_source;

static int64_t exr_source_size(exr_const_context_t context, void *user)
{
    (void)context;
    return (int64_t)((const exr_source *)user)->size;
}

/* Less than wanted at the file's end: the library asks for more than it needs while it reads headers. */
static int64_t exr_source_read(exr_const_context_t context, void *user, void *buffer, uint64_t size, uint64_t offset,
                               exr_stream_error_func_ptr_t error)
{
    const exr_source *source = user;
    int64_t got = 0;
    while ((uint64_t)got < size && offset <= INT64_MAX - size) {
        const ssize_t n = pread(source->file, (char *)buffer + got, size - (uint64_t)got, (off_t)offset + got);
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) {
            error(context, EXR_ERR_READ_IO, "cannot be read: %s", strerror(errno));
            return -1;
        }
        if (n == 0) break;
        got += n;
    }
    return got;
}

typedef struct memory_file { char *data; size_t size, capacity; } memory_file;

static int64_t exr_memory_write(exr_const_context_t context, void *user, const void *buffer, uint64_t size,
                                uint64_t offset, exr_stream_error_func_ptr_t error)
{
    memory_file *file = user;
    size_t end = offset + size;
    if (end > file->capacity) {
        size_t capacity = 2 * end;
        char *data = realloc(file->data, capacity);
        if (!data) {
            error(context, EXR_ERR_OUT_OF_MEMORY, "no memory");
            return -1;
        }
        memset(data + file->capacity, 0, capacity - file->capacity);
        file->data = data;
        file->capacity = capacity;
    }
    memcpy(file->data + offset, buffer, size);
    if (end > file->size) file->size = end;
    return (int64_t)size;
}

/* One chunk (some scanlines or a tile) straight into the planar picture; origin: its top-left pixel in the picture. */
static exr_result_t exr_read_chunk_into(exr_const_context_t context, exr_decode_pipeline_t *decode,
                                        const exr_chunk_info_t *chunk, int x, int y, kit_image *image)
{
    int first = decode->context == NULL;
    exr_result_t result =
        first ? exr_decoding_initialize(context, 0, chunk, decode) : exr_decoding_update(context, 0, chunk, decode);
    if (result != EXR_ERR_SUCCESS) return result;
    if (x < 0 || y < 0 || chunk->width > image->width - x || chunk->height > image->height - y)
        return EXR_ERR_CORRUPT_CHUNK;
    for (int c = 0; c < decode->channel_count; ++c) {
        exr_coding_channel_info_t *channel = &decode->channels[c];
        channel->decode_to_ptr =
            (uint8_t *)(image->data + ((size_t)c * (size_t)image->height + (size_t)y) * (size_t)image->width + x);
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = 4;
        channel->user_pixel_stride = 4;
        channel->user_line_stride = 4 * image->width;
    }
    if (first) result = exr_decoding_choose_default_routines(context, 0, decode);
    return result == EXR_ERR_SUCCESS ? exr_decoding_run(context, 0, decode) : result;
}

static exr_result_t exr_read_pixels(exr_const_context_t context, int tiled, const exr_attr_box2i_t *window,
                                    kit_image *image)
{
    exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
    exr_chunk_info_t chunk;
    exr_result_t result = EXR_ERR_SUCCESS;
    int32_t width = image->width, height = 0;
    if (tiled) result = exr_get_tile_sizes(context, 0, 0, 0, &width, &height);
    else result = exr_get_scanlines_per_chunk(context, 0, &height);
    if (result == EXR_ERR_SUCCESS && (width < 1 || height < 1)) result = EXR_ERR_INVALID_ATTR;
    for (int y = 0; y < image->height && result == EXR_ERR_SUCCESS; y += height)
        for (int x = 0; x < image->width && result == EXR_ERR_SUCCESS; x += width) {
            if (tiled) result = exr_read_tile_chunk_info(context, 0, x / width, y / height, 0, 0, &chunk);
            else result = exr_read_scanline_chunk_info(context, 0, window->min.y + y, &chunk);
            if (result == EXR_ERR_SUCCESS) result = exr_read_chunk_into(context, &decode, &chunk, x, y, image);
        }
    exr_decoding_destroy(context, &decode);
    return result;
}

/* For what the C core cannot decompress (DWAA, DWAB in 3.1): OpenEXR's older C interface. It knows RGB(A) only, as half
   floats. */
static int exr_read_rgba(kit_image *image, const char *path, const exr_attr_box2i_t *window, kit_error *err)
{
    static const char *const rgba[] = { "R", "G", "B", "A" };
    float *to[4];
    int    found = 0;
    for (int c = 0; c < 4; ++c) found += (to[c] = kit_image_channel(image, rgba[c])) != NULL;
    if (found != image->channels || !to[0] || !to[1] || !to[2])
        return kit_fail(err, "%s: its compression (DWAA or DWAB) is supported for the channels R, G, B (and A) alone",
                        path);
    ImfRgba *row = exr_allocate((size_t)image->width * sizeof *row);
    ImfInputFile *file = row ? ImfOpenInputFile(path) : NULL;
    exr_attr_box2i_t is = *window;
    if (file) ImfHeaderDataWindow(ImfInputHeader(file), &is.min.x, &is.min.y, &is.max.x, &is.max.y);
    const int same = !memcmp(&is, window, sizeof is);
    int good = file && same;
    for (int y = 0; y < image->height && good; ++y) {
        /* the base pointer is that of pixel (0, 0) of the data window's coordinates */
        ImfRgba *base = (ImfRgba *)((uintptr_t)row - (uintptr_t)((intptr_t)window->min.x * (intptr_t)sizeof *row));
        good =
            ImfInputSetFrameBuffer(file, base, 1, 0) && ImfInputReadPixels(file, window->min.y + y, window->min.y + y);
        for (int x = 0; x < image->width && good; ++x) {
            const ImfHalf pixel[4] = { row[x].r, row[x].g, row[x].b, row[x].a };
            for (int c = 0; c < 4; ++c)
                if (to[c]) to[c][(size_t)y * (size_t)image->width + (size_t)x] = ImfHalfToFloat(pixel[c]);
        }
    }
    if (!good) exr_fail(err, path, same ? ImfErrorMessage() : "has become another picture meanwhile");
    if (file) ImfCloseInputFile(file);
    free(row);
    return good ? 0 : -1;
}

/* Whether a file can hold what its header claims, told before anything is allocated for it: a byte of it holds so many
   bytes of pixels at most, and each chunk has a place in the table. deflate (ZIP, ZIPS) makes one of 1032; runs are of
   128 in two bytes; PIZ repeats 255 halves in 9 bits; PXR24 deflates three bytes of a float; B44A has blocks of 32
   bytes in 3; DWA deflates two halves for 64 floats, or runs. */
static int exr_fits(exr_const_context_t context, const exr_attr_chlist_t *list, int64_t pixels, size_t size)
{
    static const double most[] = {
        [EXR_COMPRESSION_NONE] = 1,          [EXR_COMPRESSION_RLE] = 64,           [EXR_COMPRESSION_ZIPS] = 1032,
        [EXR_COMPRESSION_ZIP] = 1032,        [EXR_COMPRESSION_PIZ] = 510 * 8 / 9., [EXR_COMPRESSION_PXR24] = 1376,
        [EXR_COMPRESSION_B44] = 32 / 3.,     [EXR_COMPRESSION_B44A] = 32 / 3.,     [EXR_COMPRESSION_DWAA] = 64 * 1032,
        [EXR_COMPRESSION_DWAB] = 64 * 1032
    };
    exr_compression_t compression;
    int32_t chunks;
    double bytes = 0;
    if (exr_get_compression(context, 0, &compression) != EXR_ERR_SUCCESS
        || exr_get_chunk_count(context, 0, &chunks) != EXR_ERR_SUCCESS) return 0;
    if ((size_t)compression >= sizeof most / sizeof *most) return 1;           /* it will say what it is */
    for (int c = 0; c < list->num_channels; ++c)
        bytes += (list->entries[c].pixel_type == EXR_PIXEL_HALF ? 2 : 4) * (double)pixels;
    return bytes / most[compression] + 8.0 * chunks <= (double)size;
}

static int exr_read_part(kit_image *out, const char *path, exr_const_context_t context, size_t size, kit_error *err)
{
    const exr_attr_chlist_t *list = NULL;
    exr_attr_box2i_t window;
    exr_storage_t storage;
    exr_result_t result = exr_get_storage(context, 0, &storage);
    if (result == EXR_ERR_SUCCESS && storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        return kit_fail(err, "%s: deep EXR files are not supported", path);
    if (result == EXR_ERR_SUCCESS) result = exr_get_channels(context, 0, &list);
    if (result == EXR_ERR_SUCCESS) result = exr_get_data_window(context, 0, &window);
    if (result != EXR_ERR_SUCCESS || exr_trouble.starved) return exr_fail_result(err, path, result);
    if (list->num_channels < 1 || list->num_channels > KIT_MAX_CHANNELS)
        return kit_fail(err, "%s: %d channels; 1 to %d are supported", path, list->num_channels, KIT_MAX_CHANNELS);
    for (int c = 0; c < list->num_channels; ++c) {
        const exr_attr_chlist_entry_t *entry = &list->entries[c];
        if (entry->x_sampling != 1 || entry->y_sampling != 1)
            return kit_fail(err, "%s: channel %s is subsampled, which is not supported", path, entry->name.str);
        if (entry->name.length > 31)
            return kit_fail(err, "%s: channel name %s is longer than 31 characters", path, entry->name.str);
    }
    int64_t width = (int64_t)window.max.x - window.min.x + 1, height = (int64_t)window.max.y - window.min.y + 1;
    if (width < 1 || height < 1 || width > 65536 || height > 65536)
        return kit_fail(err, "%s: a picture of %lld x %lld is not supported", path, (long long)width,
                        (long long)height);
    if (!exr_fits(context, list, width * height, size))
        return kit_fail(err, "%s: its header claims %lld x %lld pixels of %d channels, which its %zu bytes cannot hold",
                        path, (long long)width, (long long)height, list->num_channels, size);

    kit_image image;
    if (image_alloc(&image, (int)width, (int)height, list->num_channels, path, err)) return -1;
    for (int c = 0; c < list->num_channels; ++c)
        snprintf(image.name[c], sizeof image.name[c], "%s", list->entries[c].name.str);
    result = exr_read_pixels(context, storage == EXR_STORAGE_TILED, &window, &image);
    int failed = 0;
    if (result == EXR_ERR_FEATURE_NOT_IMPLEMENTED) failed = exr_read_rgba(&image, path, &window, err);
    else if (result != EXR_ERR_SUCCESS) failed = exr_fail_result(err, path, result);
    if (failed) kit_image_free(&image);
    else *out = image;
    return failed;
}

int kit_exr_read(kit_image *image, const char *path, kit_error *err)
{
    exr_source source = { 0 };
    exr_context_t context = NULL;
    FILE *file = kit_file_open(&source.size, path, err);
    if (!file) return -1;
    source.file = fileno(file);
    exr_context_initializer_t start = exr_initializer(&source);
    start.read_fn = exr_source_read;
    start.size_fn = exr_source_size;
    start.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;   /* a damaged file is an error, not a guess */
    exr_result_t result = exr_start_read(&context, path, &start);
    int failed = result == EXR_ERR_SUCCESS ? exr_read_part(image, path, context, source.size, err)
                                           : exr_fail_result(err, path, result);
    if (context) exr_finish(&context);
    fclose(file);
    return failed;
}

typedef struct exr_packer { exr_result_t (*compress)(exr_encode_pipeline_t *encode); } exr_packer;

/* A chunk as large as its pixels is read as if it were they: it has to be. OpenEXR writes what zlib made of them, when
   that has just their size. */
static exr_result_t exr_compress(exr_encode_pipeline_t *encode)
{
    const exr_packer *packer = encode->encoding_user_data;
    const exr_result_t result = packer->compress(encode);
    if (result == EXR_ERR_SUCCESS && encode->compressed_bytes >= encode->packed_bytes) {
        memcpy(encode->compressed_buffer, encode->packed_buffer, encode->packed_bytes);
        encode->compressed_bytes = encode->packed_bytes;
    }
    return result;
}

static exr_result_t exr_write_pixels(exr_context_t context, const kit_image *image)
{
    exr_encode_pipeline_t encode = EXR_ENCODE_PIPELINE_INITIALIZER;
    exr_packer packer;
    exr_chunk_info_t chunk;
    int32_t lines = 1;
    exr_result_t result = exr_get_scanlines_per_chunk(context, 0, &lines);
    for (int y = 0; y < image->height && result == EXR_ERR_SUCCESS; y += lines) {
        int first = y == 0;
        result = exr_write_scanline_chunk_info(context, 0, y, &chunk);
        if (result == EXR_ERR_SUCCESS)
            result = first ? exr_encoding_initialize(context, 0, &chunk, &encode)
                           : exr_encoding_update(context, 0, &chunk, &encode);
        for (int c = 0; result == EXR_ERR_SUCCESS && c < encode.channel_count; ++c) {
            exr_coding_channel_info_t *channel = &encode.channels[c];          /* in the file's order: sorted by name */
            channel->encode_from_ptr =
                (const uint8_t *)(kit_image_channel(image, channel->channel_name) + (size_t)y * (size_t)image->width);
            channel->user_data_type = EXR_PIXEL_FLOAT;
            channel->user_bytes_per_element = 4;
            channel->user_pixel_stride = 4;
            channel->user_line_stride = 4 * image->width;
        }
        if (first && result == EXR_ERR_SUCCESS) {
            result = exr_encoding_choose_default_routines(context, 0, &encode);
            packer.compress = encode.compress_fn;
            encode.encoding_user_data = &packer;
            encode.compress_fn = exr_compress;
        }
        if (result == EXR_ERR_SUCCESS) result = exr_encoding_run(context, 0, &encode);
    }
    exr_encoding_destroy(context, &encode);
    return result;
}

int kit_exr_write(const kit_image *image, const char *path, kit_error *err)
{
    memory_file file = { 0 };
    exr_context_t context = NULL;
    int part;
    exr_context_initializer_t start = exr_initializer(&file);
    start.write_fn = exr_memory_write;
    start.zip_level = ZIP_LEVEL;
    exr_result_t result = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &start);
    if (result == EXR_ERR_SUCCESS) result = exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &part);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, 0, image->width, image->height, EXR_COMPRESSION_ZIP);
    for (int c = 0; c < image->channels && result == EXR_ERR_SUCCESS; ++c)
        result = exr_add_channel(context, 0, image->name[c], EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    if (result == EXR_ERR_SUCCESS) result = exr_write_header(context);
    if (result == EXR_ERR_SUCCESS) result = exr_write_pixels(context, image);
    int failed = result == EXR_ERR_SUCCESS ? 0 : exr_fail_result(err, path, result);
    if (context && exr_finish(&context) != EXR_ERR_SUCCESS && !failed) failed = exr_fail_result(err, path, result);
    if (!failed) failed = kit_file_write(path, file.data, file.size, err);
    free(file.data);
    return failed;
}

/* ---- HDR and PNG -------------------------------------------------------------------------------------------- */

/* Radiance's format: lines of text, an empty one, the size, then a row after the other of three mantissas and an
   exponent a pixel, flat or each of the four in runs. Not through stb, which takes missing bytes for zeros, makes room
   for whatever a header claims, and has the picture twice. */
typedef struct hdr_source { FILE *file; int left; char line[64]; } hdr_source;

static const char hdr_short[] = "the file ends too early";

/* The header's next line, as much of it as fits; NULL, or what is wrong. */
static const char *hdr_line(hdr_source *s)
{
    size_t length = 0;
    for (int c; (c = getc_unlocked(s->file)) != '\n';) {
        if (c == EOF) return hdr_short;
        if (!s->left--) return "its header does not end within a megabyte";
        if (length + 1 < sizeof s->line) s->line[length++] = (char)c;
    }
    s->line[length] = 0;
    return NULL;
}

static const char *hdr_header(hdr_source *s, int *width, int *height)
{
    const char *wrong = hdr_line(s);
    int known = 0, end = 0;
    if (strcmp(s->line, "#?RADIANCE") && strcmp(s->line, "#?RGBE")) return "is not a Radiance HDR picture";
    while (!wrong && !(wrong = hdr_line(s)) && s->line[0]) known |= !strcmp(s->line, "FORMAT=32-bit_rle_rgbe");
    if (wrong) return wrong;
    if (!known) return "its header must say FORMAT=32-bit_rle_rgbe";
    if ((wrong = hdr_line(s)) != NULL) return wrong;
    if (sscanf(s->line, "-Y %7d +X %7d%n", height, width, &end) != 2 || s->line[end])
        return "its size must be -Y HEIGHT +X WIDTH";
    return NULL;
}

/* Whether rows of such a width may be in runs. */
static int hdr_coded(int width) { return width >= 8 && width < 32768; }

/* The fewest bytes of a row: runs are of 127 at most, in two bytes. */
static double hdr_fewest(int width)
{
    return hdr_coded(width) ? fmin(4.0 * width, 4 + 4 * 2 * ceil(width / 127.0)) : 4.0 * width;
}

static const char *hdr_row(FILE *file, unsigned char (*row)[4], int width)
{
    const size_t pixels = (size_t)width;
    if (fread(row, 4, 1, file) != 1) return hdr_short;
    if (!hdr_coded(width) || row[0][0] != 2 || row[0][1] != 2 || row[0][2] > 127) {
        const size_t got = 1 + fread(row + 1, 4, pixels - 1, file);
        for (size_t x = 0; x < got; ++x)
            if (row[x][0] == 1 && row[x][1] == 1 && row[x][2] == 1) return "its old way of runs is not supported";
        return got < pixels ? hdr_short : NULL;
    }
    if ((row[0][2] << 8 | row[0][3]) != width) return "a row has another width than the picture";
    for (int c = 0; c < 4; ++c)
        for (int x = 0; x < width;) {
            int count = getc_unlocked(file), value = 0;
            const int run = count > 128;
            if (run) count -= 128;
            if (count == EOF) return hdr_short;
            if (!count || count > width - x) return "a run does not fit its row";
            for (int k = 0; k < count; ++k) {
                if (!run || !k) value = getc_unlocked(file);
                if (value == EOF) return hdr_short;
                row[x++][c] = (unsigned char)value;
            }
        }
    return NULL;
}

static const char *hdr_pixels(FILE *file, kit_image *image)
{
    const size_t width = (size_t)image->width, n = image_pixels(image);
    unsigned char (*row)[4] = malloc(4 * width);
    const char *wrong = row ? NULL : "there is not enough memory for it";
    for (size_t i = 0; i < n && !wrong; i += width) {
        wrong = hdr_row(file, row, image->width);
        for (size_t x = 0; x < width && !wrong; ++x) {
            const float unit = row[x][3] ? ldexpf(1, row[x][3] - 128 - 8) : 0;
            for (size_t c = 0; c < 3; ++c) image->data[c * n + i + x] = row[x][c] * unit;
        }
    }
    free(row);
    return wrong;
}

int kit_hdr_read(kit_image *image, const char *path, kit_error *err)
{
    hdr_source source = { .left = 1 << 20 };
    kit_image new_ = { 0 };
    size_t size;
    int width, height, failed = 0;
    if (!(source.file = kit_file_open(&size, path, err))) return -1;
    const char *wrong = hdr_header(&source, &width, &height);
    if (!wrong && hdr_fewest(width) * height > (double)size)
        failed = kit_fail(err, "%s: its header claims %d x %d pixels, which its %zu bytes cannot hold", path, width,
                          height, size);
    if (!wrong && !failed) failed = image_alloc(&new_, width, height, 3, path, err);
    for (int c = 0; c < 3; ++c) new_.name[c][0] = "RGB"[c];
    if (!wrong && !failed) wrong = hdr_pixels(source.file, &new_);
    fclose(source.file);
    if (wrong) failed = kit_fail(err, "%s: %s", path, wrong);
    if (failed) kit_image_free(&new_);
    else *image = new_;
    return failed;
}

static void png_append(void *user, void *data, int size)
{
    memory_file *file = user;              /* stb calls this once, with the whole file */
    file->data = malloc((size_t)size);
    if (!file->data) return;
    memcpy(file->data, data, (size_t)size);
    file->size = (size_t)size;
}

int kit_png_write(const kit_image *image, const char *names, int srgb, const char *path, kit_error *err)
{
    const float *from[3] = { NULL };
    int channels = 0;
    for (const char *p = names;; ++p) {
        size_t length = strcspn(p, ",");
        char name[32] = { 0 };
        memcpy(name, p, length < 31 ? length : 31);
        if (channels == 3) return kit_fail(err, "%s: a PNG takes 1 or 3 channels, not \"%s\"", path, names);
        if (!(from[channels++] = kit_image_channel(image, name)))
            return kit_fail(err, "%s: the picture has no channel %s", path, name);
        p += length;
        if (!*p) break;
    }
    if (channels == 2) return kit_fail(err, "%s: a PNG takes 1 or 3 channels, not \"%s\"", path, names);
    size_t n = image_pixels(image), k = (size_t)channels;
    memory_file file = { 0 };
    unsigned char *bytes = malloc(n * k);
    for (size_t i = 0; bytes && i < n * k; ++i) {
        double v = (double)from[i % k][i / k];
        v = v > 0 ? fmin(v, 1) : 0;        /* NaN becomes 0 */
        if (srgb) v = v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
        bytes[i] = (unsigned char)(255 * v + 0.5);
    }
    if (bytes)
        stbi_write_png_to_func(png_append, &file, image->width, image->height, channels, bytes,
                               image->width * channels);
    free(bytes);
    int failed = file.data ? kit_file_write(path, file.data, file.size, err)
                           : kit_fail(err, "%s: no memory to write a PNG", path);
    free(file.data);
    return failed;
}

/* ---- scores ------------------------------------------------------------------------------------------------- */

static int channel_pair(const float **ca, const float **cb, const kit_image *a, const kit_image *b, const char *channel,
                        kit_error *err)
{
    if (a->width != b->width || a->height != b->height)
        return kit_fail(err, "the pictures differ in size: %d x %d and %d x %d", a->width, a->height, b->width,
                        b->height);
    *ca = kit_image_channel(a, channel);
    *cb = kit_image_channel(b, channel);
    if (!*ca || !*cb) return kit_fail(err, "the %s picture has no channel %s", *ca ? "second" : "first", channel);
    return 0;
}

typedef struct ssim_job {
    const float *a, *b, *mask;
    int          width, height;
    double       gauss[11];
    /* a row; added up in order so that the result is the same for any number of threads */
    double      *sum;
    int         *count;
} ssim_job;

static int ssim_counts(const ssim_job *j, size_t i)
{
    return (!j->mask || j->mask[i] > 0) && isfinite(j->a[i]) && isfinite(j->b[i]);
}

/* SSIM [Wang et al. 2004] of one row on [0,1] data: the 11 x 11 window is separable, its weights are those of the
   pixels that count, made to add up to 1 again at borders and gaps. Strips keep the sums of the columns on the
   stack. */
static void ssim_row(void *context, int y)
{
    enum { STRIP = 256, REACH = 5, SUMS = 6 };
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    ssim_job *j = context;
    for (int x0 = 0; x0 < j->width; x0 += STRIP) {
        double column[STRIP + 2 * REACH][SUMS] = {{0}};
        int x1 = x0 + STRIP < j->width ? x0 + STRIP : j->width;
        for (int v = y < REACH ? -y : -REACH; v <= REACH && y + v < j->height; ++v)
            for (int x = x0 < REACH ? 0 : x0 - REACH; x < x1 + REACH && x < j->width; ++x) {
                size_t i = (size_t)(y + v) * (size_t)j->width + (size_t)x;
                if (!ssim_counts(j, i)) continue;
                double w = j->gauss[v + REACH], a = (double)j->a[i], b = (double)j->b[i], *s = column[x - x0 + REACH];
                s[0] += w; s[1] += w * a; s[2] += w * b; s[3] += w * a * a; s[4] += w * b * b; s[5] += w * a * b;
            }
        for (int x = x0; x < x1; ++x) {
            if (!ssim_counts(j, (size_t)y * (size_t)j->width + (size_t)x)) continue;
            double s[SUMS] = { 0 };
            for (int u = 0; u < 11; ++u)
                for (int k = 0; k < SUMS; ++k) s[k] += j->gauss[u] * column[x - x0 + u][k];
            double a = s[1] / s[0], b = s[2] / s[0];
            double aa = s[3] / s[0] - a * a, bb = s[4] / s[0] - b * b, ab = s[5] / s[0] - a * b;
            j->sum[y] += (2 * a * b + c1) * (2 * ab + c2) / ((a * a + b * b + c1) * (aa + bb + c2));
            j->count[y]++;
        }
    }
}

/* The smallest of the n values that at least share * n of them do not exceed. The bits of positive floats sort as the
   floats do, so two histograms of half the bits each find it exactly. */
static float quantile(const float *values, size_t n, double share, size_t *histogram)
{
    size_t   below = 0, rank = (size_t)ceil(share * (double)n);
    uint32_t high = 0;
    for (int half = 0; half < 2; ++half) {
        memset(histogram, 0, 65536 * sizeof *histogram);
        for (size_t i = 0; i < n; ++i) {
            uint32_t bits;
            memcpy(&bits, &values[i], 4);
            if (!half) histogram[bits >> 16]++;
            else if (bits >> 16 == high) histogram[bits & 65535]++;
        }
        uint32_t k = 0;
        while (k < 65535 && below + histogram[k] < rank) below += histogram[k++];
        high = half ? high << 16 | k : k;
    }
    float value;
    memcpy(&value, &high, 4);
    return value;
}

int kit_score_channel(kit_score *score, const kit_image *a, const kit_image *b, const char *channel, const float *mask,
                      kit_error *err)
{
    ssim_job job = { .mask = mask, .width = a->width, .height = a->height };
    if (channel_pair(&job.a, &job.b, a, b, channel, err)) return -1;
    size_t n = image_pixels(a), rows = (size_t)a->height, pixels = 0;
    float  *absolute = malloc(n * sizeof *absolute);
    size_t *histogram = malloc(65536 * sizeof *histogram);
    job.sum = calloc(rows, sizeof *job.sum);
    job.count = calloc(rows, sizeof *job.count);
    int failed = !absolute || !histogram || !job.sum || !job.count ? kit_fail(err, "no memory to compare pictures") : 0;

    double sum = 0, squares = 0;
    for (size_t i = 0; i < n && !failed; ++i) {
        if (mask && !(mask[i] > 0)) continue;
        double d = (double)job.a[i] - (double)job.b[i];
        if (job.a[i] == job.b[i]) d = 0;   /* two equal infinities */
        if (isnan(d)) continue;
        sum += d;
        squares += d * d;
        absolute[pixels++] = (float)fabs(d);
    }
    if (!failed && !pixels)
        failed =
            kit_fail(err, "nothing to compare in channel %s: no pixel is in the mask and a number in both pictures",
                     channel);
    if (!failed) {
        double ssim = 0, total = 0;
        for (int i = 0; i < 11; ++i) total += job.gauss[i] = exp(-(i - 5) * (i - 5) / (2 * 1.5 * 1.5));
        for (int i = 0; i < 11; ++i) job.gauss[i] /= total;
        kit_parallel(NULL, a->height, ssim_row, &job);
        total = 0;
        for (size_t y = 0; y < rows; ++y) { ssim += job.sum[y]; total += job.count[y]; }
        *score = (kit_score){ .rmse = sqrt(squares / (double)pixels),
                              .bias = sum / (double)pixels,
                              .p95 = (double)quantile(absolute, pixels, 0.95, histogram),
                              .ssim = ssim / total,
                              .pixels = pixels };
    }
    free(absolute); free(histogram); free(job.sum); free(job.count);
    return failed;
}

int kit_score_channels(kit_score *score, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                       const float *mask, kit_error *err)
{
    kit_score one, all = { 0 };
    for (int i = 0; i < count; ++i) {
        if (kit_score_channel(&one, a, b, channels[i], mask, err)) return -1;
        all.rmse += one.rmse * one.rmse / count;
        all.bias += one.bias / count;
        all.p95 += one.p95 / count;
        all.ssim += one.ssim / count;
        all.pixels = one.pixels;
    }
    all.rmse = sqrt(all.rmse);
    *score = all;
    return 0;
}

/* Straight lines in Oklab, so that equal differences look equally different: from near-white (L 0.96) to blue and red
   of the same lightness (0.50) and chroma (0.20), hues 262 and 27 degrees. As sRGB values, for a PNG written as it
   is. */
int kit_image_difference(kit_image *out, const kit_image *a, const kit_image *b, const char *channel, float range,
                         kit_error *err)
{
    const float *ca, *cb;
    kit_image image;
    if (channel_pair(&ca, &cb, a, b, channel, err)) return -1;
    if (!(range > 0 && isfinite(range)))
        return kit_fail(err, "the range of the difference must be > 0, not %g", (double)range);
    if (kit_image_new(&image, a->width, a->height, "R,G,B", err)) return -1;
    for (size_t i = 0, n = image_pixels(a); i < n; ++i) {
        double t = ca[i] == cb[i] ? 0 : fmax(-1, fmin(1, ((double)ca[i] - (double)cb[i]) / (double)range));
        if (isnan(ca[i]) || isnan(cb[i])) continue;                             /* black */
        double hue = (t < 0 ? 262 : 27) * 3.14159265358979 / 180, chroma = 0.20 * fabs(t), L = 0.96 - 0.46 * fabs(t);
        double A = chroma * cos(hue), B = chroma * sin(hue);
        double l = pow(L + 0.3963377774 * A + 0.2158037573 * B, 3), m = pow(L - 0.1055613458 * A - 0.0638541728 * B, 3),
               s = pow(L - 0.0894841775 * A - 1.2914855480 * B, 3);
        const double rgb[3] = { 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s };
        for (size_t c = 0; c < 3; ++c) {
            double v = fmax(0, fmin(1, rgb[c]));
            image.data[c * n + i] = (float)(v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055);
        }
    }
    *out = image;
    return 0;
}
