// Every public function under misuse: nothing outside its memory, nothing written when it refuses, nothing but finite
// numbers when it does not. The table is compared with the headers, so that no function is left out.
#include <fstream>
#include <regex>

#include <gtest/gtest.h>

#include "support/places.h"
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

bool is_of_cpp(const std::string& header) {
  return header != "glm.h" && header != "c.h" && header != "c_gles3.h";
}

bool is_of_the_runtime(const std::string& header) {
  return header.rfind("gles3", 0) != 0 && is_of_cpp(header);
}

TEST(Misuse, HasARowOfEveryFunctionInTheHeaders) {
  expect_a_row_of_each(all_rows(), is_of_the_runtime);
}

// What C has, and what it has not and why, is said in one place.
void expect_described_in(const char* description, const std::function<bool(const std::string&)>& headers,
                         std::size_t least) {
  std::set<std::string> rows;
  std::ifstream in(in_source(description));
  const std::regex row(R"(^(?:fn (?:\w+\.)?(\w+)\(.*|no (\w+): ..........*))");
  std::smatch found;
  for (std::string line; std::getline(in, line);)
    if (std::regex_match(line, found, row)) rows.insert(found[1].matched ? found[1] : found[2]);
  const std::set<std::string> all = declared_functions(headers);
  EXPECT_GT(all.size(), least);
  for (const std::string& name : all)
    EXPECT_TRUE(rows.count(name)) << name << " is not in " << description
                                  << ": give it a row, or say there why C has it not";
}

TEST(Misuse, TheDescriptionsOfCHaveARowOfEveryFunctionInTheHeaders) {
  expect_described_in("runtime/c/api.txt", is_of_the_runtime, 100);
  expect_described_in(
      "runtime/c/gles3.txt", [](const std::string& header) { return header.rfind("gles3", 0) == 0; }, 40);
}

TEST(ThreadsPage, NamesEveryFunctionInTheHeaders) {
  expect_each_named_in("docs/threads.md", is_of_cpp);
}

TEST(Misuse, IsRefusedOrHarmless) {
  misuse_all(all_rows());
}

}  // namespace
}  // namespace marrow::test
