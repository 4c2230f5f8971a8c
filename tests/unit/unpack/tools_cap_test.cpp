// Tools give a packed file only so much memory as its bytes may be worth, whatever its counts bear out.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "common/unpack_mrw.h"
#include "support/fan.h"
#include "unpack/records.h"

namespace marrow::test {
namespace {

// The fan's record, but with this many vertices, of which there are no bytes.
std::vector<std::byte> fan_with(std::uint32_t vertex_count) {
  const std::vector<std::byte> record = fan_record();
  Bytes b;
  b.u8(std::to_integer<std::uint32_t>(record[0]));
  for (; vertex_count >= 0x80; vertex_count >>= 7) b.u8((vertex_count & 0x7F) | 0x80);
  b.u8(vertex_count);
  b.add({record.begin() + 2, record.end()});
  return b.all;
}

// A file that claims just the memory that its counts ask for.
std::vector<std::byte> honest(std::uint32_t vertex_count, std::uint32_t& memory_bytes) {
  const std::vector<std::byte> geometry = fan_with(vertex_count);
  RecordNeeds needs;
  const Record record{format::kGeometries, packed::kMeshopt, {geometry.data(), geometry.size()}};
  EXPECT_EQ(add_needs(record, needs), nullptr);
  std::vector<std::byte> file = packed_fan(geometry, packed::kMeshopt);
  std::uint32_t file_bytes = 0;
  std::memcpy(&file_bytes, file.data() + 12, 4);
  memory_bytes = static_cast<std::uint32_t>(format::align16(file_bytes) + format::align16(needs.scratch_bytes));
  std::memcpy(file.data() + 16, &memory_bytes, 4);
  forge(file);
  return file;
}

std::string refusal(std::uint32_t vertex_count, std::uint32_t& memory_bytes) {
  const std::vector<std::byte> file = honest(vertex_count, memory_bytes);
  try {
    (void)tools::unpacked(file, "fan");
  } catch (const tools::Failure& failure) {
    return failure.advice();
  }
  return "none";
}

TEST(ToolsCap, IsInProportionToTheFile) {
  std::uint32_t few = 0, many = 0;
  EXPECT_EQ(refusal(1000, few).find("more memory"), std::string::npos) << "damaged, but not large";
  EXPECT_NE(refusal(4000000, many).find("more memory than so small a file"), std::string::npos)
      << refusal(4000000, many);
  EXPECT_LT(few, 64u << 20);
  EXPECT_GT(many, 80u << 20);
}

}  // namespace
}  // namespace marrow::test
