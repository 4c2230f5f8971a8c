#include "deform/rig/embed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace marrow::deform {
namespace {

// Penalties, of shares that are squared where they should not matter while they are small.
constexpr double kLength = 1;       // of how many times too long or too short the way to the knot above is
constexpr double kDirection = 1.5;  // of 1 - cosine of the angle by which the template's direction is missed
constexpr double kHeight = 1.5;     // of how much higher or lower in the box than in the template's
constexpr double kOffPlane = 40;    // of how far from the mirror plane a middle knot is
constexpr double kThin = 0.6;       // of branching knots: how much thinner than the widest place
constexpr double kNoTip = 20;       // of leaves: how much further the mesh goes on
constexpr double kSharedWay = 4;    // of ways to two knots below one, which run together
constexpr double kAsymmetry = 20;   // of how far a knot is from its mirror image's place
constexpr double kTooClose = 4;     // of leaves with less than half the way between them
constexpr double kTipReach = 0.12;  // heights in which nothing is further out than a tip
constexpr double kMiddleReach = 0.06, kTipSlack = 0.06;  // heights: what is no candidate any more
constexpr std::size_t kMostLeafCandidates = 60, kMostCandidates = 160;
constexpr std::size_t kMostWork = 60'000'000;   // pairs of knots compared; the search then keeps the best that it found
constexpr std::size_t kMostInVain = 3'000'000;  // likewise, while it has found nothing: it then gives up

constexpr double kNever = std::numeric_limits<double>::infinity();

double squared(double x) {
  return x * x;
}

struct Candidate {
  std::size_t sphere;
  double penalty;
};

class Search {
 public:
  explicit Search(const Embedding& of) : of_(of), spheres_(of.room.spheres()) {
    measure_template();
    for (std::size_t k = 0; k < of_.knots.size(); ++k) candidates_.push_back(candidates_of(k));
    bound();
  }

  std::optional<std::vector<std::size_t>> best() {
    for (const std::vector<Candidate>& candidates : candidates_)
      if (candidates.empty()) return std::nullopt;
    chosen_.assign(of_.knots.size(), 0);
    descend(0, 0, 0);
    if (best_.empty()) return std::nullopt;
    std::vector<std::size_t> out;
    for (std::size_t k = 0; k < best_.size(); ++k) out.push_back(candidates_[k][best_[k]].sphere);
    return out;
  }

 private:
  const glm::dvec3& place(std::size_t knot) const { return of_.knots[knot].place; }

  void measure_template() {
    low_ = high_ = of_.skeleton.front().place.y;
    for (const TemplateJoint& joint : of_.skeleton) {
      low_ = std::min(low_, joint.place.y);
      high_ = std::max(high_, joint.place.y);
    }
    bottom_ = top_ = spheres_.front().centre.y;
    for (const Sphere& s : spheres_) {
      bottom_ = std::min(bottom_, s.centre.y - s.radius);
      top_ = std::max(top_, s.centre.y + s.radius);
    }
    height_ = of_.scale * std::max(high_ - low_, 1e-9);
    children_.resize(of_.knots.size());
    for (std::size_t k = 1; k < of_.knots.size(); ++k)
      children_[static_cast<std::size_t>(of_.knots[k].parent)].push_back(k);
  }

  // Whether a sphere is on the side that a knot is on, or in the middle with it.
  bool is_beside(std::size_t knot, std::size_t sphere) const {
    const double aside = (spheres_[sphere].centre.x - of_.plane.x) / height_;
    return of_.knots[knot].mirror == kNoJoint ? std::abs(aside) <= kMiddleReach : aside * place(knot).x > 0;
  }

  // How much further from the widest place the mesh goes on near a sphere, on the side of a knot; in heights.
  double beyond(std::size_t knot, std::size_t sphere) const {
    const double own = of_.room.distance(0, sphere);
    double farthest = own;
    for (std::size_t o = 0; o < spheres_.size(); ++o)
      if (of_.room.distance(0, o) > farthest && of_.room.distance(sphere, o) <= kTipReach * height_ &&
          is_beside(knot, o))
        farthest = of_.room.distance(0, o);
    return (farthest - own) / height_;
  }

