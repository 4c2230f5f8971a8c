// Triangle meshes in memory, for what depends on how vertices hang together.
#pragma once

#include <map>

#include "support/rig.h"

namespace marrow::test {

struct SurfaceVertex {
  std::vector<std::uint16_t> set;
  TestVertex vertex;
};
using Triangle = std::array<std::uint32_t, 3>;

// Vertices in runs of equal sets, triangles of their slots.
class TestSurface {
 public:
  TestSurface(const std::vector<SurfaceVertex>& vertices, const std::vector<Triangle>& triangles,
              const std::vector<Map>& inverse_bind, bool residuals = false)
      : mesh_(runs_of(vertices), inverse_bind, residuals), slot_of_(vertices.size()) {
    std::map<std::vector<std::uint16_t>, std::size_t> used;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      std::size_t run = 0;
      while (mesh_.source[run].set != vertices[v].set) ++run;
      slot_of_[v] = static_cast<std::uint32_t>(mesh_.slot(run, used[vertices[v].set]++));
    }
    for (const Triangle& t : triangles)
      for (const std::uint32_t v : t) indices_.push_back(static_cast<std::uint16_t>(slot_of_[v]));
  }
  Mesh view() const {
    Mesh m = mesh_.view();
    m.geometry.indices = indices_.data();
    m.geometry.index_count = static_cast<std::uint32_t>(indices_.size());
    return m;
  }
  std::uint32_t slot(std::size_t vertex) const { return slot_of_[vertex]; }
  std::uint32_t slot_count() const { return mesh_.slot_count; }

 private:
  // By ascending sets.
  static std::vector<TestRun> runs_of(const std::vector<SurfaceVertex>& vertices) {
    std::map<std::vector<std::uint16_t>, std::vector<TestVertex>> by_set;
    for (const SurfaceVertex& v : vertices) by_set[v.set].push_back(v.vertex);
    std::vector<TestRun> out;
    for (const auto& [set, of_set] : by_set) out.push_back({set, of_set});
    return out;
  }

  TestMesh mesh_;
  std::vector<std::uint32_t> slot_of_;
  std::vector<std::uint16_t> indices_;
};

// A wavy sheet of (side + 1)² vertices of noise over [-1, 1]², columns side / 2 twice, as at a seam of UVs. Joint sets
// of 1 … most ≤ joint_count joints change from place to place.
struct Sheet {
  std::vector<SurfaceVertex> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::array<std::uint32_t, 2>> seam;  // pairs of vertices in one place
};

inline SurfaceVertex sheet_vertex(Random& random, std::uint32_t x, std::uint32_t y, std::uint32_t side,
                                  std::size_t joint_count, std::size_t most, bool residuals) {
  SurfaceVertex v;
  v.vertex.position = {2.0 * x / side - 1, 2.0 * y / side - 1, random.between(-0.1, 0.1)};
  v.vertex.normal = normalised(Vec3{random.between(-0.2, 0.2), random.between(-0.2, 0.2), 1});
  v.vertex.tangent = normalised(Vec3{1, random.between(-0.5, 0.5), 0});
  v.vertex.sign = random.below(2) == 0 ? 1 : -1;
  const std::size_t influences = 1 + random.below(static_cast<std::uint32_t>(most));
  double left = 1;
  for (std::size_t k = 0; k < influences; ++k) {
    v.set.push_back(static_cast<std::uint16_t>((x * 3 / (side + 1) + k) % joint_count));
    const double w = k + 1 == influences ? left : left * random.between(0.25, 0.75);
    v.vertex.weights.push_back(w);
    left -= w;
  }
  // The first two undo each other, so that the bind pose stays.
  for (std::size_t k = 0; residuals && k < influences; ++k) {
    std::array<double, 4> d{};
    for (std::size_t c = 0; c < 3 && k == 0; ++c) d[c] = random.between(-0.02, 0.02);
    if (k == 0) d[3] = 0.03125;
    for (std::size_t c = 0; c < 4 && k == 1; ++c) d[c] = -v.vertex.residual[0][c];
    v.vertex.residual.push_back(influences < 2 ? std::array<double, 4>{} : d);
  }
  return v;
}

inline Sheet make_sheet(std::uint64_t seed, std::uint32_t side, std::size_t joint_count, std::size_t most,
                        bool residuals) {
  Random random(seed);
  Sheet s;
  const std::uint32_t columns = side + 1, middle = side / 2;
  for (std::uint32_t y = 0; y < columns; ++y)
    for (std::uint32_t x = 0; x < columns; ++x)
      s.vertices.push_back(sheet_vertex(random, x, y, side, joint_count, most, residuals));
  const std::uint32_t copies = columns * columns;
  for (std::uint32_t y = 0; y < columns; ++y) {
    s.seam.push_back({y * columns + middle, copies + y});
    s.vertices.push_back(s.vertices[y * columns + middle]);
  }
  for (std::uint32_t y = 0; y < side; ++y) {
    for (std::uint32_t x = 0; x < side; ++x) {
      const auto at = [&](std::uint32_t column, std::uint32_t row) {
        return x >= middle && column == middle ? copies + row : row * columns + column;
      };
      s.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
      s.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return s;
}

}  // namespace marrow::test
