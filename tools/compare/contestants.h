// The deformers that are compared.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "compare/study.h"

namespace marrow::tools {

// What a deformer has become by training. Poses are given without half-joints.
struct Trained {
  deform::Deformer deform;
  // What normals go through: for each vertex the weights of the joints' matrices, over poses as `extend` makes them.
  std::vector<std::vector<deform::Influence>> blend;
  std::function<deform::Pose(const deform::Pose&)> extend;
};

struct Contestant {
  std::string name;
  std::function<Trained(const Study& study, const Round& round, const cook::LearnOptions& options)> train;
  cook::LearnOptions cooked;  // how `marrow cook` makes it
  enum class Kernel { rigid, ssd, as, mwe, psd } kernel = Kernel::ssd;
  bool can_be_cooked = true;
};

// options: truth and delta mush; the rest is each contestant's own.
std::vector<Contestant> contestants(const cook::LearnOptions& options);

}  // namespace marrow::tools
