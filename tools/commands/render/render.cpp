#include "commands/render/render.h"

#include <cstdio>

#include "commands/render/movie.h"
#include "commands/render/sitting.h"
#include "common/files.h"
#include "common/formats.h"

namespace marrow::tools {

namespace {

void expect_output(const RenderArguments& arguments) {
  if (arguments.movie) return expect_movie_output(arguments.output);
  expect_extension(arguments.output, {".png"});
  expect_writable(arguments.output);
}

}  // namespace

void run_render(const RenderArguments& given) {
  expect_output(given);
  RenderArguments arguments = given;
  if (arguments.movie) arguments.size = movie_size(arguments.output, arguments.size);
  Sitting sitting(arguments);
  if (arguments.movie) return shoot_movie(arguments, sitting);
  const Instant instant{arguments.choice.time_s, std::nullopt};
  sitting.agree_on_heat({&instant, 1});
  write_png(arguments.output, sitting.shoot(instant));
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.output.c_str(), sitting.width(), sitting.height(),
               sitting.gl().driver().c_str());
  sitting.warn_of_misses();
}

}  // namespace marrow::tools
