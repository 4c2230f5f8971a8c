#include "deform/elastic/embedding.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "deform/weights/places.h"

namespace marrow::deform {
namespace {

constexpr double kThin = 0.10, kThick = 0.30;      // of Lattice::filled_around
constexpr double kStrange = 0.55, kAgrees = 0.80;  // of weights that are in common
constexpr int kSeam = 4;                           // steps that the border of what goes with joints is smoothed by

// Of each vertex the surface that it belongs to: vertices in one place belong to one.
std::vector<std::uint32_t> surfaces_of(const SkinnedMesh& mesh) {
  const Places places = places_of(mesh.positions);
  std::vector<std::uint32_t> up(places.positions.size());
  std::iota(up.begin(), up.end(), 0u);
  const auto root = [&](std::uint32_t i) {
    while (up[i] != i) i = up[i] = up[up[i]];
    return i;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const std::uint32_t a = root(places.of_vertex[mesh.indices[i]]),
                        b = root(places.of_vertex[mesh.indices[i - i % 3]]);
    up[std::max(a, b)] = std::min(a, b);
  }
  std::vector<std::uint32_t> out;
  for (const std::uint32_t place : places.of_vertex) out.push_back(root(place));
  return out;
}

using Weights = std::map<std::uint32_t, double>;

double in_common(const std::vector<Influence>& a, const Weights& b, double over) {
  double out = 0;
  for (const Influence& i : a)
    if (const auto found = b.find(i.joint); found != b.end()) out += std::min(found->second / over, i.weight);
  return out;
}

// Of each vertex what its weights have in common with those of the other surfaces in its cell, of the one with the
// least; 1 where it is alone.
std::vector<double> agreement(const Lattice& lattice, const SkinnedMesh& mesh) {
  struct Part {
    Weights weights;
    double count = 0;
  };
  const std::vector<std::uint32_t> surface = surfaces_of(mesh);
  std::vector<std::map<std::uint32_t, Part>> parts(lattice.cells.size());
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (lattice.cell_of[v] == Lattice::kNone) continue;
    Part& part = parts[lattice.cell_of[v]][surface[v]];
    for (const Influence& i : mesh.influences[v]) part.weights[i.joint] += i.weight;
    ++part.count;
  }
  std::vector<double> out(surface.size(), 1);
  for (std::size_t v = 0; v < surface.size(); ++v) {
    if (lattice.cell_of[v] == Lattice::kNone) continue;
    for (const auto& [other, part] : parts[lattice.cell_of[v]])
      if (other != surface[v]) out[v] = std::min(out[v], in_common(mesh.influences[v], part.weights, part.count));
  }
  return out;
}

}  // namespace

double Embedding::quadratic(double t) {
  const double away = std::abs(t);
  if (away < 0.5) return 0.75 - away * away;
  return away < 1.5 ? 0.5 * (1.5 - away) * (1.5 - away) : 0;
}

Embedding::Embedding(const Body& body, const SkinnedMesh& mesh) : body_(body), mesh_(mesh) {
  std::vector<char> has_vertex(body.lattice.cells.size(), 0);
  for (const std::uint32_t c : body.lattice.cell_of)
    if (c != Lattice::kNone) has_vertex[c] = 1;
  first_.push_back(0);
  for (std::uint32_t c = 0; c < body.lattice.cells.size(); ++c) find_near(c, has_vertex);
  find_shares();
}

// Cells that touch are at most three steps across faces away.
void Embedding::find_near(std::uint32_t cell, const std::vector<char>& has_vertex) {
  const std::vector<Lattice::Cell>& cells = body_.lattice.cells;
  if (has_vertex[cell] != 0) {
    const glm::ivec3 at = cells[cell].at;
    std::vector<std::uint32_t> reached = {cell};
    for (std::size_t i = 0; i < reached.size(); ++i)
      for (const std::uint32_t b : cells[reached[i]].beside) {
        if (b == Lattice::kNone || std::ranges::find(reached, b) != reached.end()) continue;
        const glm::ivec3 away = glm::abs(cells[b].at - at);
        if (std::max({away.x, away.y, away.z}) <= 1) reached.push_back(b);
      }
    std::vector<std::uint32_t> nodes;
    for (const std::uint32_t c : reached) nodes.insert(nodes.end(), cells[c].nodes.begin(), cells[c].nodes.end());
    std::ranges::sort(nodes);
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const std::uint32_t n : nodes) {
      const glm::ivec3 from = body_.lattice.nodes[n] - at + 1;
      near_.push_back(
          {n, static_cast<std::uint8_t>(from.x), static_cast<std::uint8_t>(from.y), static_cast<std::uint8_t>(from.z)});
    }
  }
  first_.push_back(near_.size());
}

void Embedding::find_shares() {
  const std::size_t count = mesh_.positions.size();
  rig_.assign(count, 1);
  thin_.assign(count, 0);
  const std::vector<double> agrees = agreement(body_.lattice, mesh_);
  for (std::size_t v = 0; v < count; ++v) {
    if (body_.lattice.cell_of[v] == Lattice::kNone) continue;
    Weights weights;
    double sum = 0, filled = 0;
    for_each_near(v, [&](std::uint32_t n, double share) {
      for (const Influence& i : body_.weights[n]) weights[i.joint] += i.weight * share;
      filled += static_cast<double>(body_.lattice.filled_around[n]) * share;
      sum += share;
    });
    const double common = in_common(mesh_.influences[v], weights, sum);
    // Where one surface goes over from joint to joint at once the lattice is smoother, as it should be.
    rig_[v] = 1 - smooth_step(std::max(common, agrees[v]), kStrange, kAgrees);
    thin_[v] = 1 - smooth_step(filled / sum, kThin, kThick);
  }
  soften(Surface(mesh_), 1, kSeam, rig_);
  for (std::size_t v = 0; v < count; ++v)
    if (body_.lattice.cell_of[v] == Lattice::kNone) rig_[v] = 1;
}

void Embedding::leave_to_rig(const std::vector<char>& vertices) {
  std::vector<double> shares(vertices.begin(), vertices.end());
  soften(Surface(mesh_), kSeam, kSeam, shares);
  for (std::size_t v = 0; v < shares.size(); ++v) rig_[v] = std::max(rig_[v], shares[v]);
}

}  // namespace marrow::deform
