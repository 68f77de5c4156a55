/* text.c - an OBJ's and an MTL's lines and numbers, growing arrays, names found by a hash. Declared in kit_obj.h. */
#include "kit/kit_obj.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

void kit_text_prepare(char *data, size_t size)
{
    char *start = data, *end = data + size;
    const int only_cr = !memchr(data, '\n', size);
    for (char *p = data; only_cr && (p = memchr(p, '\r', (size_t)(end - p))) != NULL; ++p) *p = '\n';
    if (size >= 3 && !memcmp(data, "\xEF\xBB\xBF", 3)) memset(data, ' ', 3);      /* byte order mark */
    while (start < end) {
        char *stop = memchr(start, '\n', (size_t)(end - start));
        if (!stop) stop = end;
        char *p = stop, *first = start;
        while (first < stop && kit_blank(*first)) ++first;
        if (p > start && p[-1] == '\r') --p;
        if (stop < end && p > start && p[-1] == '\\' && *first != '#') {
            memset(p - 1, ' ', (size_t)(stop - p + 1));
            *stop = KIT_CONTINUED;
        }
        start = stop + 1;
    }
}

kit_text kit_text_start(const char *path, const char *data, size_t size, kit_error *err)
{
    return (kit_text){ .path = path, .next = data, .last = data + size, .following = 1, .err = err };
}

void kit_skip_blanks(kit_text *t) { while (t->at < t->end && kit_blank(*t->at)) ++t->at; }

int  kit_at_value(kit_text *t) { kit_skip_blanks(t); return t->at < t->end && *t->at != '#'; }

int kit_next_line(kit_text *t)
{
    if (t->next >= t->last) return 0;
    const char *stop = memchr(t->next, '\n', (size_t)(t->last - t->next));
    t->at = t->next;
    t->end = stop ? stop : t->last;
    t->next = stop ? stop + 1 : t->last;
    t->line = t->following++;
    for (const char *p = t->at; (p = memchr(p, KIT_CONTINUED, (size_t)(t->end - p))); ++p) t->following++;
    kit_skip_blanks(t);
    return 1;
}

int kit_keyword(kit_text *t, const char *word)
{
    size_t n = strlen(word);
    if ((size_t)(t->end - t->at) < n || memcmp(t->at, word, n)) return 0;
    if (t->at + n < t->end && !kit_blank(t->at[n])) return 0;
    t->at += n;
    return 1;
}

int kit_text_fail(const kit_text *t, const char *what)
{
    int length = 0;
    while (t->at + length < t->end && !kit_blank(t->at[length]) && length < 24) ++length;
    if (!length) return kit_fail(t->err, "%s line %d: %s, but the line ends", t->path, t->line, what);
    return kit_fail(t->err, "%s line %d: %s, not \"%.*s\"", t->path, t->line, what, length, t->at);
}

/* By hand because strtod obeys the locale and is slow. A double carries the digits, so that the float is rounded once
   (almost always). */
