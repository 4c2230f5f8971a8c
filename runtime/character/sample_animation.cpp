#include "character/sample_animation.h"

#include <cstring>

#include "pose/sample_state.h"

namespace marrow {
namespace {

// The pose of an additive clip: its changes, laid on their reference.
Status sample_laid_on(const Skeleton& skeleton, const Clip& clip, float time_s, Span<AdditiveTransform> change,
                      Span<SoaTransform> out) {
  const Status status = sample_additive(skeleton, clip, time_s, change);
  if (status != Status::ok) return status;
  std::memcpy(out.data, clip.reference != nullptr ? clip.reference : skeleton.rest, out.size * sizeof(SoaTransform));
  return add(skeleton, {change, 1.0f, {}}, out);
}

}  // namespace

Status sample_animation(const Skeleton& skeleton, const Animation& animation, float time_s, std::uint32_t index,
                        Span<AdditiveTransform> change, Span<SoaTransform> out, SampleCache& cache) {
  const std::uint32_t number = animation.clip_of_skeleton[index];
  const Clip clip = animation.clips.clip(number);
  if (number != kNoClip && !clip.additive) return sample_cached(skeleton, clip, time_s, out, cache);
  state_of(cache).out = 0;  // others write there
  if (number != kNoClip) return sample_laid_on(skeleton, clip, time_s, change, out);
  std::memcpy(out.data, skeleton.rest, out.size * sizeof(SoaTransform));
  return Status::ok;
}

}  // namespace marrow
