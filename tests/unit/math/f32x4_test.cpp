// The SIMD layer against plain scalar loops, bit for bit, over ranges and corners of float.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "math/vector.h"
#include "support/bad_numbers.h"
#include "support/rig.h"

namespace marrow {
namespace {

using test::kInfinity;
using test::kNan;

// Corners, then exponents across the whole range with random fractions and signs.
std::vector<float> interesting() {
  std::vector<float> out = {0.0f,
                            -0.0f,
                            1.0f,
                            -1.0f,
                            0.5f,
                            3.0f,
                            kInfinity,
                            -kInfinity,
                            kNan,
                            -kNan,
                            std::numeric_limits<float>::min(),
                            -std::numeric_limits<float>::min(),
                            std::numeric_limits<float>::denorm_min(),
                            -std::numeric_limits<float>::denorm_min(),
                            std::bit_cast<float>(0x007FFFFFu),
                            std::numeric_limits<float>::max(),
                            -std::numeric_limits<float>::max(),
                            std::nextafter(1.0f, 0.0f),
                            std::nextafter(1.0f, 2.0f)};
  test::Random random(1);
  for (std::uint32_t exponent = 0; exponent < 255; exponent += 3) {
    out.push_back(std::bit_cast<float>((random.bits() << 31) | exponent << 23 | (random.bits() & 0x7FFFFFu)));
  }
  return out;
}

// Equal bits; any NaN equals any other, whose sign and payload differ between processors.
bool same(float a, float b) {
  return (a != a && b != b) || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

void expect_lanes(f32x4 got, const float (&want)[4], const char* what) {
  float lanes[4];
  store(lanes, got);
  for (int i = 0; i < 4; ++i)
    ASSERT_TRUE(same(lanes[i], want[i])) << what << " lane " << i << ": " << lanes[i] << " for " << want[i];
}

// Every pair of interesting numbers, four pairs at a time.
template <class Check>
int for_pairs(Check check) {
  const std::vector<float> numbers = interesting();
  std::vector<float> a, b;
  for (const float x : numbers)
    for (const float y : numbers) a.push_back(x), b.push_back(y);
  while (a.size() % 4 != 0) a.push_back(1.0f), b.push_back(1.0f);
  int cases = 0;
  for (std::size_t i = 0; i < a.size(); i += 4, ++cases) check(&a[i], &b[i]);
  return cases;
}

TEST(F32x4, ArithmeticEqualsScalar) {
  const int cases = for_pairs([](const float* a, const float* b) {
    const f32x4 x = load(a), y = load(b);
    const float sum[4] = {a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]};
    const float difference[4] = {a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]};
    const float product[4] = {a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]};
    const float quotient[4] = {a[0] / b[0], a[1] / b[1], a[2] / b[2], a[3] / b[3]};
    expect_lanes(x + y, sum, "+");
    expect_lanes(x - y, difference, "-");
    expect_lanes(x * y, product, "*");
    expect_lanes(x / y, quotient, "/");
  });
  EXPECT_GT(cases, 2500);
}

TEST(F32x4, ComparisonAndSelection) {
  const int cases = for_pairs([](const float* a, const float* b) {
    float want[4];
    for (int i = 0; i < 4; ++i) want[i] = a[i] < b[i] ? a[i] : b[i];
    const f32x4 x = load(a), y = load(b);
    expect_lanes(select(x < y, x, y), want, "select");
  });
  EXPECT_GT(cases, 2500);
}

TEST(F32x4, SignsAndRanges) {
  const int cases = for_pairs([](const float* a, const float* b) {
    float flipped[4], clamped[4];
    bool less = false;
    for (int i = 0; i < 4; ++i) {
      flipped[i] = std::signbit(b[i]) ? -a[i] : a[i];
      clamped[i] = a[i] > 0 ? std::fmin(a[i], 1.0f) : 0.0f;
      less |= a[i] < b[i];
    }
    alignas(16) const float aligned[4] = {a[0], a[1], a[2], a[3]};
    const f32x4 x = load_aligned(aligned), y = load(b);
    expect_lanes(flip(x, y), flipped, "flip");
    expect_lanes(clamp_to_unit(x), clamped, "clamp_to_unit");
    ASSERT_EQ(any(x < y), less);
  });
  EXPECT_GT(cases, 2500);
}

