// One form of mirrors: the same pose written in other ways is the same numbers, and no curve means anything else.
#include "cook/prepare/mirrors.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cook/scene/matrices.h"
#include "cook/scene/node_motion.h"
#include "support/rig.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

// Half turns about each axis, or none, and their matrices' diagonals: by these all ways to write one pose differ.
struct Way {
  glm::dquat turn;
  glm::dvec3 diagonal;
};
const Way kWays[] = {
    {{1, 0, 0, 0}, {1, 1, 1}}, {{0, 1, 0, 0}, {1, -1, -1}}, {{0, 0, 1, 0}, {-1, 1, -1}}, {{0, 0, 0, 1}, {-1, -1, 1}}};

double distance(const glm::dmat4& a, const glm::dmat4& b) {
  double out = 0;
  for (int c = 0; c < 4; ++c) out = std::max(out, glm::length(a[c] - b[c]));
  return out;
}

RawNode random_node(test::Random& random) {
  const auto q = random.rotation();
  RawNode node;
  node.rotation = glm::dquat(q[3], q[0], q[1], q[2]);
  for (int i = 0; i < 3; ++i) {
    node.translation[i] = random.between(-1, 1);
    node.scale[i] = random.between(0.5, 2) * (random.below(2) == 0 ? -1 : 1);
  }
  return node;
}

TEST(Mirrors, OnePoseHasOneForm) {
  test::Random random(3);
  for (int i = 0; i < 100; ++i) {
    const RawNode node = random_node(random);
    const glm::dmat4 meant = local_matrix(node);
    RawScene scene;
    for (const Way& way : kWays) {
      RawNode& same = scene.nodes.emplace_back(node);
      same.moved_by_game = true;
      same.rotation = node.rotation * way.turn;
      same.scale = node.scale * way.diagonal;
      EXPECT_LT(distance(local_matrix(same), meant), 1e-12) << "as matrices multiply";
    }
    scene = with_one_form_of_mirrors(std::move(scene));
    for (const RawNode& same : scene.nodes) {
      EXPECT_LT(distance(local_matrix(same), meant), 1e-12) << i;
      EXPECT_EQ(same.scale, scene.nodes[0].scale);
      EXPECT_EQ(std::fabs(glm::dot(same.rotation, scene.nodes[0].rotation)), glm::dot(node.rotation, node.rotation));
      EXPECT_EQ(same.scale.x > 0, glm::determinant(glm::dmat3(meant)) > 0);
      EXPECT_GT(std::min(same.scale.y, same.scale.z), 0);
    }
  }
}

// A limit is about the joint's axes.
TEST(Mirrors, LimitsTurnAlong) {
  test::Random random(4);
  for (int i = 0; i < 100; ++i) {
    RawScene scene;
    RawNode& node = scene.nodes.emplace_back(random_node(random));
    node.moved_by_game = true;
    node.limit.emplace();
    node.limit->zero_is_given = true;
    LimitDescription& d = node.limit->description;
    const auto zero = random.rotation();
    for (int c = 0; c < 4; ++c) d.zero[c] = static_cast<float>(zero[static_cast<std::size_t>(c)]);
    for (int c = 0; c < 3; ++c) d.axis[c] = static_cast<float>(random.between(-1, 1));
    const auto in_parent = [](const RawNode& n, const float(&v)[3]) {
      return n.rotation * glm::dvec3(v[0], v[1], v[2]);
    };
    const RawNode before = node;
    scene = with_one_form_of_mirrors(std::move(scene));
    const RawNode& after = scene.nodes[0];
    const LimitDescription &was = before.limit->description, &is = after.limit->description;
    EXPECT_LT(glm::length(in_parent(after, is.axis) - in_parent(before, was.axis)), 1e-6);
    EXPECT_LT(glm::length(in_parent(after, is.across) - in_parent(before, was.across)), 1e-6);
    const auto turned_by = [](const RawNode& n, const LimitDescription& l) {
      return n.rotation * glm::conjugate(glm::dquat(l.zero[3], l.zero[0], l.zero[1], l.zero[2]));
    };
    EXPECT_GT(std::fabs(glm::dot(turned_by(after, is), turned_by(before, was))), 1 - 1e-6) << "as far from zero";
  }
}

