// Loops that share threads; under the thread sanitizer, too.
#include "common/parallel.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

// Loops in loops: never more than the shared threads at work, and each index once.
TEST(Parallel, NestedLoopsShareTheThreads) {
  for (const int threads : {1, 2, 5}) {
    set_thread_count(static_cast<unsigned>(threads));
    std::atomic<int> at_work{0}, most{0}, calls{0};
    for_each_in_parallel(6, [&](std::size_t) {
      for_each_in_parallel(7, [&](std::size_t) {
        const int now = ++at_work;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ++calls;
        --at_work;
      });
    });
    EXPECT_EQ(calls, 42);
    EXPECT_LE(most, threads);
    EXPECT_GE(most, std::min(threads, 2));
  }
  set_thread_count(std::thread::hardware_concurrency());
}

// A loop that began alone takes over threads that others leave.
TEST(Parallel, ThreadsThatBecomeFreeAreUsed) {
  set_thread_count(2);
  std::atomic<int> at_work{0}, most{0};
  for_each_in_parallel(2, [&](std::size_t outer) {
    if (outer == 1) return std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for_each_in_parallel(60, [&](std::size_t) {
      const int now = ++at_work;
      if (now > most) most = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      --at_work;
    });
  });
  EXPECT_EQ(most, 2);
  set_thread_count(std::thread::hardware_concurrency());
}

TEST(Parallel, AnExceptionEndsTheLoopAndReturnsTheThreads) {
  set_thread_count(4);
  for (int round = 0; round < 50; ++round)
    EXPECT_THROW(for_each_in_parallel(100,
                                      [](std::size_t i) {
                                        if (i % 7 == 3) throw std::runtime_error("three");
                                      }),
                 std::runtime_error);
  int free = 0;
  while (take_thread()) ++free;
  EXPECT_EQ(free, 3);
  set_thread_count(std::thread::hardware_concurrency());
}

}  // namespace
}  // namespace marrow::tools
