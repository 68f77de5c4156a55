/* test_models.c - models read by Assimp, a polygon that is hard to cut, and messages for files that are no models: the
   kit's models.c, assimp.c, mesh.c and scene.c. The meaning of an OBJ is tested in test_files.c. */
#include "kit/kit_models.h"
#include "shell.h"

#include <math.h>
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#include <sys/stat.h>

/* ---- PNG --------------------------------------------------------------------------------------------------------- */

/* Checks values out of range and NaN; sRGB, in which 0.5 is 188 of 255; colours in the order of their names. */
static void png(void)
{
    static const float values[6] = { -1, 0, 0.5f, 1, INFINITY, NAN };
    static const struct { const char *names; int srgb; unsigned char red[6], blue[6]; } row[] = {
        { "Y", 0, { 0, 0, 128, 255, 255, 0 }, { 0, 0, 128, 255, 255, 0 } },
        { "Y", 1, { 0, 0, 188, 255, 255, 0 }, { 0, 0, 188, 255, 255, 0 } },
        { "Q,Y,Y", 0, { 51, 51, 51, 51, 51, 51 }, { 0, 0, 128, 255, 255, 0 } } };
    char *bytes;
    size_t size;
    kit_image a;
    kit_error err = {{0}};
    if (!CHECK(!kit_image_new(&a, 3, 2, "Y,Q", &err), "%s", err.text)) return;
    memcpy(kit_image_channel(&a, "Y"), values, sizeof values);
    for (int i = 0; i < 6; ++i) kit_image_channel(&a, "Q")[i] = 0.2f;
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        kit_picture is;
        const char *why = "";
        if (!CHECK(!kit_png_write(&a, row[k].names, row[k].srgb, in_folder("a.png"), &err), "%s", err.text)
            || !CHECK(!kit_file_read(&bytes, &size, in_folder("a.png"), &err), "%s", err.text))
            continue;
        CHECK(!kit_picture_read(&is, bytes, size, &why) && is.width == 3 && is.height == 2, "%s, sRGB %d: %s",
              row[k].names, row[k].srgb, why);
        for (int i = 0; i < 6 && is.texel; ++i)
            CHECK(is.texel[4 * i] == row[k].red[i] && is.texel[4 * i + 2] == row[k].blue[i],
                  "%s, sRGB %d: pixel %d is %d, %d", row[k].names, row[k].srgb, i, is.texel[4 * i],
                  is.texel[4 * i + 2]);
        kit_picture_free(&is);
        free(bytes);
    }
    kit_image_free(&a);
}

/* ---- through Assimp ------------------------------------------------------------------------------------------ */

/* A .glb: JSON, in which %s stands for the buffer's length, and the buffer. */
typedef struct glb {
    unsigned char bytes[4096];
    size_t size;
} glb;

static void add_bytes(glb *b, const void *bytes, size_t size)
{
    memcpy(b->bytes + b->size, bytes, size);
    b->size = (b->size + size + 3) / 4 * 4;
}

static void word(FILE *file, size_t value)
{
    for (int i = 0; i < 4; ++i) fputc((int)(value >> 8 * i & 255), file);
}

static void put_glb(const char *name, const char *json, const glb *b)
{
    const size_t length = (strlen(json) + 3) / 4 * 4;
    FILE *file = fopen(in_folder(name), "wb");
    if (!CHECK(file != NULL, "%s cannot be made", name)) return;
    fputs("glTF", file);
    word(file, 2);
    word(file, 28 + length + b->size);
    word(file, length);
    fprintf(file, "JSON%-*s", (int)length, json);
    word(file, b->size);
    fwrite("BIN", 1, 4, file);
    fwrite(b->bytes, 1, b->size, file);
    fclose(file);
}

static double area_of(const kit_scene *s)
{
    double all = 0;
    for (size_t t = 0; t < s->mesh.triangles; ++t) {
        const float *p = s->mesh.position + 9 * t;
        double e[2][3], n[3];
        for (int i = 0; i < 6; ++i) e[i / 3][i % 3] = (double)p[3 + i] - (double)p[i % 3];
        kit_cross(e[0], e[1], n);
        all += 0.5 * sqrt(kit_dot(n, n));
    }
    return all;
}

/* Checks one slanted triangle in three nodes. Scaled by 2, 3, 4, its normal is (0, -0.8, 0.6). Mirrored in x, its
   corners change their order, without and with normals in the file. */
