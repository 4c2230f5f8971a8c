#include "cook/roles/role_body.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

// What a name says of a joint in its limb, of legs and arms alike.
enum class Step : std::uint8_t { no, girdle, socket, upper, plain, lower, hinge, end, toes };

Step step_of(const JointPart& p, bool leg) {
  static constexpr Part kLeg[] = {Part::leg_girdle, Part::hip,   Part::upper_leg, Part::leg,
                                  Part::lower_leg,  Part::ankle, Part::foot,      Part::toes};
  static constexpr Part kArm[] = {Part::arm_girdle, Part::shoulder, Part::upper_arm, Part::arm,
                                  Part::lower_arm,  Part::wrist,    Part::hand};
  const std::span<const Part> parts = leg ? std::span<const Part>(kLeg) : kArm;  // in the order of steps
  const auto found = std::ranges::find(parts, p.part);
  return found == parts.end() ? Step::no : static_cast<Step>(1 + (found - parts.begin()));
}

struct Link {
  int joint;
  Step step;
};

// The joints of one limb, from the body out, and where its roles are: an index into them, or kNone.
struct Limb {
  std::vector<Link> links;
  int girdle = kNone, upper = kNone, lower = kNone, end = kNone, toes = kNone;

  int first(Step step, int from) const {
    for (std::size_t i = to_index(std::max(from, 0)); i < links.size(); ++i)
      if (links[i].step == step) return static_cast<int>(i);
    return kNone;
  }
  int joint(int link) const { return link == kNone ? kNone : links[to_index(link)].joint; }
};

void find_end(Limb& limb) {
  const int from = std::max(limb.upper, limb.lower) + 1;
  limb.end = limb.first(Step::end, from);
  const int hinge = limb.first(Step::hinge, from);
  if (limb.end == kNone) {
    limb.end = hinge;
  } else if (limb.lower == kNone && hinge != kNone && hinge < limb.end) {
    limb.lower = hinge;  // "leg", "ankle", "foot": the ankle is where the limb bends
  }
}

// Of a limb whose joints are only counted: "leg 1", "leg 2", …
void count_plain(Limb& limb, const std::vector<int>& plain) {
  limb.upper = plain[0];
  limb.lower = plain[1];
  find_end(limb);
  if (limb.end != kNone || plain.size() < 3) return;
  limb.end = plain[2];
  if (plain.size() > 3) limb.toes = plain[3];
}

// "Humerus" and then an "upper leg": the second begins the lower arm.
void mend_humerus(const Body& body, Limb& limb) {
  const auto first = limb.upper;
  if (first == kNone || !body.part(limb.joint(first)).is_humerus) return;
  for (std::size_t i = to_index(first) + 1; i < limb.links.size(); ++i)
    if (limb.links[i].step == Step::upper && !body.part(limb.links[i].joint).is_humerus) {
      limb.lower = static_cast<int>(i);
      return;
    }
}

void find_upper_and_lower(const Body& body, Limb& limb) {
  limb.upper = limb.first(Step::upper, 0);
  limb.lower = limb.first(Step::lower, limb.upper + 1);
  mend_humerus(body, limb);
  const int end = std::max(limb.first(Step::end, 0), limb.first(Step::hinge, 0));
  std::vector<int> plain;
  for (std::size_t i = 0; i < limb.links.size(); ++i)
    if (limb.links[i].step == Step::plain && (end == kNone || static_cast<int>(i) < end))
      plain.push_back(static_cast<int>(i));
  if (limb.upper == kNone && limb.lower == kNone) {
    if (plain.size() >= 2) return count_plain(limb, plain);
    if (plain.size() == 1 && limb.first(Step::hinge, 0) != kNone && limb.first(Step::end, 0) != kNone)
      limb.upper = plain[0];
  } else if (limb.lower == kNone) {
    const auto next = std::ranges::find_if(plain, [&](int i) { return i > limb.upper; });
    if (next != plain.end()) limb.lower = *next;
  } else if (limb.upper == kNone) {
    if (!plain.empty() && plain[0] < limb.lower) limb.upper = plain[0];
    for (int i = limb.lower - 1; i >= 0 && limb.upper == kNone; --i)
      if (limb.links[to_index(i)].step == Step::socket) limb.upper = i;
  }
  find_end(limb);
}

