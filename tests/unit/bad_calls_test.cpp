// Every stage refuses memory that is too short, and writes nothing then.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/family.h"
#include "support/rig.h"

namespace marrow {
namespace {

// A character with everything that a frame needs, all of it just large enough.
struct Frame {
  Frame()
      : c(test::make_character(41, 10, 3, false)),
        skeleton(c.skeleton.view()),
        clip(c.clip.view()),
        mesh(c.mesh.view()),
        local(c.skeleton.rest),
        model(10),
        palette(10),
        coordinates(as_coordinate_count(mesh.geometry)),
        positions(mesh.geometry.slot_count * 3, kUntouched),
        normals(positions.size(), kUntouched),
        tangents(mesh.geometry.slot_count * 4, kUntouched) {
    EXPECT_EQ(local_to_model(skeleton, local, model), Status::ok);
    EXPECT_EQ(build_palette(mesh, model, palette), Status::ok);
    EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  }
  SkinOutput output() { return {positions, normals, tangents}; }
  std::vector<Status> skin(Span<const Affine> entries, const SkinOutput& out) {
    return {skin_rigid(mesh, entries, out), skin_ssd(mesh, entries, out), skin_as(mesh, coordinates, entries, out)};
  }
  bool untouched() const {
    for (const auto* v : {&positions, &normals, &tangents})
      for (const float f : *v)
        if (f != kUntouched) return false;
    return true;
  }

  static constexpr float kUntouched = -77.0f;
  test::TestCharacter c;
  Skeleton skeleton;
  Clip clip;
  Mesh mesh;
  std::vector<SoaTransform> local;
  std::vector<Affine> model, palette;
  std::vector<float> coordinates, positions, normals, tangents;
};

template <class T>
Span<T> shorter(std::vector<T>& v) {
  return {v.data(), v.size() - 1};
}

// One entry fewer than its geometry follows, as if that were another mesh's.
TEST(BadCalls, AnotherMeshesGeometry) {
  Frame f;
  const test::TestMultiWeights weights(5, f.mesh, 0);
  const test::TestPoseSpace poses(7, f.mesh, 5);
  weights.put(f.mesh.geometry);
  poses.put(f.mesh.geometry);
  std::vector<float> distances(psd_distance_count(f.mesh.geometry)), tangents(as_tangent_count(f.mesh.geometry));
  ASSERT_EQ(psd_distances(f.mesh.geometry, f.palette, distances), Status::ok);
  const auto call_all = [&] {
    std::vector<Status> out = f.skin(f.palette, f.output());
    out.push_back(skin_mwe(f.mesh, f.palette, f.output()));
    out.push_back(skin_psd(f.mesh, distances, f.palette, f.output()));
    const AsPart part{&f.mesh, f.coordinates, tangents};
    std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&part, 1}) / 4);
    out.push_back(as_tangents({&part, 1}, {reinterpret_cast<std::byte*>(scratch.data()), scratch.size() * 4}));
    return out;
  };
  ASSERT_EQ(f.mesh.geometry.joint_count, f.mesh.joint_count);
  --f.mesh.joint_count;
  int refused = 0;
  for (const Status status : call_all()) {
    EXPECT_EQ(status, Status::bad_argument);
    ++refused;
  }
  EXPECT_EQ(refused, 6);
  EXPECT_TRUE(f.untouched());
  ++f.mesh.joint_count;
  for (const Status status : call_all()) EXPECT_EQ(status, Status::ok);
}

void expect_refused(const std::vector<Status>& all) {
  ASSERT_EQ(all.size(), 3u);
  for (const Status status : all) EXPECT_EQ(status, Status::bad_argument);
}

TEST(BadCalls, Sample) {
  Frame f;
  ASSERT_EQ(sample(f.skeleton, f.clip, 0.5f, f.local), Status::ok);
  EXPECT_EQ(sample(f.skeleton, f.clip, 0.5f, shorter(f.local)), Status::bad_argument);
  EXPECT_EQ(sample(f.skeleton, f.clip, 0.5f, {}), Status::bad_argument);
  EXPECT_EQ(sample(f.skeleton, f.clip, std::nanf(""), f.local), Status::bad_argument);
  for (const float time_s : {INFINITY, -INFINITY, 1e30f, -1e30f})
    EXPECT_EQ(sample(f.skeleton, f.clip, time_s, f.local), Status::ok) << "clamped";
  const test::TestSkeleton smaller({{}, {0}, {1}});
  EXPECT_EQ(sample(smaller.view(), f.clip, 0.5f, f.local), Status::bad_argument);
}

TEST(BadCalls, LocalToModel) {
  Frame f;
  EXPECT_EQ(local_to_model(f.skeleton, shorter(f.local), f.model), Status::bad_argument);
  EXPECT_EQ(local_to_model(f.skeleton, f.local, shorter(f.model)), Status::bad_argument);
  EXPECT_EQ(local_to_model(f.skeleton, {}, f.model), Status::bad_argument);
}

