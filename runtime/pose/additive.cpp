#include "core/check.h"
#include "marrow/blend.h"
#include "math/quaternion.h"
#include "pose/mask.h"

namespace marrow {
namespace {

// ratio of two scales; 1 where there is nothing to divide by.
f32x4 ratio(f32x4 a, f32x4 b) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f);
  const f32x4 safe = select(zero < b, b, select(b < zero, b, one));
  return select(zero < b, a / safe, select(b < zero, a / safe, one));
}

}  // namespace

Status make_additive(const Skeleton& skeleton, Span<const SoaTransform> pose, Span<const SoaTransform> reference,
                     Span<AdditiveTransform> out) {
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(pose.size >= groups);
  MARROW_REQUIRE(reference.size >= groups);
  MARROW_REQUIRE(out.size >= groups);
  for (std::size_t g = 0; g < groups; ++g) {
    const SoaTransform &p = pose[g], &r = reference[g];
    const Quaternions change = load_rotations(p) * conjugate(load_rotations(r));
    const f32x4 length = sqrt(dot(change, change));
    const f32x4 divisor = select(splat(0.0f) < length, length, splat(1.0f));
    SoaTransform& to = out[g].change;
    store(to.rotation[0], flip(change.x, change.w) / divisor);
    store(to.rotation[1], flip(change.y, change.w) / divisor);
    store(to.rotation[2], flip(change.z, change.w) / divisor);
    store(to.rotation[3], flip(change.w, change.w) / divisor);
    for (int i = 0; i < 3; ++i) {
      store(to.translation[i], load_aligned(p.translation[i]) - load_aligned(r.translation[i]));
      store(to.scale[i], ratio(load_aligned(p.scale[i]), load_aligned(r.scale[i])));
    }
  }
  return Status::ok;
}

Status add(const Skeleton& skeleton, const AdditiveLayer& layer, Span<SoaTransform> pose) {
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(pose.size >= groups);
  MARROW_REQUIRE(layer.change.size >= groups);
  MARROW_REQUIRE(within(layer.weight, 0.0f, 1.0f));
  MARROW_REQUIRE(long_enough(layer.mask, groups));
  const f32x4 zero = splat(0.0f), one = splat(1.0f), weight = splat(layer.weight);
  for (std::size_t g = 0; g < groups; ++g) {
    const f32x4 w = factors(layer.mask, g) * weight;
    const mask4 touched = zero < w;
    if (!any(touched)) continue;
    const SoaTransform& by = layer.change[g].change;
    SoaTransform& p = pose[g];
    const Quaternions before = load_rotations(p), whole = load_rotations(by);
    const Quaternions part = {whole.x * w, whole.y * w, whole.z * w, (one - w) + whole.w * w};
    const Quaternions after = normalised(part * before);
    store_rotations(p, {select(touched, after.x, before.x), select(touched, after.y, before.y),
                        select(touched, after.z, before.z), select(touched, after.w, before.w)});
    for (int i = 0; i < 3; ++i) {
      const f32x4 t = load_aligned(p.translation[i]), s = load_aligned(p.scale[i]);
      store(p.translation[i], select(touched, t + load_aligned(by.translation[i]) * w, t));
      store(p.scale[i], select(touched, s * (one + (load_aligned(by.scale[i]) - one) * w), s));
    }
  }
  return Status::ok;
}

}  // namespace marrow
