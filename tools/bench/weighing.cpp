// The rows skin/examples/EXAMPLES/PARAMETERS: weights of morph targets at 1024 points of a space, one an iteration.
#include <cmath>
#include <limits>

#include "bench/workload.h"
#include "common/check_status.h"
#include "marrow/example_space.h"

namespace marrow::tools {
namespace {

constexpr std::uint32_t kExamples[] = {8, 16, 64};
constexpr std::uint32_t kParameters[] = {2, 6};
constexpr std::uint32_t kPoints = 1024;

// Examples and points of noise between -1 and 1, a target an example.
class Weighing : public Workload {
 public:
  Weighing(std::uint32_t examples, std::uint32_t parameters) : parameters_(parameters), weights_(examples) {
    Noise noise;
    const auto fill = [&](std::vector<float>& to, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) to.push_back(noise.between(-1, 1));
    };
    fill(places_, std::size_t{examples} * parameters);
    fill(linear_, (parameters + 1) * std::size_t{examples});
    fill(radial_, std::size_t{examples} * examples);
    fill(points_, std::size_t{kPoints} * parameters);
    for (std::uint32_t k = 0; k < examples; ++k) widths_.push_back(1 / nearest(k));
    for (std::uint32_t t = 0; t < examples; ++t) targets_.push_back(t);
    space_.example_count = examples;
    space_.parameters = parameters_;
    space_.targets = targets_;
    space_.linear = linear_;
    space_.radial = radial_;
    space_.places = places_;
    space_.inverse_widths = widths_;
  }
  std::uint32_t items() const override { return space_.example_count; }
  std::uint32_t period() const override { return kPoints; }
  std::uint64_t hash_output(std::uint64_t state) const override { return hash_of(weights_, state); }
  void run(std::uint64_t iterations) override {
    const std::size_t dimensions = parameters_.size();
    for (std::uint64_t i = 0; i < iterations; ++i) {
      check(evaluate_examples(space_, {points_.data() + next_ * dimensions, dimensions}, weights_));
      next_ = (next_ + 1) % kPoints;
    }
  }

 private:
  // How far the nearest other example is.
  float nearest(std::uint32_t k) const {
    const std::size_t dimensions = parameters_.size();
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      float squared = 0;
      for (std::size_t d = 0; d < dimensions; ++d) {
        const float along = places_[i * dimensions + d] - places_[k * dimensions + d];
        squared += along * along;
      }
      if (i != k) least = std::min(least, std::sqrt(squared));
    }
    return least;
  }

  std::vector<ExampleParameter> parameters_;
  std::vector<std::uint32_t> targets_;
  std::vector<float> places_, linear_, radial_, points_, widths_, weights_;
  ExampleSpace space_;
  std::size_t next_ = 0;
};

}  // namespace

RowGroup weighing_rows() {
  RowGroup group;
  for (const std::uint32_t examples : kExamples)
    for (const std::uint32_t parameters : kParameters)
      group.rows.push_back({fmt::format("skin/examples/{}/{}", examples, parameters), nullptr, {}, [=](Models&) {
                              return std::make_unique<Weighing>(examples, parameters);
                            }});
  group.names = fmt::format("skin/examples/{}/{}\n", choice(kExamples), choice(kParameters));
  return group;
}

}  // namespace marrow::tools
