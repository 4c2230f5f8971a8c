// A checked document as typed structures, which tinygltf makes of it, and what animations of it drive: transforms and
// weights of nodes, and by KHR_animation_pointer numbers in `extras`.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cook/gltf/document/accessor.h"
#include "cook/gltf/document/buffers.h"
#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/json.h"

// tinygltf as this program uses it: no images, no file system, the system's JSON library, after which it must come.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_INCLUDE_JSON
#include <tiny_gltf.h>

namespace marrow::cook::gltf {

// A number in `extras` that an animation drives by KHR_animation_pointer.
struct UserNumber {
  std::string pointer;  // as in the file
  std::string name;     // "OWNER.property", "OWNER.list[2]"; without an owner where that is the asset or the document
  float rest = 0;
};

// By numbers of animation and channel.
using UserNumbers = std::map<std::pair<std::size_t, std::size_t>, UserNumber>;

// Makes plain what channels drive. One that points at /nodes/3/translation, rotation, scale or weights becomes that
// node's, as glTF 2.0 has them. Given are those that point at a number at any depth in the extras of the document, of
// the asset, or of an element of a root collection such as /nodes/3. All that drive nothing of this get an empty path,
// with a warning. `root` has been through check_schema().
UserNumbers aim_channels(Json& root, Report& report);

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

  const Accessor& accessor(int index) const { return accessors[to_index(index)]; }
  const View& view(int index) const { return buffers.views[to_index(index)]; }
};

// As many as its first primitive has; 0 of one without primitives.
std::size_t target_count(const tinygltf::Mesh& mesh);

// Eats `root`, which has been through check_schema(). tinygltf believes what it reads, so it gets no bytes, no URIs and
// no extras; of extensions it gets KHR_draco_mesh_compression. Channels and primitives have the document's numbers.
tinygltf::Model parse_model(Json root, Report& report);

}  // namespace marrow::cook::gltf
