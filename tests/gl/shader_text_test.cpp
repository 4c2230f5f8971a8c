// Every text that goes to a driver, through Khronos' reference compiler as well: stricter than drivers are.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "gles3/crowd/crowd.h"
#include "gles3/program.h"
#include "gles3/skinned.h"
#include "marrow/gles3_crowd.h"
#include "marrow/gles3_skinner.h"
#include "support/places.h"

namespace marrow::embedded {
extern const unsigned char shader_surface_vert[], shader_surface_frag[], shader_depth_vert[], shader_depth_frag[],
    shader_backdrop_vert[], shader_backdrop_frag[], shader_studio[], shader_self_test_vert[], shader_self_test_frag[];
}

namespace marrow::test {
namespace {

// A driver that notes what it is told to compile.
std::map<std::string, const char*>* noted = nullptr;  // text → the compiler's name of the stage
unsigned stage = 0;
const char* renderer = "";

gles3::Api noting_api() {
  gles3::Api api;
  api.GetString = [](unsigned) { return reinterpret_cast<const unsigned char*>(renderer); };
  api.CreateShader = [](unsigned type) { return stage = type; };
  api.ShaderSource = [](unsigned, int count, const char* const* texts, const int*) {
    std::string all;
    for (int i = 0; i < count; ++i) all += texts[i];
    (*noted)[all] = stage == 0x8B31u ? "vert" : stage == 0x8B30u ? "frag" : "comp";
  };
  api.CompileShader = [](unsigned) {};
  api.GetShaderiv = [](unsigned, unsigned, int* value) { *value = 1; };
  api.DeleteShader = [](unsigned) {};
  api.CreateProgram = [] { return 1u; };
  api.AttachShader = [](unsigned, unsigned) {};
  api.TransformFeedbackVaryings = [](unsigned, int, const char* const*, unsigned) {};
  api.LinkProgram = [](unsigned) {};
  api.GetProgramiv = [](unsigned, unsigned, int* value) { *value = 1; };
  api.GetUniformBlockIndex = [](unsigned, const char*) { return 0xFFFFFFFFu; };
  api.GetUniformLocation = [](unsigned, const char*) { return -1; };
  return api;
}

std::string text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

void note_all() {
  const gles3::Api api = noting_api();
  gles3::Caps caps;
  caps.compute = true;
  const std::string surface = text(embedded::shader_studio) + text(embedded::shader_surface_frag);
  const std::string backdrop = text(embedded::shader_studio) + text(embedded::shader_backdrop_frag);
  const std::string pairs[][2] = {{text(embedded::shader_surface_vert), surface},
                                  {text(embedded::shader_depth_vert), text(embedded::shader_depth_frag)},
                                  {text(embedded::shader_self_test_vert), text(embedded::shader_self_test_frag)},
                                  {text(embedded::shader_backdrop_vert), backdrop}};
  gles3::Program out;
  for (int deformer = 0; deformer < 4; ++deformer)
    for (int influences = 4; influences <= 8; ++influences)
      for (int features = 0; features < 64; ++features)
        for (const gles3::Palettes palettes :
             {gles3::Palettes::uniform_block, gles3::Palettes::texture, gles3::Palettes::crowd}) {
          // These stand beside skinning.
          const bool looks = (features & (gles3::kUvs | gles3::kColours)) != 0;
          if ((looks || *renderer != 0) && influences != 4 && influences != 8) continue;
          const bool crowd = palettes == gles3::Palettes::crowd;
          const bool can = !crowd || (deformer != 0 && (features & gles3::kMorphs) == 0);
          const gles3::ProgramKey key{static_cast<gles3::Deformer>(deformer), static_cast<std::uint8_t>(influences),
                                      static_cast<std::uint8_t>(features), palettes};
          for (const auto& [vertex, fragment] : pairs)
            EXPECT_EQ(gles3::create_program(api, key, {vertex.c_str(), fragment.c_str(), {}}, 0, out),
                      can ? Status::ok : Status::bad_argument);
          for (const gles3::Preskin method : {gles3::Preskin::feedback, gles3::Preskin::compute})
            EXPECT_EQ(gles3::create_preskin(api, caps, key, method, 0, out),
                      deformer == 0 || crowd ? Status::bad_argument : Status::ok);
        }
  EXPECT_EQ(gles3::create_crowd_program(api, out), Status::ok);
}

TEST(ShaderText, PassesTheReferenceCompiler) {
  if (std::system("command -v glslangValidator >/dev/null 2>&1") != 0) {
    std::fprintf(stderr, "SKIPPED: glslangValidator is missing (Debian: glslang-tools)\n");
    GTEST_SKIP() << "glslangValidator is missing";
  }
  std::map<std::string, const char*> texts;
  noted = &texts;
  for (const char* const name : {"", "Mali-G57", "Mali-T860", "Adreno (TM) 660", "NVIDIA Tegra"}) {
    renderer = name;
    note_all();
  }
  EXPECT_GT(texts.size(), 1000u);
  std::string folder = (std::filesystem::temp_directory_path() / "marrow_shaders_XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  // The short form takes every fifth.
  const std::size_t step = in_long_form() ? 1 : 5;
  std::size_t number = 0;
  for (const auto& [shader, suffix] : texts)
    if (number++ % step == 0) std::ofstream(folder + "/" + std::to_string(number) + "." + suffix) << shader;
  const std::string command = "cd '" + folder +
                              "' && ls *.vert *.frag *.comp | xargs -n 100 -P 2 glslangValidator > log || "
                              "{ grep -m 20 ERROR log; false; }";
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::filesystem::remove_all(folder);
  std::printf("%zu texts of %zu\n", (texts.size() + step - 1) / step, texts.size());
}

}  // namespace
}  // namespace marrow::test
