#include "skin/half_way.h"

#include <cmath>

#include "math/slerp.h"

namespace marrow {
namespace {

struct Vector {
  float x, y, z;
};

Vector operator+(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
Vector operator*(const Vector& v, float s) {
  return {v.x * s, v.y * s, v.z * s};
}
float dot(const Vector& a, const Vector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// By columns.
struct Linear {
  Vector x, y, z;
};
Vector operator*(const Linear& m, const Vector& v) {
  return m.x * v.x + m.y * v.y + m.z * v.z;
}
Linear operator*(const Linear& a, const Linear& b) {
  return {a * b.x, a * b.y, a * b.z};
}
// aᵀ b
Linear transposed_times(const Linear& a, const Linear& b) {
  const auto column = [&](const Vector& v) { return Vector{dot(a.x, v), dot(a.y, v), dot(a.z, v)}; };
  return {column(b.x), column(b.y), column(b.z)};
}
Vector column(const Affine& a, int c) {
  return {a.rows[0][c], a.rows[1][c], a.rows[2][c]};
}
Linear linear_of(const Affine& a) {
  return {column(a, 0), column(a, 1), column(a, 2)};
}

bool make_unit(Vector& v) {
  const float length = std::sqrt(dot(v, v));
  v = v * (1.0f / length);
  return length > 1e-18f && length < 1e18f;
}

// The rotation next to the first two columns (Gram and Schmidt). False without volume.
bool rotation_of(const Linear& m, Linear& out) {
  out.x = m.x;
  if (!make_unit(out.x)) return false;
  out.y = m.y + out.x * -dot(out.x, m.y);
  if (!make_unit(out.y)) return false;
  out.z = cross(out.x, out.y);
  return true;
}

struct Quaternion {
  float v[4];  // x, y, z, w
};

// From the largest component, so that nothing cancels (Shepperd 1978); w ≥ 0.
Quaternion quaternion_of(const Linear& r) {
  const float m[3][3] = {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
  const float trace = m[0][0] + m[1][1] + m[2][2];
  int i = m[1][1] > m[0][0] ? 1 : 0;
  if (m[2][2] > m[i][i]) i = 2;
  Quaternion q{};
  if (trace >= m[i][i]) {
    const float four_w = 2.0f * std::sqrt(1.0f + trace);
    q = {{(m[2][1] - m[1][2]) / four_w, (m[0][2] - m[2][0]) / four_w, (m[1][0] - m[0][1]) / four_w, 0.25f * four_w}};
  } else {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const float four = 2.0f * std::sqrt(1.0f + m[i][i] - m[j][j] - m[k][k]);
    q.v[i] = 0.25f * four;
    q.v[j] = (m[j][i] + m[i][j]) / four;
    q.v[k] = (m[k][i] + m[i][k]) / four;
    q.v[3] = (m[k][j] - m[j][k]) / four;
  }
  if (q.v[3] < 0.0f)
    for (float& c : q.v) c = -c;
  return q;
}

Linear matrix_of(const Quaternion& q) {
  const float x = q.v[0], y = q.v[1], z = q.v[2], w = q.v[3], two = 2.0f / (x * x + y * y + z * z + w * w);
  return {{1.0f - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
          {two * (x * y - w * z), 1.0f - two * (x * x + z * z), two * (y * z + w * x)},
          {two * (x * z + w * y), two * (y * z - w * x), 1.0f - two * (x * x + y * y)}};
}

// A share of a rotation on the sphere.
Linear part_of(const Linear& rotation, float share) {
  Quaternion q = quaternion_of(rotation);
  const float from_one = q.v[3] - 1.0f;
  const float chord = q.v[0] * q.v[0] + q.v[1] * q.v[1] + q.v[2] * q.v[2] + from_one * from_one;
  const SlerpWeights<float> weights = slerp_weights(chord < 2.0f ? chord : 2.0f, share);
  for (float& c : q.v) c = c * weights.b;
  q.v[3] = q.v[3] + weights.a;
  return matrix_of(q);
}

// What bind takes to the origin: the joint in the bind pose. False if nothing, or much.
bool bind_place(const Affine& bind, Vector& out) {
  const Linear m = linear_of(bind);
  const Vector yz = cross(m.y, m.z), t = column(bind, 3);
  const float volume = dot(m.x, yz);
  const float scale = -1.0f / volume;
  out = {dot(t, yz) * scale, dot(t, cross(m.z, m.x)) * scale, dot(t, cross(m.x, m.y)) * scale};
  return volume != 0.0f && dot(out, out) < 1e30f;
}

}  // namespace

Affine half_way(const Affine& parent, const Affine& joint, const Affine& bind, float share) {
  Linear a, b;
  Vector centre;
  const Linear from_parent = linear_of(parent), from_joint = linear_of(joint);
  if (!rotation_of(from_parent, a) || !rotation_of(from_joint, b) || !bind_place(bind, centre)) return joint;
  const Linear p = transposed_times(a, from_parent), j = transposed_times(b, from_joint);
  const float rest = 1.0f - share;
  const Linear stretch = {p.x * rest + j.x * share, p.y * rest + j.y * share, p.z * rest + j.z * share};
  const Linear m = a * part_of(transposed_times(a, b), share) * stretch;
  const Vector moved =
      (from_parent * centre + column(parent, 3)) * rest + (from_joint * centre + column(joint, 3)) * share;
  const Vector t = moved + m * centre * -1.0f;
  return {{{m.x.x, m.y.x, m.z.x, t.x}, {m.x.y, m.y.y, m.z.y, t.y}, {m.x.z, m.y.z, m.z.z, t.z}}};
}

}  // namespace marrow
