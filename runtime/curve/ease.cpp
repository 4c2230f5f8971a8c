// Easings: 0 … 1 → 0 … 1 with character.
#include "core/builtins.h"
#include "core/check.h"
#include "marrow/curve.h"
#include "math/elementary.h"
#include "math/finite.h"

namespace marrow {
namespace {

// Where a bounce stands, falling up to 1: four parabolas with their tops at 1.
float bounce_out(float u) {
  constexpr float kSteepness = 7.5625f, kLength = 2.75f;
  if (u < 1.0f / kLength) return kSteepness * u * u;
  if (u < 2.0f / kLength) {
    u -= 1.5f / kLength;
    return kSteepness * u * u + 0.75f;
  }
  if (u < 2.5f / kLength) {
    u -= 2.25f / kLength;
    return kSteepness * u * u + 0.9375f;
  }
  u -= 2.625f / kLength;
  return kSteepness * u * u + 0.984375f;
}

// A spring let go backwards: oscillations of `period` that grow by 2¹⁰.
float elastic_in(float u, float period) {
  const float turns = (u - 1.0f) / period - 0.25f;
  return -power_of_two(10.0f * (u - 1.0f)) * sine_of_turns(turns);
}

// Every easing in its `in` form, 0 < u < 1. `half`: as one half of in_out, where Penner has other constants.
float ease_in(Easing easing, float u, bool half) {
  const float u2 = u * u;
  switch (easing) {
    case Easing::linear:
      break;
    case Easing::quad:
      return u2;
    case Easing::cubic:
      return u2 * u;
    case Easing::quart:
      return u2 * u2;
    case Easing::quint:
      return u2 * u2 * u;
    case Easing::sine: {
      const float s = sine_of_turns(0.125f * u);  // 1 - cos x = 2 sin² (x / 2)
      return 2.0f * s * s;
    }
    case Easing::expo:
      return power_of_two(10.0f * (u - 1.0f));
    case Easing::circ:
      return u2 / (1.0f + square_root(1.0f - u2));  // 1 - √(1 - u²) without its cancellation
    case Easing::back: {
      const float overshoot = half ? 1.70158f * 1.525f : 1.70158f;
      return u2 * ((overshoot + 1.0f) * u - overshoot);
    }
    case Easing::elastic:
      return elastic_in(u, half ? 0.45f : 0.3f);
    case Easing::bounce:
      return 1.0f - bounce_out(1.0f - u);
  }
  return u;
}

// A coordinate of the cubic Bézier curve 0, a, b, 1 and its derivative. Bernstein form: nothing cancels in x.
struct Cubic {
  float a, b;
  float at(float t) const {
    const float v = 1.0f - t;
    return 3.0f * t * v * (v * a + t * b) + t * t * t;
  }
  float slope(float t) const {
    const float v = 1.0f - t;
    return 3.0f * (v * v * a + 2.0f * t * v * (b - a) + t * t * (1.0f - b));
  }
};

// t with x(t) = u; x climbs from 0 to 1. Newton's steps, halving where one would leave the bracket.
float solve(const Cubic& x, float u) {
  float low = 0.0f, high = 1.0f, t = u;
  for (int i = 0; i < 40; ++i) {
    const float off = x.at(t) - u;
    if (off == 0.0f) break;
    (off < 0.0f ? low : high) = t;
    const float newton = t - off / x.slope(t);
    const float next = newton > low && newton < high ? newton : 0.5f * (low + high);
    if (next == t || next == low || next == high) break;
    t = next;
  }
  return t;
}

}  // namespace

float ease(Easing easing, EaseMode mode, float u) {
  if (!(u > 0.0f)) return 0.0f;
  if (u >= 1.0f) return 1.0f;
  switch (mode) {
    case EaseMode::in:
      return ease_in(easing, u, false);
    case EaseMode::out:
      return 1.0f - ease_in(easing, 1.0f - u, false);
    case EaseMode::in_out:
      if (u == 0.5f) return 0.5f;
      return u < 0.5f ? 0.5f * ease_in(easing, 2.0f * u, true) : 1.0f - 0.5f * ease_in(easing, 2.0f - 2.0f * u, true);
  }
  return u;
}

Status ease(const CubicBezierEase& curve, float u, float& out) {
  MARROW_REQUIRE(curve.x1 >= 0.0f && curve.x1 <= 1.0f && curve.x2 >= 0.0f && curve.x2 <= 1.0f);
  MARROW_REQUIRE(is_finite(curve.y1) && is_finite(curve.y2));
  MARROW_REQUIRE(u == u);
  if (!(u > 0.0f)) {
    out = 0.0f;
  } else if (u >= 1.0f) {
    out = 1.0f;
  } else {
    out = Cubic{curve.y1, curve.y2}.at(solve(Cubic{curve.x1, curve.x2}, u));
  }
  return Status::ok;
}

}  // namespace marrow
