// What a rigger has to give for each algorithm, in numbers, files and poses.
#pragma once

#include <string>

#include "commands/compare/study.h"

namespace marrow::tools {

struct Labour {
  double numbers_per_vertex = 0;  // that somebody paints or sets
  std::size_t files = 0;          // beside the model
  std::size_t poses = 0;          // that somebody shapes; 0 also where they are learnt from another deformer
  std::string of_what;            // those numbers are
};

// deformer: a row of compare, or a truth. An algorithm that learns takes its poses from the model's clips and its
// shapes from the truth, so that nobody shapes them; with --truth examples somebody has.
Labour labour_of(const std::string& deformer, const Study& study, std::size_t shown_poses);

}  // namespace marrow::tools
