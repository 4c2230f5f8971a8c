#include "commands/compare/thesis/frame_rates.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include "bench/vertices.h"
#include "commands/compare/thesis/tube.h"
#include "common/check_status.h"
#include "cook/learn/learn.h"
#include "deform/deformers.h"
#include "deform/fit/eigen_skin.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
#include "disk/cook_on_disk.h"
#include "marrow/marrow.h"

namespace marrow::tools {
namespace {

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

}  // namespace marrow::tools
