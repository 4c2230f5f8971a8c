// Cooked files kept by what they were made from, so that nothing is cooked twice.
//
// DIR/ab/abcdef….inputs, by the scene's own bytes, the options and this program: which other files such a scene reads.
// DIR/cd/cdef01….cooked, by all of that and those files' bytes: the report and the cooked file.
// Every file begins with a hash of its name and the rest; one that does not fit is as good as absent. Processes may
// share a folder: files are replaced whole and never changed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "disk/cook_on_disk.h"

namespace marrow::tools {

class Cache {
 public:
  // A folder that cannot be used is no failure: nothing is found there, and store() says why.
  explicit Cache(std::string folder) : folder_(std::move(folder)) {}

  // What cooking `path` with options of this canonical text would give. Marks the entry as just used.
  std::optional<cook::Result> find(const std::string& path, const std::string& options) const;

  // Safe to call from several threads. Returns why it could not be stored, or nothing.
  std::string store(const cook::Result& result, const std::string& options) const;

  // Removes the files that were not used for longest until the rest has at most so many bytes.
  void shrink(std::uint64_t most_bytes) const;

 private:
  std::string file_of(const std::string& key, const char* extension) const;
  std::string folder_;
};

// What `path` names relative to the folder of `scene`, both as in Result::reads.
std::string relative_to_scene(const std::string& scene, const std::string& path);

}  // namespace marrow::tools
