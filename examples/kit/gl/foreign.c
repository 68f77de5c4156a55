/* foreign.c - renames the channels of other programs' frames to the kit's names. Declared in kit_gl.h. */
#include "kit/kit_gl.h"
#include <stdlib.h>
#include <string.h>

/* Indices of a view layer's channels as Blender names them: LAYER.Depth.Z and so on. */
enum { DEPTH, NORMAL, COLOUR = 4, LIGHT = 7, PASSES = 10 };
static const struct { const char *theirs, *ours; } pass_names[PASSES] = {
    { "Depth.Z", "Z" },          { "Normal.X", "N.X" },       { "Normal.Y", "N.Y" },       { "Normal.Z", "N.Z" },
    { "DiffCol.R", "albedo.R" }, { "DiffCol.G", "albedo.G" }, { "DiffCol.B", "albedo.B" }, { "DiffDir.R", "direct.R" },
    { "DiffDir.G", "direct.G" }, { "DiffDir.B", "direct.B" }
};

/* Returns the index of the frame's channel of that name, or -1. */
static int number_of(const kit_image *frame, const char *name)
{
    for (int c = 0; c < frame->channels; ++c)
        if (!strcmp(frame->name[c], name)) return c;
    return -1;
}

static int pass_of(const kit_image *frame, const char *layer, int pass)
{
    char name[64];
    snprintf(name, sizeof name, "%.31s.%s", layer, pass_names[pass].theirs);
    return number_of(frame, name);
}

/* Lists all channels, or all view layers with a depth, in text, as far as there is room, and returns their number. one
   gets the name of the last layer. */
static int list(char *text, size_t size, const kit_image *frame, int layers, char one[32])
{
    size_t length = 0;
    int count = 0;
    *text = 0;
    for (int c = 0; c < frame->channels; ++c) {
        const char *const end = strstr(frame->name[c], ".Depth.Z");
        if (layers && (!end || strcmp(end, ".Depth.Z"))) continue;
        const int shown = layers ? (int)(end - frame->name[c]) : (int)strlen(frame->name[c]);
        if (layers) snprintf(one, 32, "%.*s", shown, frame->name[c]);
        if (length < size)
            length += (size_t)snprintf(text + length, size - length, "%s%.*s", count ? ", " : "", shown,
                                       frame->name[c]);
        ++count;
    }
    return count;
}

static int rename_one(kit_image *frame, const char *text, kit_error *err)
{
    char all[600], ours[32];
    const char *const theirs = strchr(text, '=');
    if (!theirs || theirs == text || theirs - text > 31 || !theirs[1])
        return kit_fail(err, "--channel %s: must be NAME=CHANNEL, as Z=depth.V", text);
    snprintf(ours, sizeof ours, "%.*s", (int)(theirs - text), text);
    const int from = number_of(frame, theirs + 1), there = number_of(frame, ours);
    list(all, sizeof all, frame, 0, NULL);
    if (from < 0) return kit_fail(err, "--channel %s: there is no such channel; there are %s", text, all);
    if (there >= 0) snprintf(frame->name[there], sizeof frame->name[there], "was %.26s", ours);
    memcpy(frame->name[from], ours, sizeof ours);
    return 0;
}

static float *take_pass(kit_image *frame, const char *layer, int pass)
{
    const int c = pass_of(frame, layer, pass);
    snprintf(frame->name[c], sizeof frame->name[c], "%s", pass_names[pass].ours);
    return kit_image_channel(frame, pass_names[pass].ours);
}

static int passes_there(const kit_image *frame, const char *layer, int first, int last)
{
    for (int pass = first; pass < last; ++pass)
        if (pass_of(frame, layer, pass) < 0) return 0;
    return 1;
}

/* Takes a view layer's depth (1e10 = background), world-space normals, the colour of diffuse surfaces and, if that
   exists, the direct light on them. */
static int take_layer(kit_image *frame, const char *layer, const kit_camera *camera, int placed, kit_error *err)
{
    const size_t pixels = (size_t)frame->width * (size_t)frame->height;
    const int turned = passes_there(frame, layer, NORMAL, COLOUR), coloured = passes_there(frame, layer, COLOUR, LIGHT);
    const int lit = coloured && passes_there(frame, layer, LIGHT, PASSES);
    float view[16], projection[16], *n[3];
    if (turned && !placed)
        return kit_fail(err, "frame: %s.Normal.X is of the world: --camera must say where the camera stands", layer);
    float *const z = take_pass(frame, layer, DEPTH);
    for (size_t i = 0; i < pixels; ++i) z[i] = z[i] < 9e9f ? z[i] : 0;
    if (turned) {
        kit_camera_matrices(camera, view, projection);
        for (int k = 0; k < 3; ++k) n[k] = take_pass(frame, layer, NORMAL + k);
        for (size_t i = 0; i < pixels; ++i) {
            const float world[3] = { n[0][i], n[1][i], n[2][i] };
            for (int k = 0; k < 3; ++k) n[k][i] = view[k] * world[0] + view[4 + k] * world[1] + view[8 + k] * world[2];
        }
    }
    for (int k = 0; k < 3 && coloured; ++k) {
        const float *const colour = take_pass(frame, layer, COLOUR + k);
        float *const light = lit ? take_pass(frame, layer, LIGHT + k) : NULL;
        for (size_t i = 0; i < pixels && light; ++i) light[i] *= colour[i];
    }
    return 0;
}

int kit_frame_rename(kit_image *frame, const char *const *channel, int channels, const char *layer,
                     const kit_camera *camera, int placed, kit_error *err)
{
    char all[600], one[32] = "";
    for (int i = 0; i < channels; ++i) if (rename_one(frame, channel[i], err)) return -1;
    if (number_of(frame, "Z") >= 0)
        return layer ? kit_fail(err, "--layer %s: the frame has no view layers, but Z", layer) : 0;
    const int layers = list(all, sizeof all, frame, 1, one);
    if (layers && layer && pass_of(frame, layer, DEPTH) < 0)
        return kit_fail(err, "--layer %s: must be one of the frame's view layers: %s", layer, all);
    if (layers > 1 && !layer)
        return kit_fail(err, "frame: has several view layers, of which --layer takes one: %s", all);
    if (layers) return take_layer(frame, layer ? layer : one, camera, placed, err);
    list(all, sizeof all, frame, 0, NULL);
    return kit_fail(err, "frame: channel Z is missing, view depth; there are %s; --channel Z=NAME takes one for it",
                    all);
}
