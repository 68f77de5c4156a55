/* shell.h - a folder for tests that run programs. It is removed after them. */
#ifndef SHELL_H
#define SHELL_H
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "kit/kit.h"
#include "t.h"

static char folder[64];

/* Runs a shell line and puts both its outputs into text; returns its status. */
static inline int shell(char *text, size_t size, const char *format, const char *a, const char *b)
{
    char line[4096];
    size_t n = 0, got;
    FILE *pipe;
    int status;
    int length = snprintf(line, sizeof line, "cd '%s' && { ", folder);
    length += snprintf(line + length, sizeof line - (size_t)length, format, a, b);
    snprintf(line + length, sizeof line - (size_t)length, " ; } 2>&1");
    pipe = popen(line, "r");
    if (!pipe) return -1;
    while (n + 1 < size && (got = fread(text + n, 1, size - 1 - n, pipe)) > 0) n += got;
    text[n] = 0;
    while (fgetc(pipe) != EOF) {}
    status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + (WIFSIGNALED(status) ? WTERMSIG(status) : 0);
}

static inline const char *in_folder(const char *name)      /* the path is valid until the fourth next call */
{
    static char path[4][1024];
    static int turn;
    turn = (turn + 1) % 4;
    snprintf(path[turn], sizeof path[turn], "%s/%s", folder, name);
    return path[turn];
}

static inline void write_text(const char *name, const char *text)
{
    kit_file_write(in_folder(name), text, strlen(text), NULL);
}

static inline char *read_text(const char *path)
{
    char *data = NULL;
    size_t size;
    return kit_file_read(&data, &size, path, NULL) ? NULL : data;
}

/* Returns whether a program is installed. If not, says that its tests are not tried. */
static inline int has(const char *program)
{
    char text[400];
    const int here = !shell(text, sizeof text, "command -v %s%s", program, "");
    if (!here) t_note("%s is not here: not tried", program);
    return here;
}

/* Makes the folder, with both headers in it. */
static inline int folder_begin(void)
{
    char text[1000];
    strcpy(folder, "/tmp/ssgi-test-XXXXXX");
    return CHECK(mkdtemp(folder) && !shell(text, sizeof text, "cp '%s/ssgi.h' '%s/ssgi_gl.h' .", t_root, t_root),
                 "no temporary folder");
}

static inline void folder_end(void)
{
    char text[1000];
    shell(text, sizeof text, "cd / && rm -rf '%s'%s", folder, "");
}
#endif
