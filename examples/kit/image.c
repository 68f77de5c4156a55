/* image.c - float pictures: EXR in and out, HDR in, PNG out, scores, difference colours. */
#include "kit.h"

#include <math.h>
#include <OpenEXR/ImfCRgbaFile.h>
#include <OpenEXR/openexr.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
#define STBI_ONLY_HDR
#define STBI_ONLY_PNG                      /* for the tests, which read back what was written */
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
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

/* A file in memory, and OpenEXR's first complaint about it (the later ones are consequences). */
typedef struct memory_file {
    char  *data;
    size_t size, capacity;
    char   complaint[256];
} memory_file;

static void exr_complaint(exr_const_context_t context, exr_result_t code, const char *message)
{
    void *user = NULL;
    (void)code;
    if (!context || exr_get_user_data(context, &user) != EXR_ERR_SUCCESS || !user) return;
    memory_file *file = user;
    if (!file->complaint[0]) snprintf(file->complaint, sizeof file->complaint, "%s", message);
}

static int64_t exr_memory_size(exr_const_context_t context, void *user)
{
    (void)context;
    return (int64_t)((memory_file *)user)->size;
}

static int64_t exr_memory_read(exr_const_context_t context, void *user, void *buffer, uint64_t size, uint64_t offset,
                               exr_stream_error_func_ptr_t error)
{
    const memory_file *file = user;
    (void)context, (void)error;
    uint64_t left = offset < file->size ? file->size - offset : 0;
    if (size > left) size = left;          /* the library asks for more than it needs while it reads headers */
    memcpy(buffer, file->data + (left ? offset : 0), size);
    return (int64_t)size;
}

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

static int exr_fail(kit_error *err, const char *path, const memory_file *file, exr_result_t result)
{
    return kit_fail(err, "%s: %s", path, file->complaint[0] ? file->complaint : exr_get_default_error_message(result));
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
    ImfRgba *row = malloc((size_t)image->width * sizeof *row);
    ImfInputFile *file = row ? ImfOpenInputFile(path) : NULL;
    int good = file != NULL;
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
    if (!good) kit_fail(err, "%s: %s", path, row ? ImfErrorMessage() : "no memory");
    if (file) ImfCloseInputFile(file);
    free(row);
    return good ? 0 : -1;
}

static int exr_read_part(kit_image *out, const char *path, exr_const_context_t context, const memory_file *file,
                         kit_error *err)
{
    const exr_attr_chlist_t *list = NULL;
    exr_attr_box2i_t window;
    exr_storage_t storage;
    exr_result_t result = exr_get_storage(context, 0, &storage);
    if (result == EXR_ERR_SUCCESS && storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
        return kit_fail(err, "%s: deep EXR files are not supported", path);
    if (result == EXR_ERR_SUCCESS) result = exr_get_channels(context, 0, &list);
    if (result == EXR_ERR_SUCCESS) result = exr_get_data_window(context, 0, &window);
    if (result != EXR_ERR_SUCCESS) return exr_fail(err, path, file, result);
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

    kit_image image;
    if (image_alloc(&image, (int)width, (int)height, list->num_channels, path, err)) return -1;
    for (int c = 0; c < list->num_channels; ++c)
        snprintf(image.name[c], sizeof image.name[c], "%s", list->entries[c].name.str);
    result = exr_read_pixels(context, storage == EXR_STORAGE_TILED, &window, &image);
    int failed = 0;
    if (result == EXR_ERR_FEATURE_NOT_IMPLEMENTED) failed = exr_read_rgba(&image, path, &window, err);
    else if (result != EXR_ERR_SUCCESS) failed = exr_fail(err, path, file, result);
    if (failed) kit_image_free(&image);
    else *out = image;
    return failed;
}

static exr_context_initializer_t exr_initializer(memory_file *file)
{
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    start.error_handler_fn = exr_complaint;
    start.user_data = file;
    return start;
}

int kit_exr_read(kit_image *image, const char *path, kit_error *err)
{
    memory_file file = { 0 };
    exr_context_t context = NULL;
    if (kit_file_read(&file.data, &file.size, path, err)) return -1;
    exr_context_initializer_t start = exr_initializer(&file);
    start.read_fn = exr_memory_read;
    start.size_fn = exr_memory_size;
    start.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;   /* a damaged file is an error, not a guess */
    exr_result_t result = exr_start_read(&context, path, &start);
    int failed = result == EXR_ERR_SUCCESS ? exr_read_part(image, path, context, &file, err)
                                           : exr_fail(err, path, &file, result);
    if (context) exr_finish(&context);
    free(file.data);
    return failed;
}

static exr_result_t exr_write_pixels(exr_context_t context, const kit_image *image)
{
    exr_encode_pipeline_t encode = EXR_ENCODE_PIPELINE_INITIALIZER;
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
        if (first && result == EXR_ERR_SUCCESS) result = exr_encoding_choose_default_routines(context, 0, &encode);
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
    /* 3.1 hangs after it has refused a channel */
    for (int c = 0; c < image->channels; ++c)
        if (!image->name[c][0]
            || kit_image_channel(image, image->name[c]) != image->data + (size_t)c * image_pixels(image))
            return kit_fail(err, "%s: channel name \"%s\" is empty or comes twice", path, image->name[c]);
    exr_context_initializer_t start = exr_initializer(&file);
    start.write_fn = exr_memory_write;
    start.zip_level = 4;                   /* a few per cent larger than the default 6, twice as fast */
    exr_result_t result = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &start);
    if (result == EXR_ERR_SUCCESS) result = exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &part);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, 0, image->width, image->height, EXR_COMPRESSION_ZIP);
    for (int c = 0; c < image->channels && result == EXR_ERR_SUCCESS; ++c)
        result = exr_add_channel(context, 0, image->name[c], EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    if (result == EXR_ERR_SUCCESS) result = exr_write_header(context);
    if (result == EXR_ERR_SUCCESS) result = exr_write_pixels(context, image);
    if (context) {
        exr_result_t finished = exr_finish(&context);                          /* writes the chunk table */
        if (result == EXR_ERR_SUCCESS) result = finished;
    }
    int failed = result == EXR_ERR_SUCCESS ? kit_file_write(path, file.data, file.size, err)
                                           : exr_fail(err, path, &file, result);
    free(file.data);
    return failed;
}

