#include "marrow/springs.h"

#include "asset/spring_rules.h"
#include "core/check.h"
#include "core/zone.h"
#include "math/rotation.h"
#include "pose/joint_range.h"
#include "springs/spring_colliders.h"
#include "springs/spring_step.h"

namespace marrow {
namespace {

constexpr float kShortestBone_m = 1e-6f, kLongestBone_m = 1e9f;

// What all bones of a call share.
struct SpringCall {
  const Pose& pose;
  const SpringFrame& frame;
  Springs& springs;
  Columns world;                        // world_from_model
  int steps = 0;                        // 0: no time goes by
  float step_s = 0;                     // of each
  float frame_s = 0;                    // since the last frame that was simulated
  bool moved = false;                   // some chain is moved rigidly
  PlacedCollider* colliders = nullptr;  // as many as the frame has
};

// The matrix of what is above a joint: model_from_parent.
const Affine& above(const SpringCall& call, std::uint32_t joint) {
  const Skeleton& skeleton = call.pose.skeleton;
  return joint < skeleton.root_count ? skeleton.model_from_root[joint]
                                     : call.pose.model_from_joint[skeleton.parents[joint]];
}

// A sum that is not finite if some number of the matrix is not, or if numbers are far beyond any scene.
f32x4 sum_of(const Affine& a) {
  return load_aligned(a.rows[0]) + load_aligned(a.rows[1]) + load_aligned(a.rows[2]);
}

BadCall check_frame(const SpringCall& call) {
  const Pose& pose = call.pose;
  const SpringFrame& frame = call.frame;
  const Springs& springs = call.springs;
  MARROW_CHECK(springs.joint_count == pose.skeleton.joint_count);
  MARROW_CHECK(holds(pose.local, pose.skeleton.soa_size()));
  MARROW_CHECK(holds(pose.model_from_joint, pose.skeleton.joint_count));
  MARROW_CHECK(within(frame.dt_s, 0.0f, 1e9f));
  MARROW_CHECK(within(frame.teleport_m, 0.0f, 1e6f));
  MARROW_CHECK(within(frame.weight, 0.0f, 1.0f));
  MARROW_CHECK(good_point(frame.gravity));
  MARROW_CHECK(good_point(frame.wind));
  MARROW_CHECK(holds(frame.colliders) && frame.colliders.size <= kMaxSpringColliders);
  f32x4 sum = sum_of(frame.world_from_model);
  for (const SpringCollider& c : frame.colliders) {
    MARROW_CHECK(c.joint < pose.skeleton.joint_count);
    MARROW_CHECK(good_collider(c));
    sum = sum + sum_of(pose.model_from_joint[c.joint]);
  }
  for (std::uint32_t r = 0; r < springs.root_count; ++r) {
    sum = sum + sum_of(above(call, springs.roots[r].first));
  }
  for (std::uint32_t g = 0; g < springs.group_count; ++g) {
    for (int lane = 0; lane < 4; ++lane) {
      const std::uint16_t joint = springs.groups[g].joint[lane], end = springs.groups[g].end[lane];
      if (joint == kNoBone) continue;
      sum = sum + sum_of(pose.model_from_joint[joint]);
      if (end != kNoBone) sum = sum + sum_of(pose.model_from_joint[end]);
    }
  }
  MARROW_CHECK(all_finite(sum) && "world_from_model and model_from_joint");
  return {};
}

void place_colliders(SpringCall& call) {
  for (std::size_t i = 0; i < call.frame.colliders.size; ++i) {
    const SpringCollider& c = call.frame.colliders[i];
    const Columns joint = columns(call.pose.model_from_joint[c.joint]);
    const f32x4 from = load_wide(c.from);
    PlacedCollider& out = call.colliders[i];
    out.from = turn(call.world, transform(joint, from));
    out.along = turn(call.world, turn(joint, load_wide(c.to) - from));
    const float squared = squared3(out.along);
    out.over_squared = squared > 1e-20f ? 1.0f / squared : 0.0f;
    float scale = 0.0f;
    for (const f32x4 axis : joint.axis) scale = greater(scale, length3(turn(call.world, axis)));
    out.radius = c.radius_m * scale;
  }
}

f32x4 turned(const SpringRoot& root, f32x4 v) {
  const f32x4 rows[3] = {load_three(root.turn[0]), load_three(root.turn[1]), load_three(root.turn[2])};
  return products(rows, v);
}

void find_turn(SpringRoot& root, const Columns& world, const Affine& parent) {
  const Columns was = right_axes(columns(root.world), root.parent);
  Columns is = right_axes(world, parent);
  transpose(is.axis[0], is.axis[1], is.axis[2], is.origin);
  for (int i = 0; i < 3; ++i) store_wide(root.turn[i], turn(was, is.axis[i]));
}

// Each component held within ±most.
f32x4 held_within(f32x4 v, f32x4 most) {
  const f32x4 least = -most;
  return without_w(select(v < least, least, select(v < most, v, most)));
}

// Finds the first joint's velocity and acceleration at both ends of the frame: those of the cubic curve between its two
// places, which ends with the velocity of the parabola through the last three places.
void follow(const SpringCall& call, f32x4 position, SpringRoot& root) {
  const float dt = call.frame_s;
  const f32x4 mean = (position - load_wide(root.position)) * (1.0f / dt);
  f32x4 begin = load_wide(root.velocity), end = mean;
  if (root.moved != 0 || root.frames == 0) {
    end = begin;
  } else if (root.frames == 1) {
    begin = mean;
  } else {
    end = mean + (mean - load_wide(root.mean_velocity)) * (dt / (dt + root.frame_s));
  }
  f32x4 first = splat(0.0f), last = first;
  if (root.moved == 0 && root.frames == 2) {
    const f32x4 most = splat(1e7f);
    first = held_within((mean * 6.0f - begin * 4.0f - end * 2.0f) * (1.0f / dt), most);
    last = held_within((mean * -6.0f + begin * 2.0f + end * 4.0f) * (1.0f / dt), most);
  }
  const f32x4 wind = load_wide(call.frame.wind);
  store(root.acceleration[0], first);
  store(root.acceleration[1], last);
  store(root.air[0], wind - begin);
  store(root.air[1], wind - end);
  store_wide(root.velocity, end);
  store_wide(root.mean_velocity, root.moved != 0 ? end : mean);
  root.frame_s = dt;
  if (root.frames < 2) ++root.frames;
}

f32x4 place_of(const SpringCall& call, std::uint32_t joint) {
  return turn(call.world, wide_origin(call.pose.model_from_joint[joint]).v);
}

void prepare_root(SpringCall& call, SpringRoot& root) {
  const Affine& parent = above(call, root.first);
  const f32x4 position = place_of(call, root.first) + call.world.origin;
  const f32x4 way = position - load_wide(root.position);
  const float most = call.frame.teleport_m;
  root.moved = root.frames > 0 && (call.frame.teleported || !(squared3(way) <= most * most)) ? 1 : 0;
  if (root.moved != 0) {
    call.moved = true;
    find_turn(root, call.world, parent);
    store_wide(root.velocity, turned(root, load_wide(root.velocity)));
  }
  const bool begins = root.frames == 0;
  if (call.steps > 0) follow(call, position, root);
  if (call.steps == 0 && root.moved == 0 && !begins) return;
  if (begins) root.frames = 1;
  store_wide(root.position, position);
  root.parent = parent;
  root.world = call.frame.world_from_model;
}

const SpringRoot& root_of(const SpringCall& call, const SpringGroup& group, int i) {
  return call.springs.roots[group.root[i]];
}

// The bones of a group in the animated pose; world.
struct SpringBones {
  Vector<f32x4> animated;  // unit, or 0
  f32x4 length, over_length;
  bool begins[kLanes];  // the bone is the first of a chain
};

Vector<f32x4> in_world(const SpringCall& call, const Vector<f32x4>& v) {
  const f32x4(&axis)[3] = call.world.axis;
  return Linear<f32x4>{in_all_lanes(axis[0]), in_all_lanes(axis[1]), in_all_lanes(axis[2])} * v;
}

SpringBones gather(const SpringCall& call, const SpringGroup& group, std::uint16_t& chain) {
  f32x4 in_model[kLanes];
  SpringBones out;
  for (int i = 0; i < kLanes; ++i) {
    const std::uint16_t joint = group.joint[i], end = group.end[i], root = group.root[i];
    in_model[i] = splat(0.0f);
    out.begins[i] = false;
    if (joint == kNoBone) continue;
    const Affine& from = call.pose.model_from_joint[joint];
    in_model[i] = end != kNoBone ? wide_origin(call.pose.model_from_joint[end]).v - wide_origin(from).v
                                 : turn(columns(from), load_wide(call.springs.roots[root].tip));
    out.begins[i] = root != chain;
    chain = root;
  }
  const Vector<f32x4> bone = in_world(call, join_vectors(in_model));
  const f32x4 squared = dot(bone, bone);
  const f32x4 shortest = splat(kShortestBone_m * kShortestBone_m), longest = splat(kLongestBone_m * kLongestBone_m);
  const f32x4 over = only_where(shortest < squared, only_where(squared < longest, inverse_length(squared)));
  out.over_length = over;
  out.length = squared * over;
  out.animated = bone * over;
  return out;
}

// Puts bones that have not begun, or had no length, where the animation has them.
void begin(const SpringBones& bones, SpringGroup& group) {
  const Vector<f32x4> d = load_vectors(group.direction);
  const auto has_motion = splat(0.25f) < dot(d, d), has_length = splat(0.0f) < bones.over_length;
  const Vector<f32x4> velocity = only_where(has_motion, load_vectors(group.velocity));
  store_vectors(group.direction, only_where(has_length, select(has_motion, d, bones.animated)));
  store_vectors(group.velocity, only_where(has_length, velocity));
  store_vectors(group.animated, select(has_motion, load_vectors(group.animated), bones.animated));
}

// Moves chains rigidly that are to be, as if the animation stood still meanwhile.
void move_along(const SpringCall& call, const SpringBones& bones, SpringGroup& group) {
  f32x4 animated[kLanes];
  split(bones.animated, animated);
  for (int i = 0; i < kLanes; ++i) {
    const SpringRoot& root = root_of(call, group, i);
    if (group.joint[i] == kNoBone || root.moved == 0) continue;
    for (float* const v : {group.direction[0], group.velocity[0], group.bent[0]})
      set_three_of_lane(v + i, turned(root, three_of_lane(v + i)));
    set_three_of_lane(group.animated[0] + i, animated[i]);
  }
}

// One row of each bone's chain, as vectors.
template <class Row>
Vector<f32x4> of_roots(const SpringCall& call, SpringGroup& group, const Row& row) {
  const float* rows[kLanes];
  for (int i = 0; i < kLanes; ++i) rows[i] = row(root_of(call, group, i));
  f32x4 a = load_aligned(rows[0]), b = load_aligned(rows[1]), c = load_aligned(rows[2]), d = load_aligned(rows[3]);
  transpose(a, b, c, d);
  return {a, b, c};
}

SpringPull pull_of(const SpringCall& call, SpringGroup& group, const SpringBones& bones) {
  const Vector<f32x4> was = load_vectors(group.animated);
  const Vector<f32x4> weight = in_all_lanes(load_wide(call.frame.gravity)) * load_aligned(group.gravity);
  const f32x4 drag = load_aligned(group.drag);
  // The field at one end of the frame.
  const auto field = [&](int end) {
    const Vector<f32x4> air = of_roots(call, group, [end](const SpringRoot& r) { return r.air[end]; });
    const auto acceleration = of_roots(call, group, [end](const SpringRoot& r) { return r.acceleration[end]; });
    return no_longer((weight + air * drag - acceleration) * bones.over_length, kMostField);
  };
  SpringPull pull;
  pull.animated = was;
  pull.animated_change = bones.animated - was;
  pull.stiffness = load_aligned(group.stiffness);
  pull.most_pull = load_aligned(group.most_pull);
  const f32x4 rate = load_aligned(group.damping) * splat(1.0f / call.frame_s);
  pull.dragged = no_longer(pull.animated_change * rate, kMostField);
  pull.field = field(0);
  pull.field_change = field(1) - pull.field;
  return pull;
}

// What is handed from bone to bone down a chain in one step.
struct Descent {
  f32x4 bent;   // see SpringGroup
  f32x4 joint;  // where the next bone begins
};

// Turns bones out of colliders. outwards: across the direction, away from what a bone touches; 0 if it touches nothing.
void collide_bones(const SpringCall& call, SpringGroup& group, const SpringBones& bones, SpringMotion& m, f32x4& at,
                   Vector<f32x4>& outwards) {
  f32x4 d[kLanes], v[kLanes], o[kLanes];
  float lengths[kLanes];
  split(m.direction, d);
  split(m.velocity, v);
  store(lengths, bones.length);
  for (int i = 0; i < kLanes; ++i) {
    o[i] = splat(0.0f);
    if (group.joint[i] == kNoBone) continue;
    if (bones.begins[i]) at = place_of(call, group.joint[i]);
    const float bone = lengths[i], radius = group.radius_m[i];
    if (bone > 0.0f) {
      const std::uint64_t met = root_of(call, group, i).colliders;
      for (std::size_t c = 0; c < call.frame.colliders.size; ++c)
        if ((met >> c & 1) != 0) collide(call.colliders[c], at, bone, radius, d[i], v[i], o[i]);
    }
    at = at + d[i] * bone;
  }
  m = {join_vectors(d), join_vectors(v)};
  outwards = join_vectors(o);
}

void step_bones(const SpringCall& call, const SpringBones& bones, SpringGroup& group, Descent* descents) {
  const SpringPull pull = pull_of(call, group, bones);
  SpringMotion m = {load_vectors(group.direction), load_vectors(group.velocity)};
  Quaternion<f32x4> bent = load_rotations(group.bent);
  const f32x4 zero = splat(0.0f), damping = load_aligned(group.damping) + load_aligned(group.drag);
  const bool may_touch = !call.frame.colliders.empty();
  Vector<f32x4> was, from, outwards;  // was, from: before the drift; outwards: see collide_bones()
  SpringStrengths s{};
  SpringForce force;
  SpringWay way;
  f32x4 u = zero;
  for (int step = 0;; ++step) {
    const Vector<f32x4> animated = animated_at(pull, u);
    if (step > 0) {
      NearestRotation nearest;
      nearest_rotation(animated, m.direction, nearest.columns);
      bent = bend(nearest, bones.begins, descents[step - 1].bent);
    }
    const Vector<f32x4> field = field_at(pull, animated, u, bent, m.direction);
    const SpringForce next = force_on(field, m.direction);
    if (step == 0) {
      s = spring_strengths(damping, sqrt(dot(field, field)), call.step_s);
    } else {
      m.velocity = (m.velocity + next.across * s.last_kick) * s.decay;
      f32x4 work = twice_work(force, next, way);
      if (may_touch) work = select(zero < dot(outwards, outwards), twice_work(force, next, from, m.direction), work);
      m.velocity = no_faster(m.velocity, was, work);
    }
    if (step == call.steps) break;
    force = next;
    was = m.velocity, from = m.direction;
    m.velocity = was * s.decay + force.across * s.first_kick;
    m = drifted(m, s.drift, way);
    if (may_touch) collide_bones(call, group, bones, m, descents[step].joint, outwards);
    u = splat(step + 1 == call.steps ? 1.0f : static_cast<float>(step + 1) / static_cast<float>(call.steps));
  }
  m.direction = normalised(m.direction);
  store_vectors(group.direction, m.direction);
  store_vectors(group.velocity, across(m.velocity, m.direction));
  store_vectors(group.animated, bones.animated);
  store_rotations(group.bent, bent);
}

// Takes directions of the world to the spaces above the bones. By transposed matrices, since lengths do not matter and
// the animated direction goes the same way.
struct IntoParents {
  IntoParents(const SpringCall& call, SpringGroup& group) {
    const Affine* parents[kLanes];
    for (int i = 0; i < kLanes; ++i) parents[i] = group.joint[i] == kNoBone ? &kIdentity : &above(call, group.joint[i]);
    rows = linear_rows(load_affines(*parents[0], *parents[1], *parents[2], *parents[3]));
    for (int i = 0; i < 3; ++i) world[i] = call.world.axis[i];
  }
  Vector<f32x4> operator()(const Vector<f32x4>& v) const {
    return normalised(
        rows *
        transposed_times(Linear<f32x4>{in_all_lanes(world[0]), in_all_lanes(world[1]), in_all_lanes(world[2])}, v));
  }

