// Skin on the GPU by OpenGL ES 3.0: the driver's functions, what the context can do, a game's shaders.
//
//   gles3_skinner.h     draws a mesh as many characters
//   gles3_crowd.h       draws thousands of characters that the GPU poses
//   gles3_self_test.h   says which paths a driver gets right
//
// No globals, no allocation but the driver's, no linkage to a GL library. Everything here is called on the thread where
// the context is current. What a call leaves changed in the GL state is said with it. Nothing is deleted by itself: GL
// objects may only be deleted while their context is current, which the caller alone knows.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/gles3_functions.h"

namespace marrow::gles3 {

// The driver's entry points.
struct Api {
#define MARROW_MEMBER(Result, Name, Parameters) Entry<Result Parameters> Name{"gl" #Name};
  MARROW_GLES3_FUNCTIONS(MARROW_MEMBER)
  MARROW_GLES3_OPTIONAL_FUNCTIONS(MARROW_MEMBER)
#undef MARROW_MEMBER
};

// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader. Functions of OpenGL ES 3.1
// and of extensions stay null where the driver has none. If ObjectLabel is there (GL_KHR_debug, OpenGL ES 3.2), objects
// get labels for RenderDoc and drivers' tools ("newt: surface"); set it to null for none. Errors: bad_argument without
// a loader; unsupported if it returns null for a function of OpenGL ES 3.0, whose name is put in `missing` (static
// string). `api` is written only on success.
MARROW_API Status load_api(Api& api, void* (*load_proc)(const char* name), const char** missing = nullptr);

// Whether the GPU was reset, so that the context is lost with all that is in it. Ask once a frame: GL may report a
// reset only once. If so, call on_context_lost() for each object that has that function, destroy the context, make
// another, and call on_context_restored(). Always false without GetGraphicsResetStatus and EGL_LOSE_CONTEXT_ON_RESET.
MARROW_API bool context_was_reset(const Api& api);

// For debugging: reports to `watch` every GL error that a call through `api` or a copy of it causes; null ends that.
// The watch must live as long as they. GetError of `api` still returns the errors. A call costs two more, of
// glGetError.
MARROW_API void watch_errors(Api& api, ErrorWatch* watch);

// What the context can do. The defaults are the least that GLES 3.0 allows; tests force them on any driver.
struct Caps {
  std::uint32_t uniform_block_bytes = 16384;     // that one block may have
  std::uint32_t uniform_offset_alignment = 256;  // power of two
  std::uint32_t vertex_attributes = 16;          // of four numbers each
  std::uint32_t texture_size = 2048;             // along each side
  bool compute = false;                          // OpenGL ES 3.1 or newer, and its functions
};

// Errors: unsupported below OpenGL ES 3.0; gl_error.
MARROW_API Status query_caps(const Api& api, Caps& caps);

// How the GPU skins vertices. Multi-weight enveloping is for the CPU only: attributes do not hold its 192 bytes a
// vertex.
enum class Deformer : std::uint8_t {
  none,   // not at all: Marrow's own, of vertices that are skinned already
  rigid,  // the joint with the largest weight
  ssd,
  as,
  psd,  // SSD of what the mesh's pose space has moved, see skin_psd() in skin.h
};

// Features that a mesh has or a program reads, as bits.
inline constexpr std::uint8_t kNormals = 1;          // normals
inline constexpr std::uint8_t kTangents = 2;         // tangents
inline constexpr std::uint8_t kUvs = 4;              // texture coordinates
inline constexpr std::uint8_t kColours = 8;          // colours of vertices
inline constexpr std::uint8_t kMorphs = 16;          // morph targets
inline constexpr std::uint8_t kSurfaceNormals = 32;  // in animation space the deformed surface's own, by as_tangents()
inline constexpr std::uint8_t kMotion = 64;          // of programs: where vertices were in the previous frame

// The role's own texts, ESSL 3.00 without #version, zero-terminated. The vertex text comes after the skinning text
// (shaders/skin.glsl), which ends where main() is to begin; the fragment text after the same #version and defines.
// Examples: docs/gles/shaders.md.
// Both texts may test these macros with #if: MARROW_NORMAL, MARROW_TANGENT, MARROW_UV, MARROW_COLOUR, MARROW_MOTION: 1
// if the program was built to read it, else 0. MARROW_PALETTES: 2 in programs for crowds.
// What the vertex text may use:
//   MarrowVertex marrow_skin()       once; { vec3 position; vec3 normal; vec4 tangent; vec3 previous_position; } in
//                                    model space, normal and tangent of unit length, tangent.w the handedness; what is
//                                    not read is 0, but previous_position is then the position
//   vec2 in_uv, vec4 in_colour       attributes, where MARROW_UV, MARROW_COLOUR are 1
//   vec4 marrow_instance_colour()    of an instance of a crowd; else white
// Names that begin with marrow_, MARROW_, Marrow or in_ are Marrow's; all others the game's, uniforms, too: set those
// after UseProgram(program.id), by Api or by any other loader.
struct ProgramSource {
  const char* vertex = nullptr;                    // as above
  const char* fragment = nullptr;                  // as above
  Span<const char* const> feedback_varyings = {};  // for transform feedback, interleaved; empty otherwise
};

// A program of the driver, compiled by Marrow.
struct Program {
  std::uint32_t id = 0;                 // for UseProgram(); 0: none
  alignas(4) std::byte state[84] = {};  // Marrow's own
};

}  // namespace marrow::gles3
