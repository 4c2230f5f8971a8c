// Roots that are taken out of clips, and speeds: of real walks, as they are and as other tools would have written them.
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "disk/cook_on_disk.h"
#include "marrow/owned.h"
#include "support/places.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

CookOptions plain() {
  return options_of("--mesh-codec none --images none --clip-codec raw");
}

RawScene scene_of(const char* file) {
  return read_source((std::filesystem::path(test::assets_folder()) / file).string(), plain());
}

void cook(RawScene scene, RootMotion root, OwnedFile& out) {
  CookOptions options = plain();
  if (root != RootMotion::none) options.motion.roots = {{"*", root}};
  const std::vector<std::byte> bytes = cook_scene(std::move(scene), options).file;
  ASSERT_EQ(make_owned(Span<const std::byte>(bytes.data(), bytes.size()), out), Status::ok);
}

ClipMotion motion_of(const OwnedFile& file, const char* clip) {
  return find_animation(file.animations, clip)->motion;
}

bool missing(const char* file) {
  return !std::filesystem::exists(std::filesystem::path(test::assets_folder()) / file);
}

// The root nodes as if below one that turns and scales: the same scene by other numbers.
RawScene below(RawScene scene, const glm::dquat& turn, double scale) {
  const int above = static_cast<int>(scene.nodes.size());
  const glm::dquat back = glm::conjugate(turn);
  for (RawClip& clip : scene.clips)
    for (RawChannel& channel : clip.channels) {
      if (scene.nodes[to_index(channel.node)].parent != kNone) continue;
      for (glm::vec4& v : channel.values) {
        if (channel.path == RawPath::translation) v = glm::vec4(glm::vec3(back * glm::dvec3(v) / scale), 0);
        if (channel.path == RawPath::scale) v = glm::vec4(glm::vec3(glm::dvec3(v) / scale), 0);
        if (channel.path != RawPath::rotation) continue;
        const glm::dquat q = back * glm::dquat(v.w, v.x, v.y, v.z);
        v = glm::vec4(glm::dvec4(q.x, q.y, q.z, q.w));
      }
    }
  for (RawNode& node : scene.nodes) {
    if (node.parent != kNone) continue;
    node.parent = above;
    node.translation = back * node.translation / scale;
    node.rotation = back * node.rotation;
    node.scale /= scale;
  }
  RawNode node;
  node.name = "above all";
  node.rotation = turn;
  node.scale = glm::dvec3(scale);
  scene.nodes.push_back(node);
  return scene;
}

// Every root node scaled.
RawScene scaled(RawScene scene, double scale) {
  const int above = static_cast<int>(scene.nodes.size());
  for (RawNode& node : scene.nodes)
    if (node.parent == kNone) node.parent = above;
  RawNode node;
  node.scale = glm::dvec3(scale);
  scene.nodes.push_back(node);
  return scene;
}

// The clips on the spot: what the joint that is carried farthest moves along z in the mean is taken out.
RawScene on_the_spot(RawScene scene) {
  for (RawClip& clip : scene.clips)
    for (RawChannel& c : clip.channels) {
      if (c.path != RawPath::translation || c.interpolation != RawInterpolation::linear) continue;
      const glm::vec4 way = c.values.back() - c.values.front();
      if (glm::length(way) < 1) continue;
      for (std::size_t k = 0; k < c.values.size(); ++k)
        c.values[k] -= way * ((c.times_s[k] - c.times_s.front()) / (c.times_s.back() - c.times_s.front()));
    }
  return scene;
}

// pab's clips move: 1.425 m in 1.333 s, 2.5 m in 0.8 s, 3.346 m in 0.667 s.
// Feet of the jog slide back by 0.22 m/s while they stand, so that on the spot they imply more.
constexpr struct {
  const char* clip;
  double speed_m_s, on_the_spot_m_s;
} kGaits[] = {{"pab_walk_raw", 1.069, 1.069}, {"pab_jog_raw", 3.125, 3.345}, {"pab_run_raw", 5.019, 5.019}};

TEST(SpeedOfClips, IsThatOfTheHipsOverTheGround) {
  if (missing("pab.glb")) GTEST_SKIP() << "no pab.glb";
  const RawScene scene = scene_of("pab.glb");
  const auto expect = [&](RawScene changed, double scale, double tolerance, const char* how) {
    OwnedFile file;
    cook(std::move(changed), RootMotion::none, file);
    for (const auto& [clip, moving, on_the_spot] : kGaits) {
      const ClipMotion motion = motion_of(file, clip);
      const double speed = tolerance > 0.01 ? on_the_spot : moving * scale;
      EXPECT_NEAR(static_cast<double>(motion.speed_m_s), speed, tolerance * speed) << how << clip;
      EXPECT_NEAR(static_cast<double>(motion.heading[2]), 1, 0.01) << how << clip;
      EXPECT_EQ(motion.phase_marks.size, 2u) << how << clip;
    }
  };
  expect(scene, 1, 1e-3, "as it is, ");
  expect(below(scene, glm::angleAxis(-1.5707963267948966, glm::dvec3(1, 0, 0)), 1), 1, 1e-3, "turned, ");
  expect(below(scene, glm::angleAxis(1.0, glm::normalize(glm::dvec3(1, 2, 3))), 0.01), 1, 1e-3, "in centimetres, ");
  expect(scaled(scene, 0.3), 0.3, 1e-3, "small, ");
  expect(scaled(scene, 0.01), 0.01, 1e-3, "tiny, ");
  expect(on_the_spot(scene), 1, 0.03, "on the spot, ");
}

