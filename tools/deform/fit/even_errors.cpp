#include "deform/fit/even_errors.h"

#include <glm/geometric.hpp>

#include "common/parallel.h"

namespace marrow::deform {
namespace {

constexpr int kRounds = 8;
constexpr auto kOfNeighbours = static_cast<float>(1 - kOfOwn);
constexpr double kMostFarther = 1.15;

using Errors = std::vector<glm::vec3>;

// In diagonals.
Errors errors_of(const Coordinates& coordinates, const Example& example, const Errors& truth, double diagonal_m) {
  Errors out(coordinates.size());
  for (std::size_t v = 0; v < out.size(); ++v) {
    glm::dvec3 at(0);
    for (const Coordinate& c : coordinates[v]) at += example.at->pose[c.joint] * c.q;
    out[v] = glm::vec3(at / diagonal_m - example.centre - glm::dvec3(truth[v]));
  }
  return out;
}

glm::vec3 mean_of_neighbours(const Surface& surface, std::size_t v, const Errors& errors) {
  const auto around = surface.neighbours(v);
  const auto weights = surface.weights(v);
  glm::vec3 out(0);
  for (std::size_t i = 0; i < around.size(); ++i) out += errors[around[i]] * static_cast<float>(weights[i]);
  return out;
}

}  // namespace

void even_errors(const Surface& surface, const std::function<Coordinates()>& solve, Training& training,
                 Coordinates& fitted) {
  const std::size_t count = training.motion.first;  // of the poses that are learnt
  std::vector<Errors> truths;
  for (std::size_t e = 0; e < count; ++e) truths.push_back(training.examples[e].truth);
  const auto squares_of = [&](const Coordinates& coordinates) {
    std::vector<double> squares(count, 0);
    tools::for_each_in_parallel(count, [&](std::size_t e) {
      for (const glm::vec3& error : errors_of(coordinates, training.examples[e], truths[e], training.diagonal_m))
        squares[e] += static_cast<double>(glm::dot(error, error));
    });
    double out = 0;
    for (const double s : squares) out += s;
    return out;
  };
  Coordinates now = fitted;
  for (int round = 0; round < kRounds; ++round) {
    tools::for_each_in_parallel(count, [&](std::size_t e) {
      Example& example = training.examples[e];
      const Errors errors = errors_of(now, example, truths[e], training.diagonal_m);
      for (std::size_t v = 0; v < errors.size(); ++v)
        example.truth[v] = truths[e][v] + mean_of_neighbours(surface, v, errors) * kOfNeighbours;
    });
    now = solve();
  }
  for (std::size_t e = 0; e < count; ++e) training.examples[e].truth = truths[e];
  if (squares_of(now) <= kMostFarther * kMostFarther * squares_of(fitted)) fitted = std::move(now);
}

}  // namespace marrow::deform
