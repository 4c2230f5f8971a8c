// VRM adds to a bone's end, in each step of 1/60 s, what is left of its last step and a pull, and shortens the sum to
// the bone's length. Small swings about where that rests are a linear recurrence of second order, whose roots are those
// of our spring's differential equation.
#include "cook/gltf/vrm/spring_settings.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/elementary.h"

namespace marrow::cook::gltf {
namespace {

constexpr double kStep_s = 1.0 / 60, kGravity = 9.81, kTwoPi = 6.28318530717958648;
constexpr double kHighestOmega = 15 * kTwoPi, kMostDamping = 1.5, kMostDrag = 50, kMostGravity = 10;
constexpr double kLeastPull = 1e-3;     // of VRM's forces: the limit of none
constexpr double kLeastInertia = 1e-3;  // of 1 - drag_force: its logarithm is taken

// Of a number above 0, by Halley's steps on the exponential.
double logarithm(double x) {
  double y = 0;
  for (int i = 0; i < 200; ++i) {
    const double e = tools::exponential(y), step = 2 * (x - e) / (x + e);
    y += step;
    if (std::fabs(step) < 1e-15) break;
  }
  return y;
}

// y'' + damping y' + omega² y = 0, in 1/s.
struct Swing {
  double omega = 0, damping = 0;
  double slow_rate = 0;  // of the slower of two decays; 0: it swings
};

// Of y[n+1] = shrink ((1 + inertia) y[n] - inertia y[n-1]).
Swing swing_of(double shrink, double inertia) {
  const double sum = shrink * (1 + inertia), product = shrink * inertia, discriminant = sum * sum - 4 * product;
  Swing out;
  out.damping = -logarithm(product) / kStep_s;
  if (discriminant < 0) {
    const double angle = tools::angle_of(std::sqrt(-discriminant), sum), decay = out.damping / 2 * kStep_s;
    out.omega = std::sqrt(angle * angle + decay * decay) / kStep_s;
  } else {
    const double larger = (sum + std::sqrt(discriminant)) / 2;
    out.slow_rate = std::max(-logarithm(larger) / kStep_s, 0.0);
    out.omega = std::sqrt(out.slow_rate * std::max(out.damping - out.slow_rate, 0.0));
  }
  return out;
}

}  // namespace

SpringJoint spring_settings(const VrmSpring& vrm, double bone_m, const glm::dvec3& direction) {
  const double stiffness = std::clamp(vrm.stiffness, 0.0, 1e6), weight = std::clamp(vrm.gravity_power, 0.0, 1e6);
  const double drag = std::clamp(vrm.drag_force, 0.0, 1.0);
  const double down = -vrm.gravity_direction.y;
  // All that pulls where the bone rests; where stiffness and gravity cancel, they do not elsewhere.
  const glm::dvec3 both = stiffness * direction + weight * glm::dvec3(0, -down, 0);
  const double pull = std::max({glm::length(both), std::max(stiffness, weight) / 2, kLeastPull});
  Swing swing = swing_of(bone_m / (bone_m + pull * kStep_s), std::max(1 - drag, kLeastInertia));
  // Of the pull, the stiffness's share turns with the animation; so does as much damping as our range has.
  const double share = std::sqrt(std::min(stiffness / pull, 1.0));
  const double with_animation = 2 * kMostDamping * swing.omega * share;
  const double against_air = swing.omega * swing.omega * bone_m / pull * drag;
  const double air = std::min(std::max(against_air, swing.damping - with_animation), kMostDrag);
  if (swing.slow_rate > 0 && swing.damping - air > with_animation) {  // beyond our settings: the slow decay is kept
    const double r = swing.slow_rate, b = kMostDamping * share * r;
    swing.omega = b + std::sqrt(b * b + r * std::max(air - r, 0.0));
  }
  const double omega = std::min(swing.omega * share, kHighestOmega);
  const double weight_mps2 = swing.omega * swing.omega * bone_m / pull * weight * down;
  SpringJoint out;
  out.frequency_hz = std::min(static_cast<float>(omega / kTwoPi), 15.0f);
  out.damping_ratio =
      omega > 0 ? static_cast<float>(std::clamp((swing.damping - air) / (2 * omega), 0.0, kMostDamping)) : 0.0f;
  out.gravity = static_cast<float>(std::clamp(weight_mps2 / kGravity, -kMostGravity, kMostGravity));
  out.drag = static_cast<float>(air);
  out.radius_m = static_cast<float>(std::clamp(vrm.hit_radius, 0.0, 1e6));
  return out;
}

}  // namespace marrow::cook::gltf
