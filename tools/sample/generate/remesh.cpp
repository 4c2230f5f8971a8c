// Isotropic remeshing: split long edges, collapse short ones, flip for even valence, relax along the surface.
#include <algorithm>
#include <cmath>
#include <utility>

#include "isosurface.h"

namespace marrow::sample {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;
constexpr std::uint32_t kNone = ~0u;

class Remesher {
 public:
  Remesher(const Shape& shape, Surface& half) : shape_(shape), p_(half.positions), t_(half.triangles) {
    around_.resize(p_.size());
    for (std::uint32_t i = 0; i < t_.size(); ++i) {
      for (std::uint32_t v : t_[i]) around_[v].push_back(i);
    }
    for (const glm::vec3& p : p_) wanted_.push_back(shape_.edge_length(p));
  }

  void round() {
    split_long();
    collapse_short();
    flip_for_valence();
    relax();
  }

  // Drops what collapsing left behind.
  void compact() {
    std::vector<std::uint32_t> fresh(p_.size(), kNone);
    std::vector<glm::vec3> kept;
    std::vector<Triangle> triangles;
    for (const Triangle& t : t_) {
      if (t[0] == kNone) continue;
      Triangle renamed{};
      for (std::size_t i = 0; i < 3; ++i) {
        if (fresh[t[i]] == kNone) {
          fresh[t[i]] = static_cast<std::uint32_t>(kept.size());
          kept.push_back(p_[t[i]]);
        }
        renamed[i] = fresh[t[i]];
      }
      triangles.push_back(renamed);
    }
    p_ = std::move(kept);
    t_ = std::move(triangles);
  }

 private:
  bool on_seam(std::uint32_t v) const { return p_[v].x == 0; }
  float length(Edge e) const { return glm::distance(p_[e.first], p_[e.second]); }
  float wanted(Edge e) const { return (wanted_[e.first] + wanted_[e.second]) * .5f; }

