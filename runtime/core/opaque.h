// A hint for compilers.
#pragma once

namespace marrow {

// x, of which the compiler forgets what it knew: where a number comes from, that it was read before.
template <class T>
inline T opaque(T x) {
#if defined(__GNUC__)
  asm("" : "+r"(x));
#endif
  return x;
}

}  // namespace marrow
