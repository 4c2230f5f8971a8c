// Packed files built by hand, with a codec that stores numbers as they are.
#pragma once

#include <cstring>
#include <memory>
#include <vector>

#include "core/builtins.h"
#include "marrow/file.h"
#include "marrow/unpack.h"
#include "support/aligned.h"
#include "unpack/geometry.h"
#include "unpack/streams.h"

namespace marrow::test {

inline constexpr std::uint32_t kPlain = 200;

// Indices, then every stream, as 32-bit numbers.
inline Status decode_plain(Span<const std::byte> bytes, const MeshStreams& out) {
  std::size_t at = 0;
  const auto copy = [&](void* to, std::size_t count) {
    if (at + 4 * count > bytes.size) return false;
    std::memcpy(to, bytes.data + at, 4 * count);
    at += 4 * count;
    return true;
  };
  if (!copy(out.indices, std::size_t{out.triangle_count} * 3)) return Status::bad_data;
  for (std::uint32_t i = 0; i < out.stream_count; ++i)
    if (!copy(out.streams[i].values, std::size_t{out.vertex_count} * out.streams[i].components))
      return Status::bad_data;
  return at == bytes.size ? Status::ok : Status::bad_data;
}

inline const MeshDecoder kPlainDecoder[] = {{kPlain, decode_plain}};

struct Bytes {
  std::vector<std::byte> all;
  Bytes& u8(std::uint32_t v) {
    all.push_back(static_cast<std::byte>(v));
    return *this;
  }
  Bytes& u32(std::uint32_t v) {
    for (int i = 0; i < 4; ++i) u8(v >> (8 * i));
    return *this;
  }
  Bytes& f32(float v) { return u32(bit_cast<std::uint32_t>(v)); }
  Bytes& numbers(std::initializer_list<int> values) {
    for (const int v : values) u32(static_cast<std::uint32_t>(v));
    return *this;
  }
  Bytes& add(const std::vector<std::byte>& other) {
    all.insert(all.end(), other.begin(), other.end());
    return *this;
  }
};

// Five vertices of a fan. 0, 2 and 4 follow entry 1; 1 and 3 are shared between entries 0 and 2, a third and two.
inline std::vector<std::byte> fan_record() {
  Bytes b;
  b.u8(format::kHasNormals | format::kHasUvs).u8(5).u8(3).u8(3).u8(2);
  b.u8(4).f32(-1).f32(0).f32(2).f32(0.5f);  // positions: 4 bits from (-1, 0, 2) in halves
  b.u8(2);                                  // normals: 2 bits, so 0 … 2 with 1 in the middle
  b.u8(3).f32(0).f32(1).f32(0.25f);         // UVs: 3 bits from (0, 1) in quarters
  b.u8(2);                                  // weights: thirds
  b.numbers({0, 1, 2, 0, 2, 3, 0, 3, 4});
  b.numbers({0, 0, 0, 2, 0, 1, 4, 2, 0, 6, 6, 3, 8, 8, 15});  // positions
  b.numbers({1, 1, 1, 2, 2, 1, 0, 1, 2, 2});                  // normals: +x, +z, +y, -y, -x
  b.numbers({0, 0, 1, 2, 3, 4, 5, 6, 7, 7});                  // UVs
  b.numbers({1, 1, 0, 2, 1, 1, 0, 2, 1, 1});                  // joints, the last repeated
  b.numbers({0, 1, 0, 1, 0});                                 // weights of the first of two
  return b.all;
}

inline std::uint32_t geometry_bytes() {
  // 2 runs, 2 blocks; 3 influence blocks.
  return 64 + 2 * 48 + 16 + 2 * 48 + 8 * 8 + 2 * 8 + 9 * 2 + 3 * 2;
}

// As the cooker finds it: from streams that are there. Some number for a record that cannot be read.
inline std::uint32_t scratch_bytes_of(const std::vector<std::byte>& geometry) {
  AlignedBlock streams(1 << 16);
  ByteReader reader(geometry.data(), geometry.size());
  Memory memory{streams.data(), 0, streams.size()};
  MeshStreams mesh;
  if (read_geometry_record(reader, memory, mesh) != nullptr) return 4096;
  return static_cast<std::uint32_t>(format::align16(geometry_scratch_bytes(mesh)));
}

// Around it one skeleton of three joints and one mesh that binds entry e to joint e.
inline std::vector<std::byte> packed_fan(std::vector<std::byte> geometry = fan_record(), std::uint32_t codec = kPlain,
                                         std::uint32_t extra_file_bytes = 0, std::uint32_t extra_memory = 0,
                                         std::uint32_t section_bytes = geometry_bytes()) {
  Bytes skeleton;
  skeleton.u32(0).u32(3).u32(1).u32(0);
  const Affine identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const auto affine = [&](Bytes& b) {
    for (const auto& row : identity.rows)
      for (const float x : row) b.f32(x);
  };
  affine(skeleton);
  for (int i = 0; i < 40; ++i) skeleton.f32(i >= 24 ? 1.0f : 0.0f);
  skeleton.u32(0).u32(0).u32(0);
  skeleton.u8(255).u8(255).u8(0).u8(0).u8(0).u8(0);
  Bytes mesh;
  mesh.u32(0).u32(0).u32(0).u32(0).u32(3).u32(0).f32(1).f32(1).f32(1).f32(1).u32(0).u32(0);
  for (int e = 0; e < 3; ++e) affine(mesh);
  mesh.u8(0).u8(0).u8(1).u8(0).u8(2).u8(0);
  Bytes names;
  names.u8(0);

  Bytes records;
  const auto record = [&](std::uint32_t kind, std::uint32_t c, const std::vector<std::byte>& bytes) {
    records.u8(kind)
        .u8(c)
        .u8((bytes.size() & 0x7F) | 0x80)
        .u8(static_cast<std::uint32_t>(bytes.size() >> 7))
        .add(bytes);
  };
  record(format::kSkeletons, 0, skeleton.all);
  record(format::kGeometries, codec, geometry);
  record(format::kMeshes, 0, mesh.all);
  record(format::kNames, 0, names.all);

  std::uint64_t end = 32 + 4 * 16;
  for (const std::size_t bytes : {skeleton.all.size(), std::size_t{section_bytes}, mesh.all.size(), names.all.size()})
    end = format::align16(end) + bytes;
  Bytes file;
  file.u32(packed::kMagic).u32(packed::kVersion).u32(static_cast<std::uint32_t>(32 + records.all.size()));
  const std::uint32_t file_bytes = static_cast<std::uint32_t>(end) + extra_file_bytes;
  const auto memory = static_cast<std::uint32_t>(format::align16(file_bytes)) + scratch_bytes_of(geometry);
  file.u32(file_bytes).u32(memory + extra_memory).u32(4);
  const std::uint64_t sum = format::checksum(records.all.data(), records.all.size());
  file.u32(static_cast<std::uint32_t>(sum)).u32(static_cast<std::uint32_t>(sum >> 32)).add(records.all);
  return file.all;
}

inline void forge(std::vector<std::byte>& packed) {
  const std::uint64_t sum = format::checksum(packed.data() + 32, packed.size() - 32);
  std::memcpy(packed.data() + 24, &sum, sizeof sum);
}

using Unpacked = std::unique_ptr<AlignedBlock>;

// Unpacks and loads; memory is no larger than asked for.
inline Status run(const std::vector<std::byte>& packed, Unpacked& memory, File& out, DataError& error) {
  const AlignedBlock copy(packed.data(), packed.size());
  const Span<const std::byte> bytes(copy.data(), copy.size());
  UnpackSizes sizes;
  Status status = unpack_sizes(bytes, sizes, &error);
  if (status != Status::ok) return status;
  memory = std::make_unique<AlignedBlock>(sizes.memory_bytes);
  Span<const std::byte> file;
  status = unpack(bytes, {kPlainDecoder, 1}, {memory->data(), memory->size()}, file, &error);
  return status == Status::ok ? load(file, out, &error) : status;
}

// The fan with multi-weights and two example poses, of which the first moves vertex 3 by half along y and the other
// nothing. Of vertex 3 (entries 0 and 2) the first influence's element (1, 1) weighs half more, the second's
// translation along z a quarter less. Entry 1 turns relative to 0, entry 2 to 1.
inline std::vector<std::byte> fan_with_deformers() {
  const std::vector<std::byte> fan = fan_record();
  constexpr std::size_t kCounts = 5, kQuantisation = 1 + 16 + 1 + 1 + 12 + 1;
  Bytes b;
  b.u8(0x85).u8(0x03).u8(5).u8(3).u8(3).u8(2).u8(2);  // flags 1 + 4 + 128 + 256; two examples
  b.add({fan.begin() + kCounts, fan.begin() + kCounts + kQuantisation});
  b.u8(4).f32(0.25f).u8(1);  // multi-weights: 4 bits, 8 is nothing; the root is entry 1
  b.f32(0.5f).u8(0).u8(1).u8(2);
  const auto rotation = [&b](int x, int w) {
    for (const int c : {x, 0, 0, w}) b.u8(static_cast<std::uint32_t>(c)).u8(static_cast<std::uint32_t>(c) >> 8);
  };
  b.u8(4).f32(0.25f);
  rotation(1000, 32000);
  rotation(-32000, 1000);
  b.u8(0);
  rotation(3, 4);
  rotation(5, 6);
  b.add({fan.begin() + kCounts + kQuantisation, fan.end()});
  for (int influence = 0; influence < 2; ++influence)
    for (int i = 0; i < 60; ++i)
      b.numbers({influence == 0 && i == 3 * 12 + 5 ? 10 : influence == 1 && i == 3 * 12 + 11 ? 7 : 8});
  b.numbers({8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 10, 8, 8, 8, 8});
  return b.all;
}

inline std::vector<std::byte> packed_deformers(const std::vector<std::byte>& record = fan_with_deformers()) {
  const std::uint32_t section = geometry_bytes() + 3 * 192 + 16 + 2 * 32 + 2 * 3 * 8 + 2 + 24 + 3 * 2;
  return packed_fan(record, kPlain, 0, 0, section);
}

}  // namespace marrow::test
