/* macros.h - macros that hosts define before they include ssgi: those of windows.h, X11, Apple, Qt, POSIX, Arduino and
   engines. The C library comes first, as in a host, so that only ssgi's headers meet the macros. */
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* macros of windows.h and of the headers that it includes */
#define near
#define far
#define NEAR near
#define FAR far
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define PASCAL
#define CALLBACK
#define WINAPI
#define APIENTRY
#define small char
#define hyper long long
#define interface struct
#define THIS void
#define PURE = 0
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define rad1 0x0494
#define rad2 0x0495
#define grp1 0x0420
#define TRUE 1
#define FALSE 0
#define ERROR 0
#define NO_ERROR 0
#define DELETE 0x00010000L
#define STRICT 1
#define ABSOLUTE 1
#define RELATIVE 2
#define OPAQUE 2
#define TRANSPARENT 1
#define ALTERNATE 1
#define WINDING 2
#define DIFFERENCE 11
#define PASSTHROUGH 19
#define RGB(r, g, b) ((r) | (g) << 8 | (b) << 16)
#define SHADEBLENDCAPS 120
#define DOMAIN 1
#define OVERFLOW 3
#define UNDERFLOW 4
#define IGNORE 0
#define DOUBLE 1
#define MOUSE_MOVED 1
#define BACKGROUND_BLUE 16
#define VIEW_S_FIRST 0x40000
#define S_OK 0
#define CreateWindow CreateWindowA
#define GetObject GetObjectA
#define DrawText DrawTextA
#define LoadImage LoadImageA

/* X.h, Xlib.h */
#define None 0L
#define Always 2
#define Success 0
#define Bool int
#define Status int
#define True 1
#define False 0
#define Above 0
#define Below 1
#define Unsorted 0
#define Complex 0
#define Convex 2
#define CurrentTime 0L

/* macros of Apple, Qt, POSIX, complex.h, Arduino */
#define check(x)
#define verify(x)
#define require(x, label)
#define emit
#define slots
#define signals public
#define foreach for
#define forever for (;;)
#define major(x) ((x) >> 8)
#define minor(x) ((x) & 255)
#define minor_t int
#define linux 1
#define unix 1
#define I 1.0f
#define complex _Complex
#define PI 3.1415926535897932
#define HALF_PI 1.57f
#define DEG_TO_RAD 0.01745f
#define F(s) s
#define B0 0
#define B1 1
#define _A 1
#define _R 2

/* macros by which engines name settings, with words that ours use */
#define WIDTH 8
#define HEIGHT 8
#define SIZE 8
#define DEPTH 24
#define LAYERS 4
#define LEVELS 4
#define VIEWS 2
#define STEPS 16
#define SAMPLES 4
#define DIRECTIONS 8
#define BINS 64
#define LIGHTS 16
#define SUN 0
#define POINT 1
#define SPOT 2
#define SSAO 1
#define HSAO 1
#define SSDO 0
#define S3HO 0
#define LIGHT (1 << 3)
#define SHADE 0
#define SHADOW 1
#define EMITTERS 3
#define SURFELS 0
#define FIELD 1
#define FIELDS 9
#define SPLAT 0
#define SUM 1
#define BLUR 1
#define SMOOTH 2
#define HISTORY 16
#define COMPOSE 1
#define CHANGES 1
#define NEARBY 2
#define AMBIENT 0.1f
#define ALBEDO 0.5f
#define NORMAL 1
#define NOISE 1
#define NONE 0
#define CUSTOM 7
#define LINEAR 1
#define MAP 1
#define BOUNCE 1
#define BACK 1
#define SLABS 2
#define SOLID 1
#define NOTHING 0
#define OBJECTS 100
#define VISIBILITY 1
#define COUNT 3
#define MOST 10
#define LAST 10
#define KIND 1
#define TEXTURE 1
#define RADIUS 0.5f
#define THICKNESS 0.5f
#define HALF 1
#define FLOAT 2
#define UINT unsigned
#define R 0
#define RG 1
#define RGBA 2
#define X 0
#define Y 1
#define Z 2
#define A 0
#define E 2.718281828
#define CHECK(x) ((void)(x))
#define TRY(x) x
#define ROW(x) x
