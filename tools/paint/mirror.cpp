#include "paint/mirror.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>

#include "deform/weights/places.h"

namespace marrow::tools {
namespace {

template <class T>
glm::vec<3, T> mirrored(glm::vec<3, T> place, const MirrorPlane& plane) {
  place[plane.axis] = 2 * static_cast<T>(plane.at) - place[plane.axis];
  return place;
}

bool ends_word(const std::string& name, std::size_t at) {
  return at >= name.size() || std::isalnum(static_cast<unsigned char>(name[at])) == 0;
}

// Whether the letter at `at` stands for itself: "arm.L", "l_arm".
bool stands_alone(const std::string& name, std::size_t at) {
  return (at == 0 || ends_word(name, at - 1)) && ends_word(name, at + 1) && name.size() > 1;
}

}  // namespace

std::vector<std::uint32_t> mirrored_places(const Canvas& canvas, const MirrorPlane& plane, double within) {
  std::vector<std::uint32_t> out(canvas.model.size(), kNoPlace);
  std::vector<std::vector<std::uint32_t>> of_skeleton;
  for (std::uint32_t p = 0; p < out.size(); ++p) {
    const std::uint32_t skeleton = canvas.groups[canvas.group_of[p]].skeleton;
    if (skeleton >= of_skeleton.size()) of_skeleton.resize(skeleton + 1);
    of_skeleton[skeleton].push_back(p);
  }
  for (const std::vector<std::uint32_t>& places : of_skeleton) {
    deform::Positions positions;
    for (const std::uint32_t p : places) positions.push_back(canvas.model[p]);
    const deform::PlaceTree tree(positions);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto found = tree.nearest(mirrored(positions[i], plane), within);
      if (found) out[places[i]] = places[found->index];
    }
  }
  return out;
}

std::string mirrored_name(const std::string& name) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"Left", "Right"}, {"left", "right"}, {"LEFT", "RIGHT"}};
  for (const auto& [left, right] : kWords) {
    for (const auto& [from, to] : {std::pair(left, right), std::pair(right, left)}) {
      const std::size_t at = name.find(from);
      if (at != std::string::npos) return std::string(name).replace(at, from.size(), to);
    }
  }
  constexpr std::string_view kLetters = "LRlr", kOthers = "RLrl";
  for (std::size_t at = name.size(); at-- > 0;) {
    const std::size_t which = kLetters.find(name[at]);
    if (which == std::string_view::npos || !stands_alone(name, at)) continue;
    std::string out = name;
    out[at] = kOthers[which];
    return out;
  }
  return name;
}

std::uint32_t mirrored_joint(std::span<const std::string> names, std::span<const glm::vec3> places, std::uint32_t joint,
                             const MirrorPlane& plane, double within) {
  const std::string other = mirrored_name(names[joint]);
  const auto named = std::ranges::find(names, other);
  if (other != names[joint] && named != names.end()) return static_cast<std::uint32_t>(named - names.begin());
  const glm::vec3 image = mirrored(places[joint], plane);
  // What is on the plane is its own image.
  if (static_cast<double>(glm::distance(image, places[joint])) <= within) return joint;
  std::uint32_t out = joint;
  double least = within;
  for (std::uint32_t j = 0; j < places.size(); ++j) {
    const auto distance = static_cast<double>(glm::distance(places[j], image));
    if (distance >= least) continue;
    least = distance;
    out = j;
  }
  return out;
}

}  // namespace marrow::tools
