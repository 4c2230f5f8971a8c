// What math.h offers of what the runtime computes with.
#include "core/check.h"
#include "marrow/math.h"
#include "math/affine.h"
#include "math/finite.h"
#include "math/quaternion.h"

namespace marrow {
namespace {

void put(const Vector3& v, float (&out)[3]) {
  out[0] = v.x;
  out[1] = v.y;
  out[2] = v.z;
}

// The rows of the linear part's inverse; of a flat map they are not finite.
Linear<float> inverse_rows(const Affine& map) {
  // In units of the largest number, so that products neither vanish nor overflow.
  float largest = 0;
  for (const auto& row : map.rows)
    for (int i = 0; i < 3; ++i) largest = largest < absolute(row[i]) ? absolute(row[i]) : largest;
  const float unit = 1.0f / largest;
  const Linear<float> m = linear(map), scaled{m.x * unit, m.y * unit, m.z * unit}, c = cofactors(scaled);
  const float over = unit / dot(scaled.x, c.x);
  return {c.x * over, c.y * over, c.z * over};
}

}  // namespace

Affine affine_of(const JointTransform& t) {
  const Linear<float> turn = columns_of(rotation(t.rotation));
  return affine({turn.x * t.scale[0], turn.y * t.scale[1], turn.z * t.scale[2]}, vector3(t.translation));
}

Affine compose(const Affine& a, const Affine& b) {
  Affine out;
  multiply(a, b, out);
  return out;
}

Status invert(const Affine& map, Affine& out) {
  const Linear<float> rows = inverse_rows(map);
  const Vector3 back = origin(map) * -1.0f, moved{dot(rows.x, back), dot(rows.y, back), dot(rows.z, back)};
  MARROW_REQUIRE(is_finite(moved) && "a map that is not flat");  // 0 times what is not finite is not, either
  out = {{{rows.x.x, rows.x.y, rows.x.z, moved.x},
          {rows.y.x, rows.y.y, rows.y.z, moved.y},
          {rows.z.x, rows.z.y, rows.z.z, moved.z}}};
  return Status::ok;
}

void transform_point(const Affine& map, const float (&point)[3], float (&out)[3]) {
  put(transform(map, vector3(point)), out);
}

void transform_direction(const Affine& map, const float (&direction)[3], float (&out)[3]) {
  put(turn(map, vector3(direction)), out);
}

Status direction_in_joint(const Affine& model_from_joint, const float (&direction)[3], float (&out)[3]) {
  const Vector3 d = normalised_or(vector3(direction), {0, 0, 0});
  MARROW_REQUIRE(dot(d, d) > 0 && "a direction");
  const Linear<float> rows = inverse_rows(model_from_joint);
  const Vector3 seen = normalised_or({dot(rows.x, d), dot(rows.y, d), dot(rows.z, d)}, {0, 0, 0});
  MARROW_REQUIRE(dot(seen, seen) > 0 && "a joint whose axes are not flat");
  put(seen, out);
  return Status::ok;
}

}  // namespace marrow
