// Motion capture of a body, and a rig of other proportions to put it onto: composed here, in double precision, by the
// file's channel order.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cook/bvh/read_bvh.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "support/double_math.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook::mocap {

using test::Map;
using test::Vec3;

inline constexpr int kFrames = 5;

struct Joint {
  std::string name;
  int parent;
  Vec3 offset;
  std::string channels;  // X, Y, Z: rotations; x, y, z: positions; in the order of the file
};

// Two legs and arms, upright, as a body in a T-pose; the unit is the centimetre.
inline const std::vector<Joint> kBody = {
    {"Hips", -1, {0, 90, 0}, "xyzZXY"},   {"LeftLeg", 0, {10, -5, 0}, "ZXY"},    {"LeftShin", 1, {0, -40, 1}, "YXZ"},
    {"LeftFoot", 2, {0, -40, -1}, "X"},   {"RightLeg", 0, {-10, -5, 0}, "XYZ"},  {"RightShin", 4, {0, -40, 1}, "ZYX"},
    {"RightFoot", 5, {0, -40, -1}, ""},   {"Chest", 0, {0, 30, 0}, "XZY"},       {"Head", 7, {0, 25, 2}, "YZX"},
    {"LeftArm", 7, {18, 20, 0}, "ZXY"},   {"LeftElbow", 9, {28, 0, 0}, "ZXY"},   {"LeftHand", 10, {25, 0, 0}, "zZyXxY"},
    {"RightArm", 7, {-18, 20, 0}, "ZXY"}, {"RightElbow", 12, {-28, 0, 0}, "YX"}, {"RightHand", 13, {-25, 0, 0}, "ZXY"}};

inline double number_of(int frame, std::size_t joint, std::size_t channel, char kind) {
  const double wave = std::sin(1.7 * frame + 0.9 * static_cast<double>(joint) + 2.1 * static_cast<double>(channel));
  if (kind >= 'X' && kind <= 'Z') return 70 * wave;
  // Hands have positions too, and keep them.
  if (joint != 0) return kBody[joint].offset[static_cast<std::size_t>(kind - 'x')];
  return (kind == 'y' ? 88 : 0) + 20 * wave * frame;
}

inline std::string text_of(const std::vector<Joint>& body,
                           const std::function<double(int, std::size_t, std::size_t, char)>& at) {
  std::string text = "HIERARCHY\n";
  const std::function<void(std::size_t)> add = [&](std::size_t j) {
    char line[200];
    const Joint& joint = body[j];
    std::snprintf(line, sizeof line, "%s %s\n{\nOFFSET %.17g %.17g %.17g\nCHANNELS %zu", j == 0 ? "ROOT" : "JOINT",
                  joint.name.c_str(), joint.offset[0], joint.offset[1], joint.offset[2], joint.channels.size());
    text += line;
    for (const char c : joint.channels)
      text +=
          std::string(" ") + (c >= 'x' ? static_cast<char>(c - 'x' + 'X') : c) + (c >= 'x' ? "position" : "rotation");
    text += '\n';
    for (std::size_t child = j + 1; child < body.size(); ++child)
      if (body[child].parent == static_cast<int>(j)) add(child);
    text += "}\n";
  };
  add(0);
  text += "MOTION\nFrames: " + std::to_string(kFrames) + "\nFrame Time: 0.1\n";
  for (int f = 0; f < kFrames; ++f) {
    for (std::size_t j = 0; j < body.size(); ++j)
      for (std::size_t c = 0; c < body[j].channels.size(); ++c) {
        char number[40];
        std::snprintf(number, sizeof number, "%.17g ", at(f, j, c, body[j].channels[c]));
        text += number;
      }
    text += '\n';
  }
  return text;
}

inline Map turn(char axis, double degrees) {
  const double c = std::cos(degrees / 57.29577951308232), s = std::sin(degrees / 57.29577951308232);
  if (axis == 'X') return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}}};
  if (axis == 'Y') return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}}};
  return {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}}};
}

using Motion = std::function<double(int frame, std::size_t joint, std::size_t channel, char kind)>;

// What the file says of a frame: each joint's map to the scene.
inline std::vector<Map> posed(const std::vector<Joint>& body, int frame, const Motion& motion = number_of) {
  std::vector<Map> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    Map place, turned;
    for (int axis = 0; axis < 3; ++axis) place.rows[axis][3] = body[j].offset[static_cast<std::size_t>(axis)];
    for (std::size_t c = 0; c < body[j].channels.size(); ++c) {
      const char kind = body[j].channels[c];
      const double number = motion(frame, j, c, kind);
      if (kind >= 'x') {
        place.rows[kind - 'x'][3] = number;
      } else {
        turned = turned * turn(kind, number);
      }
    }
    const Map local = place * turned;
    out.push_back(body[j].parent < 0 ? local : out[static_cast<std::size_t>(body[j].parent)] * local);
  }
  return out;
}

inline Vec3 place_of(const Map& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}

inline RawScene read_body(const std::vector<Joint>& body = kBody, const Motion& motion = number_of) {
  const std::string text = text_of(body, motion);
  return read_bvh("walk.bvh", std::as_bytes(std::span(text)));
}

inline CookOptions raw() {
  return options_of("--clip-codec raw");
}

