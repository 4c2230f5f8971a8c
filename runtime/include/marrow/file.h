// Load: one validated block of memory, seen as skeletons, clips and meshes.
#pragma once

#include "marrow/api.h"
#include "marrow/pose.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

// Limits that every valid file keeps, so that a caller can bound its memory by them.
inline constexpr std::uint32_t kMaxJoints = 32767;
// The most palette entries that a vertex follows.
inline constexpr std::uint32_t kMaxInfluences = 8;
// No joint: in Skeleton::parents a root.
inline constexpr std::uint16_t kNoJoint = 0xFFFF;
// No clip: a skeleton rests.
inline constexpr std::uint32_t kNoClip = 0xFFFFFFFF;
// In Geometry::source_slots: a vertex of no triangle.
inline constexpr std::uint32_t kNoSlot = 0xFFFFFFFF;

// The shape of a JointLimit: which rotations it allows.
enum class LimitKind : std::uint8_t {
  none,   // turns freely; for joints that have a rate limit alone
  hinge,  // about one axis, between two angles: knees, elbows, fingers
  cone,   // swing inside an elliptic cone, twist between two angles: necks, shoulders, hips
  euler,  // three angles about three axes, each within its own range: for rigs with Euler-angle limits
};

// The order of the product, first letter first: xyz is Rx · Ry · Rz. Applied to a vector, z comes first.
enum class AxisOrder : std::uint8_t { xyz, xzy, yxz, yzx, zxy, zyx };

// Angles from middle - half_width to middle + half_width, both as the tangent of a quarter of the angle, so that a
// clamp needs no trigonometry: half an angle has the sine 2 t / (1 + t²) and the cosine (1 - t²) / (1 + t²). See
// angle_range() in limits.h.
struct AngleRange {
  float middle = 0;      // -1 … 1: -180° … 180°
  float half_width = 0;  // 0 … 1; 1: any angle
};

// The highest speed and acceleration; 0: no limit. In radians for rotations, in metres for points.
struct RateLimit {
  float speed = 0;         // rad/s or m/s
  float acceleration = 0;  // rad/s² or m/s²
};

// How far and how fast a joint may turn, as it lies in a cooked file; make one with make_limit(), see limits.h.
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
// At a swing of 180° the twist is undefined: the smallest step leads to any twist. See clamp_rotation().
struct JointLimit {
  std::uint16_t joint = 0;                    // of the skeleton
  LimitKind kind = LimitKind::none;           // which of the shapes above
  AxisOrder order = AxisOrder::xyz;           // of euler; else xyz
  float limit_from_parent[4] = {0, 0, 0, 1};  // unit quaternion
  float joint_from_limit[4] = {0, 0, 0, 1};   // unit quaternion
  AngleRange angles[3] = {};  // of a cone the middles of the second and third are 0; of a hinge both are 0
  RateLimit rate = {};        // of the local rotation, see follow_pose()
};
static_assert(sizeof(JointLimit) == 68);

// Whether a limit keeps these rules. Limits from make_limit() and load() do.
MARROW_API bool is_valid(const JointLimit& limit);

// A joint that swings. Its bone goes from the joint to the next joint of its chain. See springs.h.
struct SpringJoint {
  std::uint16_t joint = 0;      // of the skeleton
  std::uint16_t most_pull = 0;  // 1/s², torque over inertia: the spring turns its bone no harder; 0: without a limit
  float frequency_hz = 2.0f;    // 0 … 15: of small swings about the animated direction, undamped and without gravity
  float damping_ratio = 0.5f;   // 0 … 1.5: 0 swings for ever, 1 comes to rest soonest without passing
  float gravity = 1.0f;         // -10 … 10, times SpringFrame::gravity
  float drag = 0.0f;            // 0 … 50 1/s: how strongly air slows the bone's end, and wind carries it
  float radius_m = 0.0f;        // ≥ 0: of a sphere about the bone's end, which stays out of colliders; world
  float weight = 1.0f;          // 0 … 1: how much of the swing is shown; the swing itself goes on at 0, too
};
static_assert(sizeof(SpringJoint) == 28);

