// A study's mesh as the studio draws it, wherever deformers put its vertices.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "commands/compare/pictures.h"
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
  // All of a pose, as pictures of characters are taken.
  static View whole(const std::vector<PosedMesh>& meshes);

  // Where a deformer has put the vertices in a pose. normals: empty for those of the triangles.
  std::vector<PosedMesh> posed(const deform::Pose& pose, const deform::Positions& positions,
                               std::vector<glm::dvec3> normals) const;

  // heat: its colours instead of the mesh's own, with a legend.
  Picture shoot(const std::vector<PosedMesh>& meshes, const View& view, const std::string& caption,
                const HeatMap* heat);

  // Adds to a row the truth and deformers in a pose, and how far these are off. view_of: seen as the truth is.
  struct Scene {
    const deform::Pose& pose;
    const deform::Deformer& truth;
    const DeformerComparison& comparison;
    const std::vector<std::size_t>& deformers;  // indices into its rows
  };
  using ViewOf = std::function<View(const std::vector<PosedMesh>& truth)>;
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
