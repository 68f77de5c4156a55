/* materials.c - MTL files: diffuse colours by name. Declared in kit_obj.h. */
#include "kit/kit_obj.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const float kit_grey[3] = { 0.8f, 0.8f, 0.8f };

kit_key kit_rest(kit_text *t)
{
    const char *end = t->end;
    kit_skip_blanks(t);
    while (end > t->at && kit_blank(end[-1])) --end;
    return (kit_key){ t->at, (size_t)(end - t->at) };
}

kit_key kit_without_comment(kit_key name)
{
    for (size_t i = 1; i < name.length; ++i)
        if (name.bytes[i] == '#' && kit_blank(name.bytes[i - 1])) {
            while (i > 0 && kit_blank(name.bytes[i - 1])) --i;
            return (kit_key){ name.bytes, i };
        }
    return name;
}

void kit_materials_free(kit_materials *m)
{
    for (size_t i = 0; i < m->text.count; ++i) free(((char **)m->text.data)[i]);
    for (int way = 0; way < 2; ++way) { free(m->named[way].data); free(m->found[way].slot); }
    free(m->albedo.data);
    free(m->text.data);
}

/* A grey one; NULL: no memory. */
static float *material_add(kit_materials *m, kit_key name, const kit_text *t)
{
    kit_key *whole = kit_array_add(&m->named[0], 1, sizeof *whole, t),
            *bare = kit_array_add(&m->named[1], 1, sizeof *bare, t);
    float *albedo = kit_array_add(&m->albedo, 3, sizeof *albedo, t);
    if (!whole || !bare || !albedo) return NULL;
    *whole = name;
    *bare = kit_without_comment(name);
    return memcpy(albedo, kit_grey, sizeof kit_grey);
}

static int materials_read(kit_materials *m, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return 0;                      /* kit_grey, as if there were none */
    kit_text_prepare(data, size);
    kit_text t = kit_text_start(path, data, size, err);
    char **kept = kit_array_add(&m->text, 1, sizeof *kept, &t);
    if (!kept) { free(data); return -1; }
    *kept = data;
    for (float *now = NULL; kit_next_line(&t);) {
        if (kit_keyword(&t, "newmtl")) {
            if (!(now = material_add(m, kit_rest(&t), &t))) return -1;
        } else if (now && kit_keyword(&t, "Kd")) {
            static const char what[] = "Kd needs 1 or 3 numbers";
            float kd[3];
            kit_skip_blanks(&t);
            /* "xyz", "spectral": no rgb */
            if (t.end - t.at >= 3 && (!memcmp(t.at, "xyz", 3) || !memcmp(t.at, "spe", 3))) continue;
            if (kit_number(&t, &kd[0], what)) return -1;
            kd[1] = kd[2] = kd[0];
            if (kit_at_value(&t) && (kit_number(&t, &kd[1], what) || kit_number(&t, &kd[2], what))) return -1;
            for (int k = 0; k < 3; ++k) now[k] = fmaxf(0, fminf(1, kd[k]));
        }
    }
    return 0;
}

int kit_mtllib_add(kit_array *mtllibs, const kit_text *t, kit_key name)
{
    const char *slash = strrchr(t->path, '/');
    const size_t folder = slash && *name.bytes != '/' ? (size_t)(slash - t->path) + 1 : 0;
    const kit_key bare = kit_without_comment(name);
    struct stat status;
    char *path = malloc(folder + name.length + 1);
    if (!path) return kit_fail(t->err, "%s: no memory for the names of its materials' files", t->path);
    memcpy(path, t->path, folder);
    memcpy(path + folder, name.bytes, name.length);
    path[folder + name.length] = 0;
    for (char *p = path + folder; *p; ++p) if (*p == '\\') *p = '/';            /* as Windows writes it */
    int there = !stat(path, &status);
    if (!there && bare.length < name.length) {
        path[folder + bare.length] = 0;
        there = !stat(path, &status);
    }
    kit_mtllib *l = there ? kit_array_add(mtllibs, 1, sizeof *l, t) : NULL;
    if (!l) { free(path); return there ? -1 : 0; }
    memset(l, 0, sizeof *l);               /* id is a key: no byte of it may be left to chance */
    l->path = path;
    l->id.device = status.st_dev;
    l->id.file = status.st_ino;
    return 0;
}

int kit_mtllibs_read(kit_materials *m, const kit_array *mtllibs, const kit_text *t)
{
    const kit_mtllib *l = mtllibs->data;
    const size_t count = mtllibs->count;
    kit_table last = { 0 };
    kit_key *id = malloc(count * sizeof *id + 1);
    char *reads = malloc(count + 1);
    int failed = 0;
    for (size_t i = 0; id && i < count; ++i) id[i] = (kit_key){ (const char *)&l[i].id, sizeof l[i].id };
    if (!id || !reads || kit_table_open(&last, id, count))
        failed = kit_fail(t->err, "%s: no memory for the names of its materials' files", t->path);
    for (size_t i = count; !failed && i-- > 0;) reads[i] = kit_table_add(&last, (uint32_t)i) == i;
    for (size_t i = 0; !failed && i < count; ++i) if (reads[i]) failed = materials_read(m, l[i].path, t->err);
    free(last.slot);
    free(id);
    free(reads);
    return failed;
}

int kit_materials_close(kit_materials *m, const kit_text *t)
{
    const size_t count = m->named[0].count;
    for (int way = 0; way < 2; ++way) {
        if (kit_table_open(&m->found[way], m->named[way].data, count))
            return kit_fail(t->err, "%s: no memory for its materials", t->path);
        for (size_t i = count; i-- > 0;) kit_table_add(&m->found[way], (uint32_t)i);
    }
    return 0;
}

const float *kit_material_find(const kit_materials *m, kit_key name)
{
    const kit_key wanted[2] = { name, kit_without_comment(name) };
    for (int way = 0; way < 2; ++way) {
        const uint32_t slot = *kit_table_slot(&m->found[way], &wanted[way]);
        if (slot) return (const float *)m->albedo.data + 3 * (slot - 1);
    }
    return kit_grey;
}
