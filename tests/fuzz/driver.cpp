// Stands in for libFuzzer where there is none: mutates seed files in a fixed pseudo-random way, so that every run is
// the same; half of the time by the target's own mutator, if it has one. The long form has five times as
// many. Usage: TARGET --iterations N SEED…
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/places.h"
#include "support/rig.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" [[gnu::weak]] std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                                             unsigned seed);

namespace {

using Bytes = std::vector<std::uint8_t>;
using marrow::test::Random;

constexpr std::uint32_t kCorners[] = {0,          1,          2,          3,          4,          8,
                                      9,          15,         16,         255,        256,        0x7FFF,
                                      0x8000,     0xFFFF,     0x10000,    0x3FFFFFFF, 0x40000000, 0x7F800000,
                                      0x7FC00000, 0x7FFFFFFF, 0x80000000, 0xFFFFFFF0, 0xFFFFFFFF};

// One change; a file's first 512 bytes, with its tables and counts, are hit as often as all the rest.
void mutate(Random& random, Bytes& bytes) {
  if (bytes.size() < 8) return;
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const std::uint32_t reach = random.below(2) == 0 ? std::min(size, 512u) : size;
  const std::uint32_t at = random.below(reach), word = at & ~3u;
  switch (random.below(6)) {
    case 0:
      bytes[at] = static_cast<std::uint8_t>(bytes[at] ^ 1u << random.below(8));
      break;
    case 1:
      bytes[at] = static_cast<std::uint8_t>(random.bits());
      break;
    case 2:
      bytes[at] = static_cast<std::uint8_t>(bytes[at] + (random.below(2) == 0 ? 1 : 255));
      break;
    case 3:
      if (word + 4 <= size) std::memcpy(&bytes[word], &kCorners[random.below(std::size(kCorners))], 4);
      break;
    case 4:
      if (word + 4 <= size && size >= 4) std::memmove(&bytes[word], &bytes[random.below(size - 3)], 4);
      break;
    default:
      if (random.below(8) == 0) bytes.resize(at);  // cut, with the stated size made to fit
      if (bytes.size() >= 12) {
        const auto stated = static_cast<std::uint32_t>(bytes.size());
        std::memcpy(&bytes[8], &stated, 4);
      }
  }
}

// The target's own way, with room to grow.
void mutate_soundly(Random& random, Bytes& bytes) {
  const std::size_t size = bytes.size();
  bytes.resize(2 * size + 4096);
  bytes.resize(LLVMFuzzerCustomMutator(bytes.data(), size, bytes.size(), random.bits()));
}

Bytes read(const char* path) {
  std::ifstream in(path, std::ios::binary);
  Bytes bytes{std::istreambuf_iterator<char>(in), {}};
  if (bytes.empty()) std::fprintf(stderr, "%s: cannot read, or empty\n", path);
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  unsigned long iterations = 1000, done = 0;
  std::vector<Bytes> seeds;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--iterations") == 0 && i + 1 < argc) {
      iterations = std::strtoul(argv[++i], nullptr, 10);
    } else {
      seeds.push_back(read(argv[i]));
      if (seeds.back().empty()) return 1;
    }
  }
  if (seeds.empty() || iterations == 0) {
    std::fputs("usage: TARGET --iterations N SEED...\n", stderr);
    return 1;
  }
  for (const Bytes& seed : seeds) LLVMFuzzerTestOneInput(seed.data(), seed.size());
  if (marrow::test::in_long_form()) iterations *= 5;
  Random random(1);
  const auto begin = std::chrono::steady_clock::now();
  for (; done < iterations; ++done) {
    Bytes bytes = seeds[done % seeds.size()];
    if (LLVMFuzzerCustomMutator != nullptr && done % 2 == 1) {
      mutate_soundly(random, bytes);
    } else {
      for (std::uint32_t n = 1 + random.below(4); n > 0; --n) mutate(random, bytes);
    }
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  const std::chrono::duration<double> spent_s = std::chrono::steady_clock::now() - begin;
  std::printf("%lu mutants of %zu seeds in %.1f s, no complaint\n", done, seeds.size(), spent_s.count());
  return 0;
}
