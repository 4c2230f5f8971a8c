#include "compare/thesis/rates.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>

#include "bench/vertices.h"
#include "common/check_status.h"
#include "common/elementary.h"
#include "cook/learn/learn.h"
#include "cook/scene/raw.h"
#include "cook/skin/deform_source.h"
#include "deform/deformers.h"
#include "deform/fit/eigen_skin.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "deform/skinned_mesh.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"

namespace marrow::tools {
namespace {

// A tube on a chain of joints, of any size: what frames a second are measured on. Along x, of rings of twenty; a joint
// at x = 0, 1, 2 …, each below the one before it.
class Tube {
 public:
  explicit Tube(const ThesisSize& size);

  cook::DeformSource source;  // mesh, parents and centres

  // All joints bend and twist alike.
  deform::Pose pose(double bend_rad, double twist_rad) const;
  // As an artist's file has it, with a clip of two seconds that bends and twists it and back.
  cook::RawScene scene() const;
};

// The fastest of many.
double frames_per_s(const std::function<void()>& frame) {
  using Clock = std::chrono::steady_clock;
  constexpr double kLong_s = 0.05;
  double best_s = 1e300, all_s = 0;
  for (int i = 0; i < 5 || (all_s < kLong_s && i < 10000); ++i) {
    const auto start = Clock::now();
    frame();
    const double s = std::chrono::duration<double>(Clock::now() - start).count();
    best_s = std::min(best_s, s);
    all_s += s;
  }
  return 1 / best_s;
}

double kernel_rate(const ThesisSize& size, const std::string& algorithm) {
  const bool has_helpers = algorithm == "as_helpers";
  const GeneratedMesh generated(size.vertices, has_helpers ? 5 : 4, has_helpers ? 2 * size.joints : size.joints);
  const Mesh& mesh = generated.view();
  const std::vector<Affine> palette(mesh.palette_size(), Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  std::vector<float> positions(std::size_t{3} * mesh.geometry.slot_count), coordinates;
  if (algorithm.starts_with("as")) {
    coordinates.resize(as_coordinate_count(mesh.geometry));
    check(as_coordinates(mesh.geometry, coordinates));
  }
  const SkinOutput to{positions};
  return frames_per_s([&] {
    check(algorithm == "rigid" ? skin_rigid(mesh, palette, to)
          : algorithm == "ssd" ? skin_ssd(mesh, palette, to)
                               : skin_as(mesh, coordinates, palette, to));
  });
}

// A deformer with what it refers to.
template <class Kept>
deform::Deformer kept(std::shared_ptr<const Kept> what, deform::Deformer deformer) {
  return [what = std::move(what), deformer = std::move(deformer)](const deform::Pose& pose, deform::Positions& to) {
    deformer(pose, to);
  };
}

// Name and deformer of all that there is offline. Learnt ones are from eight poses; what they cost a frame is the same
// after any. `tube` outlives them.
std::vector<std::pair<std::string, deform::Deformer>> offline(const Tube& tube, cook::LearnOptions options) {
  constexpr int kPoses = 8;
  std::vector<deform::TrainingPose> poses;
  for (int i = 0; i < kPoses; ++i)
    poses.push_back({tube.pose(0.1 * i, 0.15 * (i % 3)), static_cast<std::uint32_t>(i), true});
  const cook::DeformSource& source = tube.source;
  const deform::SkinnedMesh& mesh = source.mesh;
  std::vector<std::pair<std::string, deform::Deformer>> out = {
      {"joint_local", deform::joint_operators(mesh, source.parents, source.centres)}, {"ssd", deform::ssd(mesh)}};
  for (const Named<cook::Truth>& truth : kJudgedTruths) {
    options.truth = truth.value;
    out.emplace_back(truth.name, cook::make_truth(source, options));
  }
  const deform::Deformer truth = out.back().second;
  const auto weights = std::make_shared<const deform::MultiWeightFit>(deform::fit_multi_weights(mesh, 0, poses, truth));
  out.emplace_back("mwe", kept(weights, deform::multi_weight(mesh, weights->weights, 0)));
  const auto space =
      std::make_shared<const deform::PoseSpaceFit>(deform::fit_pose_space(mesh, source.parents, poses, truth));
  out.emplace_back("psd", kept(space, deform::pose_space(mesh, space->space)));
  const auto skin = std::make_shared<const deform::EigenSkin>(
      deform::fit_eigen_skin(mesh, source.parents, source.centres, poses, truth));
  out.emplace_back("eigenskin", kept(skin, deform::eigen_skin(mesh, *skin)));
  return out;
}

// The runtime's kernels of what the cooker learns for a tube, in a pose that it has learnt from.
class LearntKernels {
 public:
  LearntKernels(const Tube& tube, const cook::LearnOptions& learn) : bytes_(cooked(tube, learn)) {
    check(load({bytes_.data(), bytes_.size()}, file_));
    mesh_ = file_.mesh(0);
    const Skeleton skeleton = file_.skeleton(0);
    std::vector<SoaTransform> local(skeleton.soa_size());
    std::vector<Affine> scene(skeleton.joint_count);
    check(sample(skeleton, file_.clip(0), 1, local));
    check(local_to_model(skeleton, local, scene));
    palette_.resize(mesh_.palette_size());
    check(build_palette(mesh_, scene, palette_));
    positions_.resize(std::size_t{3} * mesh_.geometry.slot_count);
    distances_.resize(psd_distance_count(mesh_.geometry));
  }
  double multi_weights() {
    return frames_per_s([&] { check(skin_mwe(mesh_, palette_, {positions_})); });
  }
  double pose_space() {
    return frames_per_s([&] {
      check(psd_distances(mesh_.geometry, palette_, distances_));
      check(skin_psd(mesh_, distances_, palette_, {positions_}));
    });
  }
  // Morph targets as EigenSkin's fields, all of which move in each frame.
  double eigen_targets() {
    AlignedBytes memory(morphed_bytes(mesh_.geometry));
    MorphedGeometry morphed;
    check(make_morphed(mesh_.geometry, {memory.data(), memory.size()}, morphed));
    Mesh moved = mesh_;
    moved.geometry = morphed.geometry;
    std::vector<float> weights(mesh_.targets.size, 0.5F);
    return frames_per_s([&] {
      check(morph(weights, morphed));
      check(skin_ssd(moved, palette_, {positions_}));
    });
  }

 private:
  static AlignedBytes cooked(const Tube& tube, const cook::LearnOptions& learn) {
    cook::CookOptions options;
    options.learn = learn;
    options.mesh.codec = cook::MeshCodec::none;
    return AlignedBytes{std::span<const std::byte>(cook::cook_scene(tube.scene(), options).file)};
  }

  AlignedBytes bytes_;
  File file_;
  Mesh mesh_;
  std::vector<Affine> palette_;
  std::vector<float> positions_, distances_;
};

void add(const std::string& algorithm, const char* path, double rate, std::vector<FrameRate>& to) {
  auto row = std::ranges::find_if(to, [&](const FrameRate& r) { return r.algorithm == algorithm && r.path == path; });
  if (row == to.end()) row = to.insert(to.end(), {algorithm, path, false, {}});
  row->frames_per_s.push_back(rate);
}

void add_learnt_kernels(const Tube& tube, std::vector<FrameRate>& to) {
  cook::LearnOptions learn;
  learn.multi_weights = true;
  learn.pose_examples = 8;
  LearntKernels beside(tube, learn);
  add("mwe", "kernel", beside.multi_weights(), to);
  add("psd", "kernel", beside.pose_space(), to);
  cook::LearnOptions fields;
  fields.eigen_targets = 8;
  add("eigenskin", "kernel", LearntKernels(tube, fields).eigen_targets(), to);
}

constexpr std::uint32_t kRound = 20;

// As far as there are four joints, those within 1.5 of it.
std::vector<deform::Influence> influences_at(double x, std::uint32_t joints) {
  std::vector<deform::Influence> out;
  double sum = 0;
  for (std::uint32_t j = 0; j < joints; ++j) {
    const double near = std::max(0.0, 1.5 - std::abs(x - 0.5 - j));
    if (near <= 0) continue;
    out.push_back({j, near * near});
    sum += near * near;
  }
  for (deform::Influence& i : out) i.weight /= sum;
  return out;
}

glm::dquat angle_axis(double angle_rad, const glm::dvec3& axis) {
  return {cosine(angle_rad / 2), axis * sine(angle_rad / 2)};
}
glm::dquat turn_of(double bend_rad, double twist_rad) {
  return angle_axis(bend_rad, {0, 0, 1}) * angle_axis(twist_rad, {1, 0, 0});
}

}  // namespace

std::vector<FrameRate> processor_rates(const cook::LearnOptions& options) {
  std::vector<FrameRate> out;
  for (const ThesisSize& size : kThesisSizes) {
    for (const char* const algorithm : {"rigid", "ssd", "as", "as_helpers"})
      add(algorithm, "kernel", kernel_rate(size, algorithm), out);
    const Tube tube(size);
    add_learnt_kernels(tube, out);
    const deform::SkinnedMesh stitched = deform::stitched(tube.source.mesh);
    const deform::Pose pose = tube.pose(0.3, 0.4);
    deform::Positions positions;
    const deform::Deformer by_seams = deform::ssd(stitched);
    add("stitched", "double", frames_per_s([&] { by_seams(pose, positions); }), out);
    for (const auto& named : offline(tube, options))
      add(named.first, "double", frames_per_s([&] { named.second(pose, positions); }), out);
  }
  return out;
}

Tube::Tube(const ThesisSize& size) {
  deform::SkinnedMesh& mesh = source.mesh;
  const std::uint32_t along = size.vertices / kRound;
  mesh.joint_count = size.joints;
  for (std::uint32_t j = 0; j < size.joints; ++j) {
    source.parents.push_back(static_cast<int>(j) - 1);
    source.centres.emplace_back(j, 0, 0);
  }
  for (std::uint32_t i = 0; i < along; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k) {
      const double x = static_cast<double>(i) / along * size.joints, angle = 2 * std::numbers::pi * k / kRound;
      mesh.positions.emplace_back(x, 0.3 * cosine(angle), 0.3 * sine(angle));
      mesh.influences.push_back(influences_at(x, size.joints));
    }
  const auto at = [](std::uint32_t i, std::uint32_t k) { return i * kRound + k % kRound; };
  for (std::uint32_t i = 0; i + 1 < along; ++i)
    for (std::uint32_t k = 0; k < kRound; ++k)
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i + 1, k)});
}

