// The two parts of a BVH file: joints, where they rest and what of them moves; and a number a channel and frame.
#include "cook/bvh/read_bvh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "asset/format.h"
#include "common/elementary.h"
#include "cook/bvh/bvh_words.h"
#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/scene_files.h"
#include "marrow/file.h"
#include "text/safe_name.h"

namespace marrow::cook {
namespace {

using namespace bvh;

// One number a frame.
struct BvhChannel {
  bool is_rotation = false;  // degrees about the axis; else a place along it
  int axis = 0;              // x, y, z
};

struct BvhJoint {
  std::string name;
  int parent = -1;  // index, always less than the joint's own
  bool is_end = false;
  glm::dvec3 offset{0};              // from the parent, at rest
  std::vector<BvhChannel> channels;  // at most 6, each once, in the file's order
};

struct BvhHierarchy {
  std::vector<BvhJoint> joints;             // in the file's order; End Sites among them, called NAME_end
  std::vector<std::size_t> channel_joints;  // joints with channels, in the order of their numbers in a frame
  std::size_t channel_count = 0;
};

constexpr std::size_t kDeepest = 1024;
constexpr std::uint32_t kMostChannels = 6;

class HierarchyReader {
 public:
  HierarchyReader(Words& words, gltf::Report& report) : words_(words), report_(report) {}

  BvhHierarchy read() {
    words_.expect("HIERARCHY", "a BVH file");
    while (words_.take("ROOT")) {
      begin_joint();
      while (!open_.empty()) read_member();
    }
    if (out_.joints.empty()) words_.fail_expected("\"ROOT\"");
    words_.expect("MOTION", "the hierarchy before it");
    if (out_.channel_count == 0) words_.fail("no joint has channels", "nothing would move; export with the motion");
    return std::move(out_);
  }

 private:
  // A joint that is not closed yet.
  struct Open {
    std::size_t joint, line;
    glm::dvec3 place;  // of the parent at rest, then its own
    bool has_offset = false, has_channels = false;
  };

  std::string of_open() const { return "the joint that begins in " + line_text(open_.back().line); }

  // Behind ROOT or JOINT.
  void begin_joint() {
    const std::size_t line = words_.line_of_last();
    const std::string_view given = words_.rest_of_line();
    if (given.empty()) words_.fail(line, "a joint without a name", "write one behind ROOT or JOINT");
    std::string name = tools::safe_name(given);
    if (name != given)
      report_.warn(line_text(line), "name-cleaned", "unfit to print or to name a file; now \"" + name + '"');
    const auto [other, is_new] = line_of_name_.try_emplace(name, line);
    if (!is_new)
      words_.fail(line, "a second joint of one name",
                  '"' + name + "\" is the joint of " + line_text(other->second) + " too; rename one");
    if (line_of_name_.size() > kMaxJoints)
      report_.unsupported(line_text(line), "too many joints", "the most is " + std::to_string(kMaxJoints));
    begin(std::move(name), false, line);
  }

  // Behind End.
  void begin_end() {
    const std::size_t line = words_.line_of_last();
    words_.expect("Site", "the end of a joint");
    words_.rest_of_line();  // some exporters name it
    const BvhJoint& of = out_.joints[open_.back().joint];
    if (of.is_end) words_.fail(line, "an End Site in an End Site", "only joints have them; export again");
    if (out_.joints.size() >= 2 * std::size_t{kMaxJoints})
      report_.unsupported(line_text(line), "too many End Sites", "one a joint is enough");
    begin(of.name + "_end", true, line);
  }

  void begin(std::string name, bool is_end, std::size_t line) {
    if (open_.size() >= kDeepest)
      report_.unsupported(line_text(line), "joints nested too deeply",
                          "at most " + std::to_string(kDeepest) + " hang on one another");
    BvhJoint& joint = out_.joints.emplace_back();
    joint.name = std::move(name);
    joint.parent = open_.empty() ? -1 : static_cast<int>(open_.back().joint);
    joint.is_end = is_end;
    open_.push_back({out_.joints.size() - 1, line, open_.empty() ? glm::dvec3(0) : open_.back().place});
    words_.expect("{", of_open());
  }

  void read_member() {
    const bool is_end = out_.joints[open_.back().joint].is_end;
    if (words_.take("OFFSET")) {
      read_offset();
    } else if (!is_end && words_.take("CHANNELS")) {
      read_channels();
    } else if (!is_end && words_.take("JOINT")) {
      expect_offset();
      begin_joint();
    } else if (!is_end && words_.take("End")) {
      expect_offset();
      begin_end();
    } else if (words_.take("}")) {
      expect_offset();
      open_.pop_back();
    } else {
      words_.fail_expected("a part or the \"}\" of " + of_open());
    }
  }

