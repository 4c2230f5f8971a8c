// Skin on the GPU, in one piece: draws one mesh as many characters, on the path that suits the device.
//
//   once a context   load_api, query_caps; a ProgramSet with the game's own texts, one a role (colour, shadow, …)
//   once a mesh      create_skinner
//   every frame      pose() each character; update(); for each role: use its program, set uniforms, draw()
//   context lost     on_context_lost; with the new context load_api, query_caps, then on_context_restored
//
// No allocation but the driver's: memory is the caller's, sizes are asked for first. The conventions are those of
// gles3.h. What the calls leave changed in the GL state: docs/gles/state.md.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// Where vertices are skinned.
enum class SkinningPath : std::uint8_t {
  ubo,       // vertex shader, every pass; palettes in a uniform block, a draw call a character
  texture,   // vertex shader, every pass; palettes in a texture, one draw call for all characters
  feedback,  // once a frame, by transform feedback
  compute,   // once a frame, by compute shader; OpenGL ES 3.1
  cpu,       // once a frame, by the CPU
};
inline constexpr std::uint32_t kPathCount = 5;  // how many values SkinningPath has
// "ubo", …
MARROW_API const char* to_string(SkinningPath path);

inline constexpr std::uint32_t kMostRoles = 4;  // of a ProgramSet

// The programs of a context: each role for each kind of mesh, compiled once, at most 192. A game fills in all but the
// state.
struct ProgramSet {
  ProgramSource roles[kMostRoles] = {{}, {}, {}, {}};  // texts that live as long as the set
  std::uint32_t role_count = 1;                        // of `roles`, that are used
  // For each role, which features of a mesh its texts read: for a shadow none, or kUvs where it has holes. kMotion:
  // whether they read previous_position, of skinners and crowds that keep it.
  std::uint8_t role_features[kMostRoles] = {255, 255, 255, 255};
  std::uint32_t palette_binding = 0;       // uniform buffer binding of the palettes
  Span<char> log = {};                     // what the driver says of a text that does not compile
  alignas(4) std::byte state[18436] = {};  // Marrow's own: what was compiled
};

// Deletes all programs. Skinners that use the set must go first.
MARROW_API void destroy(const Api& api, ProgramSet& programs);

// Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
// positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them.
struct SkinnedMesh {
  std::uint32_t array = 0;       // vertex array object
  std::uint32_t buffer = 0;      // of the vertices
  std::uint32_t slot_count = 0;  // the mesh's
  std::uint8_t features = 0;     // kNormals, kTangents, kUvs, kColours: what programs with Deformer::none may read
};

// How a mesh is skinned, and for how many characters.
struct SkinnerOptions {
  SkinningPath path = SkinningPath::ubo;  // choose() in gles3_self_test.h names the best
  Deformer deformer = Deformer::ssd;      // rigid, ssd, as or psd, which is ssd for a mesh without examples
  std::uint32_t instances = 1;            // characters, at most
  // The unit of palettes in a texture. Morph targets take the next unit; with `motion` the previous palettes take the
  // third. A pose space takes the fourth and fifth, with `motion` also the sixth.
  std::uint32_t texture_unit = 0;
  std::uint8_t features = 255;  // the mesh's features that programs read, if their role reads them, too
  // From as_tangents() of this mesh, in the caller's memory for as long as the skinner: animation space draws the
  // deformed surface's own normals. Empty, or of a mesh with morph targets: normals through the blend.
  Span<const float> as_tangents = {};
  // For motion vectors: programs of roles that read kMotion get MarrowVertex::previous_position of the last update().
  // Takes the uniform buffer binding after ProgramSet::palette_binding, too. Cost: docs/performance.md.
  bool motion = false;
};

