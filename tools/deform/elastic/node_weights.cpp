#include "deform/elastic/node_weights.h"

#include <algorithm>
#include <array>
#include <map>

#include <glm/common.hpp>

#include "common/parallel.h"
#include "deform/elastic/factor.h"
#include "deform/weights/auto_weights.h"

namespace marrow::deform {
namespace {

constexpr double kOfVertices = 4;
constexpr std::size_t kMostJoints = 6;
constexpr double kLeast = 0.01;

// How much a place in a cell takes of each corner.
std::array<double, 8> shares_of(const Lattice& lattice, const Lattice::Cell& cell, const glm::dvec3& p) {
  const glm::dvec3 t = glm::clamp(lattice.to_lattice(p) - glm::dvec3(cell.at), 0.0, 1.0);
  std::array<double, 8> out{};
  for (std::uint32_t k = 0; k < 8; ++k)
    out[k] = (k & 1u ? t.x : 1 - t.x) * (k & 2u ? t.y : 1 - t.y) * (k & 4u ? t.z : 1 - t.z);
  return out;
}

std::vector<MatrixEntry> equations(const Lattice& lattice, const SkinnedMesh& mesh) {
  std::vector<MatrixEntry> out;
  const auto add = [&](std::uint32_t a, std::uint32_t b, double value) {
    out.push_back({std::max(a, b), std::min(a, b), value});
  };
  // An edge has four cells where all are filled.
  for (const Lattice::Cell& cell : lattice.cells)
    for (std::uint32_t k = 0; k < 8; ++k)
      for (std::uint32_t axis = 1; axis < 8; axis *= 2) {
        if (k & axis) continue;
        const std::uint32_t a = cell.nodes[k], b = cell.nodes[k | axis];
        add(a, a, 0.25);
        add(b, b, 0.25);
        add(a, b, -0.25);
      }
  // What a cell's vertices add up to, so that the list does not grow with them.
  std::vector<std::array<double, 36>> sums(lattice.cells.size());
  for (std::size_t v = 0; v < lattice.cell_of.size(); ++v) {
    const std::uint32_t c = lattice.cell_of[v];
    if (c == Lattice::kNone) continue;
    const std::array<double, 8> shares = shares_of(lattice, lattice.cells[c], mesh.positions[v]);
    for (std::size_t a = 0, i = 0; a < 8; ++a)
      for (std::size_t b = 0; b <= a; ++b) sums[c][i++] += kOfVertices * shares[a] * shares[b];
  }
  for (std::size_t c = 0; c < sums.size(); ++c)
    for (std::size_t a = 0, i = 0; a < 8; ++a)
      for (std::size_t b = 0; b <= a; ++b, ++i)
        if (sums[c][i] > 0) add(lattice.cells[c].nodes[a], lattice.cells[c].nodes[b], sums[c][i]);
  return out;
}

// A joint and the vertices that follow it.
using Followers = std::vector<std::pair<std::uint32_t, std::vector<Influence>>>;  // there `joint` is the vertex

Followers followers_of(const Lattice& lattice, const SkinnedMesh& mesh) {
  std::map<std::uint32_t, std::vector<Influence>> by_joint;
  for (std::uint32_t v = 0; v < mesh.influences.size(); ++v) {
    if (lattice.cell_of[v] == Lattice::kNone) continue;
    for (const Influence& i : mesh.influences[v]) by_joint[i.joint].push_back({v, i.weight});
  }
  return {by_joint.begin(), by_joint.end()};
}

}  // namespace

std::vector<std::vector<Influence>> node_weights(const Lattice& lattice, const SkinnedMesh& mesh) {
  const std::size_t count = lattice.nodes.size();
  std::vector<std::vector<Influence>> out(count);
  const Factor factor(count, equations(lattice, mesh));
  const Followers joints = followers_of(lattice, mesh);
  const std::size_t batches = (joints.size() + 3) / 4;
  std::vector<std::vector<std::pair<std::uint32_t, Influence>>> found(batches);  // nodes and what they have
  tools::for_each_in_parallel(batches, [&](std::size_t batch) {
    std::vector<Four> x(count);
    const std::size_t first = 4 * batch, last = std::min(joints.size(), first + 4);
    for (std::size_t j = first; j < last; ++j)
      for (const Influence& of : joints[j].second) {
        const Lattice::Cell& cell = lattice.cells[lattice.cell_of[of.joint]];
        const std::array<double, 8> shares = shares_of(lattice, cell, mesh.positions[of.joint]);
        for (std::size_t k = 0; k < 8; ++k)
          x[cell.nodes[k]].v[j - first] += static_cast<float>(kOfVertices * shares[k] * of.weight);
      }
    factor.solve(x);
    for (std::size_t j = first; j < last; ++j)
      for (std::uint32_t n = 0; n < count; ++n) {
        const auto weight = static_cast<double>(x[n].v[j - first]);
        if (weight >= kLeast) found[batch].push_back({n, {joints[j].first, weight}});
      }
  });
  for (const auto& batch : found)
    for (const auto& [node, influence] : batch) out[node].push_back(influence);
  for (std::vector<Influence>& node : out) keep_largest(node, kMostJoints, 0);
  return out;
}

}  // namespace marrow::deform
