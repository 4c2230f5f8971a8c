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
#define MRW_GLES3_ABI 0xbea701d7u
// That of the library. A program compares it with its own MRW_GLES3_ABI before it calls anything else.
uint32_t mrw_gles3_abi(void);


// ---- Part gles3_functions -------------------------------------------------------------------------------------------
// The OpenGL ES functions that marrow::gles3 calls, and those for a game's uniforms; and who watches calls for errors.

typedef void (*mrw_gles3_error_report)(void* user, const char* call, uint32_t error);

typedef uint32_t (*mrw_gles3_get_error)(void);

// Is told of every GL error and of the call that caused it, as "glBindBuffer": see mrw_gles3_watch_errors(). One an
// mrw_gles3_api and thread.
typedef struct mrw_gles3_error_watch mrw_gles3_error_watch;
struct mrw_gles3_error_watch {
  // May be null. call: a static string.
  // what `report` gets
  mrw_gles3_error_report report;
  // May be null. call: a static string.
  // what `report` gets
  void* user;
  uint32_t pending;  // what the mrw_gles3_api's GetError has yet to tell, as it would without a watch
  mrw_gles3_get_error get_error;  // the driver's glGetError
};
void mrw_gles3_error_watch_init(mrw_gles3_error_watch* out);

// ---- Part gles3 -----------------------------------------------------------------------------------------------------
// Skin on the GPU by OpenGL ES 3.0: the driver's functions, what the context can do, a game's shaders.
//
//   Part gles3_skinner     draws a mesh as many characters
//   part gles3_crowd       draws thousands of characters that the GPU poses
//   part gles3_self_test   says which paths a driver gets right
//
// No globals, no allocation but the driver's, no linkage to a GL library. Everything here is called on the thread where
// the context is current. What a call leaves changed in the GL state is said with it. Nothing is deleted by itself: GL
// objects may only be deleted while their context is current, which the caller alone knows.

typedef void* (*mrw_gles3_load_proc)(const char* name);

// The driver's entry points.
typedef struct mrw_gles3_api mrw_gles3_api;
struct mrw_gles3_api {
  size_t words[216];
};

// How the GPU skins vertices. Multi-weight enveloping is for the CPU only: attributes do not hold its 192 bytes a
// vertex.
typedef uint8_t mrw_gles3_deformer;
enum {
  MRW_GLES3_DEFORMER_NONE = 0,  // not at all: Marrow's own, of vertices that are skinned already
  MRW_GLES3_DEFORMER_RIGID = 1,  // the joint with the largest weight
  MRW_GLES3_DEFORMER_SSD = 2,
  MRW_GLES3_DEFORMER_AS = 3,
  MRW_GLES3_DEFORMER_PSD = 4,  // SSD of what the mesh's pose space has moved, see mrw_skin_psd() in part skin of c.h
};

// Features that a mesh has or a program reads, as bits.
#define MRW_GLES3_NORMALS 1u  // normals
#define MRW_GLES3_TANGENTS 2u  // tangents
#define MRW_GLES3_UVS 4u  // texture coordinates
#define MRW_GLES3_COLOURS 8u  // colours of vertices
#define MRW_GLES3_MORPHS 16u  // morph targets
#define MRW_GLES3_SURFACE_NORMALS 32u  // in animation space the deformed surface's own, by mrw_as_tangents()
#define MRW_GLES3_MOTION 64u  // of programs: where vertices were in the previous frame

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
// after UseProgram(program.id), by mrw_gles3_api or by any other loader.
typedef struct mrw_gles3_program_source mrw_gles3_program_source;
struct mrw_gles3_program_source {
  const char* vertex;  // as above
  const char* fragment;  // as above
  const char* const* feedback_varyings;  // for transform feedback, interleaved; empty otherwise
  size_t feedback_varying_count;
};
void mrw_gles3_program_source_init(mrw_gles3_program_source* out);

// A program of the driver, compiled by Marrow.
typedef struct mrw_gles3_program mrw_gles3_program;
struct mrw_gles3_program {
  uint32_t id;  // for UseProgram(); 0: none
  uint8_t state[84];  // Marrow's own
};
void mrw_gles3_program_init(mrw_gles3_program* out);

