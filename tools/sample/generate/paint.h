// Colours the skin, vertex by vertex.
#pragma once

#include <glm/glm.hpp>

#include "shape.h"

namespace marrow::sample {

// From 8-bit sRGB, as a paint program shows it, to the linear values that glTF wants in COLOR_0.
glm::vec3 linear_rgb(int red, int green, int blue);

glm::vec3 skin_colour(const Shape& shape, glm::vec3 position, glm::vec3 normal);

}  // namespace marrow::sample