static void nodes_of_glb(void)
{
    static const float corner[3][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 1 } };
    static const float placed[3][3][3] = { { { 11, 2, 3 }, { 13, 2, 3 }, { 11, 5, 7 } },
                                           { { 10, 1, 1 }, { 9, 0, 0 }, { 10, 0, 0 } },
                                           { { 10, 1, 1 }, { 9, 0, 0 }, { 10, 0, 0 } } };
    static const double normal[3][3] = { { 0, -0.8, 0.6 }, { 0, -0.70710678, 0.70710678 },
                                        { 0, -0.70710678, 0.70710678 } };
    static const char json[] =
        "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
        "{\"name\":\"both\",\"translation\":[10,0,0],\"children\":[1,2,3]},"
        "{\"name\":\"large\",\"mesh\":0,\"translation\":[1,2,3],\"scale\":[2,3,4]},"
        "{\"name\":\"mirrored\",\"mesh\":1,\"scale\":[-1,1,1]},"
        "{\"name\":\"third\",\"mesh\":0,\"scale\":[-1,1,1]}],"
        "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,0.25,1,1]}}],\"meshes\":["
        "{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":1},\"material\":0}]},"
        "{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":["
        "{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"},"
        "{\"bufferView\":1,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":["
        "{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":36}],"
        "\"buffers\":[{\"byteLength\":72}]}";
    static const float albedo[3][3] = { { 0.5f, 0.25f, 1 }, { 0.8f, 0.8f, 0.8f }, { 0.5f, 0.25f, 1 } };
    static const char *const names[3] = { "large", "mirrored", "third" };
    glb b = { .size = 0 };
    kit_error err = { { 0 } };
    kit_scene s;
    add_bytes(&b, corner, sizeof corner);
    for (int k = 0; k < 3; ++k) add_bytes(&b, (const float[3]){ 0, -0.70710678f, 0.70710678f }, 12);
    put_glb("nodes.glb", json, &b);
    if (!CHECK(!kit_scene_load(&s, in_folder("nodes.glb"), 0, &err), "%s", err.text)) return;
    CHECK(s.objects == 3 && s.mesh.triangles == 3 && !*s.note, "%d objects, %zu triangles, \"%s\"", s.objects,
          s.mesh.triangles, s.note);
    for (int t = 0; t < 3 && t < s.objects; ++t) {
        const float *p = s.mesh.position + 9 * t, *n = s.mesh.normal + 9 * t;
        CHECK(!strcmp(s.object[t].name, names[t]), "object %d is %s", t, s.object[t].name);
        for (int i = 0; i < 9; ++i) {
            CHECK(fabs((double)p[i] - (double)placed[t][i / 3][i % 3]) < 1e-6, "%s: %d is %g", names[t], i,
                  (double)p[i]);
            CHECK(fabs((double)n[i] - normal[t][i % 3]) < 1e-6, "%s: normal %d is %g", names[t], i, (double)n[i]);
        }
        CHECK(!memcmp(s.mesh.albedo + 3 * t, albedo[t], sizeof albedo[t]), "%s: red is %g", names[t],
              (double)s.mesh.albedo[3 * t]);
    }
    kit_scene_free(&s);
}

static void keep_png(void *to, void *data, int size) { add_bytes(to, data, (size_t)size); }

/* Writes a square card of side 4, whose texture coordinates go from 0 to turns, perhaps transformed. The texture is
   side x side; a texel is opaque if there(x, y). */
