#include "unpack/arrange.h"

#include <algorithm>

namespace marrow {
namespace {

struct JointLists {
  const std::int32_t* values = nullptr;  // null: everything follows one joint
  std::uint32_t most = 1;

  const std::int32_t* of(std::uint32_t vertex) const { return values + std::size_t{vertex} * most; }
  std::uint32_t count(std::uint32_t vertex) const {
    if (values == nullptr) return 1;
    const std::int32_t* const joints = of(vertex);
    std::uint32_t n = 1;
    while (n < most && joints[n] != joints[n - 1]) ++n;
    return n;
  }
  // A sort key: the number of joints, then the first four. Vertices that tie with five or more need compare_rest().
  std::uint64_t key(std::uint32_t vertex) const {
    if (values == nullptr) return 0;
    const std::uint32_t n = count(vertex);
    std::uint64_t key = n;
    for (std::uint32_t i = 0; i < 4; ++i) key = key << 15 | (i < n ? static_cast<std::uint32_t>(of(vertex)[i]) : 0u);
    return key;
  }
  // Compares the fifth and further joints: less than 0, 0 or more.
  std::int32_t compare_rest(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = 4; i < most; ++i)
      if (of(a)[i] != of(b)[i]) return of(a)[i] - of(b)[i];
    return 0;
  }
  bool same(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = 0; values != nullptr && i < most; ++i)
      if (of(a)[i] != of(b)[i]) return false;
    return true;
  }
};

JointLists joint_lists(const MeshStreams& mesh) {
  const Stream* const joints = mesh.find(StreamKind::joints);
  return joints == nullptr ? JointLists{} : JointLists{joints->values, joints->components};
}

// The passes of an arrangement. A pass goes on up to the element `end`.
class Arranging {
 public:
  Arranging(const MeshStreams& mesh, ArrangingInWork& work, Arrangement& out)
      : mesh_(mesh), joints_(joint_lists(mesh)), w_(work), out_(out) {}

  bool begin(Memory& scratch) {
    const std::uint64_t count = mesh_.vertex_count;
    out_.run_ends = scratch.take<std::uint32_t>(count).data;
    w_.stretch_of = scratch.take<std::uint32_t>(count).data;
    out_.order = scratch.take<std::uint32_t>(count).data;
    out_.slot_of_vertex = scratch.take<std::uint32_t>(2 * count).data;
    w_.low = out_.slot_of_vertex + count;
    return !scratch.failed;
  }
  void find_stretches(std::uint32_t end) {
    for (std::uint32_t v = w_.at; v < end; ++v) {
      if (v == 0 || !joints_.same(v, v - 1)) {
        const std::uint64_t key = joints_.key(v);
        high()[w_.stretch_count] = static_cast<std::uint32_t>(key >> 32);
        w_.low[w_.stretch_count] = static_cast<std::uint32_t>(key);
        sorted()[w_.stretch_count] = w_.stretch_count;
        first()[w_.stretch_count++] = v;
      }
      w_.stretch_of[v] = w_.stretch_count - 1;
    }
  }
  bool sort() {
    constexpr std::uint32_t kAtOnce = 1 << 15;
    return sort_some({sorted(), w_.stretch_count}, w_.sorting, kAtOnce, [&](std::uint32_t a, std::uint32_t b) {
      const std::int32_t different = compare(a, b);
      return different != 0 ? different < 0 : a < b;
    });
  }
  // Reuses memory: run_of overwrites keys that are not compared again, and runs' first places overwrite sorted().
  void find_runs(std::uint32_t end) {
    std::uint32_t* const run_of = w_.low;
    for (std::uint32_t s = w_.at; s < end; ++s) {
      const std::uint32_t stretch = sorted()[s], last = out_.run_count - 1;
      if (s == 0 || compare(w_.before, stretch) != 0) sorted()[out_.run_count++] = w_.first;
      if (s > 0) run_of[w_.before] = last;
      w_.before = stretch;
      w_.first += (stretch + 1 < w_.stretch_count ? first()[stretch + 1] : mesh_.vertex_count) - first()[stretch];
    }
    if (end == w_.stretch_count) run_of[w_.before] = out_.run_count - 1;
  }
  // slot_of_vertex is cleared; then fill() uses it to mark vertices as seen.
  void clear(std::uint32_t end) {
    for (std::uint32_t v = w_.at; v < end; ++v) out_.slot_of_vertex[v] = 0;
  }
  // Appends vertices to their runs in the order of their first use. Vertices that no triangle uses come last.
  void fill(std::uint32_t end) {
    const std::uint32_t corners = 3 * mesh_.triangle_count;
    for (std::uint32_t i = w_.at; i < end; ++i) {
      const std::uint32_t v = i < corners ? mesh_.indices[i] : i - corners;
      if (out_.slot_of_vertex[v] != 0) continue;
      out_.slot_of_vertex[v] = 1;
      out_.order[out_.run_ends[w_.low[w_.stretch_of[v]]]++] = v;
    }
  }
  // Gives a run's vertices their slots; returns the number of vertices.
  std::uint32_t place(std::uint32_t run) {
    const std::uint32_t begin = run > 0 ? out_.run_ends[run - 1] : 0, end = out_.run_ends[run];
    const std::uint32_t influences = joints_.count(out_.order[begin]), blocks = (end - begin + 3) / 4;
    for (std::uint32_t i = begin; i < end; ++i) out_.slot_of_vertex[out_.order[i]] = 4 * out_.block_count + i - begin;
    out_.set_count += influences;
    out_.influence_blocks += blocks * influences;
    out_.block_count += blocks;
    return end - begin;
  }

