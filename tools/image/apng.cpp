#include "image/apng.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <span>

namespace marrow::tools {
namespace {

constexpr std::size_t kSignatureBytes = 8;

using Bytes = std::vector<std::byte>;

void put(Bytes& to, std::uint32_t number, std::size_t bytes = 4) {
  for (std::size_t i = bytes; i-- > 0;) to.push_back(static_cast<std::byte>(number >> 8 * i & 0xFF));
}

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t i = at; i < at + 4; ++i) n = n << 8 | static_cast<std::uint32_t>(bytes[i]);
  return n;
}

// Length, type, data, and the check sum of the last two. `prefix` comes first in the data.
void put_chunk(Bytes& to, const char* type, std::span<const std::byte> prefix, std::span<const std::byte> data = {}) {
  put(to, static_cast<std::uint32_t>(prefix.size() + data.size()));
  const std::size_t start = to.size();
  for (int i = 0; i < 4; ++i) to.push_back(static_cast<std::byte>(type[i]));
  to.insert(to.end(), prefix.begin(), prefix.end());
  to.insert(to.end(), data.begin(), data.end());
  const auto* const summed = reinterpret_cast<const unsigned char*>(to.data() + start);
  put(to, static_cast<std::uint32_t>(crc32(0, summed, static_cast<uInt>(to.size() - start))));
}

// Calls take(type, data, whole chunk) for each chunk of our own encoder's file.
template <class Take>
void for_each_chunk(std::span<const std::byte> png, const Take& take) {
  for (std::size_t at = kSignatureBytes; at + 12 <= png.size();) {
    const std::size_t length = number_at(png, at);
    take(std::string_view(reinterpret_cast<const char*>(png.data() + at + 4), 4), png.subspan(at + 8, length),
         png.subspan(at, length + 12));
    at += length + 12;
  }
}

}  // namespace

Apng::Area Apng::changed(const Image& frame) const {
  if (last_.rgb.empty()) return {0, 0, frame.width, frame.height};
  int left = frame.width, right = 0, top = frame.height, bottom = 0;
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* const row = frame.pixel(0, y);
    const std::uint8_t* const old = last_.pixel(0, y);
    const std::ptrdiff_t bytes = std::ptrdiff_t{3} * frame.width;
    const std::ptrdiff_t first = std::mismatch(row, row + bytes, old).first - row;
    if (first == bytes) continue;
    std::ptrdiff_t end = bytes;
    while (row[end - 1] == old[end - 1]) --end;
    left = std::min(left, static_cast<int>(first / 3));
    right = std::max(right, static_cast<int>((end + 2) / 3));
    top = std::min(top, y);
    bottom = y + 1;
  }
  // A frame cannot be empty.
  return bottom == 0 ? Area{0, 0, 1, 1} : Area{left, top, right - left, bottom - top};
}

void Apng::put_control(const Area& area, std::uint16_t ticks) {
  Bytes data;
  put(data, sequence_++);
  for (const int number : {area.width, area.height, area.x, area.y}) put(data, static_cast<std::uint32_t>(number));
  put(data, ticks, 2);
  put(data, kTicksPerSecond, 2);
  put(data, 0, 1);  // afterwards the frame stays where it is
  put(data, 0, 1);  // and it replaces what was there
  put_chunk(bytes_, "fcTL", data);
}

void Apng::add(const Image& frame, std::uint16_t ticks) {
  const bool first = last_.rgb.empty();
  const Area area = changed(frame);
  Image part(area.width, area.height);
  paste(part, frame, -area.x, -area.y);
  const Bytes png = encode_png(part);
  if (first) bytes_.assign(png.begin(), png.begin() + kSignatureBytes);
  bool controlled = false;
  for_each_chunk(png, [&](std::string_view type, std::span<const std::byte> data, std::span<const std::byte> chunk) {
    if (type == "IEND") return;
    if (type != "IDAT") {
      if (!first) return;
      bytes_.insert(bytes_.end(), chunk.begin(), chunk.end());
      if (type != "IHDR") return;
      Bytes animation;
      put(animation, frame_count_);
      put(animation, 0);  // without end
      return put_chunk(bytes_, "acTL", animation);
    }
    if (!controlled) put_control(area, ticks);
    controlled = true;
    if (first) {
      bytes_.insert(bytes_.end(), chunk.begin(), chunk.end());
    } else {
      Bytes sequence;
      put(sequence, sequence_++);
      put_chunk(bytes_, "fdAT", sequence, data);
    }
  });
  last_ = frame;
}

std::vector<std::byte> Apng::finish() {
  put_chunk(bytes_, "IEND", {});
  return std::move(bytes_);
}

}  // namespace marrow::tools
