#include "cook/prepare/retarget/retarget_stand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kQuarter = 1.5707963267948966;
constexpr double kFull = 0.05, kHardly = 0.2;  // of a leg's length above the ground, feet are moved in full, or hardly

// How far what rests on the ground may slope downwards, with the joint that it bends about so high above it.
double steepest(const SolePart& part, const glm::dvec3& joint, const glm::dvec3& forward, double height) {
  double out = kQuarter;
  for (const SolePoint& point : part.points) {
    const double ahead = glm::dot(point.rest - joint, forward), below = joint.y - point.rest.y;
    const double radius = std::hypot(ahead, below);
    if (!(ahead > 0) || radius <= height) continue;
    out = std::min(out, std::asin(std::max(0.0, height) / radius) - std::atan2(below, ahead));
  }
  return std::max(0.0, out);
}

// Raises what is ahead of a joint until it slopes no more than the ground lets it.
void bend(const RetargetPlan& plan, const Sole& sole, const SolePart& part, double height, Puppet& puppet) {
  const RetargetJoint& joint = plan.joints[part.joint];
  const glm::dquat moved = puppet.turns[part.joint] * glm::conjugate(joint.turn);
  const double slope = std::asin(std::clamp(-(moved * sole.forward).y, -1.0, 1.0));
  const double over = slope - steepest(part, joint.place, sole.forward, height);
  if (!(over > 0)) return;
  const glm::dvec3 across = moved * glm::cross(sole.forward, glm::dvec3(0, 1, 0));
  const glm::dquat raised = glm::angleAxis(over, across);
  for (const std::size_t j : part.turned) {
    puppet.wanted[j] = raised * puppet.turns[j];
    puppet.is_turned[j] = 1;
  }
}

// How high the lowest of a sole is above the ankle.
double lowest_of(const Sole& sole, const Puppet& puppet) {
  double out = std::numeric_limits<double>::infinity();
  for (const SolePart& part : sole.parts)
    for (const SolePoint& point : part.points) out = std::min(out, point.at(puppet.scene_from_joint).y);
  return out - puppet.place(sole.parts[0].joint).y;
}

// The joint between a leg's top and its ankle; kNone: there is not just one.
int knee_of(const RetargetPlan& plan, std::size_t top, std::size_t ankle) {
  const int knee = plan.joints[ankle].upper;
  return knee != kNone && plan.joints[to_index(knee)].upper == static_cast<int>(top) ? knee : kNone;
}

// Moves an ankle along y, as far as the leg reaches, in the plane of the leg. A straight one bends towards `ahead`.
void move_ankle(const RetargetPlan& plan, std::size_t top, std::size_t ankle, double up, const glm::dvec3& ahead,
                Puppet& puppet) {
  const int between = knee_of(plan, top, ankle);
  if (between == kNone || up == 0) return;
  const std::size_t knee = to_index(between);
  const glm::dvec3 hip = puppet.place(top);
  const glm::dvec3 thigh = puppet.place(knee) - hip, shin = puppet.place(ankle) - puppet.place(knee);
  const glm::dvec3 leg = thigh + shin;
  const double a = glm::length(thigh), b = glm::length(shin), before = glm::length(leg);
  const glm::dvec3 wanted = leg + glm::dvec3(0, up, 0);
  const double far = glm::length(wanted), length = std::clamp(far, std::abs(a - b), a + b);
  if (!(a > 0) || !(b > 0) || !(before > 0) || !(far > 0) || !(length > 0)) return;
  const glm::dvec3 old_way = leg / before, way = wanted / far;
  glm::dvec3 bent = thigh - glm::dot(thigh, old_way) * old_way;
  constexpr double kStraight = 0.02;
  const double straight = kStraight * (a + b) - glm::length(bent);
  if (straight > 0) bent += straight * ahead;
  bent = arc(old_way, way) * bent;
  bent -= glm::dot(bent, way) * way;
  if (!(glm::length(bent) > 0)) return;
  const double along = (a * a - b * b + length * length) / (2 * length);
  const glm::dvec3 new_thigh = along * way + std::sqrt(std::max(0.0, a * a - along * along)) * glm::normalize(bent);
  const glm::dvec3 new_shin = length * way - new_thigh;
  puppet.wanted[top] = arc(thigh / a, glm::normalize(new_thigh)) * puppet.turns[top];
  puppet.wanted[knee] = arc(shin / b, glm::normalize(new_shin)) * puppet.turns[knee];
}

// What is to become of a foot.
struct Standing {
  double place = 0;   // the ankle's, as high as its counterpart and the sole want it
  double lowest = 0;  // the sole's lowest above the ankle
};

}  // namespace

double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootHeights& heights,
             Puppet& puppet) {
  double ground = std::numeric_limits<double>::infinity(), nearest = ground;
  for (const Sole& sole : soles) ground = std::min(ground, sole.ground);
  for (const double height : heights.lowest) nearest = std::min(nearest, height);
  std::vector<Standing> standing;
  const auto height_of = [&](const Sole& sole) {
    return heights.ankle[sole.leg] + plan.joints[sole.parts[0].joint].place.y - sole.ground;
  };
  for (const Sole& sole : soles) bend(plan, sole, sole.parts[0], height_of(sole), puppet);
  puppet.pose(plan);
  for (const Sole& sole : soles)
    for (std::size_t p = 1; p < sole.parts.size(); ++p) {
      const double above_ankle = puppet.place(sole.parts[p].joint).y - puppet.place(sole.parts[0].joint).y;
      bend(plan, sole, sole.parts[p], height_of(sole) + above_ankle, puppet);
    }
  puppet.pose(plan);
  double raised = std::numeric_limits<double>::infinity();
  for (const Sole& sole : soles) {
    const double height = height_of(sole), lowest = lowest_of(sole, puppet);
    const double above = height + lowest;
    const double moved = above < 0 ? -above : std::min(0.0, heights.lowest[sole.leg] - above);
    standing.push_back({ground + height + moved, lowest});
    raised = std::min(raised,
                      standing.back().place - puppet.place(sole.parts[0].joint).y + heights.lowest[sole.leg] - nearest);
  }
  const double leg = legs.length / static_cast<double>(legs.tops.size());
  for (std::size_t s = 0; s < soles.size(); ++s) {
    const Sole& sole = soles[s];
    const std::size_t ankle = sole.parts[0].joint;
    const double now = puppet.place(ankle).y + raised;
    const double share = std::clamp((kHardly - heights.lowest[sole.leg] / leg) / (kHardly - kFull), 0.0, 1.0);
    const double up = std::max(share * (standing[s].place - now), ground - standing[s].lowest - now);
    const glm::dquat moved = puppet.turns[ankle] * glm::conjugate(plan.joints[ankle].turn);
    move_ankle(plan, legs.tops[sole.leg], ankle, up, moved * sole.forward, puppet);
  }
  puppet.pose(plan);
  return raised;
}

}  // namespace marrow::cook