void find_rest(const Body& body, Limb& limb) {
  for (const Step step : {Step::girdle, Step::socket})
    if (const int found = limb.first(step, 0); limb.girdle == kNone && found != kNone && found < limb.upper)
      limb.girdle = found;
  if (limb.end == kNone) return;
  if (limb.toes == kNone) limb.toes = limb.first(Step::toes, limb.end + 1);
  if (limb.toes == kNone) limb.toes = limb.first(Step::end, limb.end + 1);  // "foot 1", "foot 2"
  // One joint between the first and the last, whatever it is called, is the one that bends.
  if (limb.upper == kNone || limb.lower != kNone) return;
  const std::vector<int> way = body.way(limb.joint(limb.upper), limb.joint(limb.end));
  if (way.size() != 2 || body.part(way[0]).part != Part::none) return;
  limb.links.push_back({way[0], Step::lower});
  limb.lower = static_cast<int>(limb.links.size()) - 1;
}

// For each joint the kinds of steps on the way to it.
class NamedWays {
 public:
  NamedWays(const Body& body, bool leg, Side side)
      : body_(body), steps_(body.size(), Step::no), kinds_(body.size(), 0) {
    for (std::size_t j = 0; j < body.size(); ++j) {
      const JointPart& p = body.parts[j];
      const int joint = static_cast<int>(j);
      if (p.side == side && !body.is_end(joint)) steps_[j] = step_of(p, leg);
      if (body.parents[j] != kNone) kinds_[j] = kinds_[to_index(body.parents[j])];
      if (steps_[j] != Step::no) kinds_[j] |= 1u << static_cast<unsigned>(steps_[j]);
    }
  }
  int kinds(int joint) const { return std::popcount(kinds_[to_index(joint)]); }

  // The way with the most kinds of steps, of those the longest; kNone: none. But for what hangs below `not_below`.
  int best(int not_below) const {
    int best = kNone;
    for (std::size_t j = 0; j < body_.size(); ++j) {
      const int joint = static_cast<int>(j);
      if (steps_[j] == Step::no || (not_below != kNone && body_.is_at_or_above(not_below, joint))) continue;
      if (best == kNone || kinds(joint) > kinds(best) ||
          (kinds(joint) == kinds(best) && body_.is_at_or_above(best, joint)))
        best = joint;
    }
    return best;
  }
  Limb limb(int last) const {
    Limb out;
    for (const int joint : body_.way(kNone, last))
      if (steps_[to_index(joint)] != Step::no) out.links.push_back({joint, steps_[to_index(joint)]});
    return out;
  }
  bool has_siblings(int joint) const {
    const int parent = body_.parent(joint);
    return parent != kNone && std::ranges::any_of(body_.children[to_index(parent)], [&](int other) {
             return other != joint && steps_[to_index(other)] == steps_[to_index(joint)];
           });
  }

 private:
  const Body& body_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> kinds_;
};

void find_limb(Body& body, bool leg, Side side, const Doubt& doubt) {
  const NamedWays ways(body, leg, side);
  const int last = ways.best(kNone);
  if (last == kNone) return;
  Limb limb = ways.limb(last);
  find_upper_and_lower(body, limb);
  find_rest(body, limb);
  if (limb.upper == kNone || limb.lower == kNone) return;
  // Another limb as good as this: of a spider, say.
  const int other = ways.best(limb.joint(limb.girdle != kNone && limb.girdle < limb.upper ? limb.girdle : limb.upper));
  if (other != kNone && ways.kinds(other) >= ways.kinds(last) && !body.is_at_or_above(other, last))
    return doubt(limb.joint(limb.upper), "\"" + body.names[to_index(other)] + "\" may be of the same limb");
  if (limb.toes != kNone && ways.has_siblings(limb.joint(limb.toes))) limb.toes = kNone;
  const auto give = [&](Role left, int link) { body.give(on_side(left, side), limb.joint(link)); };
  give(leg ? Role::left_upper_leg : Role::left_upper_arm, limb.upper);
  give(leg ? Role::left_lower_leg : Role::left_lower_arm, limb.lower);
  give(leg ? Role::left_foot : Role::left_hand, limb.end);
  if (leg) give(Role::left_toes, limb.toes);
  if (!leg) give(Role::left_shoulder, limb.girdle);
}

