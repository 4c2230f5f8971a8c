#include "commands/render/movie.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "common/failure.h"
#include "common/formats.h"
#include "disk/files.h"
#include "image/apng.h"
#include "image/film.h"
#include "terminal/progress.h"
#include "text/quantity.h"

namespace marrow::tools {
namespace {

constexpr double kMostFrames = 3600;
// Of an APNG, which is in memory until it is whole (at most a byte a pixel, mostly a tenth), and of a GIF, whose frames
// ffmpeg keeps until it has seen the last one's colours.
constexpr std::size_t kMostPixels = std::size_t{1} << 30;
constexpr double kMostGifFps = 50;    // what is faster, browsers play at 10
constexpr std::size_t kSamples = 16;  // frames of which an APNG has the colours
constexpr double kTurnDegPerS = 60;
constexpr double kRadPerDeg = 0.017453292519943295;

// The number after a `%` at `at`: digits and where it ends; nothing if it is no number.
struct Number {
  int digits;
  std::size_t end;
};
std::optional<Number> number_at(const std::string& text, std::size_t at) {
  std::size_t end = at + 1;
  if (end < text.size() && text[end] == '0') ++end;
  int digits = 1;
  if (end < text.size() && text[end] >= '1' && text[end] <= '9') digits = text[end++] - '0';
  if (end >= text.size() || text[end] != 'd') return std::nullopt;
  return Number{digits, end + 1};
}

std::uint16_t ticks(const Movie& movie, std::size_t frame) {
  // Ends are rounded, not lengths, so that errors do not add up.
  const auto end = [&](std::size_t i) {
    const double share = static_cast<double>(i) / static_cast<double>(movie.instants.size());
    return std::lround(movie.duration_s * share * Apng::kTicksPerSecond);
  };
  return static_cast<std::uint16_t>(std::clamp(end(frame + 1) - end(frame), 1L, 65535L));
}

// Where frames go, one after the other.
class Reel {
 public:
  virtual ~Reel() = default;
  virtual void add(std::size_t number, const Image& frame) = 0;
  virtual void finish() = 0;
};

class NumberedFrames : public Reel {
 public:
  explicit NumberedFrames(FrameNames names) : names_(std::move(names)) {
    if (!names_.folder.empty()) create_folders(names_.folder);
  }
  void add(std::size_t number, const Image& frame) override { write_png(names_.name(number), frame); }
  void finish() override {}

 private:
  FrameNames names_;
};

class AnimatedPng : public Reel {
 public:
  AnimatedPng(const std::string& output, const Movie& movie, Sitting& sitting)
      : output_(output), movie_(movie), apng_(static_cast<std::uint32_t>(movie.instants.size()), palette(sitting)) {}
  void add(std::size_t number, const Image& frame) override { apng_.add(frame, ticks(movie_, number)); }
  void finish() override { write_file_atomically(output_, apng_.finish()); }

 private:
  Palette palette(Sitting& sitting) const {
    std::vector<Image> samples;
    const std::size_t count = movie_.instants.size();
    for (std::size_t i = 0; i < count; i += (count + kSamples - 1) / kSamples)
      samples.push_back(sitting.glimpse(movie_.instants[i]));
    return Palette::of(samples);
  }

  const std::string& output_;
  const Movie& movie_;
  Apng apng_;
};

class Video : public Reel {
 public:
  Video(const std::string& output, const Film::Shape& shape) : film_(output, shape) {}
  void add(std::size_t, const Image& frame) override { film_.add(frame); }
  void finish() override { film_.finish(); }

