// Cooking is deterministic and has not changed: the golden file's source still cooks to the golden file's bytes.
#include <cstring>
#include <string>

#include <gtest/gtest.h>

#include "cook/cook.h"
#include "support/golden.h"

namespace marrow {
namespace {

cook::CookResult cook_tiny() {
  cook::CookOptions options;
  options.keep_vertex_order = true;
  return cook::cook_file(std::string(MARROW_SOURCE_DIR) + "/tests/golden/tiny.gltf", options);
}

// If this fails because the format's version rose or the cooker got better on purpose: see golden/README.md.
TEST(GoldenCook, GivesTheGoldenBytes) {
  const cook::CookResult cooked = cook_tiny();
  test::AlignedBlock golden = test::golden_copy();
  ASSERT_EQ(cooked.file.size(), golden.size());
  for (std::size_t i = 0; i < golden.size(); ++i) ASSERT_EQ(cooked.file[i], golden.data()[i]) << "byte " << i;
}

TEST(GoldenCook, TwiceGivesTheSameBytes) {
  EXPECT_EQ(cook_tiny().file, cook_tiny().file);
}

}  // namespace
}  // namespace marrow