// Fills `api` by name ("glBindBuffer"). Pass eglGetProcAddress or an engine's own loader. Functions of OpenGL ES 3.1
// and of extensions stay null where the driver has none. If ObjectLabel is there (GL_KHR_debug, OpenGL ES 3.2), objects
// get labels for RenderDoc and drivers' tools ("newt: surface"); set it to null for none. Errors: MRW_BAD_ARGUMENT
// without a loader; MRW_UNSUPPORTED if it returns null for a function of OpenGL ES 3.0, whose name is put in `missing`
// (static string). `api` is written only on success.
// May be null: missing.
mrw_status mrw_gles3_load_api(mrw_gles3_api* api, mrw_gles3_load_proc load_proc, const char** missing) MRW_NODISCARD;

// Whether the GPU was reset, so that the context is lost with all that is in it. Ask once a frame: GL may report a
// reset only once. If so, call mrw_gles3_…_on_context_lost() for each object that has that function, destroy the
// context, make another, and call mrw_gles3_…_on_context_restored(). Always false without GetGraphicsResetStatus and
// EGL_LOSE_CONTEXT_ON_RESET.
bool mrw_gles3_context_was_reset(const mrw_gles3_api* api);

// For debugging: reports to `watch` every GL error that a call through `api` or a copy of it causes; null ends that.
// The watch must live as long as they. GetError of `api` still returns the errors. A call costs two more, of
// glGetError.
// May be null: watch.
void mrw_gles3_watch_errors(mrw_gles3_api* api, mrw_gles3_error_watch* watch);

// Errors: MRW_UNSUPPORTED below OpenGL ES 3.0; MRW_GL_ERROR.
mrw_status mrw_gles3_query_caps(const mrw_gles3_api* api, mrw_gles3_caps* caps) MRW_NODISCARD;

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
// part gles3. What the calls leave changed in the GL state: docs/gles/state.md.

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

#define MRW_GLES3_PATH_COUNT 5u  // how many values mrw_gles3_skinning_path has

#define MRW_GLES3_MOST_ROLES 4u  // of an mrw_gles3_program_set

// The programs of a context: each role for each kind of mesh, compiled once, at most 192. A game fills in all but the
// state.
typedef struct mrw_gles3_program_set mrw_gles3_program_set;
struct mrw_gles3_program_set {
  mrw_gles3_program_source roles[4];  // texts that live as long as the set
  uint32_t role_count;  // of `roles`, that are used
  // For each role, which features of a mesh its texts read: for a shadow none, or MRW_GLES3_UVS where it has holes.
  // MRW_GLES3_MOTION: whether they read previous_position, of skinners and crowds that keep it.
  uint8_t role_features[4];
  uint32_t palette_binding;  // uniform buffer binding of the palettes
  char* log;  // what the driver says of a text that does not compile
  size_t log_bytes;
  uint8_t state[18436];  // Marrow's own: what was compiled
};
void mrw_gles3_program_set_init(mrw_gles3_program_set* out);

// Scene-space vertices in float, in one buffer, block after block so that passes of depth alone read positions alone:
// positions 12 B a slot, then normals 12 B, then tangents 16 B where the mesh has them.
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
  // From mrw_as_tangents() of this mesh, in the caller's memory for as long as the skinner: animation space draws the
  // deformed surface's own normals. Empty, or of a mesh with morph targets: normals through the blend.
  const float* as_tangents;
  size_t as_tangent_count;
  // For motion vectors: programs of roles that read MRW_GLES3_MOTION get MarrowVertex::previous_position of the last
  // mrw_gles3_update(). Takes the uniform buffer binding after mrw_gles3_program_set.palette_binding, too. Cost:
  // docs/performance.md.
  bool motion;
};
void mrw_gles3_skinner_options_init(mrw_gles3_skinner_options* out);

