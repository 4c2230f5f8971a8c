// Levels of detail, from the option to the mesh that the runtime draws.
#include "cook/mesh/lod.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

CookOptions levels(const std::string& lod, const std::string& codec = "none", const std::string& more = "") {
  return options_of("--clip-codec raw --lod " + lod + " --mesh-codec " + codec + more);
}

std::uint32_t corner(const Geometry& g, std::size_t i) {
  std::uint32_t out = 0;
  std::memcpy(&out, static_cast<const std::byte*>(g.indices) + i * g.index_bytes, g.index_bytes);
  return out;
}

// From a triangle, by halving it: coarse, but nothing that the code under test uses. Never too small.
double distance(const glm::vec3& p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  for (int step = 0; step < 12; ++step) {
    const glm::vec3 ab = (a + b) / 2.0f, bc = (b + c) / 2.0f, ca = (c + a) / 2.0f;
    const glm::vec3 parts[4][3] = {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {bc, ca, ab}};
    const auto* const best = std::ranges::min_element(
        parts, {}, [&](const glm::vec3(&t)[3]) { return glm::length((t[0] + t[1] + t[2]) / 3.0f - p); });
    a = (*best)[0], b = (*best)[1], c = (*best)[2];
  }
  return static_cast<double>(std::min({glm::length(a - p), glm::length(b - p), glm::length(c - p)}));
}

class LodCodecs : public testing::TestWithParam<const char*> {};

TEST_P(LodCodecs, NewtHasTheLevelsAskedFor) {
  const LoadedCook cooked(cook_file(test::newt_glb(), levels("0.5,0.25", GetParam())));
  ASSERT_GT(cooked.file.mesh_count(), 0u);
  for (std::uint32_t m = 0; m < cooked.file.mesh_count(); ++m) {
    const Mesh full = cooked.file.mesh(m);
    ASSERT_EQ(full.lods.size, 2u);
    const auto& reported = cooked.report["meshes"][m]["lods"];
    double ratio = 1;
    for (std::uint32_t level = 1; level <= 2; ++level) {
      const Mesh mesh = cooked.file.mesh(m, level);
      ratio /= 2;
      EXPECT_EQ(mesh.geometry_index, full.lods[level - 1].geometry);
      EXPECT_EQ(mesh.palette_size(), full.palette_size());
      EXPECT_EQ(mesh.geometry.joint_count, full.geometry.joint_count);
      EXPECT_NEAR(mesh.geometry.index_count, ratio * full.geometry.index_count, 12);
      EXPECT_LT(mesh.geometry.vertex_count, full.geometry.vertex_count);
      EXPECT_EQ(reported[level - 1]["triangles"], mesh.geometry.index_count / 3);
      EXPECT_EQ(static_cast<float>(reported[level - 1]["max_error_m"].get<double>()), full.lods[level - 1].error_m);
      EXPECT_LT(reported[level - 1]["rms_error_m"], reported[level - 1]["max_error_m"]);
    }
    EXPECT_LT(reported[0]["rms_error_m"], reported[1]["rms_error_m"]);
    EXPECT_EQ(cooked.file.mesh(m, 99).geometry_index, full.lods[1].geometry) << "beyond the last is the last";
  }
  EXPECT_EQ(cooked.file.mesh_count(), cooked.report["meshes"].size()) << "levels are no meshes";
}

INSTANTIATE_TEST_SUITE_P(Codecs, LodCodecs, testing::Values("none", "draco", "meshopt"));

// The error in the file is that of anchors that stay; the nearest point of the surface is nearer still.
TEST(Lod, ErrorBoundsTheDistanceOfSurfaces) {
  const LoadedCook cooked(cook_file(test::newt_glb(), levels("0.3")));
  double worst = 0, bound = 0;
  std::size_t checked = 0;
  for (std::uint32_t m = 0; m < cooked.file.mesh_count(); ++m) {
    const Mesh full = cooked.file.mesh(m), less = cooked.file.mesh(m, 1);
    for (std::uint32_t clip = 0; clip < std::min(cooked.file.clip_count(), 2u); ++clip) {
      if (cooked.file.clip(clip).skeleton != full.skeleton) continue;
      const std::vector<glm::vec3> a = skins_at(cooked.file, clip, 0, full).as,
                                   b = skins_at(cooked.file, clip, 0, less).as;
      for (std::size_t v = 0; v < a.size(); v += 197) {
        double nearest = HUGE_VAL;
        for (std::size_t i = 0; i < less.geometry.index_count; i += 3)
          nearest = std::min(nearest, distance(a[v], b[corner(less.geometry, i)], b[corner(less.geometry, i + 1)],
                                               b[corner(less.geometry, i + 2)]));
        EXPECT_LE(nearest, static_cast<double>(full.lods[0].error_m) * 1.0001 + 1e-6);
        worst = std::max(worst, nearest);
        ++checked;
      }
      bound = std::max(bound, static_cast<double>(full.lods[0].error_m));
    }
  }
  EXPECT_GT(checked, 20u);
  EXPECT_GT(worst, bound / 50) << "and it is no idle bound";
}

