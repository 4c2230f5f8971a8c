#include "deform/elastic/lattice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/common.hpp>

#include "common/distinct.h"
#include "common/elementary.h"
#include "deform/skinned_mesh.h"
#include "deform/surface.h"
#include "deform/weights/voxels.h"

namespace marrow::deform {
namespace {

constexpr double kLeastInCommon = 0.15;

// Σ of the lesser of a joint's two shares.
double in_common(const std::vector<Influence>& a, double sum_a, const std::vector<Influence>& b, double sum_b) {
  double out = 0;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (i->joint == j->joint) out += std::min(i->weight / sum_a, j->weight / sum_b);
    const bool first = i->joint <= j->joint, second = j->joint <= i->joint;
    i += first;
    j += second;
  }
  return out;
}

bool any_in_common(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    if (*i == *j) return true;
    if (*i < *j) {
      ++i;
    } else {
      ++j;
    }
  }
  return false;
}

// Neighbouring solid voxels are linked, unless a surface goes through both, the surfaces follow joints of which less
// than 15 % are the same, and they have no vertex in common. Refers to `voxels`.
class Links {
 public:
  Links(const Voxels& voxels, const SkinnedMesh& mesh);
  // Of two solid cells beside each other.
  bool linked(std::size_t a, std::size_t b) const;

 private:
  static constexpr std::size_t kMostVertices = 24;
  static constexpr std::size_t kMostJoints = 12;
  struct Surface {
    std::vector<std::uint32_t> vertices;  // of the triangles that touch the voxel, ascending; the first so many
    std::vector<Influence> weights;       // their sum, by ascending joint
    double sum = 0;
  };
  void add(std::size_t triangle, const SkinnedMesh& mesh, Surface& surface) const;

  static constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> number_;  // of a cell, among the surfaces
  std::vector<Surface> surfaces_;
};

Links::Links(const Voxels& voxels, const SkinnedMesh& mesh) : number_(voxels.cells(), kNone) {
  std::vector<std::size_t> touched;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    touched.clear();
    const auto at = [&](std::size_t i) { return mesh.positions[mesh.indices[t + i]]; };
    voxels.add_touched(at(0), at(1), at(2), touched);
    tools::make_distinct(touched);
    for (const std::size_t cell : touched) {
      if (number_[cell] == kNone) {
        number_[cell] = static_cast<std::uint32_t>(surfaces_.size());
        surfaces_.emplace_back();
      }
      add(t, mesh, surfaces_[number_[cell]]);
    }
  }
}

void Links::add(std::size_t triangle, const SkinnedMesh& mesh, Surface& surface) const {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t v = mesh.indices[triangle + i];
    const auto place = std::ranges::lower_bound(surface.vertices, v);
    if ((place == surface.vertices.end() || *place != v) && surface.vertices.size() < kMostVertices)
      surface.vertices.insert(place, v);
    for (const Influence& influence : mesh.influences[v]) {
      const auto joint = std::ranges::lower_bound(surface.weights, influence.joint, {}, &Influence::joint);
      if (joint != surface.weights.end() && joint->joint == influence.joint) {
        joint->weight += influence.weight;
      } else if (surface.weights.size() < kMostJoints) {
        surface.weights.insert(joint, influence);
      }
      surface.sum += influence.weight;
    }
  }
}

bool Links::linked(std::size_t a, std::size_t b) const {
  if (number_[a] == kNone || number_[b] == kNone) return true;
  const Surface &first = surfaces_[number_[a]], &second = surfaces_[number_[b]];
  return any_in_common(first.vertices, second.vertices) ||
         !(in_common(first.weights, first.sum, second.weights, second.sum) < kLeastInCommon);
}

constexpr int kFine = 3;  // voxels along a cell
constexpr int kFirstResolution = 96, kLeastResolution = 48, kMostResolution = 900;
constexpr double kMostVoxels = 8e6;  // of the box
constexpr int kTries = 5;
constexpr double kNearEnough = 0.08;

// Cells of kFine³ voxels over those of a mesh, placed as evenly on both sides as the voxels are.
class Coarse {
 public:
  explicit Coarse(const Voxels& voxels) : voxels_(voxels), shift_(voxels.size() % kFine) {
    size_ = (voxels.size() + shift_ + kFine - 1) / kFine;
    count_.assign(
        static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(size_.z), 0);
    for (std::size_t v = 0; v < voxels.cells(); ++v)
      if (voxels.solid(v)) ++count_[cell_of(v)];
  }

