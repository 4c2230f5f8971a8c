// Steps of unpacking are short whatever a file holds, and what a file claims is refused before anything is done for it.
#include <cstring>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "cook/geometry/record.h"
#include "core/step.h"
#include "marrow/meshopt.h"
#include "support/fan.h"
#include "unpack/clip/bounds_codec.h"
#include "unpack/records.h"

namespace marrow::test {
namespace {

// Of processor. Sanitizers take several times as long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__clang__)
constexpr double kMostSeconds = 0.5;
#else
constexpr double kMostSeconds = 0.02;
#endif

void add_varint(Bytes& b, std::uint64_t x) {
  for (; x >= 0x80; x >>= 7) b.u8(static_cast<std::uint32_t>(x & 0x7F) | 0x80);
  b.u8(static_cast<std::uint32_t>(x));
}

// A file of one record and no names, which load() would refuse and unpacking does not ask for.
struct OneRecord {
  std::uint32_t kind, codec;
  std::vector<std::byte> bytes;
  std::uint64_t section_bytes, scratch_bytes = 0;

  std::vector<std::byte> packed() const {
    Bytes record;
    record.u8(kind).u8(codec);
    add_varint(record, bytes.size());
    record.add(bytes);
    const auto file_bytes = static_cast<std::uint32_t>(32 + 16 + section_bytes);
    Bytes out;
    out.u32(packed::kMagic).u32(packed::kVersion).u32(static_cast<std::uint32_t>(32 + record.all.size()));
    out.u32(file_bytes).u32(static_cast<std::uint32_t>(format::align16(file_bytes) + format::align16(scratch_bytes)));
    out.u32(1).u32(0).u32(0).add(record.all);
    forge(out.all);
    return out.all;
  }
};

struct Stepped {
  Status status = Status::ok;
  DataError error;
  int steps = 0;
  double longest_s = 0;
  Unpacked memory;
  Span<const std::byte> section;
};

double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

Stepped step_through(const OneRecord& record) {
  const std::vector<std::byte> packed = record.packed();
  const Span<const std::byte> bytes(packed.data(), packed.size());
  Stepped out;
  UnpackSizes sizes;
  out.status = unpack_sizes(bytes, sizes, &out.error);
  if (out.status != Status::ok) return out;
  out.memory = std::make_unique<AlignedBlock>(sizes.memory_bytes);
  std::memset(out.memory->data(), 0, out.memory->size());  // pages are the game's to have
  Unpacking work;
  const MeshDecoder decoders[] = {kPlainDecoder[0], meshopt_decoder()};
  out.status = begin_unpack(bytes, {decoders, 2}, {out.memory->data(), out.memory->size()}, work, &out.error);
  for (; out.status == Status::ok && work.file.empty(); ++out.steps) {
    const double begin_s = processor_s();
    out.status = unpack_step(work, &out.error);
    out.longest_s = std::max(out.longest_s, processor_s() - begin_s);
  }
  EXPECT_LT(out.longest_s, kMostSeconds);
  if (out.status == Status::ok) out.section = {work.file.data + 48, work.file.size - 48};
  return out;
}

TEST(Steps, OfBytesAsTheyAre) {
  std::vector<std::byte> bytes(20'000'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * i >> 7);
  const Stepped it = step_through({format::kImages, format::kCodecRaw, bytes, bytes.size()});
  ASSERT_EQ(it.status, Status::ok) << it.error.rule;
  EXPECT_EQ(it.steps, 5 + 5) << "4 MiB each, and as many for the checksum";
  EXPECT_EQ(std::memcmp(it.section.data, bytes.data(), bytes.size()), 0);
  File file;
  EXPECT_EQ(load({it.memory->data(), 48 + bytes.size()}, file, nullptr), Status::bad_data)
      << "no names; the checksum fits";
}

TEST(Steps, OfNames) {
  Bytes pool, record;
  pool.u8(0);
  Bytes names;
  for (int i = 0; i < 60000; ++i) {
    const std::string name = std::to_string(i) + std::string(40, 'n');
    names.u8(0);
    for (const char c : name) {
      names.u8(static_cast<unsigned char>(c));
      pool.u8(static_cast<unsigned char>(c));
    }
    names.u8(0);
    pool.u8(0);
  }
  add_varint(record, pool.all.size());
  record.add(names.all);
  const Stepped it = step_through({format::kNames, packed::kCompact, record.all, pool.all.size()});
  ASSERT_EQ(it.status, Status::ok) << it.error.rule;
  EXPECT_EQ(it.steps, 3 + 1) << "2.7 MB, a mebibyte each";
  EXPECT_EQ(std::memcmp(it.section.data, pool.all.data(), pool.all.size()), 0);
}

TEST(Steps, OfBounds) {
  constexpr std::uint32_t kClips = 400, kMeshes = 250;
  std::vector<format::BoundsCodes> want;
  cook::SymbolEncoder encoder;
  BoundsCodec<cook::SymbolEncoder> codec;
  const auto bytes_of = [](format::BoundsCodes& c) { return reinterpret_cast<std::byte*>(&c); };
  for (std::uint32_t i = 0; i < kClips * kMeshes; ++i) {
    const auto low = static_cast<std::int8_t>(-static_cast<int>(i % 90));
    want.push_back({0, {low, -1, -1}, {3, 3, 3}, 100});
  }
  for (std::uint32_t i = 0; i < want.size(); ++i) {
    if (i > 0 && i % kMeshes == 0) codec.code_between(encoder, 0);
    codec.code(encoder, i == 0 ? codec.kNothing : bytes_of(want[i < kMeshes ? i - 1 : i - kMeshes]), bytes_of(want[i]));
  }
  Bytes record;
  add_varint(record, 0);
  add_varint(record, kClips);
  add_varint(record, kMeshes);
  record.add(encoder.finish());
  const std::uint64_t size = sizeof(format::BoundsHeader) + want.size() * sizeof want[0];
  const Stepped it = step_through({format::kBounds, packed::kCompact, record.all, size});
  ASSERT_EQ(it.status, Status::ok) << it.error.rule;
  EXPECT_EQ(it.steps, 7 + 1) << "100 000 codes of eight numbers, and the checksum";
  EXPECT_EQ(std::memcmp(it.section.data + sizeof(format::BoundsHeader), want.data(), want.size() * sizeof want[0]), 0);
}

// A few bytes that claim more codes, values or frames than they can hold the bits of.
TEST(Steps, ClaimsThatBytesCannotBear) {
  Bytes bounds;
  add_varint(bounds, 0);
  add_varint(bounds, 2000);
  add_varint(bounds, 4000);
  bounds.add(std::vector<std::byte>(8));
  const Stepped many = step_through({format::kBounds, packed::kCompact, bounds.all, 12 + 64'000'000});
  EXPECT_EQ(many.status, Status::bad_data);
  EXPECT_STREQ(many.error.rule, "a count out of range");
  Bytes values;
  values.u8(packed::kClipHasLists | packed::kClipGivesDuration).u8(0).u8(0).u8(30).f32(1);
  values.u8(0).u8(0).u8(0);
  add_varint(values, 4'000'000);
  values.u8(0).u8(0).add(std::vector<std::byte>(8));
  const Stepped list = step_through({format::kClips, packed::kCompact, values.all, 32 + 16'000'000, 65536});
  EXPECT_EQ(list.status, Status::bad_data);
  EXPECT_STREQ(list.error.rule, "a clip that is too short, or larger than a file");
  Bytes frames;
  frames.u8(packed::kClipIsCoded | packed::kClipGivesDuration).u8(0).u8(0).u8(30).f32(1);
  add_varint(frames, 10'000'000);
  add_varint(frames, 10'000'000);
  frames.u8(1).u8(7).add(std::vector<std::byte>(8));
  const Stepped coded = step_through({format::kClips, packed::kCompact, frames.all, 32 + 80'000'000, 65536});
  EXPECT_EQ(coded.status, Status::bad_data);
  EXPECT_STREQ(coded.error.rule, "a clip that is too short, or larger than a file");
  EXPECT_EQ(many.steps + list.steps + coded.steps, 0) << "before any memory is asked for";
}

// A plain record of vertices on two joints each, whose x is their number.
struct PlainMesh {
  std::uint32_t vertices, joints, targets = 0, flags = 0;
  std::vector<int> triangles = {};
  std::vector<std::byte> apart = {};

