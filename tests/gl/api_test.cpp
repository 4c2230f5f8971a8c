// Bad calls and missing functions: a status that says so, nothing changed, nothing leaked.
#include <cstdlib>
#include <cstring>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "gl/support/faulty_driver.h"
#include "gl/support/models.h"
#include "gl/support/troop.h"
#include "gles3/mesh/gpu_mesh.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/program_set.h"
#include "gles3/skinned.h"
#include "gles3/skinner_state.h"
#include "marrow/egl.h"
#include "marrow/gles3_skinner.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

const char* hidden_function = nullptr;

void* load_all_but_one(const char* name) {
  return std::strcmp(name, hidden_function) == 0 ? nullptr : egl::load_proc(name);
}

TEST(Api, AMissingFunctionIsNamed) {
  gl();
  std::set<std::string> names;
#define MARROW_NAME(Result, Name, Parameters) names.insert("gl" #Name);
  MARROW_GLES3_FUNCTIONS(MARROW_NAME)
#undef MARROW_NAME
  EXPECT_GE(names.size(), 30u);
  for (const std::string& name : names) {
    hidden_function = name.c_str();
    gles3::Api api;
    const char* missing = "";
    EXPECT_EQ(gles3::load_api(api, load_all_but_one, &missing), Status::unsupported);
    EXPECT_EQ(name, missing);
    EXPECT_EQ(api.DrawElements, nullptr) << "written on failure";
  }
  gles3::Api api;
  EXPECT_EQ(gles3::load_api(api, nullptr), Status::bad_argument);
}

TEST(Api, WithoutComputeShadersThereIsTheRest) {
  for (const char* const name : {"glDispatchCompute", "glMemoryBarrier"}) {
    hidden_function = name;
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, load_all_but_one), Status::ok);
    gles3::Caps caps;
    ASSERT_EQ(gles3::query_caps(api, caps), Status::ok);
    EXPECT_FALSE(caps.compute) << name;
    gles3::Program program;
    EXPECT_EQ(gles3::create_preskin(api, caps, {}, gles3::Preskin::compute, 0, program), Status::unsupported);
    EXPECT_EQ(program.id, 0u);
  }
  gles3::Api old = gl();
  old.GetString = [](unsigned) { return reinterpret_cast<const unsigned char*>("OpenGL ES 3.0 Somebody"); };
  gles3::Caps caps;
  ASSERT_EQ(gles3::query_caps(old, caps), Status::ok);
  EXPECT_FALSE(caps.compute);
}

TEST(Api, CapsAreAtLeastTheLeast) {
  gles3::Caps caps;
  ASSERT_EQ(gles3::query_caps(gl(), caps), Status::ok);
  EXPECT_GE(caps.uniform_block_bytes, 16384u);
  EXPECT_LE(caps.uniform_offset_alignment, 256u);
  EXPECT_GE(caps.vertex_attributes, 16u);
  EXPECT_GE(caps.texture_size, 2048u);
}

TEST(Api, AnotherVersionIsRefused) {
  gles3::Api api = gl();
  gles3::Caps caps;
  api.GetString = [](unsigned) { return reinterpret_cast<const unsigned char*>("OpenGL ES 2.0 Somebody"); };
  EXPECT_EQ(gles3::query_caps(api, caps), Status::unsupported);
  api.GetString = [](unsigned) { return reinterpret_cast<const unsigned char*>("4.6.0 Somebody"); };
  EXPECT_EQ(gles3::query_caps(api, caps), Status::unsupported);
  api.GetString = [](unsigned) -> const unsigned char* { return nullptr; };
  EXPECT_EQ(gles3::query_caps(api, caps), Status::unsupported);
}

