// Skin weights: along each part's chain of joints, blended between parts, smoothed over the mesh, cut to four.
#include "weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "newt_skeleton.h"

namespace marrow::sample {
namespace {

using Row = std::array<float, kJointCount>;

// A joint in a part's chain, and how the handover from the joint before it is laid out along the chain.
struct Link {
  int joint;
  float shift = 0;      // of the handover's middle, along the chain, from the joint's head
  float spread = .05f;  // half the handover's length
};

std::vector<Link> arm_chain(int side) {
  std::vector<Link> chain = {
      {on_side(kClavicle, side)}, {on_side(kUpperArm, side), 0, .05f}, {on_side(kForearm, side), 0, .055f}};
  if (side == 0) {
    // No helper: the whole twist of the hand is smeared over the forearm, where linear blending pinches it.
    chain.push_back({kHand, -.085f, .095f});
  } else {
    chain.push_back({kForearmTwistR, -.02f, .075f});
    chain.push_back({on_side(kHand, side), -.015f, .055f});
  }
  chain.push_back({on_side(kFingers, side), .004f, .024f});
  return chain;
}

std::vector<Link> chain_of(int part) {
  if (part == kTrunkPart) {
    return {{kPelvis},          {kSpine1, 0, .055f}, {kSpine2, 0, .055f},
            {kChest, 0, .055f}, {kNeck, 0, .035f},   {kHead, 0, .035f}};
  }
  if (part == kHeadPart) return {{kHead}};
  if (part == kTailPart) {
    std::vector<Link> chain = {{kPelvis}};
    for (int i = 0; i < kTailCount; ++i) chain.push_back({kTail1 + i, 0, .075f});
    return chain;
  }
  const int side = (part - kArmPart) % 2;
  switch (part - side) {
    case kArmPart:
      return arm_chain(side);
    case kLegPart:
      return {{on_side(kThigh, side)},
              {on_side(kShin, side), 0, .055f},
              {on_side(kFoot, side), .004f, .038f},
              {on_side(kToes, side), .004f, .026f}};
    case kThumbPart:
      return {{on_side(kHand, side)}};
    case kGillTopPart:
      return {{on_side(kGillTop, side)}};
    case kGillMidPart:
      return {{on_side(kGillMid, side)}};
    default:
      return {{on_side(kGillLow, side)}};
  }
}

// How far along the chain's bones the point nearest to `p` is; runs past both ends.
float along_chain(const std::vector<Link>& chain, const std::vector<float>& starts, glm::vec3 p) {
  float best = 1e9f, result = 0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const RestJoint& rest = skeleton()[static_cast<std::size_t>(chain[i].joint)];
    const bool last = i + 1 == chain.size();
    const glm::vec3 tip = last ? rest.tip : skeleton()[static_cast<std::size_t>(chain[i + 1].joint)].head;
    const float length = glm::distance(rest.head, tip);
    const float t = glm::dot(p - rest.head, tip - rest.head) / length;
    const float d = glm::distance(p, rest.head + (tip - rest.head) * (std::clamp(t, 0.0f, length) / length));
    if (d >= best) continue;
    best = d;
    result = starts[i] + std::clamp(t, i == 0 ? -1.0f : 0.0f, last ? length + 1.0f : length);
  }
  return result;
}

class Chains {
 public:
  Chains() {
    for (std::size_t part = 0; part < kPartCount; ++part) {
      links_[part] = chain_of(static_cast<int>(part));
      float start = 0;
      for (std::size_t i = 0; i < links_[part].size(); ++i) {
        starts_[part].push_back(start);
        if (i + 1 == links_[part].size()) break;
        start += glm::distance(skeleton()[static_cast<std::size_t>(links_[part][i].joint)].head,
                               skeleton()[static_cast<std::size_t>(links_[part][i + 1].joint)].head);
      }
    }
  }

  // Adds `amount`, shared out among the joints of the part's chain.
  void share(std::size_t part, glm::vec3 p, float amount, Row& row) const {
    const auto& links = links_[part];
    const float s = along_chain(links, starts_[part], p);
    float left = amount;  // what has been handed on so far, from root to tip
    for (std::size_t i = links.size(); i-- > 1;) {
      const float middle = starts_[part][i] + links[i].shift;
      const float t = std::clamp((s - middle) / (2 * links[i].spread) + .5f, 0.0f, 1.0f);
      const float passed = left * t;
      row[static_cast<std::size_t>(links[i].joint)] += passed;
      left -= passed;
    }
    row[static_cast<std::size_t>(links[0].joint)] += left;
  }

