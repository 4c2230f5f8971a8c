// A cooked file in memory, packed or not. docs/stages/loading.md explains it; the programs beside it use it.
#pragma once

#include <marrow/block.h>
#include <marrow/draco.h>
#include <marrow/marrow.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

struct Asset {
  std::vector<std::byte> memory;  // stays as long as anything uses `file`
  marrow::File file;
  marrow::DataError error;  // where a file is wrong, and which rule it breaks

  marrow::Status open(const char* path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) std::perror(path);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
    return open({reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()});
  }

  marrow::Status open(marrow::Span<const std::byte> bytes) {
    if (!marrow::is_packed(bytes)) {
      memory.resize(marrow::block_bytes(bytes.size));
      const marrow::Span<std::byte> block = marrow::block_in(memory);
      std::copy(bytes.begin(), bytes.end(), block.begin());
      return load({block.data, bytes.size}, file, &error);
    }
    const marrow::MeshDecoder decoders[] = {marrow::draco_decoder()};
    marrow::UnpackSizes sizes;
    marrow::Status status = unpack_sizes(bytes, sizes, &error);
    if (status != marrow::Status::ok) return status;
    memory.resize(marrow::block_bytes(sizes.memory_bytes));
    marrow::Span<const std::byte> unpacked;
    status = unpack(bytes, decoders, marrow::block_in(memory), unpacked, &error);
    return status == marrow::Status::ok ? load(unpacked, file, &error) : status;
  }
};
