// What fits of animation space learn from, and the linear equations that come of it. Internal to tools/deform.
#pragma once

#include "deform/dense.h"
#include "deform/fit/solver.h"

namespace marrow::deform {

// What a truth makes of a pose, in diagonals from `centre`, so that single precision does wherever the character
// stands; and how far the reference is off.
struct Example {
  const TrainingPose* at = nullptr;
  glm::dvec3 centre{0};
  std::vector<glm::vec3> truth;
  bool is_usable = false;
  double reference_error = 0;  // squares, summed
};

// How much poses count: 1 / (error + ε) to the power of none, one or two halves; ε is in mean squared errors.
struct Strength {
  int halves;
  double epsilon;
};
inline constexpr Strength kStrengths[] = {{0, 1}, {1, 0.1}, {2, 0.1}, {2, 0.01}};
inline constexpr std::size_t kBalanced = 1;  // of those
inline constexpr std::size_t kStrengthCount = std::size(kStrengths);

struct Training {
  std::vector<Example> examples;   // by ascending fold; each with a truth that is finite
  std::vector<JudgedPose> judged;  // the same
  std::vector<Fold> folds;
  Fold motion{0, 0};                     // behind them: what is not learnt
  std::vector<Eigen::VectorXd> weights;  // a strength: a row that is learnt; they sum to 1
  // A strength: what a squared error of `motion` counts, so that the reference's there count as much as in the rest.
  std::vector<double> motion_weights;
  double diagonal_m = 1;
};

// Sorts `poses`, which must outlive the result. progress: of poses that the truth has made.
Training prepare_training(double diagonal_m, std::vector<TrainingPose>& poses, const Deformer& truth,
                          const Deformer& reference, const Progress& progress);

// Vertices that may follow the same joints. Unknowns: for each joint x, y, z in diagonals and w, all relative to
// `origin`.
struct Group {
  std::vector<std::uint32_t> joints;
  std::vector<std::uint32_t> vertices;
  glm::dvec3 origin{0};
};
std::vector<Group> group_by_joints(const Coordinates& coordinates);

// A group's equations: `a` times the coordinates is `truth`, a column a vertex. A motion that all joints share is taken
// out of both for precision: it has the same effect on all coordinates, as their w sum to 1.
struct Equations {
  Eigen::MatrixXd a, truth;

  // of: examples, from the first.
  Equations(const Group& group, const Training& training, std::size_t of);
};

// The coordinates of a group's vertices as columns of unknowns, and back.
Eigen::MatrixXd unknowns(const Group& group, const Coordinates& coordinates, double diagonal_m);
glm::dvec4 coordinate(const Group& group, const Eigen::Vector4d& unknown, double diagonal_m);

}  // namespace marrow::deform
