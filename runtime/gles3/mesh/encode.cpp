// Bind vertices as floats → the compact attributes of GpuMesh.
#include "gles3/mesh/encode.h"

#include <cmath>
#include <cstring>

#include "math/finite.h"

namespace marrow::gles3 {
namespace {

// One slot with everything that skinning needs, in float.
struct Vertex {
  float position[3];
  std::uint32_t influences;
  std::uint16_t joints[kMaxInfluences];
  float weights[kMaxInfluences];
  float residual[kMaxInfluences][4];
  float tangents[kMaxInfluences][2][4];  // animation-space vectors, of those that have them
};

void swap_influences(Vertex& v, std::uint32_t a, std::uint32_t b) {
  const Vertex old = v;
  v.joints[a] = old.joints[b];
  v.joints[b] = old.joints[a];
  v.weights[a] = old.weights[b];
  v.weights[b] = old.weights[a];
  std::memcpy(v.residual[a], old.residual[b], sizeof(v.residual[a]));
  std::memcpy(v.residual[b], old.residual[a], sizeof(v.residual[b]));
  std::memcpy(v.tangents[a], old.tangents[b], sizeof(v.tangents[a]));
  std::memcpy(v.tangents[b], old.tangents[a], sizeof(v.tangents[b]));
}

// Merges influence j, whose joint is the first one's, into the first: shaders may skip repeats of the first joint.
void add_to_first(Vertex& v, std::uint32_t j) {
  v.weights[0] += v.weights[j];
  v.weights[j] = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    v.residual[0][c] += v.residual[j][c];
    v.residual[j][c] = 0;
    for (std::size_t a = 0; a < 2; ++a) {
      v.tangents[0][a][c] += v.tangents[j][a][c];
      v.tangents[j][a][c] = 0;
    }
  }
}

// Lane `lane` of a block of as_tangents(). The last influence is the sum less the others.
void read_tangents(const float* block, std::uint32_t k, std::uint32_t lane, Vertex& v) {
  for (std::size_t a = 0; a < 2; ++a) {
    float(&last)[4] = v.tangents[k - 1][a];
    for (std::size_t c = 0; c < 3; ++c) last[c] = block[12 * a + 4 * c + lane];
    for (std::size_t j = 0; j + 1 < k; ++j) {
      for (std::size_t c = 0; c < 4; ++c) {
        v.tangents[j][a][c] = block[24 + 32 * j + 16 * a + 4 * c + lane];
        last[c] -= v.tangents[j][a][c];
      }
    }
  }
}

// Lane `lane` of a block of four vertices; `residual` and `tangents` may be null. The largest weight is moved to the
// front.
Vertex read_vertex(const float* skin, const float* residual, const float* tangents, const std::uint16_t* set,
                   std::uint32_t k, std::uint32_t lane) {
  Vertex v = {};
  if (tangents != nullptr) read_tangents(tangents, k, lane, v);
  v.influences = k;
  for (std::uint32_t c = 0; c < 3; ++c) v.position[c] = skin[4 * c + lane];
  float last = 1;
  std::uint32_t largest = 0;
  for (std::uint32_t j = 0; j < k; ++j) {
    v.joints[j] = set[j];
    v.weights[j] = j + 1 < k ? skin[12 + 4 * j + lane] : last;
    last -= v.weights[j];
    if (v.weights[j] > v.weights[largest]) largest = j;
    if (residual == nullptr) continue;
    for (std::uint32_t c = 0; c < 4; ++c) v.residual[j][c] = residual[16 * j + 4 * c + lane];
  }
  if (largest != 0) swap_influences(v, 0, largest);
  for (std::uint32_t j = 1; j < k; ++j) {
    if (v.joints[j] == v.joints[0]) add_to_first(v, j);
  }
  return v;
}

// Calls visit(slot, vertex) for every slot in order.
template <class Visit>
void for_each_vertex(const Geometry& geometry, const float* tangents, const Visit& visit) {
  const float* skin = geometry.skin;
  const float* residual = geometry.as_residual;
  const std::uint16_t* set = geometry.sets;
  std::uint32_t slot = 0;
  for (const Run& run : geometry.runs) {
    for (std::uint32_t block = 0; block < (run.vertex_count + 3) / 4; ++block) {
      for (std::uint32_t lane = 0; lane < 4; ++lane) {
        visit(slot++, read_vertex(skin, residual, tangents, set, run.influences, lane));
      }
      skin += 4 * (3 + run.influences - 1);
      if (residual != nullptr) residual += std::size_t{16} * run.influences;
      if (tangents != nullptr) tangents += std::size_t{32} * run.influences - 8;
    }
    set += run.influences;
  }
}

template <class T>
void put(std::byte* to, T value) {
  std::memcpy(to, &value, sizeof(value));
}

// Clamps a number to ±1e6, and NaN to 0: a file's numbers are finite, but their sums and products may not be.
double held(double value) {
  constexpr double kMost = 1e6;
  return value > kMost ? kMost : value < -kMost ? -kMost : is_number(value) ? value : 0;
}
std::int32_t round_to_int(float value) {
  return static_cast<std::int32_t>(std::floor(static_cast<float>(held(static_cast<double>(value))) + 0.5f));
}

std::int16_t to_snorm16(float value) {
  const std::int32_t i = round_to_int(value * 32767.0f);
  return static_cast<std::int16_t>(i < -32767 ? -32767 : i > 32767 ? 32767 : i);
}

void put_joints(const Vertex& v, const VertexLayout& layout, std::byte* to) {
  for (std::uint32_t j = 0; j < joint_places(layout); ++j) {
    const std::uint16_t joint = v.joints[j < v.influences ? j : 0];
    if (layout.joint_bytes == 1) {
      put(to + j, static_cast<std::uint8_t>(joint));
    } else {
      put(to + 2 * std::size_t{j}, joint);
    }
  }
}

// p̂ of a vertex, component c.
float unit_position(const Vertex& v, const Quantisation& q, std::uint32_t c) {
  return (v.position[c] - q.centre[c]) / q.half_extent;
}

// Rounds a vector to steps. carry: what the vector before lost in rounding; it is added first. whole: w is stored
// before z, and y and z are read as whole words, whose lower halves (x and w) are a fraction: that is subtracted first.
void put_vector(const float exact[4], bool whole, float carry[4], std::byte* to) {
  constexpr std::uint8_t kOrders[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};
  float behind = 0;
  for (std::size_t place = 0; place < 4; ++place) {
    const std::size_t c = kOrders[whole ? 1 : 0][place];
    const float x = exact[c] + carry[c] - (place % 2 == 1 ? behind : 0);
    std::int32_t i = round_to_int(x);
    i = i < -32767 ? -32767 : i > 32767 ? 32767 : i;
    carry[c] = x - static_cast<float>(i);
    const auto stored = static_cast<std::uint16_t>(i);
    put(to + 2 * place, stored);
    behind = whole ? static_cast<float>(stored) / 65536 : 0;
  }
}

void put_coordinates(const Vertex& v, const VertexLayout& layout, const Quantisation& quantisation, bool whole,
                     std::byte* to) {
  float total_weight[kMaxInfluences];
  std::int32_t w[kMaxInfluences] = {};
  for (std::uint32_t j = 0; j < v.influences; ++j) total_weight[j] = v.weights[j] + v.residual[j][3];
  quantise_sum(total_weight, v.influences, quantisation.coordinate_one, w);
  const float one = static_cast<float>(quantisation.coordinate_one);
  // What rounding one influence loses goes to the next, so that the bind pose, where they all move alike, is off by
  // half a step at most.
  float carry[4] = {};
  std::memset(to, 0, std::size_t{8} * layout.influences);
  for (std::uint32_t j = 0; j < v.influences; ++j) {
    // The position is weighted by the stored weight. Rounding then acts like a slightly different weight at the vertex,
    // where neighbouring joints agree, and not at the box's centre, where they do not.
    const float lift = static_cast<float>(w[j]) / one - v.residual[j][3];
    float exact[4] = {0, 0, 0, static_cast<float>(w[j])};
    for (std::uint32_t c = 0; c < 3; ++c) {
      const float d = (v.residual[j][c] - quantisation.centre[c] * v.residual[j][3]) / quantisation.half_extent;
      exact[c] = (lift * unit_position(v, quantisation, c) + d) * one;
    }
    put_vector(exact, whole, carry, to + std::size_t{8} * j);
  }
}

// Writes both tangents' vectors of all influences. Each tangent is scaled so that its largest number is 32766, since
// only directions count. What rounding one influence loses goes to the next, so that w still sums to 0. The last w
// therefore need not be stored: the first tangent's place for it says whether the texture's triad is left-handed.
void put_tangents(const Vertex& v, const VertexLayout& layout, const Quantisation& q, bool left_handed, std::byte* to) {
  const std::size_t places = layout.influences;
  for (std::size_t a = 0; a < 2; ++a) {
    float exact[kMaxInfluences][4] = {};
    float largest = 0;
    for (std::size_t j = 0; j < v.influences; ++j) {
      const float(&tau)[4] = v.tangents[j][a];
      for (std::size_t c = 0; c < 3; ++c) exact[j][c] = (tau[c] - q.centre[c] * tau[3]) / q.half_extent;
      exact[j][3] = tau[3];
      for (const float x : exact[j]) largest = std::fmax(largest, std::fabs(x));
    }
    const float scale = largest > 0 ? 32766.0f / largest : 0;
    for (auto& vector : exact)
      for (float& x : vector) x *= scale;
    float carry[4] = {};
    for (std::size_t j = 0; j < places; ++j) {
      if (j + 1 == places) {
        exact[j][3] = a == 1 ? 0.0f : left_handed ? -32767.0f : 32767.0f;
        carry[3] = 0;
      }
      put_vector(exact[j], layout.influences > 4, carry, to + 8 * (places * a + j));
    }
  }
}

}  // namespace

