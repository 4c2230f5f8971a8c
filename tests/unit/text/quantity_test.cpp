// Numbers as people read them.
#include "text/quantity.h"

#include <limits>

#include <gtest/gtest.h>

namespace marrow::tools {
namespace {

TEST(Quantity, PlainNumbersHaveNoExponentAndNoZerosAtTheEnd) {
  EXPECT_EQ(plain_number(1.0999), "1.1");
  EXPECT_EQ(plain_number(0), "0");
  EXPECT_EQ(plain_number(-0.0), "0");
  EXPECT_EQ(plain_number(12), "12");
  EXPECT_EQ(plain_number(120), "120");
  EXPECT_EQ(plain_number(123456), "123456") << "what stands before the point is never rounded";
  EXPECT_EQ(plain_number(9.996), "10");
  EXPECT_EQ(plain_number(-0.25), "-0.25");
  EXPECT_EQ(plain_number(0.00012345), "0.000123");
  EXPECT_EQ(plain_number(1e-12), "0");
  EXPECT_EQ(plain_number(-1e-12), "0");
  EXPECT_EQ(plain_number(2.0 / 3, 1), "0.7");
  EXPECT_EQ(plain_number(std::numeric_limits<double>::infinity()), "inf");
}

TEST(Quantity, LengthsAreMillimetres) {
  EXPECT_EQ(length_text(0), "0 mm");
  EXPECT_EQ(length_text(1e-12), "0 mm");
  EXPECT_EQ(length_text(0.0125), "12.5 mm");
  EXPECT_EQ(length_text(3.14159e-6), "0.00314 mm");
  EXPECT_EQ(length_text(1.7), "1700 mm");
}

TEST(Quantity, BytesHaveAUnit) {
  EXPECT_EQ(bytes_text(0), "0 bytes");
  EXPECT_EQ(bytes_text(1), "1 byte");
  EXPECT_EQ(bytes_text(999), "999 bytes");
  EXPECT_EQ(bytes_text(1000), "1 kB");
  EXPECT_EQ(bytes_text(76'400), "76 kB");
  EXPECT_EQ(bytes_text(999'499), "999 kB");
  EXPECT_EQ(bytes_text(999'500), "1 MB");
  EXPECT_EQ(bytes_text(4'120'000), "4.1 MB");
  EXPECT_EQ(bytes_text(123'000'000), "123 MB");
}

}  // namespace
}  // namespace marrow::tools
