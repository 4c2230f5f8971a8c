// Meshes through each codec, from the cooker to the loader: what comes back is the source's surface within what is
// stated, whatever the mesh looks like.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "common/failure.h"
#include "common/unpack_mrw.h"
#include "disk/cook_on_disk.h"
#include "marrow/unpack.h"
#include "support/double_math.h"
#include "support/pose_file.h"
#include "unpack/packed.h"

namespace marrow::cook {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A scene of one mesh, skinned to `joints` joints in a row along x.
RawScene scene_of(RawPrimitive primitive, int joints) {
  RawScene scene;
  RawSkin skin;
  for (int j = 0; j < joints; ++j) {
    RawNode node;
    node.name = "joint" + std::to_string(j);
    node.parent = j - 1;
    node.translation = {j == 0 ? 0.0 : 0.5, 0, 0};
    scene.nodes.push_back(node);
    skin.joints.push_back(j);
    glm::dmat4 bind(1.0);
    bind[3][0] = -0.5 * j;
    skin.inverse_bind.push_back(bind);
  }
  RawNode holder;
  holder.name = "mesh";
  scene.nodes.push_back(holder);
  primitive.pointer = "/meshes/0/primitives/0";
  RawMesh& mesh = scene.meshes.emplace_back();
  mesh.name = "mesh";
  mesh.primitives.push_back(std::move(primitive));
  scene.skins.push_back(skin);
  scene.instances.push_back({joints, 0, joints > 0 ? 0 : kNone, {}});
  return scene;
}

// A tube of n by m quads with a seam in its UVs, everything that a vertex can carry, up to `influences` a vertex.
RawPrimitive tube(int n, int m, int joints, int influences) {
  RawPrimitive p;
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; k <= m; ++k) {
      const double a = 2 * kPi * (k % m) / m, x = 0.5 * (joints - 1) * i / n, r = 0.1 + 0.02 * std::sin(9.0 * x);
      p.positions.emplace_back(x, r * std::cos(a), r * std::sin(a));
      p.normals.emplace_back(glm::normalize(glm::dvec3(-0.18 * std::cos(9.0 * x), std::cos(a), std::sin(a))));
      p.tangents.emplace_back(0, -std::sin(a), std::cos(a), k % 2 == 0 ? 1 : -1);
      p.uvs.emplace_back(3.0 * i / n - 1, double(k) / m);
      p.colours.emplace_back(i % 2, 0.25, 0.5, 1);
      std::vector<RawInfluence> at;
      for (int j = 0; j < influences; ++j) {
        const int joint = (i * joints / (n + 1) + j) % joints;
        at.push_back({static_cast<std::uint32_t>(joint), static_cast<float>(1.0 / (1 + j + (i + k) % 3))});
      }
      p.influences.push_back(at);
    }
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>(i * (m + 1) + k); };
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < m; ++k)
      p.indices.insert(p.indices.end(),
                       {at(i, k), at(i + 1, k), at(i, k + 1), at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
  return p;
}

struct Loaded {
  tools::AlignedBytes bytes;
  File file;
  nlohmann::ordered_json report;
  std::size_t cooked_bytes = 0;
};

Loaded cook_and_load(RawScene scene, const CookOptions& options) {
  const Result cooked = cook_scene(std::move(scene), options);
  const std::span<const std::byte> bytes(cooked.file);
  const bool packed = is_packed({bytes.data(), bytes.size()});
  EXPECT_EQ(packed, options.mesh.codec != MeshCodec::none);
  Loaded out;
  out.bytes = packed ? tools::unpacked(bytes, "test") : tools::AlignedBytes(bytes);
  DataError error;
  EXPECT_EQ(load({out.bytes.data(), out.bytes.size()}, out.file, &error), Status::ok) << error.rule;
  out.report = cooked.report;
  out.cooked_bytes = bytes.size();
  return out;
}

// More attributes than Draco counts.
TEST(Codecs, ManyMorphTargetsGoThroughAnother) {
  RawPrimitive p = tube(6, 5, 2, 2);
  for (int t = 0; t < 130; ++t) {
    RawTarget& target = p.targets.emplace_back();
    target.positions.resize(p.positions.size());
    target.normals.resize(p.positions.size());
    const std::size_t moved = static_cast<std::size_t>(t) % p.positions.size();
    target.positions[moved] = {0.1F, 0, 0};
    target.normals[moved] = {0, 0.5F, 0};
  }
  RawScene scene = scene_of(std::move(p), 2);
  scene.instances[0].weights.resize(130);
  const Loaded cooked = cook_and_load(std::move(scene), {});
  EXPECT_EQ(cooked.report["meshes"][0]["codec"], "meshopt");
  EXPECT_EQ(cooked.file.mesh(0).targets.size, 130u);
}

// At rest, how far vertices are from where this map takes the source's.
double farthest_from(const Loaded& cooked, const std::vector<glm::vec3>& source, const glm::dmat4& model_from_mesh) {
  const Mesh mesh = cooked.file.mesh(0);
  const test::PosedMesh posed = test::pose_mesh(cooked.file, cooked.file.clip_count(), 0, 0, test::Deformer::ssd);
  double worst = 0;
  for (std::size_t v = 0; v < source.size(); ++v) {
    const std::size_t slot = mesh.geometry.source_slots[v];
    if (slot == kNoSlot) continue;
    const glm::dvec3 want(model_from_mesh * glm::dvec4(glm::dvec3(source[v]), 1));
    glm::dvec3 got;
    for (int c = 0; c < 3; ++c) got[c] = static_cast<double>(posed.positions[3 * slot + static_cast<std::size_t>(c)]);
    worst = std::max(worst, glm::length(got - want));
  }
  return worst;
}

// A tenth of a millimetre is one of the scene's, whatever the units of the mesh are.
TEST(Codecs, PositionErrorsAreInTheScenesUnits) {
  const RawPrimitive source = tube(8, 7, 3, 2);
  constexpr double kMost = 1e-4, kFloats = 3e-5;  // 32-bit floats, two at 217 m
  for (const glm::dvec3& scale :
       {glm::dvec3(217), glm::dvec3(-217, 217, 217), glm::dvec3(217, 3, -40), glm::dvec3(0.01)})
    for (const bool skinned : {true, false}) {
      RawScene scene = scene_of(source, skinned ? 3 : 0);
      glm::dmat4 map = glm::scale(glm::dmat4(1.0), scale);
      if (skinned) {
        scene.nodes[0].scale = scale;
      } else {  // turned below a scale, and so sheared
        scene.nodes[0].parent = 1;
        scene.nodes[0].rotation = glm::angleAxis(0.5, glm::normalize(glm::dvec3(1, 2, 3)));
        map = map * glm::mat4_cast(scene.nodes[0].rotation);
        scene.nodes.emplace_back().scale = scale;
      }
      CookOptions options;
      options.mesh.codec = MeshCodec::meshopt;
      options.mesh.keep_vertex_order = true;
      options.mesh.position_error = kMost;
      options.mesh.precision.weight_error = 1e-6;
      const Loaded cooked = cook_and_load(std::move(scene), options);
      const double stated = cooked.report["meshes"][0]["max_position_error_m"].get<double>();
      const double found = farthest_from(cooked, source.positions, map);
      EXPECT_LE(stated, kMost * 1.001) << scale.x << ' ' << skinned;
      EXPECT_LE(found, stated + kFloats) << scale.x << ' ' << skinned;
      EXPECT_GE(stated, 0.5 * kMost) << "no finer than asked for";
      EXPECT_GE(found, 0.25 * stated) << scale.x << ' ' << skinned;
    }
}

// Joint of the skeleton → weight, of one slot; and that the weights sum to one.
std::map<int, double> weights_of(const Mesh& mesh, std::uint32_t slot) {
  std::uint32_t first_slot = 0;
  const std::uint16_t* set = mesh.geometry.sets;
  const float* skin = mesh.geometry.skin;
  for (const Run& run : mesh.geometry.runs) {
    const std::uint32_t blocks = (run.vertex_count + 3) / 4;
    if (slot < first_slot + 4 * blocks) {
      const float* const block = skin + std::size_t{(slot - first_slot) / 4} * (12 + 4 * (run.influences - 1));
      std::map<int, double> out;
      float left = 1;
      for (std::uint32_t j = 0; j < run.influences; ++j) {
        const float w = j + 1 < run.influences ? block[12 + 4 * j + (slot - first_slot) % 4] : left;
        EXPECT_GT(w, -1e-6f);
        left -= w;
        out[mesh.joints[set[j]]] += static_cast<double>(w);
      }
      return out;
    }
    first_slot += 4 * blocks;
    set += run.influences;
    skin += std::size_t{blocks} * (12 + 4 * (run.influences - 1));
  }
  ADD_FAILURE() << "no such slot";
  return {};
}

std::array<double, 3> position_of(const Geometry& g, std::uint32_t slot) {
  std::uint32_t first_slot = 0;
  const float* skin = g.skin;
  for (const Run& run : g.runs) {
    const std::uint32_t blocks = (run.vertex_count + 3) / 4;
    const std::size_t floats = 12 + 4 * (run.influences - 1);
    if (slot < first_slot + 4 * blocks) {
      const float* const block = skin + (slot - first_slot) / 4 * floats + slot % 4;
      return {double{block[0]}, double{block[4]}, double{block[8]}};
    }
    first_slot += 4 * blocks;
    skin += blocks * floats;
  }
  return {};
}

std::uint32_t index_at(const Geometry& g, std::size_t i) {
  return g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                            : static_cast<const std::uint32_t*>(g.indices)[i];
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

void add_rotated(std::array<std::uint32_t, 3> t, Triangles& out) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  out.push_back(t);
}

// Every vertex that a triangle uses, in all that it carries; then the triangles.
void expect_surface(const RawPrimitive& source, const Loaded& loaded, const CookOptions& options) {
  const Mesh mesh = loaded.file.mesh(0);
  const Geometry& g = mesh.geometry;
  ASSERT_EQ(g.source_slots.size, source.positions.size());
  const double position_error = loaded.report["meshes"][0]["max_position_error_m"].get<double>();
  const bool exact = options.mesh.codec == MeshCodec::none;
  EXPECT_EQ(position_error == 0, exact);
  std::size_t compared = 0;
  for (std::size_t v = 0; v < source.positions.size(); ++v) {
    const std::uint32_t slot = g.source_slots[v];
    if (slot == kNoSlot) {
      EXPECT_EQ(std::count(source.indices.begin(), source.indices.end(), v), 0) << "a used vertex is left out";
      continue;
    }
    ++compared;
    const std::array<double, 3> at = position_of(g, slot);
    double off = 0;
    for (int c = 0; c < 3; ++c) off += std::pow(at[static_cast<std::size_t>(c)] - double{source.positions[v][c]}, 2);
    ASSERT_LE(std::sqrt(off), position_error + 1e-12) << v;
    double angle = 0;
    for (std::size_t c = 0; c < 3 && g.normals != nullptr; ++c)
      angle += double{g.normals[slot / 4 * 12 + 4 * c + slot % 4]} * double{source.normals[v][static_cast<int>(c)]};
    if (g.normals != nullptr && !source.normals.empty()) {
      ASSERT_LE(std::acos(std::min(1.0, angle)) * 180 / kPi,
                exact ? 0.05 : options.mesh.precision.normal_error_deg + 0.05);
    }
    if (!source.tangents.empty()) {
      ASSERT_EQ(g.tangents[slot / 4 * 16 + 12 + slot % 4], source.tangents[v].w);
    }
    for (std::size_t c = 0; c < 2 && !source.uvs.empty(); ++c)
      ASSERT_NEAR(g.uvs[2 * slot + c], source.uvs[v][static_cast<int>(c)],
                  exact ? 0.0 : options.mesh.precision.uv_error * 1.001);
    for (std::size_t c = 0; c < 4 && !source.colours.empty(); ++c)
      ASSERT_EQ(g.colours[4 * slot + c], std::lround(source.colours[v][static_cast<int>(c)] * 255));
    if (source.influences.empty()) continue;
    std::map<int, double> want;
    double sum = 0;
    for (const RawInfluence& i : source.influences[v]) sum += double{i.weight};
    for (const RawInfluence& i : source.influences[v]) want[static_cast<int>(i.joint)] += double{i.weight} / sum;
    std::map<int, double> got = weights_of(mesh, slot);
    for (const auto& [joint, weight] : want) {
      ASSERT_NEAR(got[joint], weight, exact ? 1e-6 : options.mesh.precision.weight_error) << v << " joint " << joint;
      got.erase(joint);
    }
    ASSERT_TRUE(got.empty()) << v << ": a joint that the source does not name";
  }
  EXPECT_GT(compared, 0u);
  Triangles want, got;
  for (std::size_t i = 0; i < source.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> t{};
    for (std::size_t c = 0; c < 3; ++c) t[c] = g.source_slots[source.indices[i + c]];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) add_rotated(t, want);
  }
  for (std::size_t i = 0; i < g.index_count; i += 3)
    add_rotated({index_at(g, i), index_at(g, i + 1), index_at(g, i + 2)}, got);
  const auto places = [&](Triangles triangles) {  // a vertex may have been split: by what it holds
    std::vector<std::array<std::array<double, 3>, 3>> out;
    for (const auto& t : triangles) {
      std::array<std::array<double, 3>, 3> p{};
      for (std::size_t c = 0; c < 3; ++c) p[c] = position_of(g, t[c]);
      std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
      out.push_back(p);
    }
    std::sort(out.begin(), out.end());
    return out;
  };
  EXPECT_EQ(want.size(), got.size());
  EXPECT_EQ(places(want), places(got));
}

