#include "deform/animation_space.h"

#include <algorithm>

namespace marrow::deform {

std::vector<std::uint32_t> joints_of(const std::vector<Coordinate>& vertex) {
  std::vector<std::uint32_t> out;
  for (const Coordinate& c : vertex) out.push_back(c.joint);
  return out;
}

Deformer animation_space(const Coordinates& coordinates) {
  return [&coordinates](const Pose& pose, Positions& out) {
    out.assign(coordinates.size(), glm::dvec3(0));
    for (std::size_t v = 0; v < out.size(); ++v)
      for (const Coordinate& c : coordinates[v]) out[v] += pose[c.joint] * c.q;
  };
}

Coordinates lift(const SkinnedMesh& mesh) {
  Coordinates out(mesh.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v)
    for (const Influence& i : mesh.influences[v])
      out[v].push_back({i.joint, glm::dvec4(mesh.positions[v], 1) * i.weight});
  return out;
}

namespace {

// A column for each joint: what the joint contributes to each vertex.
template <class T>
using Columns = std::vector<std::vector<T>>;

Columns<double> weight_columns(const SkinnedMesh& mesh) {
  Columns<double> out(mesh.joint_count, std::vector<double>(mesh.positions.size(), 0));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    for (const Influence& i : mesh.influences[v]) out[i.joint][v] = i.weight;
  return out;
}

template <class T>
void smooth_columns(const Surface& surface, int iterations, double step, Columns<T>& columns) {
  std::vector<T> scratch;
  for (std::vector<T>& column : columns)
    for (int i = 0; i < iterations; ++i) surface.smooth(column, step, scratch);
}

// The joints with the largest weights of a vertex, and its own, ascending.
std::vector<Influence> largest(const Columns<double>& weights, const std::vector<Influence>& own, std::size_t v,
                               std::size_t most) {
  constexpr double kLeast = 1e-4;
  std::vector<Influence> out;
  for (std::uint32_t j = 0; j < weights.size(); ++j)
    if (weights[j][v] > kLeast) out.push_back({j, weights[j][v]});
  std::stable_sort(out.begin(), out.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  for (std::size_t i = out.size(); i-- > most;)
    if (std::ranges::find(own, out[i].joint, &Influence::joint) == own.end())
      out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
  double sum = 0;
  for (const Influence& i : out) sum += i.weight;
  for (Influence& i : out) i.weight /= sum;
  std::sort(out.begin(), out.end(), [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
  return out;
}

}  // namespace

Coordinates smoothed_ssd(const SkinnedMesh& mesh, const Surface& surface, int iterations, double step,
                         std::size_t most) {
  const Columns<double> own = weight_columns(mesh);
  Columns<double> weights = own;
  smooth_columns(surface, iterations, step, weights);
  Columns<glm::dvec3> carried(mesh.joint_count, std::vector<glm::dvec3>(mesh.positions.size()));
  for (std::size_t j = 0; j < own.size(); ++j)
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) carried[j][v] = mesh.positions[v] * own[j][v];
  smooth_columns(surface, iterations, step, carried);
  Coordinates out(mesh.positions.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    const std::vector<Influence> kept = largest(weights, mesh.influences[v], v, most);
    // Of each joint the mean of the places that it carries, as if it still had the weight it has now.
    glm::dvec3 sum(0);
    for (const Influence& i : kept) {
      const glm::dvec3 place = carried[i.joint][v] * (i.weight / weights[i.joint][v]);
      out[v].push_back({i.joint, glm::dvec4(place, i.weight)});
      sum += place;
    }
    const glm::dvec3 lost = mesh.positions[v] - sum;
    for (Coordinate& c : out[v]) c.q += glm::dvec4(lost * c.q.w, 0);
  }
  return out;
}

}  // namespace marrow::deform
