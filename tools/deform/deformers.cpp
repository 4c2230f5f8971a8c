#include "deform/deformers.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "deform/rotation_blend.h"
#include "deform/rotation_of_matrix.h"

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

}  // namespace marrow::deform
