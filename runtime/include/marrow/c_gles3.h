// Skinning by OpenGL ES 3.0 for C99, and for all languages that call C: see docs/c.md. Library marrow::c_gles3.
//
// Made by tools/c_api from runtime/c/gles3.txt and the C++ headers: do not edit. Lists, structs that are filled in, and
// what may be null are as marrow/c.h says.
//
// A pointer that is null or off the boundary of its type is refused, and so is an mrw_gles3_api full of zeros, which
// mrw_gles3_load_api() has not filled yet.
#ifndef MARROW_C_GLES3_H
#define MARROW_C_GLES3_H

#include "marrow/c.h"

// clang-format off
#ifdef __cplusplus
extern "C" {
#endif

// A number that all rows of the description give: it changes with every struct, enum, constant and function.
#define MRW_GLES3_ABI 0xe1176ccbu
// That of the library. A program compares it with its own MRW_GLES3_ABI before it calls anything else.
uint32_t mrw_gles3_abi(void);


// ---- Part gles3_entry -----------------------------------------------------------------------------------------------
// An entry point of the driver, and who watches its calls for errors.

typedef void (*mrw_gles3_error_report)(void* user, const char* call, uint32_t error);

typedef uint32_t (*mrw_gles3_get_error)(void);

// Told of every GL error by the call that caused it: for debugging, as each call is then between two of glGetError.
// One an mrw_gles3_api and thread.
typedef struct mrw_gles3_error_watch mrw_gles3_error_watch;
struct mrw_gles3_error_watch {
  // call: "glBindBuffer", a static string. May be null.
  // what `report` gets
  mrw_gles3_error_report report;
  // call: "glBindBuffer", a static string. May be null.
  // what `report` gets
  void* user;
  uint32_t pending;  // what the mrw_gles3_api's GetError has yet to tell, as it would without a watch
  mrw_gles3_get_error get_error;  // the driver's glGetError
};
void mrw_gles3_error_watch_init(mrw_gles3_error_watch* out);

// ---- Part gles3 -----------------------------------------------------------------------------------------------------
// Skin on the GPU: bind vertices in vertex buffers and a palette in a uniform block → pixels, by OpenGL ES 3.0.
//
//   once a context   mrw_gles3_load_api, mrw_gles3_query_caps, mrw_gles3_create_palette_ring, mrw_gles3_create_program
//   once a mesh      mrw_gles3_prepare(): compact attributes, and the bind matrices that undo their quantisation
//   every frame      mrw_gles3_begin_frame, then for each mesh: mrw_build_palette_of_joints(mesh.joints, bind, joints,
//                    …) → mrw_gles3_push_palette → mrw_gles3_set_morphs, if it has morph targets →
//                    mrw_gles3_bind_examples, for its pose space → mrw_gles3_draw_mesh()
//
// No globals, no allocation but the driver's, no linkage to a GL library. Everything here is called on the thread where
// the context is current. What a call leaves changed in the GL state is said with it. Nothing is deleted by itself: GL
// objects may only be deleted while their context is current, which the caller alone knows.

typedef void* (*mrw_gles3_load_proc)(const char* name);

// The driver's entry points.
typedef struct mrw_gles3_api mrw_gles3_api;
struct mrw_gles3_api {
  size_t words[222];
};

// How the GPU skins vertices. Multi-weight enveloping is for the CPU only: with four influences it needs 192 bytes a
// vertex, more than attributes hold.
typedef uint8_t mrw_gles3_deformer;
enum {
  MRW_GLES3_DEFORMER_NONE = 0,  // vertices skinned elsewhere, in float: position, normal, tangent
  MRW_GLES3_DEFORMER_RIGID = 1,  // the joint with the largest weight
  MRW_GLES3_DEFORMER_SSD = 2,
  MRW_GLES3_DEFORMER_AS = 3,
  MRW_GLES3_DEFORMER_PSD = 4,  // SSD of what the mesh's pose space has moved, see mrw_skin_psd() in part skin of c.h
};

// Where a program finds its palettes.
typedef uint8_t mrw_gles3_palettes;
enum {
  MRW_GLES3_PALETTES_UNIFORM_BLOCK = 0,  // mrw_gles3_palette_ring: one palette a draw call
  MRW_GLES3_PALETTES_TEXTURE = 1,  // mrw_gles3_palette_texture: of any size; one draw call may draw many characters
  // mrw_gles3_crowd_mesh, see part gles3_crowd: likewise, without work on the CPU; not for MRW_GLES3_DEFORMER_NONE, psd
  // or MRW_GLES3_MORPHS
  MRW_GLES3_PALETTES_CROWD = 2,
};

// Features that a mesh has or a program reads, as bits: normals.
#define MRW_GLES3_NORMALS 1u

// Tangents.
#define MRW_GLES3_TANGENTS 2u

// Texture coordinates.
#define MRW_GLES3_UVS 4u

// Colours of vertices.
#define MRW_GLES3_COLOURS 8u

// Morph targets.
#define MRW_GLES3_MORPHS 16u

// In animation space normals and tangents are the deformed surface's own, by mrw_as_tangents(): see
// mrw_gles3_prepare_options.
#define MRW_GLES3_SURFACE_NORMALS 32u

// Only of programs: where each vertex was in the previous frame, for motion vectors.
#define MRW_GLES3_MOTION 64u

// Attribute locations of the skinning text, fixed so that any program draws any mesh. There is one exception: animation
// space with MRW_GLES3_SURFACE_NORMALS has other vectors at the locations of normals and tangents, so only programs
// with MRW_GLES3_SURFACE_NORMALS draw it.
#define MRW_GLES3_POSITION_LOCATION 0u  // animation space: 0 … 7 are the coordinates
#define MRW_GLES3_WEIGHTS_LOCATION 1u  // and 2
#define MRW_GLES3_JOINTS_LOCATION 8u  // and 9; on Mali-G up to eight here, two in a number
#define MRW_GLES3_NORMAL_LOCATION 10u  // octahedral
#define MRW_GLES3_TANGENT_LOCATION 11u  // octahedral, and the handedness
#define MRW_GLES3_UV_LOCATION 12u  // in_uv
#define MRW_GLES3_COLOUR_LOCATION 13u  // in_colour
#define MRW_GLES3_MORPH_ROW_LOCATION 14u  // row of the morph texture
#define MRW_GLES3_EXAMPLE_ROW_LOCATION 15u  // row of the texture of examples

// The most morph targets that a vertex shader adds at a time: a quarter of the uniforms that GLES 3.0 promises.
#define MRW_GLES3_MORPH_TARGETS 64u

// Attribute locations of the skinning text, fixed so that any program draws any mesh. There is one exception: animation
// space with MRW_GLES3_SURFACE_NORMALS has other vectors at the locations of normals and tangents, so only programs
// with MRW_GLES3_SURFACE_NORMALS draw it.
#define MRW_GLES3_PREVIOUS_LOCATION 1u  // MRW_GLES3_DEFORMER_NONE with MRW_GLES3_MOTION: the previous position

// Matrices in the uniform block of the programs: as many as fit the smallest block that GLES 3.0 allows.
#define MRW_GLES3_PALETTE_JOINTS 341u

// Bytes of that block.
#define MRW_GLES3_PALETTE_BLOCK_BYTES 16368u

// Texels a row of the texture: what GLES 3.0 promises.
#define MRW_GLES3_PALETTE_TEXTURE_WIDTH 2048u

// What the context can do. The defaults are the least that GLES 3.0 allows; tests force them on any driver.
typedef struct mrw_gles3_caps mrw_gles3_caps;
struct mrw_gles3_caps {
  uint32_t uniform_block_bytes;  // that one block may have
  uint32_t uniform_offset_alignment;  // power of two
  uint32_t vertex_attributes;  // of four numbers each
  uint32_t texture_size;  // along each side
  bool compute;  // OpenGL ES 3.1 or newer, and its functions
};
void mrw_gles3_caps_init(mrw_gles3_caps* out);

// Byte offsets in one vertex of each stream. Offsets of what is absent are unused.
typedef struct mrw_gles3_vertex_layout mrw_gles3_vertex_layout;
struct mrw_gles3_vertex_layout {
  uint32_t influences;  // the most of any vertex, 4 to 8
  uint32_t joint_bytes;  // 1 or 2
  uint32_t ssd_stride;  // the stream of SSD
  uint32_t ssd_weights;  // the stream of SSD
  uint32_t ssd_joints;  // the stream of SSD
  uint32_t example_row;  // in SSD's stream; 0: there is none
  uint32_t as_stride;  // the stream of animation space
  uint32_t as_tangents;  // the stream of animation space
  uint32_t as_joints;  // the stream of animation space
  bool surface_normals;  // there are tangents, and room for them
  uint32_t surface_stride;  // the stream that all deformers share
  uint32_t normal;  // the stream that all deformers share
  uint32_t tangent;  // the stream that all deformers share
  uint32_t uv;  // the stream that all deformers share
  uint32_t colour;  // the stream that all deformers share
  bool uv_unorm;  // unorm16×2, otherwise f32×2
};
void mrw_gles3_vertex_layout_init(mrw_gles3_vertex_layout* out);

// A mesh on the GPU. Vertices are the geometry's slots, so indices are used as they are.
//
//   stream     what a vertex has in it               as
//   SSD        position                              snorm16×3
//              weight of the second influence        snorm16
//              weights of the others                 unorm16×2, ×4 or ×6; the first has what they leave of 1
//              joints                                u8×4, or ×8; u16 above 256 entries
//              mrw_gles3_prepare_options.psd: first change     u32; of vertices that no example moves 0
//   AS         coordinates, an influence             snorm16×4; their w sum to 32767, or less: see coordinate_scale
//              MRW_GLES3_SURFACE_NORMALS: both tangents of it  snorm16×4 each; their w sum to 0
//              joints                                as SSD's
//   surface    normal                                octahedral snorm16×2
//              tangent                               octahedral snorm16×2, the sign in y
//              texture coordinates                   unorm16×2, or f32×2
//              colour                                unorm8×4
//   morphs     row of the morph texture              u32; of vertices that no target moves 0
//
//   bytes a vertex    SSD    AS    AS, MRW_GLES3_SURFACE_NORMALS    surface, normals alone
//   4 influences       16    36                    100                         4
//   5                  24    48                    128                         4
//   6                  24    56                    152                         4
//   8                  28    72                    200                         4
//
// The morph texture, RGBA16I, holds 8 B for each attribute, target and vertex that any target moves. The example
// texture holds 8 B for each example and vertex that it moves.
typedef struct mrw_gles3_gpu_mesh mrw_gles3_gpu_mesh;
struct mrw_gles3_gpu_mesh {
  uint32_t ssd_array;  // vertex array objects; 0 where not asked for. Rigid uses this one too.
  uint32_t as_array;  // of animation space
  uint32_t ssd_buffer;  // the streams above, a buffer each
  uint32_t as_buffer;  // of animation space
  uint32_t surface_buffer;  // 0 for a mesh of bare positions
  uint32_t morph_buffer;  // 0 for a mesh without morph targets
  uint32_t morph_texture;  // likewise
  uint32_t example_texture;  // 0 without mrw_gles3_prepare_options.psd, or examples
  uint32_t index_buffer;  // of all three vertex arrays
  uint32_t index_count;  // three a triangle
  uint32_t index_type;  // GL_UNSIGNED_SHORT or GL_UNSIGNED_INT
  uint32_t primitive;  // what the indices draw: GL_TRIANGLES
  uint32_t slot_count;  // as mrw_geometry.slot_count
  uint32_t joint_count;  // matrices in its palette
  uint32_t vertex_bytes;  // all vertex buffers together
  uint8_t influences;  // the most of any vertex, 4 to 8
  uint8_t features;  // MRW_GLES3_NORMALS | …
  uint8_t morph_per_row;  // texels a vertex: positions, normals, tangents
  uint8_t morph_shift;  // the texture's width is 1 << morph_shift
  uint32_t morph_texels;  // of a target
  float morph_unit;  // 1 / half-extent, see mrw_gles3_prepare()
  float example_step;  // of changes, in half-extents
  uint32_t distances;  // mrw_gles3_distance_matrices() of the mesh, where it has examples here
  uint32_t distance_texels;  // of them, a palette entry
  float coordinate_scale;  // Coordinates are stored divided by this; 1 unless a fitted weight lies outside [-1, 1].
  mrw_gles3_vertex_layout layout;  // of its vertex buffers
};
void mrw_gles3_gpu_mesh_init(mrw_gles3_gpu_mesh* out);

// What mrw_gles3_prepare() puts on the GPU.
typedef struct mrw_gles3_prepare_options mrw_gles3_prepare_options;
struct mrw_gles3_prepare_options {
  bool ssd;  // also what rigid draws from
  bool as;  // ssd and as both false: for vertices skinned on the CPU
  // From mrw_as_tangents() of this mesh: then animation space draws the deformed surface's own normals, and `features`
  // has MRW_GLES3_SURFACE_NORMALS. Empty, or of a mesh with morph targets or without normals: normals through the
  // blend.
  const float* as_tangents;
  size_t as_tangent_count;
  bool psd;  // With `ssd`: also what MRW_GLES3_DEFORMER_PSD draws from. Adds nothing to a mesh without examples.
};
void mrw_gles3_prepare_options_init(mrw_gles3_prepare_options* out);

// What a program is compiled for. With MRW_GLES3_MORPHS it draws only meshes that have targets; call
// mrw_gles3_set_morphs() before each. With MRW_GLES3_MOTION it skins twice: by this frame's palettes and, positions
// only, by the previous frame's. Bind the previous palettes for each draw call, too:
//   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by
//                        mrw_gles3_bind_palette()
//   in a texture         mrw_gles3_bind_previous_palette(); of crowds mrw_gles3_bind_crowd() does it
//   skinned elsewhere    mrw_gles3_set_previous(), see part gles3_skinned
// and with MRW_GLES3_MORPHS mrw_gles3_set_previous_morphs().
typedef struct mrw_gles3_program_key mrw_gles3_program_key;
struct mrw_gles3_program_key {
  mrw_gles3_deformer deformer;  // by which vertices are skinned
  uint8_t influences;  // 4 to 8: that of the mesh or more
  uint8_t features;  // MRW_GLES3_NORMALS | …: the mesh's features that it reads
  mrw_gles3_palettes palettes;  // where it finds palettes
};
void mrw_gles3_program_key_init(mrw_gles3_program_key* out);

// The role's own texts, ESSL 3.00 without #version, zero-terminated. The vertex text comes after the skinning text
// (shaders/skin.glsl), which ends where main() is to begin; the fragment text after the same #version and defines.
//
//   void main() {
//     MarrowVertex v = marrow_skin();
//     gl_Position = clip_from_model * vec4(v.position, 1.0);
//   }
//
// Both texts may test these macros with #if: MARROW_NORMAL, MARROW_TANGENT, MARROW_UV, MARROW_COLOUR, MARROW_MOTION: 1
// if the program was built to read it (mrw_gles3_program_key.features), else 0. MARROW_PALETTES: 2 in programs for
// crowds. What the vertex text may use:
//   MarrowVertex marrow_skin()       once; { vec3 position; vec3 normal; vec4 tangent; vec3 previous_position; } in
//                                    model space, normal and tangent of unit length, tangent.w the handedness; what is
//                                    not read is 0, but previous_position is then the position
//   vec2 in_uv, vec4 in_colour       attributes, where MARROW_UV, MARROW_COLOUR are 1
//   vec4 marrow_instance_colour()    of an instance of a crowd; else white
// Names that begin with marrow_, MARROW_, Marrow or in_ are Marrow's; all others the game's, uniforms, too: set those
// after UseProgram(program.id), by mrw_gles3_api or by any other loader.
typedef struct mrw_gles3_program_source mrw_gles3_program_source;
struct mrw_gles3_program_source {
  const char* vertex;  // as above
  const char* fragment;  // as above
  const char* const* feedback_varyings;  // for transform feedback, interleaved; empty otherwise
  size_t feedback_varying_count;
};
void mrw_gles3_program_source_init(mrw_gles3_program_source* out);

// A program of the driver and where its uniforms are. Filled in by Marrow.
typedef struct mrw_gles3_program mrw_gles3_program;
struct mrw_gles3_program {
  uint32_t id;  // for UseProgram(); 0: none
  mrw_gles3_palettes reads;  // where it reads palettes
  bool motion;  // built with MRW_GLES3_MOTION
  // Locations of uniforms.
  // of attributes; here and below -1: there is none
  int32_t coordinate_scale;
  // Locations of uniforms.
  // of attributes; here and below -1: there is none
  int32_t joint_bits;
  int32_t palettes;  // of palettes in a texture
  int32_t first_row;  // of palettes in a texture
  int32_t instances;  // of crowds
  int32_t crowd;  // of crowds
  int32_t vertex_layout;  // of pre-skinning by compute shaders
  int32_t morph_changes;  // of morph targets
  int32_t morph_targets;  // of morph targets
  int32_t morph_count;  // of morph targets
  int32_t morph_shift;  // of morph targets
  int32_t morph_per_row;  // of morph targets
  int32_t previous_palettes;  // of the frame before
  int32_t previous_targets;  // of the frame before
  int32_t previous_count;  // of the frame before
  int32_t examples;  // of pose spaces
  int32_t example_step;  // of pose spaces
  int32_t distances;  // of pose spaces
  int32_t distance_row;  // of pose spaces
  int32_t previous_distances;  // of pose spaces
};
void mrw_gles3_program_init(mrw_gles3_program* out);

// One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
// contents are orphaned, so the CPU never waits for the GPU.
typedef struct mrw_gles3_palette_ring mrw_gles3_palette_ring;
struct mrw_gles3_palette_ring {
  uint32_t buffer;  // a uniform buffer; 0: none
  uint32_t alignment;  // of offsets, bytes
  uint32_t capacity;  // bytes that palettes may use
  uint32_t used;  // bytes, since mrw_gles3_begin_frame()
};
void mrw_gles3_palette_ring_init(mrw_gles3_palette_ring* out);

// All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Three textures take turns, each written
// every third frame, so that the driver need not wait for a texture that it still draws from, or copy it.
typedef struct mrw_gles3_palette_texture mrw_gles3_palette_texture;
struct mrw_gles3_palette_texture {
  uint32_t textures[3];  // 0: none
  uint32_t current;  // which was written last
  uint32_t capacity;  // matrices
  uint32_t count;  // matrices in the current texture
  uint32_t previous_count;  // matrices in the previous frame's texture
};
void mrw_gles3_palette_texture_init(mrw_gles3_palette_texture* out);

// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader.
// Errors: MRW_BAD_ARGUMENT without a loader; MRW_UNSUPPORTED if it returns null for a function of OpenGL ES 3.0, whose
// name is put in `missing` (static string). Functions of 3.1 stay null where the driver has none. `api` is written only
// on success.
//
// ObjectLabel is there with GL_KHR_debug or OpenGL ES 3.2. GL objects are then labelled as they are made, for RenderDoc
// and drivers' tools ("newt: surface"); set ObjectLabel to null to leave them without labels. GetGraphicsResetStatus is
// there with GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
// May be null: missing.
mrw_status mrw_gles3_load_api(mrw_gles3_api* api, mrw_gles3_load_proc load_proc, const char** missing) MRW_NODISCARD;

// Whether the GPU was reset, so that the context is lost with all that is in it. Ask once a frame. If so, call
// mrw_gles3_…_on_context_lost() for each object that has that function, destroy the context, make another, and call
// mrw_gles3_…_on_context_restored(). It can be true only if GetGraphicsResetStatus is there and the context was created
// to be lost on a reset (EGL_LOSE_CONTEXT_ON_RESET). Other contexts never report one here, and platforms have ways of
// their own (EGL_CONTEXT_LOST of eglSwapBuffers). GL may report each reset only once.
bool mrw_gles3_context_was_reset(const mrw_gles3_api* api);

// Reports to `watch` every GL error that a call through `api` or a copy of it causes, with the call's name; null ends
// the reports. The watch must live as long as `api` and its copies. The watch does not hide errors: GetError of `api`
// still returns them. For debugging: without a watch a call costs one more comparison, with a watch two calls of
// glGetError.
// May be null: watch.
void mrw_gles3_watch_errors(mrw_gles3_api* api, mrw_gles3_error_watch* watch);

// Errors: MRW_UNSUPPORTED below OpenGL ES 3.0; MRW_GL_ERROR.
mrw_status mrw_gles3_query_caps(const mrw_gles3_api* api, mrw_gles3_caps* caps) MRW_NODISCARD;

// Bytes of scratch memory that mrw_gles3_prepare() wants: as much as the largest of its vertex buffers. With `psd` the
// SSD buffer counts together with all changes.
// May be null: options.
size_t mrw_gles3_prepare_scratch_bytes(const mrw_mesh* mesh, const mrw_gles3_prepare_options* options);

// Uploads a mesh, and writes the bind matrices to build its palettes with:
//   bind[i] = inverse_bind[i] · [h·I | c]
// c is the middle of the bind box, h one half-extent for all axes: attributes hold (v - c) / h in [-1, 1]³ and the
// shader need not undo it. The same palette serves rigid, SSD and AS. In animation space the stored coordinate of an
// influence is (w (v - c) + d - δ c, (w + δ) h) / h; where residuals need more room, h grows for the whole mesh.
//
// bind: at least mesh.joint_count, the caller's to keep. scratch: at least mrw_gles3_prepare_scratch_bytes(), 4-byte
// aligned, free again afterwards. Errors: MRW_BAD_ARGUMENT (a mesh without vertices or with another one's geometry, a
// list too short); MRW_UNSUPPORTED (more morph targets or examples than a texture of 2048 × 2048 holds); MRW_GL_ERROR
// (out of memory: nothing is left allocated). `out` and `bind` are written only on success. Leaves GL_ARRAY_BUFFER, the
// vertex array and, of a mesh with morph targets or, with `psd`, examples, the active unit's 2D texture at 0. Error of
// the formats: docs/performance.md. Cost: a few passes over the vertices; once a mesh.
// May be null: options.
mrw_status mrw_gles3_prepare(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_prepare_options* options, void* scratch, size_t scratch_bytes, mrw_affine* bind, size_t bind_count,
    mrw_gles3_gpu_mesh* out) MRW_NODISCARD;

// Deletes the GL objects and clears the struct.
void mrw_gles3_destroy_mesh(const mrw_gles3_api* api, mrw_gles3_gpu_mesh* mesh);

// Compiles and links. The palette block is tied to uniform buffer binding `palette_binding`; with MRW_GLES3_MOTION the
// previous frame's block is tied to the next binding.
// Errors: MRW_BAD_ARGUMENT (a text missing, influences other than 4 to 8, what crowds cannot); MRW_GL_ERROR, with the
// driver's words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a
// frame.
mrw_status mrw_gles3_create_program(const mrw_gles3_api* api, const mrw_gles3_program_key* key,
    const mrw_gles3_program_source* source, uint32_t palette_binding, mrw_gles3_program* out, char* log,
    size_t log_bytes) MRW_NODISCARD;

// Deletes the program and clears the struct.
void mrw_gles3_destroy_program(const mrw_gles3_api* api, mrw_gles3_program* program);

// Room for palettes of `joints` matrices altogether in `palettes` pieces.
// Errors: MRW_BAD_ARGUMENT (zero); MRW_UNSUPPORTED (caps of less than OpenGL ES 3.0); MRW_GL_ERROR. Leaves
// GL_UNIFORM_BUFFER at 0.
mrw_status mrw_gles3_create_palette_ring(const mrw_gles3_api* api, const mrw_gles3_caps* caps, uint32_t joints,
    uint32_t palettes, mrw_gles3_palette_ring* out) MRW_NODISCARD;

// Deletes the buffer and clears the struct.
void mrw_gles3_destroy_palette_ring(const mrw_gles3_api* api, mrw_gles3_palette_ring* ring);

// Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
void mrw_gles3_begin_frame(const mrw_gles3_api* api, mrw_gles3_palette_ring* ring);

// Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
// ring. Errors: MRW_BAD_ARGUMENT (empty, or more than MRW_GLES3_PALETTE_JOINTS); MRW_UNSUPPORTED (the ring is full
// until mrw_gles3_begin_frame).
mrw_status mrw_gles3_push_palette(const mrw_gles3_api* api, mrw_gles3_palette_ring* ring, const mrw_affine* palette,
    size_t palette_count, uint32_t* offset) MRW_NODISCARD;

// Ties the palette at `offset` to uniform buffer binding `binding`.
void mrw_gles3_bind_palette(const mrw_gles3_api* api, const mrw_gles3_palette_ring* ring, uint32_t offset,
    uint32_t binding);

// Room for `joints` matrices: 48 B each, three times.
// Errors: MRW_BAD_ARGUMENT (zero); MRW_UNSUPPORTED (more than a texture of the caps' size holds: 1.39 million in
// 2048²); MRW_GL_ERROR. Leaves the active unit's 2D texture at 0.
mrw_status mrw_gles3_create_palette_texture(const mrw_gles3_api* api, const mrw_gles3_caps* caps, uint32_t joints,
    mrw_gles3_palette_texture* out) MRW_NODISCARD;

// Deletes the textures and clears the struct.
void mrw_gles3_destroy_palette_texture(const mrw_gles3_api* api, mrw_gles3_palette_texture* texture);

// Once a frame: uploads all palettes, one after the other, those of one mesh's instances together. mrw_build_palette()
// may write straight into such an array. 48 bytes a matrix go up, and nothing else. Errors: MRW_BAD_ARGUMENT (empty);
// MRW_UNSUPPORTED (more than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must
// be 0.
mrw_status mrw_gles3_upload_palettes(const mrw_gles3_api* api, mrw_gles3_palette_texture* texture,
    const mrw_affine* palettes, size_t palette_count) MRW_NODISCARD;

// Lets `program` draw with uploaded palettes: instance i takes the one that begins at matrix first + joints · i. The
// program must be in use and read palettes from a texture. Leaves `texture_unit` active and the texture bound to it.
// Errors: MRW_BAD_ARGUMENT (a program of another kind, a palette that reaches beyond what was uploaded).
mrw_status mrw_gles3_bind_texture_palette(const mrw_gles3_api* api, const mrw_gles3_palette_texture* texture,
    uint32_t first, uint32_t joints, uint32_t texture_unit, const mrw_gles3_program* program) MRW_NODISCARD;

// Binds the palettes of the previous frame, which are still there, for a program with MRW_GLES3_MOTION. Pass the same
// arguments as to mrw_gles3_bind_palette(). kept: false for characters that the previous frame did not have; this
// frame's palettes are then bound in place of the previous ones, and nothing moves. Leaves `texture_unit` active and
// the texture bound to it. Nothing is bound for a program whose text does not read previous_position. Errors:
// MRW_BAD_ARGUMENT (a program of another kind, a palette that reaches beyond what was uploaded in that frame).
mrw_status mrw_gles3_bind_previous_palette(const mrw_gles3_api* api, const mrw_gles3_palette_texture* texture,
    uint32_t first, uint32_t joints, bool kept, uint32_t texture_unit, const mrw_gles3_program* program) MRW_NODISCARD;

// Sets the weights, one a target, by which `program` morphs; the program must be in use. It morphs as mrw_morph() does
// on the CPU, in animation space through the same blend as normals. If more than MRW_GLES3_MORPH_TARGETS weights are
// not 0, the targets that move most count. Leaves `texture_unit` active and the mesh's texture bound to it. Errors:
// MRW_BAD_ARGUMENT (a mesh without targets, a program without MRW_GLES3_MORPHS, too few weights, one that is not
// finite).
mrw_status mrw_gles3_set_morphs(const mrw_gles3_api* api, const mrw_mesh* mesh, const mrw_gles3_gpu_mesh* gpu,
    const float* weights, size_t weight_count, uint32_t texture_unit, const mrw_gles3_program* program) MRW_NODISCARD;

// The weights of the frame before, for a program with MRW_GLES3_MOTION, after mrw_gles3_set_morphs(). Errors: as there.
mrw_status mrw_gles3_set_previous_morphs(const mrw_gles3_api* api, const mrw_mesh* mesh, const mrw_gles3_gpu_mesh* gpu,
    const float* weights, size_t weight_count, const mrw_gles3_program* program) MRW_NODISCARD;

// Room that mrw_gles3_pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and
// four examples. 0 without examples.
uint32_t mrw_gles3_distance_matrices(const mrw_geometry* geometry);

// How far a pose is from the examples, in the order in which MRW_GLES3_DEFORMER_PSD reads it: otherwise as
// mrw_psd_distances(). Upload it as palettes are, together with those of other characters: by
// mrw_gles3_upload_palettes() into an mrw_gles3_palette_texture of its own, on every path. palette: built with the bind
// matrices of mrw_gles3_prepare() or with the mesh's; the result is the same. out: mrw_gles3_distance_matrices().
// Errors: MRW_BAD_ARGUMENT (no examples, a list too short). Cost: that of mrw_psd_distances().
mrw_status mrw_gles3_pack_distances(const mrw_geometry* geometry, const mrw_affine* palette, size_t palette_count,
    mrw_affine* out, size_t out_count) MRW_NODISCARD;

// Lets `program` deform by the mesh's examples and by uploaded distances: instance i takes those that begin at matrix
// first + mrw_gles3_gpu_mesh.distances · i. The program must be in use and of MRW_GLES3_DEFORMER_PSD. Leaves
// `texture_unit` and the next one taken, the latter active. Errors: MRW_BAD_ARGUMENT (a mesh without examples, a
// program of another kind, distances that reach beyond what was uploaded).
mrw_status mrw_gles3_bind_examples(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh,
    const mrw_gles3_palette_texture* distances, uint32_t first, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// The distances of the frame before, for a program with MRW_GLES3_MOTION, after mrw_gles3_bind_examples(). kept and
// errors: as in mrw_gles3_bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
mrw_status mrw_gles3_bind_previous_distances(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh,
    const mrw_gles3_palette_texture* distances, uint32_t first, bool kept, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Draws all triangles of `instances` characters; more than one only with palettes in a texture. `program` must be in
// use, its palette bound. Leaves the vertex array at 0. The game sets culling. As glTF has it, GL_CULL_FACE is enabled
// unless mrw_mesh.double_sided, and fronts are GL_CCW, or GL_CW where mrw_palette_turns_inside_out(palette), see part
// palette of c.h. So characters that mirror need a draw call of their own.
// Errors: MRW_BAD_ARGUMENT if the mesh was not prepared for this deformer.
mrw_status mrw_gles3_draw_mesh(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh, mrw_gles3_deformer deformer,
    const mrw_gles3_program* program, uint32_t instances) MRW_NODISCARD;

// ---- Part gles3_skinned ---------------------------------------------------------------------------------------------
// Skin on the GPU, before drawing: vertices that are skinned once and drawn several times, for shadows, depth and
// colour, or that the CPU has skinned.
//
//   once a mesh      mrw_gles3_prepare(), mrw_gles3_create_skinned
//   once a context   mrw_gles3_create_preskin for GPU skinning; mrw_gles3_create_program with MRW_GLES3_DEFORMER_NONE
//                    for drawing
//   every frame      mrw_gles3_upload_skinned (the CPU's), or: use the program, bind its palette, mrw_gles3_set_morphs,
//                    mrw_gles3_preskin_mesh()
//   every pass       mrw_gles3_draw_skinned()
//
// The conventions are those of part gles3.

// What skins vertices ahead of drawing.
typedef uint8_t mrw_gles3_preskin;
enum {
  MRW_GLES3_PRESKIN_FEEDBACK = 0,  // transform feedback, OpenGL ES 3.0
  MRW_GLES3_PRESKIN_COMPUTE = 1,  // compute shader, 3.1
};

// Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
// positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them. Texture coordinates, colours
// and indices are the mesh's, which must be there as long.
typedef struct mrw_gles3_skinned_mesh mrw_gles3_skinned_mesh;
struct mrw_gles3_skinned_mesh {
  uint32_t array;  // vertex array object
  uint32_t buffer;  // of the vertices
  uint32_t slot_count;  // the mesh's
  // MRW_GLES3_NORMALS, MRW_GLES3_TANGENTS, MRW_GLES3_UVS, MRW_GLES3_COLOURS: what programs with MRW_GLES3_DEFORMER_NONE
  // may read
  uint8_t features;
};
void mrw_gles3_skinned_mesh_init(mrw_gles3_skinned_mesh* out);

// Errors: MRW_GL_ERROR (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER and the
// vertex array at 0.
mrw_status mrw_gles3_create_skinned(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh,
    mrw_gles3_skinned_mesh* out) MRW_NODISCARD;

// Deletes the GL objects and clears the struct.
void mrw_gles3_destroy_skinned(const mrw_gles3_api* api, mrw_gles3_skinned_mesh* mesh);

// What mrw_skin_ssd() and their like have written. The old contents are orphaned, so the CPU never waits for the GPU.
// Errors: MRW_BAD_ARGUMENT (a list of another size than the mesh has; normals or tangents may be empty, then they are
// undefined). Leaves GL_ARRAY_BUFFER at 0.
mrw_status mrw_gles3_upload_skinned(const mrw_gles3_api* api, mrw_gles3_skinned_mesh* mesh,
    const mrw_skin_output* vertices) MRW_NODISCARD;

// A program for mrw_gles3_preskin_mesh(), of the key's deformer, palettes, and of its features MRW_GLES3_NORMALS,
// MRW_GLES3_TANGENTS, MRW_GLES3_MORPHS and MRW_GLES3_SURFACE_NORMALS. Those must be the mesh's.
// Errors: MRW_BAD_ARGUMENT (a key of MRW_GLES3_DEFORMER_NONE, of a crowd, or with influences other than 4 to 8);
// MRW_UNSUPPORTED (compute, without caps.compute); MRW_GL_ERROR, with the driver's words in `log`. `out` is written
// only on success. Cost: a compile.
mrw_status mrw_gles3_create_preskin(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_program_key* key, mrw_gles3_preskin method, uint32_t palette_binding, mrw_gles3_program* out,
    char* log, size_t log_bytes) MRW_NODISCARD;

// Skins every slot once into `to`, with the palette that is bound. `program` must be in use. By transform feedback it
// leaves the vertex array, the default transform feedback object's bindings 0 … 2 and GL_TRANSFORM_FEEDBACK_BUFFER at
// 0, and GL_RASTERIZER_DISCARD off; by compute shader GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3 at 0.
// Errors: MRW_BAD_ARGUMENT (a mesh that was not prepared for this deformer, a program of another kind).
mrw_status mrw_gles3_preskin_mesh(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh, mrw_gles3_deformer deformer,
    const mrw_gles3_program* program, const mrw_gles3_skinned_mesh* to) MRW_NODISCARD;

// Programs with MRW_GLES3_MOTION take from `previous` where the vertices of `mesh` were in the frame before: another
// mrw_gles3_skinned_mesh of the same mrw_gles3_gpu_mesh, skinned then; or `mesh` itself, of what has no frame before.
// To be said again whenever it changes, so each frame where two take turns. Errors: MRW_BAD_ARGUMENT (of another number
// of slots). Leaves GL_ARRAY_BUFFER and the vertex array at 0.
mrw_status mrw_gles3_set_previous(const mrw_gles3_api* api, const mrw_gles3_skinned_mesh* mesh,
    const mrw_gles3_skinned_mesh* previous) MRW_NODISCARD;

// Draws all triangles with the program in use, one with MRW_GLES3_DEFORMER_NONE. Leaves the vertex array at 0.
void mrw_gles3_draw_skinned(const mrw_gles3_api* api, const mrw_gles3_gpu_mesh* mesh,
    const mrw_gles3_skinned_mesh* skinned);

// ---- Part gles3_skinner ---------------------------------------------------------------------------------------------
// Skin on the GPU, in one piece: draws one mesh as many characters, on the path that suits the device.
//
//   once a context   mrw_gles3_load_api, mrw_gles3_query_caps; an mrw_gles3_program_set with the game's own texts, one
//                    a role (colour, shadow, …)
//   once a mesh      mrw_gles3_create_skinner
//   every frame      mrw_gles3_pose() each character; mrw_gles3_update(); for each role: use its program, set uniforms,
//                    mrw_gles3_draw()
//   context lost     mrw_gles3_…_on_context_lost; with the new context mrw_gles3_load_api, mrw_gles3_query_caps, then
//                    mrw_gles3_…_on_context_restored
//
// No allocation but the driver's: memory is the caller's, sizes are asked for first. The conventions are those of
// part gles3; what a call leaves changed is what the calls that it is made of do.

// Where vertices are skinned.
typedef uint8_t mrw_gles3_skinning_path;
enum {
  MRW_GLES3_SKINNING_PATH_UBO = 0,  // vertex shader, every pass; palettes in a uniform block, a draw call a character
  // vertex shader, every pass; palettes in a texture, one draw call for all characters
  MRW_GLES3_SKINNING_PATH_TEXTURE = 1,
  MRW_GLES3_SKINNING_PATH_FEEDBACK = 2,  // once a frame, by transform feedback
  MRW_GLES3_SKINNING_PATH_COMPUTE = 3,  // once a frame, by compute shader; OpenGL ES 3.1
  MRW_GLES3_SKINNING_PATH_CPU = 4,  // once a frame, by the CPU
};

// How many values mrw_gles3_skinning_path has.
#define MRW_GLES3_PATH_COUNT 5u

// The most roles of an mrw_gles3_program_set.
#define MRW_GLES3_MOST_ROLES 4u

// The most programs of an mrw_gles3_program_set.
#define MRW_GLES3_MOST_PROGRAMS 192u

// One of a set, filled in by Marrow.
typedef struct mrw_gles3_program_set_entry mrw_gles3_program_set_entry;
struct mrw_gles3_program_set_entry {
  mrw_gles3_program_key key;  // what it was built for
  // from MRW_GLES3_MOST_ROLES on: MRW_GLES3_MOST_ROLES + mrw_gles3_preskin, pre-skinning; MRW_GLES3_MOST_ROLES + 2,
  // blending of crowds
  uint32_t role;
  mrw_gles3_program program;  // as it was built
};

// The programs of a context: each role for each kind of mesh, compiled once. A game fills in the first five members.
typedef struct mrw_gles3_program_set mrw_gles3_program_set;
struct mrw_gles3_program_set {
  mrw_gles3_program_source roles[4];  // Texts that live as long as the set. (GCC 12 takes no shorter initialiser.)
  uint32_t role_count;  // of `roles`, that are used
  // For each role, which features of a mesh its texts read: for a shadow none, or MRW_GLES3_UVS where it has holes.
  // MRW_GLES3_MOTION: whether they read previous_position, of skinners and crowds that keep it.
  uint8_t role_features[4];
  uint32_t palette_binding;  // uniform buffer binding of the palettes
  char* log;  // what the driver says of a text that does not compile
  size_t log_bytes;
  mrw_gles3_program_set_entry entries[192];  // what was compiled
  uint32_t count;  // of entries
};
void mrw_gles3_program_set_init(mrw_gles3_program_set* out);

// How a mesh is skinned, and for how many characters.
typedef struct mrw_gles3_skinner_options mrw_gles3_skinner_options;
struct mrw_gles3_skinner_options {
  mrw_gles3_skinning_path path;  // mrw_gles3_choose() in part gles3_self_test names the best
  mrw_gles3_deformer deformer;  // rigid, ssd, as or psd, which is ssd for a mesh without examples
  uint32_t instances;  // characters, at most
  // The unit of palettes in a texture. Morph targets take the next unit; with `motion` the previous palettes take the
  // third. A pose space takes the fourth and fifth, with `motion` also the sixth.
  uint32_t texture_unit;
  uint8_t features;  // the mesh's features that programs read, if their role reads them, too
  // From mrw_as_tangents() of this mesh, in the caller's memory for as long as the skinner; see
  // mrw_gles3_prepare_options.
  const float* as_tangents;
  size_t as_tangent_count;
  // For motion vectors: keeps on the GPU what the last mrw_gles3_update() left there. Programs of roles that read
  // MRW_GLES3_MOTION get MarrowVertex::previous_position from it. It also takes the uniform buffer binding after
  // mrw_gles3_program_set.palette_binding. Nothing more is uploaded; for the cost see docs/performance.md, "Motion
  // vectors".
  bool motion;
};
void mrw_gles3_skinner_options_init(mrw_gles3_skinner_options* out);

// What skinners with mrw_gles3_skinner_options.motion keep of the mrw_gles3_update() before: two of each, which take
// turns.
typedef struct mrw_gles3_skinner_motion mrw_gles3_skinner_motion;
struct mrw_gles3_skinner_motion {
  mrw_gles3_palette_ring ring;  // path ubo
  uint32_t* offsets;  // in the ring, a character each
  size_t offset_count;
  mrw_gles3_skinned_mesh* skinned;  // of paths that skin once a frame
  size_t skinned_count;
  float* weights;  // of morph targets
  size_t weight_count;
  float* sent_weights;  // of the last mrw_gles3_update()
  size_t sent_weight_count;
  uint8_t* still;  // one a character: 1 if its last mrw_gles3_update() counts as its first
  size_t still_count;
  uint8_t* reset;  // one a character: 1 if its next mrw_gles3_update() counts as its first
  size_t reset_count;
};

// A mesh that is drawn as many characters. Filled in by mrw_gles3_create_skinner(), to be read only.
typedef struct mrw_gles3_skinner mrw_gles3_skinner;
struct mrw_gles3_skinner {
  mrw_mesh mesh;  // as it was given
  mrw_gles3_skinner_options options;  // as they were given
  mrw_gles3_gpu_mesh gpu;  // its vertices on the GPU
  mrw_gles3_palette_ring ring;  // path ubo, feedback and compute
  mrw_gles3_palette_texture texture;  // path texture
  mrw_gles3_palette_texture distance_texture;  // of pose spaces
  uint32_t updated;  // how many characters the last mrw_gles3_update() prepared
  bool lost;  // between mrw_gles3_…_on_context_lost() and mrw_gles3_…_on_context_restored()
  // In the caller's memory.
  // what palettes are built with
  mrw_affine* bind;
  size_t bind_count;
  mrw_affine* palettes;  // characters after each other
  size_t palette_count;
  mrw_affine* distances;  // of pose spaces, characters after each other; path cpu: one character's
  size_t distance_count;
  float* weights;  // of morph targets, characters after each other
  size_t weight_count;
  uint32_t* offsets;  // in the ring, a character each
  size_t offset_count;
  mrw_gles3_skinned_mesh* skinned;  // a character each, of paths that skin once a frame
  size_t skinned_count;
  mrw_gles3_skinner_motion motion;  // with mrw_gles3_skinner_options.motion
  float* positions;  // path cpu: one character's
  size_t position_count;
  float* normals;  // path cpu: one character's
  size_t normal_count;
  float* tangents;  // path cpu: one character's
  size_t tangent_count;
  float* coordinates;  // path cpu: one character's
  size_t coordinate_count;
  mrw_morphed_geometry morphed;  // path cpu: one character's
  void* scratch;  // of mrw_gles3_prepare(), kept for the next context
  size_t scratch_bytes;
};

// "ubo", …
const char* mrw_gles3_skinning_path_text(mrw_gles3_skinning_path path);

// Deletes all programs. Skinners that use the set must go first.
void mrw_gles3_destroy_programs(const mrw_gles3_api* api, mrw_gles3_program_set* programs);

// Bytes of memory that mrw_gles3_create_skinner() wants.
size_t mrw_gles3_skinner_bytes(const mrw_mesh* mesh, const mrw_gles3_skinner_options* options);

// Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: mrw_gles3_pose()
// each before the first mrw_gles3_update(). Compiles what `programs` lacks for it.
//
// mesh: its geometry must live as long as the skinner, so that it can be put on the next context. memory: at least
// mrw_gles3_skinner_bytes(), 16-byte aligned, the skinner's until mrw_gles3_destroy_…().
// Errors: MRW_BAD_ARGUMENT (a list too short, no instances, MRW_GLES3_DEFORMER_NONE, no role); MRW_UNSUPPORTED (a path
// that the caps or the number of joints rule out, a full program set); MRW_GL_ERROR (nothing is left allocated but
// programs). `out` is written only on success.
mrw_status mrw_gles3_create_skinner(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_skinner_options* options, mrw_gles3_program_set* programs, void* memory, size_t memory_bytes,
    mrw_gles3_skinner* out) MRW_NODISCARD;

// Deletes the GL objects and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_skinner(const mrw_gles3_api* api, mrw_gles3_skinner* skinner);

// Sets the pose that character `instance` has from the next mrw_gles3_update() on. weights: one a morph target. Calls
// no GL, so it may run on another thread than the context's, for different instances on different threads.
// Errors: MRW_BAD_ARGUMENT (no such instance, a list too short, a skinner that was destroyed).
mrw_status mrw_gles3_pose(mrw_gles3_skinner* skinner, uint32_t instance, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, const float* weights, size_t weight_count) MRW_NODISCARD;

// With options.motion: at the next mrw_gles3_update() the character counts as new, so its vertices do not move. For a
// character that appears, or jumps to another place. A character that the last mrw_gles3_update() left out counts as
// new anyway. May be called where mrw_gles3_pose() may. Errors: MRW_BAD_ARGUMENT (no such instance, a skinner without
// motion or that was destroyed).
mrw_status mrw_gles3_reset_motion(mrw_gles3_skinner* skinner, uint32_t instance) MRW_NODISCARD;

// Once a frame, after posing: uploads the palettes of characters 0 … count - 1, or skins them. Only 48 bytes a joint
// are uploaded; with a pose space also 16 for every four examples, the bind pose counting as one; on path cpu the
// vertices instead.
// Errors: MRW_BAD_ARGUMENT (more than there are, a weight that is not finite, a skinner that was destroyed);
// MRW_GL_ERROR (the context is lost).
mrw_status mrw_gles3_update(const mrw_gles3_api* api, mrw_gles3_skinner* skinner, const mrw_gles3_program_set* programs,
    uint32_t count) MRW_NODISCARD;

// The program of a role for this mesh, never null: use it and set the game's own uniforms before mrw_gles3_draw().
const mrw_gles3_program* mrw_gles3_program_of(const mrw_gles3_skinner* skinner, const mrw_gles3_program_set* programs,
    uint32_t role);

// Draws characters first … first + count - 1 with `program`, which is mrw_gles3_program_of() of a role and in use.
// Errors: MRW_BAD_ARGUMENT (not all of them updated, a skinner that was destroyed); MRW_GL_ERROR (the context is lost).
mrw_status mrw_gles3_draw(const mrw_gles3_api* api, const mrw_gles3_skinner* skinner,
    const mrw_gles3_program_set* programs, const mrw_gles3_program* program, uint32_t first,
    uint32_t count) MRW_NODISCARD;

// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
// mrw_gles3_…_on_context_restored() mrw_gles3_update() and mrw_gles3_draw() refuse. The set first or last, as one
// likes.
void mrw_gles3_programs_on_context_lost(mrw_gles3_program_set* programs);
void mrw_gles3_skinner_on_context_lost(mrw_gles3_skinner* skinner);

// Builds everything anew in the context that is current. What had been posed is there at the next mrw_gles3_update().
// Errors: as mrw_gles3_create_skinner(); then it may be tried again.
mrw_status mrw_gles3_programs_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_program_set* programs) MRW_NODISCARD;
mrw_status mrw_gles3_skinner_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_skinner* skinner) MRW_NODISCARD;

// ---- Part gles3_crowd -----------------------------------------------------------------------------------------------
// Skin on the GPU, thousands of characters of one kind: poses baked into a texture once, blended on the GPU, drawn
// by one instanced call a mesh. A frame in which no instance changes uploads nothing but a few uniforms.
//
//   once a character   mrw_gles3_plan_crowd, mrw_gles3_bake_crowd: clips → frames, for meshes and sockets alike
//   once a mesh        mrw_gles3_create_crowd_mesh, mrw_gles3_create_crowd_programs
//   once a crowd       mrw_gles3_create_crowd
//   on changes         mrw_gles3_set_instances
//   every frame        with motion vectors: mrw_gles3_begin_crowd_frame for each mesh
//                      for each mesh: use the blending program, mrw_gles3_blend_crowd; use the drawing program,
//                      mrw_gles3_bind_crowd, mrw_gles3_draw_mesh() of part gles3
//   on the CPU         mrw_gles3_crowd_joint: where a joint of an instance is, by the arithmetic of the GPU
//   context lost       mrw_gles3_…_on_context_lost; with the new context mrw_gles3_load_api, mrw_gles3_query_caps, then
//                      mrw_gles3_…_on_context_restored
//
// Back faces are culled as mrw_gles3_draw_mesh() of part gles3 says: by each mesh's double_sided. All instances of a
// draw call share one winding of fronts. So keep instances whose world_from_model mirrors (mrw_turns_inside_out() in
// part palette of c.h) behind the others in the crowd, and bind and draw each of the two ranges with its own
// glFrontFace. If the character itself is mirrored, as mrw_palette_turns_inside_out(palette) tells, swap the two
// settings.
//
// The conventions are those of part gles3. Layout of the textures, precision, costs: docs/performance.md, "Crowds".

// The most frames of a crowd: as many as fit the smallest textures for meshes with one joint.
#define MRW_GLES3_MAX_CROWD_FRAMES 1048576u

// Bytes of memory an instance for mrw_gles3_create_crowd().
#define MRW_GLES3_CROWD_INSTANCE_BYTES 128u

// What is baked, and how it ends.
typedef struct mrw_gles3_crowd_source mrw_gles3_crowd_source;
struct mrw_gles3_crowd_source {
  mrw_clip clip;  // not an additive one
  bool loops;  // its last pose is followed by its first; otherwise it stays in the last
};
void mrw_gles3_crowd_source_init(mrw_gles3_crowd_source* out);

// Where a clip's frames are: steps + 1 of them, at even steps of time. In a clip that loops, the last frame is the
// first again.
typedef struct mrw_gles3_crowd_clip mrw_gles3_crowd_clip;
struct mrw_gles3_crowd_clip {
  float duration_s;  // of the clip
  uint32_t first_frame;  // of the crowd's frames
  uint32_t steps;  // 1 … 65535
  bool loops;  // as its source's
};
void mrw_gles3_crowd_clip_init(mrw_gles3_crowd_clip* out);

// Baked clips of one skeleton: a matrix each frame and joint, as mrw_local_to_model() writes them.
typedef struct mrw_gles3_crowd_frames mrw_gles3_crowd_frames;
struct mrw_gles3_crowd_frames {
  const mrw_gles3_crowd_clip* clips;  // in the order of their sources
  size_t clip_count;
  const mrw_affine* character_from_joint;  // frame after frame
  size_t character_from_joint_count;
  uint32_t joint_count;  // of the skeleton
  uint32_t frame_count;  // of all clips
};
void mrw_gles3_crowd_frames_init(mrw_gles3_crowd_frames* out);

// A clip on the crowd's clock: at start_s the clip is at phase_s; at any other time `speed` says where.
typedef struct mrw_gles3_crowd_play mrw_gles3_crowd_play;
struct mrw_gles3_crowd_play {
  uint32_t clip;  // of mrw_gles3_crowd_frames.clips
  float phase_s;  // of a clip that does not loop, clamped to 0 … duration_s
  float speed;  // seconds of the clip a second; may be negative
  double start_s;  // seconds
};
void mrw_gles3_crowd_play_init(mrw_gles3_crowd_play* out);

// One character of a crowd. It is exact up to 36 hours from each of its times; set it again by then, with later times.
typedef struct mrw_gles3_crowd_instance mrw_gles3_crowd_instance;
struct mrw_gles3_crowd_instance {
  mrw_affine world_from_model;  // where it stands
  mrw_gles3_crowd_play a;  // must have a clip
  mrw_gles3_crowd_play b;  // MRW_NO_CLIP: a alone
  double blend_start_s;  // until this time a alone
  float blend_s;  // length of the blend; after it b alone
  float colour[4];  // marrow_instance_colour() in the vertex shader
};
void mrw_gles3_crowd_instance_init(mrw_gles3_crowd_instance* out);

// A mesh as crowds draw it: its palette in every frame (RGBA32F), and the instances' palettes at this moment (RGBA32UI,
// the bits of floats, since GLES 3.0 cannot render to floats). A texel is a row of a matrix, a line 2048 texels.
typedef struct mrw_gles3_crowd_mesh mrw_gles3_crowd_mesh;
struct mrw_gles3_crowd_mesh {
  mrw_gles3_gpu_mesh gpu;  // what mrw_gles3_draw() takes
  uint32_t frames_texture;  // palettes of all frames
  uint32_t blended_texture;  // palettes of the instances
  uint32_t framebuffer;  // around the blended texture
  // Only with motion: the instances' palettes in the previous frame. mrw_gles3_begin_crowd_frame() swaps the two
  // textures.
  uint32_t previous_texture;
  uint32_t previous_framebuffer;  // around the previous texture
  uint32_t joints;  // matrices of a palette
  uint32_t frame_count;  // of its frames
  uint32_t capacity;  // instances
  bool motion;  // as mrw_gles3_create_crowd_mesh() was asked
  bool lost;  // between mrw_gles3_…_on_context_lost() and mrw_gles3_…_on_context_restored()
  mrw_mesh mesh;  // What it is put on the next context from.
  mrw_gles3_prepare_options options;  // as they were given
  mrw_gles3_crowd_frames frames;  // as they were given
  mrw_affine* bind;  // what palettes are built with
  size_t bind_count;
  void* scratch;  // of mrw_gles3_prepare(), and of palettes on their way up
  size_t scratch_bytes;
};
void mrw_gles3_crowd_mesh_init(mrw_gles3_crowd_mesh* out);

// Instances, in a texture: 128 B each, 256 a line. The caller's memory holds the same bytes for the next context.
typedef struct mrw_gles3_crowd mrw_gles3_crowd;
struct mrw_gles3_crowd {
  uint32_t texture;  // of records
  uint32_t capacity;  // instances, at most
  uint32_t count;  // that have been set
  uint32_t frame_count;  // of the frames that they play
  bool lost;  // between mrw_gles3_…_on_context_lost() and mrw_gles3_…_on_context_restored()
  void* records;  // as the texture has them
  size_t records_bytes;
};
void mrw_gles3_crowd_init(mrw_gles3_crowd* out);

// How many frames it takes to bake clips at `rate_hz`, or a little more, as each clip gets a whole number of steps. 30
// a second are enough for most motion. out: at least as many as sources.
// Errors: MRW_BAD_ARGUMENT (no sources, a rate that is not finite or not above 0, an additive clip, a list too short);
// MRW_UNSUPPORTED (more than 65535 steps of a clip, or MRW_GLES3_MAX_CROWD_FRAMES). Written only on success.
mrw_status mrw_gles3_plan_crowd(const mrw_gles3_crowd_source* sources, size_t source_count, float rate_hz,
    mrw_gles3_crowd_clip* out, size_t out_count, uint32_t* frame_count) MRW_NODISCARD;

// Samples the sources into frames. scratch: at least mrw_skeleton_soa_size(skeleton). clips: those that
// mrw_gles3_plan_crowd() wrote for these sources. matrices: at least frame_count × joint_count, 48 B a joint and frame.
// The caller keeps clips and matrices.
// Errors: MRW_BAD_ARGUMENT (a list too short, a clip of another skeleton, clips that are not a plan).
mrw_status mrw_gles3_bake_crowd(const mrw_skeleton* skeleton, const mrw_gles3_crowd_source* sources,
    size_t source_count, const mrw_gles3_crowd_clip* clips, size_t clip_count, mrw_soa_transform* scratch,
    size_t scratch_count, mrw_affine* matrices, size_t matrice_count, mrw_gles3_crowd_frames* out) MRW_NODISCARD;

// Where a joint of an instance is: linear between two neighbouring frames and between two clips. The palettes that are
// drawn are blended the same way, so what is put at the joint stays on the surface. Helper entries of a palette are
// blended linearly between frames and clips, too.
// Errors: MRW_BAD_ARGUMENT (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
// world_from_model beyond 1e12).
mrw_status mrw_gles3_crowd_joint(const mrw_gles3_crowd_frames* frames, const mrw_gles3_crowd_instance* instance,
    double time_s, uint32_t joint, mrw_affine* model_from_joint) MRW_NODISCARD;

// The same of all joints; out: at least frames.joint_count.
mrw_status mrw_gles3_crowd_pose(const mrw_gles3_crowd_frames* frames, const mrw_gles3_crowd_instance* instance,
    double time_s, mrw_affine* model_from_joint, size_t model_from_joint_count) MRW_NODISCARD;

// How many palettes of `joints` matrices a texture of the caps' size holds. It limits the frames of a mesh, and the
// instances.
uint32_t mrw_gles3_crowd_palettes_that_fit(const mrw_gles3_caps* caps, uint32_t joints);

// Bytes of memory that mrw_gles3_create_crowd_mesh() wants: 48 B a joint, and the larger of 0.1 MB and
// mrw_gles3_prepare_scratch_bytes(). May be null: options.
size_t mrw_gles3_crowd_mesh_bytes(const mrw_mesh* mesh, const mrw_gles3_prepare_options* options);

// Puts a mesh, by mrw_gles3_prepare(), and its palettes of all frames on the GPU. A level of detail is an
// mrw_gles3_crowd_mesh of its own.
//
// The mesh's geometry, the frames and options.as_tangents must live as long as the mrw_gles3_crowd_mesh, so that they
// can be put on the next context. capacity: instances that are drawn in a frame, at most. memory: at least
// mrw_gles3_crowd_mesh_bytes(), 16-byte aligned, the mrw_gles3_crowd_mesh's until mrw_gles3_destroy_…(). Errors:
// MRW_BAD_ARGUMENT (no capacity, no frames, memory too short or askew, a joint that the frames lack); MRW_UNSUPPORTED
// (a mesh with morph targets; more frames or instances than mrw_gles3_crowd_palettes_that_fit()); MRW_GL_ERROR (nothing
// is left allocated). `out` is written only on success. Leaves changed what mrw_gles3_prepare() does, the active unit's
// 2D texture and GL_FRAMEBUFFER at 0; GL_PIXEL_UNPACK_BUFFER must be 0. Cost: the vertices, and 48 B a matrix and
// frame, go up, once.
// motion: keeps the previous frame's palettes as well, 48 B a joint and instance. Programs of roles that read
// MRW_GLES3_MOTION get MarrowVertex::previous_position from them.
// May be null: options.
mrw_status mrw_gles3_create_crowd_mesh(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_prepare_options* options, const mrw_gles3_crowd_frames* frames, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd_mesh* out, bool motion) MRW_NODISCARD;

// Deletes the GL objects and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_crowd_mesh(const mrw_gles3_api* api, mrw_gles3_crowd_mesh* mesh);

// Room for `capacity` instances. memory: MRW_GLES3_CROWD_INSTANCE_BYTES each, 4-byte aligned, the crowd's until
// mrw_gles3_destroy_…(). Errors: MRW_BAD_ARGUMENT (zero, memory too short or askew); MRW_UNSUPPORTED (more than 256 ×
// the caps' texture size: 524 288); MRW_GL_ERROR. Leaves the active unit's 2D texture at 0.
mrw_status mrw_gles3_create_crowd(const mrw_gles3_api* api, const mrw_gles3_caps* caps, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd* out) MRW_NODISCARD;

// Deletes the texture and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_crowd(const mrw_gles3_api* api, mrw_gles3_crowd* crowd);

// Sets the instances from `first` on: it replaces existing ones, or adds more right behind them. While the context is
// lost they are kept, and restored with it. Errors: MRW_BAD_ARGUMENT (a gap before `first`, frames other than those of
// the instances before, an instance as mrw_gles3_crowd_joint() refuses it); MRW_UNSUPPORTED (more than the capacity).
// Nothing is changed then. Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and
// 128 B an instance, in at most three pieces; where the GPU still draws from the texture the driver may wait or copy
// it.
mrw_status mrw_gles3_set_instances(const mrw_gles3_api* api, mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_frames* frames, uint32_t first, const mrw_gles3_crowd_instance* instances,
    size_t instance_count) MRW_NODISCARD;

// The program for mrw_gles3_blend_crowd(). Errors: MRW_GL_ERROR, with the driver's words in `log`. Cost: a compile.
mrw_status mrw_gles3_create_crowd_program(const mrw_gles3_api* api, mrw_gles3_program* out, char* log,
    size_t log_bytes) MRW_NODISCARD;

// Makes a set hold the program for mrw_gles3_blend_crowd() and, for a kind of mesh, each role's program that reads
// palettes of crowds; what it lacks is compiled. The set restores them after the context is lost. deformer: one that
// the mesh was prepared for. features: those of the mesh's that programs are to read. Errors: MRW_BAD_ARGUMENT
// (MRW_GLES3_DEFORMER_NONE, no role); MRW_UNSUPPORTED (a full set); MRW_GL_ERROR, with the driver's words in
// programs.log.
mrw_status mrw_gles3_create_crowd_programs(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer, uint8_t features,
    mrw_gles3_program_set* programs) MRW_NODISCARD;

// The program that was built with the same arguments, never null.
const mrw_gles3_program* mrw_gles3_crowd_program_of(const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer,
    uint8_t features, const mrw_gles3_program_set* programs, uint32_t role);
const mrw_gles3_program* mrw_gles3_blending_program_of(const mrw_gles3_program_set* programs);

// With motion: call it once a frame, before mrw_gles3_blend_crowd(). The palettes that were blended last become the
// previous frame's. No call to GL.
void mrw_gles3_begin_crowd_frame(mrw_gles3_crowd_mesh* mesh);

// With motion: writes the previous frame's palettes of some instances anew. Use it for instances that were not blended
// in that frame, or that have since been set to play or stand elsewhere at once. Their palettes are computed from the
// instances as they are set now, at time_s. With the previous frame's time they move as their clips do; with this
// frame's time they stand still. Other instances keep their palettes. Otherwise as mrw_gles3_blend_crowd(). Errors: as
// there; MRW_BAD_ARGUMENT also for a mesh without motion.
mrw_status mrw_gles3_blend_previous_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Writes the palettes of `count` instances from `first` on, at time_s of the crowd's clock, placed in the scene. It
// draws one triangle, a fragment a row of a matrix. Call it once a frame, however often the instances are drawn then.
// `program`, from mrw_gles3_create_crowd_program(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and
// GL_RASTERIZER_DISCARD must be off and no colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport
// as large as the texture, `texture_unit` and the one behind it bound and the latter active. Errors: MRW_BAD_ARGUMENT
// (a program of another kind, instances that are not there, frames other than the mesh's, a time that is not finite);
// MRW_UNSUPPORTED (more instances than the mesh has capacity for); MRW_GL_ERROR (the context is lost).
mrw_status mrw_gles3_blend_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Lets the next mrw_gles3_draw() with `count` instances draw those from `first` on, as they were blended. `program`
// must be in use and read palettes of crowds. Binds two texture units as mrw_gles3_blend_crowd() does, and with
// MRW_GLES3_MOTION the next one, too. Errors: as there.
mrw_status mrw_gles3_bind_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// After the context is gone, with all that was in it: forgets GL objects without a call to GL. Until
// mrw_gles3_…_on_context_restored() mrw_gles3_blend_crowd() and mrw_gles3_bind_crowd() refuse. Meshes, crowds and the
// program set in any order.
void mrw_gles3_crowd_mesh_on_context_lost(mrw_gles3_crowd_mesh* mesh);
void mrw_gles3_crowd_on_context_lost(mrw_gles3_crowd* crowd);

// Builds everything anew in the context that is current; instances are as they were set last. Leaves changed what
// creation does. Errors: as creation, but for its arguments; then it may be tried again.
mrw_status mrw_gles3_crowd_mesh_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd_mesh* mesh) MRW_NODISCARD;
mrw_status mrw_gles3_crowd_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd* crowd) MRW_NODISCARD;

