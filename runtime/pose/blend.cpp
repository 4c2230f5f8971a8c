#include "marrow/blend.h"

#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "math/quaternion.h"
#include "pose/mask.h"

namespace marrow {
namespace {

// Four joints' weighted sums.
struct Sum {
  f32x4 translation[3];
  Quaternion<f32x4> rotation;
  f32x4 scale[3];
};

// sum += w q, in the sum's hemisphere: the sign goes into the weight.
inline void add_rotation(Quaternion<f32x4>& sum, const SoaTransform& x, f32x4 w) {
  const Quaternion<f32x4> q = load_rotations(x.rotation);
  sum = sum + q * flip(w, dot(q, sum));
}

// Unit rotations never cancel, since each is added in the hemisphere of the sum: the length is not 0.
inline void store_rotation(const Quaternion<f32x4>& sum, SoaTransform& out) {
  store_rotations(out.rotation, sum * (splat(1.0f) / sqrt(dot(sum, sum))));
}

// A separate loop: a processor does not look far enough ahead to overlap this long chain of operations with the sums.
[[gnu::noinline]] void normalise_rotations(std::size_t groups, SoaTransform* out) {
  const f32x4 one = splat(1.0f);
#pragma GCC unroll 4
  for (std::size_t g = 0; g < groups; ++g) {
    SoaTransform& t = out[g];
    const Quaternion<f32x4> q = load_rotations(t.rotation);
    store_rotations(t.rotation, q * (one / sqrt(dot(q, q))));
  }
}

// sum += w x
inline void accumulate(Sum& sum, const SoaTransform& x, f32x4 w) {
  add_rotation(sum.rotation, x, w);
  for (int i = 0; i < 3; ++i) sum.translation[i] = sum.translation[i] + load_aligned(x.translation[i]) * w;
  for (int i = 0; i < 3; ++i) sum.scale[i] = sum.scale[i] + load_aligned(x.scale[i]) * w;
}

// One group, any layers; each lane has a sum of weights of its own.
void blend_group(Span<const BlendLayer> layers, const SoaTransform& rest, float threshold, std::size_t group,
                 SoaTransform& out) {
  const f32x4 zero = splat(0.0f), least = splat(threshold);
  Sum sum = {{zero, zero, zero}, {zero, zero, zero, zero}, {zero, zero, zero}};
  f32x4 total = zero;
  for (const BlendLayer& layer : layers) {
    if (!(0.0f < layer.weight)) continue;
    const f32x4 w = factors(layer.mask, group) * splat(layer.weight);
    accumulate(sum, layer.pose[group], w);
    total = total + w;
  }
  const mask4 short_of = total < least;
  if (any(short_of)) {
    const f32x4 missing = select(short_of, least - total, zero);
    accumulate(sum, rest, missing);
    total = total + missing;
  }
  const f32x4 inverse = splat(1.0f) / total;
  store_rotation(sum.rotation, out);
  for (int i = 0; i < 3; ++i) store(out.translation[i], sum.translation[i] * inverse);
  for (int i = 0; i < 3; ++i) store(out.scale[i], sum.scale[i] * inverse);
}

// The layers whose weights are not negligible, without masks. There is one place more, for the rest pose.
struct FewLayers {
  static constexpr std::size_t kMost = 4;
  std::size_t count = 0;
  const SoaTransform* pose[kMost + 1];
  float weight[kMost + 1];
};

// Of two layers or more. Weights in the sums are relative to the first layer's; `share` is its part of the total.
void blend_even(const FewLayers& layers, std::size_t groups, SoaTransform* out) {
  f32x4 weight[FewLayers::kMost + 1];
  float total = 1.0f;
  for (std::size_t l = 1; l < layers.count; ++l) {
    const float relative = layers.weight[l] / layers.weight[0];
    weight[l] = splat(relative);
    total += relative;
  }
  const f32x4 share = splat(1.0f / total);
  const SoaTransform* const first = layers.pose[0];
  for (std::size_t g = 0; g < groups; ++g) {
    Sum sum;
    sum.rotation = load_rotations(first[g].rotation);
    for (int i = 0; i < 3; ++i) sum.translation[i] = load_aligned(first[g].translation[i]);
    for (int i = 0; i < 3; ++i) sum.scale[i] = load_aligned(first[g].scale[i]);
    std::size_t l = 1;
    do accumulate(sum, layers.pose[l][g], weight[l]);
    while (++l < layers.count);
    store_rotations(out[g].rotation, sum.rotation);
    for (int i = 0; i < 3; ++i) store(out[g].translation[i], sum.translation[i] * share);
    for (int i = 0; i < 3; ++i) store(out[g].scale[i], sum.scale[i] * share);
  }
  normalise_rotations(groups, out);
}

// A layer with its mask. Without a mask, kOnes serves every group: its step is 0.
struct MaskedLayer {
  explicit MaskedLayer(const BlendLayer& layer)
      : pose(layer.pose.data),
        mask(layer.mask.empty() ? kOnes : layer.mask.data),
        step(layer.mask.empty() ? 0 : 4),
        weight(splat(layer.weight)) {}

