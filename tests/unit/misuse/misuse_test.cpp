// Every public function under misuse: nothing outside its memory, nothing written when it refuses, nothing but finite
// numbers when it does not; what cannot be right is refused, under the function's own name, and what is right is done.
// The table is compared with the description of C, which is compared with the headers: no function is left out.
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "support/places.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

std::vector<MisuseRow> all_rows() {
  std::vector<MisuseRow> out;
  for (const auto& rows :
       {rows_of_files(), rows_of_poses(), rows_of_motion(), rows_of_animators(), rows_of_curves(), rows_of_reaching(),
        rows_of_following(), rows_of_skinning(), rows_of_characters(), rows_of_lines()})
    out.insert(out.end(), rows.begin(), rows.end());
  return out;
}

TEST(Misuse, OfEveryFunctionIsRefusedOrHarmless) {
  expect_rows_of("runtime/c/api.txt", all_rows());
}

TEST(ThreadsPage, NamesEveryFunction) {
  std::ifstream in(in_source("docs/threads.md"));
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  std::size_t named = 0;
  for (const char* description : {"runtime/c/api.txt", "runtime/c/gles3.txt"}) {
    for (const PublicFunction& f : functions_in(description)) {
      EXPECT_NE(page.find("`" + f.name + "`"), std::string::npos) << "docs/threads.md does not name " << f.name;
      ++named;
    }
  }
  EXPECT_GT(named, 150u);
}

}  // namespace
}  // namespace marrow::test
