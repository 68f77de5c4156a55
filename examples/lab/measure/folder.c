/* folder.c - makes the folders that outputs go to. Declared in folder.h. */
#include "lab/measure/folder.h"
#include <errno.h>
#include <string.h>
#include <sys/stat.h>

int folder_make(const char *path, kit_error *err)
{
    char part[4096];
    struct stat status;
    if (strlen(path) >= sizeof part - 64) return kit_fail(err, "--out %.60s...: too long", path);
    for (size_t i = 1; i <= strlen(path); ++i) {
        if (path[i] != '/' && path[i]) continue;
        memcpy(part, path, i);
        part[i] = 0;
        if (mkdir(part, 0777) && errno != EEXIST) return kit_fail(err, "%s: cannot be made: %s", part, strerror(errno));
    }
    if (stat(path, &status) || !S_ISDIR(status.st_mode)) return kit_fail(err, "%s: is not a folder", path);
    return 0;
}
