// Painting of a character's weights: the canvas, the stroke in hand, what can be taken back, and the file. The door of
// this folder: what is behind it is its own.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cook/paint/paint_file.h"
#include "cook/scene/raw.h"
#include "paint/canvas.h"
#include "paint/stroke.h"

namespace marrow::tools {

// Names of joints, by the names of the meshes that have them in their skins; meshes are named as cooked ones are.
using SkinJoints = std::map<std::string, std::set<std::string>>;
SkinJoints skin_joints(const cook::RawScene& scene);

class Painting {
 public:
  // path: where it is saved. What is there already is painted first; if it cannot be, trouble() says why, and save()
  // writes over nothing. skins: names of the joints of meshes' skins, as far as they are known: a mesh follows no
  // others. `file` outlives it. Cost: 0.1 s for 40 000 vertices.
  Painting(const File& file, std::string path, const SkinJoints& skins = {});

  const std::string& path() const { return path_; }
  // Why nothing of this file can be painted; empty: it can be.
  const std::string& refusal() const { return refusal_; }
  // What is wrong with the file at path(); empty: nothing.
  const std::string& trouble() const { return trouble_; }
  const Canvas& canvas() const { return canvas_; }

  // Where the surface is now, for hit() and posed().
  void pose(const Character& character);
  std::optional<SurfaceHit> hit(const Ray& ray) const;
  std::vector<PosedMesh> posed(const Character& character) const;
  // Of a mesh of the file, a slot: what a joint and its image weigh together. image: of image_of().
  std::vector<float> weights(std::uint32_t mesh, std::uint32_t skeleton, std::uint32_t joint,
                             std::uint32_t image) const;
  // The first mesh whose skin has not this joint; empty: there is none.
  std::string without(std::uint32_t skeleton, std::uint32_t joint) const;
  // How many vertices a joint moves.
  std::size_t moved_by(std::uint32_t skeleton, std::uint32_t joint) const;
  // Of the brush's plane: the joint on the other side, and how many places have an image.
  std::uint32_t image_of(const Brush& brush, std::uint32_t skeleton, std::uint32_t joint);
  std::size_t places_with_image(const MirrorPlane& plane);

  // A stroke, from begin() to end(). Without refusal().
  void begin(const Brush& brush, std::uint32_t skeleton, std::uint32_t joint);
  bool stroking() const { return stroke_.has_value(); }
  void dab(const SurfaceHit& hit);
  void end();
  // Vertices that the last stroke changed; none before the first.
  std::optional<std::size_t> changed() const { return changed_; }
  // Those that the last stroke could not take the joint's weight from, as they follow nothing else.
  std::size_t kept() const { return kept_; }

  const History& history() const { return history_; }
  void undo();
  void redo();

  // All that is painted, as it is saved.
  std::vector<cook::PaintedMesh> painted() const;
  // Paints it as well; it is not saved then. Throws Failure (invalid) if a joint is not there.
  void add(const std::vector<cook::PaintedMesh>& painted);
  bool saved() const { return history_.saved(); }
  // Throws Failure: io, or what trouble() says.
  void save();

 private:
  void set_joints(const SkinJoints& skins);
  void read_saved();
  void apply(const cook::PaintedMesh& mesh, const std::string& where);
  const std::vector<std::uint32_t>& mirror(const MirrorPlane& plane);

  const File& file_;
  std::string path_, refusal_, trouble_;
  std::vector<std::vector<Affine>> rest_;  // a skeleton: model_from_joint
  Canvas canvas_;
  std::vector<std::vector<glm::mat4>> binds_;  // a group
  PosedCanvas posed_;
  std::optional<Stroke> stroke_;
  History history_;
  std::size_t kept_ = 0;
  std::optional<std::size_t> changed_;
  double diagonal_ = 0;
  std::optional<MirrorPlane> mirror_plane_;  // that mirror_ is of
  std::vector<std::uint32_t> mirror_;
  std::vector<cook::PaintedMesh> others_;  // of the file, of meshes that are not here
};

// "art/hero.glb" → "art/hero.paint.json".
std::string paint_file_beside(const std::string& path);

}  // namespace marrow::tools