  static constexpr float kOnes[4] = {1.0f, 1.0f, 1.0f, 1.0f};
  const SoaTransform* pose;
  const float* mask;
  std::size_t step;
  f32x4 weight;
};

// Two layers, the usual case with masks; both weights are more than 0. Nothing is called in the loop, so that constants
// stay in registers.
void blend_two(MaskedLayer a, MaskedLayer b, const SoaTransform* rest, float threshold, std::size_t groups,
               SoaTransform* out) {
  const f32x4 least = splat(threshold);
  for (std::size_t g = 0; g < groups; ++g, a.mask += a.step, b.mask += b.step) {
    const SoaTransform &x = a.pose[g], &y = b.pose[g], &r = rest[g];
    const f32x4 wx = clamp_to_unit(load(a.mask)) * a.weight, wy = clamp_to_unit(load(b.mask)) * b.weight;
    f32x4 total = wx + wy;
    Quaternion<f32x4> rotation = load_rotations(x.rotation) * wx;
    add_rotation(rotation, y, wy);
    const mask4 short_of = total < least;
    if (any(short_of)) {
      const f32x4 missing = select(short_of, least - total, splat(0.0f));
      add_rotation(rotation, r, missing);
      store_rotation(rotation, out[g]);
      total = total + missing;
      const f32x4 u = wx / total, v = wy / total;
      const auto mix = [u, v](const float* base, const float* first, const float* second, float* mixed) {
        const f32x4 from = load_aligned(base);
        store(mixed, from + (load_aligned(first) - from) * u + (load_aligned(second) - from) * v);
      };
      for (int i = 0; i < 3; ++i) mix(r.translation[i], x.translation[i], y.translation[i], out[g].translation[i]);
      for (int i = 0; i < 3; ++i) mix(r.scale[i], x.scale[i], y.scale[i], out[g].scale[i]);
      continue;
    }
    store_rotation(rotation, out[g]);
    const f32x4 u = wy / total;
    const auto mix = [u](const float* first, const float* second, float* mixed) {
      store(mixed, load_aligned(first) + (load_aligned(second) - load_aligned(first)) * u);
    };
    for (int i = 0; i < 3; ++i) mix(x.translation[i], y.translation[i], out[g].translation[i]);
    for (int i = 0; i < 3; ++i) mix(x.scale[i], y.scale[i], out[g].scale[i]);
  }
}

// from and to may be the same.
inline void copy_pose(const SoaTransform* from, std::size_t groups, SoaTransform* to) {
  if (groups > 0) std::memmove(to, from, groups * sizeof(SoaTransform));  // else either may be null
}

void blend_without_masks(const FewLayers& layers, std::size_t groups, SoaTransform* out) {
  if (layers.count == 1) return copy_pose(layers.pose[0], groups, out);
  blend_even(layers, groups, out);
}

// Weights below this part of the whole do not show in a float, and would make ratios too large.
constexpr float kNegligible = 1e-12f;

}  // namespace

Status blend(const Skeleton& skeleton, Span<const BlendLayer> layers, Span<SoaTransform> out, float threshold) {
  MARROW_ZONE;
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(out, groups));
  MARROW_REQUIRE(within(threshold, 1e-6f, kMaxBlendWeight));
  MARROW_REQUIRE(holds(layers));
  bool masked = false;
  float total = 0.0f;
  for (const BlendLayer& layer : layers) {
    MARROW_REQUIRE(holds(layer.pose, groups));
    MARROW_REQUIRE(within(layer.weight, 0.0f, kMaxBlendWeight));
    MARROW_REQUIRE(layer.mask.empty() || holds(layer.mask, 4 * groups));
    total += layer.weight;
    masked |= !layer.mask.empty();
  }
  const bool two = masked && layers.size == 2 && layers[0].weight > 0.0f && layers[1].weight > 0.0f;
  // Below the threshold the rest pose fills up the total, so the whole is never less than `threshold`.
  const float least = kNegligible * (total < threshold ? threshold : total);
  if (two) {
    blend_two(MaskedLayer(layers[0]), MaskedLayer(layers[1]), skeleton.rest, threshold, groups, out.data);
    return Status::ok;
  }
  FewLayers few;
  for (const BlendLayer& layer : layers) {
    if (!(layer.weight > least)) continue;
    if (few.count < FewLayers::kMost) {
      few.pose[few.count] = layer.pose.data;
      few.weight[few.count] = layer.weight;
    }
    ++few.count;
  }
  if (masked || few.count > FewLayers::kMost) {
    for (std::size_t g = 0; g < groups; ++g) blend_group(layers, skeleton.rest[g], threshold, g, out[g]);
    return Status::ok;
  }
  if (total < threshold) {
    few.pose[few.count] = skeleton.rest;
    few.weight[few.count++] = threshold - total;
  }
  blend_without_masks(few, groups, out.data);
  return Status::ok;
}

