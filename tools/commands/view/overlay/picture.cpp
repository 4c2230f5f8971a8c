#include "commands/view/overlay/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr float kTurn = 0.008f;                    // radians a point
constexpr float kZoom = 0.12f;                     // a step of the wheel
constexpr float kLowest = -0.6f, kHighest = 1.5f;  // radians above the horizon
constexpr float kClick = 4;                        // points that a click may move
constexpr float kReach = 16;                       // points from what it means
constexpr ImU32 kBone = IM_COL32(236, 233, 226, 255), kChosen = IM_COL32(255, 176, 64, 255);
constexpr ImU32 kGoal = IM_COL32(90, 220, 210, 255), kTrail = IM_COL32(255, 205, 120, 255);
constexpr ImU32 kAxes[] = {IM_COL32(232, 96, 84, 255), IM_COL32(128, 200, 96, 255), IM_COL32(96, 150, 240, 255)};

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

std::string goal_text(const std::string& name, glm::vec3 p) {
  return fmt::format("{}={:.6g},{:.6g},{:.6g}", name, p.x, p.y, p.z);
}

// Of a goal that goal_text() or the command line has made.
std::string name_of(const std::string& goal) {
  return goal.substr(0, goal.rfind('='));
}
glm::vec3 point_of(const std::string& goal) {
  glm::vec3 p(0);
  const std::size_t equals = goal.rfind('=');
  if (equals != std::string::npos) std::sscanf(goal.c_str() + equals + 1, "%f,%f,%f", &p.x, &p.y, &p.z);
  return p;
}

// The nearest of `count` places to a point of the window, within kReach; or count.
std::size_t nearest(const Drawer& drawer, ImVec2 to, std::size_t count, const auto& place) {
  std::size_t found = count;
  float least = kReach;
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<ImVec2> at = drawer.project(place(i));
    if (!at || distance(*at, to) >= least) continue;
    least = distance(*at, to);
    found = i;
  }
  return found;
}

void press_or_click(const Actor& actor, const Drawer& drawer, Dragging& dragging, Settings& s) {
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const std::size_t goals = s.reach.goals.size();
    const std::size_t goal =
        nearest(drawer, io.MousePos, goals, [&](std::size_t i) { return point_of(s.reach.goals[i]); });
    dragging = {goal < goals ? goal : Dragging::kNone, 0, true};
  }
  if (!dragging.pressed) return;
  dragging.moved += std::abs(io.MouseDelta.x) + std::abs(io.MouseDelta.y);
  if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
  dragging.pressed = false;
  if (dragging.goal != Dragging::kNone || dragging.moved > kClick) return;
  const std::size_t joint =
      nearest(drawer, io.MousePos, actor.joints().size(), [&](std::size_t i) { return place_of(actor, i); });
  s.picked = s.show_joint = joint < actor.joints().size();
  if (s.picked) s.joint = joint;
}

}  // namespace

glm::vec3 place_of(const Actor& actor, std::size_t joint) {
  const NamedJoint& named = actor.joints()[joint];
  return place_of(actor.character().model_from_joint(named.skeleton)[named.joint]);
}

void add_goal(const Actor& actor, Settings& settings) {
  const NamedJoint& joint = actor.joints()[settings.joint];
  const std::string name = actor.file().text(actor.file().skeleton(joint.skeleton).names[joint.joint]);
  std::erase_if(settings.reach.goals, [&](const std::string& goal) { return name_of(goal) == name; });
  settings.reach.goals.push_back(goal_text(name, place_of(actor, settings.joint)));
}

