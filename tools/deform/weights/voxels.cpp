#include "deform/weights/voxels.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "common/elementary.h"

namespace marrow::deform {
namespace {

using Corners = std::array<glm::dvec3, 3>;  // of a triangle, in grid coordinates

constexpr std::size_t kMostSolid = 400'000;
constexpr double kMostColumns = 2e7;  // that triangles' boxes cover: work, not memory
constexpr int kLeastResolution = 16;
constexpr int kEnoughVotes = 4;  // of 6
constexpr double kTouch = 1e-9;  // voxels; what only touches a voxel counts

int to_int(double x) {
  return static_cast<int>(std::floor(x));
}

// Whether they overlap when looked at along `axis`, which is of any length.
bool overlap_along(const glm::dvec3& axis, const Corners& t, const glm::dvec3& centre) {
  const double a = glm::dot(axis, t[0] - centre), b = glm::dot(axis, t[1] - centre), c = glm::dot(axis, t[2] - centre);
  const double reach = (0.5 + kTouch) * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
  return std::min({a, b, c}) <= reach && std::max({a, b, c}) >= -reach;
}

// By separating axes (Akenine-Möller, "Fast 3D triangle-box overlap testing", JGT 6(1), 2001).
bool overlaps(const Corners& t, const glm::dvec3& normal, const glm::dvec3& centre) {
  if (!overlap_along(normal, t, centre)) return false;
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 axis(0);
    axis[i] = 1;
    if (!overlap_along(axis, t, centre)) return false;
    for (std::size_t e = 0; e < 3; ++e)
      if (!overlap_along(glm::cross(axis, t[(e + 1) % 3] - t[e]), t, centre)) return false;
  }
  return true;
}

int longest_axis(const glm::dvec3& v) {
  const glm::dvec3 a = glm::abs(v);
  return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

// Calls f(voxel) for each voxel that the triangle touches, some twice. Of a triangle without area for those of its
// edges.
template <class F>
void for_each_touched(const Corners& t, const F& f) {
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const int w = longest_axis(normal), u = (w + 1) % 3, v = (w + 2) % 3;
  if (!(std::abs(normal[w]) > 1e-12)) {
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::dvec3 along = t[(e + 1) % 3] - t[e];
      const int steps = 1 + to_int(2 * glm::length(along));
      for (int i = 0; i <= steps; ++i) f(glm::ivec3(glm::floor(t[e] + along * (static_cast<double>(i) / steps))));
    }
    return;
  }
  const glm::ivec3 low(glm::floor(glm::min(glm::min(t[0], t[1]), t[2]) - kTouch));
  const glm::ivec3 high(glm::floor(glm::max(glm::max(t[0], t[1]), t[2]) + kTouch));
  const double du = normal[u] / normal[w], dv = normal[v] / normal[w];
  const double spread = 0.5 * (std::abs(du) + std::abs(dv)) + 1e-6;
  glm::ivec3 voxel(0);
  for (voxel[u] = low[u]; voxel[u] <= high[u]; ++voxel[u]) {
    for (voxel[v] = low[v]; voxel[v] <= high[v]; ++voxel[v]) {
      const double at = t[0][w] - du * (voxel[u] + 0.5 - t[0][u]) - dv * (voxel[v] + 0.5 - t[0][v]);
      const int last = std::min(high[w], to_int(std::min(at + spread, 1e6)));
      for (voxel[w] = std::max(low[w], to_int(std::max(at - spread, -1.0))); voxel[w] <= last; ++voxel[w])
        if (overlaps(t, normal, glm::dvec3(voxel) + 0.5)) f(voxel);
    }
  }
}

// Whether a line along the third axis goes through the triangle: an edge belongs to one of its two triangles, whatever
// rounding does, as its ends are taken in one order.
bool pierces(const Corners& t, int u, int v, double pu, double pv) {
  bool inside = false;
  for (std::size_t e = 0; e < 3; ++e) {
    const glm::dvec3 *a = &t[e], *b = &t[(e + 1) % 3];
    if (((*a)[v] > pv) == ((*b)[v] > pv)) continue;
    if ((*a)[v] > (*b)[v]) std::swap(a, b);
    inside ^= pu < (*a)[u] + ((*b)[u] - (*a)[u]) * ((pv - (*a)[v]) / ((*b)[v] - (*a)[v]));
  }
  return inside;
}

// Calls f(voxel, sign) for each line along axis w through voxels' centres that the triangle is pierced by: the first
// voxel whose centre lies behind it, and whether it faces the way the line goes.
template <class F>
void for_each_hit(const Corners& t, int w, const F& f) {
  const int u = (w + 1) % 3, v = (w + 2) % 3;
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  if (!(std::abs(normal[w]) > 0)) return;
  const glm::dvec3 low = glm::min(glm::min(t[0], t[1]), t[2]), high = glm::max(glm::max(t[0], t[1]), t[2]);
  glm::ivec3 voxel(0);
  for (voxel[u] = to_int(low[u]); voxel[u] <= to_int(high[u]); ++voxel[u]) {
    for (voxel[v] = to_int(low[v]); voxel[v] <= to_int(high[v]); ++voxel[v]) {
      const double pu = voxel[u] + 0.5, pv = voxel[v] + 0.5;
      if (!pierces(t, u, v, pu, pv)) continue;
      const double at = t[0][w] - (normal[u] * (pu - t[0][u]) + normal[v] * (pv - t[0][v])) / normal[w];
      voxel[w] = to_int(std::clamp(at, low[w], high[w]) + 0.5);
      f(voxel, normal[w] > 0 ? 1 : -1);
    }
  }
}

template <class F>
void for_each_triangle(const std::vector<glm::dvec3>& grid, std::span<const std::uint32_t> indices, const F& f) {
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    f(Corners{grid[indices[i]], grid[indices[i + 1]], grid[indices[i + 2]]});
}

// Columns of voxels in the boxes of all triangles, on average over the axes.
double columns(const Positions& positions, std::span<const std::uint32_t> indices, double side) {
  double sum = 0;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 &a = positions[indices[i]], &b = positions[indices[i + 1]], &c = positions[indices[i + 2]];
    const glm::dvec3 s = (glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c)) / side + 1.0;
    sum += (s.x * s.y + s.y * s.z + s.z * s.x) / 3;
  }
  return sum;
}

