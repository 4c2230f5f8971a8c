// A comparison as one self-contained page.
#pragma once

#include <string>
#include <vector>

#include "commands/compare/measure.h"
#include "commands/compare/pictures.h"

namespace marrow::tools {

// title: what was compared. truth: its name.
std::string comparison_page(const std::string& title, const std::string& truth, const Study& study,
                            const DeformerComparison& comparison, const std::vector<PictureRow>& pictures);

}  // namespace marrow::tools
