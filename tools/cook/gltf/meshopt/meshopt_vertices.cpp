#include "cook/gltf/meshopt/meshopt_vertices.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace marrow::cook::gltf {
namespace {

constexpr std::size_t kGroup = 16;                           // elements
constexpr std::size_t kMostInBlock = 256;                    // elements
constexpr std::size_t kBlockBytes = 8192;                    // elements of more than 32 bytes are fewer
constexpr std::size_t kMostStride = 256;                     // bytes
constexpr std::array<std::size_t, 2> kLeastTail = {32, 24};  // bytes, a version

// Bits a delta takes in a group, by the group's two header bits.
using Widths = std::array<unsigned, 4>;
constexpr Widths kWidthsOfVersion0 = {0, 2, 4, 8};
constexpr std::array<Widths, 2> kWidthsOfControl = {{{0, 1, 2, 4}, {1, 2, 4, 8}}};

enum Control : unsigned { kNoDeltas = 2, kPlainDeltas = 3 };  // smaller ones choose widths

enum class Channel : unsigned { bytes, pairs, exclusive_or };

// What is left of the blocks; nothing once more was asked for than there is.
struct Reader {
  std::span<const std::uint8_t> left;
  bool ended = false;

  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > left.size()) {
      ended = true;
      left = {};
      return {};
    }
    const auto taken = left.first(size);
    left = left.subspan(size);
    return taken;
  }
};

// What one byte of each element of a block differs by, with room for a last group.
using Deltas = std::array<std::uint8_t, kMostInBlock>;

// Sixteen deltas of 1, 2 or 4 bits; those with all bits set stand as bytes behind them.
void read_narrow_group(Reader& in, unsigned width, std::uint8_t* to) {
  const auto packed = in.take(kGroup * width / 8);
  if (in.ended) return;
  const unsigned per_byte = 8 / width, most = (1U << width) - 1;
  for (unsigned i = 0; i < kGroup; ++i) {
    const unsigned place = i % per_byte;
    const unsigned shift = width == 1 ? place : 8 - width * (place + 1);
    to[i] = static_cast<std::uint8_t>(packed[i / per_byte] >> shift & most);
  }
  for (unsigned i = 0; i < kGroup; ++i) {
    if (to[i] != most) continue;
    const auto whole = in.take(1);
    if (in.ended) return;
    to[i] = whole[0];
  }
}

void read_groups(Reader& in, const Widths& widths, std::size_t count, Deltas& to) {
  const std::size_t groups = (count + kGroup - 1) / kGroup;
  const auto header = in.take((groups + 3) / 4);
  for (std::size_t g = 0; g < groups && !in.ended; ++g) {
    const unsigned width = widths[header[g / 4] >> g % 4 * 2 & 3U];
    std::uint8_t* const group = to.data() + g * kGroup;
    if (width == 0) {
      std::fill_n(group, kGroup, std::uint8_t{0});
    } else if (width == 8) {
      std::ranges::copy(in.take(kGroup), group);
    } else {
      read_narrow_group(in, width, group);
    }
  }
}

// `control` has two bits; of version 0 there are none.
void read_deltas(Reader& in, bool is_version_0, unsigned control, std::size_t count, Deltas& to) {
  if (is_version_0) return read_groups(in, kWidthsOfVersion0, count, to);
  if (control == kNoDeltas) {
    to.fill(0);
  } else if (control == kPlainDeltas) {
    std::ranges::copy(in.take(count), to.data());
  } else {
    read_groups(in, kWidthsOfControl[control], count, to);
  }
}

// 0, -1, 1, -2 … as 0, 1, 2, 3 …
template <class T>
T unzigzag(T v) {
  return static_cast<T>((v & 1U) != 0 ? ~(v >> 1U) : v >> 1U);
}

template <class T>
T number_at(const std::uint8_t* bytes) {
  std::uint32_t out = 0;
  for (unsigned b = 0; b < sizeof(T); ++b) out |= std::uint32_t{bytes[b]} << 8 * b;
  return static_cast<T>(out);
}

