#include "deform/rig/room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

constexpr double kFar = 1e12;  // squared voxels; more than any grid has

// The lower envelope of parabolas along a row (Felzenszwalb and Huttenlocher, "Distance transforms of sampled
// functions", Theory of Computing 8, 2012).
class Row {
 public:
  explicit Row(std::size_t most) : heights_(most), roots_(most), from_(most + 1) {}

  void transform(double* first, std::size_t stride, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) heights_[i] = first[i * stride];
    std::size_t last = 0;
    roots_[0] = 0;
    from_[0] = -std::numeric_limits<double>::infinity();
    for (std::size_t q = 1; q < count; ++q) {
      double cut = crossing(roots_[last], q);
      while (cut <= from_[last]) cut = crossing(roots_[--last], q);
      roots_[++last] = q;
      from_[last] = cut;
    }
    for (std::size_t i = 0, at = 0; i < count; ++i) {
      while (at < last && from_[at + 1] < static_cast<double>(i)) ++at;
      const double way = static_cast<double>(i) - static_cast<double>(roots_[at]);
      first[i * stride] = way * way + heights_[roots_[at]];
    }
  }

 private:
  // Where the parabola round q gets below that round p, q being behind p.
  double crossing(std::size_t p, std::size_t q) const {
    const auto a = static_cast<double>(p), b = static_cast<double>(q);
    return ((heights_[q] + b * b) - (heights_[p] + a * a)) / (2 * (b - a));
  }

  std::vector<double> heights_;
  std::vector<std::size_t> roots_;
  std::vector<double> from_;
};

}  // namespace

std::vector<double> squared_distances_inside(const Voxels& voxels) {
  std::vector<double> out(voxels.cells());
  for (std::size_t cell = 0; cell < out.size(); ++cell) out[cell] = voxels.solid(cell) ? kFar : 0;
  const glm::ivec3 size = voxels.size();
  for (int w = 0; w < 3; ++w) {
    const int u = (w + 1) % 3, v = (w + 2) % 3;
    glm::ivec3 step(0), first(0);
    step[w] = 1;
    const auto stride = static_cast<std::size_t>(voxels.offset(step.x, step.y, step.z));
    Row row(static_cast<std::size_t>(size[w]));
    for (first[u] = 0; first[u] < size[u]; ++first[u])
      for (first[v] = 0; first[v] < size[v]; ++first[v])
        row.transform(&out[static_cast<std::size_t>(voxels.offset(first.x, first.y, first.z))], stride,
                      static_cast<std::size_t>(size[w]));
  }
  return out;
}

MirrorPlane mirror_plane(const Voxels& voxels) {
  double sum = 0, count = 0;
  for (std::size_t cell = 0; cell < voxels.cells(); ++cell) {
    if (!voxels.solid(cell)) continue;
    sum += voxels.voxel_of(cell).x + 0.5;
    ++count;
  }
  MirrorPlane best;
  if (!(count > 0)) return best;
  // The scene's own plane, the middle of the box, the middle of the volume; the first of the best.
  for (const double x : {voxels.to_grid(glm::dvec3(0)).x, voxels.size().x * 0.5, sum / count}) {
    if (!(x >= 0 && x <= voxels.size().x)) continue;
    double opposite = 0;
    for (std::size_t cell = 0; cell < voxels.cells(); ++cell) {
      if (!voxels.solid(cell)) continue;
      const glm::ivec3 at = voxels.voxel_of(cell);
      const glm::dvec3 there(2 * x - (at.x + 0.5), at.y + 0.5, at.z + 0.5);
      if (voxels.is_inner(there) && voxels.solid(voxels.cell_at(there))) ++opposite;
    }
    if (opposite / count > best.share + 0.01) best = {x, opposite / count};
  }
  return best;
}

namespace {

constexpr std::size_t kMostSpheres = 700;
constexpr double kMedialRise = 0.5;    // distances grow by less in every direction: there is a ridge
constexpr double kLeastSpacing = 0.5;  // of centres, shares of the wider sphere's radius; more where they get too many
constexpr double kCorner = 1.75,
                 kNarrow = 0.15;  // of a box's corners: how far out they are, and how wide they count as
constexpr double kReach = 1.3;    // of neighbours, likewise
constexpr double kGap = 0.06;     // that separates parts, shares of the height

constexpr double kNoWay = std::numeric_limits<double>::infinity();

// f(voxel) for the voxels whose centres are within a sphere.
template <class F>
void for_each_within(const Voxels& voxels, const Sphere& sphere, const F& f) {
  const glm::ivec3 low = glm::max(glm::ivec3(glm::floor(sphere.centre - sphere.radius)), glm::ivec3(0));
  const glm::ivec3 high = glm::min(glm::ivec3(glm::floor(sphere.centre + sphere.radius)), voxels.size() - 1);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const glm::dvec3 way = glm::dvec3(x, y, z) + 0.5 - sphere.centre;
        if (glm::dot(way, way) <= sphere.radius * sphere.radius) f(static_cast<std::size_t>(voxels.offset(x, y, z)));
      }
}

