// The golden file of looks keeps loading as what looks.gltf says.
#include <cstring>

#include <gtest/gtest.h>

#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

class GoldenLooks : public ::testing::Test {
 protected:
  GoldenLooks() : block_(test::golden_looks_copy()) { EXPECT_EQ(load(block_, file_), Status::ok); }
  test::AlignedBlock block_;
  File file_;
};

TEST_F(GoldenLooks, Materials) {
  ASSERT_EQ(file_.mesh_count(), 3u);
  ASSERT_EQ(file_.material_count(), 2u);
  EXPECT_EQ(file_.mesh(0).material_index, 0u);
  EXPECT_EQ(file_.mesh(1).material_index, 1u);
  EXPECT_EQ(file_.mesh(2).material_index, kNoMaterial) << "a name and a colour stand in the mesh";
  EXPECT_STREQ(file_.mesh(2).material, "plain");
  EXPECT_EQ(file_.mesh(2).base_colour[0], 0.5f);

  const Material painted = file_.material(0), glass = file_.material(1);
  EXPECT_STREQ(painted.name, "painted");
  EXPECT_EQ(painted.alpha, AlphaMode::mask);
  EXPECT_EQ(painted.alpha_cutoff, 0.25f);
  ASSERT_EQ(painted.textures.size, 2u);
  EXPECT_EQ(painted.textures[0].role, TextureRole::base_colour);
  EXPECT_EQ(painted.textures[0].wrap_u, Wrap::clamp_to_edge);
  EXPECT_EQ(painted.textures[0].wrap_v, Wrap::mirrored_repeat);
  EXPECT_EQ(painted.textures[0].mag, MagFilter::nearest);
  EXPECT_EQ(painted.textures[0].min, MinFilter::linear_mipmap_linear);
  EXPECT_EQ(painted.textures[1].role, TextureRole::normal);
  EXPECT_EQ(painted.textures[1].image, 1u);
  EXPECT_EQ(painted.textures[1].min, MinFilter::any);
  EXPECT_EQ(glass.alpha, AlphaMode::blend);
  EXPECT_TRUE(glass.textures.empty());
}

TEST_F(GoldenLooks, Images) {
  ASSERT_EQ(file_.image_count(), 2u);
  EXPECT_STREQ(file_.image(0).name, "corners");
  EXPECT_STREQ(file_.image(0).uri, "");
  EXPECT_STREQ(file_.image(1).uri, "dot.png");
  EXPECT_EQ(file_.image(0).bytes.size, 76u);
  EXPECT_EQ(file_.image(1).bytes.size, 70u);
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(file_.image(i).format, ImageFormat::png);
    EXPECT_EQ(std::memcmp(file_.image(i).bytes.data, "\x89PNG\r\n\x1a\n", 8), 0);
  }
}

// The quad's second set of coordinates, (0, 1) … (0, 0), through offset (0.5, 0) and scale (0.5, 1).
TEST_F(GoldenLooks, CoordinatesOfTheTexture) {
  const Geometry g = file_.mesh(0).geometry;
  const float expected[4][2] = {{0.5f, 1}, {1, 1}, {1, 0}, {0.5f, 0}};
  ASSERT_EQ(g.vertex_count, 4u);
  for (std::uint32_t slot = 0; slot < 4; ++slot) {
    const float x = g.skin[slot], y = g.skin[4 + slot];  // four lanes of x, then of y
    const int corner = y < 0 ? (x < 0 ? 0 : 1) : (x < 0 ? 3 : 2);
    EXPECT_EQ(g.uvs[2 * slot], expected[corner][0]) << corner;
    EXPECT_EQ(g.uvs[2 * slot + 1], expected[corner][1]) << corner;
  }
}

TEST_F(GoldenLooks, Nodes) {
  ASSERT_EQ(file_.node_count(), 4u);
  EXPECT_EQ(file_.find_node("no such node"), 4u);
  const Node panel = file_.node(file_.find_node("panel"));
  EXPECT_EQ(panel.joint, 0u) << "a joint itself";
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) EXPECT_EQ(panel.joint_from_node->rows[r][c], r == c ? 1.0f : 0.0f);

  // Under panel: arm at (1, 0, 0) twice as large, in it the socket at (0, 0, 0.5).
  const Node socket = file_.node(file_.find_node("socket.tip"));
  EXPECT_EQ(socket.joint, 0u);
  const float expected[3][4] = {{2, 0, 0, 1}, {0, 2, 0, 0}, {0, 0, 2, 1}};
  EXPECT_EQ(std::memcmp(socket.joint_from_node->rows, expected, sizeof expected), 0);

  // A turn by 2 asin(0.6) about z: cosine 0.28, sine 0.96.
  const Node locator = file_.node(file_.find_node("locator"));
  EXPECT_EQ(locator.joint, kNoJoint);
  EXPECT_FLOAT_EQ(locator.joint_from_node->rows[0][0], 0.28f);
  EXPECT_FLOAT_EQ(locator.joint_from_node->rows[1][0], 0.96f);
  EXPECT_EQ(locator.joint_from_node->rows[0][3], 3.0f);
}

TEST_F(GoldenLooks, Properties) {
  const Node socket = file_.node(file_.find_node("socket.tip"));
  ASSERT_EQ(socket.properties.size, 5u) << "null is nothing";
  const auto get = [&](const char* name) {
    const Property* const p = file_.node_property(socket, name);
    EXPECT_NE(p, nullptr) << name;
    return p != nullptr ? *p : Property{};
  };
  EXPECT_EQ(get("door/hinges/0").number, 1.5);
  EXPECT_EQ(get("door/hinges/1").number, 2.0);
  EXPECT_EQ(get("door/open").type, PropertyType::boolean);
  EXPECT_EQ(get("door/open").number, 0.0);
  EXPECT_EQ(get("a~1b").number, 9007199254740991.0) << "every integer of JavaScript";
  EXPECT_EQ(get("item").type, PropertyType::text);
  EXPECT_STREQ(file_.text(get("item").text), "lamp");
  EXPECT_EQ(file_.node_property(socket, "none"), nullptr);
  EXPECT_EQ(file_.node_property(file_.node(0), "item"), nullptr);
}

}  // namespace
}  // namespace marrow
