// Files on their way into the window: opened when they are dropped on it, and again when they change on the disk.
#pragma once

#include <ctime>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "behave/find_graph.h"
#include "commands/view/changed_files.h"
#include "open/open_model.h"
#include "paint/painting.h"
#include "render/disk/images.h"

namespace marrow::tools {

// What is opened: a cooked file, or a model that is cooked in memory first.
struct Source : OpenedModel {
  ImagePlaces images;
  SkinJoints skins;  // of what was cooked here
};
// images_from: as places_of() takes it. Throws as open_model().
Source open_source(const std::string& path, const std::string& images_from = "", Opens opens = Opens::models);

class Opening {
 public:
  // also: files that are watched as well, clip packs. at_once: each call of poll() looks at the disk, and waits for
  // what is being opened, so that pictures are the same every time.
  Opening(std::string images_from, Opens opens, std::vector<std::string> also, bool at_once)
      : images_from_(std::move(images_from)), opens_(opens), also_(std::move(also)), at_once_(at_once) {}

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

  std::string images_from_;
  Opens opens_;
  std::vector<std::string> also_;
  bool at_once_;
  std::string path_, next_, busy_with_, error_;
  std::vector<std::string> reads_;
  std::future<Source> coming_;
  Watch watch_;
  std::timespec began_ = {};
};

// The graph that the window plays, as a text or a pack on the disk, which may change.
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