class Codec : public ::testing::TestWithParam<MeshCodec> {
 protected:
  CookOptions options() const {
    CookOptions o;
    o.mesh.codec = GetParam();
    o.mesh.keep_vertex_order = true;
    return o;
  }
  Loaded expect_round_trip(const RawPrimitive& source, int joints) {
    Loaded loaded = cook_and_load(scene_of(source, joints), options());
    expect_surface(source, loaded, options());
    return loaded;
  }
};
INSTANTIATE_TEST_SUITE_P(All, Codec,
                         ::testing::Values(MeshCodec::draco, MeshCodec::draco_smallest, MeshCodec::meshopt,
                                           MeshCodec::none));

TEST_P(Codec, CarriesEverything) {
  const Loaded loaded = expect_round_trip(tube(24, 12, 5, 3), 5);
  const Geometry g = loaded.file.mesh(0).geometry;
  EXPECT_EQ(g.index_bytes, 2u);
  EXPECT_NE(g.tangents, nullptr);
  EXPECT_EQ(loaded.report["meshes"][0]["influences"], 3);
}

TEST_P(Codec, CarriesEightInfluences) {
  const Loaded loaded = expect_round_trip(tube(16, 8, 12, 8), 12);
  EXPECT_EQ(loaded.report["meshes"][0]["influences"], 8);
}

