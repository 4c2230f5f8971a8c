// One key interval of a curve as at most four points and the polynomials that weigh them: what evaluation, velocity and
// arc length share.
#pragma once

#include "core/builtins.h"
#include "core/check.h"
#include "marrow/curve.h"
#include "math/finite.h"
#include "math/keys.h"

namespace marrow {

inline constexpr std::uint32_t kMaxComponents = 4;

enum class Basis : std::uint8_t { linear, slerp, bernstein2, bernstein3, hermite };

struct Weights {
  float w[4];
};

// Points in the order of the basis; rotations with their signs chained. Hermite: value, out-tangent, value, in-tangent,
// tangents a key interval.
struct Segment {
  Basis basis = Basis::linear;
  std::uint32_t components = 1;
  float point[4][kMaxComponents] = {};
};

// Whether the counts of a curve fit together: what must hold before any key is read.
BadCall check_counts(const Curve& curve);

// The interval from `key` to the next; any kind but step.
Segment make_segment(const Curve& curve, std::size_t key);
// out: components floats; rotations are not normalised yet.
void segment_value(const Segment& segment, float u, float* out);
// The derivative by u; not for Basis::slerp.
void segment_slope(const Segment& segment, float u, float* out);

Weights bernstein3(float u);
Weights catmull_rom_weights(float u);

inline float dot(const float* a, const float* b, std::uint32_t n) {
  float sum = a[0] * b[0];
  for (std::uint32_t i = 1; i < n; ++i) sum += a[i] * b[i];
  return sum;
}

// Turns q to the sign that is nearer to `reference`. Returns the factor, 1 or -1.
inline float chain_sign(const float* reference, float* q) {
  if (!(dot(reference, q, 4) < 0.0f)) return 1.0f;
  for (int i = 0; i < 4; ++i) q[i] = -q[i];
  return -1.0f;
}

// False, and q as it was, if q has no direction, or none that can be told.
inline bool normalise(float* q) {
  const float squared = dot(q, q, 4);
  if (!(squared > 1e-30f && squared < kInfinity)) return false;
  const float inverse = 1.0f / square_root(squared);
  for (int i = 0; i < 4; ++i) q[i] *= inverse;
  return true;
}

}  // namespace marrow
