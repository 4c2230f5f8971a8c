#include "marrow/sample.h"

#include <cstring>

#include "asset/format.h"
#include "core/check.h"
#include "math/slerp.h"
#include "pose/sample_coded.h"

namespace marrow {
namespace {

// Where a time falls in a list of key times.
struct Moment {
  std::uint32_t key;  // the last key at or before the time, and never the last of all unless it is the only one
  float u;            // 0 … 1 on the way to the next key
  float span_s;       // to the next key; 0 outside the list
};

Moment find(const float* times_s, std::uint32_t count, float time_s) {
  if (count == 1 || !(times_s[0] < time_s)) return {0, 0.0f, 0.0f};
  if (!(time_s < times_s[count - 1])) return {count - 2, 1.0f, 0.0f};
  std::uint32_t low = 0, high = count - 1;  // times[low] ≤ time < times[high]
  while (high - low > 1) {
    const std::uint32_t middle = (low + high) / 2;
    if (time_s < times_s[middle]) {
      high = middle;
    } else {
      low = middle;
    }
  }
  const float span_s = times_s[high] - times_s[low];
  return {low, (time_s - times_s[low]) / span_s, span_s};
}

// The values of one key, or of two keys blended; n = 3 or 4.
void mix(const float* a, const float* b, float wa, float wb, int n, float* out) {
  for (int i = 0; i < n; ++i) out[i] = wa * a[i] + wb * b[i];
}

void linear(const Track& track, const Moment& m, const float* keys, int n, float* out) {
  const float* const a = keys + m.key * static_cast<std::uint32_t>(n);
  const float* const b = track.key_count > 1 ? a + n : a;
  if (track.path != Path::rotation) return mix(a, b, 1.0f - m.u, m.u, n, out);
  float chord_squared = 0.0f;
  for (int i = 0; i < 4; ++i) chord_squared += (b[i] - a[i]) * (b[i] - a[i]);
  const SlerpWeights<float> w = slerp_weights(chord_squared, m.u);
  mix(a, b, w.a, w.b, 4, out);
}

// glTF 2.0, "Interpolation Cubic": a key holds in-tangent, value, out-tangent; tangents are per second.
void cubic_spline(const Track& track, const Moment& m, const float* keys, int n, float* out) {
  const float* const a = keys + m.key * static_cast<std::uint32_t>(3 * n);
  const float* const b = track.key_count > 1 ? a + 3 * n : a;
  const float u = m.u, u2 = u * u, u3 = u2 * u;
  const float from = 2.0f * u3 - 3.0f * u2 + 1.0f;
  const float leave = (u3 - 2.0f * u2 + u) * m.span_s;
  const float to = 3.0f * u2 - 2.0f * u3;
  const float arrive = (u3 - u2) * m.span_s;
  for (int i = 0; i < n; ++i) out[i] = from * a[n + i] + leave * a[2 * n + i] + to * b[n + i] + arrive * b[i];
  if (track.path != Path::rotation) return;
  const float squared = out[0] * out[0] + out[1] * out[1] + out[2] * out[2] + out[3] * out[3];
  const float inverse = squared > 0.0f ? 1.0f / __builtin_sqrtf(squared) : 0.0f;
  for (int i = 0; i < 4; ++i) out[i] *= inverse;
}

void sample_track(const Clip& clip, const Track& track, const Moment& m, SoaTransform* out) {
  const float* const keys = clip.values + track.first_value;
  const int n = track.path == Path::rotation ? 4 : 3;
  float value[4];
  switch (track.interpolation) {
    case Interpolation::step: {
      const std::uint32_t key = m.key + (m.u >= 1.0f ? 1u : 0u);
      std::memcpy(value, keys + key * static_cast<std::uint32_t>(n), sizeof(float) * static_cast<std::size_t>(n));
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
  float(*const lanes)[4] = track.path == Path::translation ? four.translation
                           : track.path == Path::rotation  ? four.rotation
                                                           : four.scale;
  for (int i = 0; i < n; ++i) lanes[i][track.joint % 4] = value[i];
}

bool wanted(const SampleOptions& options, std::uint32_t joint) {
  return options.joints.empty() || (options.joints[joint / 32] >> (joint % 32) & 1u) != 0;
}

}  // namespace

Status sample(const Skeleton& skeleton, const Clip& clip, float time_s, Span<SoaTransform> out,
              const SampleOptions& options) {
  MARROW_REQUIRE(out.size >= skeleton.soa_size());
  MARROW_REQUIRE(time_s == time_s);
  for (const Track& track : clip.tracks) MARROW_REQUIRE(track.joint < skeleton.joint_count);
  MARROW_REQUIRE(clip.coded.frame_count == 0 || clip.joint_count == skeleton.joint_count);
  MARROW_REQUIRE(options.joints.empty() || options.joints.size >= (std::size_t{skeleton.joint_count} + 31) / 32);
  if (clip.coded.frame_count != 0) {
    sample_coded(skeleton, clip.coded, time_s, options, out.data);
  } else if (!options.prefilled) {
    for (std::size_t g = 0; g < skeleton.soa_size(); ++g)
      copy_lanes(skeleton.rest[g], wanted_lanes(options, g), out[g]);
  }
  // Tracks that share a list of key times stand together: one search serves them all.
  Moment moment{};
  std::uint32_t list = 0, list_size = 0;
  for (const Track& track : clip.tracks) {
    if (track.first_time != list || track.key_count != list_size) {
      list = track.first_time;
      list_size = track.key_count;
      moment = find(clip.times_s + list, list_size, time_s);
    }
    if (wanted(options, track.joint)) sample_track(clip, track, moment, out.data);
  }
  return Status::ok;
}

}  // namespace marrow
