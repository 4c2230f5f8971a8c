// As tests/unit/misuse: every public function of marrow::gles3, over a driver of paper.
#include <gtest/gtest.h>

#include "gl/misuse/misuse_gl.h"

namespace marrow::test {
namespace {

std::vector<MisuseRow> all_rows() {
  std::vector<MisuseRow> out = rows_of_gl_meshes();
  for (const auto& rows : {rows_of_skinners(), rows_of_crowds()}) out.insert(out.end(), rows.begin(), rows.end());
  return out;
}

TEST(GlesMisuse, HasARowOfEveryFunctionInTheHeaders) {
  expect_a_row_of_each(all_rows(), [](const std::string& header) { return header.rfind("gles3", 0) == 0; });
}

TEST(GlesMisuse, IsRefusedOrHarmless) {
  misuse_all(all_rows());
}

}  // namespace
}  // namespace marrow::test
