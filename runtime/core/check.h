// How public functions refuse bad calls: they tell the handler that a game has set (marrow/call_error.h) and return
// Status::bad_argument.
//
//   in a public function           MARROW_REQUIRE(holds(out, count));
//   in what several of them call   BadCall check_count(…) { MARROW_CHECK(holds(out, count)); return {}; }
//   and there                      MARROW_REQUIRE_GOOD(check_count(…));
//
// A public function asks for everything itself before it calls another one, for the handler is told the name of the
// function that refuses. A condition that says too little goes on in words: same && "the same joints".
#pragma once

#include <cstdint>

#include "marrow/call_error.h"
#include "marrow/span.h"
#include "marrow/status.h"

// 0, by CMakeLists.txt, leaves all names and texts out.
#if !defined(MARROW_CALL_ERRORS) || MARROW_CALL_ERRORS

namespace marrow {
// The condition that a call does not keep, or null.
using BadCall = const char*;
// Tells the handler; gives bad_argument.
[[gnu::cold, gnu::noinline]] inline Status refuse(const char* function, BadCall condition) {
  if (const CallErrorHandler handler = call_error_handler()) handler(function, condition);
  return Status::bad_argument;
}
}  // namespace marrow
#define MARROW_REFUSE(condition) ::marrow::refuse(__func__, condition)
#define MARROW_BAD_CALL(condition) condition

#else

namespace marrow {
using BadCall = bool;
}
#define MARROW_REFUSE(condition) (static_cast<void>(condition), ::marrow::Status::bad_argument)
#define MARROW_BAD_CALL(condition) true

#endif

// Returns bad_argument from the calling function, which is public, unless `condition` holds.
#define MARROW_REQUIRE(condition)       \
  do {                                  \
    if (!(condition)) [[unlikely]]      \
      return MARROW_REFUSE(#condition); \
  } while (false)

// The same for what a check finds.
#define MARROW_REQUIRE_GOOD(check)                          \
  do {                                                      \
    if (const ::marrow::BadCall bad = (check)) [[unlikely]] \
      return MARROW_REFUSE(bad);                            \
  } while (false)

// Returns the condition from the calling function, which gives a BadCall, unless it holds.
#define MARROW_CHECK(condition)           \
  do {                                    \
    if (!(condition)) [[unlikely]]        \
      return MARROW_BAD_CALL(#condition); \
  } while (false)

namespace marrow {

// Whether memory of the caller's holds so many of what it should: long enough, and on their boundary.
template <class T>
bool holds(Span<T> span, std::size_t count) {
  return span.size >= count &&
         (count == 0 || (span.data != nullptr && reinterpret_cast<std::uintptr_t>(span.data) % alignof(T) == 0));
}

// The same of what is as long as it likes.
template <class T>
bool holds(Span<T> span) {
  return holds(span, span.size);
}

}  // namespace marrow
