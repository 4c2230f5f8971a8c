#include "cook/clip/compress/choose_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "common/heap.h"

namespace marrow::cook {
namespace {

constexpr double kFirstShare = 0.5;     // of the promise, for each track's step at the start
constexpr int kMostShrinks = 18;        // to a fiftieth of it
constexpr int kFarthestStep = 24;       // quarter octaves that one coarsening may take
constexpr int kMostPushes = 3;          // of a track, quarter octaves, a round
constexpr int kMostRounds = 8;          // of pushing, with the best effort; else one
constexpr float kMostBroken = 6.25f;    // (error / promise)² that mending may begin with
constexpr std::uint32_t kMoreBits = 2;  // a frame, that a track may take to make good what those above it miss

// The rotation in a map that is one after a scaling along its own axes; nullopt if it is not.
std::optional<glm::dquat> rotation_of(const glm::dmat3& linear) {
  const glm::dmat3 unit(glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2]));
  constexpr double kSlack = 1e-6;
  const double skew = std::max({std::fabs(glm::dot(unit[0], unit[1])), std::fabs(glm::dot(unit[1], unit[2])),
                                std::fabs(glm::dot(unit[2], unit[0]))});
  if (!(skew < kSlack) || glm::determinant(unit) < 0) return std::nullopt;
  return glm::quat_cast(unit);
}

// Between two rotations less than half a turn apart.
glm::dquat halfway(const glm::dquat& a, const glm::dquat& b) {
  return glm::normalize(a + b);
}

double largest_axis(const World& w) {
  return std::max({glm::length(w.linear[0]), glm::length(w.linear[1]), glm::length(w.linear[2])});
}

// The parameters of each rotation in the hemisphere of the one before, so that they are continuous, but for spins that
// would go far beyond half a turn and start anew on the other side: the decoder takes the shorter arc.
class Unwrapper {
 public:
  explicit Unwrapper(const glm::dquat& first) : last_(first) {}
  glm::dvec3 next(glm::dquat q) {
    constexpr double kMost = 2.41;  // tan(270° / 4)
    if (glm::dot(last_, q) < 0) q = -q;
    if (glm::length(to_rodrigues(q)) > kMost) q = -q;
    last_ = q;
    return to_rodrigues(q);
  }

 private:
  glm::dquat last_;
};

class StepSearch {
 public:
  // What is given outlives this.
  StepSearch(const Rig& rig, const Promise& promise, const std::vector<TrackId>& coded,
             const std::vector<TrackId>& exact, const std::vector<Transform>& still,
             std::vector<std::span<const Transform>> source)
      : rig_(rig),
        promise_(promise),
        ids_(coded),
        source_(std::move(source)),
        coded_(coded.size()),
        curves_(coded.size()),
        strays_(rig, promise_, source_),
        trial_local_(moment_count()),
        hard_frame_(coded.size(), 0) {
    for (std::size_t j = 0; j < rig_.size(); ++j) local_.emplace_back(moment_count(), still[j]);
    for (const TrackId& id : exact)
      for (std::size_t e = 0; e < moment_count(); ++e) {
        if (id.path == TrackPath::translation) local_[id.joint][e].translation = source_[id.joint][e].translation;
        if (id.path == TrackPath::rotation) local_[id.joint][e].rotation = source_[id.joint][e].rotation;
        if (id.path == TrackPath::scale) local_[id.joint][e].scale = source_[id.joint][e].scale;
      }
    find_targets();
    find_reach();
  }

  // False if no steps keep the promise.
  bool search(Effort effort) {
    double share = kFirstShare;
    int shrinks = 0;
    while (!start(share)) {
      if (++shrinks > kMostShrinks) return false;
      share *= 0.8;
    }
    coarsen();
    if (effort == Effort::fast) return true;
    std::vector<CodedTrack> best = coded_;
    std::uint64_t least = cost();
    for (;;) {
      compensate();
      coarsen();
      if (cost() >= least) break;
      least = cost();
      best = coded_;
    }
    bool pushed = true;
    for (int round = 0; pushed && round < (effort == Effort::best ? kMostRounds : 1); ++round) {
      pushed = false;
      for (std::size_t t = 0; t < ids_.size(); ++t) pushed = push(t) || pushed;
    }
    if (cost() >= least) coded_ = std::move(best);
    return true;
  }

  const std::vector<CodedTrack>& tracks() const { return coded_; }

 private:
  struct Trial {
    bool kept = false;  // the promise
    double energy = 0;  // change
  };

