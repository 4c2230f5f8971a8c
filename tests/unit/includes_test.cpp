// Which part of the source tree may include which: the arrows of docs/inside/source_map.md, held by reading #include
// lines.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
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

// Which folder stands behind a public header: where its functions are implemented.
const std::map<std::string, std::string> kHeaders = {{"marrow/api.h", "core"},
                                                     {"marrow/version.h", "core"},
                                                     {"marrow/status.h", "core"},
                                                     {"marrow/span.h", "core"},
                                                     {"marrow/pose.h", "core"},
                                                     {"marrow/glm.h", "math"},
                                                     {"marrow/file.h", "asset"},
                                                     {"marrow/curve.h", "curve"},
                                                     {"marrow/sample.h", "pose"},
                                                     {"marrow/local_to_model.h", "pose"},
                                                     {"marrow/blend.h", "pose"},
                                                     {"marrow/limits.h", "limits"},
                                                     {"marrow/transition.h", "pose"},
                                                     {"marrow/playback.h", "pose"},
                                                     {"marrow/ik.h", "ik"},
                                                     {"marrow/palette.h", "skin"},
                                                     {"marrow/skin.h", "skin"},
                                                     {"marrow/morph.h", "skin"},
                                                     {"marrow/clip_pack.h", "asset"},
                                                     {"marrow/unpack.h", "unpack"},
                                                     {"marrow/draco.h", "draco"},
                                                     {"marrow/meshopt.h", "meshopt"},
                                                     {"marrow/springs.h", "springs"},
                                                     {"marrow/feet.h", "ik"},
                                                     {"marrow/ik_solve.h", "ik"},
                                                     {"marrow/call_error.h", "core"},
                                                     {"marrow/marks.h", "core"},
                                                     {"marrow/bounds.h", "skin"},
                                                     {"marrow/block.h", "core"},
                                                     {"marrow/character.h", "character"},
                                                     {"marrow/outfit.h", "asset"},
                                                     {"marrow/example_space.h", "asset"},
                                                     {"marrow/debug_lines.h", "debug"}};

std::string part_of(const std::string& include) {
  const auto header = kHeaders.find(include);
  if (header != kHeaders.end()) return header->second;
  if (include.rfind("marrow/gles3", 0) == 0) return "gles3";
  if (include == "marrow/c.h" || include == "marrow/c_gles3.h") return "c";
  if (include.rfind("marrow/", 0) == 0) return "a public header that this test does not know: " + include;
  const std::size_t slash = include.find('/');
  return slash == std::string::npos ? "" : include.substr(0, slash);
}

TEST(Includes, PointOneWay) {
  const std::map<std::string, std::set<std::string>> allowed = {
      {"core", {"core"}},
      {"math", {"core", "math"}},
      {"asset", {"core", "math", "asset"}},
      {"pose", {"core", "math", "asset", "pose"}},
      {"limits", {"core", "math", "asset", "limits"}},
      {"ik", {"core", "math", "asset", "pose", "limits", "ik"}},
      {"springs", {"core", "math", "asset", "pose", "springs"}},
      {"curve", {"core", "math", "curve"}},
      {"skin", {"core", "math", "asset", "skin"}},
      {"character", {"core", "math", "asset", "pose", "skin", "character"}},
      {"debug", {"core", "math", "asset", "limits", "ik", "springs", "debug"}},
      {"gles3", {"core", "math", "asset", "pose", "skin", "gles3"}},
      {"unpack", {"core", "math", "asset", "pose", "unpack"}},
      {"c",
       {"core", "asset", "pose", "limits", "ik", "springs", "curve", "skin", "character", "unpack", "draco", "meshopt",
        "debug", "gles3", "c"}},
      {"draco", {"core", "asset", "unpack", "draco"}},
      {"meshopt", {"core", "asset", "unpack", "meshopt"}}};
  int checked = 0;
  for (const auto& [part, may] : allowed) {
    for (const Include& include : includes_under(kRuntime / part)) {
      const std::string target = part_of(include.name);
      if (target.empty() || target == "GLES3" || target == "EGL" || target == "glm") continue;  // system headers
      EXPECT_TRUE(may.count(target)) << include.file << " includes " << include.name;
      ++checked;
    }
  }
  EXPECT_GT(checked, 15);
}

TEST(Includes, EveryPartOfTheRuntimeIsKnown) {
  const std::set<std::string> known = {"include", "core",    "math",      "asset", "pose",  "limits",
                                       "ik",      "springs", "curve",     "skin",  "gles3", "unpack",
                                       "draco",   "meshopt", "character", "c",     "debug"};
  for (const auto& entry : fs::directory_iterator(kRuntime)) {
    EXPECT_TRUE(!entry.is_directory() || known.count(entry.path().filename().string())) << entry.path();
  }
}

