#include "deform/helpers/closed_form.h"

#include <algorithm>
#include <cmath>
#include <queue>

#include "deform/deformers.h"
#include "deform/rotations.h"

namespace marrow::deform {
namespace {

constexpr double kUnknown = 0.5;  // how alike joints turn of which nothing is known
constexpr double kAStep = 0.966;  // cos 15°: how alike joints are that turn 30° apart
constexpr double kNoWeight = 1e-9;
constexpr double kForbidden = 1e3;  // what an entry costs that must not be used

// A tree of joints.
class Tree {
 public:
  explicit Tree(const std::vector<int>& parents) : parents_(parents) {
    for (std::size_t j = 0; j < parents.size(); ++j) {
      std::size_t depth = 0;
      for (int up = parents[j]; up >= 0 && depth < parents.size(); up = parents[static_cast<std::size_t>(up)]) ++depth;
      depth_.push_back(depth);
    }
  }

  // From one joint to the other; 1 where no way leads there.
  std::size_t steps(std::uint32_t a, std::uint32_t b) const {
    if (std::max(a, b) >= parents_.size()) return 1;
    std::size_t out = 0;
    for (; a != b; ++out) {
      std::uint32_t& deeper = depth_[a] < depth_[b] ? b : a;
      if (parents_[deeper] < 0) return 1;
      deeper = static_cast<std::uint32_t>(parents_[deeper]);
    }
    return out;
  }

