/* library.c - the GLSL of ssgi_gl.h as files, for an editor's colours and checks: make glsl-out DIR=d writes them,
   make glsl-in DIR=d reads them back into the header, which stays what is shipped.

     build/library out ssgi_gl.h DIR        a file a room: DIR/fetch.glsl, DIR/visibility.glsl ..
     build/library in ssgi_gl.h DIR

   In a file each entry of the library stands behind a line "//@ NAME", the name that other functions use; lines of #if,
   #elif, #else and #endif, and "// #if .." at a line's end, are the emitter's (ssgi_gl.h, >>library). What stands in
   comments between entries is kept. Both ways are exact: out and in again leaves the header as it was. */
#include "kit/kit.h"

#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { LINE = 256, ROOMS = 32 };

static const char first_line[] = "static const ssgi_gl__code ssgi_gl__library[] = {\n",
                  room_mark[] = "/* ==== >>", entry_mark[] = "//@ ";

/* A text that grows. */
typedef struct text { char *data; size_t size, room; int failed; } text;

static void put(text *t, const char *s, size_t n)
{
    if (t->size + n + 1 > t->room) {
        const size_t room = 2 * (t->size + n + 1);
        char *data = realloc(t->data, room);
        if (!data) t->failed = 1;
        if (!data) return;
        t->data = data;
        t->room = room;
    }
    memcpy(t->data + t->size, s, n);
    t->size += n;
    t->data[t->size] = 0;
}

static void puts_to(text *t, const char *s) { put(t, s, strlen(s)); }

/* The library's lines in the header: from behind the first one to before the last. */
static int library_of(const char **from, const char **to, const char *header, const char *path, kit_error *err)
{
    const char *at = strstr(header, first_line);
    *from = at ? at + strlen(first_line) : NULL;
    *to = at ? strstr(*from, "\n};\n") : NULL;
    if (!*to) return kit_fail(err, "%s: has no library of GLSL (%.*s)", path, (int)strlen(first_line) - 1, first_line);
    ++*to;
    return 0;
}

/* A room's file, from its first line. */
static int room_path(char path[4096], const char *folder, const char *line)
{
    const char *name = line + strlen(room_mark);
    const int length = (int)strspn(name, "abcdefghijklmnopqrstuvwxyz_");
    const int n = snprintf(path, 4096, "%s/%.*s.glsl", folder, length, name);
    return length > 0 && n > 0 && n < 4096;
}

/* ---- out --------------------------------------------------------------------------------------------------------- */

/* The lines of GLSL in a C string's source, up to the end of its literals on this line. */
static int unquoted(text *out, const char *line, const char *end)
{
    const char *at = memchr(line, '"', (size_t)(end - line));
    if (!at) return 0;
    for (++at; at < end && *at != '"'; ++at) {
        if (*at != '\\') put(out, at, 1);
        else if (*++at == 'n') put(out, "\n", 1);
        else if (*at == '"' || *at == '\\') put(out, at, 1);
        else return 0;
    }
    return at < end && *at == '"';
}

static int write_rooms(const char *from, const char *to, const char *folder, kit_error *err)
{
    text out = { 0 };
    char path[4096] = "";
    int failed = 0, line_number = 0;
    for (const char *line = from, *end; line < to && !failed; line = end) {
        char name[LINE];
        end = strchr(line, '\n') + 1;
        ++line_number;
        if (!strncmp(line, room_mark, strlen(room_mark))) {
            if (*path) failed = kit_file_write(path, out.data, out.size, err);
            out.size = 0;
            if (!failed && !room_path(path, folder, line)) failed = kit_fail(err, "%s: is no room's name", path);
        }
        if (!*path) failed = kit_fail(err, "line %d of the library: stands before the first room", line_number);
        else if (sscanf(line, "{ \"%255[^\"]\", __LINE__ + 1,", name) == 1) {
            puts_to(&out, entry_mark);
            puts_to(&out, name);
            puts_to(&out, "\n");
        } else if (!strncmp(line, "    \"", 5)) {
            if (!unquoted(&out, line, end))
                failed = kit_fail(err, "line %d of the library: is no string", line_number);
        } else put(&out, line, (size_t)(end - line));
    }
    if (!failed && out.failed) failed = kit_fail(err, "out of memory");
    if (!failed && *path) failed = kit_file_write(path, out.data, out.size, err);
    free(out.data);
    return failed;
}

/* ---- in ---------------------------------------------------------------------------------------------------------- */

static void quoted(text *out, const char *line, size_t length)
{
    puts_to(out, "    \"");
    for (size_t i = 0; i < length; ++i) {
        if (line[i] == '"' || line[i] == '\\') puts_to(out, "\\");
        put(out, line + i, 1);
    }
    puts_to(out, "\\n\"");
}