void quantise_sum(const float* values, std::uint32_t count, std::int32_t total, std::int32_t* out) {
  double remainder[kMaxInfluences];
  std::int32_t missing = total;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double exact = held(static_cast<double>(values[i]) * total);
    const double whole = std::floor(exact);
    out[i] = static_cast<std::int32_t>(whole);
    remainder[i] = exact - whole;
    missing -= out[i];
  }
  // Fewer than `count` steps, unless the values do not sum to 1; then the first, the largest, takes the rest.
  for (std::uint32_t step = 0; step < count && missing != 0; ++step) {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < count; ++i) {
      if (missing > 0 ? remainder[i] > remainder[best] : remainder[i] < remainder[best]) best = i;
    }
    const std::int32_t direction = missing > 0 ? 1 : -1;
    out[best] += direction;
    remainder[best] -= direction;
    missing -= direction;
  }
  out[0] += missing;
}

void to_octahedron(const float unit[3], float out[2]) {
  const float sum = std::fabs(unit[0]) + std::fabs(unit[1]) + std::fabs(unit[2]);
  const float x = sum > 0 ? unit[0] / sum : 0;
  const float y = sum > 0 ? unit[1] / sum : 0;
  out[0] = unit[2] >= 0 ? x : (1 - std::fabs(y)) * (x >= 0 ? 1.0f : -1.0f);
  out[1] = unit[2] >= 0 ? y : (1 - std::fabs(x)) * (y >= 0 ? 1.0f : -1.0f);
}

