// A mutex, also where the standard library has no threads and none is needed.
#pragma once

#ifdef __wasi__
namespace marrow::tools {
class Mutex {
 public:
  void lock() {}
  void unlock() {}
};
}  // namespace marrow::tools
#else
#include <mutex>
namespace marrow::tools {
using Mutex = std::mutex;
}  // namespace marrow::tools
#endif

namespace marrow::tools {

// Holds a mutex while it lives.
class Locked {
 public:
  explicit Locked(Mutex& mutex) : mutex_(mutex) { mutex_.lock(); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;
  ~Locked() { mutex_.unlock(); }

 private:
  Mutex& mutex_;
};

}  // namespace marrow::tools