  std::size_t moment_count() const { return source_.empty() ? 0 : source_[0].size(); }

  // Rotations relative to the rest pose; the others as differences.
  void find_targets() {
    for (const TrackId& id : ids_) {
      const Transform& rest = rig_.rest[id.joint];
      std::vector<glm::dvec3> frames;
      Unwrapper unwrapper({1, 0, 0, 0});
      for (std::size_t e = 0; e < moment_count(); e += kMoments) {
        const Transform& t = source_[id.joint][e];
        if (id.path == TrackPath::translation) frames.push_back(t.translation - rest.translation);
        if (id.path == TrackPath::scale) frames.push_back(t.scale - rest.scale);
        if (id.path == TrackPath::rotation)
          frames.push_back(unwrapper.next(glm::conjugate(rest.rotation) * t.rotation));
      }
      targets_.push_back(std::move(frames));
    }
  }

  void find_reach() {
    reach_ = promise_.reach;
    scale_above_.assign(rig_.size(), 1);
    least_ = rig_.least_below(promise_.error);
    for (std::size_t j = 0; j < rig_.size(); ++j) {
      const std::size_t parent = to_index(rig_.parents[j]);
      scale_above_[j] =
          rig_.parents[j] == kNone ? largest_axis(rig_.above[j]) : largest_axis(strays_.source(parent, 0));
    }
    for (const TrackId& id : ids_) {
      const std::size_t j = id.joint;
      if (id.path == TrackPath::translation) continue;  // its reach is not asked for
      for (const std::size_t below : strays_.subtree(j))
        for (std::size_t e = 0; e < moment_count(); e += kMoments)
          reach_[j] = std::max(reach_[j], promise_.reach[below] + glm::length(strays_.source(below, e).origin -
                                                                              strays_.source(j, e).origin));
    }
  }

  // Steps in proportion to 1 / reach, so that each track alone strays by about `share` of the promise.
  bool start(double share) {
    for (std::size_t t = 0; t < ids_.size(); ++t) {
      const TrackId& id = ids_[t];
      const double budget = share * least_[id.joint];
      const double step =
          id.path == TrackPath::translation ? budget / scale_above_[id.joint] : budget / (2 * reach_[id.joint]);
      // As fine as wanted, or as the format's widths allow.
      int code = code_of_step(step);
      do {
        coded_[t] = quantise(targets_[t], code);
      } while (!coded_[t].fits && code++ < 255);
      if (!coded_[t].fits) return false;
      for (std::size_t c = 0; c < 3; ++c) curves_[t][c] = choose_curve(coded_[t].values, c);
      price(t, coded_[t]);
      for (std::size_t frame = 0; frame < strays_.frame_count(); ++frame)
        decode_frame(t, coded_[t], frame, local_[id.joint]);
    }
    return strays_.place(local_);
  }

  // Begins where the track broke the promise before: most of what fails fails there again.
  Trial attempt(std::size_t track, const CodedTrack& candidate) {
    tried_ = SIZE_MAX;
    Trial trial;
    const std::size_t frames = strays_.frame_count();
    for (std::size_t i = 0, frame = hard_frame_[track]; i < frames; ++i, frame = frame + 1 == frames ? 0 : frame + 1) {
      decode_frame(track, candidate, frame, trial_local_);
      if (strays_.attempt(ids_[track].joint, frame, &trial_local_[frame * kMoments], trial.energy)) continue;
      hard_frame_[track] = frame;
      return trial;
    }
    trial.kept = true;
    tried_ = track;
    return trial;
  }

  // Takes over what the last attempt, which must have been of this track, has computed.
  void commit(std::size_t track, CodedTrack candidate) {
    std::swap(local_[ids_[track].joint], trial_local_);
    strays_.commit(ids_[track].joint);
    for (std::size_t c = 0; c < 3; ++c) curves_[track][c] = choose_curve(candidate.values, c);
    coded_[track] = std::move(candidate);
    tried_ = SIZE_MAX;
  }

