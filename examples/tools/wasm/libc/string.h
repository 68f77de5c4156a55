/* string.h - the functions of a C library that the headers need, on a machine without one: string.c defines them. */
#ifndef SSGI_WASM_STRING_H
#define SSGI_WASM_STRING_H
#include <stddef.h>

void  *memcpy(void *to, const void *from, size_t n);
void  *memset(void *to, int byte, size_t n);
int    memcmp(const void *a, const void *b, size_t n);
void  *memchr(const void *s, int byte, size_t n);
size_t strlen(const char *s);
int    strcmp(const char *a, const char *b);
int    strncmp(const char *a, const char *b, size_t n);
char  *strchr(const char *s, int c);
char  *strstr(const char *s, const char *part);
size_t strcspn(const char *s, const char *stop);

#endif
