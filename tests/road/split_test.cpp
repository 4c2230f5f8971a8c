// Meshes in parts pose as they do whole: by every deformer, at every level of detail, in the source's order, exported.
#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "common/unpack_mrw.h"
#include "cook/gltf/read.h"
#include "disk/cook_on_disk.h"
#include "export/export.h"
#include "pose/evaluate.h"
#include "support/aligned.h"
#include "support/millipede.h"
#include "support/places.h"

namespace marrow::test {
namespace {

using cook::MeshCodec;

const std::string kNewt = newt_glb();
constexpr std::size_t kWhole = kMaxJoints;

struct CookedParts {
  CookedParts(cook::RawScene scene, cook::CookOptions options, std::size_t most, MeshCodec codec = MeshCodec::none) {
    options.mesh.most_entries = most;
    options.mesh.codec = codec;
    options.clips.raw = true;
    options.mesh.keep_vertex_order = true;
    const cook::Result result = cook::cook_scene(std::move(scene), options);
    if (codec == MeshCodec::none) {
      block = std::make_unique<AlignedBlock>(result.file.data(), result.file.size());
    } else {
      const tools::AlignedBytes unpacked = tools::unpacked(result.file, "");
      block = std::make_unique<AlignedBlock>(unpacked.data(), unpacked.size());
    }
    EXPECT_EQ(load(*block, file), Status::ok);
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) EXPECT_LE(file.mesh(m).palette_size(), most);
  }
  std::unique_ptr<AlignedBlock> block;
  File file;
};

using Three = std::array<float, 3>;

// What a deformer makes of each mesh, three numbers a slot.
using Slots = std::vector<std::vector<float>>;

// In the source's order, the parts of a primitive put together; what stands in several must be the same in all.
std::vector<Three> in_source_order(const File& file, const Slots& slots) {
  std::vector<Three> out;
  std::vector<bool> known;
  std::size_t first = 0;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    if (!mesh.is_next_part) {
      first = out.size();
      out.resize(first + mesh.geometry.source_slots.size);
      known.resize(out.size());
    }
    for (std::size_t v = 0; v < mesh.geometry.source_slots.size; ++v) {
      const std::uint32_t slot = mesh.geometry.source_slots[v];
      if (slot == kNoSlot) continue;
      const float* const at = &slots[m][std::size_t{3} * slot];
      if (known[first + v]) {
        EXPECT_EQ(out[first + v], (Three{at[0], at[1], at[2]})) << "a seam opens";
      }
      out[first + v] = {at[0], at[1], at[2]};
      known[first + v] = true;
    }
  }
  EXPECT_GT(std::ranges::count(known, true), 200);
  return out;
}

// Every deformer that the file has something for, at a moment of a clip.
struct Posed {
  std::vector<Three> ssd, as, mwe, psd;
};

std::vector<Three> family(const File& file, const tools::Character& character, bool multi_weights) {
  Slots slots;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Mesh mesh = file.mesh(m);
    const auto entries = character.palette(m);
    const Span<const Affine> palette{entries.data(), entries.size()};
    slots.emplace_back(std::size_t{3} * mesh.geometry.slot_count);
    std::vector<float> distances(psd_distance_count(mesh.geometry));
    if (multi_weights) {
      EXPECT_EQ(skin_mwe(mesh, palette, {slots.back(), {}, {}}), Status::ok);
    } else {
      EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
      EXPECT_EQ(skin_psd(mesh, distances, palette, {slots.back(), {}, {}}), Status::ok);
    }
  }
  return in_source_order(file, slots);
}

Posed pose(const File& file, float share) {
  tools::Character character(file);
  const tools::Play play = tools::play_together(file, file.clip_count() - 1);
  character.pose(play, share * play.duration_s);
  const auto all = [&](tools::Deformer deformer) {
    Slots slots;
    tools::PosedMesh posed;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      character.skin(m, deformer, posed);
      slots.push_back(posed.positions);
    }
    return in_source_order(file, slots);
  };
  Posed out{all(tools::Deformer::ssd), all(tools::Deformer::as), {}, {}};
  const Geometry g = file.mesh(0).geometry;
  if (g.mwe_residual != nullptr) out.mwe = family(file, character, true);
  if (!g.pose_space.examples.empty()) out.psd = family(file, character, false);
  return out;
}

