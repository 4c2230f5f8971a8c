// Poses: read, sampled, blended, taken to the scene.
#include <cmath>

#include <gtest/gtest.h>

#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

const Skeleton& skeleton_of(Misuse& m) {
  return m.either(stage().skeleton, stage().smaller);
}

SampleOptions sampled_joints(Misuse& m) {
  const std::vector<std::uint32_t> words(1, 0x000FFFFF);
  return {.joints = m.truth(true) ? Span<const std::uint32_t>() : m.in(words, Length::any)};
}

std::vector<BlendLayer> blended(Misuse& m) {
  std::vector<BlendLayer> layers;
  const std::vector<float> mask(stage().pose.size() * 4, 0.5f);
  for (int i = 0; i < 3; ++i)
    layers.push_back({m.in(i == 1 ? stage().other : stage().pose), m.number(0.5f),
                      i == 2 ? m.in(mask, Length::exact_or_none) : Span<const float>()});
  return layers;
}

std::vector<AdditiveTransform> change() {
  std::vector<AdditiveTransform> out(stage().pose.size());
  EXPECT_EQ(make_additive(stage().skeleton, stage().other, stage().pose, out), Status::ok);
  return out;
}

std::vector<InertialOffset> offsets(Inertia& inertia) {
  std::vector<InertialOffset> out(stage().pose.size());
  inertia.offsets = out;
  EXPECT_EQ(begin_inertia(stage().skeleton, {stage().pose, stage().pose, stage().other, {}, 0.1f}, 1, inertia),
            Status::ok);
  return out;
}

Playback playback_of(Misuse& m) {
  return {.time_s = static_cast<double>(m.number(0.5f)),
          .speed = m.number(1),
          .mode = m.kind(PlayMode::ping_pong),
          .returning = m.truth(false),
          .turns = static_cast<std::int32_t>(m.index(0))};
}

void misuse_weight(Misuse& m, float weight) {
  m.returned(weight);
  EXPECT_GE(weight, 0);
  EXPECT_LE(weight, 1);
}

JointTransform joint_of(Misuse& m) {
  return {{m.number(1), 2, 3}, {0, 0, m.number(0), m.number(1)}, {1, m.number(1), 1}};
}

Affine map_of(Misuse& m) {
  return {{{m.number(1), 0, 0, m.number(4)}, {0, m.number(1), m.number(0), 5}, {0, 0, m.number(1), 6}}};
}

}  // namespace