// A clip of a skeleton at a time, joint by joint, in the scene.
inline std::vector<Map> played(const Skeleton& skeleton, const Clip& clip, float time_s) {
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> model(skeleton.joint_count);
  EXPECT_EQ(sample(skeleton, clip, time_s, local), Status::ok);
  EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
  std::vector<Map> out(model.size());
  for (std::size_t j = 0; j < model.size(); ++j)
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) out[j].rows[r][c] = static_cast<double>(model[j].rows[r][c]);
  return out;
}

// A body of other proportions and rest rotations, arms hanging aslant, in metres; `turned` is its armature's rotation.
struct Rig {
  struct Bone {
    std::string name;
    int parent;
    glm::dvec3 place;  // in the scene, at rest
  };
  std::vector<Bone> bones = {{"rig:hips", -1, {0, 1.1, 0.02}},
                             {"rig:left_leg", 0, {0.12, 1.05, 0}},
                             {"rig:left_shin", 1, {0.13, 0.6, 0.03}},
                             {"rig:left_foot", 2, {0.14, 0.1, 0}},
                             {"rig:right_leg", 0, {-0.12, 1.05, 0}},
                             {"rig:right_shin", 4, {-0.13, 0.6, 0.03}},
                             {"rig:right_foot", 5, {-0.14, 0.1, 0}},
                             {"rig:belly", 0, {0, 1.25, 0.03}},
                             {"rig:chest", 7, {0, 1.4, 0.01}},
                             {"rig:head", 8, {0, 1.7, 0.08}},
                             {"rig:left_arm", 8, {0.2, 1.6, 0}},
                             {"rig:left_elbow", 10, {0.4, 1.4, -0.02}},
                             {"rig:left_hand", 11, {0.58, 1.2, 0}},
                             {"rig:right_arm", 8, {-0.2, 1.6, 0}},
                             {"rig:right_elbow", 13, {-0.4, 1.4, -0.02}},
                             {"rig:right_hand", 14, {-0.58, 1.2, 0}}};
  glm::dmat4 armature{1.0};

  // In the scene, at rest.
  glm::dquat turn_of(std::size_t bone) const {
    const auto angle = static_cast<double>(bone);
    return glm::normalize(glm::dquat(std::cos(angle), std::sin(2 * angle), 0.4, std::cos(3 * angle)));
  }

  Character character() const {
    RawScene scene;
    RawNode& top = scene.nodes.emplace_back();
    top.name = "Armature";
    // Of z up and centimetres, somewhere in the scene.
    top.translation = {3, 0, -2};
    top.rotation = glm::angleAxis(-glm::half_pi<double>(), glm::dvec3(1, 0, 0));
    top.scale = glm::dvec3(0.01);
    const glm::dvec3 here = top.translation;  // `top` goes as nodes are added
    RawSkin& skin = scene.skins.emplace_back();
    std::vector<glm::dmat4> to_scene = {glm::translate(glm::dmat4(1.0), top.translation) *
                                        glm::mat4_cast(top.rotation) * glm::scale(glm::dmat4(1.0), top.scale)};
    std::vector<glm::dquat> turns = {top.rotation};
    for (std::size_t b = 0; b < bones.size(); ++b) {
      const auto up = static_cast<std::size_t>(bones[b].parent + 1);
      RawNode& node = scene.nodes.emplace_back();
      node.name = bones[b].name;
      node.parent = bones[b].parent + 1;
      node.translation = glm::dvec3(glm::inverse(to_scene[up]) * glm::dvec4(here + bones[b].place, 1));
      const glm::dquat turned = turn_of(b);
      node.rotation = glm::conjugate(turns[up]) * turned;
      turns.push_back(turned);
      to_scene.push_back(to_scene[up] * glm::translate(glm::dmat4(1.0), node.translation) *
                         glm::mat4_cast(node.rotation));
      skin.joints.push_back(static_cast<int>(b) + 1);
    }
    skin.inverse_bind.assign(skin.joints.size(), glm::dmat4(1.0));
    return {"hero.mrw", build_skeletons(scene).skeletons};
  }
};

struct Onto {
  // `dress`: gives the character meshes, and what holds them.
  explicit Onto(const Rig& rig = {}, const std::vector<Joint>& body = kBody, const Motion& motion = number_of,
                const std::function<std::shared_ptr<const void>(Character&)>& dress = nullptr)
      : character(rig.character()) {
    if (dress) character.holds = dress(character);
    CookOptions options = raw();
    options.clips_only = true;
    options.onto = std::make_shared<const Character>(character);
    built = build_scene(read_body(body, motion), options, notes);
  }
  std::vector<Map> at(int frame) const {
    const Skeleton skeleton = view(built.skeletons[0]);
    return played(skeleton, view(built.clips.at(0), skeleton), 0.1F * static_cast<float>(frame));
  }
  std::size_t joint(const std::string& name) const {
    const std::vector<std::string>& names = built.skeletons[0].joint_names;
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  }
  Character character;
  Notes notes;
  BuiltScene built;
};

inline std::size_t body_joint(std::string name) {
  std::erase(name, '_');
  for (std::size_t j = 0; j < kBody.size(); ++j) {
    std::string other = kBody[j].name;
    for (char& c : other) c = static_cast<char>(std::tolower(c));
    if (other == name) return j;
  }
  ADD_FAILURE() << name;
  return 0;
}

}  // namespace marrow::cook::mocap
