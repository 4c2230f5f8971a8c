#include "cook/roles/role_body.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kNearLegs = 1, kBelowLegs = 0.5;  // of a leg's length: how far hips may be from between the legs

bool is_spine(Part part) {
  return part == Part::spine || part == Part::chest || part == Part::upper_chest;
}
// The name is that of something in the middle, or says nothing.
bool may_be_middle(const JointPart& p) {
  return !p.own_side && (is_spine(p.part) || p.part == Part::none || p.part == Part::neck || p.part == Part::head);
}

double leg_length(const Body& body, Side side) {
  const int upper = body.joint_of(on_side(Role::left_upper_leg, side)),
            lower = body.joint_of(on_side(Role::left_lower_leg, side)),
            foot = body.joint_of(on_side(Role::left_foot, side));
  const double thigh = glm::length(body.place(lower) - body.place(upper));
  return thigh + (foot == kNone ? thigh : glm::length(body.place(foot) - body.place(lower)));
}

bool is_near_legs(const Body& body, int joint) {
  const int left = body.joint_of(Role::left_upper_leg), right = body.joint_of(Role::right_upper_leg);
  const glm::dvec3 between = 0.5 * (body.place(left) + body.place(right));
  const double leg = leg_length(body, Side::left);
  return glm::length(body.place(joint) - between) <= kNearLegs * leg &&
         between.y - body.place(joint).y <= kBelowLegs * leg;
}

int arms_meet(const Body& body) {
  return body.common(body.joint_of(Role::left_upper_arm), body.joint_of(Role::right_upper_arm));
}

// Joints with a name in the middle and a part.
std::vector<int> called(const Body& body, Part part) {
  std::vector<int> out;
  for (std::size_t j = 0; j < body.size(); ++j)
    if (body.parts[j].part == part && !body.parts[j].own_side && !body.is_end(static_cast<int>(j)))
      out.push_back(static_cast<int>(j));
  return out;
}

// Anything of the upper body, to tell where the trunk goes.
int any_above(const Body& body) {
  if (const int arms = arms_meet(body); arms != kNone) return arms;
  for (const Part part : {Part::head, Part::neck, Part::upper_chest, Part::chest, Part::spine})
    if (const std::vector<int> found = called(body, part); !found.empty()) return found.front();
  return kNone;
}

// The joint so named that carries a trunk.
int hips_by_name(const Body& body) {
  const std::vector<int> named = called(body, Part::hips);
  const int above = any_above(body);
  return named.size() == 1 && above != kNone && body.is_at_or_above(named[0], above) ? named[0] : kNone;
}

int hips_above_legs(const Body& body, const Doubt& doubt) {
  const int left = body.joint_of(Role::left_upper_leg), right = body.joint_of(Role::right_upper_leg);
  const int legs = body.common(left, right);
  if (legs != kNone && (legs == left || legs == right)) return kNone;
  const int trunk = body.common(legs, any_above(body));
  const int meet = trunk == kNone ? legs : trunk;
  for (int j = meet; j != kNone; j = body.parent(j))
    if (body.part(j).part == Part::hips && !body.part(j).own_side) return j;
  const bool sure = meet != kNone && is_near_legs(body, meet);
  for (const int named : called(body, Part::hips))
    if (!body.is_at_or_above(named, left)) {
      const std::string carry = "no legs hang below it";
      doubt(named, sure ? carry + "; \"" + body.names[to_index(meet)] + "\" carries them" : carry);
      break;
    }
  return sure ? meet : kNone;
}

void find_hips(Body& body, const Doubt& doubt) {
  const bool legs = body.joint_of(Role::left_upper_leg) != kNone && body.joint_of(Role::right_upper_leg) != kNone;
  const int hips = legs ? hips_above_legs(body, doubt) : hips_by_name(body);
  body.give(Role::hips, hips);
  body.trunk = hips;
  // Legs may hang beside the trunk, on nothing or on what stands on the ground.
  if (const int named = hips_by_name(body); legs && hips == kNone && named != kNone && is_near_legs(body, named))
    body.trunk = named;
  int root = body.trunk;
  while (root != kNone && body.parent(root) != kNone) root = body.parent(root);
  if (root != body.trunk) body.give(Role::root, root);
}