  std::vector<Edge> edges() const {
    std::vector<Edge> all;
    for (const Triangle& t : t_) {
      if (t[0] == kNone) continue;
      for (std::size_t i = 0; i < 3; ++i) all.emplace_back(std::minmax(t[i], t[(i + 1) % 3]));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  std::vector<std::uint32_t> triangles_on(Edge e) const {
    std::vector<std::uint32_t> both;
    for (std::uint32_t i : around_[e.first]) {
      if (std::find(t_[i].begin(), t_[i].end(), e.second) != t_[i].end()) both.push_back(i);
    }
    return both;
  }

  std::vector<std::uint32_t> neighbours(std::uint32_t v) const {
    std::vector<std::uint32_t> list;
    for (std::uint32_t i : around_[v]) {
      for (std::uint32_t other : t_[i]) {
        if (other != v) list.push_back(other);
      }
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  std::uint32_t opposite(std::uint32_t triangle, Edge e) const {
    for (std::uint32_t v : t_[triangle]) {
      if (v != e.first && v != e.second) return v;
    }
    return kNone;
  }

  void unlink(std::uint32_t v, std::uint32_t triangle) { std::erase(around_[v], triangle); }

  glm::vec3 project(glm::vec3 p, bool seam) const {
    p = shape_.project(p);
    if (seam) p.x = 0;
    return p;
  }

  void split_long() {
    for (const Edge& e : edges()) {
      if (length(e) <= wanted(e) * 1.35f) continue;
      const auto both = triangles_on(e);
      const bool seam = both.size() == 1;
      const auto middle = static_cast<std::uint32_t>(p_.size());
      p_.push_back(project((p_[e.first] + p_[e.second]) * .5f, seam));
      if (!seam) p_[middle].x = std::max(p_[middle].x, 1e-4f);
      wanted_.push_back(shape_.edge_length(p_[middle]));
      around_.emplace_back();
      for (std::uint32_t i : both) {
        const auto added = static_cast<std::uint32_t>(t_.size());
        Triangle other = t_[i];
        std::replace(other.begin(), other.end(), e.first, middle);
        std::replace(t_[i].begin(), t_[i].end(), e.second, middle);
        t_.push_back(other);
        unlink(e.second, i);
        around_[e.second].push_back(added);
        around_[opposite(added, {middle, e.second})].push_back(added);
        around_[middle].push_back(i);
        around_[middle].push_back(added);
      }
    }
  }

  void collapse_short() {
    std::vector<std::pair<float, Edge>> queue;
    for (const Edge& e : edges()) {
      if (length(e) < wanted(e) * .8f) queue.emplace_back(length(e) / wanted(e), e);
    }
    std::sort(queue.begin(), queue.end());
    for (const auto& [ratio, e] : queue) {
      if (around_[e.first].empty() || around_[e.second].empty() || length(e) >= wanted(e) * .8f) continue;
      try_collapse(e);
    }
  }

  void try_collapse(Edge e) {
    const auto both = triangles_on(e);
    if (both.empty()) return;
    const bool a_seam = on_seam(e.first), b_seam = on_seam(e.second);
    if (a_seam && b_seam && both.size() == 2) return;  // would pinch the seam
    const auto na = neighbours(e.first), nb = neighbours(e.second);
    std::vector<std::uint32_t> shared;
    std::set_intersection(na.begin(), na.end(), nb.begin(), nb.end(), std::back_inserter(shared));
    if (shared.size() != both.size()) return;  // would fold the surface onto itself
    glm::vec3 target = (p_[e.first] + p_[e.second]) * .5f;
    if (a_seam != b_seam) {
      target = p_[a_seam ? e.first : e.second];
    } else {
      target = project(target, a_seam);
      if (!a_seam) target.x = std::max(target.x, 1e-4f);
    }
    if (!can_move(e.first, e.second, target) || !can_move(e.second, e.first, target)) return;
    for (std::uint32_t i : both) {
      for (std::uint32_t v : Triangle(t_[i])) unlink(v, i);
      t_[i] = {kNone, kNone, kNone};
    }
    for (std::uint32_t i : around_[e.second]) {
      std::replace(t_[i].begin(), t_[i].end(), e.second, e.first);
      around_[e.first].push_back(i);
    }
    around_[e.second].clear();
    p_[e.first] = target;
    wanted_[e.first] = shape_.edge_length(target);
  }

  // Whether `v` may go to `target` when the triangles shared with `gone` vanish: nothing turns over or gets long.
  bool can_move(std::uint32_t v, std::uint32_t gone, glm::vec3 target) const {
    for (std::uint32_t i : around_[v]) {
      const Triangle& t = t_[i];
      if (std::find(t.begin(), t.end(), gone) != t.end()) continue;
      std::array<glm::vec3, 3> q;
      for (std::size_t k = 0; k < 3; ++k) {
        q[k] = t[k] == v ? target : p_[t[k]];
        if (t[k] != v && glm::distance(target, p_[t[k]]) > 1.3f * wanted_[t[k]]) return false;
      }
      const glm::vec3 before = glm::cross(p_[t[1]] - p_[t[0]], p_[t[2]] - p_[t[0]]);
      const glm::vec3 after = glm::cross(q[1] - q[0], q[2] - q[0]);
      if (glm::dot(before, after) < .3f * glm::length(before) * glm::length(after)) return false;
    }
    return true;
  }

  void flip_for_valence() {
    for (const Edge& e : edges()) {
      const auto both = triangles_on(e);
      if (both.size() == 2) try_flip(e, both[0], both[1]);
    }
  }

  int valence_error(std::uint32_t v, int change) const {
    const int ideal = on_seam(v) ? 3 : 6;  // triangles; the seam sees only its half
    const int error = static_cast<int>(around_[v].size()) + change - ideal;
    return error * error;
  }

  void try_flip(Edge e, std::uint32_t first, std::uint32_t second) {
    const auto [a, b] = e;
    const std::uint32_t c = opposite(first, e), d = opposite(second, e);
    const auto nc = neighbours(c);
    if (c == d || std::binary_search(nc.begin(), nc.end(), d) || (on_seam(c) && on_seam(d))) return;
    const int before = valence_error(a, 0) + valence_error(b, 0) + valence_error(c, 0) + valence_error(d, 0);
    const int after = valence_error(a, -1) + valence_error(b, -1) + valence_error(c, 1) + valence_error(d, 1);
    if (after >= before || around_[a].size() <= 3 || around_[b].size() <= 3) return;
    Triangle one = t_[first], two = t_[second];
    std::replace(one.begin(), one.end(), b, d);
    std::replace(two.begin(), two.end(), a, c);
    const glm::vec3 old = normal(t_[first]) + normal(t_[second]);
    const glm::vec3 n1 = normal(one), n2 = normal(two);
    if (glm::dot(n1, n2) < .5f || glm::dot(n1, old) < 1.0f || glm::dot(n2, old) < 1.0f) return;
    t_[first] = one;
    t_[second] = two;
    unlink(b, first);
    unlink(a, second);
    around_[d].push_back(first);
    around_[c].push_back(second);
  }

  glm::vec3 normal(const Triangle& t) const {
    const glm::vec3 n = glm::cross(p_[t[1]] - p_[t[0]], p_[t[2]] - p_[t[0]]);
    return n / std::max(glm::length(n), 1e-12f);
  }

  void relax() {
    std::vector<glm::vec3> next = p_;
    for (std::uint32_t v = 0; v < p_.size(); ++v) {
      if (around_[v].empty()) continue;
      const bool seam = on_seam(v);
      glm::vec3 sum(0);
      float total = 0;
      for (std::uint32_t other : neighbours(v)) {
        if (seam && (!on_seam(other) || triangles_on({v, other}).size() != 1)) continue;
        const float weight = 1.0f / wanted_[other];
        sum += p_[other] * weight;
        total += weight;
      }
      if (total == 0) continue;
      const glm::vec3 n = glm::normalize(shape_.gradient(p_[v]));
      const glm::vec3 step = sum / total - p_[v];
      next[v] = project(p_[v] + (step - n * glm::dot(step, n)) * .7f, seam);
      if (!seam) next[v].x = std::max(next[v].x, 1e-4f);
    }
    p_ = std::move(next);
    for (std::uint32_t v = 0; v < p_.size(); ++v) {
      if (!around_[v].empty()) wanted_[v] = shape_.edge_length(p_[v]);
    }
  }

  const Shape& shape_;
  std::vector<glm::vec3>& p_;
  std::vector<Triangle>& t_;
  std::vector<std::vector<std::uint32_t>> around_;  // vertex -> triangles
  std::vector<float> wanted_;
};

}  // namespace

void remesh_half(const Shape& shape, Surface& half, int rounds) {
  Remesher remesher(shape, half);
  for (int i = 0; i < rounds; ++i) remesher.round();
  remesher.compact();
}

}  // namespace marrow::sample