// A chain of joints, each a descendant of the one before it. A joint belongs to at most one chain.
struct SpringChain {
  Span<const SpringJoint> joints = {};  // from the chain's root to its end
  float tip[3] = {0, 0, 0};  // end of the last joint's bone, in that joint's space; 0: that joint only ends the chain
  std::uint64_t colliders = ~std::uint64_t{0};  // bit i, lowest first: the chain stays out of SpringFrame::colliders[i]
};

// A capsule that moves with a joint; a sphere where both ends are one point. Its radius is scaled by the largest of the
// scales along the joint's axes.
struct SpringCollider {
  std::uint16_t joint = 0;  // the joint that it moves with
  std::uint16_t reserved = 0;
  float from[3] = {0, 0, 0}, to[3] = {0, 0, 0};  // in the joint's space
  float radius_m = 0.1f;                         // in the joint's space
};
static_assert(sizeof(SpringCollider) == 32);

inline constexpr std::size_t kMaxSpringColliders = 64;  // as many as SpringChain::colliders has bits

// The joints of one character or prop, which its meshes and clips share: a forest in breadth-first order, so a parent
// comes before its children and the roots come first.
struct Skeleton {
  const char* name = "";                    // as the source calls it; never null
  std::uint32_t joint_count = 0;            // 1 … kMaxJoints
  std::uint32_t root_count = 0;             // joints 0 … root_count-1 have no parent joint
  const Affine* model_from_root = nullptr;  // root_count; the transform above each root, which never changes
  const SoaTransform* rest = nullptr;       // soa_count(joint_count); the pose of joints that a clip leaves alone
  const std::uint16_t* parents = nullptr;   // joint_count; kNoJoint for roots
  const std::uint32_t* names = nullptr;     // joint_count; see File::text
  Span<const JointLimit> limits = {};       // the asset's own limits, ascending by joint

  // How many groups of four joints a local pose has.
  std::size_t soa_size() const { return soa_count(joint_count); }
};

// The skeleton that clips of a clip pack were made for; a pack holds references instead of skeletons. See clip_pack.h.
struct SkeletonReference {
  const char* name = "";                       // the skeleton's
  std::uint32_t joint_count = 0;               // the skeleton's
  std::uint64_t hash = 0;                      // skeleton_hash() of the skeleton
  const std::uint32_t* names = nullptr;        // joint_count; see File::text
  const std::uint32_t* rest_hashes = nullptr;  // joint_count; of each joint's rest pose
  const std::uint16_t* parents = nullptr;      // joint_count; kNoJoint for roots
};

// Which part of a local transform a Track drives.
enum class TrackPath : std::uint8_t { translation, rotation, scale };
// What lies between two keys, as glTF 2.0 defines it.
enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

// One channel of a clip stored without loss: the source's own keys at the source's own times.
struct Track {
  std::uint16_t joint = 0;                            // of the skeleton
  TrackPath path = TrackPath::translation;            // what of the joint it drives
  Interpolation interpolation = Interpolation::step;  // between its keys
  std::uint32_t key_count = 0;                        // ≥ 1
  std::uint32_t first_time = 0;                       // into Clip::times_s; tracks with the same keys share them
  // Into Clip::values; 3 or 4 floats a key, thrice that for cubic_spline (in, value, out).
  std::uint32_t first_value = 0;
};
static_assert(sizeof(Track) == 16);

// For a group of four joints: which sub-tracks (a joint's rotation, translation or scale) move in a clip, and which
// hold one value that is not the rest pose's. Bits 0-3 are rotations, 4-7 translations, 8-11 scales; the lowest bit is
// the first joint.
struct GroupMasks {
  std::uint16_t moving = 0;    // sub-tracks that change over the clip
  std::uint16_t constant = 0;  // sub-tracks that hold one value, not the rest pose's
};
static_assert(sizeof(GroupMasks) == 4);

