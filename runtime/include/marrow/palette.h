// Palette: model-space joints → the matrices that skinning blends.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// out[i] = model_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
//
// joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path has its own bind
// matrices, which also undo quantisation). out: at least as many entries, and one more a helper. Every joint must be
// below model_from_joint.size. A helper's `first` and `second` must be below joints.size and differ.
// Errors: bad_argument if a span is too short, a joint out of range or a share not between 0 and 1.
//
// helpers: written behind the joints' entries. Entry joints.size + h blends the entries `first` and `second`, the
// latter at `share`. Each of the two matrices is split into a rotation and a stretch: matrix = rotation · stretch. The
// rotations are blended as quaternions, the shorter way, the stretches linearly. The two entries take the origin of
// joint `second` to two places. The helper takes it to the place that dual quaternion blending of the two entries gives
// (L. Kavan et al., Geometric skinning with approximate dual quaternion blending, 2008). Between a joint and its parent
// that is a turn about the joint.
//
// centres: none, or three numbers a helper: a point in the space of joint `second`. Both entries take it somewhere; the
// helper takes it to the mean of the two places, by shares (B. Le, J. Hodgins, Real-time skeletal skinning with
// optimized centers of rotation, 2016).
//
// If the two rotations are 180° apart, the blend turns about the axis whose largest component is positive. If an entry
// mirrors, its stretch mirrors and its rotation does not. Where an entry has lost its volume, or is not finite, the two
// matrices are blended element by element.
//
// The same palette serves SSD and animation space (docs/decisions.md, "One palette").
// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64. A helper takes 198 on x86-64, with a
// centre 248. Helpers are computed four at a time: if the two entries of one of them differ in their stretches, each of
// the four takes 385.
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

// The same for vertices that follow a palette: whether more of its matrices mirror than not. For culling of meshes that
// are not double_sided; a game need not ask if its characters are never mirrored and never hung on anything mirrored.
// An instance of a crowd is turned inside out if either this palette or its world_from_model mirrors, but not if both
// do: see gles3_crowd.h. Cost: a determinant a matrix.
MARROW_API bool turns_inside_out(Span<const Affine> palette);

}  // namespace marrow
