// An animation at a time: poses of a skeleton, and weights of a mesh's morph targets.
#pragma once

#include "marrow/character.h"

namespace marrow {

// The pose of skeleton number `index`. An additive clip is laid on its reference; without a clip the skeleton rests.
// change: scratch, as many as `out`. cache: of `out`.
Status sample_animation(const Skeleton& skeleton, const Animation& animation, float time_s, std::uint32_t index,
                        Span<AdditiveTransform> change, Span<SoaTransform> out, SampleCache& cache);

// Calls f(target, its weight in the animation, its default); driven: only for targets that a channel drives.
template <class F>
Status for_each_weight(const Animation& a, float time_s, const CharacterMesh& m, bool driven, F f) {
  const std::uint32_t index = a.clip_of_skeleton[m.mesh.skeleton];
  const Clip clip = index != kNoClip ? a.clips.clip(index) : Clip{};
  Clip alone = clip;  // with one channel, so that the others need no memory
  for (std::size_t t = 0; t < m.weights.size; ++t) {
    const std::uint32_t channel = index != kNoClip ? a.channels[m.first_target + t] : kNoChannel;
    const float rest = m.mesh.targets[t].weight;
    float weight = rest;
    if (channel != kNoChannel) {
      alone.channels = {clip.channels.data + channel, 1};
      const Status status = sample_channels(alone, time_s, {&weight, 1});
      if (status != Status::ok) return status;
    } else if (driven) {
      continue;
    }
    f(t, weight, rest);
  }
  return Status::ok;
}

// Adds what an animation gives the mesh's targets, times `share`.
inline Status add_weights(const Animation& a, float time_s, float share, CharacterMesh& m) {
  return for_each_weight(a, time_s, m, false,
                         [&](std::size_t t, float weight, float) { m.weights[t] += share * weight; });
}

}  // namespace marrow
