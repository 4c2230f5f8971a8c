// What the self-test found: which path to take, and bytes to keep.
#include <cstring>

#include "asset/format.h"
#include "core/builtins.h"
#include "core/check.h"
#include "gles3/gl_constants.h"
#include "gles3/palettes.h"
#include "gles3/self_test/self_test_key.h"

namespace marrow::embedded {
extern const unsigned char shader_skin[], shader_preskin_vert[], shader_preskin_comp[], shader_self_test_vert[],
    shader_self_test_frag[];
}

namespace marrow::gles3 {
namespace {

// Which path is likely to be better, the best first; docs/decisions.md says why.
constexpr SkinningPath kUbo = SkinningPath::ubo, kTexture = SkinningPath::texture, kFeedback = SkinningPath::feedback,
                       kCompute = SkinningPath::compute, kCpu = SkinningPath::cpu;
constexpr SkinningPath kFew[2][kPathCount] = {{kUbo, kTexture, kCompute, kFeedback, kCpu},
                                              {kCompute, kFeedback, kUbo, kTexture, kCpu}};  // several passes
constexpr SkinningPath kMany[2][kPathCount] = {{kTexture, kUbo, kCompute, kFeedback, kCpu},
                                               {kTexture, kCompute, kFeedback, kUbo, kCpu}};
constexpr SkinningPath kMaliG[kPathCount] = {kTexture, kCompute, kFeedback, kUbo, kCpu};
constexpr float kAlike = 0.95f;

Span<const SkinningPath> order_of(GpuFamily family, const PathNeed& need) {
  const std::size_t several = need.passes > 1 ? 1 : 0;
  if (family == GpuFamily::mali_g) return kMaliG;
  return need.characters >= kManyCharacters ? kMany[several] : kFew[several];
}

bool can_take(const SelfTest& test, const PathNeed& need, SkinningPath path) {
  const bool has_room = path == kTexture || path == kCpu || need.joints <= kPaletteJoints;
  return has_room && test.paths[static_cast<std::size_t>(path)].verdict == Verdict::usable;
}

constexpr std::uint32_t kSavedMagic = 0x53544D4Du;
// To be raised when the test does something else.
constexpr std::uint32_t kSavedVersion = 2;

struct SavedPath {
  std::uint32_t verdict;
  float numbers[4];
};
struct SavedSelfTest {
  std::uint32_t magic, version;
  std::uint64_t key;
  SavedPath paths[kPathCount];
  std::uint32_t family;
  std::uint64_t checksum;  // of what stands before
};
static_assert(sizeof(SavedSelfTest) == kSavedSelfTestBytes);

std::uint64_t checksum_of(const SavedSelfTest& saved) {
  return format::checksum(reinterpret_cast<const std::byte*>(&saved), offsetof(SavedSelfTest, checksum));
}

std::uint64_t hash_of(const unsigned char* text) {
  if (text == nullptr) return 0;
  return format::checksum(reinterpret_cast<const std::byte*>(text), std::strlen(reinterpret_cast<const char*>(text)));
}

bool is_good(const SavedPath& saved) {
  bool good = saved.verdict < kVerdictCount;
  for (const float number : saved.numbers) good = good && number >= 0 && number < 1e12f;
  return good;
}

}  // namespace

const char* to_string(Verdict verdict) {
  const char* const reasons[kVerdictCount] = {"usable",
                                              "not asked for",
                                              "crashed when last tried",
                                              "needs what the context has not",
                                              "the driver refuses its programs or buffers",
                                              "GL reports an error",
                                              "its vertices are wrong",
                                              "much slower than another path"};
  const auto i = static_cast<std::size_t>(verdict);
  return i < kVerdictCount ? reasons[i] : "";
}

std::uint64_t self_test_key(const Api& api, const Caps& caps, const SelfTestOptions& options) {
  const std::uint64_t parts[] = {hash_of(api.GetString(kGlVendor)),
                                 hash_of(api.GetString(kGlRenderer)),
                                 hash_of(api.GetString(kGlVersion)),
                                 hash_of(embedded::shader_skin),
                                 hash_of(embedded::shader_preskin_vert),
                                 hash_of(embedded::shader_preskin_comp),
                                 hash_of(embedded::shader_self_test_vert),
                                 hash_of(embedded::shader_self_test_frag),
                                 caps.uniform_block_bytes,
                                 caps.uniform_offset_alignment,
                                 caps.vertex_attributes,
                                 caps.texture_size,
                                 caps.compute ? 1u : 0u,
                                 options.paths,
                                 options.crashed,
                                 options.ssd ? 1u : 0u,
                                 options.as ? 1u : 0u,
                                 options.seconds != nullptr ? bit_cast<std::uint32_t>(options.slow) : 0u,
                                 options.seconds != nullptr ? options.timed_vertices : 0u,
                                 options.seconds != nullptr ? options.timed_characters : 0u};
  return format::checksum(reinterpret_cast<const std::byte*>(parts), sizeof(parts));
}

GpuFamily family_of(const unsigned char* renderer) {
  if (renderer == nullptr) return GpuFamily::other;
  const char* const name = reinterpret_cast<const char*>(renderer);
  const auto begins = [name](std::size_t at, const char* word) {
    while (*word != '\0' && name[at] == *word) ++at, ++word;
    return *word == '\0';
  };
  if (begins(0, "FD")) return GpuFamily::adreno;  // as Mesa calls them
  for (std::size_t i = 0; name[i] != '\0'; ++i) {
    if (begins(i, "Mali-G") || begins(i, "Immortalis-G")) return GpuFamily::mali_g;
    if (begins(i, "Mali-T")) return GpuFamily::mali_t;
    if (begins(i, "Adreno")) return GpuFamily::adreno;
    if (begins(i, "NVIDIA") || begins(i, "GeForce") || begins(i, "Tegra")) return GpuFamily::nvidia;
  }
  return GpuFamily::other;
}

Status choose(const SelfTest& test, const PathNeed& need, SkinningPath& out) {
  const SkinningPath* first = nullptr;
  const SkinningPath* fastest = nullptr;
  bool timed = true;
  float least = 0;
  const auto passes = static_cast<float>(need.passes > 1 ? need.passes - 1 : 0);
  for (const SkinningPath& path : order_of(test.family, need)) {
    if (!can_take(test, need, path)) continue;
    if (first == nullptr) first = &path;
    if (path == kCpu) continue;
    const PathResult& result = test.paths[static_cast<std::size_t>(path)];
    timed = timed && result.ns_per_vertex > 0;
    const float taken = result.ns_per_vertex + passes * result.ns_per_pass;
    if (fastest != nullptr && !(taken < kAlike * least)) continue;
    fastest = &path;
    least = taken;
  }
  if (first == nullptr) return Status::unsupported;
  out = timed && fastest != nullptr ? *fastest : *first;
  return Status::ok;
}

Status save(const SelfTest& test, Span<std::byte> out) {
  MARROW_REQUIRE(holds(out, kSavedSelfTestBytes));
  SavedSelfTest saved = {kSavedMagic, kSavedVersion, test.key, {}, static_cast<std::uint32_t>(test.family), 0};
  for (std::size_t i = 0; i < kPathCount; ++i) {
    const PathResult& from = test.paths[i];
    saved.paths[i] = {static_cast<std::uint32_t>(from.verdict),
                      {from.position_error, from.normal_error, from.ns_per_vertex, from.ns_per_pass}};
  }
  saved.checksum = checksum_of(saved);
  std::memcpy(out.data, &saved, sizeof(saved));
  return Status::ok;
}

Status restore(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<const std::byte> bytes,
               SelfTest& out) {
  MARROW_REQUIRE(holds(bytes));
  if (bytes.size < kSavedSelfTestBytes) return Status::truncated;
  SavedSelfTest saved;
  std::memcpy(&saved, bytes.data, sizeof(saved));
  if (saved.magic != kSavedMagic) return Status::bad_magic;
  if (saved.version != kSavedVersion) return Status::bad_version;
  if (saved.checksum != checksum_of(saved)) return Status::bad_checksum;
  SelfTest test;
  test.key = saved.key;
  for (std::size_t i = 0; i < kPathCount; ++i) {
    const SavedPath& from = saved.paths[i];
    if (!is_good(from)) return Status::bad_data;
    test.paths[i] = {static_cast<Verdict>(from.verdict), from.numbers[0], from.numbers[1], from.numbers[2],
                     from.numbers[3]};
  }
  if (saved.family >= kGpuFamilyCount) return Status::bad_data;
  test.family = static_cast<GpuFamily>(saved.family);
  if (saved.key != self_test_key(api, caps, options)) return Status::mismatch;
  out = test;
  return Status::ok;
}

}  // namespace marrow::gles3
