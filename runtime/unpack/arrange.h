// Where each vertex of a mesh goes: grouped by joint set, four to a block.
#pragma once

#include "core/memory.h"
#include "core/step.h"
#include "unpack/streams.h"

namespace marrow {

struct Arrangement {
  std::uint32_t* order = nullptr;           // vertex_count; vertices in the order of their slots, without padding
  std::uint32_t* slot_of_vertex = nullptr;  // vertex_count
  std::uint32_t* run_ends = nullptr;        // run_count; where in `order` each run ends
  std::uint32_t block_count = 0;
  std::uint32_t influence_blocks = 0;
  std::uint32_t run_count = 0;
  std::uint32_t set_count = 0;
};

// The number of joints of a vertex, without the repeats of the last one.
std::uint32_t influence_count(const MeshStreams& mesh, std::uint32_t vertex);

// Orders vertices by number of influences, then joints, then first use by a triangle, so that vertices of neighbouring
// triangles stay neighbours. Joints are below 2^15.
constexpr std::uint64_t arrange_scratch_bytes(std::uint64_t vertex_count) {
  return 3 * ((vertex_count * 4 + 15) / 16 * 16) + (vertex_count * 8 + 15) / 16 * 16;
}

// The state of arrange() between steps.
struct ArrangingInWork {
  enum class Place : std::uint8_t { beginning, stretches, sorting, runs, clearing, filling, placing, done };

  Place place = Place::beginning;
  std::uint32_t at = 0;             // index in the current pass
  std::uint32_t stretch_count = 0;  // stretches of vertices that follow the same joints
  std::uint32_t before = 0, first = 0;
  Sorting sorting;
  std::uint32_t* stretch_of = nullptr;  // a vertex; free again when it is done
  std::uint32_t* low = nullptr;         // halves of a stretch's key
};
// Goes on until `left` is used up or the place is `done`. Returns false if scratch does not suffice:
// arrange_scratch_bytes().
bool arrange(const MeshStreams& mesh, Memory& scratch, ArrangingInWork& work, Arrangement& out, std::uint32_t& left);
// All at once.
bool arrange(const MeshStreams& mesh, Memory& scratch, Arrangement& out);

}  // namespace marrow
