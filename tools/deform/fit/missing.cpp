#include "deform/fit/missing.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "common/parallel.h"
#include "deform/dense.h"

namespace marrow::deform {

Matrix blended(const std::vector<Influence>& influences, const Pose& pose) {
  Matrix sum(0.0);
  for (const Influence& i : influences) sum += pose[i.joint] * i.weight;
  return sum;
}

std::optional<glm::dvec3> correction(const Matrix& m, const glm::dvec3& missing) {
  constexpr double kLeastVolume = 1e-3;  // of that of a cube with the longest edge
  const glm::dmat3 linear = linear_of(m);
  const double edge = std::max({glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])});
  if (!(std::abs(glm::determinant(linear)) > kLeastVolume * edge * edge * edge)) return std::nullopt;
  return glm::inverse(linear) * missing;
}

double dot(const Positions& a, const Positions& b) {
  double out = 0;
  for (std::size_t v = 0; v < a.size(); ++v) out += glm::dot(a[v], b[v]);
  return out;
}

PrincipalFields principal_fields(const std::vector<Positions>& examples, std::size_t most) {
  constexpr double kLeastPart = 1e-14;  // of the first one's squares: rounding
  PrincipalFields out;
  out.coordinates.resize(examples.size());
  const std::size_t count = examples.size();
  if (count == 0) return out;
  Eigen::MatrixXd products(index(count), index(count));
  tools::for_each_in_parallel(count, [&](std::size_t a) {
    for (std::size_t b = 0; b <= a; ++b)
      products(index(a), index(b)) = products(index(b), index(a)) = dot(examples[a], examples[b]);
  });
  const Eigenvectors parts = eigenvectors_of_symmetric(products);
  for (std::size_t n = 0; n < std::min(most, count); ++n) {
    const Eigen::Index column = index(count - 1 - n);
    const double squares = parts.values[column];
    if (!(squares > kLeastPart * parts.values[index(count - 1)])) break;
    const double length = std::sqrt(squares);
    Positions& field = out.fields.emplace_back(examples.front().size(), glm::dvec3(0));
    for (std::size_t a = 0; a < count; ++a) {
      const double part = parts.vectors(index(a), column);
      for (std::size_t v = 0; v < field.size(); ++v) field[v] += examples[a][v] * (part / length);
      out.coordinates[a].push_back(part * length);
    }
  }
  return out;
}

}  // namespace marrow::deform
