// What place_feet() keeps of a foot in FootMotion::state.
#pragma once

#include <type_traits>

#include "marrow/feet.h"

namespace marrow {

// All in world space. Zeros: the motion has not begun.
struct FootState {
  float offset[3], offset_speed[3];    // from the sole's target to the sole
  float lean[3], lean_speed[3];        // what is added to the ground's normal to give the foot's
  float point[3], normal[3];           // the ground in the last frame
  float heading[3];                    // level direction of the ankle's axis `axis` at the time of planting
  float turn[4];                       // about up, from the animated to the planted heading
  float turn_share, turn_share_speed;  // how much of `turn` is left
  std::uint8_t axis;                   // of heading
  std::uint8_t planted;                // 1: it was planted in the last frame
  std::uint8_t begun;                  // 1: the motion has begun
  std::uint8_t hit;                    // 1: in the last frame its ray hit ground
};
static_assert(sizeof(FootState) == sizeof(FootMotion::state) && alignof(FootState) == 4);
static_assert(std::is_trivially_copyable_v<FootState>);

inline FootState& state_of(FootMotion& motion) {
  return *reinterpret_cast<FootState*>(motion.state);
}
inline const FootState& state_of(const FootMotion& motion) {
  return *reinterpret_cast<const FootState*>(motion.state);
}

}  // namespace marrow