std::vector<MisuseRow> rows_of_poses() {
  return {
      {"get_joint",
       [](Misuse& m) {
         JointTransform& out = m.one(JointTransform{});
         m.returned(get_joint(m.in(stage().pose), m.index(19), out));
       }},
      {"set_joint",
       [](Misuse& m) {
         const Span<SoaTransform> local = m.out(stage().pose);
         m.returned(set_joint(local, m.index(19), {}));
       }},
      {"affine_of",
       [](Misuse& m) {
         static_cast<void>(affine_of(joint_of(m)));
         m.returned_ok();
       }},
      {"compose",
       [](Misuse& m) {
         const Affine a = map_of(m), b = map_of(m);
         static_cast<void>(compose(a, b));
         m.returned_ok();
       }},
      {"invert",
       [](Misuse& m) {
         Affine& out = m.one(Affine{});
         m.returned(invert(map_of(m), out));
       }},
      {"transform_point",
       [](Misuse& m) {
         float out[3];
         transform_point(map_of(m), {m.number(1), 2, 3}, out);
         m.returned_ok();
       }},
      {"transform_direction",
       [](Misuse& m) {
         float out[3];
         transform_direction(map_of(m), {m.number(1), 2, 3}, out);
         m.returned_ok();
       }},
      {"direction_in_joint",
       [](Misuse& m) {
         float out[3] = {};
         m.returned(direction_in_joint(map_of(m), {m.number(1), 2, 3}, out));
         EXPECT_TRUE(std::isfinite(out[0] + out[1] + out[2]));
       }},
      {"soa_count", [](Misuse& m) { m.returned(static_cast<float>(soa_count(m.index(5)))); }},
      {"advance",
       [](Misuse& m) {
         Playback& playback = m.one(playback_of(m));
         const Status status = advance(playback, m.number(2), m.number(0.1f));
         m.returned(status);
         EXPECT_TRUE(status != Status::ok || std::isfinite(playback.time_s));
       }},
      {"clip_time",
       [](Misuse& m) {
         clip_time(playback_of(m));
         m.returned_ok();
       }},
      {"finished",
       [](Misuse& m) {
         (void)finished(playback_of(m), m.number(2));
         m.returned_ok();
       }},
      {"sample",
       [](Misuse& m) {
         const Span<SoaTransform> out = m.out(stage().pose);
         const Clip none;
         const Skeleton& skeleton = m.spoils("another skeleton's clip") ? stage().smaller : stage().skeleton;
         const float time_s = m.spoils("a time that is no number") ? NAN : m.number(0.5f);
         m.returned(sample(skeleton, m.either(stage().clip, none), time_s, out, sampled_joints(m)));
       }},
      {"sample_cache_bytes", [](Misuse& m) { m.returned(static_cast<float>(sample_cache_bytes(stage().clip))); }},
      {"sample_cached",
       [](Misuse& m) {
         const Span<SoaTransform> out = m.out(stage().pose);
         const std::vector<SoaTransform> frames(8);
         const Span<const SoaTransform> memory = m.in(frames, Length::any);
         SampleCache cache;
         cache.memory = {reinterpret_cast<std::byte*>(const_cast<SoaTransform*>(memory.data)),
                         memory.size * sizeof(SoaTransform)};
         const Clip none;
         m.returned(sample_cached(skeleton_of(m), m.either(stage().clip, none), m.number(0.5f), out, cache));
       }},
      {"sample_additive",
       [](Misuse& m) {
         Clip additive = stage().clip;
         additive.additive = m.truth(true);
         const Span<AdditiveTransform> out = m.out<AdditiveTransform>(stage().pose.size());
         m.returned(sample_additive(skeleton_of(m), additive, m.number(0.5f), out));
       }},
      {"blend",
       [](Misuse& m) {
         const std::vector<BlendLayer> layers = blended(m);
         const Span<SoaTransform> out = m.out(stage().pose);
         m.returned(blend(skeleton_of(m), layers, out, m.number(kRestThreshold)));
       }},
      {"overlay",
       [](Misuse& m) {
         const std::vector<float> mask(stage().pose.size() * 4, 0.5f);
         const BlendLayer layer{m.in(stage().other), m.number(0.5f), m.in(mask, Length::exact_or_none)};
         const Span<SoaTransform> out = m.out(stage().pose);
         m.returned(overlay(skeleton_of(m), layer, out));
       }},
      {"overlay_in_model_space",
       [](Misuse& m) {
         const std::vector<float> mask(stage().pose.size() * 4, 0.5f);
         const BlendLayer layer{m.in(stage().other), m.number(0.5f), m.in(mask, Length::exact_or_none)};
         const Span<SoaTransform> out = m.out(stage().pose);
         m.returned(overlay_in_model_space(skeleton_of(m), layer, out, m.out<Affine>(stage().skeleton.joint_count)));
       }},
      {"mask_below",
       [](Misuse& m) {
         const Span<float> mask = m.out<float>(stage().pose.size() * 4);
         m.returned(mask_below(skeleton_of(m), m.index(2), m.index(1), mask));
       }},
      {"make_additive",
       [](Misuse& m) {
         const Span<AdditiveTransform> out = m.out<AdditiveTransform>(stage().pose.size());
         m.returned(make_additive(skeleton_of(m), m.in(stage().pose), m.in(stage().other), out));
       }},
      {"add",
       [](Misuse& m) {
         const std::vector<float> mask(stage().pose.size() * 4, 0.5f);
         const AdditiveLayer layer{m.in(change()), m.number(0.5f), m.in(mask, Length::exact_or_none)};
         m.returned(add(skeleton_of(m), layer, m.out(stage().pose)));
       }},
      {"fade_weight",
       [](Misuse& m) { misuse_weight(m, fade_weight(m.kind(Fade::smootherstep), m.number(0.25f), m.number(1))); }},
      {"cross_fade",
       [](Misuse& m) {
         const Span<SoaTransform> out = m.out(stage().pose);
         m.returned(cross_fade(skeleton_of(m), m.in(stage().pose), m.in(stage().other), m.number(0.5f), out));
       }},
      {"begin_inertia",
       [](Misuse& m) {
         Inertia inertia{m.out<InertialOffset>(stage().pose.size()), m.number(0)};
         const InertialStart start{m.in(stage().pose), m.in(stage().pose), m.in(stage().other),
                                   m.in(stage().other, Length::exact_or_none), m.number(0.02f)};
         m.returned(begin_inertia(skeleton_of(m), start, m.number(0.5f), inertia));
       }},
      {"apply_inertia",
       [](Misuse& m) {
         Inertia inertia;
         const std::vector<InertialOffset> good = offsets(inertia);
         const Span<const InertialOffset> given = m.in(good);
         inertia.offsets = {const_cast<InertialOffset*>(given.data), given.size};
         inertia.duration_s = m.number(inertia.duration_s);
         const Span<SoaTransform> pose = m.out(stage().pose);
         m.returned(apply_inertia(skeleton_of(m), inertia, m.number(0.1f), pose));
       }},
      {"local_to_model",
       [](Misuse& m) {
         const Span<Affine> out = m.out<Affine>(stage().joints.size());
         m.returned(local_to_model(skeleton_of(m), m.in(stage().pose), out));
       }},
      {"local_to_model_first",
       [](Misuse& m) {
         const Span<Affine> out = m.out<Affine>(10);
         const std::vector<SoaTransform> first(stage().pose.begin(), stage().pose.begin() + 3);
         m.returned(local_to_model_first(skeleton_of(m), m.in(first), m.index(10), out));
       }},
      {"local_to_model_below",
       [](Misuse& m) {
         const Span<Affine> out = m.out(stage().joints);
         m.returned(local_to_model_below(skeleton_of(m), m.in(stage().pose), m.index(2), out));
       }},
  };
}

}  // namespace marrow::test
