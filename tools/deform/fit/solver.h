// The loop that bases are fitted by; what differs from one to the other is what they plug in. Internal to tools/deform.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "deform/dense.h"
#include "deform/fit/fit.h"

namespace marrow::deform {

// A pose that a fit is judged by.
struct JudgedPose {
  const TrainingPose* at;
  double reference_error;  // squares, summed over vertices
};

// Poses of one fold.
struct Fold {
  std::size_t first, count;
};
// Sorts poses: those that are learnt first, by ascending fold.
void sort_by_fold(std::vector<TrainingPose>& poses);
// Of those that are learnt, in that order; none is empty.
std::vector<Fold> folds_of(const std::vector<JudgedPose>& poses);

inline constexpr std::size_t kKeepPrior = std::numeric_limits<std::size_t>::max();

// What is chosen of some settings, a ridge or a width say: the number of the one that leaves least, or kKeepPrior.
struct Choice {
  std::size_t setting = kKeepPrior;
  Eigen::VectorXd errors;  // squares, a pose
};

// prior: the errors where there is no fit. errors_of(setting): with it, of poses that it has not seen. cost_of(errors):
// what choices are judged by.
template <class ErrorsOf, class CostOf>
Choice best_setting(const Eigen::VectorXd& prior, std::size_t settings, const ErrorsOf& errors_of,
                    const CostOf& cost_of) {
  Choice out{kKeepPrior, prior};
  double least = cost_of(prior);
  for (std::size_t s = 0; s < settings; ++s) {
    Eigen::VectorXd errors = errors_of(s);
    const double cost = cost_of(errors);
    if (!(cost < least)) continue;
    least = cost;
    out = {s, std::move(errors)};
  }
  return out;
}

// A part of a fit, vertices that follow the same joints say.
struct Part {
  Eigen::VectorXd prior;       // squared errors where there is no fit, a pose
  std::vector<Choice> chosen;  // one for each way to weigh poses: all parts are weighed alike in the end
};

// A basis, as far as it is fitted.
class Basis {
 public:
  virtual ~Basis() = default;
  // How many parts there are; each is fitted apart from the others.
  virtual std::size_t parts() const = 0;
  // By cross-validation. From any thread.
  virtual Part choose(std::size_t part) = 0;
  // Writes the part, by all poses. From any thread.
  virtual void solve(std::size_t part, std::size_t weighing, std::size_t setting) = 0;
};

struct Chosen {
  std::size_t weighing = 0;
  std::vector<std::size_t> settings;  // a part
  FitQuality quality;
  double squares = 0;  // of all that is left in shipped poses
  std::size_t shipped = 0;
};

// Lets all parts choose, on all cores. Of the ways to weigh poses the one with the least error over all parts counts,
// and dearly the share of shipped poses beyond `most_worse` that are worse than the reference. In poses that are not
// learnt: until none is worse than the reference, the part that adds most keeps the prior. progress: of parts.
Chosen choose_settings(Basis& basis, const std::vector<JudgedPose>& poses, double most_worse, const Progress& progress);

// Solves the parts that do not keep the prior, on all cores.
void solve(Basis& basis, const Chosen& chosen);

}  // namespace marrow::deform
