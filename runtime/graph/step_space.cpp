// Spaces of a graph: weights of their points, and clips that go by one phase.
#include "graph/graph_step.h"
#include "math/finite.h"
#include "motion/phase_step.h"
#include "motion/root_screw.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMostInSpace = 64;

// The clips of a space in step, with these weights.
Span<const PhaseClip> group_of(const GraphStep& step, const GraphSpace& space, const float* weights) {
  for (std::uint32_t i = 0; i < space.point_count; ++i) {
    const std::uint32_t node = step.g.points[space.first_point + i].node;
    step.s.group[i] = {&step.b.clips[step.g.nodes[node].record].motion, weights[i]};
  }
  return {step.s.group.data, space.point_count};
}

const Animation& clip_of(const GraphBinding& b, const GraphSpace& space, std::uint32_t point) {
  return b.clips[b.graph.nodes[b.graph.points[space.first_point + point].node].record];
}

// Where the phase begins.
bool enter(const GraphBinding& b, const GraphSpace& space, const Entry& entry, SpaceState& own) {
  Phase place = entry.place();
  if (!entry.in_phase) {
    place = {};
    if (entry.time_s > 0 && phase_at(clip_of(b, space, 0).motion, entry.time_s, place) != Status::ok) return false;
  }
  own.share = place.share;
  own.segment = place.segment;
  return true;
}

std::uint32_t loudest(Span<const PhaseClip> clips) {
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < clips.size; ++i)
    if (clips[i].weight > clips[best].weight) best = i;
  return best;
}

// What a clip of the group met and how it moves, from one phase to another.
Status follow(const GraphStep& step, const GraphSpace& space, std::uint32_t point, float weight, bool is_heard,
              const Phase& before, const Phase& after, NodeStep& n) {
  const Animation& animation = clip_of(step.b, space, point);
  const ClipMotion& of = animation.motion;
  is_heard = is_heard && !of.events.empty() && n.loudness >= step.s.options.least_loudness;
  if (of.root.empty() && !is_heard) return Status::ok;
  Playback was, now;
  follow_checked_phase(of, before, after, was, now);
  if (is_heard) {
    const Status status = hear(step, animation, was, now, n.entry.begins, n.loudness);
    if (status != Status::ok) return status;
  }
  if (of.root.empty()) return Status::ok;
  Screw screw;
  if (!root_screw(of, was, now, screw)) return Status::bad_data;
  add(screw, static_cast<double>(weight), n.motion);
  n.moves = true;
  return Status::ok;
}

// By the means of the links.
Status step_together(const GraphStep& step, const GraphSpace& space, float rate, NodeStep& n, SpaceState& own,
                     const LinkStep* links) {
  if (n.entry.begins && !enter(step.b, space, n.entry, own)) return Status::bad_data;
  float means[kMostInSpace];
  for (std::uint32_t i = 0; i < space.point_count; ++i) means[i] = links[i].mean;
  const Span<const PhaseClip> group = group_of(step, space, means);
  const Phase before{own.share, own.segment, 0};
  Phase after = before;
  const auto length_s = static_cast<float>(step.dt_s * static_cast<double>(rate));
  if (!is_finite(length_s)) return Status::bad_data;
  advance_checked_phase(group, length_s, after);
  const std::uint32_t heard = n.is_heard ? loudest(group) : kNoIndex;
  for (std::uint32_t i = 0; i < space.point_count; ++i) {
    if (means[i] == 0) continue;
    const Status status = follow(step, space, i, means[i], i == heard, before, after, n);
    if (status != Status::ok) return status;
  }
  own.share = after.share;
  own.segment = after.segment;
  return Status::ok;
}

}  // namespace

