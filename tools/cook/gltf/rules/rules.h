// What glTF 2.0 demands beyond the shape of a document: rules between objects.
//
// Each function refuses or mends the first breach that it finds; afterwards the import need not look again.
#pragma once

#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/model.h"

namespace marrow::cook::gltf {

struct NodeGraph {
  std::vector<int> parent;     // kNone for a root
  std::vector<int> root;       // of the tree that a node is in
  std::vector<bool> in_scene;  // reachable from the default scene; all when the document has none
};

// Nodes form a forest, scenes list roots, skins hang together; transforms are given in one way.
NodeGraph check_nodes(const Document& document, Report& report);
void check_skins(const Document& document, const NodeGraph& graph, Report& report);

// Attribute names, formats, counts, alignment; index formats; morph targets.
void check_meshes(const Document& document, Report& report);
// Needs the JSON: tinygltf is not told about textures.
void check_texture_coordinates(const Json& root, Report& report);

// Samplers, channels and their outputs. Times and values are looked at when they are imported.
void check_animations(const Document& document, Report& report);

}  // namespace marrow::cook::gltf
