// Palette: model-space joints → the matrices that skinning blends.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// out[i] = model_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
//
// joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path brings its own
// bind that also undoes quantisation). out: at least as many and one a helper. Every joint must be below
// model_from_joint.size, what helpers name below joints.size and not the same.
// Errors: bad_argument if a span is too short, a joint out of range or a share not between 0 and 1.
//
// helpers: written behind the joints' entries: entry joints.size + h blends the entries `first` and `second`, the
// latter at `share`. Of either entry's matrix, a stretch and then a turn, the turns are blended as quaternions, the
// shorter way, and the stretches linearly. Where the origin of the joint `second` goes is what dual quaternions make of
// where both take it (L. Kavan et al., Geometric skinning with approximate dual quaternion blending, 2008). Between a
// joint and its parent that is a turn about the joint. centres: none, or three numbers a helper: a place, as the joint
// `second` sees it, that goes to the mean, by shares, of where both take it (B. Le, J. Hodgins, Real-time skeletal
// skinning with optimized centers of rotation, 2016). Half a turn goes round the axis that points to the positive side
// along the largest of its components. Where an entry mirrors, its stretch does. Where one has lost its volume, or is
// not finite, the two are blended as numbers.
//
// The same palette serves SSD and animation space (docs/decisions.md, "One palette").
// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64; a helper 198 on x86-64, about a
// centre 248. Four helpers share their work: where one of them has entries whose stretches differ, all four cost 385.
// Thread-safe on different outputs; out overlaps none of the inputs.
MARROW_API Status build_palette(Span<const std::uint16_t> joints, Span<const Affine> bind,
                                Span<const Affine> model_from_joint, Span<Affine> out, Span<const Helper> helpers = {},
                                Span<const float> centres = {});

// The palette of a mesh.
MARROW_API Status build_palette(const Mesh& mesh, Span<const Affine> model_from_joint, Span<Affine> out);

// Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
// are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
// not finite do not.
MARROW_API bool turns_inside_out(const Affine& map);

// The same of what follows a palette: whether more of its matrices mirror than not. For culling of meshes that are not
// double_sided; a game whose characters are never mirrored, nor hung on what is, need not ask. An instance of a crowd
// turns if either this or its world_from_model does, not if both do: see gles3_crowd.h. Cost: a determinant a
// matrix.
MARROW_API bool turns_inside_out(Span<const Affine> palette);

}  // namespace marrow
