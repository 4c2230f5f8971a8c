// What the glTF stages say: a finding ends the reading, a warning is collected.
#pragma once

#include <concepts>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/failure.h"
#include "cook/scene/raw.h"
#include "text/printable.h"

namespace marrow::cook::gltf {

// Appends one step to a JSON pointer, escaped as RFC 6901 says.
inline void append_step(std::string& pointer, std::string_view key) {
  pointer += '/';
  for (const char c : key) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      pointer += c;
    }
  }
}

inline void append_step(std::string& pointer, std::integral auto index) {
  pointer += '/' + std::to_string(index);
}

// pointer("nodes", 3, "matrix") is "/nodes/3/matrix".
template <class... Steps>
std::string pointer(const Steps&... steps) {
  std::string text;
  (append_step(text, steps), ...);
  return text;
}

// `base` with further steps.
template <class... Steps>
std::string under(std::string base, const Steps&... steps) {
  (append_step(base, steps), ...);
  return base;
}

inline std::string at_offset(std::size_t offset) {
  return '@' + std::to_string(offset);
}

class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  [[noreturn]] void fail(tools::Exit code, const std::string& where, const std::string& rule,
                         const std::string& advice) const {
    throw tools::Failure(code, file_, tools::printable(where), tools::printable(rule), tools::printable(advice));
  }
  [[noreturn]] void invalid(const std::string& where, const std::string& rule, const std::string& advice) const {
    fail(tools::Exit::invalid, where, rule, advice);
  }
  [[noreturn]] void unsupported(const std::string& where, const std::string& rule, const std::string& advice) const {
    fail(tools::Exit::unsupported, where, rule, advice);
  }
  [[noreturn]] void unreadable(const std::string& where, const std::string& rule, const std::string& advice) const {
    fail(tools::Exit::io, where, rule, advice);
  }

  // Legal, but not carried or not as the author may expect.
  void warn(const std::string& where, const std::string& rule, const std::string& text);

  // Wrong, but with one sensible meaning, which the caller goes on with. Final where that was asked for, and in a file
  // without scenes, which is a library of parts (glTF 2.0, section 3.5.1): nobody can look at the result, so nothing is
  // guessed there.
  void mend(const std::string& where, const std::string& rule, const std::string& text);

  // From here on, and why.
  void mend_nothing(std::string because) { mends_nothing_because_ = std::move(because); }
  bool mends() const { return mends_nothing_because_.empty(); }

  const std::string& file() const { return file_; }

  // Every file that the scene's meaning depends on, as it was read.
  void note_read(Read read) { reads_.push_back(std::move(read)); }
  std::vector<Read> take_reads() { return std::move(reads_); }

  // The warnings so far; repetitions of one rule beyond a handful are counted, not listed.
  std::vector<RawWarning> take_warnings();

 private:
  std::string file_;
  std::string mends_nothing_because_;
  std::vector<RawWarning> warnings_;
  std::vector<Read> reads_;
  std::map<std::string, std::size_t> count_of_rule_;
};

}  // namespace marrow::cook::gltf
