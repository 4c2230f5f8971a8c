#include "compare/thesis/smoothness.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "common/parallel.h"

namespace marrow::tools {
namespace {

double rms(const std::vector<double>& values, const std::vector<char>& counts) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (counts[i] == 0) continue;
    sum += values[i] * values[i];
    ++count;
  }
  return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0;
}

// Which vertices, and which of the edges' pairs of triangles.
struct Meeting {
  explicit Meeting(const Shape& shape) {
    for (const auto& influences : shape.mesh.influences) vertices.push_back(influences.size() > 1 ? 1 : 0);
    const auto is_met = [&](std::uint32_t triangle) {
      const std::uint32_t* const corners = shape.mesh.indices.data() + std::size_t{3} * triangle;
      return std::any_of(corners, corners + 3, [&](std::uint32_t v) { return vertices[v] != 0; });
    };
    for (const auto& [a, b] : shape.hinges) hinges.push_back(is_met(a) && is_met(b) ? 1 : 0);
  }
  std::vector<char> vertices, hinges;
};

// One less than a vertex has joints, as they sum to 1.
double weights_per_vertex(const deform::SkinnedMesh& mesh) {
  std::size_t out = 0;
  for (const auto& influences : mesh.influences) out += influences.size();
  return static_cast<double>(out) / static_cast<double>(mesh.influences.size()) - 1;
}

bool is_learnt(const std::string& deformer) {
  return deformer == "ssd_refit" || deformer == "as_fit" || deformer.starts_with("as_helpers_fit") ||
         deformer == "mwe" || deformer == "psd" || deformer == "eigenskin";
}

}  // namespace

std::vector<double> mean_curvatures(const deform::Positions& p, const std::vector<std::uint32_t>& indices) {
  std::vector<glm::dvec3> laplacian(p.size(), glm::dvec3(0));
  std::vector<double> area(p.size(), 0.0);
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = indices[t + c], b = indices[t + (c + 1) % 3], opposite = indices[t + (c + 2) % 3];
      const glm::dvec3 u = p[a] - p[opposite], v = p[b] - p[opposite];
      const double twice = glm::length(glm::cross(u, v));
      if (!(twice > 0)) continue;
      const glm::dvec3 pull = (p[b] - p[a]) * (0.5 * glm::dot(u, v) / twice);
      laplacian[a] += pull;
      laplacian[b] -= pull;
      area[a] += twice / 6;
    }
  std::vector<double> out(p.size(), 0.0);
  for (std::size_t v = 0; v < p.size(); ++v)
    if (area[v] > 0) out[v] = 0.5 * glm::length(laplacian[v]) / area[v];
  return out;
}

Smoothness smoothness(const Shape& shape, const deform::RangeOfMotion& motion, bool twists,
                      const deform::Deformer& deform) {
  const Meeting meeting(shape);
  std::vector<const deform::MotionPose*> poses;
  for (const deform::MotionPose& pose : motion.poses)
    if ((pose.kind == deform::MotionKind::twist) == twists) poses.push_back(&pose);
  const double bind_curvature = rms(mean_curvatures(shape.mesh.positions, shape.mesh.indices), meeting.vertices);
  std::vector<Smoothness> of(poses.size());
  for_each_in_parallel(poses.size(), [&](std::size_t i) {
    deform::Positions positions;
    deform(poses[i]->pose(), positions);
    std::vector<double> jumps = shape.angles(positions);
    for (std::size_t h = 0; h < jumps.size(); ++h) {
      jumps[h] = std::fabs(jumps[h] - shape.bind_angles[h]);
      if (meeting.hinges[h] != 0) of[i].largest_jump_deg = std::max(of[i].largest_jump_deg, glm::degrees(jumps[h]));
    }
    of[i].rms_jump_deg = glm::degrees(rms(jumps, meeting.hinges));
    const double curvature = rms(mean_curvatures(positions, shape.mesh.indices), meeting.vertices);
    of[i].curvature = bind_curvature > 0 ? curvature / bind_curvature : 0;
  });
  Smoothness out;
  for (const Smoothness& s : of) {
    const auto count = static_cast<double>(of.size());
    out.largest_jump_deg += s.largest_jump_deg / count;
    out.rms_jump_deg += s.rms_jump_deg / count;
    out.curvature += s.curvature / count;
  }
  return out;
}

Labour labour_of(const std::string& deformer, const Study& study, std::size_t shown_poses) {
  if (deformer == "rigid" || deformer == "stitched") return {1, 0, 0, "a joint"};
  if (deformer == "joint_local") return {1, 0, 0, "a joint, and for each joint where it acts"};
  Labour out;
  out.numbers_per_vertex = weights_per_vertex(study.source.mesh);
  out.of_what = "weights";
  if (is_learnt(deformer) && shown_poses > 0) {
    out.files = 1;
    out.poses = shown_poses;
  }
  return out;
}

}  // namespace marrow::tools