TEST(BadCalls, Palette) {
  Frame f;
  EXPECT_EQ(build_palette(f.mesh, shorter(f.model), f.palette), Status::bad_argument);
  EXPECT_EQ(build_palette(f.mesh, f.model, shorter(f.palette)), Status::bad_argument);
  EXPECT_EQ(build_palette(f.c.mesh.joints, shorter(f.c.mesh.inverse_bind), f.model, f.palette), Status::bad_argument);
  const std::vector<std::uint16_t> far = {10};
  EXPECT_EQ(build_palette(far, f.c.mesh.inverse_bind, f.model, f.palette), Status::bad_argument);
}

TEST(BadCalls, SkinOutputs) {
  Frame f;
  expect_refused(f.skin(shorter(f.palette), f.output()));
  expect_refused(f.skin(f.palette, {shorter(f.positions), f.normals, f.tangents}));
  expect_refused(f.skin(f.palette, {f.positions, shorter(f.normals), f.tangents}));
  expect_refused(f.skin(f.palette, {f.positions, f.normals, shorter(f.tangents)}));
  expect_refused(f.skin(f.palette, {{}, f.normals, f.tangents}));
  EXPECT_TRUE(f.untouched());
}

TEST(BadCalls, SkinAttributesThatAreAbsent) {
  Frame f;
  f.mesh.geometry.tangents = nullptr;
  expect_refused(f.skin(f.palette, f.output()));
  f.mesh.geometry.normals = nullptr;
  expect_refused(f.skin(f.palette, {f.positions, f.normals, {}}));
  EXPECT_TRUE(f.untouched());
  for (const Status status : f.skin(f.palette, {f.positions, {}, {}})) EXPECT_EQ(status, Status::ok);
}

TEST(BadCalls, SkinStreamsOffTheirBoundary) {
  Frame f;
  int cases = 0;
  for (const float* Geometry::*stream : {&Geometry::skin, &Geometry::normals, &Geometry::tangents}) {
    const float* const aligned = f.mesh.geometry.*stream;
    f.mesh.geometry.*stream = aligned + 1;
    expect_refused(f.skin(f.palette, f.output()));
    f.mesh.geometry.*stream = aligned;
    ++cases;
  }
  EXPECT_EQ(cases, 3);
  EXPECT_TRUE(f.untouched());
}

TEST(BadCalls, AnimationSpaceCoordinates) {
  Frame f;
  EXPECT_EQ(as_coordinates(f.mesh.geometry, shorter(f.coordinates)), Status::bad_argument);
  EXPECT_EQ(skin_as(f.mesh, shorter(f.coordinates), f.palette, f.output()), Status::bad_argument);
  EXPECT_TRUE(f.untouched());
}

TEST(BadCalls, AnimationSpaceTangents) {
  Frame f;
  std::vector<float> tau(as_tangent_count(f.mesh.geometry), Frame::kUntouched);
  ASSERT_EQ(tau.size(), 2 * f.coordinates.size());
  const AsPart good{&f.mesh, f.coordinates, tau};
  std::vector<std::uint32_t> scratch(as_tangent_scratch_bytes({&good, 1}) / 4);
  std::byte* const bytes = reinterpret_cast<std::byte*>(scratch.data());
  const auto derive = [&](const AsPart& part, std::size_t size) { return as_tangents({&part, 1}, {bytes, size}); };
  Mesh bare = f.mesh;
  bare.geometry.normals = nullptr;
  EXPECT_EQ(derive({nullptr, f.coordinates, tau}, scratch.size() * 4), Status::bad_argument);
  EXPECT_EQ(derive({&bare, f.coordinates, tau}, scratch.size() * 4), Status::bad_argument);
  EXPECT_EQ(derive({&f.mesh, shorter(f.coordinates), tau}, scratch.size() * 4), Status::bad_argument);
  EXPECT_EQ(derive({&f.mesh, f.coordinates, shorter(tau)}, scratch.size() * 4), Status::bad_argument);
  EXPECT_EQ(derive(good, scratch.size() * 4 - 1), Status::bad_argument);
  EXPECT_EQ(as_tangents({&good, 1}, {bytes + 1, scratch.size() * 4 - 1}), Status::bad_argument);
  for (const float t : tau) EXPECT_EQ(t, Frame::kUntouched);
  EXPECT_EQ(skin_as(f.mesh, f.coordinates, f.palette, f.output(), shorter(tau)), Status::bad_argument);
  EXPECT_TRUE(f.untouched());
  EXPECT_EQ(derive(good, scratch.size() * 4), Status::ok);
  EXPECT_EQ(skin_as(f.mesh, f.coordinates, f.palette, f.output(), tau), Status::ok);
}

TEST(BadCalls, LargerThanNeededIsFine) {
  Frame f;
  f.positions.resize(f.positions.size() + 5, Frame::kUntouched);
  f.palette.resize(20);
  for (const Status status : f.skin(f.palette, f.output())) EXPECT_EQ(status, Status::ok);
  for (std::size_t i = f.positions.size() - 5; i < f.positions.size(); ++i)
    EXPECT_EQ(f.positions[i], Frame::kUntouched);
}

}  // namespace
}  // namespace marrow
