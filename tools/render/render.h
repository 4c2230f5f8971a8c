// `marrow render`: a cooked character at a moment of a clip → a picture.
#pragma once

namespace CLI {
class App;
}

namespace marrow::tools {

void add_render(CLI::App& app);

}  // namespace marrow::tools
