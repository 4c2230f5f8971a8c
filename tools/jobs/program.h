// Which program this is.
#pragma once

#include <string>

namespace marrow::tools {

// A hash of the program and of the libraries that it was linked with: another build may cook other bytes. Without
// libcurl and what libraries bring in themselves, as these cook nothing.
const std::string& program_hash();

}  // namespace marrow::tools