// Feet that something else moves hang where legs do not. Of each role one is told.
void tell_of_lost_ends(const Body& body, const Doubt& doubt) {
  std::array<bool, kRoleCount> told{};
  for (std::size_t j = 0; j < body.size(); ++j) {
    const JointPart& p = body.parts[j];
    const bool foot = p.part == Part::foot, hand = p.part == Part::hand;
    if ((!foot && !hand) || !p.own_side || body.role(static_cast<int>(j)) != Role::none ||
        body.is_end(static_cast<int>(j)))
      continue;
    const Role end = on_side(foot ? Role::left_foot : Role::left_hand, p.side);
    const int upper = body.joint_of(on_side(foot ? Role::left_upper_leg : Role::left_upper_arm, p.side));
    if (upper == kNone || body.joint_of(end) != kNone || body.is_at_or_above(upper, static_cast<int>(j))) continue;
    if (std::exchange(told[static_cast<std::size_t>(end)], true)) continue;
    doubt(static_cast<int>(j), "it does not hang below \"" + body.names[to_index(upper)] + "\"");
  }
}

// The joints of one finger below a joint, each below the one before; empty if they lie otherwise.
std::vector<int> joints_of_finger(const Body& body, int above, Part finger, Side side) {
  std::vector<int> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    const int joint = static_cast<int>(j);
    const JointPart& p = body.parts[j];
    if (p.part != finger || p.side != side || body.is_end(joint) || !body.is_at_or_above(above, joint)) continue;
    if (!out.empty() && !body.is_at_or_above(out.back(), joint)) return {};
    out.push_back(joint);
  }
  return out;
}

// A finger may begin in the palm; the joint numbered 1 is the first outside. A thumb has no joint there.
std::size_t first_of(const Body& body, const std::vector<int>& joints, Part finger) {
  if (finger == Part::thumb) return 0;
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (body.part(joints[i]).number == 1 && joints.size() - i >= 3) return i;
  return 0;
}

constexpr double kMirroredChains = 0.03;                  // of the height: how far mirrored joints may be off
constexpr double kOnGround = 0.15;                        // of the height: where feet are
constexpr double kShortestLeg = 0.25;                     // of the height
constexpr double kMostUneven = 2;                         // upper by lower part of a limb, and the other way round
constexpr double kLeastShare = 0.5;                       // of both parts in what hangs below a limb's first joint
constexpr std::size_t kLeastJoints = 3, kMostJoints = 5;  // of a leg from its first joint on

struct Chains {
  int above = kNone;
  std::vector<int> joints[2];  // of the side where x is less, and of the other
  double length = 0;
};

struct Span2 {
  double low = 0, height = 0;
};

Span2 height_of(const Body& body) {
  double low = body.places[0].y, high = low;
  for (const glm::dvec3& place : body.places) {
    low = std::min(low, place.y);
    high = std::max(high, place.y);
  }
  return {low, high - low};
}

// How many joints hang below one another from each joint on.
std::vector<int> depths_of(const Body& body) {
  std::vector<int> out(body.size(), 1);
  for (std::size_t j = body.size(); j-- > 0;)
    if (const int parent = body.parents[j]; parent != kNone)
      out[to_index(parent)] = std::max(out[to_index(parent)], out[j] + 1);
  return out;
}

// From a joint down, always where most joints follow.
std::vector<int> longest_way(const Body& body, const std::vector<int>& depths, int from) {
  std::vector<int> out;
  for (int j = from; j != kNone;) {
    out.push_back(j);
    int next = kNone;
    for (const int child : body.children[to_index(j)])
      if (next == kNone || depths[to_index(child)] > depths[to_index(next)]) next = child;
    j = next;
  }
  return out;
}

double length_from(const Body& body, const std::vector<int>& joints, std::size_t from) {
  double sum = 0;
  for (std::size_t i = from + 1; i < joints.size(); ++i)
    sum += glm::length(body.place(joints[i]) - body.place(joints[i - 1]));
  return sum;
}

