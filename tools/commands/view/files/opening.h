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
  // also: a file that is watched as well, a clip pack; empty: none. at_once: each call of poll() looks at the disk, and
  // waits for what is being opened, so that pictures are the same every time.
  Opening(std::string images_from, std::string also, bool at_once)
      : images_from_(std::move(images_from)), also_(std::move(also)), at_once_(at_once) {}

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
  bool time_to_look();
  void begin(const std::string& path);
  void watch(std::vector<std::string> reads);

  std::string images_from_, also_;
  bool at_once_;
  std::string path_, next_, busy_with_, error_;
  std::vector<std::string> reads_;
  std::future<Source> coming_;
  Watch watch_;
  std::timespec began_ = {};
  double last_look_s_ = -1;
};

}  // namespace marrow::tools
