// Every combination of defines compiles and links on the driver at hand, within the least that GLES 3.0 promises.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl/support/feedback.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/skinned.h"
#include "support/places.h"

namespace marrow::embedded {
extern const unsigned char shader_surface_vert[], shader_surface_frag[], shader_depth_vert[], shader_depth_frag[],
    shader_backdrop_vert[], shader_backdrop_frag[], shader_studio[];
}

namespace marrow::test {
namespace {

std::string text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

// Reads everything that the skinning text may give, so that no attribute is optimised away.
constexpr const char* kAllVertex = R"(
out vec4 everything;
void main() {
  MarrowVertex v = marrow_skin();
  everything = vec4(v.normal, 1.0) + v.tangent + marrow_instance_colour();
#if MARROW_UV
  everything.xy += in_uv;
#endif
#if MARROW_COLOUR
  everything += in_colour;
#endif
  gl_Position = vec4(v.position, 1.0);
}
)";
constexpr const char* kAllFragment = R"(
precision highp float;
in vec4 everything;
out vec4 colour;
void main() { colour = everything; }
)";

constexpr gles3::Palettes kPalettes[] = {gles3::Palettes::uniform_block, gles3::Palettes::texture,
                                         gles3::Palettes::crowd};

// Crowds have neither vertices that are skinned already nor morph targets.
bool can_be(const gles3::ProgramKey& key) {
  return key.palettes != gles3::Palettes::crowd ||
         (key.deformer != gles3::Deformer::none && (key.features & gles3::kMorphs) == 0);
}

Status build(const gles3::ProgramKey& key, const std::string& vertex, const std::string& fragment, std::string& log) {
  log.assign(4096, '\0');
  gles3::Program program;
  const Status status = gles3::create_program(gl(), key, {vertex.c_str(), fragment.c_str(), {}}, 0, program, log);
  log.resize(log.find('\0'));
  gles3::destroy(gl(), program);
  return status;
}

constexpr int kBesideSkinning = gles3::kUvs | gles3::kColours;

// Texture coordinates and colours stand beside skinning: they are tried with four influences and eight alone.
bool is_drawn(const gles3::ProgramKey& key) {
  // No mesh asks for it, see make_layout(): some drivers count gl_InstanceID among sixteen attributes.
  constexpr int kAll = kBesideSkinning | gles3::kSurfaceNormals;
  if (key.deformer == gles3::Deformer::as && key.influences == 8 && (key.features & kAll) == kAll) return false;
  return key.influences == 4 || key.influences == 8 || (key.features & kBesideSkinning) == 0;
}

bool is_pre_skinned(const gles3::ProgramKey& key) {
  return key.deformer != gles3::Deformer::none && (key.features & kBesideSkinning) == 0;
}

std::vector<gles3::ProgramKey> keys_that(bool (*are)(const gles3::ProgramKey&)) {
  std::vector<gles3::ProgramKey> keys;
  for (int deformer = 0; deformer < 4; ++deformer)
    for (int influences = 4; influences <= 8; ++influences)
      for (int features = 0; features < 64; ++features)
        for (const gles3::Palettes palettes : kPalettes) {
          const gles3::ProgramKey key{static_cast<gles3::Deformer>(deformer), static_cast<std::uint8_t>(influences),
                                      static_cast<std::uint8_t>(features), palettes};
          if (are(key)) keys.push_back(key);
        }
  return keys;
}

// The short form tries every fifth.
std::size_t step() {
  return in_long_form() ? 1 : 5;
}

std::string name_of(const gles3::ProgramKey& key) {
  return std::to_string(static_cast<int>(key.deformer)) + " " + std::to_string(key.influences) + " " +
         std::to_string(key.features) + " " + std::to_string(static_cast<int>(key.palettes)) + ": ";
}

TEST(Program, CompilesInEveryCombination) {
  const std::vector<gles3::ProgramKey> keys = keys_that(is_drawn);
  constexpr int kTried = 2 * 64 + 3 * 16;
  EXPECT_EQ(std::count_if(keys.begin(), keys.end(), can_be), 4 * 2 * kTried + 3 * kTried / 2 - (8 + 8 + 4));
  for (std::size_t i = 0; i < keys.size(); i += step()) {
    std::string log;
    EXPECT_EQ(build(keys[i], kAllVertex, kAllFragment, log), can_be(keys[i]) ? Status::ok : Status::bad_argument)
        << name_of(keys[i]) << log;
  }
}

TEST(Program, PreSkinningCompilesInEveryCombination) {
  const std::vector<gles3::ProgramKey> keys = keys_that(is_pre_skinned);
  EXPECT_EQ(keys.size(), 3u * 5 * 16 * 3);
  for (std::size_t i = 0; i < keys.size(); i += step()) {
    for (const gles3::Preskin method : {gles3::Preskin::feedback, gles3::Preskin::compute}) {
      std::string log(4096, '\0');
      gles3::Program program;
      const bool can = method == gles3::Preskin::feedback || gl().caps().compute;
      EXPECT_EQ(gles3::create_preskin(gl(), gl().caps(), keys[i], method, 0, program, log),
                keys[i].palettes == gles3::Palettes::crowd ? Status::bad_argument
                : can                                      ? Status::ok
                                                           : Status::unsupported)
          << name_of(keys[i]) << log.c_str();
      gles3::destroy(gl(), program);
    }
  }
}

TEST(Program, TheStudioCompiles) {
  const std::string studio = text(embedded::shader_studio);
  std::string log;
  int count = 0;
  for (int deformer = 0; deformer < 4; ++deformer) {
    for (const int influences : {4, 8}) {
      for (const int features : {0, 1, 8, 9}) {
        for (const gles3::Palettes palettes : kPalettes) {
          const gles3::ProgramKey key{static_cast<gles3::Deformer>(deformer), static_cast<std::uint8_t>(influences),
                                      static_cast<std::uint8_t>(features), palettes};
          if (!can_be(key)) continue;
          EXPECT_EQ(build(key, text(embedded::shader_surface_vert), studio + text(embedded::shader_surface_frag), log),
                    Status::ok)
              << log;
          EXPECT_EQ(build(key, text(embedded::shader_depth_vert), text(embedded::shader_depth_frag), log), Status::ok)
              << log;
          ++count;
        }
      }
    }
  }
  EXPECT_EQ(count, 88);
  EXPECT_EQ(build({gles3::Deformer::none, 4, 0}, text(embedded::shader_backdrop_vert),
                  studio + text(embedded::shader_backdrop_frag), log),
            Status::ok)
      << log;
}

TEST(Program, WhatDoesNotCompileIsNamed) {
  std::string log;
  EXPECT_EQ(build({}, "void main() { no_such_function(); }", kAllFragment, log), Status::gl_error);
  EXPECT_NE(log.find("no_such_function"), std::string::npos) << log;
  EXPECT_EQ(build({}, kAllVertex, "nonsense", log), Status::gl_error);
  EXPECT_EQ(build({gles3::Deformer::ssd, 9, 0}, kAllVertex, kAllFragment, log), Status::bad_argument);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

TEST(Program, StaysWithinTheLeastThatGlesPromises) {
  EXPECT_LE(gles3::kPaletteBlockBytes, 16384u);
  EXPECT_LT(gles3::kColourLocation, 16u);
  const gles3::Caps least;
  EXPECT_EQ(least.uniform_block_bytes, 16384u);
  EXPECT_EQ(least.uniform_offset_alignment, 256u);
  EXPECT_EQ(least.vertex_attributes, 16u);
}

}  // namespace
}  // namespace marrow::test
