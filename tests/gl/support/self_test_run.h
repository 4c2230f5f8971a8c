// A self-test on the driver at hand, or on one that is spoilt.
#pragma once

#include <vector>

#include <gtest/gtest.h>

#include "gl/support/faulty_driver.h"
#include "gl/support/feedback.h"
#include "marrow/gles3_self_test.h"

namespace marrow::test {

using gles3::bit_of;
using gles3::SkinningPath;
using gles3::Verdict;

inline constexpr std::uint32_t kUbo = bit_of(SkinningPath::ubo), kTexture = bit_of(SkinningPath::texture),
                               kFeedback = bit_of(SkinningPath::feedback), kCompute = bit_of(SkinningPath::compute),
                               kCpu = bit_of(SkinningPath::cpu);

struct Outcome {
  Status status = Status::ok;
  gles3::SelfTest test;

  const gles3::PathResult& of(SkinningPath path) const { return test.paths[static_cast<std::size_t>(path)]; }
};

inline Outcome run(const gles3::Api& api, const gles3::Caps& caps, const gles3::SelfTestOptions& options) {
  std::vector<SoaTransform> memory(gles3::self_test_bytes(options) / sizeof(SoaTransform) + 1);
  Outcome out;
  out.status =
      gles3::self_test(api, caps, options,
                       {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)}, out.test);
  return out;
}

// All paths have this verdict that `broken` names, and all others are usable, as far as the context has them.
inline void expect(const Outcome& outcome, std::uint32_t broken, Verdict verdict, const char* what) {
  ASSERT_EQ(outcome.status, Status::ok) << what;
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    const SkinningPath path = static_cast<SkinningPath>(i);
    Verdict expected = (broken & bit_of(path)) != 0 ? verdict : Verdict::usable;
    if (path == SkinningPath::compute && !gl().caps().compute) expected = Verdict::unsupported;
    EXPECT_EQ(outcome.of(path).verdict, expected)
        << what << ": " << to_string(path) << " " << to_string(outcome.of(path).verdict);
  }
  EXPECT_EQ(driver().live, 0) << what;
  EXPECT_EQ(gl().GetError(), 0u) << what;
}

inline gles3::SelfTestOptions one_deformer() {
  gles3::SelfTestOptions options;
  options.as = false;
  return options;
}

}  // namespace marrow::test
