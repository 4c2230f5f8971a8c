// How layers move their character: steps of a playback, averaged, and laid over by masks.
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/character.h"
#include "marrow/roles.h"
#include "support/aligned.h"
#include "support/bad_numbers.h"
#include "support/golden.h"

namespace marrow {
namespace {

using test::AlignedBlock;

// roles.gltf: a walk of 1 m in 1 s along z, and a stand.
class RootSteps : public ::testing::Test {
 protected:
  RootSteps() : block_(test::golden_roles_copy()) {
    EXPECT_EQ(load(block_, file_), Status::ok);
    shared_ = std::make_unique<AlignedBlock>(animations_bytes(file_, file_));
    EXPECT_EQ(make_animations(file_, file_, *shared_, animations_), Status::ok);
    own_ = std::make_unique<AlignedBlock>(character_bytes(file_, {.layers = 3}));
    EXPECT_EQ(make_character(file_, {.layers = 3}, *own_, character_), Status::ok);
    mask_.assign(4 * character_.skeletons[0].pose.skeleton.soa_size(), 0);
  }
  // After dt_s from the start.
  AnimationLayer layer(const char* name, float dt_s, float weight) {
    AnimationLayer out{find_animation(animations_, name), 0, weight};
    const Playback before;
    Playback after;
    EXPECT_EQ(advance(after, out.animation->motion.duration_s, dt_s), Status::ok);
    EXPECT_EQ(step_layer(before, after, out), Status::ok);
    return out;
  }
  float way(const std::vector<AnimationLayer>& layers) {
    RigidStep step;
    EXPECT_EQ(character_root_step(character_, layers, step), Status::ok);
    EXPECT_NEAR(step.translation[0], 0, 1e-6);
    EXPECT_NEAR(step.rotation[3], 1, 1e-6);
    return step.translation[2];
  }

  AlignedBlock block_;
  File file_;
  std::unique_ptr<AlignedBlock> shared_, own_;
  Animations animations_;
  Character character_;
  std::vector<float> mask_;
};

TEST_F(RootSteps, AnimationsHaveTheirClipsMotion) {
  const Animation* const walk = find_animation(animations_, "walk");
  EXPECT_EQ(walk->motion.events.size, 4u);
  EXPECT_EQ(walk->motion.root.size, 2u);
  EXPECT_EQ(walk->motion_skeleton, 0u);
}

TEST_F(RootSteps, OfALayerAreItsPlaybacks) {
  const AnimationLayer walk = layer("walk", 2.25f, 1);
  EXPECT_FLOAT_EQ(walk.time_s, 0.25f);
  EXPECT_NEAR(way({walk}), 2.25, 1e-6);
  EXPECT_EQ(way({}), 0.0f);
}

TEST_F(RootSteps, AreAveragedByWeight) {
  EXPECT_NEAR(way({layer("walk", 0.5f, 3), layer("stand", 0.5f, 1)}), 0.375, 1e-6);
  EXPECT_NEAR(way({layer("stand", 0.5f, 1), layer("walk", 0.5f, 1), layer("walk", 0.25f, 2)}), 0.25, 1e-6);
  EXPECT_NEAR(way({layer("walk", 0.5f, 1), layer("walk", 0.5f, 0)}), 0.5, 1e-6);
}

// By hand: 0.5 m, of which a layer that stands takes 0.8 · 0.5 at the hips.
TEST_F(RootSteps, OfMaskedLayersTakeTheirShareAtTheHips) {
  AnimationLayer over = layer("stand", 0.5f, 0.8f);
  over.mask = mask_;
  mask_[joint_of(file_.roles(0), Role::head)] = 1;
  EXPECT_NEAR(way({layer("walk", 0.5f, 1), over}), 0.5, 1e-6);
  mask_[joint_of(file_.roles(0), Role::hips)] = 0.5f;
  EXPECT_NEAR(way({layer("walk", 0.5f, 1), over}), 0.3, 1e-6);
  mask_[joint_of(file_.roles(0), Role::hips)] = 7;  // counts as 1
  EXPECT_NEAR(way({over, layer("walk", 0.5f, 1)}), 0.1, 1e-6);
  mask_[joint_of(file_.roles(0), Role::hips)] = test::kNan;
  EXPECT_NEAR(way({layer("walk", 0.5f, 1), over}), 0.5, 1e-6);
}

TEST_F(RootSteps, OfBadCallsAreRefused) {
  RigidStep step{{0, 0, 0, 1}, {7, 7, 7}};
  AnimationLayer walk = layer("walk", 0.5f, 1);
  for (const float weight : {-1.0f, test::kNan, 2e6f}) {
    walk.weight = weight;
    EXPECT_EQ(character_root_step(character_, {walk}, step), Status::bad_argument) << weight;
  }
  walk.weight = 1;
  walk.step.translation[0] = test::kInfinity;
  EXPECT_EQ(character_root_step(character_, {walk}, step), Status::bad_argument);
  EXPECT_EQ(step.translation[0], 7.0f);
  AnimationLayer none;
  EXPECT_EQ(step_layer({}, {}, none), Status::bad_argument);
  EXPECT_EQ(step_layer({.time_s = 0}, {.time_s = 5}, walk), Status::bad_argument);
  EXPECT_EQ(walk.time_s, 0.5f);
}

}  // namespace
}  // namespace marrow
