#include "export/export_vertices.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "common/vertex_order.h"

namespace marrow::tools {
namespace {

struct Influence {
  std::uint16_t joint = 0;  // of the skin
  float weight = 0;
};

void add(std::uint16_t joint, float weight, std::vector<Influence>& out) {
  if (!(weight > 0)) return;
  const auto same = std::ranges::find(out, joint, &Influence::joint);
  if (same == out.end()) {
    out.push_back({joint, weight});
  } else {
    same->weight += weight;
  }
}

// Of arrays of blocks of `components` components, a part each, the vertices in `order`.
std::vector<float> unpack(std::span<const Geometry> parts, const float* Geometry::*blocks, std::size_t components,
                          const std::vector<PartSlot>& order) {
  std::vector<float> out;
  out.reserve(order.size() * components);
  for (const auto& [part, slot] : order)
    for (std::size_t c = 0; c < components; ++c)
      out.push_back((parts[part].*blocks)[(slot / 4 * components + c) * 4 + slot % 4]);
  return out;
}

// glTF wants unit vectors, whatever rounding has left; a direction that has none is up.
void normalise(std::vector<float>& directions, std::size_t parts) {
  for (std::size_t i = 0; i < directions.size(); i += parts) {
    float* const v = &directions[i];
    double squared = 0;
    for (int c = 0; c < 3; ++c) squared += static_cast<double>(v[c]) * static_cast<double>(v[c]);
    if (std::fabs(squared - 1) > 1e-5)
      for (int c = 0; c < 3; ++c)
        v[c] =
            squared > 0 ? static_cast<float>(static_cast<double>(v[c]) / std::sqrt(squared)) : (c == 1 ? 1.0f : 0.0f);
    if (parts == 4) v[3] = v[3] < 0 ? -1.0f : 1.0f;
  }
}

// Where each block's positions stand in `skin`, and its run; both follow from the runs.
struct Block {
  const float* skin;
  const std::uint16_t* set;
  std::uint32_t influences;
};

std::vector<Block> blocks_of(const Geometry& g) {
  std::vector<Block> out;
  const float* skin = g.skin;
  const std::uint16_t* set = g.sets;
  for (const Run& run : g.runs) {
    for (std::uint32_t i = 0; i < run.vertex_count; i += 4) {
      out.push_back({skin, set, run.influences});
      skin += 12 + std::size_t{run.influences - 1} * 4;
    }
    set += run.influences;
  }
  return out;
}

// Largest first; the smallest is what the others leave, so that the sum in float is exactly 1 (if what is taken from 1
// is below a half, the rounding of the difference is too small to be seen beside 1; if above, there is none).
std::vector<Influence> influences_of(const Block& block, std::uint32_t lane, const std::vector<EntryJoints>& entries) {
  std::vector<Influence> out;
  float left = 1;
  for (std::uint32_t j = 0; j < block.influences; ++j) {
    const bool last = j + 1 == block.influences;
    const float weight = last ? left : block.skin[12 + 4 * j + lane];
    left -= weight;
    if (weight == 0) continue;  // a joint of its run's others
    const EntryJoints& entry = entries[block.set[j]];
    add(entry.first, weight * (1 - entry.share), out);
    add(entry.second, weight * entry.share, out);
  }
  std::stable_sort(out.begin(), out.end(), [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
  while (out.size() > 1) {
    float sum = 0;
    for (std::size_t i = 0; i + 1 < out.size(); ++i) sum += out[i].weight;
    out.back().weight = 1 - sum;
    if (out.back().weight > 0) return out;
    out.pop_back();  // too small to count
  }
  return {{out.empty() ? entries[block.set[0]].first : out[0].joint, 1.0f}};
}

template <class T>
std::size_t add_joints(Glb& glb, const std::vector<std::uint16_t>& joints, Component component) {
  return glb.add_accessor(std::vector<T>(joints.begin(), joints.end()), component, kVec4, Target::vertices);
}

std::size_t add_indices(Glb& glb, std::span<const Geometry> parts, std::size_t vertices) {
  const std::vector<std::uint32_t> indices = indices_in_order(parts);
  if (vertices > 65535) return glb.add_accessor(indices, Component::u32, kScalar, Target::indices);
  const std::vector<std::uint16_t> narrow(indices.begin(), indices.end());
  return glb.add_accessor(narrow, Component::u16, kScalar, Target::indices);
}

std::vector<std::vector<Block>> blocks_of_all(std::span<const Geometry> parts) {
  std::vector<std::vector<Block>> out;
  for (const Geometry& g : parts) out.push_back(blocks_of(g));
  return out;
}

}  // namespace

Json export_vertices(Glb& glb, std::span<const Geometry> parts) {
  const std::vector<PartSlot> order = vertex_order(parts);
  const std::vector<std::vector<Block>> blocks = blocks_of_all(parts);
  const Geometry& first = parts[0];  // the others have the same attributes
  std::vector<float> positions;
  for (const auto& [part, slot] : order)
    for (std::size_t c = 0; c < 3; ++c) positions.push_back(blocks[part][slot / 4].skin[c * 4 + slot % 4]);
  Json out;
  Json& attributes = out["attributes"];
  attributes["POSITION"] = glb.add_bounded(positions, kVec3, Target::vertices);
  if (first.normals != nullptr) {
    std::vector<float> normals = unpack(parts, &Geometry::normals, 3, order);
    normalise(normals, 3);
    attributes["NORMAL"] = glb.add_accessor(normals, Component::f32, kVec3, Target::vertices);
  }
  if (first.tangents != nullptr) {
    std::vector<float> tangents = unpack(parts, &Geometry::tangents, 4, order);
    normalise(tangents, 4);
    attributes["TANGENT"] = glb.add_accessor(tangents, Component::f32, kVec4, Target::vertices);
  }
  if (first.uvs != nullptr) {
    std::vector<float> uvs;
    for (const auto& [part, slot] : order)
      uvs.insert(uvs.end(), {parts[part].uvs[2 * slot], parts[part].uvs[2 * slot + 1]});
    attributes["TEXCOORD_0"] = glb.add_accessor(uvs, Component::f32, kVec2, Target::vertices);
  }
  if (first.colours != nullptr) {
    std::vector<std::uint8_t> colours;
    for (const auto& [part, slot] : order)
      colours.insert(colours.end(), parts[part].colours + 4 * slot, parts[part].colours + 4 * slot + 4);
    attributes["COLOR_0"] = glb.add_accessor(colours, Component::u8, kVec4, Target::vertices, true);
  }
  if (std::ranges::any_of(parts, [](const Geometry& g) { return g.index_count > 0; }))
    out["indices"] = add_indices(glb, parts, order.size());
  return out;
}

void export_weights(Glb& glb, std::span<const Geometry> parts, const std::vector<std::vector<EntryJoints>>& entries,
                    bool wide, Json& attributes) {
  const std::vector<std::vector<Block>> blocks = blocks_of_all(parts);
  std::vector<std::vector<Influence>> vertices;
  std::size_t most = 1;
  for (const auto& [part, slot] : vertex_order(parts)) {
    vertices.push_back(influences_of(blocks[part][slot / 4], slot % 4, entries[part]));
    most = std::max(most, vertices.back().size());
  }
  const std::size_t sets = (most + 3) / 4;
  std::vector<std::vector<std::uint16_t>> joints(sets);
  std::vector<std::vector<float>> weights(sets);
  for (std::vector<Influence>& influences : vertices) {
    influences.resize(sets * 4);
    for (std::size_t i = 0; i < sets * 4; ++i) {
      joints[i / 4].push_back(influences[i].joint);
      weights[i / 4].push_back(influences[i].weight);
    }
  }
  for (std::size_t s = 0; s < sets; ++s) {
    const std::string n = std::to_string(s);
    attributes["JOINTS_" + n] = wide ? add_joints<std::uint16_t>(glb, joints[s], Component::u16)
                                     : add_joints<std::uint8_t>(glb, joints[s], Component::u8);
    attributes["WEIGHTS_" + n] = glb.add_accessor(weights[s], Component::f32, kVec4, Target::vertices);
  }
}

}  // namespace marrow::tools
