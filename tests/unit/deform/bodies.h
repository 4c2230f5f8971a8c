// Bodies of capsules, whose joints are known because the capsules are laid along them.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace marrow::test {

struct Body {
  std::vector<glm::dvec3> positions;
  std::vector<std::uint32_t> indices;
  std::map<std::string, glm::dvec3> joints;
};

// A closed surface at a distance from a segment.
inline void add_capsule(const glm::dvec3& from, const glm::dvec3& to, double radius, Body& body) {
  constexpr int kAround = 16, kCap = 5;
  const glm::dvec3 axis = glm::normalize(to - from);
  const glm::dvec3 u =
      glm::normalize(glm::cross(axis, std::abs(axis.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 v = glm::cross(axis, u);
  const auto first = static_cast<std::uint32_t>(body.positions.size());
  constexpr int kRings = 2 * kCap;
  for (int ring = 0; ring < kRings; ++ring) {
    const bool lower = ring < kCap;
    const double latitude = std::numbers::pi / 2 * (lower ? ring - kCap + 1 : ring - kCap) / (kCap - 0.5);
    const glm::dvec3 centre = (lower ? from : to) + axis * (radius * std::sin(latitude));
    for (int i = 0; i < kAround; ++i) {
      const double turn = 2 * std::numbers::pi * i / kAround;
      body.positions.push_back(centre + (u * std::cos(turn) + v * std::sin(turn)) * (radius * std::cos(latitude)));
    }
  }
  body.positions.push_back(from - axis * radius);
  body.positions.push_back(to + axis * radius);
  const std::uint32_t bottom = first + kRings * kAround, top = bottom + 1;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t j = (i + 1) % kAround, last = first + (kRings - 1) * kAround;
    body.indices.insert(body.indices.end(), {bottom, first + j, first + i, top, last + i, last + j});
    for (std::uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      const std::uint32_t a = first + ring * kAround + i, b = first + ring * kAround + j;
      body.indices.insert(body.indices.end(), {a, b, b + kAround, a, b + kAround, a + kAround});
    }
  }
}

// A chain of capsules; names of its places, those without one are no joints; mirrored as well where x is not 0.
struct Place {
  std::string name;
  glm::dvec3 at;
};
inline void add_chain(const std::vector<Place>& places, double radius, Body& body) {
  const auto mirrored = [](const glm::dvec3& p) { return glm::dvec3(-p.x, p.y, p.z); };
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto& [name, at] = places[i];
    if (!name.empty()) body.joints[name] = at;
    if (name.rfind("Left", 0) == 0) body.joints["Right" + name.substr(4)] = mirrored(at);
    if (i == 0) continue;
    add_capsule(places[i - 1].at, at, radius, body);
    if (at.x != 0) add_capsule(mirrored(places[i - 1].at), mirrored(at), radius, body);
  }
}

// 2 high, its legs longer and its arms lower than the template's.
inline Body humanoid_body() {
  Body body;
  add_chain({{"Hips", {0, 1.08, 0}}, {"", {0, 1.40, 0}}}, 0.16, body);
  add_chain({{"", {0, 1.40, 0}}, {"Neck", {0, 1.62, 0}}, {"Head", {0, 1.74, 0}}}, 0.07, body);
  add_chain({{"", {0, 1.79, 0}}, {"", {0, 1.88, 0}}}, 0.12, body);
  add_chain({{"", {0.05, 1.52, 0}},
             {"LeftArm", {0.2, 1.52, 0}},
             {"LeftForeArm", {0.42, 1.34, 0}},
             {"LeftHand", {0.62, 1.18, 0}},
             {"", {0.76, 1.06, 0}}},
            0.05, body);
  add_chain({{"", {0.06, 1.06, 0}},
             {"LeftUpLeg", {0.12, 1.0, 0}},
             {"LeftLeg", {0.14, 0.55, 0}},
             {"LeftFoot", {0.15, 0.1, 0}}},
            0.075, body);
  add_chain({{"", {0.15, 0.08, 0}}, {"LeftToeBase", {0.15, 0.05, 0.13}}, {"", {0.15, 0.05, 0.2}}}, 0.05, body);
  return body;
}

// 1 high, 2 long.
inline Body quadruped_body() {
  Body body;
  add_chain({{"Hips", {0, 0.62, -0.4}}, {"", {0, 0.62, 0.3}}}, 0.13, body);
  add_chain({{"", {0, 0.64, 0.3}}, {"Neck", {0, 0.72, 0.42}}, {"Head", {0, 0.86, 0.58}}}, 0.08, body);
  add_chain({{"", {0, 0.88, 0.6}}, {"", {0, 0.84, 0.85}}}, 0.09, body);
  add_chain({{"", {0.03, 0.62, 0.28}},
             {"LeftArm", {0.1, 0.56, 0.28}},
             {"LeftForeArm", {0.11, 0.32, 0.28}},
             {"LeftHand", {0.11, 0.08, 0.28}},
             {"", {0.11, 0.04, 0.33}}},
            0.045, body);
  add_chain({{"", {0.03, 0.62, -0.4}},
             {"LeftUpLeg", {0.1, 0.56, -0.4}},
             {"LeftLeg", {0.11, 0.36, -0.36}},
             {"LeftFoot", {0.11, 0.18, -0.46}},
             {"LeftToeBase", {0.11, 0.05, -0.42}},
             {"", {0.11, 0.04, -0.37}}},
            0.045, body);
  add_chain({{"", {0, 0.64, -0.5}}, {"", {0, 0.5, -0.75}}, {"", {0, 0.38, -1.1}}}, 0.04, body);
  return body;
}

}  // namespace marrow::test
