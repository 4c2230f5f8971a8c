// A whole character at a moment on the CPU: the road of data from clip to vertices, as a game would walk it.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "marrow/marrow.h"

namespace marrow::tools {

enum class Deformer { rigid, ssd, as };

// "rigid", "ssd" or "as"; nullopt for anything else.
std::optional<Deformer> parse_deformer(const std::string& name);

// What normals go through in animation space: the blended matrix, or tangents of the deformed surface. Meshes with
// morph targets have the blend's either way.
enum class AsNormals { blended, tangents };

// "blended" or "tangents"; nullopt for anything else.
std::optional<AsNormals> parse_as_normals(const std::string& name);

// as_tangents() of every mesh of a file as one surface; empty for meshes without normals or with morph targets.
std::vector<std::vector<float>> tangents_of(const File& file, std::uint32_t level = 0);

struct PosedMesh {
  std::vector<float> positions;  // 3 a slot, scene space
  std::vector<float> normals;    // 3 a slot; empty if the mesh has none
  std::vector<float> tangents;   // 4 a slot; empty if the mesh has none
};

// What the skeletons of a file play together: at most one clip each; those without rest.
struct Play {
  struct Part {
    std::uint32_t skeleton;
    Clip clip;
    File clips;  // that the clip is from
  };
  std::vector<Part> parts;
  float duration_s = 0;  // of the longest
};

// A clip alone, for one of the skeletons it was made for.
Play play_alone(const File& clips, const Clip& clip, std::uint32_t skeleton);
// A clip, and of each other skeleton the first one with the same name, which the cooker made of the same animation.
Play play_together(const File& file, std::uint32_t clip);

// One of several plays that are blended: when, and how much of it.
struct PlayLayer {
  Play play;
  float time_s = 0;
  float weight = 1;  // 0 … 1
};

// Everything that the skeletons and meshes of a file need beside it, allocated once.
class Character {
 public:
  // level: of detail, as in File::mesh.
  explicit Character(const File& file, AsNormals normals = AsNormals::blended, std::uint32_t level = 0);
  Character(const Character&) = delete;
  Character& operator=(const Character&) = delete;

  // Called in each pose() for each skeleton, when its joints are posed and nothing has been built from them yet; it may
  // change them, both forms alike.
  using Change = std::function<void(std::uint32_t skeleton, Span<SoaTransform> local, Span<Affine> scene_from_joint)>;
  void set_change(Change change) { change_ = std::move(change); }

  void pose(const Play& play, float time_s);
  // A blend. Weights add up to 1; a skeleton that a play leaves alone rests in it.
  void pose(std::span<const PlayLayer> layers);
  // Deforms one mesh, morphed, in the pose of the last call to pose().
  void skin(std::uint32_t mesh, Deformer deformer, PosedMesh& out) const;

  std::span<const Affine> scene_from_joint(std::uint32_t skeleton) const { return model_[skeleton]; }
  // Of the mesh's morph targets: the clip's, or their defaults.
  std::span<const float> weights(std::uint32_t mesh) const { return weights_[mesh]; }
  std::span<const Affine> palette(std::uint32_t mesh) const { return palettes_[mesh]; }

 private:
  void pose_skeleton(std::uint32_t index, std::span<const PlayLayer> layers);
  void morph_all(std::span<const PlayLayer> layers);
  // Adds weight · a play's weights of a mesh's morph targets.
  void add_morph_weights(std::uint32_t mesh, const PlayLayer& layer);

  File file_;
  std::uint32_t level_;
  Change change_;
  std::vector<std::vector<SoaTransform>> local_;  // a skeleton
  std::vector<SoaTransform> blended_;             // of the skeleton that is being blended
  std::vector<std::vector<Affine>> model_;        // a skeleton
  std::vector<std::vector<Affine>> palettes_;     // a mesh
  // A mesh.
  std::vector<std::vector<float>> coordinates_;  // in animation space
  std::vector<std::vector<float>> tangents_;     // likewise; empty: normals go through the blend
  std::vector<std::vector<float>> weights_;
  std::vector<std::vector<SoaTransform>> memory_;  // of morphed_; for its alignment
  std::vector<MorphedGeometry> morphed_;
};

// Throws Failure (internal) unless ok.
void check(Status status);

}  // namespace marrow::tools
