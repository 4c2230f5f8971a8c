// Decodes buffer views of EXT_meshopt_compression and KHR_meshopt_compression.
#include "cook/gltf/document/meshopt.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include <meshoptimizer.h>

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

namespace {

// Applies `change` to each element of four numbers.
template <class T, class Change>
void for_each_four(std::span<std::byte> elements, Change change) {
  std::array<T, 4> four;
  for (; elements.size() >= sizeof four; elements = elements.subspan(sizeof four)) {
    std::memcpy(four.data(), elements.data(), sizeof four);
    change(four);
    std::memcpy(elements.data(), four.data(), sizeof four);
  }
}

// A fraction as a normalised integer; 0 for what is no number.
template <class T>
T normalised(double fraction) {
  constexpr double kOne = std::numeric_limits<T>::max();
  constexpr double kLeast = std::is_signed_v<T> ? -1 : 0;
  if (std::isnan(fraction)) return 0;
  return static_cast<T>(std::round(std::clamp(fraction, kLeast, 1.0) * kOne));
}

template <class T>
void unfold_octahedron(std::array<T, 4>& v) {
  const double one = v[2];
  double x = v[0] / one, y = v[1] / one;
  const double z = 1 - std::abs(x) - std::abs(y);
  const double below = std::min(z, 0.0);
  x -= std::copysign(below, x);
  y -= std::copysign(below, y);
  const double length = std::sqrt(x * x + y * y + z * z);
  v[0] = normalised<T>(x / length);
  v[1] = normalised<T>(y / length);
  v[2] = normalised<T>(z / length);
}

void restore_quaternion(std::array<std::int16_t, 4>& v) {
  const unsigned largest = static_cast<std::uint16_t>(v[3]) & 3U;
  const double one = std::sqrt(2.0) * (v[3] | 3);
  const double x = v[0] / one, y = v[1] / one, z = v[2] / one;
  const double w = std::sqrt(std::max(0.0, 1 - x * x - y * y - z * z));
  v[(largest + 1) % 4] = normalised<std::int16_t>(x);
  v[(largest + 2) % 4] = normalised<std::int16_t>(y);
  v[(largest + 3) % 4] = normalised<std::int16_t>(z);
  v[largest] = normalised<std::int16_t>(w);
}

// Luma and two chromas; the highest bit of the fourth number tells how many bits there are.
template <class T>
void restore_colour(std::array<T, 4>& v) {
  const int bits = std::bit_width(v[3]);
  const int whole = (1 << bits) - 1;
  const int luma = v[0], orange = static_cast<std::make_signed_t<T>>(v[1]),
            green = static_cast<std::make_signed_t<T>>(v[2]);
  const int alpha = v[3] & (whole >> 1);
  const double scale = whole == 0 ? 0 : 1.0 / whole;
  v[0] = normalised<T>((luma + orange - green) * scale);
  v[1] = normalised<T>((luma + green) * scale);
  v[2] = normalised<T>((luma - orange - green) * scale);
  v[3] = normalised<T>((alpha << 1 | (alpha & 1)) * scale);
}

}  // namespace

void unfold_octahedra(std::span<std::byte> elements, std::uint32_t stride) {
  if (stride == 4) for_each_four<std::int8_t>(elements, unfold_octahedron<std::int8_t>);
  if (stride == 8) for_each_four<std::int16_t>(elements, unfold_octahedron<std::int16_t>);
}

void restore_quaternions(std::span<std::byte> elements) {
  for_each_four<std::int16_t>(elements, restore_quaternion);
}

void restore_exponents(std::span<std::byte> elements) {
  for (; elements.size() >= 4; elements = elements.subspan(4)) {
    std::int32_t coded;
    std::memcpy(&coded, elements.data(), 4);
    const int exponent = coded >> 24, mantissa = static_cast<std::int32_t>(static_cast<std::uint32_t>(coded) << 8) >> 8;
    const auto number = static_cast<float>(std::ldexp(mantissa, exponent));
    std::memcpy(elements.data(), &number, 4);
  }
}

void restore_colours(std::span<std::byte> elements, std::uint32_t stride) {
  if (stride == 4) for_each_four<std::uint8_t>(elements, restore_colour<std::uint8_t>);
  if (stride == 8) for_each_four<std::uint16_t>(elements, restore_colour<std::uint16_t>);
}

