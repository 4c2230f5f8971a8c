// Bad calls of the runtime are errors of the tools: each is a line on stderr.
#pragma once

namespace marrow::tools {

// Before anything else in main().
void print_call_errors();

}  // namespace marrow::tools
