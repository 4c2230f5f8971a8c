#include "commands/view/files/changed_files.h"

#include <sys/stat.h>

#include <utility>

namespace marrow::tools {

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
