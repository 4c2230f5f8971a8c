#include "marrow/root_motion.h"

#include "core/check.h"
#include "math/finite.h"
#include "math/rigid.h"
#include "motion/motion_rules.h"
#include "motion/root_screw.h"

namespace marrow {
namespace {

constexpr float kMostStepWeight = 1e6f;

bool turns(const RootKey& key) {
  return key.rotation[0] != 0 || key.rotation[1] != 0 || key.rotation[2] != 0;
}

// Most clips go straight on, which costs little.
bool turns(const RigidMotion& m) {
  return m.rotation.x != 0 || m.rotation.y != 0 || m.rotation.z != 0;
}

Vector<double> place_between(const RootKey& a, const RootKey& b, double share) {
  return vector_of_doubles(a.translation) * (1.0 - share) + vector_of_doubles(b.translation) * share;
}

// M(t).
RigidMotion root_at(Span<const RootKey> keys, double time_s) {
  if (keys.empty()) return {};
  std::size_t low = 0, high = keys.size;
  while (high - low > 1) {
    const std::size_t middle = low + (high - low) / 2;
    (time_s < static_cast<double>(keys[middle].time_s) ? high : low) = middle;
  }
  const RootKey &a = keys[low], &b = keys[high < keys.size ? high : low];
  const double from_s = static_cast<double>(a.time_s), span_s = static_cast<double>(b.time_s) - from_s;
  const double u = from_s < time_s && span_s > 0 ? (time_s - from_s) / span_s : 0.0, v = 1.0 - u;
  if (!turns(a) && !turns(b)) return {{}, place_between(a, b, u)};
  const RigidMotion one = stored_rigid(a.rotation, a.translation), other = stored_rigid(b.rotation, b.translation);
  const double turn = dot(one.rotation, other.rotation) < 0 ? -u : u;
  return {unit_rotation(one.rotation * v + other.rotation * turn), place_between(a, b, u)};
}

RigidMotion motion_of(const RigidStep& step) {
  RigidMotion out = stored_rigid(step.rotation, step.translation);
  out.rotation = unit_rotation(out.rotation);
  return out;
}

// From one place on the line to another.
RigidMotion motion_between(const ClipMotion& motion, const Playback& before, const Playback& after) {
  const LineStep line = line_step(before, after, motion.duration_s);
  // On its way back, ping_pong takes back what it went.
  const std::int64_t rounds = before.mode == PlayMode::loop ? line.to.round - line.from.round : 0;
  const RigidMotion from = root_at(motion.root, line.from.time_s), to = root_at(motion.root, line.to.time_s);
  if (rounds == 0 && !turns(from) && !turns(to)) return {{}, to.translation - from.translation};
  RigidMotion moved = inverse(from);
  if (rounds != 0) moved = moved * power(root_at(motion.root, static_cast<double>(motion.duration_s)), rounds);
  return moved * to;
}

// Rounded to floats; false if it is not finite.
bool rounded(const RigidMotion& m, RigidStep& out) {
  const Quaternion<double> q = m.rotation * (m.rotation.w < 0 ? -1.0 : 1.0);
  out = {
      {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), static_cast<float>(q.w)},
      {static_cast<float>(m.translation.x), static_cast<float>(m.translation.y), static_cast<float>(m.translation.z)}};
  return all_finite(out.rotation, 4) && all_finite(out.translation, 3);
}

// In little code, as it is called twice.
[[gnu::noinline]] void add(Screw& sum, const Screw& screw, double weight) {
  sum.turn = sum.turn + screw.turn * weight;
  sum.way = sum.way + screw.way * weight;
}

}  // namespace

Status sample_root(const ClipMotion& motion, float time_s, RigidStep& out) {
  MARROW_REQUIRE(holds(motion.root));
  MARROW_REQUIRE(is_number(time_s));
  RigidStep at;
  const bool finite = rounded(root_at(motion.root, static_cast<double>(time_s)), at);
  MARROW_REQUIRE(finite && "keys that are finite");
  out = at;
  return Status::ok;
}

