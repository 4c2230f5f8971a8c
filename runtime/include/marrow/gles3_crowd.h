// Skin on the GPU, thousands of characters of one kind: poses baked into a texture once, blended on the GPU, drawn
// by one instanced call a mesh. A frame in which no instance changes uploads nothing but a few uniforms.
//
//   once a character   plan_crowd, bake_crowd: clips → frames, for meshes and sockets alike
//   once a mesh        create_crowd_mesh, create_crowd_programs
//   once a crowd       create_crowd
//   on changes         set_instances
//   every frame        with motion vectors: begin_frame for each mesh
//                      for each mesh: use the blending program, blend_crowd; use the drawing program, bind_crowd, draw
//   on the CPU         crowd_joint: where a joint of an instance is, by the arithmetic of the GPU
//   context lost       on_context_lost; with the new context load_api, query_caps, then on_context_restored
//
// The conventions are those of gles3.h, culling is as draw() of gles3_skinner.h says; instances that mirror want a draw
// call of their own, with its glFrontFace. Layout of the textures, precision, costs: docs/performance.md, "Crowds".
#pragma once

#include "marrow/api.h"
#include "marrow/file.h"
#include "marrow/gles3_skinner.h"

namespace marrow::gles3 {

// What is baked, and how it ends.
struct CrowdSource {
  Clip clip = {};     // not an additive one
  bool loops = true;  // its last pose is followed by its first; otherwise it stays in the last
};

// Where a clip's frames are: steps + 1 of them, at even steps of time; if it loops, the last is the first again.
struct CrowdClip {
  float duration_s = 0;           // of the clip
  std::uint32_t first_frame = 0;  // of the crowd's frames
  std::uint32_t steps = 1;        // 1 … 65535
  bool loops = true;              // as its source's
};

// Baked clips of one skeleton: a matrix each frame and joint, as local_to_model() writes them.
struct CrowdFrames {
  Span<const CrowdClip> clips = {};              // in the order of their sources
  Span<const Affine> character_from_joint = {};  // frame after frame
  std::uint32_t joint_count = 0;                 // of the skeleton
  std::uint32_t frame_count = 0;                 // of all clips
};

// How many frames it takes to bake clips at `rate_hz` or a little more; mostly 30 will do. out: as many as sources.
// Errors: bad_argument (no sources, a rate that is not finite or not above 0, an additive clip, a span too short);
// unsupported (more than 65535 steps of a clip, or 1 048 576 frames). Written only on success.
MARROW_API Status plan_crowd(Span<const CrowdSource> sources, float rate_hz, Span<CrowdClip> out,
                             std::uint32_t& frame_count);

// Samples the sources into frames. scratch: at least skeleton.soa_size(). clips: those that plan_crowd() wrote for
// these sources. matrices: at least frame_count × joint_count, 48 B each. The caller keeps clips and matrices.
// Errors: bad_argument (a span too short, a clip of another skeleton, clips that are not a plan).
MARROW_API Status bake_crowd(const Skeleton& skeleton, Span<const CrowdSource> sources, Span<const CrowdClip> clips,
                             Span<SoaTransform> scratch, Span<Affine> matrices, CrowdFrames& out);

// A clip on the crowd's clock: at start_s the clip is at phase_s; at any other time `speed` says where.
struct CrowdPlay {
  std::uint32_t clip = kNoClip;  // of CrowdFrames::clips
  float phase_s = 0;             // of a clip that does not loop, clamped to 0 … duration_s
  float speed = 1;               // seconds of the clip a second; may be negative
  double start_s = 0;            // seconds
};

// One character of a crowd. It is exact up to 36 hours from each of its times; set it again by then, with later times.
struct CrowdInstance {
  Affine world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};  // where it stands
  CrowdPlay a = {};                                                        // must have a clip
  CrowdPlay b = {};                                                        // kNoClip: a alone
  double blend_start_s = 0;                                                // until this time a alone
  float blend_s = 0;                                                       // length of the blend; after it b alone
  float colour[4] = {1, 1, 1, 1};  // marrow_instance_colour() in the vertex shader
};

