// Vertices and triangles of cooked geometries, without the padding that kernels want; a primitive in parts put together
// again.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

// A mesh and the parts behind it that go on with it, see Mesh::is_next_part: of the level in full.
inline std::vector<Mesh> parts_at(const File& file, std::uint32_t first) {
  std::vector<Mesh> out = {file.mesh(first)};
  while (first + out.size() < file.mesh_count()) {
    const Mesh next = file.mesh(first + static_cast<std::uint32_t>(out.size()));
    if (!next.is_next_part) break;
    out.push_back(next);
  }
  return out;
}

inline std::vector<Geometry> geometries_of(std::span<const Mesh> parts) {
  std::vector<Geometry> out;
  for (const Mesh& part : parts) out.push_back(part.geometry);
  return out;
}

struct PartSlot {
  std::uint32_t part, slot;
};

// The order in which vertices are written: the source's if the file remembers it, else the file's own, part by part.
// For a vertex of the source that no triangle uses the first slot stands in.
inline std::vector<PartSlot> vertex_order(std::span<const Geometry> parts) {
  std::vector<PartSlot> order(parts[0].source_slots.size, PartSlot{0, 0});
  for (auto part = static_cast<std::uint32_t>(parts.size()); part-- > 0;)
    for (std::size_t v = 0; v < order.size(); ++v)
      if (parts[part].source_slots[v] != kNoSlot) order[v] = {part, parts[part].source_slots[v]};
  if (!order.empty()) return order;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    std::uint32_t slot = 0;
    for (const Run& run : parts[part].runs) {
      for (std::uint32_t i = 0; i < run.vertex_count; ++i) order.push_back({part, slot + i});
      slot += (run.vertex_count + 3) / 4 * 4;
    }
  }
  return order;
}

inline std::vector<std::uint32_t> vertex_order(const Geometry& g) {
  std::vector<std::uint32_t> order;
  for (const PartSlot& at : vertex_order(std::span(&g, 1))) order.push_back(at.slot);
  return order;
}

inline std::uint32_t index_at(const Geometry& g, std::uint32_t i) {
  return g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                            : static_cast<const std::uint32_t*>(g.indices)[i];
}

// The triangles of all parts, in places of that order.
inline std::vector<std::uint32_t> indices_in_order(std::span<const Geometry> parts) {
  const std::vector<PartSlot> order = vertex_order(parts);
  std::vector<std::uint32_t> out;
  for (std::uint32_t part = 0; part < parts.size(); ++part) {
    const Geometry& g = parts[part];
    std::vector<std::uint32_t> place(g.slot_count, 0);
    for (std::uint32_t v = 0; v < order.size(); ++v)
      if (order[v].part == part) place[order[v].slot] = v;
    for (std::uint32_t v = 0; v < g.source_slots.size; ++v)
      if (g.source_slots[v] != kNoSlot) place[g.source_slots[v]] = v;
    for (std::uint32_t i = 0; i < g.index_count; ++i) out.push_back(place[index_at(g, i)]);
  }
  return out;
}

}  // namespace marrow::tools
