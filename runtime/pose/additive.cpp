#include "core/check.h"
#include "core/zone.h"
#include "marrow/blend.h"
#include "math/quaternion.h"
#include "pose/mask.h"

namespace marrow {
namespace {

// ratio of two scales; 1 where there is next to nothing to divide by.
f32x4 ratio(f32x4 a, f32x4 b) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f);
  const f32x4 magnitude = select(b < zero, zero - b, b);
  const mask4 divides = splat(1e-20f) < magnitude;
  return select(divides, a / select(divides, b, one), one);
}

// Masked: lanes whose factor is 0 keep their bits.
template <bool Masked>
void add_layer(const AdditiveLayer& layer, std::size_t groups, SoaTransform* pose) {
  const f32x4 one = splat(1.0f), weight = splat(layer.weight);
  for (std::size_t g = 0; g < groups; ++g) {
    const f32x4 w = Masked ? factors(layer.mask, g) * weight : weight;
    const mask4 touched = splat(0.0f) < w;
    if (Masked && !any(touched)) continue;
    const auto put = [touched](float* to, f32x4 value) { Masked ? store(to, touched, value) : store(to, value); };
    const SoaTransform& by = layer.change.data[g].change;
    SoaTransform& p = pose[g];
    const Quaternion<f32x4> part = straight_share(load_rotations(by.rotation), w);
    const Quaternion<f32x4> after = normalised(part * load_rotations(p.rotation));
    put(p.rotation[0], after.x);
    put(p.rotation[1], after.y);
    put(p.rotation[2], after.z);
    put(p.rotation[3], after.w);
    for (int i = 0; i < 3; ++i) {
      put(p.translation[i], load_aligned(p.translation[i]) + load_aligned(by.translation[i]) * w);
      put(p.scale[i], load_aligned(p.scale[i]) * (one + (load_aligned(by.scale[i]) - one) * w));
    }
  }
}

}  // namespace

Status make_additive(const Skeleton& skeleton, Span<const SoaTransform> pose, Span<const SoaTransform> reference,
                     Span<AdditiveTransform> out) {
  MARROW_ZONE;
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(pose, groups));
  MARROW_REQUIRE(holds(reference, groups));
  MARROW_REQUIRE(holds(out, groups));
  for (std::size_t g = 0; g < groups; ++g) {
    const SoaTransform &p = pose[g], &r = reference[g];
    const Quaternion<f32x4> change = load_rotations(p.rotation) * conjugate(load_rotations(r.rotation));
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
  MARROW_ZONE;
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(pose, groups));
  MARROW_REQUIRE(holds(layer.change, groups));
  MARROW_REQUIRE(within(layer.weight, 0.0f, 1.0f));
  MARROW_REQUIRE(layer.mask.empty() || holds(layer.mask, 4 * groups));
  if (layer.weight == 0.0f) return Status::ok;
  layer.mask.empty() ? add_layer<false>(layer, groups, pose.data) : add_layer<true>(layer, groups, pose.data);
  return Status::ok;
}

}  // namespace marrow
