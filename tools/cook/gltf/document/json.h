// A file to the tree of its JSON, for files that nobody vouches for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cook/gltf/document/findings.h"

namespace marrow::cook::gltf {

// Of UTF-8. Not glTF's, but written by editors; glTF 2.0 lets readers skip it (section 2.7, a note).
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Views into the file's bytes.
struct Container {
  bool binary = false;  // a .glb
  std::string_view json;
  std::size_t json_offset = 0;  // of `json` in the file
  bool has_bin = false;         // a BIN chunk is there; it may be empty
  std::span<const std::byte> bin;
};

// glTF 2.0, section 4.4: header, chunk order, alignment and lengths. Bytes after the declared end are dropped with a
// warning; everything else that is off is refused at its offset.
Container split_container(std::span<const std::byte> file, Report& report);

using Json = nlohmann::json;

// Strict RFC 8259, with two rules more: names in an object are unique (glTF 2.0, section 2.7) and nesting has a limit,
// so that later stages may recurse. The result is an object. A byte-order mark is skipped with a warning. Failures
// carry the byte offset in the file.
Json parse_json(const Container& container, Report& report);

// A member that check_schema() has found to be a count, or not there.
std::uint64_t count_or(const Json& object, const char* name, std::uint64_t fallback);

}  // namespace marrow::cook::gltf
