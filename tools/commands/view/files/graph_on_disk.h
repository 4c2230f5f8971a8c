// The graph that a window plays, as a text or a pack on the disk, which may change.
#pragma once

#include <ctime>
#include <optional>
#include <string>

#include "behave/find_graph.h"
#include "commands/view/files/changed_files.h"

namespace marrow::tools {

class GraphOnDisk {
 public:
  // wanted: as find_graph() takes it; a graph of the character's own file is not watched here. at_once: as Opening has
  // it.
  GraphOnDisk(std::string wanted, bool at_once);

  // The graph, read now. Throws as find_graph().
  FoundGraph read(const std::string& path, const File& file);
  // The same if it has changed, and is no longer being written; nullopt also if it is wrong, which error() says then.
  std::optional<FoundGraph> poll(const std::string& path, const File& file);

  // Why the last one cannot be played, with line and column; empty: it can.
  const std::string& error() const { return error_; }
  void set_error(std::string text) { error_ = std::move(text); }

 private:
  std::string wanted_, reads_;  // reads_: a file; empty: none of its own
  bool at_once_;
  std::string error_;
  Watch watch_;
};

}  // namespace marrow::tools