  template <class JointOf>
  OneRecord record(const JointOf& joint_of) const {
    Bytes b;
    add_varint(b, flags | (targets > 0 ? std::uint32_t{format::kHasMorphTargets} : 0u));
    add_varint(b, vertices);
    add_varint(b, triangles.size() / 3);
    add_varint(b, joints);
    b.u8(2);
    if (targets > 0) add_varint(b, targets);
    if (!apart.empty()) b.u8(2);  // influences of the residual apart
    b.u8(24).f32(0).f32(0).f32(0).f32(1).u8(8);
    b.add(apart);
    for (std::uint32_t t = 0; t < targets; ++t) b.u8(kMorphsPositions).u8(4).f32(0.25f);
    for (const int i : triangles) b.u32(static_cast<std::uint32_t>(i));
    for (std::uint32_t v = 0; v < vertices; ++v) b.u32(v).u32(v % 7).u32(1);
    for (std::uint32_t v = 0; v < vertices; ++v) b.u32(joint_of(v, 0)).u32(joint_of(v, 1));
    for (std::uint32_t v = 0; v < vertices; ++v) b.u32(100);
    for (std::uint32_t t = 0; t < targets; ++t)
      for (std::uint32_t v = 0; v < vertices; ++v) b.u32(8).u32(v / 4 == t ? 10 : 8).u32(8);
    OneRecord out{format::kGeometries, kPlain, b.all, 0};
    GeometryNeeds needs{};
    EXPECT_EQ(measure_geometry_record({b.all.data(), b.all.size()}, needs), nullptr);
    out.scratch_bytes = needs.scratch_bytes;
    out.section_bytes = needs.most_section_bytes;
    return out;
  }
};

// More sets of joints than are sorted at once, without a triangle: runs are by their joints, vertices by their number.
TEST(Steps, OfManySetsOfJoints) {
  const PlainMesh mesh{70'000, 1000};
  const auto joint_of = [](std::uint32_t v, std::uint32_t i) {
    const std::uint32_t low = v * 7919 % 499;
    return i == 0 ? low : 500 + v * 104729 % 500;
  };
  OneRecord record = mesh.record(joint_of);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> runs;
  for (std::uint32_t v = 0; v < mesh.vertices; ++v) runs[{joint_of(v, 0), joint_of(v, 1)}].push_back(v);
  std::uint32_t blocks = 0;
  for (const auto& [set, of] : runs) blocks += (static_cast<std::uint32_t>(of.size()) + 3) / 4;
  format::GeometryHeader h{};
  h.vertex_count = mesh.vertices;
  h.block_count = blocks;
  h.influence_blocks = 2 * blocks;
  h.run_count = static_cast<std::uint32_t>(runs.size());
  h.set_count = 2 * h.run_count;
  h.joint_count = mesh.joints;
  const format::GeometryLayout l = layout(h);
  record.section_bytes = l.bytes;
  const Stepped it = step_through(record);
  ASSERT_EQ(it.status, Status::ok) << it.error.rule;
  EXPECT_GE(it.steps, 16);
  const auto* skin = reinterpret_cast<const float*>(it.section.data + l.skin);
  const auto* run = reinterpret_cast<const marrow::Run*>(it.section.data + l.runs);
  const auto* set = reinterpret_cast<const std::uint16_t*>(it.section.data + l.sets);
  std::size_t wrong = 0;
  for (const auto& [joints, of] : runs) {
    wrong +=
        run->vertex_count != of.size() || run->influences != 2 || set[0] != joints.first || set[1] != joints.second;
    for (std::size_t i = 0; i < (of.size() + 3) / 4 * 4; ++i)
      wrong += skin[i / 4 * 16 + i % 4] != static_cast<float>(of[std::min(i, of.size() - 1)]);
    skin += (of.size() + 3) / 4 * 16;
    ++run;
    set += 2;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(Steps, OfManyTargets) {
  const PlainMesh mesh{2000, 2, 400};
  OneRecord record = mesh.record([](std::uint32_t, std::uint32_t i) { return i; });
  format::GeometryHeader h{};
  h.flags = format::kHasMorphTargets;
  h.vertex_count = mesh.vertices;
  h.block_count = 500;
  h.influence_blocks = 1000;
  h.run_count = 1;
  h.set_count = 2;
  h.joint_count = 2;
  const format::MorphHeader morphs{400, 400, 400, 0};  // each moves one block
  const format::MorphLayout l = layout(morphs, layout(h));
  record.section_bytes = l.bytes;
  const Stepped it = step_through(record);
  ASSERT_EQ(it.status, Status::ok) << it.error.rule;
  EXPECT_GE(it.steps, 5) << "200 000 vertices to count, and to write";
  const auto* const blocks = reinterpret_cast<const std::uint16_t*>(it.section.data + l.blocks);
  const auto* const records = reinterpret_cast<const std::int16_t*>(it.section.data + l.records);
  for (std::size_t t = 0; t < 400; ++t) {
    EXPECT_EQ(blocks[t], t);
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(records[12 * t + i], i / 4 == 1 ? 2 : 0);
  }
}

// Vertices beside nearly all others, each edge with two triangles: those whose numbers add up to 0, twice. To smooth
// them takes edges, not vertices.
TEST(Steps, OfADenseMesh) {
  PlainMesh mesh{753, 2, 0, format::kHasAsResidual | packed::kResidualIsApart};
  for (int a = 0; a < 753; ++a)
    for (int b = a + 1; b < 753; ++b) {
      const int c = (2 * 753 - a - b) % 753;
      if (c > b) mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, b, c});
    }
  Bytes apart;
  apart.u8(30).u8(0xFF).u8(0x3F).f32(0.0625f).f32(0.5f).u8(8).add(std::vector<std::byte>(8));
  mesh.apart = apart.all;
  const Stepped it = step_through(mesh.record([](std::uint32_t, std::uint32_t i) { return i; }));
  EXPECT_EQ(it.status, Status::bad_data) << "the bits are none";
  EXPECT_GE(it.steps, 50) << "two joints, thirty times 753 vertices with 750 neighbours each";
}

// A strip of triangles on two joints, in the order in which its codec gives them; each vertex of the source is the
// first one here, so that the map to them is long, too.
class LargeStrip {
 public:
  static constexpr std::uint32_t kVertices = 360'000, kSource = 300'000;

  LargeStrip() {
    for (std::uint32_t v = 0; v < kVertices; ++v) {
      positions_.insert(positions_.end(), {v, v % 7, 1});
      joints_.push_back(v % 2);
      if (v + 2 < kVertices) indices_.insert(indices_.end(), {v, v + 1, v + 2});
    }
    std::vector<unsigned char> part(meshopt_encodeIndexBufferBound(indices_.size(), kVertices));
    part.resize(meshopt_encodeIndexBuffer(part.data(), part.size(), indices_.data(), indices_.size()));
    EXPECT_EQ(meshopt_decodeIndexBuffer(indices_.data(), indices_.size(), 4, part.data(), part.size()), 0)
        << "it may turn triangles round";
    add_part(part);
    for (const std::vector<std::uint32_t>* const numbers : {&positions_, &joints_}) {
      const std::size_t stride = 4 * numbers->size() / kVertices;
      part.resize(meshopt_encodeVertexBufferBound(kVertices, stride));
      part.resize(meshopt_encodeVertexBuffer(part.data(), part.size(), numbers->data(), kVertices, stride));
      add_part(part);
    }
  }
  OneRecord record(bool by_meshopt) const {
    Bytes b;
    for (const std::size_t n : {std::size_t{format::kHasSourceSlots}, std::size_t{kVertices}, indices_.size() / 3,
                                std::size_t{2}, std::size_t{1}, std::size_t{kSource}})
      add_varint(b, n);
    b.u8(24).f32(0).f32(0).f32(0).f32(1);
    b.add(std::vector<std::byte>(kSource));
    if (by_meshopt) {
      b.add(coded_.all);
    } else {
      for (const std::vector<std::uint32_t>* const numbers : {&indices_, &positions_, &joints_})
        for (const std::uint32_t n : *numbers) b.u32(n);
    }
    GeometryNeeds needs{};
    EXPECT_EQ(measure_geometry_record({b.all.data(), b.all.size()}, needs), nullptr);
    format::GeometryHeader h{};
    h.flags = format::kHasSourceSlots;
    h.vertex_count = kVertices;
    h.source_vertex_count = kSource;
    h.block_count = h.influence_blocks = 2 * (kVertices / 2 / 4);
    h.run_count = h.set_count = h.joint_count = 2;
    h.index_count = static_cast<std::uint32_t>(indices_.size());
    return {format::kGeometries, by_meshopt ? std::uint32_t{packed::kMeshopt} : kPlain, b.all, layout(h).bytes,
            needs.scratch_bytes};
  }

 private:
  void add_part(const std::vector<unsigned char>& part) {
    add_varint(coded_, part.size());
    for (const unsigned char byte : part) coded_.u8(byte);
  }
  std::vector<std::uint32_t> indices_, positions_, joints_;
  Bytes coded_;
};

int decoding_steps(const OneRecord& record, const MeshDecoder& decoder) {
  AlignedBlock scratch(static_cast<std::size_t>(record.scratch_bytes));
  GeometryInWork mesh;
  Status decoded = Status::ok;
  int steps = 0;
  for (bool done = false; !done && steps < 100; ++steps)
    EXPECT_EQ(decode_geometry({record.bytes.data(), record.bytes.size()}, decoder, {scratch.data(), scratch.size()},
                              mesh, decoded, &done),
              nullptr);
  return steps;
}

TEST(Steps, OfALargeMeshByMeshopt) {
  const LargeStrip strip;
  const OneRecord of_numbers = strip.record(false), of_bits = strip.record(true);
  EXPECT_EQ(decoding_steps(of_numbers, kPlainDecoder[0]), 3) << "of its map 131 072 numbers each";
  EXPECT_EQ(decoding_steps(of_bits, meshopt_decoder()), 3 + 2) << "indices and positions are 4 MiB and more";
  const Stepped plain = step_through(of_numbers), coded = step_through(of_bits);
  ASSERT_EQ(plain.status, Status::ok) << plain.error.rule;
  ASSERT_EQ(coded.status, Status::ok) << coded.error.rule;
  EXPECT_EQ(coded.steps, plain.steps + 2);
  ASSERT_EQ(plain.section.size, coded.section.size);
  EXPECT_EQ(std::memcmp(plain.section.data, coded.section.data, coded.section.size), 0);
}

}  // namespace
}  // namespace marrow::test
