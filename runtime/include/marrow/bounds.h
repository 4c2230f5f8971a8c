// Bounds: palette → a box and a sphere about the mesh, for culling and shadows, without its vertices.
//
//   over a whole clip   File::bounds(clip, mesh): from the file, no work
//   in one frame        make_extents() once a load; palette_bounds() every frame
//
// Both are about every vertex that rigid skinning, SSD (with helpers) and pose-space deformation give: those blend
// with weights ≥ 0 that sum to 1, so a vertex is in the convex hull of where its joints alone would take it. What is in
// the file holds for animation space and multi-weights too, as it was measured with them; palette_bounds() knows
// nothing of their residuals (docs/benchmarks.md, "Bounds", has how far they went beyond it).
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// The vertices of the bind pose that a palette entry has a weight in, as a box in mesh space.
struct JointExtent {
  float centre[3] = {0, 0, 0};   // the box's middle
  float half[3] = {-1, -1, -1};  // ≥ 0; below 0: nothing follows this entry
};

// What a morph target (or an example of pose-space deformation) adds to vertices at weight 1: a box about all changes
// and about 0, in mesh space.
struct MorphExtent {
  float least[3] = {0, 0, 0};  // ≤ 0
  float most[3] = {0, 0, 0};   // ≥ 0
};

// Views into the caller's memory.
struct MeshExtents {
  Span<JointExtent> joints = {};   // one a palette entry, helpers behind
  Span<MorphExtent> targets = {};  // one a morph target
  MorphExtent pose_space = {};     // the sum of what all examples may add
};

// Bytes that make_extents() needs: 24 a palette entry and 24 a morph target, up to a multiple of 16.
MARROW_API std::size_t extents_bytes(const Mesh& mesh);

// Looks at every vertex once. The result serves all characters with this mesh, at any level of detail whose vertices
// are among those of `mesh`.
//
// mesh: of a file, not of a character whose vertices are morphed. memory: at least extents_bytes(), 16-byte aligned;
// `out` keeps pointers into it. Errors: bad_argument (the memory). Cost: once a load.
MARROW_API Status make_extents(const Mesh& mesh, Span<std::byte> memory, MeshExtents& out);

// The box of the mesh and a sphere about the box's centre, in the palette's space.
//
// palette: of the mesh, extents.joints.size entries. weights: of its morph targets, any finite numbers; empty: none is
// active. Without a vertex `out` is empty (Bounds::is_empty()). Errors: bad_argument (a span too short, a weight that
// is not finite); `out` is not written. Method: the box of a transformed box is its centre, transformed, and its half
// sides through the absolute values of the matrix (J. Arvo, "Transforming axis-aligned bounding boxes", Graphics Gems,
// 1990); a union of those. The sphere's radius is the distance to the farthest corner of any of them. Cost: 119
// instructions a palette entry, x86-64, in two passes. No allocation, thread-safe.
MARROW_API Status palette_bounds(const MeshExtents& extents, Span<const Affine> palette, Span<const float> weights,
                                 Bounds& out);

}  // namespace marrow
