#include "bench/vertices.h"

#include <algorithm>
#include <cmath>

#include "bench/workload.h"

namespace marrow::tools {
namespace {

// One vertex as it lies in the four streams, each number in its lane.
struct Vertex {
  std::vector<float> skin, residual;
  float normal[3], tangent[4];
};

void unit_vector(Noise& noise, float* out) {
  float squares = 0;
  for (int i = 0; i < 3; ++i) {
    out[i] = noise.between(-1, 1) + (i == 2 ? 1.5f : 0);  // far from zero
    squares += out[i] * out[i];
  }
  for (int i = 0; i < 3; ++i) out[i] /= std::sqrt(squares);
}

Vertex make_vertex(Noise& noise, std::uint32_t influences) {
  Vertex v;
  for (int i = 0; i < 3; ++i) v.skin.push_back(noise.between(-1, 1));
  std::vector<float> weights;
  float sum = 0;
  for (std::uint32_t k = 0; k < influences; ++k) sum += weights.emplace_back(noise.between(0.1f, 1));
  for (std::uint32_t k = 0; k + 1 < influences; ++k) v.skin.push_back(weights[k] / sum);
  // The displacements' w cancel pair by pair; an odd one out has none.
  float w = 0;
  for (std::uint32_t k = 0; k < influences; ++k) {
    for (int i = 0; i < 3; ++i) v.residual.push_back(noise.between(-0.01f, 0.01f));
    w = k % 2 == 1 ? -w : k + 1 < influences ? noise.between(0, 0.01f) : 0;
    v.residual.push_back(w);
  }
  unit_vector(noise, v.normal);
  unit_vector(noise, v.tangent);
  v.tangent[3] = noise.next() < 0.5f ? -1.0f : 1.0f;
  return v;
}

// count numbers of four vertices, number by number.
template <class Numbers>
void add_block(std::vector<float>& out, const std::vector<Vertex>& vertices, std::size_t count, Numbers numbers) {
  for (std::size_t i = 0; i < count; ++i)
    for (const Vertex& v : vertices) out.push_back(numbers(v)[i]);
}

}  // namespace

GeneratedMesh::GeneratedMesh(std::uint32_t vertex_count, std::uint32_t influences, std::uint32_t joints) {
  Noise noise;
  std::vector<Vertex> block(4);
  std::uint32_t first = 0, slots = 0;
  for (std::uint32_t b = 0; b < joints; ++b) {
    // The vertices for which joints · v / vertex_count is b.
    const std::uint32_t end = ((b + 1) * vertex_count + joints - 1) / joints;
    runs_.push_back({end - first, influences});
    for (std::uint32_t k = 0; k < influences; ++k) sets_.push_back(static_cast<std::uint16_t>((b + k) % joints));
    for (; first < end; first += 4, slots += 4) {
      for (std::uint32_t lane = 0; lane < 4; ++lane)
        block[lane] = first + lane < end ? make_vertex(noise, influences) : block[lane - 1];
      add_block(skin_, block, 3 + influences - 1, [](const Vertex& v) { return v.skin.data(); });
      add_block(normals_, block, 3, [](const Vertex& v) { return v.normal; });
      add_block(tangents_, block, 4, [](const Vertex& v) { return v.tangent; });
      add_block(residual_, block, 4 * std::size_t{influences}, [](const Vertex& v) { return v.residual.data(); });
    }
    first = end;
  }
  mesh_.name = "generated";
  for (std::uint32_t j = 0; j < joints; ++j) {
    joints_.push_back(static_cast<std::uint16_t>(j));
    inverse_bind_.push_back({{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  }
  const auto width = static_cast<std::uint32_t>(std::sqrt(static_cast<float>(slots)));
  for (std::uint32_t i = 0; i + width + 1 < slots && slots <= 65536; ++i)
    for (const std::uint32_t corner : {i, i + 1, i + width, i + 1, i + width + 1, i + width})
      indices_.push_back(static_cast<std::uint16_t>(corner));
  mesh_.joint_count = joints;
  mesh_.joints = joints_.data();
  mesh_.inverse_bind = inverse_bind_.data();
  Geometry& g = mesh_.geometry;
  g.slot_count = slots;
  g.vertex_count = vertex_count;
  g.joint_count = joints;
  g.index_count = static_cast<std::uint32_t>(indices_.size());
  g.indices = indices_.data();
  for (std::size_t c = 0; c < 3; ++c) {
    g.box_min[c] = -1;
    g.box_max[c] = 1;
  }
  g.runs = runs_;
  g.sets = sets_.data();
  g.skin = skin_.data();
  g.normals = normals_.data();
  g.tangents = tangents_.data();
  g.as_residual = residual_.data();
}

std::vector<Affine> noise_palette(std::size_t count) {
  Noise noise;
  std::vector<Affine> palette(count);
  for (Affine& m : palette) {
    // A unit quaternion with w well above 0, to a matrix.
    float q[4] = {noise.between(-1, 1), noise.between(-1, 1), noise.between(-1, 1), 1};
    const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + 1);
    for (float& c : q) c /= length;
    const float x = q[0], y = q[1], z = q[2], w = q[3];
    const float rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                              {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                              {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    for (int r = 0; r < 3; ++r) {
      std::copy_n(rows[r], 3, m.rows[r]);
      m.rows[r][3] = noise.between(-1, 1);
    }
  }
  return palette;
}

}  // namespace marrow::tools
