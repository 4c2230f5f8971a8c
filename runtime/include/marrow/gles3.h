// Skin on the GPU: bind vertices in vertex buffers and a palette in a uniform block → pixels, by OpenGL ES 3.0.
//
//   once a context   load_api, query_caps, create_palette_ring, create_program
//   once a mesh      prepare(): compact attributes, and the bind matrices that undo their quantisation
//   every frame      begin_frame, then for each mesh: build_palette(mesh.joints, bind, joints, …) → push_palette →
//                    set_morphs, if it has morph targets → bind_examples, for its pose space → draw()
//
// No globals, no allocation but the driver's, no linkage to a GL library. Everything here is called on the thread where
// the context is current. What a call leaves changed in the GL state is said with it. Nothing is deleted by itself: GL
// objects may only be deleted while their context is current, which the caller alone knows.
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/gles3_entry.h"
#include "marrow/gles3_functions.h"

namespace marrow::gles3 {

// The driver's entry points.
struct Api {
#define MARROW_MEMBER(Result, Name, Parameters) Entry<Result Parameters> Name{"gl" #Name};
  MARROW_GLES3_FUNCTIONS(MARROW_MEMBER)
  MARROW_GLES31_FUNCTIONS(MARROW_MEMBER)
  MARROW_KHR_DEBUG_FUNCTIONS(MARROW_MEMBER)
  MARROW_ROBUSTNESS_FUNCTIONS(MARROW_MEMBER)
#undef MARROW_MEMBER
};

// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader.
// Errors: bad_argument without a loader; unsupported if it returns null for a function of OpenGL ES 3.0, whose name is
// put in `missing` (static string). Functions of 3.1 stay null where the driver has none. `api` is written only on
// success.
//
// ObjectLabel is there with GL_KHR_debug or OpenGL ES 3.2. GL objects are then labelled as they are made, for RenderDoc
// and drivers' tools ("newt: surface"); set ObjectLabel to null to leave them without labels. GetGraphicsResetStatus is
// there with GL_EXT_robustness, GL_KHR_robustness or OpenGL ES 3.2.
MARROW_API Status load_api(Api& api, void* (*load_proc)(const char* name), const char** missing = nullptr);

// Whether the GPU was reset, so that the context is lost with all that is in it. Ask once a frame. If so, call
// on_context_lost() for each object that has that function, destroy the context, make another, and call
// on_context_restored(). It can be true only if GetGraphicsResetStatus is there and the context was created to be lost
// on a reset (EGL_LOSE_CONTEXT_ON_RESET). Other contexts never report one here, and platforms have ways of their own
// (EGL_CONTEXT_LOST of eglSwapBuffers). GL may report each reset only once.
MARROW_API bool context_was_reset(const Api& api);

// Reports to `watch` every GL error that a call through `api` or a copy of it causes, with the call's name; null ends
// the reports. The watch must live as long as `api` and its copies. The watch does not hide errors: GetError of `api`
// still returns them. For debugging: without a watch a call costs one more comparison, with a watch two calls of
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

// How the GPU skins vertices. Multi-weight enveloping is for the CPU only: with four influences it needs 192 bytes a
// vertex, more than attributes hold.
enum class Deformer : std::uint8_t {
  none,   // vertices skinned elsewhere, in float: position, normal, tangent
  rigid,  // the joint with the largest weight
  ssd,
  as,
  psd,  // SSD of what the mesh's pose space has moved, see skin_psd() in skin.h
};

// Features that a mesh has or a program reads, as bits: normals.
inline constexpr std::uint8_t kNormals = 1;
// Tangents.
inline constexpr std::uint8_t kTangents = 2;
// Texture coordinates.
inline constexpr std::uint8_t kUvs = 4;
// Colours of vertices.
inline constexpr std::uint8_t kColours = 8;
// Morph targets.
inline constexpr std::uint8_t kMorphs = 16;
// In animation space normals and tangents are the deformed surface's own, by as_tangents(): see PrepareOptions.
inline constexpr std::uint8_t kSurfaceNormals = 32;
// Only of programs: where each vertex was in the previous frame, for motion vectors.
inline constexpr std::uint8_t kMotion = 64;

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

// The most morph targets that a vertex shader adds at a time: a quarter of the uniforms that GLES 3.0 promises.
inline constexpr std::uint32_t kMorphTargets = 64;

// Matrices in the uniform block of the programs: as many as fit the smallest block that GLES 3.0 allows.
inline constexpr std::uint32_t kPaletteJoints = 341;
// Bytes of that block.
inline constexpr std::uint32_t kPaletteBlockBytes = kPaletteJoints * 48;

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

// Bytes of scratch memory that prepare() wants: as much as the largest of its vertex buffers. With `psd` the SSD buffer
// counts together with all changes.
MARROW_API std::size_t prepare_scratch_bytes(const Mesh& mesh, const PrepareOptions& options = {});

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
MARROW_API Status prepare(const Api& api, const Caps& caps, const Mesh& mesh, const PrepareOptions& options,
                          Span<std::byte> scratch, Span<Affine> bind, GpuMesh& out);

// Deletes the GL objects and clears the struct.
MARROW_API void destroy(const Api& api, GpuMesh& mesh);

// Where a program finds its palettes.
enum class Palettes : std::uint8_t {
  uniform_block,  // PaletteRing: one palette a draw call
  texture,        // PaletteTexture: of any size; one draw call may draw many characters
  crowd,  // CrowdMesh, see gles3_crowd.h: likewise, without work on the CPU; not for Deformer::none, psd or kMorphs
};

// What a program is compiled for. With kMorphs it draws only meshes that have targets; call set_morphs() before each.
// With kMotion it skins twice: by this frame's palettes and, positions only, by the previous frame's. Bind the previous
// palettes for each draw call, too:
//   in a uniform block   a range of the ring of the frame before, at binding palette_binding + 1, by bind_palette()
//   in a texture         bind_previous_palette(); of crowds bind_crowd() does it
//   skinned elsewhere    set_previous(), see gles3_skinned.h
// and with kMorphs set_previous_morphs().
struct ProgramKey {
  Deformer deformer = Deformer::ssd;            // by which vertices are skinned
  std::uint8_t influences = 4;                  // 4 to 8: that of the mesh or more
  std::uint8_t features = kNormals;             // kNormals | …: the mesh's features that it reads
  Palettes palettes = Palettes::uniform_block;  // where it finds palettes
};

// The role's own texts, ESSL 3.00 without #version, zero-terminated. The vertex text comes after the skinning text
// (shaders/skin.glsl), which ends where main() is to begin; the fragment text after the same #version and defines.
//
//   void main() {
//     MarrowVertex v = marrow_skin();
//     gl_Position = clip_from_model * vec4(v.position, 1.0);
//   }
//
// Both texts may test these macros with #if: MARROW_NORMAL, MARROW_TANGENT, MARROW_UV, MARROW_COLOUR, MARROW_MOTION: 1
// if the program was built to read it (ProgramKey::features), else 0. MARROW_PALETTES: 2 in programs for crowds.
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

// A program of the driver and where its uniforms are. Filled in by Marrow.
struct Program {
  std::uint32_t id = 0;                      // for UseProgram(); 0: none
  Palettes reads = Palettes::uniform_block;  // where it reads palettes
  bool motion = false;                       // built with kMotion
  // Locations of uniforms.
  std::int32_t coordinate_scale = -1, joint_bits = -1;  // of attributes; here and below -1: there is none
  std::int32_t palettes = -1, first_row = -1;           // of palettes in a texture
  std::int32_t instances = -1, crowd = -1;              // of crowds
  std::int32_t vertex_layout = -1;                      // of pre-skinning by compute shaders
  std::int32_t morph_changes = -1, morph_targets = -1, morph_count = -1;            // of morph targets
  std::int32_t morph_shift = -1, morph_per_row = -1;                                // of morph targets
  std::int32_t previous_palettes = -1, previous_targets = -1, previous_count = -1;  // of the frame before
  std::int32_t examples = -1, example_step = -1;                                    // of pose spaces
  std::int32_t distances = -1, distance_row = -1, previous_distances = -1;          // of pose spaces
};

// Compiles and links. The palette block is tied to uniform buffer binding `palette_binding`; with kMotion the previous
// frame's block is tied to the next binding.
// Errors: bad_argument (a text missing, influences other than 4 to 8, what crowds cannot); gl_error, with the driver's
// words in `log` (cut to fit, zero-terminated). `out` is written only on success. Cost: a compile; never in a frame.
MARROW_API Status create_program(const Api& api, const ProgramKey& key, const ProgramSource& source,
                                 std::uint32_t palette_binding, Program& out, Span<char> log = {});

// Deletes the program and clears the struct.
MARROW_API void destroy(const Api& api, Program& program);

// One buffer that holds all palettes of a frame, each at an offset that the driver accepts. Every frame the old
// contents are orphaned, so the CPU never waits for the GPU.
struct PaletteRing {
  std::uint32_t buffer = 0;       // a uniform buffer; 0: none
  std::uint32_t alignment = 256;  // of offsets, bytes
  std::uint32_t capacity = 0;     // bytes that palettes may use
  std::uint32_t used = 0;         // bytes, since begin_frame()
};

// Room for palettes of `joints` matrices altogether in `palettes` pieces.
// Errors: bad_argument (zero); unsupported (caps of less than OpenGL ES 3.0); gl_error. Leaves GL_UNIFORM_BUFFER at 0.
MARROW_API Status create_palette_ring(const Api& api, const Caps& caps, std::uint32_t joints, std::uint32_t palettes,
                                      PaletteRing& out);
// Deletes the buffer and clears the struct.
MARROW_API void destroy(const Api& api, PaletteRing& ring);

// Drops the last frame's palettes. Leaves GL_UNIFORM_BUFFER bound to the ring.
MARROW_API void begin_frame(const Api& api, PaletteRing& ring);

// Uploads one palette (48 bytes a matrix, nothing else) and says where it lies. Leaves GL_UNIFORM_BUFFER bound to the
// ring. Errors: bad_argument (empty, or more than kPaletteJoints); unsupported (the ring is full until begin_frame).
MARROW_API Status push_palette(const Api& api, PaletteRing& ring, Span<const Affine> palette, std::uint32_t& offset);

// Ties the palette at `offset` to uniform buffer binding `binding`.
MARROW_API void bind_palette(const Api& api, const PaletteRing& ring, std::uint32_t offset, std::uint32_t binding);

// Texels a row of the texture: what GLES 3.0 promises.
inline constexpr std::uint32_t kPaletteTextureWidth = 2048;

// All palettes of a frame in an RGBA32F texture, a texel a row of a matrix. Three textures take turns, each written
// every third frame, so that the driver need not wait for a texture that it still draws from, or copy it.
struct PaletteTexture {
  std::uint32_t textures[3] = {};    // 0: none
  std::uint32_t current = 0;         // which was written last
  std::uint32_t capacity = 0;        // matrices
  std::uint32_t count = 0;           // matrices in the current texture
  std::uint32_t previous_count = 0;  // matrices in the previous frame's texture
};

// Room for `joints` matrices: 48 B each, three times.
// Errors: bad_argument (zero); unsupported (more than a texture of the caps' size holds: 1.39 million in 2048²);
// gl_error. Leaves the active unit's 2D texture at 0.
MARROW_API Status create_palette_texture(const Api& api, const Caps& caps, std::uint32_t joints, PaletteTexture& out);
// Deletes the textures and clears the struct.
MARROW_API void destroy(const Api& api, PaletteTexture& texture);

// Once a frame: uploads all palettes, one after the other, those of one mesh's instances together. build_palette() may
// write straight into such an array. 48 bytes a matrix go up, and nothing else. Errors: bad_argument (empty);
// unsupported (more than there is room for). Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be
// 0.
MARROW_API Status upload_palettes(const Api& api, PaletteTexture& texture, Span<const Affine> palettes);

// Lets `program` draw with uploaded palettes: instance i takes the one that begins at matrix first + joints · i. The
// program must be in use and read palettes from a texture. Leaves `texture_unit` active and the texture bound to it.
// Errors: bad_argument (a program of another kind, a palette that reaches beyond what was uploaded).
MARROW_API Status bind_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first, std::uint32_t joints,
                               std::uint32_t texture_unit, const Program& program);

