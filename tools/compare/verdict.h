// Which deformer should this character use, and why not what is nearest to the truth?
#pragma once

#include <string>
#include <vector>

#include "compare/motion_study.h"

namespace marrow::tools {

struct Verdict {
  std::string deformer;          // the row that is recommended: none that looks worse than plain skinning
  std::string use;               // one sentence
  std::vector<std::string> why;  // what else there is to know, each a sentence or two
};

// What looks worse than plain skinning: flips, bends or creases more, as far as the tables show, or jumps.
bool is_uglier(const SurfaceLook& look, const SurfaceLook& plain);

Verdict verdict(const Study& study, const std::string& truth, const DeformerComparison& comparison,
                const MotionStudy& motion);

}  // namespace marrow::tools
