// Several characters in one file, from a generated glTF through the whole road, against the reference evaluator.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "road/cooked.h"
#include "road/reference.h"
#include "unit/cook/scene_document.h"

namespace marrow::test {
namespace {

constexpr double kMostPosition = 1e-5;  // of the diagonal; float's rounding in a few products
constexpr int kMoments = 23;

// Two characters with joints of equal names, a target below one's armature, a machine of two parts, and scenery.
std::string write_scene() {
  cook::SceneDocument d;
  const std::vector<int> a = d.character("Ada", -1), b = d.character("Bob", 1);
  const int target = d.node("target", 6, {0, 0.25F, 0.5F});
  const int engine = d.node("engine", -1, {0, 0, 4});
  const int piston = d.node("piston", engine), wheel = d.node("wheel", engine, {0, 1, 0});
  d.prop(piston);
  d.prop(wheel);
  d.prop(target);
  for (int i = 0; i < 5; ++i) d.prop(d.node("stone", -1, {static_cast<float>(i), 0, -3}));
  d.clip("fight");
  d.turn(a[0], {0, 0.5F, 1.5F});
  d.turn(a[3], {0, 0.25F, 1});
  d.turn(b[1], {0, 0.5F, 1});
  d.carry(b[0], {0.25F, 0.75F, 1, 2});
  d.carry(target, {0, 0.5F});
  d.clip("run");
  d.carry(piston, {0, 0.125F, 0.25F});
  d.turn(wheel, {0, 0.25F});
  d.turn(a[1], {0, 0.5F});  // both characters, so that the machine is neither's
  d.turn(b[2], {0, 0.5F});
  d.clip("wait");
  d.turn(a[2], {0, 1});
  const std::string path = (std::filesystem::temp_directory_path() / "marrow_characters.gltf").string();
  std::ofstream(path) << d.text();
  return path;
}

TEST(Characters, EachPlaysAsTheReferenceDoes) {
  const std::string path = write_scene();
  const Reference reference(path);
  const Cooked cooked(path);
  std::filesystem::remove(path);
  const File& file = cooked.file();
  ASSERT_EQ(file.skeleton_count(), 4u);
  EXPECT_EQ(file.find_skeleton("Ada"), 0u);
  EXPECT_EQ(file.find_skeleton("Bob"), 1u);
  EXPECT_EQ(file.find_skeleton("Eve"), 4u);
  EXPECT_EQ(file.skeleton(1).joint_count, 5u) << "with the target";
  EXPECT_EQ(file.skeleton(2).joint_count, 2u) << "the machine";
  EXPECT_EQ(file.skeleton(3).joint_count, 5u) << "the stones";
  ASSERT_EQ(file.clip_count(), 6u);
  EXPECT_EQ(file.find_clip("run", 2), 4u);
  EXPECT_EQ(file.find_clip("wait", 1), 6u);
  EXPECT_EQ(file.find_clip("fight", 1), 1u);
  EXPECT_EQ(file.clip(0).duration_s, 2.0f);
  EXPECT_EQ(file.clip(1).duration_s, 2.0f);
  double worst = 0;
  std::size_t compared = 0;
  std::uint32_t clip = 0;
  for (std::size_t animation = 0; animation < 3; ++animation) {
    for (int moment = 0; moment < kMoments; ++moment) {
      const float time_s = 2.2f * static_cast<float>(moment) / (kMoments - 1);  // and behind the end
      const ReferencePose want = reference.at(animation, static_cast<double>(time_s));
      const CookedPose got = cooked.pose(clip, time_s, Deformer::ssd);
      ASSERT_EQ(got.positions.size(), want.positions.size());
      for (std::size_t v = 0; v < want.positions.size(); ++v, ++compared)
        worst = std::max(worst, length(minus(want.positions[v], got.positions[v])) / reference.diagonal());
    }
    clip = next_animation(file, clip);
  }
  EXPECT_EQ(clip, file.clip_count());
  EXPECT_EQ(compared, 3u * kMoments * 4 * (2 + 8));
  EXPECT_LE(worst, kMostPosition);
  EXPECT_GT(worst, 0);
  std::printf("worst %.2e of the diagonal, %zu vertices\n", worst, compared);
}

// Every vertex of a finished character by SSD, in the source's order.
std::vector<Vec3> vertices_of(const Character& character) {
  std::vector<Vec3> out;
  for (const CharacterMesh& m : character.meshes) {
    std::vector<float> positions(std::size_t{3} * m.mesh.geometry.slot_count);
    SkinOutput to;
    to.positions = positions;
    EXPECT_EQ(skin_ssd(m.mesh, m.palette, to), Status::ok);
    for (const std::uint32_t slot : m.mesh.geometry.source_slots) {
      Vec3& p = out.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) p[c] = static_cast<double>(positions[3 * std::size_t{slot} + c]);
    }
  }
  return out;
}

TEST(Characters, AllOfAFilePlayByNameAsTheReferenceDoes) {
  const std::string path = write_scene();
  const Reference reference(path);
  const Cooked cooked(path);
  std::filesystem::remove(path);
  const File& file = cooked.file();
  AlignedBlock shared(animations_bytes(file, file)), own(character_bytes(file, {}));
  Animations animations;
  Character character;
  ASSERT_EQ(make_animations(file, file, shared, animations), Status::ok);
  ASSERT_EQ(make_character(file, {}, own, character), Status::ok);
  const char* const names[] = {"fight", "run", "wait"};
  double worst = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const Animation* const animation = find_animation(animations, names[a]);
    ASSERT_NE(animation, nullptr) << names[a];
    EXPECT_NEAR(static_cast<double>(animation->duration_s), reference.duration_s(a), 1e-6);
    for (int moment = 0; moment < kMoments; ++moment) {
      const float time_s = 2.2f * static_cast<float>(moment) / (kMoments - 1);
      const AnimationLayer layer{animation, time_s, 1};
      ASSERT_EQ(pose_character(character, {&layer, 1}), Status::ok);
      ASSERT_EQ(finish_character(character), Status::ok);
      const std::vector<Vec3> want = reference.at(a, static_cast<double>(time_s)).positions;
      const std::vector<Vec3> got = vertices_of(character);
      ASSERT_EQ(got.size(), want.size());
      for (std::size_t v = 0; v < want.size(); ++v)
        worst = std::max(worst, length(minus(want[v], got[v])) / reference.diagonal());
    }
  }
  EXPECT_LE(worst, kMostPosition);
  EXPECT_GT(worst, 0);
}

}  // namespace
}  // namespace marrow::test
