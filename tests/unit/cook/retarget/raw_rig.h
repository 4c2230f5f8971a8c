// Skeletons made by hand, as scenes of nodes, and where their joints are: composed here, in double precision.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "cook/scene/raw.h"

namespace marrow::cook {

struct RawRigBone {
  std::string name;
  int parent;
  glm::dvec3 place;  // in the scene at rest
};

// Some rotation, another for each number.
inline glm::dquat some_turn(double number) {
  return glm::normalize(
      glm::dquat(std::cos(number), std::sin(2 * number), std::cos(3 * number + 1), std::sin(5 * number)));
}

// Bones at their places, turned as some_turn() has it, below a node that stands somewhere, turned and scaled. Node 0 is
// that; bone i is node i + 1, and of one skin.
inline RawScene raw_rig(const std::vector<RawRigBone>& bones, double seed) {
  RawScene out;
  out.source = "rig" + std::to_string(static_cast<int>(seed)) + ".glb";
  RawNode& top = out.nodes.emplace_back();
  top.name = "top";
  top.translation = {0.3 * seed, 0.1, -0.2};
  top.rotation = some_turn(seed);
  top.scale = glm::dvec3(0.5 + 0.1 * seed);
  RawSkin& skin = out.skins.emplace_back();
  std::vector<glm::dmat4> scene_from = {glm::translate(glm::dmat4(1.0), top.translation) *
                                        glm::mat4_cast(top.rotation) * glm::scale(glm::dmat4(1.0), top.scale)};
  std::vector<glm::dquat> turns = {top.rotation};
  for (std::size_t b = 0; b < bones.size(); ++b) {
    const auto up = static_cast<std::size_t>(bones[b].parent + 1);
    RawNode& node = out.nodes.emplace_back();
    node.name = bones[b].name;
    node.parent = bones[b].parent + 1;
    node.translation = glm::dvec3(glm::inverse(scene_from[up]) * glm::dvec4(bones[b].place, 1));
    turns.push_back(some_turn(seed + 0.7 * static_cast<double>(b)));
    node.rotation = glm::conjugate(turns[up]) * turns.back();
    scene_from.push_back(scene_from[up] * glm::translate(glm::dmat4(1.0), node.translation) *
                         glm::mat4_cast(node.rotation));
    skin.joints.push_back(static_cast<int>(b) + 1);
  }
  skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
  return out;
}

// What a clip's key of this number says of the scene's nodes: rotations and places in the scene.
struct RawPose {
  std::vector<glm::dquat> turns;
  std::vector<glm::dvec3> places;
};
inline RawPose raw_pose(const RawScene& scene, const RawClip* clip, std::size_t key) {
  RawPose out;
  std::vector<glm::dmat4> all;
  for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
    const RawNode& node = scene.nodes[n];
    glm::dquat turn = node.rotation;
    glm::dvec3 place = node.translation;
    if (clip != nullptr)
      for (const RawChannel& channel : clip->channels) {
        if (channel.node != static_cast<int>(n)) continue;
        const glm::dvec4 value(channel.values[key]);
        if (channel.path == RawPath::rotation) turn = glm::normalize(glm::dquat(value.w, value.x, value.y, value.z));
        if (channel.path == RawPath::translation) place = glm::dvec3(value);
      }
    const glm::dmat4 local =
        glm::translate(glm::dmat4(1.0), place) * glm::mat4_cast(turn) * glm::scale(glm::dmat4(1.0), node.scale);
    const bool is_root = node.parent < 0;
    all.push_back(is_root ? local : all[static_cast<std::size_t>(node.parent)] * local);
    out.turns.push_back(is_root ? turn : out.turns[static_cast<std::size_t>(node.parent)] * turn);
    out.places.emplace_back(all.back()[3]);
  }
  return out;
}

// The angle between two rotations, in radians.
inline double angle_between(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat off = glm::conjugate(a) * b;
  return 2 * std::atan2(std::sqrt(off.x * off.x + off.y * off.y + off.z * off.z), std::abs(off.w));
}

}  // namespace marrow::cook