  std::vector<Candidate> candidates_of(std::size_t knot) const {
    const Knot& k = of_.knots[knot];
    std::vector<Candidate> out;
    const double wanted = (place(knot).y - low_) / std::max(high_ - low_, 1e-9);
    for (std::size_t s = 0; s < spheres_.size(); ++s) {
      const Sphere& sphere = spheres_[s];
      if (!is_beside(knot, s)) continue;
      double penalty = kHeight * squared((sphere.centre.y - bottom_) / (top_ - bottom_) - wanted);
      if (k.mirror == kNoJoint) penalty += kOffPlane * squared((sphere.centre.x - of_.plane.x) / height_);
      if (k.is_leaf) {
        const double on = beyond(knot, s);
        if (on > kTipSlack) continue;
        penalty += kNoTip * squared(on / kTipReach);
      } else {
        penalty += kThin * squared(1 - sphere.radius / of_.room.widest());
      }
      out.push_back({s, penalty});
    }
    std::ranges::stable_sort(out, {}, &Candidate::penalty);
    const std::size_t most = k.is_leaf ? kMostLeafCandidates : kMostCandidates;
    if (out.size() > most) out.resize(most);
    return out;
  }

  // Of the way from the knot above, at one of its candidates, to a candidate of a knot.
  double along(std::size_t knot, const Candidate& above, const Candidate& at) const {
    const Knot& k = of_.knots[knot];
    const double on = k.is_leaf ? spheres_[at.sphere].radius : 0;  // from the centre to the mesh's surface
    const double way = of_.room.distance(above.sphere, at.sphere) + on, wanted = k.length * of_.scale;
    if (above.sphere == at.sphere || !(way > 0) || !(wanted > 0)) return kNever;
    const glm::dvec3 direction = place(knot) - place(static_cast<std::size_t>(k.parent));
    const glm::dvec3 there = spheres_[at.sphere].centre - spheres_[above.sphere].centre;
    const double lengths = glm::length(direction) * glm::length(there);
    const double turned = lengths > 0 ? 1 - glm::dot(direction, there) / lengths : 0;
    return kLength * (way / wanted + wanted / way - 2) + kDirection * squared(turned);
  }

  // What a knot and all below it cost at least, by the candidate of the knot above.
  void bound() {
    const std::size_t count = of_.knots.size();
    least_.resize(count);
    for (std::size_t k = count; k-- > 1;) {
      const std::vector<Candidate>& above = candidates_[static_cast<std::size_t>(of_.knots[k].parent)];
      least_[k].assign(above.size(), kNever);
      for (std::size_t c = 0; c < candidates_[k].size(); ++c) {
        const double own = candidates_[k][c].penalty + below(k, c);
        for (std::size_t p = 0; p < above.size(); ++p)
          if (own < least_[k][p]) least_[k][p] = std::min(least_[k][p], own + along(k, above[p], candidates_[k][c]));
      }
    }
  }

  double below(std::size_t knot, std::size_t candidate) const {
    double sum = 0;
    for (const std::size_t child : children_[knot]) sum += least_[child][candidate];
    return sum;
  }

  // Penalties between a knot's candidate and the knots before it, other than the one above.
  double between(std::size_t knot, std::size_t sphere) const {
    const Knot& k = of_.knots[knot];
    double sum = 0;
    for (std::size_t other = 0; other < knot; ++other) {
      const Knot& o = of_.knots[other];
      const std::size_t there = candidates_[other][chosen_[other]].sphere;
      if (there == sphere) return kNever;
      const double way = of_.room.distance(there, sphere);
      if (o.parent == k.parent && k.parent != kNoJoint) {
        const auto parent = static_cast<std::size_t>(k.parent);
        const std::size_t above = candidates_[parent][chosen_[parent]].sphere;
        const double shared = (of_.room.distance(above, there) + of_.room.distance(above, sphere) - way) / 2;
        sum += kSharedWay * shared / height_;
      }
      if (k.mirror == static_cast<int>(other)) {
        const glm::dvec3 c = spheres_[there].centre;
        const glm::dvec3 image(2 * of_.plane.x - c.x, c.y, c.z);
        const glm::dvec3 apart = (spheres_[sphere].centre - image) / height_;
        sum += kAsymmetry * of_.plane.share * glm::dot(apart, apart);
      }
      if (k.is_leaf && o.is_leaf) {
        const double wanted = of_.scale * glm::length(place(knot) - place(other)) / 2;
        if (way < wanted) sum += kTooClose * squared(1 - way / wanted);
      }
    }
    return sum;
  }

