// GIF, MP4, WebM and animated WebP, by the program ffmpeg.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>

#include "image/image.h"

namespace marrow::tools {

// .gif, .mp4, .webm or .webp.
bool is_film(const std::string& output);

// Throws Failure (unsupported) if there is no ffmpeg on the PATH.
void expect_ffmpeg(const std::string& output);

// An ffmpeg that is fed with frames. It writes into a file without a name, which finish() copies to the output: that is
// the old file or the new one, whole, however the process ends. No shell and no file name is in between.
class Film {
 public:
  struct Shape {
    int width, height;  // even, but for GIF and WebP
    std::size_t frames;
    double duration_s;
  };
  // Throws Failure: unsupported without ffmpeg, io if it cannot be started.
  Film(std::string output, const Shape& shape);
  // Without finish() the output stays as it was.
  ~Film();
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  // Of the shape's size. Throws Failure (io) with ffmpeg's last line if it has ended.
  void add(const Image& frame);
  // After the last frame. Throws Failure (io).
  void finish();

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using OwnedFile = std::unique_ptr<std::FILE, CloseFile>;

  void start(const std::string& program, const Shape& shape);
  bool end();  // waits; whether ffmpeg was content
  [[noreturn]] void complain() const;

  std::string output_;
  OwnedFile made_, said_;  // without names: the film, ffmpeg's stderr
  int frames_ = -1;        // a socket, as writing to a pipe whose reader is gone is a signal
  pid_t child_ = -1;
};

}  // namespace marrow::tools
