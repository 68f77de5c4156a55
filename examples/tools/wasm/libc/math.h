/* math.h - the maths functions that the headers need: by wasm's instructions, else by JavaScript's Math, which the page
   imports: WebAssembly.instantiate(bytes, { Math }). */
#ifndef SSGI_WASM_MATH_H
#define SSGI_WASM_MATH_H

#define SSGI_WASM_MATH(name) __attribute__((import_module("Math"), import_name(#name)))
SSGI_WASM_MATH(sin) double sin(double x);
SSGI_WASM_MATH(cos) double cos(double x);
SSGI_WASM_MATH(tan) double tan(double x);
SSGI_WASM_MATH(acos) double acos(double x);
SSGI_WASM_MATH(atan) double atan(double x);
SSGI_WASM_MATH(atan2) double atan2(double y, double x);
SSGI_WASM_MATH(exp) double exp(double x);
SSGI_WASM_MATH(log) double log(double x);
SSGI_WASM_MATH(log2) double log2(double x);
SSGI_WASM_MATH(pow) double pow(double x, double y);
SSGI_WASM_MATH(tanh) double tanh(double x);

static inline double sqrt(double x) { return __builtin_sqrt(x); }
static inline double fabs(double x) { return __builtin_fabs(x); }
static inline double floor(double x) { return __builtin_floor(x); }
static inline double fmin(double x, double y) { return x < y ? x : y; }
static inline double ceil(double x) { return __builtin_ceil(x); }
static inline float  sqrtf(float x) { return __builtin_sqrtf(x); }
static inline float  fabsf(float x) { return __builtin_fabsf(x); }
static inline double round(double x) { return x < 0.0 ? -__builtin_floor(0.5 - x) : __builtin_floor(x + 0.5); }
static inline double exp2(double x) { return pow(2.0, x); }
static inline double ldexp(double x, int n) { return x * pow(2.0, n); }
/* only for quotients below 2^53: the headers reduce angles */
static inline double fmod(double x, double y) { return x - y * __builtin_trunc(x / y); }
static inline float  sinf(float x) { return (float)sin((double)x); }
static inline float  cosf(float x) { return (float)cos((double)x); }
static inline float  atan2f(float y, float x) { return (float)atan2((double)y, (double)x); }
static inline float  expf(float x) { return (float)exp((double)x); }
static inline float  exp2f(float x) { return (float)pow(2.0, (double)x); }
static inline float  powf(float x, float y) { return (float)pow((double)x, (double)y); }

#endif
