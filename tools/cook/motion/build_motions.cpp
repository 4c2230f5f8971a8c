#include "cook/motion/build_motions.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include "common/elementary.h"
#include "common/failure.h"
#include "common/parallel.h"
#include "cook/clip/measure/rig.h"
#include "cook/motion/find_contacts.h"
#include "cook/motion/trace_clip.h"
#include "cook/scene/without_tiny.h"
#include "cook/skeleton/build_skeletons.h"
#include "text/nearest.h"
#include "text/pattern.h"

namespace marrow::cook {
namespace {

// Legs a second: what is slower stays where it is.
constexpr double kStays = 0.02;
// How far keys may be off: of a leg, and the sine of half of five degrees.
constexpr double kNear = 0.03, kSineOfHalfTurn = 0.043619387365336;
// Of a loop, in radians: what turns less, in a round, does not turn; and how far keys are apart.
constexpr double kNoTurn = 0.0175, kTurnOfAKey = 0.26;
constexpr double kTurnOfAStep = 0.05;  // of M from key to key of the pose that it is taken out of
// Of the way that the ground goes: what moves less walks on the spot.
constexpr double kLittle = 0.1;
constexpr double kEvenScale = 1e-3;  // of scales along two axes

struct Rigid {
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 translation{0};
};

// M at each frame, from the hips.
std::vector<Rigid> motion_of_hips(const ClipTrace& trace, RootMotion how) {
  std::vector<Rigid> out;
  const glm::dvec3 first = level(trace.hips[0]);
  for (std::size_t i = 0; i < trace.size(); ++i) {
    const glm::dquat turn = heading_of(trace.hips_turn[i] * glm::conjugate(trace.hips_turn[0]));
    const double up = how == RootMotion::full ? trace.hips[i].y - trace.hips[0].y : 0;
    out.push_back({turn, level(trace.hips[i]) + glm::dvec3(0, up, 0) - turn * first});
  }
  return out;
}

RootKey key_of(const Rigid& m, double time_s) {
  RootKey out{static_cast<float>(time_s), {}, {}};
  const double q[4] = {m.rotation.x, m.rotation.y, m.rotation.z, m.rotation.w};
  for (int c = 0; c < 4; ++c) out.rotation[c] = without_tiny(q[c]);
  for (int c = 0; c < 3; ++c) out.translation[c] = without_tiny(m.translation[c]);
  return out;
}

// As RootKey says.
Rigid between(const Rigid& a, const Rigid& b, double share) {
  const glm::dquat other = glm::dot(a.rotation, b.rotation) < 0 ? -b.rotation : b.rotation;
  return {glm::normalize(a.rotation * (1 - share) + other * share),
          a.translation + share * (b.translation - a.translation)};
}

// Whether the frames between two are near the line between them; and less than half a turn apart.
bool are_on_line(const std::vector<Rigid>& m, std::size_t from, std::size_t to, double near) {
  if (to - from > 1 && std::abs(glm::dot(m[from].rotation, m[to].rotation)) < 0.5) return false;
  for (std::size_t i = from + 1; i < to; ++i) {
    const Rigid on = between(m[from], m[to], static_cast<double>(i - from) / static_cast<double>(to - from));
    const glm::dquat off = on.rotation * glm::conjugate(m[i].rotation);
    if (glm::length(on.translation - m[i].translation) > near) return false;
    if (glm::length(glm::dvec3(off.x, off.y, off.z)) > kSineOfHalfTurn) return false;
  }
  return true;
}

// The farthest frame that one line goes to, of every `step`th: tried at doubled distances, then between the last two.
std::size_t line_from(const std::vector<Rigid>& m, std::size_t from, std::size_t step, double near) {
  const std::size_t last = m.size() - 1, most = (last - from + step - 1) / step;
  const auto frame = [&](std::size_t steps) { return std::min(from + steps * step, last); };
  std::size_t good = 1, bad = 2;
  while (bad <= most && are_on_line(m, from, frame(bad), near)) {
    good = bad;
    bad = std::min(2 * bad, most);
    if (good == most) return last;
  }
  while (bad - good > 1 && bad <= most) {
    const std::size_t middle = (good + bad) / 2;
    (are_on_line(m, from, frame(middle), near) ? good : bad) = middle;
  }
  return frame(good);
}

// The turn about the upright, in radians, up to half a round.
double turn_of(const glm::dquat& heading) {
  return 2 * tools::angle_of(heading.w < 0 ? -heading.y : heading.y, std::abs(heading.w));
}

// The even way of a loop to where it ends: along a line, or round an arc. With θ its turn and v its velocity in its own
// axes, it has come to ∫ R(uθ) v du.
std::vector<RootKey> even_keys(const Rigid& end, double duration_s) {
  const double whole = turn_of(end.rotation), turn = std::abs(whole) > kNoTurn ? whole : 0;
  const auto way = [](double angle) {
    return angle == 0 ? glm::dvec2(1, 0) : glm::dvec2(tools::sine(angle) / angle, (1 - tools::cosine(angle)) / angle);
  };
  const glm::dvec2 all = way(turn);
  const glm::dvec3& to = end.translation;
  const glm::dvec3 velocity =
      glm::dvec3(all.x * to.x - all.y * to.z, 0, all.y * to.x + all.x * to.z) / glm::dot(all, all);
  const auto steps = static_cast<std::size_t>(1 + std::abs(turn) / kTurnOfAKey);
  std::vector<RootKey> out;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps), angle = turn * share;
    const glm::dvec2 arc = way(angle) * share;
    const glm::dquat heading(tools::cosine(angle / 2), 0, tools::sine(angle / 2), 0);
    out.push_back(key_of(
        {heading, {arc.x * velocity.x + arc.y * velocity.z, to.y * share, arc.x * velocity.z - arc.y * velocity.x}},
        i < steps ? duration_s * share : duration_s));
  }
  return out;
}

