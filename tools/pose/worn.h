// Outfits: hair, clothes and what a hand holds, of files of their own, on a character.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "pose/choose.h"
#include "pose/evaluate.h"

namespace marrow::tools {

struct Worn {
  std::string path;
  LoadedFile loaded;
  AlignedBytes memory;
  Outfit outfit;
  Play play;  // its own clip of the name that the body plays; empty: it has none
  std::unique_ptr<Character> character;
};

// Loads outfits for `character`, of `file`, to wear. chosen: what the character plays. Throws Failure: invalid, with
// the joints that are in the way, for one that does not fit; what load_mrw() throws.
void put_on(std::span<const std::string> paths, const std::string& body_path, const File& body, const Play& chosen,
            Character& character, AsNormals normals = AsNormals::blended, std::uint32_t level = 0);

}  // namespace marrow::tools