// Binds the palettes of the previous frame, which are still there, for a program with kMotion. Pass the same arguments
// as to bind_palette(). kept: false for characters that the previous frame did not have; this frame's palettes are then
// bound in place of the previous ones, and nothing moves. Leaves `texture_unit` active and the texture bound to it.
// Nothing is bound for a program whose text does not read previous_position. Errors: bad_argument (a program of another
// kind, a palette that reaches beyond what was uploaded in that frame).
MARROW_API Status bind_previous_palette(const Api& api, const PaletteTexture& texture, std::uint32_t first,
                                        std::uint32_t joints, bool kept, std::uint32_t texture_unit,
                                        const Program& program);

// Sets the weights, one a target, by which `program` morphs; the program must be in use. It morphs as morph() does on
// the CPU, in animation space through the same blend as normals. If more than kMorphTargets weights are not 0, the
// targets that move most count. Leaves `texture_unit` active and the mesh's texture bound to it. Errors: bad_argument
// (a mesh without targets, a program without kMorphs, too few weights, one that is not finite).
MARROW_API Status set_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                             std::uint32_t texture_unit, const Program& program);

// The weights of the frame before, for a program with kMotion, after set_morphs(). Errors: as there.
MARROW_API Status set_previous_morphs(const Api& api, const Mesh& mesh, const GpuMesh& gpu, Span<const float> weights,
                                      const Program& program);

