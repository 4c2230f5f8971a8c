// `marrow cook`: glTF in, cooked files out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "options/options.h"

namespace marrow::tools {

struct CookArguments {
  std::vector<std::string> inputs;
  std::string out, report, depfile, settings;
  std::string cache;  // empty: none
  std::uint64_t cache_bytes = 1u << 30;
  unsigned jobs = 0;  // 0: one a core
  bool json = false;
  cook::Given given;  // on the command line
};

// One file; throws Failure, and then neither the output nor the report nor the depfile is touched. Or a folder's worth:
// one bad file does not stop the others. Returns the process's exit code: of a folder's, the first failure's in the
// inputs' order.
int run_cook(const CookArguments& arguments);

}  // namespace marrow::tools
