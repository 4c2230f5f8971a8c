// Deformers side by side: in the poses in which linear blend skinning is worst, and, from near by, the joints that are
// worst in their range of motion.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "compare/measure.h"
#include "compare/motion_study.h"

namespace marrow::tools {

struct Picture {
  std::string caption;
  std::vector<std::byte> jpeg;
  std::function<std::vector<std::byte>()> png;  // at full colour
};

// A row a pose.
struct PictureRow {
  std::string title;
  std::vector<Picture> shapes;    // plain skinning first, other deformers, the truth last
  std::vector<Picture> errors;    // how far those are from it, as colours that mean the same in the row
  double scale_m = 0;             // what the hottest colour stands for
  std::vector<std::string> ramp;  // the colours from the coldest on, as style sheets have them
};

// deformers: indices into the comparison's rows. At most `most` poses, no two of one clip.
std::vector<PictureRow> draw_worst_poses(const Study& study, const DeformerComparison& comparison,
                                         const deform::Deformer& truth, const std::vector<std::size_t>& deformers,
                                         std::size_t most);

// Of the poses in which the truth does not fold the one in which the last of `deformers` is farthest from it, and the
// twist in which that has the narrowest ring. deformers: indices into the comparison's rows.
std::vector<PictureRow> draw_worst_joints(const Study& study, const DeformerComparison& comparison,
                                          const MotionStudy& motion, const deform::Deformer& truth,
                                          const std::vector<std::size_t>& deformers);

}  // namespace marrow::tools
