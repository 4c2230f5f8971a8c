#include "deform/deformers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include <glm/geometric.hpp>

#include "common/elementary.h"
#include "common/parallel.h"
#include "deform/rotations.h"

namespace marrow::deform {
namespace {

glm::dvec3 blend(const std::vector<Influence>& influences, const Pose& pose, const glm::dvec3& v) {
  glm::dvec3 sum(0);
  for (const Influence& i : influences) sum += transform(pose[i.joint], v) * i.weight;
  return sum;
}

}  // namespace

Deformer rigid(const SkinnedMesh& mesh) {
  return [&mesh](const Pose& pose, Positions& out) {
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v)
      out[v] = transform(pose[largest(mesh.influences[v]).joint], mesh.positions[v]);
  };
}

Deformer ssd(const SkinnedMesh& mesh) {
  return [&mesh](const Pose& pose, Positions& out) {
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = blend(mesh.influences[v], pose, mesh.positions[v]);
  };
}

Deformer dual_quaternions(const SkinnedMesh& mesh) {
  return [&mesh](const Pose& pose, Positions& out) {
    const std::vector<glm::dquat> rotations = rotations_of(pose);
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v)
      out[v] = by_dual_quaternion(mesh.influences[v], rotations, pose, mesh.positions[v]);
  };
}

Deformer centres_of_rotation(const SkinnedMesh& mesh, double sigma) {
  const auto centres = std::make_shared<const Positions>(rotation_centres(mesh, sigma));
  return [&mesh, centres](const Pose& pose, Positions& out) {
    const std::vector<glm::dquat> rotations = rotations_of(pose);
    std::vector<glm::dmat3> stretches;
    for (std::size_t j = 0; j < pose.size(); ++j)
      stretches.push_back(glm::transpose(glm::mat3_cast(rotations[j])) * linear_of(pose[j]));
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
      const std::vector<Influence>& influences = mesh.influences[v];
      const glm::dvec3 &centre = (*centres)[v], from_centre = mesh.positions[v] - centre;
      glm::dvec3 arm(0);
      const glm::dquat q = blend_rotations(influences, rotations, [&](const Influence& i, const glm::dquat&) {
        arm += stretches[i.joint] * from_centre * i.weight;
      });
      out[v] = blend(influences, pose, centre) + glm::normalize(q) * arm;
    }
  };
}

namespace {

void smooth(const Surface& surface, const DeltaMushOptions& options, Positions& positions) {
  Positions scratch;
  for (int i = 0; i < options.iterations; ++i) surface.smooth(positions, options.step, scratch);
}

double area_kept(const SkinnedMesh& mesh, const Surface& surface, const DeltaMushOptions& options) {
  const double whole = area(mesh.positions, mesh.indices);
  Positions smoothed = mesh.positions;
  smooth(surface, options, smoothed);
  return whole > 0 ? area(smoothed, mesh.indices) / whole : 1.0;
}

// What puts back the detail that smoothing takes, in the frame of each vertex of the smoothed surface.
struct Mush {
  Mush(const SkinnedMesh& m, const DeltaMushOptions& o) : mesh(m), options(o), surface(m, o.weights) {
    Positions smoothed = mesh.positions;
    smooth(surface, options, smoothed);
    frame_edge = frame_edges(smoothed);
    const std::vector<glm::dmat3> frames = frames_of(smoothed);
    for (std::size_t v = 0; v < smoothed.size(); ++v)
      delta.push_back(glm::transpose(frames[v]) * (mesh.positions[v] - smoothed[v]));
  }

  // For each vertex coefficients of its neighbours that give a direction along the surface: linear in them, so that it
  // turns with the surface as a whole and not with one edge.
  std::vector<std::vector<double>> frame_edges(const Positions& smoothed) const {
    const std::vector<glm::dvec3> normals = vertex_normals(smoothed, mesh.indices);
    std::vector<std::vector<double>> out(smoothed.size());
    for (std::size_t v = 0; v < smoothed.size(); ++v) {
      const auto around = surface.neighbours(v);
      if (around.empty()) continue;
      const glm::dvec3 edge = smoothed[around[0]] - smoothed[v];
      const glm::dvec3 along = edge - normals[v] * glm::dot(edge, normals[v]);
      for (const std::uint32_t k : around) out[v].push_back(glm::dot(smoothed[k] - smoothed[v], along));
    }
    return out;
  }

  std::vector<glm::dmat3> frames_of(const Positions& smoothed) const {
    const std::vector<glm::dvec3> normals = vertex_normals(smoothed, mesh.indices);
    std::vector<glm::dmat3> out;
    for (std::size_t v = 0; v < smoothed.size(); ++v) {
      const auto around = surface.neighbours(v);
      glm::dvec3 along(0);
      for (std::size_t k = 0; k < around.size(); ++k) along += (smoothed[around[k]] - smoothed[v]) * frame_edge[v][k];
      out.push_back(rotation_of({normals[v], along, glm::dvec3(0)}));
    }
    return out;
  }

