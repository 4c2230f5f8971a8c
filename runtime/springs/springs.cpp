#include "marrow/springs.h"

#include "asset/spring_rules.h"
#include "core/check.h"
#include "core/mark.h"
#include "math/joint.h"
#include "math/rotation.h"
#include "pose/joint_range.h"
#include "springs/spring_colliders.h"
#include "springs/spring_state.h"
#include "springs/spring_step.h"

namespace marrow {
namespace {

constexpr float kShortestBone_m = 1e-6f, kLongestBone_m = 1e9f;
alignas(16) constexpr float kNone[4] = {0, 0, 0, 0};

// One call: what all bones share.
struct SpringCall {
  const Skeleton& skeleton;
  const SpringFrame& frame;
  Springs& springs;
  SoaTransform* local;
  Affine* scene_from_joint;
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

BadCall check_frame(const Skeleton& skeleton, const SpringFrame& frame, const Springs& springs,
                    Span<const SoaTransform> local, Span<const Affine> scene_from_joint) {
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
  const Affine& world = call.frame.world_from_scene;
  for (std::size_t i = 0; i < call.frame.colliders.size; ++i) {
    const SpringCollider& c = call.frame.colliders[i];
    const Affine& joint = call.scene_from_joint[c.joint];
    PlacedCollider& out = call.colliders[i];
    out.from = turn(world, transform(joint, vector3(c.from)));
    out.along = turn(world, turn(joint, vector3(c.to) - vector3(c.from)));
    const float squared = dot(out.along, out.along);
    out.over_squared = squared > 1e-20f ? 1.0f / squared : 0.0f;
    float scale = 0.0f;
    constexpr Vector3 kEveryAxis[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vector3& axis : kEveryAxis) {
      const float l = length(turn(world, turn(joint, axis)));
      scale = l > scale ? l : scale;
    }
    out.radius = c.radius_m * scale;
  }
}

Vector3 turned(const SpringRoot& root, const Vector3& v) {
  return transposed_times(Linear<float>{vector3(root.turn[0]), vector3(root.turn[1]), vector3(root.turn[2])}, v);
}

void find_turn(SpringRoot& root, const Affine& world, const Affine& parent) {
  const Linear<float> was = right_axes(root.world, root.parent), is = right_axes(world, parent);
  store(root.turn[0], was * Vector3{is.x.x, is.y.x, is.z.x});
  store(root.turn[1], was * Vector3{is.x.y, is.y.y, is.z.y});
  store(root.turn[2], was * Vector3{is.x.z, is.y.z, is.z.z});
}

// Component by component.
Vector3 held_within(const Vector3& v, float most) {
  const auto limit = [most](float x) { return x < -most ? -most : x < most ? x : most; };
  return {limit(v.x), limit(v.y), limit(v.z)};
}

// The velocity and the acceleration at both ends of this frame, of the curve of degree three through the places at them
// whose velocity at the end is that of the parabola through the last three places.
void follow(const SpringCall& call, const Vector3& position, SpringRoot& root) {
  const float dt = call.frame_s;
  const Vector3 mean = (position - vector3(root.position)) * (1.0f / dt);
  Vector3 begin = vector3(root.velocity), end = mean;
  if (root.moved != 0 || root.frames == 0) {
    end = begin;
  } else if (root.frames == 1) {
    begin = mean;
  } else {
    end = mean + (mean - vector3(root.mean_velocity)) * (dt / (dt + root.frame_s));
  }
  Vector3 first, last;
  if (root.moved == 0 && root.frames == 2) {
    first = held_within((mean * 6.0f - begin * 4.0f - end * 2.0f) * (1.0f / dt), 1e7f);
    last = held_within((mean * -6.0f + begin * 2.0f + end * 4.0f) * (1.0f / dt), 1e7f);
  }
  const Vector3 wind = vector3(call.frame.wind);
  store(root.acceleration[0], first);
  store(root.acceleration[1], last);
  store(root.air[0], wind - begin);
  store(root.air[1], wind - end);
  store(root.velocity, end);
  store(root.mean_velocity, root.moved != 0 ? end : mean);
  root.frame_s = dt;
  if (root.frames < 2) ++root.frames;
}

void prepare_root(SpringCall& call, SpringRoot& root) {
  const Affine& parent = above(call, root.first);
  const Affine& world = call.frame.world_from_scene;
  const Vector3 position = transform(world, origin(call.scene_from_joint[root.first]));
  const Vector3 way = position - vector3(root.position);
  const float most = call.frame.teleport_m;
  root.moved = root.frames > 0 && (call.frame.teleported || !(dot(way, way) <= most * most)) ? 1 : 0;
  if (root.moved != 0) {
    call.moved = true;
    find_turn(root, world, parent);
    store(root.velocity, turned(root, vector3(root.velocity)));
  }
  const bool begins = root.frames == 0;
  if (call.steps > 0) follow(call, position, root);
  if (call.steps == 0 && root.moved == 0 && !begins) return;
  if (begins) root.frames = 1;
  store(root.position, position);
  root.parent = parent;
  root.world = world;
}

// Four bones of the animated pose, in the world.
struct FourBones {
  Vector<f32x4> animated;  // unit, or 0
  f32x4 length, over_length;
  bool begins[4];  // a chain
  Vector3 first[4];
};

FourBones gather(const SpringCall& call, const SpringGroup& group, std::uint16_t& chain) {
  alignas(16) float v[3][4];
  FourBones out;
  for (int lane = 0; lane < 4; ++lane) {
    const std::uint16_t joint = group.joint[lane], end = group.end[lane];
    Vector3 bone;
    out.begins[lane] = false;
    if (joint != kNoBone) {
      const SpringRoot& root = call.springs.roots[group.root[lane]];
      const Affine& from = call.scene_from_joint[joint];
      bone = end != kNoBone ? origin(call.scene_from_joint[end]) - origin(from) : turn(from, vector3(root.tip));
      out.begins[lane] = group.root[lane] != chain;
      chain = group.root[lane];
    }
    v[0][lane] = bone.x, v[1][lane] = bone.y, v[2][lane] = bone.z;
  }
  const Vector<f32x4> bone = transposed_times(splat(linear_rows(call.frame.world_from_scene)), load_vectors(v));
  const f32x4 squared = dot(bone, bone), zero = splat(0.0f);
  const f32x4 shortest = splat(kShortestBone_m * kShortestBone_m), longest = splat(kLongestBone_m * kLongestBone_m);
  f32x4 over = select(squared < longest, inverse_length(squared), zero);
  over = select(shortest < squared, over, zero);
  out.over_length = over;
  out.length = squared * over;
  out.animated = bone * over;
  return out;
}

// Lanes that have not begun, or whose bone had no length, stand as animated.
void begin(const FourBones& bones, SpringGroup& group) {
  const Vector<f32x4> d = load_vectors(group.direction);
  const f32x4 zero = splat(0.0f);
  const Vector<f32x4> none = splat(0.0f, 0.0f, 0.0f);
  const mask4 has_motion = splat(0.25f) < dot(d, d), has_length = zero < bones.over_length;
  store_vectors(group.direction, select(has_length, select(has_motion, d, bones.animated), none));
  store_vectors(group.velocity, select(has_length, select(has_motion, load_vectors(group.velocity), none), none));
  store_vectors(group.animated, select(has_motion, load_vectors(group.animated), bones.animated));
}

// Lanes of chains that are moved along: as if the animation stood still meanwhile.
void move_along(const SpringCall& call, const FourBones& bones, SpringGroup& group) {
  alignas(16) float animated[3][4];
  store_vectors(animated, bones.animated);
  for (int lane = 0; lane < 4; ++lane) {
    const SpringRoot& root = call.springs.roots[group.root[lane]];
    if (group.joint[lane] == kNoBone || root.moved == 0) continue;
    float* const moving[3] = {&group.direction[0][lane], &group.velocity[0][lane], &group.bent[0][lane]};
    for (float* const v : moving) {
      const Vector3 to = turned(root, {v[0], v[4], v[8]});
      v[0] = to.x, v[4] = to.y, v[8] = to.z;
    }
    for (int i = 0; i < 3; ++i) group.animated[i][lane] = animated[i][lane];
  }
}

// One row of each lane's chain, turned into vectors.
Vector<f32x4> of_roots(const SpringCall& call, const SpringGroup& group, const float* (*row)(const SpringRoot&)) {
  const SpringRoot* const roots = call.springs.roots;
  f32x4 a = load_aligned(row(roots[group.root[0]])), b = load_aligned(row(roots[group.root[1]])),
        c = load_aligned(row(roots[group.root[2]])), d = load_aligned(row(roots[group.root[3]]));
  transpose(a, b, c, d);
  return {a, b, c};
}

SpringPull pull_of(const SpringCall& call, const SpringGroup& group, const FourBones& bones) {
  const float(&g)[3] = call.frame.gravity;
  const Vector<f32x4> was = load_vectors(group.animated);
  const Vector<f32x4> weight = splat(g[0], g[1], g[2]) * load_aligned(group.gravity);
  const f32x4 drag = load_aligned(group.drag);
  const auto field = [&](const Vector<f32x4>& air, const Vector<f32x4>& acceleration) {
    return no_longer((weight + air * drag - acceleration) * bones.over_length, kMostField);
  };
  SpringPull pull;
  pull.animated = was;
  pull.animated_change = bones.animated - was;
  pull.stiffness = load_aligned(group.stiffness);
  pull.most_pull = load_aligned(group.most_pull);
  const f32x4 rate = load_aligned(group.damping) * splat(1.0f / call.frame_s);
  pull.dragged = no_longer(pull.animated_change * rate, kMostField);
  pull.field = field(of_roots(call, group, [](const SpringRoot& r) -> const float* { return r.air[0]; }),
                     of_roots(call, group, [](const SpringRoot& r) -> const float* { return r.acceleration[0]; }));
  const Vector<f32x4> last =
      field(of_roots(call, group, [](const SpringRoot& r) -> const float* { return r.air[1]; }),
            of_roots(call, group, [](const SpringRoot& r) -> const float* { return r.acceleration[1]; }));
  pull.field_change = last - pull.field;
  return pull;
}

// What goes from bone to bone down a chain, in one step.
struct Descent {
  f32x4 bent;
  Vector3 joint;
};

// outwards: across the direction, away from what it touches; 0 where it touches nothing.
void collide_four(const SpringCall& call, const SpringGroup& group, const FourBones& bones, SpringMotion& m,
                  Vector3& at, Vector<f32x4>& outwards) {
  alignas(16) float d[3][4], v[3][4], o[3][4] = {}, lengths[4];
  store_vectors(d, m.direction);
  store_vectors(v, m.velocity);
  store(lengths, bones.length);
  const Affine& world = call.frame.world_from_scene;
  for (int lane = 0; lane < 4; ++lane) {
    if (group.joint[lane] == kNoBone) break;
    if (bones.begins[lane]) at = turn(world, origin(call.scene_from_joint[group.joint[lane]]));
    const float bone = lengths[lane];
    Vector3 direction = {d[0][lane], d[1][lane], d[2][lane]}, velocity = {v[0][lane], v[1][lane], v[2][lane]}, out;
    if (bone > 0.0f) {
      const std::uint64_t met = call.springs.roots[group.root[lane]].colliders;
      for (std::size_t c = 0; c < call.frame.colliders.size; ++c)
        if ((met >> c & 1) != 0) collide(call.colliders[c], at, bone, group.radius_m[lane], direction, velocity, out);
    }
    at = at + direction * bone;
    d[0][lane] = direction.x, d[1][lane] = direction.y, d[2][lane] = direction.z;
    v[0][lane] = velocity.x, v[1][lane] = velocity.y, v[2][lane] = velocity.z;
    o[0][lane] = out.x, o[1][lane] = out.y, o[2][lane] = out.z;
  }
  m = {load_vectors(d), load_vectors(v)};
  outwards = load_vectors(o);
}

void step_four(const SpringCall& call, const FourBones& bones, SpringGroup& group, Descent* descents) {
  const SpringPull pull = pull_of(call, group, bones);
  SpringMotion m = {load_vectors(group.direction), load_vectors(group.velocity)};
  Quaternion<f32x4> bent = load_rotations(group.bent);
  const Vector<f32x4> field = field_at(pull, animated_at(pull, splat(0.0f)), splat(0.0f), bent, m.direction);
  const SpringStrengths s =
      spring_strengths(load_aligned(group.damping) + load_aligned(group.drag), sqrt(dot(field, field)), call.step_s);
  SpringForce force = force_on(field, m.direction);
  const bool may_touch = !call.frame.colliders.empty();
  const f32x4 zero = splat(0.0f);
  for (int step = 0; step < call.steps; ++step) {
    const Vector<f32x4> was = m.velocity, from = m.direction;
    m.velocity = was * s.decay + force.across * s.first_kick;
    SpringWay way;
    m = drifted(m, s.drift, way);
    Vector<f32x4> outwards = splat(0.0f, 0.0f, 0.0f);
    if (may_touch) collide_four(call, group, bones, m, descents[step].joint, outwards);
    const f32x4 u =
        splat(step + 1 == call.steps ? 1.0f : static_cast<float>(step + 1) / static_cast<float>(call.steps));
    const Vector<f32x4> animated = animated_at(pull, u);
    NearestRotation nearest;
    nearest_rotation(animated, m.direction, nearest);
    bent = bend(nearest, bones.begins, descents[step].bent);
    const SpringForce next = force_on(field_at(pull, animated, u, bent, m.direction), m.direction);
    m.velocity = (m.velocity + next.across * s.last_kick) * s.decay;
    f32x4 work = twice_work(force, next, way);
    if (may_touch) work = select(zero < dot(outwards, outwards), twice_work(force, next, from, m.direction), work);
    m.velocity = no_faster(m.velocity, was, work);
    force = next;
  }
  m.direction = normalised(m.direction);
  store_vectors(group.direction, m.direction);
  store_vectors(group.velocity, across(m.velocity, m.direction));
  store_vectors(group.animated, bones.animated);
  store_rotations(group.bent, bent);
}

// A direction in the world as the joints above four bones see it; transposed matrices will do, since lengths are
// ignored and the animated direction goes the same way.
struct IntoParents {
  IntoParents(const SpringCall& call, const SpringGroup& group) {
    const Affine* parents[4];
    for (int lane = 0; lane < 4; ++lane)
      parents[lane] = group.joint[lane] == kNoBone ? &kIdentity : &above(call, group.joint[lane]);
    rows = linear_rows(load_affines(*parents[0], *parents[1], *parents[2], *parents[3]));
    world = splat(linear(call.frame.world_from_scene));
  }
  Vector<f32x4> operator()(const Vector<f32x4>& v) const { return normalised(rows * transposed_times(world, v)); }