TEST(Api, PrepareRefusesBadCalls) {
  const TestCharacter character = make_character(3, 10, 2, false);
  const Mesh mesh = character.mesh.view();
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  std::vector<Affine> bind(mesh.joint_count);
  gles3::GpuMesh out;
  const gles3::Caps caps;
  const std::vector<float> too_few(as_tangent_count(mesh.geometry) - 1);
  EXPECT_EQ(gles3::prepare(gl(), caps, mesh, {true, true, too_few}, scratch, bind, out), Status::bad_argument);
  EXPECT_EQ(gles3::prepare(gl(), caps, mesh, {}, {scratch.data(), scratch.size() - 1}, bind, out),
            Status::bad_argument);
  EXPECT_EQ(gles3::prepare(gl(), caps, mesh, {}, scratch, {bind.data(), bind.size() - 1}, out), Status::bad_argument);
  gles3::Caps small = caps;
  small.vertex_attributes = 15;
  EXPECT_EQ(gles3::prepare(gl(), small, mesh, {}, scratch, bind, out), Status::unsupported);
  EXPECT_EQ(out.ssd_array, 0u);
  ASSERT_EQ(gles3::prepare(gl(), caps, mesh, {true, false}, scratch, bind, out), Status::ok);
  EXPECT_NE(out.ssd_array, 0u);
  EXPECT_EQ(out.as_array, 0u);
  EXPECT_EQ(gles3::draw(gl(), out, gles3::Deformer::as, {}), Status::bad_argument);
  gles3::destroy(gl(), out);
  EXPECT_EQ(out.ssd_array, 0u);
}

TEST(Api, AMeshWithoutVerticesIsRefused) {
  const TestCharacter character = make_character(3, 10, 2, false);
  Mesh mesh = with_box(character.mesh);
  mesh.geometry.runs = {};
  mesh.geometry.slot_count = mesh.geometry.vertex_count = mesh.geometry.index_count = 0;
  std::vector<std::byte> scratch(1000);
  std::vector<Affine> bind(mesh.joint_count, Affine{});
  const gles3::Api api = faulty_api(gl());
  gles3::GpuMesh out;
  EXPECT_EQ(gles3::prepare(api, {}, mesh, {}, scratch, bind, out), Status::bad_argument);
  EXPECT_EQ(bind[0].rows[0][0], 0.0f) << "written on failure";
  gles3::ProgramSet programs;
  programs.roles[0] = feedback_source();
  std::vector<SoaTransform> memory;
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    gles3::SkinnerOptions options;
    options.path = static_cast<gles3::SkinningPath>(i);
    gles3::Skinner skinner;
    const Span<std::byte> room = room_for(memory, gles3::skinner_bytes(mesh, options));
    gles3::Caps caps;
    caps.compute = true;
    EXPECT_EQ(gles3::create_skinner(api, caps, mesh, options, programs, room, skinner), Status::bad_argument) << i;
    EXPECT_TRUE(state_of(skinner).palettes.empty());
  }
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 10);
  gles3::CrowdMesh crowd;
  EXPECT_EQ(gles3::create_crowd_mesh(api, {}, mesh, {}, reel.frames, 1, room_for(memory, gles3::crowd_mesh_bytes(mesh)),
                                     crowd),
            Status::bad_argument);
  EXPECT_EQ(crowd.capacity, 0u);
  EXPECT_EQ(driver().made, 0);
  EXPECT_EQ(state_of(programs).count, 0u);
  EXPECT_EQ(gl().GetError(), 0u);
}

TEST(Api, APaletteTooShortIsRefused) {
  const TestCharacter character = make_character(3, 10, 2, false);
  const Mesh mesh = with_box(character.mesh);
  ASSERT_EQ(mesh.palette_size(), 10u);
  const std::vector<Affine> joints(10, Affine{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  // In a texture, of ten and five matrices.
  gles3::ProgramKey key;
  key.palettes = gles3::Palettes::texture;
  gles3::Program program;
  ASSERT_EQ(gles3::create_program(gl(), key, feedback_source(), 0, program), Status::ok);
  gl().UseProgram(program.id);
  gles3::PaletteTexture texture;
  ASSERT_EQ(gles3::create_palette_texture(gl(), {}, 100, texture), Status::ok);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 0, 10, 0, program), Status::bad_argument) << "none is there";
  ASSERT_EQ(gles3::upload_palettes(gl(), texture, joints), Status::ok);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 0, 10, 0, program), Status::ok);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 1, 10, 0, program), Status::bad_argument);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 10, 0, 0, program), Status::bad_argument);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 9, 0xFFFFFFFF, 0, program), Status::bad_argument);
  ASSERT_EQ(gles3::upload_palettes(gl(), texture, {joints.data(), 5}), Status::ok);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 0, 10, 0, program), Status::bad_argument) << "the last frame's";
  gles3::destroy(gl(), texture);
  gles3::destroy(gl(), program);

  // Of a skinner; what was posed before is there still.
  gles3::ProgramSet programs;
  programs.roles[0] = feedback_source();
  for (const gles3::SkinningPath path : {gles3::SkinningPath::ubo, gles3::SkinningPath::texture,
                                         gles3::SkinningPath::feedback, gles3::SkinningPath::cpu}) {
    gles3::SkinnerOptions options;
    options.path = path;
    std::vector<SoaTransform> memory;
    gles3::Skinner skinner;
    ASSERT_EQ(gles3::create_skinner(gl(), {}, mesh, options, programs,
                                    room_for(memory, gles3::skinner_bytes(mesh, options)), skinner),
              Status::ok);
    ASSERT_EQ(gles3::pose(skinner, 0, joints), Status::ok);
    const std::vector<Affine> before(state_of(skinner).palettes.begin(), state_of(skinner).palettes.end());
    EXPECT_EQ(gles3::pose(skinner, 0, {joints.data(), 9}), Status::bad_argument) << gles3::to_string(path);
    EXPECT_EQ(gles3::pose(skinner, 0, {}), Status::bad_argument) << gles3::to_string(path);
    EXPECT_EQ(std::memcmp(before.data(), state_of(skinner).palettes.data, before.size() * sizeof(Affine)), 0);
    gles3::destroy(gl(), skinner);
  }
  gles3::destroy(gl(), programs);
  EXPECT_EQ(gl().GetError(), 0u);
}

