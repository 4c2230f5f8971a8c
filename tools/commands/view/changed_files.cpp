#include "commands/view/changed_files.h"

#include <sys/stat.h>

#include <chrono>
#include <utility>

namespace marrow::tools {
namespace {

constexpr double kLookEvery_s = 0.25;

}  // namespace

Watch::Stamp Watch::stamp(const std::string& path) {
  struct stat file = {};
  if (::stat(path.c_str(), &file) != 0) return {};
  return {file.st_mtim.tv_sec, file.st_mtim.tv_nsec, file.st_size, file.st_ino};
}

std::timespec Watch::now() {
  std::timespec time = {};
  // Some file systems stamp by this clock, which ticks: it is never ahead of the other.
  ::clock_gettime(CLOCK_REALTIME_COARSE, &time);
  return time;
}

void Watch::set(std::vector<std::string> paths, std::timespec since) {
  paths_ = std::move(paths);
  known_.clear();
  using Time = std::pair<std::int64_t, std::int64_t>;
  std::timespec until = {};
  ::clock_gettime(CLOCK_REALTIME, &until);
  for (const std::string& path : paths_) {
    const Stamp found = stamp(path);
    const Time time(found.seconds, found.nanoseconds);
    // Not what comes from the future: it would change for ever.
    const bool later = time >= Time(since.tv_sec, since.tv_nsec) && time <= Time(until.tv_sec, until.tv_nsec);
    known_.push_back(later ? Stamp{} : found);
  }
  last_ = known_;
}

bool Watch::is_due() {
  const double now_s = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  if (now_s - last_look_s_ < kLookEvery_s) return false;
  last_look_s_ = now_s;
  return true;
}

bool Watch::changed() {
  std::vector<Stamp> now;
  for (const std::string& path : paths_) now.push_back(stamp(path));
  const bool still = now == last_;
  last_ = now;
  if (!still || now == known_) return false;
  known_ = std::move(now);
  return true;
}

}  // namespace marrow::tools
