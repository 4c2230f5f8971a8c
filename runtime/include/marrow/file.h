// Load: one validated block of memory, seen as skeletons, clips and meshes.
#pragma once

#include "marrow/api.h"
#include "marrow/clip.h"
#include "marrow/material.h"
#include "marrow/mesh.h"
#include "marrow/pose.h"
#include "marrow/skeleton.h"
#include "marrow/span.h"
#include "marrow/status.h"

namespace marrow {

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

struct ClipMotion;
struct ExampleSpace;
struct Graph;
struct PoseMap;
struct Roles;

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

  // Which joints of one of the skeletons are its feet, its head and so on; see roles.h. Points into the block. Empty if
  // nothing is known. Cost: a look at every section of roles.
  MARROW_API Roles roles(std::uint32_t skeleton) const;

  // What a clip does, as far as the cooker has measured it or was told; see clip_motion.h. Points into the block. A
  // clip of which nothing is known has its duration and nothing else. Cost: a look at the sections of motion; once a
  // load.
  MARROW_API ClipMotion motion(std::uint32_t clip) const;

  // How one of the skeletons takes poses of another rig, see pose_map.h. Points into the block. An index at or above
  // the count returns an empty one. Cost: a few loads.
  std::uint32_t pose_map_count() const { return counts_[15]; }
  MARROW_API PoseMap pose_map(std::uint32_t index) const;

  // Spaces of example shapes, see example_space.h. load() only locates them; example_space() checks all that one holds.
  // Spans point into the block. Errors: bad_argument if there is none with the index; bad_data or unsupported, with
  // `error`, if not null, saying where and why. `out` is written only on success. Cost: one pass; once a load.
  std::uint32_t example_space_count() const { return counts_[12]; }
  MARROW_API Status example_space(std::uint32_t index, ExampleSpace& out, DataError* error = nullptr) const;

  // Graphs of behaviour, see graph.h. load() only locates them; graph() checks all that one holds. Spans point into the
  // block. Errors and cost: as example_space().
  std::uint32_t graph_count() const { return counts_[16]; }
  MARROW_API Status graph(std::uint32_t index, Graph& out, DataError* error = nullptr) const;

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
  // Index of the first event of `motion`, a motion of this file, with this name, or motion.events.size. Once a load,
  // not a frame: several events may have one name, so a frame compares ClipEvent::name.
  MARROW_API std::uint32_t find_event(const ClipMotion& motion, const char* name) const;
  // Index of the first pose map of a rig with this name, or pose_map_count().
  MARROW_API std::uint32_t find_pose_map(const char* name) const;
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
  std::uint32_t first_[17] = {};  // first section of each kind, in the order of format::Kind
  std::uint32_t counts_[17] = {};
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