// ---- Part gles3_self_test -------------------------------------------------------------------------------------------
// Which paths of part gles3_skinner a device can be trusted with, found out by trying them once at start-up: drivers
// miscompile, lose uploads, crash, or are slow at what others are fast at.
//
//   start            mrw_gles3_restore() what was stored; unless that is ok, mrw_gles3_run_self_test(), then
//                    mrw_gles3_save() and store the bytes
//   once a mesh      mrw_gles3_choose() → mrw_gles3_skinner_options.path
//
// Every path skins two small meshes, by each deformer asked for, as two characters in two frames. Each vertex is drawn
// as a point into a texture of integers and read back, so that no path is needed to see what another does, and compared
// with mrw_skin_ssd() and mrw_skin_as(). Motion vectors (MRW_GLES3_MOTION) and crowds are not tried. The conventions
// are those of part gles3.

// What the self-test says of a path.
typedef uint8_t mrw_gles3_verdict;
enum {
  MRW_GLES3_VERDICT_USABLE = 0,
  MRW_GLES3_VERDICT_NOT_TRIED = 1,  // not among mrw_gles3_self_test_options.paths
  MRW_GLES3_VERDICT_CRASHED = 2,  // among mrw_gles3_self_test_options.crashed
  MRW_GLES3_VERDICT_UNSUPPORTED = 3,  // the caps rule it out
  MRW_GLES3_VERDICT_REFUSED = 4,  // the driver refuses its programs or its buffers
  MRW_GLES3_VERDICT_GL_ERROR = 5,  // GL reports an error while it skins
  MRW_GLES3_VERDICT_WRONG = 6,  // its vertices differ from the CPU's
  // right, but mrw_gles3_self_test_options.slow times slower than the fastest that skins on the GPU
  MRW_GLES3_VERDICT_SLOW = 7,
};

