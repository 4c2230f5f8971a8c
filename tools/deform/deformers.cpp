#include "deform/deformers.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "deform/rotation_of_matrix.h"

namespace marrow::deform {
namespace {

const Influence& largest(const std::vector<Influence>& influences) {
  return *std::max_element(influences.begin(), influences.end(),
                           [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
}

glm::dvec3 blend(const std::vector<Influence>& influences, const Pose& pose, const glm::dvec3& v) {
  glm::dvec3 sum(0);
  for (const Influence& i : influences) sum += transform(pose[i.joint], v) * i.weight;
  return sum;
}

// A joint's matrix as rotation and what is left: M = (rotation · rest | translation).
struct Rigid {
  glm::dquat rotation;
  glm::dmat3 rest;
  glm::dvec3 translation;
};

std::vector<Rigid> rigid_parts(const Pose& pose) {
  std::vector<Rigid> out;
  for (const Matrix& m : pose) {
    const glm::dmat3 rotation = rotation_of(linear_of(m));
    out.push_back({quaternion_of(rotation), glm::transpose(rotation) * linear_of(m), m[3]});
  }
  return out;
}

// Of q and -q the one nearer to `to`, as 1 or -1.
double sign_towards(const glm::dquat& to, const glm::dquat& q) {
  return glm::dot(to, q) < 0 ? -1.0 : 1.0;
}

glm::dvec3 by_dual_quaternion(const std::vector<Influence>& influences, const std::vector<Rigid>& parts,
                              const glm::dvec3& bind) {
  const glm::dquat pivot = parts[largest(influences).joint].rotation;
  glm::dquat real(0, 0, 0, 0), dual(0, 0, 0, 0);
  glm::dvec3 v(0);
  for (const Influence& i : influences) {
    const Rigid& part = parts[i.joint];
    const double weight = i.weight * sign_towards(pivot, part.rotation);
    const glm::dvec3& t = part.translation;
    real = real + part.rotation * weight;
    dual = dual + (glm::dquat(0, t.x, t.y, t.z) * part.rotation) * (0.5 * weight);
    v += part.rest * bind * i.weight;
  }
  const double length = glm::length(real);
  real = real / length;
  dual = dual / length;
  const glm::dquat moved = dual * glm::conjugate(real);
  return real * v + glm::dvec3(moved.x, moved.y, moved.z) * 2.0;
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
    const std::vector<Rigid> parts = rigid_parts(pose);
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v)
      out[v] = mesh.influences[v].size() == 1 ? transform(pose[mesh.influences[v][0].joint], mesh.positions[v])
                                              : by_dual_quaternion(mesh.influences[v], parts, mesh.positions[v]);
  };
}

Deformer centres_of_rotation(const SkinnedMesh& mesh, double sigma) {
  const auto centres = std::make_shared<const Positions>(rotation_centres(mesh, sigma));
  return [&mesh, centres](const Pose& pose, Positions& out) {
    const std::vector<Rigid> parts = rigid_parts(pose);
    out.resize(mesh.positions.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
      const std::vector<Influence>& influences = mesh.influences[v];
      const glm::dvec3& centre = (*centres)[v];
      const glm::dquat pivot = parts[largest(influences).joint].rotation;
      glm::dquat q(0, 0, 0, 0);
      glm::dvec3 arm(0);
      for (const Influence& i : influences) {
        q = q + parts[i.joint].rotation * (i.weight * sign_towards(pivot, parts[i.joint].rotation));
        arm += parts[i.joint].rest * (mesh.positions[v] - centre) * i.weight;
      }
      out[v] = blend(influences, pose, centre) + glm::normalize(q) * arm;
    }
  };
}

namespace {

// What puts back the detail that smoothing takes, in the frame of each vertex of the smoothed surface.
struct Mush {
  Mush(const SkinnedMesh& m, const DeltaMushOptions& o) : mesh(m), options(o), surface(m, o.weights) {
    Positions smoothed = mesh.positions;
    smooth(smoothed);
    frame_edge = frame_edges(smoothed);
    const std::vector<glm::dmat3> frames = frames_of(smoothed);
    for (std::size_t v = 0; v < smoothed.size(); ++v)
      delta.push_back(glm::transpose(frames[v]) * (mesh.positions[v] - smoothed[v]));
  }

  void smooth(Positions& positions) const {
    Positions scratch;
    for (int i = 0; i < options.iterations; ++i) surface.smooth(positions, options.step, scratch);
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
  const auto mush = std::make_shared<const Mush>(mesh, options);
  return [mush, skin = ssd(mesh)](const Pose& pose, Positions& out) {
    skin(pose, out);
    mush->smooth(out);
    const std::vector<glm::dmat3> frames = mush->frames_of(out);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] += frames[v] * mush->delta[v];
  };
}

}  // namespace marrow::deform
