/* script.c - writes a view for peers.mjs: size, planes, radius, matrices and a depth. Declared in script.h. */
#include "lab/measure/script.h"
#include <stdio.h>
#include <stdlib.h>
#include "lab/measure/folder.h"

int script_run(const char *folder, const kit_camera *c, float radius, double depth, int quick, kit_error *err)
{
    float matrix[2][16];
    char path[128], command[320], text[1024];
    size_t n;
    kit_camera_matrices(c, matrix[1], matrix[0]);
    n = (size_t)snprintf(text, sizeof text, "%d %d %.9g %.9g %.9g", c->width, c->height, (double)c->znear,
                         (double)c->zfar, (double)radius);
    for (int i = 0; i < 32; ++i)
        n += (size_t)snprintf(text + n, sizeof text - n, " %.9g", (double)matrix[i / 16][i % 16]);
    n += (size_t)snprintf(text + n, sizeof text - n, " %.9g\n", depth);
    snprintf(path, sizeof path, "%s/view.txt", folder);
    if (folder_make(folder, err) || kit_file_write(path, text, n, err)) return -1;
    snprintf(command, sizeof command, "node " SCRIPT " %s%s < %s", folder, quick ? " quick" : "", path);
    return !system(command);
}
