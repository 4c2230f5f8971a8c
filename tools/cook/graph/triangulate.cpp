#include "cook/graph/build_graph.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace marrow::cook {
namespace {

using Corners = std::array<std::uint32_t, 3>;

class Triangulation {
 public:
  explicit Triangulation(const std::vector<PlanePoint>& points) : p_(points) {}

  std::vector<PlaneTriangle> make() {
    std::vector<std::uint32_t> order(p_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
      return p_[a].x != p_[b].x ? p_[a].x < p_[b].x : p_[a].y < p_[b].y;
    });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (p_[order[i]].x == p_[order[i - 1]].x && p_[order[i]].y == p_[order[i - 1]].y) return {};
    std::size_t next = 2;
    while (next < order.size() && area(order[0], order[1], order[next]) == 0) ++next;
    if (next >= order.size()) return {};
    begin(order, next);
    for (++next; next < order.size(); ++next) add(order[next]);
    for (std::size_t round = 0; round < p_.size() * p_.size() && flip_one(); ++round) {
    }
    std::vector<PlaneTriangle> out;
    for (const Corners& t : triangles_) out.push_back({{t[0], t[1], t[2]}});
    return out;
  }

 private:
  // Twice it; above 0: counter-clockwise.
  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const double ax = static_cast<double>(p_[a].x), ay = static_cast<double>(p_[a].y);
    return (static_cast<double>(p_[b].x) - ax) * (static_cast<double>(p_[c].y) - ay) -
           (static_cast<double>(p_[b].y) - ay) * (static_cast<double>(p_[c].x) - ax);
  }

  // The first points are on a line, and the next one beside it.
  void begin(const std::vector<std::uint32_t>& order, std::size_t beside) {
    const bool is_left = area(order[0], order[1], order[beside]) > 0;
    for (std::size_t i = 0; i + 1 < beside; ++i)
      triangles_.push_back(is_left ? Corners{order[i], order[i + 1], order[beside]}
                                   : Corners{order[i + 1], order[i], order[beside]});
    hull_.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(beside));
    if (!is_left) std::ranges::reverse(hull_);
    hull_.push_back(order[beside]);
  }

  // A point beyond the hull: triangles to all edges that it sees, which follow one another.
  void add(std::uint32_t point) {
    std::vector<std::uint32_t> hull;
    const std::size_t count = hull_.size();
    const auto sees = [&](std::size_t i) { return area(hull_[i % count], hull_[(i + 1) % count], point) < 0; };
    std::size_t first = 0;
    while (first < count && !(sees(first) && !sees(first + count - 1))) ++first;
    if (first == count) return;  // rounding: it is on the hull
    std::size_t end = first;
    for (; end < first + count && sees(end); ++end)
      triangles_.push_back({hull_[(end + 1) % count], hull_[end % count], point});
    hull.push_back(hull_[first % count]);
    hull.push_back(point);
    for (std::size_t i = end; i % count != first % count; ++i) hull.push_back(hull_[i % count]);
    hull_ = std::move(hull);
  }

  // Whether d is within the circle through a, b, c, which are counter-clockwise.
  bool is_in_circle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) const {
    long double m[3][3];
    const std::uint32_t corners[3] = {a, b, c};
    long double size = 0;
    for (int i = 0; i < 3; ++i) {
      const long double x = static_cast<long double>(p_[corners[i]].x) - static_cast<long double>(p_[d].x);
      const long double y = static_cast<long double>(p_[corners[i]].y) - static_cast<long double>(p_[d].y);
      m[i][0] = x;
      m[i][1] = y;
      m[i][2] = x * x + y * y;
      size = std::max(size, m[i][2]);
    }
    const long double det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                            m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                            m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    return det > 1e-12L * size * size;
  }

  // The first edge whose two triangles would be better the other way; false: there is none.
  bool flip_one() {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (std::size_t j = i + 1; j < triangles_.size(); ++j)
        for (int e = 0; e < 3; ++e) {
          Corners &s = triangles_[i], &t = triangles_[j];
          const std::uint32_t a = s[static_cast<std::size_t>(e)], b = s[static_cast<std::size_t>((e + 1) % 3)],
                              c = s[static_cast<std::size_t>((e + 2) % 3)];
          for (int f = 0; f < 3; ++f) {
            const auto at = [&](int k) { return t[static_cast<std::size_t>((f + k) % 3)]; };
            if (at(0) != b || at(1) != a) continue;
            const std::uint32_t d = at(2);
            if (!is_in_circle(a, b, c, d) || !(area(d, b, c) > 0) || !(area(a, d, c) > 0)) continue;
            s = {d, b, c};
            t = {a, d, c};
            return true;
          }
        }
    return false;
  }

  const std::vector<PlanePoint>& p_;
  std::vector<Corners> triangles_;
  std::vector<std::uint32_t> hull_;  // counter-clockwise
};

}  // namespace

std::vector<PlaneTriangle> triangulate(const std::vector<PlanePoint>& points) {
  return Triangulation(points).make();
}

}  // namespace marrow::cook