// Something of the trunk is at or above it, or the hips are.
bool hangs_on_a_body(const Body& body, int joint) {
  if (body.trunk != kNone) return body.is_at_or_above(body.trunk, joint);
  for (int j = body.parent(joint); j != kNone; j = body.parent(j))
    if (is_spine(body.part(j).part) || body.part(j).part == Part::neck) return true;
  return false;
}

int named_head(const Body& body, const Doubt& doubt) {
  std::vector<int> heads;
  for (const int j : called(body, Part::head)) {
    const bool below_another = !heads.empty() && body.is_at_or_above(heads[0], j);
    if (!below_another && hangs_on_a_body(body, j)) heads.push_back(j);
    if (heads.size() > 1) break;
  }
  if (heads.size() > 1) doubt(heads[1], "\"" + body.names[to_index(heads[0])] + "\" may be the head, too");
  return heads.size() == 1 ? heads[0] : kNone;
}

// On from `from` as long as there is one way in the middle.
int last_in_middle(const Body& body, int from) {
  for (int j = from;;) {
    int next = kNone;
    for (const int child : body.children[to_index(j)]) {
      const bool carries_arm = body.is_at_or_above(child, body.joint_of(Role::left_upper_arm)) ||
                               body.is_at_or_above(child, body.joint_of(Role::right_upper_arm));
      const bool bare = !body.carries.empty() && body.carries[to_index(child)] == 0;
      if (carries_arm || bare || !may_be_middle(body.part(child)) || body.is_end(child)) continue;
      if (next != kNone) return j == from ? kNone : j;
      next = child;
    }
    if (next == kNone) return j == from ? kNone : j;
    j = next;
  }
}

// Where no joint is called a head: the last of the neck, or of what goes on in the middle above the arms.
int unnamed_head(const Body& body) {
  const std::vector<int> necks = called(body, Part::neck);
  int last = kNone;
  for (const int neck : necks)
    if (last == kNone || body.is_at_or_above(last, neck)) last = neck;
  if (necks.size() >= 2 && last != necks.front() && hangs_on_a_body(body, last)) return last;
  if (!necks.empty() || body.trunk == kNone) return kNone;
  const int arms = arms_meet(body);
  if (arms == kNone || !called(body, Part::head).empty()) return kNone;
  const int head = last_in_middle(body, arms);
  // Of joints without names the third may be an end, or the second a neck's.
  return body.is_nameless && body.way(arms, head).size() > 2 ? kNone : head;
}

// Joints from the hips to the neck, by their number and their names.
void give_trunk(Body& body, const std::vector<int>& trunk) {
  if (trunk.empty()) return;
  const std::size_t n = trunk.size();
  const auto part = [&](std::size_t i) { return body.part(trunk[i]).part; };
  if (n == 1) {
    const bool chest = part(0) == Part::chest || part(0) == Part::upper_chest;
    return body.give(chest ? Role::chest : Role::spine, trunk[0]);
  }
  body.give(Role::spine, trunk[0]);
  const bool last_is_chest = part(n - 1) == Part::chest && part(n - 2) != Part::chest;
  if (n == 2 || last_is_chest) return body.give(Role::chest, trunk[n - 1]);
  body.give(Role::chest, trunk[n - 2]);
  body.give(Role::upper_chest, trunk[n - 1]);
}

