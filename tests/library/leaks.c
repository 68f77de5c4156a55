/* leaks.c - shoots rays from within closed meshes at corners and edges and along faces; each must hit. test_build.c
   compiles it for processors that fuse multiply and add, and with -ffast-math. */
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#include "../../ssgi.h"

#include <stdio.h>
#include <stdlib.h>

enum { CELLS = 4, MOST = 6 * 2 * CELLS * CELLS * CELLS };
enum { BALL, TORUS, SOLID, STRIPS, KINDS }; /* STRIPS: a ceiling, at whose edges rays are shot from near by */

static uint32_t state = 1;

static int below(int n)
{
    state = state * 1664525u + 1013904223u;
    return (int)((state >> 8) % (uint32_t)n);
}

static double within(double low, double high) { return low + (high - low) * below(1 << 24) / (1 << 24); }

static float mesh[3 * MOST][3], vertex[300][3];
static size_t corners;
static double turn[3][3], size, start[3], stretch; /* the mesh's place */
static int filled[CELLS][CELLS][CELLS], cells; /* cells: of a solid, along each side */

static void place(int kind)
{
    static const double sizes[] = { 1, 0.04, 37, 1000 };
    const int a = below(3), b = (a + 1) % 3, c = (a + 2) % 3, exact = below(2);
    const double angle = kind == STRIPS ? 0 : exact ? 0.78539816339744831 * below(8) : within(0, 6);
    memset(turn, 0, sizeof turn);
    turn[a][a] = 1;
    turn[b][b] = turn[c][c] = cos(angle);
    turn[c][b] = sin(angle);
    turn[b][c] = -turn[c][b];
    size = sizes[below(4)];
    stretch = below(2) ? 1 : 100;
    for (int i = 0; i < 3; ++i) start[i] = below(2) ? 0 : size * within(-20, 20);
}

static double placed(int i, const double p[3])
{
    return size * (turn[i][0] * stretch * p[0] + turn[i][1] * p[1] + turn[i][2] * p[2]) + start[i];
}

static void put(float out[3], const double p[3])
{
    for (int i = 0; i < 3; ++i) out[i] = (float)placed(i, p);
}

/* Adds two triangles of four vertices in a circle. Each vertex is placed once: -ffast-math may round it otherwise
   elsewhere. */
static void quad(int a, int b, int c, int d)
{
    const int way[2][6] = { { a, b, c, a, c, d }, { a, b, d, b, c, d } }, *const take = way[below(2)];
    for (int k = 0; k < 6; ++k) memcpy(mesh[corners++], vertex[take[k]], sizeof mesh[0]);
}

/* Makes a ball, or a torus with radii 2 and 0.7. */
static void round_mesh(int kind, int rows, int columns)
{
    for (int i = 0; i < (rows + 1) * columns; ++i) {
        const int x = i % columns, y = i / columns;
        const double a = 6.283185307179586 * x / columns, b = 3.141592653589793 * y / rows;
        const double s = y % rows ? sin(b) : 0, r = 2 + 0.7 * cos(2 * b);
        const double torus[3] = { r * cos(a), 0.7 * sin(2 * b), r * sin(a) };
        const double ball[3] = { s * cos(a), cos(b), s * sin(a) };
        put(vertex[i], kind == TORUS ? torus : ball);
    }
    for (int i = 0; i < rows * columns; ++i) {
        const int x = i % columns, y = i / columns * columns, next = (x + 1) % columns;
        const int last = y + columns == rows * columns, below_it = kind == TORUS && last ? 0 : y + columns;
        const int first_pole = kind == BALL && y == 0, last_pole = kind == BALL && last;
        quad(y + (first_pole ? 0 : x), y + (first_pole ? 0 : next), below_it + (last_pole ? 0 : next),
             below_it + (last_pole ? 0 : x));
    }
}

static int is_filled(const int c[3])
{
    for (int i = 0; i < 3; ++i)
        if (c[i] < 0 || c[i] >= cells) return 0;
    return filled[c[0]][c[1]][c[2]];
}

/* Makes the faces between filled and empty cells of a solid. */
static void solid(void)
{
    enum { SIDE = CELLS + 1 };
    for (int i = 0; i < SIDE * SIDE * SIDE; ++i) {
        const double p[3] = { i / SIDE / SIDE, i / SIDE % SIDE, i % SIDE };
        put(vertex[i], p);
    }
    for (int i = 0; i < CELLS * CELLS * CELLS; ++i)
        filled[i / CELLS / CELLS][i / CELLS % CELLS][i % CELLS] = below(3) > 0;
    for (int i = 0; i < 6 * CELLS * CELLS * CELLS; ++i) {
        static const int step[3] = { SIDE * SIDE, SIDE, 1 };
        const int f = i % 6, a = f / 2, b = step[(a + 1) % 3], c = step[(a + 2) % 3];
        int cell[3] = { i / 6 % CELLS, i / 6 / CELLS % CELLS, i / 6 / CELLS / CELLS };
        const int own = is_filled(cell), v = (cell[0] * SIDE + cell[1]) * SIDE + cell[2] + f % 2 * step[a];
        cell[a] += f % 2 ? 1 : -1;
        if (own && !is_filled(cell)) quad(v, v + b, v + b + c, v + c);
    }
}

