#include "compare/instructions.h"

#ifdef __linux__
#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace marrow::tools {

#ifdef __linux__
namespace {

// A counter of this thread, see perf_event_open(2); closed at the end.
class Counter {
 public:
  Counter() {
    perf_event_attr what{};
    what.size = sizeof what;
    what.type = PERF_TYPE_HARDWARE;
    what.config = PERF_COUNT_HW_INSTRUCTIONS;
    what.disabled = 1;
    what.exclude_kernel = 1;
    what.exclude_hv = 1;
    file_ = static_cast<int>(::syscall(SYS_perf_event_open, &what, 0, -1, -1, 0));
  }
  ~Counter() {
    if (file_ >= 0) ::close(file_);
  }
  Counter(const Counter&) = delete;
  Counter& operator=(const Counter&) = delete;

  bool start() const { return ::ioctl(file_, PERF_EVENT_IOC_ENABLE, 0) == 0; }
  bool stop(std::uint64_t& count) const {
    return ::ioctl(file_, PERF_EVENT_IOC_DISABLE, 0) == 0 && ::read(file_, &count, sizeof count) == sizeof count;
  }

 private:
  int file_ = -1;
};

}  // namespace

std::optional<std::uint64_t> count_instructions(const std::function<void()>& work) {
  const Counter counter;
  std::uint64_t count = 0;
  if (!counter.start()) return std::nullopt;
  work();
  return counter.stop(count) && count > 0 ? std::optional(count) : std::nullopt;
}
#else
std::optional<std::uint64_t> count_instructions(const std::function<void()>&) {
  return std::nullopt;
}
#endif

}  // namespace marrow::tools
