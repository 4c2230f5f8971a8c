// Changes of cooked files that keep to their container: numbers and counts of a section, sections left out, doubled,
// swapped, of another file, longer or shorter, with the table made to fit. The fuzz target makes the checksum fit.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <vector>

#include "fuzz/container.h"
#include "support/golden.h"
#include "support/rig.h"

// libFuzzer's own, where it drives.
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace marrow::test {
namespace {

// A word becomes its neighbour, a corner, another word of the section, or as a float larger, smaller or the other way.
void change_word(Random& random, std::vector<std::byte>& body) {
  if (body.size() < 4) return;
  const std::uint32_t words = static_cast<std::uint32_t>(body.size() / 4);
  // The counts stand in front.
  std::byte* const at =
      body.data() + 4 * std::size_t{random.below(random.below(2) == 0 ? std::min(words, 16u) : words)};
  constexpr std::uint32_t kCorners[] = {0, 1, 4, 255, 0x7FFF, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF};
  constexpr float kFloats[] = {0, 1e-30f, 1e6f, 1e11f, 1e12f, -1e12f, 1e30f, -1, 1e-45f};
  std::uint32_t word = 0;
  std::memcpy(&word, at, 4);
  switch (random.below(5)) {
    case 0:
      word += random.below(2) == 0 ? 1u : ~0u;
      break;
    case 1:
      word = kCorners[random.below(std::size(kCorners))];
      break;
    case 2:
      std::memcpy(&word, body.data() + 4 * std::size_t{random.below(words)}, 4);
      break;
    case 3: {
      const float f = kFloats[random.below(std::size(kFloats))];
      std::memcpy(&word, &f, 4);
      break;
    }
    default: {
      float f = 0;
      std::memcpy(&f, at, 4);
      f *= random.below(2) == 0 ? -1.0f : 1024.0f;
      std::memcpy(&word, &f, 4);
    }
  }
  std::memcpy(at, &word, 4);
}

void change_half(Random& random, std::vector<std::byte>& body) {
  if (body.size() < 2) return;
  std::byte* const at = body.data() + 2 * std::size_t{random.below(static_cast<std::uint32_t>(body.size() / 2))};
  const std::uint16_t half = random.below(2) == 0 ? 0xFFFF : static_cast<std::uint16_t>(random.below(64));
  std::memcpy(at, &half, 2);
}

void change_length(Random& random, std::vector<std::byte>& body) {
  const std::size_t at = random.below(static_cast<std::uint32_t>(body.size() + 1)), count = 4 * (1 + random.below(8));
  if (random.below(2) == 0) {
    body.insert(body.begin() + static_cast<std::ptrdiff_t>(at), count, std::byte{0});
  } else {
    body.erase(body.begin() + static_cast<std::ptrdiff_t>(at),
               body.begin() + static_cast<std::ptrdiff_t>(std::min(body.size(), at + count)));
  }
}

// A section of another file of the project's, in the place of one of its type.
void take_from_another(Random& random, std::vector<Section>& sections, std::size_t at) {
  static const std::vector<Section> others = [] {
    std::vector<Section> all;
    for (AlignedBlock (*copy)() :
         {&golden_copy, &golden_coded_copy, &golden_channels_copy, &golden_pack_copy, &golden_looks_copy,
          &golden_half_joint_copy, &golden_centres_copy, &golden_lod_copy, &golden_limits_copy, &golden_springs_copy,
          &golden_roles_copy, &golden_maps_copy, &golden_graph_copy, &golden_shapes_copy}) {
      const AlignedBlock block = copy();
      for (Section& s : sections_of(block.data(), block.size())) all.push_back(std::move(s));
    }
    return all;
  }();
  for (int attempt = 0; attempt < 32; ++attempt) {
    const Section& other = others[random.below(static_cast<std::uint32_t>(others.size()))];
    if (other.type != sections[at].type) continue;
    sections[at] = other;
    return;
  }
}

void change(Random& random, std::vector<Section>& sections) {
  const std::size_t at = random.below(static_cast<std::uint32_t>(sections.size()));
  const auto here = sections.begin() + static_cast<std::ptrdiff_t>(at);
  const std::uint32_t what = random.below(20);
  if (what < 12) {
    change_word(random, here->body);
  } else if (what < 15) {
    change_half(random, here->body);
  } else if (what == 15) {
    change_length(random, here->body);
  } else if (what == 16) {
    sections.insert(here, Section(*here));
  } else if (what == 17 && sections.size() > 1) {
    sections.erase(here);
  } else if (what == 18) {
    std::swap(*here, sections[random.below(static_cast<std::uint32_t>(sections.size()))]);
  } else {
    take_from_another(random, sections, at);
  }
}

}  // namespace
}  // namespace marrow::test

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  using namespace marrow::test;
  Random random(seed);
  std::vector<Section> sections = sections_of(reinterpret_cast<const std::byte*>(data), size);
  if (LLVMFuzzerMutate != nullptr && (sections.empty() || random.below(4) == 0))
    return LLVMFuzzerMutate(data, size, max_size);
  for (std::uint32_t n = 1 + random.below(4); n > 0 && !sections.empty(); --n) change(random, sections);
  const std::vector<std::byte> out = file_of(sections);
  if (out.size() > max_size) return size;
  std::memcpy(data, out.data(), out.size());
  return out.size();
}
