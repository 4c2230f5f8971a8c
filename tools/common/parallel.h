// Independent work on all cores, and no more threads than cores however loops are nested.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <system_error>
#include <vector>

namespace marrow::tools {

// Threads that all loops of the process share, the first one's own included. At first one a core.
void set_thread_count(unsigned count);
// A thread beyond the caller's own, if one is to spare; whoever took it gives it back.
bool take_thread();
void give_back_thread();

// Calls f(0) … f(count - 1), each once, in any order and at the same time: in the caller's thread, and in threads that
// are to spare or become so while the loop runs. An exception ends it and is thrown when all threads have ended.
template <class F>
void for_each_in_parallel(std::size_t count, const F& f) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::vector<std::future<void>> others;  // guarded by `mutex`
  std::function<void()> work;
  const auto share = [&] {
    if (!take_thread()) return;
    const auto help = [&work] {
      struct GiveBack {
        ~GiveBack() { give_back_thread(); }
      } const at_end;
      work();
    };
    try {
      const std::lock_guard lock(mutex);
      others.push_back(std::async(std::launch::async, help));
    } catch (const std::system_error&) {  // the system has no thread left; go on without
      give_back_thread();
    }
  };
  work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        if (next < count) share();
        f(i);
      }
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::exception_ptr failure;
  const auto keep_failure = [&](const auto& run) {
    try {
      run();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
  };
  keep_failure(work);
  for (std::size_t i = 0;; ++i) {
    std::future<void> other;
    {
      const std::lock_guard lock(mutex);
      if (i == others.size()) break;
      other = std::move(others[i]);
    }
    keep_failure([&] { other.get(); });
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace marrow::tools
