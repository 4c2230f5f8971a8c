// Fuzz target: bytes → load → every stage. The checksum is made to fit, so that the rules of the format are what is
// tested.
#include <cstddef>
#include <cstdint>

#include "support/aligned.h"
#include "support/pose_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  marrow::test::AlignedBlock block(data, size);
  marrow::test::forge_checksum(block.data(), block.size());
  marrow::File file;
  if (marrow::load(block, file) == marrow::Status::ok) marrow::test::exercise(file);
  return 0;
}
