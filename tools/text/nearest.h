// What may have been meant by a name that does not exist, and which names there are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace marrow::tools {

// How many letters must be changed, added or left out (Levenshtein).
std::size_t edit_distance(std::string_view a, std::string_view b);

// The name with the fewest edits, if these are at most two or a third of its letters; else, or if `wanted` begins it
// and more than one edit was needed, the shortest name that `wanted` is a part of. Case does not count. Of equals the
// first; empty if none is near.
std::string nearest_name(std::string_view wanted, const std::vector<std::string>& names);

// `did you mean "walk"?`; empty if no name is near.
std::string did_you_mean(std::string_view wanted, const std::vector<std::string>& names);

// The first dozen, each once: `a, b, c and 4 more`.
std::string listed(const std::vector<std::string>& names);

// Both, as a failure's advice: `did you mean "walk"? there are "run", "walk"`. Empty without names.
std::string suggestion(std::string_view wanted, const std::vector<std::string>& names);

}  // namespace marrow::tools
