// Put before a program's libraries: what sin, exp, pow and their like give is one last bit too large or too small, as
// the argument's bits say. At the end it writes to the file MARROW_LAST_BIT how often each was called: "log2 17".
//
// Whole numbers stay what they are: every C library gives those exactly.
#include <dlfcn.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr int kMostFunctions = 64;
struct Count {
  const char* name;
  std::atomic<long> calls{0};
};
Count counts[kMostFunctions];
std::atomic<int> count_of_counts{0};

Count& count_for(const char* name) {
  Count& count = counts[count_of_counts++];
  count.name = name;
  return count;
}

struct AtEnd {
  ~AtEnd() {
    const char* const path = std::getenv("MARROW_LAST_BIT");
    if (path == nullptr) return;
    std::FILE* const file = std::fopen(path, "w");
    if (file == nullptr) std::abort();
    for (int i = 0; i < count_of_counts; ++i) std::fprintf(file, "%s %ld\n", counts[i].name, counts[i].calls.load());
    std::fclose(file);
  }
} at_end;

std::uint64_t bits_of(double x) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

template <class F>
F moved(F result, double x, double y = 0) {
  if (!std::isfinite(result) || result == std::floor(result)) return result;
  const bool up = ((bits_of(x) * 0x9E3779B97F4A7C15 ^ bits_of(y) * 0xC2B2AE3D27D4EB4F) >> 63) != 0;
  return std::nextafter(result, up ? F(HUGE_VAL) : -F(HUGE_VAL));
}

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

#define MARROW_OF_ONE(F, name)                         \
  F name(F x) noexcept {                               \
    static Count& count = count_for(#name);            \
    static F (*const real)(F) = next<F (*)(F)>(#name); \
    ++count.calls;                                     \
    return moved(real(x), static_cast<double>(x));     \
  }
#define MARROW_OF_TWO(F, name)                                                \
  F name(F x, F y) noexcept {                                                 \
    static Count& count = count_for(#name);                                   \
    static F (*const real)(F, F) = next<F (*)(F, F)>(#name);                  \
    ++count.calls;                                                            \
    return moved(real(x, y), static_cast<double>(x), static_cast<double>(y)); \
  }
#define MARROW_BOTH(kind, name) kind(double, name) kind(float, name##f)

extern "C" {

MARROW_BOTH(MARROW_OF_ONE, sin)
MARROW_BOTH(MARROW_OF_ONE, cos)
MARROW_BOTH(MARROW_OF_ONE, tan)
MARROW_BOTH(MARROW_OF_ONE, asin)
MARROW_BOTH(MARROW_OF_ONE, acos)
MARROW_BOTH(MARROW_OF_ONE, atan)
MARROW_BOTH(MARROW_OF_ONE, sinh)
MARROW_BOTH(MARROW_OF_ONE, cosh)
MARROW_BOTH(MARROW_OF_ONE, tanh)
MARROW_BOTH(MARROW_OF_ONE, exp)
MARROW_BOTH(MARROW_OF_ONE, exp2)
MARROW_BOTH(MARROW_OF_ONE, expm1)
MARROW_BOTH(MARROW_OF_ONE, log)
MARROW_BOTH(MARROW_OF_ONE, log2)
MARROW_BOTH(MARROW_OF_ONE, log10)
MARROW_BOTH(MARROW_OF_ONE, log1p)
MARROW_BOTH(MARROW_OF_ONE, cbrt)
MARROW_BOTH(MARROW_OF_TWO, atan2)
MARROW_BOTH(MARROW_OF_TWO, pow)
MARROW_BOTH(MARROW_OF_TWO, hypot)

void sincos(double x, double* sine, double* cosine) noexcept {
  *sine = sin(x);
  *cosine = cos(x);
}
void sincosf(float x, float* sine, float* cosine) noexcept {
  *sine = sinf(x);
  *cosine = cosf(x);
}
}
