// The arithmetic behind posing: forward kinematics, two-bone limbs, monotone periodic curves.
#include "acting/motion.h"

#include <algorithm>
#include <cmath>

namespace marrow::sample {
namespace {

std::size_t at(int joint) {
  return static_cast<std::size_t>(joint);
}

struct Placed {
  glm::vec3 position;
  glm::quat turn;  // against rest, in model space
};

Placed place(const Pose& pose, int joint) {
  const RestJoint& rest = skeleton()[at(joint)];
  if (rest.parent < 0) return {rest.head + pose.hips, pose.turn[at(joint)]};
  const Placed parent = place(pose, rest.parent);
  const glm::vec3 arm = rest.head - skeleton()[at(rest.parent)].head;
  return {parent.position + parent.turn * arm, parent.turn * pose.turn[at(joint)]};
}

glm::mat3 limb_frame(glm::vec3 along, glm::vec3 hinge) {
  return {along, hinge, glm::cross(along, hinge)};
}

// Turns the two bones of a limb so that they run along `u` and `f`, hinged about `n`; all in the parent's rest axes.
void set_limb(Pose& pose, int upper, int lower, glm::vec3 u, glm::vec3 f, glm::vec3 n) {
  const glm::vec3 u0 = bone_direction(upper), f0 = bone_direction(lower);
  const glm::vec3 n0 = glm::normalize(glm::cross(u0, f0));
  const glm::quat q_upper = glm::quat_cast(limb_frame(u, n) * glm::transpose(limb_frame(u0, n0)));
  const glm::quat q_lower = glm::quat_cast(limb_frame(f, n) * glm::transpose(limb_frame(f0, n0)));
  pose.turn[at(upper)] = glm::normalize(q_upper);
  pose.turn[at(lower)] = glm::normalize(glm::inverse(q_upper) * q_lower);
}

using Point = std::pair<float, float>;

// Slope at a point for a monotone cubic (Fritsch-Butland).
float slope_between(const Point& before, const Point& here, const Point& after) {
  const float h0 = here.first - before.first, h1 = after.first - here.first;
  const float d0 = (here.second - before.second) / h0, d1 = (after.second - here.second) / h1;
  if (d0 * d1 <= 0) return 0;
  const float w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

// At point i, periodic.
float slope(const std::vector<Point>& points, std::size_t i) {
  const std::size_t n = points.size();
  Point before = points[(i + n - 1) % n], after = points[(i + 1) % n];
  if (i == 0) before.first -= 1;
  if (i + 1 == n) after.first += 1;
  return slope_between(before, points[i], after);
}

template <class Curve>
glm::vec3 by_axis(const std::vector<std::pair<float, glm::vec3>>& points, float at, Curve curve_of) {
  glm::vec3 result(0);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Point> one;
    one.reserve(points.size());
    for (const auto& [when, value] : points) one.emplace_back(when, value[axis]);
    result[axis] = curve_of(one, at);
  }
  return result;
}

}  // namespace

Pose::Pose() {
  turn.fill(glm::quat(1, 0, 0, 0));
  scale.fill(glm::vec3(1));
}

Pose mix(const Pose& a, const Pose& b, float share) {
  Pose out = a;
  for (std::size_t i = 0; i < out.turn.size(); ++i) {
    out.turn[i] = glm::slerp(a.turn[i], b.turn[i], share);
    out.scale[i] = glm::mix(a.scale[i], b.scale[i], share);
  }
  out.hips = glm::mix(a.hips, b.hips, share);
  out.gaze = glm::slerp(a.gaze, b.gaze, share);
  return out;
}

glm::quat turned(float x, float y, float z) {
  return glm::angleAxis(glm::radians(y), glm::vec3(0, 1, 0)) * glm::angleAxis(glm::radians(x), glm::vec3(1, 0, 0)) *
         glm::angleAxis(glm::radians(z), glm::vec3(0, 0, 1));
}

void bend(Pose& pose, int joint, float x, float y, float z) {
  pose.turn[at(joint)] = turned(x, y, z) * pose.turn[at(joint)];
}

void twist(Pose& pose, int joint, float degrees) {
  pose.turn[at(joint)] = pose.turn[at(joint)] * glm::angleAxis(glm::radians(degrees), bone_direction(joint));
}

void aim_arm(Pose& pose, int side, glm::vec3 along, glm::vec3 towards, float flex) {
  const glm::vec3 mirror(side_sign(side), 1, 1);
  const glm::vec3 u = glm::normalize(along * mirror);
  const glm::vec3 n = glm::normalize(glm::cross(u, towards * mirror));
  const glm::vec3 f = glm::angleAxis(glm::radians(flex), n) * u;
  set_limb(pose, on_side(kUpperArm, side), on_side(kForearm, side), u, f, n);
}

void plant_foot(Pose& pose, int side, const Stand& stand, glm::vec3 knee) {
  const int thigh = on_side(kThigh, side), shin = on_side(kShin, side);
  const int foot = on_side(kFoot, side), toes = on_side(kToes, side);
  const auto rest = [](int joint) { return skeleton()[at(joint)].head; };
  const glm::quat q_foot = turned(-stand.pitch, stand.yaw, 0);
  const glm::vec3 ankle0 = rest(foot);
  const glm::vec3 pivot = stand.pitch > 0 ? ankle0 + glm::vec3(0, -ankle0.y, -.04f) : rest(toes);
  const glm::vec3 ankle = pivot + stand.shift + q_foot * (ankle0 - pivot);

  const Placed hips = place(pose, skeleton()[at(thigh)].parent);
  const glm::vec3 hip = hips.position + hips.turn * (rest(thigh) - rest(skeleton()[at(thigh)].parent));
  const float l1 = glm::distance(rest(thigh), rest(shin)), l2 = glm::distance(rest(shin), rest(foot));
  const glm::vec3 reach = ankle - hip;
  const float d = std::clamp(glm::length(reach), .05f, (l1 + l2) * .9985f);
  const glm::vec3 down = glm::normalize(reach);
  const glm::vec3 front = glm::normalize(knee - down * glm::dot(knee, down));
  const float cosine = std::clamp((l1 * l1 + d * d - l2 * l2) / (2 * l1 * d), -1.0f, 1.0f);
  const float sine = std::sqrt(1 - cosine * cosine);
  const glm::vec3 u = down * cosine + front * sine;
  const glm::vec3 f = glm::normalize(down * d - u * l1);
  const glm::quat back = glm::inverse(hips.turn);
  set_limb(pose, thigh, shin, back * u, back * f, back * glm::cross(front, down));
  pose.turn[at(foot)] = glm::normalize(glm::inverse(place(pose, shin).turn) * q_foot);
  pose.turn[at(toes)] = turned(std::min(stand.pitch, 0.0f), 0, 0);
}

float curve(const std::vector<std::pair<float, float>>& points, float phase) {
  phase -= std::floor(phase);
  std::size_t i = points.size() - 1;
  while (i > 0 && points[i].first > phase) --i;
  const std::size_t j = (i + 1) % points.size();
  const float span = points[j].first + (j == 0 ? 1.0f : 0.0f) - points[i].first;
  const float t = (phase - points[i].first) / span, t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * points[i].second + (t3 - 2 * t2 + t) * span * slope(points, i) +
         (3 * t2 - 2 * t3) * points[j].second + (t3 - t2) * span * slope(points, j);
}

glm::vec3 curve(const std::vector<std::pair<float, glm::vec3>>& points, float phase) {
  return by_axis(points, phase, [](const std::vector<Point>& one, float at_phase) { return curve(one, at_phase); });
}

float passage(const std::vector<std::pair<float, float>>& points, float when) {
  if (when <= points.front().first) return points.front().second;
  if (when >= points.back().first) return points.back().second;
  std::size_t i = 0;
  while (points[i + 1].first <= when) ++i;
  const auto slope_at = [&](std::size_t k) {
    return k == 0 || k + 1 == points.size() ? 0.0f : slope_between(points[k - 1], points[k], points[k + 1]);
  };
  const float span = points[i + 1].first - points[i].first;
  const float t = (when - points[i].first) / span, t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * points[i].second + (t3 - 2 * t2 + t) * span * slope_at(i) +
         (3 * t2 - 2 * t3) * points[i + 1].second + (t3 - t2) * span * slope_at(i + 1);
}

glm::vec3 passage(const std::vector<std::pair<float, glm::vec3>>& points, float when) {
  return by_axis(points, when, [](const std::vector<Point>& one, float at_time) { return passage(one, at_time); });
}

}  // namespace marrow::sample
