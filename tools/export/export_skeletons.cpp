// Skeletons become trees of nodes: the joints, and above the roots what never moves.
#include <cmath>

#include "export/affine_parts.h"
#include "export/export_parts.h"

namespace marrow::tools {
namespace {

Json joint_node(const File& file, const Skeleton& skeleton, std::size_t joint) {
  const SoaTransform& four = skeleton.rest[joint / 4];
  const std::size_t lane = joint % 4;
  Parts rest;
  double squared = 0;
  for (int i = 0; i < 3; ++i) {
    rest.translation[i] = static_cast<double>(four.translation[i][lane]);
    rest.scale[i] = static_cast<double>(four.scale[i][lane]);
  }
  for (int i = 0; i < 4; ++i) {
    rest.rotation[i] = static_cast<double>(four.rotation[i][lane]);
    squared += rest.rotation[i] * rest.rotation[i];
  }
  // Cooked rotations are unit within rounding; glTF refuses others.
  if (std::fabs(squared - 1) > 1e-6)
    for (int i = 0; i < 4; ++i)
      rest.rotation[i] = squared > 0 ? rest.rotation[i] / std::sqrt(squared) : (i == 3 ? 1.0 : 0.0);
  Json node = Json::object();
  if (const char* const name = file.text(skeleton.names[joint]); *name != '\0') node["name"] = name;
  set_parts(node, rest);
  return node;
}

// Nodes for a map that never moves, below `parent`; the innermost's number.
std::size_t add_fixed(ExportScene& scene, const Affine& map, const std::string& name, std::size_t parent) {
  for (const Parts& parts : parts_of(map)) {
    Json node = Json::object();
    if (!name.empty()) node["name"] = name;
    set_parts(node, parts);
    parent = scene.add_node(std::move(node), parent);
  }
  return parent;
}

// glTF wants the joints of a skin under one node, so several roots get one.
void add_above_roots(ExportScene& scene, const Skeleton& skeleton, const std::vector<std::size_t>& nodes) {
  const Affine* const above = skeleton.model_from_root;
  bool alike = true;
  for (std::uint32_t r = 1; r < skeleton.root_count; ++r) alike = alike && same(above[r], above[0]);
  std::size_t top = ExportScene::kScene;
  const bool plain = parts_of(above[0]).empty();
  if (skeleton.root_count > 1 && (!alike || plain)) top = scene.add_node({{"name", skeleton.name}}, top);
  std::size_t parent = top;
  for (std::uint32_t r = 0; r < skeleton.root_count; ++r) {
    if (r == 0 || !same(above[r], above[r - 1])) parent = add_fixed(scene, above[r], skeleton.name, top);
    if (parent == ExportScene::kScene) {
      scene.roots.push_back(nodes[r]);
    } else {
      scene.glb.json["nodes"][parent]["children"].push_back(nodes[r]);
    }
  }
}

}  // namespace

void export_skeletons(ExportScene& scene) {
  for (std::uint32_t i = 0; i < scene.file.skeleton_count(); ++i) {
    const Skeleton skeleton = scene.file.skeleton(i);
    std::vector<std::size_t> nodes;
    // All joints first, in their own order, so that cooking the export finds them in the same one.
    for (std::size_t j = 0; j < skeleton.joint_count; ++j) {
      nodes.push_back(scene.glb.add("nodes", joint_node(scene.file, skeleton, j)));
      if (skeleton.parents[j] != kNoJoint)
        scene.glb.json["nodes"][nodes[skeleton.parents[j]]]["children"].push_back(nodes[j]);
    }
    add_above_roots(scene, skeleton, nodes);
    scene.joint_nodes.push_back(std::move(nodes));
  }
}

}  // namespace marrow::tools
