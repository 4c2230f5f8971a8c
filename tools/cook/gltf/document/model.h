// Hands a checked document to tinygltf, which turns it into typed structures.
#pragma once

#include <string>
#include <vector>

#include "cook/gltf/document/accessor.h"
#include "cook/gltf/document/animation_pointer.h"
#include "cook/gltf/document/json.h"
#include "cook/gltf/document/tinygltf.h"

namespace marrow::cook::gltf {

// What a node's extensions say of whether it is drawn.
struct NodeShown {
  bool visible = true;     // KHR_node_visibility
  std::vector<int> lower;  // MSFT_lod: nodes that are drawn in its place from afar
};

// Everything that the rules and the import start from.
struct Document {
  tinygltf::Model model;                               // meshes, nodes, skins, animations and scenes; no bytes
  std::vector<std::vector<std::string>> target_names;  // by mesh and morph target; may be shorter
  UserNumbers user_numbers;
  Json looks;                      // the root's materials, textures, samplers and images
  Json vrm;                        // the root's extensions VRM, VRMC_vrm and VRMC_springBone, those that there are
  std::vector<Json> node_extras;   // by node; null where there are none
  std::vector<Json> clip_events;   // by animation: `extras.marrow.events`; null where there are none
  std::vector<Json> node_limits;   // by node: extras.marrow.limits, taken out of the above; null where there are none
  std::vector<bool> node_is_view;  // by node: a camera or a light
  std::vector<NodeShown> node_shown;
  std::vector<Accessor> accessors;  // by the document's numbering
  Buffers buffers;
};

// As many as its first primitive has; 0 of one without primitives.
std::size_t target_count(const tinygltf::Mesh& mesh);

// Eats `root`, which has been through check_schema(). tinygltf believes what it reads, so it gets no bytes, no URIs and
// no extras; of extensions it gets KHR_draco_mesh_compression. Channels and primitives have the document's numbers.
tinygltf::Model parse_model(Json root, Report& report);

}  // namespace marrow::cook::gltf
