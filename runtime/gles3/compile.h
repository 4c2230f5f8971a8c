// Texts → programs: what drawing and pre-skinning share.
#pragma once

#include "gles3/gl_constants.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/program.h"

namespace marrow::gles3 {

// The last source text of each stage, zero-terminated; null: the program has no such stage.
struct ShaderTexts {
  const char* vertex = nullptr;
  const char* fragment = nullptr;
  const char* compute = nullptr;
  Span<const char* const> feedback_varyings;
  GlEnum feedback_mode = kGlInterleavedAttribs;
  const char* role = "drawing";  // in the program's label
};

// Compiles and links a program and looks up its uniforms. A stage's source is #version and defines, the skinning text
// (except in fragment shaders), then the stage's own text. Errors: gl_error, with the driver's words in `log`. `out` is
// written only on success.
Status compile_program(const Api& api, const ProgramKey& key, const ShaderTexts& texts, std::uint32_t palette_binding,
                       Program& out, Span<char> log);

// Whether vertices are skinned by it.
constexpr bool skins(Deformer deformer) {
  return deformer != Deformer::none && deformer <= Deformer::psd;
}

// Whether crowds can be skinned by it. They have no distances to examples.
constexpr bool in_crowds(Deformer deformer) {
  return skins(deformer) && deformer != Deformer::psd;
}

// What animation space's vertex shaders read as 32-bit words, two vectors per attribute: the values of MARROW_WORDS.
//   all             everything. For Mali-G and NVIDIA, where attributes cost but unpacking in the shader does not.
//   all_whole       everything, and y and z are read as whole words. For more than four influences and surface normals,
//                   which would need too many attributes as vectors.
//   tangents_whole  the same for tangents alone. With five or six influences there is room for coordinates as vectors:
//                   for Adreno and Mali-T, where unpacking costs. VideoCore has the room too, but spills.
enum class Words : std::uint32_t { none, all, all_whole, tangents_whole };
Words words_read(const Api& api, std::uint32_t influences, bool surface_normals);

// Whether vertex shaders read all joints as one attribute, with two joints in each number.
bool reads_joint_pairs(const Api& api, std::uint32_t influences);

// Sets the uniforms that say how to read the mesh's vertices. The program must be in use.
void tell_of_vertices(const Api& api, const GpuMesh& mesh, const Program& program);

// Empties the log, if there is one.
void clear(Span<char> log);

}  // namespace marrow::gles3
