#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"

namespace marrow::tools {
namespace {

void brush_widgets(const Actor& actor, float scale, Settings& s) {
  for (const auto& [name, mode] : kBrushModes) {
    if (mode != BrushMode::add) ImGui::SameLine(0, 4 * scale);
    if (ImGui::RadioButton(name, s.brush.mode == mode)) s.brush.mode = mode;
  }
  label("radius", scale);
  const float all = actor.performance().radius();
  float radius = s.brush.radius;
  if (ImGui::SliderFloat("##radius", &radius, 0.002f * all, all, "%.3g m",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic) &&
      std::isfinite(radius))
    s.brush.radius = radius;
  label(s.brush.mode == BrushMode::set ? "weight" : "strength", scale);
  slider("##strength", s.brush.strength, 0, 1, "%.2f");
  ImGui::Checkbox("through, what is behind as well", &s.brush.through);
}

void mirror_widgets(const Actor& actor, float scale, Painting& painting, Settings& s) {
  label("mirror", scale);
  constexpr const char* kNames[] = {"off", "x", "y", "z"};
  for (int i = 0; i < 4; ++i) {
    if (i > 0) ImGui::SameLine(0, 4 * scale);
    if (ImGui::RadioButton(kNames[i], s.brush.mirror.axis == i - 1)) s.brush.mirror.axis = i - 1;
  }
  if (s.brush.mirror.axis < 0) return;
  label("across", scale);
  float at = s.brush.mirror.at;
  if (ImGui::InputFloat("##at", &at, 0, 0, "%.4g m") && std::isfinite(at)) s.brush.mirror.at = at;
  const NamedJoint& joint = actor.joints()[s.joint];
  const std::uint32_t image = painting.image_of(s.brush, joint.skeleton, joint.joint);
  const auto is_image = [&](const NamedJoint& j) { return j.skeleton == joint.skeleton && j.joint == image; };
  const std::string name = std::ranges::find_if(actor.joints(), is_image)->name;
  const std::size_t all = painting.canvas().bind.size(), with = painting.places_with_image(s.brush.mirror);
  quiet((image == joint.joint ? "both sides are this joint's" : "the other side is " + name + "'s") +
        (with < all ? fmt::format("; {} of {} vertices have no image", all - with, all) : ""));
}

void file_widgets(Painting& painting, Settings& s) {
  const History& history = painting.history();
  ImGui::BeginDisabled(history.done() == 0);
  if (ImGui::Button("undo")) painting.undo();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(history.undone() == 0);
  if (ImGui::Button("redo")) painting.redo();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(painting.saved());
  s.save_paint |= ImGui::Button("save");
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  quiet(painting.saved() ? "nothing to save" : "not saved");
  quiet(std::filesystem::path(painting.path()).filename().string());
}

}  // namespace

void paint_section(Actor& actor, float scale, Settings& s) {
  if (!section("Paint weights", s.painting)) return;
  if (actor.joints().empty()) return quiet("There are no joints.");
  ImGui::Checkbox("paint, with the left button", &s.painting);
  if (!s.painting) return;
  Painting& painting = actor.painting(s);
  if (!painting.refusal().empty()) return quiet(painting.refusal());
  if (!painting.trouble().empty()) quiet(painting.trouble());
  label("joint", scale);
  if (combo(
          "##painted", actor.joints().size(), [&](std::size_t i) { return actor.joints()[i].name; }, s.joint))
    s.show_joint = true;
  const NamedJoint& joint = actor.joints()[s.joint];
  if (painting.moved_by(joint.skeleton, joint.joint) == 0) quiet("It moves nothing yet.");
  const std::string without = painting.without(joint.skeleton, joint.joint);
  if (!without.empty()) quiet("The skin of " + without + " has not this joint: it cannot be painted there.");
  brush_widgets(actor, scale, s);
  mirror_widgets(actor, scale, painting, s);
  file_widgets(painting, s);
  if (painting.changed() && !painting.stroking() && *painting.changed() == 0)
    quiet("The last stroke met no vertex that it could change.");
  if (painting.kept() > 0)
    quiet(fmt::format("{} vertices kept their weight: no other joint moves them. Add another joint there.",
                      painting.kept()));
}

}  // namespace marrow::tools
