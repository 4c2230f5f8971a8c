// The table of rows against the headers, and all of its calls.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "support/places.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

// Names of all functions that the headers declare, members too.
std::set<std::string> declared(const std::function<bool(const std::string&)>& headers) {
  std::set<std::string> names;
  // No functions, what makes a class a range, what has no arguments, and private ones.
  const std::set<std::string> none = {"alignas",         "requires",      "Span",
                                      "begin",           "end",           "empty",
                                      "operator",        "draco_decoder", "call_error_handler",
                                      "meshopt_decoder", "geometry",      "section",
                                      "springs_of"};
  const std::regex function(R"(^(?:  )?(?:MARROW_API )?(?:(?:inline|constexpr|const) )*)"
                            R"((?!MARROW_API)[A-Za-z_][\w:]*(?:<[^>]*>)?(?: |[&*] )(\w+)\()");
  for (const auto& entry : std::filesystem::directory_iterator(in_source("runtime/include/marrow"))) {
    if (!headers(entry.path().filename())) continue;
    std::ifstream in(entry.path());
    std::smatch found;
    for (std::string line; std::getline(in, line);)
      if (std::regex_search(line, found, function) && line.find("return ") != 2 && !none.count(found[1]))
        names.insert(found[1]);
  }
  return names;
}

int complaints() {
  return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

// What returns a Status refuses some of the calls and does others.
void misuse(const MisuseRow& row, const std::string& name, std::uint64_t rounds) {
  std::size_t ok = 0, refused = 0;
  const int before = complaints();  // one of a row is enough
  for (std::uint64_t seed = 0; seed < rounds && complaints() == before; ++seed) {
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    Misuse m(row.function, seed);
    row.call(m);
    ok += m.ok();
    refused += m.refused();
  }
  if (complaints() > before) return;
  EXPECT_GT(ok, rounds / 10) << name << " hardly ever works";
  EXPECT_GE(ok + refused, rounds) << name << " does not say what it came to";
}

}  // namespace

std::set<std::string> declared_functions(const std::function<bool(const std::string&)>& headers) {
  return declared(headers);
}

void expect_a_row_of_each(const std::vector<MisuseRow>& rows, const std::function<bool(const std::string&)>& headers) {
  const std::set<std::string> all = declared(headers);
  EXPECT_GT(all.size(), 40u);
  std::set<std::string> there;
  for (const MisuseRow& row : rows) there.insert(row.function);
  for (const std::string& name : all) EXPECT_TRUE(there.count(name)) << name << " has no row";
  for (const std::string& name : there) EXPECT_TRUE(all.count(name)) << name << " is no public function";
}

void expect_each_named_in(const char* document, const std::function<bool(const std::string&)>& headers) {
  std::ifstream in(in_source(document));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  for (const std::string& name : declared(headers))
    EXPECT_NE(text.find("`" + name + "`"), std::string::npos) << document << " does not name " << name;
}

void misuse_all(const std::vector<MisuseRow>& rows) {
#if defined(__aarch64__)
  const std::uint64_t rounds = 1000;  // emulated
#else
  const std::uint64_t rounds = in_long_form() ? 50000 : 3000;
#endif
  std::map<std::string, int> row_of;
  for (const MisuseRow& row : rows) {
    const int number = row_of[row.function]++;
    misuse(row, row.function + (number > 0 ? " " + std::to_string(number + 1) : ""), rounds);
  }
  std::printf("%zu rows, %zu calls\n", rows.size(), rows.size() * rounds);
}

}  // namespace marrow::test
