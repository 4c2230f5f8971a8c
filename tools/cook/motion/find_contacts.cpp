#include "cook/motion/find_contacts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace marrow::cook {
namespace {

// Lengths of legs. A foot that does not stand begins to below the first of each pair, and one that stands goes on to
// the second.
constexpr double kLow[2] = {0.056, 0.076};
// How fast a foot that stands goes over the ground, of the speed at which the character goes, and at least in legs a
// second. Where the character goes slower than kWalks a foot is dragged as fast as kSlow, unless it is lifted: so much
// higher than where it was slow.
constexpr double kWalks = 0.3, kSlowShare[2] = {0.42, 1.0}, kLeastSlow[2] = {0.25, 0.5}, kSlow[2] = {2, 3};
constexpr double kLifted = 0.0045;
constexpr double kDragged = 0.2;  // how much of a slip counts that is backwards
// A foot's ground is where it is for so much of the time no higher: soles sink into the ground here and there.
constexpr double kLowShare = 0.12;
// Feet whose lowest places are so far apart stand on one ground; else only the lower one does.
constexpr double kOneGround = 0.15;
constexpr double kFarFromGround = 0.35;  // a clip whose feet stay so far from the ground that they rest on has none
constexpr double kShortest_s = 0.05, kShortestGap_s = 0.1;  // of a contact, and of a gap between two
// Of the ground's velocity: how low a foot is looked at, and how alike velocities are.
constexpr double kLookedAt = 0.115, kAlike = 0.18, kAlikeShare = 0.1;
constexpr std::size_t kMostSamples = 1500, kMostGrounds = 6;
constexpr int kRounds = 3, kShifts = 8;
// Of the way's speed, and legs: a ground that goes slower, or no farther in a step, does not go.
constexpr double kStill = 0.1, kLeastStep = 0.15;
constexpr double kOnTheSpot = 0.05;  // of the ground's speed: the way of a clip that walks on the spot
// Of legs, and a cosine of half an angle: how far the end of a loop is from its start.
constexpr double kLoopGap = 0.15, kLoopTurn = 0.97;

// Heights of feet above the ground, by frame; empty where the clip has none.
std::vector<std::vector<double>> heights_above_ground(const ClipTrace& trace, double leg) {
  std::vector<double> lows;
  double lowest = HUGE_VAL, rest = HUGE_VAL;
  for (const FootTrace& foot : trace.feet) {
    std::vector<double> heights;
    for (const LowPoint& point : foot.points) heights.push_back(point.place.y);
    std::ranges::sort(heights);
    const double low = heights[static_cast<std::size_t>(static_cast<double>(heights.size() - 1) * kLowShare)];
    lows.push_back(low);
    lowest = std::min(lowest, low);
    rest = std::min(rest, foot.rest_m);
  }
  if (!(std::abs(lowest - rest) < kFarFromGround * leg)) return {};
  std::vector<std::vector<double>> out;
  for (std::size_t f = 0; f < lows.size(); ++f) {
    const double ground = lows[f] - lowest < kOneGround * leg ? lows[f] : lowest;
    std::vector<double>& heights = out.emplace_back();
    for (const LowPoint& point : trace.feet[f].points) heights.push_back(point.place.y - ground);
  }
  return out;
}

// How much a velocity counts beside another; 0 if they are farther apart than `width`.
double likeness(const glm::dvec3& a, const glm::dvec3& b, double width) {
  const double apart = glm::length(a - b) / width;
  return apart < 1 ? (1 - apart * apart) * (1 - apart * apart) : 0;
}

struct Sample {
  glm::dvec3 velocity{0};
  double weight = 0;
};

// The velocities that low feet have most of the time: modes, the likeliest first.
std::vector<glm::dvec3> likely_grounds(const ClipTrace& trace, const std::vector<std::vector<double>>& heights,
                                       double leg) {
  std::vector<Sample> samples;
  const std::size_t count = trace.size() * trace.feet.size(), stride = count / kMostSamples + 1;
  for (std::size_t i = 0; i < count; i += stride) {
    const std::size_t f = i % trace.feet.size(), frame = i / trace.feet.size();
    const double high = heights[f][frame] / (kLookedAt * leg);
    if (high < 1) samples.push_back({level(trace.feet[f].points[frame].ball_velocity), (1 - high) * (1 - high)});
  }
  const auto width_at = [&](const glm::dvec3& velocity) {
    return std::max(kAlike * leg, kAlikeShare * glm::length(velocity));
  };
  std::vector<Sample> means;  // about each sample: where most are, and how many
  for (const Sample& at : samples) {
    glm::dvec3 sum(0);
    double score = 0;
    for (const Sample& other : samples) {
      const double share = other.weight * likeness(other.velocity, at.velocity, width_at(at.velocity));
      score += share;
      sum += share * other.velocity;
    }
    means.push_back({score > 0 ? sum / score : at.velocity, score});
  }
  std::ranges::stable_sort(means, std::ranges::greater(), &Sample::weight);
  std::vector<glm::dvec3> out;
  for (const Sample& mean : means) {
    const auto is_near = [&](const glm::dvec3& other) {
      return glm::length(other - mean.velocity) < 2 * width_at(mean.velocity);
    };
    if (out.size() < kMostGrounds && std::ranges::none_of(out, is_near)) out.push_back(mean.velocity);
  }
  return out;
}

// How fast a foot goes over the ground. Feet of many clips are dragged backwards while they stand, and none is dragged
// forwards: so backwards counts little. travel: of the character over the ground.
double slip_of(const glm::dvec3& velocity, const glm::dvec3& ground, const glm::dvec3& travel) {
  const glm::dvec3 slip = velocity - ground;
  const double speed = glm::length(travel);
  if (!(speed > 0)) return glm::length(slip);
  const double ahead = glm::dot(slip, travel) / speed;
  const double across = glm::length(slip - travel * (ahead / speed));
  return glm::length(glm::dvec2(across, ahead > 0 ? ahead : kDragged * ahead));
}

// Where a foot stands, a frame. A loop's frames are gone through thrice, so that each has been come to from the one
// before it; its last frame is its first again and is left out.
std::vector<char> standing(const FootTrace& foot, const std::vector<double>& heights, const glm::dvec3& ground,
                           const glm::dvec3& travel, bool is_loop) {
  const double speed = glm::length(travel);
  const std::size_t frames = heights.size() - (is_loop ? 1 : 0);
  std::vector<char> out(frames * (is_loop ? 3 : 1), 0);
  bool stands = false;
  double slow_at_m = 0;  // the height at which it was slow
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int now = stands ? 1 : 0;
    const LowPoint& point = foot.points[i % frames];
    const double slip = std::min(slip_of(point.velocity, ground, travel), slip_of(point.ball_velocity, ground, travel));
    const double height = heights[i % frames];
    if (slip < kLeastSlow[0] * foot.leg_m && height < kLow[1] * foot.leg_m) slow_at_m = height;
    const bool is_dragged = speed < kWalks * foot.leg_m && height < slow_at_m + kLifted * foot.leg_m;
    const double slow =
        is_dragged ? kSlow[now] * foot.leg_m : std::max(kLeastSlow[now] * foot.leg_m, kSlowShare[now] * speed);
    stands = height < kLow[now] * foot.leg_m && slip < slow;
    out[i] = stands ? 1 : 0;
  }
  return out;
}