enum State : std::uint8_t { kUnknown, kSolid, kOutside };

}  // namespace

Box box_of(const Positions& positions, std::span<const std::uint32_t> indices) {
  Box box;
  bool first = true;
  const auto add = [&](const glm::dvec3& p) {
    box.low = first ? p : glm::min(box.low, p);
    box.high = first ? p : glm::max(box.high, p);
    first = false;
  };
  for (const std::uint32_t i : indices) add(positions[i]);
  if (first)
    for (const glm::dvec3& p : positions) add(p);
  return box;
}

Voxels::Voxels(const Positions& positions, std::span<const std::uint32_t> indices, int resolution) {
  const Box box = box_of(positions, indices);
  const glm::dvec3 extent = box.high - box.low;
  const double longest = std::max({extent.x, extent.y, extent.z});
  for (int n = resolution, next = 0;; n = std::max(next, kLeastResolution)) {
    side_ = longest > 1e-30 ? longest / n : 1.0;
    const bool last = n <= kLeastResolution;
    next = n * 3 / 4;
    if (!last && columns(positions, indices, side_) > kMostColumns) continue;
    // Centred, so that a symmetric mesh gets symmetric voxels; the outermost stay empty.
    size_ = glm::ivec3(glm::ceil(extent / side_)) + 3;
    origin_ = (box.low + box.high) * 0.5 - glm::dvec3(size_) * (0.5 * side_);
    const std::size_t solid = fill(positions, indices);
    if (solid <= kMostSolid || last) return;
    next = std::min(next, to_int(n * tools::cube_root(static_cast<double>(kMostSolid) / static_cast<double>(solid))));
  }
}

bool Voxels::is_inner(const glm::dvec3& grid) const {
  for (int i = 0; i < 3; ++i)
    if (!(grid[i] >= 1 && grid[i] < size_[i] - 1)) return false;
  return true;
}

std::size_t Voxels::cell_at(const glm::dvec3& grid) const {
  return static_cast<std::size_t>(offset(to_int(grid.x), to_int(grid.y), to_int(grid.z)));
}

glm::ivec3 Voxels::voxel_of(std::size_t cell) const {
  const auto i = static_cast<int>(cell);
  return {i % size_.x, i / size_.x % size_.y, i / (size_.x * size_.y)};
}

void Voxels::add_touched(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                         std::vector<std::size_t>& cells) const {
  for_each_touched({to_grid(a), to_grid(b), to_grid(c)}, [&](const glm::ivec3& voxel) {
    const glm::dvec3 centre = glm::dvec3(voxel) + 0.5;
    if (is_inner(centre)) cells.push_back(cell_at(centre));
  });
}

