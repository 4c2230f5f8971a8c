// The table of rows against the description, and all of its calls.
#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "support/places.h"
#include "unit/misuse/misuse.h"

namespace marrow::test {
namespace {

int complaints() {
  return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

std::uint64_t rounds_of_each() {
#if defined(__aarch64__)
  return 1000;  // emulated
#else
  return in_long_form() ? 50000 : 3000;
#endif
}

// What became of the calls of a function, all its overloads.
struct Called {
  int rows = 0;
  bool gave_status = false, refuses = false, was_refused = false;
};

// Some calls are done.
void misuse(const MisuseRow& row, const std::string& name, std::uint64_t rounds, Called& called) {
  std::size_t ok = 0, refused = 0;
  const int before = complaints();  // one of a row is enough
  for (std::uint64_t seed = 0; seed < rounds && complaints() == before; ++seed) {
    SCOPED_TRACE(name + ", seed " + std::to_string(seed));
    Misuse m(row.function, seed);
    row.call(m);
    ok += m.ok();
    refused += m.refused();
    called.was_refused |= m.told() > 0;
    called.gave_status |= m.gave_status();
    called.refuses |= m.gave_status() && m.refuses();
  }
  if (complaints() > before) return;
  EXPECT_GT(ok, rounds / 10) << name << " hardly ever works";
  EXPECT_GE(ok + refused, rounds) << name << " does not say what it came to";
}

}  // namespace

std::vector<PublicFunction> functions_in(const char* description) {
  std::vector<PublicFunction> out;
  std::ifstream in(in_source(description));
  const std::regex row(R"(^(?:fn (\w+\.)?(\w+)\((.*)\) -> (\w+).*|no (\w+): ..........*))");
  std::smatch found;
  for (std::string line; std::getline(in, line);) {
    if (!std::regex_match(line, found, row)) continue;
    const bool is_there = found[2].matched;
    out.push_back(
        {is_there ? found[2] : found[5], !is_there || found[1].matched || found[3].length() > 0, found[4] == "status"});
  }
  return out;
}

void expect_rows_of(const char* description, const std::vector<MisuseRow>& rows) {
  std::map<std::string, Called> all_called;
  for (const MisuseRow& row : rows) {
    Called& called = all_called[row.function];
    const std::string number = called.rows++ > 0 ? " " + std::to_string(called.rows) : "";
    misuse(row, row.function + number, rounds_of_each(), called);
  }
  std::set<std::string> all;
  for (const PublicFunction& f : functions_in(description)) {
    all.insert(f.name);
    const Called& called = all_called[f.name];
    EXPECT_TRUE(!f.has_arguments || called.rows > 0) << f.name << " has no row";
    EXPECT_TRUE(!f.gives_status || called.gave_status) << f.name << ": its row does not look at the Status";
    EXPECT_EQ(called.refuses, called.was_refused)
        << f.name << (called.refuses ? " is never" : " is, after all,") << " refused";
  }
  EXPECT_GT(all.size(), 30u);
  for (const auto& [name, called] : all_called) EXPECT_TRUE(all.count(name)) << name << " is no public function";
  std::printf("%zu rows, %zu calls\n", rows.size(), rows.size() * rounds_of_each());
}

}  // namespace marrow::test
