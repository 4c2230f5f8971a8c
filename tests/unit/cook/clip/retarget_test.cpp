// Motion capture from a BVH file, on its own skeleton and on others: against matrices composed here, in double
// precision, by the file's channel order.
#include "cook/prepare/retarget.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "cook/bvh/read_bvh.h"
#include "cook/prepare/pair_joints.h"
#include "cook/scene/views.h"
#include "cook/skeleton/build_skeletons.h"
#include "support/double_math.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

using Names = std::vector<std::string>;

using test::Map;
using test::Vec3;

constexpr int kFrames = 5;

struct Joint {
  std::string name;
  int parent;
  Vec3 offset;
  std::string channels;  // X, Y, Z: rotations; x, y, z: positions; in the order of the file
};

// Two legs and arms, upright, as a body in a T-pose; the unit is the centimetre.
const std::vector<Joint> kBody = {
    {"Hips", -1, {0, 90, 0}, "xyzZXY"},   {"LeftLeg", 0, {10, -5, 0}, "ZXY"},    {"LeftShin", 1, {0, -40, 1}, "YXZ"},
    {"LeftFoot", 2, {0, -40, -1}, "X"},   {"RightLeg", 0, {-10, -5, 0}, "XYZ"},  {"RightShin", 4, {0, -40, 1}, "ZYX"},
    {"RightFoot", 5, {0, -40, -1}, ""},   {"Chest", 0, {0, 30, 0}, "XZY"},       {"Head", 7, {0, 25, 2}, "YZX"},
    {"LeftArm", 7, {18, 20, 0}, "ZXY"},   {"LeftElbow", 9, {28, 0, 0}, "ZXY"},   {"LeftHand", 10, {25, 0, 0}, "zZyXxY"},
    {"RightArm", 7, {-18, 20, 0}, "ZXY"}, {"RightElbow", 12, {-28, 0, 0}, "YX"}, {"RightHand", 13, {-25, 0, 0}, "ZXY"}};

double number_of(int frame, std::size_t joint, std::size_t channel, char kind) {
  const double wave = std::sin(1.7 * frame + 0.9 * static_cast<double>(joint) + 2.1 * static_cast<double>(channel));
  if (kind >= 'X' && kind <= 'Z') return 70 * wave;
  // Hands have positions too, and keep them.
  if (joint != 0) return kBody[joint].offset[static_cast<std::size_t>(kind - 'x')];
  return (kind == 'y' ? 88 : 0) + 20 * wave * frame;
}

std::string text_of(const std::vector<Joint>& body,
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

Map turn(char axis, double degrees) {
  const double c = std::cos(degrees / 57.29577951308232), s = std::sin(degrees / 57.29577951308232);
  if (axis == 'X') return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}}};
  if (axis == 'Y') return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}}};
  return {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}}};
}