  // Local transforms of a track's joint from one frame on to the next, with that track replaced.
  void decode_frame(std::size_t track, const CodedTrack& candidate, std::size_t frame,
                    std::vector<Transform>& out) const {
    const TrackId& id = ids_[track];
    const Transform& rest = rig_.rest[id.joint];
    const std::size_t first = frame * kMoments, count = frame + 1 == candidate.values.size() ? 1 : kMoments;
    std::copy_n(local_[id.joint].begin() + static_cast<std::ptrdiff_t>(first), count,
                out.begin() + static_cast<std::ptrdiff_t>(first));
    const glm::dvec3 a = decode(candidate, frame), b = count == 1 ? a : decode(candidate, frame + 1);
    if (id.path == TrackPath::rotation) {
      const glm::dquat qa = from_rodrigues(a);
      out[first].rotation = rest.rotation * qa;
      if (count == 1) return;
      // Halves of arcs, and halves of those: no angle is needed.
      const glm::dquat qb = from_rodrigues(b), middle = halfway(qa, glm::dot(qa, qb) < 0 ? -qb : qb);
      out[first + 1].rotation = rest.rotation * halfway(qa, middle);
      out[first + 2].rotation = rest.rotation * middle;
      out[first + 3].rotation = rest.rotation * halfway(middle, glm::dot(middle, qb) < 0 ? -qb : qb);
      return;
    }
    for (std::size_t k = 0; k < count; ++k) {
      const glm::dvec3 at = a + static_cast<double>(k) / static_cast<double>(kMoments) * (b - a);
      if (id.path == TrackPath::translation) out[first + k].translation = rest.translation + at;
      if (id.path == TrackPath::scale) out[first + k].scale = rest.scale + at;
    }
  }

  // The finest of the coarser steps that saves a bit.
  bool coarser(std::size_t track, CodedTrack& candidate) {
    const CodedTrack& now = coded_[track];
    for (int code = now.step_code + 1; code <= 255 && code <= now.step_code + kFarthestStep; ++code) {
      candidate = quantise(targets_[track], code);
      if (!candidate.fits) continue;
      price(track, candidate);
      if (candidate.cost < now.cost) return true;
    }
    return false;
  }

  void coarsen() {
    struct Move {
      double worth;
      std::size_t track;
      CodedTrack candidate;
      std::size_t age;
      bool operator<(const Move& other) const { return worth < other.worth; }
    };
    tools::Heap<Move> moves;
    std::size_t age = 0;
    const auto propose = [&](std::size_t track) {
      Move move{0, track, {}, age};
      if (!coarser(track, move.candidate)) return;
      const Trial trial = attempt(track, move.candidate);
      if (!trial.kept) return;  // and never will be: errors only grow
      move.worth = static_cast<double>(coded_[track].cost - move.candidate.cost) / std::max(trial.energy, 1e-9);
      moves.push(std::move(move));
    };
    for (std::size_t t = 0; t < ids_.size(); ++t) propose(t);
    while (!moves.empty()) {
      Move best = moves.pop();
      if (best.age != age) {
        propose(best.track);
        continue;
      }
      if (tried_ != best.track && !attempt(best.track, best.candidate).kept) continue;
      commit(best.track, std::move(best.candidate));
      ++age;
      propose(best.track);
    }
  }

  // Says what the candidate costs.
  void price(std::size_t track, CodedTrack& candidate) {
    std::array<ClipCurve, 3> curves = curves_[track];
    for (std::size_t c = 0; c < 3; ++c) curves[c].moves = moves(candidate.values, c);
    candidate.cost = packed_cost_.of(candidate.values, curves);
  }

  std::uint64_t cost() const {
    std::uint64_t out = 0;
    for (const CodedTrack& track : coded_) out += track.cost;
    return out;
  }

  // What a track would have to hold for its joint to stand in the scene as in the source, below joints that do not
  // quite. Empty where a parent is scaled unevenly.
  std::vector<glm::dvec3> compensated(std::size_t track) const {
    const TrackId& id = ids_[track];
    const Transform& rest = rig_.rest[id.joint];
    const int parent = rig_.parents[id.joint];
    if (parent == kNone || id.path == TrackPath::scale) return {};
    std::vector<glm::dvec3> out;
    Unwrapper unwrapper(from_rodrigues(targets_[track][0]));
    for (std::size_t e = 0; e < moment_count(); e += kMoments) {
      const World above = strays_.decoded(to_index(parent), e);
      const World& wanted = strays_.source(id.joint, e);
      const glm::dmat3 inverse = glm::inverse(above.linear);
      if (id.path == TrackPath::translation) {
        out.push_back(inverse * (wanted.origin - above.origin) - rest.translation);
        continue;
      }
      const std::optional<glm::dquat> turned = rotation_of(inverse * wanted.linear);
      if (!turned) return {};
      out.push_back(unwrapper.next(glm::conjugate(rest.rotation) * *turned));
    }
    return out;
  }

