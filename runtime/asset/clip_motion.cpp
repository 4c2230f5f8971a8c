#include "marrow/clip_motion.h"

#include "asset/motion_fault.h"
#include "core/check.h"
#include "math/finite.h"

namespace marrow {
namespace {

float squared_length(const float* v, int count) {
  float sum = 0;
  for (int i = 0; i < count; ++i) sum += v[i] * v[i];
  return sum;
}
bool is_unit(float squared) {
  return within(squared, 0.998f, 1.002f);
}

MotionFault fault_of_events(const ClipMotion& m) {
  float last = 0;
  for (const ClipEvent& e : m.events) {
    if (!within(e.time_s, last, m.duration_s)) return {&e, "events ascend in their clip"};
    if (!within(e.until_s, e.time_s, e.time_s + m.duration_s)) return {&e, "an event is no longer than its clip"};
    if (!is_finite(e.number)) return {&e, "an event's number is finite"};
    last = e.time_s;
  }
  return {};
}

bool is_identity(const RootKey& k) {
  return squared_length(k.rotation, 3) == 0 && squared_length(k.translation, 3) == 0;
}

MotionFault fault_of_root(const ClipMotion& m) {
  float last = -1;
  for (const RootKey& k : m.root) {
    if (!within(k.time_s, 0, m.duration_s) || !(last < k.time_s)) return {&k, "keys of a root ascend in their clip"};
    if (!is_unit(squared_length(k.rotation, 4))) return {&k, "a rotation that is no unit quaternion"};
    if (!all_within(k.translation, 3, -kFarthestMotion, kFarthestMotion)) return {&k, "a root beyond 1e12"};
    if (last < 0 && !is_identity(k)) return {&k, "a root begins at the identity"};
    last = k.time_s;
  }
  return {};
}

}  // namespace

MotionFault find_fault_of_marks(const ClipMotion& m) {
  if (m.phase_marks.size > kMaxMarks) return {nullptr, "at most 64 phase marks"};
  bool goes_on_at_start = false;
  for (const float* mark = m.phase_marks.begin(); mark != m.phase_marks.end(); ++mark) {
    const float last = mark != m.phase_marks.begin() ? mark[-1] : -1.0f;
    const float end = goes_on_at_start ? m.phase_marks[0] : m.duration_s;
    if (!(0 <= *mark && *mark < end)) return {mark, "phase marks go once round their clip"};
    if (last < *mark) continue;
    if (goes_on_at_start || !(*mark < m.phase_marks[0])) return {mark, "phase marks go once round their clip"};
    goes_on_at_start = true;
  }
  return {};
}

MotionFault find_fault(const ClipMotion& m) {
  if (!within(m.duration_s, 0, kFarthestMotion)) return {nullptr, "a duration is finite, and not negative"};
  if (!within(m.speed_m_s, 0, kFarthestMotion)) return {nullptr, "a speed is finite, and not negative"};
  const float squared = squared_length(m.heading, 3);
  if (!is_unit(squared) && squared != 0) return {nullptr, "a heading is of length 1, or 0"};
  if (const MotionFault fault = fault_of_events(m); fault.rule != nullptr) return fault;
  if (const MotionFault fault = find_fault_of_marks(m); fault.rule != nullptr) return fault;
  return fault_of_root(m);
}

bool is_valid(const ClipMotion& m) {
  return holds(m.events) && holds(m.phase_marks) && holds(m.root) && find_fault(m).rule == nullptr;
}

}  // namespace marrow