// From voxel to voxel across the faces that the line goes through, as Amanatides and Woo, "A fast voxel traversal
// algorithm for ray tracing", Eurographics 1987.
bool Voxels::sees(const glm::dvec3& from, const glm::dvec3& to) const {
  if (!is_inner(from) || !is_inner(to)) return false;
  auto cell = static_cast<std::ptrdiff_t>(cell_at(from));
  if (!solid(static_cast<std::size_t>(cell))) return false;
  const glm::ivec3 first(glm::floor(from)), last(glm::floor(to));
  std::array<int, 3> left{};             // faces to cross
  std::array<double, 3> next{}, each{};  // shares of the line: to the next face, from one to another
  std::array<std::ptrdiff_t, 3> step = {offset(1, 0, 0), offset(0, 1, 0), offset(0, 0, 1)};
  for (int i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(i);
    left[axis] = std::abs(last[i] - first[i]);
    if (left[axis] == 0) continue;
    const double along = std::abs(to[i] - from[i]);
    const bool forward = last[i] > first[i];
    each[axis] = 1 / along;
    next[axis] = (forward ? first[i] + 1 - from[i] : from[i] - first[i]) / along;
    if (!forward) step[axis] = -step[axis];
  }
  while (left[0] + left[1] + left[2] > 0) {
    std::size_t axis = left[0] > 0 ? 0 : left[1] > 0 ? 1 : 2;
    for (std::size_t i = axis + 1; i < 3; ++i)
      if (left[i] > 0 && next[i] < next[axis]) axis = i;
    cell += step[axis];
    next[axis] += each[axis];
    --left[axis];
    if (!solid(static_cast<std::size_t>(cell))) return false;
  }
  return true;
}

// What can be reached from the first voxel through voxels' faces.
static void flood(const Voxels& voxels, std::vector<std::uint8_t>& state) {
  std::vector<std::size_t> stack = {0};
  state[0] = kOutside;
  const std::ptrdiff_t steps[] = {
      1, -1, voxels.offset(0, 1, 0), -voxels.offset(0, 1, 0), voxels.offset(0, 0, 1), -voxels.offset(0, 0, 1)};
  while (!stack.empty()) {
    const auto cell = static_cast<std::ptrdiff_t>(stack.back());
    stack.pop_back();
    for (const std::ptrdiff_t step : steps) {
      // A step over the grid's edge lands in another row's outermost voxel, which is outside all the same.
      const std::ptrdiff_t next = cell + step;
      if (next < 0 || next >= static_cast<std::ptrdiff_t>(state.size())) continue;
      std::uint8_t& there = state[static_cast<std::size_t>(next)];
      if (there != kUnknown) continue;
      there = kOutside;
      stack.push_back(static_cast<std::size_t>(next));
    }
  }
}

// Adds to each voxel's votes those of the two directions along axis w.
static void vote(const Voxels& voxels, int w, const std::vector<glm::dvec3>& grid,
                 std::span<const std::uint32_t> indices, std::vector<std::uint8_t>& votes) {
  std::vector<std::int32_t> sums(votes.size(), 0);
  for_each_triangle(grid, indices, [&](const Corners& t) {
    for_each_hit(t, w, [&](const glm::ivec3& voxel, int sign) {
      sums[static_cast<std::size_t>(voxels.offset(voxel.x, voxel.y, voxel.z))] += sign;
    });
  });
  const glm::ivec3 size = voxels.size();
  const int u = (w + 1) % 3, v = (w + 2) % 3;
  glm::ivec3 step(0);
  step[w] = 1;
  const auto stride = static_cast<std::size_t>(voxels.offset(step.x, step.y, step.z));
  glm::ivec3 first(0);
  for (first[u] = 0; first[u] < size[u]; ++first[u]) {
    for (first[v] = 0; first[v] < size[v]; ++first[v]) {
      const auto start = static_cast<std::size_t>(voxels.offset(first.x, first.y, first.z));
      const std::size_t end = start + stride * static_cast<std::size_t>(size[w]);
      std::int32_t total = 0, before = 0;
      for (std::size_t cell = start; cell < end; cell += stride) total += sums[cell];
      for (std::size_t cell = start; cell < end; cell += stride) {
        before += sums[cell];
        votes[cell] = static_cast<std::uint8_t>(votes[cell] + (before != 0) + (total != before));
      }
    }
  }
}

// Returns how many are solid.
std::size_t Voxels::fill(const Positions& positions, std::span<const std::uint32_t> indices) {
  std::vector<glm::dvec3> grid;
  grid.reserve(positions.size());
  for (const glm::dvec3& p : positions) grid.push_back(to_grid(p));
  std::vector<std::uint8_t> votes(
      static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) * static_cast<std::size_t>(size_.z), 0);
  solid_.assign(votes.size(), kUnknown);
  for (const glm::dvec3& p : grid)
    if (is_inner(p)) solid_[cell_at(p)] = kSolid;
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    touched.clear();
    add_touched(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]], touched);
    for (const std::size_t cell : touched) solid_[cell] = kSolid;
  }
  flood(*this, solid_);
  for (int axis = 0; axis < 3; ++axis) vote(*this, axis, grid, indices, votes);
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < solid_.size(); ++cell) {
    const bool is_solid =
        solid_[cell] != kOutside || (votes[cell] >= kEnoughVotes && is_inner(glm::dvec3(voxel_of(cell)) + 0.5));
    solid_[cell] = is_solid ? 1 : 0;
    count += is_solid;
  }
  return count;
}

}  // namespace marrow::deform
