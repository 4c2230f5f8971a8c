// A whole character at a moment on the CPU: the road of data from clip to vertices, as a game would walk it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "common/aligned_bytes.h"
#include "common/check_status.h"
#include "common/shape_weights.h"
#include "marrow/marrow.h"
#include "text/choices.h"

namespace marrow::tools {

enum class Deformer { rigid, ssd, as, mwe, psd };

inline constexpr Named<Deformer> kDeformers[] = {{"rigid", Deformer::rigid},
                                                 {"ssd", Deformer::ssd},
                                                 {"as", Deformer::as},
                                                 {"mwe", Deformer::mwe},
                                                 {"psd", Deformer::psd}};
// Those that a window offers for any file: the first three.
inline constexpr std::span<const Named<Deformer>> kGpuDeformers(kDeformers, 3);

// Throws Failure (unsupported) if the file, of this path, has nothing that the deformer needs: multi-weights, a pose
// space. Meshes without, of a file that has some, are skinned by SSD.
void expect_deformer(const std::string& path, const File& file, Deformer deformer);

// What normals go through in animation space: the blended matrix, or tangents of the deformed surface. Meshes with
// morph targets have the blend's either way.
enum class AsNormals { blended, tangents };

inline constexpr Named<AsNormals> kAsNormals[] = {{"tangents", AsNormals::tangents}, {"blended", AsNormals::blended}};

// as_tangents() of every mesh of a file as one surface; empty for meshes without normals or with morph targets.
std::vector<std::vector<float>> tangents_of(const File& file, std::uint32_t level = 0);

struct PosedMesh {
  std::vector<float> positions;  // 3 a slot, model space
  std::vector<float> normals;    // 3 a slot; empty if the mesh has none
  std::vector<float> tangents;   // 4 a slot; empty if the mesh has none
  bool inside_out = false;       // turns_inside_out() of its palette: its triangles' fronts are clockwise
};

// What the skeletons of a file play together, and the memory that this lies in. Empty: all rest.
struct Play : Animation {
  std::shared_ptr<const void> memory;

  bool empty() const { return clip_of_skeleton.empty(); }
  // nullopt: it rests.
  std::optional<Clip> clip(std::uint32_t skeleton) const;
};

// Of each clip of `clips` itself and what make_animations() finds to go with it; nothing if it is of a pack and does
// not fit.
std::vector<Play> plays_of(const File& file, const File& clips);
// The same of one clip.
Play play_together(const File& file, const File& clips, std::uint32_t clip);
inline Play play_together(const File& file, std::uint32_t clip) {
  return play_together(file, file, clip);
}
// The skeleton that plays a clip; none if none does, as one of a pack that does not fit.
std::optional<std::uint32_t> skeleton_of(const Play& play, std::uint32_t clip);
// Of a play what one skeleton does.
Play only(const File& file, const Play& play, std::uint32_t skeleton);

// One of several plays that are blended: when, and how much of it.
struct PlayLayer {
  Play play;
  float time_s = 0;
  float weight = 1;  // 0 … 1
};

struct Worn;

// A marrow::Character with its memory, that throws. Spaces of example shapes weigh its morph targets.
class Character {
 public:
  // level: of detail, as in File::mesh. layers: that poses hold at once, as an animator may need more.
  explicit Character(const File& file, AsNormals normals = AsNormals::blended, std::uint32_t level = 0,
                     std::uint32_t layers = kMostLayers);
  Character(const Character&) = delete;
  Character& operator=(const Character&) = delete;

  // Called in each pose() for each skeleton, when its joints are posed and nothing has been built from them yet; it may
  // change them, both forms alike.
  using Change = std::function<void(std::uint32_t skeleton, const Pose& pose)>;
  void set_change(Change change) { change_ = std::move(change); }
  // Called likewise for each mesh that has morph targets; it may change their weights.
  using Weigh = std::function<void(std::uint32_t mesh, Span<float> weights)>;
  void set_weigh(Weigh weigh) { weigh_ = std::move(weigh); }

  // Spaces of example shapes, and parameters of them by name in place of what clips say.
  const ShapeWeights& shapes() const { return shapes_; }
  void set_parameters(std::map<std::string, float> parameters) { shapes_.set(std::move(parameters)); }

  // What follows it from now on in each pose(), see worn.h; they are posed by their own plays at the same time.
  void wear(std::vector<std::shared_ptr<Worn>> worn) { worn_ = std::move(worn); }
  const std::vector<std::shared_ptr<Worn>>& worn() const { return worn_; }

  void pose(const Play& play, float time_s);
  // A blend of at most kMostLayers.
  void pose(std::span<const PlayLayer> layers);
  static constexpr std::uint32_t kMostLayers = 4;
  // As an animator has it, standing in the world: set_change() sees poses in model space, and all that follows has
  // joints in the world. shown: clips that it shows, for spaces of example shapes.
  void pose(Animator& animator, const Affine& world_from_model, std::span<const AnimationLayer> shown);
  // As an outfit of `body`, in its pose; joints of its own and morph targets play.
  void follow(const Outfit& outfit, const Character& body, const Play& play, float time_s);
  // Deforms one mesh, morphed, in the pose of the last call to pose().
  void skin(std::uint32_t mesh, Deformer deformer, PosedMesh& out) const;

  std::span<const Affine> model_from_joint(std::uint32_t skeleton) const {
    return to_std(body_.skeletons[skeleton].pose.model_from_joint);
  }
  // Of the mesh's morph targets: the clip's, or their defaults.
  std::span<const float> weights(std::uint32_t mesh) const { return to_std(body_.meshes[mesh].weights); }
  std::span<const Affine> palette(std::uint32_t mesh) const { return to_std(body_.meshes[mesh].palette); }

 private:
  void change_pose();
  template <class T>
  static std::span<const T> to_std(Span<T> span) {
    return {span.data, span.size};
  }

  AlignedBytes memory_;
  marrow::Character body_;
  std::vector<std::uint32_t> no_clips_, no_channels_;
  Animation rest_;
  ShapeWeights shapes_;
  Change change_;
  Weigh weigh_;
  std::vector<std::shared_ptr<Worn>> worn_;
  std::vector<std::vector<float>> tangents_;  // a mesh; empty: normals go through the blend
};

}  // namespace marrow::tools
