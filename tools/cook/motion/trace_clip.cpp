#include "cook/motion/trace_clip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "cook/clip/measure/rig.h"

namespace marrow::cook {
namespace {

constexpr double kFramesPerS = 60;
constexpr double kLeastDuration_s = 0.05;  // a clip of less has one pose
// So that no clip takes long: of frames, and of joints that are placed in all of them.
constexpr std::size_t kMostFrames = 1u << 15, kMostPlaced = 1u << 23;
// Of the leg: of a foot whose ankle is higher the heel does not stand.
constexpr double kHighAnkle = 0.2;

// Some joints and all above them.
class Walker {
 public:
  Walker(const Rig& rig, const std::vector<std::size_t>& joints) : rig_(&rig), world_(rig.size()) {
    std::vector<char> needed(rig.size(), 0);
    for (std::size_t joint : joints)
      for (int j = static_cast<int>(joint); j != kNone && needed[to_index(j)] == 0; j = rig.parents[to_index(j)])
        needed[to_index(j)] = 1;
    for (std::size_t j = 0; j < needed.size(); ++j)
      if (needed[j] != 0) order_.push_back(j);
  }
  std::size_t count() const { return order_.size(); }
  void pose(const SourceCurves& curves, double time_s) {
    for (const std::size_t j : order_) {
      const int parent = rig_->parents[j];
      world_[j] = rig_->place(j, parent == kNone ? nullptr : &world_[to_index(parent)], curves.at(j, time_s));
    }
  }
  const World& at(std::size_t joint) const { return world_[joint]; }

 private:
  const Rig* rig_;
  std::vector<std::size_t> order_;  // parents first
  std::vector<World> world_;
};

// What may stand: a ball, a heel.
struct TracedPoint {
  glm::dvec3 of_joint{0};
  std::vector<glm::dvec3> places;  // a frame
};
struct TracedFoot {
  std::size_t joint = 0;
  std::vector<TracedPoint> points;
};

constexpr std::array<std::array<Role, 2>, 4> kLegs = {{{Role::left_foot, Role::left_upper_leg},
                                                       {Role::right_foot, Role::right_upper_leg},
                                                       {Role::left_hand, Role::left_upper_arm},
                                                       {Role::right_hand, Role::right_upper_arm}}};

glm::dvec3 placed(const World& world, const glm::dvec3& point) {
  return world.linear * point + world.origin;
}

// The feet that have a sole and a leg.
std::vector<TracedFoot> find_feet(const Rig& rig, const Roles& roles, std::vector<FootTrace>& traces) {
  std::vector<TracedFoot> out;
  for (const auto& [foot_role, top_role] : kLegs) {
    const std::uint16_t joint = joint_of(roles, foot_role), top = joint_of(roles, top_role);
    const JointSole* const sole = joint != kNoJoint ? sole_of(roles, joint) : nullptr;
    if (sole == nullptr || top == kNoJoint) continue;
    const World& ankle = rig.world[joint];
    const glm::dvec3 ball(sole->place[0], sole->place[1], sole->place[2]);
    const glm::dvec3 ground = placed(ankle, ball);
    const double leg = glm::length(rig.world[top].origin - ground);
    if (!(leg > 0) || !std::isfinite(leg)) continue;
    TracedFoot foot{joint, {{ball, {}}}};
    if (ankle.origin.y - ground.y < kHighAnkle * leg)
      foot.points.push_back({glm::inverse(ankle.linear) * glm::dvec3(0, ground.y - ankle.origin.y, 0), {}});
    out.push_back(foot);
    traces.push_back({foot_role, leg, ground.y, {}});
  }
  return out;
}

std::size_t middle_of(const Rig& rig, const Roles& roles) {
  const std::uint16_t hips = joint_of(roles, Role::hips);
  return hips != kNoJoint && hips < rig.size() ? hips : 0;
}

// The rotation in a map that may scale.
glm::dquat turn_of(const glm::dmat3& linear) {
  glm::dmat3 m = linear;
  for (int c = 0; c < 3; ++c) {
    const double length = glm::length(m[c]);
    if (!(length > 0)) return {1, 0, 0, 0};
    m[c] /= length;
  }
  return glm::normalize(glm::quat_cast(m));
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// False if a place is not finite.
bool keep_lowest(const std::vector<TracedPoint>& points, double frame_s, FootTrace& out) {
  const std::size_t last = points[0].places.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const TracedPoint* low = points.data();
    for (const TracedPoint& point : points)
      if (point.places[i].y < low->places[i].y) low = &point;
    const std::size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, last);
    const glm::dvec3 way = low->places[to] - low->places[from];
    out.points.push_back({low->places[i], way / (frame_s * static_cast<double>(to - from))});
    if (!is_finite(out.points.back().place) || !is_finite(way)) return false;
  }
  return true;
}

}  // namespace

double leg_of(const ClipTrace& trace) {
  double sum = 0;
  for (const FootTrace& foot : trace.feet) sum += foot.leg_m;
  return trace.feet.empty() ? 1 : sum / static_cast<double>(trace.feet.size());
}

glm::dquat heading_of(const glm::dquat& turn) {
  const double length = glm::length(glm::dvec2(turn.w, turn.y));
  return length > 1e-6 ? glm::dquat(turn.w / length, 0, turn.y / length, 0) : glm::dquat(1, 0, 0, 0);
}

ClipTrace trace_clip(const BuiltClip& clip, const BuiltSkeleton& skeleton) {
  const Rig rig(skeleton);
  const Roles roles{skeleton.roles.roles, skeleton.roles.pairs, skeleton.roles.soles};
  ClipTrace out;
  std::vector<TracedFoot> feet = find_feet(rig, roles, out.feet);
  const std::size_t middle = middle_of(rig, roles);
  std::vector<std::size_t> joints = {middle};
  for (const TracedFoot& foot : feet) joints.push_back(foot.joint);
  Walker walker(rig, joints);
  const auto duration = static_cast<double>(clip.duration_s);
  if (!(duration >= kLeastDuration_s) || duration * kFramesPerS > static_cast<double>(kMostFrames)) return {};
  const auto steps = static_cast<std::size_t>(std::ceil(duration * kFramesPerS));
  if (walker.count() * steps > kMostPlaced) return {};
  const SourceCurves curves(clip, skeleton);
  for (std::size_t frame = 0; frame <= steps; ++frame) {
    walker.pose(curves, duration * static_cast<double>(frame) / static_cast<double>(steps));
    const World& hips = walker.at(middle);
    out.hips.push_back(hips.origin);
    out.hips_turn.push_back(glm::normalize(turn_of(hips.linear) * glm::conjugate(turn_of(rig.world[middle].linear))));
    if (!is_finite(hips.origin)) return {};
    for (TracedFoot& foot : feet)
      for (TracedPoint& point : foot.points) point.places.push_back(placed(walker.at(foot.joint), point.of_joint));
  }
  out.frame_s = duration / static_cast<double>(steps);
  for (std::size_t f = 0; f < feet.size(); ++f)
    if (!keep_lowest(feet[f].points, out.frame_s, out.feet[f])) return {};
  return out;
}

}  // namespace marrow::cook