// Products that a fused multiply-add would round once instead of twice.
TEST(F32x4, NothingIsFused) {
  test::Random random(2);
  int differing = 0;
  for (int i = 0; i < 4000; ++i) {
    float a[4], b[4], c[4], want[4];
    for (int lane = 0; lane < 4; ++lane) {
      a[lane] = std::bit_cast<float>(0x3F800000u | (random.bits() & 0x7FFFFFu));
      b[lane] = std::bit_cast<float>(0x3F800000u | (random.bits() & 0x7FFFFFu));
      const float rounded = static_cast<float>(static_cast<double>(a[lane]) * static_cast<double>(b[lane]));
      c[lane] = -rounded;
      want[lane] = 0.0f;
      if (std::fma(a[lane], b[lane], c[lane]) != 0.0f) ++differing;
    }
    expect_lanes(load(a) * load(b) + load(c), want, "a * b + c");
    const Vector<f32x4> x = {load(a), splat(0.0f), splat(0.0f)}, y = {load(b), splat(1.0f), splat(1.0f)};
    expect_lanes(dot(x, y) + load(c), want, "dot");
  }
  EXPECT_GT(differing, 8000) << "the numbers must be ones where fusing shows";
}

TEST(F32x4, SquareRoot) {
  std::vector<float> numbers = interesting();
  while (numbers.size() % 4 != 0) numbers.push_back(2.0f);
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    const float* const a = &numbers[i];
    const float want[4] = {std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
    expect_lanes(sqrt(load(a)), want, "sqrt");
  }
}

TEST(F32x4, Shuffles) {
  const float a[4] = {1, -0.0f, kNan, 4}, b[4] = {5, 6, 7, -0.0f}, c[4] = {9, 10, kInfinity, 12},
              d[4] = {13, 14, 15, 16};
  const f32x4 x = load(a);
  for (int lane = 0; lane < 4; ++lane) {
    const float want[4] = {a[lane], a[lane], a[lane], a[lane]};
    const f32x4 got = lane == 0   ? splat_lane<0>(x)
                      : lane == 1 ? splat_lane<1>(x)
                      : lane == 2 ? splat_lane<2>(x)
                                  : splat_lane<3>(x);
    expect_lanes(got, want, "splat_lane");
  }
  expect_lanes(splat(-0.0f), {-0.0f, -0.0f, -0.0f, -0.0f}, "splat");
  expect_lanes(only_w(x), {0, 0, 0, 4}, "only_w");
  expect_lanes(only_w(load(b)), {0, 0, 0, -0.0f}, "only_w of -0");
  f32x4 r0 = load(a), r1 = load(b), r2 = load(c), r3 = load(d);
  transpose(r0, r1, r2, r3);
  expect_lanes(r0, {a[0], b[0], c[0], d[0]}, "transpose");
  expect_lanes(r1, {a[1], b[1], c[1], d[1]}, "transpose");
  expect_lanes(r2, {a[2], b[2], c[2], d[2]}, "transpose");
  expect_lanes(r3, {a[3], b[3], c[3], d[3]}, "transpose");
}

