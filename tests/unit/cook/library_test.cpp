// The cooker as a function: files, options and progress of whoever calls it.
#include "marrow/cook.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "cook/options/options.h"
#include "disk/disk_files.h"
#include "disk/thread_pool.h"
#include "sample/embedded.h"
#include "support/golden.h"
#include "support/places.h"

namespace marrow::cook {
namespace {

using tools::Exit;
using tools::Failure;

std::vector<std::byte> bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

class Memory : public Files {
 public:
  std::map<std::string, std::vector<std::byte>> files;
  std::vector<std::byte> read(const std::string& name, std::uint64_t most) override {
    const auto found = files.find(name);
    if (found == files.end()) throw Failure(Exit::io, name, "", kNoSuchFile, "add it");
    std::vector<std::byte> out = found->second;
    out.resize(std::min<std::size_t>(out.size(), most));
    return out;
  }
};

std::string told_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Failure& failure) {
    return failure.what();
  }
  return "no failure";
}

Memory with_newt() {
  Memory out;
  const auto newt = tools::sample_glb();
  out.files["art/newt.glb"] = {newt.begin(), newt.end()};
  return out;
}

TEST(CookLibrary, FromMemoryToMemoryByAnyNumberOfThreads) {
  Memory memory = with_newt();
  Options options;
  set(options, "clip-error", "1mm");
  const Result alone = cook("art/newt.glb", options, {memory});
  const Result together = cook("art/newt.glb", options, {memory, &tools::all_cores()});
  EXPECT_GT(alone.file.size(), 1000u);
  EXPECT_TRUE(alone.file == together.file);
  EXPECT_EQ(alone.report, together.report);
  EXPECT_EQ(alone.report["output"]["bytes"], alone.file.size());
  ASSERT_EQ(alone.reads.size(), 1u);
  EXPECT_EQ(alone.reads[0].name, "art/newt.glb");
  EXPECT_EQ(alone.reads[0].bytes, memory.files["art/newt.glb"].size());
}

// A buffer beside the scene, a graph and a template that options name; each is in `reads`, once.
TEST(CookLibrary, AsksForWhatADocumentAndOptionsName) {
  Memory memory;
  memory.files["art/tri.gltf"] = bytes_of(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
    "max": [0, 0, 0]}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "data/tri.bin"}]})");
  memory.files["art/data/tri.bin"] = std::vector<std::byte>(36);
  memory.files["graphs/hero.anim.toml"] = bytes_of("output = \"walk\"\n");
  Options options;
  set(options, "graph", "graphs/hero.anim.toml");
  const Result result = cook("art/tri.gltf", options, {memory});
  ASSERT_EQ(result.reads.size(), 3u);
  EXPECT_EQ(result.reads[1].name, "art/data/tri.bin");
  EXPECT_EQ(result.reads[2].name, "graphs/hero.anim.toml");
  memory.files.erase("art/data/tri.bin");
  EXPECT_EQ(told_of([&] { cook("art/tri.gltf", options, {memory}); }),
            "art/tri.gltf: /buffers/0/uri: no such file: add it");
  memory.files.erase("graphs/hero.anim.toml");
  EXPECT_EQ(told_of([&] { cook_graphs(options, {memory}); }), "graphs/hero.anim.toml: no such file: add it");
}

TEST(CookLibrary, SaysHowFarItHasCome) {
  Memory memory = with_newt();
  Options options;
  set(options, "mesh-codec", "none");
  std::vector<Stage> begun;
  std::map<Stage, std::pair<std::size_t, std::size_t>> last;
  cook("art/newt.glb", options, {memory, nullptr, [&](Stage stage, std::size_t done, std::size_t count) {
                                   if (count == 0) begun.push_back(stage);
                                   last[stage] = {done, count};
                                 }});
  EXPECT_EQ(begun, (std::vector{Stage::read, Stage::prepare, Stage::mesh, Stage::clip, Stage::write}));
  EXPECT_GT(last[Stage::clip].second, 0u);
  EXPECT_EQ(last[Stage::clip].first, last[Stage::clip].second);
}

TEST(CookLibrary, StopsAtEveryStageWhereItIsAsked) {
  for (const Stage stage : {Stage::read, Stage::prepare, Stage::mesh, Stage::clip}) {
    Memory memory = with_newt();
    std::atomic<bool> stop{false};
    const auto told = [&](Stage at, std::size_t, std::size_t) { stop = stop || at == stage; };
    try {
      cook("art/newt.glb", {}, {memory, nullptr, told, &stop});
      ADD_FAILURE() << "it went on after " << name_of(stage);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.code(), Exit::interrupted) << name_of(stage);
    }
  }
}

