// Weights that are set, and the nearest of many places: by hand, and by looking at all of them.
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "deform/weights/edit_weights.h"
#include "deform/weights/places.h"

namespace marrow::deform {
namespace {

using Influences = std::vector<Influence>;

void expect_weights(const Influences& influences, const Influences& wanted) {
  ASSERT_EQ(influences.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_EQ(influences[i].joint, wanted[i].joint);
    EXPECT_NEAR(influences[i].weight, wanted[i].weight, 1e-9);
  }
}

TEST(SetWeights, OthersShareWhatIsLeft) {
  Influences weights = {{1, 0.5}, {4, 0.3}, {7, 0.2}};
  EXPECT_TRUE(set_weights(Influences{{4, 0.65}}, 8, weights));
  expect_weights(weights, {{1, 0.25}, {4, 0.65}, {7, 0.1}});
  EXPECT_TRUE(set_weights(Influences{{2, 0.5}, {4, 0}}, 8, weights));
  expect_weights(weights, {{1, 0.5 * 0.25 / 0.35}, {2, 0.5}, {7, 0.5 * 0.1 / 0.35}});
}

TEST(SetWeights, MoreThanOneIsScaledDown) {
  Influences weights = {{1, 1}};
  EXPECT_TRUE(set_weights(Influences{{2, 1}, {3, 0.25}}, 8, weights));
  expect_weights(weights, {{2, 0.8}, {3, 0.2}});
}

TEST(SetWeights, WithoutOthersTheGivenKeepAll) {
  Influences weights = {{1, 1}};
  EXPECT_TRUE(set_weights(Influences{{1, 0.25}}, 8, weights));
  expect_weights(weights, {{1, 1}});
  EXPECT_FALSE(set_weights(Influences{{1, 0}}, 8, weights)) << "none would be left";
  expect_weights(weights, {{1, 1}});
  EXPECT_FALSE(set_weights({}, 8, weights = {})) << "nothing of nothing";
}

TEST(SetWeights, TheLargestAreKept) {
  Influences weights = {{0, 0.4}, {1, 0.35}, {2, 0.25}};
  EXPECT_TRUE(set_weights(Influences{{5, 0.5}}, 3, weights));
  expect_weights(weights, {{0, 0.2 / 0.875}, {1, 0.175 / 0.875}, {5, 0.5 / 0.875}});
}

// Also of places that lie on one line, and that are the same.
TEST(PlaceTree, FindsWhatIsNearestOfAll) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coarse(0, 6);
  std::uniform_real_distribution<double> fine(-1, 7);
  int found = 0;
  for (const int count : {0, 1, 2, 3, 10, 400}) {
    Positions places;
    for (int i = 0; i < count; ++i)
      places.emplace_back(coarse(random), i % 3 == 0 ? 2 : coarse(random), coarse(random));
    const PlaceTree tree(places);
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 to = i % 2 == 0 ? glm::dvec3(fine(random), fine(random), fine(random))
                                       : glm::dvec3(coarse(random), coarse(random), coarse(random));
      const double within = i % 3 == 0 ? 0.5 : 20;
      std::size_t nearest = places.size();
      for (std::size_t p = 0; p < places.size(); ++p) {
        const double distance = glm::distance(places[p], to);
        if (distance <= within && (nearest == places.size() || distance < glm::distance(places[nearest], to)))
          nearest = p;
      }
      const auto got = tree.nearest(to, within);
      ASSERT_EQ(got.has_value(), nearest < places.size());
      if (!got) continue;
      EXPECT_EQ(got->index, nearest) << "the first of equals";
      EXPECT_EQ(got->distance, glm::distance(places[nearest], to));
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
}  // namespace marrow::deform
