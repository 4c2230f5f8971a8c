// A character that goes by a graph: found, bound to clips of any files, and played step by step.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "behave/graphs.h"
#include "behave/shown.h"
#include "common/aligned_bytes.h"
#include "marrow/animator.h"
#include "pose/evaluate.h"

namespace marrow::tools {

// What a machine is in.
struct MachineNow {
  std::string machine;  // the node's name
  std::string state;    // empty: it is not shown
  float seconds = 0;    // since the state was entered
};

class Behaviour {
 public:
  // file: the character's, loaded from `path`; it outlives this. packs: in the order in which their clips count; the
  // character's own come last. Throws Failure: usage if a clip or a joint that the graph wants is not there; invalid,
  // with the joints that are in the way, for a pack that does not fit; what load_mrw() throws of packs.
  Behaviour(const std::string& path, const File& file, FoundGraph found, const std::vector<std::string>& packs,
            const AnimatorOptions& options = {});
  Behaviour(const Behaviour&) = delete;
  Behaviour& operator=(const Behaviour&) = delete;

  const FoundGraph& found() const { return found_; }
  const Graph& graph() const { return binding_.graph; }
  const GraphBinding& binding() const { return binding_; }
  Animator& animator() { return animator_; }
  const Animator& animator() const { return animator_; }
  // Layers that a character needs to be posed.
  std::uint32_t layers() const { return graph().nodes[0].poses; }

  // "speed", "move" (empty: a clip that is named where it is used), "air" of a machine's node.
  std::string parameter_name(std::uint32_t parameter) const;
  std::string node_name(std::uint32_t node) const;
  // The same, but for a clip that is named where it is used the clip's. Empty: the layer that a `one_shot` is made of.
  std::string shown_name(std::uint32_t node) const;
  std::string state_name(std::uint32_t node, std::uint32_t state) const;
  // Throws Failure (usage) with what may be meant.
  std::uint32_t parameter(const std::string& name) const;

  // By the parameter's kind: a number, clamped to its range; a flag, set above 0.5; a trigger fires whatever the value.
  void set(std::uint32_t parameter, float value);
  // What it is by now: of a number where it is on its way, of the others 0 or 1.
  float value(std::uint32_t parameter) const;
  // What it is set to.
  float wanted(std::uint32_t parameter) const;

  // Moves on, and the character over the ground with it. The step's events stay until the next call.
  const AnimatorStep& update(float dt_s);
  const AnimatorStep& last_step() const { return step_; }
  // Where the character's root has come to, from the origin on.
  const RootPlace& place() const { return place_; }
  Affine world_from_model() const { return marrow::world_from_model(place_); }
  // Seconds of all updates.
  double time_s() const { return time_s_; }
  // As it was before the first update, at the origin.
  void restart();
  // Puts the root elsewhere.
  void place(const RootPlace& there) { place_ = there; }

  // All that it is in: the animator's state, and the poses that inertial fades lead away from, which are no part of
  // that.
  struct Moment {
    std::vector<std::byte> memory;
    AnimatorStep step;
    RootPlace place;
    double time_s = 0;
  };
  Moment moment() const;
  // To a moment of this behaviour: what it shows then, and what comes after, are the same bits.
  void go_back(const Moment& moment);

  // Poses the character, which has layers() layers, where its root has come to: its joints are in the world.
  void pose(Character& character);

  // One a machine, in the graph's order.
  std::vector<MachineNow> machines() const;
  std::vector<ShownNode> shown() const { return shown_nodes(animator_); }

 private:
  void bind(const std::string& path, const File& file, std::span<const std::string> packs);

  FoundGraph found_;
  AnimatorOptions options_;
  std::vector<LoadedFile> packs_;
  std::vector<AlignedBytes> animations_memory_;
  std::vector<Animations> animations_;
  AlignedBytes binding_memory_, memory_;
  GraphBinding binding_;
  Animator animator_;
  AnimatorStep step_;
  RootPlace place_;
  double time_s_ = 0;
};

}  // namespace marrow::tools
