// What a bad call meets: an assert that a game can replace or leave out, and a Status all the same.
#pragma once

#include "marrow/status.h"

#ifndef MARROW_ASSERT
#define MARROW_ASSERT(condition) static_cast<void>(0)
#endif

// Returns bad_argument from the calling function unless `condition` holds.
#define MARROW_REQUIRE(condition)            \
  do {                                       \
    if (!(condition)) {                      \
      MARROW_ASSERT(!"marrow: " #condition); \
      return ::marrow::Status::bad_argument; \
    }                                        \
  } while (false)