TEST_P(Codec, CarriesMoreVerticesThan16BitsCount) {
  RawPrimitive p = tube(700, 100, 3, 2);
  p.tangents.clear();
  p.colours.clear();
  const Loaded loaded = cook_and_load(scene_of(p, 3), options());
  const Geometry g = loaded.file.mesh(0).geometry;
  EXPECT_EQ(g.index_bytes, 4u);
  EXPECT_EQ(g.index_count, p.indices.size());
  EXPECT_GT(g.slot_count, 65536u);
}

TEST_P(Codec, CarriesRigidMeshes) {
  RawPrimitive p = tube(6, 5, 2, 1);
  p.influences.clear();
  expect_round_trip(p, 0);
}

RawPrimitive triangles(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices) {
  RawPrimitive p;
  p.positions = positions;
  p.normals.assign(positions.size(), glm::vec3(0, 0, 1));
  p.indices = indices;
  return p;
}

TEST_P(Codec, KeepsOddSurfaces) {
  // Three triangles on one edge; two that touch in a point; a single one; one turned over; all in one plane.
  const std::vector<glm::vec3> p = {{0, 0, 0},       {1, 0, 0},      {0, 1, 0},  {0, -1, 0},
                                    {0.5f, 0.5f, 0}, {-1, 0.25f, 0}, {-1, -1, 0}};
  expect_round_trip(triangles(p, {0, 1, 2, 1, 0, 3, 0, 1, 4}), 0);
  expect_round_trip(triangles(p, {0, 1, 2, 0, 5, 6}), 0);
  expect_round_trip(triangles(p, {0, 1, 2}), 0);
  expect_round_trip(triangles(p, {0, 1, 2, 0, 2, 1}), 0);
  expect_round_trip(triangles(p, {0, 1, 2, 0, 1, 2}), 0);
}

