#include "pose/reach.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "common/distinct.h"
#include "common/failure.h"
#include "text/nearest.h"

namespace marrow::tools {
namespace {

constexpr std::uint16_t kIterations = 64;
// Of a chain's length: a miss of less cannot be seen.
constexpr float kMissShare = 1e-3f;

[[noreturn]] void refuse(const std::string& goal, std::string rule) {
  throw Failure(Exit::usage, "--ik", "", "\"" + goal + "\": " + std::move(rule),
                "give JOINT=X,Y,Z, a joint by name and a point of the scene in metres");
}

// Joints that share out a bone's twist do not bend: rigs call them so.
bool is_twist(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.find("twist") != std::string::npos || name.find("roll") != std::string::npos;
}

// Joints above `joint` that bend, the nearest first.
std::vector<std::uint16_t> above(const File& file, const Skeleton& skeleton, std::uint32_t joint, std::uint32_t most) {
  std::vector<std::uint16_t> out;
  for (std::uint16_t j = skeleton.parents[joint]; j != kNoJoint && out.size() < most; j = skeleton.parents[j])
    if (!is_twist(file.text(skeleton.names[j]))) out.push_back(j);
  return out;
}

void check_solved(Status status, const Skeleton& skeleton) {
  if (status == Status::ok) return;
  throw Failure(Exit::invalid, "--ik", std::string("skeleton \"") + skeleton.name + "\"",
                "the pose or the goals are beyond what can be solved", "look for poses that are not finite");
}

}  // namespace

std::uint32_t bending_joints_above(const File& file, const Skeleton& skeleton, std::uint32_t joint,
                                   std::uint32_t most) {
  return static_cast<std::uint32_t>(above(file, skeleton, joint, most).size());
}

Reach::Reach(const File& file, const ReachArguments& arguments)
    : file_(file),
      solver_(arguments.solver),
      seed_(arguments.seed),
      joints_(arguments.solver.method ? arguments.joints : 2) {
  for (const std::string& text : arguments.goals) {
    const std::size_t equals = text.rfind('=');
    Goal goal;
    auto& [x, y, z] = goal.position;
    int end = 0;
    if (equals == std::string::npos) refuse(text, "no point");
    const std::string point = text.substr(equals + 1);
    const bool read = std::sscanf(point.c_str(), "%f,%f,%f%n", &x, &y, &z, &end) == 3;
    if (!read || static_cast<std::size_t>(end) != point.size()) refuse(text, "no point");
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) refuse(text, "the point is not finite");
    goal.name = text.substr(0, equals);
    bool found = false;
    std::vector<std::string> names;
    for (std::uint32_t s = 0; s < file.skeleton_count() && !found; ++s) {
      const Skeleton skeleton = file.skeleton(s);
      for (std::uint32_t j = 0; j < skeleton.joint_count && !found; ++j) {
        names.emplace_back(file.text(skeleton.names[j]));
        if (goal.name != names.back()) continue;
        goal.skeleton = s;
        goal.joint = j;
        found = true;
        const std::size_t least = solver_.method ? 1 : 2;
        if (above(file_, skeleton, j, joints_).size() < least) refuse(text, "too few joints above it");
      }
    }
    if (!found) throw Failure(Exit::usage, "--ik", "", "no joint \"" + goal.name + "\"", suggestion(goal.name, names));
    goals_.push_back(std::move(goal));
  }
}

void Reach::apply(std::uint32_t skeleton, const Pose& pose) const {
  if (std::ranges::find(goals_, skeleton, &Goal::skeleton) == goals_.end()) return;
  if (!solver_.method) return solve_limbs(skeleton, pose);
  solve_chains(skeleton, pose);
}

float Reach::miss_m(const Goal& goal, Span<const Affine> model_from_joint) const {
  const auto distance = [](const Affine& joint, const std::array<float, 3>& p) {
    return std::hypot(joint.rows[0][3] - p[0], joint.rows[1][3] - p[1], joint.rows[2][3] - p[2]);
  };
  float length = 0;
  const Affine* below = &model_from_joint[goal.joint];
  for (const std::uint16_t j : above(file_, file_.skeleton(goal.skeleton), goal.joint, joints_)) {
    const Affine& joint = model_from_joint[j];
    length += distance(joint, {below->rows[0][3], below->rows[1][3], below->rows[2][3]});
    below = &joint;
  }
  const float miss = distance(model_from_joint[goal.joint], goal.position);
  return miss > IkOptions().tolerance_m + kMissShare * length ? miss : 0;
}

std::vector<std::string> Reach::chain(const Goal& goal) const {
  const Skeleton skeleton = file_.skeleton(goal.skeleton);
  std::vector<std::string> out{goal.name};
  for (const std::uint16_t j : above(file_, skeleton, goal.joint, joints_))
    out.emplace_back(file_.text(skeleton.names[j]));
  std::ranges::reverse(out);
  return out;
}

void Reach::solve_limbs(std::uint32_t skeleton, const Pose& pose) const {
  for (const Goal& goal : goals_) {
    if (goal.skeleton != skeleton) continue;
    const std::vector<std::uint16_t> joints = above(file_, pose.skeleton, goal.joint, 2);
    TwoBone two_bone;
    std::ranges::copy(goal.position, two_bone.target);
    check_solved(solve_two_bone(pose, {joints[1], joints[0], goal.joint}, two_bone), pose.skeleton);
  }
}

void Reach::solve_chains(std::uint32_t skeleton, const Pose& pose) const {
  std::vector<IkGoal> goals;
  std::vector<std::uint16_t> joints;
  for (const Goal& from : goals_) {
    if (from.skeleton != skeleton) continue;
    IkGoal& goal = goals.emplace_back();
    goal.joint = static_cast<std::uint16_t>(from.joint);
    std::ranges::copy(from.position, goal.position);
    const std::vector<std::uint16_t> turning = above(file_, pose.skeleton, from.joint, joints_);
    joints.insert(joints.end(), turning.begin(), turning.end());
  }
  make_distinct(joints);
  IkProblem problem;
  problem.goals = goals;
  problem.joints = joints;
  problem.limits = pose.skeleton.limits;
  IkOptions options;
  options.method = *solver_.method;
  options.max_iterations = kIterations;
  options.seed = seed_;
  std::vector<std::byte> scratch(solver_.is_genetic ? ik_genetic_scratch_bytes(pose.skeleton, problem)
                                                    : ik_scratch_bytes(pose.skeleton, problem, options));
  check_solved(solver_.is_genetic ? solve_ik_genetic(pose, problem, options, scratch)
                                  : solve_ik(pose, problem, options, scratch),
               pose.skeleton);
}

}  // namespace marrow::tools