  glm::ivec3 at_of(std::size_t voxel) const { return (voxels_.voxel_of(voxel) + shift_) / kFine; }
  std::size_t cell_of(std::size_t voxel) const { return index_of(at_of(voxel)); }
  std::size_t filled() const {
    return static_cast<std::size_t>(std::ranges::count_if(count_, [](std::uint8_t c) { return c > 0; }));
  }
  // Of 4³ cells round a corner.
  float filled_around(const glm::ivec3& corner) const {
    int out = 0;
    glm::ivec3 at;
    for (at.z = corner.z - 2; at.z < corner.z + 2; ++at.z)
      for (at.y = corner.y - 2; at.y < corner.y + 2; ++at.y)
        for (at.x = corner.x - 2; at.x < corner.x + 2; ++at.x)
          if (has(at)) out += count_[index_of(at)];
    return static_cast<float>(out) / (64 * kFine * kFine * kFine);
  }
  glm::dvec3 origin() const { return voxels_.from_grid(-glm::dvec3(shift_)); }

 private:
  bool has(const glm::ivec3& at) const {
    return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size_.x && at.y < size_.y && at.z < size_.z;
  }
  std::size_t index_of(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(at.y)) *
               static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(at.x);
  }

  const Voxels& voxels_;
  glm::ivec3 shift_, size_{0};
  std::vector<std::uint8_t> count_;  // solid voxels of a cell
};

int most_resolution(const SkinnedMesh& mesh) {
  const Box box = box_of(mesh.positions, mesh.indices);
  const glm::dvec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z, 1e-30});
  const auto voxels = [&](double resolution) {
    const glm::dvec3 n = extent * (resolution / longest) + 4.0;
    return n.x * n.y * n.z;
  };
  int out = kMostResolution;
  while (out > kLeastResolution && voxels(out) > kMostVoxels) out = out * 15 / 16;
  return out;
}

Voxels voxels_for(const SkinnedMesh& mesh, std::size_t cells) {
  const int most = most_resolution(mesh);
  int resolution = std::min(kFirstResolution, most);
  for (int i = 0;; ++i) {
    Voxels out(mesh.positions, mesh.indices, resolution);
    const auto filled = static_cast<double>(std::max<std::size_t>(Coarse(out).filled(), 1));
    const double ratio = static_cast<double>(cells) / filled;
    const double grown = resolution * tools::cube_root(ratio);
    const int next = static_cast<int>(std::clamp(grown, double(kLeastResolution), double(most)));
    if (i == kTries || std::abs(ratio - 1) < kNearEnough || next == resolution) return out;
    resolution = next;
  }
}

// The pieces of cells, and what is linked.
class Pieces {
 public:
  Pieces(const Voxels& voxels, const Coarse& coarse, const SkinnedMesh& mesh) : voxels_(voxels), coarse_(coarse) {
    const Links links(voxels, mesh);
    number_voxels();
    Unions up(solid_.size());
    std::vector<std::array<std::uint32_t, 3>> across;  // two voxels of two cells, and the axis
    for (std::uint32_t i = 0; i < solid_.size(); ++i)
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::size_t next = solid_[i] + static_cast<std::size_t>(voxels.offset(axis == 0, axis == 1, axis == 2));
        if (!voxels.solid(next) || !links.linked(solid_[i], next)) continue;
        const std::uint32_t other = number_[next];
        if (coarse.cell_of(solid_[i]) == coarse.cell_of(next)) {
          up.unite(i, other);
        } else {
          across.push_back({i, other, axis});
        }
      }
    number_pieces(up);
    link(across);
  }

  // Of a vertex's voxel.
  std::uint32_t piece_at(const glm::dvec3& p) const {
    const glm::dvec3 grid = voxels_.to_grid(p);
    if (!voxels_.is_inner(grid)) return Lattice::kNone;
    const std::size_t voxel = voxels_.cell_at(grid);
    return voxels_.solid(voxel) ? piece_of_[number_[voxel]] : Lattice::kNone;
  }

  std::vector<Lattice::Cell> cells;  // corners are numbers in `corner`
  std::optional<Unions> corner;      // 8 a cell: those that are the same
  std::vector<std::uint32_t> body;   // of a cell: the first that it hangs together with

 private:
  void number_voxels() {
    number_.assign(voxels_.cells(), Lattice::kNone);
    for (std::size_t v = 0; v < voxels_.cells(); ++v) {
      if (!voxels_.solid(v)) continue;
      number_[v] = static_cast<std::uint32_t>(solid_.size());
      solid_.push_back(v);
    }
  }

  void number_pieces(Unions& up) {
    piece_of_.assign(solid_.size(), Lattice::kNone);
    for (std::uint32_t i = 0; i < solid_.size(); ++i) {
      const std::uint32_t root = up.root(i);  // at most i
      if (root == i) {
        piece_of_[i] = static_cast<std::uint32_t>(cells.size());
        cells.emplace_back().at = coarse_.at_of(solid_[i]);
        cells.back().beside.fill(Lattice::kNone);
      }
      piece_of_[i] = piece_of_[root];
      cells[piece_of_[i]].filled += 1.0f / (kFine * kFine * kFine);
    }
  }

  void link(const std::vector<std::array<std::uint32_t, 3>>& across) {
    corner.emplace(8 * cells.size());
    Unions bodies(cells.size());
    for (const auto& [i, j, axis] : across) {
      const std::uint32_t a = piece_of_[i], b = piece_of_[j];
      bodies.unite(a, b);
      const auto face = static_cast<std::size_t>(2 * axis);
      if (cells[a].beside[face + 1] == Lattice::kNone) cells[a].beside[face + 1] = b;
      if (cells[b].beside[face] == Lattice::kNone) cells[b].beside[face] = a;
      for (std::uint32_t c = 0; c < 8; ++c)
        if (c >> axis & 1u) corner->unite(8 * a + c, 8 * b + (c ^ (1u << axis)));
    }
    for (std::uint32_t c = 0; c < cells.size(); ++c) body.push_back(bodies.root(c));
  }

  const Voxels& voxels_;
  const Coarse& coarse_;
  std::vector<std::uint32_t> number_;  // of a voxel, among the solid
  std::vector<std::size_t> solid_;
  std::vector<std::uint32_t> piece_of_;  // of a solid voxel
};

