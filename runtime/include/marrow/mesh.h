// Vertices, triangles and what they hang on, as a file has them.
#pragma once

#include "marrow/api.h"
#include "marrow/material.h"
#include "marrow/pose.h"
#include "marrow/span.h"

namespace marrow {

// The most palette entries that a vertex follows.
inline constexpr std::uint32_t kMaxInfluences = 8;
// In Geometry::source_slots: a vertex of no triangle.
inline constexpr std::uint32_t kNoSlot = 0xFFFFFFFF;

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

}  // namespace marrow