namespace {

constexpr std::array<std::pair<std::string_view, MeshoptView::Mode>, 3> kModes = {
    {{"ATTRIBUTES", MeshoptView::Mode::attributes},
     {"TRIANGLES", MeshoptView::Mode::triangles},
     {"INDICES", MeshoptView::Mode::indices}}};
constexpr std::array<std::pair<std::string_view, MeshoptView::Filter>, 5> kFilters = {
    {{"NONE", MeshoptView::Filter::none},
     {"OCTAHEDRAL", MeshoptView::Filter::octahedral},
     {"QUATERNION", MeshoptView::Filter::quaternion},
     {"EXPONENTIAL", MeshoptView::Filter::exponential},
     {"COLOR", MeshoptView::Filter::color}}};

// The schema has seen to it that the word is one of them.
template <class Words>
auto meaning(const Words& words, const std::string& word) {
  return std::ranges::find(words, word, &Words::value_type::first)->second;
}

bool fits(MeshoptView::Filter filter, std::uint32_t stride) {
  switch (filter) {
    case MeshoptView::Filter::octahedral:
    case MeshoptView::Filter::color:
      return stride == 4 || stride == 8;
    case MeshoptView::Filter::quaternion:
      return stride == 8;
    default:
      return true;
  }
}

void apply_filter(const MeshoptView& view, std::span<std::byte> elements) {
  switch (view.filter) {
    case MeshoptView::Filter::none:
      break;
    case MeshoptView::Filter::octahedral:
      unfold_octahedra(elements, view.stride);
      break;
    case MeshoptView::Filter::quaternion:
      restore_quaternions(elements);
      break;
    case MeshoptView::Filter::exponential:
      restore_exponents(elements);
      break;
    case MeshoptView::Filter::color:
      restore_colours(elements, view.stride);
      break;
  }
}

// Data cost at least so many bytes: a byte a triangle or an index.
std::uint64_t least_length(const MeshoptView& view, std::span<const std::byte> coded) {
  switch (view.mode) {
    case MeshoptView::Mode::attributes:
      return least_vertex_bytes(coded, view.count, view.stride);
    case MeshoptView::Mode::triangles:
      return view.count / 3;
    case MeshoptView::Mode::indices:
      break;
  }
  return view.count;
}

bool decode(const MeshoptView& view, std::span<const std::byte> coded, std::span<std::byte> to) {
  const auto* from = reinterpret_cast<const unsigned char*>(coded.data());
  switch (view.mode) {
    case MeshoptView::Mode::attributes:
      return decode_vertices(coded, view.stride, to);
    case MeshoptView::Mode::triangles:
      return meshopt_decodeIndexBuffer(to.data(), view.count, view.stride, from, coded.size()) == 0;
    case MeshoptView::Mode::indices:
      break;
  }
  return meshopt_decodeIndexSequence(to.data(), view.count, view.stride, from, coded.size()) == 0;
}

}  // namespace

const Json* find_meshopt(const Json& owner, std::string& where) {
  const auto extensions = owner.find("extensions");
  if (extensions == owner.end()) return nullptr;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const auto found = extensions->find(name);
    if (found == extensions->end()) continue;
    where = under(where, "extensions", name);
    return &*found;
  }
  return nullptr;
}

MeshoptView read_meshopt_view(const Json& extension, std::uint64_t length, std::uint32_t stride,
                              const std::string& where, const Report& report) {
  MeshoptView view;
  view.buffer = extension.at("buffer").get<std::size_t>();
  view.offset = extension.value("byteOffset", std::uint64_t{0});
  view.coded_length = extension.at("byteLength").get<std::uint64_t>();
  view.count = extension.at("count").get<std::uint64_t>();
  view.stride = extension.at("byteStride").get<std::uint32_t>();
  view.mode = meaning(kModes, extension.at("mode").get<std::string>());
  view.filter = meaning(kFilters, extension.value("filter", std::string("NONE")));
  const auto refuse = [&](const char* member, const char* why) {
    report.invalid(under(where, member), "not as the extension demands", std::string(why) + "; export again");
  };
  const bool are_attributes = view.mode == MeshoptView::Mode::attributes;
  if (are_attributes ? view.stride % 4 != 0 : view.stride != 2 && view.stride != 4)
    refuse("byteStride", are_attributes ? "a multiple of 4 is needed" : "indices take 2 or 4 bytes");
  if (view.mode == MeshoptView::Mode::triangles && view.count % 3 != 0) refuse("count", "a triangle has three corners");
  if (!are_attributes && view.filter != MeshoptView::Filter::none) refuse("filter", "indices are not filtered");
  if (!fits(view.filter, view.stride)) refuse("filter", "it is for elements of another size");
  if (view.count * view.stride != length) refuse("count", "count times byteStride must be the view's byteLength");
  if (stride != 0 && stride != view.stride) refuse("byteStride", "it must be the view's own");
  return view;
}

std::vector<std::byte> decode_meshopt(const MeshoptView& view, std::span<const std::byte> coded,
                                      const std::string& where, const Report& report) {
  if (coded.size() < least_length(view, coded))
    report.invalid(where, "damaged meshopt data", "too few bytes for so many elements; export again");
  std::vector<std::byte> elements(view.count * view.stride);
  if (!decode(view, coded, elements))
    report.invalid(where, "damaged meshopt data", "it cannot be decoded; export again");
  apply_filter(view, elements);
  return elements;
}

}  // namespace marrow::cook::gltf
