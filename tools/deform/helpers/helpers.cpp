#include "deform/helpers/helpers.h"

#include <map>

#include "deform/rotations.h"

namespace marrow::deform {
namespace {

// Whether a rotation can be told: neither of the first two columns is nothing, nor along the other.
bool has_turn(const glm::dmat3& m) {
  const double x = glm::dot(m[0], m[0]);
  const glm::dvec3 rest = m[1] - m[0] * (glm::dot(m[0], m[1]) / x);
  return x > 1e-30 && glm::dot(rest, rest) > 1e-30 + 1e-10 * glm::dot(m[1], m[1]);
}

}  // namespace

Matrix blended(const Helper& helper, const Matrix& first, const Matrix& second) {
  const double rest = 1 - helper.share, share = helper.share;
  if (!has_turn(linear_of(first)) || !has_turn(linear_of(second))) return first * rest + second * share;
  const glm::dmat3 a = rotation_of(linear_of(first)), b = rotation_of(linear_of(second));
  const glm::dquat turn = quaternion_of(b * glm::transpose(a));
  const glm::dquat sum = glm::dquat(1, 0, 0, 0) * rest + turn * share;  // at least 1/√2 long
  const glm::dmat3 linear =
      glm::mat3_cast(glm::normalize(sum)) * a *
      (glm::transpose(a) * linear_of(first) * rest + glm::transpose(b) * linear_of(second) * share);
  const glm::dvec3 from = transform(first, helper.centre), to = transform(second, helper.centre);
  glm::dvec3 moved = from * rest + to * share;
  if (helper.by_dual_quaternions) {
    const glm::dquat dual =
        glm::dquat(0, from.x, from.y, from.z) * rest + glm::dquat(0, to.x, to.y, to.z) * turn * share;
    const glm::dquat at = dual * glm::conjugate(sum) * (1 / glm::dot(sum, sum));
    moved = glm::dvec3(at.x, at.y, at.z);
  }
  return {linear[0], linear[1], linear[2], moved - linear * helper.centre};
}

void append_helpers(const std::vector<Helper>& helpers, Pose& pose) {
  for (const Helper& h : helpers) pose.push_back(blended(h, pose[h.first], pose[h.second]));
}

std::vector<Influence> on_joints(const std::vector<Influence>& weights, const std::vector<Helper>& helpers,
                                 std::uint32_t joint_count) {
  std::map<std::uint32_t, double> sums;
  for (const Influence& i : weights) {
    if (i.joint < joint_count) {
      sums[i.joint] += i.weight;
      continue;
    }
    const Helper& h = helpers[i.joint - joint_count];
    sums[h.first] += i.weight * (1 - h.share);
    sums[h.second] += i.weight * h.share;
  }
  std::vector<Influence> out;
  for (const auto& [joint, weight] : sums) out.push_back({joint, weight});
  return out;
}

}  // namespace marrow::deform
