// What a call came to: one enum for the whole runtime, with text. No exceptions, no logging.
#pragma once

#include <cstdint>

#include "marrow/api.h"

namespace marrow {

// What a call came to.
enum class [[nodiscard]] Status : std::uint8_t{
    ok,
    bad_argument,   // the call is wrong: a span too short, a null pointer, an index out of range
    truncated,      // the data ends before what it announces
    bad_magic,      // not a cooked file
    bad_version,    // cooked for another version of the format
    bad_checksum,   // damaged
    bad_data,       // breaks a rule of docs/format.md
    unsupported,    // legal, but needs what this build or this device lacks
    gl_error,       // the driver refused
    mismatch,       // both are good, but not made for each other
    out_of_memory,  // a library that allocates for itself found none
};

// One word or two in English, never null.
MARROW_API const char* to_string(Status status) noexcept;

// Where a block of data breaks the format, and which rule. `rule` is a static string.
struct DataError {
  Status status = Status::ok;  // what the call returns
  std::uint32_t offset = 0;    // byte in the block
  const char* rule = "";       // in English
};

}  // namespace marrow
