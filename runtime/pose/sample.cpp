#include "marrow/sample.h"

#include <cstring>

#include "asset/format.h"
#include "core/builtins.h"
#include "core/check.h"
#include "core/mark.h"
#include "core/off_boundary.h"
#include "marrow/blend.h"
#include "math/keys.h"
#include "math/slerp.h"
#include "pose/fits.h"
#include "pose/sample_coded.h"

namespace marrow {
namespace {

constexpr std::uint32_t kNoFrame = 0xFFFFFFFF;

// n: 3 or 4 values a key.
void linear(const Track& track, const Moment& m, const float* keys, int n, float* out) {
  const float* const a = keys + m.key * static_cast<std::size_t>(n);
  const float* const b = track.key_count > 1 ? a + n : a;
  SlerpWeights<float> w = {1.0f - m.u, m.u};
  if (track.path == TrackPath::rotation) {
    float chord_squared = 0.0f;
    for (int i = 0; i < 4; ++i) chord_squared += (b[i] - a[i]) * (b[i] - a[i]);
    w = slerp_weights(chord_squared, m.u);
  }
  for (int i = 0; i < n; ++i) out[i] = w.a * a[i] + w.b * b[i];
}

// A key holds in-tangent, value, out-tangent; tangents are per second.
HermiteWeights weights_at(const Moment& m) {
  HermiteWeights w = hermite_weights(m.u);
  w.leave *= m.span_s;
  w.arrive *= m.span_s;
  return w;
}

void cubic_spline(const Track& track, const Moment& m, const float* keys, int n, float* out) {
  const float* const a = keys + m.key * static_cast<std::size_t>(3 * n);
  const float* const b = track.key_count > 1 ? a + 3 * n : a;
  const HermiteWeights w = weights_at(m);
  for (int i = 0; i < n; ++i) out[i] = w.from * a[n + i] + w.leave * a[2 * n + i] + w.to * b[n + i] + w.arrive * b[i];
  if (track.path != TrackPath::rotation) return;
  const float squared = out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3];
  const float inverse = squared > 0.0f ? 1.0f / square_root(squared) : 0.0f;
  for (int i = 0; i < 4; ++i) out[i] *= inverse;
}

void sample_track(const Clip& clip, const Track& track, const Moment& m, SoaTransform* out) {
  const float* const keys = clip.values + track.first_value;
  const int n = track.path == TrackPath::rotation ? 4 : 3;
  float value[4];
  switch (track.interpolation) {
    case Interpolation::step: {
      const std::size_t key = m.key + (m.u >= 1.0f ? 1 : 0);
      std::memcpy(value, keys + key * static_cast<std::size_t>(n), sizeof(float) * static_cast<std::size_t>(n));
      break;
    }
    case Interpolation::linear:
      linear(track, m, keys, n, value);
      break;
    case Interpolation::cubic_spline:
      cubic_spline(track, m, keys, n, value);
      break;
  }
  SoaTransform& four = out[track.joint / 4];
  float(*const lanes)[4] = track.path == TrackPath::translation ? four.translation
                           : track.path == TrackPath::rotation  ? four.rotation
                                                                : four.scale;
  for (int i = 0; i < n; ++i) lanes[i][track.joint % 4] = value[i];
}

bool wanted(const SampleOptions& options, std::uint32_t joint) {
  return options.joints.empty() || (options.joints[joint / 32] >> (joint % 32) & 1u) != 0;
}

float channel_value(const Channel& channel, const Moment& m, const float* keys) {
  const std::size_t next = channel.key_count > 1 ? m.key + 1 : m.key;
  switch (channel.interpolation) {
    case Interpolation::step:
      return keys[m.u >= 1.0f ? next : m.key];
    case Interpolation::linear:
      return (1.0f - m.u) * keys[m.key] + m.u * keys[next];
    case Interpolation::cubic_spline: {
      const float *const a = keys + 3 * m.key, *const b = keys + 3 * next;
      const HermiteWeights w = weights_at(m);
      return w.from * a[1] + w.leave * a[2] + w.to * b[1] + w.arrive * b[0];
    }
  }
  return channel.rest;
}

// Finds the moment of a time in list after list; one search serves neighbours that share theirs.
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

// Which clip this is, of which skeleton and for which memory. A clip that was made by hand is known by its place.
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

// Whether the cache holds of this clip what does not move; else from now on it is this clip's.
bool is_of(SampleCache& cache, const Skeleton& skeleton, const Clip& clip, const SoaTransform* out) {
  const std::uint64_t id = identity(skeleton, clip, cache.memory);
  if (cache.out == out && cache.clip == id) return true;
  cache.room = clip.coded.frame_count != 0 &&
               cache.memory.size / sizeof(FramePair) >= frame_pairs(clip.coded, skeleton.soa_size());
  cache.out = out;
  cache.clip = id;
  cache.frame = kNoFrame;
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

// is_still, cache: as for sample_coded.
void sample_pose(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
                 const SampleOptions& options, bool is_still, SampleCache* cache) {
  if (clip.coded.frame_count != 0) {
    sample_coded(skeleton, clip.coded, time_s, options, out.data, is_still, cache);
  } else if (!is_still) {
    for (std::size_t g = 0; g < skeleton.soa_size(); ++g)
      copy_lanes(skeleton.rest[g], wanted_lanes(options, g), out[g]);
  }
  MomentFinder moment(clip, time_s);
  for (const Track& track : clip.tracks)
    if (wanted(options, track.joint)) sample_track(clip, track, moment.in(track.first_time, track.key_count), out.data);
}

}  // namespace

Status sample(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
              const SampleOptions& options) {
  MARROW_MARK;
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
  MARROW_MARK;
  MARROW_REQUIRE(!clip.additive);
  MARROW_REQUIRE(holds(cache.memory));
  MARROW_REQUIRE_GOOD(check_boundary(cache.memory.data));
  MARROW_REQUIRE_GOOD(check_pose(skeleton, clip, time_s, out, {}));
  sample_pose(skeleton, clip, time_s, out, {}, is_of(cache, skeleton, clip, out.data), &cache);
  return Status::ok;
}

Status sample_additive(const Skeleton& skeleton, const Clip& clip, float time_s, Span<AdditiveTransform> out) {
  MARROW_MARK;
  MARROW_REQUIRE(clip.additive);
  MARROW_REQUIRE(clip.reference == nullptr || clip.joint_count == skeleton.joint_count);
  // The pose stands where its change will; make_additive reads every group before it writes it.
  const Span<SoaTransform> pose{reinterpret_cast<SoaTransform*>(out.data), out.size};
  MARROW_REQUIRE_GOOD(check_pose(skeleton, clip, time_s, pose, {}));
  sample_pose(skeleton, clip, time_s, pose, {}, false, nullptr);
  const SoaTransform* const reference = clip.reference != nullptr ? clip.reference : skeleton.rest;
  return make_additive(skeleton, pose, {reference, skeleton.soa_size()}, out);
}

Status sample_channels(const Clip& clip, float time_s, Span<float> out) {
  MARROW_MARK;
  MARROW_REQUIRE(holds(out, clip.channels.size));
  MARROW_REQUIRE(time_s == time_s);
  MomentFinder moment(clip, time_s);
  for (std::size_t i = 0; i < clip.channels.size; ++i) {
    const Channel& channel = clip.channels[i];
    out[i] =
        channel_value(channel, moment.in(channel.first_time, channel.key_count), clip.values + channel.first_value);
  }
  return Status::ok;
}

}  // namespace marrow
