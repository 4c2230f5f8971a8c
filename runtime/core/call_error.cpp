#include "marrow/call_error.h"

#include <atomic>

#ifndef NDEBUG
#include <cstdio>
#endif

namespace marrow {
namespace {

#ifdef NDEBUG
std::atomic<CallErrorHandler> handler_now = nullptr;
#else
void print(const char* function, const char* condition) {
  std::fprintf(stderr, "marrow: bad call of %s: %s\n", function, condition);
}
std::atomic<CallErrorHandler> handler_now = print;
#endif

}  // namespace

CallErrorHandler set_call_error_handler(CallErrorHandler handler) {
  return handler_now.exchange(handler, std::memory_order_acq_rel);
}

CallErrorHandler call_error_handler() {
  return handler_now.load(std::memory_order_acquire);
}

}  // namespace marrow