void use_mouse(const Actor& actor, const Drawer& drawer, float picture_height, Dragging& dragging, Settings& settings) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantCaptureMouse || picture_height <= 0) {
    dragging.pressed = false;
    return;
  }
  press_or_click(actor, drawer, dragging, settings);
  Orbit& orbit = settings.orbit;
  const float radius = actor.performance().radius();
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool move = ImGui::IsMouseDown(ImGuiMouseButton_Right) || ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                    (left && io.KeyShift);
  const float unit = view_height() * orbit.distance / picture_height;
  const glm::vec3 dragged = unit * (io.MouseDelta.x * right_of(orbit) - io.MouseDelta.y * up_of(orbit));
  if (left && dragging.pressed && dragging.goal < settings.reach.goals.size()) {
    std::string& goal = settings.reach.goals[dragging.goal];
    if (dragged != glm::vec3(0)) goal = goal_text(name_of(goal), point_of(goal) + dragged);
  } else if (move) {
    orbit.target -= dragged;
  } else if (left && dragging.moved > kClick) {
    orbit.yaw = std::remainder(orbit.yaw - kTurn * io.MouseDelta.x, 6.2831853f);
    orbit.pitch = std::clamp(orbit.pitch + kTurn * io.MouseDelta.y, kLowest, kHighest);
  }
  orbit.distance = std::clamp(orbit.distance * std::exp(-kZoom * io.MouseWheel), 0.02f * radius, 40 * radius);
}

namespace {

void draw_axes(const Affine& joint, float length, Drawer& drawer, float width) {
  const glm::vec3 at = place_of(joint);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::vec3 along(joint.rows[0][axis], joint.rows[1][axis], joint.rows[2][axis]);
    const float size = glm::length(along);
    if (size > 0) drawer.line(at, at + along * (length / size), kAxes[axis], width);
  }
}

void draw_trail(Actor& actor, const Settings& s, Drawer& drawer) {
  const JointCurves* const curves = s.picked ? actor.curves(s) : nullptr;
  if (curves == nullptr) return;
  for (std::size_t i = 1; i < curves->places.size(); ++i)
    drawer.line(curves->places[i - 1], curves->places[i], kTrail, 1.5f);
  for (const glm::vec3& place : curves->places) drawer.point(place, 1.6f, kTrail);
}

// The chosen joint's before all others.
void draw_names(const Actor& actor, const Settings& s, Drawer& drawer) {
  const std::vector<NamedJoint>& joints = actor.joints();
  if (s.picked && !joints.empty()) drawer.words(place_of(actor, s.joint), joints[s.joint].name, kChosen);
  for (std::size_t i = 0; i < joints.size() && s.overlays.names; ++i)
    if (!s.picked || i != s.joint) drawer.words(place_of(actor, i), joints[i].name, kBone);
}

}  // namespace

void draw_joints(Actor& actor, const Settings& s, Drawer& drawer) {
  const std::vector<NamedJoint>& joints = actor.joints();
  const bool marked = s.picked || s.colours == Colours::weights;
  for (std::size_t i = 0; i < joints.size() && s.overlays.bones; ++i) {
    const std::span<const Affine> places = actor.character().model_from_joint(joints[i].skeleton);
    const std::uint16_t parent = actor.file().skeleton(joints[i].skeleton).parents[joints[i].joint];
    if (parent != kNoJoint) drawer.line(place_of(places[parent]), place_of(actor, i), kBone, 1.6f);
  }
  if (s.overlays.trail) draw_trail(actor, s, drawer);
  if (s.overlays.steps && actor.rehearsal() == nullptr) actor.footprints(s).draw(clip_time(s.playback), drawer);
  const float axis = 0.05f * actor.performance().radius();
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const bool chosen = marked && i == s.joint;
    const glm::vec3 at = place_of(actor, i);
    if (s.overlays.axes || (chosen && s.picked))
      draw_axes(actor.character().model_from_joint(joints[i].skeleton)[joints[i].joint], chosen ? 2 * axis : axis,
                drawer, chosen ? 2.5f : 1.4f);
    if (s.overlays.bones && !chosen) drawer.point(at, 2.2f, kBone);
  }
  if (marked && !joints.empty()) drawer.point(place_of(actor, s.joint), 5, kChosen);
  draw_names(actor, s, drawer);
  for (const std::string& goal : s.reach.goals) drawer.square(point_of(goal), 7, kGoal);
}

}  // namespace marrow::tools
