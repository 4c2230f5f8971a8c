// What glTF 2.0 demands beyond the shape of a document: rules between objects.
//
// Each function refuses or mends the first breach that it finds; afterwards the import need not look again. The shape
// itself is schema.h's. check_texture_coordinates() stands with the textures, in import/materials.h.
#pragma once

#include <vector>

#include "cook/gltf/document/findings.h"
#include "cook/gltf/document/model.h"

namespace marrow::cook::gltf {

struct NodeGraph {
  std::vector<int> parent;     // kNone for a root
  std::vector<int> root;       // of the tree that a node is in
  std::vector<bool> in_scene;  // reachable from the scene that is cooked; all when the document has none
  std::vector<bool> drawn;     // of those; neither hidden nor a lower level of detail, nor below such a node
};

// A node has a matrix or its parts. Needs the JSON: tinygltf keeps only the matrix.
void check_transforms(const Json& root, const Report& report);
// Nodes form a forest, scenes list roots, skins hang together; transforms are given in one way. scene: the one that is
// cooked, kNone without any.
NodeGraph check_nodes(const Document& document, int scene, Report& report);
void check_skins(const Document& document, const NodeGraph& graph, Report& report);

// Attribute names, formats, counts, alignment; index formats; morph targets.
void check_meshes(const Document& document, Report& report);

// Samplers, channels and their outputs. Times and values are looked at when they are imported.
void check_animations(const Document& document, Report& report);

}  // namespace marrow::cook::gltf
