// One instance of a crowd: seconds → ticks and shares, and where its joints are.
#include <cstring>

#include "gles3/crowd/crowd.h"
#include "math/affine.h"

namespace marrow::gles3 {
namespace {

constexpr double kTicksPerSecond = 16384;
constexpr double kFarthestTime = 0x1p40;
constexpr std::int64_t kWhole = std::int64_t{1} << 48;  // of a clip, in units of a rate

std::int64_t rounded(double x) {
  return static_cast<std::int64_t>(x < 0 ? x - 0.5 : x + 0.5);
}

double clamped(double x, double least, double most) {
  return x < least ? least : x > most ? most : x;
}

std::int32_t limited(std::int64_t ticks) {
  return ticks > INT32_MAX ? INT32_MAX : static_cast<std::int32_t>(ticks);
}

BadCall check_play(const CrowdFrames& frames, const CrowdPlay& play) {
  MARROW_CHECK(play.clip < frames.clips.size);
  MARROW_CHECK(is_finite(double{play.phase_s}) && is_finite(double{play.speed}));
  MARROW_CHECK(has_ticks(play.start_s));
  return {};
}

// The share of a clip at which a play starts.
std::uint32_t phase_of(const CrowdClip& clip, const CrowdPlay& play) {
  if (!(clip.duration_s > 0)) return 0;
  double share = double{play.phase_s} / double{clip.duration_s};
  if (clip.loops) {
    if (!(share > -0x1p52 && share < 0x1p52)) return 0;  // beyond any fraction
    share -= static_cast<double>(static_cast<std::int64_t>(share));
  } else {
    share = clamped(share, 0, 1 - 0x1p-32);
  }
  return static_cast<std::uint32_t>(rounded(share * 0x1p32));
}

void set_play(const CrowdClip& clip, const CrowdPlay& play, CrowdClockwork& work, CrowdRange& range) {
  work.start = ticks_of(play.start_s);
  work.phase = phase_of(clip, play);
  const bool moves = clip.duration_s > 0;
  // Beyond 2¹⁴ rounds a tick nothing can be seen; the product below stays far from overflow.
  const double rounds = moves ? double{play.speed} / double{clip.duration_s} / kTicksPerSecond : 0;
  const std::int64_t rate = rounded(clamped(rounds, -0x1p14, 0x1p14) * 0x1p48);
  work.rate_high = static_cast<std::uint32_t>(rate >> 16);
  work.rate_low_steps = static_cast<std::uint32_t>(rate & 0xFFFF) | clip.steps << 16;
  range.first_frame = clip.first_frame;
  range.least = INT32_MIN;
  range.most = INT32_MAX;
  if (clip.loops || rate == 0) return;
  // Ticks to either end; just before the last frame, as that is a whole round and so 0 again.
  const std::int64_t behind = std::int64_t{work.phase} << 16, ahead = kWhole - 1 - behind;
  const std::int64_t speed = rate < 0 ? -rate : rate;
  range.least = -limited((rate < 0 ? ahead : behind) / speed);
  range.most = limited((rate < 0 ? behind : ahead) / speed);
}

// Frame and share of the way to the next, 16 bits of it. The text of crowd.frag, line by line.
void place_of(const CrowdClockwork& work, const CrowdRange& range, std::uint32_t now, std::uint32_t& frame,
              float& share) {
  auto passed = static_cast<std::int32_t>(now - work.start);
  passed = passed < range.least ? range.least : passed > range.most ? range.most : passed;
  const auto ticks = static_cast<std::uint32_t>(passed);
  const std::uint32_t low = work.rate_low_steps & 0xFFFF, steps = work.rate_low_steps >> 16;
  const std::uint32_t place = work.phase + work.rate_high * ticks + low * static_cast<std::uint32_t>(passed >> 16) +
                              (low * (ticks & 0xFFFF) >> 16);
  const std::uint32_t at = (place >> 16) * steps + ((place & 0xFFFF) * steps >> 16);
  frame = range.first_frame + (at >> 16);
  share = static_cast<float>(at & 0xFFFF) * (1.0f / 65536);
}

f32x4 row_of(const CrowdFrames& frames, const CrowdShares& at, std::uint32_t joint, std::uint32_t row) {
  f32x4 sum = splat(0);
  for (int i = 0; i < 4; ++i) {
    if (at.shares[i] == 0) continue;
    const Affine& matrix = frames.character_from_joint[std::size_t{at.frames[i]} * frames.joint_count + joint];
    sum = sum + splat(at.shares[i]) * load_aligned(matrix.rows[row]);
  }
  return sum;
}

// What crowd_joint() and crowd_pose() have in common.
BadCall check_moment(const CrowdFrames& frames, const CrowdInstance& instance, double time_s) {
  MARROW_CHECK(has_ticks(time_s));
  const BadCall bad = check_frames(frames);
  return bad ? bad : check_instance(frames, instance);
}

void place(const CrowdFrames& frames, const CrowdShares& at, const Affine& world_from_model, std::uint32_t joint,
           Affine& out) {
  multiply(world_from_model, row_of(frames, at, joint, 0), row_of(frames, at, joint, 1), row_of(frames, at, joint, 2),
           out);
}

}  // namespace

bool has_ticks(double time_s) {
  return time_s > -kFarthestTime && time_s < kFarthestTime;
}

std::uint32_t ticks_of(double time_s) {
  return static_cast<std::uint32_t>(rounded(time_s * kTicksPerSecond));
}

BadCall check_frames(const CrowdFrames& frames) {
  MARROW_CHECK(holds(frames.clips));
  for (const CrowdClip& clip : frames.clips) {
    MARROW_CHECK(clip.steps > 0 && clip.steps <= 0xFFFF);
    MARROW_CHECK(clip.first_frame < frames.frame_count && clip.steps < frames.frame_count - clip.first_frame);
  }
  MARROW_CHECK(frames.character_from_joint.size >= std::uint64_t{frames.frame_count} * frames.joint_count &&
               holds(frames.character_from_joint));
  return {};
}

BadCall check_instance(const CrowdFrames& frames, const CrowdInstance& instance) {
  for (const float x : instance.colour) MARROW_CHECK(is_finite(double{x}) && "the colour");
  for (const auto& row : instance.world_from_model.rows)
    for (const float x : row) MARROW_CHECK(x >= -1e12f && x <= 1e12f && "world_from_model");
  const BadCall bad = check_play(frames, instance.a);
  if (bad || instance.b.clip == kNoClip) return bad;
  MARROW_CHECK(is_finite(double{instance.blend_s}) && instance.blend_s >= 0);
  MARROW_CHECK(has_ticks(instance.blend_start_s));
  return check_play(frames, instance.b);
}

CrowdRecord record_of(const CrowdFrames& frames, const CrowdInstance& instance) {
  CrowdRecord out;
  out.world_from_model = instance.world_from_model;
  std::memcpy(out.colour, instance.colour, sizeof(out.colour));
  set_play(frames.clips[instance.a.clip], instance.a, out.a, out.range_a);
  out.b = out.a;
  out.range_b = out.range_a;
  out.blend_start = 0;
  out.blend_rate = 0;
  if (instance.b.clip == kNoClip) return out;
  set_play(frames.clips[instance.b.clip], instance.b, out.b, out.range_b);
  out.blend_start = ticks_of(instance.blend_start_s);
  const double ticks = double{instance.blend_s} * kTicksPerSecond;
  if (ticks < 1) --out.blend_start;  // all of it at the start already
  out.blend_rate = ticks < 1 ? 1.0f : static_cast<float>(1 / ticks);
  return out;
}

CrowdShares shares_of(const CrowdRecord& record, std::uint32_t now) {
  const float passed = static_cast<float>(static_cast<std::int32_t>(now - record.blend_start)) * record.blend_rate;
  const float blend = passed < 0 ? 0 : passed > 1 ? 1 : passed;
  float a, b;
  CrowdShares out;
  place_of(record.a, record.range_a, now, out.frames[0], a);
  place_of(record.b, record.range_b, now, out.frames[2], b);
  out.frames[1] = out.frames[0] + 1;
  out.frames[3] = out.frames[2] + 1;
  out.shares[0] = (1 - blend) * (1 - a);
  out.shares[1] = (1 - blend) * a;
  out.shares[2] = blend * (1 - b);
  out.shares[3] = blend * b;
  return out;
}

Status crowd_joint(const CrowdFrames& frames, const CrowdInstance& instance, double time_s, std::uint32_t joint,
                   Affine& model_from_joint) {
  MARROW_REQUIRE(joint < frames.joint_count);
  MARROW_REQUIRE_GOOD(check_moment(frames, instance, time_s));
  const CrowdShares at = shares_of(record_of(frames, instance), ticks_of(time_s));
  place(frames, at, instance.world_from_model, joint, model_from_joint);
  return Status::ok;
}

Status crowd_pose(const CrowdFrames& frames, const CrowdInstance& instance, double time_s,
                  Span<Affine> model_from_joint) {
  MARROW_REQUIRE(holds(model_from_joint, frames.joint_count));
  MARROW_REQUIRE_GOOD(check_moment(frames, instance, time_s));
  const CrowdShares at = shares_of(record_of(frames, instance), ticks_of(time_s));
  for (std::uint32_t joint = 0; joint < frames.joint_count; ++joint)
    place(frames, at, instance.world_from_model, joint, model_from_joint[joint]);
  return Status::ok;
}

}  // namespace marrow::gles3
