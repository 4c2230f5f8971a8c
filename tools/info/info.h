// `marrow info`: what a cooked file holds.
#pragma once

namespace CLI {
class App;
}

namespace marrow::tools {

void add_info(CLI::App& app);

}  // namespace marrow::tools
