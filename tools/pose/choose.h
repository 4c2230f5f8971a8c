// What --clip, --clips and --time say: what is played on a cooked file, and when.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "pose/evaluate.h"

namespace marrow::tools {

struct Choice {
  std::string clip;   // by name or by number; of each other skeleton the clip of the same name plays too; empty: none
  std::string clips;  // a clip pack that it comes from; empty: the file itself
  float time_s = 0;
  std::vector<std::string> set = {};  // "NAME=VALUE": parameters of example shapes, in place of the clip's
};

struct Chosen {
  Play play;                       // empty: the rest pose
  std::optional<LoadedFile> pack;  // holds the clips
};

// dressed: outfits go with it, so that `file` may be joints and clips alone. Throws Failure: invalid if `file` has no
// mesh; usage if there is no such clip; invalid, with the joints that are in the way, if a clip of the pack fits no
// skeleton of `file`; what load_mrw() throws of the pack.
Chosen choose(const std::string& path, const File& file, const Choice& choice, bool dressed = false);

// What --set says. Throws Failure (usage) unless each names a parameter of `file` and gives it a number.
std::map<std::string, float> set_parameters(const std::string& path, const File& file, const Choice& choice);

}  // namespace marrow::tools
