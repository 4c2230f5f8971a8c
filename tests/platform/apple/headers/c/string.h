// What the runtime calls of C's <string.h>.
#pragma once
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif
void* memchr(const void* where, int byte, size_t size);
int memcmp(const void* a, const void* b, size_t size);
void* memcpy(void* to, const void* from, size_t size);
void* memmove(void* to, const void* from, size_t size);
void* memset(void* to, int byte, size_t size);
char* strchr(const char* text, int character);
int strcmp(const char* a, const char* b);
size_t strlen(const char* text);
char* strpbrk(const char* text, const char* characters);
char* strrchr(const char* text, int character);
char* strstr(const char* text, const char* part);
#ifdef __cplusplus
}
#endif
