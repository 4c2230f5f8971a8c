// Stage 4, palette: scene-space joints → the matrices that skinning blends.
#pragma once

#include "marrow/file.h"

namespace marrow {

// out[i] = scene_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
//
// joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path brings its own
// bind that also undoes quantisation). out: at least as many. Every joint must be below scene_from_joint.size.
// Errors: bad_argument if a span is too short or a joint out of range.
// The same palette serves SSD and animation space (docs/architecture.md, "One palette").
// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64. Thread-safe on different outputs; out
// overlaps none of the inputs.
Status build_palette(Span<const std::uint16_t> joints, Span<const Affine> bind, Span<const Affine> scene_from_joint,
                     Span<Affine> out);

// The palette of a mesh.
Status build_palette(const Mesh& mesh, Span<const Affine> scene_from_joint, Span<Affine> out);

}  // namespace marrow
