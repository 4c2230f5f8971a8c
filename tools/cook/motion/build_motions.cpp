#include "cook/motion/build_motions.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "common/failure.h"
#include "common/parallel.h"
#include "cook/motion/find_contacts.h"
#include "cook/motion/root_track.h"
#include "cook/motion/trace_clip.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

constexpr double kShortestSegment = 0.05;  // of the clip: marks that are nearer are one

std::vector<std::string> names_of(const std::vector<BuiltClip>& clips) {
  std::vector<std::string> out;
  for (const BuiltClip& clip : clips) out.push_back(clip.name);
  return out;
}

[[noreturn]] void refuse(const RuleOrigin& origin, const std::string& rule, const std::string& advice) {
  throw tools::Failure(tools::Exit::usage, origin.file, origin.where, rule, advice);
}

void expect_fit(const std::string& pattern, const RuleOrigin& origin, const std::vector<BuiltClip>& clips) {
  const auto fits = [&](const BuiltClip& clip) { return tools::fits(pattern, clip.name); };
  if (origin.must_fit && std::ranges::none_of(clips, fits))
    refuse(origin, "no clip is called \"" + pattern + "\"", tools::suggestion(pattern, names_of(clips)));
}

double seconds(const tools::ClipMoment& moment, const BuiltClip& clip) {
  return moment.value * (moment.is_share ? static_cast<double>(clip.duration_s) : 1);
}

// Empty: the event is in the clip.
std::string fault_of(const tools::EventText& event, const BuiltClip& clip) {
  const double from = seconds(event.from, clip), until = seconds(event.until, clip);
  const auto duration = static_cast<double>(clip.duration_s);
  if (from > duration || until > from + duration)
    return "\"" + event.name + "\" is outside of \"" + clip.name + "\", which takes " + std::to_string(duration) + " s";
  if (until < from) return "\"" + event.name + "\" ends before it begins";
  return "";
}

void add(const tools::EventText& text, const BuiltClip& clip, BuiltMotion& to) {
  BuiltEvent event;
  event.name = text.name;
  event.time_s = std::min(static_cast<float>(seconds(text.from, clip)), clip.duration_s);
  event.until_s =
      std::clamp(static_cast<float>(seconds(text.until, clip)), event.time_s, event.time_s + clip.duration_s);
  event.number = static_cast<float>(text.number);
  to.events.push_back(std::move(event));
}

// What the source says of a clip.
void add_own_events(const RawClip& raw, const BuiltClip& clip, BuiltMotion& to, Notes& notes) {
  for (const tools::EventText& event : raw.events) {
    const std::string fault = fault_of(event, clip);
    if (fault.empty()) add(event, clip, to);
    if (!fault.empty()) notes.warnings.push_back({"/animations", "event-left-out", fault});
  }
}

void add_given_events(const std::vector<EventRule>& rules, const BuiltClip& clip, BuiltMotion& to) {
  for (const EventRule& rule : rules) {
    if (!tools::fits(rule.clips, clip.name)) continue;
    if (const std::string fault = fault_of(rule.event, clip); !fault.empty())
      refuse(rule.origin, fault, "give a time in the clip, or a share as in 50%");
    add(rule.event, clip, to);
  }
}

void add_contacts(const ClipTrace& trace, const Contacts& contacts, const BuiltClip& clip, BuiltMotion& to) {
  for (const Contact& contact : contacts.spans) {
    BuiltEvent event;
    event.name = role_name(trace.feet[contact.foot].role);
    const auto time = [&](std::size_t frame) { return static_cast<float>(static_cast<double>(frame) * trace.frame_s); };
    event.time_s = std::min(time(contact.from), clip.duration_s);
    event.until_s = std::clamp(time(contact.to), event.time_s, event.time_s + clip.duration_s);
    to.events.push_back(std::move(event));
  }
}

// Where the steps of a loop begin, the left foot's first: one a foot in turn, or one a cycle where feet do not take
// turns.
std::vector<float> steps_of(const ClipTrace& trace, const Contacts& contacts) {
  if (!contacts.is_loop) return {};
  std::vector<std::pair<double, Role>> downs;
  for (const Contact& contact : contacts.spans) {
    const Role role = trace.feet[contact.foot].role;
    const bool all_along = contact.to - contact.from + 2 >= trace.size();
    if ((role == Role::left_foot || role == Role::right_foot) && !all_along)
      downs.emplace_back(static_cast<double>(contact.from) * trace.frame_s, role);
  }
  bool take_turns = downs.size() > 1 && downs.size() % 2 == 0;
  for (std::size_t i = 0; i < downs.size() && take_turns; ++i) {
    const auto& next = downs[(i + 1) % downs.size()];
    const double apart = next.first - downs[i].first + (i + 1 < downs.size() ? 0 : trace.duration_s());
    take_turns = next.second != downs[i].second && apart > kShortestSegment * trace.duration_s();
  }
  const auto left = std::ranges::find(downs, Role::left_foot, &std::pair<double, Role>::second);
  if (left == downs.end()) return {};
  std::vector<float> out;
  for (std::size_t i = 0; i < downs.size(); ++i) {
    const auto& [time, role] = downs[(static_cast<std::size_t>(left - downs.begin()) + i) % downs.size()];
    if (take_turns || role == Role::left_foot) out.push_back(static_cast<float>(time));
  }
  return out.size() <= kMaxMarks && out.back() < static_cast<float>(trace.duration_s()) ? out : std::vector<float>();
}