TEST(F32x4, VectorsOfThreeInOneRegister) {
  const f32x4 x = load(std::array<float, 4>{1, -2, 4, 8}.data()), y = load(std::array<float, 4>{5, 6, 7, -0.5f}.data());
  expect_lanes(without_w(x), {1, -2, 4, 0}, "without_w");
  expect_lanes(with_w(x, y), {1, -2, 4, -0.5f}, "with_w");
  expect_lanes(rotated_xyz(x), {-2, 4, 1, 8}, "rotated_xyz");
  expect_lanes(sum_of_lanes(x), {11, 11, 11, 11}, "sum_of_lanes");
  // In pairs: (1 + 2⁻²⁴) + (2⁻²⁴ + 2⁻²⁴) is 1 + 2⁻²³, one after the other would be 1.
  expect_lanes(sum_of_lanes(load(std::array<float, 4>{1, 0x1p-24f, 0x1p-24f, 0x1p-24f}.data())),
               {1 + 0x1p-23f, 1 + 0x1p-23f, 1 + 0x1p-23f, 1 + 0x1p-23f}, "sum_of_lanes");
  expect_lanes(fourths(x, y, splat(3)), {8, -0.5f, 3, 0}, "fourths");
  EXPECT_EQ(first_lane(x), 1);
}

TEST(F32x4, ExtremesAndMasks) {
  const int cases = for_pairs([](const float* a, const float* b) {
    float lesser_one[4], greater_one[4], size[4], where[4];
    bool every = true, numbers = true;
    for (int i = 0; i < 4; ++i) {
      numbers = numbers && a[i] == a[i] && b[i] == b[i] && !(a[i] == 0 && b[i] == 0);
      lesser_one[i] = a[i] < b[i] ? a[i] : b[i];
      greater_one[i] = a[i] < b[i] ? b[i] : a[i];
      size[i] = std::fabs(a[i]);
      where[i] = a[i] < b[i] ? a[i] : 0.0f;
      every = every && a[i] < b[i];
    }
    const f32x4 x = load(a), y = load(b);
    if (numbers) {
      expect_lanes(lesser(x, y), lesser_one, "lesser");
      expect_lanes(greater(x, y), greater_one, "greater");
    }
    expect_lanes(absolute(x), size, "absolute");
    expect_lanes(only_where(x < y, x), where, "only_where");
    ASSERT_EQ(all(x < y), every);
  });
  EXPECT_GT(cases, 2500);
}

TEST(F32x4, StoresTheLanesOfAMaskOnly) {
  int cases = 0;
  for (std::uint32_t set = 0; set < 16; ++set, ++cases) {
    alignas(16) std::uint32_t bits[4];
    alignas(16) float to[4] = {10, 20, 30, 40};
    for (std::uint32_t lane = 0; lane < 4; ++lane) bits[lane] = (set >> lane & 1u) != 0 ? ~0u : 0u;
    const float from[4] = {1, -2, 3, -4};
    store(to, load_mask(bits), load(from));
    for (std::uint32_t lane = 0; lane < 4; ++lane)
      EXPECT_EQ(to[lane], (set >> lane & 1u) != 0 ? from[lane] : 10.0f * static_cast<float>(lane + 1)) << set;
  }
  EXPECT_EQ(cases, 16);
}

TEST(F32x4, WordsForUnpacking) {
  std::byte bytes[33];  // read from an odd address
  for (std::size_t i = 0; i < sizeof(bytes); ++i) bytes[i] = static_cast<std::byte>(i);
  const auto expect_words = [](i32x4 v, std::array<std::uint32_t, 4> want) {
    alignas(16) std::byte got[16];
    store(got, v);
    EXPECT_EQ(std::memcmp(got, want.data(), 16), 0) << want[0];
  };
  const i32x4 a = load_words(bytes + 1), b = load_words(bytes + 17);
  expect_words(a, {0x04030201u, 0x08070605u, 0x0C0B0A09u, 0x100F0E0Du});
  expect_words(even(a, b), {0x04030201u, 0x0C0B0A09u, 0x14131211u, 0x1C1B1A19u});
  expect_words(odd(a, b), {0x08070605u, 0x100F0E0Du, 0x18171615u, 0x201F1E1Du});
  expect_words(words(load_pair(bytes + 21, bytes + 2)), {0x18171615u, 0x1C1B1A19u, 0x05040302u, 0x09080706u});
  alignas(16) const std::uint64_t five[2] = {shift_count(5), shift_count(5)};
  expect_words(words(shift_right(load_pair(bytes + 21, bytes + 2), five)),
               {0xC8C0B8B0u, 0x00E0D8D0u, 0x30282018u, 0x00484038u});
}

