// What the colours of a heat map stand for, written into the picture.
#pragma once

#include <string>

#include "image/image.h"

namespace marrow::tools {

// Whether a largest distance is so far below the hottest colour that all of the map is the coldest.
bool shows_nothing(float largest_m, float full_scale_m);

// The ramp between "0" and what its hottest colour stands for, in millimetres. It ends at `right`, on the line
// `baseline`. Returns where it begins. Precondition: full_scale_m > 0.
int draw_ramp(Image& image, int right, int baseline, float cap_height, Rgb colour, float full_scale_m);

// The same in a strip along the lower edge, narrower than the margin round a framed figure, behind a heading and the
// largest distance. A map that shows nothing has no ramp, and a picture that is too small no strip.
void draw_legend(Image& image, const std::string& heading, float largest_m, float full_scale_m);

}  // namespace marrow::tools
