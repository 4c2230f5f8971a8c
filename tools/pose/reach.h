// Joints brought to points after a pose was sampled, as a game would: what `--ik` asks.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "marrow/marrow.h"
#include "text/choices.h"

namespace marrow::tools {

struct ReachSolver {
  std::optional<IkMethod> method;  // none: two bones, in closed form
  bool is_genetic = false;         // by evolution, whatever the method

  bool operator==(const ReachSolver&) const = default;
};

struct ReachArguments {
  std::vector<std::string> goals;  // "JOINT=X,Y,Z"
  ReachSolver solver;
  std::uint32_t seed = 0;    // of the genetic one
  std::uint32_t joints = 3;  // above each goal's joint that turn, but for those that twist; of two_bone always two
};

inline constexpr Named<ReachSolver> kIkSolvers[] = {{"two_bone", {}},
                                                    {"fabrik", {IkMethod::fabrik}},
                                                    {"ccd", {IkMethod::ccd}},
                                                    {"dls", {IkMethod::damped_least_squares}},
                                                    {"gauss_newton", {IkMethod::gauss_newton}},
                                                    {"genetic", {IkMethod::ccd, true}}};

// How many joints above one bend, and do not share out a bone's twist alone; counted up to `most`.
std::uint32_t bending_joints_above(const File& file, const Skeleton& skeleton, std::uint32_t joint, std::uint32_t most);

class Reach {
 public:
  // Throws Failure (usage): a goal that cannot be read, a joint that is not there, or with too few above it.
  Reach(const File& file, const ReachArguments& arguments);

  bool empty() const { return goals_.empty(); }
  // Brings the joints of this skeleton to their goals. Throws Failure (invalid) if a pose is not finite.
  void apply(std::uint32_t skeleton, const Pose& pose) const;

  struct Goal {
    std::uint32_t skeleton = 0;
    std::uint32_t joint = 0;
    std::array<float, 3> position{};  // model space
    std::string name;                 // of the joint
  };
  const std::vector<Goal>& goals() const { return goals_; }

  // By how much the goal's joint is away from it in this pose; 0 for less than a solver cares about.
  float miss_m(const Goal& goal, Span<const Affine> model_from_joint) const;
  // The names of the joints that turn for it, and its own: "thigh", "shin", "foot".
  std::vector<std::string> chain(const Goal& goal) const;

 private:
  void solve_limbs(std::uint32_t skeleton, const Pose& pose) const;
  void solve_chains(std::uint32_t skeleton, const Pose& pose) const;

  File file_;
  std::vector<Goal> goals_;
  ReachSolver solver_;
  std::uint32_t seed_, joints_;
};

}  // namespace marrow::tools