Status root_step(const ClipMotion& motion, const Playback& before, const Playback& after, RigidStep& out) {
  MARROW_REQUIRE(holds(motion.root));
  MARROW_REQUIRE_GOOD(check_step(motion, before, after));
  RigidStep step;
  const bool finite = rounded(motion_between(motion, before, after), step);
  MARROW_REQUIRE(finite && "keys that are finite");
  out = step;
  return Status::ok;
}

bool root_screw(const ClipMotion& motion, const Playback& before, const Playback& after, Screw& out) {
  if (check_step(motion, before, after)) return false;
  const RigidMotion moved = motion_between(motion, before, after);
  out = turns(moved) ? screw_of(moved) : Screw{{}, moved.translation};
  RigidStep unused;
  return rounded({{}, out.way}, unused);
}

bool rounded_step(const RigidMotion& motion, RigidStep& out) {
  return rounded(motion, out);
}

Status blend_root_steps(Span<const RigidStep> steps, Span<const float> weights, RigidStep& out) {
  MARROW_REQUIRE(holds(steps));
  MARROW_REQUIRE(holds(weights, steps.size));
  MARROW_REQUIRE(all_within(weights.data, steps.size, 0, kMostStepWeight));
  Screw sum;
  double whole = 0;
  for (std::size_t i = 0; i < steps.size; ++i) {
    const double weight = static_cast<double>(weights[i]);
    if (weight == 0) continue;
    const Screw screw = screw_of(motion_of(steps[i]));
    add(sum, screw, weight);
    whole += weight;
  }
  Screw mean;
  if (whole > 0) add(mean, sum, 1.0 / whole);
  RigidStep step;
  const bool finite = rounded(motion_of(mean), step);
  MARROW_REQUIRE(finite && "steps that are finite");
  out = step;
  return Status::ok;
}

RootPlace move_root(const RootPlace& place, const RigidStep& step) {
  const double *const q = place.rotation, *const p = place.translation;
  const RigidMotion moved = RigidMotion{{q[0], q[1], q[2], q[3]}, {p[0], p[1], p[2]}} * motion_of(step);
  const Quaternion<double>& r = moved.rotation;
  return {{r.x, r.y, r.z, r.w}, {moved.translation.x, moved.translation.y, moved.translation.z}};
}

Affine world_from_model(const RootPlace& place) {
  const double* const q = place.rotation;
  const Quaternion<double> rotation = unit_rotation({q[0], q[1], q[2], q[3]});
  Affine out;
  for (int column = 0; column < 3; ++column) {
    const double is_x = column == 0 ? 1 : 0, is_y = column == 1 ? 1 : 0, is_z = column == 2 ? 1 : 0;
    const Vector<double> axis = turned(rotation, {is_x, is_y, is_z});
    out.rows[0][column] = static_cast<float>(axis.x);
    out.rows[1][column] = static_cast<float>(axis.y);
    out.rows[2][column] = static_cast<float>(axis.z);
    out.rows[column][3] = static_cast<float>(place.translation[column]);
  }
  return out;
}

Affine move_root(const Affine& world_from_model, const RigidStep& step) {
  const RigidMotion moved = motion_of(step);
  const Quaternion<double> back = conjugate(moved.rotation);
  Affine out;
  for (int row = 0; row < 3; ++row) {
    const float* const from = world_from_model.rows[row];
    const Vector<double> axes = vector_of_doubles(from), turned_axes = turned(back, axes);
    out.rows[row][0] = static_cast<float>(turned_axes.x);
    out.rows[row][1] = static_cast<float>(turned_axes.y);
    out.rows[row][2] = static_cast<float>(turned_axes.z);
    out.rows[row][3] = static_cast<float>(dot(axes, moved.translation) + static_cast<double>(from[3]));
  }
  return out;
}

}  // namespace marrow
