// Rotations that a rig gets from another: against the formula, in double precision, on skeletons made by hand.
#include <algorithm>
#include <cmath>

#include "cook/retarget/plan/retarget_plan.h"
#include "cook/retarget/play_take.h"
#include "cook/retarget/retarget.h"
#include "cook/skeleton/build_skeletons.h"
#include "unit/cook/retarget/raw_rig.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

const std::vector<RawRigBone> kSource = {
    {"a", -1, {0, 1, 0}}, {"b", 0, {0.1, 1.5, 0}}, {"c", 1, {0.5, 1.7, 0.1}}, {"d", 2, {0.7, 2.2, 0.1}}};
const std::vector<RawRigBone> kTarget = {
    {"a", -1, {0, 2, 0}}, {"b", 0, {0, 2.4, 0.3}}, {"c", 1, {0.9, 2.5, 0.3}}, {"d", 2, {1.0, 2.6, 0.1}}};

// A clip that turns every joint, at three keys.
RawScene moved(RawScene scene, bool with_places = false) {
  RawClip& clip = scene.clips.emplace_back();
  clip.name = "move";
  for (std::size_t n = 1; n < scene.nodes.size(); ++n) {
    RawChannel& channel = clip.channels.emplace_back();
    channel.node = static_cast<int>(n);
    channel.path = RawPath::rotation;
    for (int key = 0; key < 3; ++key) {
      const glm::dquat q = some_turn(11 * static_cast<double>(n) + 1.3 * key);
      channel.times_s.push_back(0.02F * static_cast<float>(key));
      channel.values.emplace_back(q.x, q.y, q.z, q.w);
    }
    if (!with_places || n != 1) continue;
    RawChannel places{1, RawPath::translation, RawInterpolation::linear, channel.times_s, {}};
    for (int key = 0; key < 3; ++key) places.values.emplace_back(0.1 * key, 0.2, -0.3 * key, 0);
    clip.channels.push_back(places);
  }
  return scene;
}

