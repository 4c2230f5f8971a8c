// A study's mesh as the studio draws it, wherever deformers put its vertices.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands/compare/pictures.h"
#include "render/clearest_side.h"
#include "render/figure.h"
#include "render/heat.h"
#include "render/performance.h"

namespace marrow::tools {

class Stage {
 public:
  // Pictures of side × side pixels. `study` outlives it.
  Stage(const Study& study, int side);

  // What is framed, from which side, and what stands on the ground and is lit.
  struct View {
    std::vector<glm::vec3> framed;
    Orbit side;
    Box box;
  };
  // A pose by the truth, by plain skinning and by the last deformer that is shown.
  struct Compared {
    const std::vector<PosedMesh>& truth;
    const std::vector<PosedMesh>& plain;
    const std::vector<PosedMesh>& last;
  };
  // All of it, or a part, from where one sees best what the last deformer makes otherwise than plain skinning.
  View whole(const Compared& compared) const;
  View close_up(const Compared& compared, const Part& part) const;

  // Where a deformer has put the vertices in a pose. normals: empty for those of the triangles.
  std::vector<PosedMesh> posed(const deform::Pose& pose, const deform::Positions& positions,
                               std::vector<glm::dvec3> normals) const;

  // heat: its colours instead of the mesh's own, with a legend.
  Picture shoot(const std::vector<PosedMesh>& meshes, const View& view, const std::string& caption,
                const HeatMap* heat);

  // Adds to a row deformers and the truth in a pose, and how far the former are off.
  struct Scene {
    const deform::Pose& pose;
    const deform::Deformer& truth;
    const DeformerComparison& comparison;
    const std::vector<std::size_t>& deformers;  // indices into its rows, plain skinning first
  };
  using ViewOf = std::function<View(const Compared& compared)>;
  void draw(const Scene& scene, const ViewOf& view_of, PictureRow& row);

 private:
  const Study& study_;
  std::vector<glm::dvec3> bind_normals_;
  std::vector<std::byte> cooked_;
  AlignedBytes bytes_;
  File file_;
  std::optional<Gl> gl_;
  std::optional<Studio> studio_;
  std::optional<Textures> textures_;
  std::optional<Figure> figure_;
};

}  // namespace marrow::tools
