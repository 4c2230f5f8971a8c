// Which paths of gles3_skinner.h a device can be trusted with, found out by trying them once at start-up: drivers
// miscompile, lose uploads, crash, or are slow at what others are fast at.
//
//   start            restore() what was stored; unless that is ok, self_test(), then save() and store the bytes
//   once a mesh      choose() → SkinnerOptions::path
//
// Every path skins two small meshes, by each deformer asked for, as two characters in two frames. Each vertex is drawn
// as a point into a texture of integers and read back, so that no path is needed to see what another does, and compared
// with skin_ssd() and skin_as(). Motion vectors (kMotion) and crowds are not tried. The conventions are those of
// gles3.h.
#pragma once

#include "marrow/api.h"
#include "marrow/gles3_skinner.h"

namespace marrow::gles3 {

// What the self-test says of a path.
enum class Verdict : std::uint8_t {
  usable,
  not_tried,    // not among SelfTestOptions::paths
  crashed,      // among SelfTestOptions::crashed
  unsupported,  // the caps rule it out
  refused,      // the driver refuses its programs or its buffers
  gl_error,     // GL reports an error while it skins
  wrong,        // its vertices differ from the CPU's
  slow,         // right, but SelfTestOptions::slow times slower than the fastest that skins on the GPU
};
// How many values Verdict has.
inline constexpr std::uint32_t kVerdictCount = 8;
// "usable", or why a path is ruled out, in a few words; "" for a value that is none.
MARROW_API const char* to_string(Verdict verdict);

// What one path did.
struct PathResult {
  Verdict verdict = Verdict::not_tried;  // whether to use it
  // The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin;
  // and of unit normals and tangents. Quantised vertices differ by some 0.0001 and 0.0002. Above
  // kMostPositionError and kMostNormalError the path is wrong: numbers of 16 bits are off by more. Never NaN.
  float position_error = 0;
  float normal_error = 0;   // of normals and tangents
  float ns_per_vertex = 0;  // to skin and draw once; 0: not timed
  float ns_per_pass = 0;    // a vertex, of each pass that draws it again
};
// The most that PathResult::position_error may be, metres.
inline constexpr float kMostPositionError = 0.001f;
// The most that PathResult::normal_error may be.
inline constexpr float kMostNormalError = 0.005f;

// Chips that want another order of paths where nothing is timed, and other texts of shaders.
enum class GpuFamily : std::uint8_t {
  other,
  mali_g,  // Mali-G… and Immortalis: rows of a uniform block cost three times those of a texture, attributes are dear
  mali_t,  // Mali-T…: four numbers at a time; the paths as others
  adreno,  // registers enough without branches; the paths as others
  nvidia,  // unpacking attributes is dear: a quarter to a third less for animation space as words; the paths as others
};
// How many values GpuFamily has.
inline constexpr std::uint32_t kGpuFamilyCount = 5;

// What self_test() found.
struct SelfTest {
  PathResult paths[kPathCount] = {};    // by SkinningPath
  GpuFamily family = GpuFamily::other;  // by GL_RENDERER
  std::uint64_t key = 0;                // of driver, caps, options and this library's shader texts
};

// A path as a bit of SelfTestOptions::paths.
constexpr std::uint32_t bit_of(SkinningPath path) {
  return 1u << static_cast<std::uint32_t>(path);
}
// All paths, as bits.
inline constexpr std::uint32_t kAllPaths = (1u << kPathCount) - 1;

// What is tried, and how it is timed.
struct SelfTestOptions {
  std::uint32_t paths = kAllPaths;  // of those to try a bit each: 1 << path
  // Paths during which the process came to its end: they are not tried again. See about_to_try.
  std::uint32_t crashed = 0;
  bool ssd = true;  // the deformers that the game uses
  bool as = true;   // animation space
  // Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
  double (*seconds)(void* user) = nullptr;
  float slow = 4;  // times the fastest path's time
  // What is timed: characters of a mesh of so many vertices, of up to four influences, by SSD if `ssd`. State what the
  // game draws most of. 16 … 65 520 vertices, of which a multiple of 16 is taken; 1 … 256 characters.
  std::uint32_t timed_vertices = 2048;
  std::uint32_t timed_characters = 4;  // of that mesh
  // Called before a path is tried. A game that wants to outlive a driver that crashes stores which, durably, and
  // forgets it once self_test() has returned. What it finds stored at its next start goes into `crashed`, together
  // with what has been there before.
  void (*about_to_try)(void* user, SkinningPath path) = nullptr;
  void* user = nullptr;  // what the two functions above get
};

// Bytes of memory that self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as the defaults.
MARROW_API std::size_t self_test_bytes(const SelfTestOptions& options);

// Tries the paths, in the order of SkinningPath. memory: at least self_test_bytes(), 16-byte aligned, free again
// afterwards. Errors: bad_argument (no deformer, options beyond what they may be, memory too short or askew); gl_error
// (the context is lost, or nothing can be read back from it; then nothing is known of any path). `out` is written only
// on success; no GL object is left.
//
// Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
// framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
// GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
// binding 0 and what preskin() says.
// Cost: some twenty programs compiled, and a wait for each frame; only where nothing is stored.
MARROW_API Status self_test(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<std::byte> memory,
                            SelfTest& out);

// What a mesh is to be drawn for.
struct PathNeed {
  std::uint32_t passes = 1;      // that draw it in a frame: colour, depth, shadows
  std::uint32_t characters = 1;  // in one Skinner
  std::uint32_t joints = 0;      // Mesh::palette_size()
};
// From so many characters on choose() prefers palettes in a texture.
inline constexpr std::uint32_t kManyCharacters = 8;

// Of the usable paths of the GPU the one that was fastest: ns_per_vertex + (passes - 1) · ns_per_pass. cpu is taken
// where there is no other, as its time is not the GPU's. Of those within 5 % of each other, and of all where one has
// not been timed, the first in this order:
//
//                                one pass                           several passes
//   up to 7 characters           ubo texture compute feedback cpu   compute feedback ubo texture cpu
//   kManyCharacters and more     texture ubo compute feedback cpu   texture compute feedback ubo cpu
//   GpuFamily::mali_g            texture compute feedback ubo cpu   the same
//
// More than kPaletteJoints leave texture and cpu. Why so: docs/decisions.md, "Which path".
// Errors: unsupported (none is usable). `out` is written only on success.
MARROW_API Status choose(const SelfTest& test, const PathNeed& need, SkinningPath& out);

// A result as bytes that a game stores. Errors: bad_argument (too short).
inline constexpr std::size_t kSavedSelfTestBytes = 128;
// Writes kSavedSelfTestBytes. Errors: bad_argument (`out` too short).
MARROW_API Status save(const SelfTest& test, Span<std::byte> out);

// The result in bytes that save() has written, if it still holds. Errors: truncated, bad_magic, bad_version,
// bad_checksum, bad_data; mismatch (another driver, version of it, library, or other caps or options): then test anew,
// and with another driver without what had crashed. `out` is written only on success.
MARROW_API Status restore(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<const std::byte> saved,
                          SelfTest& out);

}  // namespace marrow::gles3
