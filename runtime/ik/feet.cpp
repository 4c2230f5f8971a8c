#include "marrow/feet.h"

#include "core/check.h"
#include "core/zone.h"
#include "ik/foot_state.h"
#include "ik/turn_joint.h"
#include "ik/two_bone.h"
#include "marrow/local_to_model.h"
#include "math/elementary.h"
#include "math/finite.h"
#include "math/rotation.h"

namespace marrow {
namespace {

constexpr float kFarthest = 1e6f;
constexpr float kTooFar = 1000000.0625f;     // the next float: `< kTooFar` is `<= kFarthest`
constexpr float kAllButTwoPercent = 5.834f;  // x at which (1 + x) e^-x = 0.02
constexpr float kLeastRise = 0.173648178f;   // cos 80°: of the steepest ground that counts as hit

// What all feet of a call share.
struct FeetCall {
  const Pose& pose;
  const Feet& feet;
  const FeetFrame& frame;
  f32x4 up = load_wide(frame.up);
  Columns world = columns(frame.world_from_model);
  // Set once the settings are checked.
  float rate = 0;         // 1/s, at which offsets die away
  float decay = 0;        // e^(-rate dt)
  CosSin slope = {1, 0};  // of the steepest ground that a foot leans with
};

// Whether all numbers are less than `limit` in absolute value; false for NaN.
bool is_smaller(f32x4 v, float limit) {
  return all(absolute(v) < splat(limit));
}
bool in_range(f32x4 v) {
  return is_smaller(v, kTooFar);
}
bool in_range(const float (&v)[3]) {  // a fourth number is read and dropped
  return in_range(load_wide(v));
}
bool in_range(const Affine& a) {
  return in_range(load_aligned(a.rows[0])) && in_range(load_aligned(a.rows[1])) && in_range(load_aligned(a.rows[2]));
}

// turned_by(): a direction through a matrix. at(): a point through a matrix and then to the world.
f32x4 turned_by(const Affine& a, f32x4 v) {
  return turn(columns(a), v);
}
f32x4 at(const Columns& world, const Affine& a, const float (&point)[3]) {
  return transform(world, transform(columns(a), load_three(point)));
}

// A joint's position in the world.
f32x4 place_of(const FeetCall& call, std::uint32_t joint) {
  return transform(call.world, wide_origin(call.pose.model_from_joint[joint]).v);
}

// The inverse of a map's linear part, times the determinant.
struct Inverse {
  Columns columns;
  float determinant;
};
Inverse inverse_of_linear(const Affine& m) {
  const f32x4 x = load_wide(m.rows[0]), y = load_wide(m.rows[1]), z = load_wide(m.rows[2]), yz = cross3(y, z);
  return {{{yz, cross3(z, x), cross3(x, y)}, splat(0.0f)}, dot3(x, yz)};
}

BadCall check_foot(const FeetCall& call, const Foot& foot, const FootGround& ground) {
  const Pose& pose = call.pose;
  MARROW_CHECK(foot.hip < foot.knee && foot.knee < foot.ankle && foot.ankle < pose.skeleton.joint_count);
  const std::uint32_t joints[] = {foot.hip, foot.knee, foot.ankle};
  if (const BadCall bad = check_chain(pose, {joints, 3})) return bad;
  MARROW_CHECK(call.feet.pelvis == kNoJoint || hangs_below(pose.skeleton, foot.hip, call.feet.pelvis));
  MARROW_CHECK(in_range(foot.sole));
  MARROW_CHECK(in_range(foot.bend_axis));
  MARROW_CHECK(within(foot.weight, 0, 1));
  MARROW_CHECK(in_range(ground.point));
  MARROW_CHECK(in_range(ground.normal));
  for (const std::uint32_t joint : joints) {
    const Affine& m = pose.model_from_joint[joint];
    MARROW_CHECK(in_range(m));
    MARROW_CHECK(in_range(place_of(call, joint)));
    MARROW_CHECK(in_range(turned_by(m, load_three(foot.sole))));
  }
  return {};
}

BadCall check_feet(const FeetCall& call, Span<const FootGround> ground, Span<const FootMotion> motion) {
  const Pose& pose = call.pose;
  const FeetFrame& frame = call.frame;
  if (const BadCall bad = check_pose(pose)) return bad;
  MARROW_CHECK(holds(call.feet.feet));
  MARROW_CHECK(holds(ground, call.feet.feet.size));
  MARROW_CHECK(holds(motion, call.feet.feet.size));
  MARROW_CHECK(within(frame.dt_s, 0, kFarthest));
  MARROW_CHECK(within(frame.weight, 0, 1));
  MARROW_CHECK(within(squared3(call.up), 0.999f, 1.001f));
  MARROW_CHECK(in_range(frame.world_from_model));
  MARROW_CHECK(inverse_of_linear(frame.world_from_model).determinant > 1e-12f);
  MARROW_CHECK(within(call.feet.lower_m, 0, kFarthest));
  MARROW_CHECK(within(call.feet.leg_extension, 0, 1));
  MARROW_CHECK(within(call.feet.slope_rad, 0, 1.5f));
  MARROW_CHECK(within(call.feet.ease_s, 1e-3f, 1e3f));
  const std::uint32_t pelvis = call.feet.pelvis;
  MARROW_CHECK(pelvis == kNoJoint || pelvis < pose.skeleton.joint_count);
  if (pelvis != kNoJoint) MARROW_CHECK(in_range(pose.model_from_joint[pelvis]));
  for (std::size_t i = 0; i < call.feet.feet.size; ++i) {
    if (const BadCall bad = check_foot(call, call.feet.feet[i], ground[i])) return bad;
  }
  return {};
}

// Solves x'' + 2 r x' + r² x = 0 exactly for one step; call.decay is e^(-r dt).
template <class F>
void die_away(const FeetCall& call, F& x, F& speed) {
  const F both = speed + x * call.rate;
  x = (x + both * call.frame.dt_s) * call.decay;
  speed = (speed - both * call.rate * call.frame.dt_s) * call.decay;
}
void die_away(const FeetCall& call, float (&x)[3], float (&speed)[3]) {
  f32x4 wide_x = load_three(x), wide_speed = load_three(speed);
  die_away(call, wide_x, wide_speed);
  store_wide(x, wide_x);
  store_wide(speed, wide_speed);
}

f32x4 level(const FeetCall& call, f32x4 v) {
  return unit3_or(across3(v, call.up), splat(0.0f));
}

// The turn about up from one level direction to another.
WideRotation level_turn(const FeetCall& call, f32x4 from, f32x4 to) {
  const float s = dot3(cross3(from, to), call.up), c = dot3(from, to);
  const float w = 1.0f + c;
  if (w < 1e-6f && s * s < 1e-6f) {  // they are opposite, or have no direction
    return c == 0 ? no_turn() : WideRotation{call.up};
  }
  return normalised(quaternion(call.up * s, w));
}

// The ground's normal or, if the ground is steeper than Feet::slope_rad, a normal of that slope.
f32x4 leaning(const FeetCall& call, f32x4 normal) {
  const float c = dot3(normal, call.up);
  if (c >= call.slope.cos) return normal;
  return call.up * call.slope.cos + level(call, normal) * call.slope.sin;
}

// The plane that the sole stands on: the one that the ray hit, or the animation's own.
struct Ground {
  f32x4 point, normal;
  bool hit;
};
Ground ground_of(const FeetCall& call, const FootGround& given) {
  const f32x4 normal = unit3_or(load_wide(given.normal), splat(0.0f));
  if (given.hit && dot3(normal, call.up) > kLeastRise) return {load_three(given.point), normal, true};
  return {call.world.origin, call.up, false};
}
// How far the animated sole is to be lifted, so that it is as high above the plane as above the animation's ground.
float lift_to(const FeetCall& call, const Ground& ground, f32x4 sole) {
  const float above = dot3(sole - call.world.origin, call.up);
  return above + dot3(ground.point - sole, ground.normal) / dot3(ground.normal, call.up);
}

// Where the plane is another than in the last frame, the offset takes up the difference, so that the foot does not
// jump.
void change_ground(const FeetCall& call, const Ground& now, f32x4 sole, FootState& s) {
  Ground was = {load_three(s.point), load_three(s.normal), s.hit != 0};
  if (!was.hit) was = {call.world.origin, call.up, false};
  const float step = lift_to(call, now, sole) - lift_to(call, was, sole);
  store_wide(s.offset, load_three(s.offset) - call.up * step);
  store_wide(s.lean, load_three(s.lean) + leaning(call, was.normal) - leaning(call, now.normal));
}

// Heading of a foot: stored when the foot is planted, held while it stays planted, faded out once it is released.
void follow_heading(const FeetCall& call, const Columns& ankle, bool planted, FootState& s) {
  if (s.planted != 0) {
    store(s.turn, level_turn(call, level(call, ankle.axis[s.axis]), load_three(s.heading)).v);
    s.turn_share = 1;
    s.turn_share_speed = 0;
    if (planted) return;
  }
  die_away(call, s.turn_share, s.turn_share_speed);
  if (!planted) return;
  const Vector3 rise = narrow(absolute(products(ankle.axis, call.up)));
  s.axis = rise.x <= rise.y && rise.x <= rise.z ? 0 : rise.y <= rise.z ? 1 : 2;
  const WideRotation left = share_of(WideRotation{load(s.turn)}, s.turn_share);
  store_wide(s.heading, level(call, rotate(left, ankle.axis[s.axis])));
}

f32x4 sole_of(const FeetCall& call, const Foot& foot) {
  return at(call.world, call.pose.model_from_joint[foot.ankle], foot.sole);
}

// Moves one foot's motion on by one frame.
void follow(const FeetCall& call, const Foot& foot, const FootGround& given, FootMotion& m) {
  const f32x4 sole = sole_of(call, foot);
  const Ground ground = ground_of(call, given);
  FootState& s = state_of(m);
  if (s.begun == 0 || call.frame.teleported) {
    m = {};
    s.begun = 1;
    s.turn[3] = 1;
  } else {
    change_ground(call, ground, sole, s);
  }
  const f32x4 target = sole + call.up * lift_to(call, ground, sole), was = load_three(s.offset);
  die_away(call, s.offset, s.offset_speed);
  die_away(call, s.lean, s.lean_speed);
  f32x4 shown = target + load_three(s.offset);
  follow_heading(call, right_axes(call.world, call.pose.model_from_joint[foot.ankle]), given.planted, s);
  if (given.planted && s.planted != 0) {
    const f32x4 place = load_three(m.place);
    shown = place + call.up * dot3(shown - place, call.up);
    const f32x4 offset = shown - target;
    // Across `up`: the speed at which the target leaves the sole behind. Along `up`: what die_away() has made of it.
    if (call.frame.dt_s > 0) {
      const f32x4 speed = (offset - was) * (1.0f / call.frame.dt_s);
      store_wide(s.offset_speed, speed + call.up * dot3(load_three(s.offset_speed) - speed, call.up));
    }
    store_wide(s.offset, offset);
  }
  s.planted = given.planted ? 1 : 0;
  s.hit = ground.hit ? 1 : 0;
  store_wide(m.place, shown);
  store_wide(s.point, ground.point);
  store_wide(s.normal, ground.normal);
}

// Whether a motion's numbers are in range. Games may hand in any bytes.
bool is_sound(const FootMotion& m) {
  constexpr float kMostPlace = 1e9f, kMostSpeed = 1e18f;
  const auto is_near = [](const float(&v)[3]) { return is_smaller(load_wide(v), kMostPlace); };
  const auto is_slow = [](const float(&v)[3]) { return is_smaller(load_wide(v), kMostSpeed); };
  const FootState& s = state_of(m);
  return is_near(m.place) && is_near(s.offset) && is_slow(s.offset_speed) && is_near(s.lean) && is_slow(s.lean_speed) &&
         is_near(s.point) && is_near(s.normal) && is_near(s.heading) && is_smaller(load(s.turn), 1.01f) &&
         absolute(s.turn_share) < kMostPlace && absolute(s.turn_share_speed) < kMostSpeed && s.axis < 3;
}

// follow(), beginning anew where the motion is not sound before or after.
void follow_soundly(const FeetCall& call, const Foot& foot, const FootGround& given, FootMotion& m) {
  if (!is_sound(m)) m = {};
  follow(call, foot, given, m);
  if (is_sound(m)) return;
  m = {};
  follow(call, foot, given, m);
}

// The turn from the animated orientation of a foot to the shown one.
WideRotation shown_turn(const FeetCall& call, const FootState& s) {
  const f32x4 normal = unit3_or(leaning(call, load_three(s.normal)) + load_three(s.lean), call.up);
  return shortest_arc(call.up, normal) * share_of(WideRotation{load(s.turn)}, s.turn_share);
}

// Where the ankle has to be for the sole to stand at its place once the foot is turned by `turned`.
f32x4 ankle_of(const FeetCall& call, const Foot& foot, const FootMotion& m, WideRotation turned) {
  const f32x4 sole = turned_by(call.pose.model_from_joint[foot.ankle], load_three(foot.sole));
  return load_three(m.place) - rotate(turned, turn(call.world, sole));
}

// How far the pelvis, once lifted, is too high for the leg to reach. The longest that the leg may get is
// Feet::leg_extension of its bones' length. If the animated leg is longer than that, it may be as long as it is, less
// the distance by which the ankle moves as seen from the hip.
float too_high(const FeetCall& call, const Foot& foot, const FootMotion& m, float lift) {
  const f32x4 hip = place_of(call, foot.hip), knee = place_of(call, foot.knee), ankle = place_of(call, foot.ankle);
  const f32x4 leg = hip + call.up * lift - ankle_of(call, foot, m, shown_turn(call, state_of(m))),
              animated = hip - ankle;
  const float most = call.feet.leg_extension * (length3(knee - hip) + length3(ankle - knee));
  const float own = length3(animated) - length3(leg - animated), longest = most > own ? most : own;
  const float down = dot3(leg, call.up), square = longest * longest - (squared3(leg) - down * down);
  const float highest = square > 0 ? sqrt(square) : 0.0f;
  return down > highest ? down - highest : 0.0f;
}

// How far the pelvis is lifted: as far as the sole that rises least, less what the legs need to reach their soles.
float pelvis_lift(const FeetCall& call, Span<const FootMotion> motion) {
  const float most = call.feet.lower_m;
  float lift = 0, excess = 0;
  bool first = true;
  for (std::size_t i = 0; i < call.feet.feet.size; ++i) {
    const Foot& foot = call.feet.feet[i];
    const float own = foot.weight * dot3(load_three(motion[i].place) - sole_of(call, foot), call.up);
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

// A direction taken to the space that `m` comes from; 0 if m is flat.
f32x4 to_space_of(const Affine& m, f32x4 way) {
  const Inverse inverse = inverse_of_linear(m);
  if (!(absolute(inverse.determinant) > 1e-30f)) return splat(0.0f);
  return turn(inverse.columns, way) * (1.0f / inverse.determinant);
}

void move_pelvis(const FeetCall& call, float lift) {
  const std::uint32_t joint = call.feet.pelvis;
  if (joint == kNoJoint || lift == 0) return;
  const f32x4 wide_way =
      to_space_of(map_above(call.pose, joint), to_space_of(call.frame.world_from_model, call.up * lift));
  if (!in_range(wide_way)) return;
  const Vector3 way = narrow(wide_way);
  float(&t)[3][4] = call.pose.local[joint / 4].translation;
  t[0][joint % 4] += way.x, t[1][joint % 4] += way.y, t[2][joint % 4] += way.z;
  update_below(call.pose, joint);
}

// Bends the leg to `goal` and turns the ankle to the axes `want`. Leaves a leg with numbers out of range as it is.
void turn_leg(const FeetCall& call, const Foot& foot, const TwoBone& goal, const Columns& want, bool& reached) {
  const Affine& ankle = call.pose.model_from_joint[foot.ankle];
  if (solve_limb_of_pose(call.pose, {foot.hip, foot.knee, foot.ankle}, goal, &reached)) return;
  const WideRotation q = rotation_between(right_axes(call.world, ankle), want);
  // right_axes() has negated the third axis of a mirrored ankle.
  const float mirror = inverse_of_linear(ankle).determinant < 0 ? -1.0f : 1.0f;
  float own[4];
  store(own, q.v * lanes(mirror, mirror, 1.0f, 1.0f));
  turn_joint(call.pose.local, foot.ankle, own);
  update_below(call.pose, foot.ankle);
}

void place_foot(const FeetCall& call, const Foot& foot, FootMotion& m) {
  TwoBone goal;
  goal.weight = call.frame.weight * foot.weight;
  if (goal.weight == 0) return;
  store(goal.bend_axis, vector3(foot.bend_axis));
  const WideRotation whole = shown_turn(call, state_of(m)), turned = share_of(whole, goal.weight);
  Columns want = right_axes(call.world, call.pose.model_from_joint[foot.ankle]);
  for (f32x4& axis : want.axis) axis = rotate(turned, axis);
  f32x4 target = ankle_of(call, foot, m, whole);
  // More than one pass is needed only under uneven scale, where the foot has another shape once the leg has turned.
  for (int i = 0; i < 3; ++i) {
    const f32x4 in_model = to_space_of(call.frame.world_from_model, target - call.world.origin);
    if (!in_range(in_model)) return;
    store_wide(goal.target, in_model);
    bool reached = false;
    turn_leg(call, foot, goal, want, reached);
    m.reached = reached;
    const f32x4 miss = load_three(m.place) - sole_of(call, foot);
    const f32x4 leg = target - place_of(call, foot.hip);
    if (goal.weight < 1 || !reached || squared3(miss) <= 1e-8f * squared3(leg)) break;
    target = place_of(call, foot.ankle) + miss;
  }
}

}  // namespace

Status foot_of(const Roles& roles, Role role, Foot& out) {
  const bool leg = role == Role::left_foot || role == Role::right_foot;
  MARROW_REQUIRE(leg || role == Role::left_hand || role == Role::right_hand);
  const auto before = [&](std::uint32_t steps) {
    return joint_of(roles, static_cast<Role>(static_cast<std::uint32_t>(role) - steps));
  };
  Foot foot = out;
  foot.hip = before(2);
  foot.knee = before(1);
  foot.ankle = before(0);
  const JointSole* const sole = sole_of(roles, foot.ankle);
  if (foot.hip == kNoJoint || foot.knee == kNoJoint || sole == nullptr) return Status::mismatch;
  for (int c = 0; c < 3; ++c) foot.sole[c] = sole->place[c];
  out = foot;
  return Status::ok;
}

Status foot_sole(const Foot& foot, const Affine& world_from_model, Span<const Affine> model_from_joint,
                 float (&sole_world)[3]) {
  MARROW_REQUIRE(holds(model_from_joint) && foot.ankle < model_from_joint.size);
  const f32x4 sole = at(columns(world_from_model), model_from_joint[foot.ankle], foot.sole);
  MARROW_REQUIRE(in_range(sole));
  store_wide(sole_world, sole);
  return Status::ok;
}

Status place_feet(const Pose& pose, const Feet& feet, const FeetFrame& frame, Span<const FootGround> ground,
                  Span<FootMotion> motion) {
  MARROW_ZONE;
  FeetCall call{pose, feet, frame};
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