 private:
  std::array<std::vector<Link>, kPartCount> links_;
  std::array<std::vector<float>, kPartCount> starts_;
};

Row first_guess(const Shape& shape, const Chains& chains, glm::vec3 p) {
  const auto distances = shape.part_distances(p);
  const float nearest = *std::min_element(distances.begin(), distances.end());
  std::array<float, kPartCount> shares{};
  float total = 0;
  for (std::size_t part = 0; part < kPartCount; ++part) {
    // Compact support: a part has no say on skin that clearly belongs to another, however near it is in space.
    const float reach = part >= kThumbPart ? .022f : .05f;
    const float t = std::clamp(1.0f - (distances[part] - nearest) / reach, 0.0f, 1.0f);
    shares[part] = t * t * (3 - 2 * t);
    total += shares[part];
  }
  Row row{};
  for (std::size_t part = 0; part < kPartCount; ++part) {
    if (shares[part] > 0) chains.share(part, p, shares[part] / total, row);
  }
  return row;
}

// Repeated averaging with the neighbours on the mesh, never through the air.
void smooth(const Surface& surface, std::vector<Row>& rows, int rounds) {
  const auto neighbours = vertex_neighbours(surface);
  for (int round = 0; round < rounds; ++round) {
    std::vector<Row> next = rows;
    for (std::size_t v = 0; v < rows.size(); ++v) {
      Row mean{};
      for (std::uint32_t other : neighbours[v]) {
        for (std::size_t j = 0; j < kJointCount; ++j) mean[j] += rows[other][j];
      }
      const float scale = .5f / static_cast<float>(neighbours[v].size());
      for (std::size_t j = 0; j < kJointCount; ++j) next[v][j] = rows[v][j] * .5f + mean[j] * scale;
    }
    rows = std::move(next);
  }
}

// The belly joint takes over the front of the trunk, so that the paunch can wobble and breathe.
void give_to_belly(glm::vec3 p, Row& row) {
  const float d = glm::length((p - glm::vec3(0, .59f, .20f)) / glm::vec3(.20f, .20f, .22f));
  const float t = std::clamp(1.0f - d, 0.0f, 1.0f);
  const float part = .75f * t * t * (3 - 2 * t);
  for (const int joint : {kPelvis, kSpine1, kSpine2}) {
    const float moved = row[static_cast<std::size_t>(joint)] * part;
    row[static_cast<std::size_t>(joint)] -= moved;
    row[kBelly] += moved;
  }
}

VertexWeights quantise(const Row& row) {
  std::array<std::size_t, kJointCount> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return row[a] > row[b]; });
  float total = 0;
  for (std::size_t i = 0; i < 4; ++i) total += row[order[i]] > .004f ? row[order[i]] : 0;
  VertexWeights result;
  std::uint32_t left = 65535;
  for (std::size_t i = 4; i-- > 1;) {
    if (row[order[i]] <= .004f) continue;
    result.joints[i] = static_cast<std::uint8_t>(order[i]);
    result.weights[i] = static_cast<std::uint16_t>(std::lround(row[order[i]] / total * 65535.0f));
    left -= result.weights[i];
  }
  result.joints[0] = static_cast<std::uint8_t>(order[0]);
  result.weights[0] = static_cast<std::uint16_t>(left);  // the rounding goes to the strongest
  return result;
}

}  // namespace

std::vector<VertexWeights> make_weights(const Shape& shape, const Surface& surface) {
  const Chains chains;
  std::vector<Row> rows;
  rows.reserve(surface.positions.size());
  for (const glm::vec3& p : surface.positions) rows.push_back(first_guess(shape, chains, p));
  smooth(surface, rows, 5);
  std::vector<VertexWeights> result;
  result.reserve(rows.size());
  for (std::size_t v = 0; v < rows.size(); ++v) {
    give_to_belly(surface.positions[v], rows[v]);
    result.push_back(quantise(rows[v]));
  }
  return result;
}

}  // namespace marrow::sample
