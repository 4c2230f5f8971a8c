// `marrow compare --thesis`: the comparison of algorithms that the thesis of animation space makes, made anew.
#pragma once

#include "compare/compare.h"
#include "compare/measure.h"
#include "compare/pictures.h"
#include "compare/thesis/rates.h"
#include "compare/thesis/smoothness.h"

namespace marrow::tools {

// A row of its first table: speed, labour, smoothness.
struct ThesisRow {
  std::string algorithm;
  double ns_per_vertex = 0;         // of the runtime's kernel; 0: it has none
  double double_ns_per_vertex = 0;  // offline, in double precision, one core
  Labour labour;
  double learn_s = 0;      // by the cooker
  double held_of_ssd = 0;  // RMS error in poses held out, over SSD's; 0 for the truths
  Smoothness bends, twists;
};

struct ThesisStudy {
  std::string name;
  std::size_t vertices = 0, joints = 0;
  std::vector<ThesisRow> rows;
  std::vector<PictureRow> pictures;
};

struct Thesis {
  std::vector<ThesisStudy> studies;
  std::vector<FrameRate> rates;
  std::string driver;  // empty: no OpenGL ES
};

// The algorithm as it is called and who it is from.
std::string title_of_algorithm(const std::string& algorithm);

// What the thesis says, what holds here, and why.
struct Claim {
  std::string claim, holds, why;
};
std::vector<Claim> claims(const Thesis& thesis);

std::string thesis_page(const Thesis& thesis);

// Throws Failure.
void run_thesis(const CompareArguments& arguments, const cook::LearnOptions& options);

}  // namespace marrow::tools
