#include "cook/prepare/retarget/retarget_stand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "common/elementary.h"

namespace marrow::cook {
namespace {

constexpr double kQuarter = 1.5707963267948966;
constexpr double kFull = 0.05, kHardly = 0.2;  // of a leg's length above the ground, feet are moved in full, or hardly

double arc_sine(double x) {
  return kQuarter - tools::arc_cosine(x);
}

// How far what rests on the ground may slope downwards, with the joint that it bends about so high above it.
double steepest(const SolePart& part, const glm::dvec3& joint, const glm::dvec3& forward, double height) {
  double out = kQuarter;
  for (const SolePoint& point : part.points) {
    const double ahead = glm::dot(point.rest - joint, forward), below = joint.y - point.rest.y;
    const double radius = tools::length_of(ahead, below, 0, 0);
    if (!(ahead > 0) || radius <= height) continue;
    out = std::min(out, arc_sine(std::max(0.0, height) / radius) - tools::angle_of(below, ahead));
  }
  return std::max(0.0, out);
}

// Raises what is ahead of a joint until it slopes no more than the ground lets it.
void bend(const RetargetPlan& plan, const Sole& sole, const SolePart& part, double height, Puppet& puppet) {
  const RetargetJoint& joint = plan.joints[part.joint];
  const glm::dquat moved = puppet.turns[part.joint] * glm::conjugate(joint.turn);
  const double slope = arc_sine(std::clamp(-(moved * sole.forward).y, -1.0, 1.0));
  const double over = slope - steepest(part, joint.place, sole.forward, height);
  if (!(over > 0)) return;
  const glm::dvec3 across = moved * glm::cross(sole.forward, glm::dvec3(0, 1, 0));
  const double half_sine = tools::sine(over / 2);
  const glm::dquat raised(tools::cosine(over / 2), half_sine * across.x, half_sine * across.y, half_sine * across.z);
  for (const std::size_t j : part.turned) {
    puppet.wanted[j] = raised * puppet.turns[j];
    puppet.is_turned[j] = 1;
  }
}

// How high the lowest of a sole is above the ankle.
double lowest_of(const Sole& sole, const Puppet& puppet) {
  double out = std::numeric_limits<double>::infinity();
  for (const SolePart& part : sole.parts)
    for (const SolePoint& point : part.points) out = std::min(out, point.at(puppet.model_from_joint).y);
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

// A foot of a frame: where its ankle and its sole's lowest go.
class Foot {
 public:
  Foot(const RetargetPlan& plan, const Legs& legs, const Sole& sole, const FootHeights& heights)
      : sole_(sole), top_(legs.tops[sole.leg]), captured_lowest_(heights.lowest[sole.leg]) {
    const double leg = legs.length / static_cast<double>(legs.tops.size());
    share_ = std::clamp((kHardly - captured_lowest_ / leg) / (kHardly - kFull), 0.0, 1.0);
    height_ = heights.ankle[sole.leg] + plan.joints[ankle()].place.y - sole.ground;
  }
  std::size_t ankle() const { return sole_.parts[0].joint; }

  void bend_part(const RetargetPlan& plan, std::size_t part, Puppet& puppet) const {
    const double above_ankle = puppet.place(sole_.parts[part].joint).y - puppet.place(ankle()).y;
    bend(plan, sole_, sole_.parts[part], height_ + above_ankle - floor(), puppet);
  }
  void bend_toes(const RetargetPlan& plan, Puppet& puppet) const {
    for (std::size_t part = 1; part < sole_.parts.size(); ++part) bend_part(plan, part, puppet);
  }
  // Returns by how much the character is to be raised so that the leg keeps its length. `nearest`: of all feet.
  double find_place(const Puppet& puppet, double ground, double nearest) {
    lowest_ = lowest_of(sole_, puppet);
    const double above = height_ + lowest_;
    const double moved = above < floor() ? floor() - above : std::min(0.0, captured_lowest_ - above);
    place_ = ground + height_ + moved;
    least_ = ground + floor() - lowest_;
    return place_ - puppet.place(ankle()).y + captured_lowest_ - nearest;
  }
  void move(const RetargetPlan& plan, double raised, Puppet& puppet) const {
    const double now = puppet.place(ankle()).y + raised;
    const glm::dquat moved = puppet.turns[ankle()] * glm::conjugate(plan.joints[ankle()].turn);
    move_ankle(plan, top_, ankle(), std::max(share_ * (place_ - now), least_ - now), moved * sole_.forward, puppet);
  }

 private:
  // What the sole may not come below, above the ground.
  double floor() const { return share_ * captured_lowest_; }

  const Sole& sole_;
  std::size_t top_;
  double captured_lowest_, share_ = 0, height_ = 0, lowest_ = 0, place_ = 0, least_ = 0;
};

}  // namespace

double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootHeights& heights,
             Puppet& puppet) {
  double ground = std::numeric_limits<double>::infinity(), raised = ground;
  for (const Sole& sole : soles) ground = std::min(ground, sole.ground);
  const double nearest = *std::ranges::min_element(heights.lowest);
  std::vector<Foot> feet;
  for (const Sole& sole : soles) feet.emplace_back(plan, legs, sole, heights);
  for (const Foot& foot : feet) foot.bend_part(plan, 0, puppet);
  puppet.pose(plan);
  for (const Foot& foot : feet) foot.bend_toes(plan, puppet);
  puppet.pose(plan);
  for (Foot& foot : feet) raised = std::min(raised, foot.find_place(puppet, ground, nearest));
  for (const Foot& foot : feet) foot.move(plan, raised, puppet);
  puppet.pose(plan);
  return raised;
}

}  // namespace marrow::cook
