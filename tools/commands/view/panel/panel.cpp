#include "commands/view/panel/panel.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <imgui.h>

#include "commands/view/panel/sections.h"
#include "render/heat.h"

namespace marrow::tools {
namespace {

constexpr float kPanelWidth = 316;
constexpr const char* kHelp =
    "left button: turn\nright button, or with shift: move\nwheel: zoom\nclick: choose a joint\n"
    "drag a goal's square: reach\ndrop a file: open it\nspace bar: play, pause\nleft, right: a frame back, on\n"
    "home, end: first, last frame\nof a graph\n1 to 9: fire, set, or choose a number\n"
    "up, down: more, less of it\nwith ctrl, left and right: ten frames\nwhile painting\nleft button on the figure: "
    "paint\nbeside it, or with ctrl: turn\n"
    "[ and ]: the brush smaller, larger\nctrl Z, ctrl Y: undo, redo\nctrl S: save";

void deformers(const char* id, Deformer& chosen) {
  ImGui::PushID(id);
  for (const auto& [name, deformer] : kGpuDeformers) {
    if (deformer != kDeformers[0].value) ImGui::SameLine();
    if (ImGui::RadioButton(name, chosen == deformer)) chosen = deformer;
  }
  ImGui::PopID();
}

void skinning_section(const Actor& actor, float scale, Settings& s) {
  if (!section("Skinning", false)) return;
  ImGui::BeginDisabled(s.colours == Colours::distance);
  label("deformer", scale);
  deformers("deformer", s.deformer);
  ImGui::EndDisabled();
  ImGui::BeginDisabled(actor.cpu_only() || s.colours != Colours::surface);
  label("path", scale);
  const auto path = [](std::size_t i) { return fmt::format("{}: {}", kPosedPaths[i].name, kPosedPaths[i].about); };
  const SkinPath used = actor.cpu_only() || s.colours != Colours::surface ? SkinPath::cpu : s.path;
  auto chosen =
      static_cast<std::size_t>(std::ranges::find(kPosedPaths, used, &NamedSkinPath::value) - kPosedPaths.begin());
  if (combo("##path", kPosedPaths.size(), path, chosen)) s.path = kPosedPaths[chosen].value;
  ImGui::EndDisabled();
  if (actor.cpu_only()) quiet("A mesh has more joints than one uniform block holds.");
  ImGui::BeginDisabled(s.deformer != Deformer::as || s.colours != Colours::surface);
  label("normals", scale);
  if (ImGui::RadioButton("tangents", s.normals == AsNormals::tangents)) s.normals = AsNormals::tangents;
  ImGui::SameLine();
  if (ImGui::RadioButton("blended", s.normals == AsNormals::blended)) s.normals = AsNormals::blended;
  ImGui::EndDisabled();
  label("detail", scale);
  if (actor.coarsest_lod() == 0) return quiet("in full; cooked without --lod");
  ImGui::SliderInt("##lod", &s.lod, 0, actor.coarsest_lod(), s.lod == 0 ? "in full" : "level %d",
                   ImGuiSliderFlags_AlwaysClamp);
}

// The colours from 0 to `largest`.
void ramp(const std::string& largest) {
  constexpr int kSteps = 32;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = 0.7f * ImGui::GetFontSize();
  const auto colour = [](int step) {
    const Rgb rgb = heat_colour(static_cast<float>(step) / kSteps);
    return IM_COL32(rgb[0], rgb[1], rgb[2], 255);
  };
  for (int i = 0; i < kSteps; ++i) {
    const float x0 = at.x + width * static_cast<float>(i) / kSteps;
    const float x1 = at.x + width * static_cast<float>(i + 1) / kSteps;
    ImGui::GetWindowDrawList()->AddRectFilledMultiColor({x0, at.y}, {x1, at.y + height}, colour(i), colour(i + 1),
                                                        colour(i + 1), colour(i));
  }
  ImGui::Dummy({width, height});
  quiet("0");
  ImGui::SameLine(std::max(0.0f, ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(largest.c_str()).x));
  quiet(largest);
}

void colour_section(const Actor& actor, float scale, Settings& s) {
  if (!section("Colours", true)) return;
  const std::pair<Colours, const char*> kinds[] = {{Colours::surface, "surface"},
                                                   {Colours::distance, "distance"},
                                                   {Colours::weights, "weights"},
                                                   {Colours::uv, "UV"}};
  for (const auto& [kind, name] : kinds) {
    if (kind != Colours::surface) ImGui::SameLine(0, 4 * scale);
    ImGui::BeginDisabled(kind == Colours::weights && actor.joints().empty());
    if (ImGui::RadioButton(name, s.colours == kind)) s.colours = kind;
    ImGui::EndDisabled();
  }
  if (s.colours == Colours::distance) {
    label("between", scale);
    deformers("first", s.pair.first);
    label("and", scale);
    deformers("second", s.pair.second);
    ramp(fmt::format("{:.4g} mm", 1e3 * static_cast<double>(actor.heat_scale())));
  }
  if (s.colours == Colours::weights) {
    label("joint", scale);
    if (combo(
            "##joint", actor.joints().size(), [&](std::size_t i) { return actor.joints()[i].name; }, s.joint))
      s.picked = s.show_joint = true;
    ramp("1");
  }
  if (s.colours == Colours::uv) quiet("8 squares a unit; redder where u grows, bluer where v does. White: no UVs.");
}

void frame_section(const Actor& actor, const FrameTimes& times, float scale, Settings& s) {
  if (!section("Frames", false)) return;
  const float median = times.median();
  const float top = 1.25f * std::max(times.largest(), 1e-3f);
  ImGui::PlotLines("##frames", times.ring().data(), times.count(), times.first(), nullptr, 0, top,
                   {ImGui::GetContentRegionAvail().x, 44 * scale});
  text(fmt::format("median {:.3g} ms, {:.3g} frames a second", static_cast<double>(median),
                   median > 0 ? 1e3 / static_cast<double>(median) : 0));
  quiet(fmt::format("processor: pose {:.2f} ms, skin {:.2f} ms", static_cast<double>(actor.times().pose),
                    static_cast<double>(actor.times().skin)));
  label("pixels", scale);
  for (const int n : {1, 2, 3, 4}) {
    if (n > 1) ImGui::SameLine();
    if (ImGui::RadioButton(n == 1 ? "all" : fmt::format("1/{}", n).c_str(), s.coarseness == n)) s.coarseness = n;
  }
}

void help_section(Settings& s) {
  if (ImGui::Button("see all")) s.framed = false;
  if (!section("Keys and mouse", false)) return;
  quiet(kHelp);
}

// What is on show, and what it was made from.
void file_lines(const ViewActor& actor, const Settings& settings) {
  const Source& source = actor.source();
  text(std::filesystem::path(source.path).filename().string());
  if (source.cooked_here)
    quiet(fmt::format("cooked in memory, {}{}",
                      source.settings.empty() ? "without a marrow.toml" : "with " + source.settings,
                      source.warnings == 0 ? "" : fmt::format("; warnings: {}", source.warnings)));
  std::uint64_t vertices = 0, triangles = 0;
  for (std::uint32_t i = 0; i < actor.file().mesh_count(); ++i) {
    const Geometry g = actor.file().mesh(i, static_cast<std::uint32_t>(settings.lod)).geometry;
    vertices += g.vertex_count;
    triangles += g.index_count / 3;
  }
  quiet(fmt::format("{} joints, {} vertices, {} triangles", actor.joints().size(), vertices, triangles));
}

// What plays it, and what was noticed in its text.
void graph_lines(const Rehearsal& rehearsal) {
  const FoundGraph& found = rehearsal.behaviour().found();
  quiet(fmt::format("by the graph {} of {}", found.graph.name, std::filesystem::path(found.path).filename().string()));
  for (const std::string& warning : found.warnings) quiet(warning);
}

}  // namespace

void set_panel_style(float scale) {
  ImGui::StyleColorsDark();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowRounding = 0;
  style.WindowBorderSize = 0;
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.WindowPadding = {14, 12};
  style.ItemSpacing = {7, 5};
  style.ScaleAllSizes(scale);
  const ImVec4 accent = {0.19f, 0.55f, 0.58f, 1}, bright = {0.29f, 0.72f, 0.72f, 1};
  const ImVec4 frame = {0.145f, 0.175f, 0.205f, 1}, raised = {0.20f, 0.24f, 0.28f, 1};
  const std::pair<ImGuiCol, ImVec4> colours[] = {{ImGuiCol_WindowBg, {0.078f, 0.098f, 0.122f, 1}},
                                                 {ImGuiCol_PopupBg, {0.10f, 0.125f, 0.15f, 1}},
                                                 {ImGuiCol_Text, {0.925f, 0.914f, 0.886f, 1}},
                                                 {ImGuiCol_TextDisabled, {0.57f, 0.61f, 0.65f, 1}},
                                                 {ImGuiCol_FrameBg, frame},
                                                 {ImGuiCol_FrameBgHovered, raised},
                                                 {ImGuiCol_FrameBgActive, raised},
                                                 {ImGuiCol_Button, raised},
                                                 {ImGuiCol_ButtonHovered, accent},
                                                 {ImGuiCol_ButtonActive, accent},
                                                 {ImGuiCol_Header, accent},
                                                 {ImGuiCol_HeaderHovered, accent},
                                                 {ImGuiCol_HeaderActive, accent},
                                                 {ImGuiCol_SliderGrab, accent},
                                                 {ImGuiCol_SliderGrabActive, bright},
                                                 {ImGuiCol_CheckMark, bright},
                                                 {ImGuiCol_PlotLines, bright},
                                                 {ImGuiCol_Separator, raised}};
  for (const auto& [which, colour] : colours) style.Colors[which] = colour;
  ImFontConfig font;
  font.SizePixels = std::floor(13 * scale);
  ImGui::GetIO().Fonts->AddFontDefault(&font);
}

float panel_width(float scale) {
  return kPanelWidth * scale;
}

void show_panel(const PanelState& state, ViewActor& actor, ViewSettings& settings) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({panel_width(state.scale), ImGui::GetIO().DisplaySize.y});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus);
  file_lines(actor, settings);
  if (actor.rehearsal() != nullptr) {
    graph_lines(*actor.rehearsal());
    parameter_section(*actor.rehearsal(), state.scale, settings);
    time_section(*actor.rehearsal(), state.scale, settings);
    node_section(*actor.rehearsal(), state.scale);
  } else {
    clip_section(actor, state.scale, settings);
    paint_section(actor, state.scale, settings);
  }
  joint_section(actor, state.scale, settings);
  overlay_section(actor, state.scale, settings);
  colour_section(actor, state.scale, settings);
  pose_section(actor, state.scale, settings);
  morph_section(actor, settings);
  skinning_section(actor, state.scale, settings);
  frame_section(actor, state.times, state.scale, settings);
  help_section(settings);
  ImGui::End();
}

void show_notes(const std::string& busy_with, const std::string& error, float left, float scale) {
  if (busy_with.empty() && error.empty()) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float margin = 12 * scale;
  if (window.x - left < 4 * margin) left = 0;
  ImGui::SetNextWindowPos({left + margin, margin});
  ImGui::SetNextWindowSize({window.x - left - 2 * margin, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg,
                        error.empty() ? ImVec4(0.10f, 0.125f, 0.15f, 1) : ImVec4(0.42f, 0.11f, 0.09f, 1));
  ImGui::Begin("notes", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PushTextWrapPos(0);
  if (!busy_with.empty()) text("opening " + busy_with + " ...");
  if (!error.empty()) text(error);
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleColor();
}

}  // namespace marrow::tools