/* Is every #if of an entry closed? Returns the line that is wrong, counted from 0, or -1. */
static int unclosed(const char *lines, const char *end)
{
    int depth = 0, number = 0, opened = 0;
    for (const char *line = lines; line < end; line = strchr(line, '\n') + 1, ++number) {
        if (!strncmp(line, "#if ", 4) && !depth++) opened = number;
        else if (!strncmp(line, "#endif\n", 7) && --depth < 0) return number;
        else if ((!strncmp(line, "#el", 3)) && !depth) return number;
    }
    return depth ? opened : -1;
}

static void put_entry(text *out, const char *lines, const char *end)
{
    for (const char *line = lines, *stop; line < end; line = stop + 1) {
        stop = strchr(line, '\n');
        quoted(out, line, (size_t)(stop - line));
        puts_to(out, stop + 1 < end ? "\n" : " },\n");
    }
}

static size_t lines_between(const char *from, const char *to)
{
    size_t count = 0;
    for (; from < to; ++from) count += *from == '\n';
    return count;
}

static int read_room(text *out, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, err)) return -1;
    const int text_ends = size && data[size - 1] == '\n' && !memchr(data, 0, size);
    int failed = text_ends ? 0 : kit_fail(err, "%s: is no text that ends its last line", path), number = 0;
    for (char *line = data, *end; *line && !failed; line = end) {
        end = strchr(line, '\n') + 1;
        ++number;
        if (strncmp(line, entry_mark, strlen(entry_mark))) {
            put(out, line, (size_t)(end - line));
            continue;
        }
        const size_t name = strlen(entry_mark);
        puts_to(out, "{ \"");
        put(out, line + name, (size_t)(end - line) - name - 1);
        puts_to(out, "\", __LINE__ + 1,\n");
        char *stop = end;                      /* the entry ends before a blank line that an entry or comment follows */
        while (*stop && !(stop[0] == '\n' && (!stop[1] || !strncmp(stop + 1, entry_mark, name) || stop[1] == '/'))) {
            char *next = strchr(stop, '\n') + 1;
            ++number;
            stop = next;
        }
        const int first = number - (int)lines_between(end, stop), wrong = unclosed(end, stop);
        if (stop == end) failed = kit_fail(err, "%s: line %d: an entry without text", path, number);
        else if (wrong >= 0)
            failed = kit_fail(err, "%s: line %d: #if and #endif are not in pairs", path, first + 1 + wrong);
        put_entry(out, end, stop);
        end = stop;
    }
    free(data);
    return failed;
}

/* A .glsl in the folder that is no room's would be lost without a word. */
static int no_strangers(const char *from, const char *to, const char *folder, kit_error *err)
{
    DIR *files = opendir(folder);
    int failed = files ? 0 : kit_fail(err, "%s: cannot be read: %s", folder, strerror(errno));
    for (struct dirent *file; !failed && (file = readdir(files)) != NULL;) {
        const size_t length = strlen(file->d_name);
        char path[4096];
        int known = length < 5 || strcmp(file->d_name + length - 5, ".glsl");
        for (const char *line = from; line < to && !known; line = strchr(line, '\n') + 1)
            known = !strncmp(line, room_mark, strlen(room_mark)) && room_path(path, folder, line)
                 && !strcmp(strrchr(path, '/') + 1, file->d_name);
        if (!known)
            failed = kit_fail(err, "%s/%s: is no room of the header: a new room begins with its \"%s..\" line there",
                              folder, file->d_name, room_mark);
    }
    if (files) closedir(files);
    return failed;
}

/* Rooms come in the header's order. */
static int read_rooms(text *out, const char *from, const char *to, const char *folder, kit_error *err)
{
    if (no_strangers(from, to, folder, err)) return -1;
    for (const char *line = from; line < to; line = strchr(line, '\n') + 1) {
        char path[4096];
        if (strncmp(line, room_mark, strlen(room_mark))) continue;
        if (!room_path(path, folder, line) || read_room(out, path, err)) return -1;
    }
    return out->failed ? kit_fail(err, "out of memory") : 0;
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    char *header = NULL;
    const char *from, *to;
    size_t size;
    text out = { 0 };
    const int in = argc == 4 && !strcmp(argv[1], "in");
    if (argc != 4 || (!in && strcmp(argv[1], "out"))) {
        fputs("usage: library out|in ssgi_gl.h DIR: writes the header's GLSL as files, or reads them back\n", stderr);
        return 2;
    }
    int failed = kit_file_read(&header, &size, argv[2], &err) || library_of(&from, &to, header, argv[2], &err);
    if (!failed && !in && mkdir(argv[3], 0777) && errno != EEXIST)
        failed = kit_fail(&err, "%s: cannot be made: %s", argv[3], strerror(errno));
    if (!failed && !in) failed = write_rooms(from, to, argv[3], &err);
    if (!failed && in) {
        put(&out, header, (size_t)(from - header));
        failed = read_rooms(&out, from, to, argv[3], &err);
        puts_to(&out, to);
        failed = failed || kit_file_write(argv[2], out.data, out.size, &err);
    }
    if (failed) fprintf(stderr, "library: %s\n", err.text);
    free(header);
    free(out.data);
    return failed ? 2 : 0;
}
