#include <cmath>
#include <limits>

#include "deform/rig/room.h"

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

}  // namespace marrow::deform
