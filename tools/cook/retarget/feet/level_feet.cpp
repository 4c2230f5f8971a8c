#include "cook/retarget/feet/level_feet.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

// A foot stands while it is not higher than so much of a leg's length above its lowest; what it is tilted then by up to
// twice the angle is how it rests.
constexpr double kStands = 0.02, kCosineOf12Degrees = 0.9781476007338057;
constexpr double kUnturned = 1 - 1e-9;  // of the cosine of half an angle

// How high the nodes of each foot are in the mean.
std::vector<double> heights_of(const Legs& legs, const Take& take) {
  std::vector<double> heights(legs.tops.size(), 0), count(legs.tops.size(), 0);
  for (const FootNode& node : legs.nodes) {
    heights[node.leg] += take.place(node.node).y;
    ++count[node.leg];
  }
  for (std::size_t leg = 0; leg < heights.size(); ++leg) heights[leg] /= count[leg];
  return heights;
}

// Where the take's feet are lowest in the clip: a leg. Finds the ground as well.
std::vector<double> find_lowest(Take& take, Legs& legs) {
  std::vector<double> nodes(legs.ground.size(), std::numeric_limits<double>::infinity());
  std::vector<double> feet(legs.tops.size(), std::numeric_limits<double>::infinity());
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    for (const FootNode& node : legs.nodes) nodes[node.kind] = std::min(nodes[node.kind], take.place(node.node).y);
    const std::vector<double> heights = heights_of(legs, take);
    for (std::size_t leg = 0; leg < feet.size(); ++leg) feet[leg] = std::min(feet[leg], heights[leg]);
  }
  find_ground(legs, std::move(nodes));
  return feet;
}

// The turn about y in a rotation.
glm::dquat heading_of(const glm::dquat& q) {
  const double length = std::sqrt(q.w * q.w + q.y * q.y);
  return length > 0 ? glm::dquat(q.w / length, 0, q.y / length, 0) : glm::dquat(1, 0, 0, 0);
}

glm::dquat arc_of(const RetargetJoint& joint) {
  return joint.aligned * glm::conjugate(joint.turn);
}

// Whether an ankle and the bone above it rest as in the capture.
bool rests_alike(const RetargetPlan& plan, std::size_t ankle) {
  const RetargetJoint& joint = plan.joints[ankle];
  return std::min(std::abs(arc_of(joint).w), std::abs(arc_of(plan.joints[to_index(joint.upper)]).w)) > kUnturned;
}

// Where a foot stands, the character's stands as at rest: the capture's soles may not be level at rest.
void level_feet(RetargetPlan& plan, Take& take, const std::vector<double>& lowest, const Legs& legs) {
  const double near = kStands * legs.mean_taken_length();
  std::vector<glm::dquat> sums(legs.feet.size(), glm::dquat(0, 0, 0, 0));
  for (std::size_t frame = 0; frame < take.times_s().size(); ++frame) {
    take.pose(frame);
    const std::vector<double> heights = heights_of(legs, take);
    for (std::size_t f = 0; f < sums.size(); ++f) {
      const FootJoint& foot = legs.feet[f];
      if (heights[foot.leg] > lowest[foot.leg] + near) continue;
      const RetargetJoint& joint = plan.joints[foot.joint];
      const glm::dquat turn = taken_turn(plan, joint, take);
      const glm::dquat arc = arc_of(joint);
      const glm::dquat level = glm::conjugate(turn) * heading_of(turn * arc);
      sums[f] = sums[f] + (glm::dot(level, arc) < 0 ? -level : level);
    }
  }
  std::vector<char> keeps(legs.tops.size(), 0);
  for (const FootJoint& foot : legs.feet)
    if (foot.level == 0) keeps[foot.leg] = rests_alike(plan, foot.joint) ? 1 : 0;
  for (std::size_t f = 0; f < sums.size(); ++f) {
    RetargetJoint& joint = plan.joints[legs.feet[f].joint];
    const glm::dquat level = glm::normalize(sums[f]);
    if (keeps[legs.feet[f].leg] == 0 && glm::dot(level, arc_of(joint)) >= kCosineOf12Degrees)
      joint.aligned = level * joint.turn;
  }
}

}  // namespace

glm::dquat taken_turn(const RetargetPlan& plan, const RetargetJoint& joint, const Take& take) {
  return plan.facing * take.turn(joint.at) * glm::conjugate(plan.facing);
}

void find_stance(RetargetPlan& plan, Take& take, Legs& legs) {
  const std::vector<double> lowest = find_lowest(take, legs);
  if (take.scene().is_capture) level_feet(plan, take, lowest, legs);
}

}  // namespace marrow::cook