// A mesh that is drawn as many characters. Filled in by create_skinner(), to be read only.
struct Skinner {
  Mesh mesh = {};               // as it was given
  SkinnerOptions options = {};  // as they were given
  // What update() has skinned, a character each: of the paths feedback, compute and cpu.
  Span<SkinnedMesh> skinned = {};
  alignas(void*) std::byte state[1024] = {};  // Marrow's own
  std::uint32_t updated = 0;                  // how many characters the last update() prepared
  bool lost = false;                          // between on_context_lost() and on_context_restored()
};

// Bytes of memory that create_skinner() wants.
MARROW_API std::size_t skinner_bytes(const Mesh& mesh, const SkinnerOptions& options);

// Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: pose() each
// before the first update(). Compiles what `programs` lacks for it.
//
// mesh: its geometry must live as long as the skinner. memory: at least skinner_bytes(), 16-byte aligned, the skinner's
// until destroy().
// Errors: bad_argument (a span too short, no instances, Deformer::none, no role); unsupported (a path that the caps or
// the number of joints rule out, a full program set); gl_error (nothing is left allocated but programs). `out` is
// written only on success.
MARROW_API Status create_skinner(const Api& api, const Caps& caps, const Mesh& mesh, const SkinnerOptions& options,
                                 ProgramSet& programs, Span<std::byte> memory, Skinner& out);
// Deletes the GL objects and clears the struct; the memory is the caller's again.
MARROW_API void destroy(const Api& api, Skinner& skinner);

// Sets the pose that character `instance` has from the next update() on. weights: one a morph target; the GPU takes the
// 64 that move most. Calls no GL: it may run on any thread, for different instances on different threads.
// Errors: bad_argument (no such instance, a span too short, a skinner that was destroyed).
MARROW_API Status pose(Skinner& skinner, std::uint32_t instance, Span<const Affine> model_from_joint,
                       Span<const float> weights = {});

// With options.motion: at the next update() the character counts as new, so its vertices do not move. For one that
// jumps to another place; one that the last update() left out counts as new anyway. May be called where pose() may.
// Errors: bad_argument (no such instance, a skinner without motion or that was destroyed).
MARROW_API Status reset_motion(Skinner& skinner, std::uint32_t instance);

// Once a frame, after posing: uploads the palettes of characters 0 … count - 1, or skins them. Only 48 bytes a joint
// are uploaded; with a pose space also 16 for every four examples, the bind pose counting as one; on path cpu the
// vertices instead.
// Errors: bad_argument (more than there are, a weight that is not finite, a skinner that was destroyed); gl_error (the
// context is lost).
MARROW_API Status update(const Api& api, Skinner& skinner, const ProgramSet& programs, std::uint32_t count);

// The program of a role for this mesh, never null: use it and set the game's own uniforms before draw().
MARROW_API const Program& program_of(const Skinner& skinner, const ProgramSet& programs, std::uint32_t role);

// Draws characters first … first + count - 1 with `program`, which is program_of() of a role and in use. The game sets
// culling: as glTF has it, GL_CULL_FACE unless Mesh::double_sided, and fronts GL_CCW, or GL_CW where the character is
// mirrored: turns_inside_out() in palette.h. So characters that mirror need a draw call of their own.
// Errors: bad_argument (not all of them updated, a skinner that was destroyed); gl_error (the context is lost).
MARROW_API Status draw(const Api& api, const Skinner& skinner, const ProgramSet& programs, const Program& program,
                       std::uint32_t first, std::uint32_t count);

// After the context is gone: forgets GL objects without a call to GL. Until on_context_restored() update() and draw()
// refuse. The order of set and skinners does not matter.
MARROW_API void on_context_lost(ProgramSet& programs);
MARROW_API void on_context_lost(Skinner& skinner);

// Builds everything anew in the current context; poses are kept. Errors: as create_skinner(); then it may be tried
// again.
MARROW_API Status on_context_restored(const Api& api, const Caps& caps, ProgramSet& programs);
MARROW_API Status on_context_restored(const Api& api, const Caps& caps, Skinner& skinner);

}  // namespace marrow::gles3
