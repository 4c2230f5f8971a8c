// Clips exported apart from their character: their nodes become the joints of the same names that the character has.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cook/scene/built.h"
#include "cook/scene/raw.h"

namespace marrow::cook {

// Of a cooked file, which outlives it.
Character view_character(const std::string& path, const File& file);

// Throws tools::Failure (invalid) for what has none, as a clip pack.
void expect_skeletons(const Character& character);

// Of each name the first skeleton's first joint.
std::map<std::string, NearestJoint> joints_by_name(const Character& character);

struct Matched {
  RawScene scene;    // its clips move joints alone
  BuiltScene built;  // the character's skeletons, and for each node the joint that it is
};

// A node is the joint of the first skeleton that has one of its name. What a clip moves must be such a joint, below the
// same parent or a root; what is none is left out, with a warning, if clips hold it still or it carries nothing, see
// carrying_nodes(). Where the scale above the roots is another one, translations are brought to the character's. Where
// a joint that a clip leaves alone stands otherwise than in the character, the clip gets a key for it, so that it looks
// as in its own file. Throws tools::Failure (invalid) with the nodes that are no joints, or with both scales.
Matched match_skeletons(const Character& character, RawScene scene, const std::vector<std::string>& keep, Notes& notes);

}  // namespace marrow::cook
