// The scene as the cooked file will have it: what the build stage yields and the writer lays out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "asset/format.h"
#include "common/aligned_bytes.h"
#include "cook/scene/raw.h"
#include "marrow/clip_motion.h"
#include "marrow/file.h"
#include "marrow/graph.h"
#include "marrow/pose_map.h"
#include "marrow/roles.h"

namespace marrow::cook {

// The joint at or above a node, and what lies between, which never moves.
struct NearestJoint {
  int skeleton = kNone;
  int joint = kNone;  // of that skeleton; kNone: none above; the matrix is from the scene then
  glm::dmat4 joint_from_node{1.0};
};

// As a SPRI section has it.
struct BuiltSprings {
  std::vector<format::SpringRecord> chains;
  std::vector<SpringJoint> joints;  // chain by chain
  std::vector<SpringCollider> colliders;
};

// As a ROLE section has it.
struct BuiltRoles {
  std::vector<JointRole> roles;
  std::vector<JointPair> pairs;
  std::vector<JointSole> soles;
  std::size_t doubted = 0;  // joints that got no role and a warning; not in the section
};

struct BuiltSkeleton {
  std::string name;
  std::vector<std::string> joint_names;
  std::vector<std::uint16_t> parents;
  std::vector<Affine> model_from_root;
  std::vector<SoaTransform> rest;
  std::vector<int> node_of_joint;  // the way back to the source; kNone: of an outfit, a joint of its body
  std::vector<JointLimit> limits;  // ascending by joint
  BuiltSprings springs;
  BuiltRoles roles;
};

// A clip's tracks in segments, as format::CodedHeader has them; frame_count is 0 without.
struct BuiltCoded {
  format::CodedHeader header{};
  std::vector<float> times_s;  // a frame; none at even steps
  std::vector<std::uint32_t> offsets;
  std::vector<GroupMasks> masks;
  std::vector<format::Constant> constants;
  std::vector<std::byte> payload;
};

// How far a clip strays from its source, where and when.
struct ClipError {
  double error_m = 0;
  double share = 0;  // of what is promised for the joint; the largest of any
  std::size_t joint = 0;
  double time_s = 0;
  double vertex_error_m = 0, vertex_share = 0;  // of vertices, of what is promised for each
};

struct BuiltEvent {
  std::string name;
  float time_s = 0, until_s = 0, number = 0;  // as in ClipEvent
};

// As a MOTN section has it.
struct BuiltMotion {
  float speed_m_s = 0;
  float heading[3] = {};
  std::vector<RootKey> root;
  std::vector<RootKey> root_in_pose;  // what of it the source's poses have, and the clip's have not
  std::vector<BuiltEvent> events;     // by time_s
  std::vector<float> marks;
};

struct BuiltClip {
  std::string name;
  std::size_t source = 0;  // which clip of the scene
  std::uint32_t skeleton = 0;
  float duration_s = 0;
  std::uint32_t most_keys = 0;  // of any track
  std::vector<Track> tracks;
  std::vector<Channel> channels;  // their names stand beside them
  std::vector<std::string> channel_names;
  std::vector<float> times_s;
  std::vector<float> values;
  BuiltCoded coded;
  ClipError error;
  std::string raw_because;              // why it keeps its keys; empty: coded, or nothing moves
  std::string additive;                 // over what, in --additive's words; empty: an ordinary clip
  std::vector<SoaTransform> reference;  // empty: the rest pose
  BuiltMotion motion = {};
};

// What quantisation has done at worst, lengths in the mesh's own units.
struct MeshError {
  double position = 0;
  double normal_deg = 0;
  double uv = 0;
  double weight = 0;
  std::vector<double> targets;         // of each morph target's positions, at weight 1; none: the same as the source's
  std::vector<double> targets_rest_m;  // the same where vertices have several joints at rest, as rest_m
  double bind = 0;                     // by inverse binds that follow from the rest pose
  double rest_m = 0;  // of vertices with several joints at rest, their weights rounded too; scene units
  // Of a vertex by multi-weight enveloping, in poses that take no joint's origin further from the root than the
  // diagonal of the mesh's box, and scale nothing; and of one by pose-space deformation, before the blend.
  double multi_weight = 0, pose_space = 0;
};

// What both have done at worst.
MeshError worst_of(const MeshError& a, const MeshError& b);

struct BuiltGeometry {
  format::GeometryHeader header{};
  std::uint32_t influences = 0;     // the most of any vertex
  tools::AlignedBytes section;      // GEOM as the runtime will see it
  std::uint8_t codec = 0;           // packed::Codec of the record; 0: not packed
  std::vector<std::byte> record;    // what a packed file has instead
  std::uint64_t scratch_bytes = 0;  // of memory, to unpack the record
  std::uint32_t target_count = 0;   // morph targets; 0 if none moves anything
  double position_step = 0;         // of a packed one's positions
  MeshError error;
};

// How multi-weights or a pose space came about.
struct DeformerReport {
  const char* truth = "";  // empty: not asked for
  bool shipped = false;
  std::size_t poses = 0, made_up = 0, examples = 0;  // examples: of pose space
  double held_out_share = 1, worse_share = 0;        // see deform::FitQuality
};

// How a mesh's animation space came about, and what else was learnt.
struct LearnReport {
  const char* kind = "lift";  // as it was shipped: lift, smooth or fit
  const char* truth = "";
  std::size_t poses = 0, made_up = 0, helpers = 0;
  double held_out_share = 1, worse_share = 0;  // see deform::FitQuality
  DeformerReport multi_weights, pose_space;
};

// A level of detail of a mesh.
struct BuiltLod {
  std::uint32_t geometry = 0;
  double rms_error_m = 0, max_error_m = 0;  // see MeshLevel; of all primitives of the mesh
};

struct BuiltMesh {
  std::string name;
  std::string material;
  std::uint32_t skeleton = 0;
  int raw_material = kNone;            // index into RawScene::materials
  std::uint32_t material_section = 0;  // as in format::MeshHeader
  std::uint32_t geometry = 0;
  std::uint32_t part = 0, parts = 1;  // of a primitive that one palette was too small for; its parts stand in a row
  std::size_t doubled = 0;            // vertices that stand in several of them, one counted for each but the first
  std::vector<std::uint16_t> joints;
  std::vector<Affine> inverse_bind;
  Affine model_from_mesh = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};  // in the rest pose; for what follows from it
  std::vector<char> bind_is_given;  // a joint; 0: the inverse bind follows from the rest pose; of packed files
  std::vector<Helper> helpers;
  std::vector<float> helper_centres;     // as Mesh::helper_centres
  std::int32_t centre_exponent = 0;      // they are whole numbers times 2 to this power
  double scene_scale = 1;                // scene units a unit of its own, at rest, at most
  std::vector<BuiltLod> lods;            // levels 1, 2, …
  std::size_t source_triangles = 0;      // of a subdivided mesh; else 0
  int learnt = kNone;                    // index into BuiltScene::learnt
  std::vector<RawTargetWeight> targets;  // as many as the geometry's
  float base_colour[4] = {1, 1, 1, 1};
  bool double_sided = false;
};