static void put_card(const char *mode, const char *transform, double turns, int wrap, int side,
                     int (*there)(int x, int y))
{
    static unsigned char texel[4 * 256 * 256];
    const float end = (float)turns;
    const float corner[4][3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 } };
    const float uv[4][2] = { { 0, end }, { end, end }, { end, 0 }, { 0, 0 } };
    const unsigned char index[6] = { 0, 1, 2, 0, 2, 3 };
    char json[2000];
    glb b = { .size = 0 };
    for (int i = 0; i < side * side; ++i) {
        const int is = there(i % side, i / side);
        const unsigned char rgba[4] = { is ? 188 : 10, is ? 255 : 10, 0, is ? 255 : 3 };
        memcpy(texel + 4 * i, rgba, 4);
    }
    add_bytes(&b, corner, sizeof corner);
    add_bytes(&b, uv, sizeof uv);
    add_bytes(&b, index, sizeof index);
    const size_t before = b.size;
    stbi_write_png_to_func(keep_png, &b, side, side, 4, texel, 4 * side);
    snprintf(json, sizeof json,
             "{\"asset\":{\"version\":\"2.0\"},\"extensionsUsed\":[\"KHR_texture_transform\"],"
             "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"materials\":[{%s\"pbrMetallicRoughness\":{"
             "\"baseColorFactor\":[0.5,1,1,1],\"baseColorTexture\":{\"index\":0%s}}}],"
             "\"textures\":[{\"source\":0,\"sampler\":0}],\"samplers\":[{\"wrapS\":%d,\"wrapT\":%d}],"
             "\"images\":[{\"bufferView\":3,\"mimeType\":\"image/png\"}],\"meshes\":[{\"primitives\":[{\"material\":0,"
             "\"attributes\":{\"POSITION\":0,\"TEXCOORD_0\":1},\"indices\":2}]}],\"accessors\":["
             "{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"},"
             "{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":\"VEC2\"},"
             "{\"bufferView\":2,\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"}],\"bufferViews\":["
             "{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":32},"
             "{\"buffer\":0,\"byteOffset\":80,\"byteLength\":6},{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}],"
             "\"buffers\":[{\"byteLength\":%zu}]}",
             mode, transform, wrap, wrap, before, b.size - before, b.size);
    put_glb("card.glb", json, &b);
}

static int leaf(int x, int y) { return (0x137f >> (4 * y + x) & 1) != 0; } /* 10 texels of 16, like no mirror image */

/* Returns how many triangles, which face along z, cover a point. */
static int covers(const kit_mesh *m, double x, double y)
{
    int times = 0;
    for (size_t t = 0; t < m->triangles; ++t) {
        const float *p = m->position + 9 * t;
        int in = 0;
        for (int k = 0; k < 3; ++k) {
            const float *a = p + 3 * k, *b = p + 3 * ((k + 1) % 3);
            in += ((double)b[0] - (double)a[0]) * (y - (double)a[1])
                > ((double)b[1] - (double)a[1]) * (x - (double)a[0]);
        }
        times += in == 3;
    }
    return times;
}

/* Checks that a card keeps the opaque parts, if its texture is repeated, mirrored or clamped at its edge. */
static void cards(void)
{
    enum { REPEAT = 10497, MIRROR = 33648, CLAMP = 33071 };

    static const struct {
        const char *about, *mode;
        double turns;
        int wrap, cut, turned;
    } all[] = {
        { "OPAQUE", "", 1, REPEAT, 0, 0 },
        { "MASK", "\"alphaMode\":\"MASK\",", 1, REPEAT, 1, 0 },
        { "MASK of a cutoff below all", "\"alphaMode\":\"MASK\",\"alphaCutoff\":0.01,", 1, REPEAT, 0, 0 },
        { "BLEND", "\"alphaMode\":\"BLEND\",", 1, REPEAT, 1, 0 },
        { "MASK, repeated", "\"alphaMode\":\"MASK\",", -2.5, REPEAT, 1, 0 },
        { "MASK, mirrored", "\"alphaMode\":\"MASK\",", 2.5, MIRROR, 1, 0 },
        { "MASK, going on", "\"alphaMode\":\"MASK\",", 2, CLAMP, 1, 0 },
        { "MASK, turned by a quarter", "\"alphaMode\":\"MASK\",", 2.5, REPEAT, 1, 1 },
    };

    kit_error err = { { 0 } };
    kit_scene s;
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        int wrong = 0;
        put_card(all[i].mode,
                 all[i].turned ? ",\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.25,0.5],"
                                 "\"rotation\":1.5707963,\"scale\":[2,1]}}"
                               : "",
                 all[i].turns, all[i].wrap, 4, leaf);
        if (!CHECK(!kit_scene_load(&s, in_folder("card.glb"), 0, &err), "%s: %s", all[i].about, err.text)) return;
        for (int k = 0; k < 40 * 40; ++k) {
            const double at[2] = { (k % 40 + 0.513) / 10, (int)(k / 40) / 10.0 + 0.0471 };
            int place[2], is = 1;
            for (int c = 0; c < 2; ++c) {
                const double right = at[0] / 4 * all[i].turns, down = (4 - at[1]) / 4 * all[i].turns;
                const double u = !all[i].turned ? (c ? down : right) : c ? 0.5 - 2 * right : 0.25 + down;
                const int t = (int)floor(4 * u), of = ((t % 4) + 4) % 4, odd = (int)floor(u) & 1;
                place[c] = all[i].wrap == REPEAT ? of : all[i].wrap == MIRROR ? (odd ? 3 - of : of) : t > 3 ? 3 : t;
            }
            if (all[i].cut) is = leaf(place[0], place[1]);
            wrong += covers(&s.mesh, at[0], at[1]) != is;
        }
        CHECK(wrong == 0, "%s: %d of 1600 points are there and should not be, or the reverse", all[i].about, wrong);
        const double want = all[i].turns * all[i].turns > 1 ? area_of(&s) : all[i].cut ? 10 : 16;
        CHECK(fabs(area_of(&s) - want) < 1e-5, "%s: covers %g, not %g", all[i].about, area_of(&s), want);
        const double share = all[i].cut ? 1 : 10.0 / 16, red = 0.5 * (0.502886 * share + 0.003035 * (1 - share));
        CHECK(fabs((double)s.mesh.albedo[0] - red) < 1e-5 && s.mesh.albedo[2] < 0.002f, "%s: red is %g, not %g",
              all[i].about, (double)s.mesh.albedo[0], red);
        kit_scene_free(&s);
    }
}

