// At start-up: small meshes and poses to try the paths with. Rational numbers instead of square roots throughout.
#include "gles3/self_test/self_test_mesh.h"

#include "gles3/palettes.h"
#include "math/affine.h"
#include "math/quaternion.h"

namespace marrow::gles3 {
namespace {

constexpr Run kFourInfluences[] = {{5, 1}, {7, 2}, {8, 3}, {11, 4}};
constexpr Run kEightInfluences[] = {{5, 1}, {7, 2}, {8, 3}, {11, 4}, {10, 8}};
constexpr std::uint32_t kFewJoints = 9;

class ProbeNumbers {
 public:
  explicit ProbeNumbers(std::uint32_t seed) : state_(seed * 2654435761u + 12345u) {}
  float between(float low, float high) {
    state_ = state_ * 1664525u + 1013904223u;
    return low + (high - low) * (static_cast<float>(state_ >> 8) / 16777216.0f);
  }

 private:
  std::uint32_t state_;
};

// Where a block's four vertices go.
struct ProbeBlock {
  float *skin, *residual, *normals, *tangents;
};

void make_weights(ProbeNumbers& numbers, std::uint32_t k, std::uint32_t lane, const ProbeBlock& to) {
  float weights[kMaxInfluences], sum = 0, others = 0;
  for (std::uint32_t j = 0; j < k; ++j) sum += weights[j] = numbers.between(0.1f, 1);
  for (std::uint32_t j = 0; j < k; ++j) {
    if (j + 1 < k) to.skin[12 + 4 * j + lane] = weights[j] / sum;
    float* const residual = to.residual + std::size_t{16} * j + lane;
    for (std::uint32_t c = 0; c < 3; ++c) residual[std::size_t{4} * c] = numbers.between(-0.02f, 0.02f);
    // Those of w sum to 0.
    const float w = j + 1 < k ? numbers.between(-0.02f, 0.02f) : -others;
    residual[12] = w;
    others += w;
  }
}

// The plane's points a, b on the unit sphere, and the unit tangent along a.
void make_directions(float a, float b, float sign, std::uint32_t lane, const ProbeBlock& to) {
  const float unit = 1 / (1 + a * a + b * b);
  const float normal[3] = {2 * a * unit, 2 * b * unit, (1 - a * a - b * b) * unit};
  const float tangent[4] = {(1 + b * b - a * a) * unit, -2 * a * b * unit, -2 * a * unit, sign};
  for (std::uint32_t c = 0; c < 3; ++c) to.normals[4 * c + lane] = normal[c];
  for (std::uint32_t c = 0; c < 4; ++c) to.tangents[4 * c + lane] = tangent[c];
}

void make_vertex(std::uint32_t seed, std::uint32_t k, std::uint32_t lane, const ProbeBlock& to) {
  ProbeNumbers numbers(seed);
  to.skin[lane] = numbers.between(-0.5f, 0.5f);
  to.skin[4 + lane] = numbers.between(0, 2);
  to.skin[8 + lane] = numbers.between(-0.5f, 0.5f);
  make_weights(numbers, k, lane, to);
  const float a = numbers.between(-2, 2), b = numbers.between(-2, 2);
  make_directions(a, b, numbers.between(-1, 1) < 0 ? -1.0f : 1.0f, lane, to);
}

void fill(const ProbeShape& shape, ProbeBlock to, std::uint16_t* sets) {
  for (std::uint32_t r = 0; r < shape.runs.size; ++r) {
    const Run& run = shape.runs[r];
    for (std::uint32_t slot = 0; slot < (run.vertex_count + 3) / 4 * 4; ++slot) {
      const std::uint32_t vertex = slot < run.vertex_count ? slot : run.vertex_count - 1;
      make_vertex(4096 * (r + 1) + vertex, run.influences, slot % 4, to);
      if (slot % 4 != 3) continue;
      to.skin += 4 * (std::size_t{run.influences} + 2);
      to.residual += std::size_t{16} * run.influences;
      to.normals += 12;
      to.tangents += 16;
    }
    // From the last entry on, far apart, none twice.
    for (std::uint32_t j = 0; j < run.influences; ++j)
      *sets++ = static_cast<std::uint16_t>(shape.joints - 1 - (7 * r + 37 * j) % shape.joints);
  }
}

// Turned by a rational unit quaternion, x, y, z and w over their length, then scaled along the joint's own axes.
void turn(std::uint32_t number, Affine& out) {
  constexpr float kTurns[][5] = {
      {2, 3, 6, 24, 25}, {-1, 4, 8, 40, 41}, {7, -4, 4, 40, 41}, {-6, 9, -2, 60, 61}, {6, -7, -6, 60, 61}};
  static constexpr float kScales[] = {0.8f, 1.25f, 1, 0.9f, 1.1f, 0.95f};
  const float(&q)[5] = kTurns[number % 5];
  const Linear<float> m = columns_of(Rotation{q[0] / q[4], q[1] / q[4], q[2] / q[4], q[3] / q[4]});
  const auto scale = [number](std::uint32_t axis) { return kScales[(number + axis) % 6]; };
  out = affine({m.x * scale(0), m.y * scale(1), m.z * scale(2)}, {});
}

// Where a joint is in the bind pose: spread along the axis.
float height_of(std::uint32_t joint) {
  return 0.2f * static_cast<float>(joint % 11);
}

}  // namespace

ProbeShape probe_shape(std::size_t which) {
  if (which == 0) return {{kFourInfluences, 4}, kFewJoints};
  return {{kEightInfluences, 5}, kPaletteJoints};
}

ProbeShape timed_shape(std::uint32_t vertices, Run (&runs)[4]) {
  for (std::uint32_t i = 0; i < 4; ++i) runs[i] = {vertices / 16 * 4, i + 1};
  return {{runs, 4}, kFewJoints};
}

Mesh make_probe_mesh(const ProbeShape& shape, Memory& memory) {
  std::uint32_t blocks = 0, influences = 0, skin_rows = 0, residual_rows = 0;
  for (const Run& run : shape.runs) {
    const std::uint32_t more = (run.vertex_count + 3) / 4;
    blocks += more;
    influences += run.influences;
    skin_rows += more * (run.influences + 2);
    residual_rows += more * run.influences * 4;
  }
  Mesh mesh;
  mesh.name = "self-test";
  Geometry& g = mesh.geometry;
  g.slot_count = g.vertex_count = g.index_count = 4 * blocks;
  mesh.joint_count = g.joint_count = shape.joints;
  g.runs = shape.runs;
  const float boxes[2][3] = {{-0.5f, 0, -0.5f}, {0.5f, 2, 0.5f}};
  for (int c = 0; c < 3; ++c) g.box_min[c] = boxes[0][c];
  for (int c = 0; c < 3; ++c) g.box_max[c] = boxes[1][c];
  const Span<float> skin = memory.take<float>(std::size_t{4} * skin_rows);
  const Span<float> residual = memory.take<float>(std::size_t{4} * residual_rows);
  const Span<float> normals = memory.take<float>(std::size_t{12} * blocks);
  const Span<float> tangents = memory.take<float>(std::size_t{16} * blocks);
  const Span<std::uint16_t> sets = memory.take<std::uint16_t>(influences);
  const Span<std::uint16_t> indices = memory.take<std::uint16_t>(g.index_count);
  const Span<std::uint16_t> joints = memory.take<std::uint16_t>(shape.joints);
  const Span<Affine> inverse_bind = memory.take<Affine>(shape.joints);
  // Sizes ask whether there are any.
  static constexpr float kSome = 0;
  g.normals = g.tangents = g.as_residual = &kSome;
  if (memory.first == nullptr) return mesh;
  fill(shape, {skin.data, residual.data, normals.data, tangents.data}, sets.data);
  for (std::uint32_t i = 0; i < g.index_count; ++i) indices[i] = static_cast<std::uint16_t>(i);
  for (std::uint32_t j = 0; j < shape.joints; ++j) {
    joints[j] = static_cast<std::uint16_t>(j);
    inverse_bind[j] = {{{1, 0, 0, 0}, {0, 1, 0, -height_of(j)}, {0, 0, 1, 0}}};
  }
  g.skin = skin.data;
  g.as_residual = residual.data;
  g.normals = normals.data;
  g.tangents = tangents.data;
  g.sets = sets.data;
  g.indices = indices.data;
  mesh.joints = joints.data;
  mesh.inverse_bind = inverse_bind.data;
  return mesh;
}

void pose_probe(std::uint32_t frame, std::uint32_t character, Span<Affine> model_from_joint) {
  const auto shift = static_cast<float>(character + 3 * frame);
  for (std::uint32_t j = 0; j < model_from_joint.size; ++j) {
    Affine& out = model_from_joint[j];
    turn(j + 2 * character + 3 * frame, out);
    const float sway = 0.05f * static_cast<float>(j % 7);
    const float place[3] = {100 + 2 * shift + sway, height_of(j) - 60, 80 - shift - sway};
    for (std::uint32_t c = 0; c < 3; ++c) out.rows[c][3] = place[c];
  }
}

}  // namespace marrow::gles3