// How many values mrw_gles3_verdict has.
#define MRW_GLES3_VERDICT_COUNT 8u

// Chips that want another order of paths where nothing is timed, and other texts of shaders.
typedef uint8_t mrw_gles3_gpu_family;
enum {
  MRW_GLES3_GPU_FAMILY_OTHER = 0,
  // Mali-G… and Immortalis: rows of a uniform block cost three times those of a texture, attributes are dear
  MRW_GLES3_GPU_FAMILY_MALI_G = 1,
  MRW_GLES3_GPU_FAMILY_MALI_T = 2,  // Mali-T…: four numbers at a time; the paths as others
  MRW_GLES3_GPU_FAMILY_ADRENO = 3,  // registers enough without branches; the paths as others
  // unpacking attributes is dear: a quarter to a third less for animation space as words; the paths as others
  MRW_GLES3_GPU_FAMILY_NVIDIA = 4,
};

// How many values mrw_gles3_gpu_family has.
#define MRW_GLES3_GPU_FAMILY_COUNT 5u

// The most that mrw_gles3_path_result.position_error may be, metres.
#define MRW_GLES3_MOST_POSITION_ERROR 0.001f

// The most that mrw_gles3_path_result.normal_error may be.
#define MRW_GLES3_MOST_NORMAL_ERROR 0.005f

