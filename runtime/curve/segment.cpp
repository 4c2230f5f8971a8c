#include "curve/segment.h"

#include <cstring>

#include "core/builtins.h"
#include "math/slerp.h"

namespace marrow {
namespace {

struct PointReader {
  const Curve& curve;
  // Point number `index`, where a key of kind hermite holds three.
  const float* at(std::size_t index) const { return curve.values.data + index * curve.components; }
  void copy(std::size_t index, float* out) const { std::memcpy(out, at(index), sizeof(float) * curve.components); }
};

void chain(const Curve& curve, Segment& s, int count) {
  if (!curve.rotation) return;
  for (int i = 1; i < count; ++i) chain_sign(s.point[i - 1], s.point[i]);
}

void make_hermite(const Curve& curve, std::size_t key, Segment& s) {
  const PointReader read{curve};
  const std::size_t order[4] = {3 * key + 1, 3 * key + 2, 3 * key + 4, 3 * key + 3};
  for (int i = 0; i < 4; ++i) read.copy(order[i], s.point[i]);
  const float span_s = curve.times_s[key + 1] - curve.times_s[key];
  const float sign = curve.rotation ? chain_sign(s.point[0], s.point[2]) : 1.0f;
  for (std::uint32_t i = 0; i < s.components; ++i) {
    s.point[1][i] *= span_s;
    s.point[3][i] *= sign * span_s;
  }
}

// Four consecutive points, the outer ones mirrored where the keys end.
struct Neighbours {
  float p[4][kMaxComponents];
};

Neighbours read_neighbours(const Curve& curve, std::size_t key) {
  const PointReader read{curve};
  Neighbours n{};
  const bool first = key == 0, last = key + 2 == curve.times_s.size;
  read.copy(key, n.p[1]);
  read.copy(key + 1, n.p[2]);
  if (!first) read.copy(key - 1, n.p[0]);
  if (!last) read.copy(key + 2, n.p[3]);
  if (curve.rotation) {
    chain_sign(n.p[1], n.p[0]);
    chain_sign(n.p[1], n.p[2]);
    chain_sign(n.p[2], n.p[3]);
  }
  for (std::uint32_t i = 0; i < curve.components; ++i) {
    if (first) n.p[0][i] = 2.0f * n.p[1][i] - n.p[2][i];
    if (last) n.p[3][i] = 2.0f * n.p[2][i] - n.p[1][i];
  }
  return n;
}

// The knot interval between two points: the square root of their distance.
float knot(const float* a, const float* b, std::uint32_t n) {
  float squared = 0.0f;
  for (std::uint32_t i = 0; i < n; ++i) squared += (b[i] - a[i]) * (b[i] - a[i]);
  return square_root(square_root(squared));
}

// The Hermite form of Barry and Goldman's pyramid: the tangent at a knot is the slope there of the parabola through it
// and its neighbours, here at p[1], a knot interval `here` long. `before` is the interval between p[0] and p[1]; 0,
// where points coincide, takes the other's.
void knot_tangent(const float* p0, const float* p1, const float* p2, float before, float here, std::uint32_t n,
                  float* out) {
  if (!(before > 0.0f)) before = here;
  const float ratio = here / before, share = here / (before + here);
  for (std::uint32_t i = 0; i < n; ++i) {
    out[i] = (p1[i] - p0[i]) * ratio - (p2[i] - p0[i]) * share + (p2[i] - p1[i]);
  }
}

void make_catmull_rom(const Curve& curve, std::size_t key, Segment& s) {
  const Neighbours near = read_neighbours(curve, key);
  const auto& p = near.p;
  const std::uint32_t n = s.components;
  std::memcpy(s.point[0], p[1], sizeof(p[1]));
  std::memcpy(s.point[2], p[2], sizeof(p[2]));
  if (curve.kind == CurveKind::catmull_rom) {
    for (std::uint32_t i = 0; i < n; ++i) {
      s.point[1][i] = 0.5f * (p[2][i] - p[0][i]);
      s.point[3][i] = 0.5f * (p[3][i] - p[1][i]);
    }
    return;
  }
  const float here = knot(p[1], p[2], n);
  if (!(here > 0.0f)) return;  // the two keys coincide: tangents stay zero
  knot_tangent(p[0], p[1], p[2], knot(p[0], p[1], n), here, n, s.point[1]);
  // The same from the other side: the parameter runs backwards, and so does the tangent.
  knot_tangent(p[3], p[2], p[1], knot(p[2], p[3], n), here, n, s.point[3]);
  for (std::uint32_t i = 0; i < n; ++i) s.point[3][i] = -s.point[3][i];
}

Weights value_weights(const Segment& s, float u) {
  const float v = 1.0f - u;
  switch (s.basis) {
    case Basis::linear:
      return {{v, u, 0.0f, 0.0f}};
    case Basis::slerp: {
      float chord_squared = 0.0f;
      for (int i = 0; i < 4; ++i) chord_squared += (s.point[1][i] - s.point[0][i]) * (s.point[1][i] - s.point[0][i]);
      const auto w = slerp_weights(chord_squared, u);
      return {{w.a, w.b, 0.0f, 0.0f}};
    }
    case Basis::bernstein2:
      return {{v * v, 2.0f * u * v, u * u, 0.0f}};
    case Basis::bernstein3:
      return bernstein3(u);
    case Basis::hermite:
      break;
  }
  const HermiteWeights w = hermite_weights(u);
  return {{w.from, w.leave, w.to, w.arrive}};
}

Weights slope_weights(const Segment& s, float u) {
  const float v = 1.0f - u, u2 = u * u;
  switch (s.basis) {
    case Basis::linear:
    case Basis::slerp:
      return {{-1.0f, 1.0f, 0.0f, 0.0f}};
    case Basis::bernstein2:
      return {{-2.0f * v, 2.0f * (v - u), 2.0f * u, 0.0f}};
    case Basis::bernstein3:
      return {{-3.0f * v * v, 3.0f * v * (v - 2.0f * u), 3.0f * u * (2.0f * v - u), 3.0f * u2}};
    case Basis::hermite:
      break;
  }
  return {{6.0f * (u2 - u), 3.0f * u2 - 4.0f * u + 1.0f, 6.0f * (u - u2), 3.0f * u2 - 2.0f * u}};
}

void weigh(const Segment& s, const Weights& weights, float* out) {
  const float* const w = weights.w;
  for (std::uint32_t i = 0; i < s.components; ++i) {
    out[i] = w[0] * s.point[0][i] + w[1] * s.point[1][i] + w[2] * s.point[2][i] + w[3] * s.point[3][i];
  }
}

}  // namespace

Segment make_segment(const Curve& curve, std::size_t key) {
  const PointReader read{curve};
  Segment s;
  s.components = curve.components;
  switch (curve.kind) {
    case CurveKind::step:
    case CurveKind::linear:
      s.basis = curve.rotation ? Basis::slerp : Basis::linear;
      for (std::size_t i = 0; i < 2; ++i) read.copy(key + i, s.point[i]);
      chain(curve, s, 2);
      break;
    case CurveKind::quadratic_bezier:
      s.basis = Basis::bernstein2;
      for (std::size_t i = 0; i < 3; ++i) read.copy(2 * key + i, s.point[i]);
      chain(curve, s, 3);
      break;
    case CurveKind::cubic_bezier:
      s.basis = Basis::bernstein3;
      for (std::size_t i = 0; i < 4; ++i) read.copy(3 * key + i, s.point[i]);
      chain(curve, s, 4);
      break;
    case CurveKind::hermite:
      s.basis = Basis::hermite;
      make_hermite(curve, key, s);
      break;
    case CurveKind::catmull_rom:
    case CurveKind::centripetal:
      s.basis = Basis::hermite;
      make_catmull_rom(curve, key, s);
      break;
  }
  return s;
}

void segment_value(const Segment& segment, float u, float* out) {
  weigh(segment, value_weights(segment, u), out);
}

void segment_slope(const Segment& segment, float u, float* out) {
  weigh(segment, slope_weights(segment, u), out);
}

Weights bernstein3(float u) {
  const float v = 1.0f - u;
  return {{v * v * v, 3.0f * u * v * v, 3.0f * u * u * v, u * u * u}};
}

Weights catmull_rom_weights(float u) {
  const float u2 = u * u, u3 = u2 * u;
  return {{0.5f * (2.0f * u2 - u3 - u), 0.5f * (3.0f * u3 - 5.0f * u2) + 1.0f, 0.5f * (4.0f * u2 - 3.0f * u3 + u),
           0.5f * (u3 - u2)}};
}

}  // namespace marrow
