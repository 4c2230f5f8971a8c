// Ways to cook that between them go through all that decides bytes; for tests that bytes are the same.
#pragma once

#include <string>
#include <vector>

#include "cli/support/process.h"

namespace marrow::test {

struct Cooking {
  std::string name, source;
  std::vector<std::string> options;
};

// Some of the sources are written to the folder. Those that are quick, and in the long form all.
std::vector<Cooking> cookings(const TemporaryFolder& folder);

// {"env", settings …, program, "cook", source, "-o", output, options …}
std::vector<std::string> cook_command(const Cooking& cooking, const std::string& output,
                                      const std::vector<std::string>& settings = {});

// Writes looks.gltf whose plain panel emits 6, 3, 0 and is unlit, and whose first texture is a WebP, by reference, with
// the picture that it has there as a fallback. Returns its path.
std::string shining_gltf(const TemporaryFolder& folder);

}  // namespace marrow::test
