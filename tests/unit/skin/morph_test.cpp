// Morphing against arithmetic by hand and in double precision, and that nothing is left of the frame before.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/marrow.h"
#include "support/aligned.h"
#include "support/golden.h"
#include "support/morphs.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::AlignedBlock;
using test::TestMorphs;

// A morphed geometry with its memory, exactly as long as it must be.
struct Instance {
  explicit Instance(const Geometry& geometry) : block(morphed_bytes(geometry)) {
    EXPECT_EQ(make_morphed(geometry, {block.data(), block.size()}, morphed), Status::ok);
  }
  AlignedBlock block;
  MorphedGeometry morphed;
};

std::size_t skin_floats(const Geometry& g) {
  std::size_t floats = 0;
  for (const Run& run : g.runs) floats += (run.vertex_count + 3) / 4 * 4 * (run.influences + 2);
  return floats;
}

bool same_bits(const Geometry& a, const Geometry& b) {
  const std::size_t blocks = a.slot_count / 4;
  return std::memcmp(a.skin, b.skin, skin_floats(a) * 4) == 0 && std::memcmp(a.normals, b.normals, blocks * 48) == 0 &&
         std::memcmp(a.tangents, b.tangents, blocks * 64) == 0;
}

// Two blocks of a run on one joint; a target moves the second one's first vertex.
struct Two {
  Two()
      : mesh({{{0}, std::vector<test::TestVertex>(8, {{1, 2, 3}, {0, 0, 1}, {1, 0, 0}, -1, {1}, {}})}}, {test::Map{}}) {
    records.assign(36, 0);
    records[0] = 4, records[4] = -8, records[8] = 2;
    records[12] = 3;  // a normal along x
    records[28] = 3;  // a tangent along y
    geometry = mesh.view().geometry;
    geometry.targets = {&target, 1};
    geometry.target_blocks = &moved;
    geometry.target_records = records.data();
  }
  test::TestMesh mesh;
  MorphTarget target{0, 1, 0, kMorphsPositions | kMorphsNormals | kMorphsTangents, 0.5f, 1, 1, 0};
  std::uint16_t moved = 1;
  std::vector<std::int16_t> records;
  Geometry geometry;
};

