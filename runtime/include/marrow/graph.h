// A behaviour as data: what a game sets, and how poses of clips come of it. A view of what `marrow cook --graph` wrote;
// animator.h plays it, and docs/stages/animator.md says what it does.
#pragma once

#include <cstdint>

#include "marrow/blend_space.h"
#include "marrow/playback.h"
#include "marrow/roles.h"
#include "marrow/span.h"

namespace marrow {

// No node, parameter or mask.
inline constexpr std::uint32_t kNoIndex = 0xFFFFFFFF;
inline constexpr std::uint32_t kMaxGraphNodes = 512;  // of a graph
inline constexpr std::uint32_t kMaxGraphHeight = 16;  // nodes that stand below each other
inline constexpr std::uint32_t kMaxFading = 4;        // states of a machine that are shown at once
inline constexpr std::uint32_t kMaxGraphPoses = 64;   // that are held at once

// What a parameter is.
enum class ParameterKind : std::uint32_t {
  number,
  flag,
  trigger,  // set until a transition takes it, or its time is over
};

// What a game sets.
struct GraphParameter {
  std::uint32_t name = 0;                      // here and below see File::text, of the graph's file
  ParameterKind kind = ParameterKind::number;  // what it is
  float initial = 0;                           // of a flag 0 or 1
  float least = 0;                             // of a number
  float most = 0;                              // likewise
  // Of a number its half-life: it goes half of the way to what it is set to in this time. Of a trigger how long it
  // waits. ≥ 0
  float seconds = 0;
};

// What makes a node's pose.
enum class GraphNodeKind : std::uint32_t {
  clip,
  space,
  machine,
  layer,
  given,  // the game
};

// A node stands before those whose poses it takes; the first one's pose is the graph's.
struct GraphNode {
  std::uint32_t name = 0;                    // empty: a clip that is named where it is used
  GraphNodeKind kind = GraphNodeKind::clip;  // what makes its pose
  std::uint32_t record = 0;  // of Graph's array of that kind, which stand in the nodes' order; of given: which pose
  std::uint16_t height = 0;  // above those whose poses it takes
  std::uint16_t poses = 1;   // that are held at once to make this one
};

// Plays a clip.
struct GraphClip {
  std::uint32_t name = 0;  // the clip's
  float speed = 1;         // seconds of the clip a second, within ±64
  std::uint32_t mode = 0;  // a PlayMode
};

// A pose of a space.
struct GraphPoint {
  std::uint32_t node = 0;       // whose pose stands there
  float x = 0;                  // where on the line, or in the plane
  float y = 0;                  // in a plane
  std::uint32_t own_speed = 0;  // 1: x is the speed of its clip
};

// Bits of GraphSpace::flags.
enum SpaceFlags : std::uint32_t {
  kSpaceInStep = 1,        // its clips go by one phase, see phase.h
  kSpaceMatchesSpeed = 2,  // as match_speed()
};
// Blends poses that stand on a line, or in a plane.
struct GraphSpace {
  std::uint32_t first_point = 0;               // of Graph::points
  std::uint32_t point_count = 0;               // from that on
  std::uint32_t by[2] = {kNoIndex, kNoIndex};  // numbers; on a line one
  std::uint32_t first_triangle = 0;            // of Graph::triangles
  std::uint32_t triangle_count = 0;            // from that on; 0 on a line
  std::uint32_t flags = 0;                     // SpaceFlags
};

// A state of a machine.
struct GraphState {
  std::uint32_t name = 0;         // its own
  std::uint32_t node = kNoIndex;  // kNoIndex: nothing, so a layer above shows less of itself
};

// Bits of GraphTransition::flags.
enum TransitionFlags : std::uint32_t {
  kFadeIsInertial = 1,
  kEnterInPhase = 2,  // the target begins in the phase of what it follows
  kChooseInTurn = 4,  // of several targets: one after the other; else by chance
  kWaitsForEnd = 8,   // for the end of the state's clip
};
// From a state of a machine to another.
struct GraphTransition {
  std::uint32_t from = kNoIndex;      // kNoIndex: any but the target
  std::uint32_t to = 0;               // a state
  std::uint32_t to_count = 1;         // so many states from that on, of which one is chosen
  std::uint32_t first_condition = 0;  // of Graph::conditions
  std::uint32_t condition_count = 0;  // from that on; all must hold
  float fade_s = 0;                   // how long it takes
  float after_s = 0;                  // that the state has lasted, at least
  float at_end_s = 0;                 // with kWaitsForEnd: before the end
  float enter_s = 0;                  // where the target begins
  std::uint32_t flags = 0;            // TransitionFlags
};

// What a condition asks of a parameter.
enum class ConditionTest : std::uint32_t { set, not_set, above, below, at_least, at_most };
// One of those that all hold.
struct GraphCondition {
  std::uint32_t parameter = 0;              // of Graph::parameters
  ConditionTest test = ConditionTest::set;  // what is asked of it
  float value = 0;                          // of numbers
};

// Is in one of several states.
struct GraphMachine {
  std::uint32_t first_state = 0;       // of Graph::states
  std::uint32_t state_count = 0;       // from that on
  std::uint32_t first_transition = 0;  // of Graph::transitions
  std::uint32_t transition_count = 0;  // from that on, in the order in which they are asked
  std::uint32_t start = 0;             // as GraphTransition::to
  std::uint32_t start_count = 1;       // as GraphTransition::to_count
  std::uint32_t flags = 0;             // kChooseInTurn: of the start
};

// Bits of GraphLayer::flags.
enum LayerFlags : std::uint32_t {
  kLayerIsAdditive = 1,
  kLayerInModelSpace = 2,  // as overlay_in_model_space()
};
// Lays a pose over another.
struct GraphLayer {
  std::uint32_t base = 0;         // a node
  std::uint32_t pose = 0;         // that is laid over it
  std::uint32_t mask = kNoIndex;  // of Graph::masks; kNoIndex: all joints
  std::uint32_t by = kNoIndex;    // a number or a flag; kNoIndex: `weight`
  float weight = 1;               // 0 … 1
  float fade_s = 0;               // of a flag: how long it takes from 0 to 1
  std::uint32_t flags = 0;        // LayerFlags
};

// A joint and all below it, as in mask_below().
struct GraphMaskPart {
  std::uint32_t role = 0;     // a Role; 0: `joint`
  std::uint32_t joint = 0;    // its name
  std::uint32_t falloff = 0;  // over so many joints it grows
};
// Several joints, and all below each.
struct GraphMask {
  std::uint32_t first_part = 0;  // of Graph::mask_parts
  std::uint32_t part_count = 0;  // from that on
};

// A graph. Plain spans, from File::graph() or made by hand.
struct Graph {
  const char* name = "";                         // as its text's file is called
  Span<const GraphParameter> parameters = {};    // what a game sets
  Span<const GraphNode> nodes = {};              // the first one's pose is the graph's
  Span<const GraphClip> clips = {};              // one a node of that kind, as spaces, machines and layers
  Span<const GraphSpace> spaces = {};            // likewise
  Span<const GraphPoint> points = {};            // space after space
  Span<const PlaneTriangle> triangles = {};      // likewise; their corners are points of their space
  Span<const GraphMachine> machines = {};        // one a node of that kind
  Span<const GraphState> states = {};            // machine after machine
  Span<const GraphTransition> transitions = {};  // likewise
  Span<const GraphCondition> conditions = {};    // transition after transition
  Span<const GraphLayer> layers = {};            // one a node of that kind
  Span<const GraphMask> masks = {};              // of layers
  Span<const GraphMaskPart> mask_parts = {};     // mask after mask
  std::uint32_t given_count = 0;                 // nodes that are given
};

}  // namespace marrow
