#include "disk/thread_pool.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace marrow::tools {
namespace {

std::atomic<int>& spare() {
  static std::atomic<int> threads{static_cast<int>(std::max(1u, std::thread::hardware_concurrency())) - 1};
  return threads;
}

class AllCores : public Threads {
 public:
  void for_each(std::size_t count, const std::function<void(std::size_t)>& f) override;
};

}  // namespace

Threads& all_cores() {
  static AllCores threads;
  return threads;
}

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

void AllCores::for_each(std::size_t count, const std::function<void(std::size_t)>& f) {
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
      others.reserve(others.size() + 1);  // so that no helper is waited for in here
      others.push_back(std::async(std::launch::async, help));
    } catch (const std::exception&) {  // the system has no thread or no memory left; go on without
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
