// Keys that glTF does not allow, in cooked files that are written back: splines of one key, and two keys at one time.
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "export/export.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"
#include "unit/cook/scene_document.h"

namespace marrow::cook {
namespace {

Json json_of(const std::string& glb) {
  std::uint32_t length = 0;
  std::memcpy(&length, glb.data() + 12, sizeof length);
  return Json::parse(glb.substr(20, length));
}

RawScene read_back(const tools::Exported& exported) {
  return read_gltf("export", {reinterpret_cast<const std::byte*>(exported.glb.data()), exported.glb.size()});
}

CookOptions raw() {
  return options_of("--clip-codec raw");
}

// glTF 2.0, 3.11: a CUBICSPLINE sampler has two keys at least. One holds its value.
TEST(ExportKeys, ASplineOfOneKeyIsItsValue) {
  SceneDocument d;
  const std::vector<int> joints = d.character("Ada", 0);
  d.clip("hold");
  d.keys(joints[3], "rotation", {0}, {9, 9, 9, 9, 0, 0, 0.6F, 0.8F, 9, 9, 9, 9}, "CUBICSPLINE");
  d.keys(joints[1], "translation", {0, 1}, {0, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 0, 4, 5, 6, 0, 0, 0}, "CUBICSPLINE");
  const LoadedCook cooked(cook_scene(d.read(), raw()));
  const tools::Exported exported = tools::export_file(cooked.file, "test");
  const Json json = json_of(exported.glb);
  int splines = 0, others = 0;
  for (const Json& sampler : json["animations"][0]["samplers"]) {
    const auto count = [&](const char* which) {
      return json["accessors"][sampler[which].get<std::size_t>()]["count"].get<std::size_t>();
    };
    const bool is_spline = sampler["interpolation"] == "CUBICSPLINE";
    EXPECT_EQ(count("output"), (is_spline ? 3 : 1) * count("input"));
    EXPECT_GE(count("input"), is_spline ? 2u : 1u);
    ++(is_spline ? splines : others);
  }
  EXPECT_EQ(splines, 1);
  EXPECT_EQ(others, 1);
  const RawScene again = read_back(exported);
  EXPECT_TRUE(again.warnings.empty());
  for (const RawChannel& channel : again.clips[0].channels) {
    if (channel.path != RawPath::rotation) continue;
    EXPECT_EQ(channel.values, (std::vector<glm::vec4>{{0, 0, 0.6F, 0.8F}}));
  }
}

// What comes back jumps as the source did, by the source's own sides; and its times increase.
TEST(ExportKeys, AJumpComesBack) {
  for (const bool coded : {false, true})
    for (const char* const interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) {
      SceneDocument d;
      const std::vector<int> joints = d.character("Ada", 0);
      d.clip("jump");
      const bool cubic = std::string(interpolation) == "CUBICSPLINE";
      std::vector<float> numbers;
      for (const float x : {0.0F, 1.0F, -1.0F, 2.0F}) {
        if (cubic) numbers.insert(numbers.end(), {0, 0, 0});
        numbers.insert(numbers.end(), {x, 0, 0});
        if (cubic) numbers.insert(numbers.end(), {0, 0, 0});
      }
      d.keys(joints[3], "translation", {0, 0.5F, 0.5F, 1}, numbers, interpolation);
      d.turn(joints[1], {0, 0.25F, 0.5F, 0.75F, 1});
      const LoadedCook cooked(cook_scene(d.read(), coded ? CookOptions{} : raw()));
      const tools::Exported exported = tools::export_file(cooked.file, "test");
      const RawScene again = read_back(exported);
      EXPECT_TRUE(again.warnings.empty()) << interpolation;
      const LoadedCook second(cook_scene(again, raw()));
      const float before = std::nextafter(0.5F, 0.0F);
      for (const LoadedCook* file : {&cooked, &second}) {
        const Skeleton skeleton = file->file.skeleton(0);
        const std::uint32_t arm = file->file.find_joint(skeleton, "arm");
        std::vector<SoaTransform> local(skeleton.soa_size());
        const auto x_at = [&](float time_s) {
          EXPECT_EQ(sample(skeleton, file->file.clip(0), time_s, local), Status::ok);
          return local[arm / 4].translation[0][arm % 4];
        };
        const bool step = std::string(interpolation) == "STEP";
        EXPECT_NEAR(x_at(0.49F), step ? 0 : cubic ? 1 : 0.98F, cubic ? 2e-3F : 1e-4F) << interpolation << coded;
        EXPECT_NEAR(x_at(before), 1, 1e-4F) << interpolation << coded;
        EXPECT_NEAR(x_at(0.5F), -1, 1e-4F) << interpolation << coded;
        EXPECT_NEAR(x_at(1), 2, 1e-4F) << interpolation << coded;
      }
    }
}

}  // namespace
}  // namespace marrow::cook
