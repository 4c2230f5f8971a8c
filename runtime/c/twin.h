// How a wrapper gets from what C passes to what C++ takes: pointers are looked at before anything is read by them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/check.h"
#include "marrow/span.h"
#include "marrow/status.h"
// The functions of C are not hidden in static libraries either, for libmarrow_c.so is made of these.
#if defined(__GNUC__)
#pragma GCC visibility push(default)
#include "marrow/c.h"
#pragma GCC visibility pop
#else
#include "marrow/c.h"
#endif

// Returns `nothing` from a wrapper, and says why to the handler of bad calls, unless `condition` holds.
#define MRW_NEEDS(condition, nothing)               \
  do {                                              \
    if (!(condition)) [[unlikely]] {                \
      static_cast<void>(MARROW_REFUSE(#condition)); \
      return nothing;                               \
    }                                               \
  } while (false)

namespace marrow::c {

// Whether there may be a T: not null, and on the boundary of its type.
template <class T>
bool leads_to_if_any(const void* p) {
  return reinterpret_cast<std::uintptr_t>(p) % alignof(T) == 0;
}
template <class T>
bool leads_to(const void* p) {
  return p != nullptr && leads_to_if_any<T>(p);
}

// Whether a pointer and a count may be a list.
template <class T>
bool is_list(const void* first, std::size_t count) {
  return count == 0 || leads_to<T>(first);
}

// A pointer without its type.
inline void* plain(void* p) {
  return p;
}
inline const void* plain(const void* p) {
  return p;
}

// A struct of C's is its twin in C++, which has the same layout: the tests compare them.
template <class T>
const T& of(const void* p) {
  return *static_cast<const T*>(p);
}
template <class T>
T& to(void* p) {
  return *static_cast<T*>(p);
}
template <class T>
const T& or_default(const void* p) {
  static constexpr T none = {};
  return p == nullptr ? none : of<T>(p);
}
template <class T, class C>
Span<T> span(C* first, std::size_t count) {
  return {static_cast<T*>(plain(first)), count};
}
template <class T, std::size_t count, class C>
T (&array(C* first))
[count] {
  return *static_cast<T(*)[count]>(plain(first));
}

// And back.
inline mrw_status code(Status status) {
  return static_cast<mrw_status>(status);
}
template <class C, class T>
C* to_c(T* p) {
  return static_cast<C*>(plain(p));
}
template <class T>
void give(void* out, const T& value) {
  to<T>(out) = value;
}

}  // namespace marrow::c
