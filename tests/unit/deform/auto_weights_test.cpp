// Weights from bones: by hand arithmetic, by symmetry, against distances measured without the code under test.
#include "deform/weights/auto_weights.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "deform/weights/edit_weights.h"
#include "deform/weights/voxels.h"
#include "unit/deform/shapes.h"

namespace marrow::deform {
namespace {

struct Shape {
  Positions positions;
  std::vector<std::uint32_t> indices;
};

// The surface of a box, `n` squares along each side of each face, vertices of each face its own; without its face at
// +y if it is open.
void add_box(const glm::dvec3& low, const glm::dvec3& high, int n, Shape& shape, bool open = false) {
  for (int face = 0; face < 6; ++face) {
    const int w = face % 3, u = (w + 1) % 3, v = (w + 2) % 3;
    if (open && face == 4) continue;
    const auto first = static_cast<std::uint32_t>(shape.positions.size()), row = static_cast<std::uint32_t>(n + 1);
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        glm::dvec3 p(0);
        p[w] = face < 3 ? low[w] : high[w];
        p[u] = low[u] + (high[u] - low[u]) * i / n;
        p[v] = low[v] + (high[v] - low[v]) * j / n;
        shape.positions.push_back(p);
      }
    }
    for (std::uint32_t i = 0; i + 1 < row; ++i) {
      for (std::uint32_t j = 0; j + 1 < row; ++j) {
        const std::uint32_t a = first + i * row + j, b = a + row, c = b + 1, d = a + 1;
        const std::array<std::uint32_t, 6> out = {a, b, c, a, c, d}, in = {a, c, b, a, d, c};
        const auto& corners = face < 3 ? in : out;
        shape.indices.insert(shape.indices.end(), corners.begin(), corners.end());
      }
    }
  }
}

double weight_of(const std::vector<Influence>& influences, std::uint32_t joint) {
  for (const Influence& i : influences)
    if (i.joint == joint) return i.weight;
  return 0;
}

void expect_sound(const AutoWeights& weights, std::size_t vertices, std::size_t most = 4) {
  ASSERT_EQ(weights.influences.size(), vertices);
  for (const std::vector<Influence>& influences : weights.influences) {
    ASSERT_FALSE(influences.empty());
    ASSERT_LE(influences.size(), most);
    double sum = 0;
    for (std::size_t i = 0; i < influences.size(); ++i) {
      ASSERT_GT(influences[i].weight, 0);  // no NaN either
      if (i > 0) {
        ASSERT_GT(influences[i].joint, influences[i - 1].joint);
      }
      sum += influences[i].weight;
    }
    ASSERT_EQ(sum, 1.0);
  }
}

constexpr WeightMethod kAll[] = {WeightMethod::nearest, WeightMethod::gaussian, WeightMethod::geodesic,
                                 WeightMethod::glow};

TEST(AutoWeights, NearestIsByInverseDistance) {
  // From (0, 0, 0): 1 to the first bone's side, 3 to the second's end, 4 to the third, a point.
  const std::vector<Bone> bones = {{2, {1, -5, 0}, {1, 5, 0}}, {5, {0, 3, 0}, {0, 9, 0}}, {7, {0, 0, -4}, {0, 0, -4}}};
  const AutoWeights all = auto_weights({{0, 0, 0}}, {}, bones, {.method = WeightMethod::nearest});
  expect_sound(all, 1);
  const double sum = 1.0 + 1.0 / 3 + 1.0 / 4;
  EXPECT_NEAR(weight_of(all.influences[0], 2), 1 / sum, 1e-9);
  EXPECT_NEAR(weight_of(all.influences[0], 5), 1 / sum / 3, 1e-9);
  EXPECT_NEAR(weight_of(all.influences[0], 7), 1 / sum / 4, 1e-9);
  const AutoWeights two = auto_weights({{0, 0, 0}}, {}, bones, {.method = WeightMethod::nearest, .most = 2});
  EXPECT_NEAR(weight_of(two.influences[0], 2), 0.75, 1e-9);
  EXPECT_NEAR(weight_of(two.influences[0], 5), 0.25, 1e-9);
}

