#include "common/call_errors.h"

#include <cstdio>

#include "marrow/call_error.h"

namespace marrow::tools {

void print_call_errors() {
  set_call_error_handler([](const char* function, const char* condition) {
    std::fprintf(stderr, "marrow: bad call of %s: %s\n", function, condition);
  });
}

}  // namespace marrow::tools
