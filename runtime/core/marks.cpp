#include "core/mark.h"

#if defined(MARROW_MARKS) && MARROW_MARKS
#include <atomic>

namespace marrow {
namespace {
std::atomic<const MarkHandler*> mark_handler_now = nullptr;
}

const MarkHandler* set_mark_handler(const MarkHandler* handler) {
  return mark_handler_now.exchange(handler, std::memory_order_acq_rel);
}

Mark::Mark(const char* name) : handler_(mark_handler_now.load(std::memory_order_acquire)), name_(name) {
  if (handler_ != nullptr) handler_->begin(name);
}

}  // namespace marrow

#else

namespace marrow {
const MarkHandler* set_mark_handler(const MarkHandler*) {
  return nullptr;
}
}  // namespace marrow
#endif