// A number over time, such as a morph target's weight or a property of the game; it moves no joint. Stored without
// loss, except that keys on a straight line between others may have been left out (docs/cooking/clips.md).
struct Channel {
  std::uint32_t name = 0;         // see File::text
  float rest = 0;                 // the number where no clip drives it
  std::uint32_t key_count = 0;    // ≥ 1
  std::uint32_t first_time = 0;   // as in Track
  std::uint32_t first_value = 0;  // into Clip::values; one float a key, three for cubic_spline (in, value, out)
  Interpolation interpolation = Interpolation::step;  // between its keys
  std::uint8_t reserved[3] = {};
};
static_assert(sizeof(Channel) == 24);
// No channel.
inline constexpr std::uint32_t kNoChannel = 0xFFFFFFFF;

// Tracks compressed within a stated error (docs/format.md): poses at even steps of time, or at times of their own. They
// are divided into segments of packed integers, relative to the rest pose. What does not move is stored once.
struct CodedTracks {
  std::uint32_t frame_count = 0;                   // 0: the clip has no coded tracks; else ≥ 2
  std::uint32_t track_count = 0;                   // sub-tracks that move
  std::uint32_t constant_count = 0;                // sub-tracks that hold one value, not the rest pose's
  std::uint32_t segment_intervals = 0;             // time steps in a segment; the last may have fewer
  float start_s = 0;                               // of frame 0
  float frames_per_s = 0;                          // the mean rate where steps are uneven
  const float* times_s = nullptr;                  // frame_count, ascending; null: even steps
  const GroupMasks* masks = nullptr;               // one a group of four joints
  const std::uint32_t* segment_offsets = nullptr;  // bytes into payload
  const std::byte* constants = nullptr;            // their values
  const std::byte* payload = nullptr;              // segments of packed integers

  // Seconds of a frame.
  float time_of(std::uint32_t frame) const {
    return times_s != nullptr ? times_s[frame] : start_s + static_cast<float>(frame) / frames_per_s;
  }
};

// An animation of one skeleton, and of numbers. Joints without a track keep their rest pose.
struct Clip {
  const char* name = "";                    // as the source calls it; never null
  std::uint32_t skeleton = 0;               // which skeleton of the file; in a clip pack, which reference
  std::uint32_t joint_count = 0;            // of that skeleton
  float duration_s = 0;                     // time of the last key; ≥ 0
  bool additive = false;                    // for sample_additive(), not for sample()
  const SoaTransform* reference = nullptr;  // additive: the pose that changes are relative to; null: the rest pose
  CodedTracks coded = {};                   // what is compressed
  Span<const Track> tracks = {};            // what is stored without loss
  Span<const Channel> channels = {};        // numbers that it drives
  const float* times_s = nullptr;           // key times of tracks and channels, seconds
  const float* values = nullptr;            // keys of tracks and channels
  std::uint64_t id = 0;  // of its bytes and its place in the file, from File::clip(); 0: made by hand
};

// Consecutive vertices that depend on the same joints. Each run starts a new block of four vertices; the slots that
// fill up its last block repeat its last vertex.
struct Run {
  std::uint32_t vertex_count = 0;  // ≥ 1
  std::uint32_t influences = 0;    // 1 … kMaxInfluences
};
static_assert(sizeof(Run) == 8);

// Which attributes a morph target changes.
enum MorphAttributes : std::uint32_t { kMorphsPositions = 1, kMorphsNormals = 2, kMorphsTangents = 4 };
// What a morph target adds to the vertices of the blocks that it moves; other blocks it leaves alone. Each block has a
// record for each attribute, in the order of MorphAttributes: twelve integers dx[4] dy[4] dz[4]. An integer times the
// attribute's step is the change.
struct MorphTarget {
  std::uint32_t first_block = 0;   // into Geometry::target_blocks
  std::uint32_t block_count = 0;   // how many blocks it moves
  std::uint32_t first_record = 0;  // into Geometry::target_records
  std::uint32_t attributes = 0;    // kMorphsPositions | …; 0 if it moves nothing
  float position_step = 0;         // metres, mesh space
  float normal_step = 0;           // the change that 1 in a record of normals means
  float tangent_step = 0;          // the change that 1 in a record of tangents means
  std::uint32_t reserved = 0;
};
static_assert(sizeof(MorphTarget) == 32);

