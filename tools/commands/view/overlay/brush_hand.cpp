#include "commands/view/overlay/brush_hand.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr ImU32 kRing = IM_COL32(250, 246, 236, 255), kCore = IM_COL32(250, 246, 236, 150);
constexpr int kSides = 40;
constexpr int kMostSteps = 32;  // of one movement of the mouse

std::optional<SurfaceHit> hit_at(const Painting& painting, const Camera& camera, float left, ImVec2 mouse) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (window.x <= left || window.y <= 0) return std::nullopt;
  const glm::vec2 at(2 * (mouse.x - left) / (window.x - left) - 1, 1 - 2 * mouse.y / window.y);
  return painting.hit(ray_through(camera.clip_from_model, at));
}

// Points of the window that the brush's radius is long, where it is.
float radius_in_points(const SurfaceHit& hit, const Camera& camera, float radius) {
  const glm::vec4 clip = camera.clip_from_model * glm::vec4(hit.place, 1);
  return 0.5f * ImGui::GetIO().DisplaySize.y * radius / (std::max(clip.w, 1e-20f) * 0.5f * view_height());
}

void dab_along(Painting& painting, const Camera& camera, float left, ImVec2 to, float radius, BrushHand& hand) {
  if (hand.over && !hand.last) painting.dab(*hand.over);
  const ImVec2 from = hand.last.value_or(to);
  hand.last = to;
  const float way = std::hypot(to.x - from.x, to.y - from.y);
  if (way == 0) return;
  const float step = hand.over ? 0.25f * radius_in_points(*hand.over, camera, radius) : way;
  const int steps = std::clamp(static_cast<int>(std::ceil(way / std::max(step, 1.0f))), 1, kMostSteps);
  for (int i = 1; i <= steps; ++i) {
    const float share = static_cast<float>(i) / static_cast<float>(steps);
    const ImVec2 at(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y));
    const std::optional<SurfaceHit> hit = hit_at(painting, camera, left, at);
    if (hit) painting.dab(*hit);
  }
}

void draw_ring(const SurfaceHit& hit, float radius, ImU32 colour, float width, Drawer& drawer) {
  const glm::vec3 aside = std::abs(hit.normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 right = glm::normalize(glm::cross(aside, hit.normal)), up = glm::cross(hit.normal, right);
  const auto at = [&](int side) {
    const float angle = 6.2831853f * static_cast<float>(side) / kSides;
    return hit.place + radius * (std::cos(angle) * right + std::sin(angle) * up);
  };
  for (int side = 0; side < kSides; ++side) drawer.line(at(side), at(side + 1), colour, width);
}

}  // namespace

bool use_brush(Painting& painting, const Camera& camera, float left, std::uint32_t skeleton, std::uint32_t joint,
               const Settings& settings, BrushHand& hand) {
  const ImGuiIO& io = ImGui::GetIO();
  if (painting.stroking() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) painting.end();
  hand.over.reset();
  if (io.WantCaptureMouse && !painting.stroking()) return false;
  hand.over = hit_at(painting, camera, left, io.MousePos);
  if (!painting.stroking()) {
    hand.last.reset();
    if (!hand.over || !ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.KeyShift || io.KeyCtrl) return false;
    painting.begin(settings.brush, skeleton, joint);
  }
  dab_along(painting, camera, left, io.MousePos, settings.brush.radius, hand);
  return true;
}

void draw_brush(const BrushHand& hand, const Brush& brush, Drawer& drawer) {
  if (!hand.over) return;
  draw_ring(*hand.over, brush.radius, kRing, 1.6f, drawer);
  draw_ring(*hand.over, 0.5f * brush.radius, kCore, 1, drawer);
}

}  // namespace marrow::tools
