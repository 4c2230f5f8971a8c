#include "cook/roles/find_limbs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace marrow::cook {
namespace {

// What a name says of a joint in its limb, of legs and arms alike.
enum class Step : std::uint8_t { no, girdle, socket, upper, plain, lower, hinge, end, toes };

Step step_of(const JointPart& p, bool leg) {
  switch (p.part) {
    case Part::leg_girdle:
      return leg ? Step::girdle : Step::no;
    case Part::hip:
      return leg ? Step::socket : Step::no;
    case Part::upper_leg:
      return leg ? Step::upper : Step::no;
    case Part::leg:
      return leg ? Step::plain : Step::no;
    case Part::lower_leg:
      return leg ? Step::lower : Step::no;
    case Part::ankle:
      return leg ? Step::hinge : Step::no;
    case Part::foot:
      return leg ? Step::end : Step::no;
    case Part::toes:
      return leg ? Step::toes : Step::no;
    case Part::arm_girdle:
      return leg ? Step::no : Step::girdle;
    case Part::shoulder:
      return leg ? Step::no : Step::socket;
    case Part::upper_arm:
      return leg ? Step::no : Step::upper;
    case Part::arm:
      return leg ? Step::no : Step::plain;
    case Part::lower_arm:
      return leg ? Step::no : Step::lower;
    case Part::wrist:
      return leg ? Step::no : Step::hinge;
    case Part::hand:
      return leg ? Step::no : Step::end;
    default:
      return Step::no;
  }
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

}  // namespace

void find_limbs(Body& body, const Doubt& doubt) {
  for (const bool leg : {true, false})
    for (const Side side : {Side::left, Side::right}) find_limb(body, leg, side, doubt);
  tell_of_lost_ends(body, doubt);
}

}  // namespace marrow::cook
