#include "cook/motion/trace_clip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "cook/roles/role_body.h"
#include "cook/scene/influences.h"

namespace marrow::cook {
namespace {

// Of the leg: of a foot whose ankle is higher the heel does not stand.
constexpr double kHighAnkle = 0.2;
constexpr std::size_t kMostFootJoints = 8;  // of a foot, that points are kept of
// The directions in which the farthest vertex is kept: down, and by 30 and 60 degrees from that to eight sides.
constexpr std::size_t kDirections = 17;

constexpr std::array<std::array<Role, 2>, 4> kLegs = {{{Role::left_foot, Role::left_upper_leg},
                                                       {Role::right_foot, Role::right_upper_leg},
                                                       {Role::left_hand, Role::left_upper_arm},
                                                       {Role::right_hand, Role::right_upper_arm}}};

glm::dvec3 direction(std::size_t number) {
  constexpr double kSide[8][2] = {
      {1, 0},  {0.7071067811865476, 0.7071067811865476},   {0, 1},  {-0.7071067811865476, 0.7071067811865476},
      {-1, 0}, {-0.7071067811865476, -0.7071067811865476}, {0, -1}, {0.7071067811865476, -0.7071067811865476}};
  if (number == 0) return {0, -1, 0};
  const auto& side = kSide[(number - 1) % 8];
  const bool steep = number <= 8;
  const double across = steep ? 0.5 : 0.8660254037844386, down = steep ? 0.8660254037844386 : 0.5;
  return {across * side[0], -down, across * side[1]};
}

// The farthest vertices of a joint so far; model space.
struct Extremes {
  std::array<double, kDirections> far;
  std::array<glm::dvec3, kDirections> places;
  Extremes() { far.fill(-HUGE_VAL); }
  void add(const glm::dvec3& place) {
    for (std::size_t d = 0; d < kDirections; ++d)
      if (const double along = glm::dot(direction(d), place); along > far[d]) far[d] = along, places[d] = place;
  }
};

using ExtremesOfJoints = std::map<std::uint16_t, Extremes>;

// Which foot a joint belongs to; as many as there are feet: none.
std::size_t foot_above(const Body& body, const std::vector<std::uint16_t>& feet, std::uint16_t joint) {
  std::size_t f = 0;
  while (f < feet.size() && !body.is_at_or_above(feet[f], joint)) ++f;
  return f;
}

void add_vertices(const Body& body, const std::vector<std::uint16_t>& feet, Mesh mesh,
                  std::vector<ExtremesOfJoints>& out) {
  mesh.geometry.as_residual = nullptr;  // as linear blend skinning has it
  for_each_vertex(mesh.geometry, [&](std::size_t, const std::vector<Influence>& influences) {
    glm::dvec4 place(0);
    double most = 0;
    std::uint16_t joint = 0;
    for (const Influence& i : influences)
      for_each_joint(mesh, i.entry, [&](std::uint16_t of, const Affine& bind, double share) {
        place += body.model_from_joint[of] * (transformed(bind, i.coordinate) * share);
        if (i.weight * share > most) most = i.weight * share, joint = of;
      });
    const std::size_t f = most > 0 ? foot_above(body, feet, joint) : feet.size();
    if (f == feet.size() || (out[f].size() == kMostFootJoints && !out[f].contains(joint))) return;
    out[f][joint].add(glm::dvec3(place));
  });
}

FootPoint point_of(const Body& body, std::uint16_t joint, const glm::dvec3& place) {
  return {joint, glm::dvec3(glm::inverse(body.model_from_joint[joint]) * glm::dvec4(place, 1))};
}

void keep(const Body& body, const ExtremesOfJoints& extremes, std::vector<FootPoint>& out) {
  for (const auto& [joint, of] : extremes)
    for (std::size_t d = 0; d < kDirections; ++d) {
      bool is_new = true;
      for (std::size_t e = 0; e < d; ++e) is_new = is_new && of.places[e] != of.places[d];
      if (is_new) out.push_back(point_of(body, joint, of.places[d]));
    }
}

constexpr double kFramesPerS = 60;
constexpr std::size_t kMostFramesAKey = 4;  // of clips with few keys
constexpr double kLeastDuration_s = 0.05;   // a clip of less has one pose
// So that no clip takes long or much memory: of frames, and of joints and points that are placed in all of them.
constexpr std::size_t kMostFrames = 1u << 15, kMostPlaced = 1u << 22;
// Some joints and all above them.
class Walker {
 public:
  Walker(const Rig& rig, const std::vector<std::size_t>& joints) : rig_(&rig), world_(rig.size()) {
    std::vector<char> needed(rig.size(), 0);
    for (std::size_t joint : joints)
      for (int j = static_cast<int>(joint); j != kNone && needed[to_index(j)] == 0; j = rig.parents[to_index(j)])
        needed[to_index(j)] = 1;
    for (std::size_t j = 0; j < needed.size(); ++j)
      if (needed[j] != 0) order_.push_back(j);
  }
  std::size_t count() const { return order_.size(); }
  void pose(const SourceCurves& curves, double time_s) {
    for (const std::size_t j : order_) {
      const int parent = rig_->parents[j];
      world_[j] = rig_->place(j, parent == kNone ? nullptr : &world_[to_index(parent)], curves.at(j, time_s));
    }
  }
  const World& at(std::size_t joint) const { return world_[joint]; }

