// How far apart two deformers put the same vertices, as colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"
#include "pose/evaluate.h"

namespace marrow::tools {

// How much light falls on what is coloured by numbers (Shot::shading).
inline constexpr float kHeatShading = 0.25f;

struct HeatMap {
  std::vector<std::vector<float>> colours;  // a mesh: 4 floats a slot, linear
  float largest = 0;                        // distance, scene units
  float full_scale = 0;                     // distance at the hot end of the ramp
};

// full_scale: what the hottest colour stands for, scene units, > 0.
HeatMap compare(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b, float full_scale);

// The vertex that two deformers put farthest apart; the first of equals.
struct Farthest {
  std::uint32_t mesh = 0;
  std::size_t slot = 0;
  float distance = 0;  // scene units
};
Farthest farthest(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b);

// Its distance alone.
float largest_distance(const std::vector<PosedMesh>& a, const std::vector<PosedMesh>& b);

// A hottest colour worth showing: the largest distance, but at least a thousandth of the diagonal, so that rounding
// errors do not glow.
float sensible_scale(float largest, float diagonal);

// The weight of one joint of a mesh's skeleton, 0 … 1: a float a slot. Of a helper's weight its two joints have
// their shares.
std::vector<float> joint_weights(const Mesh& mesh, std::uint32_t joint);

// Numbers 0 … 1 as colours: 4 floats each, linear.
std::vector<float> ramp_colours(const std::vector<float>& numbers);

// sRGB of the ramp at t, 0 … 1: slate, violet, red, amber, pale yellow; lightness rises evenly.
Rgb heat_colour(float t);

}  // namespace marrow::tools
