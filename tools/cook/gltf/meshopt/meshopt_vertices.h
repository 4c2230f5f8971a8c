// The vertex codec of KHR_meshopt_compression, appendix A, mode 0: bytes → elements. Versions 0 and 1.
//
// meshoptimizer decodes both from release 0.23 on; older ones, which systems install, know version 0 alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace marrow::cook::gltf {

// The fewest bytes that so many elements take; no more than what decode_vertices() reads.
std::uint64_t least_vertex_bytes(std::span<const std::byte> coded, std::uint64_t count, std::uint32_t stride);

// Fills `elements`, of `stride` bytes each, a multiple of 4 up to 256. False if `coded` is not exactly these elements;
// what is in `elements` then says nothing.
bool decode_vertices(std::span<const std::byte> coded, std::uint32_t stride, std::span<std::byte> elements);

}  // namespace marrow::cook::gltf
