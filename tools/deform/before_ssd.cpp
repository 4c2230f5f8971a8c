#include "deform/before_ssd.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "deform/rotation_of_matrix.h"
#include "deform/slerp.h"

namespace marrow::deform {
namespace {

std::vector<std::uint32_t> segments_of(const SkinnedMesh& mesh) {
  std::vector<std::uint32_t> out;
  for (const std::vector<Influence>& influences : mesh.influences)
    out.push_back(std::ranges::max_element(influences, {}, &Influence::weight)->joint);
  return out;
}

double weight_of(const std::vector<Influence>& influences, std::uint32_t joint) {
  const auto found = std::ranges::find(influences, joint, &Influence::joint);
  return found == influences.end() ? 0 : found->weight;
}

}  // namespace

SkinnedMesh stitched(SkinnedMesh mesh) {
  constexpr double kEqual = 1e-9;
  const std::vector<std::uint32_t> segments = segments_of(mesh);
  std::vector<std::uint32_t> partner = segments;
  const auto offer = [&](std::uint32_t v, std::uint32_t joint) {
    const auto weight = [&](std::uint32_t j) { return weight_of(mesh.influences[v], j); };
    if (partner[v] == segments[v] || weight(joint) > weight(partner[v]) ||
        (weight(joint) == weight(partner[v]) && joint < partner[v]))
      partner[v] = joint;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    if (segments[a] == segments[b]) continue;
    const auto apart = [&](std::uint32_t v) {
      return std::abs(weight_of(mesh.influences[v], segments[a]) - weight_of(mesh.influences[v], segments[b]));
    };
    const double difference = apart(a) - apart(b);
    const bool takes_a = std::abs(difference) > kEqual ? difference < 0 : segments[a] > segments[b];
    offer(takes_a ? a : b, segments[takes_a ? b : a]);
  }
  for (std::size_t v = 0; v < segments.size(); ++v) {
    const auto [first, second] = std::minmax(segments[v], partner[v]);
    if (first == second) {
      mesh.influences[v] = {{first, 1.0}};
    } else {
      mesh.influences[v] = {{first, 0.5}, {second, 0.5}};
    }
  }
  return mesh;
}

namespace {

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// Where a joint's operator is.
struct Operator {
  glm::dvec3 centre, along;  // unit
  double thickness = 0;      // 0: there is none

  double from_line(const glm::dvec3& v) const {
    const glm::dvec3 arm = v - centre;
    return glm::length(arm - along * glm::dot(arm, along));
  }
  // side: 1 for the joint's own segment, -1 for its parent's.
  double share(const glm::dvec3& v, double side) const {
    if (!(thickness > 0)) return 0;
    const double x = std::max(0.0, side * glm::dot(v - centre, along));
    return 0.5 * (1 - smooth_step(x / thickness)) * (1 - smooth_step(from_line(v) / thickness - 2));
  }
};

class Operators {
 public:
  Operators(const SkinnedMesh& mesh, const std::vector<int>& parents, const std::vector<glm::dvec3>& centres)
      : mesh_(mesh), parents_(parents), centres_(centres), segments_(segments_of(mesh)) {
    std::vector<Operator> operators;
    for (std::size_t j = 0; j < parents.size(); ++j) operators.push_back(make(j));
    for (std::size_t v = 0; v < segments_.size(); ++v) domains_.push_back(domain(operators, v));
  }

  void deform(const Pose& pose, Positions& out) const {
    const std::vector<glm::dquat> turns = local_rotations(pose, parents_);
    out.resize(segments_.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
      const Domain& d = domains_[v];
      glm::dvec3 at = mesh_.positions[v];
      if (d.share > 0) {
        const glm::dquat turn = segments_[v] == d.joint ? glm::conjugate(turns[d.joint]) : turns[d.joint];
        const glm::dvec3& centre = centres_[d.joint];
        at = centre + slerp(glm::dquat(1, 0, 0, 0), turn, d.share) * (at - centre);
      }
      out[v] = transform(pose[segments_[v]], at);
    }
  }

 private:
  struct Domain {
    std::uint32_t joint = 0;
    double share = 0;  // 0: of none
  };

  // From the joint to the mean of its children, or twice as far as to the mean of its segment's vertices.
  glm::dvec3 bone(std::size_t joint) const {
    glm::dvec3 to_children(0), to_vertices(0);
    double children = 0, vertices = 0;
    for (std::size_t j = 0; j < parents_.size(); ++j) {
      if (parents_[j] != static_cast<int>(joint)) continue;
      to_children += centres_[j] - centres_[joint];
      ++children;
    }
    for (std::size_t v = 0; v < segments_.size(); ++v) {
      if (segments_[v] != joint) continue;
      to_vertices += mesh_.positions[v] - centres_[joint];
      ++vertices;
    }
    return children > 0 ? to_children / children : to_vertices * (2 / std::max(1.0, vertices));
  }

  Operator make(std::size_t joint) const {
    Operator out{centres_[joint], glm::dvec3(0)};
    if (parents_[joint] < 0) return out;
    const glm::dvec3 own = bone(joint), parents = centres_[joint] - centres_[static_cast<std::size_t>(parents_[joint])];
    double most = diagonal(mesh_);
    for (const glm::dvec3& b : {own, parents}) {
      const double length = glm::length(b);
      if (!(length > 1e-6 * diagonal(mesh_))) continue;
      out.along += b / length;
      most = std::min(most, length / 2);
    }
    if (!(glm::length(out.along) > 1e-3)) return out;
    out.along = glm::normalize(out.along);
    double sum = 0, count = 0;
    for (std::size_t v = 0; v < segments_.size(); ++v) {
      if (segments_[v] != joint) continue;
      sum += out.from_line(mesh_.positions[v]);
      ++count;
    }
    if (count > 0) out.thickness = std::min(most, sum / count);
    return out;
  }

  Domain domain(const std::vector<Operator>& operators, std::size_t v) const {
    Domain out;
    for (std::uint32_t j = 0; j < operators.size(); ++j) {
      const bool is_own = segments_[v] == j;
      if (!is_own && parents_[j] != static_cast<int>(segments_[v])) continue;
      const double share = operators[j].share(mesh_.positions[v], is_own ? 1 : -1);
      if (share > out.share) out = {j, share};
    }
    return out;
  }

  const SkinnedMesh& mesh_;
  std::vector<int> parents_;
  std::vector<glm::dvec3> centres_;
  std::vector<std::uint32_t> segments_;  // a vertex: the joint that it follows
  std::vector<Domain> domains_;
};

}  // namespace

Deformer joint_operators(const SkinnedMesh& mesh, const std::vector<int>& parents,
                         const std::vector<glm::dvec3>& centres) {
  const auto operators = std::make_shared<const Operators>(mesh, parents, centres);
  return [operators](const Pose& pose, Positions& out) { operators->deform(pose, out); };
}

}  // namespace marrow::deform
