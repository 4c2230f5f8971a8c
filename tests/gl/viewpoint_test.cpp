// Pictures from a side that is asked for or that shows most, of a joint, and with a legend.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "common/load_mrw.h"
#include "disk/cook_on_disk.h"
#include "gl/support/rendered.h"
#include "render/clearest_side.h"
#include "render/performance.h"
#include "support/places.h"

namespace marrow::cook {
namespace {

const std::array<bool, 3> kRed = {true, false, false}, kGreen = {false, true, false};

// A red square, and to the left of the character, which faces +Z, a green one: its left is +X.
class Viewpoints : public Rendered {
 protected:
  void SetUp() override {
    Rendered::SetUp();
    Builder b;
    square(b, 0, {1, 0, 0, 1});
    square(b, 2, {0, 1, 0, 1});
    b.root["nodes"][0]["name"] = "sign";
    cook(b);
  }
  // One metre wide, around (x, 0, 0), seen from both sides.
  static void square(Builder& b, float x, const std::vector<float>& colour) {
    const int positions = b.positions({x - 0.5f, -0.5f, 0, x + 0.5f, -0.5f, 0, x + 0.5f, 0.5f, 0, x - 0.5f, 0.5f, 0});
    const std::size_t material = b.root["materials"].size();
    Json& primitive = b.primitive({{"POSITION", positions}});
    primitive["indices"] = b.numbers<std::uint16_t>(kU16, "SCALAR", 1, {0, 1, 2, 0, 2, 3});
    primitive["material"] = material;
    b.root["materials"].push_back({{"doubleSided", true}, {"pbrMetallicRoughness", {{"baseColorFactor", colour}}}});
  }
  Patch seen(const std::array<bool, 3>& hue) const { return patch_of(pixels(), hue); }
};

TEST_F(Viewpoints, ASideIsSeen) {
  ASSERT_EQ(render("--view front"), 0);
  EXPECT_LT(seen(kRed).x + 40, seen(kGreen).x) << "its left is to the right of who looks at it";
  ASSERT_EQ(render("--view back"), 0);
  EXPECT_LT(seen(kGreen).x + 40, seen(kRed).x);
  const std::size_t behind = seen(kRed).count;
  EXPECT_GT(behind, 1000u) << "lit from where the camera is";
  for (const std::string side : {"left", "right", "top"}) {
    ASSERT_EQ(render("--view " + side), 0);
    EXPECT_LT(seen(kRed).count + seen(kGreen).count, behind / 4) << side << ": squares are thin";
  }
  ASSERT_EQ(render("--view three-quarter"), 0);
  const Pixels asked = pixels();
  ASSERT_EQ(render(), 0);
  EXPECT_EQ(asked.rgb, pixels().rgb) << "as without";
  EXPECT_EQ(render("--view below"), 1);
}

TEST_F(Viewpoints, AJointIsAimedAt) {
  ASSERT_EQ(render("--view front --look-at sign --distance 4"), 0);
  const Patch far = seen(kRed);
  EXPECT_NEAR(far.x, 119.5, 1.5);
  EXPECT_NEAR(far.y, 99.5, 1.5);
  ASSERT_EQ(render("--view front --look-at sign --distance 200cm"), 0);
  EXPECT_EQ(seen(kGreen).count, 0u) << "out of the picture";
  ASSERT_EQ(render("--view front --look-at sign --distance 2.8284m"), 0);
  EXPECT_NEAR(double(seen(kRed).count) / double(far.count), 2, 0.1) << "the area is twice as large";
  EXPECT_EQ(render("--look-at sign"), 0);
  EXPECT_EQ(render("--look-at sign --movie --fps 1 --turn 180"), 0);
}

TEST_F(Viewpoints, WhatMakesNoSenseIsRefused) {
  EXPECT_EQ(render("--look-at nobody"), 1);
  EXPECT_EQ(render("--distance 3"), 1) << "from what?";
  for (const char* distance : {"0", "-1", "far", "3%", "inf", "1e99"})
    EXPECT_EQ(render("--look-at sign --distance " + std::string(distance)), 1) << distance;
}

TEST_F(Viewpoints, HeatMapsHaveALegend) {
  const auto hottest = [&] {
    const Pixels picture = pixels();
    std::size_t out = 0;
    for (std::size_t y = 100; y < 200; ++y)
      for (std::size_t x = 60; x < 240; ++x) {
        const png_byte* const p = picture.at(x, y);
        out += p[0] > 240 && p[1] > 220 && p[2] < 170;
      }
    return out;
  };
  ASSERT_EQ(render("--heatmap rigid:ssd"), 0);
  EXPECT_LT(int{pixels().at(9, 190)[0]}, 90) << "the strip";
  EXPECT_EQ(hottest(), 0u) << "nothing differs: there is no scale that says how far it would be";
  ASSERT_EQ(run("cook " + test::in_golden("tiny.gltf") + " -o " + path("document.mrw")), 0);
  ASSERT_EQ(render("--clip wave --time 0.5 --heatmap rigid:ssd"), 0);
  EXPECT_GT(hottest(), 20u) << "the end of the ramp, which is lit by nothing";
}

// A square sleeve along +Y, 0.5 wide, with a ring of four vertices each quarter metre or half. One side of the rings
// in its middle is pressed in, on the side towards `z`: from the other side one cannot see it.
TEST(ClearestSide, LooksAtWhatDiffers) {
  using namespace tools;
  CookOptions options;
  options.mesh.codec = MeshCodec::none;
  const auto bytes = cook_file(test::in_golden("elbow.gltf"), options).file;
  const LoadedFile loaded = load_mrw("elbow", AlignedBytes{std::span<const std::byte>(bytes)});
  tools::Character character(loaded.file);
  character.pose({}, 0);
  const std::vector<PosedMesh> straight = skin_all(loaded.file, character, Deformer::ssd);
  const Part middle = {{0, 1, 0}, 0.6f};
  for (const float z : {-0.25f, 0.25f}) {
    std::vector<PosedMesh> pressed = straight;
    std::size_t moved = 0;
    for (PosedMesh& mesh : pressed)
      for (std::size_t i = 0; i < mesh.positions.size(); i += 3)
        if (std::abs(mesh.positions[i + 1] - 1) < 0.3f && std::abs(mesh.positions[i + 2] - z) < 1e-3f) {
          mesh.positions[i + 2] *= 0.2f;
          ++moved;
        }
    ASSERT_GT(moved, 0u);
    const Seen seen = clearest_side(loaded.file, straight, pressed, middle);
    EXPECT_GT(seen.share, 0.01f);
    // The dent is seen from where the camera stands on its side.
    EXPECT_GT(std::cos(seen.side.yaw) * z, 0) << z << ", yaw " << seen.side.yaw;
    if (z > 0) {
      EXPECT_EQ(seen.side.yaw, Orbit().yaw) << "the usual side shows it";
    }
  }
  const Seen same = clearest_side(loaded.file, straight, straight, middle);
  EXPECT_EQ(same.share, 0);
  EXPECT_EQ(same.side.yaw, Orbit().yaw);
}

}  // namespace
}  // namespace marrow::cook
