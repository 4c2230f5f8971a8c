#include "gl/support/crowd_worst.h"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "gles3/crowd/crowd.h"
#include "marrow/marrow.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

constexpr double kMostNormalDeg = 1;
constexpr double kLeastConditioning = 0.05;

// A turn, an even scale and a shift.
Affine placed(Random& random, double scale, double reach) {
  const Quat q = random.rotation();
  Affine out = {};
  TestJoint joint;
  joint.rotation = q;
  joint.scale = {scale, scale, scale};
  for (double& x : joint.translation) x = random.between(-reach, reach);
  const TestSkeleton one({joint});
  const Skeleton view = one.view();
  EXPECT_EQ(local_to_model(view, {view.rest, 1}, {&out, 1}), Status::ok);
  return out;
}

struct Vertices {
  std::vector<float> positions, normals, tangents;
  explicit Vertices(const Geometry& g) : positions(std::size_t{3} * g.slot_count) {
    if (g.normals != nullptr) normals.resize(positions.size());
    if (g.tangents != nullptr) tangents.resize(std::size_t{4} * g.slot_count);
  }
  SkinOutput output() { return {positions, normals, tangents}; }
};

double diagonal_of(Span<const float> positions) {
  double squared = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    float low = 1e30f, high = -1e30f;
    for (std::size_t i = c; i < positions.size; i += 3) {
      low = std::min(low, positions[i]);
      high = std::max(high, positions[i]);
    }
    squared += static_cast<double>(high - low) * static_cast<double>(high - low);
  }
  return std::sqrt(squared);
}

}  // namespace

std::vector<gles3::CrowdInstance> some_of_each(const gles3::CrowdFrames& frames, std::size_t count, double around_s,
                                               double reach) {
  Random random(5);
  std::vector<gles3::CrowdInstance> out(count);
  const auto clips = static_cast<std::uint32_t>(frames.clips.size);
  for (std::size_t i = 0; i < count; ++i) {
    gles3::CrowdInstance& one = out[i];
    one.world_from_model = placed(random, random.between(0.5, 2), reach);
    const auto play = [&](std::uint32_t clip) {
      return gles3::CrowdPlay{clip, static_cast<float>(random.between(0, 3)), static_cast<float>(random.between(-2, 2)),
                              around_s + random.between(-9, 9)};
    };
    one.a = play(static_cast<std::uint32_t>(i) % clips);
    if (i % 4 == 0) continue;
    one.b = play(random.below(clips));
    one.blend_start_s = around_s + (i % 4 == 1 ? -0.4 : i % 4 == 2 ? 100 : -100);
    one.blend_s = 0.8f;
  }
  return out;
}

Worst compare_instance(const Mesh& mesh, const gles3::CrowdFrames& frames, const gles3::CrowdInstance& instance,
                       double time_s, gles3::Deformer deformer, Span<const float> coordinates,
                       Span<const float> tangents, const Skinned& got) {
  std::vector<Affine> pose(frames.joint_count), palette(mesh.palette_size());
  EXPECT_EQ(gles3::crowd_pose(frames, instance, time_s, pose), Status::ok);
  EXPECT_EQ(build_palette(mesh, pose, palette), Status::ok);
  Vertices want(mesh.geometry);
  std::vector<double> well(mesh.geometry.slot_count, 1.0);
  switch (deformer) {
    case gles3::Deformer::rigid:
      EXPECT_EQ(skin_rigid(mesh, palette, want.output()), Status::ok);
      break;
    case gles3::Deformer::ssd:
      EXPECT_EQ(skin_ssd(mesh, palette, want.output()), Status::ok);
      well = conditioning(mesh.geometry, palette, false);
      break;
    default:
      EXPECT_EQ(skin_as(mesh, coordinates, palette, want.output(), tangents), Status::ok);
      well = tangents.empty() ? conditioning(mesh.geometry, palette, true)
                              : surface_conditioning(mesh.geometry, tangents, palette);
  }
  return compare(mesh.geometry, got, want.output(), diagonal_of(want.positions), well, kLeastConditioning);
}

Worst compare_crowd(const Mesh& mesh, const Reel& reel, Span<const float> tangents, double after_s,
                    std::uint32_t count) {
  Worst worst;
  Troop troop(mesh, reel, count, tangents);
  if (!troop.ok()) return worst;
  const bool surface = (troop.gpu().features & gles3::kSurfaceNormals) != 0;
  std::vector<float> coordinates(as_coordinate_count(mesh.geometry));
  EXPECT_EQ(as_coordinates(mesh.geometry, coordinates), Status::ok);
  const std::vector<gles3::CrowdInstance> instances = some_of_each(reel.frames, count, 7, 3);
  EXPECT_EQ(troop.set(0, instances), Status::ok);
  for (const double moment_s : {0.0, 0.013, 0.2}) {
    const double time_s = 7 + after_s + moment_s;
    EXPECT_EQ(troop.blend(0, count, time_s), Status::ok);
    for (const gles3::Deformer deformer : {gles3::Deformer::rigid, gles3::Deformer::ssd, gles3::Deformer::as}) {
      if (surface && deformer != gles3::Deformer::as) continue;
      const std::vector<Skinned> got = troop.capture(deformer, 0, count);
      for (std::size_t i = 0; i < count; ++i)
        worst.add(compare_instance(mesh, reel.frames, instances[i], time_s, deformer, coordinates,
                                   surface ? tangents : Span<const float>{}, got[i]));
    }
  }
  return worst;
}

void expect_crowd_promises(const char* what, const Worst& worst) {
  std::printf("%s: position %.1e of the diagonal, normal %.3f deg, tangent %.3f deg, %zu vertices, %zu normals\n", what,
              worst.position, worst.normal_deg, worst.tangent_deg, worst.vertices, worst.normals);
  EXPECT_LE(worst.position, kMostCrowdPosition) << what;
  EXPECT_LE(worst.normal_deg, kMostNormalDeg) << what;
  EXPECT_LE(worst.tangent_deg, kMostNormalDeg) << what;
  EXPECT_EQ(worst.wrong_signs, 0u) << what;
  EXPECT_GE(worst.vertices, 500u) << what;
  EXPECT_GE(worst.normals, worst.vertices / 2) << what;
}

std::vector<gles3::CrowdSource> all_clips(const File& file, std::uint32_t skeleton) {
  std::vector<gles3::CrowdSource> out;
  for (std::uint32_t i = 0; i < file.clip_count(); ++i)
    if (file.clip(i).skeleton == skeleton) out.push_back({file.clip(i), i % 2 == 0});
  return out;
}

}  // namespace marrow::test
