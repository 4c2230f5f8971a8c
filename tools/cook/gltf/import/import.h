// Turns a checked document into a RawScene.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"
#include "cook/gltf/document/model.h"
#include "cook/gltf/import/materials.h"
#include "cook/gltf/rules/rules.h"
#include "cook/scene/raw.h"
#include "marrow/cook_host.h"

namespace marrow::cook::gltf {

// What the decoded scene may take in memory. A small file can name the same data ten thousand times over, or let Draco
// unfold it.
class Budget {
 public:
  explicit Budget(std::uint64_t source_bytes);
  void take(std::uint64_t bytes, const std::string& where, const Report& report);

 private:
  std::uint64_t left_;
};

// tools::safe_name(), with a warning where it changes anything.
std::string clean_name(const std::string& name, const std::string& where, Report& report);

// Refuses what stands or is scaled beyond format::kFarthest at rest.
std::vector<RawNode> import_nodes(const Document& document, const NodeGraph& graph, Report& report);

// model_from_node at rest, by node.
std::vector<glm::dmat4> rest_matrices(const std::vector<RawNode>& nodes);

std::vector<RawSkin> import_skins(const Document& document, const std::vector<RawNode>& nodes, Report& report);

// The weights of a mesh's morph targets, named after their owner: at rest `own`, or as the mesh has them where those
// are not as many. `where`: who asks.
std::vector<RawTargetWeight> mesh_weights(const Document& document, std::size_t mesh_index, const std::string& owner,
                                          const std::vector<double>& own, const std::string& where, Report& report);
// Those of the mesh at a node; none without. owners: from weight_owners().
std::vector<RawTargetWeight> node_weights(const Document& document, const std::vector<std::string>& owners,
                                          int node_index, const std::string& where, Report& report);
// What each node's weights are called after: its name; nodes[3] without, or if a node before it has the same.
std::vector<std::string> weight_owners(const Document& document, const std::vector<RawNode>& nodes);
// Gives nodes what they carry for the game: nested members and elements get the path of their keys, escaped as in a
// JSON pointer, as their name. Nulls, infinite numbers and texts with a zero character are left out and counted.
void import_extras(const Document& document, std::vector<RawNode>& nodes, Budget& budget, Report& report);
// Adds what `value` holds to a node's properties, in the same way; `name` comes before the keys.
void add_properties(const Json& value, const std::string& name, const std::string& where, Budget& budget,
                    const Report& report, RawNode& node);

// Gives nodes their joint limits. Refuses what docs/limits.schema.json does.
void import_limits(const Document& document, std::vector<RawNode>& nodes, const Report& report);

// One RawMesh a mesh of the document, in its order. Primitives that draw no triangles are left out.
std::vector<RawMesh> import_meshes(const Document& document, const Materials& materials, Budget& budget,
                                   Report& report);

// What is drawn of the scene. Also checks that every joint that a mesh uses exists in the skins that it is drawn with;
// influences that no skin makes sense of are dropped.
std::vector<RawInstance> import_instances(const Document& document, const NodeGraph& graph,
                                          const std::vector<RawNode>& nodes, std::vector<RawMesh>& meshes,
                                          const std::vector<RawSkin>& skins, Report& report);

// What moves nodes of the scene, weights of what is drawn, and numbers.
std::vector<RawClip> import_clips(const Document& document, const NodeGraph& graph, const std::vector<RawNode>& nodes,
                                  Budget& budget, Report& report);

// A hostile URI is refused even if nobody opens it.
void check_image_uris(const Json& root, Report& report);

// The document's images, by its numbering; those that no material uses stay empty. with_bytes: also reads them, which
// must be of a known format; nothing is decoded. `files` as for load_buffers(). `external_bytes` grows by what is read
// from files.
std::vector<RawImage> import_images(const Document& document, const Materials& materials, Files* files, bool with_bytes,
                                    Budget& budget, std::uint64_t& external_bytes, Report& report);

}  // namespace marrow::cook::gltf
