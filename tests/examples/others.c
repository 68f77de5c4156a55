/* others.c - see others.h. */
#include "others.h"

ImfRgba others_pixel(float r, float g, float b, float a)
{
    ImfRgba p;
    ImfFloatToHalf(r, &p.r);
    ImfFloatToHalf(g, &p.g);
    ImfFloatToHalf(b, &p.b);
    ImfFloatToHalf(a, &p.a);
    return p;
}

static int write_rows(const char *path, const ImfHeader *header, int width, int height, const ImfRgba *pixels)
{
    ImfOutputFile *file = ImfOpenOutputFile(path, header, IMF_WRITE_RGBA);
    const int good = file && ImfOutputSetFrameBuffer(file, pixels, 1, (size_t)width)
                  && ImfOutputWritePixels(file, height);
    return file && ImfCloseOutputFile(file) && good;
}

static int write_tiles(const char *path, const ImfHeader *header, int width, int height, int tile,
                       const ImfRgba *pixels)
{
    ImfTiledOutputFile *file =
        ImfOpenTiledOutputFile(path, header, IMF_WRITE_RGBA, tile, tile, IMF_ONE_LEVEL, IMF_ROUND_DOWN);
    const int good = file && ImfTiledOutputSetFrameBuffer(file, pixels, 1, (size_t)width)
                  && ImfTiledOutputWriteTiles(file, 0, (width - 1) / tile, 0, (height - 1) / tile, 0, 0);
    return file && ImfCloseTiledOutputFile(file) && good;
}

int others_write(const char *path, int width, int height, int compression, int tile, const ImfRgba *pixels)
{
    ImfHeader *header = ImfNewHeader();
    ImfHeaderSetDataWindow(header, 0, 0, width - 1, height - 1);
    ImfHeaderSetDisplayWindow(header, 0, 0, width - 1, height - 1);
    ImfHeaderSetCompression(header, compression);
    const int good = tile ? write_tiles(path, header, width, height, tile, pixels)
                          : write_rows(path, header, width, height, pixels);
    ImfDeleteHeader(header);
    return good ? 0 : -1;
}
