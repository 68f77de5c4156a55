/* exr.c - reads and writes EXR by OpenEXR's C core. Declared in kit.h. */
#include "kit/kit_image.h"
#include <math.h>
#include <OpenEXR/openexr.h>
#include <stdlib.h>
#include <string.h>

/* OpenEXR's first error message; later ones are consequences of it. It is thread-local, because OpenEXR holds a lock
   while it reports an error, and a query of the EXR context may wait for that lock. */
static _Thread_local char exr_complaint[256];

static void exr_complain(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context, (void)code;
    if (!exr_complaint[0]) snprintf(exr_complaint, sizeof exr_complaint, "%s", message);
}

static exr_context_initializer_t exr_initializer(void)
{
    exr_context_initializer_t start = EXR_DEFAULT_CONTEXT_INITIALIZER;
    exr_complaint[0] = 0;
    start.error_handler_fn = exr_complain;
    return start;
}

static int exr_fail(kit_error *err, const char *path, exr_result_t result)
{
    return kit_fail(err, "%s: %s", path, exr_complaint[0] ? exr_complaint : exr_get_default_error_message(result));
}

/* ---- reading -------------------------------------------------------------------------------------------------- */

enum { EXR_PARTS = 64 };

/* The parts of an EXR that are read: the flat parts of the first view; and a window that holds all of theirs. */
typedef struct exr_parts {
    int              count, index[EXR_PARTS];
    exr_attr_box2i_t window;
} exr_parts;

static const char *exr_view_of(exr_const_context_t context, int part)
{
    const exr_attribute_t *view;
    const int found = exr_get_attribute_by_name(context, part, "view", &view) == EXR_ERR_SUCCESS;
    return found && view->type == EXR_ATTR_STRING ? view->string->str : "";
}

static exr_result_t exr_find_parts(exr_parts *p, exr_const_context_t context)
{
    exr_attr_box2i_t *all = &p->window, window;
    exr_storage_t storage;
    int count = 0;
    exr_result_t result = exr_get_count(context, &count);
    p->count = 0;
    for (int i = 0; i < count && i < EXR_PARTS && result == EXR_ERR_SUCCESS; ++i) {
        result = exr_get_storage(context, i, &storage);
        if (result == EXR_ERR_SUCCESS) result = exr_get_data_window(context, i, &window);
        if (result != EXR_ERR_SUCCESS || (storage != EXR_STORAGE_SCANLINE && storage != EXR_STORAGE_TILED)
            || (p->count && strcmp(exr_view_of(context, i), exr_view_of(context, p->index[0])))) continue;
        if (!p->count) *all = window;
        if (window.min.x < all->min.x) all->min.x = window.min.x;
        if (window.min.y < all->min.y) all->min.y = window.min.y;
        if (window.max.x > all->max.x) all->max.x = window.max.x;
        if (window.max.y > all->max.y) all->max.y = window.max.y;
        p->index[p->count++] = i;
    }
    return result;
}

/* Reads one chunk (some scanlines or a tile) straight into the planar image, from the part's first channel on; origin:
   the part's top-left pixel in the image. */
static exr_result_t exr_read_chunk_into(exr_const_context_t context, int part, exr_decode_pipeline_t *decode,
                                        const exr_chunk_info_t *chunk, int x, int y, kit_image *image)
{
    int first = decode->context == NULL;
    exr_result_t result = first ? exr_decoding_initialize(context, part, chunk, decode)
                                : exr_decoding_update(context, part, chunk, decode);
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
    if (first) result = exr_decoding_choose_default_routines(context, part, decode);
    return result == EXR_ERR_SUCCESS ? exr_decoding_run(context, part, decode) : result;
}

