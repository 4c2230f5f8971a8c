// Which path is taken of those that work, and what is kept of a self-test from one start to the next.
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "gles3/self_test/self_test_key.h"
#include "marrow/gles3_self_test.h"

namespace marrow::test {
namespace {

using gles3::SkinningPath;
using gles3::Verdict;

gles3::SelfTest usable(std::uint32_t paths, gles3::GpuFamily family = gles3::GpuFamily::other) {
  gles3::SelfTest out;
  out.family = family;
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i)
    out.paths[i].verdict = (paths >> i & 1) != 0 ? Verdict::usable : Verdict::wrong;
  return out;
}

// The tables of docs/gles/paths.md, word by word.
TEST(SelfTestResult, ThePathIsTheFirstOfTheTable) {
  struct Row {
    gles3::PathNeed need;
    const char* order;
    gles3::GpuFamily family = gles3::GpuFamily::other;
  };
  const Row rows[] = {{{1, 1, 341}, "ubo texture compute feedback cpu"},
                      {{1, 7, 0}, "ubo texture compute feedback cpu"},
                      {{2, 1, 341}, "compute feedback ubo texture cpu"},
                      {{5, 7, 1}, "compute feedback ubo texture cpu"},
                      {{1, 8, 341}, "texture ubo compute feedback cpu"},
                      {{1, 1000, 20}, "texture ubo compute feedback cpu"},
                      {{2, 8, 341}, "texture compute feedback ubo cpu"},
                      {{1, 1, 342}, "texture cpu"},
                      {{3, 1, 342}, "texture cpu"},
                      {{1, 8, 1000}, "texture cpu"},
                      {{3, 8, 32767}, "texture cpu"},
                      {{1, 1, 341}, "texture compute feedback ubo cpu", gles3::GpuFamily::mali_g},
                      {{2, 1, 341}, "texture compute feedback ubo cpu", gles3::GpuFamily::mali_g},
                      {{1, 99, 341}, "texture compute feedback ubo cpu", gles3::GpuFamily::mali_g},
                      {{1, 1, 342}, "texture cpu", gles3::GpuFamily::mali_g}};
  for (const Row& row : rows)
    for (std::uint32_t paths = 0; paths < 32; ++paths) {
      std::string expected;
      const std::string order = row.order;
      for (std::size_t at = 0; at < order.size() && expected.empty();) {
        const std::size_t end = std::min(order.find(' ', at), order.size());
        const std::string name = order.substr(at, end - at);
        for (std::uint32_t i = 0; i < gles3::kPathCount; ++i)
          if (name == to_string(static_cast<SkinningPath>(i)) && (paths >> i & 1) != 0) expected = name;
        at = end + 1;
      }
      SkinningPath path = SkinningPath::feedback;
      const Status status = gles3::choose(usable(paths, row.family), row.need, path);
      EXPECT_EQ(status, expected.empty() ? Status::unsupported : Status::ok);
      EXPECT_EQ(to_string(path), expected.empty() ? "feedback" : expected) << row.order << ", usable " << paths;
    }
}

TEST(SelfTestResult, MeasuredTimesWin) {
  gles3::SelfTest test = usable(31);
  const auto chosen = [&](const gles3::PathNeed& need) {
    SkinningPath path = SkinningPath::cpu;
    EXPECT_EQ(gles3::choose(test, need, path), Status::ok);
    return std::string(to_string(path));
  };
  // ubo, texture, feedback, compute: a pass, and each more
  const float ns[4][2] = {{10, 10}, {8, 8}, {25, 2}, {30, 1}};
  for (std::size_t i = 0; i < 4; ++i) {
    test.paths[i].ns_per_vertex = ns[i][0];
    test.paths[i].ns_per_pass = ns[i][1];
  }
  EXPECT_EQ(chosen({1, 1, 20}), "texture");
  EXPECT_EQ(chosen({3, 1, 20}), "texture") << "24 against 29";
  EXPECT_EQ(chosen({4, 1, 20}), "feedback") << "31, 32, 33: compute is within 5 % of 31, but second in the table";
  test.paths[3].ns_per_vertex = 27;
  EXPECT_EQ(chosen({4, 1, 20}), "compute") << "30: first in the table, and nothing is 5 % faster";
  test.paths[1].ns_per_vertex = 9.6f;
  EXPECT_EQ(chosen({1, 1, 20}), "ubo") << "texture is not 5 % faster";
  EXPECT_EQ(chosen({1, 8, 20}), "texture") << "of many it comes first";
  test.paths[4].ns_per_vertex = 0.1f;
  EXPECT_EQ(chosen({1, 1, 20}), "ubo") << "the CPU's time is another's";
  test.paths[2].ns_per_vertex = 0;
  EXPECT_EQ(chosen({2, 1, 20}), "compute") << "feedback was not timed: the table alone";
  test.paths[2].verdict = Verdict::slow;
  EXPECT_EQ(chosen({1, 1, 20}), "ubo");
}

TEST(SelfTestResult, NothingIsChosenBeforeATest) {
  SkinningPath path = SkinningPath::compute;
  EXPECT_EQ(gles3::choose(gles3::SelfTest{}, {}, path), Status::unsupported);
  EXPECT_EQ(path, SkinningPath::compute);
}

TEST(SelfTestResult, EveryVerdictHasAReason) {
  std::set<std::string> reasons;
  for (std::uint32_t i = 0; i < gles3::kVerdictCount; ++i) reasons.insert(to_string(static_cast<Verdict>(i)));
  EXPECT_EQ(reasons.size(), gles3::kVerdictCount);
  EXPECT_STREQ(to_string(Verdict::usable), "usable");
  EXPECT_STREQ(to_string(Verdict::crashed), "crashed when last tried");
}

const char* strings[3] = {};  // vendor, renderer, version
gles3::Api named_driver() {
  strings[0] = "Somebody";
  strings[1] = "Shader Core 7";
  strings[2] = "OpenGL ES 3.2 build 4711";
  gles3::Api api;
  api.GetString = [](unsigned name) { return reinterpret_cast<const unsigned char*>(strings[name - 0x1F00]); };
  return api;
}

// A result and all that it depends on.
struct Kept {
  gles3::Api api = named_driver();
  gles3::Caps caps;
  gles3::SelfTestOptions options;
  gles3::SelfTest test;
  std::byte bytes[gles3::kSavedSelfTestBytes];

