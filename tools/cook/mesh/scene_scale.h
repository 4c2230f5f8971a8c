// How large what is measured in a mesh's own units is in the scene.
#pragma once

#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"
#include "cook/skin/primitive_palette.h"

namespace marrow::cook {

// In the rest pose; the largest of all directions, joints and places where a mesh stands.
class SceneScale {
 public:
  SceneScale(const std::vector<BuiltSkeleton>& skeletons, const RawScene& scene);

  // Of what is drawn through a palette.
  double of(std::uint32_t skeleton, const std::vector<std::uint16_t>& joints,
            const std::vector<Affine>& inverse_bind) const;
  // model_from_mesh of each palette entry; helpers blend those of their joints.
  std::vector<glm::dmat4> places(int skeleton, const Palette& palette) const;
  // Of a mesh wherever the scene has it; built: skeletons, and which joint a node is.
  double of(const RawScene& scene, const BuiltScene& built, int mesh) const;

 private:
  double of_joint(int skeleton, int joint, const glm::dmat4& joint_from_mesh) const;

  std::vector<std::vector<Affine>> rest_;            // model_from_joint, a skeleton
  std::vector<std::vector<std::size_t>> instances_;  // a mesh
};

}  // namespace marrow::cook
