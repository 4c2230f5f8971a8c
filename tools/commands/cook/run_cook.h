// `marrow cook`: glTF in, cooked files out.
#pragma once

#include "jobs/cooker.h"

namespace marrow::tools {

// One file; throws Failure, and then neither the output nor the report nor the depfile is touched. Or a folder's worth:
// one bad file does not stop the others. Returns the process's exit code: of a folder's, the first failure's in the
// inputs' order.
int run_cook(const CookArguments& arguments);

// No input but graphs, into a file of them alone. Throws Failure: also usage for options of anything else.
int cook_graph_pack(const CookArguments& arguments);

}  // namespace marrow::tools