// Bones of length 2, at 0.5 and 1 from the vertex: their weights are as exp(-α/16) to exp(-α/4).
TEST(AutoWeights, GaussianIsByTheBonesLength) {
  const std::vector<Bone> bones = {{0, {-1, 0.5, 0}, {1, 0.5, 0}}, {1, {-1, -1, 0}, {1, -1, 0}}};
  const AutoWeights weights = auto_weights({{0, 0, 0}}, {}, bones, {.method = WeightMethod::gaussian});
  expect_sound(weights, 1);
  const double ratio = weight_of(weights.influences[0], 1) / weight_of(weights.influences[0], 0);
  EXPECT_NEAR(ratio, std::exp(-kGaussianAlpha * 3 / 16), 1e-8);
}

// Two bars that hang side by side from a third, as arm and leg do, 0.5 apart; bones along their middles. Straight
// through the air, the left bar's right side is 0.5 from its own bone and 1 from the other's; through the mesh the
// other's is at least twice as far as the bars' top is.
TEST(AutoWeights, AHandDoesNotBindToTheThighBesideIt) {
  Shape shape;
  add_box({0, 0, 0}, {1, 10, 1}, 20, shape);
  add_box({1.5, 0, 0}, {2.5, 10, 1}, 20, shape);
  add_box({0, 9, 0}, {2.5, 10, 1}, 20, shape);
  const std::vector<Bone> bones = {{0, {0.5, 9.5, 0.5}, {0.5, 0.5, 0.5}}, {1, {2, 9.5, 0.5}, {2, 0.5, 0.5}}};
  const AutoWeights near = auto_weights(shape.positions, shape.indices, bones, {.method = WeightMethod::nearest});
  const AutoWeights through = auto_weights(shape.positions, shape.indices, bones);
  const AutoWeights lit = auto_weights(shape.positions, shape.indices, bones, {.method = WeightMethod::glow});
  expect_sound(through, shape.positions.size());
  expect_sound(lit, shape.positions.size());
  EXPECT_TRUE(through.unreached.empty());
  EXPECT_TRUE(lit.unreached.empty());
  std::size_t seen = 0;
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const glm::dvec3& p = shape.positions[v];
    if (p.y > 5) continue;
    ++seen;
    const std::uint32_t other = p.x > 1.25 ? 0 : 1;
    if (p.x == 1 && std::abs(p.z - 0.5) < 1e-9 && p.y >= 0.5) {
      EXPECT_NEAR(weight_of(near.influences[v], other), 1.0 / 3, 1e-9);
    }
    // 4 to where the bars meet and back down, against less than 1: (1/8)² even where weights fall off with d⁻² only.
    EXPECT_LT(weight_of(through.influences[v], other), 1.0 / 64) << p.x << ' ' << p.y << ' ' << p.z;
    EXPECT_LT(weight_of(lit.influences[v], other), 1.0 / 64) << p.x << ' ' << p.y << ' ' << p.z;
  }
  EXPECT_GT(seen, 500u);
}

// A bar with a joint in its middle: mirrored vertices have mirrored weights, and in the middle the joints share.
TEST(AutoWeights, ASymmetricMeshGetsSymmetricWeights) {
  Shape shape;
  add_box({-0.5, -0.5, -5}, {0.5, 0.5, 5}, 40, shape);
  const std::vector<Bone> bones = {{0, {0, 0, -5}, {0, 0, 0}}, {1, {0, 0, 0}, {0, 0, 5}}};
  for (const WeightMethod method : kAll) {
    const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones, {.method = method});
    expect_sound(weights, shape.positions.size());
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
      const glm::dvec3 mirrored = shape.positions[v] * glm::dvec3(1, 1, -1);
      const double own = weight_of(weights.influences[v], 0);
      if (shape.positions[v].z == 0) {
        EXPECT_NEAR(own, 0.5, 1e-6);
      }
      if (shape.positions[v].z < -2) {
        EXPECT_GT(own, 0.75);
      }
      for (std::size_t w = 0; w < shape.positions.size(); ++w) {
        if (shape.positions[w] == mirrored) {
          EXPECT_NEAR(weight_of(weights.influences[w], 1), own, 1e-6);
        }
      }
    }
  }
}