/* Reads a part's pixels. all: the image's window, which contains the part's. */
static exr_result_t exr_read_pixels(exr_const_context_t context, int part, const exr_attr_box2i_t *all,
                                    kit_image *image)
{
    exr_decode_pipeline_t decode = EXR_DECODE_PIPELINE_INITIALIZER;
    exr_attr_box2i_t window;
    exr_storage_t storage;
    exr_chunk_info_t chunk;
    exr_result_t result = exr_get_data_window(context, part, &window);
    if (result == EXR_ERR_SUCCESS) result = exr_get_storage(context, part, &storage);
    if (result != EXR_ERR_SUCCESS) return result;
    const int tiled = storage == EXR_STORAGE_TILED;
    int32_t wide = window.max.x - window.min.x + 1, high = window.max.y - window.min.y + 1, width = wide, height = 0;
    if (tiled) result = exr_get_tile_sizes(context, part, 0, 0, &width, &height);
    else result = exr_get_scanlines_per_chunk(context, part, &height);
    if (result == EXR_ERR_SUCCESS && (width < 1 || height < 1)) result = EXR_ERR_INVALID_ATTR;
    for (int y = 0; y < high && result == EXR_ERR_SUCCESS; y += height)
        for (int x = 0; x < wide && result == EXR_ERR_SUCCESS; x += width) {
            if (tiled) result = exr_read_tile_chunk_info(context, part, x / width, y / height, 0, 0, &chunk);
            else result = exr_read_scanline_chunk_info(context, part, window.min.y + y, &chunk);
            if (result == EXR_ERR_SUCCESS)
                result = exr_read_chunk_into(context, part, &decode, &chunk, window.min.x - all->min.x + x,
                                             window.min.y - all->min.y + y, image);
        }
    exr_decoding_destroy(context, &decode);
    return result;
}

/* Returns the least size of a file for the pixels that a part's header claims, before memory is allocated for them
   (OpenEXR checks only that the table of chunks fits, its #1161). Each chunk has an entry in the table, and a byte
   holds at most a number of pixel bytes that depends on the compression: deflate (ZIP, ZIPS) makes one of 1032; RLE two
   of 128; PIZ repeats 255 halves in 9 bits; PXR24 deflates three bytes of a float; B44A makes 3 of 32. */
static double exr_least_size(exr_const_context_t context, int part)
{
    static const double most[] = {
        [EXR_COMPRESSION_NONE] = 1,          [EXR_COMPRESSION_RLE] = 64,           [EXR_COMPRESSION_ZIPS] = 1032,
        [EXR_COMPRESSION_ZIP] = 1032,        [EXR_COMPRESSION_PIZ] = 510 * 8 / 9., [EXR_COMPRESSION_PXR24] = 1376,
        [EXR_COMPRESSION_B44] = 32 / 3.,     [EXR_COMPRESSION_B44A] = 32 / 3.
    };
    const exr_attr_chlist_t *list;
    exr_attr_box2i_t window;
    exr_compression_t compression;
    int32_t chunks;
    double bytes = 0;
    if (exr_get_compression(context, part, &compression) != EXR_ERR_SUCCESS
        || exr_get_chunk_count(context, part, &chunks) != EXR_ERR_SUCCESS
        || exr_get_channels(context, part, &list) != EXR_ERR_SUCCESS
        || exr_get_data_window(context, part, &window) != EXR_ERR_SUCCESS) return INFINITY;
    if ((size_t)compression >= sizeof most / sizeof *most) return 0;          /* OpenEXR reports unknown compressions */
    for (int c = 0; c < list->num_channels; ++c)
        bytes += (list->entries[c].pixel_type == EXR_PIXEL_HALF ? 2 : 4) * ((double)window.max.x - window.min.x + 1)
               * ((double)window.max.y - window.min.y + 1);
    return bytes / most[compression] + 8.0 * chunks;
}

/* Adds the names of a part's channels to names. A name that earlier parts have becomes PART.NAME: some renderers write
   parts such as "albedo" with R, G and B. */
