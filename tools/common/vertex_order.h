// Vertices and triangles of a cooked geometry, without the padding that kernels want.
#pragma once

#include <cstdint>
#include <vector>

#include "marrow/file.h"

namespace marrow::tools {

// Slots in the order in which vertices are written: the source's if the file remembers it, else the file's own. For a
// vertex of the source that no triangle uses the first slot stands in.
inline std::vector<std::uint32_t> vertex_order(const Geometry& g) {
  std::vector<std::uint32_t> order;
  for (const std::uint32_t slot : g.source_slots) order.push_back(slot == kNoSlot ? 0u : slot);
  if (!order.empty()) return order;
  std::uint32_t slot = 0;
  for (const Run& run : g.runs) {
    for (std::uint32_t i = 0; i < run.vertex_count; ++i) order.push_back(slot + i);
    slot += (run.vertex_count + 3) / 4 * 4;
  }
  return order;
}

inline std::uint32_t index_at(const Geometry& g, std::uint32_t i) {
  return g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                            : static_cast<const std::uint32_t*>(g.indices)[i];
}

}  // namespace marrow::tools