  Status restore(gles3::SelfTest& out) const { return gles3::restore(api, caps, options, {bytes, sizeof(bytes)}, out); }
};

template <class Function>
struct Nothing;
template <class Result, class... Arguments>
struct Nothing<gles3::Entry<Result(Arguments...)>> {
  static Result call(Arguments...) { return Result(); }
};

// A driver whose functions do nothing but read back what was cleared.
unsigned cleared = 0;
gles3::Api hollow_driver() {
  gles3::Api api = named_driver();
#define MARROW_HOLLOW(Result, Name, Parameters) \
  if (api.Name == nullptr) api.Name = Nothing<decltype(gles3::Api::Name)>::call;
  MARROW_GLES3_FUNCTIONS(MARROW_HOLLOW)
#undef MARROW_HOLLOW
  api.CheckFramebufferStatus = [](unsigned) { return 0x8CD5u; };
  api.ClearBufferuiv = [](unsigned, int, const unsigned* value) { cleared = *value; };
  api.ReadPixels = [](int, int, int width, int height, unsigned, unsigned, void* out) {
    for (int i = 0; i < 4 * width * height; ++i) static_cast<unsigned*>(out)[i] = cleared;
  };
  return api;
}

TEST(SelfTestResult, KnowsChipsByTheirNames) {
  struct Name {
    const char* renderer;
    gles3::GpuFamily family;
  };
  const Name names[] = {{"Mali-G57 MC2", gles3::GpuFamily::mali_g},
                        {"Mali-G52 r1 (Panfrost)", gles3::GpuFamily::mali_g},
                        {"Immortalis-G715", gles3::GpuFamily::mali_g},
                        {"ANGLE (ARM, Vulkan 1.1.0 (Mali-G77), ARM)", gles3::GpuFamily::mali_g},
                        {"Mali-T860", gles3::GpuFamily::mali_t},
                        {"Mali-400 MP", gles3::GpuFamily::other},
                        {"Mali-", gles3::GpuFamily::other},
                        {"Adreno (TM) 640", gles3::GpuFamily::adreno},
                        {"ANGLE (Qualcomm, Adreno (TM) 650, OpenGL ES 3.2)", gles3::GpuFamily::adreno},
                        {"FD660", gles3::GpuFamily::adreno},
                        {"AMD FD", gles3::GpuFamily::other},
                        {"NVIDIA GeForce RTX 3060/PCIe/SSE2", gles3::GpuFamily::nvidia},
                        {"GeForce GTX 1080/PCIe/SSE2", gles3::GpuFamily::nvidia},
                        {"NVIDIA Tegra", gles3::GpuFamily::nvidia},
                        {"ANGLE (NVIDIA, Vulkan 1.3.0 (NVIDIA GeForce MX450), NVIDIA)", gles3::GpuFamily::nvidia},
                        {"V3D 4.2", gles3::GpuFamily::other},
                        {"", gles3::GpuFamily::other},
                        {nullptr, gles3::GpuFamily::other}};
  gles3::Api api = hollow_driver();
  for (const Name& name : names) {
    strings[1] = name.renderer;
    gles3::SelfTestOptions options;
    options.paths = 0;
    gles3::SelfTest test;
    std::vector<SoaTransform> memory(gles3::self_test_bytes(options) / sizeof(SoaTransform) + 1);
    ASSERT_EQ(
        gles3::self_test(api, {}, options,
                         {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)}, test),
        Status::ok);
    EXPECT_EQ(test.family, name.family) << (name.renderer != nullptr ? name.renderer : "nothing");
  }
}

