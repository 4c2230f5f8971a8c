#include "common/unpack_mrw.h"

#include <new>

#include "common/failure.h"
#include "core/byte_reader.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "unpack/packed.h"

namespace marrow::tools {

namespace {

// What a few bytes may ask for, and each more: about ten times what the richest meshes take.
constexpr std::uint64_t kMostMemory = 64 << 20, kMostMemoryAByte = 4096;

}  // namespace

AlignedBytes unpacked(std::span<const std::byte> packed, const std::string& path) {
  const Span<const std::byte> bytes(packed.data(), packed.size());
  const MeshDecoder decoders[] = {draco_decoder(), meshopt_decoder()};
  UnpackSizes sizes;
  DataError error;
  Span<const std::byte> file;
  AlignedBytes memory;
  Status status = unpack_sizes(bytes, sizes, &error);
  if (status == Status::ok && sizes.memory_bytes > kMostMemory + kMostMemoryAByte * packed.size()) {
    status = Status::bad_data;
    error = {status, 16, "more memory than so small a file is given"};
  }
  if (status == Status::ok) {
    memory = AlignedBytes(sizes.memory_bytes);
    status = unpack(bytes, {decoders, 2}, {memory.data(), memory.size()}, file, &error);
  }
  if (status == Status::out_of_memory) throw std::bad_alloc();
  if (status != Status::ok) {
    const bool foreign = status == Status::unsupported || status == Status::bad_version;
    throw Failure(foreign ? Exit::unsupported : Exit::invalid, path, "@" + std::to_string(error.offset),
                  to_string(status), error.rule);
  }
  memory.truncate(sizes.file_bytes);
  return memory;
}

std::vector<File::Section> records_of(std::span<const std::byte> packed) {
  std::vector<File::Section> out;
  ByteReader reader(packed.data() + sizeof(packed::Header), packed.size() - sizeof(packed::Header));
  while (reader.left() > 0) {
    const auto kind = reader.take<std::uint8_t>();
    const auto codec = reader.take<std::uint8_t>();
    const std::uint32_t bytes = reader.take_varint();
    const auto offset = static_cast<std::uint32_t>(packed.size() - reader.left());
    reader.take_bytes(bytes);
    if (reader.failed() || kind >= format::kKindCount) break;
    out.push_back({format::kTypes[kind], offset, bytes, codec});
  }
  return out;
}

}  // namespace marrow::tools
