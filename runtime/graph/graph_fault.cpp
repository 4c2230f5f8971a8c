#include "graph/graph_fault.h"

#include <algorithm>

#include "math/finite.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMostParameters = 256, kMostPoints = 64, kMostStates = 64, kMostTransitions = 256,
                        kMostConditions = 16, kMostParts = 64, kMostFalloff = 65535;
constexpr float kMostNumber = 1e12f, kMostSeconds = 1e6f, kMostSpeed = 64;

bool is_graph_time(float s) {
  return within(s, 0, kMostSeconds);
}

// Asks one graph for its rules, and keeps the first that it breaks.
class GraphRules {
 public:
  explicit GraphRules(const Graph& graph) : g_(graph) {}

  GraphFault find() {
    expect(g_.parameters.size <= kMostParameters, nullptr, "at most 256 parameters");
    for (const GraphParameter& p : g_.parameters) parameter(p);
    expect(within_count(g_.nodes.size, 1, kMaxGraphNodes), nullptr, "1 to 512 nodes");
    for (const GraphCondition& c : g_.conditions) condition(c);
    for (const GraphMaskPart& p : g_.mask_parts)
      expect(p.role < kRoleCount && p.falloff <= kMostFalloff, &p, "a role of joints, and a falloff up to 65535");
    std::size_t parts = 0;
    for (const GraphMask& m : g_.masks) range(m.first_part, m.part_count, 1, kMostParts, parts, &m, "parts of a mask");
    expect(parts == g_.mask_parts.size, nullptr, "parts of masks in their masks' order");
    for (std::size_t i = 0; i < g_.nodes.size && fault_.rule == nullptr; ++i) node(static_cast<std::uint32_t>(i));
    expect(clips_ == g_.clips.size && spaces_ == g_.spaces.size && machines_ == g_.machines.size &&
               layers_ == g_.layers.size && givens_ == g_.given_count && points_ == g_.points.size &&
               triangles_ == g_.triangles.size && states_ == g_.states.size && transitions_ == g_.transitions.size &&
               conditions_ == g_.conditions.size,
           nullptr, "records in their nodes' order, and no others");
    return fault_;
  }

 private:
  bool expect(bool holds, const void* where, const char* rule) {
    if (!holds && fault_.rule == nullptr) fault_ = {where, rule};
    return holds;
  }
  static bool within_count(std::size_t count, std::size_t least, std::size_t most) {
    return least <= count && count <= most;
  }
  // Of records that stand one after the other.
  bool range(std::uint32_t first, std::uint32_t count, std::uint32_t least, std::uint32_t most, std::size_t& end,
             const void* where, const char* rule) {
    if (!expect(first == end && within_count(count, least, most), where, rule)) return false;
    end += count;
    return true;
  }
  bool is_kind(std::uint32_t parameter, ParameterKind kind) const {
    return parameter < g_.parameters.size && g_.parameters[parameter].kind == kind;
  }

  void parameter(const GraphParameter& p) {
    expect(p.kind <= ParameterKind::trigger && is_graph_time(p.seconds), &p,
           "a kind of parameter, and a time up to 1e6 s");
    if (p.kind == ParameterKind::number)
      expect(within(p.least, -kMostNumber, kMostNumber) && within(p.most, p.least, kMostNumber) &&
                 within(p.initial, p.least, p.most),
             &p, "a number within its range");
    else
      expect(p.initial == 0 || p.initial == 1, &p, "a flag is 0 or 1");
  }

  void condition(const GraphCondition& c) {
    const bool of_number = c.test >= ConditionTest::above;
    const bool fits = of_number
                          ? is_kind(c.parameter, ParameterKind::number)
                          : is_kind(c.parameter, ParameterKind::flag) || is_kind(c.parameter, ParameterKind::trigger);
    expect(fits && c.test <= ConditionTest::at_most && is_finite(c.value), &c, "a condition asks of its parameter");
  }