Kept kept() {
  Kept out;
  out.api = hollow_driver();
  out.options.crashed = gles3::bit_of(SkinningPath::feedback);
  std::vector<SoaTransform> memory(gles3::self_test_bytes(out.options) / sizeof(SoaTransform) + 1);
  EXPECT_EQ(
      gles3::self_test(out.api, out.caps, out.options,
                       {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(SoaTransform)}, out.test),
      Status::ok);
  out.test.paths[0] = {Verdict::usable, 0.25f, 0.5f, 12, 3};
  out.test.family = gles3::GpuFamily::mali_g;
  EXPECT_EQ(gles3::save(out.test, {out.bytes, sizeof(out.bytes)}), Status::ok);
  return out;
}

TEST(SelfTestResult, ComesBackFromItsBytes) {
  const Kept k = kept();
  gles3::SelfTest out;
  ASSERT_EQ(k.restore(out), Status::ok);
  const Verdict expected[] = {Verdict::usable, Verdict::refused, Verdict::crashed, Verdict::unsupported,
                              Verdict::refused};
  for (std::size_t i = 0; i < gles3::kPathCount; ++i) EXPECT_EQ(out.paths[i].verdict, expected[i]) << i;
  EXPECT_EQ(out.paths[0].position_error, 0.25f);
  EXPECT_EQ(out.paths[0].normal_error, 0.5f);
  EXPECT_EQ(out.paths[0].ns_per_vertex, 12.0f);
  EXPECT_EQ(out.paths[0].ns_per_pass, 3.0f);
  EXPECT_EQ(out.family, gles3::GpuFamily::mali_g);
  EXPECT_EQ(out.key, k.test.key);
  std::byte shorter[gles3::kSavedSelfTestBytes - 1];
  EXPECT_EQ(gles3::save(k.test, {shorter, sizeof(shorter)}), Status::bad_argument);
}

