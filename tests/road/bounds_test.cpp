// Bounds of clips and meshes: nothing is outside them, by the reference evaluator and by every deformer, and they are
// hardly larger than they must be.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include <gtest/gtest.h>

#include "marrow/bounds.h"
#include "road/cooked.h"
#include "road/models.h"
#include "road/reference.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

constexpr int kMomentsOfBounds = 40;
// Codes have seven bits and are rounded outwards on both sides; what a fast stroke does between two of the moments that
// are looked at here is in the bounds too.
constexpr double kMostLoose = 0.06;

struct Box {
  Vec3 least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
  void add(const Vec3& p) {
    for (std::size_t c = 0; c < 3; ++c) {
      least[c] = std::min(least[c], p[c]);
      most[c] = std::max(most[c], p[c]);
    }
  }
};

struct Found {
  std::size_t clips = 0, vertices = 0;
  double outside = 0, loose = 0;  // shares of the diagonal; of a box's largest coordinate
};

Vec3 corner(const float (&v)[3]) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

double beyond(const Vec3& p, const Bounds& b) {
  double most = 0, squared = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto axis = static_cast<int>(c);
    most = std::max({most, static_cast<double>(b.box_min[c]) - p[c], p[c] - static_cast<double>(b.box_max[c])});
    squared += std::pow(p[c] - static_cast<double>(b.centre(axis)), 2);
  }
  return std::max(most, std::sqrt(squared) - static_cast<double>(b.radius_m));
}

// One clip and mesh, by the runtime's deformers.
void check_mesh(const File& file, std::uint32_t clip, std::uint32_t m, double diagonal, Random& random, Found& found) {
  const Bounds b = file.bounds(clip, m);
  ASSERT_FALSE(b.is_empty());
  for (int i = 0; i < kMomentsOfBounds / 4; ++i) {
    const auto time_s = static_cast<float>(random.between(0, 1)) * file.clip(clip).duration_s;
    for (const Deformer deformer : {Deformer::ssd, Deformer::as}) {
      const PosedMesh posed = pose_mesh(file, clip, time_s, m, deformer);
      for (std::size_t v = 0; v < posed.positions.size(); v += 3, ++found.vertices) {
        const Vec3 p = {static_cast<double>(posed.positions[v]), static_cast<double>(posed.positions[v + 1]),
                        static_cast<double>(posed.positions[v + 2])};
        found.outside = std::max(found.outside, beyond(p, b) / diagonal);
      }
    }
  }
}

// All meshes of an animation together, by the reference; false if one of them has no bounds because it stands still.
bool check_animation(const Reference& reference, std::size_t animation, const Cooked& cooked, std::uint32_t first,
                     std::uint32_t behind, Found& found) {
  Box promised, seen;
  double largest = 0;
  for (std::uint32_t m = 0; m < cooked.file().mesh_count(); ++m) {
    Bounds b;
    for (std::uint32_t c = first; c < behind && b.is_empty(); ++c) b = cooked.file().bounds(c, m);
    if (b.is_empty()) return false;
    promised.add(corner(b.box_min));
    promised.add(corner(b.box_max));
  }
  for (std::size_t c = 0; c < 3; ++c)
    largest = std::max({largest, std::fabs(promised.least[c]), std::fabs(promised.most[c])});
  const std::vector<bool> used = cooked.pose(first, 0, Deformer::ssd).used;
  const double duration_s = reference.duration_s(animation);
  for (int i = 0; i <= 4 * kMomentsOfBounds; ++i) {
    const ReferencePose pose = reference.at(animation, duration_s * i / (4 * kMomentsOfBounds));
    for (std::size_t v = 0; v < pose.positions.size(); ++v)
      if (reference.comparable(v) && used[v]) seen.add(pose.positions[v]);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    found.outside = std::max({found.outside, (promised.least[c] - seen.least[c]) / reference.diagonal(),
                              (seen.most[c] - promised.most[c]) / reference.diagonal()});
    found.loose = std::max(
        {found.loose, (seen.least[c] - promised.least[c]) / largest, (promised.most[c] - seen.most[c]) / largest});
  }
  return true;
}

class BoundsOfClips : public ::testing::TestWithParam<std::string> {};

TEST_P(BoundsOfClips, HoldEveryVertexAndHardlyMore) {
  const Reference reference(GetParam());
  const Cooked cooked(GetParam());
  const File& file = cooked.file();
  Random random(7);
  Found found;
  std::uint32_t clip = 0;
  for (std::size_t a = 0; a < reference.source().animations.size(); ++a) {
    const SourceAnimation& animation = reference.source().animations[a];
    if (animation.channels.empty() && animation.weights.empty()) continue;
    ASSERT_LT(clip, file.clip_count());
    const std::uint32_t behind = next_animation(file, clip);
    if (a < 12) {
      found.clips += check_animation(reference, a, cooked, clip, behind, found);
      for (std::uint32_t c = clip; c < behind; ++c)
        for (std::uint32_t m = 0; m < file.mesh_count(); ++m)
          if (file.mesh(m).skeleton == file.clip(c).skeleton)
            check_mesh(file, c, m, reference.diagonal(), random, found);
    }
    clip = behind;
  }
  EXPECT_LE(found.outside, 1e-5);
  EXPECT_LE(found.loose, kMostLoose);
  EXPECT_EQ(found.vertices > 0, clip > 0 && file.mesh_count() > 0);
  std::printf("%-28s %3zu clips whole %9zu vertices  outside %8.1e of the diagonal, loose %.4f of the farthest\n",
              std::filesystem::path(GetParam()).filename().c_str(), found.clips, found.vertices, found.outside,
              found.loose);
}

INSTANTIATE_TEST_SUITE_P(Models, BoundsOfClips, ::testing::ValuesIn(models()),
                         [](const ::testing::TestParamInfo<std::string>& model) {
                           std::string name = std::filesystem::path(model.param).stem().string();
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name + "_" + std::to_string(model.index);
                         });

}  // namespace
}  // namespace marrow::test
