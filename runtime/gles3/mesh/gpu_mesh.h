// A mesh on the GPU: its buffers, textures, and what they hold.
#pragma once

#include "marrow/gles3.h"

namespace marrow::gles3 {

// Attribute locations of the skinning text, fixed so that any program draws any mesh. There is one exception: animation
// space with kSurfaceNormals has other vectors at the locations of normals and tangents, so only programs with
// kSurfaceNormals draw it.
inline constexpr std::uint32_t kPositionLocation = 0;     // animation space: 0 … 7 are the coordinates
inline constexpr std::uint32_t kWeightsLocation = 1;      // and 2
inline constexpr std::uint32_t kPreviousLocation = 1;     // Deformer::none with kMotion: the previous position
inline constexpr std::uint32_t kJointsLocation = 8;       // and 9; on Mali-G up to eight here, two in a number
inline constexpr std::uint32_t kNormalLocation = 10;      // octahedral
inline constexpr std::uint32_t kTangentLocation = 11;     // octahedral, and the handedness
inline constexpr std::uint32_t kUvLocation = 12;          // in_uv
inline constexpr std::uint32_t kColourLocation = 13;      // in_colour
inline constexpr std::uint32_t kMorphRowLocation = 14;    // row of the morph texture
inline constexpr std::uint32_t kExampleRowLocation = 15;  // row of the texture of examples
inline constexpr std::uint32_t kSurfaceLocations[8] = {4, 5, 6, 7, 9, 10, 11, 15};  // four vectors of each tangent
// Animation space as words: each attribute is a uvec4 that holds two vectors. Mali-G and NVIDIA read all coordinates
// and tangents so. With kSurfaceNormals and more than four influences every GPU does, except Adreno and Mali-T with
// five or six influences: they read only the tangents so, from the seventh location on. With kSurfaceNormals and more
// than four influences a vector is stored as x, y, w, z. The shader then takes the whole word as y or z, with the
// sixteen bits below as a fraction, and need not split it.
inline constexpr std::uint32_t kWordLocations[12] = {0, 1, 2, 3, 4, 5, 6, 7, 10, 11, 14, 15};

// Byte offsets in one vertex of each stream. Offsets of what is absent are unused.
struct VertexLayout {
  std::uint32_t influences = 4;                                   // the most of any vertex, 4 to 8
  std::uint32_t joint_bytes = 1;                                  // 1 or 2
  std::uint32_t ssd_stride = 0, ssd_weights = 0, ssd_joints = 0;  // the stream of SSD
  std::uint32_t example_row = 0;                                  // in SSD's stream; 0: there is none
  std::uint32_t as_stride = 0, as_tangents = 0, as_joints = 0;    // the stream of animation space
  bool surface_normals = false;                                   // there are tangents, and room for them
  std::uint32_t surface_stride = 0, normal = 0, tangent = 0, uv = 0, colour = 0;  // the stream that all deformers share
  bool uv_unorm = false;                                                          // unorm16×2, otherwise f32×2
};

// A mesh on the GPU. Vertices are the geometry's slots, so indices are used as they are.
//
// clang-format off
//   stream     what a vertex has in it               as
//   SSD        position                              snorm16×3
//              weight of the second influence        snorm16
//              weights of the others                 unorm16×2, ×4 or ×6; the first has what they leave of 1
//              joints                                u8×4, or ×8; u16 above 256 entries
//              PrepareOptions::psd: first change     u32; of vertices that no example moves 0
//   AS         coordinates, an influence             snorm16×4; their w sum to 32767, or less: see coordinate_scale
//              kSurfaceNormals: both tangents of it  snorm16×4 each; their w sum to 0
//              joints                                as SSD's
//   surface    normal                                octahedral snorm16×2
//              tangent                               octahedral snorm16×2, the sign in y
//              texture coordinates                   unorm16×2, or f32×2
//              colour                                unorm8×4
//   morphs     row of the morph texture              u32; of vertices that no target moves 0
//
//   bytes a vertex    SSD    AS    AS, kSurfaceNormals    surface, normals alone
//   4 influences       16    36                    100                         4
//   5                  24    48                    128                         4
//   6                  24    56                    152                         4
//   8                  28    72                    200                         4
// clang-format on
//
// The morph texture, RGBA16I, holds 8 B for each attribute, target and vertex that any target moves. The example
// texture holds 8 B for each example and vertex that it moves.
struct GpuMesh {
  std::uint32_t ssd_array = 0;        // vertex array objects; 0 where not asked for. Rigid uses this one too.
  std::uint32_t as_array = 0;         // of animation space
  std::uint32_t ssd_buffer = 0;       // the streams above, a buffer each
  std::uint32_t as_buffer = 0;        // of animation space
  std::uint32_t surface_buffer = 0;   // 0 for a mesh of bare positions
  std::uint32_t morph_buffer = 0;     // 0 for a mesh without morph targets
  std::uint32_t morph_texture = 0;    // likewise
  std::uint32_t example_texture = 0;  // 0 without PrepareOptions::psd, or examples
  std::uint32_t index_buffer = 0;     // of all three vertex arrays
  std::uint32_t index_count = 0;      // three a triangle
  std::uint32_t index_type = 0;       // GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
  std::uint32_t primitive = 4;        // what the indices draw: GL_TRIANGLES
  std::uint32_t slot_count = 0;       // as Geometry::slot_count
  std::uint32_t joint_count = 0;      // matrices in its palette
  std::uint32_t vertex_bytes = 0;     // all vertex buffers together
  std::uint8_t influences = 4;        // the most of any vertex, 4 to 8
  std::uint8_t features = 0;          // kNormals | …
  std::uint8_t morph_per_row = 1;     // texels a vertex: positions, normals, tangents
  std::uint8_t morph_shift = 0;       // the texture's width is 1 << morph_shift
  std::uint32_t morph_texels = 0;     // of a target
  float morph_unit = 1;               // 1 / half-extent, see prepare()
  float example_step = 1;             // of changes, in half-extents
  std::uint32_t distances = 0;        // distance_matrices() of the mesh, where it has examples here
  std::uint32_t distance_texels = 0;  // of them, a palette entry
  // Coordinates are stored divided by this; 1 unless a fitted weight lies outside [-1, 1].
  float coordinate_scale = 1;
  VertexLayout layout = {};  // of its vertex buffers
};

}  // namespace marrow::gles3