// A mesh that is drawn as many characters. Filled in by mrw_gles3_create_skinner(), to be read only.
typedef struct mrw_gles3_skinner mrw_gles3_skinner;
struct mrw_gles3_skinner {
  mrw_mesh mesh;  // as it was given
  mrw_gles3_skinner_options options;  // as they were given
  // What mrw_gles3_update() has skinned, a character each: of the paths feedback, compute and cpu.
  mrw_gles3_skinned_mesh* skinned;
  size_t skinned_count;
  uint8_t state[1024];  // Marrow's own
  uint32_t updated;  // how many characters the last mrw_gles3_update() prepared
  bool lost;  // between mrw_gles3_…_on_context_lost() and mrw_gles3_…_on_context_restored()
};
void mrw_gles3_skinner_init(mrw_gles3_skinner* out);

// "ubo", …
const char* mrw_gles3_skinning_path_text(mrw_gles3_skinning_path path);

// Deletes all programs. Skinners that use the set must go first.
void mrw_gles3_destroy_programs(const mrw_gles3_api* api, mrw_gles3_program_set* programs);

// Bytes of memory that mrw_gles3_create_skinner() wants.
size_t mrw_gles3_skinner_bytes(const mrw_mesh* mesh, const mrw_gles3_skinner_options* options);

// Puts the mesh on the GPU, ready for `options.instances` characters in the rest pose of no skeleton: mrw_gles3_pose()
// each before the first mrw_gles3_update(). Compiles what `programs` lacks for it.
//
// mesh: its geometry must live as long as the skinner. memory: at least mrw_gles3_skinner_bytes(), 16-byte aligned, the
// skinner's until mrw_gles3_destroy_…().
// Errors: MRW_BAD_ARGUMENT (a list too short, no instances, MRW_GLES3_DEFORMER_NONE, no role); MRW_UNSUPPORTED (a path
// that the caps or the number of joints rule out, a full program set); MRW_GL_ERROR (nothing is left allocated but
// programs). `out` is written only on success.
mrw_status mrw_gles3_create_skinner(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_skinner_options* options, mrw_gles3_program_set* programs, void* memory, size_t memory_bytes,
    mrw_gles3_skinner* out) MRW_NODISCARD;

// Deletes the GL objects and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_skinner(const mrw_gles3_api* api, mrw_gles3_skinner* skinner);

// Sets the pose that character `instance` has from the next mrw_gles3_update() on. weights: one a morph target; the GPU
// takes the 64 that move most. Calls no GL: it may run on any thread, for different instances on different threads.
// Errors: MRW_BAD_ARGUMENT (no such instance, a list too short, a skinner that was destroyed).
mrw_status mrw_gles3_pose(mrw_gles3_skinner* skinner, uint32_t instance, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, const float* weights, size_t weight_count) MRW_NODISCARD;

// With options.motion: at the next mrw_gles3_update() the character counts as new, so its vertices do not move. For one
// that jumps to another place; one that the last mrw_gles3_update() left out counts as new anyway. May be called where
// mrw_gles3_pose() may. Errors: MRW_BAD_ARGUMENT (no such instance, a skinner without motion or that was destroyed).
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

// Draws characters first … first + count - 1 with `program`, which is mrw_gles3_program_of() of a role and in use. The
// game sets culling: as glTF has it, GL_CULL_FACE unless mrw_mesh.double_sided, and fronts GL_CCW, or GL_CW where the
// character is mirrored: mrw_turns_inside_out() in part palette of c.h. So characters that mirror need a draw call of
// their own.
// Errors: MRW_BAD_ARGUMENT (not all of them updated, a skinner that was destroyed); MRW_GL_ERROR (the context is lost).
mrw_status mrw_gles3_draw(const mrw_gles3_api* api, const mrw_gles3_skinner* skinner,
    const mrw_gles3_program_set* programs, const mrw_gles3_program* program, uint32_t first,
    uint32_t count) MRW_NODISCARD;

// After the context is gone: forgets GL objects without a call to GL. Until mrw_gles3_…_on_context_restored()
// mrw_gles3_update() and mrw_gles3_draw() refuse. The order of set and skinners does not matter.
void mrw_gles3_programs_on_context_lost(mrw_gles3_program_set* programs);
void mrw_gles3_skinner_on_context_lost(mrw_gles3_skinner* skinner);