TEST_P(Codec, DropsWhatNoPoseShows) {
  const std::vector<glm::vec3> p = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 5, 5}, {1, 1, 0}};
  // A triangle without area, a copy of vertex 1, and a vertex that nothing uses.
  const Loaded loaded = expect_round_trip(triangles(p, {0, 1, 2, 1, 3, 2, 1, 1, 0, 2, 3, 5}), 0);
  const Geometry g = loaded.file.mesh(0).geometry;
  EXPECT_EQ(g.index_count, 6u);
  EXPECT_EQ(g.vertex_count, 4u);
  EXPECT_EQ(g.source_slots[1], g.source_slots[3]);
  EXPECT_EQ(g.source_slots[4], kNoSlot);
}

TEST_P(Codec, KeepsTrianglesThatOpenWhenPosed) {
  // A strip whose second row lies on the first, bound to another joint.
  RawPrimitive p = triangles({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}},
                             {0, 1, 3, 1, 4, 3, 1, 2, 4, 2, 5, 4, 0, 6, 1});
  for (int v = 0; v < 7; ++v) p.influences.push_back({{v < 3 || v == 6 ? 0u : 1u, 1.0f}});
  const Loaded loaded = expect_round_trip(p, 2);
  EXPECT_EQ(loaded.file.mesh(0).geometry.index_count, 15u);
}

