#include "deform/weights/edit_weights.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "common/parallel.h"
#include "deform/surface.h"
#include "deform/weights/auto_weights.h"
#include "deform/weights/places.h"

namespace marrow::deform {

bool set_weights(std::span<const Influence> given, std::size_t most, std::vector<Influence>& influences) {
  const auto is_given = [&](const Influence& i) {
    return std::ranges::any_of(given, [&](const Influence& g) { return g.joint == i.joint; });
  };
  double sum = 0, rest = 0;
  for (const Influence& g : given) sum += g.weight;
  for (const Influence& i : influences)
    if (!is_given(i)) rest += i.weight;
  if (rest <= 0 && sum <= 0) return false;
  std::vector<Influence> out(given.begin(), given.end());
  for (const Influence& i : influences)
    if (!is_given(i) && rest > 0 && sum < 1) out.push_back({i.joint, i.weight / rest * (1 - sum)});
  keep_largest(out, most, 0);
  influences = std::move(out);
  return true;
}

namespace {

constexpr double kStep = 0.5;
constexpr std::size_t kMostOnTheWay = 32;  // influences of a vertex between steps; the rest is too small to matter
constexpr double kLeastOnTheWay = 1e-6;
constexpr std::size_t kChunk = 1024;  // vertices that a thread takes at a time

using Influences = std::vector<std::vector<Influence>>;

// Adds up what names a joint twice.
void merge(std::vector<Influence>& influences) {
  std::stable_sort(influences.begin(), influences.end(),
                   [](const Influence& a, const Influence& b) { return a.joint < b.joint; });
  std::size_t count = 0;
  for (const Influence& i : influences) {
    if (count > 0 && influences[count - 1].joint == i.joint) {
      influences[count - 1].weight += i.weight;
    } else {
      influences[count++] = i;
    }
  }
  influences.erase(influences.begin() + static_cast<std::ptrdiff_t>(count), influences.end());
  keep_largest(influences, kMostOnTheWay, kLeastOnTheWay);
}

void add(const std::vector<Influence>& from, double share, std::vector<Influence>& to) {
  for (const Influence& i : from) to.push_back({i.joint, i.weight * share});
}

void step(const Surface& surface, const Influences& from, Influences& to) {
  tools::for_each_in_parallel((from.size() + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    for (std::size_t v = chunk * kChunk; v < std::min(from.size(), (chunk + 1) * kChunk); ++v) {
      const auto neighbours = surface.neighbours(v);
      const auto shares = surface.weights(v);
      to[v].clear();
      add(from[v], neighbours.empty() ? 1.0 : 1.0 - kStep, to[v]);
      for (std::size_t i = 0; i < neighbours.size(); ++i) add(from[neighbours[i]], shares[i] * kStep, to[v]);
      merge(to[v]);
    }
  });
}

}  // namespace

void smooth_weights(const Positions& positions, std::span<const std::uint32_t> indices, int steps,
                    std::vector<std::vector<Influence>>& influences) {
  const Places places = places_of(positions);
  SkinnedMesh mesh;
  mesh.positions = places.positions;
  mesh.indices = indices_of(places, indices);
  Influences now(places.positions.size()), next(places.positions.size());
  for (std::size_t v = 0; v < positions.size(); ++v) {
    keep_largest(influences[v], influences[v].size(), 0);
    add(influences[v], 1, now[places.of_vertex[v]]);
  }
  for (std::vector<Influence>& place : now) merge(place);
  const Surface surface(mesh);
  for (int i = 0; i < steps; ++i) {
    step(surface, now, next);
    now.swap(next);
  }
  for (std::size_t v = 0; v < positions.size(); ++v) influences[v] = now[places.of_vertex[v]];
}

}  // namespace marrow::deform
