// The driver of paper of tests/gl/misuse, as C names it.
#include "gl/misuse/paper_driver.h"

extern "C" void* paper_proc_of_c(const char* name);

void* paper_proc_of_c(const char* name) {
  return marrow::test::paper_proc(name);
}
