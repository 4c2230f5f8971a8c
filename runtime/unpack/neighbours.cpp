#include "unpack/neighbours.h"

#include <algorithm>

namespace marrow {
namespace {

// Compares two vertices by position, joints and weights: less than 0, 0 or more.
std::int32_t compare(const Stream* const (&streams)[3], std::uint32_t a, std::uint32_t b) {
  for (const Stream* const s : streams) {
    const std::int32_t *const x = s->values + std::size_t{a} * s->components, *const y = s->values +
                                                                                         std::size_t{b} * s->components;
    for (std::uint32_t c = 0; c < s->components; ++c)
      if (x[c] != y[c]) return x[c] < y[c] ? -1 : 1;
  }
  return 0;
}

// The passes of a search. A pass goes on up to the element `end`.
class Search {
 public:
  Search(const MeshStreams& mesh, NeighboursInWork& work, MeshNeighbours& out)
      : mesh_(mesh),
        w_(work),
        out_(out),
        streams_{mesh.find(StreamKind::position), mesh.find(StreamKind::joints), mesh.find(StreamKind::weights)} {}

  bool begin(Memory& memory) {
    const std::uint32_t count = mesh_.vertex_count;
    out_.leader = memory.take<std::uint32_t>(count).data;
    out_.first = memory.take<std::uint32_t>(count).data;
    out_.count = memory.take<std::uint32_t>(count).data;
    out_.scratch = memory.take<std::uint32_t>(count).data;
    out_.scratch_2 = memory.take<std::uint32_t>(count).data;
    out_.is_inside = memory.take<std::uint8_t>(count).data;
    out_.all = memory.take<std::uint32_t>(std::uint64_t{mesh_.triangle_count} * 6).data;
    return !memory.failed;
  }
  void number(std::uint32_t end) {
    for (std::uint32_t v = w_.at; v < end; ++v) {
      out_.scratch[v] = v;
      out_.count[v] = 0;
    }
  }
  bool sort() {
    constexpr std::uint32_t kAtOnce = 1 << 13;
    return sort_some({out_.scratch, mesh_.vertex_count}, w_.sorting, kAtOnce, [&](std::uint32_t a, std::uint32_t b) {
      const std::int32_t different = compare(streams_, a, b);
      return different != 0 ? different < 0 : a < b;
    });
  }
  void lead(std::uint32_t end) {
    const std::uint32_t* const order = out_.scratch;
    for (std::uint32_t i = w_.at; i < end; ++i) {
      const bool same = i > 0 && compare(streams_, order[i], order[i - 1]) == 0;
      out_.leader[order[i]] = same ? out_.leader[order[i - 1]] : order[i];
    }
  }
  void count(std::uint32_t end) {
    for_each_side(end, [&](std::uint32_t v, std::uint32_t) { ++out_.count[v]; });
  }
  void sum(std::uint32_t end) {
    for (std::uint32_t v = w_.at; v < end; ++v) {
      out_.first[v] = w_.sum;
      w_.sum += out_.count[v];
      out_.count[v] = 0;
    }
  }
  void fill(std::uint32_t end) {
    for_each_side(end,
                  [&](std::uint32_t v, std::uint32_t other) { out_.all[out_.first[v] + out_.count[v]++] = other; });
  }
  void mark(std::uint32_t end) {
    for (std::uint32_t v = w_.at; v < end; ++v) out_.scratch[v] = UINT32_MAX;
  }
  // Removes repeats from a row. A neighbour occurs once for each triangle of the edge to it. Returns the old length.
  std::uint32_t thin(std::uint32_t v) {
    std::uint32_t *const seen_by = out_.scratch, *const times = out_.scratch_2;
    std::uint32_t* const row = out_.all + out_.first[v];
    const std::uint32_t all = out_.count[v];
    std::uint32_t distinct = 0;
    for (std::uint32_t i = 0; i < all; ++i) {
      const std::uint32_t other = row[i];
      if (seen_by[other] != v) {
        seen_by[other] = v;
        times[other] = 0;
        row[distinct++] = other;
      }
      ++times[other];
    }
    out_.count[v] = distinct;
    bool inside = distinct > 0;
    for (std::uint32_t i = 0; i < distinct; ++i) inside = inside && times[row[i]] == 2;
    out_.is_inside[v] = inside ? 1 : 0;
    return all;
  }

 private:
  // Calls f(corner, another corner) for all six pairs of each triangle up to `end` whose corners are different leaders.
  template <class F>
  void for_each_side(std::uint32_t end, const F& f) {
    for (std::uint32_t t = w_.at; t < end; ++t) {
      const std::uint32_t* const i = mesh_.indices + std::size_t{t} * 3;
      const std::uint32_t a = out_.leader[i[0]], b = out_.leader[i[1]], c = out_.leader[i[2]];
      if (a == b || b == c || c == a) continue;
      f(a, b), f(a, c), f(b, c), f(b, a), f(c, a), f(c, b);
    }
  }

  const MeshStreams& mesh_;
  NeighboursInWork& w_;
  MeshNeighbours& out_;
  const Stream* const streams_[3];
};

}  // namespace

bool find_neighbours(const MeshStreams& mesh, Memory& memory, NeighboursInWork& work, MeshNeighbours& out,
                     std::uint32_t& left) {
  using Place = NeighboursInWork::Place;
  Search it(mesh, work, out);
  if (work.place == Place::beginning) {
    if (!it.begin(memory)) return false;
    work.place = Place::numbering;
  }
  while (left > 0 && work.place != Place::done) {
    const bool triangles = work.place == Place::counting || work.place == Place::filling;
    const std::uint32_t count = triangles ? mesh.triangle_count : mesh.vertex_count;
    const std::uint32_t end = step_end(work.at, count, left);
    std::uint32_t used = end - work.at;
    bool done = end == count;
    if (work.place == Place::sorting) {
      done = it.sort();
      used = done ? 4 * count : left;
    } else if (work.place == Place::thinning) {
      for (used = 0; work.at < count && used < left; ++work.at) used += 1 + it.thin(work.at) / 4;
      done = work.at == count;
    } else {
      if (work.place == Place::numbering) it.number(end);
      if (work.place == Place::leading) it.lead(end);
      if (work.place == Place::counting) it.count(end);
      if (work.place == Place::summing) it.sum(end);
      if (work.place == Place::filling) it.fill(end);
      if (work.place == Place::marking) it.mark(end);
      work.at = end;
    }
    use_up(used, left);
    if (!done) continue;
    work.at = 0;
    work.place = static_cast<Place>(static_cast<std::uint8_t>(work.place) + 1);
  }
  return true;
}

}  // namespace marrow