  bool link(std::uint32_t from, std::uint32_t to, const void* where) {
    return expect(from < to && to < g_.nodes.size && g_.nodes[to].height < g_.nodes[from].height, where,
                  "poses are of nodes that stand later, and lower");
  }

  void node(std::uint32_t index) {
    const GraphNode& n = g_.nodes[index];
    if (!expect(n.kind <= GraphNodeKind::given && n.height < kMaxGraphHeight, &n, "a kind of node, lower than 16"))
      return;
    std::size_t* const counts[] = {&clips_, &spaces_, &machines_, &layers_, &givens_};
    const std::size_t sizes[] = {g_.clips.size, g_.spaces.size, g_.machines.size, g_.layers.size, g_.given_count};
    const auto kind = static_cast<std::uint32_t>(n.kind);
    if (!expect(n.record == (*counts[kind])++ && n.record < sizes[kind], &n, "records in their nodes' order")) return;
    switch (n.kind) {
      case GraphNodeKind::clip:
        clip(g_.clips[n.record]);
        break;
      case GraphNodeKind::space:
        space(index, g_.spaces[n.record]);
        break;
      case GraphNodeKind::machine:
        machine(index, g_.machines[n.record]);
        break;
      case GraphNodeKind::layer:
        layer(index, g_.layers[n.record]);
        break;
      case GraphNodeKind::given:
        break;
    }
    if (fault_.rule == nullptr)
      expect(n.poses == poses_of(g_, index) && n.poses <= kMaxGraphPoses, &n, "as many poses as are held, up to 64");
  }

  void clip(const GraphClip& c) {
    expect(within(c.speed, -kMostSpeed, kMostSpeed) && c.mode <= static_cast<std::uint32_t>(PlayMode::ping_pong), &c,
           "a speed within 64, and a mode");
  }

  void space(std::uint32_t index, const GraphSpace& s) {
    const bool in_plane = s.triangle_count > 0, in_step = (s.flags & kSpaceInStep) != 0;
    if (!range(s.first_point, s.point_count, 1, kMostPoints, points_, &s, "1 to 64 points of a space") ||
        !range(s.first_triangle, s.triangle_count, 0, 2 * kMostPoints, triangles_, &s, "triangles of a space") ||
        !expect(points_ <= g_.points.size && triangles_ <= g_.triangles.size, &s, "points and triangles of a space"))
      return;
    expect(is_kind(s.by[0], ParameterKind::number) &&
               (in_plane ? is_kind(s.by[1], ParameterKind::number) : s.by[1] == kNoIndex),
           &s, "a space goes by a number, in a plane by two");
    const bool matches = (s.flags & kSpaceMatchesSpeed) != 0;
    expect(s.flags <= 3 && (!matches || (in_step && !in_plane)), &s, "only clips in step, on a line, match a speed");
    for (std::uint32_t i = 0; i < s.point_count; ++i) {
      const GraphPoint& p = g_.points[s.first_point + i];
      if (!link(index, p.node, &p)) return;
      expect(within(p.x, -kMostNumber, kMostNumber) && within(p.y, -kMostNumber, kMostNumber), &p,
             "a point within 1e12");
      const bool is_clip = g_.nodes[p.node].kind == GraphNodeKind::clip;
      expect(p.own_speed <= 1 && (is_clip || (p.own_speed == 0 && !in_step)) && (p.own_speed == 0 || !in_plane), &p,
             "points in step, and those that stand at a speed, are clips");
    }
    for (std::uint32_t i = 0; i < s.triangle_count; ++i)
      for (const std::uint32_t corner : g_.triangles[s.first_triangle + i].corners)
        expect(corner < s.point_count, &g_.triangles[s.first_triangle + i], "corners are points of the space");
  }