VertexLayout make_layout(const Mesh& mesh, bool as_tangents, bool psd) {
  const Geometry& g = mesh.geometry;
  VertexLayout layout;
  for (const Run& run : g.runs) {
    if (run.influences > layout.influences) layout.influences = run.influences;
  }
  layout.joint_bytes = mesh.palette_size() > 256 ? 2 : 1;
  layout.ssd_weights = 8;
  layout.ssd_joints = layout.ssd_weights + 2 * (weight_places(layout) - 2);
  layout.ssd_stride = layout.ssd_joints + layout.joint_bytes * joint_places(layout);
  if (psd && !g.pose_space.examples.empty()) {
    layout.example_row = layout.ssd_stride;
    layout.ssd_stride += 4;
  }
  // Twelve vectors, joints, UVs and colours are all sixteen attributes; some drivers count gl_InstanceID as one more.
  const bool has_room = layout.influences < 8 || g.uvs == nullptr || g.colours == nullptr;
  layout.surface_normals = as_tangents && has_room && g.normals != nullptr && g.targets.empty();
  layout.as_tangents = 8 * layout.influences;
  layout.as_joints = layout.as_tangents + (layout.surface_normals ? 16 * layout.influences : 0);
  layout.as_stride = layout.as_joints + layout.joint_bytes * joint_places(layout);
  std::uint32_t& stride = layout.surface_stride;
  layout.normal = stride;
  if (g.normals != nullptr) stride += 4;
  layout.tangent = stride;
  if (g.tangents != nullptr) stride += 4;
  layout.uv = stride;
  if (g.uvs != nullptr) {
    layout.uv_unorm = true;
    for (std::size_t i = 0; i < std::size_t{2} * g.slot_count; ++i) {
      if (!(g.uvs[i] >= 0 && g.uvs[i] <= 1)) layout.uv_unorm = false;
    }
    stride += layout.uv_unorm ? 4 : 8;
  }
  layout.colour = stride;
  if (g.colours != nullptr) stride += 4;
  return layout;
}

