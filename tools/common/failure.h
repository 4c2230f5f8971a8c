// How every sub-command says that it cannot go on: one exception type, caught once in main().
#pragma once

#include <exception>
#include <string>
#include <utility>

namespace marrow::tools {

// The process's exit codes; the same for every sub-command.
enum class Exit { done = 0, usage = 1, io = 2, invalid = 3, unsupported = 4, internal = 5, interrupted = 130 };

// Prints as `file: where: rule: advice`. `where` is a JSON pointer ("/accessors/3") or a byte offset ("@128");
// empty parts are left out.
class Failure : public std::exception {
 public:
  Failure(Exit code, std::string file, std::string where, std::string rule, std::string advice)
      : code_(code),
        file_(std::move(file)),
        where_(std::move(where)),
        rule_(std::move(rule)),
        advice_(std::move(advice)) {
    for (const std::string* part : {&file_, &where_, &rule_, &advice_}) {
      if (part->empty()) continue;
      if (!text_.empty()) text_ += ": ";
      text_ += *part;
    }
  }
  const char* what() const noexcept override { return text_.c_str(); }
  Exit code() const noexcept { return code_; }
  const std::string& file() const noexcept { return file_; }
  const std::string& where() const noexcept { return where_; }
  const std::string& rule() const noexcept { return rule_; }
  const std::string& advice() const noexcept { return advice_; }

 private:
  Exit code_;
  std::string file_, where_, rule_, advice_, text_;
};

}  // namespace marrow::tools
