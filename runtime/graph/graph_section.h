// GRPH: a behaviour, as graph.h has it. load() looks at where it stands alone; File::graph() holds it to its rules.
#pragma once

#include "asset/format.h"
#include "marrow/graph.h"

namespace marrow::format {

struct GraphHeader {
  std::uint32_t name;
  std::uint32_t parameter_count, node_count, clip_count, space_count, point_count, triangle_count, machine_count,
      state_count, transition_count, condition_count, layer_count, mask_count, part_count, given_count;
};
static_assert(sizeof(GraphHeader) == 60);

struct GraphLayout {
  Array<GraphParameter> parameters;
  Array<GraphNode> nodes;
  Array<GraphClip> clips;
  Array<GraphSpace> spaces;
  Array<GraphPoint> points;
  Array<PlaneTriangle> triangles;
  Array<GraphMachine> machines;
  Array<GraphState> states;
  Array<GraphTransition> transitions;
  Array<GraphCondition> conditions;
  Array<GraphLayer> layers;
  Array<GraphMask> masks;
  Array<GraphMaskPart> parts;
  std::uint64_t bytes;
};
template <>
struct LayoutOf<GraphHeader> {
  using Type = GraphLayout;
};

// find_fault() has the rules of numbers.
template <class V>
constexpr void fields(V& v, const GraphParameter& p) {
  v.name({"name", "offset into NAME"}, p.name);
  v.any({"kind", "0 number, 1 flag, 2 trigger"}, p.kind);
  v.any({"initial", "of a number least … most; of a flag 0 or 1"}, p.initial);
  v.any({"least", "of a number, within ±10¹²"}, p.least);
  v.any({"most", "least … 10¹²"}, p.most);
  v.any({"seconds", "0 … 10⁶; of a number its half-life, of a trigger how long it waits"}, p.seconds);
}

template <class V>
constexpr void fields(V& v, const GraphNode& n) {
  v.name({"name", "offset into NAME"}, n.name);
  v.any({"kind", "0 clip, 1 space, 2 machine, 3 layer, 4 given"}, n.kind);
  v.any({"record", "how many nodes of this kind stand before it"}, n.record);
  v.any({"height", "≤ 15, above those of the nodes whose poses it takes"}, n.height);
  v.any({"poses", "≤ 64, as many as are held at once"}, n.poses);
}

template <class V>
constexpr void fields(V& v, const GraphClip& c) {
  v.name({"name", "offset into NAME"}, c.name);
  v.any({"speed", "within ±64"}, c.speed);
  v.any({"mode", "0 once, 1 loop, 2 to and fro"}, c.mode);
}

template <class V>
constexpr void fields(V& v, const GraphSpace& s) {
  v.any({"first_point", "the points of the spaces before"}, s.first_point);
  v.any({"point_count", "1 … 64"}, s.point_count);
  v.any({"by", "numbers; the second is 0xFFFFFFFF on a line"}, s.by);
  v.any({"first_triangle", "the triangles of the spaces before"}, s.first_triangle);
  v.any({"triangle_count", "0 on a line"}, s.triangle_count);
  v.any({"flags", "1 its clips go by one phase; 2 it matches a speed"}, s.flags);
}

template <class V>
constexpr void fields(V& v, const GraphPoint& p) {
  v.any({"node", "below in the graph"}, p.node);
  v.any({"x", "within ±10¹²"}, p.x);
  v.any({"y", "likewise"}, p.y);
  v.any({"own_speed", "1: x is the speed of its clip; else 0"}, p.own_speed);
}

template <class V>
constexpr void fields(V& v, const PlaneTriangle& t) {
  v.any({"corners", "points of the space, counter-clockwise"}, t.corners);
}

template <class V>
constexpr void fields(V& v, const GraphMachine& m) {
  v.any({"first_state", "the states of the machines before"}, m.first_state);
  v.any({"state_count", "1 … 64"}, m.state_count);
  v.any({"first_transition", "the transitions of the machines before"}, m.first_transition);
  v.any({"transition_count", "≤ 256"}, m.transition_count);
  v.any({"start", "a state"}, m.start);
  v.any({"start_count", "≥ 1; so many states from it on"}, m.start_count);
  v.any({"flags", "4 one in turn, else one by chance"}, m.flags);
}

template <class V>
constexpr void fields(V& v, const GraphState& s) {
  v.name({"name", "offset into NAME"}, s.name);
  v.any({"node", "below in the graph; 0xFFFFFFFF nothing"}, s.node);
}

template <class V>
constexpr void fields(V& v, const GraphTransition& t) {
  v.any({"from", "a state; 0xFFFFFFFF any"}, t.from);
  v.any({"to", "a state"}, t.to);
  v.any({"to_count", "≥ 1; so many states from it on"}, t.to_count);
  v.any({"first_condition", "the conditions of the transitions before"}, t.first_condition);
  v.any({"condition_count", "≤ 16"}, t.condition_count);
  v.any({"fade_s", "0 … 10⁶"}, t.fade_s);
  v.any({"after_s", "0 … 10⁶"}, t.after_s);
  v.any({"at_end_s", "0 … 10⁶"}, t.at_end_s);
  v.any({"enter_s", "0 … 10⁶"}, t.enter_s);
  v.any({"flags", "1 inertial; 2 enters in phase; 4 one in turn, else one by chance; 8 waits for the end"}, t.flags);
}

template <class V>
constexpr void fields(V& v, const GraphCondition& c) {
  v.any({"parameter", "which"}, c.parameter);
  v.any({"test", "0 set, 1 not set; of numbers 2 above, 3 below, 4 at least, 5 at most"}, c.test);
  v.any({"value", "finite"}, c.value);
}

template <class V>
constexpr void fields(V& v, const GraphLayer& l) {
  v.any({"base", "below in the graph"}, l.base);
  v.any({"pose", "likewise"}, l.pose);
  v.any({"mask", "which; 0xFFFFFFFF none"}, l.mask);
  v.any({"by", "a number or a flag; 0xFFFFFFFF none"}, l.by);
  v.any({"weight", "0 … 1"}, l.weight);
  v.any({"fade_s", "0 … 10⁶"}, l.fade_s);
  v.any({"flags", "1 additive; 2 rotations as in model space"}, l.flags);
}

template <class V>
constexpr void fields(V& v, const GraphMask& m) {
  v.any({"first_part", "the parts of the masks before"}, m.first_part);
  v.any({"part_count", "1 … 64"}, m.part_count);
}

template <class V>
constexpr void fields(V& v, const GraphMaskPart& p) {
  v.any({"role", "as in ROLE; 0 none"}, p.role);
  v.name({"joint", "offset into NAME; of a joint without role"}, p.joint);
  v.any({"falloff", "≤ 65535"}, p.falloff);
}

template <class V>
constexpr void fields(V& v, const GraphHeader& h, GraphLayout& l) {
  v.name({"name", "offset into NAME"}, h.name);
  v.any({"parameter_count", "≤ 256"}, h.parameter_count);
  v.any({"node_count", "1 … 512"}, h.node_count);
  v.any({"clip_count"}, h.clip_count);
  v.any({"space_count"}, h.space_count);
  v.any({"point_count"}, h.point_count);
  v.any({"triangle_count"}, h.triangle_count);
  v.any({"machine_count"}, h.machine_count);
  v.any({"state_count"}, h.state_count);
  v.any({"transition_count"}, h.transition_count);
  v.any({"condition_count"}, h.condition_count);
  v.any({"layer_count"}, h.layer_count);
  v.any({"mask_count"}, h.mask_count);
  v.any({"part_count"}, h.part_count);
  v.any({"given_count"}, h.given_count);
  const auto each = [&](const auto& record) { fields(v, record); };
  v.records({"parameters", "see below", "parameter_count"}, l.parameters, h.parameter_count, each);
  v.records({"nodes", "see below", "node_count"}, l.nodes, h.node_count, each);
  v.records({"clips", "see below", "clip_count"}, l.clips, h.clip_count, each);
  v.records({"spaces", "see below", "space_count"}, l.spaces, h.space_count, each);
  v.records({"points", "see below", "point_count"}, l.points, h.point_count, each);
  v.records({"triangles", "see below", "triangle_count"}, l.triangles, h.triangle_count, each);
  v.records({"machines", "see below", "machine_count"}, l.machines, h.machine_count, each);
  v.records({"states", "see below", "state_count"}, l.states, h.state_count, each);
  v.records({"transitions", "see below", "transition_count"}, l.transitions, h.transition_count, each);
  v.records({"conditions", "see below", "condition_count"}, l.conditions, h.condition_count, each);
  v.records({"layers", "see below", "layer_count"}, l.layers, h.layer_count, each);
  v.records({"masks", "see below", "mask_count"}, l.masks, h.mask_count, each);
  v.records({"parts", "see below", "part_count"}, l.parts, h.part_count, each);
}

}  // namespace marrow::format
