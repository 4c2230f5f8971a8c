#include "marrow/sample.h"

#include <cstring>

#include "asset/format.h"
#include "core/builtins.h"
#include "core/check.h"
#include "core/fixed.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "marrow/blend.h"
#include "math/keys.h"
#include "math/slerp.h"
#include "pose/fits.h"
#include "pose/sample_coded.h"
#include "pose/sample_state.h"

namespace marrow {
namespace {

// Tangents are per second.
HermiteWeights weights_at(const Moment& m) {
  HermiteWeights w = hermite_weights(m.u);
  w.leave *= m.span_s;
  w.arrive *= m.span_s;
  return w;
}

// n: numbers of a value; a key of a cubic spline has 3 n: in-tangent, value, out-tangent. turns: they are quaternions.
template <class Count>
void mix_keys(Interpolation interpolation, bool turns, const Moment& m, const float* keys, std::uint32_t key_count,
              Count n, float* out) {
  const std::size_t per_key = interpolation == Interpolation::cubic_spline ? 3 * std::size_t{n} : n;
  const float* const a = keys + m.key * per_key;
  const float* const b = key_count > 1 ? a + per_key : a;
  if (interpolation == Interpolation::cubic_spline) {
    const HermiteWeights w = weights_at(m);
    for (std::size_t i = 0; i < n; ++i)
      out[i] = w.from * a[n + i] + w.leave * a[2 * n + i] + w.to * b[n + i] + w.arrive * b[i];
    if (!turns) return;
    const float squared = out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3];
    // A curve through 0, or one that overflows, gives the identity: blending needs quaternions with a length.
    const bool turned = 0.0f < squared && squared < kInfinity;
    const float inverse = turned ? 1.0f / square_root(squared) : 0.0f;
    for (std::size_t i = 0; i < n; ++i) out[i] = turned ? out[i] * inverse : i == 3 ? 1.0f : 0.0f;
    return;
  }
  if (interpolation == Interpolation::step) {
    std::memcpy(out, m.u >= 1.0f ? b : a, sizeof(float) * n);
    return;
  }
  SlerpWeights<float> w = {1.0f - m.u, m.u};
  if (turns) {
    float chord_squared = 0.0f;
    for (std::size_t i = 0; i < n; ++i) chord_squared += (b[i] - a[i]) * (b[i] - a[i]);
    w = slerp_weights(chord_squared, m.u);
  }
  for (std::size_t i = 0; i < n; ++i) out[i] = w.a * a[i] + w.b * b[i];
}

void sample_track(const Clip& clip, const Track& track, const Moment& m, SoaTransform* out) {
  const float* const keys = clip.values + track.first_value;
  const bool turns = track.path == TrackPath::rotation;
  const std::size_t n = turns ? 4 : 3;
  float value[4];
  if (turns) {
    mix_keys(track.interpolation, true, m, keys, track.key_count, Fixed<std::size_t{4}>(), value);
  } else {
    mix_keys(track.interpolation, false, m, keys, track.key_count, Fixed<std::size_t{3}>(), value);
  }
  SoaTransform& four = out[track.joint / 4];
  float(*const lanes)[4] = track.path == TrackPath::translation ? four.translation : turns ? four.rotation : four.scale;
  for (std::size_t i = 0; i < n; ++i) lanes[i][track.joint % 4] = value[i];
}

bool wanted(const SampleOptions& options, std::uint32_t joint) {
  return (wanted_lanes(options, joint / 4) >> (joint % 4) & 1u) != 0;
}

// Finds a time in one list of key times after another. Consecutive tracks that share a list share the search.
class MomentFinder {
 public:
  MomentFinder(const Clip& clip, float time_s) : times_s_(clip.times_s), time_s_(time_s) {}
  const Moment& in(std::uint32_t first, std::uint32_t count) {
    if (first != first_ || count != count_) {
      first_ = first;
      count_ = count;
      moment_ = find_moment(times_s_ + first, count, time_s_);
    }
    return moment_;
  }