// ∫ sine × cosine / r² ds by small steps: how the paper's idea reads, without anything in the way.
double light_by_steps(const Bone& bone, const glm::dvec3& p, const glm::dvec3& normal) {
  constexpr int kSteps = 20000;
  const glm::dvec3 along = bone.to - bone.from;
  const double length = glm::length(along);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const glm::dvec3 way = bone.from + along * ((i + 0.5) / kSteps) - p;
    const double r = glm::length(way);
    const double sine = glm::length(glm::cross(along, way)) / (length * r);
    sum += sine * std::max(-glm::dot(normal, way) / r, 0.0) / (r * r) * (length / kSteps);
  }
  return sum;
}

// Vertices in the middles of faces, bones in the mesh at will; one joint has two of them.
TEST(AutoWeights, GlowIsTheLightThatReachesAVertex) {
  Shape shape;
  add_box({-4, -4, -4}, {4, 4, 4}, 2, shape);
  const std::vector<Bone> bones = {{3, {-1, 1, 2}, {2, 0, -1}}, {1, {0, 3, 1}, {1, -3, 2}}, {1, {2, 2, 2}, {3, 3, 0}}};
  const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones, {.method = WeightMethod::glow});
  expect_sound(weights, shape.positions.size());
  EXPECT_TRUE(weights.unlit.empty());
  int checked = 0;
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const glm::dvec3 p = shape.positions[v], normal = p / 4.0;
    if (std::abs(glm::length(p) - 4) > 1e-9) continue;
    const double a = light_by_steps(bones[0], p, normal);
    const double b = light_by_steps(bones[1], p, normal) + light_by_steps(bones[2], p, normal);
    EXPECT_NEAR(weight_of(weights.influences[v], 3), a * a / (a * a + b * b), 2e-3);
    ++checked;
  }
  EXPECT_EQ(checked, 6);
}

// A mesh whose triangles all face inwards is as if they did not.
TEST(AutoWeights, GlowTakesAMeshInsideOut) {
  Shape shape;
  add_box({0, 0, 0}, {1, 4, 1}, 8, shape);
  const std::vector<Bone> bones = {{0, {0.5, 0.5, 0.5}, {0.5, 2, 0.5}}, {1, {0.5, 2, 0.5}, {0.5, 3.5, 0.5}}};
  const AutoWeightOptions options = {.method = WeightMethod::glow, .resolution = 64};
  const AutoWeights expected = auto_weights(shape.positions, shape.indices, bones, options);
  for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) std::swap(shape.indices[i], shape.indices[i + 1]);
  const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones, options);
  EXPECT_TRUE(expected.unlit.empty());
  EXPECT_TRUE(weights.unlit.empty());
  for (std::size_t v = 0; v < shape.positions.size(); ++v)
    EXPECT_NEAR(weight_of(weights.influences[v], 0), weight_of(expected.influences[v], 0), 1e-6);
}

// Round two corners from a bone, at the far end of a U, nothing shines; the way through the mesh leads there.
TEST(AutoWeights, DarkVerticesGoByTheWayThroughTheMesh) {
  Shape shape;
  add_box({0, 0, 0}, {1, 10, 1}, 10, shape);
  add_box({3, 0, 0}, {4, 10, 1}, 10, shape);
  add_box({0, 9, 0}, {4, 10, 1}, 10, shape);
  const std::vector<Bone> bones = {{0, {0.5, 0.5, 0.5}, {0.5, 2, 0.5}}, {1, {0.5, 2, 0.5}, {0.5, 4, 0.5}}};
  const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones, {.method = WeightMethod::glow});
  const AutoWeights geodesic = auto_weights(shape.positions, shape.indices, bones);
  expect_sound(weights, shape.positions.size());
  EXPECT_TRUE(weights.unreached.empty());
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    if (shape.positions[v].x < 3 || shape.positions[v].y > 8) continue;
    EXPECT_TRUE(std::ranges::binary_search(weights.unlit, v));
    EXPECT_EQ(weight_of(weights.influences[v], 1), weight_of(geodesic.influences[v], 1));
  }
}

