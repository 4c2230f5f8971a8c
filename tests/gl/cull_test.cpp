// Back faces in pictures: not drawn of single-sided materials, whatever mirrors, on every path.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl/support/feedback.h"
#include "gl/support/rendered.h"

namespace marrow::cook {
namespace {

const std::array<bool, 3> kRed = {true, false, false};

class Culled : public Rendered {
 protected:
  // A primitive of a skinned mesh, or of one that is not.
  static void add(Builder& b, const std::vector<float>& positions, const std::vector<std::uint16_t>& indices,
                  int material, bool skinned) {
    const std::size_t vertices = positions.size() / 3;
    Json attributes = {{"POSITION", b.positions(positions)}};
    if (skinned) {
      std::vector<float> weights;
      for (std::size_t v = 0; v < vertices; ++v) weights.insert(weights.end(), {0.5f, 0.5f, 0, 0});
      std::vector<std::uint8_t> joints;
      for (std::size_t v = 0; v < vertices; ++v) joints.insert(joints.end(), {0, 1, 0, 0});
      attributes["JOINTS_0"] = b.numbers<std::uint8_t>(kU8, "VEC4", 4, joints);
      attributes["WEIGHTS_0"] = b.numbers<float>(kF32, "VEC4", 4, weights);
    }
    Json& primitive = b.primitive(attributes);
    primitive["indices"] = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, indices);
    primitive["material"] = material;
  }
  static void paint(Builder& b, float red, bool double_sided, const std::string& alpha = "OPAQUE") {
    Json material = {{"pbrMetallicRoughness", {{"baseColorFactor", {red, 0, 0, 0.9}}}}, {"alphaMode", alpha}};
    if (double_sided) material["doubleSided"] = true;  // false where nothing stands
    b.root["materials"].push_back(material);
  }

