// A comparison as one self-contained page.
#pragma once

#include <string>
#include <vector>

#include "commands/compare/motion/motion_study.h"
#include "commands/compare/pictures.h"
#include "commands/compare/verdict.h"

namespace marrow::tools {

// What a page is made of. title: what was compared. truth: its name.
struct PageContent {
  std::string title, truth;
  const Study& study;
  const DeformerComparison& comparison;
  const MotionStudy& motion;
  const Verdict& verdict;
  std::vector<PictureRow> worst_poses, worst_joints;
};
std::string comparison_page(const PageContent& content);

// Shapes above, and below each how far it is from the truth.
std::string picture_row(const PictureRow& row);

}  // namespace marrow::tools
