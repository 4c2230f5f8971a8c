// The scene as the artist's file has it: what reading glTF or BVH yields and what the build stage starts from.
//
// Units and axes are glTF's: metres (a BVH file's own unit), right-handed, +Y up, column vectors. Nothing here is
// compressed, reordered or dropped, except what `RawScene::warnings` lists. Whoever cooks it reads it and changes
// nothing: preparation gives a new scene.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "deform/fit/progress.h"
#include "marrow/cook_host.h"
#include "marrow/file.h"
#include "marrow/limits.h"
#include "text/event_text.h"

namespace marrow::cook {

inline constexpr int kNone = -1;
// Of an index that is not kNone.
inline std::size_t to_index(int i) {
  return static_cast<std::size_t>(i);
}

// Something in a node's `extras`.
struct RawProperty {
  std::string name;  // keys from the outside in, with "/" between them
  PropertyType type = PropertyType::number;
  double number = 0;  // of a boolean 1 or 0
  std::string text;
};

// `extras.marrow.limits` of a node.
struct RawLimit {
  LimitDescription description;
  bool zero_is_given = false;  // else it is the rest rotation
};

struct RawNode {
  std::string name;      // may be empty
  int parent = kNone;    // index into RawScene::nodes, any order
  bool in_scene = true;  // reachable from the scene that is cooked (from any root when the file has none)
  // parent_from_node = translate · rotate · scale. A `matrix` in the file is decomposed; `rotation` is unit length.
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
  std::vector<RawProperty> extras;
  std::size_t dropped_extras = 0;  // what cannot be carried
  std::optional<RawLimit> limit;
  bool moved_by_game = false;  // springs or a game move it: a joint, though no skin names it and no clip moves it
  bool kept = false;           // without --keep, too
  bool is_view = false;        // a camera or a light stands there
};

struct RawInfluence {
  std::uint32_t joint;  // index into RawSkin::joints
  float weight;         // > 0
};

// What a morph target adds to a primitive's vertices at weight 1. Each array is empty or as long as the primitive's.
struct RawTarget {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec3> tangents;  // xyz; the handedness stays
};

// One triangle-list primitive (strips and fans are already unrolled). Every per-vertex array is empty or as long as
// `positions`, in the order of the source's POSITION accessor.
struct RawPrimitive {
  std::string pointer;  // "/meshes/0/primitives/1"
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;   // unit; empty if the file has none
  std::vector<glm::vec4> tangents;  // xyz unit, w = ±1
  std::vector<glm::vec2> uvs;       // where the material's base colour texture is read
  std::vector<glm::vec4> colours;   // COLOR_0, linear, 0..1
  std::vector<std::vector<RawInfluence>>
      influences;                      // all sets; weights ≥ 0 as in the file, not yet normalised; empty if unskinned
  std::vector<RawTarget> targets;      // as many in all primitives of a mesh
  std::vector<std::uint32_t> indices;  // 3 a triangle; generated when the file has none
  int material = kNone;                // index into RawScene::materials
};

// What drives a morph target.
struct RawTargetWeight {
  std::string target;   // its own name; may be empty
  std::string channel;  // NODE.TARGET, as RawScalar::name of the clips that drive it
  float rest = 0;       // where no clip does
};

struct RawMesh {
  std::string name;
  std::vector<RawTargetWeight> weights;  // of its morph targets, where no node says otherwise
  std::vector<RawPrimitive> primitives;
};

struct RawSkin {
  std::string name;
  std::vector<int> joints;               // node indices, distinct
  std::vector<glm::dmat4> inverse_bind;  // joint_from_mesh, one a joint (identity when the file has none)
};

struct RawMaterial {
  std::string name;
  glm::vec4 base_colour{1};  // baseColorFactor
  bool double_sided = false;
  AlphaMode alpha = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;  // of masks; else 0.5
  bool unlit = false;
  glm::vec3 emissive{0};          // factor times strength
  std::vector<Texture> textures;  // their images are indices into RawScene::images
};

struct RawImage {
  std::string name;  // never empty for an image that a material uses
  std::string uri;   // as in the file, percent-encoded; empty if there is none
  ImageFormat format = ImageFormat::unknown;
  std::uint64_t inside_bytes = 0;  // of the source that are the image's; 0: it is a file of its own
  std::vector<std::byte> bytes;    // empty unless read_gltf() was asked for them
  int fallback = kNone;            // index into RawScene::images: the same picture as PNG or JPEG
};

// A mesh drawn at a node of the scene. Listed in node order.
struct RawInstance {
  int node = kNone;
  int mesh = kNone;
  int skin = kNone;                      // kNone: hung rigidly on the node
  std::vector<RawTargetWeight> weights;  // of the mesh's morph targets
  int unused_skin = kNone;               // that the file gives to a mesh without weights
};

enum class RawPath { translation, rotation, scale };
enum class RawInterpolation { step, linear, cubic_spline };

struct RawChannel {
  int node = kNone;
  RawPath path = RawPath::translation;
  RawInterpolation interpolation = RawInterpolation::linear;
  std::vector<float> times_s;  // strictly increasing, finite, ≥ 0, at least one
  // One vec4 a key (w unused but for rotations, which are x, y, z, w and as in the file, not renormalised); three a key
  // for cubic_spline: in-tangent, value, out-tangent.
  std::vector<glm::vec4> values;
};

// A number that a clip moves and that is no part of a joint: a morph target's weight, a property in `extras`.
struct RawScalar {
  std::string name;
  int node = kNone;  // whose mesh has the morph target; kNone: another number
  float rest = 0;    // as in the file, where no clip moves it
  RawInterpolation interpolation = RawInterpolation::linear;
  std::vector<float> times_s;  // as in RawChannel
  std::vector<float> values;   // one a key; three for cubic_spline: in-tangent, value, out-tangent
};

struct RawClip {
  std::string name;  // may be empty
  std::vector<RawChannel> channels;
  std::vector<RawScalar> scalars;
  bool additive = false;                      // over the rest pose, without --additive
  std::vector<tools::EventText> events = {};  // `extras.marrow.events`
};

// A chain of spring bones, each node somewhere below the one before it. No node is in two chains.
struct RawSpring {
  std::vector<int> nodes;
  std::vector<SpringJoint> settings;  // a node; their `joint` means nothing
  glm::dvec3 tip{0};                  // where the last node's bone ends, in its space; 0: it only ends the chain
  std::uint64_t colliders = 0;        // bit i: RawScene::colliders[i]
};

struct RawCollider {
  int node = kNone;
  glm::dvec3 from{0}, to{0};  // in the node's space
  double radius_m = 0;        // in the node's space
};

struct RawWarning {
  std::string pointer;  // JSON pointer into the source
  std::string rule;     // short, kebab-case: "weights-zero"
  std::string text;     // one sentence
};

// What stages say beside their results, warnings in the order in which they say them.
struct Notes {
  std::vector<RawWarning> warnings;
  const Host* host = nullptr;  // who waits; null: nobody