static void ply(void)
{
    kit_error err = { { 0 } };
    kit_scene s;
    write_text("quad.ply",
               "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
               "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0 188 0 0\n2 0 0 188 0 0\n2 3 0 188 0 0\n"
               "0 3 0 188 0 0\n5 0 0 0 255 0\n6 0 0 0 255 0\n5 1 0 0 255 0\n4 0 1 2 3\n3 4 5 6\n");
    if (!CHECK(!kit_scene_load(&s, in_folder("quad.ply"), 0, &err), "%s", err.text)) return;
    CHECK(s.mesh.triangles == 3 && s.objects == 2, "%zu triangles, %d objects", s.mesh.triangles, s.objects);
    CHECK(fabs(area_of(&s) - 6.5) < 1e-6, "covers %g, not 6.5", area_of(&s));
    CHECK(fabs((double)s.mesh.albedo[0] - 0.502886) < 1e-4 && s.mesh.albedo[7] == 1, "red is %g, green is %g",
          (double)s.mesh.albedo[0], (double)s.mesh.albedo[7]);
    kit_scene_free(&s);
}

#define GLTF(more) \
    "{\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]," more
#define MESH_OF(uri, bytes) "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}]," BUFFER(uri, bytes)
#define BUFFER(uri, bytes) \
    "\"accessors\":[{\"bufferView\":0,\"count\":3," \
    "\"componentType\":5126,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":36}]," \
    "\"buffers\":[{\"byteLength\":" bytes ",\"uri\":\"" uri "\"}]}"
#define CORNERS_64 "data:application/octet-stream;base64,AACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAA"

/* Returns the largest distance of a coordinate from a place or from that place + size, whichever is nearer. */
static double corners_off(const kit_mesh *m, const double at[3], double size)
{
    double worst = 0;
    for (int k = 0; k < 9; ++k) {
        const double is = (double)m->position[k] + (m->origin[k % 3] - at[k % 3]);
        worst = fmax(worst, fmin(fabs(is), fabs(is - size)));
    }
    return worst;
}

/* Checks that a model far from 0 is drawn near 0: with corners at 1 on the axes, placed by nodes that need doubles, or
   by an OBJ's text. The note says where, and that numbers are coarse if floats hold them: 1.0 apart so far off. */
