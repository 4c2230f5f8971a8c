// What libc++ itself names of C's <uchar.h>.
#pragma once
typedef union {
  char bytes[128];
  long long align;
} mbstate_t;
