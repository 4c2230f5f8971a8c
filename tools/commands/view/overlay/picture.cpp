#include "commands/view/overlay/picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "stage/moves.h"

namespace marrow::tools {
namespace {

constexpr float kClick = 4;   // points that a click may move
constexpr float kReach = 16;  // points from what it means
constexpr ImU32 kBone = IM_COL32(236, 233, 226, 255), kChosen = IM_COL32(255, 176, 64, 255);
constexpr ImU32 kGoal = IM_COL32(90, 220, 210, 255), kTrail = IM_COL32(255, 205, 120, 255);
constexpr ImU32 kPath = IM_COL32(140, 230, 140, 255), kGone = IM_COL32(120, 120, 120, 160);
constexpr ImU32 kAxes[] = {IM_COL32(232, 96, 84, 255), IM_COL32(128, 200, 96, 255), IM_COL32(96, 150, 240, 255)};

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
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
        nearest(drawer, io.MousePos, goals, [&](std::size_t i) { return goal_point(s.reach.goals[i]); });
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

glm::vec3 place_of(const Actor& actor, std::size_t joint) {
  const NamedJoint& named = actor.joints()[joint];
  return place_of(actor.character().model_from_joint(named.skeleton)[named.joint]);
}

void add_goal(const Actor& actor, Settings& settings) {
  const NamedJoint& joint = actor.joints()[settings.joint];
  const std::string name = actor.file().text(actor.file().skeleton(joint.skeleton).names[joint.joint]);
  std::erase_if(settings.reach.goals, [&](const std::string& goal) { return goal_name(goal) == name; });
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
  const auto dragged = [&](float depth) {
    return dragged_by(orbit, io.MouseDelta.x, io.MouseDelta.y, picture_height, depth);
  };
  if (left && dragging.pressed && dragging.goal < settings.reach.goals.size()) {
    std::string& goal = settings.reach.goals[dragging.goal];
    Orbit following = orbit;
    following.target += actor.performance().followed(actor.character());
    const glm::vec3 from = goal_point(goal), to = from + dragged(depth_of(following, from));
    if (to != from) goal = goal_text(goal_name(goal), to);
  } else if (move) {
    orbit.target -= dragged(orbit.distance);
  } else if (left && dragging.moved > kClick) {
    turn_orbit(orbit, io.MouseDelta.x, io.MouseDelta.y);
  }
  zoom_orbit(orbit, io.MouseWheel, radius);
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

void draw_footprints(const Footprints& prints, float time_s, Drawer& drawer) {
  for (const Footprints::Carried& print : prints.at(time_s))
    drawer.square(print.at, print.stands ? 7.0f : 4.0f, print.stands ? colour_of(print.role) : kGone);
  const std::vector<glm::vec3> path = prints.path(time_s);
  for (std::size_t i = 1; i < path.size(); ++i) drawer.line(path[i - 1], path[i], kPath, 1.5f);
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
  if (s.overlays.steps && actor.rehearsal() == nullptr)
    draw_footprints(actor.footprints(s), clip_time(s.playback), drawer);
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
  for (const std::string& goal : s.reach.goals) drawer.square(goal_point(goal), 7, kGoal);
}

bool use_brush(Painting& painting, const Camera& camera, float left, std::uint32_t skeleton, std::uint32_t joint,
               const Brush& brush, BrushHand& hand) {
  const ImGuiIO& io = ImGui::GetIO();
  if (painting.stroking() && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) painting.end();
  hand.over.reset();
  if (io.WantCaptureMouse && !painting.stroking()) return false;
  hand.over = hit_at(painting, camera, left, io.MousePos);
  if (!painting.stroking()) {
    hand.last.reset();
    if (!hand.over || !ImGui::IsMouseClicked(ImGuiMouseButton_Left) || io.KeyShift || io.KeyCtrl) return false;
    painting.begin(brush, skeleton, joint);
  }
  dab_along(painting, camera, left, io.MousePos, brush.radius, hand);
  return true;
}

void draw_brush(const BrushHand& hand, const Brush& brush, Drawer& drawer) {
  if (!hand.over) return;
  draw_ring(*hand.over, brush.radius, kRing, 1.6f, drawer);
  draw_ring(*hand.over, 0.5f * brush.radius, kCore, 1, drawer);
}

}  // namespace marrow::tools
