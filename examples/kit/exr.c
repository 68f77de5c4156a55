/* exr.c - EXR in and out, through OpenEXR's C core. Declared in kit.h. */
#include "kit/kit_image.h"
#include <errno.h>
#include <OpenEXR/ImfCRgbaFile.h>
#include <OpenEXR/openexr.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

static int64_t exr_memory_write(exr_const_context_t context, void *user, const void *buffer, uint64_t size,
                                uint64_t offset, exr_stream_error_func_ptr_t error)
{
    kit_memory_file *file = user;
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
    if (kit_image_alloc(&image, (int)width, (int)height, list->num_channels, path, err)) return -1;
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
    kit_memory_file file = { 0 };
    exr_context_t context = NULL;
    int part;
    exr_context_initializer_t start = exr_initializer(&file);
    start.write_fn = exr_memory_write;
    start.zip_level = KIT_ZIP_LEVEL;
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
