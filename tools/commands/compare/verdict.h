// One sentence: which deformer should this character use?
#pragma once

#include <string>

#include "commands/compare/measure.h"

namespace marrow::tools {

std::string verdict(const DeformerComparison& comparison);

}  // namespace marrow::tools
