#include "deform/helpers/choose_helpers.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "deform/deformers.h"

namespace marrow::deform {
namespace {

constexpr int kLevels = 4;  // without helpers, at a half, at quarters, at eighths
constexpr int kHelpers[kLevels] = {0, 1, 3, 7};
constexpr double kLeastGain = 1e-5;

struct Pair {
  std::uint32_t first, second;
  double missed[kLevels] = {};  // squares, summed over vertices
  glm::dvec3 centre{0};
  double weight = 0;  // of the centre
};

// Of a vertex with weights a and b, squared, over 4 (1 - G)².
double missed_by(double a, double b, int level) {
  const double whole = a + b, parts = kHelpers[level] + 1;
  const double at = b / whole * parts;
  const double within = at - std::floor(at);
  const double x = whole * whole * within * (1 - within) / (parts * parts);
  return x * x;
}

std::vector<Pair> make_pairs(const SkinnedMesh& mesh, const Likeness& likeness, const Positions& centres) {
  std::vector<Pair> out;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> number;
  for (const auto& [pair, g] : likeness.pairs()) {
    number[pair] = out.size();
    out.push_back({pair.first, pair.second});
  }
  for (std::size_t v = 0; v < mesh.influences.size(); ++v) {
    const std::vector<Influence>& w = mesh.influences[v];
    for (std::size_t i = 0; i < w.size(); ++i)
      for (std::size_t j = i + 1; j < w.size(); ++j) {
        Pair& pair = out[number.at({w[i].joint, w[j].joint})];
        const double a = w[i].weight, b = w[j].weight;
        if (!(a + b > 0)) continue;
        for (int level = 0; level < kLevels; ++level) pair.missed[level] += missed_by(a, b, level);
        if (centres.empty()) continue;
        pair.centre += centres[v] * (a * a * b * b);
        pair.weight += a * a * b * b;
      }
  }
  for (Pair& pair : out) {
    const double unlike = 1 - likeness.of(pair.first, pair.second);
    for (double& missed : pair.missed) missed *= 4 * unlike * unlike;
    if (pair.weight > 0) pair.centre /= pair.weight;
  }
  return out;
}

}  // namespace

std::vector<Helper> choose_helpers(const SkinnedMesh& mesh, const Likeness& likeness,
                                   const std::vector<glm::dvec3>& places, std::size_t most, bool about_centres,
                                   int parts) {
  const std::vector<Pair> pairs = make_pairs(mesh, likeness, about_centres ? rotation_centres(mesh) : Positions());
  std::vector<int> level(pairs.size(), 0);
  // What a pair's next step takes off, a helper; the pair, the first one of equal ones.
  using Step = std::tuple<double, std::ptrdiff_t>;
  std::priority_queue<Step> steps;
  const auto offer = [&](std::size_t p) {
    const int at = level[p];
    if (at + 1 == kLevels || kHelpers[at + 1] >= parts) return;
    steps.emplace((pairs[p].missed[at] - pairs[p].missed[at + 1]) / (kHelpers[at + 1] - kHelpers[at]),
                  -static_cast<std::ptrdiff_t>(p));
  };
  for (std::size_t p = 0; p < pairs.size(); ++p) offer(p);
  const double best = steps.empty() ? 0 : std::get<0>(steps.top());
  std::size_t count = 0;
  while (!steps.empty()) {
    const auto [gain, place] = steps.top();
    steps.pop();
    const auto p = static_cast<std::size_t>(-place);
    const auto more = static_cast<std::size_t>(kHelpers[level[p] + 1] - kHelpers[level[p]]);
    if (!(gain > kLeastGain * best)) break;
    if (count + more > most) continue;
    count += more;
    ++level[p];
    offer(p);
  }
  std::vector<Helper> out;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    for (int h = 1; h <= kHelpers[level[p]]; ++h)
      out.push_back({pairs[p].first, pairs[p].second, static_cast<double>(h) / (kHelpers[level[p]] + 1),
                     about_centres ? pairs[p].centre : places[pairs[p].second], !about_centres});
  return out;
}

}  // namespace marrow::deform
