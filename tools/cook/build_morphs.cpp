// Morph targets become sparse: for each the blocks that it moves, with changes as 16-bit integers times a step.
#include <algorithm>
#include <cmath>

#include "cook/build.h"
#include "cook/normals.h"

namespace marrow::cook {
namespace {

constexpr float kMostSteps = 32767;
// A change of a unit vector below half of this, a thousandth of a degree, is an exporter's noise.
constexpr float kLeastDirectionStep = 0x1p-15f;

// The changes of one attribute as integers, three a vertex; empty if all are zero.
struct Quantised {
  float step = 0;
  std::vector<std::int16_t> steps;
};

Quantised quantise(const std::vector<glm::vec3>& changes, float least_step) {
  float most = 0;
  for (const glm::vec3& d : changes)
    for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(d[c]));
  Quantised out;
  out.step = std::max(most / kMostSteps, least_step);
  if (out.step == 0 || most * 2 < out.step) return {};
  out.steps.reserve(changes.size() * 3);
  for (const glm::vec3& d : changes)
    for (int c = 0; c < 3; ++c)
      out.steps.push_back(static_cast<std::int16_t>(
          std::clamp(std::round(static_cast<double>(d[c]) / static_cast<double>(out.step)), -32767.0, 32767.0)));
  return out;
}

bool moves(const Quantised& q, const std::uint32_t* vertices) {
  return !q.steps.empty() && std::any_of(vertices, vertices + 4, [&](std::uint32_t v) {
    return q.steps[std::size_t{3} * v] != 0 || q.steps[std::size_t{3} * v + 1] != 0 ||
           q.steps[std::size_t{3} * v + 2] != 0;
  });
}

void add_record(const Quantised& q, const std::uint32_t* vertices, std::vector<std::int16_t>& out) {
  for (std::size_t c = 0; c < 3; ++c)
    for (int lane = 0; lane < 4; ++lane) out.push_back(q.steps[std::size_t{3} * vertices[lane] + c]);
}

void add_target(const RawTarget& raw, const std::vector<std::uint32_t>& vertex_of_slot, BuiltGeometry& out) {
  const Quantised parts[3] = {quantise(raw.positions, 0), quantise(raw.normals, kLeastDirectionStep),
                              quantise(raw.tangents, kLeastDirectionStep)};
  MorphTarget target{};
  target.first_block = static_cast<std::uint32_t>(out.target_blocks.size());
  target.first_record = static_cast<std::uint32_t>(out.target_records.size() / 12);
  for (std::uint32_t block = 0; block < vertex_of_slot.size() / 4; ++block) {
    const std::uint32_t* const vertices = &vertex_of_slot[std::size_t{4} * block];
    if (std::none_of(parts, parts + 3, [&](const Quantised& q) { return moves(q, vertices); })) continue;
    out.target_blocks.push_back(block);
    for (const Quantised& q : parts)
      if (!q.steps.empty()) add_record(q, vertices, out.target_records);
  }
  target.block_count = static_cast<std::uint32_t>(out.target_blocks.size()) - target.first_block;
  constexpr std::uint32_t kAttributes[3] = {kMorphsPositions, kMorphsNormals, kMorphsTangents};
  for (int i = 0; i < 3; ++i)
    if (!parts[i].steps.empty()) target.attributes |= kAttributes[i];
  target.position_step = parts[0].step;
  target.normal_step = parts[1].step;
  target.tangent_step = parts[2].step;
  out.targets.push_back(target);
}

}  // namespace

void generate_target_normals(RawPrimitive& primitive) {
  for (RawTarget& target : primitive.targets) {
    target.normals.clear();
    if (target.positions.empty()) continue;
    RawPrimitive moved;
    moved.indices = primitive.indices;
    for (std::size_t v = 0; v < primitive.positions.size(); ++v)
      moved.positions.push_back(primitive.positions[v] + target.positions[v]);
    generate_normals(moved);
    for (std::size_t v = 0; v < primitive.positions.size(); ++v)
      target.normals.push_back(moved.normals[v] - primitive.normals[v]);
  }
}

void build_morphs(const RawPrimitive& primitive, const std::vector<std::uint32_t>& vertex_of_slot, BuiltGeometry& out) {
  for (const RawTarget& target : primitive.targets) add_target(target, vertex_of_slot, out);
  if (out.target_blocks.empty()) out.targets.clear();  // all of a mesh's primitives list its targets, moved or not
  if (out.targets.empty()) return;
  out.header.flags |= format::kHasMorphTargets;
  out.morphs.target_count = static_cast<std::uint32_t>(out.targets.size());
  out.morphs.block_count = static_cast<std::uint32_t>(out.target_blocks.size());
  out.morphs.record_count = static_cast<std::uint32_t>(out.target_records.size() / 12);
}

}  // namespace marrow::cook
