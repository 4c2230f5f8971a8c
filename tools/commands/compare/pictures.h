// Deformers side by side, drawn at the poses in which linear blend skinning is worst.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "commands/compare/measure.h"

namespace marrow::tools {

struct Picture {
  std::string caption;
  std::vector<std::byte> png;
};

// A row a pose: the truth, deformers, and how far those are from it as colours.
struct PictureRow {
  std::string title;
  std::vector<Picture> pictures;
};

// deformers: indices into the comparison's rows. At most `most` poses, no two of one clip.
std::vector<PictureRow> draw_worst_poses(const Study& study, const DeformerComparison& comparison,
                                         const deform::Deformer& truth, const std::vector<std::size_t>& deformers,
                                         std::size_t most);

}  // namespace marrow::tools
