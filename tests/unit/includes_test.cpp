// Which part of the source tree may include which: the arrows of docs/inside/source_map.md, and #include lines held to
// them.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/places.h"

namespace {

namespace fs = std::filesystem;

struct Include {
  fs::path file;
  std::string name;  // as written between the quotes or brackets
};

bool is_source(const fs::path& p) {
  return p.extension() == ".h" || p.extension() == ".cpp";
}

std::vector<Include> includes_under(const fs::path& folder) {
  std::vector<Include> out;
  if (!fs::exists(folder)) return out;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!is_source(entry.path())) continue;
    std::ifstream in(entry.path());
    for (std::string line; std::getline(in, line);) {
      const std::size_t hash = line.find_first_not_of(" \t");
      if (hash == std::string::npos || line.compare(hash, 8, "#include") != 0) continue;
      const std::size_t open = line.find_first_of("\"<");
      const std::size_t close = line.find_first_of("\">", open + 1);
      if (close != std::string::npos) out.push_back({entry.path(), line.substr(open + 1, close - open - 1)});
    }
  }
  return out;
}

const fs::path kRuntime = marrow::test::in_source("runtime");
const fs::path kTools = marrow::test::in_source("tools");

std::vector<std::string> lines_of(const char* document) {
  std::ifstream in(marrow::test::in_source(document));
  std::vector<std::string> out;
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

// All that a pattern with one group finds in a text.
std::vector<std::string> found_in(const std::string& text, const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> out;
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i) out.push_back((*i)[1]);
  return out;
}

// Folders in the order of the page, and those that each may include beside itself.
struct Arrow {
  std::string folder;
  std::set<std::string> may;
};

// The arrows of the page's block `number`. Each leads to folders that the page has before.
std::vector<Arrow> arrows(int number) {
  std::vector<Arrow> out;
  std::set<std::string> above;
  int block = 0;
  bool inside = false;
  for (const std::string& line : lines_of("docs/inside/source_map.md")) {
    if (line == "```text") ++block;
    if (line.rfind("```", 0) == 0) inside = line == "```text" && block == number;
    for (const std::string& row : found_in(inside ? line : "", R"(((?:[^ ]| (?!  ))+ → (?:[^ ]| (?!  ))+))")) {
      const std::size_t arrow = row.find(" → ");
      const std::vector<std::string> right = found_in(row.substr(arrow + 4), R"(([\w/]+))");
      const std::set<std::string> may(right.begin(), right.end());
      for (const std::string& name : may) EXPECT_TRUE(name == "nothing" || above.count(name)) << row;
      for (const std::string& name : found_in(row.substr(0, arrow), R"(([\w/]+))")) {
        out.push_back({name, may});
        above.insert(name);
      }
    }
  }
  EXPECT_GT(out.size(), 15u) << "block " << number << " of docs/inside/source_map.md";
  return out;
}

// Which folder stands behind a public header: where its functions are implemented, by the table of the stages.
std::map<std::string, std::string> folders_of_headers() {
  std::map<std::string, std::string> out;
  for (const std::string& line : lines_of("docs/stages.md")) {
    const std::vector<std::string> cells = found_in(line, R"(\| ([^|]*) (?=\|))");
    if (cells.size() != 4) continue;
    const std::vector<std::string> headers = found_in(cells[1], "`(\\w+\\.h)`");
    const std::vector<std::string> folders = found_in(cells[2], "`(?:runtime/)?(\\w+)`");
    for (std::size_t i = 0; i < headers.size() && !folders.empty(); ++i)
      out["marrow/" + headers[i]] = folders[folders.size() == headers.size() ? i : 0];
  }
  return out;
}
const std::map<std::string, std::string> kHeaders = folders_of_headers();

std::string part_of(const std::string& include) {
  const auto header = kHeaders.find(include);
  if (header != kHeaders.end()) return header->second;
  if (include.rfind("marrow/gles3", 0) == 0) return "gles3";
  if (include.rfind("marrow/", 0) == 0) return "a header that docs/stages.md does not name: " + include;
  const std::size_t slash = include.find('/');
  return slash == std::string::npos ? "" : include.substr(0, slash);
}

