#include "cook/retarget/feet/retarget_stand.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "cook/retarget/plan/limb.h"

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

// A foot of a frame: where its ankle and its sole's lowest go.
class Foot {
 public:
  Foot(const RetargetPlan& plan, const Legs& legs, const Sole& sole, const FootGoals& goals)
      : sole_(sole),
        limb_(legs.limbs[sole.leg]),
        goal_(goals.place[sole.leg]),
        captured_lowest_(goals.lowest[sole.leg]),
        most_(length_at(plan, legs.limbs[sole.leg], goals.knee[sole.leg])) {
    const double leg = legs.mean_length();
    share_ = std::clamp((kHardly - captured_lowest_ / leg) / (kHardly - kFull), 0.0, 1.0);
    height_ = goals.ankle[sole.leg] + plan.joints[ankle()].place.y - sole.ground;
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
  // How far the character may be raised for the leg not to be too straight, beyond so much only in part.
  double give_way(const Puppet& puppet, double raised) const {
    if (limb_.middle == kNone) return raised;
    const glm::dvec3 top = puppet.place(limb_.top);
    const double most = std::max(most_, glm::length(puppet.place(ankle()) - top));
    const double x = goal_.x - top.x, z = goal_.z - top.z;
    const double highest = place_ + std::sqrt(std::max(0.0, most * most - x * x - z * z)) - top.y;
    return raised - share_ * std::max(0.0, raised - highest);
  }
  void move(const RetargetPlan& plan, double raised, Puppet& puppet) const {
    const glm::dvec3 now = puppet.place(ankle());
    const double up = std::max(share_ * (place_ - now.y - raised), least_ - now.y - raised);
    const glm::dvec3 to(now.x + share_ * (goal_.x - now.x), now.y + up, now.z + share_ * (goal_.z - now.z));
    const glm::dquat moved = puppet.turns[ankle()] * glm::conjugate(plan.joints[ankle()].turn);
    reach(limb_, to, moved * sole_.forward, most_, puppet);
  }

 private:
  // What the sole may not come below, above the ground.
  double floor() const { return share_ * captured_lowest_; }

  const Sole& sole_;
  const Limb& limb_;
  glm::dvec3 goal_;
  double captured_lowest_, most_, share_ = 0, height_ = 0, lowest_ = 0, place_ = 0, least_ = 0;
};

}  // namespace

double stand(const RetargetPlan& plan, const Legs& legs, const std::vector<Sole>& soles, const FootGoals& goals,
             Puppet& puppet) {
  double ground = std::numeric_limits<double>::infinity(), raised = ground;
  for (const Sole& sole : soles) ground = std::min(ground, sole.ground);
  const double nearest = *std::ranges::min_element(goals.lowest);
  std::vector<Foot> feet;
  for (const Sole& sole : soles) feet.emplace_back(plan, legs, sole, goals);
  for (const Foot& foot : feet) foot.bend_part(plan, 0, puppet);
  puppet.pose(plan);
  for (const Foot& foot : feet) foot.bend_toes(plan, puppet);
  puppet.pose(plan);
  for (Foot& foot : feet) raised = std::min(raised, foot.find_place(puppet, ground, nearest));
  for (const Foot& foot : feet) raised = foot.give_way(puppet, raised);
  for (const Foot& foot : feet) foot.move(plan, raised, puppet);
  puppet.pose(plan);
  return raised;
}

}  // namespace marrow::cook
