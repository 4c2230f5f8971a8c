// What bad calls tell the handler while a test listens.
#pragma once

#include <string>
#include <vector>

#include "marrow/call_error.h"

namespace marrow::test {

struct CallError {
  std::string function, condition;
};

// While it lives it is told of bad calls, those of this thread and no other's; one at a time.
class CallErrors {
 public:
  CallErrors() : before_(set_call_error_handler(keep)) { heard().clear(); }
  ~CallErrors() { set_call_error_handler(before_); }
  CallErrors(const CallErrors&) = delete;
  CallErrors& operator=(const CallErrors&) = delete;

  // What has come since the last call of this.
  std::vector<CallError> take() {
    std::vector<CallError> out;
    out.swap(heard());
    return out;
  }

 private:
  static void keep(const char* function, const char* condition) { heard().push_back({function, condition}); }
  static std::vector<CallError>& heard() {
    thread_local std::vector<CallError> errors;
    return errors;
  }

  CallErrorHandler before_;
};

// The handler that a program begins with.
CallErrorHandler first_call_error_handler();

}  // namespace marrow::test
