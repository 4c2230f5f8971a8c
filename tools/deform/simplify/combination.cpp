#include "deform/simplify/combination.h"

#include <map>

namespace marrow::deform {

Combination blend(const Combination& a, const Combination& b, double t) {
  if (t <= 0) return a;
  if (t >= 1) return b;
  Combination out;
  std::size_t i = 0, k = 0;
  while (i < a.size() || k < b.size()) {
    const bool from_a = k == b.size() || (i < a.size() && a[i].vertex <= b[k].vertex);
    const bool from_b = i == a.size() || (k < b.size() && b[k].vertex <= a[i].vertex);
    Share share{from_a ? a[i].vertex : b[k].vertex, 0};
    if (from_a) share.share += (1 - t) * a[i++].share;
    if (from_b) share.share += t * b[k++].share;
    out.push_back(share);
  }
  return out;
}

std::vector<Coordinate> combined(const Combination& shares, const Coordinates& coordinates) {
  std::map<std::uint32_t, glm::dvec4> sum;
  for (const Share& s : shares)
    for (const Coordinate& c : coordinates[s.vertex])
      sum.try_emplace(c.joint, glm::dvec4(0)).first->second += c.q * s.share;
  std::vector<Coordinate> out;
  for (const auto& [joint, q] : sum) out.push_back({joint, q});
  return out;
}

}  // namespace marrow::deform
