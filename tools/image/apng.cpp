#include "image/apng.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>

#include "common/failure.h"

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

Apng::Apng(std::uint32_t frame_count, Palette palette)
    : frame_count_(frame_count), palette_(std::move(palette)), entries_(4 * (1 + Palette::kMost), 0xFF) {
  std::fill_n(entries_.begin(), 4, std::uint8_t{0});
  for (std::size_t i = 0; i < palette_.colours.size(); ++i)
    std::ranges::copy(palette_.colours[i], entries_.begin() + static_cast<std::ptrdiff_t>(4 * (i + 1)));
}

std::vector<std::uint8_t> Apng::coloured(const Image& frame) const {
  std::vector<std::uint8_t> out = shown_;
  out.resize(frame.rgb.size() / 3);
  std::size_t at = 0;
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x, ++at) {
      const std::uint8_t* const colour = frame.pixel(x, y);
      if (!shown_.empty() && std::equal(colour, colour + 3, last_.pixel(x, y))) continue;
      out[at] = static_cast<std::uint8_t>(1 + palette_.index(colour, x, y));
    }
  return out;
}

Apng::Area Apng::changed(const Image& frame, const std::vector<std::uint8_t>& pixels) const {
  if (shown_.empty()) return {0, 0, frame.width, frame.height};
  int left = frame.width, right = 0, top = frame.height, bottom = 0;
  for (int y = 0; y < frame.height; ++y) {
    const std::uint8_t* const row = pixels.data() + std::ptrdiff_t{y} * frame.width;
    const std::uint8_t* const old = shown_.data() + std::ptrdiff_t{y} * frame.width;
    const auto first = static_cast<int>(std::mismatch(row, row + frame.width, old).first - row);
    if (first == frame.width) continue;
    int end = frame.width;
    while (row[end - 1] == old[end - 1]) --end;
    left = std::min(left, first);
    right = std::max(right, end);
    top = std::min(top, y);
    bottom = y + 1;
  }
  // A frame cannot be empty.
  return bottom == 0 ? Area{0, 0, 1, 1} : Area{left, top, right - left, bottom - top};
}

// What is as before is written as nothing: that takes least.
Bytes Apng::encode(const Area& area, int width, const std::vector<std::uint8_t>& pixels) const {
  std::vector<std::uint8_t> part;
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) {
      const auto at = static_cast<std::size_t>(std::ptrdiff_t{y} * width + x);
      part.push_back(!shown_.empty() && pixels[at] == shown_[at] ? 0 : pixels[at]);
    }
  png_image header = {};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(area.width);
  header.height = static_cast<png_uint_32>(area.height);
  header.format = PNG_FORMAT_RGBA_COLORMAP;
  header.colormap_entries = static_cast<png_uint_32>(entries_.size() / 4);
  Bytes bytes(PNG_IMAGE_PNG_SIZE_MAX(header));
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, part.data(), 0, entries_.data()) == 0)
    throw Failure(Exit::internal, "PNG", "", header.message, "please report this");
  bytes.resize(size);
  return bytes;
}

void Apng::put_control(const Area& area, std::uint16_t ticks) {
  Bytes data;
  put(data, sequence_++);
  for (const int number : {area.width, area.height, area.x, area.y}) put(data, static_cast<std::uint32_t>(number));
  put(data, ticks, 2);
  put(data, kTicksPerSecond, 2);
  put(data, 0, 1);                       // afterwards the frame stays where it is
  put(data, shown_.empty() ? 0 : 1, 1);  // the first replaces what was there, others lie over it
  put_chunk(bytes_, "fcTL", data);
}

void Apng::add(const Image& frame, std::uint16_t ticks) {
  const bool first = shown_.empty();
  std::vector<std::uint8_t> pixels = coloured(frame);
  const Area area = changed(frame, pixels);
  const Bytes png = encode(area, frame.width, pixels);
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
  shown_ = std::move(pixels);
}

std::vector<std::byte> Apng::finish() {
  put_chunk(bytes_, "IEND", {});
  return std::move(bytes_);
}

}  // namespace marrow::tools
