// How far a fit has come, for who waits for it.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace marrow::deform {

// Called with how many parts of a fit are done, of how many; from any thread, at the same time too.
using Progress = std::function<void(std::size_t done, std::size_t count)>;

// Counts parts as they are done.
class Steps {
 public:
  Steps(const Progress& progress, std::size_t count) : progress_(progress), count_(count) {}
  void one_more() {
    const std::size_t done = ++done_;
    if (progress_) progress_(done, count_);
  }

 private:
  const Progress& progress_;
  std::size_t count_;
  std::atomic<std::size_t> done_{0};
};

}  // namespace marrow::deform
