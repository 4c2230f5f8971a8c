// Every public function under misuse: nothing outside its memory, nothing written when it refuses, nothing but finite
// numbers when it does not. The table is compared with the headers, so that no function is left out.
#include <gtest/gtest.h>

#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

std::vector<MisuseRow> all_rows() {
  std::vector<MisuseRow> out;
  for (const auto& rows : {rows_of_files(), rows_of_poses(), rows_of_curves(), rows_of_reaching(), rows_of_following(),
                           rows_of_skinning(), rows_of_characters(), rows_of_lines()})
    out.insert(out.end(), rows.begin(), rows.end());
  return out;
}

TEST(Misuse, HasARowOfEveryFunctionInTheHeaders) {
  expect_a_row_of_each(all_rows(),
                       [](const std::string& header) { return header.rfind("gles3", 0) != 0 && header != "glm.h"; });
}

TEST(ThreadsPage, NamesEveryFunctionInTheHeaders) {
  expect_each_named_in("docs/threads.md", [](const std::string& header) { return header != "glm.h"; });
}

TEST(Misuse, IsRefusedOrHarmless) {
  misuse_all(all_rows());
}

}  // namespace
}  // namespace marrow::test