 private:
  const Rig* rig_;
  std::vector<std::size_t> order_;  // parents first
  std::vector<World> world_;
};

glm::dvec3 placed(const World& world, const glm::dvec3& point) {
  return world.linear * point + world.origin;
}

std::size_t middle_of(const Rig& rig, const Roles& roles) {
  const std::uint16_t hips = joint_of(roles, Role::hips);
  return hips != kNoJoint && hips < rig.size() ? hips : 0;
}

// The rotation in a map that may scale.
glm::dquat turn_of(const glm::dmat3& linear) {
  glm::dmat3 m = linear;
  for (int c = 0; c < 3; ++c) {
    const double length = glm::length(m[c]);
    if (!(length > 0)) return {1, 0, 0, 0};
    m[c] /= length;
  }
  return glm::normalize(glm::quat_cast(m));
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// The keys of the track with most of them, as even steps.
std::size_t frames_a_key(const BuiltClip& clip, std::size_t frames) {
  std::size_t most = 2;
  for (const Track& track : clip.tracks) most = std::max<std::size_t>(most, track.key_count);
  return std::clamp<std::size_t>((frames + (most - 1) / 2) / (most - 1), 1, kMostFramesAKey);
}

using Places = std::vector<glm::dvec3>;  // of a foot's ball, then of its points

// Of each frame. frames: one a frame. False if a place is not finite.
bool keep_lowest(const std::vector<Places>& frames, double frame_s, std::vector<LowPoint>& out) {
  const std::size_t last = frames.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    std::size_t low = 1;
    for (std::size_t p = 1; p < frames[i].size(); ++p)
      if (frames[i][p].y < frames[i][low].y) low = p;
    const std::size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, last);
    const double time_s = frame_s * static_cast<double>(to - from);
    const auto velocity = [&](std::size_t p) { return (frames[to][p] - frames[from][p]) / time_s; };
    out.push_back({frames[i][low], velocity(low), frames[i][0], velocity(0)});
    const LowPoint& made = out.back();
    if (!is_finite(made.place) || !is_finite(made.velocity) || !is_finite(made.ball_velocity)) return false;
  }
  return true;
}

}  // namespace