void find_spine_and_neck(Body& body) {
  const int hips = body.trunk, head = body.joint_of(Role::head), arms = arms_meet(body);
  int top = head;
  for (const int neck : called(body, Part::neck)) {
    if (head != kNone || !hangs_on_a_body(body, neck)) continue;
    if (top != kNone && !body.is_at_or_above(top, neck)) return;  // another body's
    if (top == kNone) top = neck;
  }
  if (top == kNone) top = arms;
  if (top == kNone || (hips != kNone && !body.is_at_or_above(hips, top))) return;
  std::vector<int> way = body.way(hips, top);
  if (!way.empty() && way.back() == head) way.pop_back();
  const auto named = std::ranges::find_if(way, [&](int j) { return body.part(j).part == Part::neck; });
  const auto meet = std::ranges::find(way, arms);
  const bool bounded = hips != kNone && (named != way.end() || meet != way.end());
  const auto end = named != way.end() ? named : meet != way.end() ? meet + 1 : way.end();
  std::vector<int> trunk;
  for (auto j = way.begin(); j != end; ++j)
    if (const JointPart& p = body.part(*j); !p.own_side && (is_spine(p.part) || (bounded && p.part == Part::none)))
      trunk.push_back(*j);
  // Of four joints without names the last may be a neck's.
  if (body.is_nameless && trunk.size() > 3) trunk.erase(trunk.begin() + 1, trunk.end());
  // Without a neck or arms nobody knows how far up the trunk goes.
  if (named == way.end() && meet == way.end() && trunk.size() > 1) trunk.erase(trunk.begin() + 1, trunk.end());
  give_trunk(body, trunk);
  if (end != way.end() && may_be_middle(body.part(*end))) body.give(Role::neck, *end);
}

void find_face(Body& body) {
  const int head = body.joint_of(Role::head);
  if (head == kNone) return;
  const auto only = [&](Part part, Side side) {
    int found = kNone, count = 0;
    for (std::size_t j = 0; j < body.size(); ++j) {
      const JointPart& p = body.parts[j];
      const int joint = static_cast<int>(j);
      if (p.part != part || p.is_end || (p.own_side ? p.side : Side::none) != side) continue;
      if (!body.is_at_or_above(head, joint) || (found != kNone && body.is_at_or_above(found, joint))) continue;
      found = joint;
      ++count;
    }
    return count == 1 ? found : kNone;
  };
  body.give(Role::jaw, only(Part::jaw, Side::none));
  body.give(Role::left_eye, only(Part::eye, Side::left));
  body.give(Role::right_eye, only(Part::eye, Side::right));
}

// It hangs below the hips, or beside them.
bool may_be_tail(const Body& body, int joint) {
  const int hips = body.trunk;
  if (hips == kNone || body.is_at_or_above(body.joint_of(Role::head), joint)) return false;
  return body.is_at_or_above(hips, joint) || body.parent(joint) == body.parent(hips);
}

// From the first joint so called on, as long as there is one way.
void find_tail(Body& body) {
  std::vector<int> firsts;
  const auto is_tail = [&](int j) {
    return body.part(j).part == Part::tail && !body.part(j).own_side && !body.is_end(j);
  };
  for (std::size_t j = 0; j < body.size(); ++j) {
    const int joint = static_cast<int>(j);
    if (!is_tail(joint) || (body.parent(joint) != kNone && is_tail(body.parent(joint)))) continue;
    if (may_be_tail(body, joint)) firsts.push_back(joint);
  }
  if (firsts.size() != 1) return;
  for (int j = firsts[0]; j != kNone;) {
    body.give(Role::tail, j);
    int next = kNone;
    for (const int child : body.children[to_index(j)])
      if (is_tail(child)) {
        if (next != kNone) return;
        next = child;
      }
    j = next;
  }
}

}  // namespace

void find_trunk(Body& body, const Doubt& doubt) {
  find_hips(body, doubt);
  const int head = named_head(body, doubt);
  body.give(Role::head, head != kNone ? head : unnamed_head(body));
  find_spine_and_neck(body);
  find_face(body);
  find_tail(body);
}

}  // namespace marrow::cook
