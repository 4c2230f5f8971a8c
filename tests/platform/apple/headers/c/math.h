// What the runtime, libc++ itself and meshoptimizer name of C's <math.h>. The numbers are Apple's.
#pragma once
#define FP_NAN 1
#define FP_INFINITE 2
#define FP_ZERO 3
#define FP_NORMAL 4
#define FP_SUBNORMAL 5
#ifdef __cplusplus
extern "C" {
#endif
typedef float float_t;
typedef double double_t;
float acosf(float);
float atan2f(float, float);
float ceilf(float);
float cosf(float);
float fabsf(float);
float floorf(float);
float fmodf(float, float);
float ldexpf(float, int);
float powf(float, float);
float sinf(float);
float sqrtf(float);
double ceil(double);
double fabs(double);
double floor(double);
double sqrt(double);
#ifdef __cplusplus
}
#endif