bool mirror_each_other(const Body& body, const std::vector<int>& a, const std::vector<int>& b, double middle,
                       double tolerance) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    glm::dvec3 mirrored = body.place(b[i]);
    mirrored.x = 2 * middle - mirrored.x;
    if (!(glm::length(body.place(a[i]) - mirrored) <= tolerance)) return false;
  }
  return std::abs(body.place(a.back()).x - body.place(b.back()).x) > tolerance;
}

std::vector<Chains> mirrored_chains(const Body& body, double tolerance) {
  const std::vector<int> depths = depths_of(body);
  constexpr std::size_t kMostChildren = 32;
  std::vector<Chains> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    std::vector<int> deep;
    for (const int child : body.children[j])
      if (to_index(depths[to_index(child)]) >= kLeastJoints && deep.size() < kMostChildren) deep.push_back(child);
    // Only ways of the same length mirror each other. So all ways together have hardly more joints than the skeleton.
    const auto depth = [&](int child) { return depths[to_index(child)]; };
    std::vector<std::vector<int>> ways;
    for (const int child : deep)
      if (std::ranges::count(deep, depth(child), depth) > 1) ways.push_back(longest_way(body, depths, child));
    for (std::size_t a = 0; a < ways.size(); ++a)
      for (std::size_t b = a + 1; b < ways.size(); ++b) {
        if (!mirror_each_other(body, ways[a], ways[b], body.places[j].x, tolerance)) continue;
        const bool in_order = body.place(ways[a].back()).x < body.place(ways[b].back()).x;
        out.push_back(
            {static_cast<int>(j), {ways[in_order ? a : b], ways[in_order ? b : a]}, length_from(body, ways[a], 0)});
      }
  }
  return out;
}

// Where the two longest parts in a row begin, if they are those of a limb; else past the end.
std::size_t first_of_limb(const Body& body, const std::vector<int>& joints, bool down) {
  std::size_t best = joints.size();
  double longest = 0;
  for (std::size_t i = 0; i + 2 < joints.size(); ++i) {
    const glm::dvec3 a = body.place(joints[i + 1]) - body.place(joints[i]),
                     b = body.place(joints[i + 2]) - body.place(joints[i + 1]);
    const double la = glm::length(a), lb = glm::length(b);
    if (down && !(a.y < -0.5 * la && b.y < -0.5 * lb)) continue;
    if (!(la + lb > longest) || la > kMostUneven * lb || lb > kMostUneven * la) continue;
    longest = la + lb;
    best = i;
  }
  return longest >= kLeastShare * length_from(body, joints, std::min(best, joints.size() - 1)) ? best : joints.size();
}

bool carries(const Body& body, int joint) {
  return body.carries.empty() ? !body.children[to_index(joint)].empty() : body.carries[to_index(joint)] != 0;
}

struct Limbs {
  Chains chains;
  std::size_t first = 0;
};

// From hips up: above which joint a leg and a front leg hang.
void give(Body& body, const Limbs& limbs, bool leg, bool left_is_less) {
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<int>& j = limbs.chains.joints[side];
    const Side s = (side == 0) == left_is_less ? Side::left : Side::right;
    const std::size_t i = limbs.first;
    body.give(on_side(leg ? Role::left_upper_leg : Role::left_upper_arm, s), j[i]);
    body.give(on_side(leg ? Role::left_lower_leg : Role::left_lower_arm, s), j[i + 1]);
    body.give(on_side(leg ? Role::left_foot : Role::left_hand, s), j[i + 2]);
    if (leg && i + 3 < j.size() && carries(body, j[i + 3])) body.give(on_side(Role::left_toes, s), j[i + 3]);
    if (!leg && i > 0) body.give(on_side(Role::left_shoulder, s), j[i - 1]);
  }
}

// Along z: where toes point, or where front legs are; 0: not known.
double forward_of(const Body& body, const Limbs& legs, const Limbs* front) {
  if (front != nullptr) return body.place(front->chains.above).z - body.place(legs.chains.above).z;
  double sum = 0;
  for (const std::vector<int>& j : legs.chains.joints)
    if (legs.first + 3 < j.size()) sum += body.place(j[legs.first + 3]).z - body.place(j[legs.first + 2]).z;
  return sum;
}

