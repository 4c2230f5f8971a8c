// Multi-weights and pose space from fits to the cooked file and back: what the runtime makes of them, plain and packed.
#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "cook/geometry/build_geometry.h"
#include "cook/write/write_scene.h"
#include "deform/cylinder.h"
#include "deform/deformers.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "marrow/skin.h"
#include "marrow/unpack.h"
#include "support/aligned.h"

namespace marrow::cook {
namespace {

const std::vector<int> kCylinderParents = {-1, 0};

// The cylinder with weights as the cooker rounds them, deltas and weights fitted to dual quaternions.
struct FittedCylinder {
  FittedCylinder() : mesh(deform::cylinder()) {
    primitive.indices = mesh.indices;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      glm::dvec3& p = mesh.positions[v];
      p = glm::round((p + 8.0) / kStep) * kStep - 8.0;
      primitive.positions.emplace_back(p);
      double w = 0;
      for (deform::Influence& i : mesh.influences[v]) {
        i.weight = i.joint == 0 ? std::round(i.weight * 4095) / 4095 : 1 - w;
        w = i.weight;
      }
      std::erase_if(mesh.influences[v], [](const deform::Influence& i) { return i.weight == 0; });
      if (mesh.influences[v].size() == 1) mesh.influences[v][0].weight = 1;
      bindings.emplace_back();
      for (const deform::Influence& i : mesh.influences[v]) {
        bindings.back().set.push_back(static_cast<std::uint16_t>(i.joint));
        bindings.back().weights.push_back(i.weight);
      }
    }
    fit();
  }
  void fit() {
    std::vector<deform::TrainingPose> poses;
    for (std::uint32_t i = 0; i < 12; ++i)
      poses.push_back({deform::cylinder_pose(0.17 * i, 0.2 * (i * 5 % 12)), i % 4});
    const deform::Deformer truth = deform::dual_quaternions(mesh);
    weights = deform::fit_multi_weights(mesh, 0, poses, truth).weights;
    space = deform::fit_pose_space(mesh, kCylinderParents, poses, truth).space;
    data.multi_weight.root = 0;
    for (const auto& vertex : weights) {
      data.multi_weight.weights.emplace_back();
      for (const deform::MultiWeight& w : vertex) {
        auto& twelve = data.multi_weight.weights.back().emplace_back();
        for (int i = 0; i < 12; ++i)
          twelve[static_cast<std::size_t>(i)] = w.rows[static_cast<std::size_t>(i / 4)][i % 4];
      }
    }
    data.pose_space.sigma = space.sigma;
    data.pose_space.parents = {kNoJoint, 0};
    for (const deform::PoseSpaceExample& e : space.examples)
      data.pose_space.examples.push_back({e.rotations, e.deltas});
  }

  static constexpr double kStep = 0x1p-10;
  deform::SkinnedMesh mesh;
  RawPrimitive primitive;
  std::vector<Binding> bindings;
  deform::MultiWeights weights;
  deform::PoseSpace space;
  DeformerData data;
};

BuiltGeometry build_fitted(const FittedCylinder& source, const DeformerData& data, MeshCodec codec) {
  CookOptions options;
  options.mesh.codec = codec;
  options.mesh.keep_vertex_order = true;
  const MeshGrid grid{glm::dvec3(-8), FittedCylinder::kStep};
  return build_geometry(source.primitive, source.bindings, 2, grid, options.mesh, data);
}

// A file round a geometry, as load() takes it.
struct CookedDeformers {
  explicit CookedDeformers(BuiltGeometry geometry) {
    BuiltScene scene;
    BuiltSkeleton skeleton;
    skeleton.joint_names = {"a", "b"};
    skeleton.parents = {kNoJoint, 0};
    const Affine identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
    skeleton.model_from_root = {identity};
    SoaTransform rest{};
    for (int lane = 0; lane < 4; ++lane) {
      rest.rotation[3][lane] = 1;
      for (auto& axis : rest.scale) axis[lane] = 1;
    }
    skeleton.rest = {rest};
    scene.skeletons = {skeleton};
    BuiltMesh mesh;
    mesh.joints = {0, 1};
    mesh.inverse_bind = {identity, identity};
    mesh.bind_is_given = {0, 0};
    scene.meshes = {mesh};
    scene.geometries.push_back(std::move(geometry));
    const std::vector<std::byte> bytes = write_scene(scene, "test").bytes;
    const Span<const std::byte> span(bytes.data(), bytes.size());
    UnpackSizes sizes{static_cast<std::uint32_t>(bytes.size()), static_cast<std::uint32_t>(bytes.size())};
    if (is_packed(span)) {
      EXPECT_EQ(unpack_sizes(span, sizes), Status::ok);
    }
    memory = std::make_unique<test::AlignedBlock>(sizes.memory_bytes);
    Span<const std::byte> plain(memory->data(), bytes.size());
    const MeshDecoder decoders[] = {draco_decoder(), meshopt_decoder()};
    if (is_packed(span)) {
      EXPECT_EQ(unpack(span, {decoders, 2}, {memory->data(), memory->size()}, plain), Status::ok);
    } else {
      std::memcpy(memory->data(), bytes.data(), bytes.size());
    }
    EXPECT_EQ(load(plain, file), Status::ok);
  }
  std::unique_ptr<test::AlignedBlock> memory;
  File file;
};

std::vector<Affine> palette_of_pose(const deform::Pose& pose) {
  std::vector<Affine> out;
  for (const deform::Matrix& m : pose) {
    Affine& a = out.emplace_back();
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) a.rows[r][c] = static_cast<float>(m[c][r]);
  }
  return out;
}

