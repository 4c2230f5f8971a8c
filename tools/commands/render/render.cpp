#include "commands/render/render.h"

#include <cstdio>

#include "commands/render/movie.h"
#include "commands/render/sitting.h"

namespace marrow::tools {

void run_render(const RenderArguments& arguments) {
  Sitting sitting(arguments);
  if (arguments.movie) return shoot_movie(arguments, sitting);
  const Instant instant{arguments.choice.time_s, std::nullopt};
  sitting.agree_on_heat({&instant, 1});
  write_png(arguments.output, sitting.shoot(instant));
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.output.c_str(), sitting.width(), sitting.height(),
               sitting.gl().driver().c_str());
}

}  // namespace marrow::tools