 private:
  Film film_;
};

void expect_small_enough(const RenderArguments& arguments, const Movie& movie, const Sitting& sitting) {
  const std::size_t frames = movie.instants.size();
  const std::size_t pixels = static_cast<std::size_t>(sitting.width()) * static_cast<std::size_t>(sitting.height());
  const bool is_gif = has_extension(arguments.output, ".gif");
  if ((is_gif || !is_film(arguments.output)) && frames > kMostPixels / pixels)
    throw Failure(Exit::usage, arguments.output, "",
                  fmt::format("{} frames of {} are too large for one file", frames, arguments.size),
                  "lower --size or --fps, or write numbered frames, -o frames/, or an .mp4");
  if (is_gif && static_cast<double>(frames) > kMostGifFps * movie.duration_s)
    throw Failure(Exit::usage, "--fps", "", fmt::format("a GIF shows at most {:.0f} frames a second", kMostGifFps),
                  "lower --fps, or write an .mp4");
}

std::unique_ptr<Reel> make_reel(const RenderArguments& arguments, const Movie& movie, Sitting& sitting) {
  if (std::optional<FrameNames> names = parse_frame_names(arguments.output))
    return std::make_unique<NumberedFrames>(std::move(*names));
  expect_small_enough(arguments, movie, sitting);
  if (!is_film(arguments.output)) return std::make_unique<AnimatedPng>(arguments.output, movie, sitting);
  return std::make_unique<Video>(
      arguments.output, Film::Shape{sitting.width(), sitting.height(), movie.instants.size(), movie.duration_s});
}

}  // namespace

Movie plan_movie(const RenderArguments& arguments, float duration_s, bool goes_round) {
  const double clip_s = arguments.held ? 0 : static_cast<double>(duration_s);
  const bool plays = clip_s > 0;
  const double turn_deg = arguments.turn_deg ? static_cast<double>(*arguments.turn_deg) : plays ? 0 : 360;
  if (!plays && turn_deg == 0)
    throw Failure(Exit::usage, "--movie", "", "nothing would move", "name a clip without --time, or give --turn");
  const double turn_s = std::abs(turn_deg) / kTurnDegPerS;
  Movie movie;
  movie.duration_s = !plays ? turn_s : goes_round ? clip_s * std::max(1.0, std::ceil(turn_s / clip_s)) : clip_s;
  const double frames = std::max(1.0, std::round(movie.duration_s * arguments.fps));
  if (!(frames <= kMostFrames))
    throw Failure(
        Exit::usage, "--movie", "",
        fmt::format("{} s at {} frames a second are too many frames", plain_number(movie.duration_s, 4), arguments.fps),
        fmt::format("at most {:.0f}: lower --fps", kMostFrames));
  for (int i = 0; i < static_cast<int>(frames); ++i) {
    Instant& instant = movie.instants.emplace_back();
    const double time_s = movie.duration_s * i / frames;
    instant.time_s = plays ? static_cast<float>(std::fmod(time_s, clip_s)) : arguments.choice.time_s;
    if (turn_deg != 0) instant.turn_rad = static_cast<float>(turn_deg * kRadPerDeg * i / frames);
  }
  return movie;
}

std::string FrameNames::name(std::size_t frame) const {
  return fmt::format("{}{:0{}}{}", before, frame, digits, after);
}

std::optional<FrameNames> parse_frame_names(const std::string& output) {
  std::error_code ignored;
  if (output.ends_with('/') || std::filesystem::is_directory(output, ignored))
    return FrameNames{output, output.ends_with('/') ? output : output + "/", ".png"};
  std::optional<FrameNames> names;
  const std::size_t name_start = output.find_last_of('/') + 1;  // 0 without a folder
  for (std::size_t at = output.find('%', name_start); at != std::string::npos; at = output.find('%', at + 1)) {
    const std::optional<Number> number = number_at(output, at);
    if (!number) continue;
    if (names) throw Failure(Exit::usage, output, "", "two numbers in a frame's name", "give one, as in frame%04d.png");
    names = FrameNames{"", output.substr(0, at), output.substr(number->end), number->digits};
  }
  return names;
}

void expect_movie_output(const std::string& output) {
  const std::optional<FrameNames> names = parse_frame_names(output);
  if (names && !names->folder.empty()) return expect_folder(names->folder);
  const std::string first = names ? names->name(0) : output;
  if (names) {
    expect_extension(first, {".png", ".apng"});
  } else {
    expect_extension(first, {".png", ".apng", ".gif", ".mp4", ".webm", ".webp"});
  }
  expect_writable(first);
  if (is_film(first)) expect_ffmpeg(first);
}

const char* default_movie_size(const std::string& output) {
  const bool streamed = parse_frame_names(output) || has_extension(output, ".mp4") || has_extension(output, ".webm");
  return streamed ? "960x720" : "480x360";
}

std::string movie_size(const std::string& output, const std::string& size) {
  if (!is_film(output) || has_extension(output, ".gif") || has_extension(output, ".webp")) return size;
  const auto [width, height] = parse_size(size);
  return fmt::format("{}x{}", width + width % 2, height + height % 2);
}

void shoot_movie(const RenderArguments& arguments, Sitting& sitting) {
  const Movie movie = plan_movie(arguments, sitting.duration_s(), !sitting.is_acting());
  const std::size_t frames = movie.instants.size();
  sitting.agree_on_heat(movie.instants);
  const std::unique_ptr<Reel> reel = make_reel(arguments, movie, sitting);
  {
    Progress progress;
    for (std::size_t i = 0; i < frames; ++i) {
      progress.show(i, frames, "drawing");
      reel->add(i, sitting.shoot(movie.instants[i]));
    }
    if (is_film(arguments.output)) progress.show(0, 0, "encoding");
    reel->finish();
  }
  std::fputs(fmt::format("{}: {}x{}, {} frames, {} s, {}\n", arguments.output, sitting.width(), sitting.height(),
                         frames, plain_number(movie.duration_s), sitting.gl().driver())
                 .c_str(),
             stderr);
  sitting.warn_of_misses();
}

}  // namespace marrow::tools