// All paths, as bits.
#define MRW_GLES3_ALL_PATHS 31u

// From so many characters on mrw_gles3_choose() prefers palettes in a texture.
#define MRW_GLES3_MANY_CHARACTERS 8u

// A result as bytes that a game stores. Errors: MRW_BAD_ARGUMENT (too short).
#define MRW_GLES3_SAVED_SELF_TEST_BYTES 128u

typedef double (*mrw_gles3_clock)(void* user);

typedef void (*mrw_gles3_about_to_try)(void* user, mrw_gles3_skinning_path path);

// What one path did.
typedef struct mrw_gles3_path_result mrw_gles3_path_result;
struct mrw_gles3_path_result {
  mrw_gles3_verdict verdict;  // whether to use it
  // The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin;
  // and of unit normals and tangents. Quantised vertices differ by some 0.0001 and 0.0002. Above
  // MRW_GLES3_MOST_POSITION_ERROR and MRW_GLES3_MOST_NORMAL_ERROR the path is wrong: numbers of 16 bits are off by
  // more. Never NaN.
  float position_error;
  float normal_error;  // of normals and tangents
  float ns_per_vertex;  // to skin and draw once; 0: not timed
  float ns_per_pass;  // a vertex, of each pass that draws it again
};
void mrw_gles3_path_result_init(mrw_gles3_path_result* out);