Status mask_below(const Skeleton& skeleton, std::uint32_t joint, std::uint32_t falloff, Span<float> mask) {
  MARROW_REQUIRE(joint < skeleton.joint_count);
  MARROW_REQUIRE(holds(mask, 4 * skeleton.soa_size()));
  const float full = static_cast<float>(falloff) + 1.0f;
  for (std::uint32_t j = joint; j < skeleton.joint_count; ++j) {
    float depth = 1;  // of `joint` itself
    std::uint32_t at = j;
    for (; at > joint && at >= skeleton.root_count; at = skeleton.parents[at]) ++depth;
    const float share = depth < full ? depth / full : 1.0f;
    if (at == joint && !(mask[j] > share)) mask[j] = share;
  }
  return Status::ok;
}

Status overlay(const Skeleton& skeleton, const BlendLayer& layer, Span<SoaTransform> pose) {
  MARROW_ZONE;
  const std::size_t groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(pose, groups));
  MARROW_REQUIRE(holds(layer.pose, groups));
  MARROW_REQUIRE(within(layer.weight, 0.0f, 1.0f));
  MARROW_REQUIRE(layer.mask.empty() || holds(layer.mask, 4 * groups));
  const f32x4 zero = splat(0.0f), one = splat(1.0f), weight = splat(layer.weight);
  for (std::size_t g = 0; g < groups; ++g) {
    const f32x4 w = factors(layer.mask, g) * weight;
    const mask4 touched = zero < w, partly = w < one;
    if (!any(touched)) continue;
    const SoaTransform& to = layer.pose[g];
    SoaTransform& at = pose[g];
    Quaternion<f32x4> rotation = load_rotations(at.rotation) * (one - w);
    add_rotation(rotation, to, w);
    rotation = rotation * (one / sqrt(dot(rotation, rotation)));
    const auto put = [&](f32x4 mixed, const float* whole, float* kept) {
      store(kept, select(touched, select(partly, mixed, load_aligned(whole)), load_aligned(kept)));
    };
    put(rotation.x, to.rotation[0], at.rotation[0]);
    put(rotation.y, to.rotation[1], at.rotation[1]);
    put(rotation.z, to.rotation[2], at.rotation[2]);
    put(rotation.w, to.rotation[3], at.rotation[3]);
    const auto mix = [&](const float* whole, float* kept) {
      const f32x4 x = load_aligned(kept);
      put(x + (load_aligned(whole) - x) * w, whole, kept);
    };
    for (int i = 0; i < 3; ++i) mix(to.translation[i], at.translation[i]);
    for (int i = 0; i < 3; ++i) mix(to.scale[i], at.scale[i]);
  }
  return Status::ok;
}

}  // namespace marrow
