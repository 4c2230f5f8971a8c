// What a Skinner keeps in its state.
#pragma once

#include <type_traits>

#include "gles3/mesh/gpu_mesh.h"
#include "gles3/palettes.h"
#include "marrow/gles3_skinner.h"
#include "marrow/morph.h"

namespace marrow::gles3 {

// What skinners with SkinnerOptions::motion keep of the update() before: two of each, which take turns.
struct SkinnerMotion {
  PaletteRing ring = {};             // path ubo
  Span<std::uint32_t> offsets = {};  // in the ring, a character each
  Span<SkinnedMesh> skinned = {};    // of paths that skin once a frame
  Span<float> weights = {};          // of morph targets
  Span<float> sent_weights = {};     // of the last update()
  Span<std::uint8_t> still = {};     // one a character: 1 if its last update() counts as its first
  Span<std::uint8_t> reset = {};     // one a character: 1 if its next update() counts as its first
};

// What create_skinner() makes; spans are in the caller's memory.
struct SkinnerState {
  GpuMesh gpu = {};                      // the mesh's vertices on the GPU
  PaletteRing ring = {};                 // path ubo, feedback and compute
  PaletteTexture texture = {};           // path texture
  PaletteTexture distance_texture = {};  // of pose spaces
  Span<Affine> bind = {};                // what palettes are built with
  Span<Affine> palettes = {};            // characters after each other
  Span<Affine> distances = {};           // of pose spaces, characters after each other; path cpu: one character's
  Span<float> weights = {};              // of morph targets, characters after each other
  Span<std::uint32_t> offsets = {};      // in the ring, a character each
  SkinnerMotion motion = {};             // with SkinnerOptions::motion
  Span<float> positions = {}, normals = {}, tangents = {}, coordinates = {};  // path cpu: one character's
  MorphedGeometry morphed = {};                                               // path cpu: one character's
  Span<std::byte> scratch = {};                                               // of prepare(), kept for the next context
};
static_assert(sizeof(SkinnerState) <= sizeof(Skinner::state) && alignof(SkinnerState) <= alignof(void*));
static_assert(std::is_trivially_copyable_v<SkinnerState>);

inline SkinnerState& state_of(Skinner& skinner) {
  return *reinterpret_cast<SkinnerState*>(skinner.state);
}
inline const SkinnerState& state_of(const Skinner& skinner) {
  return *reinterpret_cast<const SkinnerState*>(skinner.state);
}

}  // namespace marrow::gles3
