// Who is whose neighbour on a mesh, vertices that move alike being one.
#pragma once

#include "core/memory.h"
#include "core/step.h"
#include "unpack/streams.h"

namespace marrow {

struct MeshNeighbours {
  std::uint32_t* leader =
      nullptr;                     // of each vertex the first that lies where it does and follows the same joints alike
  std::uint32_t* first = nullptr;  // of each vertex in `all`, which has entries for leaders alone
  std::uint32_t* count = nullptr;
  std::uint32_t* all = nullptr;       // leaders, each once a row; in an order that the mesh's own order decides
  std::uint8_t* is_inside = nullptr;  // whether each edge round a leader has two triangles, and there are some
  std::uint32_t* scratch = nullptr;   // a number a vertex, free when find_neighbours() is done; two of these
  std::uint32_t* scratch_2 = nullptr;
};

// Bytes that find_neighbours() takes.
constexpr std::uint64_t neighbours_bytes(std::uint64_t vertex_count, std::uint64_t triangle_count) {
  constexpr auto aligned = [](std::uint64_t bytes) { return (bytes + 15) / 16 * 16; };
  return 5 * aligned(vertex_count * 4) + aligned(vertex_count) + aligned(triangle_count * 24);
}

// A search on its way.
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
  std::uint32_t at = 0, sum = 0;  // of what it goes through; entries of `all`
  Sorting sorting;
};

// Goes on until `left` is used up or the place is `done`. The streams are checked: indices, joints. Triangles between
// fewer than three leaders do not count. Returns false if the memory does not suffice. Cost: one sort of the vertices.
bool find_neighbours(const MeshStreams& mesh, Memory& memory, NeighboursInWork& work, MeshNeighbours& out,
                     std::uint32_t& left);

}  // namespace marrow
