// How long the last frames took.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace marrow::tools {

class FrameTimes {
 public:
  static constexpr int kFrames = 120;

  void add(float milliseconds) {
    times_[static_cast<std::size_t>(next_)] = milliseconds;
    next_ = (next_ + 1) % kFrames;
    count_ = std::min(count_ + 1, kFrames);
  }
  // As a ring that begins at first().
  const std::array<float, kFrames>& ring() const { return times_; }
  int first() const { return count_ < kFrames ? 0 : next_; }
  int count() const { return count_; }
  // 0 before the first.
  float median() const {
    if (count_ == 0) return 0;
    std::vector<float> sorted(times_.begin(), times_.begin() + count_);
    std::nth_element(sorted.begin(), sorted.begin() + count_ / 2, sorted.end());
    return sorted[static_cast<std::size_t>(count_ / 2)];
  }
  float largest() const { return *std::max_element(times_.begin(), times_.end()); }

 private:
  std::array<float, kFrames> times_ = {};
  int next_ = 0, count_ = 0;
};

}  // namespace marrow::tools