 private:
  // Until the runs are known, the output arrays hold stretches: sorted, their first vertices, and upper halves of keys.
  std::uint32_t* sorted() const { return out_.run_ends; }
  std::uint32_t* first() const { return out_.order; }
  std::uint32_t* high() const { return out_.slot_of_vertex; }
  // Less than 0, 0 or more.
  std::int32_t compare(std::uint32_t a, std::uint32_t b) const {
    if (high()[a] != high()[b]) return high()[a] < high()[b] ? -1 : 1;
    if (w_.low[a] != w_.low[b]) return w_.low[a] < w_.low[b] ? -1 : 1;
    return joints_.compare_rest(first()[a], first()[b]);
  }

  const MeshStreams& mesh_;
  JointLists joints_;
  ArrangingInWork& w_;
  Arrangement& out_;
};

}  // namespace

std::uint32_t influence_count(const MeshStreams& mesh, std::uint32_t vertex) {
  return joint_lists(mesh).count(vertex);
}

bool arrange(const MeshStreams& mesh, Memory& scratch, ArrangingInWork& work, Arrangement& out, std::uint32_t& left) {
  using Place = ArrangingInWork::Place;
  Arranging it(mesh, work, out);
  if (work.place == Place::beginning) {
    if (!it.begin(scratch)) return false;
    work.place = Place::stretches;
  }
  while (left > 0 && work.place != Place::done) {
    const std::uint32_t counts[] = {0,
                                    mesh.vertex_count,
                                    0,
                                    work.stretch_count,
                                    mesh.vertex_count,
                                    3 * mesh.triangle_count + mesh.vertex_count,
                                    out.run_count};
    const std::uint32_t count = counts[static_cast<std::size_t>(work.place)], end = step_end(work.at, count, left);
    bool done = end == count;
    std::uint32_t used = end - work.at;
    if (work.place == Place::stretches) it.find_stretches(end);
    if (work.place == Place::runs) it.find_runs(end);
    if (work.place == Place::clearing) it.clear(end);
    if (work.place == Place::filling) it.fill(end);
    work.at = end;
    if (work.place == Place::sorting) {
      done = it.sort();
      used = done ? work.stretch_count * 4 : left;
    } else if (work.place == Place::placing) {
      work.at -= used;
      for (used = 0; work.at < count && used < left; ++work.at) used += it.place(work.at);
      done = work.at == count;
    }
    use_up(used, left);
    if (!done) continue;
    work.at = 0;
    work.place = static_cast<Place>(static_cast<std::uint8_t>(work.place) + 1);
  }
  return true;
}

bool arrange(const MeshStreams& mesh, Memory& scratch, Arrangement& out) {
  ArrangingInWork work;
  while (work.place != ArrangingInWork::Place::done) {
    std::uint32_t left = UINT32_MAX;
    if (!arrange(mesh, scratch, work, out, left)) return false;
  }
  return true;
}

}  // namespace marrow