// As the driver is by itself, and in the test gl.es2 one that has no more than 2.0.
TEST(Es2, AContextIsTakenForWhatItIs) {
  std::thread([] {
    const char* const override = std::getenv("MESA_GLES_VERSION_OVERRIDE");
    egl::HeadlessContext context;
    ASSERT_EQ(context.create(2, 0), Status::ok) << context.error();
    gles3::Api api;
    ASSERT_EQ(gles3::load_api(api, egl::load_proc), Status::ok);
    const std::string version = reinterpret_cast<const char*>(api.GetString(GL_VERSION));
    std::printf("%s\n", version.c_str());
    const bool is_old = version.starts_with("OpenGL ES 2.");
    const bool is_forced = override != nullptr && std::strcmp(override, "2.0") == 0;
    EXPECT_TRUE(is_old || !is_forced || version.find("Mesa") == std::string::npos) << version;
    gles3::Caps caps;
    caps.texture_size = 7;
    EXPECT_EQ(gles3::query_caps(api, caps), is_old ? Status::unsupported : Status::ok);
    EXPECT_EQ(caps.texture_size == 7, is_old) << "written on failure";
    if (!is_old || !is_forced) return;
    EXPECT_EQ(api.ObjectLabel, nullptr);
    egl::HeadlessContext other;
    EXPECT_EQ(other.create(), Status::unsupported);
    EXPECT_NE(std::string(other.error()).find("OpenGL ES"), std::string::npos) << other.error();
    try {
      const tools::Gl tool;
      ADD_FAILURE() << tool.driver();
    } catch (const tools::Failure& failure) {
      EXPECT_EQ(failure.code(), tools::Exit::unsupported);
      EXPECT_EQ(failure.file(), "OpenGL ES");
    }
  }).join();
}

unsigned pretend_out_of_memory() {
  static int calls = 0;
  return ++calls % 2 == 1 ? 0u : 0x0505u;  // clean before, GL_OUT_OF_MEMORY after
}

TEST(Api, OutOfMemoryLeavesNothing) {
  const TestCharacter character = make_character(4, 10, 2, false);
  const Mesh mesh = character.mesh.view();
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  std::vector<Affine> bind(mesh.joint_count, Affine{});
  gles3::Api api = gl();
  api.GetError = pretend_out_of_memory;
  gles3::GpuMesh out;
  EXPECT_EQ(gles3::prepare(api, {}, mesh, {}, scratch, bind, out), Status::gl_error);
  EXPECT_EQ(out.ssd_buffer, 0u);
  EXPECT_EQ(bind[0].rows[0][0], 0.0f) << "written on failure";
}