static int exr_name_channels(kit_image *names, exr_const_context_t context, int part, const char *path, kit_error *err)
{
    const exr_attr_chlist_t *list = NULL;
    const char *own = NULL;
    const exr_result_t result = exr_get_channels(context, part, &list);
    if (result != EXR_ERR_SUCCESS) return exr_fail(err, path, result);
    const int before = names->channels, all = before + list->num_channels;
    if (list->num_channels < 1 || all > KIT_MAX_CHANNELS)
        return kit_fail(err, "%s: %d channels; 1 to %d are supported", path, all, KIT_MAX_CHANNELS);
    for (int c = 0; c < list->num_channels; ++c) {
        const exr_attr_chlist_entry_t *entry = &list->entries[c];
        int known = 0;
        if (entry->x_sampling != 1 || entry->y_sampling != 1)
            return kit_fail(err, "%s: channel %s is subsampled, which is not supported", path, entry->name.str);
        for (int k = 0; k < before; ++k) known |= !strcmp(names->name[k], entry->name.str);
        if (known && exr_get_name(context, part, &own) != EXR_ERR_SUCCESS) own = "";
        if (snprintf(names->name[before + c], sizeof *names->name, "%s%s%s", known ? own : "", known ? "." : "",
                     entry->name.str) >= (int)sizeof *names->name)
            return kit_fail(err, "%s: channel name %s%s%s is longer than 31 characters", path, known ? own : "",
                            known ? "." : "", entry->name.str);
    }
    names->channels = all;
    return 0;
}

static int exr_read_parts(kit_image *out, const char *path, exr_const_context_t context, size_t size, kit_error *err)
{
    exr_parts parts;
    kit_image names = { 0 }, image;
    double least = 0;
    int ends[EXR_PARTS + 1] = { 0 };
    exr_result_t result = exr_find_parts(&parts, context);
    if (result != EXR_ERR_SUCCESS) return exr_fail(err, path, result);
    if (!parts.count) return kit_fail(err, "%s: deep EXR files are not supported", path);
    for (int i = 0; i < parts.count; ++i) {
        if (exr_name_channels(&names, context, parts.index[i], path, err)) return -1;
        least += exr_least_size(context, parts.index[i]);
        ends[i + 1] = names.channels;
    }
    const int64_t width = (int64_t)parts.window.max.x - parts.window.min.x + 1,
                  height = (int64_t)parts.window.max.y - parts.window.min.y + 1;
    if (width < 1 || height < 1 || width > 65536 || height > 65536)
        return kit_fail(err, "%s: a picture of %lld x %lld is not supported", path, (long long)width,
                        (long long)height);
    if (!(least <= (double)size))
        return kit_fail(err, "%s: its header claims %lld x %lld pixels of %d channels, which its %zu bytes cannot hold",
                        path, (long long)width, (long long)height, names.channels, size);

    if (kit_image_alloc(&image, (int)width, (int)height, names.channels, path, err)) return -1;
    memcpy(image.name, names.name, sizeof image.name);
    for (int i = 0; i < parts.count && result == EXR_ERR_SUCCESS; ++i) {
        kit_image part = image;
        part.data += (size_t)ends[i] * kit_image_pixels(&image);
        result = exr_read_pixels(context, parts.index[i], &parts.window, &part);
    }
    if (result == EXR_ERR_SUCCESS) {
        *out = image;
        return 0;
    }
    kit_image_free(&image);
    return result == EXR_ERR_FEATURE_NOT_IMPLEMENTED
             ? kit_fail(err, "%s: its compression is not supported (supported: none, RLE, ZIP, PIZ, PXR24, B44)", path)
             : exr_fail(err, path, result);
}

/* An EXR file whose header has been read. */
typedef struct exr_reader { size_t size; exr_context_t context; } exr_reader;

static void exr_close(exr_reader *r)
{
    if (r->context) exr_finish(&r->context);
}

/* Opens an EXR and reads its header. The caller must call exr_close(), also after a failure. */
static int exr_open(exr_reader *r, const char *path, kit_error *err)
{
    memset(r, 0, sizeof *r);
    FILE *const file = kit_file_open(&r->size, path, err);     /* refuses folders and pipes: OpenEXR would block */
    if (!file) return -1;
    fclose(file);
    exr_context_initializer_t start = exr_initializer();
    start.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;   /* a damaged file is an error, not reconstructed */
    const exr_result_t result = exr_start_read(&r->context, path, &start);
    return result == EXR_ERR_SUCCESS ? 0 : exr_fail(err, path, result);
}

int kit_exr_read(kit_image *image, const char *path, kit_error *err)
{
    exr_reader r;
    const int failed = exr_open(&r, path, err) || exr_read_parts(image, path, r.context, r.size, err);
    exr_close(&r);
    return failed ? -1 : 0;
}