// Whoever asks for the source's order finds each vertex where the source has it, with its own normal.
TEST_P(Codec, KeepsTheVerticesOfTrianglesWithoutArea) {
  const std::vector<glm::vec3> at = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0},
                                     {2, 3, 1}, {2, 3, 1}, {3, 0, 2}, {-2, 0, 0}};
  // Vertex 3 is vertex 1 with another normal; 4 and 5 share a place, 6 and 7 have theirs alone.
  RawPrimitive p = triangles(at, {0, 1, 2, 1, 3, 2, 4, 5, 6, 7, 7, 7, 6, 4, 4});
  p.normals[3] = {0, 1, 0};
  const Loaded loaded = cook_and_load(scene_of(p, 0), options());
  const Geometry g = loaded.file.mesh(0).geometry;
  EXPECT_EQ(g.index_count, 12u) << "what has an area, and one triangle for each vertex that would be lost";
  EXPECT_NE(g.source_slots[1], g.source_slots[3]);
  EXPECT_EQ(g.source_slots[4], g.source_slots[5]);
  ASSERT_EQ(g.source_slots.size, at.size());
  for (std::size_t v = 0; v < at.size(); ++v) {
    ASSERT_NE(g.source_slots[v], kNoSlot) << v;
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(position_of(g, g.source_slots[v])[c], at[v][static_cast<int>(c)], 1e-3) << v;
  }
  CookOptions anyhow = options();
  anyhow.mesh.keep_vertex_order = false;
  EXPECT_EQ(cook_and_load(scene_of(p, 0), anyhow).file.mesh(0).geometry.index_count, 3u);
}

// A mesh of nothing but such triangles is legal, and stays a mesh.
TEST_P(Codec, KeepsOneTriangleOfAMeshWithoutArea) {
  const RawPrimitive p = triangles({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 1, 2});
  const Loaded loaded = cook_and_load(scene_of(p, 0), options());
  EXPECT_EQ(loaded.file.mesh(0).geometry.index_count, 3u);
}

TEST_P(Codec, MakesTheSameBytesAgain) {
  const Result a = cook_scene(scene_of(tube(20, 9, 4, 4), 4), options());
  const Result b = cook_scene(scene_of(tube(20, 9, 4, 4), 4), options());
  EXPECT_EQ(a.file, b.file);
}

