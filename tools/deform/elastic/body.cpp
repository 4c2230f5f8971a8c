#include "deform/elastic/body.h"

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

namespace {

constexpr double kPinned = 0.97;                    // of a joint's weight: there nodes go with it
constexpr double kThinner = 20, kOfOneJoint = 0.3;  // how much dearer what is thin, and what follows one joint
constexpr double kBlends = 0.6;                     // of the heaviest joint

double heaviest(const std::vector<Influence>& weights) {
  double out = 0;
  for (const Influence& i : weights) out = std::max(out, i.weight);
  return out;
}

// Of the eight cells round a node.
std::vector<double> filled_at_nodes(const Lattice& lattice) {
  std::vector<double> out(lattice.nodes.size(), 0);
  for (const Lattice::Cell& cell : lattice.cells)
    for (const std::uint32_t n : cell.nodes) out[n] += static_cast<double>(cell.filled) / 8;
  return out;
}

void number_nodes(const ElasticOptions& options, Body& body) {
  const Lattice& lattice = body.lattice;
  const std::vector<double> filled = filled_at_nodes(lattice);
  for (std::size_t n = 0; n < lattice.nodes.size(); ++n) {
    const double most = heaviest(body.weights[n]);
    const bool pinned = most >= kPinned;
    body.row.push_back(pinned ? Lattice::kNone : static_cast<std::uint32_t>(body.rows++));
    const double thick = smooth_step(static_cast<double>(lattice.filled_around[n]), kThin, kThick);
    body.keep.push_back(static_cast<float>(
        filled[n] * (options.keep * (1 + kThinner * (1 - thick)) + kOfOneJoint * smooth_step(most, kBlends, kPinned))));
  }
}

// Cells at places whose coordinates add up to an even number touch only those where they do not.
void order_cells(Body& body) {
  const Lattice& lattice = body.lattice;
  std::vector<std::uint32_t> order[3];
  for (std::uint32_t c = 0; c < lattice.cells.size(); ++c) {
    const Lattice::Cell& cell = lattice.cells[c];
    const bool is_free =
        std::ranges::any_of(cell.nodes, [&](std::uint32_t n) { return body.row[n] != Lattice::kNone; });
    order[is_free ? (cell.at.x + cell.at.y + cell.at.z) & 1 : 2].push_back(c);
  }
  std::vector<std::uint32_t> number(lattice.cells.size());
  for (const std::vector<std::uint32_t>& part : order) {
    for (const std::uint32_t c : part) {
      number[c] = static_cast<std::uint32_t>(body.cells.size());
      body.cells.push_back({lattice.cells[c].nodes, lattice.cells[c].beside, lattice.cells[c].filled});
    }
    while (&part != &order[2] && body.cells.size() % 4 != 0) {
      ElasticCell& none = body.cells.emplace_back(body.cells.back());
      none.filled = 0;
      none.beside.fill(Lattice::kNone);
    }
    if (&part == &order[0]) body.half = body.cells.size();
    if (&part == &order[1]) body.free = body.cells.size();
  }
  for (ElasticCell& cell : body.cells)
    for (std::uint32_t& b : cell.beside)
      b = b == Lattice::kNone ? static_cast<std::uint32_t>(body.cells.size()) : number[b];
}

double sign(std::uint32_t node, std::uint32_t mode) {
  std::uint32_t unset = ~node & mode;  // a minus for each
  unset ^= unset >> 2;
  return (unset ^ unset >> 1) & 1u ? -1 : 1;
}

// What two corners of a cell have with each other in its energy.
double stiffness(std::uint32_t a, std::uint32_t b, double volume) {
  double out = 0;
  for (std::uint32_t mode = 1; mode < 8; ++mode) {
    const bool is_gradient = mode == 1 || mode == 2 || mode == 4;
    const double cost = is_gradient ? (1 + volume) / 16 : static_cast<double>(mode == 7 ? kTwisting : kBending);
    out += cost * sign(a, mode) * sign(b, mode);
  }
  return out;
}

void factorise(double volume, Body& body) {
  std::vector<MatrixEntry> entries;
  double table[8][8];
  for (std::uint32_t a = 0; a < 8; ++a)
    for (std::uint32_t b = 0; b < 8; ++b) table[a][b] = stiffness(a, b, volume);
  for (std::size_t n = 0; n < body.row.size(); ++n)
    if (body.row[n] != Lattice::kNone) entries.push_back({body.row[n], body.row[n], static_cast<double>(body.keep[n])});
  for (std::size_t c = 0; c < body.free; ++c) {
    const ElasticCell& cell = body.cells[c];
    for (std::uint32_t a = 0; a < 8; ++a)
      for (std::uint32_t b = 0; b < 8; ++b) {
        const std::uint32_t row = body.row[cell.nodes[a]], column = body.row[cell.nodes[b]];
        if (row == Lattice::kNone || column == Lattice::kNone || row < column || cell.filled == 0) continue;
        entries.push_back({row, column, static_cast<double>(cell.filled) * table[a][b]});
      }
  }
  body.factor = std::make_unique<Factor>(body.rows, entries);
}

}  // namespace

double smooth_step(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Body make_body(const SkinnedMesh& mesh, const ElasticOptions& options, std::size_t cells) {
  Body body;
  body.lattice = make_lattice(mesh, cells);
  body.weights = node_weights(body.lattice, mesh);
  body.volume = static_cast<float>(options.volume);
  number_nodes(options, body);
  order_cells(body);
  factorise(options.volume, body);
  return body;
}

}  // namespace marrow::deform
