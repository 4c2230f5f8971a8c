#include "commands/view/overlay/way.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::tools {
namespace {

constexpr glm::vec3 kWay{0.26f, 0.78f, 0.26f};
constexpr float kWayWidth = 0.018f;   // radii
constexpr float kWayStrength = 0.8f;  // of what is new
constexpr float kPiece = 0.04f;       // radii, at least: of one straight piece

// As a ribbon, which has a width on any screen, and lies under what stands on it.
void add_ribbon(const Rehearsal& rehearsal, const Shot& shot, Strokes& strokes) {
  const double now_s = rehearsal.time_s();
  const float half = 0.5f * kWayWidth * shot.radius;
  std::vector<std::pair<glm::vec3, double>> points;
  for (const Rehearsal::Place& place : rehearsal.way()) {
    if (place.at_s > now_s) break;
    const glm::vec3 at(place.at.x, shot.ground_height, place.at.z);
    if (points.size() < 2 || glm::length(at - points[points.size() - 2].first) > kPiece * shot.radius) {
      points.emplace_back(at, place.at_s);
    } else {
      points.back() = {at, place.at_s};
    }
  }
  const auto colour = [&](double at_s) {
    const auto age = static_cast<float>((now_s - at_s) / Rehearsal::kKept_s);
    return glm::vec4(kWay, kWayStrength * (1 - age) * (1 - age));
  };
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& [from, from_s] = points[i - 1];
    const auto& [to, to_s] = points[i];
    const float length = glm::length(to - from);
    if (!(length > 0)) continue;
    const glm::vec3 side = half / length * glm::vec3(to.z - from.z, 0, from.x - to.x);
    const Strokes::Corner a{from - side, colour(from_s)}, b{from + side, colour(from_s)}, c{to + side, colour(to_s)},
        d{to - side, colour(to_s)};
    strokes.face(a, b, c);
    strokes.face(a, c, d);
  }
}

}  // namespace

void add_way(const Rehearsal& rehearsal, const Shot& shot, Strokes& strokes) {
  add_squares(shot, {}, strokes);
  add_ribbon(rehearsal, shot, strokes);
  for (const Rehearsal::Print& print : rehearsal.prints()) {
    if (print.at_s > rehearsal.time_s()) break;
    add_print(print.print, rehearsal.time_s() - print.at_s, shot, strokes);
  }
}

}  // namespace marrow::tools