TEST(Api, TheRingFillsUpAndEmpties) {
  gles3::PaletteRing ring;
  EXPECT_EQ(gles3::create_palette_ring(gl(), {}, 0, 1, ring), Status::bad_argument);
  ASSERT_EQ(gles3::create_palette_ring(gl(), {}, 20, 2, ring), Status::ok);
  const std::vector<Affine> palette(gles3::kPaletteJoints + 1, Affine{});
  std::uint32_t first = 1, second = 0;
  gles3::begin_frame(gl(), ring);
  EXPECT_EQ(gles3::push_palette(gl(), ring, {palette.data(), 10}, first), Status::ok);
  EXPECT_EQ(gles3::push_palette(gl(), ring, {palette.data(), 10}, second), Status::ok);
  EXPECT_EQ(first, 0u);
  EXPECT_EQ(second % 256, 0u);
  EXPECT_GE(second, 480u);
  EXPECT_EQ(gles3::push_palette(gl(), ring, {palette.data(), 30}, second), Status::unsupported);
  EXPECT_EQ(gles3::push_palette(gl(), ring, {palette.data(), 0}, second), Status::bad_argument);
  EXPECT_EQ(gles3::push_palette(gl(), ring, palette, second), Status::bad_argument);
  gles3::begin_frame(gl(), ring);
  EXPECT_EQ(gles3::push_palette(gl(), ring, {palette.data(), 20}, first), Status::ok);
  gles3::destroy(gl(), ring);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

TEST(Api, PalettesInATextureRefuseBadCalls) {
  gles3::PaletteTexture texture;
  gles3::Caps caps;
  EXPECT_EQ(gles3::create_palette_texture(gl(), caps, 0, texture), Status::bad_argument);
  // 2048² texels are 1 398 101 matrices and a texel.
  EXPECT_EQ(gles3::create_palette_texture(gl(), caps, 1398102, texture), Status::unsupported);
  caps.texture_size = 1024;
  EXPECT_EQ(gles3::create_palette_texture(gl(), caps, 1, texture), Status::unsupported);
  EXPECT_EQ(texture.textures[0], 0u);
  ASSERT_EQ(gles3::create_palette_texture(gl(), {}, 10, texture), Status::ok);
  const std::vector<Affine> palettes(11, Affine{});
  EXPECT_EQ(gles3::upload_palettes(gl(), texture, {palettes.data(), 0}), Status::bad_argument);
  EXPECT_EQ(gles3::upload_palettes(gl(), texture, palettes), Status::unsupported);
  EXPECT_EQ(gles3::upload_palettes(gl(), texture, {palettes.data(), 10}), Status::ok);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 0, 10, 0, {}), Status::bad_argument) << "a program of another kind";
  gles3::destroy(gl(), texture);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

TEST(Api, SkinnedMeshesRefuseBadCalls) {
  const TestCharacter character = make_character(3, 10, 2, true);
  const Mesh mesh = character.mesh.view();
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh));
  std::vector<Affine> bind(mesh.joint_count);
  gles3::GpuMesh gpu;
  ASSERT_EQ(gles3::prepare(gl(), {}, mesh, {false, false}, scratch, bind, gpu), Status::ok) << "for the CPU's vertices";
  EXPECT_EQ(gpu.ssd_array, 0u);
  EXPECT_EQ(gpu.as_array, 0u);
  gles3::SkinnedMesh skinned;
  ASSERT_EQ(gles3::create_skinned(gl(), gpu, skinned), Status::ok);
  std::vector<float> three(std::size_t{3} * gpu.slot_count), four(std::size_t{4} * gpu.slot_count);
  EXPECT_EQ(gles3::upload_skinned(gl(), skinned, {three, {}, {}}), Status::ok);
  EXPECT_EQ(gles3::upload_skinned(gl(), skinned, {three, three, {}}),
            (gpu.features & gles3::kNormals) != 0 ? Status::ok : Status::bad_argument);
  EXPECT_EQ(gles3::upload_skinned(gl(), skinned, {{}, three, {}}), Status::bad_argument);
  EXPECT_EQ(gles3::upload_skinned(gl(), skinned, {four, {}, {}}), Status::bad_argument);
  EXPECT_EQ(gles3::preskin(gl(), gpu, gles3::Deformer::ssd, {}, skinned), Status::bad_argument) << "not prepared";
  EXPECT_EQ(gles3::preskin(gl(), gpu, gles3::Deformer::none, {}, skinned), Status::bad_argument);
  gles3::Program program;
  EXPECT_EQ(gles3::create_preskin(gl(), {}, {gles3::Deformer::none, 4, 0}, gles3::Preskin::feedback, 0, program),
            Status::bad_argument);
  EXPECT_EQ(gles3::create_preskin(gl(), {}, {gles3::Deformer::ssd, 9, 0}, gles3::Preskin::feedback, 0, program),
            Status::bad_argument);
  gles3::destroy(gl(), skinned);
  gles3::destroy(gl(), gpu);
  EXPECT_EQ(skinned.buffer, 0u);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

}  // namespace
}  // namespace marrow::test