// Runs of one value that are shorter than `least` frames become the other, but for those at the ends.
void drop_short(std::vector<char>& stands, char value, std::size_t least) {
  for (std::size_t i = 0; i < stands.size();) {
    std::size_t end = i;
    while (end < stands.size() && stands[end] == stands[i]) ++end;
    if (stands[i] == value && end - i < least && i > 0 && end < stands.size())
      std::fill(stands.begin() + static_cast<std::ptrdiff_t>(i), stands.begin() + static_cast<std::ptrdiff_t>(end),
                static_cast<char>(1 - value));
    i = end;
  }
}

// Those of one foot, from where it stands. Of a loop those that begin in the second of the three rounds.
void add_spans(std::size_t foot, const std::vector<char>& stands, bool is_loop, std::vector<Contact>& out) {
  const std::size_t round = is_loop ? stands.size() / 3 : 0, end_of_starts = is_loop ? 2 * round : stands.size();
  if (is_loop && std::ranges::count(stands, 0) == 0) return out.push_back({foot, 0, round});
  for (std::size_t i = 0; i < stands.size();) {
    std::size_t end = i;
    while (end < stands.size() && stands[end] == stands[i]) ++end;
    if (stands[i] != 0 && i >= round && i < end_of_starts) out.push_back({foot, i - round, end - 1 - round});
    i = end;
  }
}

std::vector<Contact> spans_of(const ClipTrace& trace, const std::vector<std::vector<double>>& heights,
                              const glm::dvec3& ground, const glm::dvec3& travel, bool is_loop) {
  const auto frames = [&](double time_s) { return static_cast<std::size_t>(std::ceil(time_s / trace.frame_s)); };
  std::vector<Contact> out;
  for (std::size_t f = 0; f < trace.feet.size(); ++f) {
    std::vector<char> stands = standing(trace.feet[f], heights[f], ground, travel, is_loop);
    drop_short(stands, 0, frames(kShortestGap_s));
    drop_short(stands, 1, frames(kShortest_s));
    add_spans(f, stands, is_loop, out);
  }
  return out;
}

// A foot in a frame of one of its contacts. In a loop, whose last frame is its first, that may be of the next round.
const LowPoint& point_at(const ClipTrace& trace, const Contacts& contacts, std::size_t foot, std::size_t frame) {
  return trace.feet[foot].points[frame % (trace.size() - (contacts.is_loop ? 1 : 0))];
}

