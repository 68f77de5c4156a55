/* string.c - implements libc/string.h; include it after all code that calls it. The Makefile's -fno-builtin keeps these
   loops from becoming calls of themselves. */
#include <stddef.h>
#include <stdint.h>
#include <string.h>

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
