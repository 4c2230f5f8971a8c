// Maps that say which joint turns as which of another rig, as TOML to edit.
#pragma once

#include <string>
#include <vector>

#include "cook/retarget/plan/pair_rigs.h"
#include "cook/retarget/retarget.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// A table [joints]: JOINT = "SOURCE", or JOINT = ["SOURCE", "OTHER", SHARE] for one between two. Throws tools::Failure
// (usage), located by line and column, for what is no such file.
RetargetMap parse_retarget_map(const std::string& path, std::string_view text);

// A map that says what pair_with() has found, joint by joint of the character; those without a counterpart and the
// source's that are none are comments.
std::string retarget_map_text(const Character& character, const RawScene& source, const RigPairing& pairing);

}  // namespace marrow::cook