  // so_far: penalties of knots that have been placed; open: the least of those that have not, below them.
  void descend(std::size_t knot, double so_far, double open) {
    if (knot == of_.knots.size()) {
      if (best_.empty() || so_far < least_sum_) {
        best_ = chosen_;
        least_sum_ = so_far;
      }
      return;
    }
    struct Next {
      double bound, so_far, open;
      std::size_t candidate;
    };
    std::vector<Next> all;
    const int parent = of_.knots[knot].parent;
    const std::vector<Candidate>& own = candidates_[knot];
    for (std::size_t c = 0; c < own.size(); ++c) {
      double sum = so_far + own[c].penalty, rest = open + below(knot, c);
      if (parent != kNoJoint) {
        const auto p = static_cast<std::size_t>(parent);
        sum += along(knot, candidates_[p][chosen_[p]], own[c]);
        rest -= least_[knot][chosen_[p]];
      }
      if (!best_.empty() && sum + rest >= least_sum_) continue;
      sum += between(knot, own[c].sphere);
      work_ += knot + 1;
      if (sum + rest < kNever) all.push_back({sum + rest, sum, rest, c});
    }
    std::ranges::stable_sort(all, {}, &Next::bound);
    for (const Next& next : all) {
      if (best_.empty() ? work_ >= kMostInVain : next.bound >= least_sum_ || work_ >= kMostWork) return;
      chosen_[knot] = next.candidate;
      descend(knot + 1, next.so_far, next.open);
    }
  }

  const Embedding& of_;
  const std::vector<Sphere>& spheres_;
  double low_ = 0, high_ = 1;    // of the template
  double bottom_ = 0, top_ = 1;  // of the mesh
  double height_ = 1;            // of the template, in voxels
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::vector<Candidate>> candidates_;  // a knot
  std::vector<std::vector<double>> least_;          // a knot, by the candidate of the knot above
  std::vector<std::size_t> chosen_, best_;
  double least_sum_ = kNever;
  std::size_t work_ = 0;
};

}  // namespace

std::optional<std::vector<std::size_t>> embed(const Embedding& embedding) {
  // No two knots share a sphere.
  if (embedding.room.size() < embedding.knots.size()) return std::nullopt;
  return Search(embedding).best();
}

namespace {

constexpr double kCentre = 1, kProportion = 0.3, kSymmetry = 60, kStay = 12;  // of squares of heights the last two
constexpr int kSamples = 6;                                                   // along a bone
constexpr double kFirstStep = 0.02;                                           // heights
constexpr int kHalvings = 5, kRounds = 8;
constexpr double kSymmetric = 0.85;  // share of voxels with one opposite, from which on sides are to be alike

// The point at `share` of a polyline's length.
glm::dvec3 along(const std::vector<glm::dvec3>& line, double share) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::length(line[i] - line[i - 1]);
  double left = share * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = glm::length(line[i] - line[i - 1]);
    if (left <= step && step > 0) return line[i - 1] + (line[i] - line[i - 1]) * (left / step);
    left -= step;
  }
  return line.back();
}

// Of the last bone, to go on from a sphere's centre to the mesh's surface.
glm::dvec3 end_direction(const SkeletonTemplate& skeleton, const Knot& knot) {
  const TemplateJoint& end = skeleton[knot.joint];
  const glm::dvec3 along = end.place - skeleton[static_cast<std::size_t>(end.parent)].place;
  return along / std::max(glm::length(along), 1e-12);
}

class Refinement {
 public:
  Refinement(const Embedding& of, std::vector<glm::dvec3>& places) : of_(of), places_(places), start_(places) {
    children_.resize(places.size());
    for (std::size_t j = 1; j < places.size(); ++j)
      children_[static_cast<std::size_t>(of.skeleton[j].parent)].push_back(j);
    double wanted = 0, now = 0;
    low_ = high_ = of.skeleton.front().place.y;
    for (std::size_t j = 0; j < places.size(); ++j) {
      low_ = std::min(low_, of.skeleton[j].place.y);
      high_ = std::max(high_, of.skeleton[j].place.y);
      if (j == 0) continue;
      wanted += wanted_length(j);
      now += glm::length(places[j] - parent_of(j));
    }
    height_ = of.scale * std::max(high_ - low_, 1e-9);
    scale_ = wanted > 0 && now > 0 ? now / wanted : of.scale;
  }

  void run() {
    double step = kFirstStep * height_;
    for (int halving = 0; halving < kHalvings; ++halving, step /= 2)
      for (int round = 0; round < kRounds; ++round)
        if (!move_all(step)) break;
  }

