// Independent work on all cores, and no more threads than cores however loops are nested.
#pragma once

#include <cstddef>
#include <functional>

namespace marrow::tools {

// Threads that all loops of the process share, the first one's own included. At first one a core.
void set_thread_count(unsigned count);
// A thread beyond the caller's own, if one is to spare; whoever took it gives it back.
bool take_thread();
void give_back_thread();

// Calls f(0) … f(count - 1), each once, in any order and at the same time: in the caller's thread, and in threads that
// are to spare or become so while the loop runs. An exception ends it and is thrown when all threads have ended.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& f);

}  // namespace marrow::tools
