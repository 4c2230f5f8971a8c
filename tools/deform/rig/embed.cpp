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

}  // namespace marrow::deform
