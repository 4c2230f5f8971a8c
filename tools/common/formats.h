// Which kind of file a file is, glTF, BVH or cooked, and what to do with one that is none of them.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>

namespace marrow::tools {

// Whether the name ends so, in any case. `extension`: ".png".
bool has_extension(std::string_view path, std::string_view extension);

// .gltf, .glb, and .vrm, which is glTF inside.
bool is_named_gltf(const std::string& path);
// .bvh
bool is_named_bvh(const std::string& path);
// One of these: what the cooker reads.
bool is_named_source(const std::string& path);

// What other files begin with, what they are and what to do about it.
struct LooksLike {
  std::string_view begins, name, advice;
};
// Of a file that is neither glTF nor cooked; null if its beginning says nothing.
const LooksLike* looks_like(std::span<const std::byte> bytes);

// Throws Failure (usage) that lists `extensions`, if the name has none of them.
void expect_extension(const std::string& path, std::initializer_list<const char*> extensions);

// Throws Failure if `bytes` are plainly no cooked file: invalid for glTF and BVH, unsupported for what other programs
// write.
void expect_cooked(const std::string& path, std::span<const std::byte> bytes);

// Throws Failure if `bytes` are plainly no glTF: invalid for a cooked file or BVH, unsupported for what other programs
// write.
void expect_gltf(const std::string& path, std::span<const std::byte> bytes);

}  // namespace marrow::tools