std::vector<FootShape> find_foot_points(const BuiltSkeleton& skeleton, const std::vector<Mesh>& meshes) {
  const Roles roles{skeleton.roles.roles, skeleton.roles.pairs, skeleton.roles.soles};
  if (roles.soles.empty()) return {};
  const Body body = body_of(skeleton);
  std::vector<FootShape> out;
  std::vector<std::uint16_t> feet;
  for (const auto& [foot_role, top_role] : kLegs) {
    const std::uint16_t joint = joint_of(roles, foot_role), top = joint_of(roles, top_role);
    const JointSole* const sole = joint != kNoJoint ? sole_of(roles, joint) : nullptr;
    if (sole == nullptr || top == kNoJoint) continue;
    const glm::dvec4 ball(sole->place[0], sole->place[1], sole->place[2], 1);
    const glm::dvec3 ground(body.model_from_joint[joint] * ball), ankle = body.place(joint);
    const double leg = glm::length(body.place(top) - ground);
    if (!(leg > 0) || !std::isfinite(leg)) continue;
    const FootPoint of_ball{joint, glm::dvec3(ball)};
    FootShape& foot = out.emplace_back(FootShape{foot_role, leg, ground.y, of_ball, {of_ball}});
    if (ankle.y - ground.y < kHighAnkle * leg)
      foot.points.push_back(point_of(body, joint, {ankle.x, ground.y, ankle.z}));
    feet.push_back(joint);
  }
  std::vector<ExtremesOfJoints> extremes(feet.size());
  for (const Mesh& mesh : meshes) add_vertices(body, feet, mesh, extremes);
  for (std::size_t f = 0; f < out.size(); ++f) {
    if (extremes[f].empty()) continue;
    out[f].points.clear();
    keep(body, extremes[f], out[f].points);
  }
  return out;
}

double leg_of(const ClipTrace& trace) {
  double sum = 0;
  for (const FootTrace& foot : trace.feet) sum += foot.leg_m;
  return trace.feet.empty() ? 1 : sum / static_cast<double>(trace.feet.size());
}

glm::dquat heading_of(const glm::dquat& turn) {
  const double length = glm::length(glm::dvec2(turn.w, turn.y));
  return length > 1e-6 ? glm::dquat(turn.w / length, 0, turn.y / length, 0) : glm::dquat(1, 0, 0, 0);
}

ClipTrace trace_clip(const BuiltClip& clip, const BuiltSkeleton& skeleton, const std::vector<FootShape>& feet) {
  const Rig rig(skeleton);
  const Roles roles{skeleton.roles.roles, skeleton.roles.pairs, skeleton.roles.soles};
  const std::size_t middle = middle_of(rig, roles);
  std::vector<std::size_t> joints = {middle};
  for (const FootShape& foot : feet)
    for (const FootPoint& point : foot.points) joints.push_back(point.joint);
  Walker walker(rig, joints);
  const auto duration = static_cast<double>(clip.duration_s);
  if (!(duration >= kLeastDuration_s) || duration * kFramesPerS > static_cast<double>(kMostFrames)) return {};
  const auto steps = static_cast<std::size_t>(std::ceil(duration * kFramesPerS));
  std::size_t placed_count = walker.count();
  for (const FootShape& foot : feet) placed_count += foot.points.size() + 1;
  if (placed_count * steps > kMostPlaced) return {};
  const SourceCurves curves(clip, skeleton);
  ClipTrace out;
  out.frame_s = duration / static_cast<double>(steps);
  out.frames_a_key = frames_a_key(clip, steps);
  std::vector<std::vector<Places>> places(feet.size());
  for (std::size_t frame = 0; frame <= steps; ++frame) {
    walker.pose(curves, duration * static_cast<double>(frame) / static_cast<double>(steps));
    const World& hips = walker.at(middle);
    out.hips.push_back(hips.origin);
    out.hips_turn.push_back(glm::normalize(turn_of(hips.linear) * glm::conjugate(turn_of(rig.world[middle].linear))));
    if (!is_finite(hips.origin)) return {};
    for (std::size_t f = 0; f < feet.size(); ++f) {
      Places& of = places[f].emplace_back();
      of.push_back(placed(walker.at(feet[f].ball.joint), feet[f].ball.place));
      for (const FootPoint& point : feet[f].points) of.push_back(placed(walker.at(point.joint), point.place));
    }
  }
  for (std::size_t f = 0; f < feet.size(); ++f) {
    FootTrace& foot = out.feet.emplace_back(FootTrace{feet[f].role, feet[f].leg_m, feet[f].rest_m, {}});
    if (!keep_lowest(places[f], out.frame_s, foot.points)) return {};
  }
  return out;
}
}  // namespace marrow::cook
