// `marrow cook`: glTF in, cooked files out.
#pragma once

#include "jobs/cooker.h"
#include "jobs/units.h"

namespace marrow::tools {

// What of the work this process does.
struct ShareOfWork {
  Shard shard;
  bool is_given = false;             // by --shard, --plan or --fits: then a single file is a list of one
  bool fits = false;                 // learns into the cache, and cooks nothing
  std::string plan;                  // lists the work in this file, and does none; empty: does it
  std::vector<std::string> history;  // reports that tell what takes how long
  std::string program;               // which alone may do it; empty: any
};

// One file; throws Failure, and then neither the output nor the report nor the depfile is touched. Or a folder's worth:
// one bad file does not stop the others. Returns the process's exit code: of a folder's, the first failure's in the
// inputs' order.
int run_cook(const CookArguments& arguments, const ShareOfWork& part);

// No input but graphs, into a file of them alone. Throws Failure: also usage for options of anything else.
int cook_graph_pack(const CookArguments& arguments);

}  // namespace marrow::tools
