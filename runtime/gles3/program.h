// Texts → a program: what it is compiled for, and where its uniforms are.
#pragma once

#include <cstring>
#include <type_traits>

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Where a program finds its palettes.
enum class Palettes : std::uint8_t {
  uniform_block,  // PaletteRing: one palette a draw call
  texture,        // PaletteTexture: of any size; one draw call may draw many characters
  crowd,  // CrowdMesh, see gles3_crowd.h: likewise, without work on the CPU; not for Deformer::none, psd or kMorphs
};

// What a program is compiled for. With kMorphs it draws only meshes that have targets; call set_morphs() before each.
// With kMotion it skins twice: by this frame's palettes and, positions only, by the previous frame's. Bind the previous
// palettes for each draw call, too:
//   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by bind_palette()
//   in a texture         bind_previous_palette(); of crowds bind_crowd() does it
//   skinned elsewhere    set_previous(), see skinned.h
// and with kMorphs set_previous_morphs().
struct ProgramKey {
  Deformer deformer = Deformer::ssd;            // by which vertices are skinned
  std::uint8_t influences = 4;                  // 4 to 8: that of the mesh or more
  std::uint8_t features = kNormals;             // kNormals | …: the mesh's features that it reads
  Palettes palettes = Palettes::uniform_block;  // where it finds palettes
};

// What Program::state holds.
struct ProgramState {
  Palettes reads = Palettes::uniform_block;  // where it reads palettes
  bool motion = false;                       // built with kMotion
  // Locations of uniforms.
  std::int32_t coordinate_scale = -1, joint_bits = -1;  // of attributes; here and below -1: there is none
  std::int32_t palettes = -1, first_row = -1;           // of palettes in a texture
  std::int32_t instances = -1, crowd = -1;              // of crowds
  std::int32_t vertex_layout = -1;                      // of pre-skinning by compute shaders
  std::int32_t morph_changes = -1, morph_targets = -1, morph_count = -1;            // of morph targets
  std::int32_t morph_shift = -1, morph_per_row = -1;                                // of morph targets
  std::int32_t previous_palettes = -1, previous_targets = -1, previous_count = -1;  // of the frame before
  std::int32_t examples = -1, example_step = -1;                                    // of pose spaces
  std::int32_t distances = -1, distance_row = -1, previous_distances = -1;          // of pose spaces
};
static_assert(sizeof(ProgramState) == sizeof(Program::state) && alignof(ProgramState) == 4);
static_assert(std::is_trivially_copyable_v<ProgramState>);

// Of Program{} it is ProgramState{}.
inline const ProgramState& state_of(const Program& program) {
  static constexpr ProgramState kNone;
  return program.id != 0 ? *reinterpret_cast<const ProgramState*>(program.state) : kNone;
}
inline void set_state(Program& program, const ProgramState& state) {
  std::memcpy(program.state, &state, sizeof(state));
}

// Compiles and links. The palette block is tied to uniform buffer binding `palette_binding`; with kMotion the previous
// frame's block is tied to the next binding.
// Errors: bad_argument (a text missing, influences other than 4 to 8, what crowds cannot); gl_error, with the driver's
// words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a frame.
Status create_program(const Api& api, const ProgramKey& key, const ProgramSource& source, std::uint32_t palette_binding,
                      Program& out, Span<char> log = {});

// Deletes the program and clears the struct.
void destroy(const Api& api, Program& program);

}  // namespace marrow::gles3
