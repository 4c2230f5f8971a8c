// What `marrow view` shows beyond `marrow render`: a blend of two clips, and the weights of a joint.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "gl/support/models.h"
#include "marrow/skin.h"
#include "pose/evaluate.h"
#include "render/heat.h"

namespace marrow::test {
namespace {

using tools::Character;
using tools::PlayLayer;

class CharacterTest : public ::testing::Test {
 protected:
  CharacterTest() : model_(*cook_model(model_paths().front())) {}
  const File& file() const { return model_.file; }
  tools::Play clip(const char* name) const { return tools::play_together(file(), file().find_clip(name)); }

  Model model_;
};

std::vector<float> root_place(const Character& character) {
  const Affine& root = character.model_from_joint(0)[0];
  return {root.rows[0][3], root.rows[1][3], root.rows[2][3]};
}

TEST_F(CharacterTest, ABlendIsBetweenItsClips) {
  Character character(file());
  const tools::Play walk = clip("walk"), reach = clip("reach");
  character.pose(walk, 0.3f);
  const std::vector<float> a = root_place(character);
  const std::vector<Affine> alone(character.model_from_joint(0).begin(), character.model_from_joint(0).end());
  character.pose(reach, 1.5f);
  const std::vector<float> b = root_place(character);
  for (const float weight : {0.0f, 0.25f, 1.0f}) {
    const PlayLayer layers[] = {{walk, 0.3f, 1 - weight}, {reach, 1.5f, weight}};
    character.pose(layers);
    const std::vector<float> mixed = root_place(character);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mixed[c], (1 - weight) * a[c] + weight * b[c], 1e-6f) << weight;
  }
  // Of two equal layers the blend is either.
  const PlayLayer same[] = {{walk, 0.3f, 0.4f}, {walk, 0.3f, 0.6f}};
  character.pose(same);
  for (std::size_t j = 0; j < alone.size(); ++j)
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        EXPECT_NEAR(character.model_from_joint(0)[j].rows[row][column], alone[j].rows[row][column], 1e-5f) << j;
}

// A joint that alone moves by a metre takes each vertex along by its weight.
TEST_F(CharacterTest, WeightsAreHowFarAJointTakesVertices) {
  const Mesh mesh = file().mesh(0);
  std::vector<float> sum(mesh.geometry.slot_count, 0);
  std::vector<float> before(3 * sum.size()), after(before.size());
  std::vector<Affine> palette(mesh.palette_size(), Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  ASSERT_EQ(skin_ssd(mesh, palette, {.positions = before, .normals = {}, .tangents = {}}), Status::ok);
  for (std::uint32_t entry = 0; entry < mesh.joint_count; ++entry) {
    std::vector<Affine> moved = palette;
    moved[entry].rows[1][3] = 1;
    ASSERT_EQ(skin_ssd(mesh, moved, {.positions = after, .normals = {}, .tangents = {}}), Status::ok);
    const std::vector<float> weights = tools::joint_weights(mesh, mesh.joints[entry]);
    ASSERT_EQ(weights.size(), sum.size());
    for (std::size_t slot = 0; slot < sum.size(); ++slot) {
      ASSERT_NEAR(weights[slot], after[3 * slot + 1] - before[3 * slot + 1], 1e-6f) << entry << " " << slot;
      sum[slot] += weights[slot];
    }
  }
  for (const float s : sum) ASSERT_NEAR(s, 1, 1e-5f);
}

TEST_F(CharacterTest, AHelpersWeightIsItsJointsInShares) {
  Mesh mesh = file().mesh(0);
  ASSERT_GE(mesh.joint_count, 3u);
  const std::uint32_t last = mesh.joint_count - 1;
  const std::vector<float> first = tools::joint_weights(mesh, mesh.joints[0]);
  const std::vector<float> second = tools::joint_weights(mesh, mesh.joints[1]);
  const std::vector<float> third = tools::joint_weights(mesh, mesh.joints[last]);
  // The last entry as if it were a helper between the first two.
  const Helper helper = {0, 1, 0.25f};
  mesh.joint_count = last;
  mesh.helpers = {&helper, 1};
  const std::vector<float> firsts = tools::joint_weights(mesh, mesh.joints[0]);
  const std::vector<float> seconds = tools::joint_weights(mesh, mesh.joints[1]);
  float most = 0;
  for (std::size_t slot = 0; slot < first.size(); ++slot) {
    ASSERT_NEAR(firsts[slot], first[slot] + 0.75f * third[slot], 1e-6f);
    ASSERT_NEAR(seconds[slot], second[slot] + 0.25f * third[slot], 1e-6f);
    most = std::max(most, third[slot]);
  }
  EXPECT_GT(most, 0.5f) << "there is something to share";
}

}  // namespace
}  // namespace marrow::test
