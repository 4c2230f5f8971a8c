#include "marrow/feet.h"

#include "core/check.h"
#include "core/mark.h"
#include "ik/turn_joint.h"
#include "ik/two_bone.h"
#include "marrow/local_to_model.h"
#include "math/elementary.h"
#include "math/finite.h"
#include "math/rotation.h"

namespace marrow {
namespace {

constexpr float kFarthest = 1e6f;
constexpr float kAllButTwoPercent = 5.834f;  // (1 + x) e^-x = 0.02
constexpr float kLeastRise = 0.173648178f;   // cos 80°

// One call: what all feet share.
struct FeetCall {
  PosedJoints pose;
  const Feet& feet;
  const FeetFrame& frame;
  Vector3 up = vector3(frame.up), origin = marrow::origin(frame.world_from_scene);
  // Of settings that have been checked.
  float rate = 0;         // 1/s, of what dies away
  float decay = 0;        // e^(-rate dt)
  CosSin slope = {1, 0};  // the steepest
};

bool near(const Vector3& v) {
  return within(v, -kFarthest, kFarthest);
}
bool near(const Affine& a) {
  return near(vector3(a.rows[0])) && near(vector3(a.rows[1])) && near(vector3(a.rows[2])) && near(origin(a));
}

BadCall check_foot(const FeetCall& call, const Foot& foot, const FootGround& ground) {
  const Skeleton& skeleton = call.pose.skeleton;
  const std::uint32_t joints[] = {foot.hip, foot.knee, foot.ankle};
  if (const BadCall bad = check_chain(call.pose, {joints, 3})) return bad;
  MARROW_CHECK(call.feet.pelvis == kNoJoint || hangs_below(skeleton, foot.hip, call.feet.pelvis));
  MARROW_CHECK(near(vector3(foot.sole)));
  MARROW_CHECK(near(vector3(foot.bend_axis)));
  MARROW_CHECK(within(foot.weight, 0, 1));
  MARROW_CHECK(near(vector3(ground.point)));
  MARROW_CHECK(near(vector3(ground.normal)));
  for (const std::uint32_t joint : joints) {
    const Affine& m = call.pose.scene_from_joint[joint];
    MARROW_CHECK(near(m));
    MARROW_CHECK(near(transform(call.frame.world_from_scene, origin(m))));
    MARROW_CHECK(near(turn(m, vector3(foot.sole))));
  }
  return {};
}

BadCall check_feet(const FeetCall& call, Span<const FootGround> ground, Span<const FootMotion> motion) {
  const Skeleton& skeleton = call.pose.skeleton;
  const FeetFrame& frame = call.frame;
  MARROW_CHECK(holds(call.pose.local, skeleton.soa_size()));
  MARROW_CHECK(holds(call.pose.scene_from_joint, skeleton.joint_count));
  MARROW_CHECK(holds(call.feet.feet));
  MARROW_CHECK(holds(ground, call.feet.feet.size));
  MARROW_CHECK(holds(motion, call.feet.feet.size));
  MARROW_CHECK(within(frame.dt_s, 0, kFarthest));
  MARROW_CHECK(within(frame.weight, 0, 1));
  MARROW_CHECK(within(dot(call.up, call.up), 0.999f, 1.001f));
  MARROW_CHECK(near(frame.world_from_scene));
  MARROW_CHECK(determinant(frame.world_from_scene) > 1e-12f);
  MARROW_CHECK(within(call.feet.lower_m, 0, kFarthest));
  MARROW_CHECK(within(call.feet.reach, 0, 1));
  MARROW_CHECK(within(call.feet.slope_rad, 0, 1.5f));
  MARROW_CHECK(within(call.feet.ease_s, 1e-3f, 1e3f));
  const std::uint32_t pelvis = call.feet.pelvis;
  MARROW_CHECK(pelvis == kNoJoint || pelvis < skeleton.joint_count);
  if (pelvis != kNoJoint) MARROW_CHECK(near(call.pose.scene_from_joint[pelvis]));
  for (std::size_t i = 0; i < call.feet.feet.size; ++i) {
    if (const BadCall bad = check_foot(call, call.feet.feet[i], ground[i])) return bad;
  }
  return {};
}

// x'' + 2 r x' + r² x = 0, exactly, for a step whose e^(-r dt) is given.
void die_away(float rate, float dt_s, float decay, float& x, float& speed) {
  const float both = speed + rate * x;
  x = (x + both * dt_s) * decay;
  speed = (speed - rate * both * dt_s) * decay;
}
void die_away(const FeetCall& call, float (&x)[3], float (&speed)[3]) {
  for (int i = 0; i < 3; ++i) die_away(call.rate, call.frame.dt_s, call.decay, x[i], speed[i]);
}

Vector3 level(const FeetCall& call, const Vector3& v) {
  return normalised_or(across(v, call.up), {});
}

// About up, from one level direction to another.
Rotation level_turn(const FeetCall& call, const Vector3& from, const Vector3& to) {
  const float s = dot(cross(from, to), call.up), c = dot(from, to);
  const float w = 1.0f + c;
  if (w < 1e-6f && s * s < 1e-6f) {  // half a turn, or no direction
    if (c == 0) return {};
    return quaternion(call.up, 0.0f);
  }
  return normalised(quaternion(call.up * s, w));
}

// The ground's normal, not steeper than the foot leans.
Vector3 lean_of(const FeetCall& call, const Vector3& normal) {
  const float c = dot(normal, call.up);
  if (c >= call.slope.cos) return normal;
  return call.up * call.slope.cos + level(call, normal) * call.slope.sin;
}

// A plane that the sole can stand on: the ray's, or the animation's own.
struct Ground {
  Vector3 point, normal;
  bool hit;
};
Ground ground_of(const FeetCall& call, const FootGround& given) {
  const Vector3 normal = normalised_or(vector3(given.normal), {});
  if (given.hit && dot(normal, call.up) > kLeastRise) return {vector3(given.point), normal, true};
  return {call.origin, call.up, false};
}
// By how much the animated sole is lifted to be as high above the plane as it is above the animation's level ground.
float lift_to(const FeetCall& call, const Ground& ground, const Vector3& sole) {
  const float above = dot(sole - call.origin, call.up);
  return above + dot(ground.point - sole, ground.normal) / dot(ground.normal, call.up);
}

// Another plane than in the last frame makes no difference yet: the offset makes up for it.
void change_ground(const FeetCall& call, const Ground& now, const Vector3& sole, FootMotion& m) {
  Ground was = {vector3(m.point), vector3(m.normal), m.hit != 0};
  if (!was.hit) was = {call.origin, call.up, false};
  const float step = lift_to(call, now, sole) - lift_to(call, was, sole);
  store(m.offset, vector3(m.offset) - call.up * step);
  store(m.lean, vector3(m.lean) + lean_of(call, was.normal) - lean_of(call, now.normal));
}

// The heading of a planted foot: captured, held, or on its way back.
void follow_heading(const FeetCall& call, const Linear<float>& ankle, bool planted, FootMotion& m) {
  if (m.planted != 0) {
    store(m.turn, level_turn(call, level(call, column(ankle, m.axis)), vector3(m.heading)));
    m.turn_share = 1;
    m.turn_share_speed = 0;
    if (planted) return;
  }
  die_away(call.rate, call.frame.dt_s, call.decay, m.turn_share, m.turn_share_speed);
  if (!planted) return;
  const auto rise = [&](std::uint32_t i) { return absolute(dot(column(ankle, i), call.up)); };
  m.axis = rise(0) <= rise(1) && rise(0) <= rise(2) ? 0 : rise(1) <= rise(2) ? 1 : 2;
  store(m.heading, level(call, rotate(share_of(rotation(m.turn), m.turn_share), column(ankle, m.axis))));
}

Vector3 sole_of(const FeetCall& call, const Foot& foot) {
  return transform(call.frame.world_from_scene, transform(call.pose.scene_from_joint[foot.ankle], vector3(foot.sole)));
}

// One foot's motion by one frame.
void follow(const FeetCall& call, const Foot& foot, const FootGround& given, FootMotion& m) {
  const Vector3 sole = sole_of(call, foot);
  const Ground ground = ground_of(call, given);
  if (m.begun == 0 || call.frame.teleported) {
    m = {};
    m.begun = 1;
    m.turn[3] = 1;
  } else {
    change_ground(call, ground, sole, m);
  }
  const Vector3 target = sole + call.up * lift_to(call, ground, sole), was = vector3(m.offset);
  die_away(call, m.offset, m.offset_speed);
  die_away(call, m.lean, m.lean_speed);
  Vector3 shown = target + vector3(m.offset);
  follow_heading(call, right_axes(call.frame.world_from_scene, call.pose.scene_from_joint[foot.ankle]), given.planted,
                 m);
  if (given.planted && m.planted != 0) {
    shown = vector3(m.place) + call.up * dot(shown - vector3(m.place), call.up);
    const Vector3 offset = shown - target;
    if (call.frame.dt_s > 0) {  // level, with what speed it is left behind; up and down, as it dies away
      const Vector3 speed = (offset - was) * (1.0f / call.frame.dt_s);
      store(m.offset_speed, speed + call.up * dot(vector3(m.offset_speed) - speed, call.up));
    }
    store(m.offset, offset);
  }
  m.planted = given.planted ? 1 : 0;
  m.hit = ground.hit ? 1 : 0;
  store(m.place, shown);
  store(m.point, ground.point);
  store(m.normal, ground.normal);
}

// Whether nothing that is made of a motion gets out of hand, as it may of one that nobody here has written.
bool is_sound(const FootMotion& m) {
  for (const auto* const v : {&m.place, &m.offset, &m.lean, &m.point, &m.normal, &m.heading})
    if (!all_within(*v, 3, -1e9f, 1e9f)) return false;
  for (const auto* const v : {&m.offset_speed, &m.lean_speed})
    if (!all_within(*v, 3, -1e18f, 1e18f)) return false;
  return all_within(m.turn, 4, -1.01f, 1.01f) && within(m.turn_share, -1e9f, 1e9f) &&
         within(m.turn_share_speed, -1e18f, 1e18f) && m.axis < 3;
}

// The same from and to a motion that is sound; else it begins anew.
void follow_soundly(const FeetCall& call, const Foot& foot, const FootGround& given, FootMotion& m) {
  if (!is_sound(m)) m = {};
  follow(call, foot, given, m);
  if (is_sound(m)) return;
  m = {};
  follow(call, foot, given, m);
}

// From the animated attitude of a foot to the one that is shown.
Rotation turn_of(const FeetCall& call, const FootMotion& m) {
  const Vector3 normal = normalised_or(lean_of(call, vector3(m.normal)) + vector3(m.lean), call.up);
  return shortest_arc(call.up, normal) * share_of(rotation(m.turn), m.turn_share);
}

Vector3 ankle_of(const FeetCall& call, const Foot& foot, const FootMotion& m, const Rotation& turned) {
  const Vector3 sole = turn(call.pose.scene_from_joint[foot.ankle], vector3(foot.sole));
  return vector3(m.place) - rotate(turned, turn(call.frame.world_from_scene, sole));
}

// By how much the pelvis is too high, `lift` included, for a leg no longer than it may be. A leg that the animation has
// longer may be so, too, less the way that its ankle is moved.
float too_high(const FeetCall& call, const Foot& foot, const FootMotion& m, float lift) {
  const auto place = [&](std::uint32_t joint) {
    return transform(call.frame.world_from_scene, origin(call.pose.scene_from_joint[joint]));
  };
  const Vector3 hip = place(foot.hip), knee = place(foot.knee), ankle = place(foot.ankle);
  const Vector3 leg = hip + call.up * lift - ankle_of(call, foot, m, turn_of(call, m)), animated = hip - ankle;
  const float most = call.feet.reach * (length(knee - hip) + length(ankle - knee));
  const float own = length(animated) - length(leg - animated), longest = most > own ? most : own;
  const float down = dot(leg, call.up), square = longest * longest - (dot(leg, leg) - down * down);
  const float highest = square > 0 ? sqrt(square) : 0.0f;
  return down > highest ? down - highest : 0.0f;
}

// The pelvis goes by the lowest sole, and further down as legs need it.
float pelvis_lift(const FeetCall& call, Span<const FootMotion> motion) {
  const float most = call.feet.lower_m;
  float lift = 0, excess = 0;
  bool first = true;
  for (std::size_t i = 0; i < call.feet.feet.size; ++i) {
    const Foot& foot = call.feet.feet[i];
    const float own = foot.weight * dot(vector3(motion[i].place) - sole_of(call, foot), call.up);
    lift = first || own < lift ? own : lift;
    first = false;
  }
  lift = lift < most ? lift : most;
  for (std::size_t i = 0; i < call.feet.feet.size; ++i) {
    const Foot& foot = call.feet.feet[i];
    const float own = foot.weight * too_high(call, foot, motion[i], lift);
    excess = own > excess ? own : excess;
  }
  lift -= excess;
  return call.frame.weight * (lift > -most ? lift : -most);
}

// `way` in the space of a matrix's columns; none if they have no volume.
Vector3 into(const Affine& m, const Vector3& way) {
  const Linear<float> rows = linear_rows(m);
  const float volume = determinant(rows);
  if (!(absolute(volume) > 1e-30f)) return {};
  return cofactors(rows) * way * (1.0f / volume);
}

void move_pelvis(const FeetCall& call, float lift) {
  const std::uint32_t joint = call.feet.pelvis;
  if (joint == kNoJoint || lift == 0) return;
  const Affine& parent = map_above(call.pose, joint);
  const Vector3 way = into(parent, into(call.frame.world_from_scene, call.up * lift));
  if (!near(way)) return;
  float(&t)[3][4] = call.pose.local[joint / 4].translation;
  t[0][joint % 4] += way.x, t[1][joint % 4] += way.y, t[2][joint % 4] += way.z;
  update_below(call.pose, joint);
}

// Leg to `goal`, ankle to the axes `want`. A leg that has gone too far for that stays as it is.
void turn_leg(const FeetCall& call, const Foot& foot, const TwoBone& goal, const Linear<float>& want, bool& reached) {
  const Affine& ankle = call.pose.scene_from_joint[foot.ankle];
  if (reach(call.pose, {foot.hip, foot.knee, foot.ankle}, goal, &reached)) return;
  const Rotation q = rotation_between(right_axes(call.frame.world_from_scene, ankle), want);
  const float mirror = determinant(ankle) < 0 ? -1.0f : 1.0f;  // the third axis is then the other way round
  const float own[4] = {mirror * q.x, mirror * q.y, q.z, q.w};
  turn_joint(call.pose.local, foot.ankle, own);
  update_below(call.pose, foot.ankle);
}

void place_foot(const FeetCall& call, const Foot& foot, FootMotion& m) {
  const Affine& world = call.frame.world_from_scene;
  TwoBone goal;
  goal.weight = call.frame.weight * foot.weight;
  if (goal.weight == 0) return;
  store(goal.bend_axis, vector3(foot.bend_axis));
  const Rotation whole = turn_of(call, m), turned = share_of(whole, goal.weight);
  const Linear<float> animated = right_axes(world, call.pose.scene_from_joint[foot.ankle]);
  const Linear<float> want = {rotate(turned, animated.x), rotate(turned, animated.y), rotate(turned, animated.z)};
  Vector3 target = ankle_of(call, foot, m, whole);
  // Once, but where joints are scaled unevenly and the foot is not the shape that it was before the leg turned.
  for (int i = 0; i < 3; ++i) {
    const Vector3 in_scene = into(world, target - origin(world));
    if (!near(in_scene)) return;
    store(goal.target, in_scene);
    bool reached = false;
    turn_leg(call, foot, goal, want, reached);
    m.reached = reached ? 1 : 0;
    const Vector3 miss = vector3(m.place) - sole_of(call, foot);
    const Vector3 leg = target - transform(world, origin(call.pose.scene_from_joint[foot.hip]));
    if (goal.weight < 1 || !reached || dot(miss, miss) <= 1e-8f * dot(leg, leg)) break;
    target = transform(world, origin(call.pose.scene_from_joint[foot.ankle])) + miss;
  }
}

}  // namespace

Status foot_sole(const Foot& foot, const Affine& world_from_scene, Span<const Affine> scene_from_joint,
                 float (&sole_world)[3]) {
  MARROW_REQUIRE(holds(scene_from_joint) && foot.ankle < scene_from_joint.size);
  const Vector3 sole = transform(world_from_scene, transform(scene_from_joint[foot.ankle], vector3(foot.sole)));
  MARROW_REQUIRE(near(sole));
  store(sole_world, sole);
  return Status::ok;
}

Status place_feet(const Skeleton& skeleton, const Feet& feet, const FeetFrame& frame, Span<const FootGround> ground,
                  Span<FootMotion> motion, Span<SoaTransform> local, Span<Affine> scene_from_joint) {
  MARROW_MARK;
  FeetCall call{{skeleton, local, scene_from_joint}, feet, frame};
  MARROW_REQUIRE_GOOD(check_feet(call, ground, motion));
  call.rate = kAllButTwoPercent / feet.ease_s;
  call.decay = exp_negative(-(call.rate * frame.dt_s));
  call.slope = cos_sin(feet.slope_rad);
  for (std::size_t i = 0; i < feet.feet.size; ++i) follow_soundly(call, feet.feet[i], ground[i], motion[i]);
  if (frame.weight == 0) return Status::ok;
  move_pelvis(call, pelvis_lift(call, motion));
  for (std::size_t i = 0; i < feet.feet.size; ++i) place_foot(call, feet.feet[i], motion[i]);
  return Status::ok;
}

}  // namespace marrow