// How far the runtime's vertices are from the offline deformer's, at worst over some poses.
double farthest_from_offline(const FittedCylinder& source, const Mesh& mesh, bool multi_weight) {
  const deform::Deformer offline = multi_weight ? deform::multi_weight(source.mesh, source.weights, 0)
                                                : deform::pose_space(source.mesh, source.space);
  double worst = 0;
  for (int i = 0; i <= 6; ++i) {
    const deform::Pose pose = deform::cylinder_pose(0.3 * i, 0.35 * (i * 3 % 7));
    const std::vector<Affine> palette = palette_of_pose(pose);
    std::vector<float> positions(mesh.geometry.slot_count * 3), distances(psd_distance_count(mesh.geometry));
    if (multi_weight) {
      EXPECT_EQ(skin_mwe(mesh, palette, {positions, {}, {}}), Status::ok);
    } else {
      EXPECT_EQ(psd_distances(mesh.geometry, palette, distances), Status::ok);
      EXPECT_EQ(skin_psd(mesh, distances, palette, {positions, {}, {}}), Status::ok);
    }
    deform::Positions expected;
    offline(pose, expected);
    for (std::size_t v = 0; v < expected.size(); ++v) {
      const float* const p = &positions[std::size_t{mesh.geometry.source_slots[v]} * 3];
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(expected[v][c] - double{p[c]}));
    }
  }
  return worst;
}

TEST(CookDeformers, TheRuntimeMakesOfThemWhatTheFitMeant) {
  const FittedCylinder source;
  ASSERT_EQ(source.data.pose_space.examples.size(), 8u);
  for (const MeshCodec codec : {MeshCodec::none, MeshCodec::draco, MeshCodec::meshopt}) {
    const BuiltGeometry built = build_fitted(source, source.data, codec);
    EXPECT_LE(built.error.multi_weight, FittedCylinder::kStep);
    EXPECT_LE(built.error.pose_space, FittedCylinder::kStep);
    const CookedDeformers loaded(built);
    ASSERT_EQ(loaded.file.mesh_count(), 1u);
    const Mesh mesh = loaded.file.mesh(0);
    ASSERT_EQ(mesh.geometry.source_slots.size, source.mesh.positions.size());
    ASSERT_NE(mesh.geometry.mwe_residual, nullptr);
    ASSERT_EQ(mesh.geometry.pose_space.examples.size, 8u);
    const double most = codec == MeshCodec::none ? 5e-5 : FittedCylinder::kStep;
    EXPECT_LT(farthest_from_offline(source, mesh, true), most);
    EXPECT_LT(farthest_from_offline(source, mesh, false), most);
  }
}

TEST(CookDeformers, EachCanBeAlone) {
  const FittedCylinder source;
  DeformerData only_weights = source.data, only_space = source.data;
  only_weights.pose_space = {};
  only_space.multi_weight = {};
  const CookedDeformers weights(build_fitted(source, only_weights, MeshCodec::meshopt)),
      space(build_fitted(source, only_space, MeshCodec::draco));
  EXPECT_NE(weights.file.mesh(0).geometry.mwe_residual, nullptr);
  EXPECT_TRUE(weights.file.mesh(0).geometry.pose_space.examples.empty());
  EXPECT_EQ(space.file.mesh(0).geometry.mwe_residual, nullptr);
  EXPECT_LT(farthest_from_offline(source, weights.file.mesh(0), true), FittedCylinder::kStep);
  EXPECT_LT(farthest_from_offline(source, space.file.mesh(0), false), FittedCylinder::kStep);
}

TEST(CookDeformers, DataThatDoNotFitAreRefused) {
  const FittedCylinder source;
  std::vector<DeformerData> bad(8, source.data);
  bad[0].multi_weight.root = 2;
  bad[1].multi_weight.weights.pop_back();
  bad[2].multi_weight.weights[1000].pop_back();
  bad[3].multi_weight.weights[0][0][5] = NAN;
  bad[4].pose_space.sigma = 0;
  bad[5].pose_space.parents[1] = 2;
  bad[6].pose_space.examples[3].deltas.pop_back();
  bad[7].pose_space.examples[0].deltas[5].x = INFINITY;
  int refused = 0;
  for (const DeformerData& data : bad) {
    EXPECT_THROW(build_fitted(source, data, MeshCodec::meshopt), tools::Failure) << refused;
    ++refused;
  }
  EXPECT_EQ(refused, 8);
}

}  // namespace
}  // namespace marrow::cook