// Room that pack_distances() wants, in matrices of 12 floats: about a third of one for each palette entry and four
// examples. 0 without examples.
MARROW_API std::uint32_t distance_matrices(const Geometry& geometry);

// How far a pose is from the examples, in the order in which Deformer::psd reads it: otherwise as psd_distances().
// Upload it as palettes are, together with those of other characters: by upload_palettes() into a PaletteTexture of its
// own, on every path. palette: built with the bind matrices of prepare() or with the mesh's; the result is the same.
// out: distance_matrices(). Errors: bad_argument (no examples, a span too short). Cost: that of psd_distances().
MARROW_API Status pack_distances(const Geometry& geometry, Span<const Affine> palette, Span<Affine> out);

// Lets `program` deform by the mesh's examples and by uploaded distances: instance i takes those that begin at matrix
// first + GpuMesh::distances · i. The program must be in use and of Deformer::psd. Leaves `texture_unit` and the next
// one taken, the latter active. Errors: bad_argument (a mesh without examples, a program of another kind, distances
// that reach beyond what was uploaded).
MARROW_API Status bind_examples(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances,
                                std::uint32_t first, std::uint32_t texture_unit, const Program& program);

// The distances of the frame before, for a program with kMotion, after bind_examples(). kept and errors: as in
// bind_previous_palette(). Leaves `texture_unit` active and the texture bound to it.
MARROW_API Status bind_previous_distances(const Api& api, const GpuMesh& mesh, const PaletteTexture& distances,
                                          std::uint32_t first, bool kept, std::uint32_t texture_unit,
                                          const Program& program);

// Draws all triangles of `instances` characters; more than one only with palettes in a texture. `program` must be in
// use, its palette bound. Leaves the vertex array at 0. The game sets culling. As glTF has it, GL_CULL_FACE is enabled
// unless Mesh::double_sided, and fronts are GL_CCW, or GL_CW where turns_inside_out(palette), see palette.h. So
// characters that mirror need a draw call of their own.
// Errors: bad_argument if the mesh was not prepared for this deformer.
MARROW_API Status draw(const Api& api, const GpuMesh& mesh, Deformer deformer, const Program& program,
                       std::uint32_t instances = 1);

}  // namespace marrow::gles3