// To the bit.
void expect_same(const CookedParts& parts, const CookedParts& whole) {
  ASSERT_GT(parts.file.mesh_count(), whole.file.mesh_count());
  for (const float share : {0.0f, 0.4f, 1.0f}) {
    const Posed a = pose(parts.file, share), b = pose(whole.file, share);
    EXPECT_EQ(a.ssd, b.ssd);
    EXPECT_EQ(a.as, b.as);
    EXPECT_EQ(a.mwe, b.mwe);
    EXPECT_EQ(a.psd, b.psd);
  }
}

class SplitCodecs : public ::testing::TestWithParam<MeshCodec> {};

TEST_P(SplitCodecs, AMillipedeOf2000JointsPosesAsAWhole) {
  Millipede millipede(400);
  millipede.add_targets();
  const CookedParts whole(millipede.scene, {}, kWhole, GetParam()), parts(millipede.scene, {}, 341, GetParam());
  ASSERT_EQ(whole.file.mesh_count(), 1u);
  ASSERT_EQ(whole.file.mesh(0).joint_count, 2000u);
  EXPECT_LE(parts.file.mesh_count(), 7u);
  expect_same(parts, whole);
  for (std::uint32_t m = 0; m < parts.file.mesh_count(); ++m)
    EXPECT_EQ(parts.file.mesh(m).targets.size, 2u) << "the second moves the first part alone";
  if (GetParam() == MeshCodec::none) expect_same(CookedParts(millipede.scene, {}, 24), whole);
}

