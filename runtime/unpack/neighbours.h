// The neighbours of each vertex of a mesh. Vertices that move alike count as one.
#pragma once

#include "core/memory.h"
#include "core/step.h"
#include "unpack/streams.h"

namespace marrow {

struct MeshNeighbours {
  std::uint32_t* leader = nullptr;  // per vertex: the first vertex with the same position, joints and weights
  std::uint32_t* first = nullptr;   // per vertex: where its row in `all` begins; only leaders have entries
  std::uint32_t* count = nullptr;
  std::uint32_t* all = nullptr;       // rows of leaders, without repeats; their order follows from the mesh's
  std::uint8_t* is_inside = nullptr;  // whether a leader has edges, and each of them has two triangles
  std::uint32_t* scratch = nullptr;   // a number per vertex; this and scratch_2 are free after find_neighbours()
  std::uint32_t* scratch_2 = nullptr;
};

// Bytes that find_neighbours() takes.
constexpr std::uint64_t neighbours_bytes(std::uint64_t vertex_count, std::uint64_t triangle_count) {
  constexpr auto aligned = [](std::uint64_t bytes) { return (bytes + 15) / 16 * 16; };
  return 5 * aligned(vertex_count * 4) + aligned(vertex_count) + aligned(triangle_count * 24);
}

// The state of find_neighbours() between steps.
struct NeighboursInWork {
  enum class Place : std::uint8_t {
    beginning,
    numbering,
    sorting,
    leading,
    counting,
    summing,
    filling,
    marking,
    thinning,
    done
  };

  Place place = Place::beginning;
  std::uint32_t at = 0, sum = 0;  // index in the current pass; entries of `all` so far
  Sorting sorting;
};

// Goes on until `left` is used up or the place is `done`. The streams are checked: indices, joints. Triangles between
// fewer than three leaders do not count. Returns false if the memory does not suffice. Cost: one sort of the vertices.
bool find_neighbours(const MeshStreams& mesh, Memory& memory, NeighboursInWork& work, MeshNeighbours& out,
                     std::uint32_t& left);

}  // namespace marrow
