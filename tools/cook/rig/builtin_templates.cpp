#include "cook/rig/read_template.h"

namespace marrow::cook {
namespace {

// Of a grown person 1 high, arms between T and A.
constexpr std::string_view kHumanoid = R"(
[[joint]]
name = "Hips"
place = [0, 0.52, 0]

[[joint]]
name = "Spine"
parent = "Hips"
place = [0, 0.57, 0]

[[joint]]
name = "Spine1"
parent = "Spine"
place = [0, 0.64, 0]

[[joint]]
name = "Spine2"
parent = "Spine1"
place = [0, 0.71, 0]

[[joint]]
name = "Neck"
parent = "Spine2"
place = [0, 0.81, 0]

[[joint]]
name = "Head"
parent = "Neck"
place = [0, 0.87, 0]
end = [0, 1, 0]

[[joint]]
name = "LeftShoulder"
mirror = "RightShoulder"
parent = "Spine2"
place = [0.025, 0.79, 0]

[[joint]]
name = "LeftArm"
mirror = "RightArm"
parent = "LeftShoulder"
place = [0.085, 0.79, 0]

[[joint]]
name = "LeftForeArm"
mirror = "RightForeArm"
parent = "LeftArm"
place = [0.212, 0.744, 0]

[[joint]]
name = "LeftHand"
mirror = "RightHand"
parent = "LeftForeArm"
place = [0.328, 0.702, 0]
end = [0.432, 0.664, 0]

[[joint]]
name = "LeftUpLeg"
mirror = "RightUpLeg"
parent = "Hips"
place = [0.055, 0.51, 0]

[[joint]]
name = "LeftLeg"
mirror = "RightLeg"
parent = "LeftUpLeg"
place = [0.06, 0.285, 0.01]

[[joint]]
name = "LeftFoot"
mirror = "RightFoot"
parent = "LeftLeg"
place = [0.065, 0.055, -0.02]

[[joint]]
name = "LeftToeBase"
mirror = "RightToeBase"
parent = "LeftFoot"
place = [0.07, 0.012, 0.05]
end = [0.075, 0.01, 0.10]
)";

// About a fox: head to the front, tail to the back.
constexpr std::string_view kQuadruped = R"(
[[joint]]
name = "Hips"
place = [0, 0.66, -0.36]

[[joint]]
name = "Spine"
parent = "Hips"
place = [0, 0.68, -0.22]

[[joint]]
name = "Spine1"
parent = "Spine"
place = [0, 0.68, 0]

[[joint]]
name = "Spine2"
parent = "Spine1"
place = [0, 0.66, 0.22]

[[joint]]
name = "Neck"
parent = "Spine2"
place = [0, 0.70, 0.34]

[[joint]]
name = "Head"
parent = "Neck"
place = [0, 0.78, 0.47]
end = [0, 0.70, 0.82]

[[joint]]
name = "LeftArm"
mirror = "RightArm"
parent = "Spine2"
place = [0.07, 0.62, 0.23]

[[joint]]
name = "LeftForeArm"
mirror = "RightForeArm"
parent = "LeftArm"
place = [0.09, 0.33, 0.21]

[[joint]]
name = "LeftHand"
mirror = "RightHand"
parent = "LeftForeArm"
place = [0.09, 0.08, 0.22]
end = [0.09, 0.02, 0.27]

[[joint]]
name = "LeftUpLeg"
mirror = "RightUpLeg"
parent = "Hips"
place = [0.07, 0.64, -0.37]

[[joint]]
name = "LeftLeg"
mirror = "RightLeg"
parent = "LeftUpLeg"
place = [0.09, 0.40, -0.34]

[[joint]]
name = "LeftFoot"
mirror = "RightFoot"
parent = "LeftLeg"
place = [0.09, 0.20, -0.47]

[[joint]]
name = "LeftToeBase"
mirror = "RightToeBase"
parent = "LeftFoot"
place = [0.09, 0.03, -0.42]
end = [0.09, 0.02, -0.36]

[[joint]]
name = "Tail"
parent = "Hips"
place = [0, 0.64, -0.50]

[[joint]]
name = "Tail1"
parent = "Tail"
place = [0, 0.53, -0.64]

[[joint]]
name = "Tail2"
parent = "Tail1"
place = [0, 0.42, -0.82]
end = [0, 0.34, -1.05]
)";

}  // namespace

std::string_view builtin_template(std::string_view name) {
  if (name == "humanoid") return kHumanoid;
  return name == "quadruped" ? kQuadruped : std::string_view();
}

}  // namespace marrow::cook
