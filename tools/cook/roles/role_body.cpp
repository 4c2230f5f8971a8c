#include "cook/roles/role_body.h"

#include <algorithm>
#include <map>

#include "cook/scene/matrices.h"
#include "cook/scene/views.h"
#include "marrow/skeleton.h"

namespace marrow::cook {
namespace {

constexpr std::size_t kFewDeform = 8;    // joints with DEF-, from which on the others are not meant
constexpr double kShareOfPrefix = 0.25;  // of joints that have a word, from which on it says nothing

int number_of(const std::string& digits) {
  int out = 0;
  for (const char c : digits) out = 10 * out + (c - '0');
  return out;
}

int first_number(const NameWords& n) {
  return n.numbers.empty() ? -1 : number_of(n.numbers.front());
}

// Of front legs, whose words are those of legs.
Part part_of_front(const NameWords& n) {
  if (n.has(Word::shoulder, Word::collar)) return Part::arm_girdle;
  if (n.has(Word::toe)) return Part::other;
  if (n.has(Word::ankle, Word::wrist)) return Part::wrist;
  if (n.has(Word::foot, Word::hand)) return Part::hand;
  if (n.has(Word::humerus, Word::thigh) || (n.has(Word::upper) && n.has(Word::leg, Word::arm))) return Part::upper_arm;
  if (n.has(Word::shin, Word::knee, Word::elbow, Word::forearm)) return Part::lower_arm;
  if (n.has(Word::lower) && n.has(Word::leg, Word::arm)) return Part::lower_arm;
  return n.has(Word::leg, Word::arm) ? Part::arm : Part::other;
}

Part part_of_leg(const NameWords& n) {
  if (n.has(Word::back) && n.has(Word::shoulder)) return Part::leg_girdle;
  if (n.has(Word::toe)) return Part::toes;
  if (n.has(Word::foot)) return n.has(Word::thumb) ? Part::toes : Part::foot;
  if (n.has(Word::ankle)) return Part::ankle;
  if (n.has(Word::thigh)) return Part::upper_leg;
  if (n.has(Word::shin, Word::knee)) return Part::lower_leg;
  if (n.has(Word::pelvis) && n.side != Side::none) return Part::leg_girdle;
  if (n.has(Word::leg)) {
    if (n.has(Word::hip)) return Part::hip;
    if (n.has(Word::upper)) return Part::upper_leg;
    return n.has(Word::lower) ? Part::lower_leg : Part::leg;
  }
  return n.has(Word::hip) && n.side != Side::none ? Part::hip : Part::none;
}

Part part_of_arm(const NameWords& n) {
  if (n.has(Word::hand)) return Part::hand;
  if (n.has(Word::wrist)) return Part::wrist;
  if (n.has(Word::forearm, Word::elbow)) return Part::lower_arm;
  if (n.has(Word::humerus)) return Part::upper_arm;
  if (n.has(Word::collar)) return Part::arm_girdle;
  if (n.has(Word::arm)) {
    if (n.has(Word::upper)) return Part::upper_arm;
    return n.has(Word::lower) ? Part::lower_arm : Part::arm;
  }
  return n.has(Word::shoulder) && n.side != Side::none ? Part::shoulder : Part::none;
}

Part part_of_finger(const NameWords& n) {
  if (n.has(Word::palm)) return n.has(Word::thumb) ? Part::thumb : Part::palm;
  if (n.has(Word::thumb)) return Part::thumb;
  if (n.has(Word::index)) return Part::index;
  if (n.has(Word::middle) || (n.has(Word::mid) && n.has(Word::finger))) return Part::middle;
  // Some write "RingPinky" for the little finger.
  if (n.has(Word::little)) return Part::little;
  return n.has(Word::ring) ? Part::ring : Part::none;
}

Part part_of_trunk(const NameWords& n) {
  if (n.has(Word::jaw)) return n.has(Word::upper) ? Part::other : Part::jaw;
  if (n.has(Word::mouth)) return n.has(Word::lower) ? Part::jaw : Part::other;
  if (n.has(Word::tail)) return Part::tail;
  if (n.has(Word::neck)) return Part::neck;
  if (n.has(Word::head)) return Part::head;
  if (n.has(Word::chest)) return n.has(Word::upper) ? Part::upper_chest : Part::chest;
  if (n.has(Word::spine) || (n.has(Word::back) && n.has(Word::lower, Word::upper))) return Part::spine;
  if (n.has(Word::hip, Word::pelvis)) return Part::hips;
  return n.has(Word::root) ? Part::root : Part::none;
}

Part part_of(const NameWords& n) {
  const bool twists = n.has(Word::twist) && !n.has(Word::neck);  // of some rigs "NeckTwist" is the neck
  if (twists || n.has(Word::control, Word::other)) return Part::other;
  if (n.has(Word::unknown)) return Part::unknown;
  if (n.has(Word::eye)) return Part::eye;
  if (n.has(Word::front) && !n.has(Word::head)) return part_of_front(n);
  if (const Part leg = part_of_leg(n); leg != Part::none) return leg;
  const bool of_trunk = n.has(Word::spine, Word::chest) || n.has(Word::head, Word::neck);
  if (const Part finger = part_of_finger(n); finger != Part::none && !of_trunk) return finger;
  if (const Part arm = part_of_arm(n); arm != Part::none && !of_trunk) return arm;
  return part_of_trunk(n);
}

// "Finger0", "Finger01" of 3ds Max, whose thumb is 0, or "finger1-1" of MakeHuman, whose thumb is 1. Where a thumb has
// its own name, fingers are counted from the index on.
void number_finger(const NameWords& n, bool from_0, bool has_thumb, JointPart& out) {
  constexpr Part kFingers[] = {Part::thumb, Part::index, Part::middle, Part::ring, Part::little};
  if (!n.has(Word::finger) || out.part != Part::none || n.numbers.empty()) return;
  const std::string& first = n.numbers[0];
  int finger = number_of(first), segment = n.numbers.size() > 1 ? number_of(n.numbers[1]) : 0;
  if (from_0 && first.size() == 2) {
    segment = finger % 10;
    finger /= 10;
  }
  finger += (has_thumb ? 1 : 0) - (from_0 ? 0 : 1);
  if (finger < 0 || finger > 4) return;
  out.part = kFingers[finger];
  out.number = segment + (from_0 ? 1 : 0);
}

// Of a skeleton with names for all four legs each is a leg; of another such letters say nothing.
void read_corners(std::vector<NameWords>& names) {
  std::array<bool, 5> seen{};
  for (const NameWords& n : names) seen[static_cast<std::size_t>(n.corner)] = true;
  const bool all = std::ranges::all_of(seen.begin() + 1, seen.end(), [](bool one) { return one; });
  for (NameWords& n : names) {
    if (n.corner == Corner::none) continue;
    if (!all || n.side != Side::none) {
      n.add(Word::unknown);
      continue;
    }
    const bool left = n.corner == Corner::front_left || n.corner == Corner::back_left;
    const bool front = n.corner == Corner::front_left || n.corner == Corner::front_right;
    n.side = left ? Side::left : Side::right;
    n.add(front ? Word::front : Word::back);
    n.add(Word::leg);
  }
}

// Words that so many joints have, as a rig's own name, say nothing of one.
void forget_prefixes(std::vector<NameWords>& names) {
  std::map<std::string, std::size_t> count;
  for (const NameWords& n : names)
    for (const std::string& word : n.unknown) ++count[word];
  for (NameWords& n : names) {
    const bool common = std::ranges::all_of(n.unknown, [&](const std::string& word) {
      return static_cast<double>(count[word]) >= kShareOfPrefix * static_cast<double>(names.size()) && count[word] > 2;
    });
    if (common && !n.unknown.empty()) n.words &= ~(std::uint64_t{1} << static_cast<unsigned>(Word::unknown));
  }
}

bool begins_with_def(const std::string& name) {
  return name.starts_with("DEF-") || name.starts_with("DEF_");
}

}  // namespace

std::vector<JointPart> parts_of(const std::vector<std::string>& names, const std::vector<std::uint16_t>& parents) {
  std::vector<NameWords> words;
  for (const std::string& name : names) words.push_back(words_of(name));
  read_corners(words);
  forget_prefixes(words);
  const auto deforming = static_cast<std::size_t>(std::ranges::count_if(names, begins_with_def));
  const bool from_0 = std::ranges::any_of(
      words, [](const NameWords& n) { return n.has(Word::finger) && !n.numbers.empty() && n.numbers[0] == "0"; });
  const bool has_thumb = std::ranges::any_of(words, [](const NameWords& n) { return part_of(n) == Part::thumb; });
  std::vector<JointPart> out(names.size());
  for (std::size_t j = 0; j < names.size(); ++j) {
    const NameWords& n = words[j];
    JointPart& to = out[j];
    to.part = part_of(n);
    to.own_side = n.side != Side::none;
    to.side = n.side;
    if (!to.own_side && parents[j] != kNoJoint) to.side = out[parents[j]].side;
    to.is_end = n.has(Word::end);
    to.is_front = n.has(Word::front);
    to.is_humerus = n.has(Word::humerus);
    to.number = first_number(n);
    number_finger(n, from_0, has_thumb, to);
    const bool meant = deforming < kFewDeform || begins_with_def(names[j]) || to.part == Part::root;
    if (!meant) to.part = Part::other;
  }
  return out;
}

int Body::common(int a, int b) const {
  if (a == kNone || b == kNone) return kNone;
  while (a != b) {
    int& lower = a > b ? a : b;  // a parent has the lower number
    lower = parent(lower);
    if (lower == kNone) return kNone;
  }
  return a;
}

std::vector<int> Body::way(int above, int joint) const {
  std::vector<int> out;
  for (; joint != above && joint != kNone; joint = parent(joint)) out.push_back(joint);
  std::ranges::reverse(out);
  return out;
}

bool Body::is_end(int joint) const {
  if (!part(joint).is_end) return false;
  return std::ranges::all_of(children[to_index(joint)],
                             [&](int child) { return part(child).is_end && children[to_index(child)].empty(); }) &&
         (children[to_index(joint)].empty() || part(joint).part != Part::tail);
}

void Body::give(Role role, int joint) {
  if (joint == kNone || this->role(joint) != Role::none) return;
  int& first = first_[static_cast<std::size_t>(role)];
  if (role != Role::tail && first != kNone) return;
  roles_[to_index(joint)] = role;
  first = first == kNone ? joint : std::min(first, joint);
}

void Body::take(Role role) {
  int& first = first_[static_cast<std::size_t>(role)];
  if (first == kNone) return;
  std::ranges::replace(roles_, role, Role::none);
  first = kNone;
}

void Body::set(Role role, int joint) {
  if (role != Role::tail) take(role);
  if (const Role old = this->role(joint); old != Role::none) {
    roles_[to_index(joint)] = Role::none;
    const auto next = std::ranges::find(roles_, old);
    first_[static_cast<std::size_t>(old)] = next == roles_.end() ? kNone : static_cast<int>(next - roles_.begin());
  }
  give(role, joint);
}

Body body_of(const BuiltSkeleton& skeleton) {
  Body out;
  const std::size_t count = skeleton.parents.size();
  out.names = skeleton.joint_names;
  out.parts = parts_of(out.names, skeleton.parents);
  out.children.resize(count);
  out.roles_.assign(count, Role::none);
  out.first_.fill(kNone);
  const std::vector<Transform> rest = rest_transforms(skeleton);
  for (std::size_t j = 0; j < count; ++j) {
    const bool is_root = skeleton.parents[j] == kNoJoint;
    out.parents.push_back(is_root ? kNone : skeleton.parents[j]);
    const glm::dmat4 above =
        is_root ? to_matrix(skeleton.model_from_root[j]) : out.model_from_joint[skeleton.parents[j]];
    out.model_from_joint.push_back(above * matrix_of(rest[j]));
    out.places.emplace_back(out.model_from_joint[j][3]);
    if (!is_root) out.children[skeleton.parents[j]].push_back(static_cast<int>(j));
  }
  out.descent = Descent(skeleton.parents);
  return out;
}

Role other_side(Role role) {
  const auto move = [&](Role left, Role right, unsigned count) {
    const auto n = static_cast<unsigned>(role), l = static_cast<unsigned>(left), r = static_cast<unsigned>(right);
    if (n >= l && n < l + count)
      role = static_cast<Role>(n - l + r);
    else if (n >= r && n < r + count)
      role = static_cast<Role>(n - r + l);
  };
  move(Role::left_eye, Role::right_eye, 1);
  move(Role::left_shoulder, Role::right_shoulder, 4);
  move(Role::left_upper_leg, Role::right_upper_leg, 4);
  move(Role::left_thumb_metacarpal, Role::right_thumb_metacarpal, 15);
  return role;
}
}  // namespace marrow::cook
