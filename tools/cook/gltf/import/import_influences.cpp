// Reads and cleans joints and weights, all sets of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cook/gltf/import/import_vertices.h"

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kMostSets = 16;  // 64 influences a vertex; the most that real scenes have is three sets
constexpr double kSumSlack = 0.02;     // eight influences of 8-bit weights drift by up to 4/255

// What was wrong with a primitive's weights, counted so that it is said once.
struct Findings {
  std::size_t negative = 0;
  std::size_t tiny = 0;
  std::size_t merged = 0;
  std::size_t unweighted = 0;
  std::size_t bad_sums = 0;
};

void add_influence(std::vector<RawInfluence>& vertex, std::uint32_t joint, float weight, Findings& findings) {
  if (weight == 0) return;
  if (weight < 0) {
    ++findings.negative;
    return;
  }
  if (weight < std::numeric_limits<float>::min()) {
    ++findings.tiny;
    return;
  }
  const auto same = std::ranges::find(vertex, joint, &RawInfluence::joint);
  if (same == vertex.end()) {
    vertex.push_back({joint, weight});
    return;
  }
  same->weight += weight;
  ++findings.merged;
}

void report_findings(const Findings& findings, const std::string& where, Report& report) {
  const auto say = [&](std::size_t count, const char* rule, const char* text) {
    if (count > 0) report.mend(where, rule, std::to_string(count) + text);
  };
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
  Findings findings;
  raw.influences.resize(source.count());
  std::vector<std::uint32_t> first_joint(source.count());
  std::string attribute = "JOINTS_0";
  for (std::size_t set = 0; source.has(attribute); attribute = "JOINTS_" + std::to_string(++set)) {
    const std::string where = source.pointer_of(attribute);
    if (set == kMostSets)
      report.unsupported(where, "too many joint sets", "at most " + std::to_string(kMostSets) + " are read");
    const std::string weight_name = "WEIGHTS_" + std::to_string(set);
    const std::vector<float> joints = source.read(attribute);
    const std::vector<float> weights = source.read(weight_name);
    for (std::size_t v = 0; v < source.count(); ++v) {
      for (std::size_t i = v * 4; i < v * 4 + 4; ++i) {
        if (!std::isfinite(weights[i])) {
          report.invalid(source.pointer_of(weight_name), "not a finite number",
                         "vertex " + std::to_string(v) + "; export again");
        }
        // Draco data may hold any type of number here.
        if (!(joints[i] >= 0 && joints[i] <= 65535) || joints[i] != std::floor(joints[i])) {
          report.invalid(where, "not a joint", "vertex " + std::to_string(v) + "; export again");
        }
        add_influence(raw.influences[v], static_cast<std::uint32_t>(joints[i]), weights[i], findings);
      }
      if (set == 0) first_joint[v] = static_cast<std::uint32_t>(joints[v * 4]);
    }
  }
  for (std::size_t v = 0; v < source.count(); ++v) {
    std::vector<RawInfluence>& vertex = raw.influences[v];
    if (vertex.empty()) {
      vertex.push_back({first_joint[v], 1});
      ++findings.unweighted;
      continue;
    }
    double sum = 0;
    for (const RawInfluence& influence : vertex) sum += double{influence.weight};
    if (std::abs(sum - 1) > kSumSlack) ++findings.bad_sums;
  }
  if (!source.has_data("WEIGHTS_0")) return;
  report_findings(findings, source.pointer_of("WEIGHTS_0"), report);
}

}  // namespace marrow::cook::gltf
