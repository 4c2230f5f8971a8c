// Weights that clips move, against sums of weights and matrices in double precision, and by hand.
#include "cook/prepare/weights_over_time.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/failure.h"
#include "cook/options/options.h"
#include "cook/scene/node_motion.h"
#include "disk/cook_on_disk.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

constexpr double kHalfRoot = 0.70710678118654752;

// Joints `root`, below it `chest` at (0, 1, 0) and `pole` at (2, 0, 0), which turns by 90° about z within 2 s. A strip
// of vertices at x = 0 … 4, all on the chest. The clip's number `loose` goes from 0 to 1 in its first second.
RawScene strip(const std::string& channel = "loose", int numbers = 1) {
  RawScene out;
  out.source = "strip";
  out.nodes.resize(4);
  const char* const names[] = {"root", "chest", "pole", "body"};
  for (std::size_t i = 0; i < 4; ++i) out.nodes[i].name = names[i];
  out.nodes[1].parent = out.nodes[2].parent = 0;
  out.nodes[1].translation = {0, 1, 0};
  out.nodes[2].translation = {2, 0, 0};
  RawSkin skin;
  skin.joints = {0, 1, 2};
  for (const glm::dvec3& at : {glm::dvec3(0), glm::dvec3(0, 1, 0), glm::dvec3(2, 0, 0)}) {
    glm::dmat4 inverse(1);
    inverse[3] = glm::dvec4(-at, 1);
    skin.inverse_bind.push_back(inverse);
  }
  out.skins.push_back(skin);
  RawPrimitive p;
  p.pointer = "/meshes/0/primitives/0";
  for (int x = 0; x <= 4; ++x)
    for (int y = 0; y < 2; ++y) {
      p.positions.emplace_back(x, 1 - y, 0);
      p.influences.push_back({{1, 1.0F}});
    }
  for (std::uint32_t x = 0; x < 4; ++x)
    for (const std::uint32_t corner : {0U, 1U, 2U, 2U, 1U, 3U}) p.indices.push_back(2 * x + corner);
  out.meshes.push_back({"cape", {}, {p}});
  out.instances.push_back({3, 0, 0, {}, kNone});
  RawClip clip;
  clip.name = "wind";
  clip.channels.push_back({2,
                           RawPath::rotation,
                           RawInterpolation::linear,
                           {0, 2},
                           {{0, 0, 0, 1}, {0, 0, static_cast<float>(kHalfRoot), static_cast<float>(kHalfRoot)}}});
  for (int i = 0; i < numbers; ++i) {
    RawScalar scalar;
    scalar.name = numbers == 1 ? channel : channel + "[" + std::to_string(i) + "]";
    scalar.times_s = {0, 1};
    scalar.values = {0, static_cast<float>(i + 1) / static_cast<float>(numbers)};
    clip.scalars.push_back(scalar);
  }
  out.clips.push_back(clip);
  return out;
}

WeightsOverTime rule(int splines = 1, double radius_m = 0) {
  return {"loose", "chest", "pole", splines, radius_m, {"", ""}};
}

// model_from_mesh of a joint of the skin at a moment of the clip.
glm::dmat4 matrix(const RawScene& scene, std::size_t joint, float time_s) {
  const RawSkin& skin = scene.skins[0];
  return NodeMotion(scene, scene.clips[0], {skin.joints[joint]}).at(time_s)[0] * skin.inverse_bind[joint];
}

double apart(const glm::dmat4& a, const glm::dmat4& b) {
  double out = 0;
  for (int i = 0; i < 4; ++i) out = std::max(out, glm::length(a[i] - b[i]));
  return out;
}

TEST(WeightsOverTime, AllOfAJointGoesOverToTheOther) {
  Notes notes;
  const RawScene scene = weights_over_time(strip(), {rule()}, notes);
  EXPECT_TRUE(notes.warnings.empty());
  ASSERT_EQ(scene.skins[0].joints.size(), 4U);
  EXPECT_EQ(scene.nodes[static_cast<std::size_t>(scene.skins[0].joints[3])].name, "chest/loose");
  for (std::size_t v = 0; v < 10; ++v) EXPECT_EQ(weight_of(scene, v, 3), 1);
  EXPECT_LT(apart(matrix(scene, 3, 0), matrix(scene, 1, 0)), 1e-6) << "as the chest";
  EXPECT_LT(apart(matrix(scene, 3, 1), matrix(scene, 2, 1)), 1e-6) << "as the pole";
  EXPECT_LT(apart(matrix(scene, 3, 2), matrix(scene, 2, 2)), 1e-6) << "the channel's last value holds on";
  // At half a second: half of the way to a pole that has turned by 22.5°. The mean of two quaternions goes half-way.
  const glm::dmat4 half = matrix(scene, 3, 0.5F);
  EXPECT_NEAR(half[0][0], std::cos(M_PI / 16), 1e-6);
  EXPECT_NEAR(half[0][1], std::sin(M_PI / 16), 1e-6);
  // The chest's own place is the mean of where both take it.
  const glm::dvec4 chest(0, 1, 0, 1);
  const glm::dvec4 mean = 0.5 * (chest + matrix(scene, 2, 0.5F) * chest);
  EXPECT_LT(glm::length(half * chest - mean), 1e-6);
}

