// Fuzz target: bytes → load → every stage. The checksum is made to fit, so that the rules of the format are what is
// tested. What is loaded has palettes of finite numbers, and no input takes long.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "support/aligned.h"
#include "support/pose_file.h"

namespace {

// Of the whole exercise, all clips by all deformers, and a tenth of it for a refusal. Sanitizers take several times as
// long.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(__clang__)
constexpr double kMostSeconds = 1;
#else
constexpr double kMostSeconds = 0.1;
#endif

double processor_s() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void require(bool ok, const char* what) {
  if (ok) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  marrow::test::AlignedBlock block(data, size);
  marrow::test::forge_checksum(block.data(), block.size());
  marrow::File file;
  const double begin_s = processor_s();
  const bool loaded = marrow::load(block, file) == marrow::Status::ok;
  require(processor_s() - begin_s < kMostSeconds / 10, "a block that takes too long to be loaded or refused");
  if (loaded) {
    marrow::test::exercise(file);
    require(marrow::test::has_finite_palettes(file), "a palette that is not finite");
  }
  require(processor_s() - begin_s < kMostSeconds, "an input that takes too long");
  return 0;
}
