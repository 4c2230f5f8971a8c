// Texts → programs: what drawing and pre-skinning share.
#pragma once

#include "gles3/gl_constants.h"
#include "marrow/gles3.h"

namespace marrow::gles3 {

// The end of the texts of a stage: of the skinning text or the role's, zero-terminated; null: no such stage.
struct ShaderTexts {
  const char* vertex = nullptr;
  const char* fragment = nullptr;
  const char* compute = nullptr;
  Span<const char* const> feedback_varyings;
  GlEnum feedback_mode = kGlInterleavedAttribs;
  const char* role = "drawing";  // in the program's label
};

// #version and defines, then the skinning text (not before the fragment text), then each text; compiled, linked and
// its uniforms looked up. Errors: gl_error, with the driver's words in `log`. `out` is written only on success.
Status compile_program(const Api& api, const ProgramKey& key, const ShaderTexts& texts, std::uint32_t palette_binding,
                       Program& out, Span<char> log);

// Whether vertices are skinned by it.
constexpr bool skins(Deformer deformer) {
  return deformer != Deformer::none && deformer <= Deformer::psd;
}

// Whether crowds are: they know no distances to examples.
constexpr bool in_crowds(Deformer deformer) {
  return skins(deformer) && deformer != Deformer::psd;
}

// What vertex shaders of animation space read as words, two vectors an attribute: as MARROW_WORDS. Mali-G and NVIDIA
// pay for attributes but not for unpacking in the shader. With more than four influences and surface normals vectors
// would be too many: then y and z are the whole word. With five or six Adreno and Mali-T, which pay for unpacking, have
// room for coordinates as vectors; so would VideoCore, but it spills.
enum class Words : std::uint32_t { none, all, all_whole, tangents_whole };
Words words_read(const Api& api, std::uint32_t influences, bool surface_normals);

// Whether vertex shaders read all joints as one attribute, each two as a number.
bool reads_joint_pairs(const Api& api, std::uint32_t influences);

// How the mesh's vertices are to be read: uniforms of the program, which is in use.
void tell_of_vertices(const Api& api, const GpuMesh& mesh, const Program& program);

// Empties it, where there is any.
void clear(Span<char> log);

}  // namespace marrow::gles3
