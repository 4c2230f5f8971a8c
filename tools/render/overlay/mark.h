// Marks over pictures: where something is that has no surface.
#pragma once

#include <array>

#include "image/image.h"
#include "render/camera.h"

namespace marrow::tools {

// A ring round a point of the scene, with a soft edge; in front of everything. Behind the camera: nothing.
void draw_mark(Image& image, const Camera& camera, const std::array<float, 3>& point);

}  // namespace marrow::tools
