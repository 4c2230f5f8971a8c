#include "marrow/status.h"

namespace marrow {

const char* to_string(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::bad_argument:
      return "bad argument";
    case Status::truncated:
      return "truncated";
    case Status::bad_magic:
      return "not a cooked file";
    case Status::bad_version:
      return "other format version";
    case Status::bad_checksum:
      return "damaged";
    case Status::bad_data:
      return "invalid data";
    case Status::unsupported:
      return "unsupported";
    case Status::gl_error:
      return "OpenGL error";
    case Status::out_of_memory:
      return "out of memory";
    case Status::mismatch:
      return "does not fit";
  }
  return "unknown status";
}

}  // namespace marrow
