// Reports of shards put together, and what they say as a whole.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace marrow::tools {

struct Merged {
  // By name. A file that two reports have, as it was tried again: as it was cooked, else the later.
  std::map<std::string, nlohmann::ordered_json> files;
  std::vector<std::string> problems;  // units that nobody has done, two programs
};

// Lists of reports, as `marrow cook --report` writes of several inputs. Throws Failure (io, invalid).
Merged merge(const std::vector<std::string>& reports);

struct Grown {
  std::string name;
  std::uint64_t before = 0, now = 0;
};
struct Timed {
  std::string name;
  double seconds = 0;
  bool from_cache = false;
};
struct Summary {
  std::size_t files = 0, failed = 0, from_cache = 0;
  std::uint64_t source_bytes = 0, cooked_bytes = 0, before_bytes = 0;  // before: of the same files
  double seconds = 0;                                                  // of all that was cooked now
  std::vector<std::pair<std::string, std::string>> failures;           // name, sentence; with its exit code in `code`
  int code = 0;                                                        // of the first failure
  std::vector<Grown> grown;                                            // the most first
  std::vector<std::string> appeared, gone;                             // beside `since`
  std::vector<Timed> slowest;                                          // all, the slowest first
  std::map<std::string, std::size_t> warnings;                         // by rule
};
// since: an earlier one, or nothing.
Summary summary_of(const Merged& merged, const Merged& since);

// A page by itself, for people.
std::string page_of(const Merged& merged, const Summary& summary, bool has_since);

}  // namespace marrow::tools
