#include <fmt/format.h>

#include "commands/view/overlay/among_figures.h"
#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"

namespace marrow::tools {

void overlay_section(const Actor& actor, float scale, Settings& s) {
  if (!section("Overlays", true)) return;
  int column = 0;
  for (const auto& [name, flag] : kOverlays) {
    if (column++ % 3 != 0) ImGui::SameLine(static_cast<float>((column - 1) % 3) * 90 * scale + 14 * scale);
    ImGui::Checkbox(name, &(s.overlays.*flag));
  }
  if (s.overlays.grid) quiet("a square of the grid: " + length_of_square(actor.performance().radius()));
  ImGui::BeginDisabled(actor.plays()[s.clip].play.duration_s <= 0);
  label("ghosts", scale);
  ImGui::SliderInt("##ghosts", &s.overlays.ghosts, 0, 4, s.overlays.ghosts == 0 ? "none" : "%d before and after",
                   ImGuiSliderFlags_AlwaysClamp);
  if (s.overlays.ghosts > 0) {
    label("apart", scale);
    ImGui::SliderInt("##apart", &s.overlays.ghost_step, 1, 30, "%d frames", ImGuiSliderFlags_AlwaysClamp);
  }
  ImGui::EndDisabled();
}

}  // namespace marrow::tools