// Rodrigues' formula, about the axis that both directions are at a right angle to.
glm::dmat3 shortest_arc(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 v = glm::cross(from, to);
  const double c = glm::dot(from, to);
  const glm::dmat3 k(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
  return glm::dmat3(1.0) + k + k * k / (1 + c);
}

Character character_of_rig(const RawScene& rig) {
  return {"hero.mrw", build_skeletons(rig).skeletons};
}

// R = R_s · A_s⁻¹ · A_t: A_s is the source at rest, A_t the target with its bones as the source's.
TEST(RetargetPose, RotationsFollowTheFormula) {
  const RawScene source = moved(raw_rig(kSource, 2)), target = raw_rig(kTarget, 5);
  Notes notes;
  const RetargetedClips got = retarget_clips(character_of_rig(target), source, nullptr, notes);
  ASSERT_EQ(got.clips.size(), 1u);
  RawScene posed = target;
  RawClip clip = got.clips[0];
  for (RawChannel& channel : clip.channels) channel.node += 1;  // joints to nodes
  ASSERT_EQ(clip.channels[0].times_s.size(), 3u);
  const RawPose source_rest = raw_pose(source, nullptr, 0), target_rest = raw_pose(target, nullptr, 0);
  for (std::size_t key = 0; key < 3; ++key) {
    const RawPose from = raw_pose(source, &source.clips[0], key), to = raw_pose(posed, &clip, key);
    for (std::size_t n = 1; n < 5; ++n) {
      const std::size_t upper = std::min<std::size_t>(n, 3);  // the last joint goes with the one above
      const glm::dmat3 arc = shortest_arc(glm::normalize(target_rest.places[upper + 1] - target_rest.places[upper]),
                                          glm::normalize(source_rest.places[upper + 1] - source_rest.places[upper]));
      const glm::dmat3 expected = glm::mat3_cast(from.turns[n]) * glm::transpose(glm::mat3_cast(source_rest.turns[n])) *
                                  arc * glm::mat3_cast(target_rest.turns[n]);
      const glm::dmat3 off = glm::transpose(expected) * glm::mat3_cast(to.turns[n]);
      EXPECT_NEAR(off[0][0] + off[1][1] + off[2][2], 3, 1e-9) << key << ' ' << n;
    }
  }
}

TEST(RetargetPose, OntoItselfNothingChanges) {
  const RawScene source = moved(raw_rig(kSource, 3), true);
  Notes notes;
  const RetargetedClips got = retarget_clips(character_of_rig(source), source, nullptr, notes);
  ASSERT_EQ(got.clips.size(), 1u);
  RawClip clip = got.clips[0];
  for (RawChannel& channel : clip.channels) channel.node += 1;
  for (std::size_t key = 0; key < 3; ++key) {
    const RawPose from = raw_pose(source, &source.clips[0], key), to = raw_pose(source, &clip, key);
    for (std::size_t n = 1; n < 5; ++n) {
      EXPECT_LE(angle_between(from.turns[n], to.turns[n]), 1e-6) << key << ' ' << n;
      EXPECT_LE(glm::length(from.places[n] - to.places[n]), 1e-6) << key << ' ' << n;
    }
  }
}

TEST(RetargetPose, FramesComeBetweenFarKeys) {
  RawScene source = moved(raw_rig(kSource, 2));
  for (RawChannel& channel : source.clips[0].channels) channel.times_s = {0, 1, 2};
  Notes notes;
  const RetargetedClips got = retarget_clips(character_of_rig(raw_rig(kTarget, 5)), source, nullptr, notes);
  const std::vector<float>& times_s = got.clips.at(0).channels.at(0).times_s;
  EXPECT_GE(times_s.size(), 48u);
  EXPECT_LE(times_s.size(), 50u);
  EXPECT_EQ(times_s.back(), 2.0F);
}

TEST(RetargetPose, OneKeyIsOneFrame) {
  RawScene source = moved(raw_rig(kSource, 2));
  for (RawChannel& channel : source.clips[0].channels) {
    channel.times_s.resize(1);
    channel.values.resize(1);
  }
  Notes notes;
  const RetargetedClips got = retarget_clips(character_of_rig(raw_rig(kTarget, 5)), source, nullptr, notes);
  EXPECT_EQ(got.clips.at(0).channels.at(0).values.size(), 1u);
}

// A hand that is turned by 80 degrees about the forearm takes a joint halfway with it by 40, and the upper arm's twist
// of 60 is taken back by three quarters a quarter of the way down.
TEST(RetargetPose, TwistJointsTakeTheirShare) {
  const BuiltSkeleton skeleton = [] {
    BuiltSkeleton out = build_skeletons(raw_rig({{"arm", -1, {0, 0, 0}},
                                                 {"forearm", 0, {1, 0, 0}},
                                                 {"arm_twist", 0, {0.25, 0, 0.01}},
                                                 {"hand", 1, {2, 0, 0}},
                                                 {"forearm_roll", 1, {1.5, 0.02, 0}}},
                                                7))
                            .skeletons.at(0);
    out.roles.roles = {{0, Role::left_upper_arm, 0}, {1, Role::left_lower_arm, 0}, {3, Role::left_hand, 0}};
    return out;
  }();
  ASSERT_EQ(skeleton.joint_names[3], "hand");
  RetargetPlan plan;
  std::vector<Counterpart> pairs(5);
  for (const std::size_t j : {0U, 1U, 3U}) pairs[j].node = 0;
  plan.joints = lay_out(skeleton, pairs);
  const std::vector<TwistJoint> twists = find_twists(skeleton, plan);
  ASSERT_EQ(twists.size(), 2u);
  Puppet puppet(5);
  const auto about_x = [](double degrees) {
    const double half = degrees / 57.29577951308232 / 2;
    return glm::dquat(std::cos(half), std::sin(half), 0, 0);
  };
  puppet.is_turned = {1, 1, 0, 1, 0};
  puppet.wanted = {
      about_x(60) * plan.joints[0].turn, about_x(60) * plan.joints[1].turn, {}, about_x(140) * plan.joints[3].turn, {}};
  puppet.pose(plan);
  twist(plan, twists, puppet);
  EXPECT_LE(angle_between(puppet.turns[0] * puppet.local[2], about_x(60 * 0.25) * plan.joints[2].turn), 1e-6);
  EXPECT_LE(angle_between(puppet.turns[1] * puppet.local[4], about_x(60 + 40) * plan.joints[4].turn), 1e-6);
}

// Bones of no length, a mirror and scales of 0 are no reason for what is no number.
TEST(RetargetPose, WhatIsDegenerateIsDefined) {
  std::vector<RawRigBone> flat = kSource;
  for (RawRigBone& bone : flat) bone.place = {0, 1, 0};
  RawScene source = moved(raw_rig(kSource, 2)), point = moved(raw_rig(flat, 2)), mirrored = moved(raw_rig(kSource, 2));
  mirrored.nodes[2].scale = {-1, 1, 1};
  RawScene nothing = moved(raw_rig(kSource, 2));
  nothing.nodes[2].scale = {0, 0, 0};
  const auto expect_numbers = [](const RawScene& from, const RawScene& onto) {
    Notes notes;
    for (const RawClip& clip : retarget_clips(character_of_rig(onto), from, nullptr, notes).clips)
      for (const RawChannel& channel : clip.channels)
        for (const glm::vec4& value : channel.values) ASSERT_TRUE(std::isfinite(glm::dot(value, value)));
  };
  for (const RawScene* const from : {&source, &point, &mirrored, &nothing})
    for (const RawScene* const onto : {&source, &point, &mirrored, &nothing}) expect_numbers(*from, *onto);
}

}  // namespace
}  // namespace marrow::cook
