// From step 2 on: what hello.cpp did to load a file, as functions.
#pragma once

#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}
inline void must(marrow::Status status, const char* doing, const char* log = "") {
  if (status != marrow::Status::ok) fail(std::string(doing) + ": " + to_string(status) + " " + log);
}

// Memory for Marrow, which takes none itself. It stays until the program ends.
inline marrow::Span<std::byte> memory_of(std::size_t bytes) {
  static std::deque<std::vector<std::byte>> blocks;
  return marrow::block_in(blocks.emplace_back(marrow::block_bytes(bytes)));
}

inline marrow::File load_file(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail(path + ": " + std::strerror(errno));
  static std::deque<std::vector<char>> read;
  const std::vector<char>& bytes =
      read.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  marrow::Span<const std::byte> block(reinterpret_cast<const std::byte*>(bytes.data()), bytes.size());
  marrow::DataError error;
  marrow::UnpackSizes sizes;
  marrow::Status status = marrow::Status::ok;
  if (marrow::is_packed(block)) {
    status = unpack_sizes(block, sizes, &error);
    if (status == marrow::Status::ok)
      status = unpack(block, {marrow::draco_decoder()}, memory_of(sizes.memory_bytes), block, &error);
  }
  marrow::File file;
  if (status == marrow::Status::ok) status = load(block, file, &error);
  if (status != marrow::Status::ok)
    fail(path + ": byte " + std::to_string(error.offset) + ": " + to_string(status) + ", " + error.rule);
  return file;
}

inline const marrow::Animation& find(const marrow::Animations& animations, const char* name) {
  const marrow::Animation* const found = find_animation(animations, name);
  if (found == nullptr) fail(std::string("there is no animation \"") + name + "\"");
  return *found;
}

inline std::uint32_t find(const marrow::File& file, const marrow::Skeleton& skeleton, const std::string& joint) {
  const std::uint32_t found = file.find_joint(skeleton, joint.c_str());
  if (found == skeleton.joint_count) fail("there is no joint \"" + joint + "\"");
  return found;
}
