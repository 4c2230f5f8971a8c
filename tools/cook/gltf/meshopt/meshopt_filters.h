// The filters of KHR_meshopt_compression, appendix B: what is done to elements after they are decoded.
//
// meshoptimizer has them as well, but by the approximate roots of the processor at hand; a cooked file would differ
// between two of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace marrow::cook::gltf {

// Each goes over elements of `stride` bytes in place. What the extension leaves open is zero or clamped.
void unfold_octahedra(std::span<std::byte> elements, std::uint32_t stride);  // 4 or 8 bytes: signed, normalised
void restore_quaternions(std::span<std::byte> elements);                     // 8 bytes
void restore_exponents(std::span<std::byte> elements);                       // 4 bytes a number
void restore_colours(std::span<std::byte> elements, std::uint32_t stride);   // 4 or 8 bytes: unsigned, normalised

}  // namespace marrow::cook::gltf