  Linear<f32x4> rows;
  f32x4 world[3];
};

// The part `weight` of the turn from one unit direction to another.
Quaternion<f32x4> part_of_arc(Vector<f32x4> from, Vector<f32x4> to, f32x4 weight) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f);
  Quaternion<f32x4> q = quaternion(cross(from, to), one + dot(from, to));
  const f32x4 squared = dot(q, q);
  q = q * inverse_length(squared);
  // Opposite directions: half a turn about some axis across them.
  if (const auto opposite = squared < splat(1e-10f); any(opposite)) {
    const f32x4 x = x_of(from), y = y_of(from), l = inverse_length(x * x + y * y);
    const auto upright = splat(1e3f) < l;
    const Vector<f32x4> axis = select(upright, vector_of(one, zero, zero), vector_of((zero - y) * l, x * l, zero));
    q = select(opposite, quaternion(axis, zero), q);
  }
  const Quaternion<f32x4> part = straight_share(q, weight);
  return part * inverse_length(dot(part, part));
}

void show_bones(const SpringCall& call, const SpringBones& bones, SpringGroup& group) {
  const Quaternion<f32x4> above_it = load_rotations(group.bent);
  const Vector<f32x4> seen =
      rotate_by_any(conjugate(above_it), two_over_squared(above_it), load_vectors(group.direction));
  const IntoParents into(call, group);
  const f32x4 zero = splat(0.0f), weight = load_aligned(group.weight) * splat(call.frame.weight);
  const Quaternion<f32x4> arc = part_of_arc(into(bones.animated), into(seen), weight);
  float shown[kLanes];
  store(shown, select(zero < bones.over_length, weight, zero));
  f32x4 q[kLanes];
  for (int i = 0; i < kLanes; ++i)
    q[i] = shown[i] == 0.0f ? splat(0.0f) : wide_rotation_of(call.pose.local, group.joint[i]).v;
  split(arc * join_rotations(q), q);
  for (int i = 0; i < kLanes; ++i)
    if (shown[i] != 0.0f) set_rotation(call.pose.local, group.joint[i], WideRotation{q[i]});
}

