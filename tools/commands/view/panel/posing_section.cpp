#include <algorithm>

#include <fmt/format.h>

#include "commands/view/overlay/picture.h"
#include "commands/view/panel/sections.h"
#include "commands/view/panel/widgets.h"

namespace marrow::tools {
namespace {

void goals(const Actor& actor, float scale, Settings& s) {
  label("solver", scale);
  const auto name = [](std::size_t i) { return std::string(kIkSolvers[i].name); };
  auto chosen =
      static_cast<std::size_t>(std::ranges::find(kIkSolvers, s.reach.solver, &Named<ReachSolver>::value) - kIkSolvers);
  if (combo("##solver", std::size(kIkSolvers), name, chosen)) s.reach.solver = kIkSolvers[chosen].value;
  ImGui::BeginDisabled(!s.reach.solver.method);
  label("joints", scale);
  auto joints = static_cast<int>(s.reach.joints);
  if (ImGui::SliderInt("##joints", &joints, 1, 16, "%d above turn", ImGuiSliderFlags_AlwaysClamp))
    s.reach.joints = static_cast<std::uint32_t>(joints);
  ImGui::EndDisabled();
  ImGui::BeginDisabled(!s.picked);
  if (ImGui::Button("a goal for the joint")) add_goal(actor, s);
  ImGui::EndDisabled();
  for (std::size_t i = 0; i < s.reach.goals.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool gone = ImGui::SmallButton("x");
    ImGui::SameLine();
    quiet(s.reach.goals[i]);
    ImGui::PopID();
    if (gone) s.reach.goals.erase(s.reach.goals.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void springs(const Actor& actor, float scale, Settings& s) {
  const bool has = actor.rig().has_springs();
  ImGui::BeginDisabled(!s.picked && !has);
  ImGui::Checkbox(has ? "the file's springs" : "springs below the joint", &s.springs);
  ImGui::EndDisabled();
  if (!s.springs || has) return;
  label("swings", scale);
  slider("##frequency", s.spring.frequency_hz, 0, 15, "%.2f Hz");
  label("damping", scale);
  slider("##damping", s.spring.damping_ratio, 0, 1.5f, "%.2f");
  label("gravity", scale);
  slider("##gravity", s.spring.gravity, -10, 10, "%.2f");
  label("drag", scale);
  slider("##drag", s.spring.drag, 0, 50, "%.1f 1/s");
}

bool has_limits(const File& file) {
  for (std::uint32_t i = 0; i < file.skeleton_count(); ++i)
    if (!file.skeleton(i).limits.empty()) return true;
  return false;
}

}  // namespace

void pose_section(const Actor& actor, float scale, Settings& s) {
  if (!section("Limits, goals, springs", s.limits || s.springs || !s.reach.goals.empty())) return;
  ImGui::BeginDisabled(!has_limits(actor.file()));
  ImGui::Checkbox(has_limits(actor.file()) ? "within the file's limits" : "the file has no limits", &s.limits);
  ImGui::EndDisabled();
  if (actor.rehearsal() == nullptr) goals(actor, scale, s);
  springs(actor, scale, s);
  if (!actor.rig().trouble().empty()) quiet(actor.rig().trouble());
}

namespace {

// A slider each, as wide as the examples lie.
void parameters(const Actor& actor, Settings& s) {
  const std::vector<ExampleSpace>& spaces = actor.character().shapes().spaces();
  for (std::size_t i = 0; i < spaces.size(); ++i) {
    const std::size_t count = spaces[i].parameters.size;
    for (std::size_t p = 0; p < count; ++p) {
      const std::string name = actor.file().text(spaces[i].parameters[p].name);
      float value = actor.character().shapes().value(i, p), least = value, most = value;
      for (std::size_t k = 0; k < spaces[i].example_count; ++k) {
        least = std::min(least, spaces[i].places[k * count + p]);
        most = std::max(most, spaces[i].places[k * count + p]);
      }
      ImGui::PushID(static_cast<int>(kMaxExampleParameters * i + p));
      quiet(fmt::format("{}: {}", spaces[i].name, name));
      ImGui::SetNextItemWidth(-1);
      if (slider("##parameter", value, least, most, s.parameters.contains(name) ? "%.2f" : "%.2f, the clip's"))
        s.parameters[name] = value;
      ImGui::PopID();
    }
  }
}

}  // namespace

void morph_section(const Actor& actor, Settings& s) {
  std::size_t all = 0;
  for (std::uint32_t m = 0; m < actor.file().mesh_count(); ++m) all += actor.file().mesh(m).targets.size;
  if (all == 0 || !section("Morph targets", false)) return;
  if (ImGui::Button("as the clip has them")) {
    s.weights.clear();
    s.parameters.clear();
  }
  parameters(actor, s);
  std::size_t number = 0;
  for (std::uint32_t m = 0; m < actor.file().mesh_count(); ++m) {
    const Mesh mesh = actor.file().mesh(m);
    for (std::size_t t = 0; t < mesh.targets.size; ++t, ++number) {
      const std::string name = actor.file().text(mesh.targets[t].name);
      ImGui::PushID(static_cast<int>(number));
      float weight = actor.character().weights(m)[t];
      quiet(name.empty() ? fmt::format("{} {}", mesh.name, t) : name);
      ImGui::SetNextItemWidth(-1);
      if (slider("##weight", weight, std::min(0.0f, weight), std::max(1.0f, weight),
                 s.weights.contains(number) ? "%.2f" : "%.2f, the clip's"))
        s.weights[number] = weight;
      ImGui::PopID();
    }
  }
}

}  // namespace marrow::tools
