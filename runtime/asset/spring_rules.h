// What numbers a spring's joint and a collider may have: in files and in calls.
#pragma once

#include "marrow/file.h"
#include "math/finite.h"

namespace marrow {

inline constexpr float kFarthestSpringPoint_m = 1e6f;

inline bool good_point(const float (&v)[3]) {
  return all_within(v, 3, -kFarthestSpringPoint_m, kFarthestSpringPoint_m);
}

struct SpringSetting {
  float SpringJoint::*number;
  float least, most;
};
inline constexpr SpringSetting kSpringSettings[] = {
    {&SpringJoint::frequency_hz, 0.0f, 15.0f},
    {&SpringJoint::damping_ratio, 0.0f, 1.5f},
    {&SpringJoint::gravity, -10.0f, 10.0f},
    {&SpringJoint::drag, 0.0f, 50.0f},
    {&SpringJoint::radius_m, 0.0f, kFarthestSpringPoint_m},
    {&SpringJoint::weight, 0.0f, 1.0f},
};

inline bool good_settings(const SpringJoint& j) {
  for (const SpringSetting& s : kSpringSettings)
    if (!within(j.*s.number, s.least, s.most)) return false;
  return true;
}

inline bool good_collider(const SpringCollider& c) {
  return good_point(c.from) && good_point(c.to) && within(c.radius_m, 0.0f, kFarthestSpringPoint_m);
}

inline bool has_tip(const SpringChain& chain) {
  return chain.tip[0] != 0.0f || chain.tip[1] != 0.0f || chain.tip[2] != 0.0f;
}

}  // namespace marrow