// Builds everything anew in the current context; poses are kept. Errors: as mrw_gles3_create_skinner(); then it may be
// tried again.
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
//                      mrw_gles3_bind_crowd, draw
//   on the CPU         mrw_gles3_crowd_joint: where a joint of an instance is, by the arithmetic of the GPU
//   context lost       mrw_gles3_…_on_context_lost; with the new context mrw_gles3_load_api, mrw_gles3_query_caps, then
//                      mrw_gles3_…_on_context_restored
//
// The conventions are those of part gles3, culling is as mrw_gles3_draw() of part gles3_skinner says; instances that
// mirror want a draw call of their own, with its glFrontFace. Layout of the textures, precision, costs:
// docs/performance.md, "Crowds".

#define MRW_GLES3_CROWD_INSTANCE_BYTES 128u  // of memory an instance for mrw_gles3_create_crowd()

// What is baked, and how it ends.
typedef struct mrw_gles3_crowd_source mrw_gles3_crowd_source;
struct mrw_gles3_crowd_source {
  mrw_clip clip;  // not an additive one
  bool loops;  // its last pose is followed by its first; otherwise it stays in the last
};
void mrw_gles3_crowd_source_init(mrw_gles3_crowd_source* out);

// Where a clip's frames are: steps + 1 of them, at even steps of time; if it loops, the last is the first again.
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

// By which deformers a crowd's mesh is drawn.
typedef struct mrw_gles3_crowd_mesh_options mrw_gles3_crowd_mesh_options;
struct mrw_gles3_crowd_mesh_options {
  bool ssd;  // and rigid
  bool as;  // animation space
  const float* as_tangents;  // as mrw_gles3_skinner_options.as_tangents
  size_t as_tangent_count;
};
void mrw_gles3_crowd_mesh_options_init(mrw_gles3_crowd_mesh_options* out);

// A mesh as crowds draw it. Filled in by mrw_gles3_create_crowd_mesh(), to be read only.
typedef struct mrw_gles3_crowd_mesh mrw_gles3_crowd_mesh;
struct mrw_gles3_crowd_mesh {
  mrw_mesh mesh;  // as it was given
  mrw_gles3_crowd_mesh_options options;  // as they were given
  mrw_gles3_crowd_frames frames;  // as they were given
  uint8_t state[256];  // Marrow's own
  uint32_t capacity;  // instances
  bool motion;  // as mrw_gles3_create_crowd_mesh() was asked
  bool lost;  // between mrw_gles3_…_on_context_lost() and mrw_gles3_…_on_context_restored()
};
void mrw_gles3_crowd_mesh_init(mrw_gles3_crowd_mesh* out);

// Instances, in a texture and in the caller's memory.
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

// How many frames it takes to bake clips at `rate_hz` or a little more; mostly 30 will do. out: as many as sources.
// Errors: MRW_BAD_ARGUMENT (no sources, a rate that is not finite or not above 0, an additive clip, a list too short);
// MRW_UNSUPPORTED (more than 65535 steps of a clip, or 1 048 576 frames). Written only on success.
mrw_status mrw_gles3_plan_crowd(const mrw_gles3_crowd_source* sources, size_t source_count, float rate_hz,
    mrw_gles3_crowd_clip* out, size_t out_count, uint32_t* frame_count) MRW_NODISCARD;

// Samples the sources into frames. scratch: at least mrw_skeleton_soa_size(skeleton). clips: those that
// mrw_gles3_plan_crowd() wrote for these sources. matrices: at least frame_count × joint_count, 48 B each. The caller
// keeps clips and matrices. Errors: MRW_BAD_ARGUMENT (a list too short, a clip of another skeleton, clips that are not
// a plan).
mrw_status mrw_gles3_bake_crowd(const mrw_skeleton* skeleton, const mrw_gles3_crowd_source* sources,
    size_t source_count, const mrw_gles3_crowd_clip* clips, size_t clip_count, mrw_soa_transform* scratch,
    size_t scratch_count, mrw_affine* matrices, size_t matrice_count, mrw_gles3_crowd_frames* out) MRW_NODISCARD;