// What only rounds off a corner of what a wider sphere fills; the corner of a cube is √3 radii from its middle.
bool is_in_corner(const Sphere& sphere, const std::vector<Sphere>& wider) {
  return std::ranges::any_of(wider, [&](const Sphere& other) {
    return sphere.radius < kNarrow * other.radius && glm::length(sphere.centre - other.centre) < kCorner * other.radius;
  });
}

}  // namespace

Room::Room(const Voxels& voxels) : voxels_(voxels), depth_(squared_distances_inside(voxels)) {
  for (double& depth : depth_) depth = std::sqrt(depth);
  pack(kMostSpheres);
  if (spheres_.empty()) return;
  join();
  std::vector<std::size_t> part;
  bridge_parts(part);
  keep_largest_part(part);
  measure_ways();
}

std::vector<std::size_t> Room::medial_cells() const {
  std::vector<std::size_t> out;
  for (std::size_t cell = 0; cell < depth_.size(); ++cell) {
    if (!voxels_.solid(cell)) continue;
    bool is_medial = true;
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          if (x == 0 && y == 0 && z == 0) continue;
          const auto there = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(cell) + voxels_.offset(x, y, z));
          const double step = std::sqrt(static_cast<double>(x * x + y * y + z * z));
          is_medial &= depth_[there] - depth_[cell] < kMedialRise * step;
        }
    if (is_medial) out.push_back(cell);
  }
  std::stable_sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) { return depth_[a] > depth_[b]; });
  return out;
}

// From the widest down, each whose centre is not near that of one before.
void Room::pack(std::size_t most) {
  const std::vector<std::size_t> cells = medial_cells();
  for (double spacing = kLeastSpacing;; spacing *= 1.25) {
    spheres_.clear();
    std::vector<char> taken(depth_.size(), 0);
    for (std::size_t i = 0; i < cells.size() && spheres_.size() <= most; ++i) {
      if (taken[cells[i]] != 0) continue;
      const Sphere sphere = {glm::dvec3(voxels_.voxel_of(cells[i])) + 0.5, depth_[cells[i]] - 0.5};
      if (is_in_corner(sphere, spheres_)) continue;
      spheres_.push_back(sphere);
      for_each_within(voxels_, {sphere.centre, std::max(sphere.radius * spacing, 1.0)},
                      [&](std::size_t cell) { taken[cell] = 1; });
    }
    if (spheres_.size() <= most) break;
  }
  wide_.assign(depth_.size(), 0);
  for (const Sphere& sphere : spheres_)
    for_each_within(voxels_, sphere,
                    [&](std::size_t cell) { wide_[cell] = std::max(wide_[cell], static_cast<float>(sphere.radius)); });
}

void Room::join() {
  neighbours_.assign(spheres_.size(), {});
  for (std::size_t a = 0; a < spheres_.size(); ++a)
    for (std::size_t b = a + 1; b < spheres_.size(); ++b) {
      const double way = glm::length(spheres_[a].centre - spheres_[b].centre);
      // a is the wider one.
      if (way > std::max(kReach * spheres_[a].radius, spheres_[a].radius + spheres_[b].radius) + 2 ||
          !voxels_.sees(spheres_[a].centre, spheres_[b].centre))
        continue;
      neighbours_[a].emplace_back(b, way);
      neighbours_[b].emplace_back(a, way);
    }
}

// Which solid voxels hang together, by faces, edges or corners: a number a cell.
std::vector<std::uint32_t> Room::pieces() const {
  std::vector<std::uint32_t> out(depth_.size(), 0);
  std::vector<std::size_t> stack;
  std::uint32_t number = 0;
  for (std::size_t first = 0; first < out.size(); ++first) {
    if (!voxels_.solid(first) || out[first] != 0) continue;
    out[first] = ++number;
    for (stack = {first}; !stack.empty();) {
      const auto cell = static_cast<std::ptrdiff_t>(stack.back());
      stack.pop_back();
      for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x) {
            const auto next = static_cast<std::size_t>(cell + voxels_.offset(x, y, z));
            if (!voxels_.solid(next) || out[next] != 0) continue;
            out[next] = number;
            stack.push_back(next);
          }
    }
  }
  return out;
}