// Every option that is there, as text and back.
TEST(CookOptions, AreWrittenAndRead) {
  Options options;
  const std::map<std::string, std::vector<std::string>> some = {{"additive", {"aim=rest", "w*"}},
                                                                {"clip-error", {"1mm", "hand*=0.1mm"}},
                                                                {"lod", {"0.5,0.25:2"}},
                                                                {"roles", {"left_foot=Foot \"L\"", "head=H"}},
                                                                {"strict", {"true"}},
                                                                {"keep", {"a\\b", "c\nd"}},
                                                                {"event", {"Idle=step@0.2"}}};
  for (const auto& [name, values] : some)
    for (const std::string& value : values) set(options, name, value);
  const std::string text = write_options(options);
  const Options again = read_options("again.toml", text);
  ASSERT_EQ(again.size(), options.size()) << text;
  for (const auto& [name, values] : options) {
    ASSERT_EQ(again.at(name).size(), values.size()) << name;
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(again.at(name)[i].text, values[i].text) << text;
  }
  EXPECT_EQ(write_options(again), text);
}

TEST(CookOptions, ShapesAreWrittenToo) {
  const char* const text =
      "[[shapes]]\nname = \"face\"\nmesh = \"head\"\nparameters = [\"joy\", {name = \"fear\", default = 0.25}]\n"
      "examples = [{at = [0, 0]}, {target = \"smile\", at = [1, 0.125]}]\n";
  const Options options = read_options("face.toml", text);
  const Options again = read_options("again.toml", write_options(options));
  ASSERT_EQ(again.at("shapes").size(), 1u);
  EXPECT_EQ(again.at("shapes")[0].text, options.at("shapes")[0].text);
}

TEST(CookOptions, AreRefusedWhereTheyStand) {
  Options options;
  EXPECT_EQ(told_of([&] { set(options, "strct", "true"); }).substr(0, 29), "--strct: no such option: did ");
  EXPECT_EQ(told_of([] { read_options("o.toml", "lod = '0.5'\nstrict = 3\n"); }).substr(0, 12), "o.toml: 2:10");
  Memory memory = with_newt();
  set(options, "rebind", "true");
  EXPECT_EQ(told_of([&] { cook("art/newt.glb", options, {memory}); }),
            "--rebind: --rebind without new weights: give --auto-weights too");
  EXPECT_EQ(told_of([&] { cook_graphs(Options{}, {memory}); }).substr(0, 17), "--graph: no graph");
}

// A row each of the table, as "name=value name=value", and what is said of it.
TEST(CookOptions, WhatDoesNotGoTogetherIsRefused) {
  const std::pair<const char*, const char*> rows[] = {
      {"rebind=true", "--rebind without new weights"},
      {"truth=cor", "--truth without a fit"},
      {"eigenskin=2 as=fit", "--eigenskin without plain weights"},
      {"eigenskin=2 truth=examples examples=e.glb", "--eigenskin without a truth in every pose"},
      {"as=fit examples=e.glb", "--examples without their truth"},
      {"as=fit truth=examples", "--truth without its examples"},
      {"influences=4", "--influences without a choice of them"},
      {"keep-bind-pose=true", "--keep-bind-pose without a fit"},
      {"as=smooth helpers=2", "--helpers without what may follow them"},
      {"delta-mush=3", "--delta-mush without anything to smooth"},
      {"as=fit elastic=volume=6", "--elastic without its truth"},
      {"wide-poses=true", "--wide-poses without a fit to a deformer"},
      {"mwe=true", "--mwe without a truth"},
      {"psd=4", "--psd without a truth"},
      {"subdivide=1 mwe=true truth=cor", "--subdivide with --mwe"},
      {"subdivide=1 psd=4 truth=cor", "--subdivide with --psd"},
      {"subdivide=1 keep-vertex-order=true", "--subdivide with --keep-vertex-order"},
      {"auto-skeleton=humanoid clips-only=true", "--auto-skeleton with --clips-only"},
      {"auto-skeleton=humanoid skeleton=c.mrw", "--auto-skeleton with --skeleton"},
      {"weights-over-time=m=a,b clips-only=true", "--weights-over-time with --clips-only"},
      {"eigenskin=2 clips-only=true", "--eigenskin with --clips-only"}};
  for (const auto& [asked, rule] : rows) {
    Options options;
    std::istringstream words(asked);
    for (std::string word; words >> word;) {
      const std::size_t divide = word.find('=');
      set(options, word.substr(0, divide), word.substr(divide + 1));
    }
    EXPECT_NE(told_of([&] { to_options(options); }).find(std::string(": ") + rule + ": "), std::string::npos)
        << asked << ": " << told_of([&] { to_options(options); });
  }
}

}  // namespace
}  // namespace marrow::cook
