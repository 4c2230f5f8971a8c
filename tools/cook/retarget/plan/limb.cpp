#include "cook/retarget/plan/limb.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "cook/retarget/plan/alike_pose.h"
#include "cook/retarget/plan/retarget_puppet.h"

namespace marrow::cook {

Limb limb_of(const std::vector<RetargetJoint>& joints, std::size_t top, int middle, std::size_t end) {
  Limb out{top, end, middle, {}, {}};
  std::vector<std::size_t> between;
  for (int at = joints[end].upper; at != kNone && to_index(at) != top; at = joints[to_index(at)].upper)
    between.push_back(to_index(at));
  if (middle == kNone && between.size() == 1) out.middle = static_cast<int>(between[0]);
  if (out.middle == kNone) return out;
  bool is_below = true;
  for (const std::size_t at : between) {
    if (static_cast<int>(at) == out.middle) {
      is_below = false;
    } else {
      (is_below ? out.with_middle : out.with_top).push_back(at);
    }
  }
  if (is_below) out.middle = kNone;  // it has no counterpart
  return out;
}

double length_of(const RetargetPlan& plan, const Limb& limb) {
  if (limb.middle == kNone) return glm::length(plan.joints[limb.end].place - plan.joints[limb.top].place);
  const glm::dvec3& middle = plan.joints[to_index(limb.middle)].place;
  return glm::length(middle - plan.joints[limb.top].place) + glm::length(plan.joints[limb.end].place - middle);
}

double taken_length(const RetargetPlan& plan, const Limb& limb, const Take& take) {
  const auto rest = [&](std::size_t joint) { return take.rest(plan.joints[joint].at); };
  if (limb.middle == kNone) return glm::length(rest(limb.end) - rest(limb.top));
  const glm::dvec3 middle = rest(to_index(limb.middle));
  return glm::length(middle - rest(limb.top)) + glm::length(rest(limb.end) - middle);
}

double taken_bend(const RetargetPlan& plan, const Limb& limb, const Take& take) {
  if (limb.middle == kNone) return -1;
  const auto place = [&](std::size_t joint) { return take.place(plan.joints[joint].at); };
  const glm::dvec3 middle = place(to_index(limb.middle));
  const glm::dvec3 up = place(limb.top) - middle, down = place(limb.end) - middle;
  const double lengths = glm::length(up) * glm::length(down);
  return lengths > 0 ? std::clamp(glm::dot(up, down) / lengths, -1.0, 1.0) : -1;
}

double length_at(const RetargetPlan& plan, const Limb& limb, double bend) {
  if (limb.middle == kNone) return length_of(plan, limb);
  const glm::dvec3& middle = plan.joints[to_index(limb.middle)].place;
  const double a = glm::length(middle - plan.joints[limb.top].place);
  const double b = glm::length(plan.joints[limb.end].place - middle);
  return std::sqrt(std::max(0.0, a * a + b * b - 2 * a * b * bend));
}

void reach(const Limb& limb, const glm::dvec3& place, const glm::dvec3& ahead, double most, Puppet& puppet) {
  if (limb.middle == kNone) return;
  const std::size_t middle = to_index(limb.middle);
  const glm::dvec3 top = puppet.place(limb.top);
  const glm::dvec3 upper = puppet.place(middle) - top, lower = puppet.place(limb.end) - puppet.place(middle);
  const glm::dvec3 whole = upper + lower, wanted = place - top;
  const double a = glm::length(upper), b = glm::length(lower), before = glm::length(whole);
  const double far = glm::length(wanted);
  const double length = std::clamp(std::min(far, std::max(before, most)), std::abs(a - b), a + b);
  if (!(a > 0) || !(b > 0) || !(before > 0) || !(far > 0) || !(length > 0)) return;
  const glm::dvec3 old_way = whole / before, way = wanted / far;
  glm::dvec3 bent = upper - glm::dot(upper, old_way) * old_way;
  constexpr double kStraight = 0.02;
  const double straight = kStraight * (a + b) - glm::length(bent);
  if (straight > 0) bent += straight * ahead;
  bent = arc(old_way, way) * bent;
  bent -= glm::dot(bent, way) * way;
  if (!(glm::length(bent) > 0)) return;
  const double along = (a * a - b * b + length * length) / (2 * length);
  const glm::dvec3 new_upper = along * way + std::sqrt(std::max(0.0, a * a - along * along)) * glm::normalize(bent);
  const glm::dvec3 new_lower = length * way - new_upper;
  if (!(glm::length(new_upper) > 0) || !(glm::length(new_lower) > 0)) return;
  const auto turn = [&](std::size_t joint, const glm::dquat& by) {
    puppet.wanted[joint] = by * puppet.turns[joint];
    puppet.is_turned[joint] = 1;
  };
  const glm::dquat turned = arc(upper / a, glm::normalize(new_upper));
  const glm::dquat turned_below = arc(lower / b, glm::normalize(new_lower));
  turn(limb.top, turned);
  for (const std::size_t joint : limb.with_top) turn(joint, turned);
  turn(middle, turned_below);
  for (const std::size_t joint : limb.with_middle) turn(joint, turned_below);
}

}  // namespace marrow::cook