// Where every joint is: root and pose together are the source's pose, whatever the root leaves out. At the source's
// keys, which pab has 30 a second; between them a joint of a fast turn is a few millimetres inside of its arc.
void expect_same_motion(const char* file, const char* clip, RootMotion how, bool is_at_30_hz = false) {
  OwnedFile whole, taken;
  cook(scene_of(file), RootMotion::none, whole);
  cook(scene_of(file), how, taken);
  OwnedCharacter a, b;
  ASSERT_EQ(make_owned(whole, {.layers = 1, .skin = false}, a), Status::ok);
  ASSERT_EQ(make_owned(taken, {.layers = 1, .skin = false}, b), Status::ok);
  const Animation *from = find_animation(whole.animations, clip), *to = find_animation(taken.animations, clip);
  ASSERT_GT(to->motion.root.size, 1u) << clip;
  const int frames = static_cast<int>(std::lround(60 * from->duration_s));
  for (int i = 0; i <= frames; ++i) {
    const float time_s = static_cast<float>(i) / 60, most = is_at_30_hz && i % 2 == 0 ? 5e-4f : 1e-2f;
    ASSERT_EQ(pose_character(a, {{from, time_s}}), Status::ok);
    ASSERT_EQ(pose_character(b, {{to, time_s}}), Status::ok);
    RigidStep root;
    ASSERT_EQ(sample_root(to->motion, time_s, root), Status::ok);
    const glm::quat turn(root.rotation[3], root.rotation[0], root.rotation[1], root.rotation[2]);
    const glm::vec3 way(root.translation[0], root.translation[1], root.translation[2]);
    const Pose &pose_a = a.skeletons[to->motion_skeleton].pose, &pose_b = b.skeletons[to->motion_skeleton].pose;
    const auto place = [](const Pose& pose, std::uint32_t j) {
      const auto& rows = pose.model_from_joint[j].rows;
      return glm::vec3(rows[0][3], rows[1][3], rows[2][3]);
    };
    for (std::uint32_t j = 0; j < pose_a.skeleton.joint_count; ++j)
      ASSERT_LT(glm::length(turn * place(pose_b, j) + way - place(pose_a, j)), most) << clip << time_s << " " << j;
  }
}

TEST(RootOfClips, AndPoseTogetherAreTheSource) {
  if (missing("pab.glb") || missing("mannequiny.glb")) GTEST_SKIP() << "no models";
  for (const auto& [clip, speed, on_the_spot] : kGaits) expect_same_motion("pab.glb", clip, RootMotion::ground, true);
  expect_same_motion("pab.glb", "pab_atlas_raw", RootMotion::full, true);
  expect_same_motion("mannequiny.glb", "dash_root.001", RootMotion::ground);
  expect_same_motion("mannequiny.glb", "fight_kick_root.001", RootMotion::full);
}

// A loop's root goes evenly: two keys, and hips that stay where they are.
TEST(RootOfClips, OfAStraightLoopIsOneLine) {
  if (missing("pab.glb")) GTEST_SKIP() << "no pab.glb";
  OwnedFile file;
  cook(scene_of("pab.glb"), RootMotion::ground, file);
  for (const auto& [clip, speed, on_the_spot] : kGaits) {
    const ClipMotion motion = motion_of(file, clip);
    ASSERT_EQ(motion.root.size, 2u) << clip;
    EXPECT_NEAR(static_cast<double>(motion.root[1].translation[2]), speed * static_cast<double>(motion.duration_s),
                2e-3);
    EXPECT_EQ(motion.root[1].rotation[1], 0.0f);
  }
}

// What walks on the spot gets the way that its contacts imply, and keeps its poses.
TEST(RootOfClips, OnTheSpotIsWhatContactsImply) {
  if (missing("pab.glb")) GTEST_SKIP() << "no pab.glb";
  OwnedFile with, without;
  cook(on_the_spot(scene_of("pab.glb")), RootMotion::ground, with);
  cook(on_the_spot(scene_of("pab.glb")), RootMotion::none, without);
  for (const auto& [clip, moving, speed] : kGaits) {
    const ClipMotion motion = motion_of(with, clip);
    ASSERT_EQ(motion.root.size, 2u) << clip;
    const double way = speed * static_cast<double>(motion.duration_s);
    EXPECT_NEAR(static_cast<double>(motion.root[1].translation[2]), way, 0.03 * way) << clip;
    const std::uint32_t index = with.find_clip(clip);
    ASSERT_EQ(with.clip(index).tracks.size, without.clip(index).tracks.size);
  }
  EXPECT_EQ(motion_of(without, "pab_walk_raw").root.size, 0u);
}

}  // namespace
}  // namespace marrow::cook