Rigid rigid_of(const RootKey& k) {
  return {glm::normalize(glm::dquat(static_cast<double>(k.rotation[3]), static_cast<double>(k.rotation[0]),
                                    static_cast<double>(k.rotation[1]), static_cast<double>(k.rotation[2]))),
          glm::dvec3(k.translation[0], k.translation[1], k.translation[2])};
}

Rigid motion_at(const std::vector<RootKey>& keys, double time_s) {
  const auto after =
      std::ranges::upper_bound(keys, time_s, {}, [](const RootKey& k) { return static_cast<double>(k.time_s); });
  if (after == keys.begin()) return rigid_of(keys.front());
  if (after == keys.end()) return rigid_of(keys.back());
  const double from = static_cast<double>(after[-1].time_s), to = static_cast<double>(after->time_s);
  return between(rigid_of(after[-1]), rigid_of(*after), (time_s - from) / (to - from));
}

// The parts of a map that turns, moves and scales evenly, or mirrors; false of any other.
bool split_even(const World& above, double& scale, glm::dmat3& turn) {
  scale = glm::length(above.linear[0]);
  if (!(scale > 0)) return false;
  turn = above.linear / scale;
  const glm::dmat3 product = glm::transpose(turn) * turn;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(product[c][r] - (c == r ? 1 : 0)) < kEvenScale)) return false;
  return true;
}

bool jumps_at(const BuiltClip& clip, std::size_t joint) {
  return std::ranges::any_of(
      clip.tracks, [&](const Track& t) { return t.joint == joint && t.path != TrackPath::scale && jumps(clip, t); });
}

// Those of the root's keys and of M's, and more where M turns fast: between keys the root is where lines have it. Even
// ones would be more frames of the whole clip.
std::vector<float> times_of(const std::vector<RootKey>& root, const BuiltClip& clip, std::size_t joint) {
  std::vector<float> out;
  for (std::size_t k = 0; k < root.size(); ++k) {
    out.push_back(root[k].time_s);
    if (k == 0) continue;
    const glm::dquat turn = rigid_of(root[k]).rotation * glm::conjugate(rigid_of(root[k - 1]).rotation);
    const auto steps = static_cast<std::size_t>(1 + std::abs(turn_of(turn)) / kTurnOfAStep);
    for (std::size_t i = 1; i < steps; ++i)
      out.push_back(root[k - 1].time_s +
                    (root[k].time_s - root[k - 1].time_s) * static_cast<float>(i) / static_cast<float>(steps));
  }
  for (const Track& t : clip.tracks)
    if (t.joint == joint && t.path != TrackPath::scale)
      out.insert(out.end(), clip.times_s.begin() + t.first_time, clip.times_s.begin() + t.first_time + t.key_count);
  std::ranges::sort(out);
  // Keys nearer than that would be one but for rounding.
  std::vector<float> apart;
  for (const float time : out)
    if (apart.empty() || static_cast<double>(time) - static_cast<double>(apart.back()) > 1e-4) apart.push_back(time);
  return apart;
}

struct RootChannels {
  RawChannel places, turns;
};

// M⁻¹ · above · local = above · local', so local' = above⁻¹ · M⁻¹ · above · local.
RootChannels without(const std::vector<RootKey>& root, const World& above, double scale, const glm::dmat3& turn,
                     const SourceCurves& curves, std::size_t joint, std::vector<float> times) {
  RootChannels out;
  for (const float time : times) {
    const Transform local = curves.at(joint, static_cast<double>(time));
    const Rigid m = motion_at(root, static_cast<double>(time));
    const glm::dquat back = glm::conjugate(m.rotation);
    const glm::dvec3 place = back * (above.linear * local.translation + above.origin - m.translation);
    const glm::dvec3 moved = glm::transpose(turn) * (place - above.origin) / scale;
    const glm::dmat3 turned = glm::transpose(turn) * glm::mat3_cast(back) * turn;
    const glm::dquat rotation = glm::normalize(glm::quat_cast(turned) * local.rotation);
    out.places.values.emplace_back(glm::vec3(moved), 0.0f);
    out.turns.values.emplace_back(glm::dvec4(rotation.x, rotation.y, rotation.z, rotation.w));
  }
  out.places.times_s = times;
  out.turns.times_s = std::move(times);
  return out;
}