TEST(MeshPrecision, IsKept) {
  const RawPrimitive source = tube(40, 16, 4, 4);
  std::size_t last = 0;
  for (const double error_m : {1e-2, 1e-3, 1e-4, 1e-5}) {
    CookOptions options;
    options.mesh.keep_vertex_order = true;
    options.mesh.position_error = error_m;
    options.mesh.precision = {error_m * 1e3, error_m, std::min(0.1, 10 * error_m)};
    const Loaded loaded = cook_and_load(scene_of(source, 4), options);
    expect_surface(source, loaded, options);
    const auto& report = loaded.report["meshes"][0];
    EXPECT_LE(report["max_position_error_m"].get<double>(), error_m);
    EXPECT_GT(report["max_position_error_m"].get<double>(), error_m / 4) << "no finer than asked for";
    EXPECT_LE(report["max_normal_error_deg"].get<double>(), options.mesh.precision.normal_error_deg);
    EXPECT_LE(report["max_uv_error"].get<double>(), options.mesh.precision.uv_error * 1.0001);
    EXPECT_LE(report["max_weight_error"].get<double>(), options.mesh.precision.weight_error);
    EXPECT_GT(loaded.cooked_bytes, last);
    last = loaded.cooked_bytes;
  }
}

TEST(MeshPrecision, PartsOfAMeshMeet) {
  RawPrimitive left = triangles({{0, 0, 0}, {0.37f, 0.11f, 0}, {0.1f, 0.91f, 0}}, {0, 1, 2});
  RawPrimitive right = triangles({{3, 3, 3}, {0.37f, 0.11f, 0}, {0.1f, 0.91f, 0}}, {0, 2, 1});
  RawScene scene = scene_of(left, 0);
  right.pointer = "/meshes/0/primitives/1";
  scene.meshes[0].primitives.push_back(right);
  CookOptions options;
  options.mesh.keep_vertex_order = true;
  const Loaded loaded = cook_and_load(std::move(scene), options);
  ASSERT_EQ(loaded.file.mesh_count(), 2u);
  const Geometry a = loaded.file.mesh(0).geometry, b = loaded.file.mesh(1).geometry;
  for (const std::size_t v : {1u, 2u})
    EXPECT_EQ(position_of(a, a.source_slots[v]), position_of(b, b.source_slots[v])) << "to the bit";
}

TEST(PackedFile, TheSmallestIsTheSameSurfaceInNoMoreBytes) {
  CookOptions options;
  options.mesh.keep_vertex_order = true;
  const RawPrimitive source = tube(40, 30, 3, 3);
  const Loaded quick = cook_and_load(scene_of(source, 3), options);
  options.mesh.codec = MeshCodec::draco_smallest;
  const Loaded smallest = cook_and_load(scene_of(source, 3), options);
  EXPECT_LE(smallest.cooked_bytes, quick.cooked_bytes);
  expect_surface(source, smallest, options);
  EXPECT_EQ(smallest.file.mesh(0).geometry.vertex_count, quick.file.mesh(0).geometry.vertex_count);
}

// Damage behind a checksum that fits: refused, or harmless all the way to the vertices.
TEST(PackedFile, DamageIsRefusedOrHarmless) {
  for (const MeshCodec codec : {MeshCodec::draco, MeshCodec::meshopt}) {
    CookOptions options;
    options.mesh.codec = codec;
    const Result cooked = cook_scene(scene_of(tube(10, 7, 3, 3), 3), options);
    std::mt19937 random(7);
    std::size_t refused = 0, harmless = 0;
    for (int i = 0; i < 1500; ++i) {
      std::vector<std::byte> bytes = cooked.file;
      for (auto n = 1 + random() % 3; n > 0; --n)
        bytes[32 + random() % (bytes.size() - 32)] = static_cast<std::byte>(random());
      const std::uint64_t sum = format::checksum(bytes.data() + 32, bytes.size() - 32);
      std::memcpy(bytes.data() + 24, &sum, sizeof sum);
      try {
        const tools::AlignedBytes block = tools::unpacked(bytes, "test");
        File file;
        if (load({block.data(), block.size()}, file) == Status::ok) {
          test::exercise(file);
          ++harmless;
          continue;
        }
      } catch (const tools::Failure&) {
      }
      ++refused;
    }
    EXPECT_EQ(refused + harmless, 1500u);
    EXPECT_GT(refused, 100u);
    EXPECT_GT(harmless, 100u);
  }
}

}  // namespace
}  // namespace marrow::cook
