#include "cook/roles/find_by_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace marrow::cook {
namespace {

constexpr double kMirroredChains = 0.03;                  // of the height: how far mirrored joints may be off
constexpr double kOnGround = 0.15;                        // of the height: where feet are
constexpr double kShortestLeg = 0.25;                     // of the height
constexpr double kMostUneven = 2;                         // upper by lower part of a limb, and the other way round
constexpr double kLeastShare = 0.5;                       // of both parts in what hangs below a limb's first joint
constexpr std::size_t kLeastJoints = 3, kMostJoints = 5;  // of a leg from its first joint on

struct Chains {
  int above = kNone;
  std::vector<int> joints[2];  // of the side where x is less, and of the other
  double length = 0;
};

struct Span2 {
  double low = 0, height = 0;
};

Span2 height_of(const Body& body) {
  double low = body.places[0].y, high = low;
  for (const glm::dvec3& place : body.places) {
    low = std::min(low, place.y);
    high = std::max(high, place.y);
  }
  return {low, high - low};
}

// How many joints hang below one another from each joint on.
std::vector<int> depths_of(const Body& body) {
  std::vector<int> out(body.size(), 1);
  for (std::size_t j = body.size(); j-- > 0;)
    if (const int parent = body.parents[j]; parent != kNone)
      out[to_index(parent)] = std::max(out[to_index(parent)], out[j] + 1);
  return out;
}

// From a joint down, always where most joints follow.
std::vector<int> longest_way(const Body& body, const std::vector<int>& depths, int from) {
  std::vector<int> out;
  for (int j = from; j != kNone;) {
    out.push_back(j);
    int next = kNone;
    for (const int child : body.children[to_index(j)])
      if (next == kNone || depths[to_index(child)] > depths[to_index(next)]) next = child;
    j = next;
  }
  return out;
}

double length_from(const Body& body, const std::vector<int>& joints, std::size_t from) {
  double sum = 0;
  for (std::size_t i = from + 1; i < joints.size(); ++i)
    sum += glm::length(body.place(joints[i]) - body.place(joints[i - 1]));
  return sum;
}

bool mirror_each_other(const Body& body, const std::vector<int>& a, const std::vector<int>& b, double middle,
                       double tolerance) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    glm::dvec3 mirrored = body.place(b[i]);
    mirrored.x = 2 * middle - mirrored.x;
    if (!(glm::length(body.place(a[i]) - mirrored) <= tolerance)) return false;
  }
  return std::abs(body.place(a.back()).x - body.place(b.back()).x) > tolerance;
}

std::vector<Chains> mirrored_chains(const Body& body, double tolerance) {
  const std::vector<int> depths = depths_of(body);
  constexpr std::size_t kMostChildren = 32;
  std::vector<Chains> out;
  for (std::size_t j = 0; j < body.size(); ++j) {
    std::vector<int> deep;
    for (const int child : body.children[j])
      if (to_index(depths[to_index(child)]) >= kLeastJoints && deep.size() < kMostChildren) deep.push_back(child);
    // Only ways of the same length mirror each other. So all ways together have hardly more joints than the skeleton.
    const auto depth = [&](int child) { return depths[to_index(child)]; };
    std::vector<std::vector<int>> ways;
    for (const int child : deep)
      if (std::ranges::count(deep, depth(child), depth) > 1) ways.push_back(longest_way(body, depths, child));
    for (std::size_t a = 0; a < ways.size(); ++a)
      for (std::size_t b = a + 1; b < ways.size(); ++b) {
        if (!mirror_each_other(body, ways[a], ways[b], body.places[j].x, tolerance)) continue;
        const bool in_order = body.place(ways[a].back()).x < body.place(ways[b].back()).x;
        out.push_back(
            {static_cast<int>(j), {ways[in_order ? a : b], ways[in_order ? b : a]}, length_from(body, ways[a], 0)});
      }
  }
  return out;
}

// Where the two longest parts in a row begin, if they are those of a limb; else past the end.
std::size_t first_of_limb(const Body& body, const std::vector<int>& joints, bool down) {
  std::size_t best = joints.size();
  double longest = 0;
  for (std::size_t i = 0; i + 2 < joints.size(); ++i) {
    const glm::dvec3 a = body.place(joints[i + 1]) - body.place(joints[i]),
                     b = body.place(joints[i + 2]) - body.place(joints[i + 1]);
    const double la = glm::length(a), lb = glm::length(b);
    if (down && !(a.y < -0.5 * la && b.y < -0.5 * lb)) continue;
    if (!(la + lb > longest) || la > kMostUneven * lb || lb > kMostUneven * la) continue;
    longest = la + lb;
    best = i;
  }
  return longest >= kLeastShare * length_from(body, joints, std::min(best, joints.size() - 1)) ? best : joints.size();
}

