// The same source and options are cooked to the same bytes by any number of threads, in every locale, from every
// folder. Other compilers and processors: tools/same_bytes.sh.
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/support/cookings.h"
#include "support/places.h"

namespace marrow::test {
namespace {

std::string cooked(const TemporaryFolder& folder, const Cooking& cooking,
                   const std::vector<std::string>& settings = {}) {
  const std::string output = folder / "out.mrw";
  std::filesystem::remove(output);
  const Ran ran = run_program(cook_command(cooking, output, settings));
  EXPECT_EQ(ran.code, 0) << cooking.name << ": " << ran.err;
  return read_text(output) + ran.out;
}

TEST(SameBytes, WithAnyNumberOfThreads) {
  const TemporaryFolder folder;
  for (Cooking cooking : cookings(folder)) {
    cooking.options.insert(cooking.options.end(), {"--jobs", "1"});
    const std::string one = cooked(folder, cooking);
    EXPECT_GT(one.size(), 500u);
    for (const char* jobs : {"2", "8"}) {
      cooking.options.back() = jobs;
      EXPECT_TRUE(cooked(folder, cooking) == one) << cooking.name << ", jobs: " << jobs;
    }
  }
}

// Makes a locale below the folder. False where there is nothing to make it of.
bool make_locale(const TemporaryFolder& folder, const std::string& name) {
  const Ran ran = run_program({"localedef", "--no-archive", "-i", name, "-f", "UTF-8", folder / (name + ".UTF-8")});
  return ran.code == 0 && std::filesystem::exists(folder / (name + ".UTF-8/LC_NUMERIC"));
}

TEST(SameBytes, InEveryLocale) {
  const TemporaryFolder folder;
  for (const std::string name : {"de_DE", "tr_TR"}) {
    if (!make_locale(folder, name)) GTEST_SKIP() << "no source of the locale " << name << ": install `locales`";
    const std::vector<std::string> locale = {"LOCPATH=" + folder.path(), "LC_ALL=" + name + ".UTF-8"};
    const Ran comma = run_program({"env", locale[0], locale[1], "printf", "%.2f", "1,25"});
    ASSERT_EQ(comma.out, "1,25") << "the locale is not in effect: " << comma.err;
    for (const Cooking& cooking : cookings(folder))
      EXPECT_TRUE(cooked(folder, cooking, locale) == cooked(folder, cooking, {"LC_ALL=C"})) << cooking.name << name;
  }
}

TEST(SameBytes, FromEveryFolder) {
  const TemporaryFolder folder;
  const std::string golden = in_source("tests/golden");
  const struct {
    std::string from, source;
  } ways[] = {{"/", golden + "/looks.gltf"},
              {golden, "looks.gltf"},
              {golden, "./looks.gltf"},
              {in_source("tests"), "golden/looks.gltf"},
              {in_source("tests/cli"), "../golden/looks.gltf"},
              {folder.path(), golden + "/../golden/looks.gltf"}};
  for (const char* images : {"reference", "embed"}) {
    std::string first;
    int compared = 0;
    for (const auto& way : ways) {
      std::filesystem::remove(folder / "out.mrw");
      const Ran ran = run_program(
          {"env", "-C", way.from, program(), "cook", way.source, "-o", folder / "out.mrw", "--images", images});
      ASSERT_EQ(ran.code, 0) << ran.err;
      const std::string now = read_text(folder / "out.mrw");
      if (first.empty()) first = now;
      EXPECT_TRUE(now == first) << way.source << " from " << way.from;
      ++compared;
    }
    EXPECT_EQ(compared, 6);
    EXPECT_GT(first.size(), 500u);
  }
}

}  // namespace
}  // namespace marrow::test