// What mrw_gles3_run_self_test() found.
typedef struct mrw_gles3_self_test mrw_gles3_self_test;
struct mrw_gles3_self_test {
  mrw_gles3_path_result paths[5];  // by mrw_gles3_skinning_path
  mrw_gles3_gpu_family family;  // by GL_RENDERER
  uint64_t key;  // of driver, caps, options and this library's shader texts
};
void mrw_gles3_self_test_init(mrw_gles3_self_test* out);

// What is tried, and how it is timed.
typedef struct mrw_gles3_self_test_options mrw_gles3_self_test_options;
struct mrw_gles3_self_test_options {
  uint32_t paths;  // of those to try a bit each: 1 << path
  uint32_t crashed;  // Paths during which the process came to its end: they are not tried again. See about_to_try.
  bool ssd;  // the deformers that the game uses
  bool as;  // animation space
  mrw_gles3_clock seconds;  // Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
  float slow;  // times the fastest path's time
  // What is timed: characters of a mesh of so many vertices, of up to four influences, by SSD if `ssd`. State what the
  // game draws most of. 16 … 65 520 vertices, of which a multiple of 16 is taken; 1 … 256 characters.
  uint32_t timed_vertices;
  uint32_t timed_characters;  // of that mesh
  // Called before a path is tried. A game that wants to outlive a driver that crashes stores which, durably, and
  // forgets it once mrw_gles3_run_self_test() has returned. What it finds stored at its next start goes into `crashed`,
  // together with what has been there before.
  // what the two functions above get
  mrw_gles3_about_to_try about_to_try;
  void* user;  // Seconds of a clock that never goes back. Null: nothing is timed, and nothing is slow.
};
void mrw_gles3_self_test_options_init(mrw_gles3_self_test_options* out);