// Voxels that a line goes through: the ones at the middles of its parts between planes of faces.
TEST(Voxels, SeeAlongLinesThatStayInside) {
  std::mt19937 random(11);
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Shape shape;
  add_box({0, 0, 0}, {1, 1, 4}, 1, shape);
  add_box({0, 0, 3}, {4, 1, 4}, 1, shape);
  const Voxels voxels(shape.positions, shape.indices, 24);
  std::array<int, 2> counts = {};
  for (int i = 0; i < 4000; ++i) {
    const auto place = [&] {
      const bool upper = share() < 0.5;
      return voxels.to_grid(upper ? glm::dvec3(4 * share(), share(), 3 + share())
                                  : glm::dvec3(share(), share(), 4 * share()));
    };
    const glm::dvec3 from = place(), to = place();
    std::vector<double> cuts = {0, 1};
    for (int axis = 0; axis < 3; ++axis)
      for (double plane = 0; plane < voxels.size()[axis]; ++plane)
        if ((plane - from[axis]) * (plane - to[axis]) < 0)
          cuts.push_back((plane - from[axis]) / (to[axis] - from[axis]));
    std::ranges::sort(cuts);
    bool expected = true;
    for (std::size_t c = 1; c < cuts.size(); ++c)
      expected &= voxels.solid(voxels.cell_at(from + (to - from) * ((cuts[c - 1] + cuts[c]) / 2)));
    EXPECT_EQ(voxels.sees(from, to), expected);
    ++counts[expected ? 1 : 0];
  }
  EXPECT_GT(counts[0], 200);
  EXPECT_GT(counts[1], 200);
  EXPECT_FALSE(voxels.sees({-5, 3, 3}, {3, 3, 3}));
  EXPECT_FALSE(voxels.sees({3, 3, 3}, {3, 3, 1e30}));
}

// In a convex mesh the way through it is the straight one: which joint is nearest is as measured by brute force, but
// for what steps between voxels' centres add, at most 14 % (26 neighbours).
TEST(AutoWeights, InAConvexMeshTheNearestJointWins) {
  Shape shape;
  add_box({-1, -1, -1}, {1, 1, 1}, 16, shape);
  std::mt19937 random(7);
  std::vector<Bone> bones;
  const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.0 * 1.6 - 0.8; };
  for (std::uint32_t j = 0; j < 12; ++j) {
    const glm::dvec3 p(coordinate(), coordinate(), coordinate());
    bones.push_back({j, p, p});
  }
  const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones, {.resolution = 64});
  expect_sound(weights, shape.positions.size());
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    const auto largest = std::max_element(weights.influences[v].begin(), weights.influences[v].end(),
                                          [](const Influence& a, const Influence& b) { return a.weight < b.weight; });
    double least = 1e300;
    for (const Bone& bone : bones) least = std::min(least, glm::length(bone.from - shape.positions[v]));
    EXPECT_LT(glm::length(bones[largest->joint].from - shape.positions[v]), least * 1.14 + 0.1);
  }
}

// Without its lid the flood runs in, and a bone in the middle would be cut off; five of six directions still say
// inside.
TEST(AutoWeights, AnOpenMeshIsSolidAllTheSame) {
  Shape shut, open;
  add_box({0, 0, 0}, {1, 4, 1}, 12, shut);
  add_box({0, 0, 0}, {1, 4, 1}, 12, open, true);
  const std::vector<Bone> bones = {{0, {0.5, 0.5, 0.5}, {0.5, 2, 0.5}}, {1, {0.5, 2, 0.5}, {0.5, 3.5, 0.5}}};
  const AutoWeights expected = auto_weights(shut.positions, shut.indices, bones, {.resolution = 96});
  const AutoWeights weights = auto_weights(open.positions, open.indices, bones, {.resolution = 96});
  expect_sound(weights, open.positions.size());
  EXPECT_TRUE(weights.unreached.empty());
  for (std::size_t v = 0, w = 0; v < open.positions.size(); ++v, ++w) {
    while (shut.positions[w] != open.positions[v]) ++w;
    EXPECT_NEAR(weight_of(weights.influences[v], 0), weight_of(expected.influences[w], 0), 0.02);
  }
}