  // A red cube in a black one that is a little larger and wound the other way: toon art's outline.
  static Builder hull(bool skinned = false) {
    std::vector<float> corners;
    for (int i = 0; i < 8; ++i)
      for (int axis = 0; axis < 3; ++axis) corners.push_back((i >> axis & 1) != 0 ? 1.0f : -1.0f);
    // Corner x + 2 y + 4 z; counter-clockwise from outside.
    const std::vector<std::uint16_t> outwards = {1, 3, 7, 1, 7, 5, 0, 4, 6, 0, 6, 2, 2, 6, 7, 2, 7, 3,
                                                 0, 1, 5, 0, 5, 4, 4, 5, 7, 4, 7, 6, 0, 2, 3, 0, 3, 1};
    Builder b;
    add(b, corners, outwards, 0, skinned);
    for (float& x : corners) x *= 1.1f;
    add(b, corners, {outwards.rbegin(), outwards.rend()}, 1, skinned);
    paint(b, 1, false);
    paint(b, 0, false);
    return b;
  }
  // The same on two joints: node 1, below which is node 2.
  static Builder skinned_hull() {
    Builder b = hull(true);
    b.root["nodes"] = {{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, {{"name", "tip"}}};
    b.root["scenes"][0]["nodes"] = {0, 1};
    b.root["skins"] = {{{"joints", {1, 2}}}};
    return b;
  }
  // Faces the camera.
  static Builder plane(bool from_behind, bool double_sided, const std::string& alpha = "OPAQUE") {
    Builder b;
    std::vector<std::uint16_t> indices = {0, 1, 2, 0, 2, 3};
    if (from_behind) std::ranges::reverse(indices);
    add(b, {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, indices, 0, false);
    paint(b, 1, double_sided, alpha);
    return b;
  }

  static std::vector<std::string> paths() {
    std::vector<std::string> out = {"ubo", "texture", "feedback", "cpu", "crowd"};
    if (test::gl().caps().compute) out.emplace_back("compute");
    return out;
  }

  // Red in the middle and in the light, which its hull does not keep out; its neighbour to the left black.
  void expect_outlined(const std::string& options = "") const {
    ASSERT_EQ(render(options), 0);
    const Pixels picture = pixels();
    const std::size_t row = picture.height / 2;
    ASSERT_TRUE(has_hue(picture.at(picture.width / 2, row), kRed));
    EXPECT_GT(int{picture.at(picture.width / 2, row)[0]}, 190) << "in the shadow it is 156";
    EXPECT_GT(patch_of(picture, kRed).count, 5000u);
    std::size_t left = picture.width / 2;
    while (left > 0 && has_hue(picture.at(left - 1, row), kRed)) --left;
    ASSERT_GT(left, 8u);
    const png_byte* const rim = picture.at(left - 3, row);
    const png_byte* const backdrop = picture.at(2, 2);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LT(rim[c], 45) << "channel " << c << " of the rim";
      EXPECT_GT(backdrop[c], 60) << "channel " << c << " of the backdrop";
    }
  }
  void expect_outlined_by_every_path(const std::string& options = "") const {
    for (const std::string& way : paths()) {
      SCOPED_TRACE(way);
      expect_outlined("--path " + way + options);
    }
  }
};

TEST_F(Culled, HullsAreOutlines) {
  cook(hull());
  expect_outlined_by_every_path();
  expect_outlined("--deformer as");
  expect_outlined("--deformer rigid");
}

TEST_F(Culled, MirroredNodesAreSeenFromOutside) {
  for (const Json& scale : {Json{-1, 1, 1}, Json{1, 1, -1}, Json{-1, -1, -1}, Json{-1, 1, -1}}) {
    SCOPED_TRACE(scale.dump());
    Builder b = hull();
    b.root["nodes"][0]["scale"] = scale;
    cook(b);
    expect_outlined();
    expect_outlined("--path cpu");
  }
  // Twice is not at all.
  Builder b = hull();
  b.root["nodes"] = {{{"scale", {-1, 1, 1}}, {"children", {1}}}, {{"mesh", 0}, {"scale", {1, -1, 1}}}};
  cook(b);
  expect_outlined();
}

TEST_F(Culled, MirroredCharactersAreSeenFromOutside) {
  Builder b = skinned_hull();
  cook(b);
  expect_outlined_by_every_path();
  b.root["nodes"][0]["scale"] = {-1, 1, 1};  // of a skinned mesh's node, which has no say
  cook(b);
  expect_outlined();
  b.root["nodes"][0].erase("scale");
  b.root["nodes"][1]["scale"] = {-1, 1, 1};
  cook(b);
  expect_outlined_by_every_path();
  // Bound mirrored: what is drawn is not.
  const std::vector<float> mirror = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  std::vector<float> both = mirror;
  both.insert(both.end(), mirror.begin(), mirror.end());
  b.root["skins"][0]["inverseBindMatrices"] = b.numbers<float>(kF32, "MAT4", 16, both);
  cook(b);
  expect_outlined_by_every_path();
}

// A clip that mirrors the root halfway through.
TEST_F(Culled, ThePoseDecides) {
  Builder b = skinned_hull();
  const int times = b.times({0, 1, 2});
  const int scales = b.numbers<float>(kF32, "VEC3", 3, {1, 1, 1, -1, 1, 1, -1, 1, 1});
  b.channel(times, scales, "scale", "STEP", 1);
  cook(b);
  for (const char* const time : {"0", "2"}) {
    SCOPED_TRACE(time);
    expect_outlined_by_every_path(std::string(" --clip 0 --time ") + time);
  }
}

// What blends is drawn behind the others: here all of it, as nothing is all but opaque.
TEST_F(Culled, PlanesHaveTheSidesOfTheirMaterial) {
  const auto expect_sides = [&](const std::string& alpha, const std::string& way) {
    SCOPED_TRACE(alpha + " " + way);
    const auto reds = [&](bool from_behind, bool double_sided) {
      cook(plane(from_behind, double_sided, alpha));
      EXPECT_EQ(render("--path " + way), 0);
      return patch_of(pixels(), kRed).count;
    };
    EXPECT_GT(reds(false, false), 5000u);
    EXPECT_EQ(reds(true, false), 0u);
    EXPECT_GT(reds(false, true), 5000u);
    EXPECT_GT(reds(true, true), 5000u);
  };
  for (const std::string& way : paths()) expect_sides("OPAQUE", way);
  for (const char* const alpha : {"MASK", "BLEND"}) expect_sides(alpha, "ubo");
}

// Of a plane that does not move the map is of one colour, which nothing else in the picture has.
TEST_F(Culled, HeatMapsShowTheSameSides) {
  const auto middle = [&](bool from_behind, bool double_sided) {
    cook(plane(from_behind, double_sided));
    EXPECT_EQ(render("--heatmap rigid:ssd"), 0);
    const Pixels picture = pixels();
    const png_byte* const at = picture.at(picture.width / 2, picture.height / 2);
    return std::vector<int>{at[0], at[1], at[2]};
  };
  const auto is_near = [](const std::vector<int>& a, const std::vector<int>& b) {
    for (std::size_t c = 0; c < 3; ++c)
      if (std::abs(a[c] - b[c]) > 12) return false;
    return true;
  };
  const std::vector<int> front = middle(false, false);
  EXPECT_TRUE(is_near(middle(true, true), front));
  EXPECT_FALSE(is_near(middle(true, false), front));
}

TEST_F(Culled, TheDemoShowsTheOutline) {
  Builder b = hull();
  b.root["nodes"][0]["scale"] = {-1, 1, 1};
  write("hull.gltf", b.text());
  ASSERT_EQ(run("demo " + path("hull.gltf") + " -o " + path("out")), 0);
  EXPECT_GT(patch_of(read_png(path("out/hull.png")), kRed).count, 20000u);
}

}  // namespace
}  // namespace marrow::cook