Status weigh_points(const GraphBinding& b, const GraphSpace& space, const float (&at)[2], float* weights, float& rate) {
  rate = 1;
  const std::uint32_t first = space.first_point, count = space.point_count;
  const Span<float> out(weights, count);
  const Span<const SpeedPoint> places(b.points.data + first, count);
  if ((space.flags & kSpaceMatchesSpeed) != 0) return match_speed(places, at[0], out, rate);
  if (space.triangle_count > 0) {
    PlanePoint points[kMostInSpace];
    for (std::uint32_t i = 0; i < count; ++i) points[i] = {b.graph.points[first + i].x, b.graph.points[first + i].y};
    return plane_weights({points, count}, {b.graph.triangles.data + space.first_triangle, space.triangle_count},
                         {at[0], at[1]}, out);
  }
  float points[kMostInSpace];
  for (std::uint32_t i = 0; i < count; ++i) points[i] = places[i].speed_m_s;
  return line_weights({points, count}, at[0], out);
}

Status step_space(const GraphStep& step, std::uint32_t node) {
  const GraphSpace& space = step.g.spaces[step.g.nodes[node].record];
  NodeStep& n = step.step(node);
  LinkStep* const links = step.links(node);
  float means[2] = {}, ends[2] = {}, rate = 1;
  for (int i = 0; i < 2; ++i) {
    if (space.by[i] == kNoIndex) continue;
    means[i] = step.s.means[space.by[i]];
    ends[i] = step.parameter(space.by[i]).value;
  }
  float weights[kMostInSpace];
  Status status = weigh_points(step.b, space, ends, weights, rate);
  for (std::uint32_t i = 0; i < space.point_count && status == Status::ok; ++i) links[i].end = weights[i];
  const bool stays = means[0] == ends[0] && means[1] == ends[1];
  if (status == Status::ok && !stays) status = weigh_points(step.b, space, means, weights, rate);
  if (status != Status::ok) return Status::bad_data;
  for (std::uint32_t i = 0; i < space.point_count; ++i) links[i].mean = weights[i];
  if ((space.flags & kSpaceInStep) != 0) return step_together(step, space, rate, n, step.own<SpaceState>(node), links);
  for (std::uint32_t i = 0; i < space.point_count; ++i) {
    if (!(links[i].mean > 0 || links[i].end > 0)) continue;
    step.reach(step.g.points[space.first_point + i].node, {.entry = n.entry,
                                                           .loudness = n.loudness * links[i].mean,
                                                           .is_heard = n.is_heard,
                                                           .is_kept = n.is_kept && links[i].end > 0});
  }
  return Status::ok;
}

Status move_back(const GraphStep& step, const GraphSpace& space, const float* weights, float shift_s, Phase& phase) {
  if (shift_s == 0) return Status::ok;
  return advance_phase(group_of(step, space, weights), -shift_s, phase) == Status::ok ? Status::ok : Status::bad_data;
}

bool find_place(const GraphStep& step, std::uint32_t node, const Entry* entered, Phase& out) {
  for (std::uint32_t depth = 0; depth < kMaxGraphHeight && node != kNoIndex; ++depth) {
    const GraphNode& of = step.g.nodes[node];
    switch (of.kind) {
      case GraphNodeKind::clip: {
        const Playback at = playback_of(step, node, entered);
        return phase_at(step.b.clips[of.record].motion, clip_time(at), out) == Status::ok;
      }
      case GraphNodeKind::space: {
        const GraphSpace& space = step.g.spaces[of.record];
        SpaceState own = step.own<SpaceState>(node);
        if ((space.flags & kSpaceInStep) == 0) return false;
        if (entered != nullptr && !enter(step.b, space, *entered, own)) return false;
        out = {own.share, own.segment, 0};
        return true;
      }
      case GraphNodeKind::machine: {
        const GraphMachine& m = step.g.machines[of.record];
        const std::uint32_t state = entered != nullptr ? m.start : step.own<MachineState>(node).chain[0];
        node = step.g.states[m.first_state + state].node;
        break;
      }
      case GraphNodeKind::layer:
        node = step.g.layers[of.record].base;
        break;
      case GraphNodeKind::given:
        return false;
    }
  }
  return false;
}

}  // namespace marrow
