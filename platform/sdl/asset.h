// A cooked file, packed or not, from wherever SDL finds it.
#pragma once

#include <marrow/block.h>
#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <list>
#include <vector>

#include "stage.h"

// Memory for the runtime, which takes none itself. It stays until the game ends.
inline marrow::Span<std::byte> block_of(std::size_t bytes) {
  static std::list<std::vector<std::byte>> memory;
  return marrow::block_in(memory.emplace_back(marrow::block_bytes(bytes)));
}

inline constexpr Sint64 kMostBytes = 1 << 28;
inline const char* const kCookSample =
    ". Cook it: marrow sample -o newt.glb; marrow cook newt.glb --lod 0.12 -o newt.mrw";

inline marrow::File open_file(const std::string& path) {
  SDL_RWops* const stream = SDL_RWFromFile(path.c_str(), "rb");  // of an Android package, too
  if (stream == nullptr) fail(path + ": cannot be opened: " + SDL_GetError() + kCookSample);
  const Sint64 size = SDL_RWsize(stream);
  if (size <= 0 || size > kMostBytes) fail(path + ": is empty, too large, or no file" + kCookSample);
  const marrow::Span<std::byte> memory = block_of(std::size_t(size));
  marrow::Span<const std::byte> bytes(memory.data, std::size_t(size));
  if (SDL_RWread(stream, memory.data, 1, bytes.size) != bytes.size) fail(path + ": cannot be read" + kCookSample);
  SDL_RWclose(stream);

  marrow::Status status = marrow::Status::ok;
  marrow::DataError error;
  if (marrow::is_packed(bytes)) {  // as `marrow cook` writes it
    marrow::UnpackSizes sizes;
    status = unpack_sizes(bytes, sizes, &error);
    if (status == marrow::Status::ok)
      status = unpack(bytes, {marrow::draco_decoder()}, block_of(sizes.memory_bytes), bytes, &error);
  }
  marrow::File file;
  if (status == marrow::Status::ok) status = load(bytes, file, &error);
  if (status != marrow::Status::ok)
    fail(path + ": byte " + std::to_string(error.offset) + ": " + to_string(status) + ", " + error.rule + kCookSample);
  return file;
}