// Vertices of the upper edge are 0 … 4 from the chest, those of the lower one √(x² + 1).
TEST(WeightsOverTime, SplinesShareOutByDistance) {
  Notes notes;
  const RawScene scene = weights_over_time(strip("loose", 3), {rule(3)}, notes);
  ASSERT_EQ(scene.skins[0].joints.size(), 6U);
  const double farthest = std::sqrt(17.0);
  for (std::size_t v = 0; v < 10; ++v) {
    const double x = static_cast<double>(v / 2), y = static_cast<double>(v % 2);
    const double place = 2 * std::sqrt(x * x + y * y) / farthest;
    double sum = 0;
    for (std::uint32_t b = 0; b < 3; ++b) {
      const double want = std::max(0.0, 1 - std::abs(place - b));
      EXPECT_NEAR(weight_of(scene, v, 3 + b), want, 1e-6) << v << ", spline " << b;
      sum += weight_of(scene, v, 3 + b);
    }
    EXPECT_NEAR(sum, 1, 1e-6);
  }
  // Splines 0, 1, 2 end a third, two thirds and all of the way over.
  for (std::size_t b = 0; b < 3; ++b) {
    const glm::dvec4 chest(0, 1, 0, 1);
    const double share = static_cast<double>(b + 1) / 3;
    const glm::dvec4 want = chest * (1 - share) + matrix(scene, 2, 1) * chest * share;
    EXPECT_LT(glm::length(matrix(scene, 3 + b, 1) * chest - want), 1e-6);
  }
}

TEST(WeightsOverTime, ABumpTakesWhatIsNearItsJoint) {
  Notes notes;
  const RawScene scene = weights_over_time(strip(), {rule(1, 1.5)}, notes);
  for (std::size_t v = 0; v < 10; ++v) {
    const double x = static_cast<double>(v / 2) - 2, y = static_cast<double>(1 - v % 2);
    const double r = std::min(1.0, std::sqrt(x * x + y * y) / 1.5);
    const double want = (1 - r * r) * (1 - r * r);
    EXPECT_NEAR(weight_of(scene, v, 3), want, 1e-6) << v;
    EXPECT_NEAR(weight_of(scene, v, 1), 1 - want, 1e-6) << v;
  }
}

TEST(WeightsOverTime, WhereNothingDrivesThem) {
  Notes notes;
  RawScene still = strip("other");
  const RawScene scene = weights_over_time(still, {rule()}, notes);
  ASSERT_EQ(notes.warnings.size(), 1U);
  EXPECT_EQ(notes.warnings[0].rule, "weights-never-move");
  for (const RawChannel& channel : scene.clips[0].channels) EXPECT_EQ(channel.node, 2) << "no keys";
  EXPECT_LT(apart(matrix(scene, 3, 2), matrix(scene, 1, 2)), 1e-12);
  // A second clip has not the channel: the number's rest, here 1, holds there.
  still = strip();
  still.clips[0].scalars[0].rest = 1;
  still.clips.push_back(still.clips[0]);
  still.clips[1].scalars.clear();
  const RawScene second = weights_over_time(still, {rule()}, notes);
  const RawSkin& skin = second.skins[0];
  const glm::dmat4 made = NodeMotion(second, second.clips[1], {skin.joints[3]}).at(1.5F)[0] * skin.inverse_bind[3];
  EXPECT_LT(apart(made, matrix(second, 2, 1.5F)), 1e-6);
}

TEST(WeightsOverTime, AMeshOfTwoSkinsIsCopied) {
  RawScene two = strip();
  two.skins.push_back(two.skins[0]);
  two.skins[1].joints = {0, 2, 1};  // what follows the chest there is the other's pole
  two.nodes.push_back(two.nodes[3]);
  two.instances.push_back({4, 0, 1, {}, kNone});
  Notes notes;
  const RawScene scene = weights_over_time(two, {rule()}, notes);
  ASSERT_EQ(scene.meshes.size(), 2U);
  const auto influences = [&](std::size_t instance) {
    return scene.meshes[static_cast<std::size_t>(scene.instances[instance].mesh)].primitives[0].influences[0];
  };
  EXPECT_EQ(influences(0)[0].joint, 3U);
  EXPECT_EQ(influences(1)[0].joint, 1U);
}

