// Packed files built by hand, with a codec that stores numbers as they are: what unpacking must give, and what it must
// refuse.
#include <bit>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/file.h"
#include "marrow/unpack.h"
#include "support/aligned.h"
#include "support/fan.h"
#include "support/golden.h"
#include "unpack/geometry.h"
#include "unpack/streams.h"

namespace marrow {
namespace {

using namespace test;

TEST(Unpack, GivesBlocksByHand) {
  const std::vector<std::byte> packed = packed_fan();
  ASSERT_TRUE(is_packed({packed.data(), packed.size()}));
  Unpacked memory;
  File file;
  DataError error;
  ASSERT_EQ(run(packed, memory, file, error), Status::ok) << error.rule << " @" << error.offset;
  const Geometry g = file.mesh(0).geometry;
  ASSERT_EQ(g.vertex_count, 5u);
  ASSERT_EQ(g.slot_count, 8u);
  ASSERT_EQ(g.runs.size, 2u);
  EXPECT_EQ(g.runs[0].vertex_count, 3u);
  EXPECT_EQ(g.runs[0].influences, 1u);
  EXPECT_EQ(g.runs[1].vertex_count, 2u);
  EXPECT_EQ(g.runs[1].influences, 2u);
  EXPECT_EQ(g.sets[0], 1);
  EXPECT_EQ(g.sets[1], 0);
  EXPECT_EQ(g.sets[2], 2);
  // Run 0 holds vertices 0, 2, 4 and 4 again: x = -1 + halves.
  const float skin[] = {-1, 1, 3, 3, 0, 1, 4, 4, 2, 2, 9.5f, 9.5f};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(g.skin[i], skin[i]) << i;
  // Run 1: vertices 1, 3, 3, 3, then the weight of entry 0.
  const float shared[] = {0, 2, 2, 2, 0, 3, 3, 3, 2.5f, 3.5f, 3.5f, 3.5f, 1 / 3.0f, 1 / 3.0f, 1 / 3.0f, 1 / 3.0f};
  for (std::size_t i = 0; i < 16; ++i) EXPECT_FLOAT_EQ(g.skin[12 + i], shared[i]) << i;
  const float normals[] = {1, 0, -1, -1, 0, 1, 0, 0, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 12; ++i) EXPECT_FLOAT_EQ(g.normals[i], normals[i]) << i;
  EXPECT_FLOAT_EQ(g.normals[12 + 8], 1) << "vertex 1 looks along z";
  EXPECT_FLOAT_EQ(g.normals[12 + 5], -1) << "vertex 3 against y";
  EXPECT_FLOAT_EQ(g.uvs[2 * 1], 0.75f) << "vertex 2 is in slot 1";
  EXPECT_FLOAT_EQ(g.uvs[2 * 1 + 1], 2.0f);
  const std::uint16_t indices[] = {0, 4, 1, 0, 1, 5, 0, 5, 2};
  ASSERT_EQ(g.index_count, 9u);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_EQ(static_cast<const std::uint16_t*>(g.indices)[i], indices[i]) << i;
  EXPECT_EQ(g.box_min[0], -1);
  EXPECT_EQ(g.box_max[2], 9.5f);
}

// The fan with two morph targets: the first lifts vertex 3 by a half and lowers vertex 4 by a quarter, the second
// nothing.
std::vector<std::byte> morphed_fan(std::uint32_t targets) {
  Bytes b;
  b.u8(format::kHasNormals | format::kHasUvs | format::kHasMorphTargets).u8(5).u8(3).u8(3).u8(2);
  for (; targets >= 0x80; targets >>= 7) b.u8((targets & 0x7F) | 0x80);
  b.u8(targets);
  return b.all;
}

std::vector<std::byte> fan_with_targets(std::uint32_t targets) {
  const std::vector<std::byte> fan = fan_record();
  constexpr std::size_t kCounts = 5, kQuantisation = 1 + 16 + 1 + 1 + 12 + 1;
  Bytes b;
  b.add(morphed_fan(targets));
  b.add({fan.begin() + kCounts, fan.begin() + kCounts + kQuantisation});
  b.u8(kMorphsPositions).u8(4).f32(0.25f);  // 4 bits: 8 is nothing
  for (std::uint32_t t = 1; t < targets; ++t) b.u8(0);
  b.add({fan.begin() + kCounts + kQuantisation, fan.end()});
  b.numbers({8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 10, 8, 8, 7, 8});
  return b.all;
}

// What unpacking makes of a record alone.
const char* expand(const std::vector<std::byte>& record, std::vector<float>& out, std::uint32_t& bytes) {
  std::vector<float> scratch(65536);
  out.assign(1 << 20, 0.0f);
  Status decoded = Status::ok;
  return unpack_geometry({record.data(), record.size()}, kPlainDecoder[0],
                         {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4},
                         {reinterpret_cast<std::byte*>(out.data()), out.size() * 4}, bytes, decoded);
}

TEST(Unpack, GivesMorphTargetsByHand) {
  std::vector<float> memory;
  std::uint32_t bytes = 0;
  ASSERT_EQ(expand(fan_with_targets(2), memory, bytes), nullptr);
  const auto* const base = reinterpret_cast<const std::byte*>(memory.data());
  format::GeometryHeader g;
  std::memcpy(&g, base, sizeof g);
  format::MorphHeader h;
  std::memcpy(&h, base + format::morph_start(layout(g)), sizeof h);
  EXPECT_EQ(h.target_count, 2u);
  EXPECT_EQ(h.block_count, 2u);
  EXPECT_EQ(h.record_count, 2u);
  const format::MorphLayout l = layout(h, layout(g));
  EXPECT_EQ(bytes, l.bytes);
  const auto* const targets = reinterpret_cast<const MorphTarget*>(base + l.targets);
  EXPECT_EQ(targets[0].attributes, std::uint32_t{kMorphsPositions});
  EXPECT_EQ(targets[0].position_step, 0.25f);
  EXPECT_EQ(targets[1].block_count + targets[1].attributes, 0u);
  const auto* const blocks = reinterpret_cast<const std::uint16_t*>(base + l.blocks);
  EXPECT_EQ(blocks[0], 0) << "vertex 4 in slot 2, and again in slot 3";
  EXPECT_EQ(blocks[1], 1) << "vertex 3 in slots 5 to 7";
  const std::int16_t records[] = {0, 0, 0, 0, 0, 0, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 2, 2, 0, 0, 0, 0};
  for (std::size_t i = 0; i < 24; ++i)
    EXPECT_EQ(reinterpret_cast<const std::int16_t*>(base + l.records)[i], records[i]) << i;
}

TEST(Unpack, ManyEmptyTargetsCostNothing) {
  std::vector<float> memory;
  std::uint32_t bytes = 0;
  // Scratch memory for their streams is claimed, so a file must at least claim to need it.
  EXPECT_STREQ(expand(fan_with_targets(60000), memory, bytes), "memory_bytes too small");
  EXPECT_EQ(expand(fan_with_targets(1000), memory, bytes), nullptr);
}

// Unpacks step by step; counts the steps.
Status run_in_steps(const std::vector<std::byte>& packed, Unpacked& memory, Unpacking& unpacking, int& steps) {
  const Span<const std::byte> bytes(packed.data(), packed.size());
  UnpackSizes sizes;
  Status status = unpack_sizes(bytes, sizes);
  if (status != Status::ok) return status;
  memory = std::make_unique<AlignedBlock>(sizes.memory_bytes);
  status = begin_unpack(bytes, {kPlainDecoder, 1}, {memory->data(), memory->size()}, unpacking);
  for (steps = 0; status == Status::ok && unpacking.file.empty(); ++steps) {
    EXPECT_LE(unpacking.done_bytes, unpacking.total_bytes);
    unpacking = Unpacking(unpacking);  // it may move
    status = unpack_step(unpacking);
  }
  return status;
}

TEST(Unpack, StepsGiveTheSame) {
  for (const std::vector<std::byte>& packed : {packed_fan(), packed_deformers()}) {
    Unpacked memory, stepped;
    File file;
    DataError error;
    ASSERT_EQ(run(packed, memory, file, error), Status::ok);
    Unpacking unpacking;
    int steps = 0;
    ASSERT_EQ(run_in_steps(packed, stepped, unpacking, steps), Status::ok);
    EXPECT_EQ(steps, 4 + 2 + 1) << "four records, two more stages of the mesh, and the checksum";
    ASSERT_EQ(unpacking.file.size, unpacking.total_bytes);
    EXPECT_EQ(unpacking.done_bytes, unpacking.total_bytes);
    EXPECT_EQ(std::memcmp(memory->data(), unpacking.file.data, unpacking.file.size), 0);
    EXPECT_EQ(unpack_step(unpacking), Status::bad_argument) << "done";
    EXPECT_FALSE(unpacking.file.empty());
  }
}

// Two at a time do not meet.
TEST(Unpack, StepsOfTwoFilesMayAlternate) {
  const std::vector<std::byte> packed[] = {packed_fan(), packed_deformers()};
  Unpacking unpacking[2];
  std::vector<std::unique_ptr<AlignedBlock>> memory;
  for (std::size_t i = 0; i < 2; ++i) {
    UnpackSizes sizes;
    ASSERT_EQ(unpack_sizes(packed[i], sizes), Status::ok);
    memory.push_back(std::make_unique<AlignedBlock>(sizes.memory_bytes));
    ASSERT_EQ(begin_unpack(packed[i], {kPlainDecoder, 1}, {memory[i]->data(), memory[i]->size()}, unpacking[i]),
              Status::ok);
  }
  for (int step = 0; step < 7; ++step)
    for (Unpacking& u : unpacking) EXPECT_EQ(unpack_step(u), Status::ok) << step;
  for (std::size_t i = 0; i < 2; ++i) {
    Unpacked whole;
    File file;
    DataError error;
    ASSERT_EQ(run(packed[i], whole, file, error), Status::ok);
    ASSERT_FALSE(unpacking[i].file.empty());
    EXPECT_EQ(std::memcmp(whole->data(), unpacking[i].file.data, unpacking[i].file.size), 0);
  }
}

TEST(Unpack, AStepThatFailsIsTheLast) {
  std::vector<std::byte> record = fan_record();
  record[record.size() - 4 * (9 + 15 + 10 + 10 + 10 + 5)] = std::byte{5};  // the first index
  Unpacked memory;
  Unpacking unpacking;
  int steps = 0;
  EXPECT_EQ(unpack_step(unpacking), Status::bad_argument) << "nothing is begun";
  EXPECT_EQ(run_in_steps(packed_fan(record), memory, unpacking, steps), Status::bad_data);
  EXPECT_EQ(steps, 3) << "the skeleton, decoding, and ordering, which checks";
  EXPECT_TRUE(unpacking.file.empty());
  EXPECT_EQ(unpack_step(unpacking), Status::bad_argument);
}

TEST(Unpack, SaysWhatItLacks) {
  const std::vector<std::byte> packed = packed_fan();
  const Span<const std::byte> bytes(packed.data(), packed.size());
  alignas(16) std::byte memory[4096];
  Span<const std::byte> file;
  DataError error;
  EXPECT_EQ(unpack(bytes, {}, {memory, sizeof memory}, file, &error), Status::unsupported);
  EXPECT_EQ(file.data, nullptr);
  const std::vector<std::byte> draco = packed_fan(fan_record(), packed::kDraco);
  EXPECT_EQ(unpack({draco.data(), draco.size()}, {kPlainDecoder, 1}, {memory, sizeof memory}, file, &error),
            Status::unsupported);
  EXPECT_NE(std::string(error.rule).find("draco_decoder"), std::string::npos) << error.rule;
  File loaded;
  EXPECT_EQ(load(bytes, loaded, &error), Status::unsupported) << "packed files say so to load()";
  EXPECT_NE(std::string(error.rule).find("unpack"), std::string::npos) << error.rule;
  EXPECT_EQ(unpack(bytes, {kPlainDecoder, 1}, {memory, 2048}, file), Status::bad_argument) << "too little memory";
  EXPECT_EQ(unpack(bytes, {kPlainDecoder, 1}, {memory + 4, 4092}, file), Status::bad_argument) << "not aligned";
  const test::AlignedBlock golden = test::golden_copy();
  EXPECT_FALSE(is_packed({golden.data(), golden.size()}));
}

TEST(Unpack, RefusesWhatTheCodecMakesUp) {
  struct Case {
    std::size_t from_end;  // byte of fan_record(), from its end
    std::uint32_t now;
    const char* rule;
  };
  const std::size_t size = fan_record().size();
  const std::size_t indices = size - 4 * (9 + 15 + 10 + 10 + 10 + 5);
  const Case cases[] = {
      {indices, 5, "a triangle has no such vertex"},
      {size - 4 * 15, 3, "a palette entry beyond joint_count"},
      {size - 4 * 5, 4, "weights that sum to more than one"},
      {0, 0x03, "a stream's bits, origin or step out of range"},
      {1, 0, "a count out of range"},
      {3, 0, "joint_count or influences out of range"},
      {4, 9, "joint_count or influences out of range"},
      {5, 0, "a stream's bits, origin or step out of range"},
  };
  std::size_t refused = 0;
  for (const Case& c : cases) {
    std::vector<std::byte> record = fan_record();
    record[c.from_end] = static_cast<std::byte>(c.now);
    Unpacked memory;
    File file;
    DataError error;
    EXPECT_EQ(run(packed_fan(record), memory, file, error), Status::bad_data) << c.rule;
    EXPECT_STREQ(error.rule, c.rule);
    ++refused;
  }
  EXPECT_EQ(refused, std::size(cases));
}

TEST(Unpack, RefusesSizesThatDoNotFit) {
  for (const std::uint32_t extra : {1u, 16u, std::uint32_t(-16)}) {
    Unpacked memory;
    File file;
    DataError error;
    EXPECT_EQ(run(packed_fan(fan_record(), kPlain, extra), memory, file, error), Status::bad_data) << extra;
  }
}

TEST(Unpack, SaysWhatIsDamaged) {
  std::vector<std::byte> packed = packed_fan();
  packed.back() ^= std::byte{1};
  Unpacked memory;
  File file;
  DataError error;
  EXPECT_EQ(run(packed, memory, file, error), Status::bad_checksum);
  EXPECT_EQ(error.offset, 24u) << "where the checksum stands";
  EXPECT_STREQ(error.rule, "checksum of everything behind the header") << "as load() has it";
}

// Header fields are outside the checksum: what they claim is measured by the records, before any memory is.
TEST(Unpack, TellsNoMoreMemoryThanRecordsNeed) {
  const auto sizes_of = [](const std::vector<std::byte>& packed, UnpackSizes& sizes, DataError& error) {
    const AlignedBlock copy(packed.data(), packed.size());
    return unpack_sizes({copy.data(), copy.size()}, sizes, &error);
  };
  for (const std::vector<std::byte>& good : {packed_fan(), packed_deformers()}) {
    UnpackSizes sizes;
    DataError error;
    ASSERT_EQ(sizes_of(good, sizes, error), Status::ok) << error.rule;
    EXPECT_LT(sizes.memory_bytes, 8192u);
    int refused = 0;
    for (std::size_t bit = 8 * 12; bit < 8 * 20; ++bit) {
      std::vector<std::byte> flipped = good;
      flipped[bit / 8] ^= std::byte{1} << bit % 8;
      UnpackSizes other;
      if (sizes_of(flipped, other, error) == Status::ok) {  // a few bytes of file_bytes: unpack() will see
        EXPECT_EQ(other.memory_bytes, sizes.memory_bytes) << bit;
      } else {
        EXPECT_TRUE(error.offset == 12 || error.offset == 16) << bit << " @" << error.offset;
        ++refused;
      }
    }
    EXPECT_GE(refused, 64 - 4);
  }
  UnpackSizes sizes;
  DataError error;
  for (const std::uint32_t extra : {16u, 1u << 20, 1u << 30}) {  // both claims agree
    EXPECT_EQ(sizes_of(packed_fan(fan_record(), kPlain, 0, extra), sizes, error), Status::bad_data) << extra;
    EXPECT_EQ(error.offset, 16u);
    if (extra == 16) continue;
    EXPECT_EQ(sizes_of(packed_fan(fan_record(), kPlain, extra), sizes, error), Status::bad_data) << extra;
    EXPECT_EQ(error.offset, 12u);
  }
}

class UnpackDamaged : public ::testing::TestWithParam<std::vector<std::byte> (*)()> {};
INSTANTIATE_TEST_SUITE_P(Fans, UnpackDamaged,
                         ::testing::Values([] { return packed_fan(); }, [] { return packed_deformers(); }));

TEST_P(UnpackDamaged, EveryPrefixIsRefused) {
  const std::vector<std::byte> packed = GetParam()();
  std::size_t refused = 0;
  for (std::size_t size = 0; size < packed.size(); ++size) {
    std::vector<std::byte> prefix(packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(size));
    Unpacked memory;
    File file;
    DataError error;
    refused += run(prefix, memory, file, error) != Status::ok;
    if (size <= 32) continue;
    const auto stated = static_cast<std::uint32_t>(size);
    std::memcpy(prefix.data() + 8, &stated, sizeof stated);
    forge(prefix);
    ASSERT_NE(run(prefix, memory, file, error), Status::ok) << size;
  }
  EXPECT_EQ(refused, packed.size());
}

TEST_P(UnpackDamaged, EveryChangedByteIsRefusedOrHarmless) {
  const std::vector<std::byte> packed = GetParam()();
  std::size_t changes = 0, caught = 0, loaded = 0;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    for (const std::uint32_t now : {0u, 1u, 127u, 128u, 255u}) {
      std::vector<std::byte> changed = packed;
      if (changed[i] == static_cast<std::byte>(now)) continue;
      changed[i] = static_cast<std::byte>(now);
      Unpacked memory;
      File file;
      DataError error;
      ++changes;
      caught += run(changed, memory, file, error) != Status::ok;
      if (i >= 24 && i < 32) continue;
      UnpackSizes sizes;
      forge(changed);
      // Counts may say more than there is: a game sets a limit.
      if (unpack_sizes({changed.data(), changed.size()}, sizes) == Status::ok && sizes.memory_bytes > 1 << 20) continue;
      loaded += run(changed, memory, file, error) == Status::ok;
    }
  }
  EXPECT_EQ(caught, changes) << "the checksum finds damage";
  EXPECT_GT(loaded, 0u);
  EXPECT_GT(changes, 4 * (packed.size() - 8));
}

}  // namespace
}  // namespace marrow
