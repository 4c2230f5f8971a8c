// Files on their way into the window: opened when they are dropped on it, and again when they change on the disk.
#pragma once

#include <future>
#include <optional>
#include <string>

#include "commands/view/files/changed_files.h"
#include "commands/view/files/source.h"

namespace marrow::tools {

class Opening {
 public:
  // also: files that are watched as well, clip packs. at_once: each call of poll() looks at the disk, and waits for
  // what is being opened, so that pictures are the same every time.
  Opening(SourceOptions how, std::vector<std::string> also, bool at_once)
      : how_(std::move(how)), also_(std::move(also)), at_once_(at_once) {}

  // Opens it now, and watches it. Throws as open_source().
  Source open(const std::string& path);

  // Begins to open a file in place of the one that is shown.
  void drop(const std::string& path) { next_ = path; }

  // What was opened since the last call, if anything was. Cost: a look at the disk four times a second.
  std::optional<Source> poll();

  // The name of what is being opened; empty: nothing is.
  const std::string& busy_with() const { return busy_with_; }
  // Why the last file could not be opened; empty: it could.
  const std::string& error() const { return error_; }
  void set_error(std::string text) { error_ = std::move(text); }

 private:
  void begin(const std::string& path);
  void watch(std::vector<std::string> reads);

  SourceOptions how_;
  std::vector<std::string> also_;
  bool at_once_;
  std::string path_, next_, busy_with_, error_;
  std::vector<std::string> reads_;
  std::future<Source> coming_;
  Watch watch_;
  std::timespec began_ = {};
};

}  // namespace marrow::tools