/* ---- the camera of a frame ------------------------------------------------------------------------------------ */

static const char MATRIX[] = "worldToCamera", FAR_MATRIX[] = "ssgi.worldToCamera",
                  WIDTH[] = "screenWindowWidth", CENTRE[] = "screenWindowCenter",
                  ORTHO_HEIGHT[] = "ssgi.orthoHeight", RADIUS[] = "ssgi.radius";

/* Finds an attribute of the header. Returns 1: found, 0: missing, -1: it has another type. */
static int exr_find(const exr_attribute_t **found, const exr_reader *r, const char *name, exr_attribute_type_t type,
                    const char *path, kit_error *err)
{
    if (exr_get_attribute_by_name(r->context, 0, name, found) != EXR_ERR_SUCCESS) return 0;
    return (*found)->type == type ? 1 : kit_fail(err, "%s: %s: is of type %s", path, name, (*found)->type_name);
}

/* Reads a number of the header, which must be in [least, most]. Returns as exr_find does. */
static int exr_number(float *out, const exr_reader *r, const char *name, double least, double most, const char *path,
                      kit_error *err)
{
    const exr_attribute_t *found;
    const int is = exr_find(&found, r, name, EXR_ATTR_FLOAT, path, err);
    if (is < 1) return is;
    if (!((double)found->f >= least && (double)found->f <= most))
        return kit_fail(err, "%s: %s %g: must be in %g..%g", path, name, (double)found->f, least, most);
    *out = found->f;
    return 1;
}

/* Returns whether m is a rotation and a translation. m is for row vectors: its columns are the rotation's rows. */
static int exr_rigid(const float m[16])
{
    double row[3][3], across[3];
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) row[i][k] = (double)m[4 * k + i];
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            if (!(fabs(kit_dot(row[i], row[k]) - (i == k)) < 1e-3)) return 0;
    for (int i = 0; i < 4; ++i)
        if (!(fabs((double)m[4 * i + 3] - (i == 3)) < 1e-6)) return 0;
    kit_cross(row[0], row[1], across);
    return kit_dot(across, row[2]) < 0;            /* the world is right-handed, the file's camera left-handed */
}

/* Makes the eye the origin. The eye is found by solving a system: the rotation is rounded to floats, so its transpose
   equals its inverse only to float precision. */
static void exr_place_at_eye(kit_header *h, const double place[3])
{
    double row[3][3], across[3];
    for (int i = 0; i < 9; ++i) row[i / 3][i % 3] = (double)h->world_to_camera[4 * (i / 3) + i % 3];
    for (int i = 0; i < 3; ++i) {
        kit_cross(row[(i + 1) % 3], row[(i + 2) % 3], across);
        h->origin[i] = 0 - kit_dot(place, across) / kit_dot(row[i], across);
        h->world_to_camera[12 + i] = 0;
    }
}

/* Reads worldToCamera. Returns 1: found, 0: missing, -1: an error. */
static int exr_place(kit_header *h, const exr_reader *r, const char *path, kit_error *err)
{
    const exr_attribute_t *found;
    double place[3];
    const char *name = FAR_MATRIX;
    const int away = exr_find(&found, r, name, EXR_ATTR_M44D, path, err);
    const int is = away ? away : exr_find(&found, r, name = MATRIX, EXR_ATTR_M44F, path, err);
    if (is < 1) return is;
    for (int i = 0; i < 16; ++i) h->world_to_camera[i] = away ? (float)found->m44d->m[i] : found->m44f->m[i];
    for (int i = 0; i < 3; ++i) {
        place[i] = away ? found->m44d->m[12 + i] : (double)found->m44f->m[12 + i];
        if (!(fabs(place[i]) <= KIT_MOST))
            return kit_fail(err, "%s: %s: its place must be in -%g..%g", path, name, KIT_MOST, KIT_MOST);
    }
    if (!exr_rigid(h->world_to_camera))
        return kit_fail(err, "%s: %s: must turn and move a right-handed world, without scale, to a camera with x to "
                             "the right, y up, looking down +z", path, name);
    if (away) exr_place_at_eye(h, place);
    return 1;
}