/* ---- HDR and PNG -------------------------------------------------------------------------------------------- */

typedef struct hdr_source { const char *data; int size, at, starved; } hdr_source;

/* stb takes missing bytes for zeros, or waits for ever for others (2.28: a run of none). It asks for 128 when its
   buffer is empty and for exact small numbers otherwise: a reply of nothing, or of part of a small request, means that
   the file is cut off. */
static int hdr_read(void *user, char *data, int size)
{
    hdr_source *s = user;
    int n = s->size - s->at < size ? s->size - s->at : size;
    memcpy(data, s->data + s->at, (size_t)n);
    s->at += n;
    if (n > 0 && (n == size || size >= 128)) return n;
    s->starved = 1;
    memset(data + n, '\n', (size_t)(size - n));  /* ends a header, and every loop over pixels */
    return size;
}
static void hdr_skip(void *user, int n) { ((hdr_source *)user)->at += n; }
static int  hdr_end(void *user) { return ((hdr_source *)user)->at >= ((hdr_source *)user)->size; }

int kit_hdr_read(kit_image *image, const char *path, kit_error *err)
{
    const stbi_io_callbacks callbacks = { hdr_read, hdr_skip, hdr_end };
    char *data;
    size_t size;
    int width, height, channels, failed = 0;
    if (kit_file_read(&data, &size, path, err)) return -1;
    hdr_source source = { data, size > INT32_MAX ? INT32_MAX : (int)size, 0, 0 };
    int is_hdr = stbi_is_hdr_from_memory((const stbi_uc *)data, source.size);
    float *rgb = is_hdr ? stbi_loadf_from_callbacks(&callbacks, &source, &width, &height, &channels, 3) : NULL;
    if (!is_hdr) failed = kit_fail(err, "%s: is not a Radiance HDR picture", path);
    else if (source.starved) failed = kit_fail(err, "%s: the file ends too early", path);
    else if (!rgb) failed = kit_fail(err, "%s: %s", path, stbi_failure_reason());
    else failed = image_alloc(image, width, height, 3, path, err);
    for (int c = 0; c < 3 && !failed; ++c) image->name[c][0] = "RGB"[c];
    if (!failed)
        for (size_t i = 0, n = image_pixels(image); i < n; ++i)
            for (size_t c = 0; c < 3; ++c) image->data[c * n + i] = rgb[3 * i + c];
    stbi_image_free(rgb);
    free(data);
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
