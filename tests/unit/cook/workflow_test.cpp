// What many files at once lean on: escaped dependencies, options as text, bytes that compilers and processors
// leave alone.
#include <string>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "common/hash.h"
#include "cook/gltf/read.h"
#include "cook/options/options.h"
#include "disk/cook_on_disk.h"
#include "jobs/depfile.h"
#include "sample/embedded.h"

namespace marrow::tools {
namespace {

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
  cook::Options first, second;
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
    options.mesh.codec = codec;
    options.clips.raw = codec != cook::MeshCodec::none;  // coded once
    return cook::cook_scene(cook::read_gltf("newt.glb", sample_glb()), options).file;
  };
  const std::vector<std::byte> none = cook_with(cook::MeshCodec::none), meshopt = cook_with(cook::MeshCodec::meshopt),
                               draco = cook_with(cook::MeshCodec::draco);
  EXPECT_EQ(hash_of(none), "01aa86914246499ef9816bb7cbcf20d4");
  EXPECT_EQ(hash_of(meshopt), "7e9be3fa8562f0f1717d04adca4880bc");
  EXPECT_EQ(hash_of(draco), "ab95ba3c06260d84f13057820df7990c");
}

}  // namespace
}  // namespace marrow::tools
