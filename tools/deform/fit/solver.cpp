#include "deform/fit/solver.h"

#include <algorithm>
#include <cmath>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd errors_of(const std::vector<Part>& parts, std::size_t weighing, std::size_t poses) {
  VectorXd out = VectorXd::Zero(index(poses));
  for (const Part& part : parts) out += part.chosen[weighing].errors;
  return out;
}

// By poses left out.
Chosen judged(const std::vector<Part>& parts, const std::vector<JudgedPose>& poses, std::size_t weighing) {
  const VectorXd errors = errors_of(parts, weighing, poses.size());
  Chosen out;
  out.weighing = weighing;
  double reference = 0;
  std::size_t worse = 0;
  for (std::size_t p = 0; p < poses.size(); ++p) {
    if (!poses[p].at->shipped) continue;
    ++out.shipped;
    out.squares += errors[index(p)];
    reference += poses[p].reference_error;
    worse += errors[index(p)] > poses[p].reference_error;
  }
  if (!(reference > 0)) return {weighing, {}, {}, 0, 0};
  out.quality = {std::sqrt(out.squares / reference), static_cast<double>(worse) / static_cast<double>(out.shipped)};
  return out;
}

std::size_t best_weighing(const std::vector<Part>& parts, const std::vector<JudgedPose>& poses, double most_worse) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t w = 0; !parts.empty() && w < parts.front().chosen.size(); ++w) {
    const FitQuality quality = judged(parts, poses, w).quality;
    const double cost = quality.share * (1 + 2 * std::max(0.0, quality.worse_share - most_worse));
    if (cost >= least) continue;
    least = cost;
    best = w;
  }
  return best;
}

void keep_what_is_not_learnt(const std::vector<JudgedPose>& poses, std::size_t weighing, std::vector<Part>& parts) {
  VectorXd errors = errors_of(parts, weighing, poses.size());
  for (std::size_t p = 0; p < poses.size(); ++p) {
    const Index at = index(p);
    while (!poses[p].at->learnt && errors[at] > poses[p].reference_error * (1 - 1e-6)) {
      const auto added = [&](const Part& part) { return part.chosen[weighing].errors[at] - part.prior[at]; };
      const auto worst = std::ranges::max_element(parts, {}, added);
      if (worst == parts.end() || !(added(*worst) > 0)) break;
      errors += worst->prior - worst->chosen[weighing].errors;
      worst->chosen[weighing] = {kKeepPrior, worst->prior};
    }
  }
}

}  // namespace

void sort_by_fold(std::vector<TrainingPose>& poses) {
  std::stable_sort(poses.begin(), poses.end(), [](const TrainingPose& a, const TrainingPose& b) {
    return a.learnt != b.learnt ? a.learnt : a.learnt && a.fold < b.fold;
  });
}

std::vector<Fold> folds_of(const std::vector<JudgedPose>& poses) {
  std::vector<Fold> out;
  for (std::size_t i = 0; i < poses.size() && poses[i].at->learnt; ++i) {
    if (i == 0 || poses[i].at->fold != poses[i - 1].at->fold) out.push_back({i, 0});
    ++out.back().count;
  }
  return out;
}

Chosen choose_settings(Basis& basis, const std::vector<JudgedPose>& poses, double most_worse,
                       const Progress& progress) {
  std::vector<Part> parts(basis.parts());
  Steps steps(progress, parts.size());
  tools::for_each_in_parallel(parts.size(), [&](std::size_t p) {
    parts[p] = basis.choose(p);
    steps.one_more();
  });
  const std::size_t weighing = best_weighing(parts, poses, most_worse);
  keep_what_is_not_learnt(poses, weighing, parts);
  Chosen out = judged(parts, poses, weighing);
  for (const Part& part : parts) out.settings.push_back(part.chosen[weighing].setting);
  return out;
}

void solve(Basis& basis, const Chosen& chosen) {
  tools::for_each_in_parallel(chosen.settings.size(), [&](std::size_t p) {
    if (chosen.settings[p] != kKeepPrior) basis.solve(p, chosen.weighing, chosen.settings[p]);
  });
}

}  // namespace marrow::deform
