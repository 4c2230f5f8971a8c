// The models whose clips `marrow bench` plays, cooked in memory on first use.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/load_mrw.h"

namespace marrow::tools {

struct ModelSource {
  const char* file;
  bool embedded;  // comes with the program
};
inline constexpr ModelSource kPab = {"pab.glb", false};
inline constexpr ModelSource kCesiumMan = {"CesiumMan.glb", false};
inline constexpr ModelSource kRuby = {"ruby.glb", false};
inline constexpr ModelSource kMannequiny = {"mannequiny.glb", false};
inline constexpr ModelSource kNewt = {"newt.glb", true};

class Models {
 public:
  // Looks for files in the folder that the environment's MARROW_ASSETS names, else where the build was told.
  Models();

  const std::string& folder() const { return folder_; }
  bool has(const ModelSource& model) const;
  // Call for all clips before the first get(): only these are compressed, which is what takes time.
  void want(const ModelSource& model, const std::string& clip) { wanted_[&model].insert(clip); }
  // Cooked with default settings; clips that nobody wants stand still. Throws Failure.
  const File& get(const ModelSource& model);
  // The packed file, with all clips; codec: "draco" or "meshopt". Throws Failure.
  const std::vector<std::byte>& packed(const ModelSource& model, const std::string& codec);

 private:
  std::string folder_;
  std::map<const ModelSource*, std::set<std::string>> wanted_;
  std::map<const ModelSource*, LoadedFile> cooked_;
  std::map<std::pair<const ModelSource*, std::string>, std::vector<std::byte>> packed_;
};

// The first clip of this name and its skeleton. Throws Failure (invalid) if there is none.
struct ClipOfModel {
  Skeleton skeleton;
  Clip clip;
};
ClipOfModel find_clip(const ModelSource& model, const File& file, const std::string& name);

}  // namespace marrow::tools