// What a mesh is to be drawn for.
typedef struct mrw_gles3_path_need mrw_gles3_path_need;
struct mrw_gles3_path_need {
  uint32_t passes;  // that draw it in a frame: colour, depth, shadows
  uint32_t characters;  // in one mrw_gles3_skinner
  uint32_t joints;  // mrw_mesh_palette_size()
};
void mrw_gles3_path_need_init(mrw_gles3_path_need* out);

// "usable", or why a path is ruled out, in a few words; "" for a value that is none.
const char* mrw_gles3_verdict_text(mrw_gles3_verdict verdict);

// Bytes of memory that mrw_gles3_run_self_test() wants: 0.15 MB, and 0.5 MB where it takes times of as many vertices as
// the defaults.
size_t mrw_gles3_self_test_bytes(const mrw_gles3_self_test_options* options);

// Tries the paths, in the order of mrw_gles3_skinning_path. memory: at least mrw_gles3_self_test_bytes(), 16-byte
// aligned, free again afterwards. Errors: MRW_BAD_ARGUMENT (no deformer, options beyond what they may be, memory too
// short or askew); MRW_GL_ERROR (the context is lost, or nothing can be read back from it; then nothing is known of any
// path). `out` is written only on success; no GL object is left.
//
// Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
// framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
// GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
// binding 0 and what mrw_gles3_preskin_mesh() says.
// Cost: some twenty programs compiled, and a wait for each frame; only where nothing is stored.
mrw_status mrw_gles3_run_self_test(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_self_test_options* options, void* memory, size_t memory_bytes,
    mrw_gles3_self_test* out) MRW_NODISCARD;