  Linear<f32x4> rows, world;
};

// From one unit direction to another, and of that the part `weight`.
Quaternion<f32x4> part_of_arc(const Vector<f32x4>& from, const Vector<f32x4>& to, f32x4 weight) {
  const f32x4 one = splat(1.0f);
  Quaternion<f32x4> q = quaternion(cross(from, to), one + dot(from, to));
  const f32x4 squared = dot(q, q);
  q = q * inverse_length(squared);
  // Opposite: half a turn about anything across.
  const mask4 opposite = squared < splat(1e-10f);
  if (any(opposite)) {
    const f32x4 zero = splat(0.0f), l = inverse_length(from.x * from.x + from.y * from.y);
    const mask4 upright = splat(1e3f) < l;
    q.x = select(opposite, select(upright, one, (zero - from.y) * l), q.x);
    q.y = select(opposite, select(upright, zero, from.x * l), q.y);
    q.z = select(opposite, zero, q.z);
    q.w = select(opposite, zero, q.w);
  }
  return share_of(q, weight);
}

void show_four(const SpringCall& call, const FourBones& bones, const SpringGroup& group) {
  const Quaternion<f32x4> above_it = load_rotations(group.bent);
  const Vector<f32x4> seen =
      rotate_by_any(conjugate(above_it), two_over_squared(above_it), load_vectors(group.direction));
  const IntoParents into(call, group);
  const f32x4 weight = load_aligned(group.weight) * splat(call.frame.weight);
  const Quaternion<f32x4> arc = part_of_arc(into(bones.animated), into(seen), weight);
  alignas(16) float shown[4], none[16] = {};
  const f32x4 zero = splat(0.0f);
  store(shown, select(zero < bones.over_length, weight, zero));
  float* lanes[4];
  for (int lane = 0; lane < 4; ++lane) {
    const std::uint32_t joint = group.joint[lane];
    lanes[lane] = shown[lane] == 0.0f ? none : &call.local[joint / 4].rotation[0][joint % 4];
  }
  const auto row = [&](int i) {
    alignas(16) const float four[4] = {lanes[0][i], lanes[1][i], lanes[2][i], lanes[3][i]};
    return load_aligned(four);
  };
  const Quaternion<f32x4> bent = arc * Quaternion<f32x4>{row(0), row(4), row(8), row(12)};
  alignas(16) float out[4][4];
  store_rotations(out, bent);
  for (int lane = 0; lane < 4; ++lane) {
    if (shown[lane] == 0.0f) continue;
    for (int i = 0; i < 4; ++i) lanes[lane][4 * i] = out[i][lane];
  }
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
  SpringCall call{skeleton, frame, springs, local.data, scene_from_joint.data};
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
  for (int s = 0; s < call.steps; ++s) descents[s] = {load_aligned(kNone), {}};
  std::uint16_t chain = kNoBone;
  for (std::uint32_t g = 0; g < springs.group_count; ++g) {
    SpringGroup& group = springs.groups[g];
    const FourBones bones = gather(call, group, chain);
    begin(bones, group);
    if (call.moved) move_along(call, bones, group);
    if (call.steps > 0) step_four(call, bones, group, descents);
    if (frame.weight > 0.0f) show_four(call, bones, group);
  }
  if (!(frame.weight > 0.0f)) return Status::ok;
  for (std::uint32_t i = 0; i < springs.below_count; ++i)
    transform_joints(skeleton, local.data, springs.below[i].first, springs.below[i].end, scene_from_joint.data);
  return Status::ok;
}

}  // namespace marrow
