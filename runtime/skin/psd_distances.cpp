// How far a pose is from the examples of pose-space deformation, four palette entries at a time.
#include "core/check.h"
#include "core/zone.h"
#include "marrow/skin.h"
#include "math/rotation.h"

namespace marrow {
namespace {

// A rotation matrix L as Davenport's quadratic form in a quaternion q. It gives the trace of Lᵀ R(q):
// |q|² tr(Lᵀ R(q)) = Σ diagonal_i q_i² + 2 Σ product_i.
struct RotationForm {
  f32x4 xx, yy, zz, ww, xy, xz, yz, wx, wy, wz;

  explicit RotationForm(const Linear<f32x4>& l)
      : xx(l.x.x - l.y.y - l.z.z),
        yy(l.y.y - l.x.x - l.z.z),
        zz(l.z.z - l.x.x - l.y.y),
        ww(l.x.x + l.y.y + l.z.z),
        xy(l.y.x + l.x.y),
        xz(l.z.x + l.x.z),
        yz(l.z.y + l.y.z),
        wx(l.y.z - l.z.y),
        wy(l.z.x - l.x.z),
        wz(l.x.y - l.y.x) {}
};

// sin² of half the angle between L and q: (3 - tr(Lᵀ R)) / 4, kept at or above 0 against rounding. 0 for q = 0.
f32x4 distance(const RotationForm& l, const Quaternion<f32x4>& q) {
  const f32x4 squares = l.xx * (q.x * q.x) + l.yy * (q.y * q.y) + l.zz * (q.z * q.z) + l.ww * (q.w * q.w);
  const f32x4 with_w = q.w * (l.wx * q.x + l.wy * q.y + l.wz * q.z);
  const f32x4 others = l.xy * (q.x * q.y) + l.xz * (q.x * q.z) + l.yz * (q.y * q.z);
  const f32x4 length = dot(q, q);
  const f32x4 zero = splat(0.0f);
  const f32x4 d = splat(0.75f) - splat(0.25f) * (squares + splat(2.0f) * (with_w + others)) / length;
  return select(zero < d, d, zero);
}

// Four entries of a palette; lanes beyond its end repeat the last entry.
struct FourEntries {
  std::size_t entry[4];
  const Affine* joints[4];
  const Affine* parents[4];  // an entry without a parent: the entry itself
  alignas(16) float has_parent[4];

  FourEntries(std::size_t first, std::size_t count, const std::uint16_t* parent_of, const Affine* palette) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const std::size_t j = first + lane < count ? first + lane : count - 1;
      entry[lane] = j;
      has_parent[lane] = parent_of[j] == kNoJoint ? 0.0f : 1.0f;
      joints[lane] = palette + j;
      parents[lane] = palette + (parent_of[j] == kNoJoint ? j : parent_of[j]);
    }
  }
  Quaternion<f32x4> rotations(const std::int16_t* of_example) const {
    Quaternion<f32x4> q = {load_int16(of_example + 4 * entry[0]), load_int16(of_example + 4 * entry[1]),
                           load_int16(of_example + 4 * entry[2]), load_int16(of_example + 4 * entry[3])};
    transpose(q.x, q.y, q.z, q.w);
    return q;
  }
};

// The entries' rotations relative to their parents.
RotationForm local_rotations(const FourEntries& four) {
  const auto rotations = [](const Affine* const(&m)[4]) { return rotations_of(*m[0], *m[1], *m[2], *m[3]); };
  return RotationForm(transposed_times(rotations(four.parents), rotations(four.joints)));
}

}  // namespace

std::size_t psd_distance_count(const Geometry& geometry) {
  const std::size_t examples = geometry.pose_space.examples.size;
  return examples > 0 ? (examples + 1) * geometry.joint_count : 0;
}

Status psd_distances(const Geometry& geometry, Span<const Affine> palette, Span<float> out) {
  MARROW_ZONE;
  const PoseSpace& space = geometry.pose_space;
  const std::size_t joints = geometry.joint_count, examples = space.examples.size;
  MARROW_REQUIRE(holds(palette, joints));
  MARROW_REQUIRE(holds(out, psd_distance_count(geometry)));
  if (examples == 0) return Status::ok;
  const f32x4 falloff = splat(-0.5f / (space.sigma * space.sigma));
  const f32x4 zero = splat(0.0f), one = splat(1.0f);
  const Quaternion<f32x4> bind = {zero, zero, zero, one};
  for (std::size_t first = 0; first < joints; first += 4) {
    const FourEntries four(first, joints, space.parents, palette.data);
    const RotationForm now = local_rotations(four);
    const f32x4 scale = falloff * load_aligned(four.has_parent);
    for (std::size_t k = 0; k <= examples; ++k) {
      const bool is_bind = k == examples;
      alignas(16) float to[4];
      store(to, distance(now, is_bind ? bind : four.rotations(space.rotations + 4 * joints * k)) * scale);
      // Lanes beyond the end write the last entry again.
      for (std::size_t lane = 0; lane < 4; ++lane) out[(examples + 1) * four.entry[lane] + k] = to[lane];
    }
  }
  return Status::ok;
}

}  // namespace marrow
