// Joint limits on their way from glTF: what is accepted, in agreement with docs/limits.schema.json, what is refused and
// where; into the file, and by `marrow export` back.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>

#include "cook/skeleton/build_details.h"
#include "cook/skeleton/build_skeletons.h"
#include "cook/skin/deform_source.h"
#include "export/export.h"
#include "marrow/limits.h"
#include "support/json_schema.h"
#include "support/places.h"
#include "unit/cook/gltf/document.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

Json schema_file() {
  return Json::parse(std::ifstream(test::in_source("docs/limits.schema.json")));
}

// skinned() with limits on its first joint, node 1.
Builder limited(const Json& limits) {
  Builder b = cook::skinned();
  b.root["nodes"][1]["extras"] = {{"marrow", {{"limits", limits}}}, {"height", 1.5}};
  return b;
}

struct Example {
  const char* limits;
  const char* where = nullptr;  // below /nodes/1/extras/marrow/limits; null: accepted
  const char* rule = "";
  bool schema_knows = true;  // or the schema accepts what the cooker refuses: rules between numbers
};

const Example kExamples[] = {
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 150]}})"},
    {R"({"hinge": {"axis": [0, 2, 1], "angle": [-360, 360]}, "zero": [0, 0, 0, 1], "speed": 90, "acceleration": 1e3})"},
    {R"({"cone": {"axis": [0, 1, 0], "across": [1, 0, 0], "swing": [40, 0], "twist": [-30, 30]}})"},
    {R"({"cone": {"axis": [0, 1, 0], "across": [1, 0.5, 0], "swing": [170, 170], "twist": [10, 10]}})"},
    {R"({"euler": {"order": "zyx", "x": [-180, 180], "y": [-90, 90], "z": [0, 0]}})"},
    {R"({"euler": {"order": "yxz", "x": [-45, 45], "y": [-200, 90], "z": [0, 1], "axis": [0, 0, 1], "across": [1, 0, 0]}})"},
    {R"({"speed": 0.001})"},
    {R"({"acceleration": 1000000000})"},
    {R"([])", "", "an object is expected"},
    {R"(null)", "", "an object is expected"},
    {R"({})", "", "a limit of nothing"},
    {R"({"zero": [0, 0, 0, 1]})", "", "a limit of nothing"},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 150]}, "cone": {}})", "", "several kinds"},
    {R"({"hinges": {"axis": [1, 0, 0], "angle": [0, 150]}})", "/hinges", "unknown property"},
    {R"({"hinge": [1, 0, 0]})", "/hinge", "an object is expected"},
    {R"({"hinge": {"axis": [1, 0, 0]}})", "/hinge", "no angle"},
    {R"({"hinge": {"angle": [0, 150]}})", "/hinge", "no axis"},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 150], "twist": 1}})", "/hinge/twist", "unknown property"},
    {R"({"hinge": {"axis": [1, 0], "angle": [0, 150]}})", "/hinge/axis", "3 numbers"},
    {R"({"hinge": {"axis": "x", "angle": [0, 150]}})", "/hinge/axis", "3 numbers"},
    {R"({"hinge": {"axis": [1, 0, "0"], "angle": [0, 150]}})", "/hinge/axis/2", "a number is expected"},
    {R"({"hinge": {"axis": [1, 0, 1e30], "angle": [0, 150]}})", "/hinge/axis/2", "out of range"},
    {R"({"hinge": {"axis": [0, 0, 0], "angle": [0, 150]}})", "/hinge/axis", "without length", false},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 361]}})", "/hinge/angle/1", "out of range"},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [150, 0]}})", "/hinge/angle", "above the most", false},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": 150}})", "/hinge/angle", "2 numbers"},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 1]}, "zero": [0, 0, 0]})", "/zero", "4 numbers"},
    {R"({"hinge": {"axis": [1, 0, 0], "angle": [0, 1]}, "zero": [0, 0, 0, 0]})", "/zero", "without length", false},
    {R"({"cone": {"axis": [0, 1, 0], "swing": [40, 0], "twist": [-30, 30]}})", "/cone", "no across"},
    {R"({"cone": {"axis": [0, 1, 0], "across": [0, 2, 0], "swing": [40, 0], "twist": [0, 0]}})", "/cone/across",
     "along axis", false},
    {R"({"cone": {"axis": [0, 1, 0], "across": [1, 0, 0], "swing": [40, 171], "twist": [0, 0]}})", "/cone/swing/1",
     "out of range"},
    {R"({"cone": {"axis": [0, 1, 0], "across": [1, 0, 0], "swing": [-1, 40], "twist": [0, 0]}})", "/cone/swing/0",
     "below 0"},
    {R"({"cone": {"axis": [0, 1, 0], "across": [1, 0, 0], "swing": [1, 40]}})", "/cone", "no twist"},
    {R"({"euler": {"order": "xyx", "x": [0, 1], "y": [0, 1], "z": [0, 1]}})", "/euler/order", "unknown order"},
    {R"({"euler": {"order": 0, "x": [0, 1], "y": [0, 1], "z": [0, 1]}})", "/euler/order", "unknown order"},
    {R"({"euler": {"x": [0, 1], "y": [0, 1], "z": [0, 1]}})", "/euler", "no order"},
    {R"({"euler": {"order": "xyz", "x": [0, 1], "y": [0, 1]}})", "/euler", "no z"},
    {R"({"euler": {"order": "xyz", "x": [0, 1], "y": [0, 91], "z": [0, 1]}})", "/euler/y/1", "out of range", false},
    {R"({"euler": {"order": "xyz", "x": [0, 1], "y": [0, 1], "z": [0, 1], "axis": [1, 0, 0]}})", "/euler", "no across"},
    {R"({"speed": 0})", "/speed", "out of range"},
    {R"({"speed": "fast"})", "/speed", "a number is expected"},
    {R"({"acceleration": 1e10})", "/acceleration", "out of range"},
};

