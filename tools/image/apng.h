// Moving pictures: APNG files (https://wiki.mozilla.org/APNG_Specification), which are PNG files to who knows no
// better.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/few_colours.h"

namespace marrow::tools {

class Apng {
 public:
  // Parts of a second that frames are timed in.
  static constexpr std::uint16_t kTicksPerSecond = 10000;

  // That plays again and again, in these colours. frame_count: how often add() will be called, at least once.
  Apng(std::uint32_t frame_count, Palette palette);

  // All of one size. Of a frame only the rectangle that differs from the one before it is written, and there only the
  // pixels that do. ticks: how long it is shown. Throws Failure (internal) if the encoder fails.
  void add(const Image& frame, std::uint16_t ticks);

  // The file. Precondition: all frames are there.
  std::vector<std::byte> finish();

 private:
  struct Area {
    int x, y, width, height;
  };
  std::vector<std::uint8_t> coloured(const Image& frame) const;
  Area changed(const Image& frame, const std::vector<std::uint8_t>& pixels) const;
  std::vector<std::byte> encode(const Area& area, int width, const std::vector<std::uint8_t>& pixels) const;
  void put_control(const Area& area, std::uint16_t ticks);

  std::uint32_t frame_count_;
  std::uint32_t sequence_ = 0;
  Palette palette_;
  std::vector<std::uint8_t> entries_;  // red, green, blue, opacity: nothing first, then the palette's
  Image last_;
  std::vector<std::uint8_t> shown_;  // of the last frame, an entry a pixel
  std::vector<std::byte> bytes_;
};

}  // namespace marrow::tools