static void far_away(void)
{
#define EAST 13487434.75
#define SOUTH (-3741689.25)
#define AWAY "[13487434.75,-6.5,-3741689.25]"
#define NODES(nodes) "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[" nodes "],"
#define HERE MESH_OF(CORNERS_64 "AIA/", "36")
#define THERE MESH_OF("data:application/octet-stream;base64,S81NSwAAAAAAAAAASs1NSwAAgD8AAAAASs1NSwAAAAAAAIA/", "36")
    static const struct { const char *name, *text, *note; double at[3], size; } all[] = {
        { "a.gltf", NODES("{\"mesh\":0,\"translation\":" AWAY "}") HERE, "drawn about 13487436,-6,-3741689;",
          { EAST, -6.5, SOUTH }, 1 },
        { "a.gltf", NODES("{\"matrix\":[0,0,-1,0,0,1,0,0,1,0,0,0,0,0,0,1],\"children\":[1]},"
                          "{\"mesh\":0,\"translation\":[3741689.25,-6.5,13487434.75],"
                          "\"rotation\":[0,-0.7071067811865476,0,0.7071067811865476]}") HERE,
          "it lies far from 0", { EAST, -6.5, SOUTH }, 1 },
        { "a.gltf", NODES("{\"translation\":" AWAY ",\"children\":[1]},{\"mesh\":0,"
                          "\"translation\":[-13487434.5,6.5,3741689.25]}") HERE, "", { 0.25, 0, 0 }, 1 },
        { "a.gltf", NODES("{\"mesh\":0,\"translation\":[0,0,1e-3],\"scale\":[1e-9,1e-9,1e-9]}") HERE,
          "it lies far from 0", { 0, 0, 1e-3 }, 1e-9 },
        { "a.gltf", NODES("{\"mesh\":0,\"translation\":[0,3e14,0],\"scale\":[1e9,1e9,1e9]}") HERE,
          "it lies far from 0", { 0, 3e14, 0 }, 1e9 },
        { "a.gltf", NODES("{\"mesh\":0,\"scale\":[1e-12,1e-12,1e-12]}") HERE, "", { 0, 0, 0 }, 1e-12 },
        { "a.gltf", NODES("{\"mesh\":0,\"translation\":[90.25,0,0]}") HERE, "", { 90.25, 0, 0 }, 1 },
        { "a.gltf", NODES("{\"mesh\":0}") THERE, "read as floats, which so far from 0 are 1 apart, 0.58 of its size; "
          "it lies far", { 13487434, 0, 0 }, 1 },
        { "a.gltf", NODES("{\"mesh\":0,\"translation\":[-13487434,0,0]}") THERE,
          "read as floats, which so far from 0 are 1 apart", { 0, 0, 0 }, 1 },
        { "a.obj", "v 0 0 0\nv 13487435.75 -6.5 -3741689.25\nv 13487434.75 \\\n -5.5 -3741689.25 # a comment\n"
                   "v 13487434.75 -6.5 -3741688.25 1 0 0\nf 2/1 3 -1\np 1\n", "it lies far from 0",
          { EAST, -6.5, SOUTH }, 1 },
        { "a.obj", "mtllib one.mtl\nusemtl red\nv 1 0.000000000001 1\nv 1 0 1.000000000001\nv 1.000000000001 0 1\n"
                   "f 1 2 3\n",
          "read as doubles, which so far from 0 are 2.2e-16 apart", { 1, 0, 1 }, 1e-12 },
    };

    kit_error err = { { 0 } };
    kit_scene s;
    write_text("one.mtl", "newmtl red\nKd 1 0 0\n");
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        double away[3];
        const double area = 0.5 * sqrt(3) * all[i].size * all[i].size;
        write_text(all[i].name, all[i].text);
        if (!CHECK(!kit_scene_load(&s, in_folder(all[i].name), 0, &err), "%zu: %s", i, err.text)) continue;
        const double worst = corners_off(&s.mesh, all[i].at, all[i].size);
        CHECK(worst < 1e-3 * all[i].size && fabs(area_of(&s) / area - 1) < 1e-3,
              "%zu: a corner is off by %g of %g, the area by %g", i, worst, all[i].size, area_of(&s) / area);
        for (int k = 0; k < 3; ++k) away[k] = (double)s.camera.eye[k] - (double)s.camera.target[k];
        const double sizes = sqrt(kit_dot(away, away)) / all[i].size;
        CHECK(sizes > 1 && sizes < 10, "%zu: the camera is %g sizes away", i, sizes);
        CHECK(!strstr(all[i].text, "mtllib") || (s.mesh.albedo[0] > 0.99f && s.mesh.albedo[1] < 0.01f),
              "%zu: %g, %g is not red", i, (double)s.mesh.albedo[0], (double)s.mesh.albedo[1]);
        kit_mesh own; /* read without Assimp */
        if (!strcmp(all[i].name, "a.obj") && CHECK(!kit_mesh_obj(&own, NULL, NULL, in_folder("a.obj"), &err), "%s",
                                                   err.text)) {
            CHECK(corners_off(&own, all[i].at, all[i].size) < 1e-3 * all[i].size, "%zu: without Assimp", i);
            kit_mesh_free(&own);
        }
        CHECK(*all[i].note ? strstr(s.note, all[i].note) != NULL : !*s.note, "%zu: \"%s\"", i, s.note);
        kit_scene_free(&s);
    }
}