/* Makes a ceiling of strips, each 64 or 6400 times as long as wide. */
static void strips(int count)
{
    for (int i = 0; i < 2 * count + 2; ++i) {
        const double p[3] = { i % 2 ? 1 : -1, 0, i / 2 / 32.0 };
        put(vertex[i], p);
    }
    for (int i = 0; i < 2 * count; i += 2) quad(i, i + 1, i + 3, i + 2);
}

/* Chooses an origin o in the mesh, and a target unless q stays below -1e8: for strips, on an edge right above; for a
   solid, now and then, in the plane of faces that holds the origin. Returns 0 if the origin is outside after all. */
static int from(float o[3], double q[3], int kind, int count)
{
    const double angle = 0.78539816339744831 * below(8), away = pow(10, within(-3.5, -1)) / 32;
    const int axis = below(2 * 3);
    double p[3] = { 0, 0, 0 };
    int cell[3], inside = 1;
    for (int i = 0; i < 3; ++i) {
        cell[i] = below(cells);
        if (kind == SOLID) p[i] = cell[i] + (axis < 3 ? 0.5 : 0.25 * (1 + below(3)));
        q[i] = kind == SOLID && axis < 3 ? p[i] + below(5) - 2 : -1e9;
    }
    if (kind == SOLID) inside = is_filled(cell);
    if (kind == SOLID && axis < 3) {
        q[axis] = p[axis] = ++cell[axis];
        inside &= is_filled(cell);
    }
    if (kind == TORUS) {
        p[0] = 2 * cos(angle);
        p[2] = 2 * sin(angle);
    }
    if (kind == STRIPS) {
        p[0] = within(-0.9, 0.9);
        p[1] = -away;
        q[0] = p[0] + away / stretch * within(-2, 2);
        q[1] = 0;
        q[2] = (1 + below(count - 1)) / 32.0 + 3e-8 * stretch * within(-1, 1);
        p[2] = q[2] + away * within(-2, 2);
    }
    put(o, p);
    return inside;
}

/* "leaks 1000" makes so many meshes and shoots 200 rays in each */
int main(int argc, char **argv)
{
    const int count = argc > 1 ? atoi(argv[1]) : 1000;
    static const uint32_t bits[2] = { 0x7fc00000u, 0x7f800000u };
    long rays = 0, leaks = 0, odd = 0;
    float none, endless; /* NaN and infinity, by their bits, as -ffast-math assumes that there are none */
    memcpy(&none, &bits[0], sizeof none);
    memcpy(&endless, &bits[1], sizeof endless);
    for (int run = 0; run < count; ++run) {
        cells = 2 + below(2) * below(CELLS - 1);
        const int kind = run % KINDS, rows = 4 + below(12), columns = 8 + below(8);
        ssgi_trace trace;
        corners = 0;
        place(kind);
        if (kind == SOLID) solid();
        else if (kind == STRIPS) strips(columns);
        else round_mesh(kind, rows, columns);
        const size_t triangles = corners / 3, bytes = ssgi_trace_size(triangles);
        void *memory = malloc(bytes);
        if (!memory || ssgi_trace_build(&trace, memory, bytes, mesh[0], 12, NULL, triangles, NULL) != SSGI_OK) return 2;
        for (int r = 0; r < 200; ++r) {
            const int corner = below((int)corners), other = corner - corner % 3 + below(3), aim = below(4);
            const float *a = mesh[corner], *b = mesh[other];
            float o[3], d[3], length = 0;
            double q[3];
            ssgi_hit hit;
            if (!from(o, q, kind, columns)) continue;
            for (int i = 0; i < 3; ++i) {
                d[i] = q[i] > -1e8 ? (float)(placed(i, q) - (double)o[i])
                     : aim == 0      ? a[i] - o[i]
                     : aim == 1      ? 0.5f * (a[i] + b[i]) - o[i]
                     : aim == 2      ? 0.75f * a[i] + 0.25f * b[i] - o[i]
                                     : a[i] - b[i];
                length += fabsf(d[i]);
            }
            if (length < 1e-5f * (float)size) continue;
            const int any = ssgi_trace_any(&trace, o, d, 0, 1e12f);
            const int closest = ssgi_trace_closest(&hit, &trace, o, d, 0, 1e12f);
            ++rays;
            leaks += !any || !closest;
            odd += closest && !(hit.u >= 0 && hit.v >= 0 && hit.u + hit.v <= 1.00001f && hit.triangle < triangles);
            odd += ssgi_trace_any(&trace, o, d, 0, none) || ssgi_trace_closest(&hit, &trace, o, d, 0, none);
            odd += ssgi_trace_any(&trace, o, d, 0, endless) != any
                || ssgi_trace_closest(&hit, &trace, o, d, none, endless) != closest;
        }
        free(memory);
    }
    printf("%ld of %ld rays leave closed meshes, %ld answers are odd\n", leaks, rays, odd);
    return leaks || odd || rays < 100 * count;
}