  void expect_offset() const {
    if (!open_.back().has_offset)
      words_.fail(open_.back().line, "a joint without OFFSET", "write one in front of what hangs on it");
  }

  void read_offset() {
    const std::size_t line = words_.line_of_last();
    Open& open = open_.back();
    if (open.has_offset) words_.fail(line, "a second OFFSET", "leave one in " + of_open());
    open.has_offset = true;
    glm::dvec3& offset = out_.joints[open.joint].offset;
    for (int axis = 0; axis < 3; ++axis) offset[axis] = words_.number("an offset");
    open.place += offset;
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(open.place[axis]) <= double{format::kFarthest}))
        words_.fail(line, "stands beyond 1e12", "with the joints above; export again");
  }

  void read_channels() {
    const std::size_t line = words_.line_of_last();
    Open& open = open_.back();
    if (open.has_channels) words_.fail(line, "a second CHANNELS", "leave one in " + of_open());
    open.has_channels = true;
    const std::uint32_t count = words_.whole_number("how many channels there are");
    if (count > kMostChannels)
      words_.fail(line, std::to_string(count) + " channels of one joint", "at most 6: positions and rotations");
    std::vector<BvhChannel>& channels = out_.joints[open.joint].channels;
    for (std::uint32_t i = 0; i < count; ++i) channels.push_back(read_channel(channels, count));
    if (count == 0) return;
    out_.channel_joints.push_back(open.joint);
    out_.channel_count += count;
  }

  BvhChannel read_channel(const std::vector<BvhChannel>& before, std::uint32_t count) {
    for (const bool is_rotation : {true, false})
      for (int axis = 0; axis < 3; ++axis) {
        const std::string name = std::string(1, "XYZ"[axis]) + (is_rotation ? "rotation" : "position");
        if (!words_.take(name)) continue;
        for (const BvhChannel& other : before)
          if (other.is_rotation == is_rotation && other.axis == axis)
            words_.fail(words_.line_of_last(), name + " twice", "a joint has each channel once");
        return {is_rotation, axis};
      }
    words_.fail_expected("a channel such as Xrotation, one of " + std::to_string(count) + ',');
  }

  Words& words_;
  gltf::Report& report_;
  BvhHierarchy out_;
  std::vector<Open> open_;
  std::map<std::string, std::size_t> line_of_name_;
};

// Reads up to the word MOTION. Throws tools::Failure: invalid; unsupported for too many joints.
BvhHierarchy read_hierarchy(Words& words, gltf::Report& report) {
  return HierarchyReader(words, report).read();
}

// The second part: a number a channel and frame, which become keys.
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

// A rotation of every joint that has channels, and a translation of those with positions, at every frame, linear.
// Rotations are composed in the channels' order, each about the axes that those before it have turned; a position takes
// the place of the OFFSET. Throws tools::Failure: invalid; unsupported for clips of more than a day.
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

RawScene read_scene(const std::string& name, std::span<const std::byte> bytes, gltf::Report& report) {
  Words words({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, report);
  const BvhHierarchy hierarchy = read_hierarchy(words, report);
  RawScene scene;
  scene.source = name;
  scene.source_bytes = bytes.size();
  scene.is_capture = true;
  RawSkin& skin = scene.skins.emplace_back();
  for (const BvhJoint& joint : hierarchy.joints) {
    if (!joint.is_end) skin.joints.push_back(static_cast<int>(scene.nodes.size()));
    RawNode& node = scene.nodes.emplace_back();
    node.name = joint.name;
    node.parent = joint.parent;
    node.translation = joint.offset;
  }
  skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
  scene.clips.push_back(read_motion(words, hierarchy, report));
  scene.clips.back().name = tools::safe_name(std::filesystem::path(name).stem().string());
  scene.warnings = report.take_warnings();
  scene.reads = report.take_reads();
  return scene;
}

}  // namespace

RawScene read_bvh(const std::string& name, Files& files) {
  gltf::Report report(name);
  const std::vector<std::byte> bytes = gltf::read_scene_file(files, name, kMostBytes + 1, "", report);
  return read_scene(name, bytes, report);
}

RawScene read_bvh(const std::string& name, std::span<const std::byte> bytes) {
  gltf::Report report(name);
  return read_scene(name, bytes, report);
}

}  // namespace marrow::cook
