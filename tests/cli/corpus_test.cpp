// Bad inputs, collected and mutated: cooked or refused, within bounds of time and memory, and nothing left behind.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/process.h"
#include "support/places.h"

namespace marrow::test {
namespace {

namespace fs = std::filesystem;

// Sanitizers take several times as long and as much; they look for other things.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#else
constexpr bool kIsSanitized = false;
#endif
constexpr double kMostSeconds = 20;  // of processor; 20 000 meshes take half a millisecond each, and machines differ
constexpr std::size_t kMostBytes = 64 << 20, kMostBytesAByte = 32;

std::vector<fs::path> inputs() {
  std::vector<fs::path> out;
  if (!fs::is_directory(corpus_folder())) return out;
  for (const auto& entry : fs::recursive_directory_iterator(corpus_folder())) {
    const std::string kind = entry.path().extension();
    if (kind == ".gltf" || kind == ".glb" || kind == ".mrw") out.push_back(entry.path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

// Of the file and of what it may name: the largest folder that it stands in has them beside it.
std::size_t bytes_of(const fs::path& input) {
  std::size_t bytes = fs::file_size(input), beside = 0;
  for (const auto& entry : fs::directory_iterator(input.parent_path()))
    if (entry.path().extension() == ".bin" && entry.path().stem() == input.stem()) beside += entry.file_size();
  return bytes + beside;
}

TEST(Corpus, EachStaysWithinTimeAndMemory) {
  const std::vector<fs::path> all = inputs();
  if (all.empty()) {
    std::fprintf(stderr, "SKIPPED: no bad inputs at %s; set MARROW_CORPUS\n", corpus_folder().c_str());
    GTEST_SKIP() << "no bad inputs";
  }
  const std::size_t step = in_long_form() && !kIsSanitized ? 1 : 8;
  std::size_t cooked = 0, refused = 0;
  double longest_s = 0, largest = 0;
  for (std::size_t i = 0; i < all.size(); i += step) {
    const TemporaryFolder folder;
    const std::string out = folder / "out.mrw";
    const bool is_source = all[i].extension() != ".mrw";
    const Ran ran = is_source ? run_marrow({"cook", all[i].string(), "-o", out, "--jobs", "2"})
                              : run_marrow({"info", all[i].string()});
    EXPECT_TRUE(ran.code == 0 || (ran.code >= 2 && ran.code <= 5)) << all[i] << ": " << ran.code << ran.err;
    EXPECT_EQ(folder.listing().size(), is_source && ran.code == 0 ? 1u : 0u) << all[i];
    EXPECT_TRUE(kIsSanitized || ran.processor_s <= kMostSeconds) << all[i] << ": " << ran.processor_s << " s";
    EXPECT_TRUE(kIsSanitized || ran.peak_bytes <= kMostBytes + kMostBytesAByte * bytes_of(all[i]))
        << all[i] << ": " << ran.peak_bytes << " bytes of " << bytes_of(all[i]);
    ++(ran.code == 0 ? cooked : refused);
    longest_s = std::max(longest_s, ran.processor_s);
    largest = std::max(largest, static_cast<double>(ran.peak_bytes));
  }
  EXPECT_GT(cooked, 0u);
  EXPECT_GT(refused, 0u);
  std::printf("%zu cooked, %zu refused, at most %.2f s of processor and %.0f MB\n", cooked, refused, longest_s,
              largest / (1 << 20));
}

}  // namespace
}  // namespace marrow::test