 private:
  double wanted_length(std::size_t joint) const {
    const auto parent = static_cast<std::size_t>(of_.skeleton[joint].parent);
    return glm::length(of_.skeleton[joint].place - of_.skeleton[parent].place);
  }
  const glm::dvec3& parent_of(std::size_t joint) const {
    return places_[static_cast<std::size_t>(of_.skeleton[joint].parent)];
  }

  // Of the bone that ends at a joint.
  double bone(std::size_t joint) const {
    const glm::dvec3 &from = parent_of(joint), &to = places_[joint];
    double off = 0;
    for (int i = 1; i <= kSamples; ++i) {
      const double o = of_.room.off_centre(from + (to - from) * (static_cast<double>(i) / kSamples));
      off += o * o / kSamples;
    }
    const double length = std::max(glm::length(to - from), 1e-6 * height_);
    const double wanted = std::max(wanted_length(joint) * scale_, 1e-6 * height_);
    const double share = wanted * of_.scale / (scale_ * height_);  // long bones count more
    return share * (kCentre * off + kProportion * (length / wanted + wanted / length - 2));
  }

  double around(std::size_t joint) const {
    double sum = joint > 0 ? bone(joint) : 0;
    for (const std::size_t child : children_[joint]) sum += bone(child);
    const glm::dvec3 moved = (places_[joint] - start_[joint]) / height_;
    sum += kStay * glm::dot(moved, moved);
    const int mirror = of_.skeleton[joint].mirror;
    const glm::dvec3 other = places_[mirror == kNoJoint ? joint : static_cast<std::size_t>(mirror)];
    const glm::dvec3 apart = (places_[joint] - glm::dvec3(2 * of_.plane.x - other.x, other.y, other.z)) / height_;
    return sum + kSymmetry * of_.plane.share * glm::dot(apart, apart);
  }

  bool move_all(double step) {
    bool moved = false;
    for (std::size_t j = 0; j < places_.size(); ++j)
      for (int axis = 0; axis < 3; ++axis)
        for (const double by : {step, -step}) {
          const double before = around(j);
          places_[j][axis] += by;
          if (around(j) < before - 1e-12) {
            moved = true;
            break;
          }
          places_[j][axis] -= by;
        }
    return moved;
  }

  const Embedding& of_;
  std::vector<glm::dvec3>& places_;
  const std::vector<glm::dvec3> start_;
  std::vector<std::vector<std::size_t>> children_;
  double low_ = 0, high_ = 1, height_ = 1, scale_ = 1;
};

// Of a symmetric mesh: both sides at the mean of both.
void mirror_joints(const Embedding& of, std::vector<glm::dvec3>& places) {
  if (of.plane.share < kSymmetric) return;
  for (std::size_t j = 0; j < places.size(); ++j) {
    const int mirror = of.skeleton[j].mirror;
    const std::size_t other = mirror == kNoJoint ? j : static_cast<std::size_t>(mirror);
    if (other < j) continue;
    const glm::dvec3 image(2 * of.plane.x - places[other].x, places[other].y, places[other].z);
    const glm::dvec3 mean = (places[j] + image) * 0.5;
    places[j] = mean;
    places[other] =
        other == j ? glm::dvec3(of.plane.x, mean.y, mean.z) : glm::dvec3(2 * of.plane.x - mean.x, mean.y, mean.z);
  }
}

}  // namespace

std::vector<glm::dvec3> place_joints(const Embedding& of, const std::vector<std::size_t>& spheres) {
  std::vector<glm::dvec3> out(of.skeleton.size());
  for (std::size_t k = 0; k < of.knots.size(); ++k) {
    const Knot& knot = of.knots[k];
    if (knot.parent == kNoJoint) {
      out[knot.joint] = of.room.spheres()[spheres[k]].centre;
      continue;
    }
    std::vector<glm::dvec3> line;
    for (const std::size_t s : of.room.way(spheres[static_cast<std::size_t>(knot.parent)], spheres[k]))
      line.push_back(of.room.spheres()[s].centre);
    if (knot.is_leaf)
      line.push_back(line.back() + end_direction(of.skeleton, knot) * of.room.spheres()[spheres[k]].radius);
    for (std::size_t i = 0; i < knot.chain.size(); ++i)
      out[knot.chain[i]] = along(line, knot.length > 0 ? knot.lengths[i] / knot.length : 1);
  }
  mirror_joints(of, out);
  return out;
}

void refine_joints(const Embedding& of, std::vector<glm::dvec3>& places) {
  Refinement(of, places).run();
  mirror_joints(of, places);
}

}  // namespace marrow::deform