// The most examples of a PoseSpace.
inline constexpr std::uint32_t kMaxPoseExamples = 32;
// Example poses for pose-space deformation, and for each example the deltas of the blocks that it moves. They are added
// to the bind pose, see skin_psd() in skin.h.
struct PoseSpace {
  float sigma = 0;                          // width of the Gaussian, as the sine of half an angle
  Span<const MorphTarget> examples = {};    // positions alone; empty: none
  const void* blocks = nullptr;             // as Geometry::target_blocks
  const std::int16_t* records = nullptr;    // as Geometry::target_records
  const std::int16_t* rotations = nullptr;  // for each example and palette entry a quaternion x y z w, of any length
  const std::uint16_t* parents = nullptr;   // the entry that each entry's rotation is relative to, or kNoJoint
};

// Triangles and bind-pose vertices. Vertices live in *slots*: blocks of four, laid out for the skinning kernels
// (`k` is the run's influence count). The arrays of blocks begin on 16-byte boundaries.
struct Geometry {
  std::uint32_t slot_count = 0;           // vertices with padding; a multiple of 4
  std::uint32_t vertex_count = 0;         // without padding
  std::uint32_t index_count = 0;          // 3 a triangle; counter-clockwise fronts
  std::uint32_t index_bytes = 2;          // 2 or 4
  std::uint32_t joint_count = 0;          // how many palette entries the sets refer to
  const void* indices = nullptr;          // slots
  Span<const Run> runs = {};              // in the order of the slots
  const std::uint16_t* sets = nullptr;    // for each run its k palette entries, run after run
  const float* skin = nullptr;            // a block: x[4] y[4] z[4], then k-1 times w[4]; the last weight is 1 - Σ
  const float* normals = nullptr;         // a block: x[4] y[4] z[4]; unit; null if absent
  const float* tangents = nullptr;        // a block: x[4] y[4] z[4] sign[4]; unit; null if absent
  const float* as_residual = nullptr;     // a block: k times dx[4] dy[4] dz[4] dw[4]; null: the lift, all zero
  const float* mwe_residual = nullptr;    // a block: k times three rows x[4] y[4] z[4] t[4]; null if absent
  std::uint32_t mwe_root = 0;             // palette entry in whose frame mwe_residual is meant
  const float* uvs = nullptr;             // a slot: u v; null if absent
  const std::uint8_t* colours = nullptr;  // a slot: r g b a, linear; null if absent
  // The slot of each source vertex, if cooked with --keep-vertex-order. kNoSlot: no triangle of this mesh uses the
  // vertex; of a primitive that was split into parts, no triangle of this part.
  Span<const std::uint32_t> source_slots = {};
  Span<const MorphTarget> targets = {};          // morph targets, as many as MeshTarget of a mesh
  const void* target_blocks = nullptr;           // as wide as indices; for each target the blocks it moves, ascending
  const std::int16_t* target_records = nullptr;  // twelve a record
  PoseSpace pose_space = {};                     // examples empty: none
  float box_min[3] = {};                         // of the bind positions, mesh space
  float box_max[3] = {};                         // likewise
};

// A morph target of a mesh: what it is called and what drives it.
struct MeshTarget {
  std::uint32_t name = 0;  // see File::text; may be empty
  // Name of the channel by which clips drive its weight; see find_weight_channels() in morph.h.
  std::uint32_t channel = 0;
  float weight = 0;  // its weight where no clip drives it
};
static_assert(sizeof(MeshTarget) == 12);

// In Mesh::material_index: the source says no more of the material than the Mesh itself holds.
inline constexpr std::uint32_t kNoMaterial = 0xFFFFFFFF;
// How a material's alpha is meant, as in glTF 2.0.
enum class AlphaMode : std::uint8_t { opaque, mask, blend };
// Which property of a material an image supplies.
enum class TextureRole : std::uint8_t {
  base_colour,
  metallic_roughness,
  normal,
  occlusion,
  emissive,
  specular_glossiness  // KHR_materials_pbrSpecularGlossiness; its diffuse colour and texture are the base colour
};
// What lies beyond an image's edge.
enum class Wrap : std::uint8_t { repeat, clamp_to_edge, mirrored_repeat };
// How an image is magnified.
enum class MagFilter : std::uint8_t { any, nearest, linear };  // any: the source leaves it to the game
// How an image is minified; any: the source leaves it to the game.
enum class MinFilter : std::uint8_t {
  any,
  nearest,
  linear,
  nearest_mipmap_nearest,
  linear_mipmap_nearest,
  nearest_mipmap_linear,
  linear_mipmap_linear,
};