/* Checks that a morph adds its own corners as often as its weight says. The node's weights replace the mesh's. */
static void morphs(void)
{
#define MORPHED(weights) "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"material\":0," \
    "\"targets\":[{\"POSITION\":0}]}]" weights "}]," BUFFER(CORNERS_64 "AIA/", "36")
#define LIGHT(factor) "\"materials\":[{\"emissiveFactor\":[" factor ",0,0]}],"
    static const struct { const char *text, *note; double size; } all[] = {
        { NODES("{\"mesh\":0}") LIGHT("0") MORPHED(""), "", 1 },
        { NODES("{\"mesh\":0}") LIGHT("0") MORPHED(",\"weights\":[2]"), "", 3 },
        { NODES("{\"mesh\":0,\"weights\":[0.5]}") LIGHT("0") MORPHED(",\"weights\":[2]"), "", 1.5 },
        { NODES("{\"mesh\":0,\"weights\":[0]}") LIGHT("0.5") MORPHED(",\"weights\":[2]"),
          "its materials emit light, which is not read", 1 },
        { NODES("{\"mesh\":0}") "\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0}}}],"
          "\"textures\":[{\"source\":0}],\"images\":[{\"uri\":\"no.png\"}]," MORPHED(""), "no.png", 1 } };
    kit_error err = { { 0 } };
    kit_scene s;
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        write_text("a.gltf", all[i].text);
        if (!CHECK(!kit_scene_load(&s, in_folder("a.gltf"), 0, &err), "%zu: %s", i, err.text)) continue;
        const double area = 0.5 * sqrt(3) * all[i].size * all[i].size;
        CHECK(fabs(area_of(&s) - area) < 1e-6, "%zu: covers %g, not %g", i, area_of(&s), area);
        CHECK(*all[i].note ? strstr(s.note, all[i].note) != NULL : !*s.note, "%zu: \"%s\"", i, s.note);
        kit_scene_free(&s);
    }
}

/* Checks that a refusal is one line with the file, its format and the fault. */
static void refused(void)
{
    static const struct {
        const char *name, *text, *says[2];
    } bad[] = {
        { "bad.gltf", GLTF(MESH_OF("absent.bin", "36")), { "is glTF that cannot be read", "absent.bin" } },
        { "bad.gltf",
          GLTF("\"extensionsRequired\":[\"KHR_materials_unlit\",\"EXT_meshopt_compression\"]," MESH_OF(
              CORNERS_64 "AIA/", "36")),
          { "needs the extension EXT_meshopt_compression", "" } },
        { "bad.gltf", GLTF(MESH_OF(CORNERS_64 "AMB/", "36")), { "a vertex is not within 1e+15 of 0", "" } },
        { "bad.gltf",
          GLTF("\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\"accessors\":[{\"count\":3,"
               "\"componentType\":5126,\"type\":\"VEC3\",\"sparse\":{}}]}"),
          { "bad.gltf: is glTF that", "" } },
        { "bad.gltf", GLTF("\"meshes\":[]}"), { "bad.gltf: ", "" } },
        { "bad.gltf", "{", { "is glTF that cannot be read", "" } },
        { "bad.glb", "", { "is empty", "" } },
        { "bad.ply",
          "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "end_header\n0 0 0\n",
          { "bad.ply: no triangles in it, but a cloud of 1 points", "lift=1,offset=8" } },
        { "bad.obj", "v 0 0 0\nv 1 0 0\n", { "a cloud of 2 points", "" } },
        { "bad.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", { "bad.obj: no triangles in it", "" } },
        { "bad.usdz", "PK\3\4", { "is USDZ, which is not read", "glTF, PLY, FBX" } },
        { "notes.txt", "bread\nmilk\n", { "is of no format that is known; read as an OBJ: no triangles", "" } },
    };

    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_error err = { { 0 } };
        kit_scene s;
        write_text(bad[i].name, bad[i].text);
        if (!CHECK(kit_scene_load(&s, in_folder(bad[i].name), 0, &err) == -1, "%s, number %zu is read", bad[i].name, i))
            continue;
        CHECK(strstr(err.text, bad[i].says[0]) && strstr(err.text, bad[i].says[1]) && strstr(err.text, bad[i].name)
                  && !strchr(err.text, '\n'),
              "number %zu: \"%s\"", i, err.text);
    }
}