// Where a joint of an instance is: linear between two neighbouring frames and between two clips. The palettes that are
// drawn are blended the same way, so what is put at the joint stays on the surface.
// Errors: MRW_BAD_ARGUMENT (a joint or clip that is not there, a number that is not finite, times beyond ±2⁴⁰ s, or a
// world_from_model beyond 1e12).
mrw_status mrw_gles3_crowd_joint(const mrw_gles3_crowd_frames* frames, const mrw_gles3_crowd_instance* instance,
    double time_s, uint32_t joint, mrw_affine* model_from_joint) MRW_NODISCARD;

// Bytes that mrw_gles3_create_crowd_mesh() wants: 48 a joint, and the larger of 0.1 MB and the mesh's largest vertex
// buffer. May be null: options.
size_t mrw_gles3_crowd_mesh_bytes(const mrw_mesh* mesh, const mrw_gles3_crowd_mesh_options* options);

// Puts a mesh and its palettes of all frames on the GPU. A level of detail is an mrw_gles3_crowd_mesh of its own.
//
// The mesh's geometry, the frames and options.as_tangents must live as long as the mrw_gles3_crowd_mesh. capacity:
// instances that are drawn in a frame, at most. memory: at least mrw_gles3_crowd_mesh_bytes(), 16-byte aligned, the
// mrw_gles3_crowd_mesh's until mrw_gles3_destroy_…(). motion: keeps the previous frame's palettes as well, 48 B a joint
// and instance, for roles that read MRW_GLES3_MOTION. Errors: MRW_BAD_ARGUMENT (no capacity, no frames, memory too
// short or askew, a joint that the frames lack); MRW_UNSUPPORTED (a mesh with morph targets; more frames or instances
// than 2048 × texture_size / 3 / mrw_mesh_palette_size()); MRW_GL_ERROR (nothing is left allocated). `out` is written
// only on success. Leaves GL_ARRAY_BUFFER, the vertex array, the active unit's 2D texture and GL_FRAMEBUFFER at 0;
// GL_PIXEL_UNPACK_BUFFER must be 0. Cost: the vertices, and 48 B a matrix and frame, go up, once.
// May be null: options.
mrw_status mrw_gles3_create_crowd_mesh(const mrw_gles3_api* api, const mrw_gles3_caps* caps, const mrw_mesh* mesh,
    const mrw_gles3_crowd_mesh_options* options, const mrw_gles3_crowd_frames* frames, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd_mesh* out, bool motion) MRW_NODISCARD;

// Deletes the GL objects and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_crowd_mesh(const mrw_gles3_api* api, mrw_gles3_crowd_mesh* mesh);

// Room for `capacity` instances. memory: MRW_GLES3_CROWD_INSTANCE_BYTES each, 4-byte aligned, the crowd's until
// mrw_gles3_destroy_…(). Errors: MRW_BAD_ARGUMENT (zero, memory too short or askew); MRW_UNSUPPORTED (more than 256 ×
// the caps' texture size); MRW_GL_ERROR. Leaves the active unit's 2D texture at 0.
mrw_status mrw_gles3_create_crowd(const mrw_gles3_api* api, const mrw_gles3_caps* caps, uint32_t capacity, void* memory,
    size_t memory_bytes, mrw_gles3_crowd* out) MRW_NODISCARD;

// Deletes the texture and clears the struct; the memory is the caller's again.
void mrw_gles3_destroy_crowd(const mrw_gles3_api* api, mrw_gles3_crowd* crowd);

// Sets the instances from `first` on: replaces existing ones, or adds more right behind them; also while the context is
// lost. Errors: MRW_BAD_ARGUMENT (a gap before `first`, frames other than those of the instances before, an
// instance as mrw_gles3_crowd_joint() refuses it); MRW_UNSUPPORTED (more than the capacity). Nothing is changed then.
// Leaves the active unit's 2D texture at 0, GL_PIXEL_UNPACK_BUFFER must be 0. Cost: 30 ns and 128 B an instance;
// where the GPU still draws from the texture the driver may wait or copy it.
mrw_status mrw_gles3_set_instances(const mrw_gles3_api* api, mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_frames* frames, uint32_t first, const mrw_gles3_crowd_instance* instances,
    size_t instance_count) MRW_NODISCARD;