bool carries(const Body& body, int joint) {
  return body.carries.empty() ? !body.children[to_index(joint)].empty() : body.carries[to_index(joint)] != 0;
}

struct Limbs {
  Chains chains;
  std::size_t first = 0;
};

// From hips up: above which joint a leg and a front leg hang.
void give(Body& body, const Limbs& limbs, bool leg, bool left_is_less) {
  for (std::size_t side = 0; side < 2; ++side) {
    const std::vector<int>& j = limbs.chains.joints[side];
    const Side s = (side == 0) == left_is_less ? Side::left : Side::right;
    const std::size_t i = limbs.first;
    body.give(on_side(leg ? Role::left_upper_leg : Role::left_upper_arm, s), j[i]);
    body.give(on_side(leg ? Role::left_lower_leg : Role::left_lower_arm, s), j[i + 1]);
    body.give(on_side(leg ? Role::left_foot : Role::left_hand, s), j[i + 2]);
    if (leg && i + 3 < j.size() && carries(body, j[i + 3])) body.give(on_side(Role::left_toes, s), j[i + 3]);
    if (!leg && i > 0) body.give(on_side(Role::left_shoulder, s), j[i - 1]);
  }
}

// Along z: where toes point, or where front legs are; 0: not known.
double forward_of(const Body& body, const Limbs& legs, const Limbs* front) {
  if (front != nullptr) return body.place(front->chains.above).z - body.place(legs.chains.above).z;
  double sum = 0;
  for (const std::vector<int>& j : legs.chains.joints)
    if (legs.first + 3 < j.size()) sum += body.place(j[legs.first + 3]).z - body.place(j[legs.first + 2]).z;
  return sum;
}

// Legs; and front legs, if there are. False: neither, or too many.
bool find_legs(const Body& body, const std::vector<Chains>& all, const Span2& height, std::vector<Limbs>& out) {
  for (const Chains& c : all) {
    double lowest = body.place(c.joints[0][0]).y;
    for (const int j : c.joints[0]) lowest = std::min(lowest, body.place(j).y);
    if (lowest > height.low + kOnGround * height.height) continue;
    if (body.place(c.joints[0][0]).y - lowest < kShortestLeg * height.height) continue;
    const std::size_t first = first_of_limb(body, c.joints[0], true);
    // Girdles and hocks of animals make chains longer, and then nobody knows which joint is the knee.
    const std::size_t behind = c.joints[0].size() - first;
    if (first < c.joints[0].size() && behind <= kMostJoints && first <= 1) out.push_back({c, first});
  }
  if (out.size() == 2 && out[0].chains.above != out[1].chains.above &&
      body.is_at_or_above(out[1].chains.above, out[0].chains.above))
    std::swap(out[0], out[1]);
  if (out.empty() || out[0].first > 0) return false;
  return out.size() == 1 || (out.size() == 2 && out[0].chains.above != out[1].chains.above &&
                             body.is_at_or_above(out[0].chains.above, out[1].chains.above));
}

bool find_arms(const Body& body, const std::vector<Chains>& all, const Limbs& legs, Limbs& out) {
  bool found = false;
  for (const Chains& c : all) {
    if (c.above == legs.chains.above || !body.is_at_or_above(legs.chains.above, c.above)) continue;
    const std::size_t first = first_of_limb(body, c.joints[0], false);
    if (first == c.joints[0].size() || (found && c.length <= out.chains.length)) continue;
    out = {c, first};
    found = true;
  }
  return found;
}

}  // namespace

void find_by_shape(Body& body) {
  const bool named = std::ranges::any_of(body.parts, [](const JointPart& p) {
    return p.part != Part::none && p.part != Part::unknown && p.part != Part::other && p.part != Part::root;
  });
  if (named || body.size() == 0) return;
  const Span2 height = height_of(body);
  const std::vector<Chains> all = mirrored_chains(body, kMirroredChains * height.height);
  std::vector<Limbs> legs;
  if (!find_legs(body, all, height, legs)) return;
  const double forward = forward_of(body, legs[0], legs.size() == 2 ? &legs[1] : nullptr);
  if (!(std::abs(forward) > kMirroredChains * height.height)) return;
  Limbs arms;
  const bool has_arms = legs.size() == 2 || find_arms(body, all, legs[0], arms);
  if (legs.size() == 2) arms = legs[1];
  body.is_nameless = true;
  // Left is where x is less if the character looks against z.
  give(body, legs[0], true, forward < 0);
  if (has_arms) give(body, arms, false, forward < 0);
}

}  // namespace marrow::cook
