// Marching tetrahedra over the left half of space, and the mirroring that completes it.
#include "isosurface.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace marrow::sample {
namespace {

// Six tetrahedra around a cube's diagonal; corner bits are x, y, z. Neighbouring cubes agree on their shared faces,
// which is why the result cannot have holes or edges with three triangles.
constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}};

class Marcher {
 public:
  Marcher(const Shape& shape, glm::vec3 low, glm::vec3 high, float cell) : low_(low), cell_(cell) {
    size_ = glm::ivec3(glm::ceil((high - low) / cell)) + 1;
    values_.reserve(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y * size_.z));
    for (int z = 0; z < size_.z; ++z) {
      for (int y = 0; y < size_.y; ++y) {
        for (int x = 0; x < size_.x; ++x) values_.push_back(shape.field(place({x, y, z})));
      }
    }
  }

  Surface run() {
    for (int z = 0; z + 1 < size_.z; ++z) {
      for (int y = 0; y + 1 < size_.y; ++y) {
        for (int x = 0; x + 1 < size_.x; ++x) cube({x, y, z});
      }
    }
    return std::move(result_);
  }

 private:
  glm::vec3 place(glm::ivec3 at) const { return low_ + glm::vec3(at) * cell_; }
  std::uint32_t index(glm::ivec3 at) const {
    return static_cast<std::uint32_t>((at.z * size_.y + at.y) * size_.x + at.x);
  }

  void cube(glm::ivec3 at) {
    std::array<glm::ivec3, 8> corners;
    int inside = 0;
    for (int i = 0; i < 8; ++i) {
      corners[static_cast<std::size_t>(i)] = at + glm::ivec3(i & 1, (i >> 1) & 1, i >> 2);
      inside += values_[index(corners[static_cast<std::size_t>(i)])] < 0;
    }
    if (inside == 0 || inside == 8) return;
    for (const auto& tetrahedron : kTetrahedra) {
      std::array<glm::ivec3, 4> tet;
      for (std::size_t i = 0; i < 4; ++i) tet[i] = corners[static_cast<std::size_t>(tetrahedron[i])];
      cut(tet);
    }
  }

  void cut(const std::array<glm::ivec3, 4>& tet) {
    std::vector<glm::ivec3> in, out;
    for (const glm::ivec3& corner : tet) (values_[index(corner)] < 0 ? in : out).push_back(corner);
    if (in.empty() || out.empty()) return;
    const glm::vec3 outward = place(out[0]) - place(in[0]);
    if (in.size() == 2) {
      const std::uint32_t a = crossing(in[0], out[0]), b = crossing(in[0], out[1]);
      const std::uint32_t c = crossing(in[1], out[1]), d = crossing(in[1], out[0]);
      emit(a, b, c, outward);
      emit(a, c, d, outward);
    } else {
      // Vertices are numbered as they are made: one after another, whatever order a compiler has for arguments.
      const bool one_in = in.size() == 1;
      const std::uint32_t c = one_in ? crossing(in[0], out[2]) : crossing(in[2], out[0]);
      const std::uint32_t b = one_in ? crossing(in[0], out[1]) : crossing(in[1], out[0]);
      const std::uint32_t a = crossing(in[0], out[0]);
      emit(a, b, c, outward);
    }
  }

  void emit(std::uint32_t a, std::uint32_t b, std::uint32_t c, glm::vec3 outward) {
    const auto& p = result_.positions;
    if (glm::dot(glm::cross(p[b] - p[a], p[c] - p[a]), outward) < 0) std::swap(b, c);
    result_.triangles.push_back({a, b, c});
  }

  std::uint32_t crossing(glm::ivec3 in, glm::ivec3 out) {
    const std::uint64_t i = index(in), o = index(out);
    const auto found = made_.find(std::min(i, o) << 32 | std::max(i, o));
    if (found != made_.end()) return found->second;
    const float vi = values_[i], vo = values_[o];
    // Kept off the corners, so that no triangle has zero area.
    const float t = std::clamp(vi / (vi - vo), .05f, .95f);
    const auto vertex = static_cast<std::uint32_t>(result_.positions.size());
    result_.positions.push_back(glm::mix(place(in), place(out), t));
    made_.emplace(std::min(i, o) << 32 | std::max(i, o), vertex);
    return vertex;
  }

  glm::vec3 low_;
  float cell_;
  glm::ivec3 size_{0};
  std::vector<float> values_;
  std::unordered_map<std::uint64_t, std::uint32_t> made_;
  Surface result_;
};

}  // namespace

Surface polygonise_left_half(const Shape& shape, glm::vec3 low, glm::vec3 high, float cell) {
  low.x = 0;  // grid points lie on the plane of symmetry, so vertices do as well
  return Marcher(shape, low, high, cell).run();
}

Surface mirror_half(const Surface& half) {
  Surface whole = half;
  std::vector<std::uint32_t> twin(half.positions.size());
  for (std::uint32_t v = 0; v < twin.size(); ++v) {
    const glm::vec3 p = half.positions[v];
    twin[v] = p.x == 0 ? v : static_cast<std::uint32_t>(whole.positions.size());
    if (p.x != 0) whole.positions.push_back({-p.x, p.y, p.z});
  }
  for (const Triangle& t : half.triangles) whole.triangles.push_back({twin[t[0]], twin[t[2]], twin[t[1]]});
  return whole;
}

bool is_watertight(const Surface& surface) {
  std::unordered_map<std::uint64_t, int> directed;
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++directed[std::uint64_t{t[i]} << 32 | t[(i + 1) % 3]];
  }
  return std::all_of(directed.begin(), directed.end(), [&](const auto& edge) {
    const auto back = directed.find(edge.first << 32 | edge.first >> 32);
    return edge.second == 1 && back != directed.end();
  });
}

std::vector<std::vector<std::uint32_t>> vertex_neighbours(const Surface& surface) {
  std::vector<std::vector<std::uint32_t>> result(surface.positions.size());
  for (const Triangle& t : surface.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      result[t[i]].push_back(t[(i + 1) % 3]);
      result[t[i]].push_back(t[(i + 2) % 3]);
    }
  }
  for (auto& list : result) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return result;
}

}  // namespace marrow::sample
