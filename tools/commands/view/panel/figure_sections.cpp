#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "commands/view/overlay/drawer.h"
#include "commands/view/panel/sections.h"
#include "stage/among_figures.h"
#include "stage/recording.h"

namespace marrow::tools {
namespace {

// The frame by number, steps to its neighbours, and how many there are a second.
void frame_row(const Actor& actor, float scale, Settings& s) {
  const float duration_s = actor.plays()[s.clip].play.duration_s, rate = actor.rate_hz(s);
  const float button = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const auto go = [&](double time_s) {
    s.playback.time_s = time_s;
    s.playing = false;
  };
  label("frame", scale);
  int frame = frame_at(static_cast<double>(clip_time(s.playback)), rate);
  const int last = last_frame(duration_s, rate);
  if (ImGui::Button("<", {button, 0})) go(stepped(s.playback.time_s, -1, duration_s, rate));
  ImGui::SameLine(0, gap);
  ImGui::SetNextItemWidth(-button - gap);
  const std::string format = fmt::format("%d of {}", last);
  if (ImGui::SliderInt("##frame", &frame, 0, std::max(last, 1), format.c_str(), ImGuiSliderFlags_AlwaysClamp))
    go(time_of_frame(frame, duration_s, rate));
  ImGui::SameLine(0, gap);
  if (ImGui::Button(">", {button, 0})) go(stepped(s.playback.time_s, 1, duration_s, rate));
  label("a second", scale);
  constexpr float kRates[] = {0, 24, 25, 30, 50, 60};
  const auto name = [&](std::size_t i) {
    if (kRates[i] > 0) return fmt::format("{:.0f} frames", kRates[i]);
    const float own = actor.own_rate_hz(s.clip);
    return own > 0 ? fmt::format("{:.0f} frames, the clip's own", own) : std::string("30 frames");
  };
  auto chosen = static_cast<std::size_t>(std::ranges::find(kRates, s.rate_hz) - kRates);
  if (combo("##rate", std::size(kRates), name, chosen)) s.rate_hz = kRates[chosen];
}

constexpr ImU32 kNow = IM_COL32(255, 255, 255, 200);

// A row a foot, with its contacts, other events, and time_s: as wide as the panel.
void draw_rows(const Footprints& prints, float time_s, float scale) {
  const ClipMotion& motion = prints.motion();
  if (motion.events.empty() || motion.duration_s <= 0) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float width = ImGui::GetContentRegionAvail().x, height = 9 * scale;
  const auto bar = [&](const ImVec2& corner, float from_s, float until_s, ImU32 colour) {
    const float left = corner.x + width * from_s / motion.duration_s,
                right = corner.x + width * std::min(until_s / motion.duration_s, 1.0f);
    list.AddRectFilled({left, corner.y + 1}, {std::max(right, left + 2 * scale), corner.y + height - 1}, colour);
  };
  for (const Role role : {Role::left_foot, Role::right_foot, Role::left_hand, Role::right_hand, Role::none}) {
    bool any = false;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    for (std::size_t e = 0; e < motion.events.size; ++e) {
      if (find_role(prints.name(e).c_str()) != role) continue;
      const ClipEvent& event = motion.events[e];
      bar(corner, event.time_s, event.until_s, colour_of(role));
      if (event.until_s > motion.duration_s) bar(corner, 0, event.until_s - motion.duration_s, colour_of(role));
      any = true;
    }
    if (!any) continue;
    const float x = corner.x + width * time_s / motion.duration_s;
    list.AddLine({x, corner.y}, {x, corner.y + height}, kNow, scale);
    ImGui::Dummy({width, height});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", role == Role::none ? "events" : role_name(role));
  }
}

void brush_widgets(const Actor& actor, float scale, ViewSettings& s) {
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

void mirror_widgets(const Actor& actor, float scale, Painting& painting, ViewSettings& s) {
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

void file_widgets(Painting& painting, ViewSettings& s) {
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

void clip_section(Actor& actor, float scale, Settings& s) {
  const std::vector<NamedPlay>& plays = actor.plays();
  const auto name = [&](std::size_t i) { return plays[i].name; };
  if (!section("Clip", true)) return;
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
  draw_rows(actor.footprints(s), time_s, scale);
  frame_row(actor, scale, s);
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

void paint_section(ViewActor& actor, float scale, ViewSettings& s) {
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
