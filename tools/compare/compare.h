// `marrow compare`: which deformer should this character use? The door of this folder: what is behind it is its own.
#pragma once

#include <string>
#include <vector>

#include "cook/options/options.h"
#include "text/choices.h"

namespace marrow::tools {

// What is judged by and not learnt from.
enum class Holdout { frames, clips };
inline constexpr Named<Holdout> kHoldouts[] = {{"frames", Holdout::frames}, {"clips", Holdout::clips}};

// EigenSkin's fields a joint.
inline constexpr int kEigenFields = 4, kMostEigenFields = 16;

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
