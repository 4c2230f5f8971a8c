// How far apart two deformers put the same vertices, as colours.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
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

// The legend: what the colours stand for, written into the picture.

// Whether a largest distance is so far below the hottest colour that all of the map is the coldest.
bool shows_nothing(float largest_m, float full_scale_m);

// The ramp between "0" and what its hottest colour stands for, in millimetres. It ends at `right`, on the line
// `baseline`. Returns where it begins. Precondition: full_scale_m > 0.
int draw_ramp(Image& image, int right, int baseline, float cap_height, Rgb colour, float full_scale_m);

// The same in a strip along the lower edge, narrower than the margin round a framed figure, behind a heading and the
// largest distance. A map that shows nothing has no ramp, and a picture that is too small no strip.
void draw_legend(Image& image, const std::string& heading, float largest_m, float full_scale_m);

}  // namespace marrow::tools
