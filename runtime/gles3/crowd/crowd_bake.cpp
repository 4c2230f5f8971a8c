// Clips → frames: matrices at even steps of time, loops closed.
#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "gles3/crowd/crowd.h"
#include "marrow/local_to_model.h"
#include "marrow/sample.h"
#include "pose/fits.h"

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kMaxSteps = 0xFFFF;

// A whole number, at least the rate but for rounding; 0: too many, or no number.
std::uint32_t steps_of(float duration_s, float rate_hz) {
  const double steps = double{duration_s} * double{rate_hz};
  if (!(steps >= 0 && steps <= kMaxSteps)) return 0;
  const auto whole = static_cast<std::uint32_t>(steps + 0.999);
  return whole == 0 ? 1 : whole < kMaxSteps ? whole : kMaxSteps;
}

bool is_plan(const CrowdSource& source, const CrowdClip& clip, std::uint32_t first_frame) {
  return clip.first_frame == first_frame && clip.steps >= 1 && clip.steps <= kMaxSteps && clip.loops == source.loops &&
         clip.duration_s == source.clip.duration_s;
}

}  // namespace

Status plan_crowd(Span<const CrowdSource> sources, float rate_hz, Span<CrowdClip> out, std::uint32_t& frame_count) {
  MARROW_REQUIRE(holds(sources, 1) && holds(out, sources.size));
  MARROW_REQUIRE(rate_hz > 0 && rate_hz - rate_hz == 0);
  std::uint64_t frames = 0;
  for (const CrowdSource& source : sources) {
    MARROW_REQUIRE(!source.clip.additive);
    const std::uint32_t steps = steps_of(source.clip.duration_s, rate_hz);
    if (steps == 0) return Status::unsupported;
    frames += steps + 1;
  }
  if (frames > kMaxCrowdFrames) return Status::unsupported;
  frame_count = 0;
  for (std::size_t i = 0; i < sources.size; ++i) {
    const float duration_s = sources[i].clip.duration_s;
    out[i] = {duration_s, frame_count, steps_of(duration_s, rate_hz), sources[i].loops};
    frame_count += out[i].steps + 1;
  }
  return Status::ok;
}

Status bake_crowd(const Skeleton& skeleton, Span<const CrowdSource> sources, Span<const CrowdClip> clips,
                  Span<SoaTransform> scratch, Span<Affine> matrices, CrowdFrames& out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(sources, 1) && holds(clips, sources.size));
  MARROW_REQUIRE(holds(scratch, skeleton.soa_size()));
  std::uint64_t frames = 0;
  for (std::size_t i = 0; i < sources.size; ++i) {
    MARROW_REQUIRE(is_plan(sources[i], clips[i], static_cast<std::uint32_t>(frames)));
    MARROW_REQUIRE(!sources[i].clip.additive && fits(sources[i].clip, skeleton));
    frames += clips[i].steps + 1;
    MARROW_REQUIRE(frames <= kMaxCrowdFrames);
  }
  MARROW_REQUIRE(skeleton.joint_count > 0 && matrices.size / skeleton.joint_count >= frames && holds(matrices));
  for (std::size_t i = 0; i < sources.size; ++i) {
    const CrowdClip& clip = clips[i];
    Affine* const first = matrices.data + std::size_t{clip.first_frame} * skeleton.joint_count;
    for (std::uint32_t step = 0; step <= clip.steps; ++step) {
      const Span<Affine> frame(first + std::size_t{step} * skeleton.joint_count, skeleton.joint_count);
      if (clip.loops && step == clip.steps) {
        std::memcpy(frame.data, first, frame.size * sizeof(Affine));
        continue;
      }
      const double time_s = double{clip.duration_s} * step / clip.steps;
      Status status = sample(skeleton, sources[i].clip, static_cast<float>(time_s), scratch);
      if (status == Status::ok) status = local_to_model(skeleton, scratch, frame);
      if (status != Status::ok) return status;
    }
  }
  out.clips = {clips.data, sources.size};
  out.character_from_joint = matrices;
  out.joint_count = skeleton.joint_count;
  out.frame_count = static_cast<std::uint32_t>(frames);
  return Status::ok;
}

}  // namespace marrow::gles3
