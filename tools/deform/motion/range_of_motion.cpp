#include "deform/motion/range_of_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <glm/geometric.hpp>

#include "common/elementary.h"

namespace marrow::deform {

std::vector<char> turned_along(std::uint32_t joint, const std::vector<int>& parents) {
  std::vector<char> out(parents.size(), 0);
  for (std::size_t j = 0; j < parents.size(); ++j) {
    std::size_t up = j;
    while (up != joint && parents[up] >= 0) up = static_cast<std::size_t>(parents[up]);
    out[j] = up == joint;
  }
  return out;
}

Pose turned(const std::vector<char>& turns, const glm::dvec3& centre, const glm::dmat3& turn) {
  Pose out(turns.size(), Matrix(1.0));
  for (std::size_t j = 0; j < out.size(); ++j)
    if (turns[j] != 0) out[j] = {turn[0], turn[1], turn[2], centre - turn * centre};
  return out;
}

namespace {

constexpr double kLeastTurn_rad = 5 * std::numbers::pi / 180;
constexpr double kLeastLikeness = 0.5;  // cosine between the axis that was meant and what limits leave of it
constexpr double kLeastShare = 1e-6;    // of a vertex
constexpr double kLeastLength = 1e-6;   // of the diagonal

bool is_finite(const glm::dvec3& p) {
  return deform::is_finite(Positions{p});
}

glm::dquat turn_about(const glm::dvec3& axis, double angle_rad) {
  const double s = tools::sine(angle_rad / 2);
  return {tools::cosine(angle_rad / 2), s * axis.x, s * axis.y, s * axis.z};
}

// 0 … π.
double angle_of(const glm::dquat& q) {
  return 2 * tools::angle_of(glm::length(glm::dvec3(q.x, q.y, q.z)), std::abs(q.w));
}

// What a joint turns, and which of the vertices that is.
struct Branch {
  std::shared_ptr<const std::vector<char>> turns;  // of joints
  std::vector<double> shares;                      // of vertices

  Branch(const SkinnedMesh& mesh, const std::vector<int>& parents, std::uint32_t joint) {
    std::vector<char> below = turned_along(joint, parents);
    shares = turned_shares(mesh, below);
    turns = std::make_shared<const std::vector<char>>(std::move(below));
  }

  bool moves_any() const {
    return std::ranges::any_of(shares, [](double s) { return s > kLeastShare; });
  }
  // Whether a vertex goes along in part, or a triangle with some of its vertices.
  bool deforms(const SkinnedMesh& mesh) const {
    if (std::ranges::any_of(shares, [](double s) { return s > kLeastShare && s < 1 - kLeastShare; })) return true;
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const double a = shares[mesh.indices[t]];
      for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(shares[mesh.indices[t + i]] - a) > kLeastShare) return true;
    }
    return false;
  }
};

struct Rig {
  const SkinnedMesh& mesh;
  const std::vector<int>& parents;
  const std::vector<glm::dvec3>& centres;
  double least_length;

  // Unit; none for a direction that is too short or not finite.
  std::optional<glm::dvec3> unit(const glm::dvec3& v) const {
    const double length = tools::length_of(v.x, v.y, v.z, 0);
    if (!(length > least_length) || !std::isfinite(length)) return std::nullopt;
    return v / length;
  }

  std::optional<glm::dvec3> to_children(std::uint32_t joint) const {
    glm::dvec3 sum(0);
    double count = 0;
    for (std::size_t j = 0; j < parents.size(); ++j) {
      if (parents[j] != static_cast<int>(joint) || !is_finite(centres[j])) continue;
      sum += centres[j] - centres[joint];
      ++count;
    }
    return count > 0 ? unit(sum / count) : std::nullopt;
  }

  std::optional<glm::dvec3> to_vertices(std::uint32_t joint, const Branch& branch) const {
    glm::dvec3 sum(0);
    double total = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      sum += (mesh.positions[v] - centres[joint]) * branch.shares[v];
      total += branch.shares[v];
    }
    return unit(sum / total);
  }

  std::optional<glm::dvec3> bone(std::uint32_t joint, const Branch& branch) const {
    if (const auto along = to_children(joint)) return along;
    if (const auto along = to_vertices(joint, branch)) return along;
    const int parent = parents[joint];
    return parent < 0 ? std::nullopt : unit(centres[joint] - centres[static_cast<std::size_t>(parent)]);
  }
};

glm::dvec3 across(const glm::dvec3& bone) {
  int least = 0;
  for (int c = 1; c < 3; ++c)
    if (std::abs(bone[c]) < std::abs(bone[least])) least = c;
  glm::dvec3 axis(0);
  axis[least] = 1;
  return glm::normalize(glm::cross(bone, axis));
}

// The poses of one joint.
class Turns {
 public:
  Turns(const MotionOptions& options, std::uint32_t joint, const glm::dvec3& centre, const Branch& branch)
      : options_(options), joint_(joint), centre_(centre), branch_(branch) {}