// What the file says of a frame: each joint's map to the scene.
std::vector<Map> posed(const std::vector<Joint>& body, int frame) {
  std::vector<Map> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    Map place, turned;
    for (int axis = 0; axis < 3; ++axis) place.rows[axis][3] = body[j].offset[static_cast<std::size_t>(axis)];
    for (std::size_t c = 0; c < body[j].channels.size(); ++c) {
      const char kind = body[j].channels[c];
      const double number = number_of(frame, j, c, kind);
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

Vec3 place_of(const Map& m) {
  return {m.rows[0][3], m.rows[1][3], m.rows[2][3]};
}

RawScene read_body(const std::vector<Joint>& body = kBody) {
  const std::string text = text_of(body, number_of);
  return read_bvh("walk.bvh", std::as_bytes(std::span(text)));
}

CookOptions raw() {
  CookOptions options;
  options.raw_clips = true;
  return options;
}

// A clip of a skeleton at a time, joint by joint, in the scene.
std::vector<Map> played(const Skeleton& skeleton, const Clip& clip, float time_s) {
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

TEST(Retarget, ItsOwnSkeletonStandsAsTheFileSays) {
  const LoadedCook cooked(cook_scene(read_body(), raw()));
  ASSERT_EQ(cooked.file.skeleton_count(), 1u);
  const Skeleton skeleton = cooked.file.skeleton(0);
  ASSERT_EQ(skeleton.joint_count, kBody.size()) << "joints without channels too";
  const Clip clip = cooked.file.clip(0);
  EXPECT_STREQ(clip.name, "walk");
  EXPECT_FLOAT_EQ(clip.duration_s, 0.1F * (kFrames - 1));
  double worst = 0;
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<Map> expected = posed(kBody, f), found = played(skeleton, clip, 0.1F * static_cast<float>(f));
    for (std::size_t j = 0; j < kBody.size(); ++j) {
      std::size_t cooked_joint = 0;
      while (cooked.file.text(skeleton.names[cooked_joint]) != kBody[j].name) ++cooked_joint;
      worst = std::max(worst, test::length(test::minus(place_of(expected[j]), place_of(found[cooked_joint]))));
    }
  }
  EXPECT_LE(worst, 1e-5 * 180) << "of the body's size";
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
      const auto angle = static_cast<double>(b);
      const glm::dquat turned =
          glm::normalize(glm::dquat(std::cos(angle), std::sin(2 * angle), 0.4, std::cos(3 * angle)));
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
  explicit Onto(const Rig& rig = {}, const std::vector<Joint>& body = kBody) : character(rig.character()) {
    CookOptions options = raw();
    options.clips_only = true;
    options.onto = std::make_shared<const Character>(character);
    built = build_scene(read_body(body), options, notes);
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

const std::pair<const char*, const char*> kBones[] = {{"left_leg", "left_shin"},    {"left_shin", "left_foot"},
                                                      {"right_leg", "right_shin"},  {"right_shin", "right_foot"},
                                                      {"left_arm", "left_elbow"},   {"left_elbow", "left_hand"},
                                                      {"right_arm", "right_elbow"}, {"right_elbow", "right_hand"}};

std::size_t body_joint(std::string name) {
  std::erase(name, '_');
  for (std::size_t j = 0; j < kBody.size(); ++j) {
    std::string other = kBody[j].name;
    for (char& c : other) c = static_cast<char>(std::tolower(c));
    if (other == name) return j;
  }
  ADD_FAILURE() << name;
  return 0;
}

// The largest angle between bones of the rig and of the file, these turned about y by so much.
double worst_angle_deg(const Onto& onto, double facing_deg) {
  double worst = 0;
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<Map> file = posed(kBody, f), rig = onto.at(f);
    for (const auto& [from, to] : kBones) {
      const Vec3 a = test::minus(place_of(rig[onto.joint(std::string("rig:") + to)]),
                                 place_of(rig[onto.joint(std::string("rig:") + from)]));
      const Vec3 b = test::minus(place_of(file[body_joint(to)]), place_of(file[body_joint(from)]));
      worst = std::max(worst, test::angle_deg(a, test::direction(turn('Y', facing_deg), b)));
    }
  }
  return worst;
}

TEST(Retarget, BonesPointWhereTheFileHasThem) {
  const Onto onto;
  EXPECT_EQ(onto.built.skeletons.size(), 1u);
  EXPECT_TRUE(onto.notes.warnings.empty()) << onto.notes.warnings[0].text;
  EXPECT_LE(worst_angle_deg(onto, 0), 1e-3);
  // The joint that the file does not have keeps its rest pose and is carried along.
  for (const Track& track : onto.built.clips[0].tracks) EXPECT_NE(track.joint, onto.joint("rig:belly"));
}

TEST(Retarget, HipsAreCarriedInTheRigsSize) {
  const Onto onto;
  // From hips to foot, 5 and 10 aside, then the leg.
  const double file_way = std::hypot(10, 5) + 2 * std::hypot(40, 1);
  const double rig_way = glm::length(glm::dvec3(0.12, -0.05, -0.02)) + glm::length(glm::dvec3(0.01, -0.45, 0.03)) +
                         glm::length(glm::dvec3(0.01, -0.5, -0.03));
  std::size_t moves = 0;
  for (const Track& track : onto.built.clips[0].tracks)
    if (track.path == TrackPath::translation) moves += track.joint == onto.joint("rig:hips") ? 1u : 100u;
  EXPECT_EQ(moves, 1u) << "hips, and nothing else";
  for (int f = 0; f < kFrames; ++f) {
    const Vec3 file = place_of(posed(kBody, f)[0]), rig = place_of(onto.at(f)[onto.joint("rig:hips")]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double origin = axis == 0 ? 3 : axis == 1 ? 0 : -2;
      EXPECT_NEAR(rig[axis], origin + file[axis] * rig_way / file_way, 1e-5) << f;
    }
  }
}

// At the file's rest pose, a T, hands and forearms are to one another as in the rig's own pose.
TEST(Retarget, HandsGoWithTheArmAndHeadsStayUpright) {
  std::vector<Joint> still = kBody;
  for (Joint& joint : still) joint.channels = joint.name == "Hips" ? "X" : "";
  const std::string text = text_of(still, [](int, std::size_t, std::size_t, char) { return 0.0; });
  const Rig rig;
  CookOptions options = raw();
  options.clips_only = true;
  const Character character = rig.character();
  options.onto = std::make_shared<const Character>(character);
  Notes notes;
  const BuiltScene built = build_scene(read_bvh("t.bvh", std::as_bytes(std::span(text))), options, notes);
  const Skeleton skeleton = view(built.skeletons[0]);
  const std::vector<Map> pose = played(skeleton, view(built.clips.at(0), skeleton), 0);
  std::vector<Affine> rest(skeleton.joint_count);
  ASSERT_EQ(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, rest), Status::ok);
  const std::vector<std::string>& names = built.skeletons[0].joint_names;
  const auto joint = [&](const char* name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  // Head as at rest.
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      EXPECT_NEAR(pose[joint("rig:head")].rows[r][c], static_cast<double>(rest[joint("rig:head")].rows[r][c]), 1e-7);
  // The hand's rotation relative to the elbow's is that of the rest pose: transposes of one another's products.
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      double now = 0, then = 0;
      for (int r = 0; r < 3; ++r) {
        const std::size_t hand = joint("rig:left_hand"), elbow = joint("rig:left_elbow");
        now += pose[elbow].rows[r][i] * pose[hand].rows[r][k];
        then += static_cast<double>(rest[elbow].rows[r][i]) * static_cast<double>(rest[hand].rows[r][k]);
      }
      EXPECT_NEAR(now, then, 1e-9) << i << k << ", of columns 0.01 long";
    }
}

TEST(Retarget, WhoFacesOtherwiseIsTurned) {
  for (const double degrees : {180.0, 90.0, -90.0}) {
    Rig rig;
    for (Rig::Bone& bone : rig.bones) {
      const Vec3 place = test::direction(turn('Y', degrees), {bone.place.x, bone.place.y, bone.place.z});
      bone.place = {place[0], place[1], place[2]};
    }
    const Onto onto(rig);
    EXPECT_LE(worst_angle_deg(onto, degrees), 1e-3) << degrees;
    EXPECT_TRUE(warns(onto.notes, "turned", "HIERARCHY"));
  }
}

TEST(Retarget, OntoItselfNothingChanges) {
  const RawScene own = read_body();
  const Character character{"own.mrw", build_skeletons(own).skeletons};
  Notes notes;
  const Matched matched = retarget(character, read_body(), notes);
  const std::vector<std::string>& names = character.skeletons[0].joint_names;
  std::size_t compared = 0;
  for (const RawChannel& channel : matched.scene.clips.at(0).channels) {
    const std::string& name = names[static_cast<std::size_t>(channel.node)];
    for (const RawChannel& other : own.clips[0].channels) {
      if (own.nodes[static_cast<std::size_t>(other.node)].name != name || other.path != channel.path) continue;
      ++compared;
      for (std::size_t i = 0; i < other.values.size(); ++i)
        EXPECT_LE(std::min(glm::length(channel.values[i] - other.values[i]),
                           glm::length(channel.values[i] + other.values[i])),
                  1e-5F * (1 + glm::length(other.values[i])))
            << name;
    }
  }
  EXPECT_EQ(compared, kBody.size()) << "a rotation of all but one, and a translation";
}

TEST(Retarget, WhatIsLeftOutIsNamed) {
  std::vector<Joint> body = kBody;
  body[8].name = "Kopf";
  body[14].name = "HandRechts";
  const Onto onto({}, body);
  ASSERT_EQ(onto.notes.warnings.size(), 1u);
  EXPECT_EQ(onto.notes.warnings[0].rule, "no-such-joint");
  EXPECT_NE(onto.notes.warnings[0].text.find("2 of 15 joints have no counterpart in hero.mrw"), std::string::npos);
  EXPECT_NE(onto.notes.warnings[0].text.find("Kopf, HandRechts"), std::string::npos) << onto.notes.warnings[0].text;
  for (Joint& joint : body) joint.name = "x" + joint.name;
  expect_failure([&] { Onto({}, body); }, Exit::invalid, "HIERARCHY", "no joint is called as in hero.mrw");
}

// Legs of next to nothing make a giant.
TEST(Retarget, PlacesStayWithinBounds) {
  std::vector<Joint> body = kBody;
  for (Joint& joint : body)
    for (double& x : joint.offset) x *= joint.parent < 0 ? 1 : 1e-14;
  expect_failure([&] { Onto({}, body); }, Exit::invalid, "MOTION", "a place beyond 1e12");
}

TEST(Retarget, ManyJointsWithoutChannelsAndManyFrames) {
  std::vector<Joint> body = {{"Hips", -1, {0, 1, 0}, "X"}};
  for (int i = 0; i < 2'000; ++i) body.push_back({"j" + std::to_string(i), 0, {0, 1, 0}, ""});
  std::string text = text_of(body, [](int, std::size_t, std::size_t, char) { return 0.0; });
  text.resize(text.find("Frames"));
  text += "Frames: 60000\nFrame Time: 0.01\n";
  for (int f = 0; f < 60'000; ++f) text += "0\n";
  Rig rig;
  Notes notes;
  expect_failure([&] { retarget(rig.character(), read_bvh("many.bvh", std::as_bytes(std::span(text))), notes); },
                 Exit::unsupported, "MOTION", "too many frames");
}

TEST(PairJoints, ExactlyThenLoosely) {
  using Pairs = std::vector<int>;
  EXPECT_EQ(pair_joints({"a", "b", "c"}, {"c", "a"}), (Pairs{1, kNone, 0}));
  EXPECT_EQ(pair_joints({"mixamorig:Hips", "LeftArm"}, {"left_arm", "hips"}), (Pairs{1, 0}));
  EXPECT_EQ(pair_joints({"Hips"}, {"ns:inner:hIPS"}), (Pairs{0}));
  EXPECT_EQ(pair_joints({"Upper Arm.L"}, {"upper_arm_l"}), (Pairs{0}));
  EXPECT_EQ(pair_joints({"hips", "Hips"}, {"Hips"}), (Pairs{kNone, 0})) << "the exact one goes first";
  EXPECT_EQ(pair_joints({"hips"}, {"a:Hips", "b:Hips"}), (Pairs{kNone})) << "two could be meant";
  EXPECT_EQ(pair_joints({"Hips", "Hips"}, {"Hips"}), (Pairs{kNone, kNone}));
  EXPECT_EQ(pair_joints({"", "a:", "_"}, {"", "b:", "."}), (Pairs{kNone, kNone, kNone})) << "nothing is no name";
  EXPECT_EQ(pair_joints({"Foot"}, {"Feet"}), (Pairs{kNone}));
  EXPECT_EQ(pair_joints({}, Names{"a"}), Pairs{});
}

}  // namespace
}  // namespace marrow::cook
