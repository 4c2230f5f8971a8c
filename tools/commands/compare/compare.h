// `marrow compare`: which deformer should this character use?
#pragma once

#include <string>
#include <vector>

#include "commands/compare/contestants.h"
#include "commands/compare/study.h"
#include "cook/options/options.h"

namespace marrow::tools {

struct CompareArguments {
  std::string in, sample;
  Holdout holdout = Holdout::frames;
  std::string out;                                                 // HTML; empty: none
  std::string pictures;                                            // folder of the page's pictures; empty: none
  std::vector<std::string> shown = {"as_fit", "as_helpers_fit5"};  // rows that pictures are of, beside SSD
  bool json = false;
  bool thesis = false, full = false;  // the thesis's comparison instead; with every path and normals
  int eigen_fields = kEigenFields;
  std::vector<double> frames_hz;  // for each: how far clips are off between so many frames a second
  cook::Options given;            // --truth, --delta-mush, --keep-bind-pose, as for `cook`
};

// Throws Failure.
void run_compare(const CompareArguments& arguments);

}  // namespace marrow::tools