TEST(Lod, FewerInfluencesAreThose) {
  const LoadedCook cooked(cook_file(test::newt_glb(), levels("0.5,0.49:2,0.48:1")));
  std::uint32_t most[4] = {};
  for (std::uint32_t m = 0; m < cooked.file.mesh_count(); ++m)
    for (std::uint32_t level = 0; level < 4; ++level)
      for (const auto& run : cooked.file.mesh(m, level).geometry.runs)
        most[level] = std::max(most[level], run.influences);
  EXPECT_GT(most[0], 2u);
  EXPECT_EQ(most[1], most[0]);
  EXPECT_EQ(most[2], 2u);
  EXPECT_EQ(most[3], 1u);
  const auto& reported = cooked.report["meshes"][0]["lods"];
  EXPECT_GT(reported[2]["rms_error_m"], reported[0]["rms_error_m"]);
}

// A learnt residual goes along, with the helpers that it follows.
TEST(Lod, AnimationSpaceHasLevels) {
  const LoadedCook cooked(cook_file(test::newt_glb(), levels("0.25:3", "none", " --as fit --truth dqs --helpers 4")));
  const Mesh full = cooked.file.mesh(0), less = cooked.file.mesh(0, 1);
  ASSERT_NE(full.geometry.as_residual, nullptr);
  ASSERT_NE(less.geometry.as_residual, nullptr);
  EXPECT_GT(less.helpers.size, 0u);
  for (const auto& run : less.geometry.runs) EXPECT_LE(run.influences, 3u);
}

// Every vertex of a level is one of the full mesh, in place, normal and texture.
TEST(Lod, VerticesAreTheMeshsOwn) {
  const LoadedCook cooked(cook_file(test::newt_glb(), levels("0.2")));
  const Geometry full = cooked.file.mesh(0).geometry, less = cooked.file.mesh(0, 1).geometry;
  const auto lane = [](const float* blocks, std::uint32_t slot) {
    return glm::vec3(blocks[slot % 4], blocks[4 + slot % 4], blocks[8 + slot % 4]);
  };
  std::size_t found = 0;
  for (std::size_t i = 0; i < less.index_count; i += 50)
    for (std::uint32_t slot = 0; slot < full.slot_count; ++slot) {
      const std::uint32_t at = corner(less, i);
      if (lane(full.normals + slot / 4 * 12, slot) != lane(less.normals + at / 4 * 12, at)) continue;
      if (full.uvs != nullptr && std::memcmp(full.uvs + 2 * slot, less.uvs + 2 * at, 8) != 0) continue;
      ++found;
      break;
    }
  EXPECT_EQ(found, (less.index_count + 49) / 50);
}

// Meshes that hang on a node, with morph targets, of two triangles each: one of them is the least there can be.
TEST(Lod, SaysWhatCannotBeReached) {
  const LoadedCook cooked(cook_file(test::in_golden("face.gltf"), levels("0.1", "draco")));
  std::size_t warned = 0;
  for (const auto& w : cooked.report["warnings"]) warned += w["rule"] == "lod-not-reached" ? 1u : 0u;
  EXPECT_EQ(warned, 2u);
  for (std::uint32_t m = 0; m < cooked.file.mesh_count(); ++m) {
    const Mesh full = cooked.file.mesh(m), less = cooked.file.mesh(m, 1);
    EXPECT_EQ(full.geometry.index_count, 6u);
    EXPECT_EQ(less.geometry.index_count, 3u);
    EXPECT_EQ(less.targets.size, less.geometry.targets.size);
    EXPECT_GT(full.lods[0].error_m, 0);
  }
}

TEST(Lod, KeepsTheSourcesOrderOfTheFullMeshAlone) {
  const CookOptions options = levels("0.5", "none", " --keep-vertex-order");
  const LoadedCook cooked(cook_file(test::in_golden("tiny.gltf"), options));
  EXPECT_GT(cooked.file.mesh(0).geometry.source_slots.size, 0u);
  EXPECT_EQ(cooked.file.mesh(0, 1).geometry.source_slots.size, 0u);
}

TEST(Lod, OptionIsReadWhole) {
  const CookOptions options = levels("0.5,0.25:2,1e-3:1");
  ASSERT_EQ(options.mesh.lod.size(), 3u);
  EXPECT_EQ(options.mesh.lod[0].ratio, 0.5);
  EXPECT_EQ(options.mesh.lod[0].influences, std::size_t{kMaxInfluences});
  EXPECT_EQ(options.mesh.lod[1].influences, 2u);
  EXPECT_EQ(options.mesh.lod[2].ratio, 1e-3);
  for (const char* const bad :
       {"", "1", "0", "-0.5", "0.5,", "0.5,0.5", "0.25,0.5", "0.5:0", "0.5:9", "0.5:", "0.5;0.2", "nan", "inf", "0.5x",
        ",0.5", "0.5:2:3", "0.9,0.8,0.7,0.6,0.5,0.4,0.3,0.2,0.1,0.09,0.08,0.07,0.06,0.05,0.04,0.03"})
    EXPECT_THROW(levels(bad), tools::Failure) << bad;
}

TEST(Lod, SameBytesEveryTime) {
  const RawScene scene = read_gltf(test::newt_glb());
  const CookOptions options = levels("0.5,0.1:2", "meshopt");
  EXPECT_EQ(cook_scene(scene, options).file, cook_scene(scene, options).file);
}

}  // namespace
}  // namespace marrow::cook