  void machine(std::uint32_t index, const GraphMachine& m) {
    if (!range(m.first_state, m.state_count, 1, kMostStates, states_, &m, "1 to 64 states of a machine") ||
        !range(m.first_transition, m.transition_count, 0, kMostTransitions, transitions_, &m,
               "up to 256 transitions of a machine") ||
        !expect(states_ <= g_.states.size && transitions_ <= g_.transitions.size, &m, "states and transitions"))
      return;
    expect(is_choice(m.start, m.start_count, m) && (m.flags & ~std::uint32_t{kChooseInTurn}) == 0, &m,
           "a machine starts in a state");
    for (std::uint32_t i = 0; i < m.state_count; ++i) {
      const GraphState& s = g_.states[m.first_state + i];
      if (s.node != kNoIndex && !link(index, s.node, &s)) return;
    }
    for (std::uint32_t i = 0; i < m.transition_count; ++i) transition(m, g_.transitions[m.first_transition + i]);
  }
  static bool is_choice(std::uint32_t first, std::uint32_t count, const GraphMachine& m) {
    return count >= 1 && first < m.state_count && count <= m.state_count - first;
  }

  void transition(const GraphMachine& m, const GraphTransition& t) {
    expect((t.from == kNoIndex || t.from < m.state_count) && is_choice(t.to, t.to_count, m), &t,
           "a transition is from a state to one");
    if (!range(t.first_condition, t.condition_count, 0, kMostConditions, conditions_, &t,
               "up to 16 conditions of a transition"))
      return;
    expect(conditions_ <= g_.conditions.size, &t, "conditions of a transition");
    expect(is_graph_time(t.fade_s) && is_graph_time(t.after_s) && is_graph_time(t.at_end_s) &&
               is_graph_time(t.enter_s) && t.flags < 16,
           &t, "times of a transition are 0 to 1e6 s");
  }

  void layer(std::uint32_t index, const GraphLayer& l) {
    if (!link(index, l.base, &l) || !link(index, l.pose, &l)) return;
    expect(l.mask == kNoIndex || l.mask < g_.masks.size, &l, "no such mask");
    expect(l.by == kNoIndex || is_kind(l.by, ParameterKind::number) || is_kind(l.by, ParameterKind::flag), &l,
           "a layer goes by a number or a flag");
    expect(within(l.weight, 0, 1) && is_graph_time(l.fade_s) && l.flags <= kLayerInModelSpace, &l,
           "a weight from 0 to 1, and a time");
  }

  const Graph& g_;
  GraphFault fault_;
  std::size_t clips_ = 0, spaces_ = 0, machines_ = 0, layers_ = 0, givens_ = 0, points_ = 0, triangles_ = 0,
              states_ = 0, transitions_ = 0, conditions_ = 0;
};

std::uint32_t most_poses(const Graph& g, std::uint32_t node) {
  return node == kNoIndex ? 1 : g.nodes[node].poses;
}

}  // namespace

std::uint32_t poses_of(const Graph& g, std::uint32_t node) {
  const GraphNode& n = g.nodes[node];
  std::uint32_t most = 1;
  switch (n.kind) {
    case GraphNodeKind::clip:
    case GraphNodeKind::given:
      return 1;
    case GraphNodeKind::space: {
      const GraphSpace& s = g.spaces[n.record];
      for (std::uint32_t i = 0; i < s.point_count; ++i)
        most = std::max(most, most_poses(g, g.points[s.first_point + i].node));
      return most + std::min(s.point_count, s.triangle_count > 0 ? 3u : 2u) - 1;
    }
    case GraphNodeKind::machine: {
      const GraphMachine& m = g.machines[n.record];
      for (std::uint32_t i = 0; i < m.state_count; ++i)
        most = std::max(most, most_poses(g, g.states[m.first_state + i].node));
      return most + std::min(m.state_count, kMaxFading) - 1;
    }
    case GraphNodeKind::layer: {
      const GraphLayer& l = g.layers[n.record];
      return std::max(most_poses(g, l.base), 1 + most_poses(g, l.pose));
    }
  }
  return most;
}

GraphFault find_fault(const Graph& graph) {
  return GraphRules(graph).find();
}

}  // namespace marrow