deform::Pose Tube::pose(double bend_rad, double twist_rad) const {
  const glm::dmat3 linear = glm::mat3_cast(turn_of(bend_rad, twist_rad));
  deform::Pose out;
  for (std::uint32_t j = 0; j < source.mesh.joint_count; ++j) {
    const deform::Matrix about(linear[0], linear[1], linear[2], source.centres[j] - linear * source.centres[j]);
    out.push_back(j == 0 ? about : deform::Matrix(glm::dmat4(out.back()) * glm::dmat4(about)));
  }
  return out;
}

cook::RawScene Tube::scene() const {
  cook::RawScene out;
  out.source = "tube";
  cook::RawSkin skin;
  const glm::vec4 turned = [] {
    const glm::dquat q = turn_of(0.7, 0.3);
    return glm::vec4(q.x, q.y, q.z, q.w);
  }();
  cook::RawClip clip;
  clip.name = "bend";
  for (std::size_t j = 0; j < source.centres.size(); ++j) {
    cook::RawNode& node = out.nodes.emplace_back();
    node.name = "joint" + std::to_string(j);
    node.parent = source.parents[j];
    if (j > 0) node.translation = {1, 0, 0};
    skin.joints.push_back(static_cast<int>(j));
    skin.inverse_bind.emplace_back(1.0);
    skin.inverse_bind.back()[3] = glm::dvec4(-source.centres[j], 1);
    clip.channels.push_back({static_cast<int>(j),
                             cook::RawPath::rotation,
                             cook::RawInterpolation::linear,
                             {0, 1, 2},
                             {{0, 0, 0, 1}, turned, {0, 0, 0, 1}}});
  }
  out.nodes.emplace_back().name = "tube";
  cook::RawPrimitive primitive;
  primitive.pointer = "/meshes/0/primitives/0";
  primitive.indices = source.mesh.indices;
  for (std::size_t v = 0; v < source.mesh.positions.size(); ++v) {
    primitive.positions.emplace_back(source.mesh.positions[v]);
    std::vector<cook::RawInfluence>& to = primitive.influences.emplace_back();
    for (const deform::Influence& i : source.mesh.influences[v]) to.push_back({i.joint, static_cast<float>(i.weight)});
  }
  out.meshes.push_back({"tube", {}, {std::move(primitive)}});
  out.skins.push_back(std::move(skin));
  out.instances.push_back({static_cast<int>(out.nodes.size()) - 1, 0, 0, {}, cook::kNone});
  out.clips.push_back(std::move(clip));
  return out;
}

}  // namespace marrow::tools
