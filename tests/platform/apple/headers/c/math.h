// What the runtime and libc++ itself name of C's <math.h>. The numbers are Apple's.
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
float sqrtf(float);
double sqrt(double);
#ifdef __cplusplus
}
#endif