 private:
  const float* times_s_;
  float time_s_;
  Moment moment_{};
  std::uint32_t first_ = 0, count_ = 0;
};

constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15u;  // any with many bits

// A hash of the clip, the skeleton and the cache's memory. A clip that was made by hand is recognised by its addresses.
std::uint64_t identity(const Skeleton& skeleton, const Clip& clip, Span<std::byte> memory) {
  const auto place_of = [](const void* data) { return std::uint64_t{reinterpret_cast<std::uintptr_t>(data)}; };
  std::uint64_t out = 1;
  for (const std::uint64_t word :
       {clip.id, place_of(clip.coded.payload), place_of(clip.tracks.data), std::uint64_t{clip.coded.frame_count},
        place_of(skeleton.rest), std::uint64_t{skeleton.joint_count}, place_of(memory.data),
        std::uint64_t{memory.size}})
    out = (out ^ word) * kOdd;
  return out;
}

// Whether the cache is this clip's, so that `out` already holds what does not move. If not, it becomes this clip's.
bool is_of(SampleCache& cache, const Skeleton& skeleton, const Clip& clip, const SoaTransform* out) {
  SampleState& kept = state_of(cache);
  const std::uint64_t id = identity(skeleton, clip, cache.memory), place = reinterpret_cast<std::uintptr_t>(out);
  if (kept.out == place && kept.clip == id) return true;
  kept.room = clip.coded.frame_count != 0 &&
              cache.memory.size / sizeof(FramePair) >= frame_pairs(clip.coded, skeleton.soa_size());
  kept.out = place;
  kept.clip = id;
  kept.frame = kNoFrame;
  return false;
}

BadCall check_pose(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                   const SampleOptions& options) {
  MARROW_CHECK(holds(out, skeleton.soa_size()));
  MARROW_CHECK(time_s == time_s);
  MARROW_CHECK(fits(clip, skeleton));
  MARROW_CHECK(options.joints.empty() || holds(options.joints, (std::size_t{skeleton.joint_count} + 31) / 32));
  return {};
}

// is_still: `out` holds already what does not move. cache: as for sample_coded.
void sample_pose(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                 const SampleOptions& options, bool is_still, SampleCache* cache) {
  if (!is_still) set_still(skeleton, clip.coded, options, out.data);
  if (clip.coded.frame_count != 0) sample_coded(skeleton, clip.coded, time_s, options, out.data, cache);
  MomentFinder moment(clip, time_s);
  for (const Track& track : clip.tracks)
    if (wanted(options, track.joint)) sample_track(clip, track, moment.in(track.first_time, track.key_count), out.data);
}

}  // namespace

Status sample(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
              const SampleOptions& options) {
  MARROW_ZONE;
  MARROW_REQUIRE(!clip.additive);
  MARROW_REQUIRE_GOOD(check_pose(skeleton, clip, time_s, out, options));
  sample_pose(skeleton, clip, time_s, out, options, false, nullptr);
  return Status::ok;
}

std::size_t sample_cache_bytes(const Clip& clip) {
  const std::size_t groups = (std::size_t{clip.joint_count} + 3) / 4;
  return clip.coded.frame_count != 0 ? sizeof(FramePair) * frame_pairs(clip.coded, groups) : 0;
}

Status sample_cached(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                     SampleCache& cache) {
  MARROW_ZONE;
  MARROW_REQUIRE(!clip.additive);
  MARROW_REQUIRE(holds(cache.memory));
  MARROW_REQUIRE_GOOD(check_boundary(cache.memory.data));
  MARROW_REQUIRE_GOOD(check_pose(skeleton, clip, time_s, out, {}));
  sample_pose(skeleton, clip, time_s, out, {}, is_of(cache, skeleton, clip, out.data), &cache);
  return Status::ok;
}

Status sample_additive(const Skeleton& skeleton, const Clip& clip, float time_s, Span<AdditiveTransform> out) {
  MARROW_ZONE;
  MARROW_REQUIRE(clip.additive);
  MARROW_REQUIRE(clip.reference == nullptr || clip.joint_count == skeleton.joint_count);
  // The pose is sampled into `out`, and its change replaces it: make_additive reads every group before it writes it.
  const Span<SoaTransform> pose{reinterpret_cast<SoaTransform*>(out.data), out.size};
  MARROW_REQUIRE_GOOD(check_pose(skeleton, clip, time_s, pose, {}));
  sample_pose(skeleton, clip, time_s, pose, {}, false, nullptr);
  const SoaTransform* const reference = clip.reference != nullptr ? clip.reference : skeleton.rest;
  return make_additive(skeleton, pose, {reference, skeleton.soa_size()}, out);
}

Status sample_channels(const Clip& clip, float time_s, Span<float> out) {
  MARROW_ZONE;
  MARROW_REQUIRE(holds(out, clip.channels.size));
  MARROW_REQUIRE(time_s == time_s);
  MomentFinder moment(clip, time_s);
  for (std::size_t i = 0; i < clip.channels.size; ++i) {
    const Channel& channel = clip.channels[i];
    mix_keys(channel.interpolation, false, moment.in(channel.first_time, channel.key_count),
             clip.values + channel.first_value, channel.key_count, Fixed<std::size_t{1}>(), out.data + i);
  }
  return Status::ok;
}

}  // namespace marrow
