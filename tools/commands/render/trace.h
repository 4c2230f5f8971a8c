// `marrow render --trace`: what a graph does, frame by frame, as JSON.
#pragma once

#include <string>

#include "commands/render/acting.h"

namespace marrow::tools {

// Of as many frames a second, from 0 to the end. docs/reference/graphs.md has the fields. Throws Failure.
std::string trace_text(const std::string& path, Acting& acting, double duration_s, int fps);

}  // namespace marrow::tools
