// The finer mesh, from the option to what the runtime draws, beside Loop's scheme on what it drew before.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "cook/gltf/read.h"
#include "cook/mesh/subdivide_mesh.h"
#include "disk/cook_on_disk.h"
#include "support/places.h"
#include "unit/cook/loaded_cook.h"
#include "unit/cook/mesh/looped.h"
#include "unit/cook/options_text.h"

namespace marrow::cook {
namespace {

const std::string kTiny = test::in_golden("tiny.gltf");
const std::string kNewtSource = test::newt_glb();

std::uint32_t slot_of(const Geometry& g, std::size_t corner) {
  std::uint32_t out = 0;
  std::memcpy(&out, static_cast<const std::byte*>(g.indices) + corner * g.index_bytes, g.index_bytes);
  return out;
}

// The bind pose, a slot each.
Places bind_places(const Geometry& g) {
  Places out;
  const float* block = g.skin;
  for (const Run& run : g.runs)
    for (std::uint32_t v = 0; v < run.vertex_count; v += 4, block += 12 + 4 * (run.influences - 1))
      for (std::size_t lane = 0; lane < 4; ++lane) out.emplace_back(block[lane], block[4 + lane], block[8 + lane]);
  return out;
}

// A cooked mesh as a net: slots at one place are one point.
struct Welded {
  explicit Welded(const Geometry& g) {
    const Places bind = bind_places(g);
    std::map<std::tuple<double, double, double>, std::uint32_t> points;
    for (std::uint32_t s = 0; s < g.slot_count; ++s) {
      const glm::dvec3& v = bind[s];
      const auto [at, is_new] = points.try_emplace({v.x, v.y, v.z}, static_cast<std::uint32_t>(slots.size()));
      if (is_new) {
        slots.push_back(s);
        net.at.push_back(v);
      }
      point_of.push_back(at->second);
    }
    for (std::size_t i = 0; i < g.index_count; i += 3)
      net.triangles.push_back({point_of[slot_of(g, i)], point_of[slot_of(g, i + 1)], point_of[slot_of(g, i + 2)]});
  }
  // The same net elsewhere.
  Net placed(const std::vector<glm::vec3>& posed) const {
    Net out = net;
    for (std::size_t p = 0; p < slots.size(); ++p) out.at[p] = posed[slots[p]];
    return out;
  }
  Net net;
  std::vector<std::uint32_t> slots, point_of;  // of a point the first slot; of a slot the point
};

CookOptions finer(int steps, const std::string& codec = "none",
                  const std::string& more = "--as fit --truth dqs --helpers auto") {
  return options_of("--subdivide " + std::to_string(steps) + " --mesh-codec " + codec + " --clip-codec raw " + more);
}

// A residual at once, where a fit takes seconds.
CookOptions smoother(int steps, const std::string& codec = "none") {
  return finer(steps, codec, "--as smooth");
}

const LoadedCook& smooth_newt() {
  static const LoadedCook cooked(cook_file(kNewtSource, smoother(0)));
  return cooked;
}

// How far the body, cooked finer, is from Loop's scheme on the posed coarse one, at four moments of each clip.
struct Distance {
  double rms = 0, worst = 0;
  double off = 0;  // share of vertices that are ever further than single precision explains
};

Distance distance_from_loop(const File& coarse, const File& fine, double match_within, int steps = 1) {
  const Mesh before = coarse.mesh(0), after = fine.mesh(0);
  const Welded welded(before.geometry);
  const auto times_looped = [&](Net net) {
    for (int i = 0; i < steps; ++i) net = looped(net);
    return net.at;
  };
  const std::vector<std::uint32_t> which = nearest(bind_places(after.geometry), times_looped(welded.net), match_within);
  Distance out;
  std::size_t count = 0;
  std::vector<double> worst(which.size(), 0);
  for (std::uint32_t clip = 0; clip < coarse.clip_count(); ++clip)
    for (const float share : {0.0f, 0.3f, 0.55f, 0.8f}) {
      const float time_s = share * coarse.clip(clip).duration_s;
      const Places wanted = times_looped(welded.placed(skins_at(coarse, clip, time_s, before).as));
      const std::vector<glm::vec3> got = skins_at(fine, clip, time_s, after).as;
      for (std::size_t s = 0; s < got.size(); ++s, ++count) {
        const double d = glm::length(glm::dvec3(got[s]) - wanted[which[s]]);
        worst[s] = std::max(worst[s], d);
        out.rms += d * d;
      }
    }
  out.rms = std::sqrt(out.rms / static_cast<double>(count));
  out.worst = std::ranges::max(worst);
  out.off = static_cast<double>(std::ranges::count_if(worst, [](double d) { return d > 2e-6; })) /
            static_cast<double>(worst.size());
  return out;
}

// Without quantisation single precision is left.
TEST(CookSubdivide, PosingTheFinerMeshIsSubdividingThePosedOne) {
  const std::string elbow = test::in_golden("elbow.gltf");
  const LoadedCook coarse(cook_file(elbow, finer(0))), fine(cook_file(elbow, finer(1)));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  ASSERT_GT(fine.file.mesh(0).helpers.size, 0u);
  EXPECT_EQ(distance_from_loop(coarse.file, fine.file, 1e-6).off, 0);
}

// And points that would follow nine palette entries or more, as neighbours follow different helpers. Of the newt of
// 1.6 m, in the long form, those are one in twelve: 0.005 mm RMS and 0.34 mm at worst.
TEST(CookSubdivide, ThatIsSoWhereInfluencesAreDropped) {
  const bool newt = test::in_long_form();
  const std::string source = newt ? kNewtSource : test::in_golden("dance.gltf");
  const LoadedCook coarse(cook_file(source, finer(0))), fine(cook_file(source, finer(1)));
  EXPECT_TRUE(std::ranges::any_of(fine.report["warnings"],
                                  [](const auto& warning) { return warning["rule"] == "influences-dropped"; }));
  const Distance distance = distance_from_loop(coarse.file, fine.file, 1e-6);
  EXPECT_LT(distance.off, 0.1);
  EXPECT_LT(distance.rms, 6e-6);
  EXPECT_LT(distance.worst, 4e-4);
}

// Packed, positions are rounded by up to 0.09 mm, weights by 1/4000 of how far joints take a vertex apart, residuals by
// a quarter of what they do, an influence each. The smoothed newt is then 0.06 mm off, 0.35 mm at worst.
TEST(CookSubdivide, SoItIsPacked) {
  const LoadedCook fine(cook_file(kNewtSource, smoother(1, "meshopt")));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Distance distance = distance_from_loop(smooth_newt().file, fine.file, 2e-4);
  EXPECT_LT(distance.rms, 1e-4);
  EXPECT_LT(distance.worst, 1e-3);
}

TEST(CookSubdivide, SoItIsTwice) {
  const LoadedCook coarse(cook_file(kTiny, smoother(0))), fine(cook_file(kTiny, smoother(2)));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Distance distance = distance_from_loop(coarse.file, fine.file, 1e-5, 2);
  EXPECT_EQ(distance.off, 0);
}

// The lift is linear blend skinning of the finer mesh, which is nearly the posed mesh subdivided.
TEST(CookSubdivide, TheLiftHasNoResidual) {
  const LoadedCook coarse(cook_file(kNewtSource, finer(0, "none", ""))),
      fine(cook_file(kNewtSource, finer(1, "none", "")));
  EXPECT_EQ(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Distance distance = distance_from_loop(coarse.file, fine.file, 1e-6);
  EXPECT_GT(distance.off, 0.1);
  EXPECT_LT(distance.rms, 3e-4);
  EXPECT_LT(distance.worst, 5e-3);
}

// The left half of the body has vertices and UVs of its own.
RawScene cut_newt() {
  RawScene scene = read_gltf(kNewtSource);
  RawPrimitive& p = scene.meshes[0].primitives[0];
  const std::size_t count = p.positions.size();
  const auto twice = [](auto& values) {
    const auto copy = values;
    values.insert(values.end(), copy.begin(), copy.end());
  };
  p.uvs.assign(count, glm::vec2(0));
  twice(p.positions), twice(p.normals), twice(p.tangents), twice(p.uvs), twice(p.colours), twice(p.influences);
  p.targets.clear();
  for (std::size_t v = 0; v < p.uvs.size(); ++v) p.uvs[v] = {v < count ? 0 : 0.5f, p.positions[v].y};
  for (std::size_t i = 0; i < p.indices.size(); i += 3)
    if (p.positions[p.indices[i]].x + p.positions[p.indices[i + 1]].x + p.positions[p.indices[i + 2]].x > 0)
      for (std::size_t k = 0; k < 3; ++k) p.indices[i + k] += static_cast<std::uint32_t>(count);
  return scene;
}

TEST(CookSubdivide, SeamsStayClosed) {
  const LoadedCook fine(cook_scene(cut_newt(), smoother(1)));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Mesh mesh = fine.file.mesh(0);
  const Welded welded(mesh.geometry);
  std::set<std::uint32_t> seam;
  for (std::uint32_t clip = 0; clip < fine.file.clip_count(); ++clip) {
    const std::vector<glm::vec3> posed = skins_at(fine.file, clip, 0.6f * fine.file.clip(clip).duration_s, mesh).as;
    for (std::uint32_t s = 0; s < posed.size(); ++s) {
      const std::uint32_t other = welded.slots[welded.point_of[s]];
      EXPECT_EQ(posed[s], posed[other]);
      if (mesh.geometry.uvs[std::size_t{2} * s] != mesh.geometry.uvs[std::size_t{2} * other]) seam.insert(s);
    }
  }
  EXPECT_GT(seam.size(), 100u);
  // And it is the body that it was without the seam.
  EXPECT_EQ(distance_from_loop(smooth_newt().file, fine.file, 1e-6).off, 0);
}

class FinerCodecs : public testing::TestWithParam<const char*> {};

TEST_P(FinerCodecs, FourTimesTheTriangles) {
  const Result before = cook_file(kTiny, finer(0, GetParam(), ""));
  std::size_t times = 1;
  for (int steps = 1; steps <= kMostSubdivisions; ++steps) {
    const LoadedCook after(cook_file(kTiny, finer(steps, GetParam(), "")));
    times *= 4;
    for (std::uint32_t m = 0; m < after.file.mesh_count(); ++m) {
      const std::size_t triangles = before.report["meshes"][m]["triangles"];
      EXPECT_EQ(after.report["meshes"][m]["source_triangles"], triangles);
      EXPECT_EQ(after.report["meshes"][m]["triangles"], times * triangles);
      EXPECT_EQ(after.file.mesh(m).geometry.index_count, 3 * times * triangles);
    }
  }
  EXPECT_FALSE(before.report["meshes"][0].contains("source_triangles"));
}

INSTANTIATE_TEST_SUITE_P(Codecs, FinerCodecs, testing::Values("none", "draco", "meshopt"));

// Levels are of the finer mesh.
TEST(CookSubdivide, LevelsOfDetailFollow) {
  const LoadedCook fine(cook_file(kNewtSource, finer(1, "none", "--lod 0.25")));
  const std::size_t triangles = fine.report["meshes"][0]["triangles"];
  EXPECT_NEAR(fine.file.mesh(0, 1).geometry.index_count, 0.75 * static_cast<double>(triangles), 12);
}

TEST(CookSubdivide, SameBytesEveryTime) {
  const std::string source = test::in_long_form() ? kNewtSource : test::in_golden("elbow.gltf");
  EXPECT_EQ(cook_file(source, finer(1, "meshopt")).file, cook_file(source, finer(1, "meshopt")).file);
}

}  // namespace
}  // namespace marrow::cook