 private:
  const std::vector<int>& parents_;
  std::vector<std::size_t> depth_;
};

// A column of the program: joint or helper as shares of the vertex's joints, by their places.
struct Column {
  std::uint32_t entry;
  std::size_t first, second;
  double share, cost;
};

// min Σ cost_i c_i, Σ c_i column_i = w, c ≥ 0, by the simplex method. The first columns are the joints, which are the
// first basis. Bland's rule, so that it ends.
std::vector<Influence> solve(const std::vector<Column>& columns, const std::vector<Influence>& w) {
  const std::size_t rows = w.size(), width = columns.size();
  std::vector<double> table(rows * width, 0.0);
  std::vector<double> right(rows), reduced(width);
  std::vector<std::size_t> basis(rows);
  for (std::size_t i = 0; i < width; ++i) {
    table[columns[i].first * width + i] += 1 - columns[i].share;
    table[columns[i].second * width + i] += columns[i].share;
  }
  for (std::size_t r = 0; r < rows; ++r) {
    right[r] = w[r].weight;
    basis[r] = r;
  }
  for (std::size_t i = 0; i < width; ++i) {
    reduced[i] = columns[i].cost;
    for (std::size_t r = 0; r < rows; ++r) reduced[i] -= columns[r].cost * table[r * width + i];
  }
  for (;;) {
    const auto enters =
        static_cast<std::size_t>(std::ranges::find_if(reduced, [](double x) { return x < -1e-10; }) - reduced.begin());
    if (enters == width) break;
    std::size_t leaves = rows;
    for (std::size_t r = 0; r < rows; ++r) {
      const double slope = table[r * width + enters];
      if (!(slope > 1e-10)) continue;
      if (leaves < rows) {
        const double now = right[r] / slope, best = right[leaves] / table[leaves * width + enters];
        if (now > best || (now == best && basis[r] > basis[leaves])) continue;
      }
      leaves = r;
    }
    if (leaves == rows) break;  // cannot be: c sum to 1
    const double pivot = table[leaves * width + enters];
    for (std::size_t i = 0; i < width; ++i) table[leaves * width + i] /= pivot;
    right[leaves] /= pivot;
    for (std::size_t r = 0; r < rows; ++r) {
      const double factor = table[r * width + enters];
      if (r == leaves || factor == 0) continue;
      for (std::size_t i = 0; i < width; ++i) table[r * width + i] -= factor * table[leaves * width + i];
      right[r] = std::max(0.0, right[r] - factor * right[leaves]);
    }
    const double factor = reduced[enters];
    for (std::size_t i = 0; i < width; ++i) reduced[i] -= factor * table[leaves * width + i];
    basis[leaves] = enters;
  }
  std::vector<Influence> out;
  for (std::size_t r = 0; r < rows; ++r)
    if (right[r] > kNoWeight) out.push_back({columns[basis[r]].entry, right[r]});
  std::ranges::sort(out, {}, &Influence::joint);
  return out;
}

}  // namespace

Likeness::Likeness(const SkinnedMesh& mesh, const std::vector<Pose>& poses, const std::vector<int>& parents) {
  for (const std::vector<Influence>& vertex : mesh.influences)
    for (std::size_t i = 0; i < vertex.size(); ++i)
      for (std::size_t j = i + 1; j < vertex.size(); ++j) pairs_.try_emplace({vertex[i].joint, vertex[j].joint}, 0.0);
  std::size_t count = 0;
  for (const Pose& pose : poses) {
    if (!is_finite(pose)) continue;
    ++count;
    std::vector<glm::dquat> rotations;
    for (std::size_t j = 0; j < mesh.joint_count; ++j)
      rotations.push_back(quaternion_of(rotation_of(linear_of(pose[j]))));
    for (auto& [pair, sum] : pairs_)
      sum += std::min(1.0, std::abs(glm::dot(rotations[pair.first], rotations[pair.second])));
  }
  const Tree tree(parents);
  for (auto& [pair, sum] : pairs_) {
    sum = count > 0 ? sum / static_cast<double>(count) : kUnknown;
    for (std::size_t s = count > 0 ? tree.steps(pair.first, pair.second) : 0; s > 0; --s) sum *= kAStep;
  }
}

double Likeness::of(std::uint32_t i, std::uint32_t j) const {
  if (i == j) return 1;
  const auto found = pairs_.find({std::min(i, j), std::max(i, j)});
  return found == pairs_.end() ? kUnknown : found->second;
}

ClosedForm::ClosedForm(const SkinnedMesh& mesh, const std::vector<Helper>& helpers, const Likeness& likeness)
    : mesh_(mesh), helpers_(helpers) {
  for (std::uint32_t h = 0; h < helpers.size(); ++h) {
    const Helper& helper = helpers[h];
    const double s = helper.share;
    between_[std::minmax(helper.first, helper.second)].push_back(mesh.joint_count + h);
    cost_.push_back((1 - s) * (1 - s) + s * s + 2 * s * (1 - s) * likeness.of(helper.first, helper.second));
  }
}

std::vector<std::uint32_t> ClosedForm::entries_of(std::size_t v) const {
  const std::vector<Influence>& w = mesh_.influences[v];
  std::vector<std::uint32_t> out;
  for (const Influence& i : w) out.push_back(i.joint);
  for (std::size_t i = 0; i < w.size(); ++i)
    for (std::size_t j = i + 1; j < w.size(); ++j) {
      const auto found = between_.find({w[i].joint, w[j].joint});
      if (found != between_.end()) out.insert(out.end(), found->second.begin(), found->second.end());
    }
  std::ranges::sort(out);
  return out;
}

std::vector<Influence> ClosedForm::weights_of(std::size_t v) const {
  return weights_of(v, entries_of(v)).value_or(mesh_.influences[v]);
}

std::optional<std::vector<Influence>> ClosedForm::weights_of(std::size_t v,
                                                             std::span<const std::uint32_t> entries) const {
  const std::vector<Influence>& w = mesh_.influences[v];
  const auto place_of = [&](std::uint32_t joint) {
    return static_cast<std::size_t>(std::ranges::find(w, joint, &Influence::joint) - w.begin());
  };
  std::vector<Column> columns;
  for (std::size_t r = 0; r < w.size(); ++r)
    columns.push_back({w[r].joint, r, r, 0, std::ranges::binary_search(entries, w[r].joint) ? 1 : kForbidden});
  for (const std::uint32_t entry : entries) {
    if (entry < mesh_.joint_count) continue;
    const Helper& h = helpers_[entry - mesh_.joint_count];
    const std::size_t first = place_of(h.first), second = place_of(h.second);
    if (first == w.size() || second == w.size()) continue;
    columns.push_back({entry, first, second, h.share, cost_[entry - mesh_.joint_count]});
  }
  std::vector<Influence> out = solve(columns, w);
  for (const Influence& i : out)
    if (!std::ranges::binary_search(entries, i.joint)) return std::nullopt;
  return out;
}

std::vector<Coordinate> lift(const std::vector<Influence>& weights, const glm::dvec3& position) {
  std::vector<Coordinate> out;
  for (const Influence& i : weights) out.push_back({i.joint, glm::dvec4(position, 1) * i.weight});
  return out;
}

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