// Adds deltas up to numbers, of the four bytes of a channel. `last` is the element before, and becomes the last one.
template <class T, class Add>
void add_up(const std::array<Deltas, 4>& deltas, std::size_t count, std::size_t stride, std::uint8_t* last,
            std::byte* to, Add add) {
  for (unsigned first = 0; first < 4; first += sizeof(T)) {
    T number = number_at<T>(last + first);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<std::uint8_t, sizeof(T)> delta;
      for (unsigned b = 0; b < sizeof(T); ++b) delta[b] = deltas[first + b][i];
      number = add(number, number_at<T>(delta.data()));
      for (unsigned b = 0; b < sizeof(T); ++b) to[i * stride + first + b] = std::byte(number >> 8 * b & 0xFFU);
    }
    for (unsigned b = 0; b < sizeof(T); ++b) last[first + b] = static_cast<std::uint8_t>(number >> 8 * b & 0xFFU);
  }
}

// Low four bits: what a delta is; high four bits: by how many bits one of the third kind was turned.
void add_channel(unsigned mode, const std::array<Deltas, 4>& deltas, std::size_t count, std::size_t stride,
                 std::uint8_t* last, std::byte* to) {
  const auto plus = []<class T>(T number, T delta) { return static_cast<T>(number + unzigzag(delta)); };
  switch (static_cast<Channel>(mode & 0xFU)) {
    case Channel::bytes:
      return add_up<std::uint8_t>(deltas, count, stride, last, to, plus);
    case Channel::pairs:
      return add_up<std::uint16_t>(deltas, count, stride, last, to, plus);
    case Channel::exclusive_or:
      break;
  }
  const int turn = static_cast<int>(mode >> 4U);
  add_up<std::uint32_t>(deltas, count, stride, last, to,
                        [turn](std::uint32_t number, std::uint32_t delta) { return number ^ std::rotr(delta, turn); });
}

bool is_channel_mode(std::uint8_t mode) {
  const auto kind = static_cast<Channel>(mode & 0xFU);
  return kind == Channel::exclusive_or || ((kind == Channel::bytes || kind == Channel::pairs) && mode >> 4U == 0);
}

std::size_t block_size(std::size_t stride) {
  return std::min(kBlockBytes / stride / kGroup * kGroup, kMostInBlock);
}

}  // namespace

// Version 0: two bits a column of sixteen elements. Version 1: two bits a column of a block.
std::uint64_t least_vertex_bytes(std::span<const std::byte> coded, std::uint64_t count, std::uint32_t stride) {
  const bool is_version_0 = coded.empty() || coded[0] == std::byte{0xA0};
  return is_version_0 ? count / 64 * stride : count / kMostInBlock * (stride / 4);
}

bool decode_vertices(std::span<const std::byte> coded, std::uint32_t stride, std::span<std::byte> elements) {
  const std::span<const std::uint8_t> bytes(reinterpret_cast<const std::uint8_t*>(coded.data()), coded.size());
  if (bytes.empty() || (bytes[0] != 0xA0 && bytes[0] != 0xA1)) return false;
  const unsigned version = bytes[0] & 1U;
  const std::size_t tail = stride + (version == 0 ? 0 : stride / 4), padded = std::max(tail, kLeastTail[version]);
  if (bytes.size() - 1 < padded) return false;
  const auto modes = bytes.last(tail).subspan(stride);  // none in version 0
  if (!std::ranges::all_of(modes, is_channel_mode)) return false;

  std::array<std::uint8_t, kMostStride> last;
  std::ranges::copy(bytes.last(tail).first(stride), last.data());
  Reader in{bytes.subspan(1, bytes.size() - 1 - padded)};
  std::array<Deltas, 4> deltas;
  while (!elements.empty()) {
    const std::size_t count = std::min(elements.size() / stride, block_size(stride));
    const auto controls = in.take(modes.size());
    for (std::size_t c = 0; c < stride / 4 && !in.ended; ++c) {
      for (unsigned b = 0; b < 4 && !in.ended; ++b)
        read_deltas(in, version == 0, version == 0 ? 0 : controls[c] >> 2 * b & 3U, count, deltas[b]);
      if (!in.ended)
        add_channel(version == 0 ? 0 : modes[c], deltas, count, stride, last.data() + 4 * c, elements.data() + 4 * c);
    }
    if (in.ended) return false;
    elements = elements.subspan(count * stride);
  }
  return in.left.empty();
}

}  // namespace marrow::cook::gltf
