#include "cook/clip/compress/choose_steps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include <glm/geometric.hpp>

#include "deform/slerp.h"

namespace marrow::cook {
namespace {

constexpr double kFirstShare = 0.5;     // of the promise, for each track's step at the start
constexpr int kMostShrinks = 18;        // to a fiftieth of it
constexpr int kFarthestStep = 24;       // quarter octaves that one coarsening may take
constexpr std::uint32_t kMoreBits = 2;  // a frame, that a track may take to make good what those above it miss

double eighth_power(double x) {
  const double x2 = x * x, x4 = x2 * x2;
  return x4 * x4;
}

// The rotation in a map that is one after a scaling along its own axes; nullopt if it is not.
std::optional<glm::dquat> rotation_of(const glm::dmat3& linear) {
  const glm::dmat3 unit(glm::normalize(linear[0]), glm::normalize(linear[1]), glm::normalize(linear[2]));
  constexpr double kSlack = 1e-6;
  const double skew = std::max({std::fabs(glm::dot(unit[0], unit[1])), std::fabs(glm::dot(unit[1], unit[2])),
                                std::fabs(glm::dot(unit[2], unit[0]))});
  if (!(skew < kSlack) || glm::determinant(unit) < 0) return std::nullopt;
  return glm::quat_cast(unit);
}

double largest_axis(const World& w) {
  return std::max({glm::length(w.linear[0]), glm::length(w.linear[1]), glm::length(w.linear[2])});
}

}  // namespace

Segment::Segment(const Rig& rig, const Promise& promise, const std::vector<TrackId>& coded,
                 const std::vector<TrackId>& exact, const std::vector<Transform>& still,
                 std::vector<std::vector<Transform>> source)
    : rig_(rig),
      promise_(promise),
      ids_(coded),
      source_(std::move(source)),
      source_world_(rig.size()),
      coded_(coded.size()),
      world_(rig.size()),
      energy_(rig.size(), 0),
      trial_world_(rig.size()),
      trial_energy_(rig.size(), 0) {
  for (std::size_t j = 0; j < rig_.size(); ++j) {
    for (std::size_t e = 0; e < moment_count(); ++e) {
      const World* parent =
          rig_.parents[j] == kNone ? nullptr : &source_world_[static_cast<std::size_t>(rig_.parents[j])][e];
      source_world_[j].push_back(rig_.place(j, parent, source_[j][e]));
    }
    local_.emplace_back(moment_count(), still[j]);
    world_[j].resize(moment_count());
    trial_world_[j].resize(moment_count());
  }
  for (const TrackId& id : exact)
    for (std::size_t e = 0; e < moment_count(); ++e) {
      if (id.path == TrackPath::translation) local_[id.joint][e].translation = source_[id.joint][e].translation;
      if (id.path == TrackPath::rotation) local_[id.joint][e].rotation = source_[id.joint][e].rotation;
      if (id.path == TrackPath::scale) local_[id.joint][e].scale = source_[id.joint][e].scale;
    }
  find_targets();
  find_reach();
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

// Rotations relative to the rest pose; the others as differences.
void Segment::find_targets() {
  for (const TrackId& id : ids_) {
    const Transform& rest = rig_.rest[id.joint];
    std::vector<glm::dvec3> frames;
    Unwrapper unwrapper({1, 0, 0, 0});
    for (std::size_t e = 0; e < moment_count(); e += kMoments) {
      const Transform& t = source_[id.joint][e];
      if (id.path == TrackPath::translation) frames.push_back(t.translation - rest.translation);
      if (id.path == TrackPath::scale) frames.push_back(t.scale - rest.scale);
      if (id.path == TrackPath::rotation) frames.push_back(unwrapper.next(glm::conjugate(rest.rotation) * t.rotation));
    }
    targets_.push_back(std::move(frames));
  }
}

void Segment::find_reach() {
  reach_ = promise_.reach;
  scale_above_.assign(rig_.size(), 1);
  least_ = promise_.error;
  for (std::size_t j = 0; j < rig_.size(); ++j) {
    const std::size_t parent = static_cast<std::size_t>(rig_.parents[j]);
    scale_above_[j] = rig_.parents[j] == kNone ? largest_axis(rig_.above[j]) : largest_axis(source_world_[parent][0]);
    for (const std::size_t below : rig_.subtrees[j]) least_[j] = std::min(least_[j], promise_.error[below]);
    for (const std::size_t below : rig_.subtrees[j])
      for (std::size_t e = 0; e < moment_count(); e += kMoments)
        reach_[j] = std::max(reach_[j], promise_.reach[below] +
                                            glm::length(source_world_[below][e].origin - source_world_[j][e].origin));
  }
}

// Local transforms of a joint with one of its tracks replaced.
void Segment::decode_local(std::size_t joint, std::size_t track, const CodedTrack& candidate,
                           std::vector<Transform>& out) const {
  out = local_[joint];
  const Transform& rest = rig_.rest[joint];
  const TrackPath path = ids_[track].path;
  glm::dvec3 b = decode(candidate, 0);
  glm::dquat qb = from_rodrigues(b);
  for (std::size_t e = 0; e < out.size(); ++e) {
    const glm::dvec3 a = b;
    const glm::dquat qa = qb;
    const std::size_t frame = e / kMoments;
    const bool last = frame + 1 == candidate.values.size();
    if (!last) {
      b = decode(candidate, frame + 1);
      if (path == TrackPath::rotation) qb = from_rodrigues(b);
    }
    for (std::size_t k = 0; k < (last ? 1 : kMoments); ++k, ++e) {
      const double u = static_cast<double>(k) / static_cast<double>(kMoments);
      if (path == TrackPath::translation) out[e].translation = rest.translation + a + u * (b - a);
      if (path == TrackPath::scale) out[e].scale = rest.scale + a + u * (b - a);
      if (path == TrackPath::rotation) out[e].rotation = rest.rotation * deform::slerp(qa, qb, u);
    }
    --e;
  }
}

Segment::Trial Segment::attempt(std::size_t track, const CodedTrack& candidate) {
  const std::size_t changed = ids_[track].joint;
  decode_local(changed, track, candidate, trial_local_);
  Trial trial;
  for (const std::size_t j : rig_.subtrees[changed]) {
    const int parent = rig_.parents[j];
    const std::vector<World>* up = nullptr;
    if (parent != kNone)
      up = j == changed ? &world_[static_cast<std::size_t>(parent)] : &trial_world_[static_cast<std::size_t>(parent)];
    const std::vector<Transform>& local = j == changed ? trial_local_ : local_[j];
    double energy = 0;
    for (std::size_t e = 0; e < moment_count(); ++e) {
      trial_world_[j][e] = rig_.place(j, up == nullptr ? nullptr : &(*up)[e], local[e]);
      const double error = joint_error(source_world_[j][e], trial_world_[j][e], promise_, j);
      if (!(error <= promise_.error[j])) return trial;
      energy += eighth_power(error / promise_.error[j]);
    }
    trial_energy_[j] = energy;
    trial.energy += energy - energy_[j];
  }
  trial.kept = true;
  return trial;
}

// Takes over what the last attempt, which must have been of this track, has computed.
void Segment::commit(std::size_t track, CodedTrack candidate) {
  const std::size_t changed = ids_[track].joint;
  std::swap(local_[changed], trial_local_);
  for (const std::size_t j : rig_.subtrees[changed]) {
    std::swap(world_[j], trial_world_[j]);
    energy_[j] = trial_energy_[j];
  }
  coded_[track] = std::move(candidate);
}

// Steps in proportion to 1 / reach, so that each track alone strays by about `share` of the promise.
bool Segment::start(double share) {
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
    decode_local(id.joint, t, coded_[t], trial_local_);
    std::swap(local_[id.joint], trial_local_);
  }
  for (std::size_t j = 0; j < rig_.size(); ++j) {
    energy_[j] = 0;
    for (std::size_t e = 0; e < moment_count(); ++e) {
      const World* parent = rig_.parents[j] == kNone ? nullptr : &world_[static_cast<std::size_t>(rig_.parents[j])][e];
      world_[j][e] = rig_.place(j, parent, local_[j][e]);
      const double error = joint_error(source_world_[j][e], world_[j][e], promise_, j);
      if (!(error <= promise_.error[j])) return false;
      energy_[j] += eighth_power(error / promise_.error[j]);
    }
  }
  return true;
}

// The finest of the coarser steps that saves a bit.
bool Segment::coarser(std::size_t track, CodedTrack& candidate) const {
  const CodedTrack& now = coded_[track];
  for (int code = now.step_code + 1; code <= 255 && code <= now.step_code + kFarthestStep; ++code) {
    candidate = quantise(targets_[track], code);
    if (candidate.fits && candidate.frame_bits < now.frame_bits) return true;
  }
  return false;
}

void Segment::coarsen() {
  struct Move {
    double worth;
    std::size_t track;
    CodedTrack candidate;
    std::size_t age;
    bool operator<(const Move& other) const { return worth < other.worth; }
  };
  std::priority_queue<Move> moves;
  std::size_t age = 0;
  const auto propose = [&](std::size_t track) {
    Move move{0, track, {}, age};
    if (!coarser(track, move.candidate)) return;
    const Trial trial = attempt(track, move.candidate);
    if (!trial.kept) return;  // and never will be: errors only grow
    move.worth = (coded_[track].frame_bits - move.candidate.frame_bits) / std::max(trial.energy, 1e-9);
    moves.push(std::move(move));
  };
  for (std::size_t t = 0; t < ids_.size(); ++t) propose(t);
  while (!moves.empty()) {
    Move best = moves.top();
    moves.pop();
    if (best.age != age) {
      propose(best.track);
      continue;
    }
    if (!attempt(best.track, best.candidate).kept) continue;
    commit(best.track, std::move(best.candidate));
    ++age;
    propose(best.track);
  }
}

std::size_t Segment::frame_bits() const {
  std::size_t bits = 0;
  for (const CodedTrack& track : coded_) bits += track.frame_bits;
  return bits;
}

// What a track would have to hold for its joint to stand in the scene as in the source, below joints that do not quite.
// Empty where a parent is scaled unevenly.
std::vector<glm::dvec3> Segment::compensated(std::size_t track) const {
  const TrackId& id = ids_[track];
  const Transform& rest = rig_.rest[id.joint];
  const int parent = rig_.parents[id.joint];
  if (parent == kNone || id.path == TrackPath::scale) return {};
  std::vector<glm::dvec3> out;
  Unwrapper unwrapper(from_rodrigues(targets_[track][0]));
  for (std::size_t e = 0; e < moment_count(); e += kMoments) {
    const World& above = world_[static_cast<std::size_t>(parent)][e];
    const World& wanted = source_world_[id.joint][e];
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
void Segment::compensate() {
  for (std::size_t t = 0; t < ids_.size(); ++t) {
    std::vector<glm::dvec3> targets = compensated(t);
    if (targets.empty()) continue;
    CodedTrack candidate = quantise(targets, coded_[t].step_code);
    if (!candidate.fits || candidate.frame_bits > coded_[t].frame_bits + kMoreBits) continue;
    const Trial trial = attempt(t, candidate);
    if (!trial.kept || trial.energy >= 0) continue;
    commit(t, std::move(candidate));
    targets_[t] = std::move(targets);
  }
}

bool Segment::search() {
  double share = kFirstShare;
  int shrinks = 0;
  while (!start(share)) {
    if (++shrinks > kMostShrinks) return false;
    share *= 0.8;
  }
  coarsen();
  std::vector<CodedTrack> best = coded_;
  for (std::size_t least = frame_bits();;) {
    compensate();
    coarsen();
    if (frame_bits() >= least) break;
    least = frame_bits();
    best = coded_;
  }
  coded_ = std::move(best);
  return true;
}

}  // namespace marrow::cook
