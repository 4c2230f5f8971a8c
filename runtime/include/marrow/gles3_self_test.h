// Which paths of gles3_skinner.h a driver gets right and fast, found out by trying them once at start-up.
//
//   start            restore() what was stored; unless that is ok, self_test(), then save() and store the bytes
//   once a mesh      choose() → SkinnerOptions::path
//
// Every path skins two small meshes, as two characters in two frames. Each vertex is read back and compared with
// skin_ssd() and skin_as(). Motion vectors and crowds are not tried. The conventions are those of gles3.h.
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
// "usable", or why a path is ruled out, in a few words; "" for a value that is none.
MARROW_API const char* to_string(Verdict verdict);

// What one path did.
struct PathResult {
  Verdict verdict = Verdict::not_tried;  // whether to use it
  // The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin.
  // Quantised vertices differ by some 0.0001. Above 0.001 the path is wrong. Never NaN.
  float position_error = 0;
  float normal_error = 0;   // of unit normals and tangents: some 0.0002; above 0.005 the path is wrong
  float ns_per_vertex = 0;  // to skin and draw once; 0: not timed
  float ns_per_pass = 0;    // a vertex, of each pass that draws it again
};

// Chips that want another order of paths where nothing is timed, and other texts of shaders.
enum class GpuFamily : std::uint8_t { other, mali_g, mali_t, adreno, nvidia };

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

// What is tried, and how it is timed.
struct SelfTestOptions {
  std::uint32_t paths = (1u << kPathCount) - 1;  // those to try, by bit_of(); all
  std::uint32_t crashed = 0;   // paths during which the process ended: they are not tried again; see about_to_try
  bool ssd = true, as = true;  // the deformers that the game uses
  double (*seconds)(void* user) = nullptr;  // a clock that never goes back; null: nothing is timed, and nothing is slow
  float slow = 4;                           // times the fastest path's time
  // What is timed, by SSD if `ssd`: state what the game draws most of.
  std::uint32_t timed_vertices = 2048;  // of a mesh, 16 … 65 520, of which a multiple of 16 is taken
  std::uint32_t timed_characters = 4;   // of that mesh, 1 … 256
  // Called before a path is tried. To outlive a driver that crashes, a game stores the path and forgets it once
  // self_test() has returned. What it finds stored at its next start it adds to `crashed`.
  void (*about_to_try)(void* user, SkinningPath path) = nullptr;
  void* user = nullptr;  // what the two functions above get
};

// Bytes of memory that self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as the defaults.
MARROW_API std::size_t self_test_bytes(const SelfTestOptions& options);

// Tries the paths, in the order of SkinningPath. memory: at least self_test_bytes(), 16-byte aligned, free again
// afterwards. Errors: bad_argument (no deformer, options beyond what they may be, memory too short or askew); gl_error
// (the context is lost, or nothing can be read back from it). `out` is written only on success; no GL object is left.
//
// Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
// framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
// GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
// binding 0, GL_TRANSFORM_FEEDBACK_BUFFER and its bindings 0 … 2, GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3.
// Cost: some twenty programs compiled, and a wait for each frame; only where nothing is stored.
MARROW_API Status self_test(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<std::byte> memory,
                            SelfTest& out);

// What a mesh is to be drawn for.
struct PathNeed {
  std::uint32_t passes = 1;      // that draw it in a frame: colour, depth, shadows
  std::uint32_t characters = 1;  // in one Skinner
  std::uint32_t joints = 0;      // Mesh::palette_size()
};
// Of the usable paths of the GPU the one that was fastest: ns_per_vertex + (passes - 1) · ns_per_pass. cpu is taken
// where there is no other, as its time is not the GPU's. Of those within 5 % of each other, and of all where one has
// not been timed, the first in this order:
//
//                                one pass                           several passes
//   up to 7 characters           ubo texture compute feedback cpu   compute feedback ubo texture cpu
//   8 characters and more        texture ubo compute feedback cpu   texture compute feedback ubo cpu
//   GpuFamily::mali_g            texture compute feedback ubo cpu   the same
//
// More than 341 joints leave texture and cpu. Why so: docs/decisions.md, "Which path".
// Errors: unsupported (none is usable). `out` is written only on success.
MARROW_API Status choose(const SelfTest& test, const PathNeed& need, SkinningPath& out);

inline constexpr std::size_t kSavedSelfTestBytes = 128;  // of a result that a game stores
// Writes kSavedSelfTestBytes. Errors: bad_argument (`out` too short).
MARROW_API Status save(const SelfTest& test, Span<std::byte> out);

// The result in bytes that save() has written, if it still holds. Errors: truncated, bad_magic, bad_version,
// bad_checksum, bad_data; mismatch (another driver, version of it, library, or other caps or options): then test anew,
// and with another driver without what had crashed. `out` is written only on success.
MARROW_API Status restore(const Api& api, const Caps& caps, const SelfTestOptions& options, Span<const std::byte> saved,
                          SelfTest& out);

}  // namespace marrow::gles3
