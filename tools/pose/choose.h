// What --clip, --clips and --time say: a clip as a command line names it, what is played on a cooked file, and when.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/load_mrw.h"
#include "marrow/file.h"
#include "pose/evaluate.h"

namespace marrow::tools {

struct Choice {
  std::string clip;   // as find_clip() takes it; empty: none
  std::string clips;  // a clip pack that it comes from; empty: the file itself
  float time_s = 0;
  std::vector<std::string> set = {};  // "NAME=VALUE": parameters of example shapes, in place of the clip's
};

struct Chosen {
  Play play;                       // empty: the rest pose
  std::optional<LoadedFile> pack;  // holds the clips
};

// Throws Failure (invalid) if `file`, of this path, is a clip pack, which has no joints of its own.
void expect_joints(const std::string& path, const File& file);

// dressed: outfits go with it, so that `file` may be joints and clips alone. Throws Failure: invalid if `file` has no
// mesh; usage if there is no such clip; invalid, with the joints that are in the way, if a clip of the pack fits no
// skeleton of `file`; what load_mrw() throws of the pack.
Chosen choose(const std::string& path, const File& file, const Choice& choice, bool dressed = false);

// Of each clip of a pack what it plays on `file`. Throws Failure (invalid) with the joints that are in the way if one
// fits no skeleton, or `pack` is none.
std::vector<Play> plays_of_pack(const std::string& pack_path, const File& pack, const std::string& path,
                                const File& file);

// What --set says. Throws Failure (usage) unless each names a parameter of `file` and gives it a number.
std::map<std::string, float> set_parameters(const std::string& path, const File& file, const Choice& choice);

struct NamedClip {
  std::uint32_t clip = 0;
  bool alone = false;  // what other skeletons play by the same name does not go with it
};

// By name or else by number; where clips of several skeletons have a name, one of them alone by CLIP@SKELETON, the
// skeleton (of a pack the reference) by name or number, too. Throws Failure (usage) that lists what there is.
NamedClip find_clip(const std::string& path, const File& file, const std::string& wanted);

}  // namespace marrow::tools
