// A hint for compilers.
#pragma once

namespace marrow {

// x, of which the compiler forgets what it knew: where a number comes from, that it was read before. Without it rows
// `sample/*` of `marrow bench` take 3 to 5 % more instructions (g++ 12).
template <class T>
inline T opaque(T x) {
#if defined(__GNUC__)
  asm("" : "+r"(x));
#endif
  return x;
}

}  // namespace marrow