  const SkinnedMesh& mesh;
  DeltaMushOptions options;
  Surface surface;
  std::vector<std::vector<double>> frame_edge;
  Positions delta;
};

}  // namespace

Deformer delta_mush(const SkinnedMesh& mesh, const DeltaMushOptions& options) {
  return delta_mush(mesh, options, ssd(mesh));
}

Deformer delta_mush(const SkinnedMesh& mesh, const DeltaMushOptions& options, const Deformer& over) {
  const auto mush = std::make_shared<const Mush>(mesh, options);
  return [mush, over](const Pose& pose, Positions& out) {
    over(pose, out);
    smooth(mush->surface, mush->options, out);
    const std::vector<glm::dmat3> frames = mush->frames_of(out);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] += frames[v] * mush->delta[v];
  };
}

double area_kept(const SkinnedMesh& mesh, const DeltaMushOptions& options) {
  return area_kept(mesh, Surface(mesh, options.weights), options);
}

DeltaMushOptions with_least_area(const SkinnedMesh& mesh, DeltaMushOptions options) {
  const Surface surface(mesh, options.weights);
  // Steps that are a thousand times shorter leave all of what can be left.
  for (int i = 0; i < 52 && area_kept(mesh, surface, options) < kLeastArea; ++i) options.step *= 0.875;
  return options;
}

namespace {

// A triangle as two of its joints see it.
struct Patch {
  double a, b;  // weights of the two
  double area;
  glm::dvec3 centre;
};
using JointPair = std::pair<std::uint32_t, std::uint32_t>;

std::map<JointPair, std::vector<Patch>> patches_of(const SkinnedMesh& mesh) {
  std::map<JointPair, std::vector<Patch>> out;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const std::uint32_t* const corner = &mesh.indices[t];
    const glm::dvec3 &a = mesh.positions[corner[0]], &b = mesh.positions[corner[1]], &c = mesh.positions[corner[2]];
    const double area = glm::length(glm::cross(b - a, c - a)) / 2;
    std::map<std::uint32_t, double> weights;
    for (int i = 0; i < 3; ++i)
      for (const Influence& influence : mesh.influences[corner[i]]) weights[influence.joint] += influence.weight / 3;
    for (auto j = weights.begin(); j != weights.end(); ++j)
      for (auto k = std::next(j); k != weights.end(); ++k)
        out[{j->first, k->first}].push_back({j->second, k->second, area, (a + b + c) / 3.0});
  }
  return out;
}

}  // namespace

// Equation 1 and 2 there: the mean of the surface, weighted by how alike weights are. Their sum over pairs of joints
// can be taken pair by pair, so each vertex meets only triangles that follow two of its joints.
Positions rotation_centres(const SkinnedMesh& mesh, double sigma) {
  const std::map<JointPair, std::vector<Patch>> patches = patches_of(mesh);
  Positions out = mesh.positions;
  tools::for_each_in_parallel(mesh.positions.size(), [&](std::size_t v) {
    const std::vector<Influence>& influences = mesh.influences[v];
    glm::dvec3 sum(0);
    double total = 0;
    for (std::size_t j = 0; j < influences.size(); ++j) {
      for (std::size_t k = j + 1; k < influences.size(); ++k) {
        const auto found = patches.find({influences[j].joint, influences[k].joint});
        if (found == patches.end()) continue;
        const double a = influences[j].weight, b = influences[k].weight;
        for (const Patch& patch : found->second) {
          const double apart = a * patch.b - b * patch.a;
          const double alike =
              a * b * patch.a * patch.b * tools::exponential(-apart * apart / (sigma * sigma)) * patch.area;
          sum += patch.centre * alike;
          total += alike;
        }
      }
    }
    if (total > 0) out[v] = sum / total;
  });
  return out;
}

namespace {

std::vector<std::uint32_t> segments_of(const SkinnedMesh& mesh) {
  std::vector<std::uint32_t> out;
  for (const std::vector<Influence>& influences : mesh.influences)
    out.push_back(std::ranges::max_element(influences, {}, &Influence::weight)->joint);
  return out;
}

}  // namespace

SkinnedMesh stitched(SkinnedMesh mesh) {
  constexpr double kEqual = 1e-9;
  const std::vector<std::uint32_t> segments = segments_of(mesh);
  std::vector<std::uint32_t> partner = segments;
  const auto offer = [&](std::uint32_t v, std::uint32_t joint) {
    const auto weight = [&](std::uint32_t j) { return weight_of(j, mesh.influences[v]); };
    if (partner[v] == segments[v] || weight(joint) > weight(partner[v]) ||
        (weight(joint) == weight(partner[v]) && joint < partner[v]))
      partner[v] = joint;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    if (segments[a] == segments[b]) continue;
    const auto apart = [&](std::uint32_t v) {
      return std::abs(weight_of(segments[a], mesh.influences[v]) - weight_of(segments[b], mesh.influences[v]));
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
