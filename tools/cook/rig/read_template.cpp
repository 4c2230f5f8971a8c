#include "cook/rig/read_template.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "common/failure.h"
#include "cook/scene/raw.h"
#include "text/deep_key.h"
#include "text/printable.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

// Of a grown person 1 high, arms between T and A.
constexpr std::string_view kHumanoid = R"(
joint = [
  {name="Hips", place=[0, 0.52, 0]},
  {name="Spine", parent="Hips", place=[0, 0.57, 0]},
  {name="Spine1", parent="Spine", place=[0, 0.64, 0]},
  {name="Spine2", parent="Spine1", place=[0, 0.71, 0]},
  {name="Neck", parent="Spine2", place=[0, 0.81, 0]},
  {name="Head", parent="Neck", place=[0, 0.87, 0], end=[0, 1, 0]},
  {name="LeftShoulder", mirror="RightShoulder", parent="Spine2", place=[0.025, 0.79, 0]},
  {name="LeftArm", mirror="RightArm", parent="LeftShoulder", place=[0.085, 0.79, 0]},
  {name="LeftForeArm", mirror="RightForeArm", parent="LeftArm", place=[0.212, 0.744, 0]},
  {name="LeftHand", mirror="RightHand", parent="LeftForeArm", place=[0.328, 0.702, 0], end=[0.432, 0.664, 0]},
  {name="LeftUpLeg", mirror="RightUpLeg", parent="Hips", place=[0.055, 0.51, 0]},
  {name="LeftLeg", mirror="RightLeg", parent="LeftUpLeg", place=[0.06, 0.285, 0.01]},
  {name="LeftFoot", mirror="RightFoot", parent="LeftLeg", place=[0.065, 0.055, -0.02]},
  {name="LeftToeBase", mirror="RightToeBase", parent="LeftFoot", place=[0.07, 0.012, 0.05], end=[0.075, 0.01, 0.10]},
]
)";

// About a fox: head to the front, tail to the back.
constexpr std::string_view kQuadruped = R"(
joint = [
  {name="Hips", place=[0, 0.66, -0.36]},
  {name="Spine", parent="Hips", place=[0, 0.68, -0.22]},
  {name="Spine1", parent="Spine", place=[0, 0.68, 0]},
  {name="Spine2", parent="Spine1", place=[0, 0.66, 0.22]},
  {name="Neck", parent="Spine2", place=[0, 0.70, 0.34]},
  {name="Head", parent="Neck", place=[0, 0.78, 0.47], end=[0, 0.70, 0.82]},
  {name="LeftArm", mirror="RightArm", parent="Spine2", place=[0.07, 0.62, 0.23]},
  {name="LeftForeArm", mirror="RightForeArm", parent="LeftArm", place=[0.09, 0.33, 0.21]},
  {name="LeftHand", mirror="RightHand", parent="LeftForeArm", place=[0.09, 0.08, 0.22], end=[0.09, 0.02, 0.27]},
  {name="LeftUpLeg", mirror="RightUpLeg", parent="Hips", place=[0.07, 0.64, -0.37]},
  {name="LeftLeg", mirror="RightLeg", parent="LeftUpLeg", place=[0.09, 0.40, -0.34]},
  {name="LeftFoot", mirror="RightFoot", parent="LeftLeg", place=[0.09, 0.20, -0.47]},
  {name="LeftToeBase", mirror="RightToeBase", parent="LeftFoot", place=[0.09, 0.03, -0.42], end=[0.09, 0.02, -0.36]},
  {name="Tail", parent="Hips", place=[0, 0.64, -0.50]},
  {name="Tail1", parent="Tail", place=[0, 0.53, -0.64]},
  {name="Tail2", parent="Tail1", place=[0, 0.42, -0.82], end=[0, 0.34, -1.05]},
]
)";

using deform::SkeletonTemplate;

constexpr std::size_t kLargestTemplate = std::size_t{64} * 1024;
constexpr double kFarthestInTemplate = 1e6;  // of a coordinate

class TemplateReader {
 public:
  explicit TemplateReader(const std::string& path) : path_(path) {}

