// How far a command has come, for who waits at a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace marrow::tools {

// One line of stderr, written over and over, and gone at the end. Nothing where stderr is no terminal.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  // `[12/340] WHAT, 14 s left`; from any thread. Another `count`, or a `done` that begins anew, is another stage. A
  // count of 0: `WHAT` alone.
  void show(std::size_t done, std::size_t count, const std::string& what);

 private:
  using Clock = std::chrono::steady_clock;
  std::mutex mutex_;
  bool shown_;
  Clock::time_point start_{};  // of the stage, when it had first_
  std::size_t first_ = 0, count_ = 0;
};

// ", 2 min 5 s left", if `done` parts took so long and `left` are to come. Empty where that says nothing yet.
std::string time_left(double elapsed_s, std::size_t done, std::size_t left);

}  // namespace marrow::tools
