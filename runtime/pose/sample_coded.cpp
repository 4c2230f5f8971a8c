#include "pose/sample_coded.h"

#include <cstring>

#include "asset/format.h"
#include "math/f32x4.h"
#include "math/slerp.h"

namespace marrow {
namespace {

// Two neighbouring frames of four sub-tracks, one lane each; lanes that are not coded stay zero.
struct alignas(16) Unpacked {
  std::int32_t a[3][4] = {};
  std::int32_t b[3][4] = {};
  float step[4] = {};
};

// What a width code means; tables, since a shift by a variable amount takes three instructions.
struct Widths {
  std::uint8_t bits[16];
  std::uint32_t masks[16];
};
constexpr Widths make_widths() {
  Widths w{};
  for (std::uint32_t code = 0; code < 16; ++code) {
    w.bits[code] = static_cast<std::uint8_t>(format::component_bits(code));
    w.masks[code] = (1u << format::component_bits(code)) - 1;
  }
  return w;
}
constexpr Widths kTable = make_widths();

// Walks the headers of a segment and two of its frame records side by side.
class Reader {
 public:
  Reader(const std::byte* segment, std::uint32_t track_count, std::uint32_t frame) {
    std::uint32_t frame_bits;
    std::memcpy(&frame_bits, segment, 4);
    header_ = segment + 4;
    records_ = header_ + std::size_t{track_count} * sizeof(format::TrackHeader);
    a_ = std::uint64_t{frame_bits} * frame;
    b_ = a_ + frame_bits;
  }

  void unpack(std::uint32_t lane, Unpacked& out) {
    format::TrackHeader h;
    std::memcpy(&h, header_, sizeof h);
    header_ += sizeof h;
    const std::uint32_t widths = h.widths, shift = widths >> 12;
    std::uint64_t a = word(a_), b = word(b_);
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t code = widths >> (4 * c) & 15u;
      const std::uint32_t width = kTable.bits[code], mask = kTable.masks[code];
      const std::uint32_t least = static_cast<std::uint32_t>(std::int32_t{h.least[c]}) << shift;
      out.a[c][lane] = static_cast<std::int32_t>((static_cast<std::uint32_t>(a) & mask) + least);
      out.b[c][lane] = static_cast<std::int32_t>((static_cast<std::uint32_t>(b) & mask) + least);
      a >>= width;
      b >>= width;
      a_ += width;
      b_ += width;
    }
    out.step[lane] = format::step_size(h.step);
  }

 private:
  std::uint64_t word(std::uint64_t bit) const {
    std::uint64_t w;
    std::memcpy(&w, records_ + bit / 8, 8);
    return w >> (bit % 8);
  }

  const std::byte* header_;
  const std::byte* records_;
  std::uint64_t a_, b_;
};

Unpacked unpack_lanes(Reader& reader, std::uint32_t mask) {
  Unpacked four;
  for (std::uint32_t lane = 0; lane < 4; ++lane)
    if ((mask >> lane & 1u) != 0) reader.unpack(lane, four);
  return four;
}

// Up to a factor, a unit quaternion: (m, (1 - m²) / 2), and that factor, 2 / (1 + m²).
struct Quat4 {
  f32x4 x, y, z, w, factor;
};

Quat4 from_rodrigues(const std::int32_t (&m)[3][4], f32x4 step) {
  const f32x4 x = from_ints(m[0]) * step, y = from_ints(m[1]) * step, z = from_ints(m[2]) * step;
  const f32x4 half = splat(0.5f), half_squared = half * dot3(x, y, z, x, y, z);
  return {x, y, z, half - half_squared, splat(1.0f) / (half + half_squared)};
}

// The blend of two frames, the same for every joint.
struct Blend {
  f32x4 u;
  SlerpSeries a, b;
  explicit Blend(float between) : u(splat(between)), a(slerp_series(1.0f - between)), b(slerp_series(between)) {}
};

void rotate_rest(const Unpacked& four, const Blend& blend, float (&rotation)[4][4]) {
  const f32x4 step = load(four.step), one = splat(1.0f);
  const Quat4 a = from_rodrigues(four.a, step), b = from_rodrigues(four.b, step);
  const f32x4 versine = one - (dot3(a.x, a.y, a.z, b.x, b.y, b.z) + a.w * b.w) * (a.factor * b.factor);
  f32x4 wa = slerp_weight(blend.a, versine), wb = slerp_weight(blend.b, versine);
  if (any(splat(kSlerpSeriesLimit) < versine)) {
    const auto [exact_a, exact_b] = slerp_weights(versine + versine, blend.u);
    wa = exact_a;
    wb = exact_b;
  }
  wa = wa * a.factor;
  wb = wb * b.factor;
  const f32x4 x = wa * a.x + wb * b.x, y = wa * a.y + wb * b.y, z = wa * a.z + wb * b.z, w = wa * a.w + wb * b.w;
  const f32x4 rx = load(rotation[0]), ry = load(rotation[1]), rz = load(rotation[2]), rw = load(rotation[3]);
  store(rotation[0], rw * x + rx * w + (ry * z - rz * y));
  store(rotation[1], rw * y + ry * w + (rz * x - rx * z));
  store(rotation[2], rw * z + rz * w + (rx * y - ry * x));
  store(rotation[3], rw * w - dot3(rx, ry, rz, x, y, z));
}

void add_to_rest(const Unpacked& four, f32x4 u, float (&vector)[3][4]) {
  const f32x4 step = load(four.step), b = u * step, a = step - b;
  for (int c = 0; c < 3; ++c) store(vector[c], load(vector[c]) + (from_ints(four.a[c]) * a + from_ints(four.b[c]) * b));
}

}  // namespace

void sample_coded(const CodedTracks& coded, std::uint32_t joint_count, float time_s, SoaTransform* out) {
  const std::uint32_t last = coded.frame_count - 1;
  const float position = (time_s - coded.start_s) * coded.frames_per_s;
  // The last frame is reached from the one before it.
  std::uint32_t frame = 0;
  float between = 0.0f;
  if (position >= static_cast<float>(last)) {
    frame = last - 1;
    between = 1.0f;
  } else if (position > 0.0f) {
    frame = static_cast<std::uint32_t>(position);
    between = position - static_cast<float>(frame);
  }
  const std::uint32_t segment = frame / coded.segment_intervals;
  const std::uint32_t groups = static_cast<std::uint32_t>(soa_count(joint_count));
  Reader reader(coded.payload + coded.segment_offsets[segment], coded.track_count,
                frame - segment * coded.segment_intervals);
  const Blend blend(between);
  for (std::uint32_t g = 0; g < groups; ++g) {
    const std::uint32_t mask = coded.masks[g];
    if ((mask & 0x00Fu) != 0) rotate_rest(unpack_lanes(reader, mask & 15u), blend, out[g].rotation);
    if ((mask & 0x0F0u) != 0) add_to_rest(unpack_lanes(reader, mask >> 4 & 15u), blend.u, out[g].translation);
    if ((mask & 0xF00u) != 0) add_to_rest(unpack_lanes(reader, mask >> 8), blend.u, out[g].scale);
  }
}

}  // namespace marrow
