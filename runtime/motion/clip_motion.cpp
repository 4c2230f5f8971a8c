#include "marrow/clip_motion.h"

#include "core/check.h"
#include "math/finite.h"
#include "motion/motion_rules.h"

namespace marrow {
namespace {

bool good_events(const ClipMotion& m) {
  float last = 0;
  for (const ClipEvent& e : m.events) {
    if (!within(e.time_s, last, m.duration_s) || !within(e.until_s, e.time_s, e.time_s + m.duration_s)) return false;
    if (!is_finite(e.number)) return false;
    last = e.time_s;
  }
  return true;
}

float squared_length(const float* v, int count) {
  float sum = 0;
  for (int i = 0; i < count; ++i) sum += v[i] * v[i];
  return sum;
}
bool is_unit(float squared) {
  return within(squared, 0.998f, 1.002f);
}

bool is_identity(const RootKey& k) {
  return squared_length(k.rotation, 3) == 0 && squared_length(k.translation, 3) == 0;
}

bool good_root(const ClipMotion& m) {
  if (m.root.empty()) return true;
  if (!is_identity(m.root[0])) return false;
  float last = -1;
  for (const RootKey& k : m.root) {
    if (!within(k.time_s, 0, m.duration_s) || !(last < k.time_s)) return false;
    if (!is_unit(squared_length(k.rotation, 4))) return false;
    if (!all_within(k.translation, 3, -kFarthestMotion, kFarthestMotion)) return false;
    last = k.time_s;
  }
  return true;
}

}  // namespace

bool is_valid(const ClipMotion& m) {
  if (!within(m.duration_s, 0, kFarthestMotion) || !within(m.speed_m_s, 0, kFarthestMotion)) return false;
  const float squared = squared_length(m.heading, 3);
  if (!is_unit(squared) && squared != 0) return false;
  return holds(m.events) && holds(m.root) && good_events(m) && !check_marks(m) && good_root(m);
}

}  // namespace marrow