void expect_refused(const RawScene& scene, const WeightsOverTime& of, const std::string& why) {
  Notes notes;
  try {
    static_cast<void>(weights_over_time(scene, {of}, notes));
    ADD_FAILURE() << "took what it must refuse: " << why;
  } catch (const tools::Failure& failure) {
    EXPECT_NE(std::string(failure.what()).find(why), std::string::npos) << failure.what();
  }
}

TEST(WeightsOverTime, Refused) {
  WeightsOverTime bad = rule();
  bad.from = "chset";
  expect_refused(strip(), bad, "no node is called chset");
  bad = rule();
  bad.to = "chest";
  expect_refused(strip(), bad, "from a joint to itself");
  bad = rule();
  bad.from = "body";
  expect_refused(strip(), bad, "no mesh follows body");
  RawScene twice = strip();
  twice.nodes[0].name = "pole";
  expect_refused(twice, rule(), "several nodes are called pole");
  RawScene flat = strip();
  flat.nodes[1].scale = {0, 0, 0};
  expect_refused(flat, rule(), "loses its volume");
  RawScene unbound = strip();
  unbound.skins[0].inverse_bind[1] = glm::dmat4(0);
  expect_refused(unbound, rule(), "has no volume in the bind pose");
  RawScene far = strip();
  far.clips[0].channels.push_back({1, RawPath::translation, RawInterpolation::linear, {0}, {{3e38F, 0, 0, 0}}});
  expect_refused(far, rule(), "goes too far away");
  RawScene long_one = strip();
  long_one.clips[0].scalars[0].times_s = {0, 100'000};
  expect_refused(long_one, rule(), "too long for 60 keys a second");
}

// Two rules may go by one number; of one joint it is given once.
TEST(WeightsOverTime, OneChannelForTwoJoints) {
  RawScene two = strip();
  for (std::size_t v = 0; v < 5; ++v) two.meshes[0].primitives[0].influences[v] = {{0, 1.0F}};
  Notes notes;
  WeightsOverTime of_root = rule();
  of_root.from = "root";
  const RawScene scene = weights_over_time(two, {rule(), of_root}, notes);
  ASSERT_EQ(scene.skins[0].joints.size(), 5U);
  EXPECT_EQ(scene.nodes[to_index(scene.skins[0].joints[4])].name, "root/loose");
  expect_refused(scene, rule(), "there is a joint chest/loose already");
}

TEST(WeightsOverTime, AsAnOption) {
  const auto given = [](const std::string& text) {
    return options_of("--weights-over-time " + text).prepare.weights_over_time.at(0);
  };
  const WeightsOverTime plain = given("hero.loose=mixamorig:Spine,pole");
  EXPECT_EQ(plain.channel, "hero.loose");
  EXPECT_EQ(plain.from, "mixamorig:Spine");
  EXPECT_EQ(plain.to, "pole");
  EXPECT_EQ(plain.splines, 1);
  EXPECT_EQ(plain.radius_m, 0);
  EXPECT_EQ(given("a=b,c,4").splines, 4);
  EXPECT_EQ(given("a=b,c,8cm").radius_m, 0.08);
  for (const char* bad : {"", "a", "=b,c", "a=b", "a=,c", "a=b,", "a=b,c,", "a=b,c,d", "a=b,c,0", "a=b,c,17",
                          "a=b,c,5%", "a=b,c,-1cm", "a=b,c,2,3", "a=b,c,99999999999999999999"})
    EXPECT_THROW(given(bad), tools::Failure) << bad;
}

// All the way: what the cooked file's vertices do at the end of the clip.
TEST(WeightsOverTime, CookedAndPosed) {
  const LoadedCook cooked(cook_scene(strip(), options_of("--weights-over-time loose=chest,pole")));
  const Skins skins = skins_at(cooked.file, 0, 2, cooked.file.mesh(0));
  // The pole at (2, 0) has turned by 90°: (x, y) goes to (2 - y, x - 2).
  int found = 0;
  for (int x = 0; x <= 4; ++x)
    for (int y = 0; y < 2; ++y)
      for (const std::vector<glm::vec3>& posed : {skins.ssd, skins.as})
        found += std::ranges::any_of(
            posed, [&](const glm::vec3& v) { return glm::length(v - glm::vec3(2 - y, x - 2, 0)) < 1e-3F; });
  EXPECT_EQ(found, 20);
}

}  // namespace
}  // namespace marrow::cook
