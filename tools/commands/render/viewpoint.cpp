#include "commands/render/viewpoint.h"

#include <cmath>

#include "common/failure.h"
#include "cook/options/read_value.h"
#include "text/printable.h"

namespace marrow::tools {
namespace {

constexpr float kQuarterTurn = 1.5707963f;
constexpr float kFromAbove = 1.57f;  // all but upright, so that the picture has an up
constexpr std::size_t kMostNames = 40;

Orbit direction_of(Side side) {
  Orbit out;
  if (side == Side::three_quarter) return out;
  out.pitch = side == Side::top ? kFromAbove : 0;
  out.yaw = side == Side::left    ? kQuarterTurn
            : side == Side::right ? -kQuarterTurn
            : side == Side::back  ? 2 * kQuarterTurn
                                  : 0;
  return out;
}

Viewpoint::Joint joint_called(const std::string& path, const File& file, const std::string& name) {
  std::string names;
  std::size_t count = 0;
  for (std::uint32_t s = 0; s < file.skeleton_count(); ++s) {
    const Skeleton skeleton = file.skeleton(s);
    for (std::uint32_t j = 0; j < skeleton.joint_count; ++j) {
      const std::string known = file.text(skeleton.names[j]);
      if (known == name) return {s, j};
      if (++count <= kMostNames) names += (names.empty() ? "\"" : ", \"") + printable(known) + '"';
    }
  }
  if (count > kMostNames)
    names += " and " + std::to_string(count - kMostNames) + " more, which `marrow info --json` lists";
  throw Failure(Exit::usage, path, "", "no joint \"" + name + "\"",
                names.empty() ? "the file has no joints" : "there are " + names);
}

float read_distance(const std::string& text) {
  cook::Amount amount;
  const bool plain = !text.empty() && text.back() >= '0' && text.back() <= '9';
  const bool read = cook::read_amount(plain ? text + 'm' : text, amount);
  if (!read || amount.is_share || !std::isfinite(static_cast<float>(amount.value)))
    throw Failure(Exit::usage, "--distance", "", "\"" + text + "\" is no distance", "give metres, or a length as 50cm");
  return static_cast<float>(amount.value);
}

}  // namespace

Viewpoint make_viewpoint(const std::string& path, const File& file, const ViewpointArguments& arguments) {
  Viewpoint out;
  out.direction = direction_of(arguments.side);
  if (!arguments.look_at.empty()) out.joint = joint_called(path, file, arguments.look_at);
  if (!arguments.distance.empty()) out.distance = read_distance(arguments.distance);
  return out;
}

float light_turn_rad(const Orbit& direction) {
  return direction.yaw - Orbit().yaw;
}

}  // namespace marrow::tools
