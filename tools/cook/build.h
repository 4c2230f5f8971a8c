// From the artist's scene to the runtime's: which nodes become joints, how keys become tracks, how vertices become
// blocks.
#pragma once

#include "cook/built.h"
#include "cook/raw.h"

namespace marrow::cook {

struct CookOptions {
  bool raw_clips = false;    // keep clips' keys as they are
  double clip_error = 1e-4;  // metres on the shell; or, if clip_error_is_share, of the skeleton's diagonal
  bool clip_error_is_share = false;
  bool keep_vertex_order = false;  // remember where every vertex of the source went
};

// Adds to scene.warnings what it mends or leaves out. Throws tools::Failure (invalid: nothing to cook; unsupported: a
// limit of the format).
BuiltScene build_scene(RawScene& scene, const CookOptions& options);

// The stages of build_scene, each in a file of its own.
BuiltSkeleton build_skeleton(RawScene& scene);
BuiltClip build_clip(const RawClip& clip, const BuiltSkeleton& skeleton);
// Behind the tracks, which must be final. all_keys: keep those too that others make superfluous.
void add_channels(const RawClip& raw, bool all_keys, BuiltClip& clip);
void build_meshes(RawScene& scene, const CookOptions& options, BuiltScene& out);

// node-to-parent matrix of one node, and rows of an affine matrix.
glm::dmat4 local_matrix(const RawNode& node);
Affine to_affine(const glm::dmat4& m);

}  // namespace marrow::cook
