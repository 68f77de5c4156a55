/* gltf.c - reads properties of nodes from a glTF's JSON that Assimp rounds to floats or leaves out. Declared in
   kit_models.h.

   Nodes are read only after Assimp has read the file, so its JSON is well formed. If it is not, nothing is read beyond
   the 0 at its end. */
#include "kit/kit_models.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>JSON ------------------------------------------------------------------------------------------------------ */

static const char *behind_blanks(const char *at) { return at + strspn(at, " \t\r\n"); }

static const char *behind_string(const char *at)
{
    for (++at; *at && *at != '"'; ++at)
        if (*at == '\\' && at[1]) ++at;
    return *at ? at + 1 : at;
}

static const char *behind_value(const char *at)
{
    int depth = 0;
    do {
        const size_t plain = strcspn(at, " \t\r\n,:{}[]\"");
        if (*at == '"') {
            at = behind_string(at);
            continue;
        }
        depth += (*at == '{' || *at == '[') - (*at == '}' || *at == ']');
        at += plain ? plain : 1;
    } while (*at && depth > 0);
    return behind_blanks(at);
}

const char *kit_gltf_member(const char *object, const char *name)
{
    const size_t length = strlen(name);
    if (!object || *object != '{') return NULL;
    for (const char *at = behind_blanks(object + 1); *at == '"';) {
        const char *key = at + 1, *end = behind_blanks(behind_string(at));
        if (*end != ':') return NULL;
        at = behind_blanks(end + 1);
        if (!strncmp(key, name, length) && key[length] == '"') return at;
        at = behind_value(at);
        if (*at == ',') at = behind_blanks(at + 1);
    }
    return NULL;
}

static const char *element_at(const char *at) { return *at && *at != ']' ? at : NULL; }

const char *kit_gltf_first(const char *array)
{
    return array && *array == '[' ? element_at(behind_blanks(array + 1)) : NULL;
}

const char *kit_gltf_next(const char *element)
{
    const char *at = behind_value(element);
    return *at == ',' ? element_at(behind_blanks(at + 1)) : NULL;
}

size_t kit_gltf_numbers(double *out, size_t most, const char *array)
{
    size_t count = 0;
    for (const char *at = kit_gltf_first(array); at; at = kit_gltf_next(at), ++count)
        if (count < most) out[count] = strtod(at, NULL);
    return count;
}

/* ---- >>nodes ----------------------------------------------------------------------------------------------------- */

int kit_gltf_text(kit_gltf *g, const char *path, kit_error *err)
{
    size_t size, from = 0, length;
    memset(g, 0, sizeof *g);
    if (kit_file_read(&g->data, &size, path, err)) return -1;
    length = size;
    if (size >= 20 && !memcmp(g->data, "glTF", 4)) { /* a GLB: a header of 12 bytes, then the JSON's length and kind */
        const unsigned char *p = (const unsigned char *)g->data + 12;
        length = (size_t)p[0] | (size_t)p[1] << 8 | (size_t)p[2] << 16 | (size_t)p[3] << 24;
        from = 20;
        if (length > size - from) length = size - from;
    }
    g->data[from + length] = 0;
    g->text = g->data + from;
    return 0;
}

int kit_gltf_open(kit_gltf *g, const char *path, kit_error *err)
{
    const kit_source source = { path, 0, err };
    if (kit_gltf_text(g, path, err)) return -1;
    g->text = (char *)behind_blanks(g->text);
    const char *at = kit_gltf_first(kit_gltf_member(g->text, "nodes"));
    for (; at; at = kit_gltf_next(at)) {
        const char **node = kit_array_add(&g->node, 1, sizeof *node, &source);
        if (!node) {
            kit_gltf_close(g);
            return -1;
        }
        *node = at;
    }
    return 0;
}

void kit_gltf_close(kit_gltf *g)
{
    free(g->node.data);
    free(g->data);
    memset(g, 0, sizeof *g);
}

static size_t number_of(const char *element) { return element ? (size_t)strtoul(element, NULL, 10) : 0; }

const char *kit_gltf_node(const kit_gltf *g, const char *element)
{
    const size_t i = number_of(element);
    return i < g->node.count ? ((const char *const *)g->node.data)[i] : NULL;
}

const char *kit_gltf_roots(const kit_gltf *g)
{
    const char *scene = kit_gltf_first(kit_gltf_member(g->text, "scenes"));
    for (size_t i = number_of(kit_gltf_member(g->text, "scene")); scene && i > 0; --i) scene = kit_gltf_next(scene);
    return kit_gltf_member(scene, "nodes");
}

void kit_gltf_place(double m[3][4], const char *node)
{
    double all[16], t[3] = { 0 }, q[4] = { 0, 0, 0, 1 }, s[3] = { 1, 1, 1 };
    if (kit_gltf_numbers(all, 16, kit_gltf_member(node, "matrix")) == 16) {
        for (int i = 0; i < 12; ++i) m[i / 4][i % 4] = all[4 * (i % 4) + i / 4];
        return;
    }
    kit_gltf_numbers(t, 3, kit_gltf_member(node, "translation"));
    kit_gltf_numbers(q, 4, kit_gltf_member(node, "rotation"));
    kit_gltf_numbers(s, 3, kit_gltf_member(node, "scale"));
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[3][3] = { { 1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w) },
                                { 2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w) },
                                { 2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y) } };
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) m[i][k] = turn[i][k] * s[k];
        m[i][3] = t[i];
    }
}