// Legs; and front legs, if there are. False: neither, or too many.
bool find_legs(const Body& body, const std::vector<Chains>& all, const Span2& height, std::vector<Limbs>& out) {
  for (const Chains& c : all) {
    double lowest = body.place(c.joints[0][0]).y;
    for (const int j : c.joints[0]) lowest = std::min(lowest, body.place(j).y);
    if (lowest > height.low + kOnGround * height.height) continue;
    if (body.place(c.joints[0][0]).y - lowest < kShortestLeg * height.height) continue;
    const std::size_t first = first_of_limb(body, c.joints[0], true);
    // Girdles and hocks of animals make chains longer, and then nobody knows which joint is the knee.
    const std::size_t behind = c.joints[0].size() - first;
    if (first < c.joints[0].size() && behind <= kMostJoints && first <= 1) out.push_back({c, first});
  }
  if (out.size() == 2 && out[0].chains.above != out[1].chains.above &&
      body.is_at_or_above(out[1].chains.above, out[0].chains.above))
    std::swap(out[0], out[1]);
  if (out.empty() || out[0].first > 0) return false;
  return out.size() == 1 || (out.size() == 2 && out[0].chains.above != out[1].chains.above &&
                             body.is_at_or_above(out[0].chains.above, out[1].chains.above));
}

bool find_arms(const Body& body, const std::vector<Chains>& all, const Limbs& legs, Limbs& out) {
  bool found = false;
  for (const Chains& c : all) {
    if (c.above == legs.chains.above || !body.is_at_or_above(legs.chains.above, c.above)) continue;
    const std::size_t first = first_of_limb(body, c.joints[0], false);
    if (first == c.joints[0].size() || (found && c.length <= out.chains.length)) continue;
    out = {c, first};
    found = true;
  }
  return found;
}

}  // namespace

void find_limbs(Body& body, const Doubt& doubt) {
  for (const bool leg : {true, false})
    for (const Side side : {Side::left, Side::right}) find_limb(body, leg, side, doubt);
  tell_of_lost_ends(body, doubt);
}

void find_fingers(Body& body) {
  constexpr std::pair<Part, Role> kFingers[] = {{Part::thumb, Role::left_thumb_metacarpal},
                                                {Part::index, Role::left_index_proximal},
                                                {Part::middle, Role::left_middle_proximal},
                                                {Part::ring, Role::left_ring_proximal},
                                                {Part::little, Role::left_little_proximal}};
  for (const Side side : {Side::left, Side::right}) {
    int above = body.joint_of(on_side(Role::left_hand, side));
    if (above == kNone) above = body.joint_of(on_side(Role::left_lower_arm, side));
    if (above == kNone) continue;
    for (const auto& [part, role] : kFingers) {
      const std::vector<int> joints = joints_of_finger(body, above, part, side);
      const std::size_t first = first_of(body, joints, part);
      for (std::size_t i = first; i < joints.size() && i < first + 3; ++i)
        body.give(on_side(static_cast<Role>(static_cast<std::size_t>(role) + i - first), side), joints[i]);
    }
  }
}

void find_by_shape(Body& body) {
  const bool named = std::ranges::any_of(body.parts, [](const JointPart& p) {
    return p.part != Part::none && p.part != Part::unknown && p.part != Part::other && p.part != Part::root;
  });
  if (named || body.size() == 0) return;
  const Span2 height = height_of(body);
  const std::vector<Chains> all = mirrored_chains(body, kMirroredChains * height.height);
  std::vector<Limbs> legs;
  if (!find_legs(body, all, height, legs)) return;
  const double forward = forward_of(body, legs[0], legs.size() == 2 ? &legs[1] : nullptr);
  if (!(std::abs(forward) > kMirroredChains * height.height)) return;
  Limbs arms;
  const bool has_arms = legs.size() == 2 || find_arms(body, all, legs[0], arms);
  if (legs.size() == 2) arms = legs[1];
  body.is_nameless = true;
  // Left is where x is less if the character looks against z.
  give(body, legs[0], true, forward < 0);
  if (has_arms) give(body, arms, false, forward < 0);
}
}  // namespace marrow::cook
