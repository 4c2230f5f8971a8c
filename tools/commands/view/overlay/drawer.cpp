#include "commands/view/overlay/drawer.h"

#include <cmath>
#include <utility>

#include <glm/vec4.hpp>

namespace marrow::tools {
namespace {

constexpr ImU32 kDark = IM_COL32(12, 16, 20, 190), kBehindWords = IM_COL32(12, 16, 20, 130);

ImVec2 in_window(const glm::vec4& clip, float left) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  return {left + (0.5f + 0.5f * clip.x / clip.w) * (window.x - left), (0.5f - 0.5f * clip.y / clip.w) * window.y};
}

}  // namespace

Drawer::Drawer(const Camera& camera, float left)
    : camera_(camera), left_(left), list_(*ImGui::GetBackgroundDrawList()) {
  list_.PushClipRect({left, 0}, ImGui::GetIO().DisplaySize);
}

Drawer::~Drawer() {
  list_.PopClipRect();
}

std::optional<ImVec2> Drawer::project(glm::vec3 place) const {
  const glm::vec4 clip = camera_.clip_from_model * glm::vec4(place, 1);
  if (clip.w <= 0 || clip.z < -clip.w) return std::nullopt;
  return in_window(clip, left_);
}

void Drawer::line(glm::vec3 from, glm::vec3 to, ImU32 colour, float width) {
  glm::vec4 a = camera_.clip_from_model * glm::vec4(from, 1), b = camera_.clip_from_model * glm::vec4(to, 1);
  const float before_a = a.z + a.w, before_b = b.z + b.w;  // the near plane
  if (before_a <= 0 && before_b <= 0) return;
  const glm::vec4 cut = a + (b - a) * (before_a / (before_a - before_b));
  if (before_a < 0) a = cut;
  if (before_b < 0) b = cut;
  if (a.w <= 0 || b.w <= 0) return;
  list_.AddLine(in_window(a, left_), in_window(b, left_), kDark, width + 2);
  list_.AddLine(in_window(a, left_), in_window(b, left_), colour, width);
}

void Drawer::point(glm::vec3 at, float radius, ImU32 colour) {
  const std::optional<ImVec2> where = project(at);
  if (!where) return;
  list_.AddCircleFilled(*where, radius + 1.2f, kDark, 16);
  list_.AddCircleFilled(*where, radius, colour, 16);
}

void Drawer::square(glm::vec3 at, float radius, ImU32 colour) {
  const std::optional<ImVec2> where = project(at);
  if (!where) return;
  const auto box = [&](float r, ImU32 c, float width) {
    list_.AddRect({where->x - r, where->y - r}, {where->x + r, where->y + r}, c, 0, 0, width);
  };
  box(radius, kDark, 4);
  box(radius, colour, 2);
}

void Drawer::words(glm::vec3 at, const std::string& text, ImU32 colour) {
  const std::optional<ImVec2> where = project(at);
  if (!where) return;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const bool fits = where->x + 8 + size.x <= ImGui::GetIO().DisplaySize.x;
  const ImVec2 corner(std::round(fits ? where->x + 8 : where->x - 8 - size.x), std::round(where->y - 0.5f * size.y));
  const ImVec4 box(corner.x - 2, corner.y - 1, corner.x + size.x + 2, corner.y + size.y + 1);
  for (const ImVec4& other : taken_)
    if (box.x < other.z && other.x < box.z && box.y < other.w && other.y < box.w) return;
  taken_.push_back(box);
  list_.AddRectFilled({box.x, box.y}, {box.z, box.w}, kBehindWords, 2);
  list_.AddText(corner, colour, text.c_str());
}

}  // namespace marrow::tools