void replace(RawClip& clip, RawChannel channel, int node, RawPath path) {
  channel.node = node;
  channel.path = path;
  std::erase_if(clip.channels, [&](const RawChannel& c) { return c.node == node && c.path == path; });
  clip.channels.push_back(std::move(channel));
}

// The mean velocity over the ground, level, model space. Of a clip that turns as it goes, its length is that of the arc
// and its direction that of the arc's chord.
glm::dvec3 velocity_of(const ClipTrace& trace, const Contacts& contacts) {
  const glm::dvec3 way = level(trace.hips.back() - trace.hips.front());
  const glm::dquat turn = heading_of(trace.hips_turn.back() * glm::conjugate(trace.hips_turn.front()));
  const double half = turn_of(turn) / 2;
  const double longer = std::abs(half) > 0.05 && std::abs(half) < 2.9 ? half / tools::sine(half) : 1;
  const glm::dvec3 out = way * longer / trace.duration_s() - contacts.ground_m_s;
  return glm::length(out) > kStays * leg_of(trace) ? out : glm::dvec3(0);
}

struct RootTrack {
  std::vector<RootKey> keys;     // M(t) as ClipMotion::root has it; empty: it does not move
  std::vector<RootKey> in_pose;  // what of it the clip's poses have: all, but for clips that walk on the spot
};

// From the hips, and for clips that walk on the spot from their contacts. What it leaves out stays in the pose, so both
// together are the clip. A loop goes evenly from its start to its end, along a line or round an arc: then clips may be
// blended at changing weights without the sway of their hips turning the character. Other clips follow the hips within
// a thirtieth of a leg and five degrees; their last key is exact.
RootTrack find_root(const ClipTrace& trace, const Contacts& contacts, RootMotion how) {
  RootTrack out;
  if (how == RootMotion::none) return out;
  const double duration = trace.duration_s(), near = kNear * leg_of(trace);
  const glm::dvec3 implied = -contacts.ground_m_s;
  const bool on_the_spot =
      glm::length(level(trace.hips.back() - trace.hips.front())) < kLittle * glm::length(implied) * duration;
  const std::vector<Rigid> m = motion_of_hips(trace, how);
  const bool stays = (contacts.is_loop || are_on_line(m, 0, m.size() - 1, near)) &&
                     glm::length(m.back().translation) < near && std::abs(m.back().rotation.y) < kSineOfHalfTurn;
  if (!on_the_spot && !stays && contacts.is_loop) out.in_pose = even_keys(m.back(), duration);
  if (!on_the_spot && !stays && !contacts.is_loop) {
    out.in_pose.push_back(key_of({}, 0));
    for (std::size_t i = 0; i + 1 < m.size();) {
      i = line_from(m, i, trace.frames_a_key, near);
      out.in_pose.push_back(key_of(m[i], i + 1 < m.size() ? static_cast<double>(i) * trace.frame_s : duration));
    }
  }
  out.keys = out.in_pose;
  if (!(glm::length(implied) > 0)) return out;
  if (out.keys.empty()) out.keys = {key_of({}, 0), key_of({}, duration)};
  for (RootKey& key : out.keys)
    for (int c = 0; c < 3; ++c) key.translation[c] += static_cast<float>(implied[c] * static_cast<double>(key.time_s));
  return out;
}

// Whether take_out_root() can do its work: the scale above each root is the same along all axes, and no root jumps.
bool can_take_out_root(const BuiltClip& clip, const BuiltSkeleton& skeleton) {
  const Rig rig(skeleton);
  for (std::size_t j = 0; j < rig.size(); ++j) {
    double scale = 1;
    glm::dmat3 turn(1);
    if (rig.parents[j] != kNone) continue;
    if (skeleton.node_of_joint[j] == kNone || !split_even(rig.above[j], scale, turn) || jumps_at(clip, j)) return false;
  }
  return true;
}

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

void take_out_root(const std::vector<RootKey>& root, const BuiltClip& clip, const BuiltSkeleton& skeleton,
                   RawClip& channels) {
  const Rig rig(skeleton);
  const SourceCurves curves(clip, skeleton);
  for (std::size_t j = 0; j < rig.size(); ++j) {
    if (rig.parents[j] != kNone) continue;
    double scale = 1;
    glm::dmat3 turn(1);
    split_even(rig.above[j], scale, turn);
    RootChannels moved = without(root, rig.above[j], scale, turn, curves, j, times_of(root, clip, j));
    replace(channels, std::move(moved.places), skeleton.node_of_joint[j], RawPath::translation);
    replace(channels, std::move(moved.turns), skeleton.node_of_joint[j], RawPath::rotation);
  }
}

std::vector<BuiltMotion> build_motions(const RawScene& scene, const BuiltScene& built, const std::vector<Mesh>& meshes,
                                       const MotionOptions& options, Notes& notes) {
  const std::vector<BuiltClip>& clips = built.clips;
  expect_all_fit(options, clips);
  std::vector<std::vector<FootShape>> feet;
  for (std::size_t s = 0; s < built.skeletons.size() && !clips.empty(); ++s)
    feet.push_back(find_foot_points(built.skeletons[s], meshes_of(meshes, s)));
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
