// What has been built, as the runtime takes it, and joint by joint in double precision.
#pragma once

#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "cook/scene/built.h"
#include "marrow/file.h"

namespace marrow::cook {

// Both point into what they are of. A skeleton's has no names.
Skeleton view(const BuiltSkeleton& skeleton);
Clip view(const BuiltClip& clip, const Skeleton& skeleton);

// A mesh at the level of detail that `geometry` is; without names, materials and morph targets' names.
Mesh view(const BuiltMesh& mesh, const BuiltGeometry& geometry);

struct Transform {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

// parent_from_joint.
glm::dmat4 matrix_of(const Transform& transform);

// The rest pose of a skeleton, joint by joint.
std::vector<Transform> rest_transforms(const BuiltSkeleton& skeleton);

}  // namespace marrow::cook
