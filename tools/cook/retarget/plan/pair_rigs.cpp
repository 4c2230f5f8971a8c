#include "cook/retarget/plan/pair_rigs.h"

#include <algorithm>
#include <map>

#include "common/failure.h"
#include "cook/scene/raw.h"
#include "cook/skeleton/build_skeletons.h"
#include "marrow/roles.h"
#include "text/nearest.h"
#include "text/printable.h"

namespace marrow::cook {
namespace {

std::string loose(const std::string& name) {
  std::string out;
  const std::size_t colon = name.rfind(':');
  for (std::size_t i = colon == std::string::npos ? 0 : colon + 1; i < name.size(); ++i) {
    const char c = name[i];
    if (c == ' ' || c == '_' || c == '.') continue;
    out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::string exact(const std::string& name) {
  return name;
}

constexpr int kSeveral = -2;

// Names, as `key` makes them, to joints; those that several have are kSeveral.
template <class Key>
std::map<std::string, int> by_name(const std::vector<std::string>& names, Key key) {
  std::map<std::string, int> out;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const auto [at, is_new] = out.try_emplace(key(names[i]), static_cast<int>(i)); !is_new) at->second = kSeveral;
  return out;
}

// The same of joints that have no partner yet.
template <class Key>
std::map<std::string, int> unpaired_by_name(std::vector<std::string> names, const std::vector<int>& partner, Key key) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (partner[i] != kNone) names[i].clear();
  std::map<std::string, int> out = by_name(names, key);
  out.erase("");
  return out;
}

int parent_of(const BuiltSkeleton& skeleton, int joint) {
  const std::uint16_t parent = skeleton.parents[to_index(joint)];
  return parent == kNoJoint ? kNone : parent;
}

// From below `above` down to `joint`; empty if it is not below it.
std::vector<int> way(const BuiltSkeleton& skeleton, int above, int joint) {
  std::vector<int> out;
  for (; joint != above && joint != kNone; joint = parent_of(skeleton, joint)) out.push_back(joint);
  if (joint != above) return {};
  std::ranges::reverse(out);
  return out;
}

// The next joint above that has a counterpart, as long as joints are asked in their order.
class Uppers {
 public:
  explicit Uppers(const BuiltSkeleton& skeleton) : skeleton_(skeleton), upper_(skeleton.parents.size(), kNone) {}
  int of(int joint, const std::vector<Counterpart>& pairs) {
    const int up = parent_of(skeleton_, joint);
    if (up != kNone) upper_[to_index(joint)] = pairs[to_index(up)].is_there() ? up : upper_[to_index(up)];
    return upper_[to_index(joint)];
  }

 private:
  const BuiltSkeleton& skeleton_;
  std::vector<int> upper_;
};

bool is_of_trunk(Role role) {
  return role == Role::spine || role == Role::chest || role == Role::upper_chest || role == Role::neck;
}

class Pairs {
 public:
  Pairs(const BuiltSkeleton& target, const BuiltSkeleton& source)
      : target_(target), source_(source), out_(target.joint_names.size()), used_(source.joint_names.size(), 0) {}

  void add_roles() {
    for (const JointRole& of : target_.roles.roles)
      if (of.role != Role::tail && !(is_of_trunk(of.role) && has_trunk_))
        if (const int joint = joint_with(source_, of.role); joint != kNone) add(of.joint, {joint, kNone, 0});
  }

  void add_trunk() {
    const TrunkJoints own = trunk_of(target_), other = trunk_of(source_);
    has_trunk_ = !own.spine.empty() && !other.spine.empty();
    if (!has_trunk_) return;
    add_chain(own.spine, other.spine);
    add_chain(own.neck, other.neck);
  }

  void add_tails() { add_chain(tail_of(target_), tail_of(source_)); }

  void add_names() {
    std::vector<std::string> names = target_.joint_names, others = source_.joint_names;
    for (std::size_t j = 0; j < names.size(); ++j)
      if (out_[j].is_there()) names[j].clear();
    for (std::size_t j = 0; j < others.size(); ++j)
      if (used_[j] != 0) others[j].clear();
    const bool has_pairs = std::ranges::any_of(out_, &Counterpart::is_there);
    const std::vector<int> found = pair_joints(names, others);
    const Descent descent(source_.parents);
    Uppers uppers(target_);
    for (std::size_t j = 0; j < found.size(); ++j) {
      const int up = uppers.of(static_cast<int>(j), out_);
      if (found[j] == kNone) continue;
      const bool hangs_alike = up == kNone || descent.is_at_or_above(out_[to_index(up)].node, found[j]);
      if (!has_pairs || hangs_alike) add(static_cast<int>(j), {found[j], kNone, 0});
    }
  }

  std::vector<Counterpart> take() { return std::move(out_); }

 private:
  void add(int joint, const Counterpart& at) {
    if (out_[to_index(joint)].is_there()) return;
    out_[to_index(joint)] = at;
    used_[to_index(at.node)] = 1;
    if (at.other != kNone) used_[to_index(at.other)] = 1;
  }

