// `marrow cook`: glTF in, a cooked file out.
#pragma once

namespace CLI {
class App;
}

namespace marrow::tools {

void add_cook(CLI::App& app);

}  // namespace marrow::tools
