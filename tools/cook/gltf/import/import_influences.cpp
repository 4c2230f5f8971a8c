// Reads and cleans joints and weights, all sets of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cook/gltf/import/import_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kMostSets = 16;  // 64 influences a vertex; the most that real scenes have is three sets
constexpr double kSumSlack = 0.02;     // eight influences of 8-bit weights drift by up to 4/255
constexpr double kLargestSum = 1e6;    // beyond every unit that weights are painted in

// What was wrong with a primitive's weights, counted so that it is said once.
struct Findings {
  std::size_t not_finite = 0;
  std::size_t negative = 0;
  std::size_t tiny = 0;
  std::size_t merged = 0;
  std::size_t unweighted = 0;
  std::size_t bad_sums = 0;
};

// Joints and weights of one set, four a vertex.
struct Set {
  std::vector<float> joints, weights;
};

std::vector<Set> read_sets(VertexSource& source, Report& report) {
  std::vector<Set> sets;
  std::string attribute = "JOINTS_0";
  for (; source.has(attribute); attribute = "JOINTS_" + std::to_string(sets.size())) {
    const std::string where = source.pointer_of(attribute);
    if (sets.size() == kMostSets)
      report.unsupported(where, "too many joint sets", "at most " + std::to_string(kMostSets) + " are read");
    Set& set = sets.emplace_back();
    set.joints = source.read(attribute);
    set.weights = source.read("WEIGHTS_" + std::to_string(sets.size() - 1));
    for (std::size_t i = 0; i < set.joints.size(); ++i) {
      // Draco data may hold any type of number here.
      const float joint = set.joints[i];
      if (!(joint >= 0 && joint <= 65535) || joint != std::floor(joint))
        report.invalid(where, "not a joint", "vertex " + std::to_string(i / 4) + "; export again");
    }
  }
  return sets;
}

// A weight as it counts: what is none counts as zero.
float counted(float weight, Findings& findings) {
  if (!std::isfinite(weight)) {
    ++findings.not_finite;
    return 0;
  }
  if (weight < 0) {
    ++findings.negative;
    return 0;
  }
  if (weight > 0 && weight < std::numeric_limits<float>::min()) {
    ++findings.tiny;
    return 0;
  }
  return weight;
}

// Of one vertex, each joint once. Weights so large that they would add up to infinity are made shares of their sum.
std::vector<RawInfluence> influences_of(const std::vector<Set>& sets, std::size_t vertex, Findings& findings) {
  std::vector<RawInfluence> out;
  double sum = 0;
  for (const Set& set : sets)
    for (std::size_t i = vertex * 4; i < vertex * 4 + 4; ++i) {
      const float weight = counted(set.weights[i], findings);
      if (weight == 0) continue;
      sum += double{weight};
      out.push_back({static_cast<std::uint32_t>(set.joints[i]), weight});
    }
  if (sum > kLargestSum) {
    for (RawInfluence& influence : out) influence.weight = static_cast<float>(double{influence.weight} / sum);
    std::erase_if(out, [](const RawInfluence& i) { return i.weight < std::numeric_limits<float>::min(); });
  }
  if (!out.empty() && std::abs(sum - 1) > kSumSlack) ++findings.bad_sums;
  // A joint that is listed twice gets the sum, at its first place.
  for (std::size_t i = 0; i < out.size();) {
    const auto first = std::ranges::find(out, out[i].joint, &RawInfluence::joint);
    const auto at = out.begin() + static_cast<std::ptrdiff_t>(i);
    if (first == at) {
      ++i;
      continue;
    }
    first->weight += at->weight;
    ++findings.merged;
    out.erase(at);
  }
  return out;
}

void report_findings(const Findings& findings, const std::string& where, Report& report) {
  const auto say = [&](std::size_t count, const char* rule, const char* text) {
    if (count > 0) report.mend(where, rule, std::to_string(count) + text);
  };
  say(findings.not_finite, "weights-not-finite", " weights are not finite numbers; taken as zero");
  say(findings.negative, "weights-negative", " weights are below zero; taken as zero");
  say(findings.tiny, "weights-denormal", " weights are too small to compute with; taken as zero");
  say(findings.merged, "joints-listed-twice",
      " influences name a joint that the vertex has already; the weights are added");
  say(findings.unweighted, "weights-zero", " vertices have no weight at all; they follow the first joint listed");
  say(findings.bad_sums, "weights-not-normalised",
      " vertices have weights that do not add up to one; they will be scaled to do so");
}

}  // namespace

void import_influences(VertexSource& source, RawPrimitive& raw, Report& report) {
  if (!source.has("JOINTS_0")) return;
  const std::vector<Set> sets = read_sets(source, report);
  Findings findings;
  raw.influences.resize(source.count());
  for (std::size_t v = 0; v < source.count(); ++v) {
    std::vector<RawInfluence>& vertex = raw.influences[v];
    vertex = influences_of(sets, v, findings);
    if (!vertex.empty()) continue;
    vertex.push_back({static_cast<std::uint32_t>(sets.front().joints[v * 4]), 1});
    ++findings.unweighted;
  }
  if (!source.has_data("WEIGHTS_0")) return;
  report_findings(findings, source.pointer_of("WEIGHTS_0"), report);
}

}  // namespace marrow::cook::gltf