// Where a joint of an instance is: linear between two neighbouring frames and between two clips. The palettes that are
// drawn are blended the same way, so what is put at the joint stays on the surface.
// Errors: bad_argument (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
// world_from_model beyond 1e12).
MARROW_API Status crowd_joint(const CrowdFrames& frames, const CrowdInstance& instance, double time_s,
                              std::uint32_t joint, Affine& model_from_joint);

// By which deformers a crowd's mesh is drawn.
struct CrowdMeshOptions {
  bool ssd = true;                     // and rigid
  bool as = true;                      // animation space
  Span<const float> as_tangents = {};  // as SkinnerOptions::as_tangents
};

// A mesh as crowds draw it. Filled in by create_crowd_mesh(), to be read only.
struct CrowdMesh {
  Mesh mesh = {};                            // as it was given
  CrowdMeshOptions options = {};             // as they were given
  CrowdFrames frames = {};                   // as they were given
  alignas(void*) std::byte state[256] = {};  // Marrow's own
  std::uint32_t capacity = 0;                // instances
  bool motion = false;                       // as create_crowd_mesh() was asked
  bool lost = false;                         // between on_context_lost() and on_context_restored()
};

// Bytes that create_crowd_mesh() wants: 48 a joint, and the larger of 0.1 MB and the mesh's largest vertex buffer.
MARROW_API std::size_t crowd_mesh_bytes(const Mesh& mesh, const CrowdMeshOptions& options = {});

// Puts a mesh and its palettes of all frames on the GPU. A level of detail is a CrowdMesh of its own.
//
// The mesh's geometry, the frames and options.as_tangents must live as long as the CrowdMesh. capacity: instances that
// are drawn in a frame, at most. memory: at least crowd_mesh_bytes(), 16-byte aligned, the CrowdMesh's until destroy().
// motion: keeps the previous frame's palettes as well, 48 B a joint and instance, for roles that read kMotion.
// Errors: bad_argument (no capacity, no frames, memory too short or askew, a joint that the frames lack); unsupported
// (a mesh with morph targets; more frames or instances than 2048 × texture_size / 3 / Mesh::palette_size()); gl_error
// (nothing is left allocated). `out` is written only on success. Leaves GL_ARRAY_BUFFER, the vertex array, the active
// unit's 2D texture and GL_FRAMEBUFFER at 0; GL_PIXEL_UNPACK_BUFFER must be 0. Cost: the vertices, and 48 B a matrix
// and frame, go up, once.
MARROW_API Status create_crowd_mesh(const Api& api, const Caps& caps, const Mesh& mesh, const CrowdMeshOptions& options,
                                    const CrowdFrames& frames, std::uint32_t capacity, Span<std::byte> memory,
                                    CrowdMesh& out, bool motion = false);
// Deletes the GL objects and clears the struct; the memory is the caller's again.
MARROW_API void destroy(const Api& api, CrowdMesh& mesh);

// Instances, in a texture and in the caller's memory.
struct Crowd {
  std::uint32_t texture = 0;      // of records
  std::uint32_t capacity = 0;     // instances, at most
  std::uint32_t count = 0;        // that have been set
  std::uint32_t frame_count = 0;  // of the frames that they play
  bool lost = false;              // between on_context_lost() and on_context_restored()
  Span<std::byte> records = {};   // as the texture has them
};

inline constexpr std::size_t kCrowdInstanceBytes = 128;  // of memory an instance for create_crowd()

// Room for `capacity` instances. memory: kCrowdInstanceBytes each, 4-byte aligned, the crowd's until destroy().
// Errors: bad_argument (zero, memory too short or askew); unsupported (more than 256 × the caps' texture size);
// gl_error. Leaves the active unit's 2D texture at 0.
MARROW_API Status create_crowd(const Api& api, const Caps& caps, std::uint32_t capacity, Span<std::byte> memory,
                               Crowd& out);
// Deletes the texture and clears the struct; the memory is the caller's again.
MARROW_API void destroy(const Api& api, Crowd& crowd);

