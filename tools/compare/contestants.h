// The deformers that are compared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/study.h"
#include "deform/helpers/tangents.h"

namespace marrow::tools {

// What a deformer has become by training. Poses are given without helpers.
struct Trained {
  deform::Deformer deform;
  // What normals go through: for each vertex the weights of the joints' matrices, or tangents where it has them. Over
  // poses as `extend` makes them.
  std::vector<std::vector<deform::Influence>> blend;
  deform::TangentCoordinates tangents;
  std::function<std::vector<glm::dvec3>(const deform::Pose&)> normals;  // instead of both, if it is set
  std::function<deform::Pose(const deform::Pose&)> extend;
  double displacements = 0;  // stored a vertex, the mean; EigenSkin alone has some
};

// The normals that pictures show, unit, 0 where they have no direction: a deformer's own, or through the blended
// matrix. bind_normals: of the bind pose's triangles.
std::vector<glm::dvec3> shading_normals(const Trained& trained, const std::vector<glm::dvec3>& bind_normals,
                                        const deform::Pose& pose);
// One through the blended matrix. extended: as Trained::extend makes it.
glm::dvec3 blended_normal(const std::vector<deform::Influence>& blend, const deform::Pose& extended,
                          const glm::dvec3& bind_normal);

struct Contestant {
  std::string name;
  std::function<Trained(const Study& study, const Round& round, const cook::LearnOptions& options)> train;
  cook::LearnOptions cooked;  // how `marrow cook` makes it
  enum class Kernel { rigid, ssd, as, psd, mwe } kernel = Kernel::ssd;
  bool can_be_cooked = true;
};

// What no character is deformed by any more: rigid segments, and what came between them and SSD.
bool is_before_ssd(const std::string& deformer);

// options: truth and delta mush; the rest is each contestant's own. EigenSkin turns joints alone, so it takes no part
// where the truth is examples.
std::vector<Contestant> contestants(const cook::LearnOptions& options, int eigen_fields);

}  // namespace marrow::tools
