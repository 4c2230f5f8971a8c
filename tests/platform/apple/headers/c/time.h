// What libc++ itself names of C's <time.h>.
#pragma once
typedef long time_t;
