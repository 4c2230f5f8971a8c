// The examples of the documentation, as printed there.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/places.h"
#include "support/rig.h"

namespace {

// [springs]
struct Tail {
  std::vector<marrow::SpringJoint> joints;
  std::vector<marrow::Affine> memory;  // 16-byte boundaries
  marrow::Springs springs;
};

marrow::Status make_tail(const marrow::Skeleton& skeleton, const std::vector<std::uint16_t>& joints, Tail& tail) {
  for (const std::uint16_t joint : joints) {
    marrow::SpringJoint j;
    j.joint = joint;
    j.frequency_hz = 2.5f;
    j.damping_ratio = 0.5f;
    j.drag = 1.0f;
    tail.joints.push_back(j);
  }
  const marrow::SpringChain chain{tail.joints, {}};  // the last joint only ends it
  tail.memory.resize(marrow::springs_bytes(skeleton, {&chain, 1}) / sizeof(marrow::Affine) + 1);
  return marrow::make_springs(
      skeleton, {&chain, 1},
      {reinterpret_cast<std::byte*>(tail.memory.data()), tail.memory.size() * sizeof(marrow::Affine)}, tail.springs);
}

// Every frame: after sample, blend and local_to_model, before the palette.
marrow::Status swing_tail(const marrow::Pose& pose, const marrow::Affine& world_from_model, float dt_s, Tail& tail) {
  marrow::SpringFrame frame;
  frame.dt_s = dt_s;
  frame.world_from_model = world_from_model;
  return marrow::simulate_springs(pose, frame, tail.springs);
}
// [/springs]

// [asset]
marrow::Status load_springs(const marrow::File& file, std::uint32_t skeleton, std::vector<marrow::Affine>& memory,
                            marrow::Springs& springs, marrow::SpringFrame& frame) {
  std::vector<marrow::SpringChain> chains;
  for (std::uint32_t i = 0; i < file.spring_count(skeleton); ++i) chains.push_back(file.spring(skeleton, i));
  frame.colliders = file.spring_colliders(skeleton);
  const marrow::Span<const marrow::SpringChain> all(chains.data(), chains.size());
  memory.resize(marrow::springs_bytes(file.skeleton(skeleton), all) / sizeof(marrow::Affine) + 1);
  return marrow::make_springs(file.skeleton(skeleton), all,
                              {reinterpret_cast<std::byte*>(memory.data()), memory.size() * sizeof(marrow::Affine)},
                              springs);
}
// [/asset]

// [feet]
// The game's: a ray straight down; false if it hits nothing.
using Ray = bool (*)(const float (&through)[3], float (&point)[3], float (&normal)[3]);

marrow::Status stand(const marrow::Pose& pose, const marrow::Feet& feet, const marrow::FeetFrame& frame, Ray ray,
                     const std::vector<bool>& planted, std::vector<marrow::FootMotion>& motion) {
  std::vector<marrow::FootGround> ground(feet.feet.size);
  for (std::size_t i = 0; i < ground.size(); ++i) {
    float sole[3];
    const marrow::Status found = marrow::foot_sole(feet.feet[i], frame.world_from_model, pose.model_from_joint, sole);
    if (found != marrow::Status::ok) return found;
    ground[i].hit = ray(sole, ground[i].point, ground[i].normal);
    ground[i].planted = planted[i];
  }
  return marrow::place_feet(pose, feet, frame, ground, motion);
}
// [/feet]

bool stairs(const float (&through)[3], float (&point)[3], float (&normal)[3]) {
  for (int i = 0; i < 3; ++i) {
    point[i] = i == 1 ? 0.25f : through[i];
    normal[i] = i == 1 ? 1.0f : 0.0f;
  }
  return true;
}

// A tail of three joints on a body, and a leg of three.
marrow::test::TestSkeleton creature() {
  return marrow::test::TestSkeleton({{-1, {0, 1, 0}},
                                     {0, {0, 0, -0.1}},
                                     {0, {0.1, 0, 0}},
                                     {1, {0, 0, -0.2}},
                                     {2, {0, -0.45, 0.1}},
                                     {3, {0, 0, -0.2}},
                                     {4, {0, -0.45, -0.1}}});
}

TEST(FollowingExamples, TheTailSags) {
  const marrow::test::TestSkeleton c = creature();
  const marrow::Skeleton skeleton = c.view();
  Tail tail;
  ASSERT_EQ(make_tail(skeleton, {1, 3, 5}, tail), marrow::Status::ok);
  const marrow::Affine world = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  std::vector<marrow::SoaTransform> local;
  std::vector<marrow::Affine> scene(skeleton.joint_count);
  for (int i = 0; i < 60; ++i) {
    local = c.rest;
    ASSERT_EQ(marrow::local_to_model(skeleton, local, scene), marrow::Status::ok);
    ASSERT_EQ(swing_tail({skeleton, local, scene}, world, 1.0f / 60, tail), marrow::Status::ok);
  }
  EXPECT_LT(scene[5].rows[1][3], 0.95f);
}

// load_springs_test.cpp has a file with some.
TEST(FollowingExamples, AFileWithoutSpringsHasNone) {
  std::vector<marrow::Affine> memory;
  marrow::Springs springs;
  marrow::SpringFrame frame;
  EXPECT_EQ(load_springs(marrow::File(), 0, memory, springs, frame), marrow::Status::ok);
  EXPECT_EQ(springs.group_count, 0u);
}

TEST(FollowingExamples, TheFootStandsOnTheStep) {
  const marrow::test::TestSkeleton c = creature();
  const marrow::Skeleton skeleton = c.view();
  marrow::Foot leg;
  leg.hip = 2, leg.knee = 4, leg.ankle = 6;
  leg.sole[1] = -0.1f;
  marrow::Feet feet;
  feet.feet = {&leg, 1};
  std::vector<marrow::FootMotion> motion(1);
  std::vector<marrow::SoaTransform> local = c.rest;
  std::vector<marrow::Affine> scene(skeleton.joint_count);
  ASSERT_EQ(marrow::local_to_model(skeleton, local, scene), marrow::Status::ok);
  const float height = scene[6].rows[1][3];
  ASSERT_EQ(stand({skeleton, local, scene}, feet, {}, stairs, {false}, motion), marrow::Status::ok);
  EXPECT_NEAR(scene[6].rows[1][3], height + 0.25f, 1e-5f);
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

TEST(FollowingExamples, AreThoseOfTheDocumentation) {
  const std::filesystem::path root = marrow::test::in_source("");
  const std::string source = text_of(root / "tests/unit/ik/following_examples_test.cpp");
  std::string docs;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") docs += text_of(entry.path());
  int found = 0;
  for (const std::string name : {"springs", "asset", "feet"}) {
    const std::string first = "// [" + name + "]\n", last = "// [/" + name + "]\n";
    const std::size_t begin = source.find(first), end = source.find(last);
    ASSERT_NE(begin, std::string::npos) << name;
    ASSERT_NE(end, std::string::npos) << name;
    const std::string example = source.substr(begin + first.size(), end - begin - first.size());
    EXPECT_NE(docs.find("```cpp\n" + example + "```"), std::string::npos) << name << " is printed otherwise";
    ++found;
  }
  EXPECT_EQ(found, 3);
}

}  // namespace
