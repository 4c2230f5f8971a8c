// Cooked files kept by what they were made from, so that nothing is cooked twice.
//
// abcdef….inputs, by the scene's own bytes, the options and this program: which other files such a scene reads.
// cdef01….cooked, by all of that and those files' bytes: how long it took, the report and the cooked file.
// ef0123….fit, by what a mesh was learnt from: what was learnt.
// Every entry begins with a hash of its name and the rest; one that does not fit is as good as absent.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "disk/cook_on_disk.h"
#include "jobs/store.h"

namespace marrow::tools {

// Safe to call from several threads. A place that cannot be used is no failure: end() says why.
class Cache : public cook::Fits {
 public:
  // Throws Failure as http_store() does.
  explicit Cache(const CacheArguments& arguments);

  struct Kept {
    cook::Result result;
    double cooking_s = 0;  // what it took
  };
  // What cooking `path` with options of this canonical text would give.
  std::optional<Kept> find(const std::string& path, const std::string& options) const;
  void store(const cook::Result& result, double cooking_s, const std::string& options) const;

  std::optional<std::string> find(const std::string& key) override;
  void keep(const std::string& key, const std::string& bytes) override;

  // Keeps folders within their bounds; says on stderr what was wrong.
  void end();

 private:
  std::optional<std::string> get(const std::string& name) const;
  void put(const std::string& name, const std::string& body) const;
  std::vector<std::unique_ptr<Store>> stores_;
};

// Whether it is a name that a cache gives.
bool is_entry(const std::string& name);

// What `path` names relative to the folder of `scene`, both as in Result::reads.
std::string relative_to_scene(const std::string& scene, const std::string& path);

}  // namespace marrow::tools
