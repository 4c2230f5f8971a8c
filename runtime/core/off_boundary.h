// Whether the caller's memory begins on a boundary of 16 bytes and, if not, how far behind one.
#pragma once

#include "core/check.h"
#include "marrow/block.h"

namespace marrow {

// null on a boundary, else a sentence that says how many bytes too far behind one `first` is. Without call errors the
// sentence leaves the number out.
inline const char* off_boundary(const void* first) {
  if (is_on_boundary(first)) return nullptr;
#if !defined(MARROW_CALL_ERRORS) || MARROW_CALL_ERRORS
#define MARROW_BEHIND(bytes) "memory begins " bytes " bytes behind a boundary of 16 bytes: see marrow/block.h"
  static constexpr const char* kBehind[kBlockBoundary - 1] = {
      MARROW_BEHIND("1"),  MARROW_BEHIND("2"),  MARROW_BEHIND("3"),  MARROW_BEHIND("4"),  MARROW_BEHIND("5"),
      MARROW_BEHIND("6"),  MARROW_BEHIND("7"),  MARROW_BEHIND("8"),  MARROW_BEHIND("9"),  MARROW_BEHIND("10"),
      MARROW_BEHIND("11"), MARROW_BEHIND("12"), MARROW_BEHIND("13"), MARROW_BEHIND("14"), MARROW_BEHIND("15"),
  };
#undef MARROW_BEHIND
  return kBehind[reinterpret_cast<std::uintptr_t>(first) % kBlockBoundary - 1];
#else
  return "memory must begin on a boundary of 16 bytes: see marrow/block.h";
#endif
}

// The same as a condition that a call keeps.
inline BadCall check_boundary(const void* first) {
#if !defined(MARROW_CALL_ERRORS) || MARROW_CALL_ERRORS
  return off_boundary(first);
#else
  return off_boundary(first) != nullptr;
#endif
}

}  // namespace marrow
