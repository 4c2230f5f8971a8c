// Animators: made, updated, saved and taken back.
#include "marrow/animator.h"

#include <cstring>

#include "core/check.h"
#include "core/memory.h"
#include "core/off_boundary.h"
#include "core/zone.h"
#include "graph/graph_step.h"
#include "math/finite.h"
#include "motion/root_screw.h"

namespace marrow {
namespace {

struct AnimatorPieces {
  Span<std::byte> state;
  Span<AnimatorScratch> scratch;
};

AnimatorPieces lay_out(const GraphBinding& b, const AnimatorOptions& options, Memory& memory) {
  AnimatorPieces out;
  out.scratch = memory.take<AnimatorScratch>(1);
  AnimatorScratch made;
  made.options = options;
  out.state = memory.take<std::byte>(b.state_bytes);
  made.begun = memory.take<std::byte>(b.state_bytes);
  made.part_begun = memory.take<std::byte>(b.state_bytes);
  made.nodes = memory.take<NodeStep>(b.graph.nodes.size);
  made.links = memory.take<LinkStep>(b.link_count);
  made.weights = memory.take<float>(b.link_count);
  made.group = memory.take<PhaseClip>(b.link_count);
  made.means = memory.take<float>(b.graph.parameters.size);
  made.events = memory.take<AnimatorEvent>(options.events);
  if (options.poses) {
    made.skeletons = memory.take<ShownSkeleton>(b.character.skeleton_count());
    for (std::uint32_t s = 0; s < b.character.skeleton_count(); ++s) {
      ShownSkeleton of;
      const std::size_t size = b.character.skeleton(s).soa_size();
      for (Span<SoaTransform>& shown : of.shown) shown = memory.take<SoaTransform>(size);
      of.spare = memory.take<SoaTransform>(size);
      of.inertia.offsets = memory.take<InertialOffset>(size);
      if (!made.skeletons.empty()) made.skeletons[s] = of;
    }
  }
  if (!out.scratch.empty()) out.scratch[0] = made;
  return out;
}

// What a node below a link has of it: the means of links times the motions below them.
void sum_links(const GraphStep& step, std::uint32_t node) {
  NodeStep& n = step.step(node);
  const GraphNode& of = step.g.nodes[node];
  const LinkStep* const links = step.links(node);
  const auto sum = [&](std::uint32_t below, double weight) {
    const NodeStep& from = step.step(below);
    if (!(weight > 0) || !from.moves) return;
    add(from.motion, weight, n.motion);
    n.moves = true;
  };
  switch (of.kind) {
    case GraphNodeKind::space: {
      const GraphSpace& s = step.g.spaces[of.record];
      if ((s.flags & kSpaceInStep) != 0) return;
      for (std::uint32_t i = 0; i < s.point_count; ++i)
        sum(step.g.points[s.first_point + i].node, static_cast<double>(links[i].mean));
      return;
    }
    case GraphNodeKind::machine: {
      const GraphMachine& m = step.g.machines[of.record];
      n.presence = 0;
      for (std::uint32_t i = 0; i < m.state_count; ++i) {
        const std::uint32_t below = step.g.states[m.first_state + i].node;
        if (below == kNoIndex || links[i].mean == 0) continue;
        n.presence += links[i].mean;
        sum(below, static_cast<double>(links[i].mean));
      }
      return;
    }
    case GraphNodeKind::layer: {
      const GraphLayer& l = step.g.layers[of.record];
      const NodeStep& over = step.step(l.pose);
      const bool counts = (l.flags & kLayerIsAdditive) == 0 && links[1].mean > 0;
      const float share = counts ? links[1].mean * (l.mask == kNoIndex ? 1.0f : step.b.hips[l.mask]) : 0.0f;
      sum(l.base, 1.0 - static_cast<double>(share * (counts ? over.presence : 0.0f)));
      if (counts) sum(l.pose, static_cast<double>(share));
      return;
    }
    case GraphNodeKind::clip:
    case GraphNodeKind::given:
      return;
  }
}

Status step_node(const GraphStep& step, std::uint32_t node) {
  switch (step.g.nodes[node].kind) {
    case GraphNodeKind::clip:
      return step_clip(step, node);
    case GraphNodeKind::space:
      return step_space(step, node);
    case GraphNodeKind::machine:
      step_machine(step, node);
      break;
    case GraphNodeKind::layer:
      step_layer(step, node);
      break;
    case GraphNodeKind::given:
      break;
  }
  return Status::ok;
}

// From the first node down, then what it comes to from the last one up.
Status step_nodes(const GraphStep& step) {
  const auto count = static_cast<std::uint32_t>(step.g.nodes.size);
  Status status = Status::ok;
  step.reach(0, {.loudness = 1, .is_heard = true, .is_kept = true});
  for (std::uint32_t node = 0; node < count && status == Status::ok; ++node)
    if (step.step(node).is_reached) status = step_node(step, node);
  for (std::uint32_t node = count; node-- > 0;) {
    NodeStep& n = step.step(node);
    if (n.is_reached && status == Status::ok) sum_links(step, node);
    step.own<std::uint32_t>(node) = n.is_reached && n.is_kept ? 1 : 0;
    n.is_reached = false;
  }
  return status;
}

Status step_once(const GraphStep& step, RigidMotion& root) {
  step.s.is_changing = false;
  step_parameters(step);
  const Status status = step_nodes(step);
  if (status != Status::ok) return status;
  end_triggers(step);
  step.head().age_s += step.dt_s;
  step.head().is_updated = 1;
  step.head().is_changing = step.s.is_changing ? 1 : 0;
  if (step.s.nodes[0].moves) root = root * motion_of(step.s.nodes[0].motion);
  return Status::ok;
}

// Cut where transitions fall due.
Status step_in_cuts(const GraphStep& step, RigidMotion& root) {
  constexpr int kMostCuts = 16;
  AnimatorScratch& s = step.s;
  s.has_changed = false;
  double left_s = step.dt_s;
  for (int cuts = 0;; ++cuts) {
    std::memcpy(s.part_begun.data, step.state.data, step.b.state_bytes);
    const std::uint32_t events = s.event_count, left_out = s.left_out;
    const RigidMotion before = root;
    s.cut_s = -1;
    const Status status = step_once({step.b, step.g, step.state, s, left_s}, root);
    const double cut_s = s.cut_s;
    if (status != Status::ok || cut_s < 0 || cuts == kMostCuts) return status;
    std::memcpy(step.state.data, s.part_begun.data, step.b.state_bytes);
    s.event_count = events;
    s.left_out = left_out;
    root = before;
    const Status first = step_once({step.b, step.g, step.state, s, cut_s}, root);
    if (first != Status::ok) return first;
    left_s -= cut_s;
  }
}

// How many equal parts a step in which weights change is taken in: of 1/240 s, as means are not quite the way.
double parts_of(double dt_s) {
  constexpr double kMostParts = 64;
  const double parts = dt_s * 240.0 - 1e-6;
  return !(parts > 1) ? 1 : parts < kMostParts ? static_cast<double>(static_cast<int>(parts) + 1) : kMostParts;
}

BadCall check_animator(const Animator& a) {
  MARROW_CHECK(a.binding != nullptr && a.scratch != nullptr && a.state.size >= a.binding->state_bytes);
  return {};
}

// Whether a state is one that an animator of the binding can have.
bool is_state(const GraphBinding& b, Span<const std::byte> snapshot) {
  const Span<std::byte> state(const_cast<std::byte*>(snapshot.data), snapshot.size);  // it is only read
  const AnimatorHead& head = head_of(state);
  if (head.graph != b.hash || !is_finite(head.age_s) || !within(head.inertia_s, 0, 1e6f) || head.chance == 0)
    return false;
  for (std::uint32_t i = 0; i < b.graph.parameters.size; ++i) {
    const ParameterState& own = parameters_of(state)[i];
    const GraphParameter& p = b.graph.parameters[i];
    const bool is_number = p.kind == ParameterKind::number;
    if (is_number ? !within(own.target, p.least, p.most) || !within(own.value, p.least, p.most)
                  : (own.target != 0 && own.target != 1) || !within(own.value, 0, 1e6f))
      return false;
  }
  for (std::uint32_t n = 0; n < b.graph.nodes.size; ++n) {
    const GraphNode& node = b.graph.nodes[n];
    if (state_of_node<std::uint32_t>(b, state, n) > 1) return false;
    if (node.kind == GraphNodeKind::clip) {
      const auto& own = state_of_node<ClipState>(b, state, n);
      if (own.returning > 1 || !is_finite(own.time_s)) return false;
    } else if (node.kind == GraphNodeKind::space) {
      const auto& own = state_of_node<SpaceState>(b, state, n);
      if (!(own.share >= 0 && own.share < 1)) return false;
    } else if (node.kind == GraphNodeKind::layer) {
      if (!within(state_of_node<LayerState>(b, state, n).ramp, 0, 1)) return false;
    } else if (node.kind == GraphNodeKind::machine) {
      const auto& own = state_of_node<MachineState>(b, state, n);
      const GraphMachine& m = b.graph.machines[node.record];
      if (own.is_shown == 0 && own.count == 0) continue;
      if (own.count < 1 || own.count > kMaxFading || !within(own.fade_s, 0, 1e6f)) return false;
      if (!(own.in_state_s >= 0) || !is_finite(own.in_state_s)) return false;
      for (const std::uint16_t chained : own.chain)
        if (chained >= m.state_count) return false;
      for (const float share : own.shares)
        if (!within(share, 0, 1)) return false;
    }
  }
  return true;
}

}  // namespace

void GraphStep::reach(std::uint32_t node, const Reach& r) const {
  NodeStep& n = step(node);
  const float loudness = r.is_heard ? r.loudness : 0;
  if (!n.is_reached) {
    n = {.is_reached = true,
         .is_kept = r.is_kept,
         .is_heard = r.is_heard,
         .entry = r.entry,
         .loudness = loudness,
         .presence = 1};
    if (!is_shown(node)) n.entry.begins = true;
    return;
  }
  if (r.entry.begins && !n.entry.begins) n.entry = r.entry;
  n.loudness = loudness > n.loudness ? loudness : n.loudness;
  n.is_heard = n.is_heard || r.is_heard;
  n.is_kept = n.is_kept || r.is_kept;
}

std::size_t animator_bytes(const GraphBinding& binding, const AnimatorOptions& options) {
  Memory counted;
  lay_out(binding, options, counted);
  return counted.whole();
}

Status make_animator(const GraphBinding& binding, const AnimatorOptions& options, Span<std::byte> memory,
                     Animator& out) {
  MARROW_REQUIRE(binding.state_bytes > 0);
  MARROW_REQUIRE(within(options.least_loudness, 0, 1));
  MARROW_REQUIRE(holds(memory, animator_bytes(binding, options)));
  MARROW_REQUIRE_GOOD(check_boundary(memory.data));
  Memory taken{memory.data};
  const AnimatorPieces pieces = lay_out(binding, options, taken);
  for (NodeStep& n : pieces.scratch[0].nodes) n = {};
  std::memset(pieces.state.data, 0, pieces.state.size);
  AnimatorHead head{};
  head.graph = binding.hash;
  head.chance = options.seed != 0 ? options.seed : 1;
  head_of(pieces.state) = head;
  for (std::uint32_t i = 0; i < binding.graph.parameters.size; ++i) {
    const GraphParameter& p = binding.graph.parameters[i];
    const float left = p.kind == ParameterKind::trigger && p.initial != 0 ? p.seconds : 0;
    parameters_of(pieces.state)[i] = {p.initial, p.kind == ParameterKind::trigger ? left : p.initial};
  }
  out = {&binding, pieces.state, pieces.scratch.data};
  return Status::ok;
}

Status update_animator(Animator& animator, float dt_s, AnimatorStep& out) {
  MARROW_ZONE;
  MARROW_REQUIRE_GOOD(check_animator(animator));
  MARROW_REQUIRE(is_finite(dt_s) && dt_s >= 0);
  const GraphBinding& b = *animator.binding;
  AnimatorScratch& s = *animator.scratch;
  const GraphStep step{b, b.graph, animator.state, s, static_cast<double>(dt_s)};
  if (step.head().graph != b.hash) return Status::bad_data;
  s.event_count = s.left_out = 0;
  RigidMotion root;
  Status status = Status::ok;
  bool in_parts = step.head().is_changing != 0 || numbers_change(step);
  if (!in_parts) {
    std::memcpy(s.begun.data, animator.state.data, b.state_bytes);
    status = step_in_cuts(step, root);
    in_parts = s.has_changed;
    if (in_parts) std::memcpy(animator.state.data, s.begun.data, b.state_bytes);
  }
  if (in_parts && status == Status::ok) {
    s.event_count = s.left_out = 0;
    root = {};
    const double parts = parts_of(step.dt_s);
    const GraphStep part{b, b.graph, animator.state, s, step.dt_s / parts};
    for (double i = 0; i < parts && status == Status::ok; ++i) status = step_in_cuts(part, root);
  }
  if (status != Status::ok) return status;
  drop_brief_triggers(step);
  AnimatorStep made{{}, {s.events.data, s.event_count}, s.left_out};
  if (!rounded_step(root, made.root)) return Status::bad_data;
  out = made;
  return Status::ok;
}

Status restore_animator(Animator& animator, Span<const std::byte> snapshot) {
  MARROW_REQUIRE_GOOD(check_animator(animator));
  MARROW_REQUIRE(holds(snapshot, animator.binding->state_bytes));
  MARROW_REQUIRE(reinterpret_cast<std::uintptr_t>(snapshot.data) % alignof(AnimatorHead) == 0 &&
                 "a snapshot on a boundary of 8 bytes");
  if (!is_state(*animator.binding, snapshot)) return Status::bad_data;
  std::memcpy(animator.state.data, snapshot.data, animator.binding->state_bytes);
  return Status::ok;
}

namespace {

// The first record with this name; how many there are without.
template <class T>
std::uint32_t find_named(const File& file, Span<const T> records, const char* name) {
  std::uint32_t i = 0;
  while (i < records.size && (name == nullptr || std::strcmp(file.text(records[i].name), name) != 0)) ++i;
  return i;
}

}  // namespace

std::uint32_t find_parameter(const GraphBinding& binding, const char* name) {
  return find_named(binding.file, binding.graph.parameters, name);
}

std::uint32_t find_graph_node(const GraphBinding& binding, const char* name) {
  return find_named(binding.file, binding.graph.nodes, name);
}

std::uint32_t find_state(const GraphBinding& binding, std::uint32_t node, const char* name) {
  const Graph& g = binding.graph;
  if (node >= g.nodes.size || g.nodes[node].kind != GraphNodeKind::machine) return kNoIndex;
  const GraphMachine& m = g.machines[g.nodes[node].record];
  const std::uint32_t found =
      find_named(binding.file, Span<const GraphState>(g.states.data + m.first_state, m.state_count), name);
  return found < m.state_count ? found : kNoIndex;
}

std::uint32_t state_of(const Animator& animator, std::uint32_t node, float* seconds) {
  if (animator.binding == nullptr) return kNoIndex;
  const Graph& g = animator.binding->graph;
  if (node >= g.nodes.size || g.nodes[node].kind != GraphNodeKind::machine) return kNoIndex;
  const auto& own = state_of_node<MachineState>(*animator.binding, animator.state, node);
  if (own.is_shown == 0) return kNoIndex;
  if (seconds != nullptr) *seconds = static_cast<float>(own.in_state_s);
  return own.chain[0];
}

}  // namespace marrow