int steps_of(float dt_s) {
  const float steps = dt_s * (1.0f / kMaxSpringStep_s) - 0.01f;
  if (!(steps < static_cast<float>(kMaxSpringSteps - 1))) return kMaxSpringSteps;
  const int whole = static_cast<int>(steps);
  return steps > static_cast<float>(whole) ? whole + 1 : whole > 0 ? whole : 1;
}

}  // namespace

Status simulate_springs(const Pose& pose, const SpringFrame& frame, Springs& springs) {
  MARROW_ZONE;
  SpringCall call{pose, frame, springs, columns(frame.world_from_model)};
  MARROW_REQUIRE_GOOD(check_frame(call));
  PlacedCollider colliders[kMaxSpringColliders];
  call.colliders = colliders;
  call.frame_s = springs.saved_s + frame.dt_s;
  springs.saved_s = call.frame_s;
  if (call.frame_s >= kMinSpringFrame_s) {
    springs.saved_s = 0;
    call.steps = steps_of(call.frame_s);
    const float most = kMaxSpringStep_s * static_cast<float>(kMaxSpringSteps);
    call.step_s = (call.frame_s < most ? call.frame_s : most) / static_cast<float>(call.steps);
    place_colliders(call);
  }
  for (std::uint32_t r = 0; r < springs.root_count; ++r) prepare_root(call, springs.roots[r]);
  Descent descents[kMaxSpringSteps];
  for (int s = 0; s < call.steps; ++s) descents[s] = {splat(0.0f), splat(0.0f)};
  std::uint16_t chain = kNoBone;
  for (std::uint32_t g = 0; g < springs.group_count; ++g) {
    SpringGroup& group = springs.groups[g];
    if (group.joint[0] == kNoBone) continue;
    const SpringBones bones = gather(call, group, chain);
    begin(bones, group);
    if (call.moved) move_along(call, bones, group);
    if (call.steps > 0) step_bones(call, bones, group, descents);
    if (frame.weight > 0.0f) show_bones(call, bones, group);
  }
  if (!(frame.weight > 0.0f)) return Status::ok;
  for (std::uint32_t i = 0; i < springs.below_count; ++i)
    transform_joints(pose.skeleton, pose.local.data, springs.below[i].first, springs.below[i].end,
                     pose.model_from_joint.data);
  return Status::ok;
}

}  // namespace marrow
