// Loops that share threads; under the thread sanitizer, too.
#include "disk/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "common/failure.h"

namespace marrow::tools {
namespace {

// Loops in loops: never more than the shared threads at work, and each index once.
TEST(Parallel, NestedLoopsShareTheThreads) {
  for (const int threads : {1, 2, 5}) {
    set_thread_count(static_cast<unsigned>(threads));
    std::atomic<int> at_work{0}, most{0}, calls{0};
    all_cores().for_each(6, [&](std::size_t) {
      all_cores().for_each(7, [&](std::size_t) {
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
  all_cores().for_each(2, [&](std::size_t outer) {
    if (outer == 1) return std::this_thread::sleep_for(std::chrono::milliseconds(20));
    all_cores().for_each(60, [&](std::size_t) {
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
    EXPECT_THROW(all_cores().for_each(100,
                                      [](std::size_t i) {
                                        if (i % 7 == 3) throw std::runtime_error("three");
                                      }),
                 std::runtime_error);
  int free = 0;
  while (take_thread()) ++free;
  EXPECT_EQ(free, 3);
  set_thread_count(std::thread::hardware_concurrency());
}

TEST(Parallel, WithoutThreadsALoopRunsInItsCaller) {
  const std::thread::id here = std::this_thread::get_id();
  int calls = 0;
  for_each_in_parallel(5, [&](std::size_t) { calls += std::this_thread::get_id() == here ? 1 : 100; });
  EXPECT_EQ(calls, 5);
}

// Loops within loops, in whichever thread they run.
TEST(Parallel, WorkReachesLoopsWithinLoopsAndEndsWithItsScope) {
  struct Counting : Threads {
    void for_each(std::size_t count, const std::function<void(std::size_t)>& f) override {
      ++loops;
      all_cores().for_each(count, f);
    }
    std::atomic<int> loops{0};
  } threads;
  {
    const UseWork work({&threads, nullptr});
    for_each_in_parallel(4, [](std::size_t) { for_each_in_parallel(3, [](std::size_t) {}); });
  }
  for_each_in_parallel(4, [](std::size_t) {});
  EXPECT_EQ(threads.loops, 5);
}

TEST(Parallel, StopsWhereItIsAsked) {
  std::atomic<bool> stop{false};
  std::atomic<int> calls{0};
  const UseWork work({&all_cores(), &stop});
  try {
    for_each_in_parallel(1000, [&](std::size_t i) {
      ++calls;
      if (i == 10) stop = true;
    });
    ADD_FAILURE() << "it went on";
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.code(), Exit::interrupted);
  }
  EXPECT_LT(calls, 1000);
}

}  // namespace
}  // namespace marrow::tools
