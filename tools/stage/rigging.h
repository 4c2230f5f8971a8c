// What changes a pose after a clip has made it: turns and weights of morph targets by hand, limits, goals, springs.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/gtc/quaternion.hpp>

#include "common/aligned_bytes.h"
#include "pose/evaluate.h"
#include "pose/file_springs.h"
#include "stage/settings.h"

namespace marrow::tools {

struct NamedJoint {
  std::string name;
  std::uint32_t skeleton, joint;
};

// A joint of the skeleton, and below it the first child of each: what springs swing.
std::vector<std::uint16_t> chain_below(const Skeleton& skeleton, std::uint32_t joint);

class Rig {
 public:
  // `file` outlives it.
  explicit Rig(const File& file) : file_(file), file_springs_(file) {}

  // Whether the file brings springs; then those swing, and none that begin at a joint.
  bool has_springs() const { return file_springs_.has_any(); }

  // For the next pose. joints: those that the settings have numbers of. dt_s: since the last pose; 0: the springs stand
  // still. world_from_model: where the character is by then.
  void prepare(const Settings& settings, std::span<const NamedJoint> joints, float dt_s,
               const Affine& world_from_model = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});

  // As Character::Change and Character::Weigh.
  void change(std::uint32_t skeleton, const Pose& pose);
  void weigh(std::uint32_t mesh, Span<float> weights) const;

  // Why goals or springs do not work; empty: they do.
  const std::string& trouble() const { return trouble_; }

 private:
  void turn(std::uint32_t skeleton, const Pose& pose) const;
  void make_springs(const Settings& settings, std::uint32_t skeleton, std::uint32_t joint);

  struct TurnedJoint {
    NamedJoint joint;
    glm::quat by;
  };
  const File& file_;
  std::vector<TurnedJoint> turns_;
  bool limits_ = false;
  std::optional<Reach> reach_;
  std::vector<std::string> goals_;
  std::map<std::size_t, float> weights_;
  std::uint32_t spring_skeleton_ = 0;
  std::vector<std::uint16_t> spring_joints_;  // empty: none swing
  FileSprings file_springs_;
  bool swing_files_ = false;
  AlignedBytes memory_;
  Springs springs_;
  SpringFrame frame_;
  std::string trouble_;
};

}  // namespace marrow::tools
