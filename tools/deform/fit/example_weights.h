// Cardinal functions over a space of examples: P.-P. Sloan, C. Rose, M. Cohen, "Shape by example", I3D 2001, section 3.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace marrow::deform {

// weight_t(p) = linear[0][t] + Σ_d linear[1 + d][t] p_d + Σ_k radial[k][t] R(|p - place_k| · inverse_widths[k]), with R
// the cubic B-spline as in marrow/example_space.h.
struct ExampleFunctions {
  std::vector<std::vector<double>> linear;  // 1 + dimensions rows
  std::vector<std::vector<double>> radial;  // a row an example
  std::vector<float> inverse_widths;        // of the distance to the nearest other example
  std::size_t spanned = 0;                  // dimensions along which the examples differ
};

// places: of each example, at least 1e-6 apart. values: of each example what weight_t is there, as many in each.
// The linear part is the least-squares fit, about the mean of the examples; along what they do not span it is constant.
// The radial part is what is left at the examples. nullopt if their radial functions depend on one another.
std::optional<ExampleFunctions> solve_examples(const std::vector<std::vector<float>>& places,
                                               const std::vector<std::vector<double>>& values);

}  // namespace marrow::deform