int kit_number(kit_text *t, float *out, const char *what)
{
    static const double ten[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    kit_skip_blanks(t);
    const char *p = t->at, *end = t->end;
    uint64_t digits = 0;
    int negative = p < end && *p == '-', exponent = 0, any = 0, point = 0;
    if (p < end && (*p == '-' || *p == '+')) ++p;
    for (; p < end; ++p) {
        if (*p == '.' && !point) { point = 1; continue; }
        if (*p < '0' || *p > '9') break;
        any = 1;
        if (digits < 1000000000000000000u) { digits = 10 * digits + (uint64_t)(*p - '0'); exponent -= point; }
        else exponent += !point;
    }
    if (!any) return kit_text_fail(t, what);
    if (p < end && (*p == 'e' || *p == 'E')) {
        int sign = 1, e = 0, some = 0;
        if (++p < end && (*p == '-' || *p == '+')) sign = *p++ == '-' ? -1 : 1;
        for (; p < end && *p >= '0' && *p <= '9'; ++p, some = 1) if (e < 10000) e = 10 * e + *p - '0';
        if (!some) return kit_text_fail(t, what);
        exponent += sign * e;
    }
    if (p < end && !kit_blank(*p) && *p != '#') return kit_text_fail(t, what);
    double v = (double)digits;
    if (exponent >= -22 && exponent <= 22) v = exponent < 0 ? v / ten[-exponent] : v * ten[exponent];
    else if (digits) v = v * pow(10, exponent);
    if (v > (double)FLT_MAX) return kit_text_fail(t, "a number is too large: at most 3.4e38 is possible");
    *out = (float)v;
    if (negative && *out > 0) *out = -*out;  /* never -0: equal positions have equal bytes */
    t->at = p;
    return 0;
}

void *kit_array_add(kit_array *a, size_t n, size_t element, const kit_text *t)
{
    if (a->count + n > a->capacity) {
        size_t capacity = 2 * a->capacity + n + 64;
        void *data = realloc(a->data, capacity * element);
        if (!data) { kit_fail(t->err, "%s: no memory for this mesh", t->path); return NULL; }
        a->data = data;
        a->capacity = capacity;
    }
    a->count += n;
    return (char *)a->data + (a->count - n) * element;
}

static uint64_t rotated(uint64_t v, int bits) { return v << bits | v >> (64 - bits); }

static void sip_round(uint64_t v[4])
{
    v[0] += v[1]; v[1] = rotated(v[1], 13) ^ v[0]; v[0] = rotated(v[0], 32);
    v[2] += v[3]; v[3] = rotated(v[3], 16) ^ v[2];
    v[0] += v[3]; v[3] = rotated(v[3], 21) ^ v[0];
    v[2] += v[1]; v[1] = rotated(v[1], 17) ^ v[2]; v[2] = rotated(v[2], 32);
}

/* SipHash-1-3 [Aumasson and Bernstein 2012]: without the secret nobody writes a file whose keys all share a slot. */
static uint64_t key_hash(const kit_key *k, const uint64_t secret[2])
{
    uint64_t v[4] = { secret[0] ^ 0x736f6d6570736575u, secret[1] ^ 0x646f72616e646f6du, secret[0] ^ 0x6c7967656e657261u,
                      secret[1] ^ 0x7465646279746573u };
    for (size_t i = 0; i <= k->length / 8; ++i) {
        const size_t left = k->length - 8 * i;
        uint64_t word = 0;
        memcpy(&word, k->bytes + 8 * i, left < 8 ? left : 8);
        if (left < 8) word |= (uint64_t)(k->length & 255) << 56;
        v[3] ^= word;
        sip_round(v);
        v[0] ^= word;
    }
    v[2] ^= 255;
    for (int i = 0; i < 3; ++i) sip_round(v);
    return v[0] ^ v[1] ^ v[2] ^ v[3];
}

int kit_table_open(kit_table *t, const kit_key *keys, size_t count)
{
    *t = (kit_table){ .keys = keys, .size = 16 };
    while (t->size < 2 * count) t->size *= 2;
    t->slot = calloc(t->size, sizeof *t->slot);        /* of a key, plus 1 */
    if (getentropy(t->secret, sizeof t->secret)) t->secret[0] = (uintptr_t)t->slot;
    return t->slot ? 0 : -1;
}

uint32_t *kit_table_slot(const kit_table *t, const kit_key *k)
{
    size_t at = key_hash(k, t->secret) & (t->size - 1);
    for (; t->slot[at]; at = (at + 1) & (t->size - 1)) {
        const kit_key *there = &t->keys[t->slot[at] - 1];
        if (there->length == k->length && !memcmp(there->bytes, k->bytes, k->length)) break;
    }
    return &t->slot[at];
}

uint32_t kit_table_add(kit_table *t, uint32_t i)
{
    uint32_t *slot = kit_table_slot(t, &t->keys[i]);
    if (!*slot) *slot = i + 1;
    return *slot - 1;
}
