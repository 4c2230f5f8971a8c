// The steps of an export, in order, and what they share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "export/export.h"
#include "glb/glb.h"
#include "marrow/file.h"
#include "terminal/warnings.h"

namespace marrow::tools {

// A node whose mesh has morph targets: for each the name of the channel that drives its weight, and its default.
struct MorphedNode {
  std::size_t node;
  std::vector<std::string> channels;
  std::vector<float> weights;
};

struct ExportScene {
  const File& file;
  std::string name;  // of the cooked file
  Glb glb;
  std::vector<std::vector<std::size_t>> joint_nodes;  // node of each joint, for each skeleton
  std::vector<std::size_t> roots;                     // of the scene
  std::vector<MorphedNode> morphed;
  std::vector<Warning> warnings;

  // Adds a node below another, or to the scene's roots without one, and returns its number.
  static constexpr std::size_t kScene = SIZE_MAX;
  std::size_t add_node(Json node, std::size_t parent);
};

// The last element of each array must exist before: skeletons, meshes, clips.
void export_skeletons(ExportScene& scene);
void export_limits(ExportScene& scene);
void export_meshes(ExportScene& scene);
void export_clips(ExportScene& scene, const ExportedClips& clips);

}  // namespace marrow::tools
