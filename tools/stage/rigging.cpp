#include "stage/rigging.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "common/failure.h"
#include "marrow/limits.h"

namespace marrow::tools {

std::vector<std::uint16_t> chain_below(const Skeleton& skeleton, std::uint32_t joint) {
  std::vector<std::uint16_t> out{static_cast<std::uint16_t>(joint)};
  // Parents stand before their children.
  for (std::uint32_t j = joint + 1; j < skeleton.joint_count; ++j)
    if (skeleton.parents[j] == out.back()) out.push_back(static_cast<std::uint16_t>(j));
  return out;
}

void Rig::prepare(const Settings& settings, std::span<const NamedJoint> joints, float dt_s,
                  const Affine& world_from_model) {
  frame_.dt_s = dt_s;
  frame_.world_from_model = world_from_model;
  limits_ = settings.limits;
  weights_ = settings.weights;
  trouble_.clear();
  try {
    reach_.emplace(file_, settings.reach);
  } catch (const Failure& why) {
    reach_.reset();
    trouble_ = why.what();
  }
  if (settings.springs && !swing_files_) file_springs_ = FileSprings(file_);  // at rest again
  swing_files_ = settings.springs && has_springs();
  turns_.clear();
  for (const Turn& t : settings.turns) {
    const glm::vec3 half = glm::radians(t.degrees) / 2.0f;
    const auto about = [&](int axis) {
      glm::quat out(std::cos(half[axis]), 0, 0, 0);
      out[axis] = std::sin(half[axis]);
      return out;
    };
    if (t.joint < joints.size()) turns_.push_back({joints[t.joint], about(2) * about(1) * about(0)});
  }
  if (settings.springs && !has_springs() && settings.joint < joints.size()) {
    make_springs(settings, joints[settings.joint].skeleton, joints[settings.joint].joint);
  } else {
    spring_joints_.clear();
  }
}

void Rig::make_springs(const Settings& settings, std::uint32_t skeleton, std::uint32_t joint) {
  const Skeleton of = file_.skeleton(skeleton);
  const std::vector<std::uint16_t> joints = chain_below(of, joint);
  std::vector<SpringJoint> chain(joints.size(), settings.spring);
  for (std::size_t i = 0; i < joints.size(); ++i) chain[i].joint = joints[i];
  const SpringChain chains[] = {{chain, {0, 0, 0}}};
  Status status = Status::ok;
  if (joints == spring_joints_ && skeleton == spring_skeleton_) {
    status = set_springs(of, chains, springs_);
  } else {
    memory_ = AlignedBytes(springs_bytes(of, chains));
    status = marrow::make_springs(of, chains, {memory_.data(), memory_.size()}, springs_);
  }
  spring_skeleton_ = skeleton;
  spring_joints_ = status == Status::ok ? joints : std::vector<std::uint16_t>();
  if (status != Status::ok) trouble_ = "no joint below the chosen one: nothing swings";
}

void Rig::turn(std::uint32_t skeleton, const Pose& pose) const {
  bool any = false;
  for (const TurnedJoint& t : turns_) {
    if (t.joint.skeleton != skeleton) continue;
    JointTransform at;
    check(get_joint(pose.local, t.joint.joint, at));
    const glm::quat turned = t.by * glm::quat(at.rotation[3], at.rotation[0], at.rotation[1], at.rotation[2]);
    for (int i = 0; i < 3; ++i) at.rotation[i] = turned[i];
    at.rotation[3] = turned.w;
    check(set_joint(pose.local, t.joint.joint, at));
    any = true;
  }
  if (any) check(local_to_model(pose.skeleton, pose.local, pose.model_from_joint));
}

void Rig::change(std::uint32_t skeleton, const Pose& pose) {
  turn(skeleton, pose);
  if (limits_ && !pose.skeleton.limits.empty()) {
    check(limit_pose(pose.skeleton.limits, pose.local));
    check(local_to_model(pose.skeleton, pose.local, pose.model_from_joint));
  }
  if (reach_) reach_->apply(skeleton, pose);
  if (swing_files_ && file_springs_.has(skeleton)) file_springs_.swing(skeleton, frame_, pose);
  if (spring_joints_.empty() || skeleton != spring_skeleton_) return;
  check(simulate_springs(pose, frame_, springs_));
}

void Rig::weigh(std::uint32_t mesh, Span<float> weights) const {
  std::size_t first = 0;
  for (std::uint32_t m = 0; m < mesh; ++m) first += file_.mesh(m).targets.size;
  for (auto at = weights_.lower_bound(first); at != weights_.end() && at->first < first + weights.size; ++at)
    weights[at->first - first] = at->second;
}

}  // namespace marrow::tools
