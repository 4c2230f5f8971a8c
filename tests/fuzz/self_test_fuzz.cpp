// Fuzz target: stored bytes of a self-test → restore. As they are, and as save() would have written them.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "gl/misuse/paper_driver.h"
#include "gles3/self_test/self_test_key.h"
#include "marrow/gles3_self_test.h"

namespace {

using namespace marrow;
using namespace marrow::gles3;

// Whatever is restored can be chosen from.
void try_bytes(const Api& api, Span<const std::byte> bytes) {
  SelfTest out;
  if (restore(api, {}, {}, bytes, out) != Status::ok) return;
  SkinningPath path = SkinningPath::cpu;
  (void)choose(out, {}, path);
  if (path > SkinningPath::cpu) std::abort();
  for (const PathResult& result : out.paths)
    if (*to_string(result.verdict) == '\0') std::abort();
  for (const PathResult& result : out.paths)
    if (!std::isfinite(result.position_error + result.normal_error + result.ns_per_vertex)) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Api api = marrow::test::paper_api();
  const auto* const bytes = reinterpret_cast<const std::byte*>(data);
  try_bytes(api, {bytes, size});
  SelfTest test;
  test.key = self_test_key(api, {}, {});
  std::memcpy(test.paths, data, size < sizeof test.paths ? size : sizeof test.paths);
  std::byte saved[kSavedSelfTestBytes];
  if (save(test, saved) != Status::ok) std::abort();
  try_bytes(api, saved);
  return 0;
}
