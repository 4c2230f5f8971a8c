// Moving pictures: APNG files (https://wiki.mozilla.org/APNG_Specification), which are PNG files to who knows no
// better.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/image.h"

namespace marrow::tools {

class Apng {
 public:
  // Parts of a second that frames are timed in.
  static constexpr std::uint16_t kTicksPerSecond = 10000;

  // That plays again and again. frame_count: how often add() will be called, at least once.
  explicit Apng(std::uint32_t frame_count) : frame_count_(frame_count) {}

  // All of one size. Of a frame only the rectangle that differs from the one before it is written. ticks: how long it
  // is shown. Throws Failure (internal) if the encoder fails.
  void add(const Image& frame, std::uint16_t ticks);

  // The file. Precondition: all frames are there.
  std::vector<std::byte> finish();

 private:
  struct Area {
    int x, y, width, height;
  };
  Area changed(const Image& frame) const;
  void put_control(const Area& area, std::uint16_t ticks);

  std::uint32_t frame_count_;
  std::uint32_t sequence_ = 0;
  Image last_;
  std::vector<std::byte> bytes_;
};

}  // namespace marrow::tools
