#include "marrow/springs.h"

#include "asset/spring_rules.h"
#include "core/check.h"
#include "core/mark.h"
#include "math/rotation.h"
#include "pose/joint_range.h"
#include "springs/spring_colliders.h"
#include "springs/spring_step.h"

namespace marrow {
namespace {

constexpr float kShortestBone_m = 1e-6f, kLongestBone_m = 1e9f;

// One call: what all bones share.
struct SpringCall {
  const Skeleton& skeleton;
  const SpringFrame& frame;
  Springs& springs;
  Span<SoaTransform> local;
  Affine* scene_from_joint;
  Columns world;                        // world_from_scene
  int steps = 0;                        // 0: no time goes by
  float step_s = 0;                     // of each
  float frame_s = 0;                    // since the last frame that was simulated
  bool moved = false;                   // some chain is moved along
  PlacedCollider* colliders = nullptr;  // as many as the frame has
};

const Affine& above(const SpringCall& call, std::uint32_t joint) {
  return joint < call.skeleton.root_count ? call.skeleton.scene_from_root[joint]
                                          : call.scene_from_joint[call.skeleton.parents[joint]];
}

// Not finite if a number of the matrix is not (or their sum is not, far beyond any scene).
f32x4 sum_of(const Affine& a) {
  return load_aligned(a.rows[0]) + load_aligned(a.rows[1]) + load_aligned(a.rows[2]);
}

MARROW_CALLED_WHERE_SMALL BadCall check_frame(const Skeleton& skeleton, const SpringFrame& frame,
                                              const Springs& springs, Span<const SoaTransform> local,
                                              Span<const Affine> scene_from_joint) {
  MARROW_CHECK(springs.joint_count == skeleton.joint_count);
  MARROW_CHECK(holds(local, skeleton.soa_size()));
  MARROW_CHECK(holds(scene_from_joint, skeleton.joint_count));
  MARROW_CHECK(within(frame.dt_s, 0.0f, 1e9f));
  MARROW_CHECK(within(frame.teleport_m, 0.0f, 1e6f));
  MARROW_CHECK(within(frame.weight, 0.0f, 1.0f));
  MARROW_CHECK(good_point(frame.gravity));
  MARROW_CHECK(good_point(frame.wind));
  MARROW_CHECK(holds(frame.colliders) && frame.colliders.size <= kMaxSpringColliders);
  f32x4 sum = sum_of(frame.world_from_scene);
  for (const SpringCollider& c : frame.colliders) {
    MARROW_CHECK(c.joint < skeleton.joint_count);
    MARROW_CHECK(good_collider(c));
    sum = sum + sum_of(scene_from_joint[c.joint]);
  }
  for (std::uint32_t r = 0; r < springs.root_count; ++r) {
    const std::uint32_t joint = springs.roots[r].first;
    sum = sum + sum_of(joint < skeleton.root_count ? skeleton.scene_from_root[joint]
                                                   : scene_from_joint[skeleton.parents[joint]]);
  }
  for (std::uint32_t g = 0; g < springs.group_count; ++g) {
    for (int lane = 0; lane < 4; ++lane) {
      const std::uint16_t joint = springs.groups[g].joint[lane], end = springs.groups[g].end[lane];
      if (joint == kNoBone) continue;
      sum = sum + sum_of(scene_from_joint[joint]);
      if (end != kNoBone) sum = sum + sum_of(scene_from_joint[end]);
    }
  }
  MARROW_CHECK(all_finite(sum) && "world_from_scene and scene_from_joint");
  return {};
}

void place_colliders(SpringCall& call) {
  for (std::size_t i = 0; i < call.frame.colliders.size; ++i) {
    const SpringCollider& c = call.frame.colliders[i];
    const Columns joint = columns(call.scene_from_joint[c.joint]);
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

// Component by component.
f32x4 held_within(f32x4 v, f32x4 most) {
  const f32x4 least = -most;
  return without_w(select(v < least, least, select(v < most, v, most)));
}

// The velocity and the acceleration at both ends of this frame, of the curve of degree three through the places at them
// whose velocity at the end is that of the parabola through the last three places.
MARROW_CALLED_WHERE_SMALL void follow(const SpringCall& call, f32x4 position, SpringRoot& root) {
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
  return turn(call.world, wide_origin(call.scene_from_joint[joint]).v);
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
  root.world = call.frame.world_from_scene;
}

// The bones that go now: those of a group from `lane` on.
struct SpringPlace {
  SpringGroup& group;
  int lane;

  Vector<Number> vector(const float (&from)[3][4]) const { return Lanes::vector(from, lane); }
  Number number(const float (&from)[4]) const { return Lanes::number(from, lane); }
  std::uint16_t joint(int i) const { return group.joint[lane + i]; }
  const SpringRoot& root(const SpringCall& call, int i) const { return call.springs.roots[group.root[lane + i]]; }
};

// They, in the animated pose, in the world.
struct SpringBones {
  Vector<Number> animated;  // unit, or 0
  Number length, over_length;
  bool begins[Lanes::kCount];  // a chain
};

Vector<Number> in_world(const SpringCall& call, const Vector<Number>& v) {
  const f32x4(&axis)[3] = call.world.axis;
  return Linear<Number>{Lanes::same(axis[0]), Lanes::same(axis[1]), Lanes::same(axis[2])} * v;
}

SpringBones gather(const SpringCall& call, const SpringPlace& place, std::uint16_t& chain) {
  f32x4 in_scene[Lanes::kCount];
  SpringBones out;
  for (int i = 0; i < Lanes::kCount; ++i) {
    const std::uint16_t joint = place.joint(i), end = place.group.end[place.lane + i],
                        root = place.group.root[place.lane + i];
    in_scene[i] = splat(0.0f);
    out.begins[i] = false;
    if (joint == kNoBone) continue;
    const Affine& from = call.scene_from_joint[joint];
    in_scene[i] = end != kNoBone ? wide_origin(call.scene_from_joint[end]).v - wide_origin(from).v
                                 : turn(columns(from), load_wide(call.springs.roots[root].tip));
    out.begins[i] = root != chain;
    chain = root;
  }
  const Vector<Number> bone = in_world(call, Lanes::vector(in_scene));
  const Number squared = dot(bone, bone);
  const Number shortest = number(kShortestBone_m * kShortestBone_m), longest = number(kLongestBone_m * kLongestBone_m);
  const Number over = only_where(shortest < squared, only_where(squared < longest, inverse_length(squared)));
  out.over_length = over;
  out.length = squared * over;
  out.animated = bone * over;
  return out;
}

// Lanes that have not begun, or whose bone had no length, stand as animated.
void begin(const SpringBones& bones, const SpringPlace& place) {
  SpringGroup& group = place.group;
  const Vector<Number> d = place.vector(group.direction);
  const auto has_motion = number(0.25f) < dot(d, d), has_length = number(0.0f) < bones.over_length;
  const Vector<Number> velocity = only_where(has_motion, place.vector(group.velocity));
  Lanes::store(group.direction, place.lane, only_where(has_length, select(has_motion, d, bones.animated)));
  Lanes::store(group.velocity, place.lane, only_where(has_length, velocity));
  Lanes::store(group.animated, place.lane, select(has_motion, place.vector(group.animated), bones.animated));
}

// SpringBones of chains that are moved along: as if the animation stood still meanwhile.
void move_along(const SpringCall& call, const SpringBones& bones, const SpringPlace& place) {
  SpringGroup& group = place.group;
  f32x4 animated[Lanes::kCount];
  Lanes::split(bones.animated, animated);
  for (int i = 0; i < Lanes::kCount; ++i) {
    const SpringRoot& root = place.root(call, i);
    if (place.joint(i) == kNoBone || root.moved == 0) continue;
    const int lane = place.lane + i;
    for (float* const v : {group.direction[0], group.velocity[0], group.bent[0]})
      set_three_of_lane(v + lane, turned(root, three_of_lane(v + lane)));
    set_three_of_lane(group.animated[0] + lane, animated[i]);
  }
}

// One row of each one's chain, turned into vectors.
template <class Row>
Vector<Number> of_roots(const SpringCall& call, const SpringPlace& place, const Row& row) {
  const float* rows[Lanes::kCount];
  for (int i = 0; i < Lanes::kCount; ++i) rows[i] = row(place.root(call, i));
  return Lanes::rows(rows);
}

MARROW_CALLED_WHERE_SMALL SpringPull pull_of(const SpringCall& call, const SpringPlace& place,
                                             const SpringBones& bones) {
  const SpringGroup& group = place.group;
  const Vector<Number> was = place.vector(group.animated);
  const Vector<Number> weight = Lanes::same(load_wide(call.frame.gravity)) * place.number(group.gravity);
  const Number drag = place.number(group.drag);
  // At one end of the frame.
  const auto field = [&](int end) {
    const Vector<Number> air = of_roots(call, place, [end](const SpringRoot& r) { return r.air[end]; });
    const auto acceleration = of_roots(call, place, [end](const SpringRoot& r) { return r.acceleration[end]; });
    return no_longer((weight + air * drag - acceleration) * bones.over_length, kMostField);
  };
  SpringPull pull;
  pull.animated = was;
  pull.animated_change = bones.animated - was;
  pull.stiffness = place.number(group.stiffness);
  pull.most_pull = place.number(group.most_pull);
  const Number rate = place.number(group.damping) * number(1.0f / call.frame_s);
  pull.dragged = no_longer(pull.animated_change * rate, kMostField);
  pull.field = field(0);
  pull.field_change = field(1) - pull.field;
  return pull;
}

// What goes from bone to bone down a chain, in one step.
struct Descent {
  f32x4 bent;
  f32x4 joint;
};

// outwards: across the direction, away from what it touches; 0 where it touches nothing.
MARROW_CALLED_WHERE_SMALL void collide_bones(const SpringCall& call, const SpringPlace& place, const SpringBones& bones,
                                             SpringMotion& m, f32x4& at, Vector<Number>& outwards) {
  f32x4 d[Lanes::kCount], v[Lanes::kCount], o[Lanes::kCount];
  float lengths[Lanes::kCount];
  Lanes::split(m.direction, d);
  Lanes::split(m.velocity, v);
  Lanes::split(bones.length, lengths);
  for (int i = 0; i < Lanes::kCount; ++i) {
    o[i] = splat(0.0f);
    if (place.joint(i) == kNoBone) continue;
    if (bones.begins[i]) at = place_of(call, place.joint(i));
    const float bone = lengths[i], radius = place.group.radius_m[place.lane + i];
    if (bone > 0.0f) {
      const std::uint64_t met = place.root(call, i).colliders;
      for (std::size_t c = 0; c < call.frame.colliders.size; ++c)
        if ((met >> c & 1) != 0) collide(call.colliders[c], at, bone, radius, d[i], v[i], o[i]);
    }
    at = at + d[i] * bone;
  }
  m = {Lanes::vector(d), Lanes::vector(v)};
  outwards = Lanes::vector(o);
}

MARROW_CALLED_WHERE_SMALL void step_bones(const SpringCall& call, const SpringBones& bones, const SpringPlace& place,
                                          Descent* descents) {
  SpringGroup& group = place.group;
  const SpringPull pull = pull_of(call, place, bones);
  SpringMotion m = {place.vector(group.direction), place.vector(group.velocity)};
  Quaternion<Number> bent = Lanes::rotation(group.bent, place.lane);
  const Number zero = number(0.0f), damping = place.number(group.damping) + place.number(group.drag);
  const bool may_touch = !call.frame.colliders.empty();
  Vector<Number> was, from, outwards;  // before the drift; what it touches
  SpringStrengths s{};
  SpringForce force;
  SpringWay way;
  Number u = zero;
  for (int step = 0;; ++step) {
    const Vector<Number> animated = animated_at(pull, u);
    if (step > 0) {
      NearestRotation nearest;
      nearest_rotation(animated, m.direction, nearest.columns);
      bent = bend(nearest, bones.begins, descents[step - 1].bent);
    }
    const Vector<Number> field = field_at(pull, animated, u, bent, m.direction);
    const SpringForce next = force_on(field, m.direction);
    if (step == 0) {
      s = spring_strengths(damping, sqrt(dot(field, field)), call.step_s);
    } else {
      m.velocity = (m.velocity + next.across * s.last_kick) * s.decay;
      Number work = twice_work(force, next, way);
      if (may_touch) work = select(zero < dot(outwards, outwards), twice_work(force, next, from, m.direction), work);
      m.velocity = no_faster(m.velocity, was, work);
    }
    if (step == call.steps) break;
    force = next;
    was = m.velocity, from = m.direction;
    m.velocity = was * s.decay + force.across * s.first_kick;
    m = drifted(m, s.drift, way);
    if (may_touch) collide_bones(call, place, bones, m, descents[step].joint, outwards);
    u = number(step + 1 == call.steps ? 1.0f : static_cast<float>(step + 1) / static_cast<float>(call.steps));
  }
  m.direction = normalised(m.direction);
  Lanes::store(group.direction, place.lane, m.direction);
  Lanes::store(group.velocity, place.lane, across(m.velocity, m.direction));
  Lanes::store(group.animated, place.lane, bones.animated);
  Lanes::store(group.bent, place.lane, bent);
}

// A direction in the world as the joints above the bones see it; transposed matrices will do, since lengths are ignored
// and the animated direction goes the same way.
struct IntoParents {
  IntoParents(const SpringCall& call, const SpringPlace& place) {
    const Affine* parents[Lanes::kCount];
    for (int i = 0; i < Lanes::kCount; ++i)
      parents[i] = place.joint(i) == kNoBone ? &kIdentity : &above(call, place.joint(i));
    rows = Lanes::linear_rows(parents);
    for (int i = 0; i < 3; ++i) world[i] = call.world.axis[i];
  }
  Vector<Number> operator()(const Vector<Number>& v) const {
    return normalised(
        rows *
        transposed_times(Linear<Number>{Lanes::same(world[0]), Lanes::same(world[1]), Lanes::same(world[2])}, v));
  }

  Linear<Number> rows;
  f32x4 world[3];
};

// From one unit direction to another, and of that the part `weight`.
MARROW_CALLED_WHERE_SMALL Quaternion<Number> part_of_arc(Vector<Number> from, Vector<Number> to, Number weight) {
  const Number zero = number(0.0f), one = number(1.0f);
  Quaternion<Number> q = quaternion(cross(from, to), one + dot(from, to));
  const Number squared = dot(q, q);
  q = q * inverse_length(squared);
  // Opposite: half a turn about anything across.
  if (const auto opposite = squared < number(1e-10f); any(opposite)) {
    const Number x = x_of(from), y = y_of(from), l = inverse_length(x * x + y * y);
    const auto upright = number(1e3f) < l;
    const Vector<Number> axis = select(upright, vector_of(one, zero, zero), vector_of((zero - y) * l, x * l, zero));
    q = select(opposite, quaternion(axis, zero), q);
  }
  const Quaternion<Number> part = straight_share(q, weight);
  return part * inverse_length(dot(part, part));
}

MARROW_CALLED_WHERE_SMALL void show_bones(const SpringCall& call, const SpringBones& bones, const SpringPlace& place) {
  const Quaternion<Number> above_it = Lanes::rotation(place.group.bent, place.lane);
  const Vector<Number> seen =
      rotate_by_any(conjugate(above_it), two_over_squared(above_it), place.vector(place.group.direction));
  const IntoParents into(call, place);
  const Number zero = number(0.0f), weight = place.number(place.group.weight) * number(call.frame.weight);
  const Quaternion<Number> arc = part_of_arc(into(bones.animated), into(seen), weight);
  float shown[Lanes::kCount];
  Lanes::split(select(zero < bones.over_length, weight, zero), shown);
  f32x4 q[Lanes::kCount];
  for (int i = 0; i < Lanes::kCount; ++i)
    q[i] = shown[i] == 0.0f ? splat(0.0f) : wide_rotation_of(call.local, place.joint(i)).v;
  Lanes::split(arc * Lanes::quaternion(q), q);
  for (int i = 0; i < Lanes::kCount; ++i)
    if (shown[i] != 0.0f) set_rotation(call.local, place.joint(i), WideRotation{q[i]});
}

int steps_of(float dt_s) {
  const float steps = dt_s * (1.0f / kMaxSpringStep_s) - 0.01f;
  if (!(steps < static_cast<float>(kMaxSpringSteps - 1))) return kMaxSpringSteps;
  const int whole = static_cast<int>(steps);
  return steps > static_cast<float>(whole) ? whole + 1 : whole > 0 ? whole : 1;
}

}  // namespace

Status simulate_springs(const Skeleton& skeleton, const SpringFrame& frame, Springs& springs, Span<SoaTransform> local,
                        Span<Affine> scene_from_joint) {
  MARROW_MARK;
  MARROW_REQUIRE_GOOD(check_frame(skeleton, frame, springs, local, scene_from_joint));
  PlacedCollider colliders[kMaxSpringColliders];
  SpringCall call{skeleton, frame, springs, local, scene_from_joint.data, columns(frame.world_from_scene)};
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
  for (std::uint32_t b = 0; b < 4 * springs.group_count; b += Lanes::kCount) {
    const SpringPlace place = {springs.groups[b / 4], static_cast<int>(b % 4)};
    if (place.joint(0) == kNoBone) continue;
    const SpringBones bones = gather(call, place, chain);
    begin(bones, place);
    if (call.moved) move_along(call, bones, place);
    if (call.steps > 0) step_bones(call, bones, place, descents);
    if (frame.weight > 0.0f) show_bones(call, bones, place);
  }
  if (!(frame.weight > 0.0f)) return Status::ok;
  for (std::uint32_t i = 0; i < springs.below_count; ++i)
    transform_joints(skeleton, local.data, springs.below[i].first, springs.below[i].end, scene_from_joint.data);
  return Status::ok;
}

}  // namespace marrow
