#include "commands/compare/thesis/frame_rates.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <numbers>

#include "bench/vertices.h"
#include "common/check_status.h"
#include "common/elementary.h"
#include "cook/learn/learn.h"
#include "deform/before_ssd.h"
#include "deform/deformers.h"
#include "deform/fit/eigen_skin.h"
#include "deform/fit/multi_weight.h"
#include "deform/fit/pose_space.h"
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

// A tube along x of rings of twenty, on a chain of joints at even distances.
struct Chain {
  cook::DeformSource source;

  explicit Chain(const ThesisSize& size) {
    constexpr std::uint32_t kRound = 20;
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
        mesh.influences.push_back(influences_at(x));
      }
    const auto at = [](std::uint32_t i, std::uint32_t k) { return i * kRound + k % kRound; };
    for (std::uint32_t i = 0; i + 1 < along; ++i)
      for (std::uint32_t k = 0; k < kRound; ++k)
        mesh.indices.insert(mesh.indices.end(),
                            {at(i, k), at(i, k + 1), at(i + 1, k + 1), at(i, k), at(i + 1, k + 1), at(i + 1, k)});
  }

  // As far as there are four joints, those within 1.5 of it.
  std::vector<deform::Influence> influences_at(double x) const {
    std::vector<deform::Influence> out;
    double sum = 0;
    for (std::uint32_t j = 0; j < source.mesh.joint_count; ++j) {
      const double near = std::max(0.0, 1.5 - std::abs(x - 0.5 - j));
      if (near <= 0) continue;
      out.push_back({j, near * near});
      sum += near * near;
    }
    for (deform::Influence& i : out) i.weight /= sum;
    return out;
  }

  // All joints bend and twist alike.
  deform::Pose pose(double bend_rad, double twist_rad) const {
    deform::Pose out;
    for (std::uint32_t j = 0; j < source.mesh.joint_count; ++j) {
      const glm::dquat turn = angle_axis(bend_rad, {0, 0, 1}) * angle_axis(twist_rad, {1, 0, 0});
      const glm::dmat3 linear = glm::mat3_cast(turn);
      const deform::Matrix about(linear[0], linear[1], linear[2], source.centres[j] - linear * source.centres[j]);
      out.push_back(j == 0 ? about : deform::Matrix(glm::dmat4(out.back()) * glm::dmat4(about)));
    }
    return out;
  }
  static glm::dquat angle_axis(double angle_rad, const glm::dvec3& axis) {
    return {cosine(angle_rad / 2), axis * sine(angle_rad / 2)};
  }
};

// A deformer with what it refers to.
template <class Kept>
deform::Deformer kept(std::shared_ptr<const Kept> what, deform::Deformer deformer) {
  return [what = std::move(what), deformer = std::move(deformer)](const deform::Pose& pose, deform::Positions& to) {
    deformer(pose, to);
  };
}

// Name and deformer of all that there is offline. Learnt ones are from eight poses; what they cost a frame is the same
// after any. `chain` outlives them.
std::vector<std::pair<std::string, deform::Deformer>> offline(const Chain& chain, cook::LearnOptions options) {
  constexpr int kPoses = 8;
  std::vector<deform::TrainingPose> poses;
  for (int i = 0; i < kPoses; ++i)
    poses.push_back({chain.pose(0.1 * i, 0.15 * (i % 3)), static_cast<std::uint32_t>(i), true});
  const cook::DeformSource& source = chain.source;
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

void add(const std::string& algorithm, const char* path, double rate, std::vector<FrameRate>& to) {
  auto row = std::ranges::find_if(to, [&](const FrameRate& r) { return r.algorithm == algorithm && r.path == path; });
  if (row == to.end()) row = to.insert(to.end(), {algorithm, path, false, {}});
  row->frames_per_s.push_back(rate);
}

}  // namespace

std::vector<FrameRate> processor_rates(const cook::LearnOptions& options) {
  std::vector<FrameRate> out;
  for (const ThesisSize& size : kThesisSizes) {
    for (const char* const algorithm : {"rigid", "ssd", "as", "as_helpers"})
      add(algorithm, "kernel", kernel_rate(size, algorithm), out);
    const Chain chain(size);
    const deform::SkinnedMesh stitched = deform::stitched(chain.source.mesh);
    const deform::Pose pose = chain.pose(0.3, 0.4);
    deform::Positions positions;
    const deform::Deformer by_seams = deform::ssd(stitched);
    add("stitched", "double", frames_per_s([&] { by_seams(pose, positions); }), out);
    for (const auto& named : offline(chain, options))
      add(named.first, "double", frames_per_s([&] { named.second(pose, positions); }), out);
  }
  return out;
}

}  // namespace marrow::tools
