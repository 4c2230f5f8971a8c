// Unpacking reads only what it has decoded: whatever memory held before, the same comes of it, and codecs are told
// nothing of it.
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "draco/skin_codec.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "support/fan.h"
#include "support/golden.h"
#include "support/places.h"
#include "support/ring.h"
#include "unpack/clip/bounds_codec.h"
#include "unpack/clip/list_codec.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// What arithmetic goes wrong with most: no number, the least number, all bits.
constexpr std::uint32_t kPatterns[] = {0, 0x80000000, 0xFFFFFFFF, 0x7FFFFFFF, 0x7FC00000};

void fill(void* to, std::size_t bytes, std::uint32_t pattern) {
  for (std::size_t i = 0; i < bytes; ++i)
    static_cast<std::byte*>(to)[i] = static_cast<std::byte>(pattern >> 8 * (i % 4));
}

std::vector<std::byte> read_bytes(const std::string& path) {
  std::vector<std::byte> out(static_cast<std::size_t>(fs::file_size(path)));
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(out.data()), static_cast<long>(out.size()));
  return out;
}

// Whole and step by step, the state elsewhere at each.
std::vector<std::byte> unpacked_over(const std::vector<std::byte>& packed, std::uint32_t pattern, bool in_steps) {
  const MeshDecoder decoders[] = {draco_decoder(), meshopt_decoder(), kPlainDecoder[0]};
  const AlignedBlock bytes(packed.data(), packed.size());
  const Span<const std::byte> span(bytes.data(), bytes.size());
  UnpackSizes sizes;
  EXPECT_EQ(unpack_sizes(span, sizes), Status::ok);
  AlignedBlock memory(sizes.memory_bytes);
  fill(memory.data(), memory.size(), pattern);
  Span<const std::byte> file;
  if (in_steps) {
    auto work = std::make_unique<Unpacking>();
    EXPECT_EQ(begin_unpack(span, {decoders, 3}, {memory.data(), memory.size()}, *work), Status::ok);
    for (Status status = Status::ok; work->file.empty() && status == Status::ok;) {
      auto moved = std::make_unique<Unpacking>(*work);
      fill(work.get(), sizeof(Unpacking), pattern);
      work = std::move(moved);
      status = unpack_step(*work);
      EXPECT_EQ(status, Status::ok);
    }
    file = work->file;
  } else {
    EXPECT_EQ(unpack(span, {decoders, 3}, {memory.data(), memory.size()}, file), Status::ok);
  }
  return {file.begin(), file.end()};
}

TEST(MemoryPatterns, AreNeverRead) {
  std::vector<std::pair<std::string, std::vector<std::byte>>> files = {
      {"fan", packed_fan()}, {"deformers", packed_deformers()}, {"ring", packed_fan(ring_record())}};
  const AlignedBlock golden = golden_packed_copy();
  files.emplace_back("golden", std::vector<std::byte>(golden.data(), golden.data() + golden.size()));
  int seeds = 0;
  for (const auto& entry : fs::directory_iterator(in_source("tests/fuzz/seeds"))) {
    if (entry.path().extension() != ".mrw") continue;
    files.emplace_back(entry.path().filename(), read_bytes(entry.path()));
    ++seeds;
  }
  EXPECT_GE(seeds, 10) << "of both codecs, with morphs, residuals, helpers, limits and packed clips";
  for (const auto& [name, packed] : files) {
    if (name == "ring") continue;  // its section is another size: below
    ASSERT_TRUE(is_packed({packed.data(), packed.size()})) << name;
    const std::vector<std::byte> want = unpacked_over(packed, kPatterns[0], false);
    const AlignedBlock block(want.data(), want.size());
    File file;
    EXPECT_EQ(load({block.data(), block.size()}, file), Status::ok) << name;
    for (const std::uint32_t pattern : kPatterns)
      for (const bool in_steps : {false, true})
        EXPECT_TRUE(unpacked_over(packed, pattern, in_steps) == want) << name << ' ' << pattern << ' ' << in_steps;
  }
  const std::vector<std::byte> ring = ring_record();
  std::vector<std::byte> first;
  for (const std::uint32_t pattern : kPatterns) {
    GeometryNeeds needs{};
    ASSERT_EQ(measure_geometry_record({ring.data(), ring.size()}, needs), nullptr);
    AlignedBlock scratch(needs.scratch_bytes), section(needs.most_section_bytes);
    fill(scratch.data(), scratch.size(), pattern);
    fill(section.data(), section.size(), pattern);
    std::uint32_t bytes = 0;
    Status decoded = Status::ok;
    ASSERT_EQ(unpack_geometry({ring.data(), ring.size()}, kPlainDecoder[0], {scratch.data(), scratch.size()},
                              {section.data(), section.size()}, bytes, decoded),
              nullptr);
    const std::vector<std::byte> got(section.data(), section.data() + bytes);
    if (first.empty()) first = got;
    EXPECT_TRUE(got == first) << pattern;
  }
}

