#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace marrow::cook {

// The triangles of a mesh that is in order for the vertex cache, cut into parts, of which those that face away from the
// middle come first: what lies behind them need not be drawn. Sander, Nehab, Barczak, "Fast triangle reordering for
// vertex locality and reduced overdraw", 2007, as meshoptimizer 0.18 does it; its library for AArch64 contracts
// products, so that the order would be another there.
//
// positions: three floats a vertex. most_misses: how many more vertices than without cuts a part may load, as 1.05.
std::vector<std::uint32_t> outer_parts_first(std::span<const std::uint32_t> indices, std::span<const float> positions,
                                             float most_misses);

}  // namespace marrow::cook
