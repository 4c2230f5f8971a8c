// Splits a file into its JSON text and the binary chunk that a .glb carries.
#include "cook/gltf/document/container.h"

#include <cstdint>
#include <cstring>

#include "common/formats.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67;      // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;  // "JSON"
constexpr std::uint32_t kBinChunk = 0x004E4942;   // "BIN\0"
constexpr std::size_t kGlbHeaderSize = 12;
constexpr std::size_t kChunkHeaderSize = 8;

std::uint32_t read_u32(std::span<const std::byte> file, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | std::to_integer<std::uint32_t>(file[offset + i]);
  return value;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// The length that the header claims, which is at least one chunk header and no more than the file has.
std::size_t checked_length(std::span<const std::byte> file, Report& report) {
  if (file.size() < kGlbHeaderSize) report.invalid(at_offset(file.size()), "GLB header cut short", "export again");
  const std::uint32_t version = read_u32(file, 4);
  if (version == 1) report.unsupported("@4", "GLB version 1", "export as glTF 2.0");
  if (version != 2) report.invalid("@4", "unknown GLB version " + std::to_string(version), "export as glTF 2.0");
  const std::size_t length = read_u32(file, 8);
  if (length < kGlbHeaderSize + kChunkHeaderSize) {
    report.invalid("@8", "GLB length too small", "the header leaves no room for a JSON chunk; export again");
  }
  if (length > file.size()) {
    report.invalid(at_offset(file.size()), "GLB cut short",
                   "the header claims " + std::to_string(length) + " bytes; copy or export the file again");
  }
  if (length < file.size()) {
    report.warn(at_offset(length), "glb-trailing-bytes",
                "the file goes on for " + std::to_string(file.size() - length) + " bytes after its end; dropped");
  }
  return length;
}

struct Chunk {
  std::size_t offset;
  std::uint32_t type;
  std::span<const std::byte> bytes;
};

Chunk read_chunk(std::span<const std::byte> file, std::size_t offset, Report& report) {
  if (file.size() - offset < kChunkHeaderSize) {
    report.invalid(at_offset(file.size()), "chunk header cut short", "a chunk starts with 8 bytes; export again");
  }
  const std::size_t length = read_u32(file, offset);
  if (length % 4 != 0) report.invalid(at_offset(offset), "chunk length is not a multiple of 4", "pad and export again");
  if (length > file.size() - offset - kChunkHeaderSize) {
    report.invalid(at_offset(offset), "chunk too long",
                   "it claims " + std::to_string(length) + " bytes, more than the file has; export again");
  }
  return {offset, read_u32(file, offset + 4), file.subspan(offset + kChunkHeaderSize, length)};
}

void take_chunk(const Chunk& chunk, int number, Container& container, Report& report) {
  const std::string where = at_offset(chunk.offset);
  if (number == 0) {
    if (chunk.type != kJsonChunk) report.invalid(where, "first chunk is not JSON", "export again");
    if (chunk.bytes.empty()) report.invalid(where, "JSON chunk is empty", "export again");
    container.json = text_of(chunk.bytes);
    container.json_offset = chunk.offset + kChunkHeaderSize;
    return;
  }
  if (chunk.type == kJsonChunk) report.invalid(where, "second JSON chunk", "a file has one; export again");
  if (chunk.type == kBinChunk) {
    if (container.has_bin) report.invalid(where, "second BIN chunk", "a file has one; export again");
    if (number != 1) report.invalid(where, "misplaced BIN chunk", "it must be the second chunk; export again");
    container.has_bin = true;
    container.bin = chunk.bytes;
    return;
  }
  report.warn(where, "unknown-chunk", "a chunk of unknown type is ignored");
}

Container split_glb(std::span<const std::byte> file, Report& report) {
  file = file.first(checked_length(file, report));
  Container container;
  container.binary = true;
  std::size_t offset = kGlbHeaderSize;
  for (int number = 0; offset < file.size(); ++number) {
    const Chunk chunk = read_chunk(file, offset, report);
    take_chunk(chunk, number, container, report);
    offset += kChunkHeaderSize + chunk.bytes.size();
  }
  return container;
}

}  // namespace

Container split_container(std::span<const std::byte> file, Report& report) {
  if (file.empty()) report.invalid("@0", "empty file", "export again");
  if (file.size() >= 4 && read_u32(file, 0) == kMagic) return split_glb(file, report);
  Container container;
  container.json = text_of(file);
  const std::size_t start =
      container.json.find_first_not_of(" \t\r\n", container.json.starts_with(kByteOrderMark) ? 3 : 0);
  if (start == std::string_view::npos || container.json[start] != '{') {
    if (const tools::LooksLike* const other = tools::looks_like(file))
      report.invalid("@0", "not a glTF file but, as it begins, " + std::string(other->name),
                     std::string(other->advice));
    report.invalid("@0", "not a glTF file", "a .gltf starts with '{' and a .glb with 'glTF'");
  }
  return container;
}

}  // namespace marrow::cook::gltf