// Compiles what a set lacks of the program for mrw_gles3_blend_crowd() and of each role's program for this mesh.
// deformer: one of the mesh's options. features: those of the mesh's that programs are to read. Errors:
// MRW_BAD_ARGUMENT (MRW_GLES3_DEFORMER_NONE or psd, no role, a mesh that was destroyed); MRW_UNSUPPORTED (a full set);
// MRW_GL_ERROR, with the driver's words in programs.log.
mrw_status mrw_gles3_create_crowd_programs(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer, uint8_t features,
    mrw_gles3_program_set* programs) MRW_NODISCARD;

// The program of a role that was compiled with the same arguments; and the one for mrw_gles3_blend_crowd(). Never null.
const mrw_gles3_program* mrw_gles3_crowd_program_of(const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer,
    uint8_t features, const mrw_gles3_program_set* programs, uint32_t role);
const mrw_gles3_program* mrw_gles3_blending_program_of(const mrw_gles3_program_set* programs);

// With motion: once a frame, before mrw_gles3_blend_crowd(). What was blended last becomes the previous frame's. No
// call to GL.
void mrw_gles3_begin_crowd_frame(mrw_gles3_crowd_mesh* mesh);

// With motion: writes the previous frame's palettes of instances that were not blended in that frame, or have since
// been set to play or stand elsewhere. With that frame's time_s they move as their clips do; with this frame's they
// stand still. Otherwise as mrw_gles3_blend_crowd(). Errors: as there; MRW_BAD_ARGUMENT also for a mesh without motion.
mrw_status mrw_gles3_blend_previous_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Writes the palettes of `count` instances from `first` on, at time_s of the crowd's clock, placed in the scene. It
// draws one triangle, a fragment a row of a matrix. Call it once a frame, however often the instances are drawn then.
// `program`, from mrw_gles3_blending_program_of(), must be in use; GL_SCISSOR_TEST, GL_CULL_FACE and
// GL_RASTERIZER_DISCARD must be off and no colour masked. Leaves GL_FRAMEBUFFER and the vertex array at 0, the viewport
// as large as the texture, `texture_unit` and the one behind it bound and the latter active. Errors: MRW_BAD_ARGUMENT
// (a program of another kind, instances that are not there, frames other than the mesh's, a time that is not finite);
// MRW_UNSUPPORTED (more instances than the mesh has capacity for); MRW_GL_ERROR (the context is lost).
mrw_status mrw_gles3_blend_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, double time_s, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Lets the next mrw_gles3_draw_crowd() with `count` instances draw those from `first` on, as they were blended.
// `program` must be in use and of mrw_gles3_crowd_program_of(). Binds two texture units as mrw_gles3_blend_crowd()
// does, and with MRW_GLES3_MOTION the next one, too. Errors: as there.
mrw_status mrw_gles3_bind_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd* crowd,
    const mrw_gles3_crowd_mesh* mesh, uint32_t first, uint32_t count, uint32_t texture_unit,
    const mrw_gles3_program* program) MRW_NODISCARD;

// Draws all triangles of the instances that are bound. `program` must be in use. Leaves the vertex array at 0.
// Errors: MRW_BAD_ARGUMENT (a deformer that is not among the mesh's options).
mrw_status mrw_gles3_draw_crowd(const mrw_gles3_api* api, const mrw_gles3_crowd_mesh* mesh, mrw_gles3_deformer deformer,
    const mrw_gles3_program* program, uint32_t instances) MRW_NODISCARD;

// After the context is gone: forgets GL objects without a call to GL. Until mrw_gles3_…_on_context_restored()
// mrw_gles3_blend_crowd() and mrw_gles3_bind_crowd() refuse. The order of meshes, crowds and program sets does not
// matter.
void mrw_gles3_crowd_mesh_on_context_lost(mrw_gles3_crowd_mesh* mesh);
void mrw_gles3_crowd_on_context_lost(mrw_gles3_crowd* crowd);

// Builds everything anew in the context that is current. Errors: as creation; then it may be tried again.
mrw_status mrw_gles3_crowd_mesh_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd_mesh* mesh) MRW_NODISCARD;
mrw_status mrw_gles3_crowd_on_context_restored(const mrw_gles3_api* api, const mrw_gles3_caps* caps,
    mrw_gles3_crowd* crowd) MRW_NODISCARD;

