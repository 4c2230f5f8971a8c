// The finer mesh, from the option to what the runtime draws, beside Loop's scheme written anew.
#include "cook/subdivide.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "common/failure.h"
#include "cook/cook.h"
#include "cook/gltf/read.h"
#include "cook/options.h"
#include "unit/cook/loaded_cook.h"

namespace marrow::cook {
namespace {

const std::string kTiny = std::string(MARROW_SOURCE_DIR) + "/tests/golden/tiny.gltf";
const std::string kNewt = std::string(MARROW_SOURCE_DIR) + "/tools/sample/newt.glb";

using Corners = std::array<std::uint32_t, 3>;
using Places = std::vector<glm::dvec3>;

// Points and triangles, without seams.
struct Net {
  Places at;
  std::vector<Corners> triangles;
};

// Loop 1987, in his own form: a(n) of the point and the rest of its neighbours' mean, a(n) = (3/8 + cos(2π/n)/4)² +
// 3/8.
Net looped(const Net& net) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> opposite;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
  for (const Corners& t : net.triangles)
    for (std::size_t k = 0; k < 3; ++k) opposite[std::minmax(t[k], t[(k + 1) % 3])].push_back(t[(k + 2) % 3]);
  Net out;
  std::vector<std::vector<std::uint32_t>> ring(net.at.size()), border(net.at.size());
  for (const auto& [edge, ends] : opposite) {
    const auto& [a, b] = edge;
    ring[a].push_back(b), ring[b].push_back(a);
    if (ends.size() == 1) border[a].push_back(b), border[b].push_back(a);
  }
  for (std::size_t p = 0; p < net.at.size(); ++p) {
    const std::vector<std::uint32_t>& around = border[p].empty() ? ring[p] : border[p];
    glm::dvec3 mean(0);
    for (const std::uint32_t q : around) mean += net.at[q] / static_cast<double>(around.size());
    const double part = 3.0 / 8 + std::cos(2 * std::numbers::pi / static_cast<double>(around.size())) / 4;
    const double own = around.empty() ? 1 : border[p].empty() ? part * part + 3.0 / 8 : 0.75;
    out.at.push_back(net.at[p] * own + mean * (1 - own));
  }
  for (const auto& [edge, ends] : opposite) {
    middle[edge] = static_cast<std::uint32_t>(out.at.size());
    const glm::dvec3 sum = net.at[edge.first] + net.at[edge.second];
    out.at.push_back(ends.size() == 2 ? (sum * 3.0 + net.at[ends[0]] + net.at[ends[1]]) / 8.0 : sum / 2.0);
  }
  for (const auto& [a, b, c] : net.triangles) {
    const std::uint32_t ab = middle.at(std::minmax(a, b)), bc = middle.at(std::minmax(b, c)),
                        ca = middle.at(std::minmax(c, a));
    out.triangles.insert(out.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return out;
}

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

// For each of `from` the nearest of `to`, which must be within `most`.
std::vector<std::uint32_t> nearest(const Places& from, const Places& to, double most) {
  std::vector<std::pair<double, std::uint32_t>> by_x;
  for (std::uint32_t i = 0; i < to.size(); ++i) by_x.emplace_back(to[i].x, i);
  std::ranges::sort(by_x);
  std::vector<std::uint32_t> out;
  std::size_t lost = 0;
  for (const glm::dvec3& v : from) {
    double best = most;
    std::uint32_t found = 0;
    for (auto at = std::ranges::lower_bound(by_x, std::pair(v.x - most, 0u)); at != by_x.end(); ++at) {
      if (at->first > v.x + most) break;
      const double distance = glm::length(to[at->second] - v);
      if (distance < best) best = distance, found = at->second;
    }
    lost += best == most ? 1u : 0u;
    out.push_back(found);
  }
  EXPECT_EQ(lost, 0u) << "of " << from.size();
  return out;
}

CookOptions finer(int steps, MeshCodec codec = MeshCodec::none, bool fits = true) {
  CookOptions options;
  options.subdivide = steps;
  options.mesh_codec = codec;
  options.raw_clips = true;
  if (fits) {
    options.learn.animation_space = AnimationSpace::fit;
    options.learn.truth = Truth::dual_quaternions;
    options.learn.half_joints = 1;
  }
  return options;
}

const LoadedCook& fitted_newt() {
  static const LoadedCook cooked(cook_file(kNewt, finer(0)));
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

// The newt measures 1.6 m. Without quantisation single precision is left, and points that would follow nine joints or
// more: one in two hundred.
TEST(CookSubdivide, PosingTheFinerNewtIsSubdividingThePosedOne) {
  const LoadedCook fine(cook_file(kNewt, finer(1)));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  ASSERT_GT(fine.file.mesh(0).half_joints.size, 0u);
  EXPECT_EQ(fine.report["warnings"][0]["rule"], "influences-dropped");
  const Distance distance = distance_from_loop(fitted_newt().file, fine.file, 1e-6);
  EXPECT_LT(distance.off, 0.005);
  EXPECT_LT(distance.rms, 2e-6);
  EXPECT_LT(distance.worst, 3e-4);
}

// Packed, positions are rounded by up to 0.09 mm, weights by 1/4000 of how far joints take a vertex apart, residuals by
// a quarter of what the fit leaves, an influence each. The coarse newt is then 0.14 mm off, 1.2 mm at worst.
TEST(CookSubdivide, SoItIsPacked) {
  const LoadedCook fine(cook_file(kNewt, finer(1, MeshCodec::meshopt)));
  const Distance distance = distance_from_loop(fitted_newt().file, fine.file, 2e-4);
  EXPECT_LT(distance.rms, 2e-4);
  EXPECT_LT(distance.worst, 2.5e-3);
}

TEST(CookSubdivide, SoItIsTwice) {
  CookOptions options = finer(0, MeshCodec::none, false);
  options.learn.animation_space = AnimationSpace::smooth;
  const LoadedCook coarse(cook_file(kTiny, options));
  options.subdivide = 2;
  const LoadedCook fine(cook_file(kTiny, options));
  ASSERT_NE(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Distance distance = distance_from_loop(coarse.file, fine.file, 1e-5, 2);
  EXPECT_EQ(distance.off, 0);
}

// The lift is linear blend skinning of the finer mesh, which is nearly the posed mesh subdivided.
TEST(CookSubdivide, TheLiftHasNoResidual) {
  const LoadedCook coarse(cook_file(kNewt, finer(0, MeshCodec::none, false))),
      fine(cook_file(kNewt, finer(1, MeshCodec::none, false)));
  EXPECT_EQ(fine.file.mesh(0).geometry.as_residual, nullptr);
  const Distance distance = distance_from_loop(coarse.file, fine.file, 1e-6);
  EXPECT_GT(distance.off, 0.1);
  EXPECT_LT(distance.rms, 3e-4);
  EXPECT_LT(distance.worst, 5e-3);
}

// The left half of the body has vertices and UVs of its own.
RawScene cut_newt() {
  RawScene scene = read_gltf(kNewt);
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
  const LoadedCook fine(cook_scene(cut_newt(), finer(1)));
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
  EXPECT_LT(distance_from_loop(fitted_newt().file, fine.file, 1e-6).off, 0.005);
}

class FinerCodecs : public testing::TestWithParam<MeshCodec> {};

TEST_P(FinerCodecs, FourTimesTheTriangles) {
  const CookResult before = cook_file(kTiny, finer(0, GetParam(), false));
  std::size_t times = 1;
  for (int steps = 1; steps <= kMostSubdivisions; ++steps) {
    const LoadedCook after(cook_file(kTiny, finer(steps, GetParam(), false)));
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

INSTANTIATE_TEST_SUITE_P(Codecs, FinerCodecs, testing::Values(MeshCodec::none, MeshCodec::draco, MeshCodec::meshopt));

// Levels are of the finer mesh.
TEST(CookSubdivide, LevelsOfDetailFollow) {
  CookOptions options = finer(1, MeshCodec::none, false);
  options.lod = {{0.25}};
  const LoadedCook fine(cook_file(kNewt, options));
  const std::size_t triangles = fine.report["meshes"][0]["triangles"];
  EXPECT_NEAR(fine.file.mesh(0, 1).geometry.index_count, 0.75 * static_cast<double>(triangles), 12);
}

TEST(CookSubdivide, SameBytesEveryTime) {
  const RawScene scene = read_gltf(kNewt);
  const CookOptions options = finer(1, MeshCodec::meshopt);
  EXPECT_EQ(cook_scene(scene, options).file, cook_scene(scene, options).file);
}

// Meshes in memory.

// Squares of side 1 over [0, side]², two triangles each, in the plane z = 0, facing up.
RawPrimitive grid(std::uint32_t side) {
  RawPrimitive out;
  out.pointer = "/meshes/0/primitives/0";
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) {
      out.positions.emplace_back(x, y, 0);
      out.normals.emplace_back(0, 0, 1);
      out.tangents.emplace_back(1, 0, 0, -1);
      out.uvs.emplace_back(x, y);
      out.colours.emplace_back(x, 0, 0, 1);
    }
  const std::uint32_t row = side + 1;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      const std::uint32_t a = y * row + x;
      out.indices.insert(out.indices.end(), {a, a + 1, a + row + 1, a, a + row + 1, a + row});
    }
  return out;
}

std::size_t border_edges(const RawPrimitive& p) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> triangles;
  for (std::size_t i = 0; i < p.indices.size(); ++i)
    ++triangles[std::minmax(p.indices[i], p.indices[i % 3 == 2 ? i - 2 : i + 1])];
  return static_cast<std::size_t>(std::ranges::count_if(triangles, [](const auto& e) { return e.second == 1; }));
}

TEST(CookSubdivide, AFlatGridStaysFlatWithinItsBorders) {
  RawMesh mesh{"", {}, {grid(4)}};
  EXPECT_EQ(subdivide_mesh(mesh, {}, 2), 0u);
  const RawPrimitive& p = mesh.primitives[0];
  ASSERT_EQ(p.positions.size(), 17u * 17);
  EXPECT_EQ(p.indices.size(), 16u * 32 * 3);
  EXPECT_EQ(border_edges(p), 4u * 16);
  std::size_t on_border = 0, in_order = 0;
  double area = 0;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    const glm::vec3& at = p.positions[v];
    EXPECT_EQ(at.z, 0);
    EXPECT_EQ(p.normals[v], glm::vec3(0, 0, 1));
    EXPECT_EQ(p.tangents[v], glm::vec4(1, 0, 0, -1));
    EXPECT_TRUE(at.x >= 0 && at.x <= 4 && at.y >= 0 && at.y <= 4);
    EXPECT_EQ(p.colours[v].x, p.uvs[v].x) << "both linear in what they were";
    on_border += at.x == 0 || at.x == 4 || at.y == 0 || at.y == 4 ? 1u : 0u;
    in_order += glm::vec2(at) == p.uvs[v] ? 1u : 0u;
  }
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const glm::vec3 a = p.positions[p.indices[i]], b = p.positions[p.indices[i + 1]], c = p.positions[p.indices[i + 2]];
    const double up = glm::cross(b - a, c - a).z;
    EXPECT_GT(up, 0) << "no triangle turns over";
    area += up / 2;
  }
  // At each corner five points leave the border: itself, in the second step its neighbours and the middles between.
  EXPECT_EQ(on_border, 4u * 16 - 4 * 5);
  EXPECT_GT(in_order, p.positions.size() / 2);
  EXPECT_GT(area, 16 - 4 * 0.2);
  EXPECT_LT(area, 16);
}

// A cube of edge 2 about the origin, each side with vertices of its own; normals of the sides, or of the corners.
RawPrimitive cube(bool hard) {
  RawPrimitive out;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    const auto first = static_cast<std::uint32_t>(out.positions.size());
    for (const auto& [a, b] : {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
      glm::vec3 v(0);
      v[axis] = sign;
      v[(axis + 1) % 3] = a;
      v[(axis + 2) % 3] = b * sign;
      out.positions.push_back(v);
      glm::vec3 normal(0);
      normal[axis] = sign;
      out.normals.push_back(hard ? normal : glm::normalize(v));
      out.uvs.emplace_back(side, a + 2 * b);
    }
    out.indices.insert(out.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }
  return out;
}

using Key = std::tuple<float, float, float>;
Key key(const glm::vec3& v) {
  return {v.x, v.y, v.z};
}

TEST(CookSubdivide, HardEdgesStayHardAndSmoothOnesSmooth) {
  for (const bool hard : {false, true}) {
    RawMesh mesh{"", {}, {cube(hard)}};
    subdivide_mesh(mesh, {}, 2);
    const RawPrimitive& p = mesh.primitives[0];
    std::map<Key, std::set<Key>> normals;
    std::map<Key, std::size_t> vertices;
    for (std::size_t v = 0; v < p.positions.size(); ++v) {
      EXPECT_NEAR(glm::length(p.normals[v]), 1, 1e-6);
      EXPECT_GT(glm::dot(p.normals[v], glm::normalize(p.positions[v])), hard ? 0.7 : 0.95);
      normals[key(p.positions[v])].insert(key(p.normals[v]));
      ++vertices[key(p.positions[v])];
    }
    EXPECT_EQ(normals.size(), 12u * 16 / 2 + 2) << "it is closed: Euler";
    std::size_t seams = 0;
    for (const auto& [at, of] : normals) {
      EXPECT_EQ(of.size(), hard ? vertices[at] : 1u);
      seams += vertices[at] > 1 ? 1u : 0u;
    }
    EXPECT_EQ(seams, 8u + 12 * 3);
  }
}

// Of the surface: area-weighted over the sides' own triangles.
TEST(CookSubdivide, NormalsAreTheFinerSurfaces) {
  RawMesh mesh{"", {}, {cube(true)}};
  subdivide_mesh(mesh, {}, 1);
  const RawPrimitive& p = mesh.primitives[0];
  std::vector<glm::dvec3> sums(p.positions.size(), glm::dvec3(0));
  for (std::size_t i = 0; i < p.indices.size(); i += 3) {
    const glm::dvec3 a(p.positions[p.indices[i]]), b(p.positions[p.indices[i + 1]]), c(p.positions[p.indices[i + 2]]);
    for (std::size_t k = 0; k < 3; ++k) sums[p.indices[i + k]] += glm::cross(b - a, c - a);
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    EXPECT_LT(glm::length(glm::normalize(sums[v]) - glm::dvec3(p.normals[v])), 1e-5);
}

// Normals that are not the surface's, as grass has them, stay what they are beside it.
TEST(CookSubdivide, NormalsOfTheArtistsOwnStay) {
  RawMesh mesh{"", {}, {grid(3)}};
  for (glm::vec3& n : mesh.primitives[0].normals) n = {0.6f, 0, 0.8f};
  subdivide_mesh(mesh, {}, 2);
  for (std::size_t v = 0; v < mesh.primitives[0].normals.size(); ++v) {
    EXPECT_LT(glm::length(mesh.primitives[0].normals[v] - glm::vec3(0.6f, 0, 0.8f)), 1e-6f);
    EXPECT_LT(glm::length(mesh.primitives[0].tangents[v] - glm::vec4(0.8f, 0, -0.6f, -1)), 1e-6f) << "at right angles";
  }
}

// Smoothing the mesh with a morph target on it, and smoothing both, is the same; directions go along edges.
TEST(CookSubdivide, MorphTargetsAreSmoothedToo) {
  RawPrimitive p = grid(3);
  RawTarget target;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    const auto number = static_cast<float>(v);
    target.positions.emplace_back(0, 0.125f * std::sin(number), std::cos(3 * number));
    target.normals.emplace_back(number, 0, 0);
    target.tangents.emplace_back(0, number, 0);
  }
  p.targets = {target};
  Net bind, morphed;
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    bind.at.emplace_back(p.positions[v]);
    morphed.at.push_back(bind.at[v] + glm::dvec3(target.positions[v]));
  }
  for (std::size_t i = 0; i < p.indices.size(); i += 3)
    bind.triangles.push_back({p.indices[i], p.indices[i + 1], p.indices[i + 2]});
  morphed.triangles = bind.triangles;
  RawMesh mesh{"", {{"t", "t", 0}}, {p}};
  subdivide_mesh(mesh, {}, 1);
  const RawPrimitive& fine = mesh.primitives[0];
  const Places rest = looped(bind).at, moved = looped(morphed).at;
  Places got;
  for (const glm::vec3& v : fine.positions) got.emplace_back(v);
  const std::vector<std::uint32_t> which = nearest(got, rest, 1e-6);
  for (std::size_t v = 0; v < got.size(); ++v)
    EXPECT_LT(glm::length(got[v] + glm::dvec3(fine.targets[0].positions[v]) - moved[which[v]]), 1e-6);
  // The first new vertex lies between 0 and 1.
  EXPECT_EQ(fine.targets[0].normals[16], glm::vec3(0.5f, 0, 0));
  EXPECT_EQ(fine.targets[0].tangents[16], glm::vec3(0, 0.5f, 0));
}

// Two primitives that touch, one of which a target leaves alone: where they touch it moves with the other.
TEST(CookSubdivide, PrimitivesStayClosedWhereTheyTouch) {
  RawPrimitive left = grid(2), right = grid(2);
  for (glm::vec3& v : right.positions) v.x += 2;
  left.targets.resize(1);
  right.targets.resize(1);
  for (const glm::vec3& v : left.positions) left.targets[0].positions.emplace_back(0, 0, v.x < 2 ? 1 : 0);
  RawMesh mesh{"", {{"t", "t", 0}}, {left, right}};
  subdivide_mesh(mesh, {}, 1);
  ASSERT_EQ(mesh.primitives[0].positions.size(), 25u);
  ASSERT_EQ(mesh.primitives[1].targets[0].positions.size(), 25u);
  std::size_t touching = 0, moved = 0;
  for (std::size_t a = 0; a < 25; ++a)
    for (std::size_t b = 0; b < 25; ++b) {
      const RawPrimitive &l = mesh.primitives[0], &r = mesh.primitives[1];
      if (l.positions[a] != r.positions[b]) continue;
      ++touching;
      EXPECT_EQ(l.targets[0].positions[a], r.targets[0].positions[b]);
      moved += r.targets[0].positions[b].z > 0 ? 1u : 0u;
    }
  EXPECT_EQ(touching, 5u);
  EXPECT_EQ(moved, 5u);
}

// A hub with a rim of twelve, each point on a joint of its own. By hand the hub has 1 - nβ and 12 times β.
struct Wheel {
  Wheel() {
    RawPrimitive p;
    p.pointer = "/meshes/0/primitives/0";
    binding.primitives.emplace_back();
    for (std::uint32_t k = 0; k <= 12; ++k) {
      const double angle = k * std::numbers::pi / 6, radius = k < 12 ? 1 : 0;
      p.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
      p.influences.push_back({{k, 1.0f}});
      binding.primitives[0].push_back({{k, 1.0}});
      if (k < 12) p.indices.insert(p.indices.end(), {12, k, (k + 1) % 12});
    }
    mesh.primitives.push_back(p);
  }
  // Every joint turns by an angle of its own about the hub.
  static std::vector<deform::Pose> poses() {
    std::vector<deform::Pose> out(3, deform::Pose(13, deform::Matrix(1.0)));
    for (std::size_t k = 0; k < 13; ++k) {
      const double turn = 0.1 * static_cast<double>(k);
      out[1][k] = {{std::cos(turn), std::sin(turn), 0}, {-std::sin(turn), std::cos(turn), 0}, {0, 0, 1}, {0, 0, 0}};
      out[2][k][3] = {0, 0, turn};
    }
    return out;
  }
  RawMesh mesh;
  SkinBinding binding;
};

TEST(CookSubdivide, VerticesKeepAsManyJointsAsTheyMayHave) {
  for (const double residual_step_m : {0.0, 1e-4}) {
    Wheel wheel;
    wheel.binding.residual_step_m = residual_step_m;
    EXPECT_EQ(subdivide_mesh(wheel.mesh, {{&wheel.binding, Wheel::poses}}, 1), 1u) << "the hub alone";
    const RawPrimitive& p = wheel.mesh.primitives[0];
    const std::vector<BoundVertex>& vertices = wheel.binding.primitives[0];
    ASSERT_EQ(vertices.size(), p.positions.size());
    ASSERT_EQ(p.influences.size(), p.positions.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      double weight = 0;
      glm::dvec4 sum(0);
      ASSERT_LE(vertices[v].size(), std::size_t{kMaxInfluences});
      for (const BoundInfluence& i : vertices[v]) {
        weight += i.weight;
        sum += i.residual;
        EXPECT_GE(i.weight, 0);
      }
      EXPECT_NEAR(weight, 1, 1e-9);
      EXPECT_LT(glm::length(sum), 1e-7) << "the bind pose stays, to single precision";
    }
    // In the last pose every joint lifts it by a tenth of its number.
    const double part = 3.0 / 8 + std::cos(std::numbers::pi / 6) / 4, beta = (5.0 / 8 - part * part) / 12;
    double lift = 0;
    for (const BoundInfluence& i : vertices[12]) lift += (i.weight + i.residual.w) * 0.1 * i.joint;
    EXPECT_NEAR(lift, (1 - 12 * beta) * 1.2 + beta * 6.6, 1e-4);
    // A spoke's middle, by hand: 3/8 of its ends, 1/8 of the two beside, each where it was.
    std::size_t spokes = 0;
    for (std::size_t v = 13; v < vertices.size(); ++v) {
      if (vertices[v].size() != 4) continue;
      ++spokes;
      std::vector<double> weights;
      for (const BoundInfluence& i : vertices[v]) {
        weights.push_back(i.weight);
        const glm::dvec3 from = i.joint == 12 ? glm::dvec3(0)
                                              : glm::dvec3(std::cos(i.joint * std::numbers::pi / 6),
                                                           std::sin(i.joint * std::numbers::pi / 6), 0);
        const glm::dvec3 wanted = residual_step_m > 0 ? (from - glm::dvec3(p.positions[v])) * i.weight : glm::dvec3(0);
        EXPECT_LT(glm::length(glm::dvec3(i.residual) - wanted), 1e-6);
      }
      std::ranges::sort(weights);
      EXPECT_NEAR(weights[1], 0.125, 1e-12);
      EXPECT_NEAR(weights[2], 0.375, 1e-12);
    }
    EXPECT_EQ(spokes, 12u);
  }
}

// Two at one place that follow different joints are two, as lips are that open.
TEST(CookSubdivide, WhatComesApartStaysApart) {
  RawPrimitive upper = grid(2), lower = grid(2);
  for (glm::vec3& v : lower.positions) v.y -= 2;
  SkinBinding binding;
  for (RawPrimitive* const p : {&upper, &lower}) {
    const std::uint32_t joint = p == &upper ? 0 : 1;
    p->influences.assign(9, {{joint, 1.0f}});
    binding.primitives.emplace_back(9, BoundVertex{{joint, 1.0}});
  }
  RawMesh mesh{"", {}, {upper, lower}};
  subdivide_mesh(mesh, {{&binding, {}}}, 1);
  for (std::uint32_t p = 0; p < 2; ++p)
    for (const BoundVertex& vertex : binding.primitives[p]) {
      ASSERT_EQ(vertex.size(), 1u);
      EXPECT_EQ(vertex[0].joint, p);
    }
}

TEST(CookSubdivide, TakesTrianglesThatAreNone) {
  RawMesh mesh{"", {}, {grid(1), RawPrimitive()}};
  mesh.primitives[0].positions[3] = mesh.primitives[0].positions[0];
  mesh.primitives[0].indices.insert(mesh.primitives[0].indices.end(), {0, 0, 1, 0, 3, 2, 1, 1, 1, 0, 1, 2, 0, 1, 2});
  const std::size_t corners = mesh.primitives[0].indices.size();
  subdivide_mesh(mesh, {}, 3);
  const RawPrimitive& p = mesh.primitives[0];
  EXPECT_EQ(p.indices.size(), 64 * corners);
  for (const std::uint32_t i : p.indices) ASSERT_LT(i, p.positions.size());
  for (std::size_t v = 0; v < p.positions.size(); ++v) {
    EXPECT_TRUE(glm::length(p.positions[v]) < 3);
    EXPECT_NEAR(glm::length(p.normals[v]), 1, 1e-6);
    EXPECT_NEAR(glm::length(glm::vec3(p.tangents[v])), 1, 1e-6);
  }
}

TEST(CookSubdivide, RefusesWhatWouldBeTooMuch) {
  RawScene scene;
  scene.source = "big.glb";
  scene.meshes.resize(2);
  for (RawMesh& mesh : scene.meshes) mesh.primitives.push_back(grid(100));
  scene.meshes[1].primitives[0].pointer = "/meshes/1/primitives/0";
  scene.instances = {{0, 0, kNone, {}, kNone}, {0, 0, kNone, {}, kNone}};
  scene.meshes[0].primitives[0].indices.resize(3 * 62'500);
  check_subdivision(scene, 3);  // 4 000 000, drawn twice
  scene.instances.push_back({0, 1, kNone, {}, kNone});
  check_subdivision(scene, 2);
  try {
    check_subdivision(scene, 3);
    ADD_FAILURE();
  } catch (const tools::Failure& failure) {
    EXPECT_EQ(failure.code(), tools::Exit::unsupported);
    EXPECT_EQ(failure.where(), "/meshes/1/primitives/0");
    EXPECT_EQ(failure.rule(), "too-many-triangles");
  }
  scene.meshes[0].primitives[0].targets.resize(32);
  check_subdivision(scene, 1);
  EXPECT_THROW(check_subdivision(scene, 2), tools::Failure);
}

}  // namespace
}  // namespace marrow::cook
