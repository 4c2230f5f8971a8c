// The whole runtime for C99, and for all languages that call C: see docs/c.md. Library marrow::c.
//
// Made by tools/c_api from runtime/c/api.txt and the C++ headers: do not edit. A list is a pointer and a count; a null
// pointer with a count of 0 is empty. What is said to be empty by default, or that it may be, may be null.
//
// A struct that is filled in begins with its mrw_…_init(), which sets defaults. Memory is the caller's, and nothing is
// to be freed. A pointer that is null or off the boundary of its type makes a call return MRW_BAD_ARGUMENT, and what
// returns no status 0, false or null; the handler of mrw_set_call_error_handler() is told why.
#ifndef MARROW_C_H
#define MARROW_C_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define MRW_ALIGN(bytes) __attribute__((aligned(bytes)))
#define MRW_NODISCARD __attribute__((warn_unused_result))
#elif defined(_MSC_VER)
#define MRW_ALIGN(bytes) __declspec(align(bytes))
#define MRW_NODISCARD
#endif

// clang-format off
#ifdef __cplusplus
extern "C" {
#endif

// A number that all rows of the description give: it changes with every struct, enum, constant and function.
#define MRW_ABI 0x4177e301u
// That of the library. A program compares it with its own MRW_ABI before it calls anything else.
uint32_t mrw_abi(void);


// ---- Part status ----------------------------------------------------------------------------------------------------
// What a call came to: one enum for the whole runtime, with text. No exceptions, no logging.

// What a call came to.
typedef uint8_t mrw_status;
enum {
  MRW_OK = 0,
  MRW_BAD_ARGUMENT = 1,  // the call is wrong: a list too short, a null pointer, an index out of range
  MRW_TRUNCATED = 2,  // the data ends before what it announces
  MRW_BAD_MAGIC = 3,  // not a cooked file
  MRW_BAD_VERSION = 4,  // cooked for another version of the format
  MRW_BAD_CHECKSUM = 5,  // damaged
  MRW_BAD_DATA = 6,  // breaks a rule of docs/format.md
  MRW_UNSUPPORTED = 7,  // legal, but needs what this build or this device lacks
  MRW_GL_ERROR = 8,  // the driver refused
  MRW_MISMATCH = 9,  // both are good, but not made for each other
  MRW_OUT_OF_MEMORY = 10,  // a library that allocates for itself found none
};

// Where a block of data breaks the format, and which rule. `rule` is a static string.
typedef struct mrw_data_error mrw_data_error;
struct mrw_data_error {
  mrw_status status;  // what the call returns
  uint32_t offset;  // byte in the block
  const char* rule;  // in English
};
void mrw_data_error_init(mrw_data_error* out);

// One word or two in English, never null.
const char* mrw_status_text(mrw_status status);

// ---- Part call_error ------------------------------------------------------------------------------------------------
// Who is told when a call is wrong: which function, and what it asks for and did not get.

typedef void (*mrw_call_error_handler)(const char* function, const char* condition);

// From now on `handler` is told of every call that returns MRW_BAD_ARGUMENT, on the thread of that call and before
// it returns. null: nobody is told. Returns the handler before.
//
// The runtime itself never logs. Without a call of this nobody is told in a build with NDEBUG, and in one without a
// line goes to stderr. A library built with MARROW_CALL_ERRORS=OFF, as it is by default for MinSizeRel, holds no names
// and no conditions, and tells nobody whatever is set here.
//
// Bad data in a file is no bad call: see mrw_data_error.
// Thread-safe; the handler must be so too, and the one before may still be running on other threads. It may call
// anything of Marrow, may set another handler, and may stop the program.
mrw_call_error_handler mrw_set_call_error_handler(mrw_call_error_handler handler);

// The handler of now; null: nobody is told. Thread-safe.
mrw_call_error_handler mrw_get_call_error_handler(void);

// ---- Part block -----------------------------------------------------------------------------------------------------
// Blocks of memory on boundaries of 16 bytes, as mrw_load() and whatever lays things out in the caller's memory want
// them.
//
// mrw_block_in() finds a block of at least `size` bytes in any memory of mrw_block_bytes(size) bytes.

// Bytes: where blocks begin at multiples of.
#define MRW_BLOCK_BOUNDARY 16u

typedef struct mrw_block mrw_block;
struct mrw_block {
  void* data;
  size_t size;
};

// How many bytes of any alignment hold a block of `bytes`.
size_t mrw_block_bytes(size_t bytes);

// Whether a block may begin there.
bool mrw_is_on_boundary(const void* first);

// What lies behind the first boundary in `memory`; empty if there is none.
mrw_status mrw_block_in(void* memory, size_t memory_bytes, mrw_block* out) MRW_NODISCARD;

// ---- Part unpack ----------------------------------------------------------------------------------------------------
// Unpack: what a game ships → what mrw_load() reads.
//
// A packed file holds its meshes and coded clips compressed. Unpacking yields the cooked file that `marrow cook
// --mesh-codec none` would have written, except for what quantisation lost. The codecs are libraries of their own, so
// that a game links only the one it ships with: mrw_draco_decoder() (smallest), mrw_meshopt_decoder() (fastest).

typedef struct mrw_bytes mrw_bytes;
struct mrw_bytes {
  const void* data;
  size_t size;
};
void mrw_bytes_init(mrw_bytes* out);

// One way to compress meshes. `decode` fills in all streams or fails; it trusts nothing that the bytes say.
typedef struct mrw_mesh_decoder mrw_mesh_decoder;
struct mrw_mesh_decoder {
  uint32_t codec;  // as packed files name it
  void (*decode)(void);  // Decompresses the bytes of one mesh into the streams.
};

// Bytes of mrw_unpacking's state.
#define MRW_UNPACK_STATE_BYTES 512u

// How much memory mrw_unpack() takes.
typedef struct mrw_unpack_sizes mrw_unpack_sizes;
struct mrw_unpack_sizes {
  uint32_t file_bytes;  // of the unpacked file
  uint32_t memory_bytes;  // what mrw_unpack() wants: the file and, behind it, room to work in
};

// Whether these are the first bytes of a packed file. If not, hand them to mrw_load().
bool mrw_is_packed(const void* bytes, size_t byte_count);

// How much memory unpacking takes, computed from the counts in the records. A mesh's counts are only what the file
// claims: with some codecs, few bytes can really hold many vertices. So set a limit of your own for files from
// untrusted sources. Errors: MRW_BAD_MAGIC, MRW_BAD_VERSION, MRW_BAD_CHECKSUM, MRW_TRUNCATED; MRW_BAD_DATA, also if the
// header claims any other size, or if a clip or bounds claim more than their bytes can hold. Cost: the checksum.
// May be null: error.
mrw_status mrw_find_unpack_sizes(const void* packed, size_t packed_bytes, mrw_unpack_sizes* out,
    mrw_data_error* error) MRW_NODISCARD;

// Unpacks into `memory` (16-byte aligned, at least memory_bytes). `file` becomes the front part of memory. Unpacking
// does not check it: mrw_load() does, decoded counts, indices and joints included. What lies behind `file` is free
// again.
//
// packed may come from anywhere: nothing is read outside of it or written outside of memory. Errors: as
// mrw_find_unpack_sizes(); MRW_BAD_DATA; MRW_UNSUPPORTED if a mesh's codec is not among `decoders` (mrw_data_error.rule
// names it); MRW_OUT_OF_MEMORY, by Draco; MRW_BAD_ARGUMENT. On failure `file` is unchanged and memory holds garbage.
// Vertices come out grouped and ordered for skinning, triangles in the order of the codec. Thread-safe on different
// outputs. Cost: docs/benchmarks.md; Draco allocates while it decodes, nothing else does.
// May be null: error.
mrw_status mrw_unpack(const void* packed, size_t packed_bytes, const mrw_mesh_decoder* decoders, size_t decoder_count,
    void* memory, size_t memory_bytes, mrw_bytes* file, mrw_data_error* error) MRW_NODISCARD;

// The same in steps, for a game that loads while it plays: as many a frame as its time allows.
//
//   once          mrw_begin_unpack()
//   every frame   mrw_unpack_step(), while there is time and mrw_unpacking.file is empty
//   then          mrw_load() of mrw_unpacking.file
//
// A plain struct; a new one has not begun. Keep the packed bytes, the decoders and the memory as they are until the
// last step. To stop half way, just forget the struct: there is nothing to free.
typedef struct mrw_unpacking mrw_unpacking;
struct MRW_ALIGN(8) mrw_unpacking {
  const void* file;  // empty until the last step is done; then as of mrw_unpack()
  size_t file_bytes;
  uint32_t done_bytes;  // of total_bytes; for a progress bar
  uint32_t total_bytes;  // of the unpacked file
  uint8_t state[512];  // mrw_unpack_step()'s own
};
void mrw_unpacking_init(mrw_unpacking* out);

// Checks the header and the records' counts. Errors: as mrw_find_unpack_sizes(), and MRW_BAD_ARGUMENT; then nothing is
// begun. Cost: the checksum.
// May be null: error.
mrw_status mrw_begin_unpack(const void* packed, size_t packed_bytes, const mrw_mesh_decoder* decoders,
    size_t decoder_count, void* memory, size_t memory_bytes, mrw_unpacking* out, mrw_data_error* error) MRW_NODISCARD;

// Does one step: a record, or one stage of a mesh (decode; smooth and decode the residual of animation space, if there
// is one; order; write). After the records it does the file's checksum. A step ends early once it has done a few
// milliseconds' work, and the next step goes on there. Only a single call of a codec's library cannot be cut. A call of
// meshoptimizer decodes a mesh's triangles, or one property of its vertices: 20 ms at a million of them. A call of
// Draco decodes all of a mesh: about a microsecond a vertex, 20 ms at 20 000. Cost: docs/threads.md.
//
// Errors: as mrw_unpack(), and unpacking has then ended; MRW_BAD_ARGUMENT if none had begun. May run on any thread, on
// one at a time.
// May be null: error.
mrw_status mrw_unpack_step(mrw_unpacking* unpacking, mrw_data_error* error) MRW_NODISCARD;

// ---- Part draco -----------------------------------------------------------------------------------------------------
// Meshes compressed with Google's Draco: the smallest files, about a microsecond a vertex to decode. Library
// marrow::draco.

// For mrw_unpack(). Draco allocates while it decodes and frees all of it again.
mrw_status mrw_draco_decoder(mrw_mesh_decoder* out) MRW_NODISCARD;

// ---- Part meshopt ---------------------------------------------------------------------------------------------------
// Meshes compressed with meshoptimizer's vertex and index codecs: several times as fast to decode as Draco, and meant
// to be compressed once more by whatever packs the game's data. Library marrow::meshopt.

// For mrw_unpack(). Allocates nothing.
mrw_status mrw_meshopt_decoder(mrw_mesh_decoder* out) MRW_NODISCARD;

// ---- Part pose ------------------------------------------------------------------------------------------------------
// The two forms of a pose that stages hand on: local transforms in groups of four joints, and model-space matrices.

// Local transforms (parent_from_joint = translate · rotate · scale) of four consecutive joints, one lane a joint.
// Rotations are unit quaternions. Lanes past the last joint hold the identity.
typedef struct mrw_soa_transform mrw_soa_transform;
struct MRW_ALIGN(16) mrw_soa_transform {
  float translation[3][4];  // x, y, z; metres
  float rotation[4][4];  // x, y, z, w
  float scale[3][4];  // x, y, z
};

// The change from one pose to another, not a pose: a type of its own, so that one is not taken for the other.
// translation: difference; rotation: of the parent's axes, w ≥ 0; scale: ratio.
typedef struct mrw_additive_transform mrw_additive_transform;
struct mrw_additive_transform {
  mrw_soa_transform change;  // of four joints
};

// An affine map, three rows of four: out = rows · (x, y, z, 1). What palettes and files hold: 48 bytes a joint.
typedef struct mrw_affine mrw_affine;
struct MRW_ALIGN(16) mrw_affine {
  float rows[3][4];  // the last column is the translation
};

// The local transform of one joint.
typedef struct mrw_joint_transform mrw_joint_transform;
struct mrw_joint_transform {
  float translation[3];  // metres
  float rotation[4];  // a unit quaternion x, y, z, w
  float scale[3];  // along the joint's axes
};
void mrw_joint_transform_init(mrw_joint_transform* out);

// How many elements of mrw_soa_transform hold a pose of `joint_count` joints.
size_t mrw_soa_count(size_t joint_count);

// Reads and sets the transform of joint `joint` in a local pose; for a few joints a frame. What is set goes in as it
// is. Errors: MRW_BAD_ARGUMENT if the joint is beyond the pose; nothing is written.
mrw_status mrw_get_joint(const mrw_soa_transform* local, size_t local_count, uint32_t joint,
    mrw_joint_transform* out) MRW_NODISCARD;
mrw_status mrw_set_joint(mrw_soa_transform* local, size_t local_count, uint32_t joint,
    const mrw_joint_transform* transform) MRW_NODISCARD;

// ---- Part math ------------------------------------------------------------------------------------------------------
// A little mathematics of joints and places, for games that bring none: maps one after another, back, and on points.
//
// Maps take column vectors: mrw_compose(a, b) does b first. None of it allocates; all of it is thread-safe.
// marrow/glm.h is for games that have GLM.

// translate · rotate · scale. The rotation is taken as it is: a unit quaternion gives a rotation.
mrw_status mrw_affine_of(const mrw_joint_transform* transform, mrw_affine* out) MRW_NODISCARD;

// a · b: what `b` makes, taken through `a`. world_from_joint = mrw_compose(world_from_model, model_from_joint[j]).
mrw_status mrw_compose(const mrw_affine* a, const mrw_affine* b, mrw_affine* out) MRW_NODISCARD;

// The way back: mrw_compose(out, map) is the identity, within rounding.
// Errors: MRW_BAD_ARGUMENT for a map that is flat (a scale of 0) or not finite, or whose inverse is not finite; nothing
// is written. Method: cofactors over the determinant.
mrw_status mrw_invert(const mrw_affine* map, mrw_affine* out) MRW_NODISCARD;

// A point through a map. out may be point.
void mrw_transform_point(const mrw_affine* map, const float point[3], float out[3]);

// A direction through a map: as a point, but without the map's translation. Its length changes as the map scales.
void mrw_transform_direction(const mrw_affine* map, const float direction[3], float out[3]);

// Which way in the joint's own axes a direction of model space is, of unit length: what mrw_aim.forward and mrw_aim.up
// ask for. With the rest pose's matrices it says once a load where a head's front is.
// Errors: MRW_BAD_ARGUMENT as mrw_invert(), and for a direction without length; nothing is written.
mrw_status mrw_direction_in_joint(const mrw_affine* model_from_joint, const float direction[3],
    float out[3]) MRW_NODISCARD;

// ---- Part example_space ---------------------------------------------------------------------------------------------
// Shape by example, the stage before morph: numbers that a game or a clip sets → weights of morph targets.
//
//   once a load    mrw_file_example_space, mrw_find_example_channels
//   every frame    mrw_sample_channels → parameters → mrw_evaluate_examples → weights of each of the space's meshes →
//                  mrw_morph(), or mrw_character_mesh.weights between mrw_pose_character() and mrw_finish_character()
//
// An artist places shapes at points of a space, such as "angry" at (1, 0). Each shape is a morph target, or the mesh as
// it is. Between those points all shapes are interpolated at once. The cooker solves for the coefficients here
// (docs/deformers.md).

// What a space has at most.
#define MRW_MAX_EXAMPLE_PARAMETERS 8u
#define MRW_MAX_EXAMPLES 64u  // also the most targets

// An axis of the space.
typedef struct mrw_example_parameter mrw_example_parameter;
struct mrw_example_parameter {
  uint32_t name;  // see mrw_file_text; also of the channel that drives it
  float rest;  // where nothing drives it
};

// Rows have one float a target, and zeros up to a multiple of four.
typedef struct mrw_example_space mrw_example_space;
struct mrw_example_space {
  const char* name;  // as the source calls it; never null
  uint32_t example_count;  // at most MRW_MAX_EXAMPLES
  const mrw_example_parameter* parameters;  // at most MRW_MAX_EXAMPLE_PARAMETERS
  size_t parameter_count;
  const uint32_t* targets;  // of each mesh the targets that it weighs, ascending, at most MRW_MAX_EXAMPLES
  size_t target_count;
  const uint32_t* meshes;  // of the file, ascending
  size_t mesh_count;
  const float* linear;  // a row of constants, then a row a parameter
  size_t linear_count;
  const float* radial;  // a row an example
  size_t radial_count;
  const float* places;  // for each example its parameters
  size_t place_count;
  const float* inverse_widths;  // one an example; above 0
  size_t inverse_width_count;
};

// ---- Part skeleton --------------------------------------------------------------------------------------------------
// The joints of a character as a file has them, with their limits and springs.

// Limits that every valid file keeps, so that a caller can bound its memory by them.
#define MRW_MAX_JOINTS 32767u

// No joint: in mrw_skeleton.parents a root.
#define MRW_NO_JOINT 0xFFFFu

// The shape of an mrw_joint_limit: which rotations it allows.
typedef uint8_t mrw_limit_kind;
enum {
  MRW_LIMIT_KIND_NONE = 0,  // turns freely; for joints that have a rate limit alone
  MRW_LIMIT_KIND_HINGE = 1,  // about one axis, between two angles: knees, elbows, fingers
  MRW_LIMIT_KIND_CONE = 2,  // swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
  // three angles about three axes, each within its own range: for rigs with Euler-angle limits
  MRW_LIMIT_KIND_EULER = 3,
};

// The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
typedef uint8_t mrw_axis_order;
enum {
  MRW_AXIS_ORDER_XYZ = 0,
  MRW_AXIS_ORDER_XZY = 1,
  MRW_AXIS_ORDER_YXZ = 2,
  MRW_AXIS_ORDER_YZX = 3,
  MRW_AXIS_ORDER_ZXY = 4,
  MRW_AXIS_ORDER_ZYX = 5,
};

// Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
// clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
// mrw_make_angle_range() in part limits.
typedef struct mrw_angle_range mrw_angle_range;
struct mrw_angle_range {
  float middle;  // -1 … 1: -180° … 180°
  float half_width;  // 0 … 1; 1: any angle
};

// The highest speed and acceleration; 0: no limit. In radians for rotations, in metres for points.
typedef struct mrw_rate_limit mrw_rate_limit;
struct mrw_rate_limit {
  float speed;  // rad/s or m/s
  float acceleration;  // rad/s² or m/s²
};
void mrw_rate_limit_init(mrw_rate_limit* out);

// How far and how fast a joint may turn, as it lies in a cooked file; make one with mrw_make_limit(), see part limits.
//
// The limit has axes of its own, fixed to the joint. At the joint's zero rotation they coincide with axes fixed to the
// parent. In them a local rotation q (parent_from_joint) is
//   t = limit_from_parent · q · joint_from_limit,   limit_from_parent = (zero · joint_from_limit)⁻¹
// so that t is the identity where q = zero. Angles are positive by the right hand: about x from y to z.
//
// hinge: t is a turn about x, by an angle in angles[0].
// cone: t = swing · twist, the twist, about x, first. The twist is an angle in angles[0]. The swing turns by θ about a
//   unit axis in the y-z plane. The point (y, z) = tan(θ / 4) · axis lies in the ellipse with the half axes
//   angles[1].half_width and angles[2].half_width. So angles[1] holds the widest swing about y alone, angles[2] the
//   widest about z alone. Below 90° this is within 2.3° of an ellipse in the angles themselves.
// euler: t is the product of three turns about x, y and z in the order `order`; angles[0] is the first factor's. The
//   second angle is within ±90°, so that each rotation has one set of angles (at ±90° many).
//
// At a swing of 180° the twist is undefined: the smallest step leads to any twist. See mrw_clamp_rotation().
typedef struct mrw_joint_limit mrw_joint_limit;
struct mrw_joint_limit {
  uint16_t joint;  // of the skeleton
  mrw_limit_kind kind;  // which of the shapes above
  mrw_axis_order order;  // of euler; else xyz
  float limit_from_parent[4];  // unit quaternion
  float joint_from_limit[4];  // unit quaternion
  mrw_angle_range angles[3];  // of a cone the middles of the second and third are 0; of a hinge both are 0
  mrw_rate_limit rate;  // of the local rotation, see mrw_follow_pose()
};
void mrw_joint_limit_init(mrw_joint_limit* out);

#define MRW_MAX_SPRING_COLLIDERS 64u  // as many as mrw_spring_chain.colliders has bits

// A joint that swings. Its bone goes from the joint to the next joint of its chain. See part springs.
typedef struct mrw_spring_joint mrw_spring_joint;
struct mrw_spring_joint {
  uint16_t joint;  // of the skeleton
  uint16_t most_pull;  // 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
  float frequency_hz;  // 0 … 15: of small swings about the animated direction, undamped and without gravity
  float damping_ratio;  // 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
  float gravity;  // -10 … 10, times mrw_spring_frame.gravity
  float drag;  // 0 … 50 1/s: how strongly air slows the bone's end, and wind carries it
  float radius_m;  // ≥ 0: of a sphere about the bone's end, which stays out of colliders; world
  float weight;  // 0 … 1: how much of the swing is shown; the swing itself goes on at 0, too
};
void mrw_spring_joint_init(mrw_spring_joint* out);

// A chain of joints, each a descendant of the one before it. A joint belongs to at most one chain.
typedef struct mrw_spring_chain mrw_spring_chain;
struct mrw_spring_chain {
  const mrw_spring_joint* joints;  // from the chain's root to its end
  size_t joint_count;
  float tip[3];  // end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
  uint64_t colliders;  // bit i, lowest first: the chain stays out of mrw_spring_frame.colliders[i]
};
void mrw_spring_chain_init(mrw_spring_chain* out);

// A capsule that moves with a joint; a sphere where both ends are one point. Its radius is scaled by the largest of the
// scales along the joint's axes.
typedef struct mrw_spring_collider mrw_spring_collider;
struct mrw_spring_collider {
  uint16_t joint;  // the joint that it moves with
  uint16_t reserved;
  float from[3];  // in the joint's space
  float to[3];  // in the joint's space
  float radius_m;  // in the joint's space
};
void mrw_spring_collider_init(mrw_spring_collider* out);

typedef struct mrw_spring_collider_list mrw_spring_collider_list;
struct mrw_spring_collider_list {
  const mrw_spring_collider* data;
  size_t size;
};

// The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
// comes before its children and the roots come first.
typedef struct mrw_skeleton mrw_skeleton;
struct mrw_skeleton {
  const char* name;  // as the source calls it; never null
  uint32_t joint_count;  // 1 … MRW_MAX_JOINTS
  uint32_t root_count;  // joints 0 … root_count-1 have no parent joint
  const mrw_affine* model_from_root;  // root_count; the transform above each root, which never changes
  const mrw_soa_transform* rest;  // mrw_soa_count(joint_count); the pose of joints that a clip leaves alone
  const uint16_t* parents;  // joint_count; MRW_NO_JOINT for roots
  const uint32_t* names;  // joint_count; see mrw_file_text
  const mrw_joint_limit* limits;  // the asset's own limits, ascending by joint
  size_t limit_count;
};

// The skeleton that clips of a clip pack were made for; a pack holds references instead of skeletons. See part
// clip_pack.
typedef struct mrw_skeleton_reference mrw_skeleton_reference;
struct mrw_skeleton_reference {
  const char* name;  // the skeleton's
  uint32_t joint_count;  // the skeleton's
  uint64_t hash;  // mrw_skeleton_hash() of the skeleton
  const uint32_t* names;  // joint_count; see mrw_file_text
  const uint32_t* rest_hashes;  // joint_count; of each joint's rest pose
  const uint16_t* parents;  // joint_count; MRW_NO_JOINT for roots
};

// Whether a limit keeps these rules. Limits from mrw_make_limit() and mrw_load() do.
bool mrw_is_valid(const mrw_joint_limit* limit);

// How many groups of four joints a local pose has.
size_t mrw_skeleton_soa_size(const mrw_skeleton* skeleton);

// ---- Part roles -----------------------------------------------------------------------------------------------------
// Which joint is the left foot, the head, the tail: roles of joints, mirrored pairs and soles, as the cooker found
// them.

// What a joint is for. Names are those of VRM's humanoid; left and right are the character's own. Hind legs of animals
// are legs; front legs have the arms' roles, so what stands on the ground may be feet and hands. A limb's role is that
// of the joint where the limb begins: left_lower_arm is the elbow, left_hand the wrist.
typedef uint8_t mrw_role;
enum {
  MRW_ROLE_NONE = 0,  // of joints without a role
  MRW_ROLE_ROOT = 1,  // above the hips: what moves all of the character
  MRW_ROLE_HIPS = 2,  // carries the legs and the trunk
  MRW_ROLE_SPINE = 3,
  MRW_ROLE_CHEST = 4,
  MRW_ROLE_UPPER_CHEST = 5,
  MRW_ROLE_NECK = 6,
  MRW_ROLE_HEAD = 7,
  MRW_ROLE_JAW = 8,
  MRW_ROLE_LEFT_EYE = 9,
  MRW_ROLE_RIGHT_EYE = 10,
  MRW_ROLE_LEFT_SHOULDER = 11,
  MRW_ROLE_LEFT_UPPER_ARM = 12,
  MRW_ROLE_LEFT_LOWER_ARM = 13,
  MRW_ROLE_LEFT_HAND = 14,
  MRW_ROLE_RIGHT_SHOULDER = 15,
  MRW_ROLE_RIGHT_UPPER_ARM = 16,
  MRW_ROLE_RIGHT_LOWER_ARM = 17,
  MRW_ROLE_RIGHT_HAND = 18,
  MRW_ROLE_LEFT_UPPER_LEG = 19,
  MRW_ROLE_LEFT_LOWER_LEG = 20,
  MRW_ROLE_LEFT_FOOT = 21,
  MRW_ROLE_LEFT_TOES = 22,
  MRW_ROLE_RIGHT_UPPER_LEG = 23,
  MRW_ROLE_RIGHT_LOWER_LEG = 24,
  MRW_ROLE_RIGHT_FOOT = 25,
  MRW_ROLE_RIGHT_TOES = 26,
  MRW_ROLE_LEFT_THUMB_METACARPAL = 27,
  MRW_ROLE_LEFT_THUMB_PROXIMAL = 28,
  MRW_ROLE_LEFT_THUMB_DISTAL = 29,
  MRW_ROLE_LEFT_INDEX_PROXIMAL = 30,
  MRW_ROLE_LEFT_INDEX_INTERMEDIATE = 31,
  MRW_ROLE_LEFT_INDEX_DISTAL = 32,
  MRW_ROLE_LEFT_MIDDLE_PROXIMAL = 33,
  MRW_ROLE_LEFT_MIDDLE_INTERMEDIATE = 34,
  MRW_ROLE_LEFT_MIDDLE_DISTAL = 35,
  MRW_ROLE_LEFT_RING_PROXIMAL = 36,
  MRW_ROLE_LEFT_RING_INTERMEDIATE = 37,
  MRW_ROLE_LEFT_RING_DISTAL = 38,
  MRW_ROLE_LEFT_LITTLE_PROXIMAL = 39,
  MRW_ROLE_LEFT_LITTLE_INTERMEDIATE = 40,
  MRW_ROLE_LEFT_LITTLE_DISTAL = 41,
  MRW_ROLE_RIGHT_THUMB_METACARPAL = 42,
  MRW_ROLE_RIGHT_THUMB_PROXIMAL = 43,
  MRW_ROLE_RIGHT_THUMB_DISTAL = 44,
  MRW_ROLE_RIGHT_INDEX_PROXIMAL = 45,
  MRW_ROLE_RIGHT_INDEX_INTERMEDIATE = 46,
  MRW_ROLE_RIGHT_INDEX_DISTAL = 47,
  MRW_ROLE_RIGHT_MIDDLE_PROXIMAL = 48,
  MRW_ROLE_RIGHT_MIDDLE_INTERMEDIATE = 49,
  MRW_ROLE_RIGHT_MIDDLE_DISTAL = 50,
  MRW_ROLE_RIGHT_RING_PROXIMAL = 51,
  MRW_ROLE_RIGHT_RING_INTERMEDIATE = 52,
  MRW_ROLE_RIGHT_RING_DISTAL = 53,
  MRW_ROLE_RIGHT_LITTLE_PROXIMAL = 54,
  MRW_ROLE_RIGHT_LITTLE_INTERMEDIATE = 55,
  MRW_ROLE_RIGHT_LITTLE_DISTAL = 56,
  MRW_ROLE_TAIL = 57,  // each joint of the tail has this one
};

#define MRW_ROLE_COUNT 58u  // with none

// A joint with a role.
typedef struct mrw_joint_role mrw_joint_role;
struct mrw_joint_role {
  uint16_t joint;  // of the skeleton
  mrw_role role;  // what the joint is for
  uint8_t reserved;
};

// Two joints that mirror each other at rest.
typedef struct mrw_joint_pair mrw_joint_pair;
struct mrw_joint_pair {
  uint16_t left;  // of the skeleton
  uint16_t right;  // of the skeleton
};

// Where a foot stands.
typedef struct mrw_joint_sole mrw_joint_sole;
struct mrw_joint_sole {
  uint16_t joint;  // a foot, or a hand that is a front foot
  uint16_t reserved;
  float place[3];  // on the ground below the ball of the foot at rest; joint's space. As mrw_foot.sole
};

// What is known of a skeleton's joints; see mrw_file_roles. All three are empty where nothing is.
typedef struct mrw_roles mrw_roles;
struct mrw_roles {
  const mrw_joint_role* roles;  // ascending by joint; no role but tail twice
  size_t role_count;
  const mrw_joint_pair* pairs;  // ascending by the left joint; a joint is in one pair at most
  size_t pair_count;
  const mrw_joint_sole* soles;  // ascending by joint
  size_t sole_count;
};

// The joint with this role; of a tail its first. MRW_NO_JOINT if there is none, and for MRW_ROLE_NONE. Cost: a look at
// the roles; once a load, not a frame. This and those below are thread-safe.
uint16_t mrw_joint_of(const mrw_roles* roles, mrw_role role);

// The joint's role; MRW_ROLE_NONE if it has none. Cost: as mrw_joint_of().
mrw_role mrw_role_of(const mrw_roles* roles, uint32_t joint);

// The joint on the other side; MRW_NO_JOINT if there is none, as of the spine. Cost: a look at the pairs.
uint16_t mrw_mirror_of(const mrw_roles* roles, uint32_t joint);

// Where the joint stands on the ground; null if that is not known. Points into `roles`. Cost: a look at the soles.
const mrw_joint_sole* mrw_sole_of(const mrw_roles* roles, uint32_t joint);

// "left_upper_leg"; of what is no role "none". Zero-terminated, never null.
const char* mrw_role_name(mrw_role role);

// The role with this name; MRW_ROLE_NONE if there is none, and for a null pointer. Cost: a look at all names.
mrw_role mrw_find_role(const char* name);

// ---- Part pose_map --------------------------------------------------------------------------------------------------
// Poses of another rig put onto a skeleton, frame by frame: motion capture as it comes in, a pose from a network,
// another character's. The cooker makes the map (--pose-map); it says which joints turn as which.
//
//   const mrw_pose_map map = file.pose_map(file.find_pose_map("mocap"));
//   mrw_retarget_pose(map, captured, skeleton, local);

// How four consecutive joints turn, one lane a joint, as in mrw_soa_transform: a joint's local rotation is before · r ·
// after, with r the local rotation of one joint of the rig. before and after are what the rest poses of both rigs
// differ by.
typedef struct mrw_mapped_group mrw_mapped_group;
struct mrw_mapped_group {
  float before[4][4];  // unit quaternions x, y, z, w
  float after[4][4];  // likewise
  uint16_t rig_joints[4];  // MRW_NO_JOINT: r is the identity, so that the rotation never changes
};

// One local rotation of the rig, on the way from one of its joints to another.
typedef struct mrw_rig_step mrw_rig_step;
struct mrw_rig_step {
  uint16_t joint;  // of the rig
  uint8_t inverse;  // not 0: the way leads up, so its inverse counts
  uint8_t mirrored;  // not 0: its y and z are negated; one of the two joints is in a mirrored space
};
void mrw_rig_step_init(mrw_rig_step* out);

// How a joint turns that takes more than that, in place of its group's lane: before · Π steps · after. Of a joint that
// is between several of the rig there is one for each. Their weighted sum is normalised; each is added in the
// hemisphere of the sum.
typedef struct mrw_mapped_turn mrw_mapped_turn;
struct mrw_mapped_turn {
  uint16_t joint;  // of the skeleton
  uint16_t step_count;  // the next of mrw_pose_map.steps
  float weight;  // 1e-6 … 1
  float before[4];  // unit quaternion x, y, z, w
  float after[4];  // likewise
};
void mrw_mapped_turn_init(mrw_mapped_turn* out);

// Where a joint goes: its local translation is parent_from_rig · p. p is where the last step's joint is, in the space
// above the first one's.
typedef struct mrw_mapped_place mrw_mapped_place;
struct mrw_mapped_place {
  uint16_t joint;  // of the skeleton
  uint16_t step_count;  // the next of mrw_pose_map.steps, ≥ 1, each a child of the one before
  float parent_from_rig[3][4];  // affine map, as mrw_affine
};
void mrw_mapped_place_init(mrw_mapped_place* out);

// How a skeleton of the file takes poses of another rig; see mrw_file_pose_map.
typedef struct mrw_pose_map mrw_pose_map;
struct mrw_pose_map {
  const char* name;  // of the rig's file; never null
  uint32_t skeleton;  // which skeleton of the file
  uint32_t rig_joint_count;  // of the rig
  uint64_t rig_hash;  // mrw_skeleton_hash() of the rig, cooked; says whether poses are of the right one
  const mrw_mapped_group* groups;  // of all joints
  size_t group_count;
  const mrw_mapped_turn* turns;  // ascending by joint
  size_t turn_count;
  const mrw_mapped_place* places;  // ascending strictly by joint: the hips, and what is above them
  size_t place_count;
  const mrw_rig_step* steps;  // those of the turns, then those of the places
  size_t step_count;
};

// Puts a pose of the rig onto the skeleton. Joints that nothing turns are at rest below their parents. Bones of pairs
// point the same way as the rig's; hips go as far as its do, in lengths of the legs. Feet slide and sink as far as the
// bodies differ: call mrw_place_feet() after it.
//
// rig: at least mrw_soa_count(map.rig_joint_count). out: at least mrw_skeleton_soa_size(skeleton); it gets rotations of
// unit length, and does not overlap `rig`. Scales of the rig move places, and nothing else. A joint whose place would
// not be finite, or beyond 1e12, is where it is at rest. Errors: MRW_BAD_ARGUMENT if a list is too short, the map is of
// fewer joints than the skeleton or names one that there is not, its steps are not as many as it says, or a rotation of
// `rig` is not finite or its squared length not 0.5 … 4.1. Nothing is written then. Cost: 66 instructions a joint on
// x86-64, and 125 a turn beside the groups. No allocation. Thread-safe on different outputs.
mrw_status mrw_retarget_pose(const mrw_pose_map* map, const mrw_soa_transform* rig, size_t rig_count,
    const mrw_skeleton* skeleton, mrw_soa_transform* out, size_t out_count) MRW_NODISCARD;

// ---- Part clip_motion -----------------------------------------------------------------------------------------------
// What a game asks of a clip beside its poses: how fast it goes, what happens in it, where its steps are, where its
// root moves. A view, from a file or made by hand; part events, part root_motion, part phase and part blend_space read
// it.

// A cycle has as many segments as phase marks, and no group of clips has a cycle of more: see part phase.
#define MRW_MAX_MARKS 64u

// Distances and times of a motion are at most this, in metres and seconds.
#define MRW_FARTHEST_MOTION 1e12f

// Something that happens in a clip: a moment, as a blow that lands, or a list, as a foot that stands.
typedef struct mrw_clip_event mrw_clip_event;
struct mrw_clip_event {
  float time_s;  // 0 … the clip's duration
  float until_s;  // ≥ time_s; equal: a moment. Beyond the clip's end it goes on at its start
  uint32_t name;  // see mrw_file_text
  float number;  // whatever the game means by it
};
void mrw_clip_event_init(mrw_clip_event* out);

// M(t): where the root has moved since the clip's start, in model space. Between keys the translation is linear; the
// rotation is the normalised sum of the two quaternions (nlerp), on the shorter arc, so keys are less than half a turn
// apart. Before the first key and after the last M stays.
typedef struct mrw_root_key mrw_root_key;
struct mrw_root_key {
  float time_s;  // 0 … the clip's duration
  float rotation[4];  // unit quaternion x, y, z, w
  float translation[3];  // metres
};

// A clip's motion.
typedef struct mrw_clip_motion mrw_clip_motion;
struct mrw_clip_motion {
  float duration_s;  // the clip's; ≥ 0
  float speed_m_s;  // over the ground, ≥ 0, also of a clip that walks on the spot
  float heading[3];  // where to: of unit length, model space; 0: nowhere
  const mrw_clip_event* events;  // by time_s
  size_t event_count;
  // Where the segments of a cycle begin, see part phase: at most MRW_MAX_MARKS, 0 … below the duration. Each is later
  // than the one before. A cycle may begin anywhere in the clip, so once at most they go on at the clip's start.
  const float* phase_marks;
  size_t phase_mark_count;
  const mrw_root_key* root;  // by time, strictly; the first is the identity; empty: the root stays
  size_t root_count;
};
void mrw_clip_motion_init(mrw_clip_motion* out);

// Whether a motion keeps these rules: numbers finite, lists and marks in order, an event no longer than the clip,
// rotations of unit length within 1e-3. Call it once for a motion that is made by hand; the functions that read motions
// do not. Cost: once over it all.
bool mrw_clip_motion_is_valid(const mrw_clip_motion* motion);

// ---- Part clip ------------------------------------------------------------------------------------------------------
// A clip as a file has it: what moves, and numbers beside it.

// No clip: a skeleton rests.
#define MRW_NO_CLIP 0xFFFFFFFFu

// Which part of a local transform an mrw_track drives.
typedef uint8_t mrw_track_path;
enum {
  MRW_TRACK_PATH_TRANSLATION = 0,
  MRW_TRACK_PATH_ROTATION = 1,
  MRW_TRACK_PATH_SCALE = 2,
};

// What lies between two keys, as glTF 2.0 defines it.
typedef uint8_t mrw_interpolation;
enum {
  MRW_INTERPOLATION_STEP = 0,
  MRW_INTERPOLATION_LINEAR = 1,
  MRW_INTERPOLATION_CUBIC_SPLINE = 2,
};

// One channel of a clip stored without loss: the source's own keys at the source's own times.
typedef struct mrw_track mrw_track;
struct mrw_track {
  uint16_t joint;  // of the skeleton
  mrw_track_path path;  // what of the joint it drives
  mrw_interpolation interpolation;  // between its keys
  uint32_t key_count;  // ≥ 1
  uint32_t first_time;  // into mrw_clip.times_s; tracks with the same keys share them
  uint32_t first_value;  // Into mrw_clip.values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
};

// For a group of four joints: which sub-tracks (a joint's rotation, translation or scale) move in a clip, and which
// hold one value that is not the rest pose's. Bits 0-3 are rotations, 4-7 translations, 8-11 scales; the lowest bit is
// the first joint.
typedef struct mrw_group_masks mrw_group_masks;
struct mrw_group_masks {
  uint16_t moving;  // sub-tracks that change over the clip
  uint16_t constant;  // sub-tracks that hold one value, not the rest pose's
};

// A number over time, such as a morph target's weight or a property of the game; it moves no joint. Stored without
// loss, except that keys on a straight line between others may have been left out (docs/cooking/clips.md).
typedef struct mrw_channel mrw_channel;
struct mrw_channel {
  uint32_t name;  // see mrw_file_text
  float rest;  // the number where no clip drives it
  uint32_t key_count;  // ≥ 1
  uint32_t first_time;  // as in mrw_track
  uint32_t first_value;  // into mrw_clip.values; one float a key, three for cubic_spline (in, value, out)
  mrw_interpolation interpolation;  // between its keys
  uint8_t reserved[3];
};

// No channel.
#define MRW_NO_CHANNEL 0xFFFFFFFFu

// Tracks compressed within a stated error (docs/format.md): poses at even steps of time, or at times of their own. They
// are divided into segments of packed integers, relative to the rest pose. What does not move is stored once.
typedef struct mrw_coded_tracks mrw_coded_tracks;
struct mrw_coded_tracks {
  uint32_t frame_count;  // 0: the clip has no coded tracks; else ≥ 2
  uint32_t track_count;  // sub-tracks that move
  uint32_t constant_count;  // sub-tracks that hold one value, not the rest pose's
  uint32_t segment_intervals;  // time steps in a segment; the last may have fewer
  float start_s;  // of frame 0
  float frames_per_s;  // the mean rate where steps are uneven
  const float* times_s;  // frame_count, ascending; null: even steps
  const mrw_group_masks* masks;  // one a group of four joints
  const uint32_t* segment_offsets;  // bytes into payload
  const void* constants;  // their values
  const void* payload;  // segments of packed integers
};

// An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
typedef struct mrw_clip mrw_clip;
struct mrw_clip {
  const char* name;  // as the source calls it; never null
  uint32_t skeleton;  // which skeleton of the file; in a clip pack, which reference
  uint32_t joint_count;  // of that skeleton
  float duration_s;  // time of the last key; ≥ 0
  bool additive;  // for mrw_sample_additive(), not for mrw_sample()
  const mrw_soa_transform* reference;  // additive: the pose that changes are relative to; null: the rest pose
  mrw_coded_tracks coded;  // what is compressed
  const mrw_track* tracks;  // what is stored without loss
  size_t track_count;
  const mrw_channel* channels;  // numbers that it drives
  size_t channel_count;
  const float* times_s;  // key times of tracks and channels, seconds
  const float* values;  // keys of tracks and channels
  uint64_t id;  // of its bytes and its place in the file, from mrw_file_clip(); 0: made by hand
};

// ---- Part material --------------------------------------------------------------------------------------------------
// Materials and pictures as a file has them. The runtime draws with neither: a game does.

// In mrw_mesh.material_index: the source says no more of the material than the mrw_mesh itself holds.
#define MRW_NO_MATERIAL 0xFFFFFFFFu

// No image.
#define MRW_NO_IMAGE 0xFFFFFFFFu

// How a material's alpha is meant, as in glTF 2.0.
typedef uint8_t mrw_alpha_mode;
enum {
  MRW_ALPHA_MODE_OPAQUE = 0,
  MRW_ALPHA_MODE_MASK = 1,
  MRW_ALPHA_MODE_BLEND = 2,
};

// Which property of a material an image supplies.
typedef uint8_t mrw_texture_role;
enum {
  MRW_TEXTURE_ROLE_BASE_COLOUR = 0,
  MRW_TEXTURE_ROLE_METALLIC_ROUGHNESS = 1,
  MRW_TEXTURE_ROLE_NORMAL = 2,
  MRW_TEXTURE_ROLE_OCCLUSION = 3,
  MRW_TEXTURE_ROLE_EMISSIVE = 4,
  // KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
  MRW_TEXTURE_ROLE_SPECULAR_GLOSSINESS = 5,
};

// What lies beyond an image's edge.
typedef uint8_t mrw_wrap;
enum {
  MRW_WRAP_REPEAT = 0,
  MRW_WRAP_CLAMP_TO_EDGE = 1,
  MRW_WRAP_MIRRORED_REPEAT = 2,
};

// How an image is magnified.
typedef uint8_t mrw_mag_filter;
enum {
  MRW_MAG_FILTER_ANY = 0,
  MRW_MAG_FILTER_NEAREST = 1,
  MRW_MAG_FILTER_LINEAR = 2,
};

// How an image is minified; any: the source leaves it to the game.
typedef uint8_t mrw_min_filter;
enum {
  MRW_MIN_FILTER_ANY = 0,
  MRW_MIN_FILTER_NEAREST = 1,
  MRW_MIN_FILTER_LINEAR = 2,
  MRW_MIN_FILTER_NEAREST_MIPMAP_NEAREST = 3,
  MRW_MIN_FILTER_LINEAR_MIPMAP_NEAREST = 4,
  MRW_MIN_FILTER_NEAREST_MIPMAP_LINEAR = 5,
  MRW_MIN_FILTER_LINEAR_MIPMAP_LINEAR = 6,
};

// What an image's bytes are.
typedef uint8_t mrw_image_format;
enum {
  MRW_IMAGE_FORMAT_UNKNOWN = 0,
  MRW_IMAGE_FORMAT_PNG = 1,
  MRW_IMAGE_FORMAT_JPEG = 2,
  MRW_IMAGE_FORMAT_WEBP = 3,
  MRW_IMAGE_FORMAT_KTX2 = 4,
  MRW_IMAGE_FORMAT_DDS = 5,
};

// An image in a role; its channels are as in glTF 2.0, section 3.9. Base colour, emissive and specular-glossiness
// images are sRGB (the last except for alpha), all others linear. UV (0, 0) is the image's upper left corner.
typedef struct mrw_texture mrw_texture;
struct mrw_texture {
  uint16_t image;  // which image of the file
  mrw_texture_role role;  // none twice in a material
  mrw_wrap wrap_u;  // along u and v
  mrw_wrap wrap_v;  // along u and v
  mrw_mag_filter mag;  // as the source asks
  mrw_min_filter min;  // as the source asks
  uint8_t reserved;
};

// What a material has beyond the members of mrw_mesh.
typedef struct mrw_material mrw_material;
struct mrw_material {
  const char* name;  // as the source calls it; never null
  mrw_alpha_mode alpha;  // opaque: alpha is not looked at
  float alpha_cutoff;  // mask: what is less opaque is not drawn
  bool unlit;  // KHR_materials_unlit: the base colour is what is seen
  float emissive[3];  // linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
  const mrw_texture* textures;  // one a role
  size_t texture_count;
};

// A picture, by reference or as the source's own bytes. Marrow does not check the bytes; whoever decodes them must.
typedef struct mrw_image mrw_image;
struct mrw_image {
  const char* name;  // as the source calls it; never null
  const char* uri;  // relative to the source file and percent-encoded, as it stood there; empty if it had none
  mrw_image_format format;  // unknown: neither its bytes nor its URI tell which
  const void* bytes;  // empty: by reference
  size_t byte_count;
  uint32_t fallback;  // of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
};

// ---- Part mesh ------------------------------------------------------------------------------------------------------
// Vertices, triangles and what they hang on, as a file has them.

// The most palette entries that a vertex follows.
#define MRW_MAX_INFLUENCES 8u

// In mrw_geometry.source_slots: a vertex of no triangle.
#define MRW_NO_SLOT 0xFFFFFFFFu

// The most examples of an mrw_pose_space.
#define MRW_MAX_POSE_EXAMPLES 32u

// Which attributes a morph target changes.
#define MRW_MORPHS_POSITIONS 1u
#define MRW_MORPHS_NORMALS 2u
#define MRW_MORPHS_TANGENTS 4u

// Consecutive vertices that depend on the same joints. Each run starts a new block of four vertices; the slots that
// fill up its last block repeat its last vertex.
typedef struct mrw_run mrw_run;
struct mrw_run {
  uint32_t vertex_count;  // ≥ 1
  uint32_t influences;  // 1 … MRW_MAX_INFLUENCES
};

// What a morph target adds to the vertices of the blocks that it moves; other blocks it leaves alone. Each block has a
// record for each attribute, in the order of MorphAttributes: twelve integers dx[4] dy[4] dz[4]. An integer times the
// attribute's step is the change.
typedef struct mrw_morph_target mrw_morph_target;
struct mrw_morph_target {
  uint32_t first_block;  // into mrw_geometry.target_blocks
  uint32_t block_count;  // how many blocks it moves
  uint32_t first_record;  // into mrw_geometry.target_records
  uint32_t attributes;  // MRW_MORPHS_POSITIONS | …; 0 if it moves nothing
  float position_step;  // metres, mesh space
  float normal_step;  // the change that 1 in a record of normals means
  float tangent_step;  // the change that 1 in a record of tangents means
  uint32_t reserved;
};

// Example poses for pose-space deformation, and for each example the deltas of the blocks that it moves. They are added
// to the bind pose, see mrw_skin_psd() in part skin.
typedef struct mrw_pose_space mrw_pose_space;
struct mrw_pose_space {
  float sigma;  // width of the Gaussian, as the sine of half an angle
  const mrw_morph_target* examples;  // positions alone; empty: none
  size_t example_count;
  const void* blocks;  // as mrw_geometry.target_blocks
  const int16_t* records;  // as mrw_geometry.target_records
  const int16_t* rotations;  // for each example and palette entry a quaternion x y z w, of any length
  const uint16_t* parents;  // the entry that each entry's rotation is relative to, or MRW_NO_JOINT
};

// Triangles and bind-pose vertices. Vertices live in *slots*: blocks of four, laid out for the skinning kernels
// (`k` is the run's influence count). The arrays of blocks begin on 16-byte boundaries.
typedef struct mrw_geometry mrw_geometry;
struct mrw_geometry {
  uint32_t slot_count;  // vertices with padding; a multiple of 4
  uint32_t vertex_count;  // without padding
  uint32_t index_count;  // 3 a triangle; counter-clockwise fronts
  uint32_t index_bytes;  // 2 or 4
  uint32_t joint_count;  // how many palette entries the sets refer to
  const void* indices;  // slots
  const mrw_run* runs;  // in the order of the slots
  size_t run_count;
  const uint16_t* sets;  // for each run its k palette entries, run after run
  const float* skin;  // a block: x[4] y[4] z[4], then k-1 times w[4]; the last weight is 1 - Σ
  const float* normals;  // a block: x[4] y[4] z[4]; unit; null if absent
  const float* tangents;  // a block: x[4] y[4] z[4] sign[4]; unit; null if absent
  const float* as_residual;  // a block: k times dx[4] dy[4] dz[4] dw[4]; null: the lift, all zero
  const float* mwe_residual;  // a block: k times three rows x[4] y[4] z[4] t[4]; null if absent
  uint32_t mwe_root;  // palette entry in whose frame mwe_residual is meant
  const float* uvs;  // a slot: u v; null if absent
  const uint8_t* colours;  // a slot: r g b a, linear; null if absent
  // The slot of each source vertex, if cooked with --keep-vertex-order. MRW_NO_SLOT: no triangle of this mesh uses the
  // vertex; of a primitive that was split into parts, no triangle of this part.
  const uint32_t* source_slots;
  size_t source_slot_count;
  const mrw_morph_target* targets;  // morph targets, as many as mrw_mesh_target of a mesh
  size_t target_count;
  const void* target_blocks;  // as wide as indices; for each target the blocks it moves, ascending
  const int16_t* target_records;  // twelve a record
  mrw_pose_space pose_space;  // examples empty: none
  float box_min[3];  // of the bind positions, mesh space
  float box_max[3];  // likewise
};

// A morph target of a mesh: what it is called and what drives it.
typedef struct mrw_mesh_target mrw_mesh_target;
struct mrw_mesh_target {
  uint32_t name;  // see mrw_file_text; may be empty
  // Name of the channel by which clips drive its weight; see mrw_find_weight_channels() in part morph.
  uint32_t channel;
  float weight;  // its weight where no clip drives it
};

// A palette entry that blends those of two joints, for vertices that follow both: see mrw_build_palette().
typedef struct mrw_helper mrw_helper;
struct mrw_helper {
  uint16_t first;  // palette entries, below mrw_mesh.joint_count, not the same
  uint16_t second;  // palette entries, below mrw_mesh.joint_count, not the same
  float share;  // of second; above 0, below 1
};
void mrw_helper_init(mrw_helper* out);

// A level of detail: another geometry over the same palette.
typedef struct mrw_mesh_lod mrw_mesh_lod;
struct mrw_mesh_lod {
  uint32_t geometry;  // which of the file
  float error_m;  // the farthest that a vertex of the full mesh is from it, in the clips it was made with
};

// A box and a sphere about the box's centre; both contain the same vertices. Model space, metres.
typedef struct mrw_bounds mrw_bounds;
struct mrw_bounds {
  float box_min[3];  // least corner
  float box_max[3];  // greatest corner
  float radius_m;  // below 0: empty, or not known
};

// Geometry bound to joints. A mesh hung rigidly on a node is bound to one joint with weight 1.
typedef struct mrw_mesh mrw_mesh;
struct mrw_mesh {
  const char* name;  // as the source calls it; never null
  const char* material;  // the material's name; never null
  uint32_t material_index;  // which material of the file, if that has more than this mrw_mesh
  uint32_t skeleton;  // which skeleton of the file
  uint32_t geometry_index;  // meshes with the same number share their geometry
  uint32_t joint_count;  // palette entries that are joints
  const uint16_t* joints;  // joint_count; palette entry → joint of the skeleton
  const mrw_affine* inverse_bind;  // joint_count; joint_from_mesh in the bind pose
  float base_colour[4];  // linear RGBA
  bool double_sided;  // backs are drawn, too
  // Another part of the same source primitive as the mesh before it: one palette was too small for the whole. Only the
  // source's vertex order depends on this, see mrw_geometry.source_slots.
  bool is_next_part;
  const mrw_helper* helpers;  // palette entries behind those of the joints
  size_t helper_count;
  const float* helper_centres;  // three a helper, or none: see mrw_build_palette()
  size_t helper_centre_count;
  const mrw_mesh_target* targets;  // as many as the geometry's
  size_t target_count;
  const mrw_mesh_lod* lods;  // levels 1, 2, …, ever coarser; level 0 is the mesh in full
  size_t lod_count;
  mrw_geometry geometry;  // of the level asked for
};

// How many matrices mrw_build_palette() writes.
uint32_t mrw_mesh_palette_size(const mrw_mesh* mesh);

// Whether it contains nothing, or is not known.
bool mrw_bounds_is_empty(const mrw_bounds* bounds);

// ---- Part blend_space -----------------------------------------------------------------------------------------------
// Blend spaces: a number or two of a game → weights of clips that stand at points, and the speed that it asks for.

// Three points of it, counter-clockwise.
typedef struct mrw_plane_triangle mrw_plane_triangle;
struct mrw_plane_triangle {
  uint32_t corners[3];  // which points
};
void mrw_plane_triangle_init(mrw_plane_triangle* out);

// ---- Part graph -----------------------------------------------------------------------------------------------------
// A behaviour as data: what a game sets, and how poses of clips come of it. A view of what `marrow cook --graph` wrote;
// part animator plays it, and docs/stages/animator.md says what it does.

// No node, parameter or mask.
#define MRW_NO_INDEX 4294967295u
#define MRW_MAX_GRAPH_NODES 512u  // of a graph
#define MRW_MAX_GRAPH_HEIGHT 16u  // nodes that stand below each other
#define MRW_MAX_FADING 4u  // states of a machine that are shown at once
#define MRW_MAX_GRAPH_POSES 64u  // that are held at once

// What a parameter is.
typedef uint32_t mrw_parameter_kind;
enum {
  MRW_PARAMETER_KIND_NUMBER = 0,
  MRW_PARAMETER_KIND_FLAG = 1,
  MRW_PARAMETER_KIND_TRIGGER = 2,  // set until a transition takes it, or its time is over
};

// What a game sets.
typedef struct mrw_graph_parameter mrw_graph_parameter;
struct mrw_graph_parameter {
  uint32_t name;  // here and below see mrw_file_text, of the graph's file
  mrw_parameter_kind kind;  // what it is
  float initial;  // of a flag 0 or 1
  float least;  // of a number
  float most;  // likewise
  // Of a number its half-life: it goes half of the way to what it is set to in this time. Of a trigger how long it
  // waits. ≥ 0
  float seconds;
};

// What makes a node's pose.
typedef uint32_t mrw_graph_node_kind;
enum {
  MRW_GRAPH_NODE_KIND_CLIP = 0,
  MRW_GRAPH_NODE_KIND_SPACE = 1,
  MRW_GRAPH_NODE_KIND_MACHINE = 2,
  MRW_GRAPH_NODE_KIND_LAYER = 3,
  MRW_GRAPH_NODE_KIND_GIVEN = 4,  // the game
};

// A node stands before those whose poses it takes; the first one's pose is the graph's.
typedef struct mrw_graph_node mrw_graph_node;
struct mrw_graph_node {
  uint32_t name;  // empty: a clip that is named where it is used
  mrw_graph_node_kind kind;  // what makes its pose
  uint32_t record;  // of mrw_graph's array of that kind, which stand in the nodes' order; of given: which pose
  uint16_t height;  // above those whose poses it takes
  uint16_t poses;  // that are held at once to make this one
};

// Plays a clip.
typedef struct mrw_graph_clip mrw_graph_clip;
struct mrw_graph_clip {
  uint32_t name;  // the clip's
  float speed;  // seconds of the clip a second, within ±64
  uint32_t mode;  // an mrw_play_mode
};

// A pose of a space.
typedef struct mrw_graph_point mrw_graph_point;
struct mrw_graph_point {
  uint32_t node;  // whose pose stands there
  float x;  // where on the line, or in the plane
  float y;  // in a plane
  uint32_t own_speed;  // 1: x is the speed of its clip
};

// Blends poses that stand on a line, or in a plane.
typedef struct mrw_graph_space mrw_graph_space;
struct mrw_graph_space {
  uint32_t first_point;  // of mrw_graph.points
  uint32_t point_count;  // from that on
  uint32_t by[2];  // numbers; on a line one
  uint32_t first_triangle;  // of mrw_graph.triangles
  uint32_t triangle_count;  // from that on; 0 on a line
  uint32_t flags;  // SpaceFlags
};

// A state of a machine.
typedef struct mrw_graph_state mrw_graph_state;
struct mrw_graph_state {
  uint32_t name;  // its own
  uint32_t node;  // MRW_NO_INDEX: nothing, so a layer above shows less of itself
};

// From a state of a machine to another.
typedef struct mrw_graph_transition mrw_graph_transition;
struct mrw_graph_transition {
  uint32_t from;  // MRW_NO_INDEX: any but the target
  uint32_t to;  // a state
  uint32_t to_count;  // so many states from that on, of which one is chosen
  uint32_t first_condition;  // of mrw_graph.conditions
  uint32_t condition_count;  // from that on; all must hold
  float fade_s;  // how long it takes
  float after_s;  // that the state has lasted, at least
  float at_end_s;  // with kWaitsForEnd: before the end
  float enter_s;  // where the target begins
  uint32_t flags;  // TransitionFlags
};

// What a condition asks of a parameter.
typedef uint32_t mrw_condition_test;
enum {
  MRW_CONDITION_TEST_SET = 0,
  MRW_CONDITION_TEST_NOT_SET = 1,
  MRW_CONDITION_TEST_ABOVE = 2,
  MRW_CONDITION_TEST_BELOW = 3,
  MRW_CONDITION_TEST_AT_LEAST = 4,
  MRW_CONDITION_TEST_AT_MOST = 5,
};

// One of those that all hold.
typedef struct mrw_graph_condition mrw_graph_condition;
struct mrw_graph_condition {
  uint32_t parameter;  // of mrw_graph.parameters
  mrw_condition_test test;  // what is asked of it
  float value;  // of numbers
};

// Is in one of several states.
typedef struct mrw_graph_machine mrw_graph_machine;
struct mrw_graph_machine {
  uint32_t first_state;  // of mrw_graph.states
  uint32_t state_count;  // from that on
  uint32_t first_transition;  // of mrw_graph.transitions
  uint32_t transition_count;  // from that on, in the order in which they are asked
  uint32_t start;  // as mrw_graph_transition.to
  uint32_t start_count;  // as mrw_graph_transition.to_count
  uint32_t flags;  // kChooseInTurn: of the start
};

// Lays a pose over another.
typedef struct mrw_graph_layer mrw_graph_layer;
struct mrw_graph_layer {
  uint32_t base;  // a node
  uint32_t pose;  // that is laid over it
  uint32_t mask;  // of mrw_graph.masks; MRW_NO_INDEX: all joints
  uint32_t by;  // a number or a flag; MRW_NO_INDEX: `weight`
  float weight;  // 0 … 1
  float fade_s;  // of a flag: how long it takes from 0 to 1
  uint32_t flags;  // LayerFlags
};

// A joint and all below it, as in mrw_mask_below().
typedef struct mrw_graph_mask_part mrw_graph_mask_part;
struct mrw_graph_mask_part {
  uint32_t role;  // an mrw_role; 0: `joint`
  uint32_t joint;  // its name
  uint32_t falloff;  // over so many joints it grows
};

// Several joints, and all below each.
typedef struct mrw_graph_mask mrw_graph_mask;
struct mrw_graph_mask {
  uint32_t first_part;  // of mrw_graph.mask_parts
  uint32_t part_count;  // from that on
};

// A graph. Plain lists, from mrw_file_graph() or made by hand.
typedef struct mrw_graph mrw_graph;
struct mrw_graph {
  const char* name;  // as its text's file is called
  const mrw_graph_parameter* parameters;  // what a game sets
  size_t parameter_count;
  const mrw_graph_node* nodes;  // the first one's pose is the graph's
  size_t node_count;
  const mrw_graph_clip* clips;  // one a node of that kind, as spaces, machines and layers
  size_t clip_count;
  const mrw_graph_space* spaces;  // likewise
  size_t space_count;
  const mrw_graph_point* points;  // space after space
  size_t point_count;
  const mrw_plane_triangle* triangles;  // likewise; their corners are points of their space
  size_t triangle_count;
  const mrw_graph_machine* machines;  // one a node of that kind
  size_t machine_count;
  const mrw_graph_state* states;  // machine after machine
  size_t state_count;
  const mrw_graph_transition* transitions;  // likewise
  size_t transition_count;
  const mrw_graph_condition* conditions;  // transition after transition
  size_t condition_count;
  const mrw_graph_layer* layers;  // one a node of that kind
  size_t layer_count;
  const mrw_graph_mask* masks;  // of layers
  size_t mask_count;
  const mrw_graph_mask_part* mask_parts;  // mask after mask
  size_t mask_part_count;
  uint32_t given_count;  // nodes that are given
};

// ---- Part file ------------------------------------------------------------------------------------------------------
// Load: one validated block of memory, seen as skeletons, clips and meshes.

// What an mrw_property is.
typedef uint8_t mrw_property_type;
enum {
  MRW_PROPERTY_TYPE_NUMBER = 0,
  MRW_PROPERTY_TYPE_BOOLEAN = 1,
  MRW_PROPERTY_TYPE_TEXT = 2,
};

// A number, boolean or text that an artist attached to a node.
typedef struct mrw_property mrw_property;
struct mrw_property {
  uint32_t name;  // see mrw_file_text; a nested property has its path, as in "door/hinges/0"
  mrw_property_type type;  // which of the two members below holds it
  uint8_t reserved[3];
  // finite; a boolean is 1 or 0
  // see mrw_file_text
  double number;
};

// A node of the source that is kept although it may be no joint: a socket, a locator. Its place in model space is
// model_from_joint[joint] · joint_from_node, or joint_from_node alone without a joint.
typedef struct mrw_node mrw_node;
struct mrw_node {
  const char* name;  // as the source calls it; never empty
  uint32_t skeleton;  // which skeleton of the file
  uint16_t joint;  // the nearest joint at or above it
  const mrw_affine* joint_from_node;  // never changes
  const mrw_property* properties;  // the `extras` of the source
  size_t property_count;
};

// A cooked file in memory. Cheap to copy; holds pointers into the block, which must outlive it and stay unchanged.
typedef struct mrw_file mrw_file;
struct mrw_file {
  const void* block;
  const void* sections;
  size_t section_count;
  uint32_t numbers[34];
};
void mrw_file_init(mrw_file* out);

// Validates a cooked file (docs/format.md) and makes `out` a view of it.
//
// The block must be 16-byte aligned (MRW_BAD_ARGUMENT otherwise; part block helps) and may come from anywhere. Nothing
// is read outside it, whatever it holds. After `ok`, nothing that it holds can make another stage read or write out of
// bounds. Numbers of matrices, translations and scales are at most 1e12, and rotations are unit quaternions. So the
// product of a root's model_from_root, one joint and an inverse bind is finite; along a long chain of huge scales it
// need not be. Names are at most 2047 bytes. `out` is written only on success. `error`, if not null, gets the place and
// the broken rule on failure. Cost: one pass over the block; no allocation. Thread-safe.
// May be null: error.
mrw_status mrw_load(const void* block, size_t block_bytes, mrw_file* out, mrw_data_error* error) MRW_NODISCARD;

// How many of each there are.
uint32_t mrw_file_skeleton_count(const mrw_file* file);
uint32_t mrw_file_reference_count(const mrw_file* file);
uint32_t mrw_file_clip_count(const mrw_file* file);
uint32_t mrw_file_mesh_count(const mrw_file* file);
uint32_t mrw_file_material_count(const mrw_file* file);
uint32_t mrw_file_image_count(const mrw_file* file);
uint32_t mrw_file_node_count(const mrw_file* file);

// An index at or above the count returns an empty object. Cost: a few loads.
mrw_status mrw_file_skeleton(const mrw_file* file, uint32_t index, mrw_skeleton* out) MRW_NODISCARD;
mrw_status mrw_file_reference(const mrw_file* file, uint32_t index, mrw_skeleton_reference* out) MRW_NODISCARD;
mrw_status mrw_file_clip(const mrw_file* file, uint32_t index, mrw_clip* out) MRW_NODISCARD;

// level: of detail; 0 is the full mesh, and a level beyond the mesh's last returns the last. All levels share one
// palette.
mrw_status mrw_file_mesh(const mrw_file* file, uint32_t index, uint32_t level, mrw_mesh* out) MRW_NODISCARD;

// An index at or above the count returns an empty object. Cost: a few loads.
mrw_status mrw_file_material(const mrw_file* file, uint32_t index, mrw_material* out) MRW_NODISCARD;
mrw_status mrw_file_image(const mrw_file* file, uint32_t index, mrw_image* out) MRW_NODISCARD;
mrw_status mrw_file_node(const mrw_file* file, uint32_t index, mrw_node* out) MRW_NODISCARD;

// Contains the mesh's vertices while the clip plays from the rest pose: at every level of detail, by every deformer
// that the mesh was cooked for. Empty if the clip does not move the mesh's skeleton, and in files without bounds.
// Stored as codes of 8 bits, rounded outwards: a face may be 1/64 of the box's farthest coordinate beyond the vertices.
// For clips of a clip pack there are none; see mrw_palette_bounds() in part bounds. Cost: a look at every clip and
// mesh; once a load.
mrw_status mrw_file_bounds(const mrw_file* file, uint32_t clip, uint32_t mesh, mrw_bounds* out) MRW_NODISCARD;

// The asset's spring bones for one of the skeletons: chains for mrw_make_springs(), and colliders for mrw_spring_frame.
// A game may copy them and change their settings. Cost: a look at every section of springs.
uint32_t mrw_file_spring_count(const mrw_file* file, uint32_t skeleton);
mrw_status mrw_file_spring(const mrw_file* file, uint32_t skeleton, uint32_t index,
    mrw_spring_chain* out) MRW_NODISCARD;
mrw_status mrw_file_spring_colliders(const mrw_file* file, uint32_t skeleton,
    mrw_spring_collider_list* out) MRW_NODISCARD;

// Which joints of one of the skeletons are its feet, its head and so on; see part roles. Points into the block. Empty
// if nothing is known. Cost: a look at every section of roles.
mrw_status mrw_file_roles(const mrw_file* file, uint32_t skeleton, mrw_roles* out) MRW_NODISCARD;

// What a clip does, as far as the cooker has measured it or was told; see part clip_motion. Points into the block. A
// clip of which nothing is known has its duration and nothing else. Cost: a look at the sections of motion; once a
// load.
mrw_status mrw_file_motion(const mrw_file* file, uint32_t clip, mrw_clip_motion* out) MRW_NODISCARD;

// How one of the skeletons takes poses of another rig, see part pose_map. Points into the block. An index at or above
// the count returns an empty one. Cost: a few loads.
uint32_t mrw_file_pose_map_count(const mrw_file* file);
mrw_status mrw_file_pose_map(const mrw_file* file, uint32_t index, mrw_pose_map* out) MRW_NODISCARD;

// Spaces of example shapes, see part example_space. mrw_load() only locates them; mrw_file_example_space() checks all
// that one holds. lists point into the block. Errors: MRW_BAD_ARGUMENT if there is none with the index; MRW_BAD_DATA or
// MRW_UNSUPPORTED, with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass;
// once a load.
uint32_t mrw_file_example_space_count(const mrw_file* file);

// Spaces of example shapes, see part example_space. mrw_load() only locates them; mrw_file_example_space() checks all
// that one holds. lists point into the block. Errors: MRW_BAD_ARGUMENT if there is none with the index; MRW_BAD_DATA or
// MRW_UNSUPPORTED, with `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass;
// once a load.
// May be null: error.
mrw_status mrw_file_example_space(const mrw_file* file, uint32_t index, mrw_example_space* out,
    mrw_data_error* error) MRW_NODISCARD;

// Graphs of behaviour, see part graph. mrw_load() only locates them; mrw_file_graph() checks all that one holds. lists
// point into the block. Errors and cost: as mrw_file_example_space().
uint32_t mrw_file_graph_count(const mrw_file* file);

// Graphs of behaviour, see part graph. mrw_load() only locates them; mrw_file_graph() checks all that one holds. lists
// point into the block. Errors and cost: as mrw_file_example_space().
// May be null: error.
mrw_status mrw_file_graph(const mrw_file* file, uint32_t index, mrw_graph* out, mrw_data_error* error) MRW_NODISCARD;

// Index of the first skeleton with this name, or mrw_file_skeleton_count(). Here and below a null pointer names
// nothing.
uint32_t mrw_file_find_skeleton(const mrw_file* file, const char* name);

// The first joint of `skeleton`, a skeleton of this file, with this name, or skeleton.joint_count. Once a load, not a
// frame.
uint32_t mrw_file_find_joint(const mrw_file* file, const mrw_skeleton* skeleton, const char* name);

// Index of the first mesh with this name, or mrw_file_mesh_count(). A source mesh with several materials is one
// mrw_mesh for each, all of the same name.
uint32_t mrw_file_find_mesh(const mrw_file* file, const char* name);

// Index of the first clip with this name, or mrw_file_clip_count(). With `skeleton` only clips that move that skeleton
// are searched. An animation of several skeletons is one clip for each, all with the same name and duration.
uint32_t mrw_file_find_clip(const mrw_file* file, const char* name);
uint32_t mrw_file_find_clip_of(const mrw_file* file, const char* name, uint32_t skeleton);

// Index of the first channel of `clip`, a clip of this file, with this name, or clip.channel_count. Once a load, not
// a frame.
uint32_t mrw_file_find_channel(const mrw_file* file, const mrw_clip* clip, const char* name);

// Index of the first event of `motion`, a motion of this file, with this name, or motion.event_count. Once a load,
// not a frame: several events may have one name, so a frame compares mrw_clip_event.name.
uint32_t mrw_file_find_event(const mrw_file* file, const mrw_clip_motion* motion, const char* name);

// Index of the first pose map of a rig with this name, or mrw_file_pose_map_count().
uint32_t mrw_file_find_pose_map(const mrw_file* file, const char* name);

// Index of the first node with this name, or mrw_file_node_count().
uint32_t mrw_file_find_node(const mrw_file* file, const char* name);

// The property of `node`, a node of this file, with this name; null if there is none.
const mrw_property* mrw_file_node_property(const mrw_file* file, const mrw_node* node, const char* name);

// The name with this number (mrw_skeleton.names, mrw_channel.name, mrw_property.name); empty if there is none. UTF-8,
// zero-terminated, never null.
const char* mrw_file_text(const mrw_file* file, uint32_t name);
uint32_t mrw_property_text(const mrw_property* property);

// ---- Part clip_pack -------------------------------------------------------------------------------------------------
// Clips apart from their character: does a clip pack fit a skeleton, and if not, which joints are in the way.

// Why a joint keeps a clip pack from fitting a skeleton.
typedef uint8_t mrw_misfit;
enum {
  MRW_MISFIT_MISSING = 0,  // the skeleton has no joint of this name
  MRW_MISFIT_OTHER_PARENT = 1,  // it has one, below another joint
  MRW_MISFIT_OTHER_REST = 2,  // it has one with another rest pose, which coded tracks are relative to
  MRW_MISFIT_EXTRA = 3,  // the skeleton has a joint that the clips were made without
  MRW_MISFIT_OTHER_PLACE = 4,  // all joints are there, but this one has another number
};

// A joint that is in the way.
typedef struct mrw_joint_misfit mrw_joint_misfit;
struct mrw_joint_misfit {
  mrw_misfit how;  // what is wrong with it
  uint32_t joint;  // index in the pack's reference; for `extra` in the skeleton
};

// A 64-bit hash of a skeleton's joints in their order: names, parents, rest poses bit for bit (docs/format.md, SREF).
// An index without a skeleton gives the hash of no joints. Cost: one pass over the skeleton.
uint64_t mrw_skeleton_hash(const mrw_file* file, uint32_t skeleton);

// Whether a pack's clips for one of its references can move a skeleton of another file. After `ok`, mrw_sample() treats
// every clip of the pack whose mrw_clip.skeleton is `reference` like the skeleton's own clips. Once a load, not a
// frame. (Sampling a clip that does not fit is safe: joints out of range are refused; otherwise the pose is nonsense.)
//
// misfits: gets as many of the first misfits as it holds. misfit_count, if not null, gets their total number. Both may
// be left out. The transforms above the roots may differ: they do not concern clips. Errors: MRW_MISMATCH if the
// skeletons are not the same; MRW_BAD_ARGUMENT if an index is out of range. Cost: one pass over the skeleton if it
// fits; else a search by name a joint. No allocation. Thread-safe.
// May be null: misfits_there.
mrw_status mrw_bind_clips(const mrw_file* pack, uint32_t reference, const mrw_file* character, uint32_t skeleton,
    mrw_joint_misfit* misfits, size_t misfit_count, size_t* misfits_there) MRW_NODISCARD;

// ---- Part outfit ----------------------------------------------------------------------------------------------------
// Hair, clothes and things held in a hand, in files of their own: their joints follow the body's.
//
// `marrow cook hair.glb --skeleton body.mrw` gives an outfit the body's whole skeleton plus the joints that only the
// outfit has. Under each parent the outfit's own joints come after the body's. So an outfit may be posed, and may have
// springs, clips and masks as anything else. An outfit without joints of its own has the body's joints, number by
// number.
//
// mrw_make_outfit() and mrw_character_follow_body() of part character do what is here for whole characters.

// Whether an outfit fits a body, and which joint of the body each of its joints is.
//
// body_joints: at least the outfit's joint_count. For each joint of the outfit it gets the body joint's number,
// ascending, or MRW_NO_JOINT for a joint that only the outfit has. The outfit fits if it has all joints of the body, in
// their order and each below the same parent, and if every joint of its own has a parent. Rest poses may differ, as may
// the transforms above the roots: the same clothes fit a taller body. If all joints are the body's, body_joints[j] is
// j.
//
// misfits: as in mrw_bind_clips(). `joint` is one of the outfit; for `extra` it is one of the body that the outfit
// lacks; for `missing` it is a root that the body lacks. Errors: MRW_MISMATCH if it does not fit, and body_joints then
// holds nothing of use; MRW_BAD_ARGUMENT if an index is out of range or a list too short. Cost: a comparison of names a
// joint if it fits; else a search by name. No allocation. Thread-safe.
// May be null: misfits_there.
mrw_status mrw_bind_outfit(const mrw_file* outfit, uint32_t skeleton, const mrw_file* body, uint32_t body_skeleton,
    uint16_t* body_joints, size_t body_joint_count, mrw_joint_misfit* misfits, size_t misfit_count,
    size_t* misfits_there) MRW_NODISCARD;

// The outfit's model-space joints in the body's pose. The body's joints are copied; the outfit's own joints are placed
// by `local` below their parents. The result has the same bits as if mrw_local_to_model() had posed all of them.
//
// skeleton: the outfit's. body_joints: from mrw_bind_outfit(). local: at least mrw_skeleton_soa_size(skeleton);
// elements of the body's joints are not read. model_from_joint: at least skeleton.joint_count; does not overlap the
// body's.
// Errors: MRW_BAD_ARGUMENT if a list is too short, a joint out of range, or a root is not one of the body's.
// Cost: 48 bytes are copied a joint of the body; the others cost what mrw_local_to_model() does. Where body_joints[j]
// is always j, mrw_build_palette() and mrw_gles3_pose() may as well take the body's joints themselves, without a copy.
// Thread-safe on different outputs.
mrw_status mrw_follow_body(const mrw_skeleton* skeleton, const uint16_t* body_joints, size_t body_joint_count,
    const mrw_affine* body_model_from_joint, size_t body_model_from_joint_count, const mrw_soa_transform* local,
    size_t local_count, mrw_affine* model_from_joint, size_t model_from_joint_count) MRW_NODISCARD;

// ---- Part playback --------------------------------------------------------------------------------------------------
// Playback: where in its clip a character is, moved on from frame to frame.

// What happens at the ends of a clip.
typedef uint8_t mrw_play_mode;
enum {
  MRW_PLAY_MODE_ONCE = 0,  // time stops at the end
  MRW_PLAY_MODE_LOOP = 1,  // time goes on from the other end; the last pose and the first are one moment
  MRW_PLAY_MODE_PING_PONG = 2,  // time turns round
};

// The state of a playing clip: plain numbers that may be set, copied and stored at will. To play a clip backwards once,
// start with time_s = its duration and a speed below 0.
typedef struct mrw_playback mrw_playback;
struct mrw_playback {
  double time_s;  // in the clip
  float speed;  // seconds of the clip a second; 0 pauses, below 0 runs backwards
  mrw_play_mode mode;  // what happens at the ends
  bool returning;  // ping_pong: on the way back, so time runs against speed
  // Turns in the last mrw_advance(). loop: how often time went from the clip's end to its start, minus how often from
  // start to end. ping_pong: how often time turned. once: 0. Stops at ±2147483647.
  int32_t turns;
};
void mrw_playback_init(mrw_playback* out);

// Moves `playback` on by dt_s seconds times its speed, in a clip of `duration_s`. Time beyond an end is carried over,
// however many times it passes: neither a loop nor a turn loses time or shows any twice. Afterwards time_s is in 0 …
// duration_s, and in a loop below duration_s. A time exactly at an end passes it, or turns there, only when time moves
// on. To find the events that are due, compare time_s before and after, and read `turns`. A time_s outside the clip is
// treated as if time had just run there. In a clip of duration 0, time_s becomes 0, without a turn.
//
// Errors: MRW_BAD_ARGUMENT if time_s, speed, dt_s or duration_s is not finite, or duration_s is below 0; nothing is
// changed.
//
// Rounding: dt_s · speed is exact. Adding it to the time rounds once, by at most 2⁻⁵³ (time_s + |dt_s · speed|), with
// time_s as it was before, and by 2⁻⁵³ duration_s more where a loop passes its start backwards. Wrapping a time beyond
// an end is exact. So after 10⁷ steps of a clip of 10 s time is off by less than 2·10⁻⁸ s. Cost: a few operations; the
// logarithm of the turns where there are many. The same bits everywhere; thread-safe on different playbacks.
mrw_status mrw_advance(mrw_playback* playback, float duration_s, float dt_s) MRW_NODISCARD;

// The time to sample: time_s as a float, which never goes beyond the clip.
float mrw_clip_time(const mrw_playback* playback);

// Whether a clip that plays once has reached the end that it runs towards; it stays true while time runs on. At speed 0
// it runs towards no end.
bool mrw_finished(const mrw_playback* playback, float duration_s);

// ---- Part events ----------------------------------------------------------------------------------------------------
// Events: which of a clip's events a step of its playback met, and whether one goes on now.
//
//   const mrw_playback before = playback;
//   mrw_advance(playback, motion.duration_s, dt_s);
//   mrw_events_between(motion, before, playback, first, hits, met);

// An event that a step met.
typedef struct mrw_event_hit mrw_event_hit;
struct mrw_event_hit {
  uint32_t event;  // of mrw_clip_motion.events
  uint32_t count;  // how often: more than once where the step is longer than the clip
};
void mrw_event_hit_init(mrw_event_hit* out);

// The events whose time_s the step from `before` to `after` met, in the order in which it met each first. `after` is
// `before` after one mrw_advance(), at any speed and in any mode.
//
// A step does not meet the moment that it starts from, and meets the one where it ends: forwards (before, after],
// backwards [after, before). So however time is cut into steps, each event is met exactly once each time that time goes
// over it. `first`: this is the playback's first step, which meets the moment that it starts from, too. In a loop the
// clip's end and its start are one moment: events at either are met together. A playback that turns round at an end
// meets the events there once. An event that lasts a whole round of a loop, as a foot that stands, does not begin
// again: only a first step meets it, once. After a jump of time_s by hand a step is a first one again.
//
// out: gets as many as it holds. met: how many events were met; more than out_count if some had no room. A motion has
// no more than motion.event_count of them, however long the step is. Counts stop where mrw_playback.turns does.
//
// Errors: MRW_BAD_ARGUMENT if a list is null, the duration, or a time of the playbacks, is not finite or the duration
// below 0, after.time_s is outside the clip, or the playbacks are not of one mode; nothing is written. ping_pong takes
// the direction from after.speed, so dt_s must not have been below 0. Cost: a few comparisons an event, whatever the
// step. Thread-safe; no allocation.
mrw_status mrw_events_between(const mrw_clip_motion* motion, const mrw_playback* before, const mrw_playback* after,
    bool first, mrw_event_hit* out, size_t out_count, size_t* met) MRW_NODISCARD;

// Whether time_s lies in an event's list, both of its ends included; of a clip of duration_s that loops, if the list
// goes beyond its end.
bool mrw_is_within(const mrw_clip_event* event, float time_s, float duration_s);

// ---- Part root_motion -----------------------------------------------------------------------------------------------
// Root motion: how far a step of a clip moves the character, blends of such steps, and the character moved by them.
//
//   mrw_root_step(walk, before, playback, step);
//   world_from_model = mrw_move_root(world_from_model, step);

// A rigid motion: a rotation, then a translation.
typedef struct mrw_rigid_step mrw_rigid_step;
struct mrw_rigid_step {
  float rotation[4];  // unit quaternion x, y, z, w
  float translation[3];  // metres
};
void mrw_rigid_step_init(mrw_rigid_step* out);

// M(t), see mrw_root_key: where the root is at time_s, in the model space of the clip's start. The identity for a
// motion without keys.
// Errors: MRW_BAD_ARGUMENT if the keys' list is null, time_s is no number, or what the keys give is not finite; nothing
// is written. Cost: a binary search and some dozen operations.
mrw_status mrw_sample_root(const mrw_clip_motion* motion, float time_s, mrw_rigid_step* out) MRW_NODISCARD;

// How the root moved from `before` to `after`, which is `before` after one mrw_advance(): in the model space that the
// character had before the step. Any speed, mode and number of turns.
//
//   step = M(t0)⁻¹ · Lⁿ · M(t1) with L = M(duration)
// and n rounds of a loop; a playback that turns round, or plays once, has n = 0. So however time is cut into steps,
// their product is the same within rounding. In double precision; n rounds are off by less than 1e-6 m and 2⁻²⁴ of the
// way, n ≤ 10⁶. rotation: w ≥ 0.
// Errors: MRW_BAD_ARGUMENT as mrw_events_between(), and if the result is not finite; nothing is written. Cost: two
// mrw_sample_root(); in a loop the logarithm of n products.
mrw_status mrw_root_step(const mrw_clip_motion* motion, const mrw_playback* before, const mrw_playback* after,
    mrw_rigid_step* out) MRW_NODISCARD;

// The step of a blend of clips: exp(Σ w log(step) / Σ w), with the logarithm of a rigid motion being its screw. A mean
// of a straight walk and a turn is then the same way at any frame rate, which it would not be of lengths and angles.
//
// steps, weights: one weight for each step, ≥ 0. If all are 0 the result is the identity. Steps are no longer than
// half a turn, and taken the shorter way round. Rotations need not be quite of unit length.
// Errors: MRW_BAD_ARGUMENT if a list is too short or null, a weight is below 0 or above 1e6, or the result is not
// finite; nothing is written. Cost: some 200 operations in double precision a step of weight above 0.
mrw_status mrw_blend_root_steps(const mrw_rigid_step* steps, size_t step_count, const float* weights,
    size_t weight_count, mrw_rigid_step* out) MRW_NODISCARD;

// world_from_model after the step: world_from_model · step. Computed in double and rounded once, so a place some
// hundred metres from the origin drifts by centimetres a minute: mrw_root_place does not.
mrw_status mrw_move_root(const mrw_affine* world_from_model, const mrw_rigid_step* step, mrw_affine* out) MRW_NODISCARD;

// Where a character stands in the world, in double precision: steps are added up for hours, and far from the origin.
typedef struct mrw_root_place mrw_root_place;
struct mrw_root_place {
  double rotation[4];  // unit quaternion x, y, z, w
  double translation[3];  // metres
};
void mrw_root_place_init(mrw_root_place* out);

// The place after the step. rotation: of unit length again.
mrw_status mrw_move_place(const mrw_root_place* place, const mrw_rigid_step* step, mrw_root_place* out) MRW_NODISCARD;

// The place as a matrix, in floats. A game with a camera in double takes its place off before.
mrw_status mrw_world_from_model(const mrw_root_place* place, mrw_affine* out) MRW_NODISCARD;

// ---- Part phase -----------------------------------------------------------------------------------------------------
// Phase: clips of different lengths go through their steps together, so that blended feet come down at one time.
//
// Phase marks cut a clip into segments: two for a walk, one a step. A place is a segment and a share of it, and means
// the same in each clip of a group. A group has one mrw_phase, which mrw_advance_phase() moves on; a clip's time
// follows from it alone, so no clip can drift.

// Where a group of clips is: plain numbers that may be set, copied and stored at will.
typedef struct mrw_phase mrw_phase;
struct mrw_phase {
  double share;  // of the segment: 0 … below 1
  uint32_t segment;  // of the group; a clip of n marks takes it modulo n
  int32_t passed;  // Segments that the last mrw_advance_phase() passed, below 0 backwards. Stops at ±2147483647.
};
void mrw_phase_init(mrw_phase* out);

// A clip of a group.
typedef struct mrw_phase_clip mrw_phase_clip;
struct mrw_phase_clip {
  const mrw_clip_motion* motion;  // its duration and phase marks; without marks it is one segment from 0 on
  float weight;  // 0 … 1e6
};
void mrw_phase_clip_init(mrw_phase_clip* out);

// The place of a clip at time_s, with `passed` 0: where a group begins that takes over from this clip. time_s outside
// the clip counts as its nearest end.
// Errors: MRW_BAD_ARGUMENT if time_s is no number, or the duration and the marks are not as part clip_motion has them;
// nothing is written. Cost: over the marks.
mrw_status mrw_phase_at(const mrw_clip_motion* motion, float time_s, mrw_phase* out) MRW_NODISCARD;

// Moves `phase` on by dt_s seconds; below 0 backwards.
//
// A segment takes the mean of what it takes in each clip, by weight: d = Σ w d_c / Σ w. A group of clips of different
// numbers of marks has the least common multiple of them as its number of segments, at most MRW_MAX_MARKS: a clip of
// two marks goes twice through itself while one of four goes once. If the durations are 0 nothing moves.
//
// Errors: MRW_BAD_ARGUMENT if there is no clip, a motion is null or as mrw_phase_at() refuses it, the common multiple
// is more than MRW_MAX_MARKS, a weight is out of range or all are 0, `phase` is not a place, or dt_s is not finite;
// nothing is written. Cost: over the group's segments and clips. Thread-safe on different phases.
mrw_status mrw_advance_phase(const mrw_phase_clip* clips, size_t clip_count, float dt_s,
    mrw_phase* phase) MRW_NODISCARD;

// The playback of one clip of the group, now and before the last step: `before` and `after` are the group's phase
// before and after one mrw_advance_phase(). was, now: of mode loop, as mrw_advance() would leave them, now.turns
// included, for mrw_events_between(), mrw_root_step() and mrw_clip_time(). Errors: MRW_BAD_ARGUMENT if the motion is as
// mrw_phase_at() refuses it, or a phase is not a place; nothing is written.
mrw_status mrw_follow_phase(const mrw_clip_motion* motion, const mrw_phase* before, const mrw_phase* after,
    mrw_playback* was, mrw_playback* now) MRW_NODISCARD;

// ---- Part blend_space -----------------------------------------------------------------------------------------------
// Blend spaces: a number or two of a game → weights of clips that stand at points, and the speed that it asks for.

// A point of a plane.
typedef struct mrw_plane_point mrw_plane_point;
struct mrw_plane_point {
  float x;  // at most 1e12
  float y;  // at most 1e12
};
void mrw_plane_point_init(mrw_plane_point* out);

// A clip that moves over the ground, in a group of clips that go by one phase (part phase).
typedef struct mrw_speed_point mrw_speed_point;
struct mrw_speed_point {
  float speed_m_s;  // ≥ 0; mrw_clip_motion.speed_m_s
  float duration_s;  // > 0; of as many segments as the others' durations are
};
void mrw_speed_point_init(mrw_speed_point* out);

// Weights of points on a line: the two beside `at` share them, and beyond an end that point has all.
//
// points: strictly ascending. weights: at least point_count; the first point_count are written. Their sum is 1 within
// 1e-6; a point has exactly 1 where it stands; they are continuous in `at`.
// Errors: MRW_BAD_ARGUMENT if there is no point, they do not ascend or are not finite, `at` is no number, or a list is
// too short; nothing is written. Cost: over the points.
mrw_status mrw_line_weights(const float* points, size_t point_count, float at, float* weights,
    size_t weight_count) MRW_NODISCARD;

// Weights of points in a plane, over triangles that cover what they list, as Delaunay's do: inside a triangle its
// corners share the weight by areas. Outside of all the nearest point of the triangles counts.
//
// weights: at least point_count; the first point_count are written. Their sum is 1 within 1e-6; a point that is a
// corner has exactly 1 where it stands. Weights are continuous where triangles meet in whole edges and what they cover
// is convex. Errors: MRW_BAD_ARGUMENT if there is no triangle, one has a corner that is no point, or is not
// counter-clockwise, `at` or a point is not finite or beyond 1e12, or a list is too short; nothing is written. Cost:
// over the triangles; outside of all of them some 20 operations an edge.
mrw_status mrw_plane_weights(const mrw_plane_point* points, size_t point_count, const mrw_plane_triangle* triangles,
    size_t triangle_count, const mrw_plane_point* at, float* weights, size_t weight_count) MRW_NODISCARD;

// Weights of clips in step, such that their blend goes at exactly speed_m_s.
//
// Linear weights miss it, as the slower clip's steps take longer. With strides s = speed · duration, the share of the
// faster neighbour is w = (v t0 - s0) / ((s1 - s0) - v (t1 - t0)). rate: what to multiply dt_s by. It is 1 between the
// slowest and the fastest clip. Below the slowest, and above the fastest, that clip has all the weight, and plays
// slower, or faster; a slowest clip of speed 0 keeps rate 1.
//
// points: by speed, strictly ascending. speed_m_s: below 0 counts as 0. weights: at least point_count; the first
// point_count are written. Errors: MRW_BAD_ARGUMENT if there is no point, they are not as said, or a number is not
// finite or beyond 1e12, or the rate is not finite; nothing is written. Cost: over the points.
mrw_status mrw_match_speed(const mrw_speed_point* points, size_t point_count, float speed_m_s, float* weights,
    size_t weight_count, float* rate) MRW_NODISCARD;

// ---- Part sample ----------------------------------------------------------------------------------------------------
// Sample: a clip at a time → local transforms of every joint.

// Which joints are sampled.
typedef struct mrw_sample_options mrw_sample_options;
struct mrw_sample_options {
  // A level of detail, or any set of joints: joint j is bit j % 32 of word j / 32; at least ⌈joint_count / 32⌉ words.
  // Joints whose bit is 0 keep what `out` holds. Empty: all joints. Every group of four without a joint of the set
  // costs a few operations only.
  const uint32_t* joints;
  size_t joint_count;
};
void mrw_sample_options_init(mrw_sample_options* out);

// Evaluates `clip` at `time_s`, clamped to each track's first and last key, as glTF 2.0 defines its interpolations:
// STEP, LINEAR (spherical along the shortest arc for rotations) and CUBICSPLINE (Hermite, rotations normalised). Coded
// (compressed) tracks are blended between their two nearest frames, rotations by spherical interpolation; their error
// stays within the cooker's --clip-error.
//
// out: at least mrw_skeleton_soa_size(skeleton) elements, caller's memory; joints that the clip leaves alone get their
// rest pose. Errors: MRW_BAD_ARGUMENT if `out` or the set of joints is too short, the clip belongs to a skeleton with
// other joints or is additive, or time_s is not a number. Rotations differ from exact spherical interpolation by at
// most 1e-6 rad plus float rounding. Cost: one binary search for each distinct list of key times and a few dozen
// operations for each track, whatever time_s is. Stateless; thread-safe on different outputs.
// May be null: options.
mrw_status mrw_sample(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s, mrw_soa_transform* out,
    size_t out_count, const mrw_sample_options* options) MRW_NODISCARD;

// What an instance that plays a clip keeps between two calls of mrw_sample_cached(). A new cache is empty.
typedef struct mrw_sample_cache mrw_sample_cache;
struct MRW_ALIGN(8) mrw_sample_cache {
  // The caller's, 16-byte aligned. It holds the two unpacked frames of the clip that the time lies between, so that
  // times between them need no unpacking. If it is empty, or smaller than mrw_sample_cache_bytes() of the clip, each
  // call unpacks both frames; only what does not move in the clip is still skipped.
  void* memory;
  size_t memory_bytes;
  uint8_t state[24];  // mrw_sample_cached()'s own
};
void mrw_sample_cache_init(mrw_sample_cache* out);

// Bytes of mrw_sample_cache.memory for this clip: 160 for each group of four joints in which some rotation changes, and
// the same again for translations and for scales.
size_t mrw_sample_cache_bytes(const mrw_clip* clip);

// mrw_sample() of all joints for an instance that plays on: writes the same bits, but skips what the last call with
// this cache has already done. The cache notices a changed clip, skeleton or `out` and starts anew. It knows an
// mrw_file's clip by mrw_clip.id, a clip made by hand by the addresses of its tracks.
//
// out: as in mrw_sample(). Nobody else may write to it while the cache is in use, not even to joints that move: a joint
// whose two frames are alike is written once and then skipped until the frames change. To change the pose afterwards,
// copy it or let mrw_blend() read it. cache: one for each `out`. If others wrote to `out`, replace the cache by a new
// one with the same memory. Errors: as mrw_sample(), and MRW_BAD_ARGUMENT if the cache's memory is not on a boundary of
// 16 bytes; the cache then stays as it is. Cost: at most that of mrw_sample() and a copy of the frames; about half of
// mrw_sample() for keys at 30 Hz that are played at 60 Hz.
mrw_status mrw_sample_cached(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s, mrw_soa_transform* out,
    size_t out_count, mrw_sample_cache* cache) MRW_NODISCARD;

// Evaluates a clip cooked as additive (`marrow cook --additive`). out: the change for mrw_add(), from the clip's
// reference pose to the pose that mrw_sample() would give of an ordinary clip. Added to the reference with weight 1 it
// gives that pose, within the cooker's --clip-error. A joint that the clip leaves alone is sampled in its rest pose: it
// does not change if the reference has it in its rest pose, too.
//
// out: at least mrw_skeleton_soa_size(skeleton) elements, caller's memory. Errors: as mrw_sample(), and
// MRW_BAD_ARGUMENT if the clip is not additive. Cost: mrw_sample() and mrw_make_additive(). Stateless; thread-safe on
// different outputs.
mrw_status mrw_sample_additive(const mrw_skeleton* skeleton, const mrw_clip* clip, float time_s,
    mrw_additive_transform* out, size_t out_count) MRW_NODISCARD;

// Evaluates the clip's channels at `time_s` as above: out[i] is the value of clip.channels[i].
//
// out: at least clip.channel_count floats. mrw_file_find_channel says which channel is which. A number that the clip
// does not drive has no channel and keeps the value that the game gives it. Channels of an additive clip are values,
// too, not changes. Errors: MRW_BAD_ARGUMENT if `out` is too short or time_s is not a number. Cost: one binary search
// for each distinct list of key times and a few operations for each channel.
mrw_status mrw_sample_channels(const mrw_clip* clip, float time_s, float* out, size_t out_count) MRW_NODISCARD;

// ---- Part curve -----------------------------------------------------------------------------------------------------
// Curves through keys, easings and patches: a time, or any other parameter, → numbers. For user channels and
// procedural motion; outside the pipeline of poses and meshes.
//
// Everything is plain functions over the caller's memory; nothing is kept, nothing is allocated, all is thread-safe on
// different outputs. Results are the same bits on every processor.

// How values run between two keys, and what a key holds. N is mrw_curve.components, u goes 0 … 1 from one key to the
// next.
typedef uint8_t mrw_curve_kind;
enum {
  MRW_CURVE_KIND_STEP = 0,  // key: value. The earlier key's value
  MRW_CURVE_KIND_LINEAR = 1,  // key: value. A straight line; for rotations the shorter great arc (slerp)
  // key: in-tangent, value, out-tangent; tangents per second, as glTF 2.0 CUBICSPLINE has it
  MRW_CURVE_KIND_HERMITE = 2,
  MRW_CURVE_KIND_QUADRATIC_BEZIER = 3,  // value, one control point, value, one control point, … value; Bernstein form
  MRW_CURVE_KIND_CUBIC_BEZIER = 4,  // value, two control points, value, two control points, … value; Bernstein form
  // key: value. Uniform; Catmull and Rom 1974: the tangent at P1 is (P2 - P0) / 2 a key interval
  MRW_CURVE_KIND_CATMULL_ROM = 5,
  // key: value. Catmull-Rom with knots √|P2 - P1| apart; Barry and Goldman, SIGGRAPH 1988, and
  // Yuksel, Schaefer and Keyser 2011: no cusps or loops between two keys. Keys less than 1e18 apart
  MRW_CURVE_KIND_CENTRIPETAL = 6,
};

// How a patch's points shape it.
typedef uint8_t mrw_patch_basis;
enum {
  MRW_PATCH_BASIS_CATMULL_ROM = 0,  // through its inner points: u, v = 0 … 1 lead from point (1, 1) to point (2, 2)
  MRW_PATCH_BASIS_BEZIER = 1,  // through its corners: from point (0, 0) to point (3, 3)
};

// R. Penner's easings (Programming Macromedia Flash MX, 2002, chapter 7).
typedef uint8_t mrw_easing;
enum {
  MRW_EASING_LINEAR = 0,
  MRW_EASING_QUAD = 1,
  MRW_EASING_CUBIC = 2,
  MRW_EASING_QUART = 3,
  MRW_EASING_QUINT = 4,
  MRW_EASING_SINE = 5,
  MRW_EASING_EXPO = 6,
  MRW_EASING_CIRC = 7,
  MRW_EASING_BACK = 8,
  MRW_EASING_ELASTIC = 9,
  MRW_EASING_BOUNCE = 10,
};

// At which end a movement is eased.
typedef uint8_t mrw_ease_mode;
enum {
  MRW_EASE_MODE_IN = 0,
  MRW_EASE_MODE_OUT = 1,
  MRW_EASE_MODE_IN_OUT = 2,
};

// Keys, as a view. catmull_rom and centripetal draw a smooth path whatever the times are, but its velocity is
// continuous only where key intervals are even (or go with √distance, centripetal); for motion that is smooth over
// uneven keys make a spline. Beyond the first and last key they continue with a mirrored point, so that the path leaves
// and arrives straight.
typedef struct mrw_curve mrw_curve;
struct mrw_curve {
  mrw_curve_kind kind;  // what lies between keys
  // Values are unit quaternions x, y, z, w; components is 4. Each key and control point is taken with the sign that is
  // nearer to the one before it. The result is normalised and may have either sign, as q and -q are the same rotation.
  // Where a blend has no direction, the result is the earlier key.
  bool rotation;
  uint32_t components;  // floats a value: 1 … 4
  const float* times_s;  // one a key, strictly increasing; seconds, or whatever the curve runs over
  size_t time_count;
  const float* values;  // mrw_curve_value_count() floats
  size_t value_count;
};
void mrw_curve_init(mrw_curve* out);

// Arc length: at which time to evaluate a curve to move along it at an even speed.
//
// The table holds the length of the path up to each of `steps` equal parts of every key interval.
typedef struct mrw_arc_length mrw_arc_length;
struct mrw_arc_length {
  uint32_t steps;  // a key interval, at least 1
  const float* lengths;  // mrw_arc_length_count() of them, ascending
  size_t length_count;
};
void mrw_arc_length_init(mrw_arc_length* out);

// The timing function of CSS Easing Functions Level 1: the cubic Bézier curve (0, 0), (x1, y1), (x2, y2), (1, 1), y
// over x.
typedef struct mrw_cubic_bezier_ease mrw_cubic_bezier_ease;
struct mrw_cubic_bezier_ease {
  float x1;  // CSS "ease"
  float y1;  // CSS "ease"
  float x2;  // CSS "ease"
  float y2;  // CSS "ease"
};
void mrw_cubic_bezier_ease_init(mrw_cubic_bezier_ease* out);

// How many floats `key_count` keys of `components` hold.
size_t mrw_curve_value_count(mrw_curve_kind kind, uint32_t components, size_t key_count);

// Whether a curve keeps the rules above; call it once for keys that come from outside. Errors: MRW_BAD_ARGUMENT if
// `kind` is unknown, there is no key, components is not 1 … 4 (4 for rotations) or values are missing. MRW_BAD_DATA if
// times do not increase strictly, a number is not finite, a value or control point is beyond 1e18, a tangent times the
// longest interval is beyond 1e18, or a rotation key's squared length differs from 1 by more than 1e-3. Cost: once over
// the keys.
mrw_status mrw_check_curve(const mrw_curve* curve) MRW_NODISCARD;

// The value at `time_s`, clamped to the first and last key; one key is a constant.
//
// out: at least curve.components floats. Errors: MRW_BAD_ARGUMENT as in mrw_check_curve(), if `out` is too short, or
// time_s is not a number. Keys that mrw_check_curve() refuses with MRW_BAD_DATA are safe but give garbage; all other
// keys give finite values. At a key's time the value is exactly the key's (a rotation's except for normalisation and
// sign). Cost: a binary search and some dozen operations.
mrw_status mrw_evaluate_curve(const mrw_curve* curve, float time_s, float* out, size_t out_count) MRW_NODISCARD;

// The derivative of mrw_evaluate_curve() by time, per second. At an inner key it is that of the interval after the key;
// before the first and after the last key it is 0. Arguments, errors and cost as in mrw_evaluate_curve(). Also
// MRW_UNSUPPORTED for rotations; and MRW_BAD_DATA, with nothing written, if the result is not finite because keys are
// so far apart in so little time.
mrw_status mrw_curve_velocity(const mrw_curve* curve, float time_s, float* out, size_t out_count) MRW_NODISCARD;

// Cubic splines: tangents at the keys such that the second derivative is continuous too, for any key intervals.
//
// keys: kind linear. out: mrw_curve_value_count(hermite, …) floats, which with the same times are a curve of kind
// hermite; it does not overlap the keys. mrw_natural_spline: the second derivative is zero at both ends.
// mrw_clamped_spline: the first derivative at the ends is given, `components` floats a second each. One key: tangents
// 0, or those given. Rotations are written with signs that make neighbours nearest; then the spline runs through the
// four components. Errors: as mrw_check_curve(keys); MRW_BAD_ARGUMENT also if kind is not linear or a list is too
// short; MRW_BAD_DATA also if keys are so close in time or so far in value that a tangent is not finite. After
// MRW_BAD_DATA `out` may hold garbage. Method: tridiagonal system of the tangents, diagonally dominant, solved by
// elimination without pivots (de Boor, A Practical Guide to Splines, chapter IV) in `out` alone. Cost: twice over the
// keys.
mrw_status mrw_natural_spline(const mrw_curve* keys, float* out, size_t out_count) MRW_NODISCARD;
mrw_status mrw_clamped_spline(const mrw_curve* keys, const float* first_velocity, size_t first_velocity_count,
    const float* last_velocity, size_t last_velocity_count, float* out, size_t out_count) MRW_NODISCARD;

// A Bézier curve of any degree at u, by de Casteljau's algorithm.
//
// points: degree + 1 points of `components` floats (1 … 4). scratch: at least point_count floats, overlapping nothing.
// out: at least `components`. u outside [0, 1] extrapolates. Errors: MRW_BAD_ARGUMENT if there is no point, point_count
// is no multiple of components, a list is too short, or u is not finite; MRW_BAD_DATA if the result is not finite.
// Cost: degree · (degree + 1) / 2 interpolations.
mrw_status mrw_bezier(const float* points, size_t point_count, uint32_t components, float u, float* scratch,
    size_t scratch_count, float* out, size_t out_count) MRW_NODISCARD;

// The same for unit quaternions; each is taken with the sign nearer to the one before it, and the result is normalised.
// MRW_BAD_DATA also if the result has no direction, or is too long to be squared.
mrw_status mrw_bezier_rotation(const float* quaternions, size_t quaternion_count, float u, float* scratch,
    size_t scratch_count, float* out, size_t out_count) MRW_NODISCARD;

// A bicubic patch over 4 × 4 points: the tensor product of two cubics.
//
// points: 16 · components floats, component by component within a point, points along u first, then v. out: at least
// `components` (1 … 4). Errors: MRW_BAD_ARGUMENT if a list is too short, the basis is unknown, or u or v is not finite;
// MRW_BAD_DATA, with nothing written, if the result is not finite.
// Cost: 20 blends of four points.
mrw_status mrw_bicubic_patch(mrw_patch_basis basis, const float* points, size_t point_count, uint32_t components,
    float u, float v, float* out, size_t out_count) MRW_NODISCARD;

// How many floats the table of a curve has.
size_t mrw_arc_length_count(size_t key_count, uint32_t steps);

// Measures `curve` once. out: mrw_arc_length_count() floats; the last is the length of all, in the unit of the values.
// Errors: as mrw_evaluate_curve(); MRW_UNSUPPORTED for rotations (slerp is even as it is) and for kind step;
// MRW_BAD_ARGUMENT if `steps` is 0 or `out` too short; MRW_BAD_DATA if a length is not finite. Three-point Gauss
// quadrature a step: exact for linear, and else of the order steps⁻⁶ where the path does not stop inside a step. Cost:
// 3 square roots a step.
mrw_status mrw_make_arc_length(const mrw_curve* curve, uint32_t steps, float* out, size_t out_count) MRW_NODISCARD;

// The time at which `curve` has gone `distance`, clamped to the path; where the path rests, the end of the rest.
// Between two entries the length is taken as linear, so the point found is off along the path by at most
// A / (8 steps²), A being the largest second derivative by u in that key interval, plus rounding: twice the steps, a
// quarter of the error. Errors: MRW_BAD_ARGUMENT if the table is too short for this curve or `distance` is not a
// number. Cost: a binary search.
mrw_status mrw_time_at_distance(const mrw_curve* curve, const mrw_arc_length* table, float distance,
    float* time_s) MRW_NODISCARD;

// From 0 at u = 0 to 1 at u = 1, both exactly; u is clamped, and what is not a number counts as 0. back and elastic
// overshoot. out(u) = 1 - in(1 - u), in_out is the one, then the other at half size. As in Penner's, expo and elastic
// leave 0 (out: reach 1) with a jump of 1e-3 or less; back's overshoot is 1.70158, 1.525 times that for in_out;
// elastic's period is 0.3, 0.45 for in_out. Within 1e-6 of the closed forms. Unknown enumerators: linear.
float mrw_ease(mrw_easing easing, mrw_ease_mode mode, float u);

// y at x = u, with u clamped to [0, 1]. The point lies on the curve within 3e-7 in x (4e-7 (1 + |y1| + |y2|) in y):
// where the curve is steep, y is as uncertain as x is. Errors: MRW_BAD_ARGUMENT unless x1 and x2 are in [0, 1], y1 and
// y2 finite and u a number. Newton's method within a shrinking bracket. Cost: about 5 steps, at most 40.
mrw_status mrw_ease_by_curve(const mrw_cubic_bezier_ease* curve, float u, float* out) MRW_NODISCARD;

// ---- Part blend -----------------------------------------------------------------------------------------------------
// Blend: local poses of one skeleton → one local pose.
//
// Three functions, in the order in which a frame uses them: mrw_blend() averages, mrw_overlay() replaces parts,
// mrw_add() lays changes on top. All work on whole groups of four joints, allocate nothing and are thread-safe on
// different outputs.

// The largest weight of a layer; results stay far from the limits of float.
#define MRW_MAX_BLEND_WEIGHT 1e6f

// Where a joint's weights sum to less than this, its rest pose makes up the difference.
#define MRW_REST_THRESHOLD 0.1f

// A pose and how much of it.
typedef struct mrw_blend_layer mrw_blend_layer;
struct mrw_blend_layer {
  const mrw_soa_transform* pose;  // at least mrw_skeleton_soa_size(skeleton)
  size_t pose_count;
  float weight;  // 0 … MRW_MAX_BLEND_WEIGHT in mrw_blend(), 0 … 1 in mrw_overlay()
  // A factor for each joint's weight, 0 … 1: below 0 and NaN count as 0, above 1 as 1. Empty: 1 for every joint; else
  // at least 4 · mrw_skeleton_soa_size(skeleton) floats, in joint order, so that a group's factors are read at once.
  const float* mask;
  size_t mask_count;
};
void mrw_blend_layer_init(mrw_blend_layer* out);

// A change, and how much of it.
typedef struct mrw_additive_layer mrw_additive_layer;
struct mrw_additive_layer {
  const mrw_additive_transform* change;  // at least mrw_skeleton_soa_size(skeleton)
  size_t change_count;
  float weight;  // 0 … 1
  const float* mask;  // as in mrw_blend_layer
  size_t mask_count;
};
void mrw_additive_layer_init(mrw_additive_layer* out);

// out = Σ w x / Σ w for each joint, with w = weight · mask: translations and scales are averaged, rotations are summed
// as quaternions and normalised. Rotations must be unit quaternions; a sum in one hemisphere (see below) then never has
// length 0.
//
// Hemisphere: a layer's quaternion is negated where it points away from the sum of the layers before it. So two layers
// blend along the shorter arc, and no number of layers cancels out; the result's sign is arbitrary. Where Σ w is below
// `threshold`, the rest pose is added with the missing weight; so without layers the result is the rest pose. A single
// layer without a mask is copied bit for bit. Layers of weight 0 are not read. If no layer has a mask, and at most four
// layers have more than 1e-12 of the sum of weights (or of `threshold`, if that is greater), the other layers are not
// read either. The result is finite for poses with translations and scales up to 1e15.
//
// layers: any number; out: at least mrw_skeleton_soa_size(skeleton), and may be the pose of a layer. threshold: 1e-6 …
// MRW_MAX_BLEND_WEIGHT.
// Errors: MRW_BAD_ARGUMENT if a list is too short, or a weight or the threshold is out of its range or not a number.
// Cost: 14 multiply-adds a layer and joint, a square root and a division, four joints at once.
mrw_status mrw_blend(const mrw_skeleton* skeleton, const mrw_blend_layer* layers, size_t layer_count,
    mrw_soa_transform* out, size_t out_count, float threshold) MRW_NODISCARD;

// Replaces a part of `pose`: goes from pose to layer.pose by w = weight · mask, on the shorter arc. Where w is 0 the
// pose keeps its bits, where it is 1 it gets the layer's bits, whatever the other joints do.
// Errors: MRW_BAD_ARGUMENT if a list is too short, or the weight is not in 0 … 1.
mrw_status mrw_overlay(const mrw_skeleton* skeleton, const mrw_blend_layer* layer, mrw_soa_transform* pose,
    size_t pose_count) MRW_NODISCARD;

// The same with rotations in model space, so that a gun stays level while the hips below it sway: each joint's rotation
// in model space goes from the pose's to the layer's by w. Where w is 0 it stays, whatever the joints above do.
// Translations and scales are those of mrw_overlay(). The rotation of a joint in model space is here the product of
// those from its root down to it; scales have no part in it.
//
// scratch: at least skeleton.joint_count; what it holds is lost. mrw_pose.model_from_joint serves before
// mrw_local_to_model(). Errors: MRW_BAD_ARGUMENT if a list is too short, the weight is not in 0 … 1. Cost: that of
// mrw_overlay(), and about 150 operations a joint.
mrw_status mrw_overlay_in_model_space(const mrw_skeleton* skeleton, const mrw_blend_layer* layer,
    mrw_soa_transform* pose, size_t pose_count, mrw_affine* scratch, size_t scratch_count) MRW_NODISCARD;

// Masks a joint and all that hangs on it, for layers that move a part of the body. Each of these joints gets its new
// value or keeps the one in the mask, whichever is greater; all other joints keep theirs. So several calls can build
// one mask: begin with zeros. falloff: over how many joints the mask grows. 0: `joint` has 1. 2: `joint` has 1/3, its
// children 2/3, and what is below those 1, so that a spine bends evenly into the layer.
//
// mask: at least 4 · mrw_skeleton_soa_size(skeleton).
// Errors: MRW_BAD_ARGUMENT if `joint` is no joint or the mask is too short; nothing is written. Cost: for each joint
// with a higher index than `joint`, a walk up the hierarchy. Call it once a load.
mrw_status mrw_mask_below(const mrw_skeleton* skeleton, uint32_t joint, uint32_t falloff, float* mask,
    size_t mask_count) MRW_NODISCARD;

// out: the change from `reference` to `pose`: differences of translations, pose · reference⁻¹ of rotations, ratios of
// scales (1 where the reference is less than 1e-20). Rotations must be unit quaternions. For clips cooked as additive
// call mrw_sample_additive() instead: they hold their reference. Errors: MRW_BAD_ARGUMENT if a list is too short.
mrw_status mrw_make_additive(const mrw_skeleton* skeleton, const mrw_soa_transform* pose, size_t pose_count,
    const mrw_soa_transform* reference, size_t reference_count, mrw_additive_transform* out,
    size_t out_count) MRW_NODISCARD;

// Adds the share w = weight · mask of a change to `pose`. Translation: + w Δ. Rotation: multiplied from the left by the
// normalised (1 - w) · identity + w · change. Scale: · (1 + w (ratio - 1)). Where w is 0 the pose keeps its bits.
// Errors: MRW_BAD_ARGUMENT if a list is too short, or the weight is not in 0 … 1.
mrw_status mrw_add(const mrw_skeleton* skeleton, const mrw_additive_layer* layer, mrw_soa_transform* pose,
    size_t pose_count) MRW_NODISCARD;

// ---- Part transition ------------------------------------------------------------------------------------------------
// Transition: from one clip to the next, by cross-fading (both are sampled) or by inertialisation (only the
// new one is).

// How a weight goes from 0 to 1; u = time / duration. Part curve has more shapes.
typedef uint8_t mrw_fade;
enum {
  MRW_FADE_LINEAR = 0,  // u
  MRW_FADE_SMOOTHSTEP = 1,  // 3 u² - 2 u³: no jump of speed
  MRW_FADE_SMOOTHERSTEP = 2,  // 6 u⁵ - 15 u⁴ + 10 u³: no jump of acceleration
};

// How far four joints are from the new clip's pose, and how that fades. Each of the nine components of a joint, x y z
// of the translation, of the rotation vector (axis times angle, in the parent's axes) and of the scale, fades by
// itself:
//   offset(t) = (1 - s)⁴ (start + slope s) with s = min(rate t, 1).
typedef struct mrw_inertial_offset mrw_inertial_offset;
struct MRW_ALIGN(16) mrw_inertial_offset {
  float start[9][4];  // metres, radians, factors
  float slope[9][4];  // over the whole fade
  float rate[9][4];  // 1 / seconds
};

// A transition under way; the memory is the caller's and can be used again for the next one.
typedef struct mrw_inertia mrw_inertia;
struct mrw_inertia {
  mrw_inertial_offset* offsets;  // at least mrw_skeleton_soa_size(skeleton)
  size_t offset_count;
  float duration_s;  // 0: none, or over
};
void mrw_inertia_init(mrw_inertia* out);

// What was shown in the last two frames, and what the new clip would show.
typedef struct mrw_inertial_start mrw_inertial_start;
struct mrw_inertial_start {
  const mrw_soa_transform* before;  // the pose shown one frame before `now`
  size_t before_count;
  const mrw_soa_transform* now;  // the pose shown last
  size_t now_count;
  const mrw_soa_transform* target;  // the new clip at the time of `now`
  size_t target_count;
  const mrw_soa_transform* target_was;  // the new clip one frame earlier; empty: as if it stood still
  size_t target_was_count;
  float frame_s;  // time from `before` to `now`, > 0; less than 1e-6 counts as 1e-6
};
void mrw_inertial_start_init(mrw_inertial_start* out);

// The new clip's weight, `time_s` after the fade began. It is exactly 0 at times ≤ 0 and if time_s is not a number, and
// exactly 1 from duration_s on. If duration_s is not above 0, it is 1 at every time above 0.
float mrw_fade_weight(mrw_fade shape, float time_s, float duration_s);

// mrw_blend() of two poses: weight 0 gives `from`, weight 1 gives `to`, both bit for bit.
// from, to, out: at least mrw_skeleton_soa_size(skeleton); out may be either of the poses.
// Errors: MRW_BAD_ARGUMENT if a list is too short or the weight not in 0 … 1.
mrw_status mrw_cross_fade(const mrw_skeleton* skeleton, const mrw_soa_transform* from, size_t from_count,
    const mrw_soa_transform* to, size_t to_count, float weight, mrw_soa_transform* out, size_t out_count) MRW_NODISCARD;

// Captures the offset and its velocity; from then on only the new clip is sampled, and mrw_apply_inertia() gives what
// is shown.
//
// Inertialisation: D. Bollo, GDC 2018. Each component is a quintic: at the start it has the offset's value and
// velocity; at the end its value, velocity, acceleration and jerk are 0. It is in the factored form above. A component
// whose velocity would take it past zero before duration_s ends sooner, 5 start / -velocity after the beginning; so no
// offset changes its sign. Unlike Bollo's, x, y and z fade separately, not as a length along a fixed axis: the whole
// velocity is carried over, not only its part along the offset. A growing turn is limited to less than a whole turn. A
// turn of more than a quarter in one frame is not carried over faithfully.
// Rotations must be unit quaternions, translations and scales at most 1e15: then all is finite, here and below. To
// begin a new transition in the middle of another, pass the poses that were shown. Errors: MRW_BAD_ARGUMENT if a list
// is too short, or frame_s or duration_s is not above 0 and finite, or duration_s is above 1e6. Cost: two logarithms of
// quaternions a joint, four joints at a time; no allocation.
mrw_status mrw_begin_inertia(const mrw_skeleton* skeleton, const mrw_inertial_start* start, float duration_s,
    mrw_inertia* inertia) MRW_NODISCARD;

// pose: in, the new clip's pose `time_s` after the beginning; out, the pose to show. From duration_s on, and without an
// mrw_begin_inertia() before, the pose keeps its bits. Times below 0 count as 0.
// Errors: MRW_BAD_ARGUMENT if a list is too short or time_s not a number.
// Cost: nine quintics and one exponential a joint, four joints at a time.
mrw_status mrw_apply_inertia(const mrw_skeleton* skeleton, const mrw_inertia* inertia, float time_s,
    mrw_soa_transform* pose, size_t pose_count) MRW_NODISCARD;

// ---- Part local_to_model --------------------------------------------------------------------------------------------
// Local to model: local transforms → one model-space matrix a joint. And a pose that has both.

// A skeleton's pose in both forms. What changes one form keeps the other alike. The lists are views: functions that
// take a const mrw_pose write through them.
typedef struct mrw_pose mrw_pose;
struct mrw_pose {
  mrw_skeleton skeleton;  // of a file
  mrw_soa_transform* local;  // at least mrw_skeleton_soa_size(skeleton)
  size_t local_count;
  mrw_affine* model_from_joint;  // at least skeleton.joint_count
  size_t model_from_joint_count;
};
void mrw_pose_init(mrw_pose* out);

// model_from_joint = model_from_root · Π parent_from_joint, from the root down. model_from_root is the fixed transform
// that the source has above the skeleton, so the matrices are in the source's own space.
//
// local: at least mrw_skeleton_soa_size(skeleton); out: at least skeleton.joint_count; they do not overlap.
// Errors: MRW_BAD_ARGUMENT if a list is too short.
// Cost: one quaternion-to-matrix (four joints at a time) and one affine product a joint: 70 instructions on x86-64, 49
// on AArch64. Thread-safe on different outputs.
mrw_status mrw_local_to_model(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    mrw_affine* out, size_t out_count) MRW_NODISCARD;

// A level of detail: the same for the first `joint_count` joints only, to the same bits. Joints are breadth-first, so
// the parents of these joints are among them. All other matrices are left as they are.
//
// local: at least mrw_soa_count(joint_count); out: at least joint_count. Errors: MRW_BAD_ARGUMENT also if there are
// fewer joints.
mrw_status mrw_local_to_model_first(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    uint32_t joint_count, mrw_affine* out, size_t out_count) MRW_NODISCARD;

// The same for `joint` and its descendants only, after a change of their local transforms, say by inverse kinematics.
// `out` holds the matrices of the whole skeleton; all others keep their bits.
//
// local: at least mrw_skeleton_soa_size(skeleton); out: at least skeleton.joint_count. Errors: MRW_BAD_ARGUMENT also if
// there is no such joint. Cost: that of mrw_local_to_model for these joints, where a group of four that a generation
// covers only in part costs as much as a whole one; and one comparison for each other joint from `joint` to the last
// generation.
mrw_status mrw_local_to_model_below(const mrw_skeleton* skeleton, const mrw_soa_transform* local, size_t local_count,
    uint32_t joint, mrw_affine* out, size_t out_count) MRW_NODISCARD;

// ---- Part limits ----------------------------------------------------------------------------------------------------
// Joint limits: how far a joint may turn against its parent, and the nearest rotation within that.

// Rotations that exceed a limit by no more than this keep their bits.
#define MRW_LIMIT_TOLERANCE_RAD 1e-5f

// The widest swing of a cone: 170°.
#define MRW_WIDEST_SWING_RAD 2.9670597f

// A limit as people describe it, by angles.
typedef struct mrw_limit_description mrw_limit_description;
struct mrw_limit_description {
  mrw_limit_kind kind;  // its shape
  mrw_axis_order order;  // of a euler limit
  float zero[4];  // the local rotation at which all angles are 0: most often the joint's rest
  float axis[3];  // the limit's x in the joint's axes: a hinge's axis, a cone's middle
  float across[3];  // the limit's y; made perpendicular to x
  // Hinge: [0] is the angle. Cone: [0] is the twist; [1] and [2] are swings about y and z, for which least_rad must be
  // -most_rad. Euler: the three angles.
  float least_rad[3];
  float most_rad[3];  // as least_rad
  mrw_rate_limit rate;  // 0: none
};
void mrw_limit_description_init(mrw_limit_description* out);

// A rotation that follows a target with limited speed and acceleration: plain numbers. The next call puts a new
// follower on its target, at rest. It does the same with one that holds numbers out of range, which no call can have
// stored.
typedef struct mrw_rotation_follower mrw_rotation_follower;
struct mrw_rotation_follower {
  float rotation[4];  // x y z w
  float target[4];  // of the last call
  float velocity[3];  // radians a second, about the parent's axes
  float frame_s;  // of the last call
  uint32_t mode;  // mrw_follow_rotation()'s own
};
void mrw_rotation_follower_init(mrw_rotation_follower* out);

// A point that follows another likewise.
typedef struct mrw_point_follower mrw_point_follower;
struct mrw_point_follower {
  float point[3];  // metres
  float target[3];  // of the last call
  float velocity[3];  // metres a second
  float frame_s;  // of the last call
  uint32_t mode;  // mrw_follow_point()'s own
};
void mrw_point_follower_init(mrw_point_follower* out);

// The range of angles least_rad … most_rad; all angles if that is a turn or more.
// Precondition: -2π ≤ least_rad ≤ most_rad ≤ 2π. Off by at most 1e-6 rad; the same bits everywhere.
mrw_status mrw_make_angle_range(float least_rad, float most_rad, mrw_angle_range* out) MRW_NODISCARD;

// `out` is written only on success.
// Errors: MRW_BAD_ARGUMENT if a number is not finite, an axis or `zero` has no length, `across` is along `axis`, least
// is above most, an angle is beyond ±2π, a swing not in 0 … MRW_WIDEST_SWING_RAD or not symmetric, the second angle of
// an euler limit beyond ±π/2, a rate not in 0 … 1e18, or a kind or order is no value of its enum.
mrw_status mrw_make_limit(const mrw_limit_description* description, uint16_t joint, mrw_joint_limit* out) MRW_NODISCARD;

// local: in, a rotation x y z w; out, one inside the limit, in the same hemisphere and of unit length.
//
// A rotation that is inside, or outside by no more than MRW_LIMIT_TOLERANCE_RAD, keeps its bits, so a second call
// changes nothing. The result is inside within the same tolerance.
//
// The result depends on the kind. Hinge: the nearest rotation. Cone: the nearest swing, with the nearest twist for that
// swing. Euler: the clamped angles, improved by one round of exact searches along each angle; docs/ik/limits.md says
// how near that is.
//
// The nearest rotation jumps half way round, where both ends of the range are equally far. To avoid the jump, the
// result moves from the range's end to its middle over the last quarter of the way from that end to that point. For a
// turn about an axis that point is the angle opposite the middle. For a swing it is 180°, where the twist is undefined.
// For euler angles it is ±90° of the second angle, where the first and the third turn about the same axis. Distances
// are measured as tangents of a quarter of the angle. Two jumps remain. A range of all angles has no middle: its result
// jumps at a swing of 180°. A euler limit whose second angle may be ±90° jumps there, by no more than twice the angle
// by which the rotation is outside.
//
// Errors: MRW_BAD_ARGUMENT if the rotation has no length or is not finite; nothing is written.
// Cost: 5 to 15 products of quaternions and a few square roots; 3 products for a rotation that is inside. No
// trigonometry. Thread-safe.
mrw_status mrw_clamp_rotation(const mrw_joint_limit* limit, float local[4]) MRW_NODISCARD;

// The angle by which mrw_clamp_rotation() would turn the rotation, in radians; 0 if the rotation would keep its bits or
// be refused.
float mrw_limit_excess(const mrw_joint_limit* limit, const float local[4]);

// Does mrw_clamp_rotation() for the joint of each limit. All other joints keep their bits, and so do rotations that are
// not finite. local: of a skeleton that has all those joints. Errors: MRW_BAD_ARGUMENT if not; nothing is written.
// Cost: mrw_clamp_rotation() a limit. Thread-safe on different poses.
mrw_status mrw_limit_pose(const mrw_joint_limit* limits, size_t limit_count, mrw_soa_transform* local,
    size_t local_count) MRW_NODISCARD;

// The limit of a joint, or null. Precondition: the limits' joints ascend, as in an mrw_skeleton. Cost: a binary search.
const mrw_joint_limit* mrw_find_limit(const mrw_joint_limit* limits, size_t limit_count, uint32_t joint);

// Moves `state` on by dt_s. The target is taken to move in a straight line during that time, from the last call's
// target to `target`. The result is state.rotation or state.point.
//
// A follower on its target stays on it, to the bit, as long as the target keeps within the limits. Otherwise it takes
// the quickest way that the limits allow, and brakes in time: it does not overshoot a target at rest, unless it was too
// fast already or moved sideways. It brakes at 0.9 of the acceleration; within 0.9 acceleration / (120 s⁻¹)² of the
// target the distance falls as exp(-120 s⁻¹ · time) instead. Without a limit of acceleration it moves at the speed
// limit until it is there; without any limit it is always on its target. Rotations go the shorter way round, from rest
// along the great circle. While their target passes by sideways, rotations may exceed the acceleration by a few per
// cent.
//
// The path does not depend on the frame rate, except for how that samples the target: time advances in even steps of at
// most 1/960 s with constant acceleration. At rates that divide 960 Hz, paths to a target at rest agree to rounding; at
// others from 15 to 240 Hz, within the larger of 1e-4 rad (m) and 0.1 % of the way. Moving targets: docs/ik/limits.md.
//
// dt_s of 0 changes nothing. More than 0.25 s counts as 0.25 s, and less than a nanosecond as a nanosecond: so a
// follower's numbers stay finite.
// Errors: MRW_BAD_ARGUMENT if a number is not finite, dt_s or a limit is below 0, a limit is 1e18 or more, a target is
// 1e15 m away or more, or the target's quaternion has no length; nothing is written. Cost: on the target, a comparison
// and a logarithm of a quaternion; else a square root or two each step. No trigonometry of a library; the same bits
// everywhere. Thread-safe on different states.
mrw_status mrw_follow_rotation(mrw_rotation_follower* state, const float target[4], float dt_s,
    const mrw_rate_limit* limit) MRW_NODISCARD;
mrw_status mrw_follow_point(mrw_point_follower* state, const float target[3], float dt_s,
    const mrw_rate_limit* limit) MRW_NODISCARD;

// Does mrw_follow_rotation() for each joint whose limit has a rate: the pose's rotation is the target, and is replaced
// by the follower's. All other joints keep their bits. To stay inside the limits, call mrw_limit_pose() before, for the
// targets, and again after, since the way to a target may lead outside.
// states: one a limit. Errors: MRW_BAD_ARGUMENT if there are too few, a joint is not in the pose, or dt_s is below 0 or
// not finite; nothing is written. A rotation that is not finite stays as it is.
mrw_status mrw_follow_pose(const mrw_joint_limit* limits, size_t limit_count, mrw_rotation_follower* states,
    size_t state_count, float dt_s, mrw_soa_transform* local, size_t local_count) MRW_NODISCARD;

// ---- Part ik --------------------------------------------------------------------------------------------------------
// Inverse kinematics in closed form, for poses after mrw_local_to_model(). A limb of two bones reaches a point; a
// joint, or a chain of joints, looks at a point.
//
// Each comes in two forms. A kernel (mrw_turn_two_bone, aim) takes model matrices and gives turns, to be multiplied
// onto the joints' local rotations from the right (local · turn); it knows no skeleton. A whole call (solve_...) takes
// an mrw_pose, changes its local rotations, and updates the model matrices of all that hangs below. Both take the same
// struct.
//
// Every vector says its space: model space is that of model_from_joint, local space is the joint's own. Directions may
// be of any length. Results are exact under uniform scale, and for scales of the joints themselves. Under uneven scale
// of a joint above, a joint does not turn rigidly: kernels and aims are then approximate; mrw_solve_two_bone() stays
// exact. The same call gives the same bits on every processor. Thread-safe on different outputs; no allocation.

// The goal of a limb, whose joints are start, middle and end: hip, knee and ankle, say.
typedef struct mrw_two_bone mrw_two_bone;
struct MRW_ALIGN(16) mrw_two_bone {
  float target[3];  // where the end joint is to be; model space, metres
  float weight;  // 0 … 1: 0 changes no bit, 1 reaches the target; between, both turns are blended
  // The direction from the start joint in which the middle joint is to point; model space. Zero: the middle joint stays
  // on its side in the pose, turned with the limb by the shortest arc. Within 0.1 rad of the target's direction the
  // pole counts less and less. There a second direction is mixed in: 37° from the side that the shortest arc alone
  // would give. So when the target passes over the pole, the limb swings round and does not jump.
  float pole[3];
  float twist_rad;  // turns the limb about the line from start to target, on top of the pole; a few turns at most
  // The axis about which the middle joint bends by positive angles; in its local space. It decides how a straight limb
  // bends, and corrects a limb that the pose has bent the wrong way. Zero: the limb bends as in the pose, and a
  // straight limb bends towards the pole.
  float bend_axis[3];
  // 0 … 1: beyond this share of its length the limb straightens ever more slowly, so that the middle joint does not
  // snap when the target goes out of reach. 1: targets are reached exactly up to full length. 0.97 is a usual choice.
  float soft;
  float max_stretch;  // ≥ 1: for a target out of reach, the bones become longer by up to this factor
};
void mrw_two_bone_init(mrw_two_bone* out);

// The turns of a limb: unit quaternions x, y, z, w with w ≥ 0, in the joints' local spaces.
typedef struct mrw_two_bone_turns mrw_two_bone_turns;
struct MRW_ALIGN(16) mrw_two_bone_turns {
  float start[4];  // of the start joint
  float mid[4];  // of the middle joint
  float stretch;  // the factor on the translations of all joints below start, as far as end
  bool reached;  // Whether, at weight 1, the end joint comes within 1e-4 of the limb's length of the target.
};

// The model matrices of a limb's joints, none null. mid is start's child or further below, end mid's.
typedef struct mrw_two_bone_joints mrw_two_bone_joints;
struct mrw_two_bone_joints {
  const mrw_affine* start;  // hip, shoulder
  const mrw_affine* mid;  // knee, elbow
  const mrw_affine* end;  // ankle, wrist
};
void mrw_two_bone_joints_init(mrw_two_bone_joints* out);

// Joints of a skeleton; other joints may lie between them.
typedef struct mrw_two_bone_limb mrw_two_bone_limb;
struct mrw_two_bone_limb {
  uint32_t start;  // hip, knee and ankle
  uint32_t mid;  // hip, knee and ankle
  uint32_t end;  // hip, knee and ankle
};
void mrw_two_bone_limb_init(mrw_two_bone_limb* out);

// The goal of a joint that looks or points at something: an eye, a head, a gun.
typedef struct mrw_aim mrw_aim;
struct MRW_ALIGN(16) mrw_aim {
  float target[3];  // model space, metres
  float weight;  // 0 … 1: 0 changes no bit, 1 aims
  // The direction towards which `up` is turned about the line to the target; model space. Zero: the joint turns to the
  // target by the shortest arc. Within 0.1 rad of the target's direction the pole counts less and less, as an
  // mrw_two_bone's.
  float pole[3];
  float twist_rad;  // turns about the line to the target, on top of the pole; a few turns at most
  float forward[3];  // the direction that is to point at the target; in the joint's local space
  float up[3];  // local, not along forward; ignored without a pole
  float offset[3];  // where forward begins: an eye before the head's joint; local
};
void mrw_aim_init(mrw_aim* out);

// What mrw_turn_aim() gives.
typedef struct mrw_aim_turn mrw_aim_turn;
struct MRW_ALIGN(16) mrw_aim_turn {
  float turn[4];  // a unit quaternion x, y, z, w with w ≥ 0, in the joint's local space
  // Whether, at weight 1, the ray from the offset along forward goes through the target. It cannot in three cases: all
  // of the ray is farther from the joint than the target is; the target is at the joint; or forward has no length.
  bool reached;
};

// Method: half-angles by the law of cosines from (s - x)(s + x) and (x - m)(x + m), with s and m the sum and difference
// of the bones' lengths, x the distance to the target; then the shortest arc to the target, and a turn about the
// target's direction, in one quaternion. A limb with a bone of no length is solved as far as it can be; nothing becomes
// infinite. A target at the start joint folds the limb.
//
// The turns refer to the axes of the given matrices, which include the joints' own scales. If a joint's own scale has
// negative components, the caller must change signs in its turn: of x where exactly one of the scale's y and z is
// negative, of y where exactly one of z and x is, of z where exactly one of x and y is. mrw_solve_two_bone() does so.
//
// Errors: MRW_BAD_ARGUMENT, and nothing is written, for a matrix that is not there, numbers that are not finite (or too
// large to be squared), a weight or soft outside 0 … 1, max_stretch not in 1 … 2²⁰.
// Cost: 416 instructions on x86-64, 326 on AArch64; twice that where the limb is nearly straight or bent the wrong way,
// the target is more than 140° off or near the pole, or there is a twist.
mrw_status mrw_turn_two_bone(const mrw_two_bone_joints* joints, const mrw_two_bone* goal,
    mrw_two_bone_turns* out) MRW_NODISCARD;

// Solves four limbs at once, with the same bits, at 60 % of the instructions each. With fewer than four limbs, fill the
// rest with copies. Errors: as above; if one goal is bad, none is solved.
mrw_status mrw_turn_two_bone_x4(const mrw_two_bone_joints joints[4], const mrw_two_bone goals[4],
    mrw_two_bone_turns out[4]) MRW_NODISCARD;

// Solves a limb of a pose. Changes mrw_pose.local and mrw_pose.model_from_joint, unless the weight is 0. reached: may
// be null; see mrw_two_bone_turns. Errors: as above, and MRW_BAD_ARGUMENT if a list is too short or the joints are not
// a chain; nothing is written.
// Cost: the kernel's, and mrw_local_to_model_below(start). Under uneven scale, above the limb or of its start joint,
// the secant method finds the bend, and the limb is then turned: three to five times the cost, at most twelve. The
// target is still reached, or `reached` is false.
// May be null: reached.
mrw_status mrw_solve_two_bone(const mrw_pose* pose, const mrw_two_bone_limb* limb, const mrw_two_bone* goal,
    bool* reached) MRW_NODISCARD;

// Method: takes the point of the ray that is as far from the joint as the target, and turns it onto the target by the
// shortest arc and a turn about it, in one quaternion.
// Errors: MRW_BAD_ARGUMENT, and nothing is written, for numbers that are not finite (or too large to be squared), or a
// weight outside 0 … 1.
// Cost: 226 instructions on x86-64, 180 on AArch64.
mrw_status mrw_turn_aim(const mrw_affine* joint, const mrw_aim* goal, mrw_aim_turn* out) MRW_NODISCARD;

// Aims a joint of a pose. Changes mrw_pose.local and mrw_pose.model_from_joint, unless the weight is 0. reached: may be
// null. Errors: as above, and MRW_BAD_ARGUMENT if a list is too short or there is no such joint; nothing is written.
// Cost: the kernel's, and mrw_local_to_model_below(joint).
// May be null: reached.
mrw_status mrw_solve_aim(const mrw_pose* pose, uint32_t joint, const mrw_aim* goal, bool* reached) MRW_NODISCARD;

// Aims a chain of joints that share the turn, such as spine, neck and head. joints: each below the one before it in the
// skeleton. The last joint looks: forward, up and offset are in its space, and it makes the rest of the turn that the
// others leave. falloff: each joint's share of the turn, relative to the next joint's; 1: all alike, 0: the last joint
// alone.
// Errors: as above, and MRW_BAD_ARGUMENT if `joints` is empty or not a chain, or falloff not in 0 … 1.
// May be null: reached.
mrw_status mrw_solve_look_at(const mrw_pose* pose, const uint32_t* joints, size_t joint_count, const mrw_aim* goal,
    float falloff, bool* reached) MRW_NODISCARD;

// ---- Part ik_solve --------------------------------------------------------------------------------------------------
// Inverse kinematics of any chain or tree of joints, by iteration: several goals at once, with a choice of methods.

// The methods of mrw_solve_ik(); docs/ik/solvers.md says which to take.
typedef uint8_t mrw_ik_method;
enum {
  MRW_IK_METHOD_FABRIK = 0,
  MRW_IK_METHOD_CCD = 1,
  MRW_IK_METHOD_DAMPED_LEAST_SQUARES = 2,
  MRW_IK_METHOD_GAUSS_NEWTON = 3,
};

// Why a solver stopped.
typedef uint8_t mrw_ik_stop;
enum {
  MRW_IK_STOP_REACHED = 0,  // the error is less than the tolerance
  MRW_IK_STOP_STALLED = 1,  // nothing moves any more: a goal is out of reach, or goals conflict
  MRW_IK_STOP_ITERATIONS = 2,  // max_iterations are used up
};

// A position for a point of a joint, a rotation for the joint, or both. A part of weight 0 is ignored. Where goals
// conflict, doubling a weight halves that part's error.
typedef struct mrw_ik_goal mrw_ik_goal;
struct mrw_ik_goal {
  uint16_t joint;  // of the skeleton
  uint8_t priority;  // 0 is the most urgent; less urgent goals never disturb it. Jacobian methods only
  float offset[3];  // the point of the joint that is to reach `position`; the joint's space, metres
  float position[3];  // model space, metres
  float rotation[4];  // of the joint's axes, in model space: a unit quaternion x, y, z, w
  float position_weight;  // 0 … 100
  float rotation_weight;  // metres a radian: an error of one radian counts as this many metres
};
void mrw_ik_goal_init(mrw_ik_goal* out);

// What mrw_solve_ik() is to do with a pose.
typedef struct mrw_ik_problem mrw_ik_problem;
struct mrw_ik_problem {
  const mrw_ik_goal* goals;  // at least one
  size_t goal_count;
  const uint16_t* joints;  // the joints that may turn, in ascending order
  size_t joint_count;
  const float* stiffness;  // one for each of `joints`: 0 turns freely … 1 not at all; empty: all are free
  size_t stiffness_count;
  // By joint in ascending order, as a skeleton's. Limits of joints that do not turn are ignored.
  const mrw_joint_limit* limits;
  size_t limit_count;
  // The point towards which a chain with one goal bends, as a knee forward: the chain is turned about the line from its
  // first joint to the goal until its joints face this point. pole_weight is 0 … 1. FABRIK and CCD only.
  // model space, metres
  float pole[3];
  float pole_weight;  // 0: no pole
  // Lets joints[0] move, such as the pelvis of a full body: moving it by this many metres is as easy as turning a joint
  // by a radian. 0: it stays. Jacobian methods only.
  float root_travel_m;
};
void mrw_ik_problem_init(mrw_ik_problem* out);

// How mrw_solve_ik() solves.
typedef struct mrw_ik_options mrw_ik_options;
struct mrw_ik_options {
  mrw_ik_method method;  // see docs/ik/solvers.md
  // The most poses to start from. The first is the given one; while the goals are not reached, others follow, with
  // joints turned at random by `seed`. For sets of limits in which a single start gets stuck in a corner. A goal out of
  // reach uses all starts and costs that many times as much; the result may jump as goals move.
  uint8_t starts;
  uint16_t max_iterations;  // in each start
  float tolerance_m;  // iteration ends at an error (see mrw_ik_report) of no more than this
  float damping;  // for the Jacobian methods: more is calmer and slower
  uint32_t seed;  // for `starts` and mrw_solve_ik_genetic: the same seed gives the same result
  float weight;  // 0 … 1: 0 changes no bit; between, rotations are blended
  // For FABRIK and CCD with one goal. If the goal is out of reach, the bones from the first joint that turns to the
  // goal's joint become longer by up to this factor; if it is too near, shorter. 1: bones keep their lengths. Changes
  // the local translations of joints on the way.
  float stretch;
};
void mrw_ik_options_init(mrw_ik_options* out);

// How a solver ended.
typedef struct mrw_ik_report mrw_ik_report;
struct mrw_ik_report {
  float error_m;  // √Σ (position_weight · distance)² + (rotation_weight · angle)² of the goals, as for weight 1
  uint32_t iterations;  // of all starts
  mrw_ik_stop why;  // why it stopped
};

// Bytes of scratch memory that mrw_solve_ik needs; 0 if the problem's goals or joints cannot be read.
// May be null: options.
size_t mrw_ik_scratch_bytes(const mrw_skeleton* skeleton, const mrw_ik_problem* problem, const mrw_ik_options* options);

// Turns the joints from the given pose so that the goals are reached, or as nearly as can be.
//
// Local rotations of problem.joints are changed, and the translation of joints[0] if it may travel; model_from_joint is
// updated for what hangs below. scratch: at least mrw_ik_scratch_bytes(), of any alignment. report: may be null. A
// joint's rotation in model space is the product of the rotations from the root down; scale has no part in it. Errors:
// MRW_BAD_ARGUMENT, and nothing is written, if a list is too short, an index is out of range, `joints` do not ascend,
// there are more than MRW_MAX_JOINTS goals, a goal hangs on no joint that turns, a number is not finite, a weight or a
// stiffness is out of range, or the pose is not finite on the way to a goal. Cost: docs/ik.md. Thread-safe on different
// poses and scratch.
// May be null: options, report.
mrw_status mrw_solve_ik(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) MRW_NODISCARD;

// mrw_solve_ik_chain has only FABRIK and CCD, mrw_solve_ik_body only the Jacobian methods, so that a game does not link
// the others. Both take scratch memory of mrw_ik_scratch_bytes(), which links little. Errors: as mrw_solve_ik, and
// MRW_BAD_ARGUMENT if options.method is one of the others.
// May be null: options, report.
mrw_status mrw_solve_ik_chain(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) MRW_NODISCARD;
mrw_status mrw_solve_ik_body(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) MRW_NODISCARD;

// mrw_solve_ik by evolution, for sets of limits in which the other methods end in a corner. Too slow for every frame,
// and the result jumps as goals move. A function of its own, so that a game that does not call it does not link it.
//
// A memetic algorithm: poses compete by their error. The better ones are crossed and changed at random, and the best
// improve by cyclic coordinate descent. options.max_iterations counts generations, options.seed starts the random
// numbers. options.method, starts, damping and stretch are ignored, and so are the problem's pole and root travel.
// Every pose keeps to the limits. Joints of stiffness 1 stay; in crossing, all others turn alike. The
// same bits everywhere. Cost: tens of microseconds a generation, see docs/ik.md.
size_t mrw_ik_genetic_scratch_bytes(const mrw_skeleton* skeleton, const mrw_ik_problem* problem);

// mrw_solve_ik by evolution, for sets of limits in which the other methods end in a corner. Too slow for every frame,
// and the result jumps as goals move. A function of its own, so that a game that does not call it does not link it.
//
// A memetic algorithm: poses compete by their error. The better ones are crossed and changed at random, and the best
// improve by cyclic coordinate descent. options.max_iterations counts generations, options.seed starts the random
// numbers. options.method, starts, damping and stretch are ignored, and so are the problem's pole and root travel.
// Every pose keeps to the limits. Joints of stiffness 1 stay; in crossing, all others turn alike. The
// same bits everywhere. Cost: tens of microseconds a generation, see docs/ik.md.
// May be null: options, report.
mrw_status mrw_solve_ik_genetic(const mrw_pose* pose, const mrw_ik_problem* problem, const mrw_ik_options* options,
    void* scratch, size_t scratch_bytes, mrw_ik_report* report) MRW_NODISCARD;

// ---- Part feet ------------------------------------------------------------------------------------------------------
// Feet on the ground, for poses after mrw_local_to_model(). Soles stand where the game's rays hit, planted feet stay in
// place, and the pelvis moves so that the legs reach.

// A leg. Other joints may lie between the three; those keep their local rotations. For a hind leg, which has three
// bones, set hip, knee and paw.
typedef struct mrw_foot mrw_foot;
struct mrw_foot {
  uint32_t hip;  // joints of the skeleton
  uint32_t knee;  // joints of the skeleton
  uint32_t ankle;  // joints of the skeleton
  float sole[3];  // the point that stands on the ground, below the ball of the foot, say; ankle's space
  float bend_axis[3];  // of the knee; see mrw_two_bone
  float weight;  // 0 … 1
};
void mrw_foot_init(mrw_foot* out);

// The legs of a character, whose clips are made for level ground through the model's origin.
typedef struct mrw_feet mrw_feet;
struct mrw_feet {
  const mrw_foot* feet;  // two or more
  size_t foot_count;
  uint32_t pelvis;  // moves up and down with all below it, hips included; MRW_NO_JOINT: no joint moves
  float lower_m;  // ≥ 0: the most that the pelvis moves from its animated place, down or up; world
  float leg_extension;  // 0 … 1: how long a leg may get, as a share of its bones, before the pelvis goes down for it.
  float slope_rad;  // 0 … 1.5: the steepest slope that a foot follows
  float ease_s;  // > 0: time in which an offset, from a step in the ground or a release, falls to 2 %
};
void mrw_feet_init(mrw_feet* out);

// The ground under a foot in this frame, from the game; world.
typedef struct mrw_foot_ground mrw_foot_ground;
struct mrw_foot_ground {
  bool hit;  // false: as if the ground were level at the height of the model's origin
  float point[3];  // where a ray along `up` through mrw_foot_sole() hit, or any point of the plane that it hit
  float normal[3];  // of any length; steeper than 80°: no hit
  bool planted;  // the sole stays where it is for as long as this is true
};
void mrw_foot_ground_init(mrw_foot_ground* out);

// What mrw_place_feet() keeps of one foot from frame to frame. A new motion begins where the animation has the foot. So
// does one whose numbers are out of range. On a moving platform, use the platform's space as the world.
typedef struct mrw_foot_motion mrw_foot_motion;
struct mrw_foot_motion {
  float place[3];  // of the sole, as shown last; world
  uint8_t state[112];  // mrw_place_feet()'s own
  bool reached;  // whether the leg was long enough
};
void mrw_foot_motion_init(mrw_foot_motion* out);

// What mrw_place_feet() is told of a frame.
typedef struct mrw_feet_frame mrw_feet_frame;
struct mrw_feet_frame {
  float dt_s;  // since the last frame
  mrw_affine world_from_model;  // The character's placement: a rotation, one uniform scale above 0 and a translation.
  float up[3];  // a unit vector; world
  bool teleported;  // feet begin anew, none is planted where it was
  float weight;  // 0 … 1, times each foot's; motions go on at 0 too
};
void mrw_feet_frame_init(mrw_feet_frame* out);

// The leg that stands with this role: left_foot or right_foot, or of an animal's front legs left_hand or right_hand.
// `out` keeps its bend_axis and its weight.
// Errors: MRW_BAD_ARGUMENT for another role; MRW_MISMATCH if a joint of the leg, or its sole, is not known. `out` is
// written only on success. Cost: a few looks at the roles; once a load. Thread-safe.
mrw_status mrw_foot_of(const mrw_roles* roles, mrw_role role, mrw_foot* out) MRW_NODISCARD;

// The animated place of a foot's sole, in the world: the point for a ray to go through.
// Errors: MRW_BAD_ARGUMENT if the list is too short, there is no such joint, or the place is not finite or beyond 1e6.
mrw_status mrw_foot_sole(const mrw_foot* foot, const mrw_affine* world_from_model, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float sole_world[3]) MRW_NODISCARD;

// Places the feet: turns hips, knees and ankles, shifts the pelvis, and updates the matrices of what hangs below. Call
// it after mrw_local_to_model(), and cast the rays before it, from the same pose.
//
// pose: the animated one. ground, motion: one a foot.
//
// The sole's target is its animated place, lifted by the height of the ground's plane there above the level ground of
// the animation. The foot tilts with the plane, about its sole. A planted foot keeps its place across `up`, and its
// heading; along `up` it moves as animated, so that a heel can rise. When the ground's plane changes, or a foot is
// released, the target jumps but the sole does not: the difference becomes the sole's offset from the target. The
// offset goes on at the foot's speed, so that neither place nor speed jumps, and dies away as a critically damped
// spring does, exactly at any frame rate. The pelvis rises or sinks with the lowest sole, and sinks further if legs are
// too short. Ankles keep their animated orientation except for lean and heading. See docs/ik/feet.md.
//
// Errors: MRW_BAD_ARGUMENT if a list is too short, joints are not as they should be, or a number is not finite, out of
// its range or beyond 1e6; nothing is written.
// Cost: mrw_local_to_model_below() of the pelvis, if that moves, of each hip and each ankle; one mrw_solve_two_bone() a
// foot, up to three where joints are scaled unevenly: 6700 instructions a foot on x86-64, the skeleton having 27
// joints. No allocation; thread-safe on different motions and poses.
mrw_status mrw_place_feet(const mrw_pose* pose, const mrw_feet* feet, const mrw_feet_frame* frame,
    const mrw_foot_ground* ground, size_t ground_count, mrw_foot_motion* motion, size_t motion_count) MRW_NODISCARD;

// ---- Part springs ---------------------------------------------------------------------------------------------------
// Spring bones, for poses after mrw_local_to_model(): hair, tails and capes swing behind the animated pose.
//
// Chains and colliders are mrw_spring_chain and mrw_spring_collider of part file: a game's own, or an asset's by
// mrw_file_spring() and mrw_file_spring_colliders().

#define MRW_MAX_SPRING_STEP_S (1.0f / 60)  // a frame is cut into equal steps no longer than this

#define MRW_MAX_SPRING_STEPS 8  // the most steps of a frame; time beyond them is dropped

#define MRW_MIN_SPRING_FRAME_S 0.001f  // shorter frames are added up until they are this long

// mrw_spring_group: settings and motion of four bones. mrw_spring_root: motion of one chain's first joint, and what its
// bones share. mrw_joint_range: joints with consecutive numbers. Plain bytes in the caller's memory, defined in
// springs/spring_state.h.
typedef struct mrw_spring_group mrw_spring_group;
typedef struct mrw_spring_root mrw_spring_root;
typedef struct mrw_joint_range mrw_joint_range;

// The chains of one character. To keep or copy a motion, copy the memory.
typedef struct mrw_springs mrw_springs;
struct mrw_springs {
  mrw_spring_group* groups;  // one for four bones
  mrw_spring_root* roots;  // one a chain
  mrw_joint_range* below;  // the joints whose matrices springs change
  uint32_t group_count;  // length of groups
  uint32_t root_count;  // length of roots
  uint32_t below_count;  // length of below
  uint32_t joint_count;  // of the skeleton
  float saved_s;  // time of short frames, added up
};
void mrw_springs_init(mrw_springs* out);

// What mrw_simulate_springs() is told of a frame.
typedef struct mrw_spring_frame mrw_spring_frame;
struct mrw_spring_frame {
  float dt_s;  // since the last frame
  // The character's placement: a rotation, one uniform scale and a translation. Springs feel motion in the world, which
  // comes from this and from the pose.
  mrw_affine world_from_model;
  float gravity[3];  // m/s², world
  float wind[3];  // m/s, world; acts through mrw_spring_joint.drag
  const mrw_spring_collider* colliders;  // at most MRW_MAX_SPRING_COLLIDERS
  size_t collider_count;
  float teleport_m;  // if a chain's first joint moves further in a frame, the chain moves rigidly
  bool teleported;  // true: all chains move rigidly in this frame
  float weight;  // 0 … 1, times each joint's
};
void mrw_spring_frame_init(mrw_spring_frame* out);

// Bytes of memory that mrw_make_springs needs: 352 for four bones, 272 a chain, 2 a joint of the skeleton; 0 without
// chains.
size_t mrw_springs_bytes(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count);

// Makes springs in `memory`, which they use from then on. They begin at rest in the first pose.
//
// memory: at least mrw_springs_bytes(), on a boundary of 16 bytes. `chains` is not needed afterwards.
// Errors: MRW_BAD_ARGUMENT if a setting is out of its range, a joint is not in the skeleton or not below the one before
// it, a chain has no bone, or the memory is too small or off its boundary; nothing is written.
mrw_status mrw_make_springs(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    void* memory, size_t memory_bytes, mrw_springs* out) MRW_NODISCARD;

// Changes the settings, keeping the motion. Errors: as mrw_make_springs, and MRW_BAD_ARGUMENT if the joints are not the
// same.
mrw_status mrw_set_springs(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    mrw_springs* springs) MRW_NODISCARD;

// Lets the springs begin anew: at rest in the next frame's pose.
void mrw_reset_springs(mrw_springs* springs);

// Moves the springs on by a frame and bends the pose by them. Updates the matrices of what hangs below.
//
// pose: the animated one, in every frame: springs never read what they have written.
//
// Model. A bone is a damped pendulum about its joint. Its direction d in the world is a unit vector; u is the velocity
// of d:
//   du/dt = [ω² t + 2 ζ ω dt'/dt + (gravity - A) / L + drag (wind - V) / L] - (2 ζ ω + drag) u,
// without the part along d, which the bone bears: its length L never changes. ω is 2π mrw_spring_joint.frequency_hz, ζ
// is mrw_spring_joint.damping_ratio. t is the animated direction, turned with the bones above as they swing; t' is the
// animated direction alone. V and A are velocity and acceleration of the chain's first joint, from a parabola through
// its last three places. mrw_spring_joint.most_pull, if set, limits how hard the first two terms together turn the
// bone: under a greater load it yields. The pull ω² t grows with the sine of the angle. So it is a linear spring's at
// small angles, and nothing at half a turn. A bone feels the bones above it; they do not feel it. So in a chain of
// equal bones, at their common frequency, a lower bone swings 1 / (2 ζ) as far as the one above: less if ζ is above ½.
// The joint turns by the shortest arc that takes the bone to its direction. A chain below a joint of another chain is
// carried along, but does not feel that chain's swing.
//
// Method. Equal steps of at most 1/60 s: kick, drift on a great circle, kick (Störmer-Verlet), with half of the damping
// before and half after. Drift and kicks are scaled so that small swings have the exact frequency and decay at any
// step. So the frame rate changes a path only through how it samples the animation. The energy |u|²/2 - F·d may grow by
// no more than the work done, so it never grows without input. The rotation that a bone hands down to the bones below
// takes its animated direction to its simulated one. Of all such rotations it is the one nearest to the rotation of the
// bone above: a projection (P. Davenport's matrix; see G. Wahba, SIAM Review 7(3), 1965), at the cost of one product of
// matrix and vector a joint.
//
// Under uneven scale above a joint directions are approximate, and lengths are kept. A bone shorter than a micrometre
// stays as it is. A joint of weight 0 keeps its bits; if all weights are 0, so do the matrices.
// Errors: MRW_BAD_ARGUMENT if a list is too short, the skeleton has another count of joints, a number is not finite or
// out of its range, or there are more than MRW_MAX_SPRING_COLLIDERS; nothing is written.
// Cost: at 60 frames/s 726 instructions a joint on x86-64; with colliders 110 more, and 110 for each. No allocation;
// thread-safe on different springs and poses.
mrw_status mrw_simulate_springs(const mrw_pose* pose, const mrw_spring_frame* frame,
    mrw_springs* springs) MRW_NODISCARD;

// ---- Part morph -----------------------------------------------------------------------------------------------------
// Morph: weights of morph targets → bind-pose vertices moved, for any deformer.
//
//   once a load       mrw_find_weight_channels
//   once an instance  mrw_make_morphed
//   every frame       mrw_sample_channels → mrw_morph_weights → mrw_morph() → an mrw_mesh whose geometry is
//                     mrw_morphed_geometry.geometry goes through mrw_skin_rigid, mrw_skin_ssd; through
//                     mrw_morph_coordinates and mrw_skin_as in animation space
//
// glTF 2.0, section 3.7.2.2: attribute = bind + Σ_i weight_i · change_i, before skinning; normals and tangents are
// normalised afterwards. Any finite weight is legal.

// An instance's vertices, in the caller's memory. Copies are views of the same vertices.
typedef struct mrw_morphed_geometry mrw_morphed_geometry;
struct mrw_morphed_geometry {
  mrw_geometry geometry;  // the bind geometry, with the instance's own skin, normals and tangents
  mrw_geometry bind;  // as the file has it
  const uint32_t* offsets;  // for each block its first float in the skin; one more for the end
  uint32_t* moved;  // a bit for each block: it differs from the bind pose
  uint32_t* changed;  // a bit for each block: written since mrw_morph_coordinates()
  uint32_t* attributes;  // one, MRW_MORPHS_POSITIONS | …: what differs in the blocks moved
};

// For each target of `mesh` the index of the channel of `clip` that drives its weight, or MRW_NO_CHANNEL. The mesh is
// of `file`, the clip of `clips`, the same or a clip pack. out: at least mesh.target_count; errors: MRW_BAD_ARGUMENT.
// Cost: compares names; once a load.
mrw_status mrw_find_weight_channels(const mrw_file* file, const mrw_mesh* mesh, const mrw_file* clips,
    const mrw_clip* clip, uint32_t* out, size_t out_count) MRW_NODISCARD;

// The weights at one moment: each target gets its channel's value, or its default if it has no channel. channels: from
// mrw_find_weight_channels(); values: from mrw_sample_channels() of the same clip; empty lists: all defaults.
// out: at least mesh.target_count. Errors: MRW_BAD_ARGUMENT (`out` or `channels` too short, a channel outside the
// values).
mrw_status mrw_morph_weights(const mrw_mesh* mesh, const uint32_t* channels, size_t channel_count, const float* values,
    size_t value_count, float* out, size_t out_count) MRW_NODISCARD;

// Bytes that mrw_make_morphed() needs; 0 for a geometry without targets, which is its own morphed geometry.
size_t mrw_morphed_bytes(const mrw_geometry* geometry);

// The bind pose. memory: at least mrw_morphed_bytes(), 16-byte aligned (MRW_BAD_ARGUMENT otherwise); `out` keeps
// pointers into it and into `geometry`'s block. Cost: a copy of the vertices; once an instance.
mrw_status mrw_make_morphed(const mrw_geometry* geometry, void* memory, size_t memory_bytes,
    mrw_morphed_geometry* out) MRW_NODISCARD;

// Moves the vertices by `weights`, one a target; whatever they were moved by before is undone. Targets with weight 0
// cost nothing. Errors: MRW_BAD_ARGUMENT (too few weights, or one that is not finite: nothing is written).
// Cost: in proportion to the vertices (blocks of four) that targets with a weight other than 0 move, now or in the last
// call. Instructions a vertex, x86-64, g++ 12 -O3: 9 a target for positions, 15 with normals, 21 with tangents; and
// once, however many targets move it, 8, 20 or 29 to undo and normalise.
mrw_status mrw_morph(const float* weights, size_t weight_count, mrw_morphed_geometry* morphed) MRW_NODISCARD;

// Brings animation-space coordinates up to date with the last mrw_morph(): q_j.xyz += (q_j)_w Δ and so Σ_j q_j += Δ,
// where Δ is how far a vertex is from its bind pose. Δ goes through the blend that normals go through;
// mrw_as_coordinates() of the morphed geometry is the same where no residual changes a weight.
//
// coordinates: mrw_as_coordinates() of the bind geometry; pass the same floats to every call. Errors: MRW_BAD_ARGUMENT
// (too short). Cost: 60 instructions a vertex with four influences and a residual, for vertices that mrw_morph() has
// written since the last call.
mrw_status mrw_morph_coordinates(mrw_morphed_geometry* morphed, float* coordinates,
    size_t coordinate_count) MRW_NODISCARD;

// ---- Part example_space ---------------------------------------------------------------------------------------------
// Shape by example, the stage before morph: numbers that a game or a clip sets → weights of morph targets.
//
//   once a load    mrw_file_example_space, mrw_find_example_channels
//   every frame    mrw_sample_channels → parameters → mrw_evaluate_examples → weights of each of the space's meshes →
//                  mrw_morph(), or mrw_character_mesh.weights between mrw_pose_character() and mrw_finish_character()
//
// An artist places shapes at points of a space, such as "angry" at (1, 0). Each shape is a morph target, or the mesh as
// it is. Between those points all shapes are interpolated at once. The cooker solves for the coefficients here
// (docs/deformers.md).

// For each parameter the index of the channel of `clip` that has its name, or MRW_NO_CHANNEL. The space is of `file`,
// the clip of `clips`, the same or a clip pack. out: at least space.parameter_count. Errors: MRW_BAD_ARGUMENT. Cost:
// compares names; once a load.
mrw_status mrw_find_example_channels(const mrw_file* file, const mrw_example_space* space, const mrw_file* clips,
    const mrw_clip* clip, uint32_t* out, size_t out_count) MRW_NODISCARD;

// Weights of the space's targets at a point of it; others are left as they are.
//   weight_t(p) = linear_t · (1, p) + Σ_k radial_kt R(|p - place_k| · inverse_width_k)
//   R(x) = 2/3 - x² + x³/2 below 1, (2 - x)³/6 below 2, 0 beyond: the cubic B-spline
// At an example's place its own target has weight 1 and all others 0, but for rounding. Far from all examples weights
// are linear: they leave 0 … 1, so clamp parameters where a shape must not be exaggerated.
// parameters: finite, at least space.parameter_count; weights: one a target of the mesh. Errors: MRW_BAD_ARGUMENT (also
// for a space by hand whose lists are too short, or with a target beyond the weights); MRW_BAD_DATA if a weight is not
// finite: nothing is written. The same bits on every processor.
// Method: P.-P. Sloan, C. Rose, M. Cohen, "Shape by example", I3D 2001, section 3: cardinal functions.
// Cost: instructions an example, each with a target of its own, x86-64, g++ 12 -O3: in spaces of 2 parameters 91 of 8
// examples, 69 of 64; of 6 parameters 142 and 131. It grows with the examples that are near.
mrw_status mrw_evaluate_examples(const mrw_example_space* space, const float* parameters, size_t parameter_count,
    float* weights, size_t weight_count) MRW_NODISCARD;

// ---- Part debug_lines -----------------------------------------------------------------------------------------------
// Lines that show what a frame came to: joints, limits, goals, springs, bounds. For a game's own debug view, which
// draws them as it draws any lines; a game that calls none of these links none of it.
//
//   once          lines in mrw_debug_lines.room
//   every frame   mrw_debug_lines.count = mrw_debug_lines.left_out = 0; then mrw_joint_lines(), mrw_limit_lines(), …
//
// All lines are in model space, metres. Each call appends. A line without room is left out and counted, and so is one
// with a number that is not finite. No allocation; thread-safe on different lines. Cost: a few products a line.

// A line to draw; model space.
typedef struct mrw_debug_line mrw_debug_line;
struct mrw_debug_line {
  float from[3];  // its ends, metres
  float to[3];  // its ends, metres
  uint8_t colour[4];  // r g b a
};
void mrw_debug_line_init(mrw_debug_line* out);

// Room for lines in the caller's memory. The calls below append to it.
typedef struct mrw_debug_lines mrw_debug_lines;
struct mrw_debug_lines {
  mrw_debug_line* room;  // the caller's
  size_t room_count;
  size_t count;  // of lines that are there, from the front
  size_t left_out;  // for which there was no room
};
void mrw_debug_lines_init(mrw_debug_lines* out);

// A line from each joint's parent to the joint, and the joint's axes x, y, z in red, green, blue: `axis_m` long
// whatever its scale; 0: none. model_from_joint: at least skeleton.joint_count. At most 4 lines a joint.
// Errors, of all that follow: MRW_BAD_ARGUMENT if a list is too short, a joint is not in the skeleton, or a length is
// below 0 or not finite; nothing is appended.
mrw_status mrw_joint_lines(const mrw_skeleton* skeleton, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float axis_m, mrw_debug_lines* lines) MRW_NODISCARD;

// What each limit lets the joint do, about the joint, `size_m` large. local: the pose that model_from_joint is of.
// A hinge: the arc along which its y moves. A cone: the rim along which its x moves at most, and four spokes. Euler
// angles: three arcs in the colours of their axes, each with the other angles at the middle. Then where the joint is
// now, in green inside the limit and red outside of it. Limits that mrw_is_valid() refuses are passed over. At most 51
// lines a limit.
mrw_status mrw_limit_lines(const mrw_skeleton* skeleton, const mrw_joint_limit* limits, size_t limit_count,
    const mrw_soa_transform* local, size_t local_count, const mrw_affine* model_from_joint,
    size_t model_from_joint_count, float size_m, mrw_debug_lines* lines) MRW_NODISCARD;

// A cross at each goal's position, or, where its rotation counts, the axes it asks for; and a line to it from the point
// of the joint that is to be there. Green within `tolerance_m`, else red. At most 4 lines a goal.
mrw_status mrw_goal_lines(const mrw_skeleton* skeleton, const mrw_ik_goal* goals, size_t goal_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, float size_m, float tolerance_m,
    mrw_debug_lines* lines) MRW_NODISCARD;

// The bones of each chain, and its tip. model_from_joint: after mrw_simulate_springs(). At most a line a joint.
mrw_status mrw_spring_lines(const mrw_skeleton* skeleton, const mrw_spring_chain* chains, size_t chain_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_debug_lines* lines) MRW_NODISCARD;

// Each collider as great circles about its ends, and lines between them: 48 lines a sphere, 100 a capsule.
mrw_status mrw_collider_lines(const mrw_skeleton* skeleton, const mrw_spring_collider* colliders, size_t collider_count,
    const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_debug_lines* lines) MRW_NODISCARD;

// The box's edges and the sphere's three great circles: 60 lines; none if it is empty.
mrw_status mrw_bounds_lines(const mrw_bounds* bounds, mrw_debug_lines* lines) MRW_NODISCARD;

// ---- Part palette ---------------------------------------------------------------------------------------------------
// Palette: model-space joints → the matrices that skinning blends.

// out[i] = model_from_joint[joints[i]] · bind[i]: where palette entry i takes a vertex of the bind pose.
//
// joints, bind: one a palette entry, equal in size (mrw_mesh.joints and mrw_mesh.inverse_bind; the GLES path has its
// own bind matrices, which also undo quantisation). out: at least as many entries, and one more a helper. Every joint
// must be below model_from_joint_count. A helper's `first` and `second` must be below joint_count and differ.
// Errors: MRW_BAD_ARGUMENT if a list is too short, a joint out of range or a share not between 0 and 1.
//
// helpers: written behind the joints' entries. Entry joint_count + h blends the entries `first` and `second`, the
// latter at `share`. Each of the two matrices is split into a rotation and a stretch: matrix = rotation · stretch. The
// rotations are blended as quaternions, the shorter way, the stretches linearly. The two entries take the origin of
// joint `second` to two places. The helper takes it to the place that dual quaternion blending of the two entries gives
// (L. Kavan et al., Geometric skinning with approximate dual quaternion blending, 2008). Between a joint and its parent
// that is a turn about the joint.
//
// centres: none, or three numbers a helper: a point in the space of joint `second`. Both entries take it somewhere; the
// helper takes it to the mean of the two places, by shares (B. Le, J. Hodgins, Real-time skeletal skinning with
// optimized centers of rotation, 2016).
//
// If the two rotations are 180° apart, the blend turns about the axis whose largest component is positive. If an entry
// mirrors, its stretch mirrors and its rotation does not. Where an entry has lost its volume, or is not finite, the two
// matrices are blended element by element.
//
// The same palette serves SSD and animation space (docs/decisions.md, "One palette").
// Cost: one affine product an entry, 44 instructions on x86-64 and 33 on AArch64. A helper takes 198 on x86-64, with a
// centre 248. Helpers are computed four at a time: if the two entries of one of them differ in their stretches, each of
// the four takes 385.
// Thread-safe on different outputs; out overlaps none of the inputs.
mrw_status mrw_build_palette_of_joints(const uint16_t* joints, size_t joint_count, const mrw_affine* bind,
    size_t bind_count, const mrw_affine* model_from_joint, size_t model_from_joint_count, mrw_affine* out,
    size_t out_count, const mrw_helper* helpers, size_t helper_count, const float* centres,
    size_t centre_count) MRW_NODISCARD;

// The palette of a mesh.
mrw_status mrw_build_palette(const mrw_mesh* mesh, const mrw_affine* model_from_joint, size_t model_from_joint_count,
    mrw_affine* out, size_t out_count) MRW_NODISCARD;

// Whether a map mirrors: its determinant is below 0. Triangles that it places are wound the other way, so their fronts
// are clockwise: glFrontFace(GL_CW), where back faces are culled. A map without volume and one with a number that is
// not finite do not.
bool mrw_turns_inside_out(const mrw_affine* map);

// The same for vertices that follow a palette: whether more of its matrices mirror than not. For culling of meshes that
// are not double_sided; a game need not ask if its characters are never mirrored and never hung on anything mirrored.
// An instance of a crowd is turned inside out if either this palette or its world_from_model mirrors, but not if both
// do: see part gles3_crowd of c_gles3.h. Cost: a determinant a matrix.
bool mrw_palette_turns_inside_out(const mrw_affine* palette, size_t palette_count);

// ---- Part bounds ----------------------------------------------------------------------------------------------------
// Bounds: palette → a box and a sphere about the mesh, for culling and shadows, without its vertices.
//
//   over a whole clip   mrw_file_bounds(clip, mesh): from the file, no work
//   in one frame        mrw_make_extents() once a load; mrw_palette_bounds() every frame
//
// Both are about every vertex that rigid skinning, SSD (with helpers) and pose-space deformation give: those blend
// with weights ≥ 0 that sum to 1, so a vertex is in the convex hull of where its joints alone would take it. What is in
// the file holds for animation space and multi-weights too, as it was measured with them; mrw_palette_bounds() knows
// nothing of their residuals (docs/benchmarks.md, "Bounds", has how far they went beyond it).

// The vertices of the bind pose that a palette entry has a weight in, as a box in mesh space.
typedef struct mrw_joint_extent mrw_joint_extent;
struct mrw_joint_extent {
  float centre[3];  // the box's middle
  float half[3];  // ≥ 0; below 0: nothing follows this entry
};

// What a morph target (or an example of pose-space deformation) adds to vertices at weight 1: a box about all changes
// and about 0, in mesh space.
typedef struct mrw_morph_extent mrw_morph_extent;
struct mrw_morph_extent {
  float least[3];  // ≤ 0
  float most[3];  // ≥ 0
};

// Views into the caller's memory.
typedef struct mrw_mesh_extents mrw_mesh_extents;
struct mrw_mesh_extents {
  mrw_joint_extent* joints;  // one a palette entry, helpers behind
  size_t joint_count;
  mrw_morph_extent* targets;  // one a morph target
  size_t target_count;
  mrw_morph_extent pose_space;  // the sum of what all examples may add
};

// Bytes that mrw_make_extents() needs: 24 a palette entry and 24 a morph target, up to a multiple of 16.
size_t mrw_extents_bytes(const mrw_mesh* mesh);

// Looks at every vertex once. The result serves all characters with this mesh, at any level of detail whose vertices
// are among those of `mesh`.
//
// mesh: of a file, not of a character whose vertices are morphed. memory: at least mrw_extents_bytes(), 16-byte
// aligned; `out` keeps pointers into it. Errors: MRW_BAD_ARGUMENT (the memory). Cost: once a load.
mrw_status mrw_make_extents(const mrw_mesh* mesh, void* memory, size_t memory_bytes,
    mrw_mesh_extents* out) MRW_NODISCARD;

// The box of the mesh and a sphere about the box's centre, in the palette's space.
//
// palette: of the mesh, extents.joint_count entries. weights: of its morph targets, any finite numbers; empty: none is
// active. Without a vertex `out` is empty (mrw_bounds_is_empty()). Errors: MRW_BAD_ARGUMENT (a list too short, a weight
// that is not finite); `out` is not written. Method: the box of a transformed box is its centre, transformed, and its
// half sides through the absolute values of the matrix (J. Arvo, "Transforming axis-aligned bounding boxes", Graphics
// Gems, 1990); a union of those. The sphere's radius is the distance to the farthest corner of any of them. Cost: 119
// instructions a palette entry, x86-64, in two passes. No allocation, thread-safe.
mrw_status mrw_palette_bounds(const mrw_mesh_extents* extents, const mrw_affine* palette, size_t palette_count,
    const float* weights, size_t weight_count, mrw_bounds* out) MRW_NODISCARD;

// ---- Part skin ------------------------------------------------------------------------------------------------------
// Skin on the CPU: bind vertices and a palette → deformed vertices.
//
// Every deformer writes all mrw_geometry.slot_count slots, padding included, so that the geometry's indices can be used
// as they are. Positions are in the palette's space (model space after mrw_local_to_model). All are thread-safe on
// different outputs.
//
// Costs are CPU instructions for each vertex with four influences, in runs of about 150 vertices: first x86-64 (SSE2),
// then AArch64, by g++ 12 -O3.

// How normals and tangents of the bind pose are deformed. M is the 3×3 part of the vertex's blended matrix.
typedef uint8_t mrw_normal_transform;
enum {
  // Normals through the inverse transpose of M (its cofactors), tangents through M, both unit: exact for any blend that
  // can be inverted, mirrored or unevenly scaled ones too.
  MRW_NORMAL_TRANSFORM_INVERSE_TRANSPOSE = 0,
  // Both through M, not normalised: half the time, for shaders that normalise anyway. Directions are right where M is a
  // rotation, a mirror or an even scale; a blend of rotations is not quite one of these. On real clips normals stray by
  // 0.8° on average, by up to 58° inside sharp bends, and come as short as 0.27 (docs/benchmarks.md). Tangents are
  // those of inverse_transpose, except for their length.
  MRW_NORMAL_TRANSFORM_BLENDED_MATRIX = 1,
};

// Where skinned vertices go: the caller's memory, slot after slot.
typedef struct mrw_skin_output mrw_skin_output;
struct mrw_skin_output {
  float* positions;  // 3 a slot; required
  size_t position_count;
  float* normals;  // 3 a slot; leave empty to skip
  size_t normal_count;
  // 4 a slot: xyz, then the handedness, which changes sign where the blend mirrors. With blended_matrix, mrw_skin_ssd()
  // and mrw_skin_as() take that from the determinant of the run's last joint instead of the blend's: the two differ
  // only at a vertex that follows both mirrored and unmirrored joints. Needs normals. Leave empty to skip.
  float* tangents;
  size_t tangent_count;
  mrw_normal_transform normal_transform;  // of tangents, too
};
void mrw_skin_output_init(mrw_skin_output* out);

// A mesh in animation space, for mrw_as_tangents().
typedef struct mrw_as_part mrw_as_part;
struct mrw_as_part {
  const mrw_mesh* mesh;  // cooked with animation space
  const float* coordinates;  // from mrw_as_coordinates()
  size_t coordinate_count;
  float* tangents;  // mrw_as_tangent_count() floats, to be written
  size_t tangent_count;
};
void mrw_as_part_init(mrw_as_part* out);

// Each vertex follows the joint with its largest weight.
//   position = M_j (v, 1)
// palette: mrw_mesh_palette_size(mesh) entries. Errors, here and below: MRW_BAD_ARGUMENT if a list is too short, if the
// geometry refers to palette entries that the mesh does not have (then it is another mesh's), if normals or tangents
// are asked of a mesh without them, or if the geometry's floats do not stand on 16-byte boundaries.
// Cost: positions 50 / 32; with exact normals 78 / 49.
mrw_status mrw_skin_rigid(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) MRW_NODISCARD;

// Skeletal subspace deformation, also called linear blend skinning.
//   position = (Σ_j w_j M_j) (v, 1)
// Cost: positions 38 / 29. Through the blended matrix: with normals 47 / 34, with tangents too 59 / 42. Through the
// inverse transpose: 66 / 47 and 83 / 56. In multiply-adds that is 12 for each influence except the last, 9 for the
// position, and 9 for each normal or tangent through the matrix. A normal through the inverse transpose takes 27
// multiplications, a square root and a division.
mrw_status mrw_skin_ssd(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) MRW_NODISCARD;

// How many floats mrw_as_coordinates() writes: 3 a slot, and 4 more for each of its influences except the last.
size_t mrw_as_coordinate_count(const mrw_geometry* geometry);

// Animation-space coordinates of every slot: q_j = (w_j v + d_j, w_j + δ_j), with Σ_j (q_j)_w = 1. (w_j v, w_j) is the
// lift of SSD's weights; (d_j, δ_j) is mrw_geometry.as_residual. In the notation of Merry, Marais and Gain (ACM TOG
// 25(4), 2006) p_j = B_j⁻¹ q_j, with B_j⁻¹ the joint's inverse bind matrix; here B_j⁻¹ is part of the palette's M_j.
//
// As with the weights of SSD, the last influence is not stored, since it is what the others leave: a block holds the
// sum Σ_j q_j as x[4] y[4] z[4] (its w is 1), then x[4] y[4] z[4] w[4] of each q_j but the last.
// out: mrw_as_coordinate_count() floats. Done once a mesh, not a frame.
mrw_status mrw_as_coordinates(const mrw_geometry* geometry, float* out, size_t out_count) MRW_NODISCARD;

// How many floats mrw_as_tangents() writes of a mesh: twice mrw_as_coordinate_count().
size_t mrw_as_tangent_count(const mrw_geometry* geometry);

// Bytes of scratch memory that mrw_as_tangents() wants: about 32 a slot and 4 an index.
size_t mrw_as_tangent_scratch_bytes(const mrw_as_part* parts, size_t part_count);

// Two tangents of the surface at every slot as animation-space vectors, as in Merry, Marais and Gain:
//   t = Σ_k c_k (p_k - p) over the vertex's neighbours k, so t = Σ_j M_j τ_j with τ_j = Σ_k c_k (q_kj - q_j),
//   Σ_j (τ_j)_w = 0
// Each is the derivative of the surface along one of two directions: the mean over the triangles round the vertex,
// weighted by area. In the bind pose, unless residuals change that, the two are perpendicular unit vectors: t₀ × t₁ is
// the mesh's normal, and t₀ points along its tangent if it has one. Where the triangles' own derivative in the bind
// pose is not that unit vector, the difference goes through the blended matrix; it is all of t if the triangles have no
// area.
//
// A neighbour may follow a palette entry that the vertex does not follow. It is replaced by the linear combination of
// the vertex's own entries that blends the same joints at the same shares, or comes closest. Before that, a joint that
// none of the vertex's entries blends is replaced by the vertex's joint that the neighbour follows most.
//
// parts: the meshes that make up a surface, such as the primitives of one mesh of the source. Slots in one place, with
// the same weights and normals less than 25° apart, are one vertex, whichever part they are in; so seams do not show.
// scratch: mrw_as_tangent_scratch_bytes(), on a 4-byte boundary, free again afterwards. Errors: MRW_BAD_ARGUMENT if a
// mesh has no normals or a list is too short. Call it once, not every frame: it takes about 11 000 instructions for
// each vertex, and 23 000 where helpers are involved.
mrw_status mrw_as_tangents(const mrw_as_part* parts, size_t part_count, void* scratch,
    size_t scratch_bytes) MRW_NODISCARD;

// Animation space.
//   position = Σ_j M_j q_j        (= Σ_j W_j p_j)
//            = M_last Σ_j q_j + Σ_{j<last} (M_j - M_last) q_j
// Normals and tangents go through the blend Σ_j (q_j)_w M_j, which equals SSD's where the residual is zero.
// coordinates: from mrw_as_coordinates() of this geometry.
// Cost: positions 40 / 31. Through the blended matrix: with normals 73 / 56, with tangents too 85 / 62. Through the
// inverse transpose: 92 / 69 and 108 / 77. In multiply-adds that is 12 for each influence except the last and 9 for the
// sum; with normals 9 more for each influence except the last.
//
// tangents: from mrw_as_tangents() of this geometry, or empty. With them, normals are those of the deformed surface
// itself, t₀' × t₁' with t' = Σ_j M_j τ_j, negated where the run's last joint mirrors. Tangents are t₀', whose
// handedness changes sign there. Both are unit vectors, whatever out.normal_transform says. `tangents` are of the
// surface without morph targets. Cost, x86-64: 140, and with tangents 151.
mrw_status mrw_skin_as(const mrw_mesh* mesh, const float* coordinates, size_t coordinate_count,
    const mrw_affine* palette, size_t palette_count, const mrw_skin_output* out, const float* tangents,
    size_t tangent_count) MRW_NODISCARD;

// Multi-weight enveloping: Wang and Phillips, "Multi-weight enveloping: least-squares approximation techniques for skin
// animation", SCA 2002. Twelve weights an influence, one for each element of its matrix:
//   position = R Σ_j (Ω_j ∘ R⁻¹ M_j) (v, 1)        Ω_j = w_j + mrw_geometry.mwe_residual, ∘ element by element
// Weights of single elements depend on the frame in which matrices are given. That frame, R, is taken from the palette
// entry mrw_geometry.mwe_root: the rotation that Gram-Schmidt makes of its matrix's first two columns, and its
// translation. So the result moves with the character. Normals and tangents go through the 3×3 part of the blend, R Σ_j
// Ω_j ∘ R⁻¹ M_j, which is SSD's where the residual is zero. With blended_matrix this blend decides whether tangents are
// mirrored.
//
// Errors: also MRW_BAD_ARGUMENT for a geometry without mwe_residual. Cost, x86-64: positions 82; with normals through
// the blended matrix 110, through the inverse transpose 127. It reads 192 bytes of residual a block and influence, so
// with four influences nine times as much as SSD.
mrw_status mrw_skin_mwe(const mrw_mesh* mesh, const mrw_affine* palette, size_t palette_count,
    const mrw_skin_output* out) MRW_NODISCARD;

// How many floats mrw_psd_distances() writes: for each palette entry one for each example and one for the bind pose; 0
// without examples.
size_t mrw_psd_distance_count(const mrw_geometry* geometry);

// How far a pose is from the examples, joint by joint; mrw_skin_psd() takes the mean for each vertex by its weights.
// For palette entry j and example k it is D_jk = 1 - (q_j · q_jk)² = sin²(half the angle between), with q_j the
// rotation of M_j relative to its parent's, rotations as in mrw_skin_mwe(); 0 for an entry without a parent.
// out, for each palette entry j: -D_jk / 2σ² for each example k, then the same for the bind pose in place of an
// example. Call it once for each mesh and frame. Errors: MRW_BAD_ARGUMENT if a list is too short.
// Cost: 34 instructions a palette entry and example, x86-64.
mrw_status mrw_psd_distances(const mrw_geometry* geometry, const mrw_affine* palette, size_t palette_count, float* out,
    size_t out_count) MRW_NODISCARD;

// Weighted pose-space deformation: Lewis, Cordner, Fong, "Pose space deformation", SIGGRAPH 2000, with distances
// weighted for each vertex as in Kurihara and Miyata, "Modeling deformable human hands from medical images", SCA 2004.
//   position = (Σ_j w_j M_j) (v + (1 - φ_bind) Σ_k φ_k d_k, 1)        d_k: mrw_geometry.pose_space
//   φ_k = exp(-Σ_j w_j D_jk / 2σ²)
// The factor 1 - φ_bind makes the deltas vanish in the bind pose. Normals and tangents go through the blend, as in SSD.
// distances: from mrw_psd_distances() of this geometry and palette. Errors: also MRW_BAD_ARGUMENT if they are too few.
// A geometry without examples is deformed as by mrw_skin_ssd().
// Cost, x86-64: positions 49, with normals through the blended matrix 61, through the inverse transpose 74; and 30 more
// a vertex for each example that moves the vertex's block of four.
mrw_status mrw_skin_psd(const mrw_mesh* mesh, const float* distances, size_t distance_count, const mrw_affine* palette,
    size_t palette_count, const mrw_skin_output* out) MRW_NODISCARD;

// ---- Part character -------------------------------------------------------------------------------------------------
// A whole file as one character: takes all its skeletons and meshes through the stages of marrow.h, in their order.
//
//   once a load       mrw_make_animations
//   once a character  mrw_make_character
//   every frame       mrw_pose_character; the game's own inverse kinematics, feet and springs; mrw_finish_character
//   then              mrw_skin_ssd() and its like of an mrw_character_mesh, or mrw_gles3_pose() of an mrw_gles3_skinner
//
// A file may hold several skeletons, such as a rider's and a horse's; they are posed together. Arrays with one element
// a skeleton or mesh are in the order of the file.
//
// Local poses may come from elsewhere. Then, instead of calling mrw_pose_character(), write mrw_pose.local of each
// skeleton and mrw_character_mesh.weights, and call mrw_character_to_model().
//
// No allocation: memory is the caller's, sizes are asked for first. Thread-safe on different characters; animations are
// only read, and serve any number of them.

// What the skeletons of a character play together: a clip each, or none. Plain pointers, which a game may fill itself.
typedef struct mrw_animation mrw_animation;
struct mrw_animation {
  const char* name;  // of its clips; may be empty
  mrw_file clips;  // the file that its clips are from: the character's file, or a clip pack
  float duration_s;  // of the longest
  const uint32_t* clip_of_skeleton;  // One a skeleton of the character: which clip it plays; MRW_NO_CLIP: it rests.
  size_t clip_of_skeleton_count;
  // One a morph target of the character, mesh after mesh: its channel in the clip that the mesh's skeleton plays, or
  // MRW_NO_CHANNEL. From mrw_find_weight_channels().
  const uint32_t* channels;
  size_t channel_count;
  // What its clips do beside their poses: that of the first skeleton whose clip has a root's motion, else of the first
  // whose clip has any.
  mrw_clip_motion motion;
  uint32_t motion_skeleton;  // which skeleton's clip that is
};

// All animations of a file, by name.
typedef struct mrw_animations mrw_animations;
struct mrw_animations {
  // One animation for each clip, at the clip's own index. It plays that clip and, on each other skeleton, the first
  // clip with the same name. A clip without a name plays alone.
  const mrw_animation* all;
  size_t all_count;
};

// What a character is made for.
typedef struct mrw_character_options mrw_character_options;
struct mrw_character_options {
  uint32_t layers;  // the most layers that are blended at once; at least 1
  uint32_t level;  // of detail, as in mrw_file_mesh
  bool skin;  // on the CPU; false: no palettes or morphed vertices; an mrw_gles3_skinner makes its own
  bool animation_space;  // skin by mrw_skin_as(), too
};
void mrw_character_options_init(mrw_character_options* out);

// A skeleton of the file, posed. Between mrw_pose_character() and mrw_finish_character(), whatever changes
// mrw_pose.local must also bring mrw_pose.model_from_joint up to date, and the other way round; the functions called
// there all do so.
typedef struct mrw_character_skeleton mrw_character_skeleton;
struct mrw_character_skeleton {
  mrw_pose pose;  // what solvers, feet and springs take
  // mrw_sample_character()'s own. One a layer: its sampled pose, and what is cached of the clip.
  mrw_soa_transform* sampled;
  size_t sampled_count;
  mrw_sample_cache* caches;  // as `sampled`
  size_t cache_count;
};

// A mesh, ready for mrw_skin_ssd(mesh, palette, …) or mrw_skin_as(mesh, coordinates, palette, …) after
// mrw_finish_character().
typedef struct mrw_character_mesh mrw_character_mesh;
struct mrw_character_mesh {
  mrw_mesh mesh;  // of the level asked for; with `skin` its geometry is this character's own, morphed
  float* weights;  // of morph targets
  size_t weight_count;
  mrw_affine* palette;  // empty without `skin`
  size_t palette_count;
  float* coordinates;  // empty without `skin` and `animation_space`
  size_t coordinate_count;
  mrw_morphed_geometry morphed;  // with `skin`
  void* vertices;  // the memory that `morphed` lies in
  size_t vertices_bytes;
  uint32_t first_target;  // in mrw_animation.channels
};

// Views into the caller's memory. A copy is the same character.
typedef struct mrw_character mrw_character;
struct mrw_character {
  mrw_file file;  // as it was given
  mrw_character_options options;  // as they were given
  mrw_character_skeleton* skeletons;  // all of the file, in its order
  size_t skeleton_count;
  mrw_character_mesh* meshes;  // all of the file, in its order
  size_t mesh_count;
  uint32_t target_count;  // of morph targets, of all meshes
  // Scratch.
  // as many as mrw_character_options.layers
  mrw_blend_layer* blended;
  size_t blended_count;
  mrw_additive_transform* change;  // soa_size() of the largest skeleton
  size_t change_count;
};

// An animation at a time, and how much of it.
typedef struct mrw_animation_layer mrw_animation_layer;
struct mrw_animation_layer {
  const mrw_animation* animation;  // made for the character's file
  float time_s;  // see part playback
  float weight;  // 0 … MRW_MAX_BLEND_WEIGHT; with a mask 0 … 1
  // Empty: the layer is averaged with the others. Else the layer is laid over those and over the masked layers before
  // it, joint by joint, as mrw_overlay() does: a hand waves while the legs walk. The factors are as in mrw_blend_layer;
  // those of several skeletons follow one another, each skeleton's beginning at a multiple of four floats.
  // mrw_mask_below() fills one skeleton's.
  const float* mask;
  size_t mask_count;
  mrw_rigid_step step;  // how its root moves in this frame: for mrw_character_root_step(); poses do not need it
};
void mrw_animation_layer_init(mrw_animation_layer* out);

// Bytes that mrw_make_animations() needs: for each clip an mrw_animation, and 4 bytes for each skeleton and morph
// target. A multiple of 16.
size_t mrw_animations_bytes(const mrw_file* file, const mrw_file* clips);

// Makes animations from clips of `file`, the character's, or of a clip pack. A clip pack has references to skeletons in
// place of skeletons. Each reference is paired with one skeleton that it fits and that no earlier reference has taken:
// the one with its name, else the first. A reference that fits no skeleton is left out: no skeleton plays its clips.
// See mrw_bind_clips().
//
// memory: at least mrw_animations_bytes(), 16-byte aligned; `out` keeps pointers into it and into both files' blocks.
// Errors: MRW_BAD_ARGUMENT (the memory); MRW_MISMATCH (`clips` is another file but no pack, or a pack none of whose
// clips fits a skeleton). Cost: compares names; once a load.
mrw_status mrw_make_animations(const mrw_file* file, const mrw_file* clips, void* memory, size_t memory_bytes,
    mrw_animations* out) MRW_NODISCARD;

// The first animation with this name that moves anything; null if there is none. Cost: compares names.
const mrw_animation* mrw_find_animation(const mrw_animations* animations, const char* name);

// The clip that a skeleton of the character plays in the animation; if that skeleton rests, an empty mrw_clip: no name,
// no tracks, duration 0.
mrw_status mrw_clip_of(const mrw_animation* animation, uint32_t skeleton, mrw_clip* out) MRW_NODISCARD;

// Bytes that mrw_make_character() needs: a multiple of 16, so that the blocks of a crowd may stand back to back.
// May be null: options.
size_t mrw_character_bytes(const mrw_file* file, const mrw_character_options* options);

// A character in its rest pose, finished.
//
// `file`'s block must outlive it. memory: at least mrw_character_bytes(), 16-byte aligned.
// Errors: MRW_BAD_ARGUMENT (the memory, no layers, a default weight that is not finite). Cost: a copy of the vertices
// of meshes with morph targets, and mrw_as_coordinates().
// May be null: options.
mrw_status mrw_make_character(const mrw_file* file, const mrw_character_options* options, void* memory,
    size_t memory_bytes, mrw_character* out) MRW_NODISCARD;

// Samples and blends. Local poses of all skeletons and weights of all morph targets become weighted means of the layers
// without masks, as in mrw_blend(). Without such layers all skeletons are in the rest pose, and all morph targets have
// their default weights. Then layers with masks are laid over the poses. They leave weights of morph targets alone:
// mrw_add_expression() is for those. A clip that is cooked as additive is first added to its reference pose.
//
// Errors: MRW_BAD_ARGUMENT (more layers than the options say, an animation that is null or not made for this file, a
// weight out of range, a time that is not a number, a mask too short); a part of the character may have been written
// then. Cost: mrw_sample(), mrw_blend() and mrw_overlay() of each skeleton, mrw_sample_channels() of what drives morph
// targets.
mrw_status mrw_sample_character(mrw_character* character, const mrw_animation_layer* layers,
    size_t layer_count) MRW_NODISCARD;

// Brings model_from_joint of all skeletons up to date with `local`.
mrw_status mrw_character_to_model(mrw_character* character) MRW_NODISCARD;

// mrw_sample_character(), then mrw_character_to_model(): the pose is ready for inverse kinematics, feet and springs.
// Errors: as mrw_sample_character().
mrw_status mrw_pose_character(mrw_character* character, const mrw_animation_layer* layers,
    size_t layer_count) MRW_NODISCARD;

// Puts a layer where a step of its animation's playback has come to: sets time_s, and `step` by mrw_root_step().
// `after` is `before` after one mrw_advance() with mrw_animation.motion's duration, or both are from
// mrw_follow_phase().
// Errors: MRW_BAD_ARGUMENT (no animation; as mrw_root_step()); nothing is written. Cost: as mrw_root_step().
mrw_status mrw_step_layer(const mrw_playback* before, const mrw_playback* after,
    mrw_animation_layer* layer) MRW_NODISCARD;

// How the layers together move the character, for mrw_move_root(). Steps of layers without masks are averaged, as
// mrw_blend_root_steps() of part root_motion does. Then each layer with a mask, in their order, takes the share weight
// · mask at the hips.
// Errors: MRW_BAD_ARGUMENT (as mrw_pose_character(); a result that is not finite); nothing is written. Cost: some 400
// operations in double precision a layer of weight above 0.
mrw_status mrw_character_root_step(const mrw_character* character, const mrw_animation_layer* layers,
    size_t layer_count, mrw_rigid_step* out) MRW_NODISCARD;

// Adds an expression, such as a face's, to the weights of morph targets: the difference between the animation's weight
// and the default, times `weight`. Call it once for each expression, between mrw_pose_character() and
// mrw_finish_character(). A weight that no channel drives keeps its bits; poses do, too.
//
// Errors: MRW_BAD_ARGUMENT (an animation that is null or not made for this file, a weight out of range, a time that is
// not a number); nothing is written. Cost: mrw_sample_channels() of what drives morph targets.
mrw_status mrw_add_expression(mrw_character* character, const mrw_animation_layer* expression) MRW_NODISCARD;

// Palettes from model_from_joint, and vertices morphed by `weights`; nothing without `skin`.
// Errors: MRW_BAD_ARGUMENT (a weight that is not finite). Cost: mrw_build_palette(), mrw_morph() and
// mrw_morph_coordinates() of each mesh.
mrw_status mrw_finish_character(mrw_character* character) MRW_NODISCARD;

// What one skeleton of an outfit follows.
typedef struct mrw_outfit_skeleton mrw_outfit_skeleton;
struct mrw_outfit_skeleton {
  uint32_t body_skeleton;  // of the body's character
  const uint16_t* body_joints;  // one a joint of the outfit; see mrw_bind_outfit()
  size_t body_joint_count;
};

// How an outfit, hair or clothes in a file of its own, follows the skeletons of a body's file. It serves any number of
// characters.
typedef struct mrw_outfit mrw_outfit;
struct mrw_outfit {
  const mrw_outfit_skeleton* skeletons;  // one a skeleton of the outfit
  size_t skeleton_count;
};

// Bytes that mrw_make_outfit() needs: 24 a skeleton and 2 a joint, on boundaries of 16. A multiple of 16.
size_t mrw_outfit_bytes(const mrw_file* outfit);

// Finds the body's skeleton that each skeleton of an outfit follows: the one with the same name if the outfit's fits
// it, else the first that it fits. An outfit is cooked with `--skeleton BODY`; part outfit says when it fits.
//
// memory: at least mrw_outfit_bytes(), 16-byte aligned; `out` keeps pointers into it. Several outfits may follow one
// body. Errors: MRW_BAD_ARGUMENT (the memory); MRW_MISMATCH if a skeleton fits none, and mrw_bind_outfit() says which
// joints are in the way. Cost: compares names; once a load.
mrw_status mrw_make_outfit(const mrw_file* body, const mrw_file* outfit, void* memory, size_t memory_bytes,
    mrw_outfit* out) MRW_NODISCARD;

// Brings model_from_joint of an outfit's skeletons to the body's pose. Call it once the body is posed, then
// mrw_finish_character(). Joints that only the outfit has are placed by the outfit's `local`, which stays as it is from
// frame to frame. If clips or springs of the outfit move them, a frame is
//
//   mrw_sample_character(outfit, …); mrw_character_follow_body(…); springs; mrw_finish_character(outfit)
//
// mrw_sample_character() without layers puts those joints back to rest. `local` of the body's joints is neither read
// nor written. The outfit drives its own morph targets: by its clips, or the game writes mrw_character_mesh.weights.
//
// worn: made from the outfit's file. Errors: MRW_BAD_ARGUMENT if `outfit` was made for other files. Cost:
// mrw_follow_body() of part outfit for each skeleton.
mrw_status mrw_character_follow_body(const mrw_outfit* outfit, const mrw_character* body,
    mrw_character* worn) MRW_NODISCARD;

// ---- Part animator --------------------------------------------------------------------------------------------------
// Animator: a character's behaviour in two calls, from a graph that `marrow cook --graph` made.
//
//   once a load       mrw_bind_graph
//   once a character  mrw_make_animator
//   every frame       mrw_set_number, mrw_set_flag, fire; mrw_update_animator; mrw_pose_animated; the game's own feet
//                     and springs; mrw_finish_character
//
// mrw_update_animator() decides: times, states, events, root motion. mrw_pose_animated() poses. A server calls only the
// first; results are the same bits. What an animator is in is plain bytes, mrw_animator.state: a snapshot is a copy,
// and mrw_restore_animator() takes it back.
//
// No allocation: memory is the caller's, sizes are asked for first. Thread-safe on different animators; bindings are
// only read, and serve any number of them. What each kind of node does, docs/stages/animator.md says.

// Why a graph does not fit a character.
typedef struct mrw_graph_misfit mrw_graph_misfit;
struct mrw_graph_misfit {
  const char* rule;  // what is not so
  const char* name;  // of what: a clip, a joint or a node
};

// A graph for characters of one file: its clips found, its masks made.
typedef struct mrw_graph_binding mrw_graph_binding;
struct mrw_graph_binding {
  mrw_file file;  // whose graph it is
  mrw_graph graph;  // as it was given
  mrw_file character;  // whose skeletons and meshes it is for
  const mrw_animation* clips;  // one a clip of the graph
  size_t clip_count;
  const mrw_speed_point* points;  // one a point: where it stands, and the time of a cycle of its space
  size_t point_count;
  const float* masks;  // mask after mask, each as mrw_animation_layer.mask
  size_t mask_count;
  const float* hips;  // what a mask leaves of root motion
  size_t hip_count;
  const uint32_t* state_at;  // of a node, in mrw_animator.state
  size_t state_at_count;
  const uint32_t* first_link;  // of a node: of its points, states, or base and pose
  size_t first_link_count;
  uint32_t link_count;  // of all nodes
  uint32_t state_bytes;  // of an animator
  uint64_t hash;  // of the graph
};

// An event of a clip that a step met.
typedef struct mrw_animator_event mrw_animator_event;
struct mrw_animator_event {
  uint32_t id;  // mrw_event_id() of its name
  const char* name;  // as the clip's file has it
  float number;  // as mrw_clip_event has it, here and below
  float time_s;  // in the clip
  float until_s;  // likewise
  uint32_t count;  // how often
  const mrw_animation* animation;  // whose clip it is of
};

// What a step did.
typedef struct mrw_animator_step mrw_animator_step;
struct mrw_animator_step {
  mrw_rigid_step root;  // for mrw_move_root()
  const mrw_animator_event* events;  // in the order of the graph's nodes; until the next update
  size_t event_count;
  uint32_t events_left_out;  // that there was no room for
};
void mrw_animator_step_init(mrw_animator_step* out);

// What an animator is made for.
typedef struct mrw_animator_options mrw_animator_options;
struct mrw_animator_options {
  bool poses;  // false: it is only updated; a fade that is inertial is none then
  uint32_t events;  // of a step, at most
  uint32_t seed;  // of what happens by chance
  float least_loudness;  // Of clips that are shown less than that, events are left out. 0 … 1
};
void mrw_animator_options_init(mrw_animator_options* out);

typedef struct mrw_animator_scratch mrw_animator_scratch;

// An instance of a graph. Views into the caller's memory; a copy is the same animator.
typedef struct mrw_animator mrw_animator;
struct mrw_animator {
  const mrw_graph_binding* binding;  // as it was given
  void* state;  // what it is in: plain bytes, without pointers
  size_t state_bytes;
  mrw_animator_scratch* scratch;  // its own
};

// A pose that the game gives a node, of one skeleton.
typedef struct mrw_given_pose mrw_given_pose;
struct mrw_given_pose {
  const mrw_soa_transform* local;  // at least mrw_skeleton_soa_size(skeleton); empty: at rest
  size_t local_count;
};

// Bytes that mrw_bind_graph() needs. A multiple of 16.
size_t mrw_graph_binding_bytes(const mrw_graph* graph, const mrw_file* character);

// Finds a graph's clips among animations that are made for the character's file, the first of each name, and makes its
// masks.
//
// file: the graph's, for its names; also the character's, or a graph pack. memory: at least mrw_graph_binding_bytes(),
// 16-byte aligned; `out` keeps pointers into it, into the animations and into both files' blocks.
// Errors: MRW_BAD_ARGUMENT (the memory, a null list); MRW_BAD_DATA if the graph breaks a rule of its format;
// MRW_MISMATCH if a clip is missing, a joint of a mask is, or clips of a space do not go together; `misfit`, if not
// null, says which. Cost: compares names; once a load.
// May be null: misfit.
mrw_status mrw_bind_graph(const mrw_file* file, const mrw_graph* graph, const mrw_file* character,
    const mrw_animations* animations, size_t animation_count, void* memory, size_t memory_bytes, mrw_graph_binding* out,
    mrw_graph_misfit* misfit) MRW_NODISCARD;

// The number of an event's name: 32 bits by FNV-1a. May be computed while compiling.
uint32_t mrw_event_id(const char* name);

// Bytes that mrw_make_animator() needs. A multiple of 16.
// May be null: options.
size_t mrw_animator_bytes(const mrw_graph_binding* binding, const mrw_animator_options* options);

// An animator before its first update. memory: at least mrw_animator_bytes(), 16-byte aligned. The binding outlives it.
// Errors: MRW_BAD_ARGUMENT (the memory).
// May be null: options.
mrw_status mrw_make_animator(const mrw_graph_binding* binding, const mrw_animator_options* options, void* memory,
    size_t memory_bytes, mrw_animator* out) MRW_NODISCARD;

// Index of the first parameter of the graph with this name, or graph.parameter_count; of the first node, or
// graph.node_count; of a machine's state, or MRW_NO_INDEX. Cost: compares names; once a load.
uint32_t mrw_find_parameter(const mrw_graph_binding* binding, const char* name);
uint32_t mrw_find_graph_node(const mrw_graph_binding* binding, const char* name);
uint32_t mrw_find_state(const mrw_graph_binding* binding, uint32_t node, const char* name);

// Sets a number, which is clamped to its range; a flag; a trigger, which stays set until a transition takes it, or its
// time is over. Errors: MRW_BAD_ARGUMENT if there is no such parameter of that kind, or the value is no number.
mrw_status mrw_set_number(mrw_animator* animator, uint32_t parameter, float value) MRW_NODISCARD;
mrw_status mrw_set_flag(mrw_animator* animator, uint32_t parameter, bool value) MRW_NODISCARD;
mrw_status mrw_fire_trigger(mrw_animator* animator, uint32_t parameter) MRW_NODISCARD;

// What a parameter is set to: a flag to 0 or 1, a trigger to 1 while it waits. 0 if there is no such parameter.
float mrw_value_of(const mrw_animator* animator, uint32_t parameter);

// What a machine is in: a state of that node, and for how long; MRW_NO_INDEX if the node is no machine, or is not
// shown.
uint32_t mrw_state_of(const mrw_animator* animator, uint32_t node, float* seconds);

// Moves on by dt_s ≥ 0 seconds: parameters, then machines, then clips.
//
// Errors: MRW_BAD_ARGUMENT if dt_s is not finite or below 0; MRW_BAD_DATA if the state's bytes are none of this graph,
// or a clip breaks a rule of part clip_motion. The animator may have moved on in part then. Cost: in proportion to the
// nodes that are shown.
mrw_status mrw_update_animator(mrw_animator* animator, float dt_s, mrw_animator_step* out) MRW_NODISCARD;

// Takes a snapshot back, a copy of mrw_animator.state: of this animator, or of another of the same binding.
// Errors: MRW_BAD_DATA if the bytes are not of this graph, or have what no animator has; nothing is changed.
mrw_status mrw_restore_animator(mrw_animator* animator, const void* snapshot, size_t snapshot_bytes) MRW_NODISCARD;

// Poses as mrw_sample_animated(), and weights of morph targets, by what the animator is in.
//
// The character is of the binding's file, and holds as many layers as the graph's first node says it needs poses
// (mrw_graph_node.poses); with more, more of what is sampled is kept from frame to frame. given: for each
// given node one a skeleton, in their order; where the list ends nodes are at rest.
// Errors: MRW_BAD_ARGUMENT (a character of another file, or of too few layers; a given pose that is too short; an
// animator before its first update); MRW_BAD_DATA as mrw_update_animator(). Cost: mrw_sample_cached() of each clip that
// is shown, and mrw_blend(), mrw_overlay() and mrw_add() of them. Layers in model space write over
// mrw_pose.model_from_joint.
mrw_status mrw_sample_animated(mrw_character* character, mrw_animator* animator, const mrw_given_pose* given,
    size_t given_count) MRW_NODISCARD;

// The same, then mrw_local_to_model(): ready for inverse kinematics, feet and springs.
mrw_status mrw_pose_animated(mrw_character* character, mrw_animator* animator, const mrw_given_pose* given,
    size_t given_count) MRW_NODISCARD;

#ifdef __cplusplus
}
#endif
#endif
