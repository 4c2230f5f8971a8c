// What happens over the picture: the mouse moves the camera, chooses joints, drags goals, and paints; joints are drawn.
#pragma once

#include <optional>

#include "commands/view/overlay/drawer.h"
#include "paint/painting.h"
#include "render/camera.h"
#include "stage/actor.h"
#include "stage/settings.h"

namespace marrow::tools {

// The place of a joint of Actor::joints(), model space.
glm::vec3 place_of(const Actor& actor, std::size_t joint);

// A goal where the chosen joint is.
void add_goal(const Actor& actor, Settings& settings);

// What the left button began to do when it went down.
struct Dragging {
  std::size_t goal = kNone;
  float moved = 0;       // points, since it went down
  bool pressed = false;  // over the picture
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

// Turns, moves and zooms the camera; a click chooses the nearest joint, or none; a goal's square is dragged in the
// plane of the picture. picture_height: points.
void use_mouse(const Actor& actor, const Drawer& drawer, float picture_height, Dragging& dragging, Settings& settings);

// Bones, names, axes, the trail of the chosen joint, goals, as the settings ask.
void draw_joints(Actor& actor, const Settings& settings, Drawer& drawer);

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
               const Brush& brush, BrushHand& hand);

// A ring on the surface.
void draw_brush(const BrushHand& hand, const Brush& brush, Drawer& drawer);

}  // namespace marrow::tools
