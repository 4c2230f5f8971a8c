// Clips of a graph: their time, what they meet, and how they move the root.
#include "graph/graph_step.h"
#include "marrow/events.h"
#include "motion/root_screw.h"

namespace marrow {

namespace {

// As a clip begins.
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

}  // namespace

Playback playback_of(const GraphStep& step, std::uint32_t node, const Entry* entered) {
  const std::uint32_t record = step.g.nodes[node].record;
  const GraphClip& clip = step.g.clips[record];
  if (entered != nullptr) return beginning(clip, step.b.clips[record].motion, *entered);
  const ClipState& own = step.own<ClipState>(node);
  return {.time_s = own.time_s,
          .speed = clip.speed,
          .mode = static_cast<PlayMode>(clip.mode),
          .returning = own.returning != 0};
}

Status step_clip(const GraphStep& step, std::uint32_t node) {
  const Animation& animation = step.b.clips[step.g.nodes[node].record];
  NodeStep& n = step.step(node);
  const Playback was = playback_of(step, node, n.entry.begins ? &n.entry : nullptr);
  Playback now = was;
  Status status = advance(now, animation.motion.duration_s, static_cast<float>(step.dt_s));
  if (status != Status::ok) return Status::bad_data;
  ClipState& own = step.own<ClipState>(node);
  own.time_s = now.time_s;
  own.returning = now.returning ? 1 : 0;
  if (n.is_heard && !animation.motion.events.empty())
    status = hear(step, animation, was, now, n.entry.begins, n.loudness);
  if (status != Status::ok || animation.motion.root.empty()) return status;
  Screw screw;
  if (!root_screw(animation.motion, was, now, screw)) return Status::bad_data;
  add(screw, 1, n.motion);
  n.moves = true;
  return Status::ok;
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