// Whatever keys do: signs that stay, that change, that come from 0 or never have one; in lines, steps and splines.
TEST(Mirrors, CurvesMeanTheSameAtEveryMoment) {
  test::Random random(5);
  int turned = 0;
  for (int i = 0; i < 400; ++i) {
    RawScene scene;
    scene.nodes.push_back(random_node(random));
    RawClip& clip = scene.clips.emplace_back();
    for (const RawPath path : {RawPath::rotation, RawPath::scale}) {
      if (random.below(4) == 0) continue;
      RawChannel channel{0, path, static_cast<RawInterpolation>(random.below(3)), {}, {}};
      const bool cubic = channel.interpolation == RawInterpolation::cubic_spline, steady = random.below(2) == 0;
      const RawNode first = random_node(random);
      for (int k = 0; k < 3; ++k) {
        channel.times_s.push_back(0.5f * static_cast<float>(k) + (path == RawPath::scale ? 0.1f : 0));
        for (int part = 0; part < (cubic ? 3 : 1); ++part) {
          const RawNode node = random_node(random);
          glm::vec4& key = channel.values.emplace_back(glm::vec4(glm::abs(node.scale) * glm::sign(first.scale), 0));
          if (!steady) key = glm::vec4(glm::vec3(node.scale), 0);
          if (!steady && random.below(3) == 0) key[static_cast<int>(random.below(3))] = 0;
          if (path == RawPath::rotation)
            key = glm::vec4(node.rotation.x, node.rotation.y, node.rotation.z, node.rotation.w);
        }
      }
      clip.channels.push_back(std::move(channel));
    }
    RawScene after = with_one_form_of_mirrors(scene);
    const NodeMotion was(scene, scene.clips[0], {0}), is(after, after.clips[0], {0});
    for (int t = 0; t <= 24; ++t) {
      const float time_s = 0.05f * static_cast<float>(t);
      EXPECT_LT(distance(was.at(time_s)[0], is.at(time_s)[0]), 2e-5) << i << " at " << time_s;
    }
    turned += after.nodes[0].scale != scene.nodes[0].scale;
  }
  EXPECT_GT(turned, 200);
}

// A bone mirrored in z, or in x and turned half about y, at rest and in two clips: between them nothing is flat.
TEST(Mirrors, OnePoseWrittenTwoWaysBlendsToItself) {
  SceneDocument d;
  const std::vector<int> joints = d.character("Ada", 0);
  d.b.root["nodes"][static_cast<std::size_t>(joints[1])]["scale"] = {1, 1, -1};
  d.clip("z");
  d.keys(joints[1], "scale", {0, 1}, {1, 1, -1, 1, 1, -1});
  d.clip("x");
  d.keys(joints[1], "scale", {0, 1}, {-1, 1, 1, -1, 1, 1});
  d.keys(joints[1], "rotation", {0, 1}, {0, 1, 0, 0, 0, 1, 0, 0});
  for (const bool raw : {false, true}) {
    const LoadedCook cooked(cook_scene(d.read(), options_of(raw ? "--clip-codec raw" : "")));
    const Skeleton skeleton = cooked.file.skeleton(0);
    std::vector<SoaTransform> z(skeleton.soa_size()), x(z), mixed(z);
    ASSERT_EQ(sample(skeleton, cooked.file.clip(0), 0.5f, z), Status::ok);
    ASSERT_EQ(sample(skeleton, cooked.file.clip(1), 0.5f, x), Status::ok);
    const BlendLayer layers[] = {{z, 0.5f, {}}, {x, 0.5f, {}}};
    ASSERT_EQ(blend(skeleton, layers, mixed), Status::ok);
    std::vector<Affine> at_rest(skeleton.joint_count), blended(skeleton.joint_count);
    ASSERT_EQ(local_to_model(skeleton, {skeleton.rest, skeleton.soa_size()}, at_rest), Status::ok);
    ASSERT_EQ(local_to_model(skeleton, mixed, blended), Status::ok);
    for (std::size_t j = 0; j < skeleton.joint_count; ++j)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) EXPECT_NEAR(blended[j].rows[r][c], at_rest[j].rows[r][c], 1e-5f) << j;
  }
}

}  // namespace
}  // namespace marrow::cook
