#include "common/parallel.h"

#include <algorithm>
#include <thread>

namespace marrow::tools {
namespace {

std::atomic<int>& spare() {
  static std::atomic<int> threads{static_cast<int>(std::max(1u, std::thread::hardware_concurrency())) - 1};
  return threads;
}

}  // namespace

void set_thread_count(unsigned count) {
  spare() = static_cast<int>(std::max(1u, count)) - 1;
}

bool take_thread() {
  int free = spare();
  while (free > 0)
    if (spare().compare_exchange_weak(free, free - 1)) return true;
  return false;
}

void give_back_thread() {
  ++spare();
}

}  // namespace marrow::tools
