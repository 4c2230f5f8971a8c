#include "deform/weights/glow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "deform/surface.h"
#include "deform/weights/places.h"

namespace marrow::deform {
namespace {

constexpr std::size_t kRays = 16;     // from a vertex to a bone
constexpr double kLeastHeight = 0.5;  // voxels: nearer, voxels say nothing of what is between

// Whether most triangles face inwards, seen from the middle, so that a mesh that is open does not depend on its place.
bool is_inside_out(Positions positions, std::span<const std::uint32_t> indices) {
  const Box box = box_of(positions, indices);
  const glm::dvec3 middle = (box.low + box.high) * 0.5;
  for (glm::dvec3& p : positions) p -= middle;
  return volume(positions, indices) < 0;
}

std::vector<glm::dvec3> outward_normals(const Positions& positions, std::span<const std::uint32_t> indices) {
  const Places places = places_of(positions);
  const std::vector<std::uint32_t> triangles = indices_of(places, indices);
  const std::vector<glm::dvec3> normals = vertex_normals(places.positions, triangles);
  const double sign = is_inside_out(places.positions, triangles) ? -1 : 1;
  std::vector<glm::dvec3> out;
  for (const std::uint32_t place : places.of_vertex) out.push_back(normals[place] * sign);
  return out;
}

// ∫ sine / r² ds along a rod is (high - low) / height in terms of this: equal steps of it are equal shares of light.
double share_at(double s, double height) {
  return s / std::sqrt(s * s + height * height);
}

}  // namespace

Glow::Glow(const Voxels& voxels, const Positions& positions, std::span<const std::uint32_t> indices,
           std::span<const Bone> bones)
    : voxels_(voxels), normals_(outward_normals(positions, indices)) {
  for (const Bone& bone : bones) {
    const glm::dvec3 from = voxels.to_grid(bone.from), along = voxels.to_grid(bone.to) - from;
    const double length = glm::length(along);
    if (length > 0) rods_.push_back({bone.joint, from, along / length, length});
  }
  std::stable_sort(rods_.begin(), rods_.end(), [](const Rod& a, const Rod& b) { return a.joint < b.joint; });
}

Glow::View Glow::view_of(const Rod& rod, const glm::dvec3& p) const {
  const glm::dvec3 to_vertex = p - rod.from;
  const double foot = glm::dot(to_vertex, rod.axis);
  const double height = std::max(glm::length(to_vertex - rod.axis * foot), kLeastHeight);
  return {&rod, foot, height, share_at(-foot, height), share_at(rod.length - foot, height)};
}

double Glow::light_of(const View& view, const glm::dvec3& p, const glm::dvec3& normal, double needed) const {
  const Rod& rod = *view.rod;
  const bool has_normal = glm::dot(normal, normal) > 0;
  std::array<glm::dvec3, kRays> ends;
  std::array<double, kRays> lights;
  double hoped_for = 0;  // were nothing in the way
  for (std::size_t ray = 0; ray < kRays; ++ray) {
    const double share = view.low + (view.high - view.low) * ((static_cast<double>(ray) + 0.5) / kRays);
    const double s = view.height * share / std::sqrt(std::max(1 - share * share, 1e-30));
    ends[ray] = rod.from + rod.axis * std::clamp(view.foot + s, 0.0, rod.length);
    const glm::dvec3 way = ends[ray] - p;
    const double distance = glm::length(way);
    const double cosine = has_normal && distance > 0 ? -glm::dot(normal, way) / distance : 1;
    hoped_for += lights[ray] = std::max(cosine, 0.0) * view.most_light() / kRays;
  }
  double light = 0;
  for (std::size_t ray = 0; ray < kRays && light + hoped_for > needed; ++ray) {
    hoped_for -= lights[ray];
    if (lights[ray] > 0 && voxels_.sees(p, ends[ray])) light += lights[ray];
  }
  return light;
}

std::vector<Influence> Glow::at(const glm::dvec3& p, std::size_t vertex, std::size_t most) const {
  const glm::dvec3 grid = voxels_.to_grid(p);
  if (!voxels_.is_inner(grid)) return {};
  std::vector<View> views;
  struct Candidate {
    std::size_t first, end;  // of a joint's views
    double most_light;       // were nothing in the way
  };
  std::vector<Candidate> candidates;
  for (const Rod& rod : rods_) {
    views.push_back(view_of(rod, grid));
    if (candidates.empty() || views[candidates.back().first].rod->joint != rod.joint)
      candidates.push_back({views.size() - 1, views.size() - 1, 0});
    ++candidates.back().end;
    candidates.back().most_light += views.back().most_light();
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.most_light > b.most_light; });
  std::vector<Influence> lit;
  for (const Candidate& candidate : candidates) {
    // All that follow are darker than what is kept already.
    if (lit.size() == most && !(candidate.most_light > lit.back().weight)) break;
    const double needed = lit.size() == most ? lit.back().weight : 0;
    double light = 0, others = candidate.most_light;  // of the joint's bones; of those to come, at most
    for (std::size_t v = candidate.first; v < candidate.end; ++v) {
      others -= views[v].most_light();
      light += light_of(views[v], grid, normals_[vertex], needed - light - others);
    }
    if (!(light > needed)) continue;
    const auto darker = std::find_if(lit.begin(), lit.end(), [&](const Influence& i) { return i.weight < light; });
    lit.insert(darker, {views[candidate.first].rod->joint, light});
    if (lit.size() > most) lit.pop_back();
  }
  return lit;
}

}  // namespace marrow::deform
