// The machine's threads, for all loops of the process: no more threads than cores, however loops are nested.
#pragma once

#include "common/parallel.h"

namespace marrow::tools {

// Threads of the whole process. A loop runs in its caller's thread, and in threads that are to spare or become so while
// it runs.
Threads& all_cores();

// Threads that all loops share, the first one's own included. At first one a core.
void set_thread_count(unsigned count);
// A thread beyond the caller's own, if one is to spare; whoever took it gives it back.
bool take_thread();
void give_back_thread();

}  // namespace marrow::tools