TEST(CookLimits, SchemaAndCookerAgree) {
  const test::Schema schema(schema_file());
  int accepted = 0, refused = 0;
  for (const Example& example : kExamples) {
    const Json limits = Json::parse(example.limits);
    EXPECT_EQ(schema.accepts(limits), example.where == nullptr || !example.schema_knows) << example.limits;
    Builder b = limited(limits);
    if (example.where == nullptr) {
      const LoadedCook cooked(cook_scene(read(b), {}));
      ASSERT_EQ(cooked.file.skeleton(0).limits.size, 1U) << example.limits;
      ++accepted;
    } else {
      expect_failure([&] { read(b); }, Exit::invalid, std::string("/nodes/1/extras/marrow/limits") + example.where,
                     example.rule);
      ++refused;
    }
  }
  EXPECT_EQ(accepted, 8);
  EXPECT_EQ(refused, 34);
}

TEST(CookLimits, LeaveOtherExtrasToTheGame) {
  Builder b = limited(Json::parse(kExamples[0].limits));
  b.root["nodes"][1]["extras"]["marrow"]["of the game"] = 7;
  b.root["nodes"][2]["extras"] = {{"marrow", "a text"}};
  const RawScene scene = read(b);
  ASSERT_TRUE(scene.nodes[1].limit.has_value());
  EXPECT_FALSE(scene.nodes[2].limit.has_value());
  ASSERT_EQ(scene.nodes[1].extras.size(), 2U);
  EXPECT_EQ(scene.nodes[1].extras[0].name, "height");
  EXPECT_EQ(scene.nodes[1].extras[1].name, "marrow/of the game");
}

TEST(CookLimits, OfNodesThatAreNoJointsAreLeftOut) {
  Builder b = cook::skinned();
  b.root["nodes"].push_back({{"name", "lamp"}, {"extras", {{"marrow", {{"limits", {{"speed", 1}}}}}}}});
  b.root["scenes"][0]["nodes"].push_back(3);
  Result result = cook_scene(read(b), {});
  const LoadedCook cooked(result);
  EXPECT_TRUE(cooked.file.skeleton(0).limits.empty());
  std::size_t warned = 0;
  for (const auto& w : result.report["warnings"])
    warned += w["rule"] == "limit-without-joint" && w["pointer"] == "/nodes/3/extras/marrow/limits";
  EXPECT_EQ(warned, 1U);
}

TEST(CookLimits, AreNoPartOfAClipPack) {
  Builder b = limited(Json::parse(kExamples[0].limits));
  const LoadedCook cooked(cook_scene(read(b), options_of("--clips-only")));
  EXPECT_EQ(cooked.file.skeleton_count(), 0U);
  for (const File::Section& s : cooked.file.sections()) EXPECT_NE(s.type, format::four_characters("LIMI"));
}

// Every accepted example exported and cooked again, and the same rotations through both limits.
TEST(CookLimits, ComeBackFromGltf) {
  int compared = 0;
  for (const Example& example : kExamples) {
    if (example.where != nullptr) continue;
    Builder b = limited(Json::parse(example.limits));
    b.root["nodes"][1]["rotation"] = {0.6, 0, 0, 0.8};
    const LoadedCook first(cook_scene(read(b), {}));
    const tools::Exported exported = tools::export_file(first.file, "test");
    const std::span<const std::byte> glb(reinterpret_cast<const std::byte*>(exported.glb.data()), exported.glb.size());
    const LoadedCook second(cook_scene(read_gltf("export", glb), {}));
    ASSERT_EQ(second.file.skeleton(0).limits.size, 1U);
    const JointLimit &a = first.file.skeleton(0).limits[0], &c = second.file.skeleton(0).limits[0];
    EXPECT_EQ(a.joint, c.joint);
    EXPECT_EQ(a.kind, c.kind);
    EXPECT_NEAR(a.rate.speed, c.rate.speed, a.rate.speed * 1e-6f);
    EXPECT_NEAR(a.rate.acceleration, c.rate.acceleration, a.rate.acceleration * 1e-6f);
    for (int i = 0; i < 200; ++i, ++compared) {
      const float x = static_cast<float>(i);
      float p[4] = {std::sin(x), std::sin(2.3F * x), std::sin(3.1F * x), std::cos(x) + 2};
      float q[4];
      std::memcpy(q, p, sizeof q);
      ASSERT_EQ(clamp_rotation(a, p), Status::ok);
      ASSERT_EQ(clamp_rotation(c, q), Status::ok);
      double size_p = 0, size_q = 0;
      for (int k = 0; k < 4; ++k) size_p += double{p[k]} * double{p[k]}, size_q += double{q[k]} * double{q[k]};
      for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(double{p[k]} / std::sqrt(size_p), double{q[k]} / std::sqrt(size_q), 2e-5) << example.limits;
    }
  }
  EXPECT_EQ(compared, 8 * 200);
}

