// Animator: a character's behaviour in two calls, from a graph that `marrow cook --graph` made.
//
//   once a load       bind_graph
//   once a character  make_animator
//   every frame       set_number, set_flag, fire; update_animator; pose_character; the game's own feet and springs;
//                     finish_character
//
// update_animator() decides: times, states, events, root motion. pose_character() poses. A server calls only the first;
// results are the same bits. What an animator is in is plain bytes, Animator::state: a snapshot is a copy, and
// restore_animator() takes it back.
//
// No allocation: memory is the caller's, sizes are asked for first. Thread-safe on different animators; bindings are
// only read, and serve any number of them. What each kind of node does, docs/stages/animator.md says.
#pragma once

#include <cstddef>
#include <cstdint>

#include "marrow/api.h"
#include "marrow/character.h"
#include "marrow/graph.h"

namespace marrow {

// Why a graph does not fit a character.
struct GraphMisfit {
  const char* rule = "";  // what is not so
  const char* name = "";  // of what: a clip, a joint or a node
};

// A graph for characters of one file: its clips found, its masks made.
struct GraphBinding {
  File file = {};                             // whose graph it is
  Graph graph = {};                           // as it was given
  File character = {};                        // whose skeletons and meshes it is for
  Span<const Animation> clips = {};           // one a clip of the graph
  Span<const SpeedPoint> points = {};         // one a point: where it stands, and the time of a cycle of its space
  Span<const float> masks = {};               // mask after mask, each as AnimationLayer::mask
  Span<const float> hips = {};                // what a mask leaves of root motion
  Span<const std::uint32_t> state_at = {};    // of a node, in Animator::state
  Span<const std::uint32_t> first_link = {};  // of a node: of its points, states, or base and pose
  std::uint32_t link_count = 0;               // of all nodes
  std::uint32_t state_bytes = 0;              // of an animator
  std::uint64_t hash = 0;                     // of the graph
};

// Bytes that bind_graph() needs. A multiple of 16.
MARROW_API std::size_t graph_binding_bytes(const Graph& graph, const File& character);

// Finds a graph's clips among animations that are made for the character's file, the first of each name, and makes its
// masks.
//
// file: the graph's, for its names; also the character's, or a graph pack. memory: at least graph_binding_bytes(),
// 16-byte aligned; `out` keeps pointers into it, into the animations and into both files' blocks.
// Errors: bad_argument (the memory, a null span); bad_data if the graph breaks a rule of its format; mismatch if
// a clip is missing, a joint of a mask is, or clips of a space do not go together; `misfit`, if not null, says which.
// Cost: compares names; once a load.
MARROW_API Status bind_graph(const File& file, const Graph& graph, const File& character,
                             Span<const Animations> animations, Span<std::byte> memory, GraphBinding& out,
                             GraphMisfit* misfit = nullptr);

// An event of a clip that a step met.
struct AnimatorEvent {
  std::uint32_t id = 0;                  // event_id() of its name
  const char* name = "";                 // as the clip's file has it
  float number = 0;                      // as ClipEvent has it, here and below
  float time_s = 0;                      // in the clip
  float until_s = 0;                     // likewise
  std::uint32_t count = 0;               // how often
  const Animation* animation = nullptr;  // whose clip it is of
};

// The number of an event's name: 32 bits by FNV-1a. May be computed while compiling.
constexpr std::uint32_t event_id(const char* name) {
  std::uint32_t id = 2166136261u;
  if (name == nullptr) return id;
  for (; *name != '\0'; ++name) id = (id ^ static_cast<std::uint8_t>(*name)) * 16777619u;
  return id;
}

// What a step did.
struct AnimatorStep {
  RigidStep root = {};                    // for move_root()
  Span<const AnimatorEvent> events = {};  // in the order of the graph's nodes; until the next update
  std::uint32_t events_left_out = 0;      // that there was no room for
};

// What an animator is made for.
struct AnimatorOptions {
  bool poses = true;          // false: it is only updated; a fade that is inertial is none then
  std::uint32_t events = 32;  // of a step, at most
  std::uint32_t seed = 1;     // of what happens by chance
  // Of clips that are shown less than that, events are left out. 0 … 1
  float least_loudness = 0.1f;
};

struct AnimatorScratch;

// An instance of a graph. Views into the caller's memory; a copy is the same animator.
struct Animator {
  const GraphBinding* binding = nullptr;  // as it was given
  Span<std::byte> state = {};             // what it is in: plain bytes, without pointers
  AnimatorScratch* scratch = nullptr;     // its own
};

// Bytes that make_animator() needs. A multiple of 16.
MARROW_API std::size_t animator_bytes(const GraphBinding& binding, const AnimatorOptions& options);

// An animator before its first update. memory: at least animator_bytes(), 16-byte aligned. The binding outlives it.
// Errors: bad_argument (the memory).
MARROW_API Status make_animator(const GraphBinding& binding, const AnimatorOptions& options, Span<std::byte> memory,
                                Animator& out);

// Index of the first parameter of the graph with this name, or graph.parameters.size; of the first node, or
// graph.nodes.size; of a machine's state, or kNoIndex. Cost: compares names; once a load.
MARROW_API std::uint32_t find_parameter(const GraphBinding& binding, const char* name);
MARROW_API std::uint32_t find_graph_node(const GraphBinding& binding, const char* name);
MARROW_API std::uint32_t find_state(const GraphBinding& binding, std::uint32_t node, const char* name);

// Sets a number, which is clamped to its range; a flag; a trigger, which stays set until a transition takes it, or its
// time is over. Errors: bad_argument if there is no such parameter of that kind, or the value is no number.
MARROW_API Status set_number(Animator& animator, std::uint32_t parameter, float value);
MARROW_API Status set_flag(Animator& animator, std::uint32_t parameter, bool value);
MARROW_API Status fire(Animator& animator, std::uint32_t parameter);

// What a parameter is set to: a flag to 0 or 1, a trigger to 1 while it waits. 0 if there is no such parameter.
MARROW_API float value_of(const Animator& animator, std::uint32_t parameter);

// What a machine is in: a state of that node, and for how long; kNoIndex if the node is no machine, or is not shown.
MARROW_API std::uint32_t state_of(const Animator& animator, std::uint32_t node, float* seconds = nullptr);

// Moves on by dt_s ≥ 0 seconds: parameters, then machines, then clips.
//
// Errors: bad_argument if dt_s is not finite or below 0; bad_data if the state's bytes are none of this graph, or a
// clip breaks a rule of clip_motion.h. The animator may have moved on in part then. Cost: in proportion to the nodes
// that are shown.
MARROW_API Status update_animator(Animator& animator, float dt_s, AnimatorStep& out);

// Takes a snapshot back, a copy of Animator::state: of this animator, or of another of the same binding.
// Errors: bad_data if the bytes are not of this graph, or have what no animator has; nothing is changed.
MARROW_API Status restore_animator(Animator& animator, Span<const std::byte> snapshot);

// A pose that the game gives a node, of one skeleton.
struct GivenPose {
  Span<const SoaTransform> local = {};  // at least skeleton.soa_size(); empty: at rest
};

// Poses as sample_character(), and weights of morph targets, by what the animator is in.
//
// The character is of the binding's file, and holds as many layers as the graph's first node says it needs poses
// (GraphNode::poses); with more, more of what is sampled is kept from frame to frame. given: for each
// given node one a skeleton, in their order; where the list ends nodes are at rest.
// Errors: bad_argument (a character of another file, or of too few layers; a given pose that is too short; an animator
// before its first update); bad_data as update_animator(). Cost: sample_cached() of each clip that is shown, and
// blend(), overlay() and add() of them. Layers in model space write over Pose::model_from_joint.
MARROW_API Status sample_character(Character& character, Animator& animator, Span<const GivenPose> given = {});
// The same, then local_to_model(): ready for inverse kinematics, feet and springs.
MARROW_API Status pose_character(Character& character, Animator& animator, Span<const GivenPose> given = {});

}  // namespace marrow
