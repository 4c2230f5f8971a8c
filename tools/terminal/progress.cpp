#include "terminal/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "text/printable.h"

namespace marrow::tools {
namespace {

// Before that a guess is too rough.
constexpr double kLeastElapsed_s = 1;

}  // namespace

Progress::Progress() : shown_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::size_t done, std::size_t count, const std::string& what) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (count != count_ || done <= first_) {
    start_ = now;
    first_ = done;
    count_ = count;
  }
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const std::string number = count > 0 ? fmt::format("[{}/{}] ", done, count) : "";
  fmt::print(stderr, "\r\033[K{}{}{}", number, printable(what),
             time_left(elapsed_s, done - first_, count > done ? count - done : 0));
  std::fflush(stderr);
}

std::string time_left(double elapsed_s, std::size_t done, std::size_t left) {
  if (done == 0 || left == 0 || elapsed_s < kLeastElapsed_s) return "";
  const auto seconds = static_cast<long>(std::ceil(elapsed_s * static_cast<double>(left) / static_cast<double>(done)));
  if (seconds < 60) return fmt::format(", {} s left", seconds);
  if (seconds < 3600) return fmt::format(", {} min {} s left", seconds / 60, seconds % 60);
  return fmt::format(", {} h {} min left", seconds / 3600, seconds / 60 % 60);
}

}  // namespace marrow::tools