  // From the root down, with steps as they are.
  void compensate() {
    for (std::size_t t = 0; t < ids_.size(); ++t) {
      std::vector<glm::dvec3> targets = compensated(t);
      if (targets.empty()) continue;
      CodedTrack candidate = quantise(targets, coded_[t].step_code);
      if (!candidate.fits) continue;
      price(t, candidate);
      if (candidate.cost > coded_[t].cost + kMoreBits * candidate.values.size() * PackedCost::kBit) continue;
      const Trial trial = attempt(t, candidate);
      if (!trial.kept || trial.energy >= 0) continue;
      commit(t, std::move(candidate));
      targets_[t] = std::move(targets);
    }
  }

  // The largest (error / promise)² at a frame and between it and the one before.
  float error_at(std::size_t track, const CodedTrack& candidate, std::size_t frame, float most) {
    const std::size_t joint = ids_[track].joint;
    decode_frame(track, candidate, frame, trial_local_);
    float out = strays_.worst(joint, frame, &trial_local_[frame * kMoments], true, most);
    if (frame == 0 || !(out <= most)) return out;
    decode_frame(track, candidate, frame - 1, trial_local_);
    out = std::max(out, strays_.worst(joint, frame - 1, &trial_local_[(frame - 1) * kMoments], false, most));
    return out;
  }

  // Frame by frame: where the promise is broken, the best of the 27 triples around. False: there is none, or it is
  // broken too often.
  bool mend(std::size_t track, CodedTrack& candidate) {
    const std::size_t frames = candidate.values.size();
    std::size_t mended = 0;
    for (std::size_t frame = 0; frame < frames; ++frame) {
      float least = error_at(track, candidate, frame, kMostBroken);
      if (least < 1) continue;
      if (!(least < kMostBroken) || ++mended > frames / 2 + 4) return false;
      const std::array<std::int32_t, 3> middle = candidate.values[frame];
      std::array<std::int32_t, 3> best = middle;
      for (int i = 0; i < 27; ++i) {
        candidate.values[frame] = {middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1};
        const float error = error_at(track, candidate, frame, least);
        if (!(error < least)) continue;
        least = error;
        best = candidate.values[frame];
      }
      candidate.values[frame] = best;
      if (!(least < 1)) return false;
    }
    return true;
  }

  bool push(std::size_t track) {
    std::vector<glm::dvec3> targets = compensated(track);
    if (targets.empty()) targets = targets_[track];
    bool pushed = false;
    for (int i = 0; i < kMostPushes && coded_[track].step_code < 255; ++i) {
      tried_ = SIZE_MAX;
      CodedTrack candidate = quantise(targets, coded_[track].step_code + 1);
      if (!candidate.fits || !mend(track, candidate)) break;
      fit(candidate);
      if (!candidate.fits) break;
      price(track, candidate);
      if (candidate.cost >= coded_[track].cost || !attempt(track, candidate).kept) break;
      commit(track, std::move(candidate));
      targets_[track] = targets;
      pushed = true;
    }
    return pushed;
  }

  const Rig& rig_;
  Promise promise_;
  const std::vector<TrackId>& ids_;
  std::vector<std::span<const Transform>> source_;
  std::vector<std::vector<glm::dvec3>> targets_;  // a track and frame: what is rounded
  std::vector<double> reach_;                     // a joint: metres to the farthest of what it carries
  std::vector<double> scale_above_;               // a joint: scene units a unit of its translation
  std::vector<double> least_;                     // a joint: the strictest promise for it and those below it

  std::vector<CodedTrack> coded_;
  PackedCost packed_cost_;
  std::vector<std::array<ClipCurve, 3>> curves_;  // a track
  std::vector<std::vector<Transform>> local_;     // as decoded, a joint and moment
  Strays strays_;

  std::size_t tried_ = SIZE_MAX;         // the track of the last attempt, if it is not committed and was kept
  std::vector<Transform> trial_local_;   // of the last attempt
  std::vector<std::size_t> hard_frame_;  // a track: where it last broke the promise
};

}  // namespace

std::optional<std::vector<CodedTrack>> choose_steps(const Rig& rig, const Promise& promise,
                                                    const std::vector<TrackId>& coded,
                                                    const std::vector<TrackId>& exact,
                                                    const std::vector<Transform>& still,
                                                    std::vector<std::span<const Transform>> source, Effort effort) {
  StepSearch search(rig, promise, coded, exact, still, std::move(source));
  if (!search.search(effort)) return std::nullopt;
  return search.tracks();
}

}  // namespace marrow::cook
