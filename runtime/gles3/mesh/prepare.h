// Once a mesh: its vertices into the GPU's memory; and how it is drawn.
#pragma once

#include "core/check.h"
#include "gles3/mesh/gpu_mesh.h"

namespace marrow::gles3 {

// What prepare() puts on the GPU.
struct PrepareOptions {
  bool ssd = true;  // also what rigid draws from
  bool as = true;   // ssd and as both false: for vertices skinned on the CPU
  // From as_tangents() of this mesh: then animation space draws the deformed surface's own normals, and `features` has
  // kSurfaceNormals. Empty, or of a mesh with morph targets or without normals: normals through the blend.
  Span<const float> as_tangents = {};
  // With `ssd`: also what Deformer::psd draws from. Adds nothing to a mesh without examples.
  bool psd = false;
};

// Checks that the mesh has vertices, joints and a finite box, and animation-space tangents for all of it or for none.
BadCall check_mesh(const Mesh& mesh, const PrepareOptions& options);

// Bytes of scratch memory that prepare() wants: as much as the largest of its vertex buffers. With `psd` the SSD buffer
// counts together with all changes.
std::size_t prepare_scratch_bytes(const Mesh& mesh, const PrepareOptions& options = {});

// Uploads a mesh, and writes the bind matrices to build its palettes with:
//   bind[i] = inverse_bind[i] · [h·I | c]
// c is the middle of the bind box, h one half-extent for all axes: attributes hold (v - c) / h in [-1, 1]³ and the
// shader need not undo it. The same palette serves rigid, SSD and AS. In animation space the stored coordinate of an
// influence is (w (v - c) + d - δ c, (w + δ) h) / h; where residuals need more room, h grows for the whole mesh.
//
// bind: at least mesh.joint_count, the caller's to keep. scratch: at least prepare_scratch_bytes(), 4-byte aligned,
// free again afterwards. Errors: bad_argument (a mesh without vertices or with another one's geometry, a span too
// short); unsupported (more morph targets or examples than a texture of 2048 × 2048 holds); gl_error (out of memory:
// nothing is left allocated). `out` and `bind` are written only on success. Leaves GL_ARRAY_BUFFER, the vertex array
// and, of a mesh with morph targets or, with `psd`, examples, the active unit's 2D texture at 0. Error of the formats:
// docs/performance.md. Cost: a few passes over the vertices; once a mesh.
Status prepare(const Api& api, const Caps& caps, const Mesh& mesh, const PrepareOptions& options,
               Span<std::byte> scratch, Span<Affine> bind, GpuMesh& out);

// Deletes the GL objects and clears the struct.
void destroy(const Api& api, GpuMesh& mesh);

// Draws all triangles of `instances` characters; more than one only with palettes in a texture. `program` must be in
// use, its palette bound. Leaves the vertex array at 0. The game sets culling. As glTF has it, GL_CULL_FACE is enabled
// unless Mesh::double_sided, and fronts are GL_CCW, or GL_CW where turns_inside_out(palette), see palette.h. So
// characters that mirror need a draw call of their own.
// Errors: bad_argument if the mesh was not prepared for this deformer.
Status draw(const Api& api, const GpuMesh& mesh, Deformer deformer, const Program& program,
            std::uint32_t instances = 1);

}  // namespace marrow::gles3
