// Files on the disk that may change under a window.
#pragma once

#include <cstdint>
#include <ctime>
#include <string>
#include <vector>

namespace marrow::tools {

class Watch {
 public:
  // From now on these. since: when reading them began; what was written later counts as changed.
  void set(std::vector<std::string> paths, std::timespec since);

  // Whether one of them has changed since set() or the last true, and is now as it was at the last call: a file that is
  // still being written has not changed yet. A file that is gone has. Cost: a stat() a file.
  bool changed();

  // Whether it is time for a look: four times a second.
  bool is_due();

  // No later than the stamp of what is written after it.
  static std::timespec now();

 private:
  struct Stamp {
    std::int64_t seconds = 0, nanoseconds = 0, bytes = -1;  // -1: there is no file
    std::uint64_t number = 0;                               // of the file: another takes its place when it is renamed
    bool operator==(const Stamp&) const = default;
  };
  static Stamp stamp(const std::string& path);

  std::vector<std::string> paths_;
  std::vector<Stamp> known_, last_;
  double last_look_s_ = -1;
};

}  // namespace marrow::tools
