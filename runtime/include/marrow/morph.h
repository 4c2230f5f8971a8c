// Morph: weights of morph targets → bind-pose vertices moved, for any deformer.
//
//   once a load       find_weight_channels
//   once an instance  make_morphed
//   every frame       sample_channels → morph_weights → morph() → a Mesh whose geometry is MorphedGeometry::geometry
//                     goes through skin_rigid, skin_ssd; through morph_coordinates and skin_as in animation space
//
// glTF 2.0, section 3.7.2.2: attribute = bind + Σ_i weight_i · change_i, before skinning; normals and tangents are
// normalised afterwards. Any finite weight is legal.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"

namespace marrow {

// For each target of `mesh` the index of the channel of `clip` that drives its weight, or kNoChannel. The mesh is of
// `file`, the clip of `clips`, the same or a clip pack. out: at least mesh.targets.size; errors: bad_argument. Cost:
// compares names; once a load.
MARROW_API Status find_weight_channels(const File& file, const Mesh& mesh, const File& clips, const Clip& clip,
                                       Span<std::uint32_t> out);

// The weights at one moment: each target gets its channel's value, or its default if it has no channel. channels: from
// find_weight_channels(); values: from sample_channels() of the same clip; empty spans: all defaults.
// out: at least mesh.targets.size. Errors: bad_argument (`out` or `channels` too short, a channel outside the values).
MARROW_API Status morph_weights(const Mesh& mesh, Span<const std::uint32_t> channels, Span<const float> values,
                                Span<float> out);

// An instance's vertices, in the caller's memory. Copies are views of the same vertices.
struct MorphedGeometry {
  Geometry geometry = {};                  // the bind geometry, with the instance's own skin, normals and tangents
  Geometry bind = {};                      // as the file has it
  const std::uint32_t* offsets = nullptr;  // for each block its first float in the skin; one more for the end
  std::uint32_t* moved = nullptr;          // a bit for each block: it differs from the bind pose
  std::uint32_t* changed = nullptr;        // a bit for each block: written since morph_coordinates()
  std::uint32_t* attributes = nullptr;     // one, kMorphsPositions | …: what differs in the blocks moved
};

// Bytes that make_morphed() needs; 0 for a geometry without targets, which is its own morphed geometry.
MARROW_API std::size_t morphed_bytes(const Geometry& geometry);

// The bind pose. memory: at least morphed_bytes(), 16-byte aligned (bad_argument otherwise); `out` keeps pointers into
// it and into `geometry`'s block. Cost: a copy of the vertices; once an instance.
MARROW_API Status make_morphed(const Geometry& geometry, Span<std::byte> memory, MorphedGeometry& out);

// Moves the vertices by `weights`, one a target; whatever they were moved by before is undone. Targets with weight 0
// cost nothing. Errors: bad_argument (too few weights, or one that is not finite: nothing is written).
// Cost: in proportion to the vertices (blocks of four) that targets with a weight other than 0 move, now or in the last
// call. Instructions a vertex, x86-64, g++ 12 -O3: 9 a target for positions, 15 with normals, 21 with tangents; and
// once, however many targets move it, 8, 20 or 29 to undo and normalise.
MARROW_API Status morph(Span<const float> weights, MorphedGeometry& morphed);

// Brings animation-space coordinates up to date with the last morph(): q_j.xyz += (q_j)_w Δ and so Σ_j q_j += Δ, where
// Δ is how far a vertex is from its bind pose. Δ goes through the blend that normals go through; as_coordinates() of
// the morphed geometry is the same where no residual changes a weight.
//
// coordinates: as_coordinates() of the bind geometry; pass the same floats to every call. Errors: bad_argument (too
// short). Cost: 60 instructions a vertex with four influences and a residual, for vertices that morph() has written
// since the last call.
MARROW_API Status morph_coordinates(MorphedGeometry& morphed, Span<float> coordinates);

}  // namespace marrow
