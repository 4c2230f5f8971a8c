#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "commands/view/overlay/picture.h"
#include "commands/view/panel/sections.h"

namespace marrow::tools {
namespace {

constexpr ImU32 kAxisColours[] = {IM_COL32(232, 96, 84, 255), IM_COL32(128, 200, 96, 255), IM_COL32(96, 150, 240, 255)};

// Joints of a skeleton by their parents, as indices into Actor::joints().
std::vector<std::vector<std::size_t>> children_of(const Actor& actor, std::vector<std::size_t>& roots) {
  std::vector<std::vector<std::size_t>> out(actor.joints().size());
  std::size_t first = 0;
  for (std::uint32_t s = 0; s < actor.file().skeleton_count(); ++s) {
    const Skeleton skeleton = actor.file().skeleton(s);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
      const std::uint16_t parent = skeleton.parents[j];
      (parent == kNoJoint ? roots : out[first + parent]).push_back(first + j);
    }
    first += skeleton.joint_count;
  }
  return out;
}

// Rows of the tree in its order, without recursion: hostile skeletons are as deep as they have joints.
void tree(const Actor& actor, float scale, Settings& s) {
  std::vector<std::size_t> roots;
  const auto children = children_of(actor, roots);
  std::vector<std::pair<std::size_t, int>> open;
  for (auto at = roots.rbegin(); at != roots.rend(); ++at) open.emplace_back(*at, 0);
  ImGui::BeginChild("tree", {0, 118 * scale}, true);
  while (!open.empty()) {
    const auto [joint, depth] = open.back();
    open.pop_back();
    const float indent = 9 * scale * static_cast<float>(std::min(depth, 12));
    if (indent > 0) ImGui::Indent(indent);
    ImGui::PushID(static_cast<int>(joint));
    if (ImGui::Selectable(actor.joints()[joint].name.c_str(), s.picked && joint == s.joint)) {
      s.joint = joint;
      s.picked = true;
    }
    if (s.show_joint && joint == s.joint) ImGui::SetScrollHereY(0.5f);
    ImGui::PopID();
    if (indent > 0) ImGui::Unindent(indent);
    for (auto at = children[joint].rbegin(); at != children[joint].rend(); ++at) open.emplace_back(*at, depth + 1);
  }
  s.show_joint = false;
  ImGui::EndChild();
}

void transforms(const Actor& actor, const Settings& s) {
  const NamedJoint& joint = actor.joints()[s.joint];
  const JointTransform t = actor.local(s.joint);
  const glm::vec3 angles = angles_deg(t.rotation);
  const Affine& place = actor.character().model_from_joint(joint.skeleton)[joint.joint];
  const auto row = [](const char* name, float x, float y, float z, const char* unit) {
    text(fmt::format("{:<7}{:8.3f}{:9.3f}{:9.3f} {}", name, x, y, z, unit));
  };
  quiet("of its parent: x, y, z");
  row("move", t.translation[0], t.translation[1], t.translation[2], "m");
  row("turn", angles.x, angles.y, angles.z, "deg");
  row("scale", t.scale[0], t.scale[1], t.scale[2], "");
  quiet("of the model");
  row("place", place.rows[0][3], place.rows[1][3], place.rows[2][3], "m");
  for (int i = 0; i < 3; ++i) row(i == 0 ? "axes" : "", place.rows[i][0], place.rows[i][1], place.rows[i][2], "");
}

// Three curves in one frame, with what they reach and where the clip is now.
void plot(const char* name, const std::vector<float> (&rows)[3], float share, const char* unit, float scale) {
  float least = rows[0][0], most = least;
  for (const std::vector<float>& row : rows) {
    const auto [low, high] = std::ranges::minmax(row);
    least = std::min(least, low);
    most = std::max(most, high);
  }
  quiet(fmt::format("{}: {:.3g} to {:.3g}{}", name, least, most, unit));
  const float range = std::max(most - least, 1e-4f), middle = 0.5f * (least + most);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 46 * scale);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
  std::vector<ImVec2> line;
  for (int axis = 2; axis >= 0; --axis) {
    line.clear();
    const std::vector<float>& row = rows[axis];
    for (std::size_t i = 0; i < row.size(); ++i)
      line.emplace_back(at.x + size.x * static_cast<float>(i) / static_cast<float>(row.size() - 1),
                        at.y + size.y * (0.5f - 0.86f * (row[i] - middle) / range));
    list.AddPolyline(line.data(), static_cast<int>(line.size()), kAxisColours[axis], 0, 1.5f * scale);
  }
  const float x = at.x + size.x * share;
  list.AddLine({x, at.y}, {x, at.y + size.y}, IM_COL32(236, 233, 226, 200), scale);
  ImGui::Dummy(size);
}

void curves(Actor& actor, float scale, const Settings& s) {
  const JointCurves* const rows = actor.curves(s);
  if (actor.rehearsal() != nullptr) return quiet("Curves are of clips.");
  if (rows == nullptr) return quiet("The rest pose has no curves.");
  const float duration_s = actor.plays()[s.clip].play.duration_s;
  const float share = std::clamp(clip_time(s.playback) / duration_s, 0.0f, 1.0f);
  for (int axis = 0; axis < 3; ++axis) {
    constexpr const char* kNames[] = {"x", "y", "z"};
    if (axis > 0) ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kAxisColours[axis]), "%s", kNames[axis]);
  }
  ImGui::SameLine();
  quiet("over the clip alone");
  plot("move", rows->translation, share, " m", scale);
  plot("turn", rows->rotation_deg, share, " deg", scale);
  plot("scale", rows->scale, share, "", scale);
}

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

void joint_section(Actor& actor, float scale, Settings& s) {
  if (!section("Joints", true)) return;
  if (actor.joints().empty()) return quiet("There are none.");
  tree(actor, scale, s);
  if (!s.picked) return quiet("Click a joint here or in the picture.");
  ImGui::TextColored({1, 0.69f, 0.25f, 1}, "%s", actor.joints()[s.joint].name.c_str());
  transforms(actor, s);
  if (ImGui::TreeNodeEx("curves", ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_NoTreePushOnOpen))
    curves(actor, scale, s);
}

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