// An image in a role; its channels are as in glTF 2.0, section 3.9. Base colour, emissive and specular-glossiness
// images are sRGB (the last except for alpha), all others linear. UV (0, 0) is the image's upper left corner.
struct Texture {
  std::uint16_t image = 0;                            // which image of the file
  TextureRole role = TextureRole::base_colour;        // none twice in a material
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;  // along u and v
  MagFilter mag = MagFilter::any;                     // as the source asks
  MinFilter min = MinFilter::any;                     // as the source asks
  std::uint8_t reserved = 0;
};
static_assert(sizeof(Texture) == 8);

// What a material has beyond the members of Mesh.
struct Material {
  const char* name = "";                // as the source calls it; never null
  AlphaMode alpha = AlphaMode::opaque;  // opaque: alpha is not looked at
  float alpha_cutoff = 0.5f;            // mask: what is less opaque is not drawn
  bool unlit = false;                   // KHR_materials_unlit: the base colour is what is seen
  float emissive[3] = {0, 0, 0};      // linear RGB ≥ 0, may be above 1: factor times strength, and times its texture
  Span<const Texture> textures = {};  // one a role
};

// No image.
inline constexpr std::uint32_t kNoImage = 0xFFFFFFFF;
// What an image's bytes are.
enum class ImageFormat : std::uint8_t { unknown, png, jpeg, webp, ktx2, dds };
// A picture, by reference or as the source's own bytes. Marrow does not check the bytes; whoever decodes them must.
struct Image {
  const char* name = "";  // as the source calls it; never null
  const char* uri = "";   // relative to the source file and percent-encoded, as it stood there; empty if it had none
  ImageFormat format = ImageFormat::unknown;  // unknown: neither its bytes nor its URI tell which
  Span<const std::byte> bytes = {};           // empty: by reference
  std::uint32_t fallback = kNoImage;          // of WebP, KTX2 and DDS: which PNG or JPEG image shows the same
};

// What a Property is.
enum class PropertyType : std::uint8_t { number, boolean, text };
// A number, boolean or text that an artist attached to a node.
struct Property {
  std::uint32_t name = 0;                    // see File::text; a nested property has its path, as in "door/hinges/0"
  PropertyType type = PropertyType::number;  // which of the two members below holds it
  std::uint8_t reserved[3] = {};
  union {
    double number = 0;   // finite; a boolean is 1 or 0
    std::uint32_t text;  // see File::text
  };
};
static_assert(sizeof(Property) == 16);

// A node of the source that is kept although it may be no joint: a socket, a locator. Its place in model space is
// model_from_joint[joint] · joint_from_node, or joint_from_node alone without a joint.
struct Node {
  const char* name = "";                    // as the source calls it; never empty
  std::uint32_t skeleton = 0;               // which skeleton of the file
  std::uint16_t joint = kNoJoint;           // the nearest joint at or above it
  const Affine* joint_from_node = nullptr;  // never changes
  Span<const Property> properties = {};     // the `extras` of the source
};

// A palette entry that blends those of two joints, for vertices that follow both: see build_palette().
struct Helper {
  std::uint16_t first = 0, second = 0;  // palette entries, below Mesh::joint_count, not the same
  float share = 0;                      // of second; above 0, below 1
};
static_assert(sizeof(Helper) == 8);

// A level of detail: another geometry over the same palette.
struct MeshLod {
  std::uint32_t geometry = 0;  // which of the file
  float error_m = 0;           // the farthest that a vertex of the full mesh is from it, in the clips it was made with
};
static_assert(sizeof(MeshLod) == 8);

