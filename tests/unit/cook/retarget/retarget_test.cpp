// Motion capture from a BVH file, on its own skeleton and on others: against matrices composed here, in double
// precision, by the file's channel order.
#include "cook/retarget/retarget.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "cook/retarget/plan/pair_rigs.h"
#include "unit/cook/retarget/retarget_bodies.h"

namespace marrow::cook::mocap {
namespace {

using Names = std::vector<std::string>;

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

const std::pair<const char*, const char*> kBones[] = {{"left_leg", "left_shin"},    {"left_shin", "left_foot"},
                                                      {"right_leg", "right_shin"},  {"right_shin", "right_foot"},
                                                      {"left_arm", "left_elbow"},   {"left_elbow", "left_hand"},
                                                      {"right_arm", "right_elbow"}, {"right_elbow", "right_hand"}};

// The largest angles between bones of the rig and of the file, these turned about y by so much.
struct Angles {
  double legs_deg = 0, arms_deg = 0;
};
Angles worst_angles(const Onto& onto, double facing_deg) {
  Angles worst;
  for (int f = 0; f < kFrames; ++f) {
    const std::vector<Map> file = posed(kBody, f), rig = onto.at(f);
    for (const auto& [from, to] : kBones) {
      const Vec3 a = test::minus(place_of(rig[onto.joint(std::string("rig:") + to)]),
                                 place_of(rig[onto.joint(std::string("rig:") + from)]));
      const Vec3 b = test::minus(place_of(file[body_joint(to)]), place_of(file[body_joint(from)]));
      double& of =
          std::string(to).find("shin") != std::string::npos || std::string(to).find("foot") != std::string::npos
              ? worst.legs_deg
              : worst.arms_deg;
      of = std::max(of, test::angle_deg(a, test::direction(turn('Y', facing_deg), b)));
    }
  }
  return worst;
}

// Legs give a little, so that feet near the ground stay where the file's are.
void expect_same_bones(const Onto& onto, double facing_deg) {
  const Angles worst = worst_angles(onto, facing_deg);
  EXPECT_LE(worst.arms_deg, 1e-3) << facing_deg;
  EXPECT_LE(worst.legs_deg, 2) << facing_deg;
}

TEST(Retarget, BonesPointWhereTheFileHasThem) {
  const Onto onto;
  EXPECT_EQ(onto.built.skeletons.size(), 1u);
  EXPECT_TRUE(onto.notes.warnings.empty()) << onto.notes.warnings[0].text;
  expect_same_bones(onto, 0);
  // The joint that the file does not have keeps its rest pose and is carried along.
  for (const Track& track : onto.built.clips[0].tracks) EXPECT_NE(track.joint, onto.joint("rig:belly"));
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
    expect_same_bones(onto, degrees);
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
}  // namespace marrow::cook::mocap