// False: the clip is too long for its joints and feet.
bool measure(const BuiltClip& clip, const BuiltSkeleton& skeleton, const std::vector<FootShape>& feet, RootMotion how,
             BuiltMotion& out) {
  const ClipTrace trace = trace_clip(clip, skeleton, feet);
  if (!(trace.frame_s > 0)) return clip.duration_s < 1;
  const Contacts contacts = find_contacts(trace);
  const glm::dvec3 velocity = velocity_of(trace, contacts);
  const double speed = glm::length(velocity);
  if (!(speed < static_cast<double>(kFarthestMotion))) return true;
  out.speed_m_s = static_cast<float>(speed);
  if (out.speed_m_s > 0)
    for (int c = 0; c < 3; ++c) out.heading[c] = static_cast<float>(velocity[c] / speed);
  add_contacts(trace, contacts, clip, out);
  out.marks = steps_of(trace, contacts);
  RootTrack root = find_root(trace, contacts, how);
  out.root = std::move(root.keys);
  out.root_in_pose = std::move(root.in_pose);
  return true;
}

RootMotion root_of(const std::vector<RootRule>& rules, const BuiltClip& clip) {
  RootMotion out = RootMotion::none;
  for (const RootRule& rule : rules)
    if (tools::fits(rule.clips, clip.name)) out = rule.root;
  return out;
}

void give_marks(const std::vector<PhaseRule>& rules, const BuiltClip& clip, BuiltMotion& to) {
  for (const PhaseRule& rule : rules) {
    if (!tools::fits(rule.clips, clip.name)) continue;
    to.marks.clear();
    for (const tools::ClipMoment& moment : rule.marks) to.marks.push_back(static_cast<float>(seconds(moment, clip)));
    ClipMotion motion;
    motion.duration_s = clip.duration_s;
    motion.phase_marks = to.marks;
    if (!is_valid(motion))
      refuse(rule.origin, "phase marks that do not go once round \"" + clip.name + "\"",
             "give times below the clip's duration, each later than the one before");
  }
}

void expect_all_fit(const MotionOptions& options, const std::vector<BuiltClip>& clips) {
  for (const RootRule& rule : options.roots) expect_fit(rule.clips, rule.origin, clips);
  for (const EventRule& rule : options.events) expect_fit(rule.clips, rule.origin, clips);
  for (const PhaseRule& rule : options.phases) expect_fit(rule.clips, rule.origin, clips);
}

}  // namespace

std::vector<BuiltMotion> build_motions(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                       const MotionOptions& options, Notes& notes) {
  const std::vector<BuiltClip>& clips = built.clips;
  expect_all_fit(options, clips);
  std::vector<std::vector<FootShape>> feet;
  for (std::size_t s = 0; s < built.skeletons.size() && !clips.empty(); ++s) {
    std::vector<Mesh> own;
    for (const Mesh& mesh : meshes)
      if (mesh.skeleton == s) own.push_back(mesh);
    feet.push_back(find_foot_points(built.skeletons[s], own));
  }
  std::vector<BuiltMotion> out(clips.size());
  std::vector<char> measured(clips.size(), 1);
  tools::for_each_in_parallel(clips.size(), [&](std::size_t i) {
    if (clips[i].additive.empty())
      measured[i] = measure(clips[i], built.skeletons[clips[i].skeleton], feet[clips[i].skeleton],
                            root_of(options.roots, clips[i]), out[i])
                        ? 1
                        : 0;
  });
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const BuiltClip& clip = clips[i];
    BuiltMotion& motion = out[i];
    if (!motion.root_in_pose.empty() && !can_take_out_root(clip, built.skeletons[clip.skeleton])) {
      motion.root.clear();
      motion.root_in_pose.clear();
      notes.warnings.push_back({"/animations", "root-stays",
                                "the root of \"" + clip.name +
                                    "\" jumps, or what is above it is scaled unevenly; its motion stays in the pose"});
    }
    if (measured[i] == 0)
      notes.warnings.push_back({"/animations", "motion-not-measured",
                                "\"" + clip.name + "\" is too long for contacts and a speed to be looked for"});
    add_own_events(scene.clips[clip.source], clip, motion, notes);
    add_given_events(options.events, clip, motion);
    give_marks(options.phases, clip, motion);
    std::ranges::stable_sort(motion.events, {}, &BuiltEvent::time_s);
  }
  return out;
}

void measure_motions(const RawScene& scene, const std::vector<Mesh>& meshes, const MotionOptions& options,
                     BuiltScene& built, Notes& notes) {
  std::vector<BuiltMotion> motions = build_motions(scene, built, meshes, options, notes);
  for (std::size_t i = 0; i < motions.size(); ++i) built.clips[i].motion = std::move(motions[i]);
}

}  // namespace marrow::cook
