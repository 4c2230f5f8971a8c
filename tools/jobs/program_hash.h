// Which program this is.
#pragma once

#include <string>

namespace marrow::tools {

// A hash of the program and of the libraries that it was linked with: another build may cook other bytes. Not of what
// those bring in themselves, which cooks nothing.
const std::string& program_hash();

}  // namespace marrow::tools
