// Files of every version of the format keep loading and keep their shape: today's loader on the golden file of
// version 1.
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "asset/format.h"
#include "marrow/unpack.h"
#include "support/double_math.h"
#include "support/golden.h"
#include "support/pose_file.h"

namespace marrow {
namespace {

using test::Vec3;

constexpr const char* kRest = nullptr;

struct Expected {
  const char* clip;  // kRest or a name
  float time_s;
  std::uint32_t vertex;  // of the source: 0 to 23 the arm, 24 to 28 the hat
  Vec3 position;
  Vec3 normal;  // zero: not compared (the source has none)
};

// The glTF beside the golden file, evaluated in double precision from the specification (road/reference.cpp); the rest
// pose and "point" can be checked by hand, see reference_test.cpp.
const Expected kExpected[] = {
    {kRest, 0.0f, 5, {-1, 0, 1.5}, {0, 0, 1}},
    {kRest, 0.0f, 13, {-3, 0, 1.5}, {0, 0, 1}},
    {kRest, 0.0f, 18, {-4, -0.5, 1}, {0, -1, 0}},
    {kRest, 0.0f, 25, {-5, 1, 2}, {0, 0, 0}},
    {kRest, 0.0f, 28, {-6.5, 0, 1}, {0, 0, 0}},
    {"wave", 0.3f, 5, {-1.125, 0.2165064, 1.5}, {0, 0, 1}},
    {"wave", 0.3f, 13, {-2.5239849, -0.8329327, 1.4971991}, {-0.06482, 0.03742, 0.9972}},
    {"wave", 0.3f, 18, {-2.5712322, -1.9796, 1.0653063}, {0.85859, -0.49571, 0.13077}},
    {"wave", 0.3f, 25, {-4.5022623, -2.0579099, 1.8395247}, {0, 0, 0}},
    {"wave", 0.3f, 28, {-4.2916666, -3.9692831, 1}, {0, 0, 0}},
    {"wave", 0.7f, 5, {-1.1662255, 1.2601966, 1.4333486}, {0.08485, -0.03307, 0.99584}},
    {"wave", 0.7f, 13, {-2.3365847, 0.3178142, 1.5464098}, {-0.39347, 0.31059, 0.86529}},
    {"wave", 0.7f, 18, {-2.1671723, -0.8559931, 1.8577077}, {0.57101, 0.08022, 0.81701}},
    {"wave", 0.7f, 25, {-4.0278706, -1.9442377, 1.3304619}, {0, 0, 0}},
    {"wave", 0.7f, 28, {-3.1229568, -3.96809, 2.2726152}, {0, 0, 0}},
    {"wave", 1.25f, 5, {-1.0167468, 1, 0.7209936}, {0.24019, 0, 0.97073}},
    {"wave", 1.25f, 13, {-2.2667468, 1.2165064, 1.2120191}, {0.43301, 0.86603, 0.25}},
    {"wave", 1.25f, 18, {-2.671875, 1.15625, 2.4214939}, {0.80062, 0.38125, 0.46224}},
    {"wave", 1.25f, 25, {-4.9330127, 1.3660254, 2.8480763}, {0, 0, 0}},
    {"wave", 1.25f, 28, {-4.8749999, 1, 5.4796461}, {0, 0, 0}},
    {"point", 0.0f, 5, {0, 1, 1.5}, {0, 0, 1}},
    {"point", 0.0f, 13, {0, 3, 1.5}, {0, 0, 1}},
    {"point", 0.0f, 18, {-0.5, 4, 1}, {-1, 0, 0}},
    {"point", 0.0f, 25, {1, 5, 2}, {0, 0, 0}},
    {"point", 0.0f, 28, {0, 6.5, 1}, {0, 0, 0}},
};

class Golden : public ::testing::Test {
 protected:
  Golden() : block_(test::golden_copy()) { EXPECT_EQ(load(block_, file_), Status::ok); }
  test::AlignedBlock block_;
  File file_;
};

TEST_F(Golden, HoldsWhatItsSourceHolds) {
  ASSERT_EQ(file_.skeleton_count(), 1u);
  ASSERT_EQ(file_.clip_count(), 2u);
  ASSERT_EQ(file_.mesh_count(), 2u);
  const Skeleton skeleton = file_.skeleton(0);
  ASSERT_EQ(skeleton.joint_count, 3u);
  EXPECT_EQ(skeleton.root_count, 1u);
  const char* const names[] = {"shoulder", "elbow", "wrist"};
  const std::uint16_t parents[] = {kNoJoint, 0, 1};
  for (std::uint32_t j = 0; j < 3; ++j) {
    EXPECT_STREQ(file_.text(skeleton.names[j]), names[j]);
    EXPECT_EQ(skeleton.parents[j], parents[j]);
  }
  EXPECT_EQ(file_.find_clip("wave"), 0u);
  EXPECT_EQ(file_.find_clip("point"), 1u);
  EXPECT_EQ(file_.find_clip("Wave"), 2u);
  EXPECT_EQ(file_.clip(0).duration_s, 1.25f);
  EXPECT_EQ(file_.clip(0).tracks.size, 4u);
  EXPECT_EQ(file_.clip(1).duration_s, 0.0f);
}

TEST_F(Golden, MeshesKeepTheirAttributes) {
  const Mesh arm = file_.mesh(0), hat = file_.mesh(1);
  EXPECT_STREQ(arm.name, "arm");
  EXPECT_STREQ(arm.material, "skin");
  EXPECT_EQ(arm.base_colour[0], 0.75f);
  EXPECT_FALSE(arm.double_sided);
  EXPECT_TRUE(hat.double_sided);
  EXPECT_EQ(arm.geometry.vertex_count, 24u);
  EXPECT_EQ(arm.geometry.index_count, 120u);
  EXPECT_EQ(hat.geometry.index_count, 12u);
  EXPECT_EQ(arm.joint_count, 3u);
  EXPECT_EQ(hat.joint_count, 1u);
  EXPECT_NE(arm.geometry.tangents, nullptr);
  EXPECT_EQ(arm.geometry.uvs, nullptr);
  ASSERT_NE(hat.geometry.uvs, nullptr);
  ASSERT_NE(hat.geometry.colours, nullptr);
  const std::uint32_t slot = hat.geometry.source_slots[2];
  EXPECT_EQ(hat.geometry.uvs[slot * 2], 1.0f);
  EXPECT_EQ(hat.geometry.uvs[slot * 2 + 1], 1.0f);
  const std::uint8_t blue[] = {0, 0, 255, 255};
  EXPECT_EQ(std::memcmp(hat.geometry.colours + slot * 4, blue, 4), 0);
}

TEST_F(Golden, PosesAsTheSpecificationSays) {
  int cases = 0;
  for (const Expected& e : kExpected) {
    const std::uint32_t clip = e.clip == kRest ? file_.clip_count() : file_.find_clip(e.clip);
    const std::uint32_t mesh = e.vertex < 24 ? 0 : 1;
    const std::uint32_t slot = file_.mesh(mesh).geometry.source_slots[e.vertex - mesh * 24];
    for (const test::Deformer deformer : {test::Deformer::ssd, test::Deformer::as}) {
      const test::PosedMesh posed = test::pose_mesh(file_, clip, e.time_s, mesh, deformer);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(static_cast<double>(posed.positions[slot * 3 + i]), e.position[i], 3e-6)
            << e.vertex << " at " << e.time_s;
        if (test::length(e.normal) > 0) {
          EXPECT_NEAR(static_cast<double>(posed.normals[slot * 3 + i]), e.normal[i], 1e-4)
              << e.vertex << " at " << e.time_s;
        }
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 50);
}

// stride.gltf's keys, and straight lines between them: at a key, on the way, in the long gap, before and behind.
TEST(GoldenStride, FramesAtUnevenTimes) {
  const test::AlignedBlock block = test::golden_uneven_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  const Clip clip = file.clip(0);
  ASSERT_EQ(clip.coded.frame_count, 7u);
  EXPECT_EQ(clip.coded.time_of(4), 1.0833334f);
  struct Moment {
    float time_s, hips_x, knee_degrees;
  };
  const Moment moments[] = {{-1, 0, 0},           {0, 0, 0},
                            {0.125f, 0.5f, 15},   {0.25f, 1, 30},
                            {0.75f, 2, 20},       {0.8333333f, 1.25f, 10},
                            {1.0f, -0.25f, -10},  {1.0833334f, -1, -20},
                            {1.3333334f, 1, -50}, {1.4583334f, 0.5f, -25},
                            {1.5833334f, 0, 0},   {9, 0, 0}};
  for (const Moment& m : moments) {
    SoaTransform local;
    ASSERT_EQ(sample(file.skeleton(0), clip, m.time_s, {&local, 1}), Status::ok);
    EXPECT_NEAR(local.translation[0][0], m.hips_x, 1e-4) << m.time_s;
    EXPECT_NEAR(local.rotation[0][1], std::sin(m.knee_degrees * 3.14159265f / 360), 1e-3) << m.time_s;
    EXPECT_NEAR(local.rotation[3][1], std::cos(m.knee_degrees * 3.14159265f / 360), 1e-3) << m.time_s;
  }
}

// The helper's matrix, from elbow.gltf and the centre in double precision: at times of keys.
TEST(GoldenCentres, TheHelperTurnsAboutItsCentre) {
  const test::AlignedBlock block = test::golden_centres_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  const Mesh mesh = file.mesh(0);
  ASSERT_EQ(mesh.helpers.size, 1u);
  EXPECT_EQ(mesh.helpers[0].first, 0u);
  EXPECT_EQ(mesh.helpers[0].second, 1u);
  EXPECT_EQ(mesh.helpers[0].share, 0.25f);
  ASSERT_EQ(mesh.helper_centres.size, 3u);
  EXPECT_EQ(mesh.helper_centres[0], 0.0625f);
  EXPECT_EQ(mesh.helper_centres[1], -0.03125f);
  EXPECT_EQ(mesh.helper_centres[2], 0.015625f);
  struct Moment {
    float time_s, rows[3][4];
  };
  const Moment moments[] = {
      {0, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}},
      {1.0f,
       {{0.9229775f, -0.3356448f, 0.1882953f, 0.3183563f},
        {0.2453355f, 0.8901076f, 0.384082f, 0.0966733f},
        {-0.2965182f, -0.3083035f, 0.9038949f, 0.2987308f}}},
      {1.25f,
       {{0.9020895f, -0.1990911f, 0.3828803f, 0.1834328f},
        {0.0487963f, 0.9285905f, 0.367884f, 0.057521f},
        {-0.4287814f, -0.3131811f, 0.8473866f, 0.3156355f}}},
      {2.5f,
       {{0.8716493f, -0.0626014f, 0.4861158f, 0.0414925f},
        {0.017642f, 0.9951743f, 0.0965237f, 0.0001236f},
        {-0.4898125f, -0.0755588f, 0.8685474f, 0.0874782f}}},
  };
  for (const Moment& m : moments) {
    SoaTransform local;
    Affine joints[2], palette[3];
    ASSERT_EQ(sample(file.skeleton(0), file.clip(0), m.time_s, {&local, 1}), Status::ok);
    ASSERT_EQ(local_to_model(file.skeleton(0), {&local, 1}, joints), Status::ok);
    ASSERT_EQ(build_palette(mesh, joints, palette), Status::ok);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) EXPECT_NEAR(palette[2].rows[r][c], m.rows[r][c], 2e-6f) << m.time_s;
  }
}

// What the file's numbers say, evaluated in double precision by a decoder of its own.
TEST(GoldenElbow, DeformsWithAHalfJoint) {
  const test::AlignedBlock block = test::golden_half_joint_copy();
  File file;
  ASSERT_EQ(load(block, file), Status::ok);
  const Mesh mesh = file.mesh(0);
  ASSERT_EQ(mesh.helpers.size, 1u);
  EXPECT_EQ(mesh.helpers[0].first, 0u);
  EXPECT_EQ(mesh.helpers[0].second, 1u);
  EXPECT_EQ(mesh.helpers[0].share, 0.5f);
  struct Moment {
    float time_s;
    std::uint32_t vertex;
    Vec3 as, ssd;
  };
  const Moment moments[] = {
      {0.0f, 9, {0.2512067, 0.7518073, -0.2519657}, {0.2500000, 0.7500000, -0.2500000}},
      {0.0f, 18, {-0.2473670, 1.2515293, -0.2496816}, {-0.2500000, 1.2500000, -0.2500000}},
      {0.6f, 1, {0.2500000, 0.0000000, -0.2500000}, {0.2500000, 0.0000000, -0.2500000}},
      {0.6f, 14, {-0.2468128, 0.7966787, -0.1510958}, {-0.1788672, 0.8323517, -0.1405685}},
      {1.0f, 6, {-0.1937712, 0.4342704, -0.1301529}, {-0.1513494, 0.5600562, -0.1825483}},
      {1.0f, 14, {-0.2132063, 0.7197200, 0.0274921}, {-0.0903209, 0.9047199, 0.0198070}},
      {1.3f, 18, {-0.3664017, 1.0273216, 0.2322065}, {-0.2442452, 1.1266624, 0.1988821}},
      {1.3f, 23, {-0.3329935, 1.5129914, -0.0088766}, {-0.3518736, 1.4915708, 0.0168238}},
      {2.45f, 9, {0.1249065, 0.7328085, -0.3150578}, {0.1369975, 0.7192129, -0.2090813}},
      {2.45f, 23, {0.0773575, 1.5891965, 0.1449647}, {0.0500734, 1.5857331, 0.1132442}},
  };
  int cases = 0;
  for (const Moment& m : moments) {
    const std::uint32_t slot = mesh.geometry.source_slots[m.vertex];
    const test::PosedMesh as = test::pose_mesh(file, 0, m.time_s, 0, test::Deformer::as),
                          ssd = test::pose_mesh(file, 0, m.time_s, 0, test::Deformer::ssd);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(static_cast<double>(as.positions[slot * 3 + i]), m.as[i], 3e-6) << m.vertex << " at " << m.time_s;
      EXPECT_NEAR(static_cast<double>(ssd.positions[slot * 3 + i]), m.ssd[i], 3e-6) << m.vertex << " at " << m.time_s;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 30);
}

// A packed file of version 2 becomes the clip pack of version 1, byte by byte, in one go and in steps.
TEST(GoldenPacked, UnpacksToTheClipPack) {
  const test::AlignedBlock packed = test::golden_packed_copy(), want = test::golden_pack_copy();
  const Span<const std::byte> bytes(packed.data(), packed.size());
  UnpackSizes sizes;
  ASSERT_EQ(unpack_sizes(bytes, sizes), Status::ok);
  ASSERT_EQ(sizes.file_bytes, want.size());
  test::AlignedBlock memory(sizes.memory_bytes), again(sizes.memory_bytes);
  Span<const std::byte> file;
  ASSERT_EQ(unpack(bytes, {}, {memory.data(), memory.size()}, file), Status::ok);
  ASSERT_EQ(file.size, want.size());
  EXPECT_EQ(std::memcmp(file.data, want.data(), want.size()), 0);
  Unpacking unpacking;
  ASSERT_EQ(begin_unpack(bytes, {}, {again.data(), again.size()}, unpacking), Status::ok);
  std::size_t steps = 0;
  for (; unpacking.file.empty(); ++steps) ASSERT_EQ(unpack_step(unpacking), Status::ok);
  EXPECT_EQ(steps, 5u) << "a reference, a clip, its motion, names, and the checksum";
  EXPECT_EQ(std::memcmp(again.data(), want.data(), want.size()), 0);
}

// Every byte changed, with a checksum that fits: refused, or a file that load() judges.
TEST(GoldenPacked, DamagedIsRefusedOrHarmless) {
  const test::AlignedBlock good = test::golden_packed_copy();
  std::size_t refused = 0, tried = 0;
  for (std::size_t i = 32; i < good.size(); ++i)
    for (unsigned v = 1; v < 256; v += 2, ++tried) {
      test::AlignedBlock packed(good.data(), good.size());
      packed.data()[i] ^= static_cast<std::byte>(v);
      const std::uint64_t sum = format::checksum(packed.data() + 32, packed.size() - 32);
      std::memcpy(packed.data() + 24, &sum, sizeof sum);
      UnpackSizes sizes;
      const Span<const std::byte> bytes(packed.data(), packed.size());
      Span<const std::byte> file;
      if (unpack_sizes(bytes, sizes) != Status::ok || sizes.memory_bytes > 1 << 20) {
        ++refused;
        continue;
      }
      test::AlignedBlock memory(sizes.memory_bytes);
      if (unpack(bytes, {}, {memory.data(), memory.size()}, file) != Status::ok) {
        ++refused;
        continue;
      }
      File loaded;
      if (load(file, loaded) == Status::ok) test::exercise(loaded);
    }
  EXPECT_GT(refused, tried / 3);
}

// One of version 1 is to be cooked again.
TEST(GoldenPacked, OlderVersionsAreRefused) {
  test::AlignedBlock packed = test::golden_packed_copy();
  packed.data()[4] = std::byte{1};
  UnpackSizes sizes;
  DataError error;
  EXPECT_EQ(unpack_sizes({packed.data(), packed.size()}, sizes, &error), Status::bad_version);
  EXPECT_STREQ(error.rule, "packed for another version: cook it again");
}

}  // namespace
}  // namespace marrow