/* Converts the file's screen window, which is that of the display window, to that of the data window. given: h has the
   height of the display window, which replaces the file's. */
static int exr_window(kit_header *h, int given, const exr_reader *r, const char *path, kit_error *err)
{
    const exr_attribute_t *found = NULL;
    exr_attr_box2i_t shown;
    exr_parts parts;
    float aspect = 1, size = 0;
    if (exr_find_parts(&parts, r->context) != EXR_ERR_SUCCESS || !parts.count
        || exr_get_display_window(r->context, 0, &shown) != EXR_ERR_SUCCESS)
        return kit_fail(err, "%s: has no data window and display window", path);
    const exr_attr_box2i_t data = parts.window;
    const double wide = (double)shown.max.x - shown.min.x + 1, high = (double)shown.max.y - shown.min.y + 1;
    const double rows = (double)data.max.y - data.min.y + 1;
    if (!(wide >= 1 && high >= 1 && rows >= 1)) return kit_fail(err, "%s: displayWindow: is empty", path);
    if (given && !memcmp(&shown, &data, sizeof data)) return 0;
    const int flat = given ? h->orthographic : exr_number(&size, r, ORTHO_HEIGHT, 1e-12, KIT_MOST, path, err);
    if (flat < 0 || exr_number(&aspect, r, "pixelAspectRatio", 0.995, 1.005, path, err) < 0
        || (!given && !flat && exr_number(&size, r, WIDTH, 1e-12, KIT_MOST, path, err) < 0)) return -1;
    const double pixel = given ? (double)h->height / high : (double)size / (flat ? high : wide), height = pixel * rows;
    const double angle = 360 / KIT_PI * atan(height / 2);
    if (!given && !flat && !(angle > 0.09 && angle < 179.1))
        return kit_fail(err, "%s: %s %g: makes a vertical angle of %g degrees, which must be in 0.1..179", path, WIDTH,
                        (double)size, angle);
    const int centred = given ? 0 : exr_find(&found, r, CENTRE, EXR_ATTR_V2F, path, err);
    if (centred < 0) return -1;
    const double off[2] = { ((double)data.min.x + data.max.x - shown.min.x - shown.max.x) / 2,
                            ((double)shown.min.y + shown.max.y - data.min.y - data.max.y) / 2 };
    h->orthographic = flat;
    h->height = (float)height;
    for (int i = 0; i < 2; ++i) {
        const double centre = (!centred ? 0 : i ? (double)found->v2f->y : (double)found->v2f->x) + off[i] * pixel;
        if (!(fabs(centre) <= 1000 * height))
            return kit_fail(err, "%s: %s: the picture must not be so far from the camera's axis", path, CENTRE);
        h->centre[i] = (float)centre;
    }
    h->has |= KIT_HEADER_WINDOW;
    return 0;
}

int kit_exr_header(kit_header *header, int wanted, const char *path, kit_error *err)
{
    exr_reader r;
    kit_header h = { 0 };
    const exr_attribute_t *none;
    int failed = exr_open(&r, path, err);
    if (!failed && wanted & KIT_HEADER_PLACE) {
        const int is = exr_place(&h, &r, path, err);
        failed = is < 0;
        h.has |= is > 0 ? KIT_HEADER_PLACE : 0;
    }
    /* every EXR has a screen window: it counts only together with a matrix or a height */
    if (!failed && wanted & KIT_HEADER_WINDOW
        && (exr_get_attribute_by_name(r.context, 0, MATRIX, &none) == EXR_ERR_SUCCESS
            || exr_get_attribute_by_name(r.context, 0, ORTHO_HEIGHT, &none) == EXR_ERR_SUCCESS))
        failed = exr_window(&h, 0, &r, path, err);
    if (!failed && wanted & KIT_HEADER_PART) {
        h.orthographic = header->orthographic;
        h.height = header->height;
        failed = exr_window(&h, 1, &r, path, err);
    }
    if (!failed && wanted & KIT_HEADER_RADIUS) {
        const int is = exr_number(&h.radius, &r, RADIUS, 1e-12, KIT_MOST, path, err);
        failed = is < 0;
        h.has |= is > 0 ? KIT_HEADER_RADIUS : 0;
    }
    exr_close(&r);
    if (failed) return -1;
    *header = h;
    return 0;
}