// part: of each sphere. The nearest two spheres of different parts are joined, in one piece of the mesh wherever they
// are, else as long as the gap is small.
void Room::bridge_parts(std::vector<std::size_t>& part) {
  part.resize(spheres_.size());
  std::iota(part.begin(), part.end(), std::size_t{0});
  const auto unite = [&](std::size_t a, std::size_t b) {
    const std::size_t kept = std::min(part[a], part[b]), gone = std::max(part[a], part[b]);
    for (std::size_t& p : part)
      if (p == gone) p = kept;
  };
  for (std::size_t a = 0; a < spheres_.size(); ++a)
    for (const auto& [b, way] : neighbours_[a])
      if (part[a] != part[b]) unite(a, b);
  struct Gap {
    double width;
    std::size_t a, b;
  };
  std::vector<Gap> gaps;
  const std::vector<std::uint32_t> piece = pieces();
  const auto piece_of = [&](std::size_t sphere) { return piece[voxels_.cell_at(spheres_[sphere].centre)]; };
  for (std::size_t a = 0; a < spheres_.size(); ++a)
    for (std::size_t b = a + 1; b < spheres_.size(); ++b) {
      if (part[a] == part[b]) continue;
      const double width =
          glm::length(spheres_[a].centre - spheres_[b].centre) - spheres_[a].radius - spheres_[b].radius;
      if (piece_of(a) == piece_of(b) || width <= kGap * voxels_.size().y) gaps.push_back({width, a, b});
    }
  std::stable_sort(gaps.begin(), gaps.end(), [](const Gap& x, const Gap& y) { return x.width < y.width; });
  for (const auto& [width, a, b] : gaps) {
    if (part[a] == part[b]) continue;
    unite(a, b);
    const double way = glm::length(spheres_[a].centre - spheres_[b].centre);
    neighbours_[a].emplace_back(b, way);
    neighbours_[b].emplace_back(a, way);
  }
}

void Room::keep_largest_part(const std::vector<std::size_t>& part) {
  // By voxels within spheres, each once.
  std::vector<double> volume(spheres_.size(), 0);
  std::vector<char> counted(depth_.size(), 0);
  double all = 0;
  for (std::size_t s = 0; s < spheres_.size(); ++s)
    for_each_within(voxels_, spheres_[s], [&](std::size_t cell) {
      if (counted[cell] != 0) return;
      counted[cell] = 1;
      ++volume[part[s]];
      ++all;
    });
  const auto largest = static_cast<std::size_t>(std::ranges::max_element(volume) - volume.begin());
  share_of_largest_part_ = volume[largest] / all;
  std::vector<std::size_t> number(spheres_.size(), 0);
  std::vector<Sphere> kept;
  for (std::size_t s = 0; s < spheres_.size(); ++s) {
    if (part[s] != largest) continue;
    number[s] = kept.size();
    kept.push_back(spheres_[s]);
  }
  Neighbours neighbours;
  for (std::size_t s = 0; s < spheres_.size(); ++s) {
    if (part[s] != largest) continue;
    neighbours.emplace_back();
    for (const auto& [other, way] : neighbours_[s]) neighbours.back().emplace_back(number[other], way);
  }
  spheres_ = std::move(kept);
  neighbours_ = std::move(neighbours);
}

// Dijkstra's algorithm: of each sphere the one before it on the way.
std::vector<std::size_t> Room::sources_of(std::size_t from, std::vector<double>& distances) const {
  distances.assign(spheres_.size(), kNoWay);
  std::vector<std::size_t> source(spheres_.size(), from);
  std::set<std::pair<double, std::size_t>> waiting = {{0.0, from}};
  distances[from] = 0;
  while (!waiting.empty()) {
    const auto [so_far, at] = *waiting.begin();
    waiting.erase(waiting.begin());
    for (const auto& [next, way] : neighbours_[at]) {
      if (!(so_far + way < distances[next])) continue;
      waiting.erase({distances[next], next});
      distances[next] = so_far + way;
      source[next] = at;
      waiting.emplace(distances[next], next);
    }
  }
  return source;
}

void Room::measure_ways() {
  distances_.clear();
  std::vector<double> row;
  for (std::size_t s = 0; s < spheres_.size(); ++s) {
    sources_of(s, row);
    distances_.insert(distances_.end(), row.begin(), row.end());
  }
}

std::vector<std::size_t> Room::way(std::size_t from, std::size_t to) const {
  std::vector<double> distances;
  const std::vector<std::size_t> source = sources_of(from, distances);
  std::vector<std::size_t> out = {to};
  while (out.back() != from) out.push_back(source[out.back()]);
  std::ranges::reverse(out);
  return out;
}

double Room::off_centre(const glm::dvec3& p) const {
  if (!voxels_.is_inner(p)) return 2;
  const std::size_t cell = voxels_.cell_at(p);
  if (!voxels_.solid(cell)) return 1.5;
  const double wide = std::max(static_cast<double>(wide_[cell]), 1.0);
  return 1 - std::min((depth_[cell] - 0.5) / wide, 1.0);
}

}  // namespace marrow::deform
