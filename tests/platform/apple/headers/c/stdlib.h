// What libc++ and Clang's own headers name of C's <stdlib.h>.
#pragma once
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif
typedef struct {
  long quot, rem;
} ldiv_t;
typedef struct {
  long long quot, rem;
} lldiv_t;
ldiv_t ldiv(long, long);
lldiv_t lldiv(long long, long long);
void* malloc(size_t size);
void free(void* memory);
void abort(void) __attribute__((noreturn));
#ifdef __cplusplus
}
#endif
