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

}  // namespace marrow::cook::gltf
