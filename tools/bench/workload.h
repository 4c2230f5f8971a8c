// What a row of `marrow bench` runs over and over, and the rows there are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "asset/format.h"
#include "bench/models.h"

namespace marrow::tools {

// Everything that one iteration reads and writes, made beforehand: run() allocates nothing.
class Workload {
 public:
  virtual ~Workload() = default;
  // Joints or vertices in one iteration.
  virtual std::uint32_t items() const = 0;
  // Goes on where the last call stopped.
  virtual void run(std::uint64_t iterations) = 0;
  // How many iterations differ from one another, or enough of them.
  virtual std::uint32_t period() const { return 1; }
  // Takes what the last iteration wrote into `state`.
  virtual std::uint64_t hash_output(std::uint64_t state) const = 0;
};

struct Row {
  std::string name;
  const ModelSource* model = nullptr;  // null: needs none
  std::vector<std::string> clips;      // of the model
  std::function<std::unique_ptr<Workload>(Models&)> make;
  bool stand_in = false;  // the model is there in place of pab, which is missing
};

// Rows of one kind; `names` is how all of them are called, alternatives in braces, a line each.
struct RowGroup {
  std::string names;
  std::vector<Row> rows;
};
RowGroup sampling_rows();
RowGroup pose_rows(const Models& models);  // on pab, or else on the sample
RowGroup skinning_rows();
RowGroup morphing_rows();
RowGroup weighing_rows();
RowGroup limit_rows();
RowGroup chain_rows();
RowGroup body_rows();
RowGroup reaching_rows();
RowGroup following_rows();
RowGroup moving_rows();
RowGroup behaving_rows();
RowGroup unpacking_rows();

// xorshift32 (Marsaglia, Journal of Statistical Software 8(14), 2003): the same numbers everywhere.
class Noise {
 public:
  // A multiple of 2⁻²⁴ in [0, 1).
  float next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return static_cast<float>(state_ >> 8) * 0x1p-24f;
  }
  float between(float low, float high) { return low + (high - low) * next(); }

 private:
  std::uint32_t state_ = 0x12345678;
};

// Matrices as a palette may have them: turned by up to a right angle or so, moved by up to 1, not scaled.
std::vector<Affine> noise_palette(std::size_t count);

template <class T>
std::uint64_t hash_of(Span<T> values, std::uint64_t state) {
  if (values.empty()) return state;
  const std::uint64_t both[2] = {
      state, format::checksum(reinterpret_cast<const std::byte*>(values.data), values.size * sizeof(T))};
  return format::checksum(reinterpret_cast<const std::byte*>(both), sizeof both);
}
template <class T>
std::uint64_t hash_of(const std::vector<T>& values, std::uint64_t state) {
  return hash_of(Span<const T>(values), state);
}

// "{a,b,c}"
template <class List>
std::string choice(const List& names) {
  return fmt::format("{{{}}}", fmt::join(names, ","));
}

}  // namespace marrow::tools
