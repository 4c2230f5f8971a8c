// What a game does to the newt's pose after its clips: feet stay where they have come down, it looks at something,
// leans into a curve, and its tail follows the way that it has come.
#pragma once

#include <array>
#include <vector>

#include <glm/vec3.hpp>

#include "marrow/glm.h"
#include "marrow/marrow.h"

namespace marrow::tools {

// The sample's joint of a role. Throws Failure (internal) if it has none.
std::uint32_t joint_with(const Roles& roles, Role role);

class Adjuster {
 public:
  static constexpr std::size_t kFeet = 2;  // the left one first

  // file: the sample's, as cooked.
  explicit Adjuster(const File& file);

  // A contact of this foot has begun: as soon as it is down it stays where it is, until it is lifted.
  void come_down(std::size_t foot) { wait_s_[foot] = kWait_s; }
  bool is_planted(std::size_t foot) const { return planted_[foot]; }

  // How far blends of gaits have the feet of a pose in model space below the ground, metres.
  float sunk(const Pose& pose) const;
  // Of a pose in model space. dt_s: since the last one.
  void place(const Pose& pose, const Affine& world_from_model, float dt_s);
  // Turns neck and head, and the eyes by so much of what is left; weights: 0 … 1.
  void look(const Pose& pose, const Affine& world_from_model, const glm::vec3& target, float head, float eyes) const;
  // Leans the trunk to the left, radians.
  void lean(const Pose& pose, float left_rad) const;
  // Turns the tail towards a point.
  void trail(const Pose& pose, const Affine& world_from_model, const glm::vec3& target, float weight) const;

  // On the ground below the ball of a foot; world, of joints in the world.
  glm::vec3 ball(std::size_t foot, Span<const Affine> world_from_joint) const;
  // How high the lowest of heel, ball and toes is, above the ground at height 0; of a foot that stands 0.
  float height(std::size_t foot, Span<const Affine> world_from_joint) const;
  // Of the foot, seen from above: radians from +Z towards +X.
  float heading(std::size_t foot, Span<const Affine> world_from_joint) const;
  glm::vec3 head(Span<const Affine> world_from_joint) const;

 private:
  struct Part {
    std::uint32_t joint = 0;
    glm::vec3 place{0};  // in the joint's space; on the ground at rest
  };
  std::array<Foot, kFeet> feet_;
  std::array<std::array<Part, 3>, kFeet> soles_;  // heel, ball, toes
  Feet both_;
  std::array<FootMotion, kFeet> motions_ = {};
  std::array<bool, kFeet> planted_ = {};
  static constexpr float kWait_s = 0.1f;
  std::array<float, kFeet> wait_s_ = {};  // how long a contact that has begun is waited for
  std::vector<std::uint32_t> gaze_, trunk_, tail_;
  std::array<std::uint32_t, 2> eyes_ = {kNoJoint, kNoJoint};
  Aim look_, eye_[2], trail_;
  std::uint32_t head_ = 0;
};

}  // namespace marrow::tools