// Numbers the cells that stay, and their corners in the order in which they appear.
void take_cells(Pieces& pieces, const std::vector<char>& stays, const Coarse& coarse, Lattice& out) {
  std::vector<std::uint32_t> number(pieces.cells.size(), Lattice::kNone);
  std::uint32_t count = 0;
  for (std::size_t c = 0; c < number.size(); ++c)
    if (stays[pieces.body[c]] != 0) number[c] = count++;
  std::vector<std::uint32_t> node(8 * pieces.cells.size(), Lattice::kNone);
  for (std::uint32_t c = 0; c < number.size(); ++c) {
    if (number[c] == Lattice::kNone) continue;
    Lattice::Cell& cell = out.cells.emplace_back(pieces.cells[c]);
    for (std::uint32_t& b : cell.beside)
      if (b != Lattice::kNone) b = number[b];
    for (std::uint32_t k = 0; k < 8; ++k) {
      std::uint32_t& n = node[pieces.corner->root(8 * c + k)];
      if (n == Lattice::kNone) {
        n = static_cast<std::uint32_t>(out.nodes.size());
        out.nodes.push_back(cell.at + glm::ivec3(k & 1u, k >> 1 & 1u, k >> 2 & 1u));
        out.filled_around.push_back(coarse.filled_around(out.nodes.back()));
      }
      cell.nodes[k] = n;
    }
  }
  for (std::uint32_t& c : out.cell_of)
    if (c != Lattice::kNone) c = number[c];
}

}  // namespace

std::size_t cells_for(std::size_t vertices) {
  return std::clamp<std::size_t>(20 * std::min<std::size_t>(vertices, 10'000), 500, 10'000);
}

Lattice make_lattice(const SkinnedMesh& mesh, std::size_t cells) {
  Lattice out;
  out.cell_of.assign(mesh.positions.size(), Lattice::kNone);
  if (mesh.indices.empty() || !is_finite(mesh.positions) || !(diagonal(mesh) > 1e-30)) return out;
  const Voxels voxels = voxels_for(mesh, cells);
  const Coarse coarse(voxels);
  out.side = kFine * voxels.side();
  out.origin = coarse.origin();
  Pieces pieces(voxels, coarse, mesh);
  std::vector<char> stays(pieces.cells.size(), 0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.influences[v].empty()) continue;
    out.cell_of[v] = pieces.piece_at(mesh.positions[v]);
    if (out.cell_of[v] != Lattice::kNone) stays[pieces.body[out.cell_of[v]]] = 1;
  }
  take_cells(pieces, stays, coarse, out);
  return out;
}

}  // namespace marrow::deform
