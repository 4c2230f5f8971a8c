// Clips of a graph: their time, what they meet, and how they move the root.
#include "graph/graph_step.h"
#include "marrow/events.h"
#include "motion/root_screw.h"

namespace marrow {

Playback beginning(const GraphClip& clip, const ClipMotion& motion, const Entry& entry) {
  Playback out{.speed = clip.speed, .mode = static_cast<PlayMode>(clip.mode)};
  const auto end_s = static_cast<double>(motion.duration_s);
  if (entry.in_phase) {
    Playback now;
    if (follow_phase(motion, entry.place(), entry.place(), now, now) == Status::ok) out.time_s = now.time_s;
  } else {
    const auto enter_s = static_cast<double>(entry.time_s);
    out.time_s = enter_s < end_s ? enter_s : end_s;
    if (clip.speed < 0) out.time_s = end_s - out.time_s;
  }
  return out;
}

namespace {

Playback playback_of(const GraphClip& clip, const ClipState& own) {
  return {.time_s = own.time_s,
          .speed = clip.speed,
          .mode = static_cast<PlayMode>(clip.mode),
          .returning = own.returning != 0};
}

// Plays on from one time of the step to another; events until heard_s count.
Status play(const GraphStep& step, const Animation& animation, double from_s, double until_s, bool first,
            NodeStep& node, Playback& playback) {
  const float duration_s = animation.motion.duration_s;
  const Playback was = playback;
  Status status = advance(playback, duration_s, static_cast<float>(until_s - from_s));
  if (status != Status::ok) return Status::bad_data;
  if (node.heard_s >= from_s && !animation.motion.events.empty()) {
    Playback heard = was;
    if (node.heard_s < until_s) {
      status = advance(heard, duration_s, static_cast<float>(node.heard_s - from_s));
    } else {
      heard = playback;
    }
    if (status == Status::ok) status = hear(step, animation, was, heard, first, node.loudness);
    if (status != Status::ok) return status;
  }
  if (animation.motion.root.empty()) return Status::ok;
  Screw screw;
  if (!root_screw(animation.motion, was, playback, screw)) return Status::bad_data;
  add(screw, 1, node.motion);
  node.moves = true;
  return Status::ok;
}

}  // namespace

Playback playback_at(const GraphStep& step, std::uint32_t node, double t, const Entry* entered) {
  const std::uint32_t record = step.g.nodes[node].record;
  const GraphClip& clip = step.g.clips[record];
  const ClipMotion& motion = step.b.clips[record].motion;
  Playback out = entered != nullptr ? beginning(clip, motion, *entered) : playback_of(clip, step.own<ClipState>(node));
  const double from_s = entered != nullptr ? entered->at_s : 0;
  if (t > from_s) static_cast<void>(advance(out, motion.duration_s, static_cast<float>(t - from_s)));
  return out;
}

Status step_clip(const GraphStep& step, std::uint32_t node) {
  const std::uint32_t record = step.g.nodes[node].record;
  const Animation& animation = step.b.clips[record];
  ClipState& own = step.own<ClipState>(node);
  NodeStep& n = step.step(node);
  Playback playback = playback_of(step.g.clips[record], own);
  double from_s = n.from_s;
  if (n.entry.begins) {
    if (own.is_shown != 0 && from_s < n.entry.at_s) {
      const Status status = play(step, animation, from_s, n.entry.at_s, false, n, playback);
      if (status != Status::ok) return status;
    }
    playback = beginning(step.g.clips[record], animation.motion, n.entry);
    from_s = n.entry.at_s;
  }
  const Status status = play(step, animation, from_s, n.until_s, n.entry.begins, n, playback);
  own.time_s = playback.time_s;
  own.returning = playback.returning ? 1 : 0;
  return status;
}

Status hear(const GraphStep& step, const Animation& animation, const Playback& was, const Playback& now, bool first,
            float loudness) {
  if (loudness < step.s.options.least_loudness) return Status::ok;
  constexpr std::size_t kMostAtOnce = 64;
  EventHit hits[kMostAtOnce];
  std::size_t met = 0;
  if (events_between(animation.motion, was, now, first, hits, met) != Status::ok) return Status::bad_data;
  const std::size_t kept = met < kMostAtOnce ? met : kMostAtOnce;
  step.s.left_out += static_cast<std::uint32_t>(met - kept);
  for (std::size_t i = 0; i < kept; ++i) {
    if (step.s.event_count == step.s.events.size) {
      ++step.s.left_out;
      continue;
    }
    const ClipEvent& event = animation.motion.events[hits[i].event];
    const char* const name = animation.clips.text(event.name);
    step.s.events[step.s.event_count++] = {event_id(name), name,          event.number, event.time_s,
                                           event.until_s,  hits[i].count, &animation};
  }
  return Status::ok;
}

}  // namespace marrow
