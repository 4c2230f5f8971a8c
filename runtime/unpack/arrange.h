// Where each vertex of a mesh goes: grouped by joint set, four to a block.
#pragma once

#include "core/memory.h"
#include "unpack/streams.h"

namespace marrow {

struct Arrangement {
  std::uint32_t* order = nullptr;           // vertex_count; vertices in the order of their slots, without padding
  std::uint32_t* slot_of_vertex = nullptr;  // vertex_count
  std::uint32_t* run_ends = nullptr;        // run_count; in `order`, behind the last vertex each
  std::uint32_t block_count = 0;
  std::uint32_t influence_blocks = 0;
  std::uint32_t run_count = 0;
  std::uint32_t set_count = 0;
};

// How many of the joints of a vertex count: those up to where the last one repeats.
std::uint32_t influence_count(const MeshStreams& mesh, std::uint32_t vertex);

// Orders vertices by number of influences, then joints, then first use by a triangle, so that vertices of neighbouring
// triangles stay neighbours. Joints are below 2^15. Returns false if scratch does not suffice: arrange_scratch_bytes().
constexpr std::uint64_t arrange_scratch_bytes(std::uint64_t vertex_count) {
  return 3 * ((vertex_count * 4 + 15) / 16 * 16) + (vertex_count * 8 + 15) / 16 * 16;
}
bool arrange(const MeshStreams& mesh, Memory& scratch, Arrangement& out);

}  // namespace marrow
