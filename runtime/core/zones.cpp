#include "core/zone.h"

#if defined(MARROW_ZONES) && MARROW_ZONES
#include <atomic>

namespace marrow {
namespace {
std::atomic<const ZoneHandler*> zone_handler_now = nullptr;
}

const ZoneHandler* set_zone_handler(const ZoneHandler* handler) {
  return zone_handler_now.exchange(handler, std::memory_order_acq_rel);
}

Zone::Zone(const char* name) : handler_(zone_handler_now.load(std::memory_order_acquire)), name_(name) {
  if (handler_ != nullptr) handler_->begin(name);
}

}  // namespace marrow

#else

namespace marrow {
const ZoneHandler* set_zone_handler(const ZoneHandler*) {
  return nullptr;
}
}  // namespace marrow
#endif
