// What an animator is in, as plain bytes, and what it keeps of a step.
#pragma once

#include "marrow/animator.h"
#include "marrow/phase.h"
#include "marrow/transition.h"
#include "math/rigid.h"

namespace marrow {

// In Animator::state, first of all.
struct AnimatorHead {
  std::uint64_t graph;  // GraphBinding::hash
  double age_s;
  float inertia_s;              // how long the last inertial fade takes
  std::uint32_t inertia_count;  // of those so far; 0: none
  std::uint32_t chance;         // xorshift32
  std::uint8_t is_updated;      // 0 before the first update
  std::uint8_t is_changing;     // weights were on their way when the last one ended
  std::uint8_t reserved[2];
};
static_assert(sizeof(AnimatorHead) == 32);

// Behind it, one a parameter.
struct ParameterState {
  float target;  // what the game set; of a trigger whether it is
  float value;   // of a number where it is by now; of a trigger how long it waits
};

// Then one a node, by its kind. All begin with whether the node is shown.
struct ClipState {
  std::uint32_t is_shown;
  std::uint32_t returning;
  double time_s;
};
struct SpaceState {
  std::uint32_t is_shown;
  std::uint32_t segment;
  double share;
};
struct MachineState {
  std::uint32_t is_shown;
  std::uint32_t count;  // of `chain`
  double in_state_s;    // since the current state was entered, and its fade began
  float fade_s;
  float shares[kMaxFading - 1];     // of the others in what is left beside the current one; their sum is 1
  std::uint16_t chain[kMaxFading];  // states: the current one first
  std::uint32_t turn;               // how often one was chosen in turn
  std::uint32_t reserved;
};
static_assert(sizeof(MachineState) == 48);
struct LayerState {
  std::uint32_t is_shown;
  float ramp;  // of a flag, 0 … 1
};

// How a node is entered. All 0: it goes on.
struct Entry {
  bool begins = false;    // anew
  bool in_phase = false;  // at the place, else at time_s
  float time_s = 0;
  double share = 0;  // the place, see Phase
  std::uint32_t segment = 0;

  Phase place() const { return {share, segment, 0}; }
};

// What happens to a node in a step. Set by GraphStep::reach().
struct NodeStep {
  bool is_reached = false;
  bool is_kept = false;   // it is shown at the end of the step
  bool is_heard = false;  // its events count, and its machines decide
  bool moves = false;     // `motion` is not 0
  Entry entry = {};
  float loudness = 0;  // what its events weigh
  float presence = 0;  // of a machine: less where it shows nothing
  Screw motion = {};
};

// What a link has in a step, and at its end.
struct LinkStep {
  float mean = 0, end = 0;
};

struct ShownSkeleton {
  Span<SoaTransform> shown[2] = {};  // the last two poses
  Span<SoaTransform> spare = {};
  Inertia inertia = {};
};

struct AnimatorScratch {
  AnimatorOptions options = {};
  Span<std::byte> begun = {}, part_begun = {};  // the state at the begin of an update, and of a part of it
  Span<NodeStep> nodes = {};
  Span<LinkStep> links = {};
  Span<float> weights = {};    // a link
  Span<PhaseClip> group = {};  // of a space in step
  Span<float> means = {};      // of a number over the step
  Span<AnimatorEvent> events = {};
  std::uint32_t event_count = 0, left_out = 0;
  double cut_s = -1;         // where a step must be cut, as a transition falls due then; below 0: nowhere
  bool has_changed = false;  // weights changed in the update, but for those by numbers
  bool is_changing = false;  // they are on their way when the step ends
  // Of poses.
  Span<ShownSkeleton> skeletons = {};
  double shown_at_s[2] = {};        // by the animator's age
  std::uint32_t shown_count = 0;    // how many of the two are there
  std::uint32_t newest = 0;         // which of them was last
  std::uint32_t inertia_count = 0;  // AnimatorHead's, of the fade that is shown
  double inertia_at_s = 0;          // by the age: of the pose that it leads away from
};

inline AnimatorHead& head_of(Span<std::byte> state) {
  return *reinterpret_cast<AnimatorHead*>(state.data);
}
inline const AnimatorHead& head_of(const Animator& a) {
  return *reinterpret_cast<const AnimatorHead*>(a.state.data);
}
inline ParameterState* parameters_of(Span<std::byte> state) {
  return reinterpret_cast<ParameterState*>(state.data + sizeof(AnimatorHead));
}
template <class T>
T& state_of_node(const GraphBinding& b, Span<std::byte> state, std::uint32_t node) {
  return *reinterpret_cast<T*>(state.data + b.state_at[node]);
}

}  // namespace marrow