Quantisation make_quantisation(const Geometry& g) {
  Quantisation q;
  q.half_extent = 0;
  for (int c = 0; c < 3; ++c) {
    q.centre[c] = 0.5f * (g.box_min[c] + g.box_max[c]);
    q.half_extent = std::fmax(q.half_extent, std::fmax(g.box_max[c] - q.centre[c], q.centre[c] - g.box_min[c]));
  }
  float largest_weight = 1;
  if (g.as_residual != nullptr) {
    float room = q.half_extent;
    for_each_vertex(g, nullptr, [&](std::uint32_t, const Vertex& v) {
      for (std::uint32_t j = 0; j < v.influences; ++j) {
        const float delta = v.residual[j][3];
        largest_weight = std::fmax(largest_weight, std::fabs(v.weights[j] + delta));
        for (int c = 0; c < 3; ++c) {
          const float x = v.weights[j] * (v.position[c] - q.centre[c]) + v.residual[j][c] - q.centre[c] * delta;
          room = std::fmax(room, std::fabs(x));
        }
      }
    });
    // A hair more, since weights move by up to a step when they are quantised.
    if (room > q.half_extent) q.half_extent = room * 1.0002f;
  }
  if (!(q.half_extent > 0)) q.half_extent = 1;
  for (; largest_weight > 1 && q.coordinate_one > 255; largest_weight *= 0.5f) q.coordinate_one /= 2;
  return q;
}

void encode_ssd(const Geometry& geometry, const VertexLayout& layout, const Quantisation& quantisation,
                std::byte* out) {
  for_each_vertex(geometry, nullptr, [&](std::uint32_t slot, const Vertex& v) {
    std::byte* vertex = out + std::size_t{slot} * layout.ssd_stride;
    std::int16_t position[4] = {};
    for (std::uint32_t c = 0; c < 3; ++c) position[c] = to_snorm16(unit_position(v, quantisation, c));
    if (v.influences > 1) position[3] = to_snorm16(v.weights[1]);
    std::memcpy(vertex, position, sizeof(position));
    for (std::uint32_t j = 2; j < weight_places(layout); ++j) {
      const float weight = j < v.influences ? v.weights[j] : 0.0f;
      put(vertex + layout.ssd_weights + 2 * std::size_t{j - 2},
          static_cast<std::uint16_t>(round_to_int(weight * 65535.0f)));
    }
    put_joints(v, layout, vertex + layout.ssd_joints);
  });
}

void encode_as(const Geometry& geometry, const VertexLayout& layout, const Quantisation& quantisation,
               const float* tangents, bool whole_coordinates, std::byte* out) {
  if (!layout.surface_normals) tangents = nullptr;
  for_each_vertex(geometry, tangents, [&](std::uint32_t slot, const Vertex& v) {
    std::byte* vertex = out + std::size_t{slot} * layout.as_stride;
    put_coordinates(v, layout, quantisation, whole_coordinates, vertex);
    if (tangents != nullptr) {
      const bool left_handed = geometry.tangents != nullptr && geometry.tangents[slot / 4 * 16 + 12 + slot % 4] < 0;
      put_tangents(v, layout, quantisation, left_handed, vertex + layout.as_tangents);
    }
    put_joints(v, layout, vertex + layout.as_joints);
  });
}

void encode_surface(const Geometry& g, const VertexLayout& layout, std::byte* out) {
  for (std::size_t slot = 0; slot < g.slot_count; ++slot) {
    std::byte* vertex = out + slot * layout.surface_stride;
    const std::size_t lane = slot % 4;
    float octahedron[2];
    if (g.normals != nullptr) {
      const float* block = g.normals + slot / 4 * 12;
      const float normal[3] = {block[lane], block[4 + lane], block[8 + lane]};
      to_octahedron(normal, octahedron);
      put(vertex + layout.normal, to_snorm16(octahedron[0]));
      put(vertex + layout.normal + 2, to_snorm16(octahedron[1]));
    }
    if (g.tangents != nullptr) {
      const float* block = g.tangents + slot / 4 * 16;
      const float tangent[3] = {block[lane], block[4 + lane], block[8 + lane]};
      to_octahedron(tangent, octahedron);
      // Never 0, which could not carry a sign.
      const std::int32_t y = round_to_int((octahedron[1] * 0.5f + 0.5f) * 32766.0f) + 1;
      put(vertex + layout.tangent, to_snorm16(octahedron[0]));
      put(vertex + layout.tangent + 2, static_cast<std::int16_t>(block[12 + lane] < 0 ? -y : y));
    }
    if (g.uvs != nullptr && layout.uv_unorm) {
      put(vertex + layout.uv, static_cast<std::uint16_t>(round_to_int(g.uvs[2 * slot] * 65535.0f)));
      put(vertex + layout.uv + 2, static_cast<std::uint16_t>(round_to_int(g.uvs[2 * slot + 1] * 65535.0f)));
    } else if (g.uvs != nullptr) {
      std::memcpy(vertex + layout.uv, g.uvs + 2 * slot, 8);
    }
    if (g.colours != nullptr) std::memcpy(vertex + layout.colour, g.colours + 4 * slot, 4);
  }
}

}  // namespace marrow::gles3
