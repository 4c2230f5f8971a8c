// Where plain skinning spoils a character most, and is seen to: which clip, when, at which joint, from which side.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "pose/evaluate.h"
#include "render/clearest_side.h"

namespace marrow::tools {

// A character by plain skinning, whatever else its file has.
class PlainSkin {
 public:
  // Cooks the source once more. file: the same source cooked in any other way, but for the order of its vertices as
  // precise; outlives it. Throws Failure.
  PlainSkin(const std::string& source, const File& file);

  // In another character's pose, who is of `file`, slot by slot of it.
  std::vector<PosedMesh> skin(const Character& posed);

  // What it was cooked to, and who is of it: as skin() has posed them.
  const File& file() const { return loaded_.file; }
  const Character& character() const { return *character_; }

 private:
  struct Place {
    std::uint32_t mesh, slot;
  };
  const File& other_;
  LoadedFile loaded_;
  std::unique_ptr<Character> character_;
  std::vector<std::vector<Place>> places_;  // a slot of each mesh of the other file
  std::vector<std::uint32_t> twin_;         // a mesh: one of the other file's that is of the same primitive
};

struct WorstPlace {
  std::optional<std::uint32_t> clip;  // none if there is none
  float time_s = 0;
  std::string joint;  // its name, or without one its number; empty where nothing is to be seen
  Part part;          // about it
  Orbit side;
};

// Of the clips, at moments spread over them; of those that stand still only where all do. A place is bad where
// triangles lose area that animation space leaves them; of the worst places the one whose picture changes most is
// taken. Leaves `character`, of `file`, in some pose.
WorstPlace find_worst(const File& file, Character& character, PlainSkin& plain, std::span<const std::uint32_t> clips);

}  // namespace marrow::tools