TEST_P(SplitCodecs, TheNewtPosesAsAWhole) {
  const cook::RawScene newt = cook::read_gltf(kNewt);
  expect_same(CookedParts(newt, {}, 24, GetParam()), CookedParts(newt, {}, kWhole, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Codecs, SplitCodecs, testing::Values(MeshCodec::none, MeshCodec::draco, MeshCodec::meshopt));

// At rest it is turned so little that near its head inverse binds might follow from the rest pose as they are, but not
// at its tail: they are made to in one way for all.
TEST(Split, PartsAreBoundAlike) {
  Millipede millipede(400);
  millipede.scene.nodes[0].rotation = glm::angleAxis(1e-5, glm::dvec3(0, 1, 0));
  const CookedParts whole(millipede.scene, {}, kWhole, MeshCodec::meshopt),
      parts(millipede.scene, {}, 341, MeshCodec::meshopt);
  const Posed a = pose(parts.file, 0), b = pose(whole.file, 0);
  double apart = 0;
  for (std::size_t v = 0; v < a.ssd.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      apart = std::max(apart, static_cast<double>(std::abs(a.ssd[v][c] - b.ssd[v][c])));
  EXPECT_LT(apart, 40e-6) << "a millionth of its length";
}

Millipede bending_millipede() {
  Millipede out(8);  // 40 joints
  for (cook::RawChannel& channel : out.scene.clips[0].channels) channel.values[1] = {0, 0.3f, 0, 0.9539392f};
  return out;
}

// Whatever is learnt goes along: residuals, the root of multi-weights, parents and rotations of pose space.
TEST(Split, WhatIsLearntGoesAlong) {
  const Millipede millipede = bending_millipede();
  cook::CookOptions options;
  options.learn.animation_space = cook::AnimationSpace::fit;
  options.learn.truth = cook::Truth::dual_quaternions;
  options.learn.multi_weights = true;
  options.learn.pose_examples = 3;
  for (const MeshCodec codec : {MeshCodec::none, MeshCodec::draco}) {
    const CookedParts whole(millipede.scene, options, kWhole, codec), parts(millipede.scene, options, 24, codec);
    const Mesh mesh = whole.file.mesh(0);
    EXPECT_NE(mesh.geometry.as_residual, nullptr);
    EXPECT_NE(mesh.geometry.mwe_residual, nullptr);
    EXPECT_GT(mesh.geometry.pose_space.examples.size, 0u);
    expect_same(parts, whole);
  }
}

// And helpers, of both kinds.
TEST(Split, HelpersGoAlong) {
  const Millipede millipede = bending_millipede();
  cook::CookOptions options;
  options.learn.helpers = cook::kAutoHelpers;
  for (const cook::Truth truth : {cook::Truth::dual_quaternions, cook::Truth::centres_of_rotation})
    for (const MeshCodec codec : {MeshCodec::none, MeshCodec::draco}) {
      options.learn.truth = truth;
      const CookedParts whole(millipede.scene, options, kWhole, codec), parts(millipede.scene, options, 40, codec);
      EXPECT_GT(whole.file.mesh(0).helpers.size, 0u);
      expect_same(parts, whole);
    }
}

// Normals of the surface: triangles of other parts count at the seams.
TEST(Split, NormalsOfTheSurfaceKnowNoSeams) {
  const Millipede millipede(400);
  const CookedParts whole(millipede.scene, {}, kWhole), parts(millipede.scene, {}, 341);
  const auto normals = [](const File& file) {
    tools::Character character(file, tools::AsNormals::tangents);
    const tools::Play play = tools::play_together(file, 0);
    character.pose(play, play.duration_s);
    Slots slots;
    tools::PosedMesh posed;
    for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
      character.skin(m, tools::Deformer::as, posed);
      slots.push_back(posed.normals);
    }
    // Triangles are summed in another order: what is equal on both sides of a seam is so but for the last bits.
    for (std::vector<float>& of_mesh : slots)
      for (float& x : of_mesh) x = std::round(x * 1024) / 1024;
    return slots;
  };
  const std::vector<Three> a = in_source_order(parts.file, normals(parts.file)),
                           b = in_source_order(whole.file, normals(whole.file));
  ASSERT_EQ(a.size(), b.size());
  std::size_t apart = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c) apart += std::abs(a[v][c] - b[v][c]) > 0.0011f;
  EXPECT_EQ(apart, 0u);
}

// How many edges of a level's triangles, all parts together, have no triangle on their other side. By where vertices
// are in a pose, so that a seam that opens has edges.
std::size_t open_edges(const File& file, std::uint32_t level) {
  tools::Character character(file, tools::AsNormals::blended, level);
  const tools::Play play = tools::play_together(file, 0);
  character.pose(play, play.duration_s * 0.6f);
  std::map<std::pair<Three, Three>, int> edges;
  tools::PosedMesh posed;
  for (std::uint32_t m = 0; m < file.mesh_count(); ++m) {
    const Geometry g = file.mesh(m, level).geometry;
    character.skin(m, tools::Deformer::ssd, posed);
    const auto corner = [&](std::uint32_t i) {
      const std::size_t slot = g.index_bytes == 2 ? static_cast<const std::uint16_t*>(g.indices)[i]
                                                  : static_cast<const std::uint32_t*>(g.indices)[i];
      return Three{posed.positions[3 * slot], posed.positions[3 * slot + 1], posed.positions[3 * slot + 2]};
    };
    for (std::uint32_t i = 0; i < g.index_count; i += 3)
      for (std::uint32_t c = 0; c < 3; ++c) {
        const Three from = corner(i + c), to = corner(i + (c + 1) % 3);
        if (from == to) continue;
        from < to ? ++edges[{from, to}] : --edges[{to, from}];
      }
  }
  return static_cast<std::size_t>(std::ranges::count_if(edges, [](const auto& e) { return e.second != 0; }));
}

TEST(Split, LevelsOfDetailStayClosed) {
  cook::CookOptions options;
  options.mesh.lod = {{0.5, 8}, {0.2, 2}, {0.02, 1}};
  const cook::RawScene newt = cook::read_gltf(kNewt);
  const CookedParts whole(newt, options, kWhole), parts(newt, options, 24);
  for (std::uint32_t level = 0; level < 4; ++level) {
    std::size_t triangles[2] = {};
    for (const CookedParts* const cooked : {&whole, &parts})
      for (std::uint32_t m = 0; m < cooked->file.mesh_count(); ++m) {
        const std::uint32_t count = cooked->file.mesh(m, level).geometry.index_count / 3;
        triangles[cooked == &parts ? 1 : 0] += count;
      }
    std::printf("  level %u: %zu triangles, in parts %zu; open edges %zu and %zu\n", level, triangles[0], triangles[1],
                open_edges(whole.file, level), open_edges(parts.file, level));
    EXPECT_EQ(open_edges(parts.file, level), open_edges(whole.file, level));
  }
}

// A sheet on one joint, and in it patches of six triangles round a vertex on a joint of its own.
cook::RawScene sheet_with_patches() {
  cook::RawScene scene = Millipede(14).scene;  // for its joints
  cook::RawPrimitive p;
  p.pointer = "/meshes/0/primitives/0";
  for (std::uint32_t i = 0; i < 33 * 33; ++i) {
    const std::uint32_t x = i % 33, y = i / 33;
    p.positions.emplace_back(x, y, 0.1 * std::sin(0.4 * x) * std::sin(0.3 * y));
    const bool is_patch = x % 8 == 4 && y % 8 == 4;
    p.influences.push_back({{is_patch ? 1 + x / 8 + y / 8 * 4 : 0, 1.0f}});
    if (x > 0 && y > 0) p.indices.insert(p.indices.end(), {i - 34, i - 33, i, i - 34, i, i - 1});
  }
  scene.meshes[0].primitives = {p};
  // A clip in which nothing moves: patches are as flat as the sheet.
  for (cook::RawChannel& channel : scene.clips[0].channels) channel.values[1] = channel.values[0];
  return scene;
}

// A part that has lost everything stays, with a triangle that shows nothing, and the others are as they should be.
TEST(Split, PartsThatLoseAllTheirTrianglesAreStillThere) {
  cook::CookOptions options;
  options.mesh.lod = {{0.02, 8}};
  for (const MeshCodec codec : {MeshCodec::none, MeshCodec::draco, MeshCodec::meshopt}) {
    const CookedParts parts(sheet_with_patches(), options, 2, codec);
    std::size_t still = 0, triangles = 0;
    for (std::uint32_t m = 0; m < parts.file.mesh_count(); ++m) {
      const Geometry g = parts.file.mesh(m, 1).geometry;
      EXPECT_EQ(g.joint_count, parts.file.mesh(m).geometry.joint_count);
      still += g.index_count == 3 && g.vertex_count == 1 ? 1 : 0;
      triangles += g.index_count / 3;
    }
    std::printf("  %u parts, %zu without triangles, %zu triangles\n", parts.file.mesh_count(), still, triangles);
    EXPECT_GT(still, 0u);
  }
}

// What is exported is the primitive as it was.
TEST(Split, ExportsAsOnePrimitive) {
  Millipede millipede(100);
  millipede.add_targets();
  const CookedParts parts(millipede.scene, {}, 64);
  ASSERT_GT(parts.file.mesh_count(), 5u);
  const std::string glb = tools::export_file(parts.file, "millipede.mrw").glb;
  const cook::RawScene back =
      cook::read_gltf("back.glb", std::span(reinterpret_cast<const std::byte*>(glb.data()), glb.size()));
  ASSERT_EQ(back.meshes.size(), 1u);
  ASSERT_EQ(back.meshes[0].primitives.size(), 1u);
  const cook::RawPrimitive &a = millipede.scene.meshes[0].primitives[0], &b = back.meshes[0].primitives[0];
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.uvs, b.uvs);
  const auto triangles = [](const std::vector<std::uint32_t>& indices) {
    std::multiset<std::set<std::uint32_t>> out;
    for (std::size_t i = 0; i < indices.size(); i += 3) out.insert({indices[i], indices[i + 1], indices[i + 2]});
    return out;
  };
  EXPECT_EQ(triangles(a.indices), triangles(b.indices));
  const auto follows = [](const cook::RawScene& scene, const cook::RawPrimitive& p, std::size_t v) {
    std::map<std::string, float> out;
    for (const cook::RawInfluence& i : p.influences[v])
      if (i.weight > 0) out[scene.nodes[static_cast<std::size_t>(scene.skins[0].joints[i.joint])].name] = i.weight;
    return out;
  };
  ASSERT_EQ(a.influences.size(), b.influences.size());
  ASSERT_EQ(b.targets.size(), 2u);
  for (std::size_t v = 0; v < a.positions.size(); ++v) {
    EXPECT_EQ(follows(millipede.scene, a, v), follows(back, b, v));
    for (std::size_t t = 0; t < 2; ++t)
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(a.targets[t].positions[v][c], b.targets[t].positions[v][c], 1e-6f);
  }
}

}  // namespace
}  // namespace marrow::test
