// Fuzz target: packed bytes → unpack, by Draco and meshoptimizer → load → every stage. The checksum is made to fit.
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "marrow/unpack.h"
#include "support/aligned.h"
#include "support/pose_file.h"
#include "unpack/packed.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::uint32_t kMostMemory = 16 << 20;  // whoever reads files of strangers sets a limit
  marrow::test::AlignedBlock packed(data, size);
  if (size >= sizeof(marrow::packed::Header)) {
    constexpr std::size_t kBehind = sizeof(marrow::packed::Header);
    const std::uint64_t sum = marrow::format::checksum(packed.data() + kBehind, size - kBehind);
    std::memcpy(packed.data() + offsetof(marrow::packed::Header, checksum), &sum, sizeof sum);
  }
  const marrow::Span<const std::byte> bytes(packed.data(), packed.size());
  const marrow::MeshDecoder decoders[] = {marrow::draco_decoder(), marrow::meshopt_decoder()};
  marrow::UnpackSizes sizes;
  if (marrow::unpack_sizes(bytes, sizes) != marrow::Status::ok || sizes.memory_bytes > kMostMemory) return 0;
  marrow::test::AlignedBlock memory(sizes.memory_bytes);
  marrow::Unpacking unpacking;  // unpack() takes the same steps
  if (marrow::begin_unpack(bytes, {decoders, 2}, {memory.data(), memory.size()}, unpacking) != marrow::Status::ok)
    return 0;
  while (unpacking.file.empty())
    if (marrow::unpack_step(unpacking) != marrow::Status::ok) return 0;
  marrow::File file;
  if (marrow::load(unpacking.file, file) == marrow::Status::ok) marrow::test::exercise(file);
  return 0;
}
