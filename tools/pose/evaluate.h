// A whole character at a moment on the CPU: the road of data from clip to vertices, as a game would walk it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "marrow/marrow.h"

namespace marrow::tools {

enum class Deformer { rigid, ssd, as };

// "rigid", "ssd" or "as"; nullopt for anything else.
std::optional<Deformer> parse_deformer(const std::string& name);

struct PosedMesh {
  std::vector<float> positions;  // 3 a slot, scene space
  std::vector<float> normals;    // 3 a slot; empty if the mesh has none
  std::vector<float> tangents;   // 4 a slot; empty if the mesh has none
};

// Everything that one character needs beside the file, allocated once. Skeletons are posed together: a clip moves its
// own skeleton and leaves the others at rest.
class Character {
 public:
  explicit Character(const File& file);

  // nullopt: the rest pose.
  void pose(std::optional<std::uint32_t> clip, float time_s);
  // Deforms one mesh in the pose of the last call to pose().
  void skin(std::uint32_t mesh, Deformer deformer, PosedMesh& out) const;

  std::span<const Affine> scene_from_joint(std::uint32_t skeleton) const { return model_[skeleton]; }
  std::span<const Affine> palette(std::uint32_t mesh) const { return palettes_[mesh]; }

 private:
  File file_;
  std::vector<std::vector<SoaTransform>> local_;  // a skeleton
  std::vector<std::vector<Affine>> model_;        // a skeleton
  std::vector<std::vector<Affine>> palettes_;     // a mesh
  std::vector<std::vector<float>> coordinates_;   // a mesh: animation space
};

// Throws Failure (internal) unless ok.
void check(Status status);

}  // namespace marrow::tools
