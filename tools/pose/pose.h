// `marrow pose`: a character at a moment, as numbers.
#pragma once

namespace CLI {
class App;
}

namespace marrow::tools {

void add_pose(CLI::App& app);

}  // namespace marrow::tools