// ---- Part gles3_self_test -------------------------------------------------------------------------------------------
// Which paths of part gles3_skinner a driver gets right and fast, found out by trying them once at start-up.
//
//   start            mrw_gles3_restore() what was stored; unless that is ok, mrw_gles3_run_self_test(), then
//                    mrw_gles3_save() and store the bytes
//   once a mesh      mrw_gles3_choose() → mrw_gles3_skinner_options.path
//
// Every path skins two small meshes, as two characters in two frames. Each vertex is read back and compared with
// mrw_skin_ssd() and mrw_skin_as(). Motion vectors and crowds are not tried. The conventions are those of part gles3.

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

// Chips that want another order of paths where nothing is timed, and other texts of shaders.
typedef uint8_t mrw_gles3_gpu_family;
enum {
  MRW_GLES3_GPU_FAMILY_OTHER = 0,
  MRW_GLES3_GPU_FAMILY_MALI_G = 1,
  MRW_GLES3_GPU_FAMILY_MALI_T = 2,
  MRW_GLES3_GPU_FAMILY_ADRENO = 3,
  MRW_GLES3_GPU_FAMILY_NVIDIA = 4,
};

#define MRW_GLES3_SAVED_SELF_TEST_BYTES 128u  // of a result that a game stores

typedef double (*mrw_gles3_clock)(void* user);

typedef void (*mrw_gles3_about_to_try)(void* user, mrw_gles3_skinning_path path);

// What one path did.
typedef struct mrw_gles3_path_result mrw_gles3_path_result;
struct mrw_gles3_path_result {
  mrw_gles3_verdict verdict;  // whether to use it
  // The largest difference from the CPU in a coordinate: metres, of a mesh 2 m high that stands 100 m from the origin.
  // Quantised vertices differ by some 0.0001. Above 0.001 the path is wrong. Never NaN.
  float position_error;
  float normal_error;  // of unit normals and tangents: some 0.0002; above 0.005 the path is wrong
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
  uint32_t paths;  // those to try, by bit_of(); all
  uint32_t crashed;  // paths during which the process ended: they are not tried again; see about_to_try
  bool ssd;  // the deformers that the game uses
  bool as;  // the deformers that the game uses
  mrw_gles3_clock seconds;  // a clock that never goes back; null: nothing is timed, and nothing is slow
  float slow;  // times the fastest path's time
  // What is timed, by SSD if `ssd`: state what the game draws most of.
  // of a mesh, 16 … 65 520, of which a multiple of 16 is taken
  uint32_t timed_vertices;
  uint32_t timed_characters;  // of that mesh, 1 … 256
  // Called before a path is tried. To outlive a driver that crashes, a game stores the path and forgets it once
  // mrw_gles3_run_self_test() has returned. What it finds stored at its next start it adds to `crashed`.
  // what the two functions above get
  mrw_gles3_about_to_try about_to_try;
  void* user;  // a clock that never goes back; null: nothing is timed, and nothing is slow
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
// short or askew); MRW_GL_ERROR (the context is lost, or nothing can be read back from it). `out` is written only on
// success; no GL object is left.
//
// Wants the defaults of GL_PACK_ALIGNMENT and its like and no sampler on texture unit 0. Leaves as they were: both
// framebuffers, viewport, program, vertex array, active texture unit, the 2D texture of unit 0, GL_ARRAY_BUFFER,
// GL_UNIFORM_BUFFER, the pixel buffers, colour mask, scissor test and rasterizer discard. Leaves at 0 uniform buffer
// binding 0, GL_TRANSFORM_FEEDBACK_BUFFER and its bindings 0 … 2, GL_SHADER_STORAGE_BUFFER and its bindings 0 … 3.
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
//   8 characters and more        texture ubo compute feedback cpu   texture compute feedback ubo cpu
//   MRW_GLES3_GPU_FAMILY_MALI_G            texture compute feedback ubo cpu   the same
//
// More than 341 joints leave texture and cpu. Why so: docs/decisions.md, "Which path".
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
