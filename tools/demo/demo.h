// `marrow demo`: from artists' files to cooked ones, a contact sheet each and a table.
#pragma once

namespace CLI {
class App;
}

namespace marrow::tools {

void add_demo(CLI::App& app);

}  // namespace marrow::tools
