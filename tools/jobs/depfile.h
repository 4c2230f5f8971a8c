// What an output was made from, for make and ninja.
#pragma once

#include <string>
#include <vector>

namespace marrow::tools {

// "OUT: IN IN" as one line, escaped as `gcc -MD` does and ninja understands it. Throws Failure (usage) for a name with
// a line break, which the syntax cannot hold.
std::string depfile_rule(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace marrow::tools