static exr_result_t exr_write_header_of(exr_context_t context, const kit_image *image, const kit_header *h)
{
    exr_attr_m44f_t matrix;
    exr_attr_m44d_t far_matrix;
    const exr_attr_v2f_t centre = { { { h->centre[0], h->centre[1] } } };
    const int away = h->origin[0] != 0 || h->origin[1] != 0 || h->origin[2] != 0;
    exr_result_t result = EXR_ERR_SUCCESS;
    for (int i = 0; i < 16; ++i) {
        far_matrix.m[i] = (double)h->world_to_camera[i];
        for (int k = 0; k < 3 && i >= 12 && i < 15; ++k) far_matrix.m[i] -= h->origin[k] * far_matrix.m[4 * k + i % 4];
        matrix.m[i] = (float)far_matrix.m[i];
    }
    if (h->has & KIT_HEADER_PLACE) result = exr_attr_set_m44f(context, 0, MATRIX, &matrix);
    if (h->has & KIT_HEADER_PLACE && away && result == EXR_ERR_SUCCESS)
        result = exr_attr_set_m44d(context, 0, FAR_MATRIX, &far_matrix);
    if (h->has & KIT_HEADER_WINDOW && result == EXR_ERR_SUCCESS) {
        result = exr_set_screen_window_width(context, 0, h->height * (float)image->width / (float)image->height);
        if (result == EXR_ERR_SUCCESS) result = exr_set_screen_window_center(context, 0, &centre);
        if (result == EXR_ERR_SUCCESS && h->orthographic)
            result = exr_attr_set_float(context, 0, ORTHO_HEIGHT, h->height);
    }
    if (h->has & KIT_HEADER_RADIUS && result == EXR_ERR_SUCCESS)
        result = exr_attr_set_float(context, 0, RADIUS, h->radius);
    return result;
}

/* ---- writing -------------------------------------------------------------------------------------------------- */

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

typedef struct exr_packer { exr_result_t (*compress)(exr_encode_pipeline_t *encode); } exr_packer;

/* Compresses a chunk. One with as many bytes as its pixels is read as uncompressed, so it must be. But OpenEXR writes
   zlib's output even if it has exactly that size (its #2306). */
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

int kit_exr_write_frame(const kit_image *image, const kit_header *header, const char *path, kit_error *err)
{
    kit_memory_file file = { 0 };
    exr_context_t context = NULL;
    int part;
    exr_context_initializer_t start = exr_initializer();
    start.user_data = &file;
    start.write_fn = exr_memory_write;
    start.zip_level = KIT_ZIP_LEVEL;
    exr_result_t result = exr_start_write(&context, path, EXR_WRITE_FILE_DIRECTLY, &start);
    if (result == EXR_ERR_SUCCESS) result = exr_add_part(context, NULL, EXR_STORAGE_SCANLINE, &part);
    if (result == EXR_ERR_SUCCESS)
        result = exr_initialize_required_attr_simple(context, 0, image->width, image->height, EXR_COMPRESSION_ZIP);
    for (int c = 0; c < image->channels && result == EXR_ERR_SUCCESS; ++c)
        result = exr_add_channel(context, 0, image->name[c], EXR_PIXEL_FLOAT, EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    if (result == EXR_ERR_SUCCESS && header) result = exr_write_header_of(context, image, header);
    if (result == EXR_ERR_SUCCESS) result = exr_write_header(context);
    if (result == EXR_ERR_SUCCESS) result = exr_write_pixels(context, image);
    int failed = result == EXR_ERR_SUCCESS ? 0 : exr_fail(err, path, result);
    if (context && exr_finish(&context) != EXR_ERR_SUCCESS && !failed) failed = exr_fail(err, path, result);
    if (!failed) failed = kit_file_write(path, file.data, file.size, err);
    free(file.data);
    return failed;
}

int kit_exr_write(const kit_image *image, const char *path, kit_error *err)
{
    return kit_exr_write_frame(image, NULL, path, err);
}
