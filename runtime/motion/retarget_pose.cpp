#include <cstring>

#include "core/check.h"
#include "core/zone.h"
#include "marrow/clip_motion.h"
#include "marrow/pose_map.h"
#include "math/finite.h"
#include "math/joint.h"

namespace marrow {
namespace {

// What a map that is made by hand may break, and one that is for another skeleton.
BadCall check_map(const PoseMap& map, std::uint32_t joint_count) {
  MARROW_CHECK(holds(map.groups, soa_count(joint_count)));
  MARROW_CHECK(holds(map.turns));
  MARROW_CHECK(holds(map.places));
  MARROW_CHECK(holds(map.steps));
  std::size_t steps = 0;
  bool is_good = true;
  for (const MappedTurn& turn : map.turns) {
    steps += turn.step_count;
    is_good &= turn.joint < joint_count;
  }
  for (const MappedPlace& place : map.places) {
    steps += place.step_count;
    is_good &= place.joint < joint_count && place.step_count > 0;
  }
  for (const RigStep& step : map.steps) is_good &= step.joint < map.rig_joint_count;
  MARROW_CHECK(is_good && "a map of joints of the skeleton and of the rig");
  MARROW_CHECK(steps == map.steps.size && "as many steps as turns and places have");
  return {};
}

bool has_rotations(Span<const SoaTransform> pose, std::size_t groups) {
  const f32x4 least = splat(0.5f), most = splat(4.1f);
  for (std::size_t g = 0; g < groups; ++g) {
    const Quaternion<f32x4> q = load_rotations(pose[g].rotation);
    const f32x4 squared = dot(q, q);
    if (!all(least < squared) || !all(squared < most)) return false;
  }
  return true;
}

// Of unit length; the identity where there is no direction.
inline Quaternion<f32x4> unit_or_identity(const Quaternion<f32x4>& q) {
  const f32x4 zero = splat(0.0f), one = splat(1.0f), any = dot(q, q);
  const f32x4 squared = select(any < splat(1e30f), any, zero);
  return select(splat(1e-30f) < squared, q * (one / sqrt(squared)), {zero, zero, zero, one});
}

void put_groups(const PoseMap& map, Span<const SoaTransform> rig, std::size_t count, SoaTransform* out) {
  static constexpr float kIdentity[13] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  const std::uint32_t rig_joint_count = map.rig_joint_count;
  for (std::size_t g = 0; g < count; ++g) {
    const MappedGroup& group = map.groups[g];
    const auto of = [&](std::uint32_t joint) {
      return joint < rig_joint_count ? &rig[joint / 4].rotation[0][joint % 4] : kIdentity;
    };
    const float *const a = of(group.rig_joints[0]), *const b = of(group.rig_joints[1]);
    const float *const c = of(group.rig_joints[2]), *const d = of(group.rig_joints[3]);
    const auto component = [&](std::size_t i) { return lanes(a[i], b[i], c[i], d[i]); };
    const auto loaded = [](const float(&q)[4][4]) {
      return Quaternion<f32x4>{load(q[0]), load(q[1]), load(q[2]), load(q[3])};
    };
    const Quaternion<f32x4> r = {component(0), component(4), component(8), component(12)};
    store_rotations(out[g].rotation, unit_or_identity(loaded(group.before) * r * loaded(group.after)));
  }
}

// before · Π steps · after.
inline WideRotation turned(const MappedTurn& turn, const RigStep* steps, Span<const SoaTransform> rig) {
  WideRotation out = {load(turn.before)};
  for (std::uint32_t i = 0; i < turn.step_count; ++i) {
    WideRotation q = wide_rotation_of(rig, steps[i].joint);
    if (steps[i].inverse != 0) q = conjugate(q);
    if (steps[i].mirrored != 0) q = {flip(q.v, lanes(0.0f, -0.0f, -0.0f, 0.0f))};
    out = out * q;
  }
  return out * WideRotation{load(turn.after)};
}

// Where the last step's joint is, in the space above the first one's.
f32x4 place_of(const RigStep* steps, std::uint32_t count, Span<const SoaTransform> rig) {
  f32x4 at = wide_translation_of(rig, steps[--count].joint);
  while (count > 0) {
    const std::size_t joint = steps[--count].joint;
    const WideRotation q = normalised(wide_rotation_of(rig, joint));
    at = wide_translation_of(rig, joint) + rotate(q, at * wide_scale_of(rig, joint));
  }
  return at;
}

// `steps`: behind those of turns.
void put_places(const PoseMap& map, const RigStep* steps, Span<const SoaTransform> rig, Span<SoaTransform> out) {
  for (const MappedPlace& place : map.places) {
    const Vector3 p = narrow(place_of(steps, place.step_count, rig));
    float at[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float(&row)[4] = place.parent_from_rig[axis];
      at[axis] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
    }
    steps += place.step_count;
    if (!all_within(at, 3, -kFarthestMotion, kFarthestMotion)) continue;
    float* const to = &out[place.joint / 4u].translation[0][place.joint % 4u];
    for (int axis = 0; axis < 3; ++axis) to[4 * axis] = at[axis];
  }
}

// Returns the steps behind those of turns.
const RigStep* put_turns(const PoseMap& map, Span<const SoaTransform> rig, Span<SoaTransform> out) {
  const RigStep* steps = map.steps.begin();
  for (const MappedTurn* turn = map.turns.begin(); turn != map.turns.end();) {
    const std::uint32_t joint = turn->joint;
    f32x4 sum = splat(0.0f);
    do {
      const f32x4 q = turned(*turn, steps, rig).v;
      sum = sum + q * (dot4(q, sum) < 0 ? -turn->weight : turn->weight);
      steps += turn->step_count;
    } while (++turn != map.turns.end() && turn->joint == joint);
    set_rotation(out, joint, normalised(WideRotation{sum}));
  }
  return steps;
}

}  // namespace

Status retarget_pose(const PoseMap& map, Span<const SoaTransform> rig, const Skeleton& skeleton,
                     Span<SoaTransform> out) {
  MARROW_ZONE;
  const std::size_t rig_groups = soa_count(map.rig_joint_count), groups = skeleton.soa_size();
  MARROW_REQUIRE(holds(rig, rig_groups));
  MARROW_REQUIRE(holds(out, groups));
  MARROW_REQUIRE_GOOD(check_map(map, skeleton.joint_count));
  MARROW_REQUIRE(has_rotations(rig, rig_groups) && "a pose of the rig whose rotations have a length");
  if (groups > 0) std::memcpy(out.data, skeleton.rest, groups * sizeof(SoaTransform));
  put_groups(map, rig, groups, out.data);
  put_places(map, put_turns(map, rig, out), rig, out);
  return Status::ok;
}

}  // namespace marrow