  // Throws tools::Failure (interrupted) if the work is to stop.
  void begin(Stage stage) const {
    tools::expect_to_go_on();
    tell(stage, 0, 0);
  }
  void tell(Stage stage, std::size_t done, std::size_t count) const {
    if (host != nullptr && host->progress) host->progress(stage, done, count);
  }
  // Of parts of a stage; while the notes live.
  deform::Progress progress_of(Stage stage) const {
    return [this, stage](std::size_t done, std::size_t count) { tell(stage, done, count); };
  }
};

struct RawScene {
  std::string source;              // path as given
  std::uint64_t source_bytes = 0;  // the file and whatever else was read for it
  bool is_capture = false;         // motion of a body of other proportions, see retarget()
  bool draws_elsewhere = false;    // nodes draw meshes, if not those that are cooked
  std::vector<RawNode> nodes;
  std::vector<RawMesh> meshes;
  std::vector<RawMaterial> materials;
  std::vector<RawImage> images;  // those that no material uses are empty
  std::vector<RawSkin> skins;
  std::vector<RawInstance> instances;
  std::vector<RawClip> clips;
  std::vector<RawSpring> springs;
  std::vector<RawCollider> colliders;  // at most kMaxSpringColliders
  std::vector<RawWarning> warnings;    // of whoever read it
  std::vector<Read> reads;             // the scene's own file first; empty for a scene in memory
};

}  // namespace marrow::cook
