// What happens over the picture: the mouse moves the camera, and bones are drawn.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <glm/vec4.hpp>

#include "commands/view/panel.h"

namespace marrow::tools {
namespace {

constexpr float kTurn = 0.008f;                    // radians a point
constexpr float kZoom = 0.12f;                     // a step of the wheel
constexpr float kLowest = -0.6f, kHighest = 1.5f;  // radians above the horizon

// Where a point of the scene is in the window; false behind the camera.
bool project(const Camera& camera, const Affine& joint, float left, ImVec2& out) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const glm::vec4 clip = camera.clip_from_scene * glm::vec4(joint.rows[0][3], joint.rows[1][3], joint.rows[2][3], 1);
  if (clip.w <= 0 || clip.z < -clip.w) return false;
  out = {left + (0.5f + 0.5f * clip.x / clip.w) * (window.x - left), (0.5f - 0.5f * clip.y / clip.w) * window.y};
  return true;
}

void draw_bone(ImDrawList& list, ImVec2 from, ImVec2 to, ImU32 colour) {
  list.AddLine(from, to, IM_COL32(12, 16, 20, 190), 3.5f);
  list.AddLine(from, to, colour, 1.6f);
}

void draw_joint(ImDrawList& list, ImVec2 at, float radius, ImU32 colour) {
  list.AddCircleFilled(at, radius + 1.2f, IM_COL32(12, 16, 20, 210), 12);
  list.AddCircleFilled(at, radius, colour, 12);
}

}  // namespace

void use_mouse(float picture_height, float radius, Settings& settings) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse || picture_height <= 0) return;
  Orbit& orbit = settings.orbit;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool move = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                    (left && io.KeyShift);
  if (move) {
    const float unit = view_height() * orbit.distance / picture_height;
    orbit.target += unit * (io.MouseDelta.y * up_of(orbit) - io.MouseDelta.x * right_of(orbit));
  } else if (left) {
    orbit.yaw = std::remainder(orbit.yaw - kTurn * io.MouseDelta.x, 6.2831853f);
    orbit.pitch = std::clamp(orbit.pitch + kTurn * io.MouseDelta.y, kLowest, kHighest);
  }
  orbit.distance = std::clamp(orbit.distance * std::exp(-kZoom * io.MouseWheel), 0.02f * radius, 40 * radius);
}

void draw_bones(const Actor& actor, const Settings& settings, const Camera& camera, float left) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  list.PushClipRect({left, 0}, window);
  constexpr ImU32 kBone = IM_COL32(236, 233, 226, 255), kChosen = IM_COL32(255, 176, 64, 255);
  for (std::size_t i = 0; i < actor.joints().size(); ++i) {
    const NamedJoint& joint = actor.joints()[i];
    const std::span<const Affine> places = actor.character().scene_from_joint(joint.skeleton);
    const std::uint16_t parent = actor.file().skeleton(joint.skeleton).parents[joint.joint];
    ImVec2 from, to;
    if (parent != kNoParent && project(camera, places[parent], left, from) &&
        project(camera, places[joint.joint], left, to))
      draw_bone(list, from, to, kBone);
  }
  for (std::size_t i = 0; i < actor.joints().size(); ++i) {
    const NamedJoint& joint = actor.joints()[i];
    const bool chosen = settings.colours == Colours::weights && i == settings.joint;
    ImVec2 at;
    if (project(camera, actor.character().scene_from_joint(joint.skeleton)[joint.joint], left, at))
      draw_joint(list, at, chosen ? 5.0f : 2.2f, chosen ? kChosen : kBone);
  }
  list.PopClipRect();
}

}  // namespace marrow::tools
