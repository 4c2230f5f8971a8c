#include "cook/retarget/retarget.h"

#include <set>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "common/failure.h"
#include "text/deep_key.h"
#include "text/printable.h"
#include "toml/toml_reader.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kLargestMap = 8 * 1024 * 1024;  // 32767 joints and comments

using tools::place_of;

struct MapFailure {
  const std::string& path;
  [[noreturn]] void operator()(const std::string& where, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, path, where, tools::printable(rule), tools::printable(advice));
  }
};

// One name, or two and a share.
MappedJoint read_joint(const MapFailure& fail, const std::string& joint, const toml::node& value) {
  MappedJoint out{joint, "", "", 0, place_of(value.source())};
  if (const auto* const name = value.as_string()) {
    out.source = name->get();
    if (out.source.empty()) fail(out.where, "\"" + joint + "\" turns as nothing", "leave the line out");
    return out;
  }
  const toml::array* const list = value.as_array();
  if (list == nullptr || list->size() != 3 || !list->get(0)->is_string() || !list->get(1)->is_string() ||
      !list->get(2)->is_number())
    fail(out.where, "\"" + joint + "\" is neither a name nor a list of two names and a share",
         "give \"Spine1\", or [\"Spine1\", \"Spine2\", 0.5] for what is halfway between");
  out.source = list->get(0)->as_string()->get();
  out.other = list->get(1)->as_string()->get();
  out.share = list->get(2)->value<double>().value_or(-1);
  if (out.source.empty() || out.other.empty()) fail(out.where, "an empty name", "give names of two joints");
  if (!(out.share >= 0 && out.share <= 1)) fail(out.where, "a share that is not from 0 to 1", "1 is all of the second");
  return out;
}

std::string value_text(const RigPairing& pairing, const Counterpart& at) {
  const std::vector<std::string>& names = pairing.rig_skeleton.joint_names;
  const std::string name = tools::toml_quoted(names[to_index(at.node)]);
  if (at.other == kNone) return name;
  return fmt::format("[{}, {}, {:.6g}]", name, tools::toml_quoted(names[to_index(at.other)]), at.share);
}

}  // namespace

RetargetMap parse_retarget_map(const std::string& path, std::string_view text) {
  const MapFailure fail{path};
  if (text.size() > kLargestMap) fail("", "too large", "8 MiB is the limit");
  if (const std::size_t line = tools::line_of_deep_key(text))
    fail(std::to_string(line) + ":1", "a key of too many parts", "quote names with dots");
  const toml::table root = tools::parse_toml(
      text, [&](const toml::parse_error& e) { fail(place_of(e.source()), "no TOML", std::string(e.description())); });
  for (const auto& [key, value] : root)
    if (key.str() != "joints")
      fail(place_of(key.source()), "unknown setting \"" + std::string(key.str()) + "\"", "a map has [joints] alone");
  const toml::node* const joints = root.get("joints");
  if (joints == nullptr || !joints->is_table()) fail("", "no [joints]", "`marrow retarget --map` writes a map");
  RetargetMap out{path, {}};
  for (const auto& [key, value] : *joints->as_table())
    out.joints.push_back(read_joint(fail, std::string(key.str()), value));
  if (out.joints.empty()) fail(place_of(joints->source()), "a map of no joints", "give JOINT = \"SOURCE\"");
  return out;
}

std::string retarget_map_text(const Character& character, const RawScene& source, const RigPairing& pairing) {
  const BuiltSkeleton& skeleton = character.skeletons[pairing.skeleton];
  std::string out = fmt::format(
      "# Joints of {} turn as these of {}.\n# A line that is left out, or begins with #, lets a "
      "joint keep its rest pose.\n[joints]\n",
      tools::printable(character.file), tools::printable(source.source));
  std::set<std::string> names;
  std::set<int> used;
  for (std::size_t j = 0; j < pairing.pairs.size(); ++j) {
    const Counterpart& at = pairing.pairs[j];
    const std::string name = tools::toml_quoted(skeleton.joint_names[j]);
    if (!at.is_there() || !names.insert(name).second) {
      out += "# " + name + " = \"\"\n";
      continue;
    }
    used.insert({at.node, at.other});
    out += name + " = " + value_text(pairing, at) + "\n";
  }
  bool is_first = true;
  for (std::size_t j = 0; j < pairing.rig_skeleton.joint_names.size(); ++j) {
    if (used.contains(static_cast<int>(j))) continue;
    if (is_first) out += fmt::format("\n# Of {} nothing turns as:\n", tools::printable(source.source));
    is_first = false;
    out += "# " + tools::toml_quoted(pairing.rig_skeleton.joint_names[j]) + "\n";
  }
  return out;
}

}  // namespace marrow::cook
