#include "cook/bvh/bvh_motion.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

#include "common/elementary.h"

namespace marrow::cook::bvh {
namespace {

constexpr double kLongest_s = 86'400;  // a day, as of glTF's clips
constexpr float kShortestStep_s = 1e-6F;
constexpr double kHalfDegree_rad = 3.14159265358979323846 / 360;

// Refuses more frames than the rest of the file can hold, so that nothing is reserved for numbers that are not there.
std::uint32_t read_frame_count(Words& words, std::size_t channels) {
  words.expect("Frames:", "the motion");
  const std::size_t line = words.line_of_last();
  const std::uint32_t frames = words.whole_number("the number of frames");
  if (frames == 0) words.fail(line, "no frames", "export at least one");
  if (std::uint64_t{frames} * channels > words.bytes_left() / 2 + 1)
    words.fail(line, std::to_string(frames) + " frames of " + std::to_string(channels) + " numbers",
               "only " + std::to_string(words.bytes_left()) + " bytes follow; export again, or correct the number");
  return frames;
}

std::vector<float> read_times(Words& words, std::uint32_t frames, const gltf::Report& report) {
  words.expect("Frame", "\"Frame Time:\"");
  words.expect("Time:", "\"Frame Time:\"");
  const std::size_t line = words.line_of_last();
  const double step_s = words.number("the seconds of a frame");
  if (!(step_s > 0)) words.fail(line, "a frame time that is not above 0", "give seconds, as in 0.033333");
  if (step_s * (frames - 1) > kLongest_s)
    report.unsupported(line_text(line), "a clip of more than a day", "give the frame time in seconds; split the take");
  std::vector<float> times;
  times.reserve(frames);
  for (std::uint32_t f = 0; f < frames; ++f) {
    times.push_back(static_cast<float>(step_s * f));
    if (f > 0 && !(times[f] - times[f - 1] >= kShortestStep_s))
      words.fail(line, "frames too close",
                 "frame " + std::to_string(f) + " is less than a microsecond behind the last");
  }
  return times;
}

// Which channels of a clip a joint's numbers become.
struct Targets {
  const BvhJoint* joint;
  RawChannel* rotation = nullptr;
  RawChannel* translation = nullptr;
};

RawClip empty_clip(const BvhHierarchy& hierarchy, const std::vector<float>& times) {
  RawClip clip;
  for (const std::size_t j : hierarchy.channel_joints)
    for (const bool is_rotation : {true, false}) {
      const auto same = [&](const BvhChannel& channel) { return channel.is_rotation == is_rotation; };
      if (!std::ranges::any_of(hierarchy.joints[j].channels, same)) continue;
      RawChannel& channel = clip.channels.emplace_back();
      channel.node = static_cast<int>(j);
      channel.path = is_rotation ? RawPath::rotation : RawPath::translation;
      channel.times_s = times;
      channel.values.reserve(times.size());
    }
  return clip;
}

std::vector<Targets> targets_of(const BvhHierarchy& hierarchy, RawClip& clip) {
  std::vector<Targets> out;
  std::size_t next = 0;
  for (const std::size_t j : hierarchy.channel_joints) {
    Targets& targets = out.emplace_back(Targets{&hierarchy.joints[j]});
    for (; next < clip.channels.size() && clip.channels[next].node == static_cast<int>(j); ++next)
      (clip.channels[next].path == RawPath::rotation ? targets.rotation : targets.translation) = &clip.channels[next];
  }
  return out;
}

glm::dquat turn(int axis, double angle_deg) {
  const double half_rad = std::fmod(angle_deg, 720.0) * kHalfDegree_rad;
  glm::dquat q(tools::cosine(half_rad), 0, 0, 0);
  (axis == 0 ? q.x : axis == 1 ? q.y : q.z) = tools::sine(half_rad);
  return q;
}

// With the sign that is next to the key before it.
void add_rotation(const glm::dquat& q, std::vector<glm::vec4>& keys) {
  const glm::vec4 key(glm::dvec4(q.x, q.y, q.z, q.w));
  keys.push_back(!keys.empty() && glm::dot(keys.back(), key) < 0 ? -key : key);
}

void read_frame(Words& words, const std::vector<Targets>& all, const std::string& what) {
  for (const Targets& of : all) {
    glm::dquat rotation(1, 0, 0, 0);
    glm::dvec3 place = of.joint->offset;
    for (const BvhChannel& channel : of.joint->channels) {
      const double number = words.number(what);
      if (channel.is_rotation) {
        rotation = rotation * turn(channel.axis, number);
      } else {
        place[channel.axis] = number;
      }
    }
    if (of.rotation != nullptr) add_rotation(rotation, of.rotation->values);
    if (of.translation != nullptr) of.translation->values.emplace_back(glm::vec3(place), 0.0F);
  }
}

}  // namespace

RawClip read_motion(Words& words, const BvhHierarchy& hierarchy, const gltf::Report& report) {
  const std::uint32_t frames = read_frame_count(words, hierarchy.channel_count);
  const std::vector<float> times = read_times(words, frames, report);
  const std::size_t first_line = words.words_left_on_line();
  // Where frames are a line each, this says what is wrong with all of them.
  const std::string compare = "the first line of numbers has " + std::to_string(first_line) +
                              ", the hierarchy declares " + std::to_string(hierarchy.channel_count) + " channels";
  RawClip clip = empty_clip(hierarchy, times);
  const std::vector<Targets> all = targets_of(hierarchy, clip);
  for (std::uint32_t f = 0; f < frames; ++f) {
    const std::string what = "a number of frame " + std::to_string(f + 1) + " of " + std::to_string(frames);
    read_frame(words, all, first_line == hierarchy.channel_count ? what : what + " (" + compare + ')');
  }
  if (!words.at_end())
    words.fail("more numbers than " + std::to_string(frames) + " frames need",
               compare + "; correct Frames: or export again");
  return clip;
}

}  // namespace marrow::cook::bvh
