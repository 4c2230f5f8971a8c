// Every public function under misuse: nothing outside its memory, nothing written when it refuses, nothing but finite
// numbers when it does not. The table is compared with the headers, so that no function is left out.
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "support/places.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// Names of all functions that the headers declare, members too.
std::set<std::string> declared() {
  std::set<std::string> names;
  // No functions, what makes a class a range, what has no arguments, and private ones.
  const std::set<std::string> none = {"alignas",       "requires",        "Span",     "begin",  "end", "empty",
                                      "draco_decoder", "meshopt_decoder", "geometry", "section"};
  const std::regex function(R"(^(?:  )?(?:(?:inline|constexpr|const) )*[A-Za-z_][\w:]*(?:<[^>]*>)?(?: |[&*] )(\w+)\()");
  for (const auto& entry : std::filesystem::directory_iterator(in_source("runtime/include/marrow"))) {
    const std::string header = entry.path().filename();
    if (header.rfind("gles3", 0) == 0 || header == "glm.h") continue;
    std::ifstream in(entry.path());
    std::smatch found;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, found, function) && line.find("return ") != 2 && !none.count(found[1]))
        names.insert(found[1]);
  }
  return names;
}

std::map<std::string, std::vector<MisuseRow>> table() {
  std::map<std::string, std::vector<MisuseRow>> out;
  for (const auto& rows : {rows_of_files(), rows_of_poses(), rows_of_curves(), rows_of_reaching(), rows_of_following(),
                           rows_of_skinning(), rows_of_characters()})
    for (const MisuseRow& row : rows) out[row.function].push_back(row);
  return out;
}

TEST(Misuse, HasARowOfEveryFunctionInTheHeaders) {
  const std::set<std::string> all = declared();
  EXPECT_GT(all.size(), 110u);
  const auto rows = table();
  for (const std::string& name : all) EXPECT_TRUE(rows.count(name)) << name << " has no row";
  for (const auto& row : rows) EXPECT_TRUE(all.count(row.first)) << row.first << " is no public function";
}

int complaints() {
  return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

// What returns a Status refuses some of the calls and does others.
TEST(Misuse, IsRefusedOrHarmless) {
  const std::uint64_t rounds = in_long_form() ? 50000 : 3000;
  std::size_t calls = 0;
  for (const auto& [name, rows] : table()) {
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::size_t ok = 0, refused = 0;
      const int before = complaints();  // one of a row is enough
      for (std::uint64_t seed = 0; seed < rounds && complaints() == before; ++seed) {
        SCOPED_TRACE(name + ", row " + std::to_string(r) + ", seed " + std::to_string(seed));
        Misuse m(name.c_str(), seed);
        rows[r].call(m);
        ok += m.ok();
        refused += m.refused();
      }
      if (complaints() > before) continue;
      EXPECT_GT(ok, rounds / 10) << name << ", row " << r << ", hardly ever works";
      EXPECT_GE(ok + refused, rounds) << name << ", row " << r << ", does not say what it came to";
      calls += rounds;
    }
  }
  std::printf("%zu calls\n", calls);
}

}  // namespace
}  // namespace marrow::test
