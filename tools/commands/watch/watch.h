// `marrow watch`: cooks as `marrow cook` does, and again what changes.
#pragma once

#include "jobs/cooker.h"

namespace marrow::tools {

struct WatchArguments : CookArguments {
  bool poll = false;
};

// Goes on until the process is interrupted. Throws Failure for what is wrong before the first file is cooked; what goes
// wrong later is said on stderr.
[[noreturn]] void run_watch(const WatchArguments& arguments);

}  // namespace marrow::tools
