// Skin before drawing: vertices that are skinned once and drawn several times, by the GPU or by the CPU.
#pragma once

#include "gles3/gl_constants.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/program.h"
#include "marrow/gles3_skinner.h"
#include "marrow/skin.h"

namespace marrow::gles3 {

// Bytes; what the mesh lacks has none.
struct SkinnedBlocks {
  std::uint32_t position_bytes = 0, normal_bytes = 0, tangent_bytes = 0;
  std::uint32_t normals = 0, tangents = 0;  // where they begin
  std::uint32_t bytes = 0;
};
SkinnedBlocks blocks_of(const SkinnedMesh& mesh);

// create_skinned(), with a name for labels.
Status make_skinned(const Api& api, const GpuMesh& mesh, const char* name, SkinnedMesh& out);

// Errors: gl_error (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER and the vertex
// array at 0.
Status create_skinned(const Api& api, const GpuMesh& mesh, SkinnedMesh& out);
// Deletes the GL objects and clears the struct.
void destroy(const Api& api, SkinnedMesh& mesh);

// Programs with kMotion take from `previous` where the vertices of `mesh` were in the frame before: another SkinnedMesh
// of the same GpuMesh, skinned then; or `mesh` itself, of what has no frame before. To be said again whenever it
// changes, so each frame where two take turns. Errors: bad_argument (of another number of slots). Leaves
// GL_ARRAY_BUFFER and the vertex array at 0.
Status set_previous(const Api& api, const SkinnedMesh& mesh, const SkinnedMesh& previous);

// What skin_ssd() and their like have written. The old contents are orphaned, so the CPU never waits for the GPU.
// Errors: bad_argument (a span of another size than the mesh has; normals or tangents may be empty, then they are
// undefined). Leaves GL_ARRAY_BUFFER at 0.
Status upload_skinned(const Api& api, SkinnedMesh& mesh, const SkinOutput& vertices);

// What skins vertices ahead of drawing.
enum class Preskin : std::uint8_t {
  feedback,  // transform feedback, OpenGL ES 3.0
  compute,   // compute shader, 3.1
};

// A program for preskin(), of the key's deformer, palettes, and of its features kNormals, kTangents, kMorphs and
// kSurfaceNormals. Those must be the mesh's.
// Errors: bad_argument (a key of Deformer::none, of a crowd, or with influences other than 4 to 8); unsupported
// (compute, without caps.compute); gl_error, with the driver's words in `log`. `out` is written only on success. Cost:
// a compile.
Status create_preskin(const Api& api, const Caps& caps, const ProgramKey& key, Preskin method,
                      std::uint32_t palette_binding, Program& out, Span<char> log = {});

// Skins every slot once into `to`, with the palette that is bound. `program` must be in use. By transform feedback it
// leaves the vertex array, the default transform feedback object's bindings 0 … 2 and GL_TRANSFORM_FEEDBACK_BUFFER at
// 0, and GL_RASTERIZER_DISCARD off; by compute shader GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3 at 0.
// Errors: bad_argument (a mesh that was not prepared for this deformer, a program of another kind).
Status preskin(const Api& api, const GpuMesh& mesh, Deformer deformer, const Program& program, const SkinnedMesh& to);

// Draws all triangles with the program in use, one with Deformer::none. Leaves the vertex array at 0.
void draw(const Api& api, const GpuMesh& mesh, const SkinnedMesh& skinned);

}  // namespace marrow::gles3
