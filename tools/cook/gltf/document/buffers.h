// Gathers the bytes behind a document's buffers and cuts them into buffer views.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "marrow/cook_host.h"

namespace marrow::cook::gltf {

struct View {
  std::span<const std::byte> bytes;  // decoded, if compressed; empty when the buffer has none
  bool present = false;              // the buffer's bytes are known
  std::uint64_t offset = 0;          // in the buffer
  std::uint64_t length = 0;
  std::uint32_t stride = 0;  // 0: tightly packed
  std::int64_t target = 0;   // 0: not given
};

struct Buffers {
  std::vector<std::vector<std::byte>> owned;
  std::vector<std::optional<std::span<const std::byte>>> buffers;  // nullopt: the document gives no bytes
  std::vector<View> views;
  std::uint64_t external_bytes = 0;  // read from files besides the scene's own
};

// `files` has what relative URIs name; null for a scene in memory, where they are refused. Needs a schema-checked
// document. Every view lies in its buffer afterwards. Views into `container` stay views.
Buffers load_buffers(const Json& root, const Container& container, Files* files, Report& report);

}  // namespace marrow::cook::gltf
