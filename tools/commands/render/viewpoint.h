// From where `marrow render` looks: a side, or a joint and how far away it is.
#pragma once

#include <optional>
#include <string>

#include "marrow/file.h"
#include "render/camera.h"
#include "text/choices.h"

namespace marrow::tools {

// Of a character that faces +Z, as glTF has it; left and right are its own.
enum class Side { three_quarter, front, back, left, right, top };
inline constexpr Named<Side> kSides[] = {{"three-quarter", Side::three_quarter},
                                         {"front", Side::front},
                                         {"back", Side::back},
                                         {"left", Side::left},
                                         {"right", Side::right},
                                         {"top", Side::top}};

struct ViewpointArguments {
  Side side = Side::three_quarter;
  std::string look_at;   // a joint by name; empty: the whole character
  std::string distance;  // "0.5" or "50cm"; empty: half of the character's size
};

// Of one file, found once.
struct Viewpoint {
  Orbit direction;  // its yaw and pitch alone
  struct Joint {
    std::uint32_t skeleton = 0, joint = 0;
  };
  std::optional<Joint> joint;
  std::optional<float> distance;
};

// Throws Failure (usage): there is no such joint, or the distance is none.
Viewpoint make_viewpoint(const std::string& path, const File& file, const ViewpointArguments& arguments);

// How far the lights walk round the character so that they stay where the camera is.
float light_turn_rad(const Orbit& direction);

}  // namespace marrow::tools
