// Decodes buffer views of EXT_meshopt_compression and KHR_meshopt_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"

namespace marrow::cook::gltf {

// The extension of a buffer or a buffer view, under either name, with where it is; null without.
const Json* find_meshopt(const Json& owner, std::string& where);

// What the extension's object says of a buffer view, checked against the view.
struct MeshoptView {
  enum class Mode { attributes, triangles, indices };
  enum class Filter { none, octahedral, quaternion, exponential, color };

  std::size_t buffer = 0;  // holds the coded bytes
  std::uint64_t offset = 0, coded_length = 0;
  std::uint64_t count = 0;
  std::uint32_t stride = 0;
  Mode mode = Mode::attributes;
  Filter filter = Filter::none;
};
// Throws Failure where the extension's rules do not hold. `length` and `stride` are the view's own.
MeshoptView read_meshopt_view(const Json& extension, std::uint64_t length, std::uint32_t stride,
                              const std::string& where, const Report& report);

// count × stride bytes, filtered; the same on every processor. Throws Failure for data that are damaged.
std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> coded,
                                      const std::string& where, const Report& report);

// The vertex codec of KHR_meshopt_compression, appendix A, mode 0: bytes → elements. Versions 0 and 1. meshoptimizer
// decodes both from release 0.23 on; older ones, which systems install, know version 0 alone.
//
// The fewest bytes that so many elements take; no more than what decode_vertices() reads.
std::uint64_t least_vertex_bytes(std::span<const std::byte> coded, std::uint64_t count, std::uint32_t stride);

// Fills `elements`, of `stride` bytes each, a multiple of 4 up to 256. False if `coded` is not exactly these elements;
// what is in `elements` then says nothing.
bool decode_vertices(std::span<const std::byte> coded, std::uint32_t stride, std::span<std::byte> elements);

// The filters of appendix B: what is done to elements after they are decoded. meshoptimizer has them as well, but by
// the approximate roots of the processor at hand; a cooked file would differ between two of them.
//
// Each goes over elements of `stride` bytes in place. What the extension leaves open is zero or clamped.
void unfold_octahedra(std::span<std::byte> elements, std::uint32_t stride);  // 4 or 8 bytes: signed, normalised
void restore_quaternions(std::span<std::byte> elements);                     // 8 bytes
void restore_exponents(std::span<std::byte> elements);                       // 4 bytes a number
void restore_colours(std::span<std::byte> elements, std::uint32_t stride);   // 4 or 8 bytes: unsigned, normalised

}  // namespace marrow::cook::gltf