// A box and a sphere about the box's centre; both contain the same vertices. Model space, metres.
struct Bounds {
  float box_min[3] = {0, 0, 0};  // least corner
  float box_max[3] = {0, 0, 0};  // greatest corner
  float radius_m = -1;           // below 0: empty, or not known

  // Whether it contains nothing, or is not known.
  bool is_empty() const { return radius_m < 0; }
  // The box's centre along an axis, 0 to 2: the sphere's, too.
  float centre(int axis) const { return box_min[axis] + (box_max[axis] - box_min[axis]) * 0.5f; }
};

// Geometry bound to joints. A mesh hung rigidly on a node is bound to one joint with weight 1.
struct Mesh {
  const char* name = "";                       // as the source calls it; never null
  const char* material = "";                   // the material's name; never null
  std::uint32_t material_index = kNoMaterial;  // which material of the file, if that has more than this Mesh
  std::uint32_t skeleton = 0;                  // which skeleton of the file
  std::uint32_t geometry_index = 0;            // meshes with the same number share their geometry
  std::uint32_t joint_count = 0;               // palette entries that are joints
  const std::uint16_t* joints = nullptr;       // joint_count; palette entry → joint of the skeleton
  const Affine* inverse_bind = nullptr;        // joint_count; joint_from_mesh in the bind pose
  float base_colour[4] = {1, 1, 1, 1};         // linear RGBA
  bool double_sided = false;                   // backs are drawn, too
  // Another part of the same source primitive as the mesh before it: one palette was too small for the whole. Only the
  // source's vertex order depends on this, see Geometry::source_slots.
  bool is_next_part = false;
  Span<const Helper> helpers = {};        // palette entries behind those of the joints
  Span<const float> helper_centres = {};  // three a helper, or none: see build_palette()
  Span<const MeshTarget> targets = {};    // as many as the geometry's
  Span<const MeshLod> lods = {};          // levels 1, 2, …, ever coarser; level 0 is the mesh in full
  Geometry geometry = {};                 // of the level asked for

  // How many matrices build_palette() writes.
  std::uint32_t palette_size() const { return joint_count + static_cast<std::uint32_t>(helpers.size); }
};

struct ExampleSpace;

// A cooked file in memory. Cheap to copy; holds pointers into the block, which must outlive it and stay unchanged.
class File {
 public:
  // How many of each there are.
  std::uint32_t skeleton_count() const { return counts_[0]; }
  std::uint32_t reference_count() const { return counts_[1]; }  // 0 except in clip packs, which have no skeletons
  std::uint32_t clip_count() const { return counts_[2]; }
  std::uint32_t mesh_count() const { return counts_[4]; }
  std::uint32_t material_count() const { return counts_[5]; }
  std::uint32_t image_count() const { return counts_[6]; }
  std::uint32_t node_count() const { return counts_[7]; }

  // An index at or above the count returns an empty object. Cost: a few loads.
  MARROW_API Skeleton skeleton(std::uint32_t index) const;
  MARROW_API SkeletonReference reference(std::uint32_t index) const;
  MARROW_API Clip clip(std::uint32_t index) const;
  MARROW_API Material material(std::uint32_t index) const;
  MARROW_API Image image(std::uint32_t index) const;
  MARROW_API Node node(std::uint32_t index) const;
  // level: of detail; 0 is the full mesh, and a level beyond the mesh's last returns the last. All levels share one
  // palette.
  MARROW_API Mesh mesh(std::uint32_t index, std::uint32_t level = 0) const;
  // Contains the mesh's vertices while the clip plays from the rest pose: at every level of detail, by every deformer
  // that the mesh was cooked for. Empty if the clip does not move the mesh's skeleton, and in files without bounds.
  // Stored as codes of 8 bits, rounded outwards: a face may be 1/64 of the box's farthest coordinate beyond the
  // vertices. For clips of a clip pack there are none; see palette_bounds() in bounds.h. Cost: a look at every clip and
  // mesh; once a load.
  MARROW_API Bounds bounds(std::uint32_t clip, std::uint32_t mesh) const;