// The folder of tools that an include line names; empty: none of them.
std::string tool_of(const std::string& include) {
  const std::string folder = include.substr(0, include.find('/'));
  return folder != include && fs::is_directory(kTools / folder) && !fs::exists(kRuntime / include) ? folder : "";
}

TEST(Includes, LibrariesOfTheToolsPointOneWayAndToNoCommand) {
  const std::map<std::string, std::set<std::string>> allowed = {
      {"text", {}},
      {"common", {"text"}},
      {"terminal", {"text", "common"}},
      {"deform", {"text", "common"}},
      {"cook", {"text", "common", "deform"}},
      {"options", {"text", "common", "deform", "cook"}},
      {"jobs", {"text", "common", "terminal", "deform", "cook", "options"}},
      {"glb", {"text", "common"}},
      {"export", {"text", "common", "terminal", "glb"}},
      {"image", {"text", "common"}},
      {"pose", {"text", "common"}},
      {"sample", {"text", "common", "glb"}},
      {"bench", {"text", "common", "cook", "pose", "sample"}},
      {"render", {"text", "common", "cook", "image", "pose"}},
      {"gpu_bench", {"common", "terminal", "bench", "pose", "render"}},
      {"sizes", {}},
      {"gpu_cost", {"text", "common"}},
      {"phone", {"common"}},
  };
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

// Folders of the cooker and of the offline deformers, each of which may include those above it that its line names.
struct Room {
  std::string folder;
  std::set<std::string> may;
};

const std::vector<Room> kRooms = {
    {"deform", {}},
    {"deform/helpers", {"deform"}},
    {"deform/fit", {"deform", "deform/helpers"}},
    {"deform/motion", {"deform"}},
    {"deform/simplify", {"deform"}},
    {"deform/weights", {"deform"}},
    {"deform/rig", {"deform", "deform/weights"}},
    {"cook/scene", {}},
    {"cook/gltf/meshopt", {}},
    {"cook/gltf/document", {"cook/gltf/meshopt", "cook/scene"}},
    {"cook/gltf/rules", {"cook/gltf/document"}},
    {"cook/gltf/import", {"cook/gltf/rules", "cook/gltf/document", "cook/scene"}},
    {"cook/gltf/vrm", {"cook/gltf/import", "cook/gltf/document", "cook/scene"}},
    {"cook/gltf", {"cook/gltf/vrm", "cook/gltf/import", "cook/gltf/rules", "cook/gltf/document", "cook/scene"}},
    {"cook/bvh", {"cook/gltf/document", "cook/scene"}},
    {"cook/skeleton", {"cook/scene"}},
    {"cook/clip/compress", {"cook/scene"}},
    {"cook/clip", {"cook/clip/compress", "cook/skeleton", "cook/scene"}},
    {"cook/rig", {"cook/scene"}},
    {"cook/paint", {"cook/gltf/document", "cook/scene"}},
    {"cook/prepare/retarget", {"cook/scene"}},
    {"cook/prepare", {"cook/prepare/retarget", "cook/paint", "cook/gltf", "cook/rig", "cook/skeleton", "cook/scene"}},
    {"cook/geometry", {"cook/scene"}},
    {"cook/skin", {"cook/geometry", "cook/scene"}},
    {"cook/learn", {"cook/skin", "cook/geometry", "cook/clip", "cook/skeleton", "cook/gltf", "cook/scene"}},
    {"cook/mesh", {"cook/learn", "cook/skin", "cook/geometry", "cook/scene"}},
    {"cook/write", {"cook/geometry", "cook/clip/compress", "cook/scene"}},
    {"cook",
     {"cook/write", "cook/mesh", "cook/learn", "cook/prepare", "cook/clip", "cook/skeleton", "cook/bvh", "cook/gltf",
      "cook/scene"}}};

TEST(Includes, RoomsOfTheCookerPointOneWay) {
  std::set<std::string> above;
  int checked = 0;
  for (const Room& room : kRooms) {
    for (const std::string& may : room.may) EXPECT_TRUE(above.count(may)) << room.folder << " and " << may;
    above.insert(room.folder);
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
  for (const Room& room : kRooms) known.insert(kTools / room.folder);
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

TEST(Includes, TheRuntimeKnowsNoFilesNoJsonNoStreams) {
  const std::vector<Include> all = includes_under(kRuntime);
  EXPECT_GT(all.size(), 30u);
  const std::set<std::string> heavy = {"vector",     "string",    "map",       "unordered_map", "functional",
                                       "memory",     "exception", "stdexcept", "iostream",      "fstream",
                                       "filesystem", "cstdio",    "stdio.h",   "span"};
  // In debug builds a bad call that nobody handles prints a line.
  const fs::path prints = kRuntime / "core" / "call_error.cpp";
  // Draco brings these, and allocates, anyhow.
  const std::set<std::string> of_draco = {"vector", "memory"};
  for (const Include& include : all) {
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
