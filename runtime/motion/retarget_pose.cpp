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

inline WideRotation wide(const float (&q)[4]) {
  return {load(q)};
}

// before · Π steps · after.
inline WideRotation turned(const MappedTurn& turn, const RigStep* steps, Span<const SoaTransform> rig) {
  WideRotation out = wide(turn.before);
  for (std::uint32_t i = 0; i < turn.step_count; ++i) {
    WideRotation q = wide_rotation_of(rig, steps[i].joint);
    if (steps[i].inverse != 0) q = conjugate(q);
    if (steps[i].mirrored != 0) q = {flip(q.v, lanes(0.0f, -0.0f, -0.0f, 0.0f))};
    out = out * q;
  }
  return out * wide(turn.after);
}

// False if it is beyond what a pose may hold.
bool place_of(const MappedPlace& place, const RigStep* steps, Span<const SoaTransform> rig, float (&out)[3]) {
  f32x4 at = splat(0.0f);
  for (std::uint32_t i = place.step_count; i-- > 0;) {
    const std::size_t joint = steps[i].joint;
    const WideRotation q = normalised(wide_rotation_of(rig, joint));
    at = wide_translation_of(rig, joint) + rotate(q, at * wide_scale_of(rig, joint));
  }
  const Vector3 p = narrow(at);
  for (int axis = 0; axis < 3; ++axis) {
    const float(&row)[4] = place.parent_from_rig[axis];
    out[axis] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
  }
  return all_within(out, 3, -kFarthestMotion, kFarthestMotion);
}

// The steps of places stand behind those of turns.
const RigStep* steps_of_places(const PoseMap& map) {
  const RigStep* first = map.steps.end();
  for (const MappedPlace& place : map.places) first -= place.step_count;
  return first;
}

bool has_places(const PoseMap& map, Span<const SoaTransform> rig) {
  const RigStep* steps = steps_of_places(map);
  for (const MappedPlace& place : map.places) {
    float at[3];
    if (!place_of(place, steps, rig, at)) return false;
    steps += place.step_count;
  }
  return true;
}

void put_places(const PoseMap& map, Span<const SoaTransform> rig, Span<SoaTransform> out) {
  const RigStep* steps = steps_of_places(map);
  for (const MappedPlace& place : map.places) {
    float at[3];
    place_of(place, steps, rig, at);
    for (int axis = 0; axis < 3; ++axis) out[place.joint / 4u].translation[axis][place.joint % 4u] = at[axis];
    steps += place.step_count;
  }
}

void put_turns(const PoseMap& map, Span<const SoaTransform> rig, Span<SoaTransform> out) {
  const RigStep* steps = map.steps.begin();
  for (const MappedTurn* turn = map.turns.begin(); turn != map.turns.end();) {
    const std::uint32_t joint = turn->joint;
    WideRotation sum = turned(*turn, steps, rig);
    const float weight = turn->weight;
    steps += turn->step_count;
    if (++turn != map.turns.end() && turn->joint == joint) {
      sum = {sum.v * weight};
      do {
        const WideRotation q = turned(*turn, steps, rig);
        const float share = turn->weight;
        sum = {sum.v + q.v * (dot4(q.v, sum.v) < 0 ? -share : share)};
        steps += turn->step_count;
      } while (++turn != map.turns.end() && turn->joint == joint);
    }
    set_rotation(out, joint, normalised(sum));
  }
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
  MARROW_REQUIRE(has_places(map, rig) && "a pose of the rig whose places are finite");
  if (groups > 0) std::memcpy(out.data, skeleton.rest, groups * sizeof(SoaTransform));
  put_turns(map, rig, out);
  put_places(map, rig, out);
  return Status::ok;
}

}  // namespace marrow
