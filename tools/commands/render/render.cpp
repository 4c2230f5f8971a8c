#include "commands/render/render.h"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>

#include "behave/open_character.h"
#include "commands/render/movie.h"
#include "commands/render/sitting.h"
#include "commands/render/trace.h"
#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "image/caption.h"

namespace marrow::tools {

namespace {

constexpr int kFilmColumns = 8, kFilmGap = 2;
constexpr int kMostFilmPixels = 16384;

void expect_output(const RenderArguments& arguments) {
  if (!arguments.trace.empty()) {
    expect_extension(arguments.trace, {".json"});
    expect_writable(arguments.trace);
  }
  if (arguments.output.empty()) return;
  if (arguments.movie) return expect_movie_output(arguments.output);
  expect_extension(arguments.output, {".png"});
  expect_writable(arguments.output);
}

// Moments of what is played, from its first to its last; of what goes round the last is the first.
std::vector<Instant> moments_of(const Sitting& sitting, int count) {
  std::vector<Instant> out;
  const float steps = static_cast<float>(sitting.is_acting() ? std::max(count - 1, 1) : count);
  for (int i = 0; i < count; ++i) out.push_back({sitting.duration_s() * static_cast<float>(i) / steps, std::nullopt});
  return out;
}

// Moments beside each other, and in rows where there are many.
Image film_strip(Sitting& sitting, int count) {
  const std::vector<Instant> moments = moments_of(sitting, count);
  sitting.agree_on_heat(moments);
  const int rows = (count + kFilmColumns - 1) / kFilmColumns, columns = (count + rows - 1) / rows;
  const int width = columns * (sitting.width() + kFilmGap) - kFilmGap,
            height = rows * (sitting.height() + kFilmGap) - kFilmGap;
  if (width > kMostFilmPixels || height > kMostFilmPixels)
    throw Failure(Exit::usage, "--film", "", fmt::format("{}x{} pixels in all are too many", width, height),
                  fmt::format("at most {} each way: lower --size or the number of moments", kMostFilmPixels));
  Image out(width, height, {16, 18, 20});
  for (int i = 0; i < count; ++i) {
    const Instant& moment = moments[static_cast<std::size_t>(i)];
    Image image = sitting.shoot(moment);
    const float letters = std::max(7.0f, static_cast<float>(image.height) / 36);
    draw_text(image, letters, static_cast<float>(image.height) - letters, letters, {40, 44, 48},
              fmt::format("{:.2f} s", moment.time_s));
    paste(out, image, i % columns * (sitting.width() + kFilmGap), i / columns * (sitting.height() + kFilmGap));
  }
  return out;
}

// What it does is no picture: it needs no driver.
void trace(const RenderArguments& arguments, const File& file) {
  Acting acting(arguments.file, file, *arguments.acting);
  const double end_s =
      arguments.held ? static_cast<double>(arguments.choice.time_s) : static_cast<double>(acting.duration_s());
  write_file_atomically(arguments.trace, trace_text(arguments.file, acting, end_s, arguments.fps));
}

}  // namespace

void run_render(const RenderArguments& given) {
  expect_output(given);
  if (given.output.empty())
    return trace(given, open_character(given.file, {.takes_roots = true, .look = {}}).loaded.file);
  RenderArguments arguments = given;
  if (arguments.movie) arguments.size = movie_size(arguments.output, arguments.size);
  Sitting sitting(arguments);
  if (!arguments.trace.empty()) trace(arguments, sitting.file());
  if (arguments.movie) return shoot_movie(arguments, sitting);
  Image image;
  if (arguments.film) {
    image = film_strip(sitting, *arguments.film);
  } else {
    const Instant instant{arguments.choice.time_s, std::nullopt};
    sitting.agree_on_heat({&instant, 1});
    image = sitting.shoot(instant);
  }
  write_png(arguments.output, image);
  std::fprintf(stderr, "%s: %dx%d, %s\n", arguments.output.c_str(), image.width, image.height,
               sitting.gl().driver().c_str());
  sitting.warn_of_misses();
}

}  // namespace marrow::tools
