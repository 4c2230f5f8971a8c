#include "cook/geometry/owned_streams.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "unpack/entry_set.h"

namespace marrow::cook {
namespace {

using Set = std::vector<std::int32_t>;

struct AlikeVertices {
  Set set;
  std::size_t vertices = 0;
  std::size_t partner = 0;    // with which most is saved
  std::ptrdiff_t saving = 0;  // 0: it stays as it is
};

// In units of some 37 instructions of skin_ssd: a matrix costs a block as much as it costs to set it up, and the
// branches of a run a bit more than that.
std::ptrdiff_t cost(std::size_t vertices, std::size_t influences) {
  constexpr std::size_t kOfRun = 1;
  return static_cast<std::ptrdiff_t>(influences * ((vertices + 3) / 4 + 1) + kOfRun);
}

Set union_of(const Set& a, const Set& b) {
  Set out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

// Of two sets; asked of every pair.
std::size_t size_of_union(const Set& a, const Set& b) {
  std::size_t size = a.size() + b.size();
  for (auto x = a.begin(), y = b.begin(); x != a.end() && y != b.end();) {
    const std::int32_t joint = *x, other = *y;
    size -= joint == other ? 1u : 0u;
    x += joint <= other ? 1 : 0;
    y += other <= joint ? 1 : 0;
  }
  return size;
}

// Of sets with one last joint.
class Merging {
 public:
  Merging(std::vector<AlikeVertices> runs, std::size_t most_influences)
      : runs_(std::move(runs)), most_(most_influences) {
    for (std::size_t i = 0; i < runs_.size(); ++i) find_partner(i);
  }

  // Whatever saves most, until nothing does.
  void run() {
    while (!runs_.empty()) {
      const auto best = std::ranges::max_element(runs_, {}, &AlikeVertices::saving);
      if (best->saving <= 0) return;
      merge(static_cast<std::size_t>(best - runs_.begin()), best->partner);
    }
  }
  // The set that contains this one; one of those that there are now.
  const Set& home_of(const Set& set) const {
    const Set* home = &set;
    for (auto at = homes_.find(*home); at != homes_.end(); at = homes_.find(*home)) home = &at->second;
    return *home;
  }

 private:
  std::ptrdiff_t saving(const AlikeVertices& a, const AlikeVertices& b) const {
    const std::size_t influences = size_of_union(a.set, b.set);
    if (influences > most_) return 0;
    return cost(a.vertices, a.set.size()) + cost(b.vertices, b.set.size()) - cost(a.vertices + b.vertices, influences);
  }
  void find_partner(std::size_t i) {
    runs_[i].saving = 0;
    for (std::size_t j = 0; j < runs_.size(); ++j) {
      const std::ptrdiff_t s = i == j || runs_[j].vertices == 0 ? 0 : saving(runs_[i], runs_[j]);
      if (s <= runs_[i].saving) continue;
      runs_[i].saving = s;
      runs_[i].partner = j;
    }
  }
  // One of them is left without vertices.
  void merge(std::size_t i, std::size_t j) {
    const Set both = union_of(runs_[i].set, runs_[j].set);
    for (const std::size_t k : {i, j})
      if (runs_[k].set != both) homes_[runs_[k].set] = both;
    runs_[i].set = both;
    runs_[i].vertices += runs_[j].vertices;
    runs_[j] = {};
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      if (runs_[k].vertices == 0) continue;
      if (k == i || runs_[k].partner == i || runs_[k].partner == j) find_partner(k);
      const std::ptrdiff_t s = k == i ? 0 : saving(runs_[k], runs_[i]);
      if (s > runs_[k].saving) {
        runs_[k].saving = s;
        runs_[k].partner = i;
      }
    }
  }

  std::vector<AlikeVertices> runs_;
  std::size_t most_;
  std::map<Set, Set> homes_;
};

EntrySet set_of(const OwnedStreams& s, const std::vector<std::int32_t>& joints, std::size_t v) {
  return read_set(&joints[v * s.mesh.influences], s.mesh.influences);
}
Set joints_of(const EntrySet& set) {
  return {set.joints, set.joints + set.count};
}

// From each set the one that it becomes; not those that stay.
std::map<Set, Set> merged_sets(const OwnedStreams& s, const std::vector<std::int32_t>& joints) {
  std::map<Set, std::size_t> counts;
  for (std::size_t v = 0; v < s.mesh.vertex_count; ++v) ++counts[joints_of(set_of(s, joints, v))];
  std::map<std::int32_t, std::vector<AlikeVertices>> by_last;
  for (const auto& [set, count] : counts) by_last[set.back()].push_back({set, count});
  std::map<Set, Set> out;
  for (const auto& [last, runs] : by_last) {
    Merging merging(runs, s.mesh.influences);
    merging.run();
    for (const AlikeVertices& r : runs)
      if (const Set& home = merging.home_of(r.set); home != r.set) out.emplace(r.set, home);
  }
  return out;
}

// A vertex's place among the joints of its new set for each of the old; those between have nothing.
std::vector<std::size_t> places_in(const Set& home, const EntrySet& set) {
  std::vector<std::size_t> out;
  for (std::uint32_t j = 0; j < set.count; ++j)
    out.push_back(static_cast<std::size_t>(std::ranges::find(home, set.joints[j]) - home.begin()));
  return out;
}

// Moves what the influences have, `width` numbers each, to their places, which ascend. at(j): those of influence j.
template <class At>
void spread(const std::vector<std::size_t>& places, std::size_t count, std::size_t width, std::int32_t nothing,
            const At& at) {
  for (std::size_t j = count; j-- > 0 && places[j] != j;) {
    std::copy_n(at(j), width, at(places[j]));
    std::fill_n(at(j), width, nothing);
  }
}

void move_vertex(std::size_t v, const EntrySet& set, const Set& home, OwnedStreams& s) {
  const std::vector<std::size_t> places = places_in(home, set);
  std::size_t first[2] = {};  // streams of an influence each: residuals, multi-weights
  for (std::size_t i = s.streams.size(); i-- > 0;) {
    if (s.streams[i].kind == StreamKind::residual) first[0] = i;
    if (s.streams[i].kind == StreamKind::multi_weight) first[1] = i;
  }
  const auto weights =
      s.values_of(StreamKind::weights)->begin() + static_cast<std::ptrdiff_t>(v * (s.mesh.influences - 1));
  spread(places, set.count - 1, 1, 0, [&](std::size_t j) { return weights + static_cast<std::ptrdiff_t>(j); });
  for (const std::size_t of : first) {
    if (of == 0) continue;  // the first stream of all are positions
    const Stream& stream = s.streams[of];
    spread(places, set.count, stream.components, stream.bits == 0 ? 0 : 1 << (stream.bits - 1), [&](std::size_t j) {
      return s.values[of + j].begin() + static_cast<std::ptrdiff_t>(v * stream.components);
    });
  }
  EntrySet out;
  for (const std::int32_t joint : home) out.add(joint);
  write_set(out, s.mesh.influences, &(*s.values_of(StreamKind::joints))[v * s.mesh.influences]);
}

}  // namespace

void merge_runs(OwnedStreams& s) {
  const std::vector<std::int32_t>* const joints = s.values_of(StreamKind::joints);
  if (joints == nullptr || s.mesh.influences < 2) return;
  const std::map<Set, Set> homes = merged_sets(s, *joints);
  for (std::size_t v = 0; v < s.mesh.vertex_count; ++v) {
    const EntrySet set = set_of(s, *joints, v);
    if (const auto home = homes.find(joints_of(set)); home != homes.end()) move_vertex(v, set, home->second, s);
  }
}

}  // namespace marrow::cook