// The velocity that most feet have inside of contacts, two frames from where these begin and end: mean shift from what
// was thought. A foot that rolls over its toes is faster than one that stands, so their mean is not meant.
glm::dvec3 ground_of(const ClipTrace& trace, const Contacts& contacts, glm::dvec3 thought, double speed) {
  constexpr std::size_t kOff = 2;
  for (int step = 0; step < kShifts; ++step) {
    glm::dvec3 sum(0);
    double whole = 0;
    for (const Contact& span : contacts.spans)
      for (std::size_t i = span.from + kOff; i + kOff <= span.to; ++i) {
        const FootTrace& foot = trace.feet[span.foot];
        const glm::dvec3 velocity = level(point_at(trace, contacts, span.foot, i).ball_velocity);
        const double weight = likeness(velocity, thought, std::max(kAlike * foot.leg_m, kAlikeShare * speed));
        sum += weight * velocity;
        whole += weight;
      }
    if (!(whole > 0)) break;
    thought = sum / whole;
  }
  return thought;
}

// Whether the ground can be said to go: in a loop, or on the spot; and both feet, or all that stand, go far with it.
bool goes(const ClipTrace& trace, const Contacts& contacts, double way) {
  const double speed = glm::length(contacts.ground_m_s);
  if (speed < kStill * way || (!contacts.is_loop && way > kOnTheSpot * speed)) return false;
  for (std::size_t f = 0; f < trace.feet.size(); ++f) {
    double longest_s = 0;
    for (const Contact& span : contacts.spans)
      if (span.foot == f) longest_s = std::max(longest_s, static_cast<double>(span.to - span.from) * trace.frame_s);
    const bool is_hind = trace.feet[f].role == Role::left_foot || trace.feet[f].role == Role::right_foot;
    if (is_hind && speed * longest_s < kLeastStep * trace.feet[f].leg_m) return false;
  }
  return true;
}

// Whether feet stand below the hips in the end as at the start.
bool is_loop(const ClipTrace& trace, double leg) {
  const std::size_t last = trace.size() - 1;
  const glm::dquat turn = trace.hips_turn[last] * glm::conjugate(trace.hips_turn[0]);
  // The turn about the upright is the way's; the rest is the pose's.
  if (glm::length(glm::dvec2(turn.w, turn.y)) < kLoopTurn) return false;
  const glm::dquat heading = heading_of(turn);
  for (const FootTrace& foot : trace.feet) {
    const glm::dvec3 first = foot.points[0].ball - trace.hips[0], end = foot.points[last].ball - trace.hips[last];
    if (glm::length(end - heading * first) > kLoopGap * leg) return false;
  }
  return true;
}

// The contacts with a ground that goes about as fast as is thought.
Contacts contacts_with(const ClipTrace& trace, const std::vector<std::vector<double>>& heights, glm::dvec3 ground,
                       bool is_loop) {
  const glm::dvec3 way = level(trace.hips.back() - trace.hips.front()) / trace.duration_s();
  Contacts out{is_loop, ground, {}};
  for (int round = 0; round < kRounds; ++round) {
    const glm::dvec3 travel = way - out.ground_m_s;
    out.spans = spans_of(trace, heights, out.ground_m_s, travel, is_loop);
    out.ground_m_s = ground_of(trace, out, out.ground_m_s, glm::length(travel));
  }
  if (goes(trace, out, glm::length(way))) return out;
  out.ground_m_s = glm::dvec3(0);
  out.spans = spans_of(trace, heights, out.ground_m_s, way, is_loop);
  return out;
}

// For how many frames feet stand and go about as fast as the ground.
double fit_of(const ClipTrace& trace, const Contacts& contacts) {
  double out = 0;
  for (const Contact& span : contacts.spans) {
    const FootTrace& foot = trace.feet[span.foot];
    const double width = 2 * std::max(kAlike * foot.leg_m, kAlikeShare * glm::length(contacts.ground_m_s));
    for (std::size_t i = span.from; i <= span.to; ++i)
      out += likeness(point_at(trace, contacts, span.foot, i).ball_velocity, contacts.ground_m_s, width);
  }
  return out;
}

}  // namespace

Contacts find_contacts(const ClipTrace& trace) {
  if (trace.feet.empty() || trace.frame_s <= 0) return {};
  const double leg = leg_of(trace);
  Contacts best;
  best.is_loop = is_loop(trace, leg);
  const std::vector<std::vector<double>> heights = heights_above_ground(trace, leg);
  if (heights.empty()) return best;
  double most = 0;
  for (const glm::dvec3& ground : likely_grounds(trace, heights, leg)) {
    Contacts found = contacts_with(trace, heights, ground, best.is_loop);
    const double fit = fit_of(trace, found);
    if (fit <= most) continue;
    most = fit;
    best = std::move(found);
  }
  std::ranges::sort(best.spans, {}, &Contact::from);
  return best;
}

}  // namespace marrow::cook
