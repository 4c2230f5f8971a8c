// Errors over clips as charts, SVG inside a page.
#pragma once

#include <string>

#include "commands/compare/measure.h"

namespace marrow::tools {

// Text of a page's body, with nothing in it that HTML would take for markup.
std::string escaped(const std::string& text);

// A key and a chart a clip, of the first round; empty if there is nothing to draw. Lines that would flatten the others
// are hidden until the page's script shows them.
std::string charts(const Study& study, const DeformerComparison& comparison);

}  // namespace marrow::tools