// A decoder that keeps what it is told that an encoder would write.
struct Watched : SymbolDecoder {
  using SymbolDecoder::SymbolDecoder;
  std::uint32_t symbol(SymbolModel& model, std::uint32_t wanted) {
    told.push_back(wanted);
    return SymbolDecoder::symbol(model, wanted);
  }
  std::uint32_t raw_bits(std::uint32_t count, std::uint32_t wanted) {
    told.push_back(wanted);
    return SymbolDecoder::raw_bits(count, wanted);
  }
  bool bit(BitModel& model, bool wanted) {
    told.push_back(wanted ? 1 : 0);
    return SymbolDecoder::bit(model, wanted);
  }
  bool even_bit(bool wanted) { return raw_bits(1, wanted ? 1 : 0) != 0; }
  std::vector<std::uint32_t> told;
};

// Calls run(decoder, pattern), which gives what it has decoded, for bits of chance and each pattern; the same must come
// of all, by the same words.
template <class Run>
void expect_nothing_told(const Run& run) {
  std::mt19937 random(11);
  std::size_t told = 0;
  for (int round = 0; round < 200; ++round) {
    std::vector<std::byte> bits(200);
    for (std::byte& b : bits) b = static_cast<std::byte>(random());
    std::vector<std::uint32_t> words;
    std::vector<std::byte> made;
    for (const std::uint32_t pattern : kPatterns) {
      Watched decoder({bits.data(), bits.size()});
      const std::vector<std::byte> out = run(decoder, pattern);
      if (pattern == kPatterns[0]) {
        words = decoder.told;
        made = out;
      }
      EXPECT_TRUE(decoder.told == words) << round << ' ' << pattern;
      EXPECT_TRUE(out == made) << round << ' ' << pattern;
      told += decoder.told.size();
    }
  }
  EXPECT_GT(told, 5000u);
}

template <class T>
void append(std::vector<std::byte>& out, const T* first, std::size_t count) {
  const auto* const bytes = reinterpret_cast<const std::byte*>(first);
  out.insert(out.end(), bytes, bytes + count * sizeof(T));
}

TEST(MemoryPatterns, SkinsAreToldNothing) {
  constexpr std::uint32_t kVertices = 40, kInfluences = 3;
  std::vector<std::int32_t> positions(3 * kVertices), joints(kInfluences * kVertices),
      weights((kInfluences - 1) * kVertices);
  for (std::uint32_t v = 0; v < kVertices; ++v) positions[3 * v] = static_cast<std::int32_t>(v - v % 7 / 6);  // twins
  std::vector<std::uint32_t> indices;
  for (std::uint32_t v = 0; v + 2 < kVertices; ++v) indices.insert(indices.end(), {v, v + 1, v + 2});
  Stream streams[3];
  streams[0] = {StreamKind::position, 3, 8, 0, 0, {}, 1, positions.data()};
  streams[1] = {StreamKind::joints, kInfluences, 15, 0, 0, {}, 1, joints.data()};
  streams[2] = {StreamKind::weights, kInfluences - 1, 10, 0, 0, {}, 1, weights.data()};
  MeshStreams mesh;
  mesh.vertex_count = kVertices;
  mesh.triangle_count = kVertices - 2;
  mesh.joint_count = 9;
  mesh.influences = kInfluences;
  mesh.indices = indices.data();
  mesh.streams = streams;
  mesh.stream_count = 3;
  const SkinBefore before(mesh);
  expect_nothing_told([&](Watched& decoder, std::uint32_t pattern) {
    fill(joints.data(), joints.size() * 4, pattern);
    fill(weights.data(), weights.size() * 4, pattern);
    const auto models = std::make_unique<SkinModels>();
    models->begin();
    SkinCodec<Watched> codec(mesh, before, *models, decoder);
    std::uint32_t v = 0;
    while (v < kVertices && codec.code(v)) ++v;
    std::vector<std::byte> out;
    append(out, joints.data(), std::size_t{v} * kInfluences);
    append(out, weights.data(), std::size_t{v} * (kInfluences - 1));
    return out;
  });
}

TEST(MemoryPatterns, ListsAreToldNothing) {
  expect_nothing_told([](Watched& decoder, std::uint32_t pattern) {
    const auto models = std::make_unique<ListModels>();
    models->begin();
    ListCodec<Watched> codec(*models, decoder);
    Track tracks[8];
    Channel channels[8];
    float values[24];
    fill(tracks, sizeof tracks, pattern);
    fill(channels, sizeof channels, pattern);
    fill(values, sizeof values, pattern);
    for (Track& t : tracks) codec.code_track(t);
    for (Channel& c : channels) codec.code_channel(c);
    const bool fits = codec.code_values({0, 24, 4, true}, {}, values);
    std::vector<std::byte> out;
    append(out, tracks, 8);
    append(out, channels, 8);
    if (fits) append(out, values, 24);
    return out;
  });
}

TEST(MemoryPatterns, BoundsAreToldNothing) {
  expect_nothing_told([](Watched& decoder, std::uint32_t pattern) {
    BoundsCodec<Watched> codec;
    std::vector<std::byte> codes(10 * codec.kBytes);
    fill(codes.data(), codes.size(), pattern);
    for (std::size_t i = 0; i < 10; ++i)
      codec.code(decoder, i > 0 ? codes.data() + (i - 1) * codec.kBytes : codec.kNothing,
                 codes.data() + i * codec.kBytes);
    return codes;
  });
}

}  // namespace
}  // namespace marrow::test
