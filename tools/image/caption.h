// Small print in pictures: a stroke font of the project's own, drawn with soft edges at any size.
#pragma once

#include <string_view>

#include "image/image.h"

namespace marrow::tools {

// ASCII; other characters come out as question marks. x, y: left end of the baseline, pixels. cap_height: pixels.
// Returns the x where the text ends.
float draw_text(Image& image, float x, float y, float cap_height, Rgb colour, std::string_view text);

// Pixels that draw_text() would take.
float text_width(float cap_height, std::string_view text);

}  // namespace marrow::tools
