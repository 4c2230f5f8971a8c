// A brush for a joint's weights: what it is, and what it makes of one weight.
#pragma once

#include <cstdint>

#include "text/choices.h"

namespace marrow::tools {

enum class BrushMode : std::uint8_t { add, subtract, set, smooth };

inline constexpr Named<BrushMode> kBrushModes[] = {
    {"add", BrushMode::add}, {"subtract", BrushMode::subtract}, {"set", BrushMode::set}, {"smooth", BrushMode::smooth}};

// A plane of symmetry, of the model at rest.
struct MirrorPlane {
  int axis = -1;  // 0, 1, 2: across x, y, z; below 0: there is none
  float at = 0;   // scene units along the axis
  bool operator==(const MirrorPlane&) const = default;
};

struct Brush {
  BrushMode mode = BrushMode::add;
  float radius = 0;  // scene units
  float strength = 0.5f;
  MirrorPlane mirror;
  bool through = false;  // what is not joined to the surface under it, too
};

// 1 in the middle, 0 at the radius and beyond, flat at both: (1 - (d / r)²)². A radius that is not above 0 has no
// inside.
double falloff(double distance, double radius);

// The weight that the whole of a stroke makes of `before`. amount: 0 … 1, how much of the brush the vertex has felt.
// Not for smoothing, which depends on neighbours.
double painted_weight(const Brush& brush, double before, double amount);

}  // namespace marrow::tools
