// Fuzz target: what a game has stored of a self-test. The checksum is made to fit.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "asset/format.h"
#include "marrow/gles3_self_test.h"

namespace {

const unsigned char* name_of(unsigned) {
  return reinterpret_cast<const unsigned char*>("a driver");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace gles3 = marrow::gles3;
  std::byte bytes[gles3::kSavedSelfTestBytes];
  constexpr std::size_t kSummed = sizeof(bytes) - sizeof(std::uint64_t);
  const std::size_t given = size < sizeof(bytes) ? size : sizeof(bytes);
  if (given > 0) std::memcpy(bytes, data, given);
  if (given == sizeof(bytes)) {
    const std::uint64_t sum = marrow::format::checksum(bytes, kSummed);
    std::memcpy(bytes + kSummed, &sum, sizeof sum);
  }
  gles3::Api api;
  api.GetString = name_of;
  gles3::SelfTest test;
  gles3::SkinningPath path;
  if (gles3::restore(api, {}, {}, {bytes, given}, test) != marrow::Status::ok) return 0;
  (void)gles3::choose(test, {}, path);
  for (const gles3::PathResult& result : test.paths)
    if (!std::isfinite(result.position_error) || !std::isfinite(result.ns_per_vertex)) std::abort();
  return 0;
}
