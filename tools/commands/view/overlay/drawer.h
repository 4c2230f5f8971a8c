// Lines, points and words over the picture, at places of the scene; nothing hides them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include <glm/vec3.hpp>

#include "marrow/pose.h"
#include "marrow/roles.h"
#include "render/camera.h"
#include "render/overlay/ground.h"

namespace marrow::tools {

class Drawer {
 public:
  // left: where the picture begins, points; it ends with the window.
  Drawer(const Camera& camera, float left);
  ~Drawer();
  Drawer(const Drawer&) = delete;
  Drawer& operator=(const Drawer&) = delete;

  // Where in the window; nullopt behind the camera.
  std::optional<ImVec2> project(glm::vec3 place) const;
  // Dark about it, so that it is seen on any ground. What reaches behind the camera is cut off there.
  void line(glm::vec3 from, glm::vec3 to, ImU32 colour, float width);
  void point(glm::vec3 at, float radius, ImU32 colour);
  void square(glm::vec3 at, float radius, ImU32 colour);
  // To the right of the place, or, where the window ends, to the left; not at all if that would be over other words:
  // what is more important comes first.
  void words(glm::vec3 at, const std::string& text, ImU32 colour);

 private:
  Camera camera_;
  float left_;
  ImDrawList& list_;
  std::vector<ImVec4> taken_;  // by words: left, top, right, bottom
};

// Of a foot or a hand that stands.
inline ImU32 colour_of(Role role) {
  const Rgb rgb = foot_colour(role);
  return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
}

inline glm::vec3 place_of(const Affine& joint) {
  return {joint.rows[0][3], joint.rows[1][3], joint.rows[2][3]};
}

}  // namespace marrow::tools
