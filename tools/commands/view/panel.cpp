#include "commands/view/panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "render/heat.h"

namespace marrow::tools {
namespace {

constexpr float kPanelWidth = 316;
constexpr float kLabelWidth = 82;

// A label, and room for a widget that fills the rest of the line.
void label(const char* text, float scale) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(kLabelWidth * scale);
  ImGui::SetNextItemWidth(-1);
}

void heading(const char* text) {
  ImGui::Dummy({0, 0.35f * ImGui::GetFontSize()});
  ImGui::TextColored({0.93f, 0.68f, 0.36f, 1}, "%s", text);
  ImGui::Separator();
}

void text(const std::string& words) {
  ImGui::TextUnformatted(words.c_str());
}

void quiet(const std::string& words) {
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyle().Colors[ImGuiCol_TextDisabled]);
  ImGui::PushTextWrapPos(0);
  text(words);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

// names[i] for i below count; whether another was chosen.
bool combo(const char* id, std::size_t count, const auto& name, std::size_t& chosen) {
  const std::size_t before = chosen;
  if (!ImGui::BeginCombo(id, name(chosen).c_str(), ImGuiComboFlags_HeightLarge)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(name(i).c_str(), i == chosen)) chosen = i;
    if (i == chosen) ImGui::SetItemDefaultFocus();
    ImGui::PopID();
  }
  ImGui::EndCombo();
  return chosen != before;
}

// A slider that takes no number typed into it that is none.
bool slider(const char* id, float& value, float least, float most, const char* format) {
  const float before = value;
  if (!ImGui::SliderFloat(id, &value, least, most, format, ImGuiSliderFlags_AlwaysClamp)) return false;
  if (!std::isfinite(value)) value = before;
  return true;
}

void deformers(const char* id, Deformer& chosen) {
  ImGui::PushID(id);
  for (const auto& [name, deformer] : kDeformers) {
    if (deformer != kDeformers[0].value) ImGui::SameLine();
    if (ImGui::RadioButton(name, chosen == deformer)) chosen = deformer;
  }
  ImGui::PopID();
}

void clip_section(const Actor& actor, float scale, Settings& s) {
  const std::vector<NamedPlay>& plays = actor.plays();
  const auto name = [&](std::size_t i) { return plays[i].name; };
  heading("Clip");
  label("play", scale);
  if (combo("##clip", plays.size(), name, s.clip)) {
    s.playback.time_s = 0;
    s.framed = false;
  }
  const float duration_s = plays[s.clip].play.duration_s;
  ImGui::BeginDisabled(duration_s <= 0);
  label("time", scale);
  float time_s = clip_time(s.playback);
  const std::string format = fmt::format("%.2f of {:.2f} s", static_cast<double>(duration_s));
  if (slider("##time", time_s, 0, std::max(duration_s, 1e-6f), format.c_str())) {
    s.playback.time_s = static_cast<double>(time_s);
    s.playing = false;
  }
  label("speed", scale);
  const float button = 62 * scale;
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  slider("##speed", s.playback.speed, -2, 2, "%.2f");
  ImGui::SameLine();
  if (ImGui::Button(s.playing ? "pause" : "play", {button, 0})) s.playing = !s.playing;
  ImGui::EndDisabled();
  label("blend", scale);
  combo(
      "##second", plays.size(), [&](std::size_t i) { return i == 0 ? std::string("with nothing") : plays[i].name; },
      s.second);
  ImGui::BeginDisabled(s.second == 0);
  label("weight", scale);
  slider("##weight", s.second_weight, 0, 1, "%.2f");
  ImGui::EndDisabled();
}

void skinning_section(const Actor& actor, float scale, Settings& s) {
  heading("Skinning");
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
  heading("Colours");
  const std::pair<Colours, const char*> kinds[] = {
      {Colours::surface, "surface"}, {Colours::distance, "distance"}, {Colours::weights, "weights"}};
  for (const auto& [kind, name] : kinds) {
    if (kind != Colours::surface) ImGui::SameLine();
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
    combo(
        "##joint", actor.joints().size(), [&](std::size_t i) { return actor.joints()[i].name; }, s.joint);
    ramp("1");
  }
  ImGui::Checkbox("skeleton", &s.bones);
}

void frame_section(const Actor& actor, const FrameTimes& times, float scale, Settings& s) {
  heading("Frames");
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
  heading("Camera");
  if (ImGui::Button("see all")) s.framed = false;
  quiet("left button: turn\nright button, or with shift: move\nwheel: zoom\nspace bar: play, pause");
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

void show_panel(const std::string& file, const Actor& actor, const FrameTimes& times, float scale, Settings& settings) {
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({panel_width(scale), ImGui::GetIO().DisplaySize.y});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus);
  text(std::filesystem::path(file).filename().string());
  std::uint64_t vertices = 0, triangles = 0;
  for (std::uint32_t i = 0; i < actor.file().mesh_count(); ++i) {
    const Geometry g = actor.file().mesh(i, static_cast<std::uint32_t>(settings.lod)).geometry;
    vertices += g.vertex_count;
    triangles += g.index_count / 3;
  }
  quiet(fmt::format("{} joints, {} vertices, {} triangles", actor.joints().size(), vertices, triangles));
  clip_section(actor, scale, settings);
  skinning_section(actor, scale, settings);
  colour_section(actor, scale, settings);
  frame_section(actor, times, scale, settings);
  ImGui::End();
}

}  // namespace marrow::tools
