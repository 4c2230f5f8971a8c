#include "marrow/local_to_model.h"

#include "core/check.h"
#include "core/zone.h"
#include "math/affine.h"
#include "math/quaternion.h"
#include "pose/joint_range.h"

namespace marrow {
namespace {

// The rows of four joints' parent_from_joint matrices.
struct FourMatrices {
  f32x4 rows[3][4];  // [row][joint]
};

inline void store_row(f32x4 a, f32x4 b, f32x4 c, f32x4 d, f32x4 (&row)[4]) {
  transpose(a, b, c, d);
  row[0] = a, row[1] = b, row[2] = c, row[3] = d;
}

// Rotation matrix of a unit quaternion, columns scaled, translation in the fourth column.
inline void to_matrices(const SoaTransform& t, FourMatrices& m) {
  const Linear<f32x4> axes = columns_of(load_rotations(t.rotation));
  const f32x4 sx = load_aligned(t.scale[0]), sy = load_aligned(t.scale[1]), sz = load_aligned(t.scale[2]);
  store_row(axes.x.x * sx, axes.y.x * sy, axes.z.x * sz, load_aligned(t.translation[0]), m.rows[0]);
  store_row(axes.x.y * sx, axes.y.y * sy, axes.z.y * sz, load_aligned(t.translation[1]), m.rows[1]);
  store_row(axes.x.z * sx, axes.y.z * sy, axes.z.z * sz, load_aligned(t.translation[2]), m.rows[2]);
}

// Joints `first` … `end` - 1 of one group of four. A root's parent matrix is its model_from_root.
void transform_some(const Skeleton& skeleton, const SoaTransform* local, std::uint32_t first, std::uint32_t end,
                    Affine* out) {
  FourMatrices m;
  to_matrices(local[first / 4], m);
  for (std::uint32_t joint = first; joint < end; ++joint) {
    const Affine& above = joint < skeleton.root_count ? skeleton.model_from_root[joint] : out[skeleton.parents[joint]];
    const std::uint32_t lane = joint % 4;
    multiply(above, m.rows[0][lane], m.rows[1][lane], m.rows[2][lane], out[joint]);
  }
}

}  // namespace

void transform_joints(const Skeleton& skeleton, const SoaTransform* local, std::uint32_t first, std::uint32_t end,
                      Affine* out) {
  std::uint32_t joint = first;
  while (joint < end && (joint % 4 != 0 || joint < skeleton.root_count)) {
    const std::uint32_t group_end = joint / 4 * 4 + 4, stop = group_end < end ? group_end : end;
    transform_some(skeleton, local, joint, stop, out);
    joint = stop;
  }
  const std::uint16_t* above = skeleton.parents + joint;
  const SoaTransform* group = local + joint / 4;
  for (; joint + 4 <= end; joint += 4, above += 4, ++group) {
    FourMatrices m;
    to_matrices(*group, m);
    Affine* const to = out + joint;
    multiply(out[above[0]], m.rows[0][0], m.rows[1][0], m.rows[2][0], to[0]);
    multiply(out[above[1]], m.rows[0][1], m.rows[1][1], m.rows[2][1], to[1]);
    multiply(out[above[2]], m.rows[0][2], m.rows[1][2], m.rows[2][2], to[2]);
    multiply(out[above[3]], m.rows[0][3], m.rows[1][3], m.rows[2][3], to[3]);
  }
  if (joint < end) transform_some(skeleton, local, joint, end, out);
}

Status local_to_model(const Skeleton& skeleton, Span<const SoaTransform> local, Span<Affine> out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(local, skeleton.soa_size()));
  MARROW_REQUIRE(holds(out, skeleton.joint_count));
  transform_joints(skeleton, local.data, 0, skeleton.joint_count, out.data);
  return Status::ok;
}

Status local_to_model_first(const Skeleton& skeleton, Span<const SoaTransform> local, std::uint32_t joint_count,
                            Span<Affine> out) {
  MARROW_ZONE;
  MARROW_REQUIRE(joint_count <= skeleton.joint_count);
  MARROW_REQUIRE(holds(local, soa_count(joint_count)));
  MARROW_REQUIRE(holds(out, joint_count));
  transform_joints(skeleton, local.data, 0, joint_count, out.data);
  return Status::ok;
}

// Breadth-first order keeps the children of neighbours together, so the descendants of each generation are one range.
Status local_to_model_below(const Skeleton& skeleton, Span<const SoaTransform> local, std::uint32_t joint,
                            Span<Affine> out) {
  MARROW_ZONE;
  const std::uint32_t count = skeleton.joint_count;
  const std::uint16_t* const parents = skeleton.parents;
  MARROW_REQUIRE(joint < count);
  MARROW_REQUIRE(holds(local, skeleton.soa_size()));
  MARROW_REQUIRE(holds(out, count));
  std::uint32_t first = joint, end = joint + 1;
  while (first < end) {
    transform_joints(skeleton, local.data, first, end, out.data);
    std::uint32_t begin = end > skeleton.root_count ? end : skeleton.root_count;
    while (begin < count && parents[begin] < first) ++begin;
    std::uint32_t past = begin;
    while (past < count && parents[past] < end) ++past;
    first = begin;
    end = past;
  }
  return Status::ok;
}

}  // namespace marrow
