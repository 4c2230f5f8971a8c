#include "marrow/local_to_model.h"

#include "core/check.h"
#include "math/affine.h"

namespace marrow {
namespace {

// The rows of four joints' parent_from_joint matrices.
struct FourMatrices {
  f32x4 rows[3][4];  // [row][joint]
};

// Rotation matrix of a unit quaternion, columns scaled, translation in the fourth column.
FourMatrices to_matrices(const SoaTransform& t) {
  const f32x4 x = load(t.rotation[0]), y = load(t.rotation[1]), z = load(t.rotation[2]), w = load(t.rotation[3]);
  const f32x4 sx = load(t.scale[0]), sy = load(t.scale[1]), sz = load(t.scale[2]);
  const f32x4 one = splat(1.0f);
  const f32x4 x2 = x + x, y2 = y + y, z2 = z + z;
  const f32x4 xx = x * x2, yy = y * y2, zz = z * z2;
  const f32x4 xy = x * y2, xz = x * z2, yz = y * z2;
  const f32x4 wx = w * x2, wy = w * y2, wz = w * z2;
  FourMatrices m = {{{(one - (yy + zz)) * sx, (xy - wz) * sy, (xz + wy) * sz, load(t.translation[0])},
                     {(xy + wz) * sx, (one - (xx + zz)) * sy, (yz - wx) * sz, load(t.translation[1])},
                     {(xz - wy) * sx, (yz + wx) * sy, (one - (xx + yy)) * sz, load(t.translation[2])}}};
  for (f32x4(&row)[4] : m.rows) transpose(row[0], row[1], row[2], row[3]);
  return m;
}

}  // namespace

Status local_to_model(const Skeleton& skeleton, Span<const SoaTransform> local, Span<Affine> out) {
  MARROW_REQUIRE(local.size >= skeleton.soa_size());
  MARROW_REQUIRE(out.size >= skeleton.joint_count);
  for (std::uint32_t first = 0; first < skeleton.joint_count; first += 4) {
    const FourMatrices m = to_matrices(local[first / 4]);
    const std::uint32_t end = first + 4 < skeleton.joint_count ? first + 4 : skeleton.joint_count;
    for (std::uint32_t joint = first; joint < end; ++joint) {
      const Affine& above =
          joint < skeleton.root_count ? skeleton.scene_from_root[joint] : out[skeleton.parents[joint]];
      const std::uint32_t lane = joint - first;
      multiply(above, m.rows[0][lane], m.rows[1][lane], m.rows[2][lane], out[joint]);
    }
  }
  return Status::ok;
}

}  // namespace marrow