struct BuiltMaterial {
  std::string name;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool unlit = false;
  glm::vec3 emissive{0};
  std::vector<Texture> textures;
};

// A node that --keep asked for.
struct BuiltNode {
  std::string name;
  std::uint32_t skeleton = 0;
  std::uint16_t joint = kNoJoint;
  Affine joint_from_node;
  std::vector<RawProperty> properties;
};

// As a PMAP section has it.
struct BuiltPoseMap {
  std::string name;
  std::uint32_t skeleton = 0;
  std::uint64_t rig_hash = 0;
  std::uint32_t rig_joint_count = 0;
  std::vector<MappedGroup> groups;
  std::vector<MappedTurn> turns;
  std::vector<MappedPlace> places;
  std::vector<RigStep> steps;
};

// As an SHAP section has it; arrays of floats as in ExampleSpace.
struct BuiltExampleSpace {
  std::string name;
  std::vector<std::string> parameters;
  std::vector<float> rests;  // a parameter
  std::vector<std::uint32_t> targets, meshes;
  std::vector<float> linear, radial, places, inverse_widths;
};

// As a GRPH section has it; names of records stand beside them, and are 0 there.
struct BuiltGraph {
  std::string name;
  std::vector<GraphParameter> parameters;
  std::vector<GraphNode> nodes;
  std::vector<GraphClip> clips;
  std::vector<GraphSpace> spaces;
  std::vector<GraphPoint> points;
  std::vector<PlaneTriangle> triangles;
  std::vector<GraphMachine> machines;
  std::vector<GraphState> states;
  std::vector<GraphTransition> transitions;
  std::vector<GraphCondition> conditions;
  std::vector<GraphLayer> layers;
  std::vector<GraphMask> masks;
  std::vector<GraphMaskPart> mask_parts;
  std::uint32_t given_count = 0;
  std::vector<std::string> parameter_names, node_names, clip_names, state_names, part_joints;
};

// As the runtime sees it, without names.
Graph view(const BuiltGraph& graph);

// What one GLOB of --keep fits.
struct Kept {
  std::string glob;
  std::vector<std::string> nodes;
};

// A mesh of which clips may weigh morph targets, and how far these take a vertex at weight 1, in the mesh's units.
struct MorphedMesh {
  struct Target {
    std::string channel;  // as RawTargetWeight's
    double rest = 0;
    double reach = 0;
    double error = 0;  // as MeshError's
  };
  Mesh mesh;
  std::vector<Target> targets;
};

// A character that is cooked already, or will be, for clip packs and outfits.
struct Character {
  std::string file;
  std::vector<BuiltSkeleton> skeletons = {};
  std::vector<Mesh> meshes = {};           // of every level of detail
  std::vector<MorphedMesh> morphed = {};   // those with targets
  std::shared_ptr<const void> holds = {};  // what they point into
};

struct BuiltScene {
  bool is_pack = false;      // the skeletons are only referred to
  bool packs_clips = false;  // a file without meshes, too, is packed if it has coded clips
  bool is_outfit = false;    // the skeletons are a body's, which poses them
  std::vector<BuiltSkeleton> skeletons;
  std::vector<int> joint_of_node;         // in its skeleton; kNone for nodes that are no joints
  std::vector<NearestJoint> nearest;      // a node
  std::vector<BuiltClip> clips;           // clip by clip of the source, in each skeleton by skeleton
  std::vector<BuiltGeometry> geometries;  // no two the same
  std::vector<LearnReport> learnt;
  std::vector<BuiltMesh> meshes;         // node by node, primitive by primitive, part by part
  std::vector<BuiltMaterial> materials;  // those with more than MESH says; no two the same
  std::vector<RawImage> images;          // no two the same; fallbacks are among these
  std::vector<BuiltNode> nodes;          // in the source's order
  std::vector<BuiltPoseMap> pose_maps;
  std::vector<BuiltExampleSpace> example_spaces;
  std::vector<BuiltGraph> graphs;
  std::vector<Kept> kept;  // a GLOB
};

}  // namespace marrow::cook