// Of the usable paths of the GPU the one that was fastest: ns_per_vertex + (passes - 1) · ns_per_pass. cpu is taken
// where there is no other, as its time is not the GPU's. Of those within 5 % of each other, and of all where one has
// not been timed, the first in this order:
//
//                                one pass                           several passes
//   up to 7 characters           ubo texture compute feedback cpu   compute feedback ubo texture cpu
//   MRW_GLES3_MANY_CHARACTERS and more     texture ubo compute feedback cpu   texture compute feedback ubo cpu
//   MRW_GLES3_GPU_FAMILY_MALI_G            texture compute feedback ubo cpu   the same
//
// More than MRW_GLES3_PALETTE_JOINTS leave texture and cpu. Why so: docs/decisions.md, "Which path".
// Errors: MRW_UNSUPPORTED (none is usable). `out` is written only on success.
mrw_status mrw_gles3_choose(const mrw_gles3_self_test* test, const mrw_gles3_path_need* need,
    mrw_gles3_skinning_path* out) MRW_NODISCARD;

// Writes MRW_GLES3_SAVED_SELF_TEST_BYTES. Errors: MRW_BAD_ARGUMENT (`out` too short).
mrw_status mrw_gles3_save(const mrw_gles3_self_test* test, void* out, size_t out_bytes) MRW_NODISCARD;

// The result in bytes that mrw_gles3_save() has written, if it still holds. Errors: MRW_TRUNCATED, MRW_BAD_MAGIC,
// MRW_BAD_VERSION, MRW_BAD_CHECKSUM, MRW_BAD_DATA; MRW_MISMATCH (another driver, version of it, library, or other caps
// or options): then test anew, and with another driver without what had crashed. `out` is written only on success.
mrw_status mrw_gles3_restore(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_self_test_options* options, const void* saved, size_t saved_bytes,
    mrw_gles3_self_test* out) MRW_NODISCARD;

#ifdef __cplusplus
}
#endif
#endif
