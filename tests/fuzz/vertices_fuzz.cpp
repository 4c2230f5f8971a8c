// Fuzz target: a stride, a count and bytes → the vertex codec of KHR_meshopt_compression.
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cook/gltf/document/meshopt.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::uint32_t stride = 4 * (1 + data[0] % 64U);
  const std::size_t count = data[1] + 256U * (data[2] % 4U);
  std::vector<std::byte> elements(count * stride);
  marrow::cook::gltf::decode_vertices(std::as_bytes(std::span(data, size).subspan(3)), stride, elements);
  return 0;
}