  [[noreturn]] void fail(const std::string& where, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, path_, where, tools::printable(rule), tools::printable(advice));
  }

  SkeletonTemplate read(const toml::table& root) {
    for (const auto& [key, node] : root)
      if (key.str() != "joint")
        fail(tools::place_of(key.source()), "unknown key \"" + std::string(key.str()) + "\"",
             "a template has [[joint]]");
    const toml::array* const joints = root.get_as<toml::array>("joint");
    if (joints == nullptr || joints->empty()) fail("", "the template has no joints", "write [[joint]]");
    for (const toml::node& node : *joints) {
      const toml::table* const joint = node.as_table();
      if (joint == nullptr) fail(tools::place_of(node.source()), "a joint must be a table", "write [[joint]]");
      read_joint(*joint);
    }
    check_whole();
    return std::move(out_);
  }

 private:
  std::string name_in(const toml::table& joint, const char* key) const {
    const toml::node* const node = joint.get(key);
    if (node == nullptr) return "";
    const auto* const text = node->as_string();
    if (text == nullptr || text->get().empty())
      fail(tools::place_of(node->source()), fmt::format("\"{}\" must be a name", key), "quote it");
    return text->get();
  }

  std::optional<glm::dvec3> place_of(const toml::table& joint, const char* key) const {
    const toml::node* const node = joint.get(key);
    if (node == nullptr) return std::nullopt;
    const toml::array* const numbers = node->as_array();
    const auto refuse = [&] {
      fail(tools::place_of(node->source()), fmt::format("\"{}\" must be three numbers, none above a million", key),
           "write [x, y, z]");
    };
    if (numbers == nullptr || numbers->size() != 3) refuse();
    glm::dvec3 out(0);
    for (int i = 0; i < 3; ++i) {
      const auto number = numbers->get(static_cast<std::size_t>(i))->value<double>();
      if (!number || !(std::abs(*number) <= kFarthestInTemplate)) refuse();
      out[i] = *number;
    }
    return out;
  }

  int add(const std::string& where, const std::string& name, int parent, const glm::dvec3& place, bool is_end) {
    if (out_.size() >= deform::kMostTemplateJoints)
      fail(where, "too many joints", fmt::format("{} with ends are the most", deform::kMostTemplateJoints));
    const auto index = static_cast<int>(out_.size());
    if (!is_end && !index_of_.emplace(name, index).second)
      fail(where, "two joints are called \"" + name + "\"", "rename one");
    if (parent != deform::kNoJoint && out_[to_index(parent)].place == place)
      fail(where, "a joint at the place of the one above it", "move it: bones have lengths");
    out_.push_back({name, parent, place, deform::kNoJoint, is_end});
    return index;
  }

  // Both of them where the joint has a mirror; the second is deform::kNoJoint else.
  std::pair<int, int> add_pair(const std::string& where, const std::string& name, const std::string& mirror, int parent,
                               const glm::dvec3& place, bool is_end) {
    const int other_parent = parent == deform::kNoJoint ? deform::kNoJoint : out_[to_index(parent)].mirror;
    if (mirror.empty()) {
      if (place.x != 0) fail(where, "a joint that stands aside without a mirror", "give mirror, or x = 0");
      if (other_parent != deform::kNoJoint)
        fail(where, "a joint without a mirror below one that has one", "give mirror");
      return {add(where, name, parent, place, is_end), deform::kNoJoint};
    }
    if (!(place.x > 0)) fail(where, "a joint with a mirror that is not on the left", "give x > 0");
    const int left = add(where, name, parent, place, is_end);
    const int right = add(where, is_end ? "" : mirror, other_parent == deform::kNoJoint ? parent : other_parent,
                          glm::dvec3(-place.x, place.y, place.z), is_end);
    out_[to_index(left)].mirror = right;
    out_[to_index(right)].mirror = left;
    return {left, right};
  }

  void read_joint(const toml::table& joint) {
    constexpr std::string_view kKeys[] = {"name", "parent", "mirror", "place", "end"};
    for (const auto& [key, node] : joint)
      if (std::ranges::find(kKeys, key.str()) == std::end(kKeys))
        fail(tools::place_of(key.source()), "unknown key \"" + std::string(key.str()) + "\"",
             fmt::format("a joint has {}", fmt::join(kKeys, ", ")));
    const std::string where = tools::place_of(joint.source());
    const std::string name = name_in(joint, "name"), parent_name = name_in(joint, "parent"),
                      mirror = name_in(joint, "mirror");
    const std::optional<glm::dvec3> place = place_of(joint, "place"), end = place_of(joint, "end");
    if (name.empty()) fail(where, "a joint without a name", "give name = \"Hips\"");
    if (!place) fail(where, "a joint without a place", "give place = [x, y, z]");
    int parent = deform::kNoJoint;
    if (!parent_name.empty()) {
      const auto found = index_of_.find(parent_name);
      if (found == index_of_.end())
        fail(tools::place_of(joint.get("parent")->source()), "no joint above is called \"" + parent_name + "\"",
             "joints come after their parents");
      parent = found->second;
    }
    if ((parent == deform::kNoJoint) != out_.empty())
      fail(where, out_.empty() ? "the first joint has a parent" : "a second joint without a parent",
           "one joint, the first, is above all others");
    if (out_.empty() && !mirror.empty()) fail(where, "the first joint has a mirror", "leave it out");
    if (parent != deform::kNoJoint && has_end_.contains(parent))
      fail(where, "\"" + parent_name + "\" has both an end and a joint below it", "leave out its end");
    const auto [left, right] = add_pair(where, name, mirror, parent, *place, false);
    if (!end) return;
    add_pair(where, "", mirror, left, *end, true);
    has_end_.insert({left, right});
  }

  void check_whole() const {
    double low = out_.front().place.y, high = low;
    for (const deform::TemplateJoint& joint : out_) {
      low = std::min(low, joint.place.y);
      high = std::max(high, joint.place.y);
    }
    if (!(high > low)) fail("", "all joints are at one height", "+Y is up");
    if (deform::knots_of(out_).size() > deform::kMostTemplateKnots)
      fail("", "too many joints that branch or end chains", fmt::format("{} are the most", deform::kMostTemplateKnots));
  }

  std::string path_;
  SkeletonTemplate out_;
  std::map<std::string, int> index_of_;
  std::set<int> has_end_;
};

}  // namespace

std::string_view builtin_template(std::string_view name) {
  if (name == "humanoid") return kHumanoid;
  return name == "quadruped" ? kQuadruped : std::string_view();
}

SkeletonTemplate parse_template(const std::string& path, std::string_view text) {
  TemplateReader reader(path);
  if (text.size() > kLargestTemplate) reader.fail("", "too large", "64 KiB is the limit");
  if (const std::size_t line = tools::line_of_deep_key(text))
    reader.fail(std::to_string(line) + ":1", "a key of too many parts", "a template has [[joint]] alone");
  return reader.read(tools::parse_toml(text, [&](const toml::parse_error& e) {
    reader.fail(tools::place_of(e.source()), "no TOML", std::string(e.description()));
  }));
}
}  // namespace marrow::cook