  // The asset's spring bones for one of the skeletons: chains for make_springs(), and colliders for SpringFrame. A game
  // may copy them and change their settings. Cost: a look at every section of springs.
  MARROW_API std::uint32_t spring_count(std::uint32_t skeleton) const;
  MARROW_API SpringChain spring(std::uint32_t skeleton, std::uint32_t index) const;
  MARROW_API Span<const SpringCollider> spring_colliders(std::uint32_t skeleton) const;

  // Spaces of example shapes, see example_space.h. load() only locates them; example_space() checks all that one holds.
  // Spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported, with
  // `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
  std::uint32_t example_space_count() const { return counts_[12]; }
  MARROW_API Status example_space(std::uint32_t index, ExampleSpace& out, DataError* error = nullptr) const;

  // Index of the first skeleton with this name, or skeleton_count(). Here and below a null pointer names nothing.
  MARROW_API std::uint32_t find_skeleton(const char* name) const;
  // The first joint of `skeleton`, a skeleton of this file, with this name, or skeleton.joint_count. Once a load, not a
  // frame.
  MARROW_API std::uint32_t find_joint(const Skeleton& skeleton, const char* name) const;
  // Index of the first mesh with this name, or mesh_count(). A source mesh with several materials is one Mesh for each,
  // all of the same name.
  MARROW_API std::uint32_t find_mesh(const char* name) const;
  // Index of the first clip with this name, or clip_count(). With `skeleton` only clips that move that skeleton are
  // searched. An animation of several skeletons is one clip for each, all with the same name and duration.
  MARROW_API std::uint32_t find_clip(const char* name) const;
  MARROW_API std::uint32_t find_clip(const char* name, std::uint32_t skeleton) const;
  // Index of the first channel of `clip`, a clip of this file, with this name, or clip.channels.size. Once a load, not
  // a frame.
  MARROW_API std::uint32_t find_channel(const Clip& clip, const char* name) const;
  // Index of the first node with this name, or node_count().
  MARROW_API std::uint32_t find_node(const char* name) const;
  // The property of `node`, a node of this file, with this name; null if there is none.
  MARROW_API const Property* node_property(const Node& node, const char* name) const;
  // The name with this number (Skeleton::names, Channel::name, Property::name); empty if there is none. UTF-8,
  // zero-terminated, never null.
  MARROW_API const char* text(std::uint32_t name) const;

  // For tools: the sections as they stand in the file.
  struct Section {
    std::uint32_t type = 0;    // four characters, first in the lowest byte
    std::uint32_t offset = 0;  // from the block's begin
    std::uint32_t bytes = 0;   // without padding
    std::uint32_t codec = 0;   // 0: none
  };
  // In the order of the file.
  Span<const Section> sections() const { return sections_; }

 private:
  friend Status load(Span<const std::byte>, File&, DataError*);
  Geometry geometry(std::uint32_t index) const;
  const std::byte* section(std::uint32_t kind, std::uint32_t index) const;
  const std::byte* springs_of(std::uint32_t skeleton) const;  // null: none

  const std::byte* block_ = nullptr;
  Span<const Section> sections_ = {};
  std::uint32_t first_[13] = {};  // first section of each kind, in the order of format::Kind
  std::uint32_t counts_[13] = {};
};

// Validates a cooked file (docs/format.md) and makes `out` a view of it.
//
// The block must be 16-byte aligned (bad_argument otherwise; block.h helps) and may come from anywhere. Nothing is read
// outside it, whatever it holds. After `ok`, nothing that it holds can make another stage read or write out of bounds.
// Numbers of matrices, translations and scales are at most 1e12, and rotations are unit quaternions. So the product of
// a root's model_from_root, one joint and an inverse bind is finite; along a long chain of huge scales it need not be.
// Names are at most 2047 bytes. `out` is written only on success. `error`, if not null, gets the place and the broken
// rule on failure. Cost: one pass over the block; no allocation. Thread-safe.
MARROW_API Status load(Span<const std::byte> block, File& out, DataError* error = nullptr);

}  // namespace marrow