TEST(F32x4, SmallIntegersBecomeFloats) {
  // From an odd place, too.
  const std::int16_t in[9] = {0, -32768, 32767, -1, 1, 255, -256, 12345, -32767};
  for (int first = 0; first < 6; ++first) {
    float want[4];
    for (int i = 0; i < 4; ++i) want[i] = static_cast<float>(in[first + i]);
    expect_lanes(load_int16(in + first), want, "load_int16");
  }
}

TEST(F32x4, LoadXyzTakesTwelveFloatsApart) {
  float in[13];
  for (int i = 0; i < 13; ++i) in[i] = static_cast<float>(i);
  f32x4 x = splat(0.0f), y = x, z = x;
  load_xyz(in + 1, x, y, z);
  expect_lanes(x, {1, 4, 7, 10}, "x");
  expect_lanes(y, {2, 5, 8, 11}, "y");
  expect_lanes(z, {3, 6, 9, 12}, "z");
}

TEST(F32x4, LoadTransposedTakesColumns) {
  alignas(16) const float in[4][4] = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
  f32x4 x = splat(0.0f), y = x, z = x, w = x;
  load_transposed(in[2], in[0], in[3], in[1], x, y, z, w);
  expect_lanes(x, {9, 1, 13, 5}, "x");
  expect_lanes(y, {10, 2, 14, 6}, "y");
  expect_lanes(z, {11, 3, 15, 7}, "z");
  expect_lanes(w, {12, 4, 16, 8}, "w");
}

TEST(F32x4, StoreXyzInterleavesAndWritesNoMore) {
  const float x[4] = {1, 2, 3, 4}, y[4] = {5, 6, 7, 8}, z[4] = {9, 10, 11, 12};
  float out[14];
  for (float& f : out) f = -1;
  store_xyz(out + 1, load(x), load(y), load(z));
  EXPECT_EQ(out[0], -1.0f);
  EXPECT_EQ(out[13], -1.0f);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(out[1 + 3 * i], x[i]);
    EXPECT_EQ(out[2 + 3 * i], y[i]);
    EXPECT_EQ(out[3 + 3 * i], z[i]);
  }
}

TEST(F32x4, StoreXyzwInterleavesAndWritesNoMore) {
  const float in[4][4] = {{1, 2, 3, 4}, {5, 6, 7, 8}, {9, 10, 11, 12}, {13, 14, 15, 16}};
  float out[18];
  for (float& f : out) f = -1;
  store_xyzw(out + 1, load(in[0]), load(in[1]), load(in[2]), load(in[3]));
  EXPECT_EQ(out[0], -1.0f);
  EXPECT_EQ(out[17], -1.0f);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(out[1 + i], in[i % 4][i / 4]) << i;
}

TEST(F32x4, TimesALane) {
  const int cases = for_pairs([](const float* a, const float* b) {
    const Factors f = factors(load(b));
    float want[4][4];
    for (int lane = 0; lane < 4; ++lane)
      for (int i = 0; i < 4; ++i) want[lane][i] = a[i] * b[lane];
    expect_lanes(times<0>(load(a), f), want[0], "times<0>");
    expect_lanes(times<1>(load(a), f), want[1], "times<1>");
    expect_lanes(times<2>(load(a), f), want[2], "times<2>");
    expect_lanes(times<3>(load(a), f), want[3], "times<3>");
  });
  EXPECT_GT(cases, 1000);
}

TEST(F32x4, InverseLength) {
  const float squared[4] = {4.0f, 0.0f, 2.0f, kNan};
  expect_lanes(inverse_length(load(squared)), {0.5f, 0.0f, 1.0f / std::sqrt(2.0f), 0.0f}, "inverse_length");
}

}  // namespace
}  // namespace marrow
