// Stage 4, palette: scene-space joints → the matrices that skinning blends.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// out[i] = scene_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
//
// joints, bind: one a palette entry, equal in size (Mesh::joints and Mesh::inverse_bind; the GLES path brings its own
// bind that also undoes quantisation). out: at least as many and a half-joint each. Every joint must be below
// scene_from_joint.size, what half-joints name below joints.size.
// Errors: bad_argument if a span is too short, a joint out of range or a share not between 0 and 1.
//
// half_joints: helpers, written behind the joints' entries: entry joints.size + h stands between the entries `parent`
// and `joint` at `share`. Its rotation is that share of the way on the sphere, scale and shear are blended linearly,
// and all happens about the joint (the point that bind[joint] takes to the origin). Where a matrix has no volume, the
// helper is the joint's own. See `marrow cook --half-joints`, docs/deformers.md.
//
// The same palette serves SSD and animation space (docs/architecture.md, "One palette").
// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64; a half-joint about 1200 on x86-64.
// Thread-safe on different outputs; out overlaps none of the inputs.
MARROW_API Status build_palette(Span<const std::uint16_t> joints, Span<const Affine> bind,
                                Span<const Affine> scene_from_joint, Span<Affine> out,
                                Span<const HalfJoint> half_joints = {});

// The palette of a mesh.
MARROW_API Status build_palette(const Mesh& mesh, Span<const Affine> scene_from_joint, Span<Affine> out);

// Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
// are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
// not finite do not.
MARROW_API bool turns_inside_out(const Affine& map);

// The same of what follows a palette: whether more of its matrices mirror than not. For culling of meshes that are not
// double_sided; a game whose characters are never mirrored, nor hung on what is, need not ask. An instance of a crowd
// turns if either this or its scene_from_character does, not if both do: see gles3_crowd.h. Cost: a determinant a
// matrix.
MARROW_API bool turns_inside_out(Span<const Affine> palette);

}  // namespace marrow
