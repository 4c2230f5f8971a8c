#include "cook/bvh/bvh_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "asset/format.h"
#include "marrow/file.h"
#include "text/safe_name.h"

namespace marrow::cook::bvh {
namespace {

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

}  // namespace

BvhHierarchy read_hierarchy(Words& words, gltf::Report& report) {
  return HierarchyReader(words, report).read();
}

}  // namespace marrow::cook::bvh
