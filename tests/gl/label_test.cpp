// Labels of GL objects: where they come from, how they are cut, and that crowds and the self-test have them too.
#include <cstring>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "gl/support/faulty_driver.h"
#include "gl/support/models.h"
#include "gl/support/self_test_run.h"
#include "gl/support/troop.h"
#include "gles3/crowd/crowd.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/prepare.h"
#include "gles3/program.h"
#include "marrow/gles3_crowd.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

// A loader that has something for every name.
const char* pretended_version = nullptr;
const char* pretended_extensions = nullptr;
void label_of_khr() {}
void label_of_es() {}
void something() {}
const unsigned char* pretended_string(unsigned name) {
  return reinterpret_cast<const unsigned char*>(name == GL_VERSION ? pretended_version : pretended_extensions);
}
void* pretended_proc(const char* name) {
  if (std::strcmp(name, "glGetString") == 0) return reinterpret_cast<void*>(pretended_string);
  if (std::strcmp(name, "glObjectLabelKHR") == 0) return reinterpret_cast<void*>(label_of_khr);
  if (std::strcmp(name, "glObjectLabel") == 0) return reinterpret_cast<void*>(label_of_es);
  return reinterpret_cast<void*>(something);
}

TEST(ApiLabels, AreThereIfTheContextSaysSo) {
  struct Case {
    const char *version, *extensions;
    void (*expected)();
  };
  const Case cases[] = {
      {"OpenGL ES 3.0 Somebody", "GL_OES_one GL_KHR_debug GL_OES_two", label_of_khr},
      {"OpenGL ES 3.0 Somebody", "GL_KHR_debug", label_of_khr},
      {"OpenGL ES 3.2 Somebody", "GL_OES_one GL_KHR_debug", label_of_khr},
      {"OpenGL ES 3.2 Somebody", "GL_OES_one", label_of_es},
      {"OpenGL ES 3.2 Somebody", nullptr, label_of_es},
      {"OpenGL ES 3.1 Somebody", "GL_KHR_debugger GL_XKHR_debug GL_KHR_ GL_KHR_debu", nullptr},
      {"OpenGL ES 3.1 Somebody", "", nullptr},
      {"4.6.0 Somebody", "GL_KHR_debug", nullptr},
      {nullptr, nullptr, nullptr},  // no current context
  };
  for (const Case& one : cases) {
    pretended_version = one.version;
    pretended_extensions = one.extensions;
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, pretended_proc), Status::ok);
    EXPECT_EQ(reinterpret_cast<void*>(api.ObjectLabel.function), reinterpret_cast<void*>(one.expected))
        << (one.extensions != nullptr ? one.extensions : "none");
  }
}

// Labels of a mesh with this name: its index buffer's.
std::string label_of_indices(const char* name) {
  const TestCharacter character = make_character(3, 10, 2, false);
  Mesh mesh = with_box(character.mesh);
  mesh.name = name;
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  std::vector<Affine> bind(mesh.joint_count);
  gles3::Api api = faulty_api(gl());
  record_labels(api);
  gles3::GpuMesh out;
  EXPECT_EQ(gles3::prepare(api, {}, mesh, {}, scratch, bind, out), Status::ok);
  EXPECT_EQ(static_cast<std::int64_t>(driver().labels.size()), driver().live);
  const std::string text = driver().labels[{0x82E0, out.index_buffer}].text;
  gles3::destroy(api, out);
  return text;
}

TEST(ApiLabels, AreCutToFitAtWholeCharacters) {
  EXPECT_EQ(label_of_indices("newt"), "newt: indices");
  EXPECT_EQ(label_of_indices(""), "mesh: indices");
  EXPECT_EQ(label_of_indices(nullptr), "mesh: indices");
  const std::string a95(95, 'a');
  EXPECT_EQ(label_of_indices((a95 + "b").c_str()), a95 + "b: indices");
  EXPECT_EQ(label_of_indices((a95 + "bc").c_str()), a95 + "b: indices");
  EXPECT_EQ(label_of_indices((a95 + "\u00e4").c_str()), a95 + ": indices");
  EXPECT_EQ(label_of_indices((a95.substr(1) + "\u00e4").c_str()), a95.substr(1) + "\u00e4: indices");
}

TEST(CrowdLabels, EveryObjectHasOne) {
  const TestCharacter character = make_character(3, 10, 2, false);
  Mesh mesh = with_box(character.mesh);
  mesh.name = "newt";
  std::uint32_t joints = 0;
  for (std::uint32_t i = 0; i < mesh.joint_count; ++i) joints = std::max(joints, mesh.joints[i] + 1u);
  const std::vector<Affine> matrices(std::size_t{2} * joints);
  const gles3::CrowdClip clip = {1, 0, 1, true};
  gles3::CrowdFrames frames;
  frames.clips = {&clip, 1};
  frames.character_from_joint = matrices;
  frames.joint_count = joints;
  frames.frame_count = 2;
  std::vector<SoaTransform> memory, room;

  gles3::Api api = faulty_api(gl());
  record_labels(api);
  gles3::Crowd crowd;
  gles3::CrowdMesh crowd_mesh;
  gles3::Program program;
  ASSERT_EQ(gles3::create_crowd(api, {}, 10, room_for(room, 10 * gles3::kCrowdInstanceBytes), crowd), Status::ok);
  ASSERT_EQ(gles3::create_crowd_mesh(api, {}, mesh, {}, frames, 10, room_for(memory, gles3::crowd_mesh_bytes(mesh)),
                                     crowd_mesh),
            Status::ok);
  ASSERT_EQ(gles3::create_crowd_program(api, program), Status::ok);
  EXPECT_EQ(driver().live, 5 + 6) << "those of prepare() too";
  EXPECT_EQ(driver().label_count, driver().live);
  const auto text = [](unsigned kind, unsigned name) { return driver().labels[{kind, name}].text; };
  EXPECT_EQ(text(GL_TEXTURE, crowd.texture), "marrow: crowd");
  EXPECT_EQ(text(GL_TEXTURE, state_of(crowd_mesh).frames_texture), "newt: frames");
  EXPECT_EQ(text(GL_TEXTURE, state_of(crowd_mesh).blended_texture), "newt: blended palettes");
  EXPECT_EQ(text(GL_FRAMEBUFFER, state_of(crowd_mesh).framebuffer), "newt: blended palettes");
  EXPECT_EQ(text(0x82E2, program.id), "marrow: blending of crowds");
  gles3::destroy(api, crowd);
  gles3::destroy(api, crowd_mesh);
  gles3::destroy(api, program);
  EXPECT_EQ(driver().live, 0);
}

TEST(SelfTestLabels, EveryObjectHasOne) {
  gles3::Api api = faulty_api(gl());
  record_labels(api);
  expect(run(api, gl().caps(), {}), 0, Verdict::usable, "with labels");
  EXPECT_GT(driver().made, 50);
  EXPECT_EQ(driver().label_count, driver().made);
  for (const auto& [object, label] : driver().labels) EXPECT_FALSE(label.text.empty());
}

}  // namespace
}  // namespace marrow::test