// A box far from the bones' own is reached by no path; its vertices go by plain distance.
TEST(AutoWeights, PiecesWithoutBonesGoByDistance) {
  Shape shape;
  add_box({0, 0, 0}, {1, 1, 1}, 4, shape);
  const std::size_t first_of_other = shape.positions.size();
  add_box({3, 0, 0}, {4, 1, 1}, 4, shape);
  const std::vector<Bone> bones = {{0, {0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, {1, {0.9, 0.5, 0.5}, {0.9, 0.5, 0.5}}};
  const AutoWeights weights = auto_weights(shape.positions, shape.indices, bones);
  expect_sound(weights, shape.positions.size());
  EXPECT_EQ(weights.unreached.size(), shape.positions.size() - first_of_other);
  for (std::size_t v = first_of_other; v < shape.positions.size(); ++v) {
    const double a = glm::length(shape.positions[v] - bones[0].from),
                 b = glm::length(shape.positions[v] - bones[1].from);
    EXPECT_NEAR(weight_of(weights.influences[v], 1), a / (a + b), 1e-9);
  }
}

TEST(AutoWeights, BadInputGivesSoundWeights) {
  const Bone bone{3, {0, 0, 0}, {0, 1, 0}};
  const std::vector<Bone> one_point = {{0, {1, 1, 1}, {1, 1, 1}}, {1, {1, 1, 1}, {1, 1, 1}}, {2, {1, 1, 1}, {1, 1, 1}}};
  const std::vector<Bone> far = {{0, {1e29, 0, 0}, {1e29, 1, 0}}, {1, {0, -1e29, 0}, {0, 0, -1e29}}};
  const std::vector<Bone> many(20, bone);
  Shape cube;
  add_box({0, 0, 0}, {1, 1, 1}, 3, cube);
  const Shape points{{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}}, {}};
  const Shape flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {0, 1, 2, 0, 0, 0, 3, 3, 1}};  // no area
  const Shape one_place{{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {0, 1, 2}};
  const Shape huge{{{-1e30, 0, 0}, {1e30, 0, 0}, {0, 1e30, 1e30}, {0, 0, 0}}, {0, 1, 2, 0, 1, 3}};
  const Shape tiny{{{0, 0, 0}, {1e-45, 0, 0}, {0, 1e-45, 0}}, {0, 1, 2}};
  for (const Shape* const shape : {static_cast<const Shape*>(&cube), &points, &flat, &one_place, &huge, &tiny}) {
    for (const std::vector<Bone>& bones : {std::vector<Bone>{bone}, one_point, far, many}) {
      for (const WeightMethod method : kAll)
        expect_sound(auto_weights(shape->positions, shape->indices, bones, {.method = method, .resolution = 48}),
                     shape->positions.size());
    }
  }
  const AutoWeights shared = auto_weights(cube.positions, cube.indices, one_point);
  for (const std::vector<Influence>& influences : shared.influences) {
    ASSERT_EQ(influences.size(), 3u);
    for (const Influence& i : influences) EXPECT_NEAR(i.weight, 1.0 / 3, 1e-9);
  }
  EXPECT_TRUE(auto_weights({}, {}, many).influences.empty());
}

// Triangles at random, no two of which agree on what is inside.
TEST(AutoWeights, ASoupOfTrianglesGetsSoundWeights) {
  std::mt19937 random(3);
  const auto coordinate = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Shape soup;
  for (std::uint32_t i = 0; i < 300; ++i) {
    soup.positions.emplace_back(coordinate(), coordinate(), coordinate());
    soup.indices.push_back(i);
  }
  const std::vector<Bone> bones = {{0, {0.2, 0.2, 0.2}, {0.5, 0.5, 0.5}}, {1, {0.5, 0.5, 0.5}, {2, 2, 2}}};
  for (const WeightMethod method : kAll)
    expect_sound(auto_weights(soup.positions, soup.indices, bones, {.method = method, .resolution = 96}),
                 soup.positions.size());
}

TEST(AutoWeights, TheSameEveryTime) {
  Shape shape;
  add_box({0, 0, 0}, {1, 3, 1}, 30, shape);
  const std::vector<Bone> bones = {{0, {0.5, 0.5, 0.5}, {0.5, 1.5, 0.5}}, {1, {0.5, 1.5, 0.5}, {0.5, 3.5, 0.5}}};
  const AutoWeights first = auto_weights(shape.positions, shape.indices, bones, {.resolution = 64});
  const AutoWeights second = auto_weights(shape.positions, shape.indices, bones, {.resolution = 64});
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    ASSERT_EQ(first.influences[v].size(), second.influences[v].size());
    for (std::size_t i = 0; i < first.influences[v].size(); ++i)
      EXPECT_EQ(first.influences[v][i].weight, second.influences[v][i].weight);
  }
}

