// Loops of independent work, on threads that the caller of the whole work lends.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace marrow::tools {

// Runs loops. Loops may be nested, and several threads may call at once.
class Threads {
 public:
  virtual ~Threads() = default;
  // Calls f(0) … f(count - 1), each once, in any order, perhaps at the same time, and returns when all have ended. An
  // exception of `f` ends the loop and is thrown from here.
  virtual void for_each(std::size_t count, const std::function<void(std::size_t)>& f) = 0;
};

// What the loops of one piece of work run on, and what ends it.
struct Work {
  Threads* threads = nullptr;               // null: the caller's own thread
  const std::atomic<bool>* stop = nullptr;  // once it is true, loops throw Failure (interrupted); null: never
};

// While it lives, loops of this thread, and loops within those, are of this work.
class UseWork {
 public:
  explicit UseWork(const Work& work);
  UseWork(const UseWork&) = delete;
  UseWork& operator=(const UseWork&) = delete;
  ~UseWork();

 private:
  Work work_;
  const Work* before_;
};

// Throws Failure (interrupted) if the work of this thread is to stop.
void expect_to_go_on();

// Threads::for_each() of this thread's work; without any, in the caller's thread.
void for_each_in_parallel(std::size_t count, const std::function<void(std::size_t)>& f);

}  // namespace marrow::tools