TEST(Morph, ByHand) {
  const Two two;
  Instance i(two.geometry);
  const float weight = 0.25f;
  ASSERT_EQ(morph({&weight, 1}, i.morphed), Status::ok);
  const Geometry& g = i.morphed.geometry;
  // (1, 2, 3) + 0.25 · 0.5 · (4, -8, 2); (0, 0, 1) + 0.25 · (3, 0, 0) and (1, 0, 0) + 0.25 · (0, 3, 0), made unit.
  EXPECT_EQ(g.skin[12], 1.5f);
  EXPECT_EQ(g.skin[16], 1.0f);
  EXPECT_EQ(g.skin[20], 3.25f);
  EXPECT_NEAR(g.normals[12], 0.6f, 1e-7f);
  EXPECT_EQ(g.normals[16], 0.0f);
  EXPECT_NEAR(g.normals[20], 0.8f, 1e-7f);
  EXPECT_NEAR(g.tangents[16], 0.8f, 1e-7f);
  EXPECT_NEAR(g.tangents[20], 0.6f, 1e-7f);
  EXPECT_EQ(g.tangents[28], -1.0f) << "the handedness stays";
  EXPECT_EQ(g.skin[13], 1.0f) << "the next vertex stays";
  EXPECT_EQ(std::memcmp(g.skin, two.geometry.skin, 48), 0) << "the first block stays";
  EXPECT_EQ(*i.morphed.moved, 2u);

  std::vector<float> positions(24);
  const Affine palette{{{1, 0, 0, 10}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  Mesh mesh = two.mesh.view();
  mesh.geometry = g;
  ASSERT_EQ(skin_ssd(mesh, {&palette, 1}, {positions, {}, {}}), Status::ok);
  EXPECT_EQ(positions[12], 11.5f);
  EXPECT_EQ(positions[13], 1.0f);
  EXPECT_EQ(positions[14], 3.25f);
}

TEST(Morph, AnyFiniteWeightIsLegal) {
  const Two two;
  Instance i(two.geometry);
  for (const float weight : {-1.0f, 2.0f, 1000.0f, -0.0f}) {
    ASSERT_EQ(morph({&weight, 1}, i.morphed), Status::ok);
    EXPECT_EQ(i.morphed.geometry.skin[12], 1 + 2 * weight);
  }
  const std::vector<std::byte> before(i.block.data(), i.block.data() + i.block.size());
  const float bad[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()};
  for (const float& weight : bad) EXPECT_EQ(morph({&weight, 1}, i.morphed), Status::bad_argument);
  EXPECT_EQ(morph({}, i.morphed), Status::bad_argument);
  EXPECT_EQ(std::memcmp(before.data(), i.block.data(), before.size()), 0) << "nothing is written";
}

// Σ w d of a slot in double precision.
test::Vec3 change(const TestMorphs& morphs, std::size_t slot, std::uint32_t attribute) {
  test::Vec3 sum{0, 0, 0};
  for (std::size_t t = 0; t < morphs.targets.size(); ++t) {
    const MorphTarget& target = morphs.targets[t];
    if ((target.attributes & attribute) == 0) continue;
    const float steps[] = {target.position_step, target.normal_step, target.tangent_step};
    const std::size_t each = target.attributes == kMorphsPositions ? 1 : 3, which = attribute / 2;
    for (std::size_t b = 0; b < target.block_count; ++b) {
      if (morphs.narrow[target.first_block + b] != slot / 4) continue;
      const std::int16_t* record = &morphs.records[12 * (target.first_record + b * each + which)];
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += static_cast<double>(morphs.weights[t]) * static_cast<double>(steps[which]) * record[4 * c + slot % 4];
    }
  }
  return sum;
}

struct Noise {
  explicit Noise(bool residuals, bool wide = false)
      : character(test::make_character(71, 20, 13, residuals)),
        mesh(character.mesh.view()),
        morphs(72, mesh.geometry.slot_count, 7, wide) {
    morphs.put(mesh.geometry);
  }
  test::TestCharacter character;
  Mesh mesh;
  TestMorphs morphs;
};

TEST(Morph, AgreesWithDoublePrecision) {
  const Noise n(false);
  Instance i(n.mesh.geometry);
  ASSERT_EQ(morph(n.morphs.weights, i.morphed), Status::ok);
  const auto at = [](const float* block, std::size_t lane) {
    return test::Vec3{static_cast<double>(block[lane]), static_cast<double>(block[4 + lane]),
                      static_cast<double>(block[8 + lane])};
  };
  std::size_t compared = 0, turned = 0;
  for (std::size_t slot = 0; slot < n.mesh.geometry.slot_count; ++slot, ++compared) {
    const std::size_t block = slot / 4, lane = slot % 4, offset = i.morphed.offsets[block];
    const auto expect = [&](const float* bind, const float* got, std::uint32_t attribute, bool unit) {
      test::Vec3 want = at(bind, lane);
      const test::Vec3 d = change(n.morphs, slot, attribute);
      for (std::size_t c = 0; c < 3; ++c) want[c] += d[c];
      if (unit && test::length(want) < 0.05) return;  // where rounding has the say
      if (unit) want = test::normalised(want);
      turned += unit && test::length(d) > 0.01;
      EXPECT_LT(test::length(test::minus(at(got, lane), want)), unit ? 1e-5 : 1e-6) << "slot " << slot;
    };
    const Geometry& g = i.morphed.geometry;
    expect(n.mesh.geometry.skin + offset, g.skin + offset, kMorphsPositions, false);
    expect(n.mesh.geometry.normals + 12 * block, g.normals + 12 * block, kMorphsNormals, true);
    expect(n.mesh.geometry.tangents + 16 * block, g.tangents + 16 * block, kMorphsTangents, true);
  }
  EXPECT_EQ(compared, n.mesh.geometry.slot_count);
  EXPECT_GT(turned, 100u);
}

TEST(Morph, NothingIsLeftOfTheFrameBefore) {
  const Noise n(false);
  Instance used(n.mesh.geometry);
  std::vector<float> weights = n.morphs.weights;
  for (std::size_t round = 0; round < 8; ++round) {
    for (std::size_t t = 0; t < weights.size(); ++t)
      weights[t] = (round + t) % 3 == 0 ? 0.0f : n.morphs.weights[t] * static_cast<float>(round);
    Instance fresh(n.mesh.geometry);
    ASSERT_EQ(morph(weights, used.morphed), Status::ok);
    ASSERT_EQ(morph(weights, fresh.morphed), Status::ok);
    EXPECT_TRUE(same_bits(used.morphed.geometry, fresh.morphed.geometry)) << round;
    EXPECT_EQ(same_bits(used.morphed.geometry, n.mesh.geometry), round == 0);
  }
  weights.assign(weights.size(), 0.0f);
  ASSERT_EQ(morph(weights, used.morphed), Status::ok);
  EXPECT_TRUE(same_bits(used.morphed.geometry, n.mesh.geometry)) << "the bind pose again, to the bit";
}

TEST(Morph, WideBlocksAreTheSame) {
  const Noise narrow(false), wide(false, true);
  Instance a(narrow.mesh.geometry), b(wide.mesh.geometry);
  ASSERT_EQ(morph(narrow.morphs.weights, a.morphed), Status::ok);
  ASSERT_EQ(morph(wide.morphs.weights, b.morphed), Status::ok);
  EXPECT_TRUE(same_bits(a.morphed.geometry, b.morphed.geometry));
}

TEST(Morph, CoordinatesFollow) {
  const Noise n(false);
  Instance i(n.mesh.geometry);
  std::vector<float> coordinates(as_coordinate_count(n.mesh.geometry)), whole(coordinates.size());
  ASSERT_EQ(as_coordinates(n.mesh.geometry, coordinates), Status::ok);
  const std::vector<float> bind = coordinates;
  std::vector<float> weights = n.morphs.weights;
  for (const float factor : {1.0f, -0.5f, 0.0f, 2.0f}) {
    // Once without a look at the coordinates.
    ASSERT_EQ(morph(n.morphs.weights, i.morphed), Status::ok);
    for (std::size_t t = 0; t < weights.size(); ++t) weights[t] = n.morphs.weights[t] * factor;
    ASSERT_EQ(morph(weights, i.morphed), Status::ok);
    ASSERT_EQ(morph_coordinates(i.morphed, coordinates), Status::ok);
    ASSERT_EQ(as_coordinates(i.morphed.geometry, whole), Status::ok);
    float worst = 0;
    for (std::size_t c = 0; c < whole.size(); ++c) worst = std::max(worst, std::fabs(whole[c] - coordinates[c]));
    EXPECT_LT(worst, 2e-6f) << factor;
    EXPECT_EQ(coordinates == bind, factor == 0.0f);
  }
  EXPECT_EQ(morph_coordinates(i.morphed, {coordinates.data(), coordinates.size() - 1}), Status::bad_argument);
}

// With fitted weights the change goes through the blend that normals go through: p' = Σ M_j q_j + (Σ (q_j)_w M_j) Δ.
TEST(Morph, FittedWeightsCarryTheChange) {
  const Noise n(true);
  Instance i(n.mesh.geometry);
  std::vector<float> coordinates(as_coordinate_count(n.mesh.geometry));
  ASSERT_EQ(as_coordinates(n.mesh.geometry, coordinates), Status::ok);
  std::vector<Affine> palette;
  test::Random random(5);
  for (std::uint32_t j = 0; j < n.mesh.joint_count; ++j) {
    const test::Vec3 t{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
    palette.push_back(test::to_affine(test::from_trs(t, random.rotation(), {1, 1, 1})));
  }
  const std::size_t slots = n.mesh.geometry.slot_count;
  std::vector<float> before(slots * 3), after(slots * 3);
  ASSERT_EQ(skin_as(n.mesh, coordinates, palette, {before, {}, {}}), Status::ok);
  ASSERT_EQ(morph(n.morphs.weights, i.morphed), Status::ok);
  ASSERT_EQ(morph_coordinates(i.morphed, coordinates), Status::ok);
  ASSERT_EQ(skin_as(n.mesh, coordinates, palette, {after, {}, {}}), Status::ok);
  std::size_t compared = 0;
  for (std::size_t r = 0; r < n.character.mesh.source.size(); ++r) {
    const test::TestRun& run = n.character.mesh.source[r];
    for (std::size_t v = 0; v < run.vertices.size(); ++v, ++compared) {
      const std::size_t slot = n.character.mesh.slot(r, v);
      const test::Vec3 d = change(n.morphs, slot, kMorphsPositions);
      test::Vec3 want{static_cast<double>(before[3 * slot]), static_cast<double>(before[3 * slot + 1]),
                      static_cast<double>(before[3 * slot + 2])};
      double last = 1;
      for (std::size_t k = 0; k < run.set.size(); ++k) {
        // The last w is what the others leave.
        const double w = k + 1 < run.set.size() ? run.vertices[v].weights[k] + run.vertices[v].residual[k][3] : last;
        last -= w;
        const test::Vec3 turned = test::direction(test::to_map(palette[run.set[k]]), d);
        for (std::size_t c = 0; c < 3; ++c) want[c] += w * turned[c];
      }
      for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(after[3 * slot + c]), want[c], 1e-5);
    }
  }
  EXPECT_GT(compared, 100u);
}

TEST(Morph, WithoutTargetsNothingIsNeeded) {
  const test::TestCharacter c = test::make_character(73, 5, 3, false);
  const Geometry g = c.mesh.view().geometry;
  EXPECT_EQ(morphed_bytes(g), 0u);
  MorphedGeometry m;
  ASSERT_EQ(make_morphed(g, {}, m), Status::ok);
  EXPECT_EQ(m.geometry.skin, g.skin);
  EXPECT_EQ(morph({}, m), Status::ok);
  std::vector<float> coordinates(as_coordinate_count(g));
  EXPECT_EQ(morph_coordinates(m, coordinates), Status::ok);
}

TEST(Morph, BadMemoryIsRefused) {
  const Two two;
  AlignedBlock block(morphed_bytes(two.geometry) + 16);
  MorphedGeometry m;
  EXPECT_EQ(make_morphed(two.geometry, {block.data(), morphed_bytes(two.geometry) - 1}, m), Status::bad_argument);
  EXPECT_EQ(make_morphed(two.geometry, {block.data() + 4, morphed_bytes(two.geometry)}, m), Status::bad_argument);
  EXPECT_EQ(m.geometry.skin, nullptr);
}

// face.gltf: node "face" has targets smile and blink with weights 0.5 and 0, nodes[2] two without names; one clip.
TEST(Morph, ChannelsAreFoundOnceAndWeightsTaken) {
  AlignedBlock block = test::golden_channels_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  ASSERT_EQ(file.mesh_count(), 2u);
  const char* names[2][2] = {{"smile", "blink"}, {"", ""}};
  const char* channels[2][2] = {{"face.smile", "face.blink"}, {"nodes[2].weights[0]", "nodes[2].weights[1]"}};
  const float rest[2][2] = {{0.5f, 0}, {0.25f, 0.75f}};
  for (std::uint32_t m = 0; m < 2; ++m) {
    const Mesh mesh = file.mesh(m);
    const Clip clip = file.clip(0);
    ASSERT_EQ(mesh.targets.size, 2u);
    ASSERT_EQ(mesh.geometry.targets.size, 2u);
    std::vector<std::uint32_t> found(2);
    ASSERT_EQ(find_weight_channels(file, mesh, file, clip, found), Status::ok);
    std::vector<float> values(clip.channels.size), weights(2), defaults(2);
    ASSERT_EQ(sample_channels(clip, 0.4f, values), Status::ok);
    ASSERT_EQ(morph_weights(mesh, found, values, weights), Status::ok);
    ASSERT_EQ(morph_weights(mesh, {}, {}, defaults), Status::ok);
    for (std::size_t t = 0; t < 2; ++t) {
      EXPECT_STREQ(file.text(mesh.targets[t].name), names[m][t]);
      EXPECT_STREQ(file.text(mesh.targets[t].channel), channels[m][t]);
      EXPECT_EQ(mesh.targets[t].weight, rest[m][t]);
      EXPECT_EQ(defaults[t], rest[m][t]);
      ASSERT_LT(found[t], clip.channels.size);
      EXPECT_STREQ(file.text(clip.channels[found[t]].name), channels[m][t]);
      EXPECT_EQ(weights[t], values[found[t]]);
    }
    found[1] = kNoChannel;
    ASSERT_EQ(morph_weights(mesh, found, values, weights), Status::ok);
    EXPECT_EQ(weights[1], rest[m][1]) << "what the clip leaves alone";
    found[1] = static_cast<std::uint32_t>(values.size());
    EXPECT_EQ(morph_weights(mesh, found, values, weights), Status::bad_argument);
    EXPECT_EQ(morph_weights(mesh, {found.data(), 1}, values, weights), Status::bad_argument);
    EXPECT_EQ(morph_weights(mesh, {}, {}, {weights.data(), 1}), Status::bad_argument);
    EXPECT_EQ(find_weight_channels(file, mesh, file, clip, {found.data(), 1}), Status::bad_argument);
  }
}

}  // namespace
}  // namespace marrow
