// Numbers that a function is made for, or is told where code is to be small.
#pragma once

#include <type_traits>

namespace marrow {

// Whether code is to be small: then one function does the work of those that are made for fixed numbers.
#ifdef __OPTIMIZE_SIZE__
inline constexpr bool kSmall = true;
#else
inline constexpr bool kSmall = false;
#endif

// Before a function that is to be called, however short it is, where code is to be small. Else compilers choose.
#ifdef __OPTIMIZE_SIZE__
#define MARROW_CALLED_WHERE_SMALL [[gnu::noinline]]
#else
#define MARROW_CALLED_WHERE_SMALL
#endif

// Before a short inline function that calls nothing else, or others of these. Where code is small each file has a copy
// of its own, of which GCC sees what registers it leaves alone: callers keep their vectors there. Of a function that
// files share it sees nothing, and callers put all they have into memory. The copies are the same, so it is no matter
// which of them an inline function calls. The standard wants one for all files; compilers' own headers of intrinsics do
// as this does.
#if defined(__OPTIMIZE_SIZE__) && defined(__GNUC__) && !defined(__clang__)
#define MARROW_OWN_WHERE_SMALL static
#else
#define MARROW_OWN_WHERE_SMALL
#endif

// As MARROW_CALLED_WHERE_SMALL, of an inline function that else is to stand wherever it is used, however long it is.
#ifdef __OPTIMIZE_SIZE__
#define MARROW_CALLED_ONLY_WHERE_SMALL [[gnu::noinline]]
#else
#define MARROW_CALLED_ONLY_WHERE_SMALL [[gnu::always_inline]]
#endif

// A number that is known when code is compiled, and is used like any other.
template <auto Value>
using Fixed = std::integral_constant<decltype(Value), Value>;

}  // namespace marrow