// Sets the instances from `first` on: replaces existing ones, or adds more right behind them; also while the context is
// lost. Errors: bad_argument (a gap before `first`, frames other than those of the instances before, an
// instance as crowd_joint() refuses it); unsupported (more than the capacity). Nothing is changed then. Leaves the
// active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and 128 B an instance;
// where the GPU still draws from the texture the driver may wait or copy it.
MARROW_API Status set_instances(const Api& api, Crowd& crowd, const CrowdFrames& frames, std::uint32_t first,
                                Span<const CrowdInstance> instances);

// Compiles what a set lacks of the program for blend_crowd() and of each role's program for this mesh. deformer: one of
// the mesh's options. features: those of the mesh's that programs are to read. Errors: bad_argument (Deformer::none or
// psd, no role, a mesh that was destroyed); unsupported (a full set); gl_error, with the driver's words in
// programs.log.
MARROW_API Status create_crowd_programs(const Api& api, const Caps& caps, const CrowdMesh& mesh, Deformer deformer,
                                        std::uint8_t features, ProgramSet& programs);
// The program of a role that was compiled with the same arguments; and the one for blend_crowd(). Never null.
MARROW_API const Program& crowd_program_of(const CrowdMesh& mesh, Deformer deformer, std::uint8_t features,
                                           const ProgramSet& programs, std::uint32_t role);
MARROW_API const Program& blending_program_of(const ProgramSet& programs);

// Writes the palettes of `count` instances from `first` on, at time_s of the crowd's clock, placed in the scene. It
// draws one triangle, a fragment a row of a matrix. Call it once a frame, however often the instances are drawn then.
// `program`, from blending_program_of(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and GL_RASTERIZER_DISCARD must
// be off and no colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport as large as the texture,
// `texture_unit` and the one behind it bound and the latter active. Errors: bad_argument (a program of another kind,
// instances that are not there, frames other than the mesh's, a time that is not finite); unsupported (more instances
// than the mesh has capacity for); gl_error (the context is lost).
MARROW_API Status blend_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first,
                              std::uint32_t count, double time_s, std::uint32_t texture_unit, const Program& program);

// With motion: once a frame, before blend_crowd(). What was blended last becomes the previous frame's. No call to GL.
MARROW_API void begin_frame(CrowdMesh& mesh);

// With motion: writes the previous frame's palettes of instances that were not blended in that frame, or have since
// been set to play or stand elsewhere. With that frame's time_s they move as their clips do; with this frame's they
// stand still. Otherwise as blend_crowd(). Errors: as there; bad_argument also for a mesh without motion.
MARROW_API Status blend_previous_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first,
                                       std::uint32_t count, double time_s, std::uint32_t texture_unit,
                                       const Program& program);

// Lets the next draw() with `count` instances draw those from `first` on, as they were blended. `program` must be in
// use and of crowd_program_of(). Binds two texture units as blend_crowd() does, and with kMotion the next one, too.
// Errors: as there.
MARROW_API Status bind_crowd(const Api& api, const Crowd& crowd, const CrowdMesh& mesh, std::uint32_t first,
                             std::uint32_t count, std::uint32_t texture_unit, const Program& program);

// Draws all triangles of the instances that are bound. `program` must be in use. Leaves the vertex array at 0.
// Errors: bad_argument (a deformer that is not among the mesh's options).
MARROW_API Status draw(const Api& api, const CrowdMesh& mesh, Deformer deformer, const Program& program,
                       std::uint32_t instances);

// After the context is gone: forgets GL objects without a call to GL. Until on_context_restored() blend_crowd() and
// bind_crowd() refuse. The order of meshes, crowds and program sets does not matter.
MARROW_API void on_context_lost(CrowdMesh& mesh);
MARROW_API void on_context_lost(Crowd& crowd);

// Builds everything anew in the context that is current. Errors: as creation; then it may be tried again.
MARROW_API Status on_context_restored(const Api& api, const Caps& caps, CrowdMesh& mesh);
MARROW_API Status on_context_restored(const Api& api, const Caps& caps, Crowd& crowd);

}  // namespace marrow::gles3