  // First to first, last to last. One joint alone goes with the last, which carries the most.
  void add_chain(const std::vector<int>& own, const std::vector<int>& other) {
    if (own.empty() || other.empty()) return;
    const double last = static_cast<double>(other.size() - 1);
    for (std::size_t i = 0; i < own.size(); ++i) {
      const double at = own.size() == 1 ? last : last * static_cast<double>(i) / static_cast<double>(own.size() - 1);
      const auto whole = static_cast<std::size_t>(at);
      const double share = at - static_cast<double>(whole);
      add(own[i], share > 0 ? Counterpart{other[whole], other[whole + 1], share} : Counterpart{other[whole], kNone, 0});
    }
  }

  static std::vector<int> tail_of(const BuiltSkeleton& skeleton) {
    std::vector<int> out;
    for (const JointRole& of : skeleton.roles.roles)
      if (of.role == Role::tail) out.push_back(of.joint);
    return out;
  }

  const BuiltSkeleton& target_;
  const BuiltSkeleton& source_;
  std::vector<Counterpart> out_;
  std::vector<char> used_;
  bool has_trunk_ = false;
};

// Looks names of a map up.
struct MapReader {
  const RetargetMap& map;

  [[noreturn]] void fail(const MappedJoint& line, const std::string& rule, const std::string& advice) const {
    throw tools::Failure(tools::Exit::usage, map.file, line.where, tools::printable(rule), tools::printable(advice));
  }
  int find(const std::map<std::string, int>& joints, const MappedJoint& line, const std::string& name,
           const std::string& file) const {
    const auto found = joints.find(name);
    if (found == joints.end()) {
      std::vector<std::string> names;
      for (const auto& [other, joint] : joints) names.push_back(other);
      fail(line, "no joint \"" + name + "\" in " + file, tools::suggestion(name, names));
    }
    if (found->second == kSeveral)
      fail(line, "several joints \"" + name + "\" in " + file, "rename them, or leave the line out");
    return found->second;
  }
};

}  // namespace

std::vector<int> pair_joints(const std::vector<std::string>& joints, const std::vector<std::string>& others) {
  std::vector<int> other_of(joints.size(), kNone), joint_of(others.size(), kNone);
  for (const auto key : {exact, loose}) {
    const std::map<std::string, int> right = unpaired_by_name(others, joint_of, key);
    for (const auto& [name, joint] : unpaired_by_name(joints, other_of, key)) {
      const auto found = right.find(name);
      if (joint == kSeveral || found == right.end() || found->second == kSeveral) continue;
      other_of[to_index(joint)] = found->second;
      joint_of[to_index(found->second)] = joint;
    }
  }
  return other_of;
}

int joint_with(const BuiltSkeleton& skeleton, Role role) {
  const auto found = std::ranges::find(skeleton.roles.roles, role, &JointRole::role);
  return found == skeleton.roles.roles.end() ? kNone : found->joint;
}

TrunkJoints trunk_of(const BuiltSkeleton& skeleton) {
  const int hips = joint_with(skeleton, Role::hips), head = joint_with(skeleton, Role::head);
  if (hips == kNone) return {};
  int top = kNone;  // shoulders may hang on the neck, so that arms do not say where the spine ends
  for (const Role role : {Role::spine, Role::chest, Role::upper_chest})
    if (const int joint = joint_with(skeleton, role); joint != kNone) top = joint;
  if (top == kNone) return {};
  TrunkJoints out;
  out.spine = way(skeleton, hips, top);
  if (head != kNone) out.neck = way(skeleton, top, head);
  if (!out.neck.empty()) out.neck.pop_back();  // the head
  return out;
}

std::vector<Counterpart> pair_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source) {
  Pairs pairs(target, source);
  pairs.add_trunk();
  pairs.add_roles();
  pairs.add_tails();
  pairs.add_names();
  return pairs.take();
}

std::vector<Counterpart> map_rigs(const BuiltSkeleton& target, const BuiltSkeleton& source, const RetargetMap& map,
                                  const std::string& target_file, const std::string& source_file) {
  const MapReader reader{map};
  const std::map<std::string, int> own = by_name(target.joint_names, exact),
                                   others = by_name(source.joint_names, exact);
  std::vector<Counterpart> out(target.joint_names.size());
  std::vector<const MappedJoint*> line_of(out.size(), nullptr);
  for (const MappedJoint& line : map.joints) {
    const int joint = reader.find(own, line, line.joint, target_file);
    Counterpart& at = out[to_index(joint)];
    if (at.is_there()) reader.fail(line, "\"" + line.joint + "\" a second time", "leave one line out");
    line_of[to_index(joint)] = &line;
    at.node = reader.find(others, line, line.source, source_file);
    if (line.other.empty()) continue;
    at.other = reader.find(others, line, line.other, source_file);
    at.share = line.share;
  }
  const Descent descent(source.parents);
  Uppers uppers(target);
  for (std::size_t j = 0; j < out.size(); ++j) {
    const int up = uppers.of(static_cast<int>(j), out);
    if (up == kNone || !out[j].is_there()) continue;
    const int above = out[to_index(up)].node;
    if (above == out[j].node || !descent.is_at_or_above(out[j].node, above)) continue;
    reader.fail(*line_of[j],
                "\"" + line_of[j]->joint + "\" hangs below \"" + target.joint_names[to_index(up)] + "\", but \"" +
                    line_of[j]->source + "\" above \"" + source.joint_names[to_index(above)] + "\"",
                "exchange the two, or leave one out");
  }
  return out;
}
}  // namespace marrow::cook