  void add(MotionKind kind, const glm::dvec3& axis, double most_rad) {
    for (const double sign : {1.0, -1.0})
      for (std::uint32_t i = 1; i <= options_.steps; ++i) add_one(kind, axis, sign * most_rad * i / options_.steps);
  }
  bool has(MotionKind kind) const { return std::ranges::find(poses_, kind, &MotionPose::kind) != poses_.end(); }
  std::vector<MotionPose> take() { return std::move(poses_); }

 private:
  void add_one(MotionKind kind, const glm::dvec3& wanted, double angle_rad) {
    glm::dquat turn = turn_about(wanted, angle_rad);
    glm::dvec3 axis = wanted;
    if (options_.nearest_allowed) {
      turn = options_.nearest_allowed(joint_, turn);
      if (!std::isfinite(glm::dot(turn, turn)) || !is_new(turn)) return;
      const glm::dvec3 about = glm::dvec3(turn.x, turn.y, turn.z) * (turn.w < 0 ? -1.0 : 1.0);
      const double side = glm::dot(about, wanted) < 0 ? -1.0 : 1.0;
      axis = glm::normalize(about) * side;
      if (glm::dot(axis, wanted) < kLeastLikeness) return;
      angle_rad = angle_of(turn) * side;
    }
    turns_.push_back(turn);
    poses_.push_back({joint_, kind, angle_rad, axis, centre_, branch_.turns});
  }

  bool is_new(const glm::dquat& turn) const {
    if (angle_of(turn) < kLeastTurn_rad) return false;
    return std::ranges::none_of(
        turns_, [&](const glm::dquat& other) { return angle_of(glm::conjugate(other) * turn) < kLeastTurn_rad; });
  }

  const MotionOptions& options_;
  std::uint32_t joint_;
  glm::dvec3 centre_;
  const Branch& branch_;
  std::vector<glm::dquat> turns_;
  std::vector<MotionPose> poses_;
};

void add_joint(const Rig& rig, const MotionOptions& options, std::uint32_t joint, RangeOfMotion& out) {
  const auto leave_out = [&](LeftOut::Why why) { out.left_out.push_back({joint, why}); };
  const Branch branch(rig.mesh, rig.parents, joint);
  if (!branch.moves_any()) return leave_out(LeftOut::Why::no_vertices);
  if (!branch.deforms(rig.mesh)) return leave_out(LeftOut::Why::moves_as_one);
  if (!is_finite(rig.centres[joint])) return leave_out(LeftOut::Why::not_finite);
  const std::optional<glm::dvec3> bone = rig.bone(joint, branch);
  if (!bone) return leave_out(LeftOut::Why::no_axis);
  const glm::dvec3 bend = across(*bone);
  Turns turns(options, joint, rig.centres[joint], branch);
  turns.add(MotionKind::twist, *bone, options.twist_rad);
  turns.add(MotionKind::bend, bend, options.bend_rad);
  turns.add(MotionKind::other_bend, glm::cross(*bone, bend), options.bend_rad);
  const bool twists = turns.has(MotionKind::twist),
             bends = turns.has(MotionKind::bend) || turns.has(MotionKind::other_bend);
  if (!twists || !bends)
    leave_out(twists ? LeftOut::Why::limits_of_bends : bends ? LeftOut::Why::limits_of_twist : LeftOut::Why::limits);
  for (MotionPose& pose : turns.take()) out.poses.push_back(std::move(pose));
}

}  // namespace

const char* name_of(MotionKind kind) {
  const char* const names[] = {"twist", "bend", "other bend"};
  return names[static_cast<std::size_t>(kind)];
}

const char* text_of(LeftOut::Why why) {
  const char* const texts[] = {
      "no vertex follows it",      "all that follows it moves as one", "its place in the bind pose is not finite",
      "its bone has no direction", "its limits forbid all turns",      "its limits forbid twists",
      "its limits forbid bends"};
  return texts[static_cast<std::size_t>(why)];
}

Pose MotionPose::pose() const {
  return turned(*turns, centre, glm::mat3_cast(turn_about(axis, angle_rad)));
}

std::vector<double> turned_shares(const SkinnedMesh& mesh, const std::vector<char>& turns) {
  std::vector<double> out;
  for (const std::vector<Influence>& influences : mesh.influences) {
    double share = 0;
    for (const Influence& i : influences)
      if (turns[i.joint] != 0) share += i.weight;
    out.push_back(share);
  }
  return out;
}

RangeOfMotion range_of_motion(const SkinnedMesh& mesh, const std::vector<int>& parents,
                              const std::vector<glm::dvec3>& centres, const MotionOptions& options) {
  const Rig rig{mesh, parents, centres, kLeastLength * diagonal(mesh)};
  RangeOfMotion out;
  for (std::uint32_t joint = 0; joint < mesh.joint_count; ++joint) add_joint(rig, options, joint, out);
  return out;
}

}  // namespace marrow::deform
