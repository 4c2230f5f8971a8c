// The mouse as a brush, over the picture.
#pragma once

#include <optional>

#include "commands/view/overlay/drawer.h"
#include "commands/view/paint/painting.h"
#include "commands/view/stage/view_settings.h"
#include "render/camera.h"

namespace marrow::tools {

// Where the brush is, and where it was pressed last.
struct BrushHand {
  std::optional<SurfaceHit> over;  // the surface under the mouse
  std::optional<ImVec2> last;      // points, of the last dab
};

// The left button paints where it goes down on the surface, until it is let go; from one place of the mouse to the next
// in steps of a quarter of the brush. With Ctrl or Shift held it does not. left: where the picture begins, points.
// Whether the mouse is the brush's, and no one else's. Call Painting::pose() before. Precondition: painting has no
// refusal().
bool use_brush(Painting& painting, const Camera& camera, float left, std::uint32_t skeleton, std::uint32_t joint,
               const Settings& settings, BrushHand& hand);

// A ring on the surface.
void draw_brush(const BrushHand& hand, const Brush& brush, Drawer& drawer);

}  // namespace marrow::tools
