/* ssgi.c - the headers as WebAssembly, without a C library: make wasm builds build/wasm/ssgi.wasm, ssgi.mjs loads it.

   What a page needs is exported by name; the linker drops the rest. For more (surfels, fields, lights, plans) add lines
   of EXPORT. Memory is the page's: from __heap_base on nothing here touches what it does not get a pointer to. */
#include "../../ssgi_gl.h"

#define EXPORT(function) extern __typeof__(function) function __attribute__((export_name(#function)))
EXPORT(ssgi_view_from_projection);
EXPORT(ssgi_gl_choice_at);
EXPORT(ssgi_gl_check);
EXPORT(ssgi_gl_preset);
EXPORT(ssgi_gl_resolve);
EXPORT(ssgi_gl_emit);
EXPORT(ssgi_gl_key);
EXPORT(ssgi_gl_pass_name);
EXPORT(ssgi_gl_dialect_name);
EXPORT(ssgi_gl_reflect);
EXPORT(ssgi_gl_member_at);
EXPORT(ssgi_gl_frame_init);
EXPORT(ssgi_gl_frame_history);
EXPORT(ssgi_gl_phase);
EXPORT(ssgi_gl_harmonics_set);
/* ssgi_gl_steps goes here */

/* Sizes and places of members, in the order in which ssgi.mjs reads them. */
const int32_t *ssgi_wasm_layout(void) __attribute__((export_name("ssgi_wasm_layout")));
const int32_t *ssgi_wasm_layout(void)
{
#define AT(of, member) (int32_t)offsetof(of, member)
    static const int32_t layout[] = {
        sizeof(ssgi_view), sizeof(ssgi_gl_desc), sizeof(ssgi_gl_frame), sizeof(ssgi_gl_views), sizeof(ssgi_gl_io),
        AT(ssgi_gl_desc, version), AT(ssgi_gl_desc, fetch),
        AT(ssgi_gl_choice, name), AT(ssgi_gl_choice, values), AT(ssgi_gl_choice, sentence), AT(ssgi_gl_choice, offset),
        AT(ssgi_gl_choice, most),
        AT(ssgi_gl_io, name), AT(ssgi_gl_io, kind), AT(ssgi_gl_io, type), AT(ssgi_gl_io, slot), AT(ssgi_gl_io, offset),
        AT(ssgi_gl_io, format), SSGI_VERSION_MAJOR, SSGI_VERSION_MINOR
    };
    return layout;
}

#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi.h"
#include "../../ssgi_gl.h"

/* ---- libc/string.h; the Makefile's -fno-builtin keeps these loops from becoming calls to themselves */

void *memcpy(void *to, const void *from, size_t n)
{
    for (size_t i = 0; i < n; ++i) ((char *)to)[i] = ((const char *)from)[i];
    return to;
}

void *memset(void *to, int byte, size_t n)
{
    for (size_t i = 0; i < n; ++i) ((char *)to)[i] = (char)byte;
    return to;
}

int memcmp(const void *a, const void *b, size_t n)
{
    const unsigned char *s = a, *t = b;
    for (; n; --n, ++s, ++t) if (*s != *t) return *s - *t;
    return 0;
}

void *memchr(const void *s, int byte, size_t n)
{
    for (const unsigned char *at = s; n; --n, ++at) if (*at == (unsigned char)byte) return (void *)(uintptr_t)at;
    return NULL;
}

size_t strlen(const char *s)
{
    const char *end = s;
    while (*end) ++end;
    return (size_t)(end - s);
}

int strncmp(const char *a, const char *b, size_t n)
{
    for (; n; --n, ++a, ++b) if (*a != *b || !*a) return (unsigned char)*a - (unsigned char)*b;
    return 0;
}

int strcmp(const char *a, const char *b)
{
    return strncmp(a, b, SIZE_MAX);
}

char *strchr(const char *s, int c)
{
    while (*s && *s != (char)c) ++s;
    return *s == (char)c ? (char *)(uintptr_t)s : NULL;
}

char *strstr(const char *s, const char *part)
{
    const size_t n = strlen(part);
    while (*s && strncmp(s, part, n)) ++s;
    return *s || !n ? (char *)(uintptr_t)s : NULL;
}

size_t strcspn(const char *s, const char *stop)
{
    size_t n = 0;
    while (s[n] && !strchr(stop, s[n])) ++n;
    return n;
}