// 40 000 vertices and 60 bones: seconds at most, of which the machine may be short.
TEST(AutoWeights, ALargeMeshTakesSeconds) {
  Shape shape;
  add_box({0, 0, 0}, {1, 1, 1}, 81, shape);
  std::vector<Bone> bones;
  for (std::uint32_t j = 0; j < 60; ++j) bones.push_back({j, {0.5, j / 60.0, 0.5}, {0.5, (j + 1) / 60.0, 0.5}});
  ASSERT_GT(shape.positions.size(), 40000u);
  const auto start = std::chrono::steady_clock::now();
  expect_sound(auto_weights(shape.positions, shape.indices, bones), shape.positions.size());
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  RecordProperty("seconds", std::to_string(taken.count()));
  EXPECT_LT(taken.count(), 60);
}

TEST(KeepLargest, SumsToOneAndDropsWhatIsSmall) {
  std::vector<Influence> influences = {{9, 3}, {2, 5}, {4, 1}, {1, 1e-9}, {7, 0}};
  keep_largest(influences, 8, 1e-3);
  ASSERT_EQ(influences.size(), 3u);
  EXPECT_EQ(influences[0].joint, 2u);
  EXPECT_NEAR(influences[0].weight, 5.0 / 9, 1e-9);
  EXPECT_NEAR(influences[1].weight, 1.0 / 9, 1e-9);
  EXPECT_EQ(influences[0].weight + influences[1].weight + influences[2].weight, 1.0);
  keep_largest(influences, 1, 0);
  ASSERT_EQ(influences.size(), 1u);
  EXPECT_EQ(influences[0].weight, 1.0);
}

// One triangle: a step takes each vertex half of the way to the mean of the other two.
TEST(SmoothWeights, ATriangleByHand) {
  const Positions positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> indices = {0, 1, 2};
  std::vector<std::vector<Influence>> influences = {{{0, 1}}, {{1, 1}}, {{1, 1}}};
  smooth_weights(positions, indices, 1, influences);
  EXPECT_NEAR(weight_of(influences[0], 0), 0.5, 1e-9);
  EXPECT_NEAR(weight_of(influences[1], 0), 0.25, 1e-9);
  EXPECT_NEAR(weight_of(influences[2], 1), 0.75, 1e-9);
  smooth_weights(positions, indices, 1, influences);
  EXPECT_NEAR(weight_of(influences[0], 0), 0.25 + 0.125, 1e-9);
}

// Each face of the box has vertices of its own along its edges: smoothed they stay together.
TEST(SmoothWeights, SeamsStayClosed) {
  Shape shape;
  add_box({0, 0, 0}, {1, 1, 1}, 6, shape);
  std::vector<std::vector<Influence>> influences;
  std::mt19937 random(5);
  for (std::size_t v = 0; v < shape.positions.size(); ++v)
    influences.push_back({{static_cast<std::uint32_t>(random() % 5), 1}});
  smooth_weights(shape.positions, shape.indices, 3, influences);
  for (std::size_t v = 0; v < shape.positions.size(); ++v) {
    double sum = 0;
    for (const Influence& i : influences[v]) sum += i.weight;
    EXPECT_EQ(sum, 1.0);
    for (std::size_t w = 0; w < v; ++w) {
      if (shape.positions[v] != shape.positions[w]) continue;
      for (std::uint32_t j = 0; j < 5; ++j) EXPECT_EQ(weight_of(influences[v], j), weight_of(influences[w], j));
    }
  }
}

// What every vertex agrees on smoothing leaves alone; vertices without weights or without triangles do no harm.
TEST(SmoothWeights, NothingToSmooth) {
  Shape shape;
  add_box({0, 0, 0}, {1, 1, 1}, 2, shape);
  std::vector<std::vector<Influence>> influences(shape.positions.size(), {{1, 0.25}, {4, 0.75}});
  smooth_weights(shape.positions, shape.indices, 50, influences);
  for (const auto& vertex : influences) EXPECT_NEAR(weight_of(vertex, 1), 0.25, 1e-6);
  std::vector<std::vector<Influence>> alone = {{{2, 3}}, {}};
  smooth_weights({{0, 0, 0}, {9, 9, 9}}, {}, 2, alone);
  ASSERT_EQ(alone[0].size(), 1u);
  EXPECT_EQ(alone[0][0].weight, 1.0);
  EXPECT_TRUE(alone[1].empty());
}

}  // namespace
}  // namespace marrow::deform