TEST(Includes, PointOneWay) {
  int checked = 0;
  for (const auto& [part, may] : arrows(1)) {
    for (const Include& include : includes_under(kRuntime / part)) {
      const std::string target = part_of(include.name);
      if (target.empty() || target == "GLES3" || target == "EGL" || target == "glm") continue;  // system headers
      EXPECT_TRUE(target == part || may.count(target)) << include.file << " includes " << include.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 15);
}

TEST(Includes, EveryPartOfTheRuntimeIsKnown) {
  std::set<std::string> known = {"include"};
  for (const Arrow& arrow : arrows(1)) known.insert(arrow.folder);
  for (const auto& entry : fs::directory_iterator(kRuntime)) {
    EXPECT_TRUE(!entry.is_directory() || known.count(entry.path().filename().string())) << entry.path();
  }
  for (const auto& entry : fs::directory_iterator(kRuntime / "include/marrow"))
    EXPECT_TRUE(entry.path().filename() == "marrow.h" ||
                part_of("marrow/" + entry.path().filename().string())[1] != ' ')
        << entry.path();
}

// The folder of tools that an include line names; empty: none of them.
std::string tool_of(const std::string& include) {
  const std::string folder = include.substr(0, include.find('/'));
  return folder != include && fs::is_directory(kTools / folder) && !fs::exists(kRuntime / include) ? folder : "";
}

TEST(Includes, LibrariesOfTheToolsPointOneWayAndToNoCommand) {
  std::map<std::string, std::set<std::string>> allowed;
  for (const Arrow& arrow : arrows(2)) allowed[arrow.folder] = arrow.may;
  for (const auto& entry : fs::directory_iterator(kTools)) {
    if (!entry.is_directory()) continue;
    const std::string folder = entry.path().filename().string();
    const auto may = allowed.find(folder);
    EXPECT_TRUE(may != allowed.end() || folder == "commands" || includes_under(entry.path()).empty()) << entry.path();
    if (may == allowed.end()) continue;
    for (const Include& include : includes_under(entry.path())) {
      const std::string target = tool_of(include.name);
      EXPECT_TRUE(target.empty() || target == folder || may->second.count(target))
          << include.file << " includes " << include.name;
    }
  }
}

// Folders of the cooker and of the offline deformers.
std::vector<Arrow> rooms() {
  const auto full = [](const std::string& name) {
    return name == "cook" || name.rfind("deform", 0) == 0 ? name : "cook/" + name;
  };
  std::vector<Arrow> out;
  for (const Arrow& arrow : arrows(3)) {
    out.push_back({full(arrow.folder), {}});
    for (const std::string& name : arrow.may) out.back().may.insert(full(name));
  }
  return out;
}

TEST(Includes, RoomsOfTheCookerPointOneWay) {
  int checked = 0;
  for (const Arrow& room : rooms()) {
    const std::string library = room.folder.substr(0, room.folder.find('/'));
    for (const Include& include : includes_under(kTools / room.folder)) {
      const std::string target = fs::path(include.name).parent_path().string();
      if (include.file.parent_path() != kTools / room.folder || tool_of(include.name) != library) continue;
      EXPECT_TRUE(target == room.folder || room.may.count(target)) << include.file << " includes " << include.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 300);
}

TEST(Includes, EveryRoomIsKnownAndNoneIsAHall) {
  constexpr std::ptrdiff_t kMostFiles = 25;
  std::set<fs::path> known;
  for (const Arrow& room : rooms()) known.insert(kTools / room.folder);
  std::map<fs::path, int> files;
  for (const auto& entry : fs::recursive_directory_iterator(kTools))
    if (is_source(entry.path())) ++files[entry.path().parent_path()];
  for (const auto& [folder, count] : files) {
    EXPECT_LE(count, kMostFiles) << folder;
    const std::string library = fs::relative(folder, kTools).begin()->string();
    EXPECT_TRUE((library != "cook" && library != "deform") || known.count(folder)) << folder;
  }
}

// A name that is said or searched for means one file.
TEST(Includes, HardlyTwoFilesAreCalledTheSame) {
  std::map<std::string, int> times;
  for (const fs::path& folder : {kRuntime, kTools})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (is_source(entry.path())) ++times[entry.path().filename().string()];
  int twice = 0;
  for (const auto& [name, count] : times) twice += count > 1;
  EXPECT_LE(twice, 12);
}

// Two types of one name in one namespace are one to the linker, which takes either's functions for both.
TEST(Includes, NoTwoTypesOfTheToolsAreCalledTheSame) {
  std::map<std::string, std::string> file_of;
  for (const auto& entry : fs::recursive_directory_iterator(kTools)) {
    if (entry.path().extension() != ".h") continue;
    std::ifstream lines(entry.path());
    std::string space;
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (std::regex_match(line, found, std::regex("namespace (\\S*) \\{"))) space = found[1];
      if (!std::regex_match(line, found, std::regex("(?:struct|class) (\\w+)(?: final)?(?: : .*)? \\{"))) continue;
      const std::string name = space + "::" + found[1].str();
      const auto [other, is_new] = file_of.try_emplace(name, entry.path().string());
      EXPECT_TRUE(is_new) << name << " of " << entry.path() << " and " << other->second;
    }
  }
  EXPECT_GT(file_of.size(), 300u);
}

// A command's files are its own; what lies beside the folders in tools/commands is for all of them.
TEST(Includes, CommandsDoNotKnowOneAnother) {
  const fs::path commands = kTools / "commands";
  int checked = 0;
  for (const auto& entry : fs::directory_iterator(commands)) {
    if (!entry.is_directory()) continue;
    const std::string own = "commands/" + entry.path().filename().string();
    for (const Include& include : includes_under(entry.path())) {
      if (tool_of(include.name) != "commands") continue;
      const std::string folder = fs::path(include.name).parent_path().string();
      EXPECT_TRUE(folder == own || folder.starts_with(own + "/") || folder == "commands")
          << include.file << " includes " << include.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 15);
}

// Rooms of the tools that others enter by one header alone.
TEST(Includes, RoomsWithADoorAreEnteredByIt) {
  const std::map<std::string, std::string> doors = {
      {"compare", "compare/compare.h"}, {"open", "open/open_model.h"}, {"paint", "paint/painting.h"}};
  int entered = 0;
  for (const auto& entry : fs::directory_iterator(kTools)) {
    if (!entry.is_directory()) continue;
    for (const Include& include : includes_under(entry.path())) {
      const auto door = doors.find(tool_of(include.name));
      if (door == doors.end() || entry.path().filename() == door->first) continue;
      EXPECT_EQ(include.name, door->second) << include.file;
      ++entered;
    }
  }
  EXPECT_GT(entered, 5);
}

TEST(Includes, TheRuntimeKnowsNoFilesNoJsonNoStreams) {
  const std::vector<Include> all = includes_under(kRuntime);
  EXPECT_GT(all.size(), 30u);
  const std::set<std::string> heavy = {"vector",     "string",    "map",       "unordered_map", "functional",
                                       "memory",     "exception", "stdexcept", "iostream",      "fstream",
                                       "filesystem", "cstdio",    "stdio.h",   "span"};
  // In debug builds a bad call that nobody handles prints a line.
  const fs::path prints = kRuntime / "core" / "call_error.cpp";
  // For programs that may allocate: no part of the library includes it.
  const fs::path allocates = kRuntime / "include/marrow/owned.h";
  // Draco brings these, and allocates, anyhow.
  const std::set<std::string> of_draco = {"vector", "memory"};
  for (const Include& include : all) {
    EXPECT_NE(include.name, "marrow/owned.h") << include.file;
    if (include.file == allocates) continue;
    const bool beside_draco =
        fs::path(include.file).parent_path() == kRuntime / "draco" && of_draco.count(include.name);
    EXPECT_TRUE(!heavy.count(include.name) || (include.file == prints && include.name == "cstdio") || beside_draco)
        << include.file << " includes " << include.name;
    for (const char* banned : {"tiny_gltf", "json", "cook/", "common/", "fmt/", "CLI"})
      EXPECT_EQ(include.name.find(banned), std::string::npos) << include.file << " includes " << include.name;
  }
}

TEST(Includes, OnlyTheCookerKnowsTinygltf) {
  int found = 0;
  for (const char* folder : {"runtime", "platform", "tools"}) {
    for (const Include& include : includes_under(marrow::test::in_source(folder))) {
      if (include.name.find("tiny_gltf") == std::string::npos) continue;
      ++found;
      EXPECT_NE(include.file.string().find("/tools/cook/"), std::string::npos) << include.file;
    }
  }
  EXPECT_GT(found, 0);
}

TEST(Includes, IntrinsicsAreSpokenInOnePlace) {
  const std::set<std::string> intrinsics = {"immintrin.h", "emmintrin.h", "xmmintrin.h", "pmmintrin.h",
                                            "smmintrin.h", "tmmintrin.h", "arm_neon.h",  "wasm_simd128.h"};
  int found = 0;
  for (const char* folder : {"runtime", "platform", "tools"}) {
    for (const Include& include : includes_under(marrow::test::in_source(folder))) {
      if (!intrinsics.count(include.name)) continue;
      ++found;
      EXPECT_EQ(include.file.parent_path(), kRuntime / "math") << include.file;
    }
  }
  EXPECT_GE(found, 2);
}

}  // namespace