/* Checks that a model stands upright: z is up, and the front looks along y. */
static void upright(void)
{
    static const char text[] =
        "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\nFBXVersion: 7400\n}\n"
        "GlobalSettings: {\nVersion: 1000\nProperties70: {\nP: \"UpAxis\", \"int\", \"Integer\", \"\",2\n"
        "P: \"UpAxisSign\", \"int\", \"Integer\", \"\",1\nP: \"FrontAxis\", \"int\", \"Integer\", \"\",1\n"
        "P: \"FrontAxisSign\", \"int\", \"Integer\", \"\",-1\n"
        "P: \"CoordAxis\", \"int\", \"Integer\", \"\",0\nP: \"CoordAxisSign\", \"int\", \"Integer\", \"\",1\n"
        "}\n}\nObjects: {\nGeometry: 1, \"Geometry::g\", \"Mesh\" {\nVertices: *9 {\na: 0,0,0,1,0,0,0,3,2\n"
        "}\nPolygonVertexIndex: *3 {\na: 0,1,-3\n}\n}\nModel: 2, \"Model::m\", \"Mesh\" {\nVersion: 232\n}\n"
        "}\nConnections: {\nC: \"OO\",1,2\nC: \"OO\",2,0\n}\n";
    static const float at[9] = { 0, 0, 0, 1, 0, 0, 0, 2, -3 };
    kit_error err = { { 0 } };
    kit_scene s;
    write_text("up.fbx", text);
    if (!CHECK(!kit_scene_load(&s, in_folder("up.fbx"), 0, &err), "%s", err.text)) return;
    for (int i = 0; i < 9 && s.mesh.triangles == 1; ++i)
        CHECK(s.mesh.position[i] == at[i], "coordinate %d is %g, not %g", i, (double)s.mesh.position[i], (double)at[i]);
    kit_scene_free(&s);
}

static void without_assimp(void)
{
    kit_error err = { { 0 } };
    kit_scene s;
    write_text("nodes.glb", "glTF");
    CHECK(
        kit_scene_load(&s, in_folder("nodes.glb"), 0, &err) == -1
            && strstr(err.text, "nodes.glb: is glTF binary; this build reads OBJ alone: apt-get install libassimp-dev"),
        "\"%s\"", err.text);
}

/* ---- files that are no models -------------------------------------------------------------------------------- */

static void no_scene(void)
{
    kit_error err = {{0}};
    kit_scene scene;
    const char *name;
    CHECK(kit_scene_load(&scene, in_folder("nowhere"), 0, &err) == -1, "a scene that is nowhere was found");
    CHECK(strstr(err.text, "nowhere") != NULL, "\"%s\"", err.text);
    for (int i = 0; (name = kit_scene_builtin(i, NULL)) != NULL; ++i)
        CHECK(strstr(err.text, name) != NULL, "%s is not named: \"%s\"", name, err.text);
    if (!CHECK(!mkfifo(in_folder("pipe"), 0600), "no pipe can be made")) return;
    alarm(60);                             /* ends the test: waiting for a writer never would */
    CHECK(kit_scene_load(&scene, in_folder("pipe"), 0, &err) == -1 && strstr(err.text, "not a regular file"), "\"%s\"",
          err.text);
    alarm(0);
}

void test_models(void)
{
    if (!folder_begin()) return;
    RUN("a PNG read back is what was written", png);
    if (kit_assimp_version()) {
        RUN("nodes of a .glb stand, are scaled and mirrored as it says; their names, colours and normals",
            nodes_of_glb);
        RUN("a card is cut exactly along its texels, where its texture is repeated, mirrored or goes on, too", cards);
        RUN("a PLY's polygons, parts and colours", ply);
        RUN("an FBX whose z axis is up stands upright", upright);
        RUN("models far from 0 stand where their files say, to doubles; what is coarse is said", far_away);
        RUN("a glTF's morphs stand by its weights; that it emits light or lacks a picture is said", morphs);
        RUN("what cannot be read is refused in one line that says why", refused);
    } else {
        RUN("without Assimp a .glb is refused in one line that says what would help", without_assimp);
        printf("skipped: models but OBJ: Assimp is missing (apt-get install libassimp-dev)\n");
    }
    RUN("a scene that is none: all built-in ones are named; a pipe is not waited for", no_scene);
    folder_end();
}
