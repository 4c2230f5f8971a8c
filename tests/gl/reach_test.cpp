// What `marrow render --ik` does: joints of the sample are where they were told to be, and the picture shows it.
#include "pose/reach.h"

#include <cmath>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "gl/support/models.h"
#include "pose/evaluate.h"
#include "support/places.h"

namespace marrow::test {
namespace {

// Distance of the goals' joints from their goals, the worst over a walk.
double worst_distance(const File& file, const tools::Reach& reach) {
  tools::Character character(file);
  character.set_change([&](std::uint32_t skeleton, const Pose& pose) { reach.apply(skeleton, pose); });
  const tools::Play play = tools::play_together(file, file.find_clip("walk", 0));
  double worst = 0;
  for (int i = 0; i < 16; ++i) {
    character.pose(play, play.duration_s * static_cast<float>(i) / 16);
    for (const auto& goal : reach.goals()) {
      const Affine& joint = character.model_from_joint(goal.skeleton)[goal.joint];
      double squared = 0;
      for (std::size_t c = 0; c < 3; ++c)
        squared += std::pow(static_cast<double>(joint.rows[c][3]) - static_cast<double>(goal.position[c]), 2);
      worst = std::max(worst, std::sqrt(squared));
    }
  }
  return worst;
}

TEST(Reach, EverySolverBringsJointsToTheirGoals) {
  const auto model = cook_model(newt_glb());
  ASSERT_TRUE(model);
  tools::ReachArguments arguments;
  arguments.goals = {"hand.L=0.44,0.88,0.25", "hand.R=-0.44,0.88,0.25"};
  EXPECT_EQ(std::size(tools::kIkSolvers), 6u);
  for (const auto& [solver, method] : tools::kIkSolvers) {
    arguments.solver = method;
    EXPECT_LT(worst_distance(model->file, tools::Reach(model->file, arguments)), 1e-3) << solver;
  }
}

TEST(Reach, RefusesWhatItCannotRead) {
  const auto model = cook_model(newt_glb());
  ASSERT_TRUE(model);
  for (const char* goal : {"", "hand.L", "hand.L=", "hand.L=1,2", "hand.L=1,2,3,4", "hand.L=1,2,x", "hand.L=1,2,nan",
                           "hand.L=1,2,1e999", "=1,2,3", "hand=1,2,3", "pelvis=1,2,3", "spine_1=1,2,3"}) {
    tools::ReachArguments arguments;
    arguments.goals = {goal};
    try {
      const tools::Reach reach(model->file, arguments);
      FAIL() << goal;
    } catch (const tools::Failure& failure) {
      EXPECT_EQ(failure.code(), tools::Exit::usage) << goal;
    }
  }
}

}  // namespace
}  // namespace marrow::test
