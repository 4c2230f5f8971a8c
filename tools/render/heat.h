// How far apart two deformers put the same vertices, as colours.
#pragma once

#include <vector>

#include "pose/evaluate.h"
#include "render/image.h"

namespace marrow::tools {

struct HeatMap {
  std::vector<std::vector<float>> colours;  // a mesh: 4 floats a slot, linear
  float largest = 0;                        // distance, scene units
  float full_scale = 0;                     // distance at the hot end of the ramp
};

// full_scale: what the hottest colour stands for, scene units, > 0.
HeatMap compare(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b, float full_scale);

// The largest distance alone.
float largest_distance(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b);

// A hottest colour worth showing: the largest distance, but at least a thousandth of the diagonal, so that rounding
// errors do not glow.
float sensible_scale(float largest, float diagonal);

// sRGB of the ramp at t, 0 … 1: slate, violet, red, amber, pale yellow; lightness rises evenly.
Rgb heat_colour(float t);

}  // namespace marrow::tools