TEST(SelfTestResult, HoldsForOneDriverAndOneQuestion) {
  Kept k = kept();
  const auto refuses = [&](const char* what, const std::function<void(Kept&)>& change) {
    Kept other = k;
    change(other);
    gles3::SelfTest out;
    EXPECT_EQ(other.restore(out), Status::mismatch) << what;
    EXPECT_EQ(out.key, 0u) << "written on failure";
  };
  const char* const others[3] = {"Somebody else", "Shader Core 8", "OpenGL ES 3.2 build 4712"};
  for (int i = 0; i < 3; ++i) {
    const char* const before = strings[i];
    refuses("another driver", [&](Kept&) { strings[i] = others[i]; });
    refuses("a driver without a name", [&](Kept&) { strings[i] = nullptr; });
    strings[i] = before;
  }
  refuses("paths", [](Kept& o) { o.options.paths = 3; });
  refuses("crashed", [](Kept& o) { o.options.crashed = 0; });
  refuses("ssd", [](Kept& o) { o.options.ssd = false; });
  refuses("as", [](Kept& o) { o.options.as = false; });
  refuses("timed", [](Kept& o) { o.options.seconds = [](void*) { return 0.0; }; });
  refuses("compute", [](Kept& o) { o.caps.compute = true; });
  refuses("alignment", [](Kept& o) { o.caps.uniform_offset_alignment = 64; });
  refuses("block", [](Kept& o) { o.caps.uniform_block_bytes = 65536; });
  refuses("attributes", [](Kept& o) { o.caps.vertex_attributes = 32; });
  refuses("texture", [](Kept& o) { o.caps.texture_size = 4096; });
  gles3::SelfTest out;
  EXPECT_EQ(k.restore(out), Status::ok) << "as it was";
}

TEST(SelfTestResult, DamageIsNoticed) {
  Kept k = kept();
  gles3::SelfTest out;
  for (std::size_t bit = 0; bit < 8 * sizeof(k.bytes); ++bit) {
    const auto flip = std::byte(1u << bit % 8);
    k.bytes[bit / 8] ^= flip;
    const Status status = k.restore(out);
    EXPECT_EQ(status, bit < 32 ? Status::bad_magic : bit < 64 ? Status::bad_version : Status::bad_checksum) << bit;
    k.bytes[bit / 8] ^= flip;
  }
  for (std::size_t size = 0; size < sizeof(k.bytes); ++size)
    EXPECT_EQ(gles3::restore(k.api, k.caps, k.options, {k.bytes, size}, out), Status::truncated);
  EXPECT_EQ(out.key, 0u) << "written on failure";
}

// Bytes that somebody has made up.
TEST(SelfTestResult, NonsenseIsRefused) {
  const Kept good = kept();
  const auto restored = [&](std::size_t at, auto value) {
    Kept k = good;
    std::memcpy(k.bytes + at, &value, sizeof(value));
    const std::uint64_t sum = format::checksum(k.bytes, sizeof(k.bytes) - 8);
    std::memcpy(k.bytes + sizeof(k.bytes) - 8, &sum, sizeof(sum));
    gles3::SelfTest out;
    return k.restore(out);
  };
  constexpr std::size_t kVerdict = 16, kNumber = 20;  // of the first path
  EXPECT_EQ(restored(kVerdict, gles3::kVerdictCount - 1), Status::ok);
  EXPECT_EQ(restored(kVerdict, gles3::kVerdictCount), Status::bad_data);
  EXPECT_EQ(restored(kVerdict, 256u), Status::bad_data);
  EXPECT_EQ(restored(kNumber, 3.0f), Status::ok);
  EXPECT_EQ(restored(kNumber, -3.0f), Status::bad_data);
  EXPECT_EQ(restored(kNumber + 4, std::numeric_limits<float>::quiet_NaN()), Status::bad_data);
  EXPECT_EQ(restored(kNumber + 8, std::numeric_limits<float>::infinity()), Status::bad_data);
  EXPECT_EQ(restored(kNumber + 12, -1.0f), Status::bad_data);
  constexpr std::size_t kFamily = 116;
  EXPECT_EQ(restored(kFamily, gles3::kGpuFamilyCount - 1), Status::ok);
  EXPECT_EQ(restored(kFamily, gles3::kGpuFamilyCount), Status::bad_data);
}

}  // namespace
}  // namespace marrow::test
