// A character as any engine draws it: linear blend skinning by the source's own joints and weights, without helpers.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "pose/evaluate.h"

namespace marrow::tools {

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

}  // namespace marrow::tools
