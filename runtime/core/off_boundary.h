// Whether the caller's memory begins on a boundary of 16 bytes and, if not, how far behind one.
#pragma once

#include "core/check.h"

namespace marrow {

// null on a boundary, else a sentence that says how many bytes too far behind one `first` is. Without call errors the
// sentence leaves the number out.
const char* off_boundary(const void* first);

// The same as a condition that a call keeps.
inline BadCall check_boundary(const void* first) {
#if !defined(MARROW_CALL_ERRORS) || MARROW_CALL_ERRORS
  return off_boundary(first);
#else
  return off_boundary(first) != nullptr;
#endif
}

}  // namespace marrow