TEST(CookLimits, OfTheSampleAreKeptByItsClips) {
  const LoadedCook cooked(cook_file(test::newt_glb(), {}));
  const Skeleton skeleton = cooked.file.skeleton(0);
  ASSERT_EQ(skeleton.limits.size, 5U);  // knees, elbows, neck
  std::vector<SoaTransform> local(skeleton.soa_size());
  float worst = 0;
  int poses = 0;
  for (std::uint32_t c = 0; c < cooked.file.clip_count(); ++c) {
    const Clip clip = cooked.file.clip(c);
    for (int i = 0; i <= 100; ++i, ++poses) {
      ASSERT_EQ(sample(skeleton, clip, clip.duration_s * static_cast<float>(i) / 100, local), Status::ok);
      for (const JointLimit& limit : skeleton.limits) {
        float q[4];
        for (std::size_t k = 0; k < 4; ++k) q[k] = local[limit.joint / 4].rotation[k][limit.joint % 4];
        worst = std::max(worst, limit_excess(limit, q));
      }
    }
  }
  EXPECT_EQ(poses, 404);
  EXPECT_LT(worst, 1e-3F);  // what compression does
}

TEST(CookLimits, AreTheSameInAPackedFile) {
  const CookOptions plain = options_of("--mesh-codec none");
  const RawScene scene = [] {
    Builder b = limited(Json::parse(kExamples[2].limits));
    return read(b);
  }();
  const LoadedCook packed(cook_scene(scene, {})), whole(cook_scene(scene, plain));
  ASSERT_EQ(packed.file.skeleton(0).limits.size, 1U);
  ASSERT_EQ(whole.file.skeleton(0).limits.size, 1U);
  EXPECT_EQ(std::memcmp(packed.file.skeleton(0).limits.data, whole.file.skeleton(0).limits.data, sizeof(JointLimit)),
            0);
}

// A hinge about z from -60° to 40°, from the rest pose, which is 20° further than the bind pose: -40° … 60° from there.
// In mirrored axes a turn goes the other way.
TEST(CookLimits, HoldInTheRangeOfMotion) {
  Builder b = cook::skinned();
  b.root["nodes"][2]["rotation"] = {0, 0, std::sin(10 * 3.14159265358979 / 180), std::cos(10 * 3.14159265358979 / 180)};
  b.root["nodes"][2]["extras"]["marrow"]["limits"]["hinge"] = {{"axis", {0, 0, 1}}, {"angle", {-60, 40}}};
  const RawScene scene = read(b);
  Notes notes;
  BuiltScene built = build_skeletons(scene);
  built.skeletons[0].limits = build_limits(scene, built, notes)[0];
  DeformSource source = deform_source(scene.meshes[0], scene.skins[0], bind_to_skin(scene.meshes[0], notes), built);
  for (const bool mirrored : {false, true}) {
    if (mirrored)
      for (glm::dmat4& m : source.inverse_bind) m = glm::dmat4(glm::dmat3({-2, 0, 0}, {0, 2, 0}, {0, 0, 2})) * m;
    const deform::RangeOfMotion motion = range_of_motion(source, built.skeletons[0]);
    std::vector<double> about_z;
    for (const deform::MotionPose& pose : motion.poses) {
      EXPECT_NEAR(std::abs(pose.axis.z), 1, 1e-5);
      about_z.push_back(pose.angle_rad * pose.axis.z * 180 / 3.14159265358979);
    }
    std::ranges::sort(about_z);
    ASSERT_EQ(about_z.size(), 2U);
    EXPECT_NEAR(about_z[0], mirrored ? -60 : -40, 1e-3);
    EXPECT_NEAR(about_z[1], mirrored ? 40 : 60, 1e-3);
    EXPECT_EQ(left_out_of_motion(source, built.skeletons[0], motion.left_out),
              std::vector<std::string>{"its limits forbid twists: tip"});
  }
}

}  // namespace
}  // namespace marrow::cook
