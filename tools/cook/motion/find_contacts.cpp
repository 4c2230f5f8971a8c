#include "cook/motion/find_contacts.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace marrow::cook {
namespace {

// Lengths of legs, and those a second. A foot that does not stand begins to at the first of each pair, and one that
// stands goes on to the second. Shares are of the speed at which the character goes.
constexpr double kLow[2] = {0.06, 0.12};
constexpr double kSlow[2] = {0.5, 0.9}, kSlowShare[2] = {0.5, 0.8};
// Feet whose lowest places are so far apart stand on one ground; else only the lower one does.
constexpr double kOneGround = 0.15;
constexpr double kFarFromGround = 0.35;  // a clip whose feet stay so far from the ground that they rest on has none
constexpr double kShortest_s = 0.05;     // of a contact, and of a gap between two
// Of the ground's velocity: how low a foot is looked at, and how alike velocities are.
constexpr double kLookedAt = 0.08, kAlike = 0.15, kAlikeShare = 0.1;
constexpr std::size_t kMostSamples = 1500;
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
    double low = HUGE_VAL;
    for (const LowPoint& point : foot.points) low = std::min(low, point.place.y);
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

// The velocity that most low feet have.
glm::dvec3 ground_by_mode(const ClipTrace& trace, const std::vector<std::vector<double>>& heights, double leg) {
  std::vector<Sample> samples;
  const std::size_t count = trace.size() * trace.feet.size(), stride = count / kMostSamples + 1;
  for (std::size_t i = 0; i < count; i += stride) {
    const std::size_t f = i % trace.feet.size(), frame = i / trace.feet.size();
    const glm::dvec3& velocity = trace.feet[f].points[frame].ball_velocity;
    const double high = heights[f][frame] / (kLookedAt * leg);
    if (high < 1) samples.push_back({level(velocity), (1 - high) * (1 - high)});
  }
  glm::dvec3 best(0);
  double most = 0;
  for (const Sample& at : samples) {
    const double width = std::max(kAlike * leg, kAlikeShare * glm::length(at.velocity));
    double score = 0;
    glm::dvec3 sum(0);
    for (const Sample& other : samples) {
      const double share = other.weight * likeness(other.velocity, at.velocity, width);
      score += share;
      sum += share * other.velocity;
    }
    if (score <= most) continue;
    most = score;
    best = sum / score;
  }
  return best;
}

// Where a foot stands, a frame. A loop's frames are gone through thrice, so that each has been come to from the one
// before it; its last frame is its first again and is left out.
std::vector<char> standing(const FootTrace& foot, const std::vector<double>& heights, const glm::dvec3& ground,
                           double speed, bool is_loop) {
  const std::size_t frames = heights.size() - (is_loop ? 1 : 0);
  std::vector<char> out(frames * (is_loop ? 3 : 1), 0);
  bool stands = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int now = stands ? 1 : 0;
    const LowPoint& point = foot.points[i % frames];
    const double slip = std::min(glm::length(point.velocity - ground), glm::length(point.ball_velocity - ground));
    const double slow = std::max(kSlow[now] * foot.leg_m, kSlowShare[now] * speed);
    stands = heights[i % frames] < kLow[now] * foot.leg_m && slip < slow;
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
                              const glm::dvec3& ground, double speed, bool is_loop) {
  const auto least = static_cast<std::size_t>(std::ceil(kShortest_s / trace.frame_s));
  std::vector<Contact> out;
  for (std::size_t f = 0; f < trace.feet.size(); ++f) {
    std::vector<char> stands = standing(trace.feet[f], heights[f], ground, speed, is_loop);
    drop_short(stands, 0, least);
    drop_short(stands, 1, least);
    add_spans(f, stands, is_loop, out);
  }
  return out;
}

// The velocity that most feet have inside of contacts, two frames from where these begin and end: mean shift from what
// was thought. A foot that rolls over its toes is faster than one that stands, so their mean is not meant.
glm::dvec3 ground_of(const ClipTrace& trace, const std::vector<Contact>& spans, glm::dvec3 thought, double speed) {
  constexpr std::size_t kOff = 2;
  for (int step = 0; step < kShifts; ++step) {
    glm::dvec3 sum(0);
    double whole = 0;
    for (const Contact& span : spans)
      for (std::size_t i = span.from + kOff; i + kOff <= span.to; ++i) {
        const FootTrace& foot = trace.feet[span.foot];
        const glm::dvec3 velocity = level(foot.points[i % trace.size()].ball_velocity);
        const double weight = likeness(velocity, thought, std::max(kAlike * foot.leg_m, kAlikeShare * speed));
        sum += weight * velocity;
        whole += weight;
      }
    if (!(whole > 0)) break;
    thought = sum / whole;
  }
  return thought;
}

// Whether the ground goes so far while a foot stands that it can be said to go: in a loop, or on the spot.
bool goes(const ClipTrace& trace, const Contacts& contacts, const glm::dvec3& ground, double way) {
  const double speed = glm::length(ground);
  if (speed < kStill * way || (!contacts.is_loop && way > kOnTheSpot * speed)) return false;
  return std::ranges::any_of(contacts.spans, [&](const Contact& span) {
    const double time_s = static_cast<double>(span.to - span.from) * trace.frame_s;
    return speed * time_s > kLeastStep * trace.feet[span.foot].leg_m;
  });
}

// Whether feet stand below the hips in the end as at the start.
bool is_loop(const ClipTrace& trace, double leg) {
  const std::size_t last = trace.size() - 1;
  const glm::dquat turn = trace.hips_turn[last] * glm::conjugate(trace.hips_turn[0]);
  // The turn about the upright is the way's; the rest is the pose's.
  if (glm::length(glm::dvec2(turn.w, turn.y)) < kLoopTurn) return false;
  const glm::dquat heading = heading_of(turn);
  for (const FootTrace& foot : trace.feet) {
    const glm::dvec3 first = foot.points[0].place - trace.hips[0], end = foot.points[last].place - trace.hips[last];
    if (glm::length(end - heading * first) > kLoopGap * leg) return false;
  }
  return true;
}

}  // namespace

Contacts find_contacts(const ClipTrace& trace) {
  Contacts out;
  if (trace.feet.empty() || trace.frame_s <= 0) return out;
  const double leg = leg_of(trace);
  out.is_loop = is_loop(trace, leg);
  const std::vector<std::vector<double>> heights = heights_above_ground(trace, leg);
  if (heights.empty()) return out;
  const glm::dvec3 way = level(trace.hips.back() - trace.hips.front()) / trace.duration_s();
  glm::dvec3 ground = ground_by_mode(trace, heights, leg);
  for (int round = 0; round < kRounds; ++round) {
    const double speed = glm::length(way - ground);
    out.spans = spans_of(trace, heights, ground, speed, out.is_loop);
    ground = ground_of(trace, out.spans, ground, speed);
    if (!goes(trace, out, ground, glm::length(way))) ground = glm::dvec3(0);
  }
  out.spans = spans_of(trace, heights, ground, glm::length(way - ground), out.is_loop);
  out.ground_m_s = out.spans.empty() ? glm::dvec3(0) : ground;
  std::ranges::sort(out.spans, {}, &Contact::from);
  return out;
}

}  // namespace marrow::cook
