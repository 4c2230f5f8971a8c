// What many files at once lean on: shared threads, escaped dependencies, options as text, bytes that threads, compilers
// and processors leave alone.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "common/hash.h"
#include "common/parallel.h"
#include "cook/cook.h"
#include "cook/gltf/read.h"
#include "jobs/depfile.h"
#include "options/options.h"
#include "sample/embedded.h"

namespace marrow::tools {
namespace {

// Loops in loops: never more than the shared threads at work, and each index once.
TEST(Parallel, NestedLoopsShareTheThreads) {
  for (const int threads : {1, 2, 5}) {
    set_thread_count(static_cast<unsigned>(threads));
    std::atomic<int> at_work{0}, most{0}, calls{0};
    for_each_in_parallel(6, [&](std::size_t) {
      for_each_in_parallel(7, [&](std::size_t) {
        const int now = ++at_work;
        int seen = most;
        while (now > seen && !most.compare_exchange_weak(seen, now)) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ++calls;
        --at_work;
      });
    });
    EXPECT_EQ(calls, 42);
    EXPECT_LE(most, threads);
    EXPECT_GE(most, std::min(threads, 2));
  }
  set_thread_count(std::thread::hardware_concurrency());
}

// A loop that began alone takes over threads that others leave.
TEST(Parallel, ThreadsThatBecomeFreeAreUsed) {
  set_thread_count(2);
  std::atomic<int> at_work{0}, most{0};
  for_each_in_parallel(2, [&](std::size_t outer) {
    if (outer == 1) return std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for_each_in_parallel(60, [&](std::size_t) {
      const int now = ++at_work;
      if (now > most) most = now;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      --at_work;
    });
  });
  EXPECT_EQ(most, 2);
  set_thread_count(std::thread::hardware_concurrency());
}

TEST(Parallel, AnExceptionEndsTheLoopAndReturnsTheThreads) {
  set_thread_count(4);
  for (int round = 0; round < 50; ++round)
    EXPECT_THROW(for_each_in_parallel(100,
                                      [](std::size_t i) {
                                        if (i % 7 == 3) throw std::runtime_error("three");
                                      }),
                 std::runtime_error);
  int free = 0;
  while (take_thread()) ++free;
  EXPECT_EQ(free, 3);
  set_thread_count(std::thread::hardware_concurrency());
}

// As `gcc -MD` writes such names.
TEST(DepfileRule, Escapes) {
  EXPECT_EQ(depfile_rule("a.mrw", {"a.gltf", "a.bin"}), "a.mrw: a.gltf a.bin\n");
  EXPECT_EQ(depfile_rule("a b", {"c#d", "e$f", "C:x", "g\\h", "i\\ j"}), "a\\ b: c\\#d e$$f C\\:x g\\h i\\\\\\ j\n");
  EXPECT_THROW(depfile_rule("a\nb", {}), Failure);
}

// XXH3's own test vector for no bytes (seed 0), from its repository's documentation of the canonical form.
TEST(Hash, IsXxh3) {
  EXPECT_EQ(hash_of({}), "99aa06d3014798d86001c324468d497f");
  Hasher a, b;
  a.add("ab");
  a.add("c");
  b.add("a");
  b.add("bc");
  EXPECT_NE(a.hex(), b.hex());
}

TEST(Options, CanonicalText) {
  cook::Given first, second;
  first["clip-error"] = {{"1mm", {"--clip-error", ""}}};
  second["clip-error"] = {{"1mm", {"marrow.toml", "3:4"}}};
  EXPECT_EQ(cook::canonical_text(first), cook::canonical_text(second));
  second["clip-error"][0].text = "2mm";
  EXPECT_NE(cook::canonical_text(first), cook::canonical_text(second));
  second = first;
  second["additive"] = {{"a", {}}};
  EXPECT_NE(cook::canonical_text(first), cook::canonical_text(second));
  second = first;
  second["clip-error"][0].origin.must_fit = false;
  EXPECT_NE(cook::canonical_text(first), cook::canonical_text(second)) << "one may fail where the other warns";
}

// The sample character with its four clips, on all cores. The same for every compiler, processor and build type; if the
// cooker got better on purpose, the new figures belong here. Meshes in Draco's hands depend on its version, too.
TEST(SameBytes, Newt) {
  const auto cook_with = [](cook::MeshCodec codec) {
    cook::CookOptions options;
    options.mesh_codec = codec;
    options.raw_clips = codec != cook::MeshCodec::none;  // coded once
    return cook::cook_scene(cook::read_gltf("newt.glb", sample_glb()), options).file;
  };
  const std::vector<std::byte> none = cook_with(cook::MeshCodec::none), meshopt = cook_with(cook::MeshCodec::meshopt),
                               draco = cook_with(cook::MeshCodec::draco);
  EXPECT_EQ(hash_of(none), "711076ff7fcc9aff52be1bd07a5a4793");
  EXPECT_EQ(hash_of(meshopt), "793051e04bfecd1c75ff80ecf5a99b03");
  EXPECT_EQ(hash_of(draco), "4a29fcf8bd163c37703671837631d539");
}

}  // namespace
}  // namespace marrow::tools
