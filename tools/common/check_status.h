// Calls of the runtime that cannot fail as the tools make them.
#pragma once

#include "common/failure.h"
#include "marrow/status.h"

namespace marrow::tools {

// Throws Failure (internal) unless ok.
inline void check(Status status) {
  if (status != Status::ok) throw Failure(Exit::internal, "marrow", "", to_string(status), "please report this");
}

}  // namespace marrow::tools
