// Crowds as the GPU draws them, held against the CPU: vertices, sockets, thousands in one call, no work for nothing.
#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

#include "gl/support/crowd_worst.h"
#include "gl/support/models.h"
#include "gl/support/troop.h"
#include "gles3/crowd/crowd.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "marrow/marrow.h"
#include "pose/evaluate.h"
#include "support/places.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

using gles3::CrowdInstance;

TEST(Crowd, DrawsTheNewtAsTheCpuDoes) {
  const std::optional<Model> model = cook_model(newt_glb());
  ASSERT_TRUE(model.has_value());
  const Mesh mesh = model->file.mesh(0);
  const Reel reel(model->file.skeleton(mesh.skeleton), all_clips(model->file, mesh.skeleton), 30);
  ASSERT_GE(reel.clips.size(), 3u);
  expect_crowd_promises("newt", compare_crowd(mesh, reel, {}, 0));
  expect_crowd_promises("newt after 24 h", compare_crowd(mesh, reel, {}, 86400));
  expect_crowd_promises("newt, its surface's normals",
                        compare_crowd(mesh, reel, tools::tangents_of(model->file)[0], 0));
}

TEST(Crowd, DrawsNoiseWithEightInfluences) {
  for (const std::size_t joints : {5u, 67u, 700u}) {
    const TestCharacter character = make_character(joints, joints, 13, true);
    const Reel reel(character.skeleton.view(), {{character.clip.view(), true}, {character.clip.view(), false}}, 20);
    expect_crowd_promises("noise", compare_crowd(with_box(character.mesh), reel, {}, 3));
  }
}

// Helpers are in the baked palettes; on a baked frame they are the CPU's.
void expect_helper_on_frames(Span<const float> centre) {
  const TestCharacter character = make_character(31, 9, 13, false);
  TestRun run;
  run.set = {2};  // the helper
  for (const double x : {0.0, 1.0, 2.0}) run.vertices.push_back({{x, 1, x * x}, {0, 0, 1}, {1, 0, 0}, 1, {1}, {}});
  const Map none;
  const TestMesh source({run}, {none, none});
  Mesh mesh = with_box(source);
  const Helper helper{0, 1, 0.5f};
  mesh.helpers = {&helper, 1};
  mesh.helper_centres = centre;
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 16);
  const gles3::CrowdClip& clip = reel.clips[0];
  Troop troop(mesh, reel, 1);
  ASSERT_TRUE(troop.ok());
  ASSERT_EQ(state_of(troop.mesh()).joints, 3u);
  CrowdInstance instance;
  instance.a = {0, clip.duration_s * 3 / static_cast<float>(clip.steps), 0, 0};
  ASSERT_EQ(troop.set(0, {&instance, 1}), Status::ok);
  ASSERT_EQ(troop.blend(0, 1, 0), Status::ok);
  const Worst worst = compare_instance(mesh, reel.frames, instance, 0, gles3::Deformer::ssd, {}, {},
                                       troop.capture(gles3::Deformer::ssd, 0, 1)[0]);
  EXPECT_LE(worst.position, kMostCrowdPosition);
}
TEST(Crowd, HelpersAreTheCpusOnFrames) {
  expect_helper_on_frames({});
}
TEST(Crowd, HelpersAboutCentresAreTheCpusOnFrames) {
  const float centre[] = {0.5f, -0.25f, 1};
  expect_helper_on_frames(centre);
}

// A vertex that hangs on one joint, at that joint's origin, is where crowd_joint() says that the joint is.
TEST(Crowd, SocketsAreWhereTheVerticesAre) {
  const TestCharacter character = make_character(77, 6, 4, false);
  TestRun run;
  run.set = {5};
  run.vertices = {{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1, {1}, {}}, {{1, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1, {1}, {}}};
  const TestMesh source({run}, std::vector<Map>(6));
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 24);
  constexpr std::uint32_t kCount = 40;
  Troop troop(with_box(source), reel, kCount);
  ASSERT_TRUE(troop.ok());
  const std::vector<CrowdInstance> instances = some_of_each(reel.frames, kCount, 50, 10);
  ASSERT_EQ(troop.set(0, instances), Status::ok);
  ASSERT_EQ(troop.blend(0, kCount, 50.1), Status::ok);
  const std::vector<Skinned> got = troop.capture(gles3::Deformer::ssd, 0, kCount);
  for (std::size_t i = 0; i < kCount; ++i) {
    Affine joint;
    ASSERT_EQ(gles3::crowd_joint(reel.frames, instances[i], 50.1, 5, joint), Status::ok);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto size = 1e-4f * (1 + std::fabs(joint.rows[c][3]) + std::fabs(joint.rows[c][0]));
      EXPECT_NEAR(got[i].positions[c], joint.rows[c][3], size) << i;
      EXPECT_NEAR(got[i].positions[3 + c], joint.rows[c][3] + joint.rows[c][0], size) << i;
    }
  }
}

TEST(Crowd, ARangeOfInstancesIsSetAndDrawn) {
  const TestCharacter character = make_character(3, 10, 5, false);
  const Mesh mesh = with_box(character.mesh);
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 10);
  constexpr std::uint32_t kCount = 1500;  // six lines
  Troop troop(mesh, reel, kCount);
  ASSERT_TRUE(troop.ok());
  std::vector<CrowdInstance> instances = some_of_each(reel.frames, kCount, 1, 5);
  ASSERT_EQ(troop.set(0, {instances.data(), 700}), Status::ok);
  EXPECT_EQ(troop.crowd().count, 700u);
  ASSERT_EQ(troop.set(700, {instances.data() + 700, 800}), Status::ok);
  const std::vector<CrowdInstance> others = some_of_each(reel.frames, 600, 2, 7);
  ASSERT_EQ(troop.set(300, others), Status::ok) << "rest of a line, whole ones, and the start of one";
  EXPECT_EQ(troop.crowd().count, kCount);
  std::copy(others.begin(), others.end(), instances.begin() + 300);

  ASSERT_EQ(troop.blend(0, kCount, 1.5), Status::ok);
  ASSERT_EQ(troop.blend(250, 700, 1.75), Status::ok) << "these later";
  Worst worst;
  const auto look = [&](std::uint32_t first, std::uint32_t count, double time_s) {
    const std::vector<Skinned> got = troop.capture(gles3::Deformer::ssd, first, count);
    for (std::size_t i = 0; i < count; ++i)
      worst.add(
          compare_instance(mesh, reel.frames, instances[first + i], time_s, gles3::Deformer::ssd, {}, {}, got[i]));
  };
  look(0, 150, 1.5);
  look(250, 700, 1.75);
  look(1100, 400, 1.5);
  EXPECT_LE(worst.position, kMostCrowdPosition);
}

// As many as a city has, one call: of every one its first vertices, and a pixel of its own.
constexpr std::uint32_t kSide = 100;
constexpr const char* kDotVertex = R"(
out vec4 dot_colour;
void main() {
  dot_colour = marrow_instance_colour();
  MarrowVertex v = marrow_skin();
  gl_Position = vec4(v.position.xy, 0.0, 1.0);
}
)";
constexpr const char* kDotFragment = R"(
precision highp float;
in vec4 dot_colour;
out vec4 colour;
void main() { colour = dot_colour; }
)";

int instanced_calls = 0, instances_drawn = 0;
void (*real_draw)(unsigned, int, unsigned, const void*, int) = nullptr;

// Two triangles over [-1, 1]² that hang on one joint at rest.
TestMesh square() {
  TestRun run;
  run.set = {0};
  for (const double y : {-1.0, 1.0})
    for (const double x : {-1.0, 1.0}) run.vertices.push_back({{x, y, 0}, {0, 0, 1}, {1, 0, 0}, 1, {1}, {}});
  return TestMesh({run}, {Map{}});
}

// In rows over the picture, each in a colour that is its number.
std::vector<CrowdInstance> one_a_pixel() {
  std::vector<CrowdInstance> out(kSide * kSide);
  const float half = 1.0f / kSide;
  for (std::uint32_t i = 0; i < out.size(); ++i) {
    const float x = half * static_cast<float>(2 * (i % kSide) + 1) - 1;
    const float y = half * static_cast<float>(2 * (i / kSide) + 1) - 1;
    out[i].a = {0, 0, 1, 0};
    out[i].world_from_model = {{{0.9f * half, 0, 0, x}, {0, 0.9f * half, 0, y}, {0, 0, 1, 0}}};
    const float colour[4] = {static_cast<float>(i & 0xFF) / 255, static_cast<float>(i >> 8) / 255, 0, 1};
    std::copy_n(colour, 4, out[i].colour);
  }
  return out;
}

struct Picture {
  Picture() : pixels(gl()), target(gl()) {
    gl().BindRenderbuffer(GL_RENDERBUFFER, pixels);
    gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, kSide, kSide);
    gl().BindFramebuffer(GL_FRAMEBUFFER, target);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels);
  }
  void begin() const {
    gl().BindFramebuffer(GL_FRAMEBUFFER, target);
    gl().Viewport(0, 0, kSide, kSide);
    gl().Clear(GL_COLOR_BUFFER_BIT);
  }
  // How many pixels are their own number, of those from `first` on; others must be empty.
  std::size_t right(std::uint32_t first, std::uint32_t count) const {
    std::vector<std::uint8_t> got(std::size_t{4} * kSide * kSide);
    gl().ReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_UNSIGNED_BYTE, got.data());
    std::size_t out = 0;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i) {
      const std::uint8_t* const rgba = &got[std::size_t{4} * i];
      const bool drawn = i >= first && i < first + count;
      EXPECT_EQ(rgba[3], drawn ? 255 : 0) << i;
      out += drawn && rgba[0] + 256u * rgba[1] == i;
    }
    return out;
  }
  tools::GlRenderbuffer pixels;
  tools::GlFramebuffer target;
};

TEST(Crowd, TenThousandInOneCall) {
  constexpr std::uint32_t kCount = kSide * kSide;
  const TestMesh source = square();
  Mesh mesh = with_box(source);
  const std::uint16_t indices[] = {0, 1, 2, 2, 1, 3};
  mesh.geometry.indices = indices;
  mesh.geometry.index_count = 6;
  const TestSkeleton skeleton(std::vector<TestJoint>{{}});
  TestClip still;
  still.add(0, TrackPath::translation, Interpolation::step, {0, 1}, {0, 0, 0, 0, 0, 0});
  const Reel reel(skeleton.view(), {{still.view(), true}}, 1);
  Troop troop(mesh, reel, kCount);
  ASSERT_TRUE(troop.ok());
  ASSERT_EQ(troop.set(0, one_a_pixel()), Status::ok);
  ASSERT_EQ(troop.blend(0, kCount, 10), Status::ok);
  gles3::Program program;
  const gles3::ProgramKey key{gles3::Deformer::ssd, troop.gpu().influences, 0, gles3::Palettes::crowd};
  ASSERT_EQ(gles3::create_program(gl(), key, {kDotVertex, kDotFragment, {}}, 0, program), Status::ok);
  gl().UseProgram(program.id);
  gles3::Api counting = gl();
  real_draw = counting.DrawElementsInstanced.function;
  instanced_calls = instances_drawn = 0;
  counting.DrawElementsInstanced = [](unsigned mode, int count, unsigned type, const void* at, int number) {
    ++instanced_calls;
    instances_drawn += number;
    real_draw(mode, count, type, at, number);
  };
  const Picture picture;
  const auto draw = [&](std::uint32_t first, std::uint32_t count) {
    picture.begin();
    EXPECT_EQ(gles3::bind_crowd(counting, troop.crowd(), troop.mesh(), first, count, 0, program), Status::ok);
    EXPECT_EQ(gles3::draw(counting, troop.gpu(), gles3::Deformer::ssd, program, count), Status::ok);
    return picture.right(first, count);
  };
  EXPECT_EQ(draw(0, kCount), 10000u) << "each in its own pixel, in its own colour";
  EXPECT_EQ(instanced_calls, 1);
  EXPECT_EQ(instances_drawn, 10000);
  EXPECT_EQ(draw(1234, 777), 777u);
  gles3::destroy(gl(), program);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

int uploads = 0, small_uploads = 0;

TEST(Crowd, AFrameWithoutChangesUploadsNothing) {
  const TestCharacter character = make_character(8, 20, 5, false);
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 10);
  Troop troop(with_box(character.mesh), reel, 600);
  ASSERT_TRUE(troop.ok());
  const std::vector<CrowdInstance> instances = some_of_each(reel.frames, 600, 0, 5);
  ASSERT_EQ(troop.set(0, instances), Status::ok);
  const gles3::ProgramKey key{gles3::Deformer::ssd, 8, gles3::kNormals, gles3::Palettes::crowd};
  gles3::Program program;
  ASSERT_EQ(gles3::create_program(gl(), key, feedback_source(), 0, program), Status::ok);
  static const gles3::Api real = gl();
  gles3::Api api = real;
  uploads = small_uploads = 0;
  api.TexImage2D = [](unsigned, int, int, int, int, int, unsigned, unsigned, const void*) { ++uploads; };
  api.TexSubImage2D = [](unsigned, int, int, int, int, int, unsigned, unsigned, const void*) { ++uploads; };
  api.BufferData = [](unsigned, std::ptrdiff_t, const void*, unsigned) { ++uploads; };
  api.BufferSubData = [](unsigned, std::ptrdiff_t, std::ptrdiff_t, const void*) { ++uploads; };
  api.Uniform1iv = [](int at, int count, const int* v) {
    small_uploads += count;
    real.Uniform1iv(at, count, v);
  };
  api.Uniform4fv = [](int, int, const float*) { ++uploads; };
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_EQ(troop.blend(0, 600, 0.1 * frame, api), Status::ok);
    gl().UseProgram(program.id);
    ASSERT_EQ(gles3::bind_crowd(api, troop.crowd(), troop.mesh(), 0, 600, 0, program), Status::ok);
    ASSERT_EQ(gles3::draw(api, troop.gpu(), gles3::Deformer::ssd, program, 600), Status::ok);
  }
  EXPECT_EQ(uploads, 0);
  EXPECT_EQ(small_uploads, 40) << "the time, and three numbers";
  ASSERT_EQ(gles3::set_instances(api, troop.crowd(), reel.frames, 250, {instances.data(), 10}), Status::ok);
  EXPECT_EQ(uploads, 2) << "the end of a line and the start of the next";
  gles3::destroy(gl(), program);
  while (gl().GetError() != GL_NO_ERROR) {
  }
}

TEST(Crowd, MeshesRefuseBadCalls) {
  const TestCharacter character = make_character(3, 10, 5, false);
  Mesh mesh = with_box(character.mesh);
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 10);
  std::vector<SoaTransform> memory;
  const Span<std::byte> enough = room_for(memory, gles3::crowd_mesh_bytes(mesh));
  gles3::CrowdMesh out;
  const auto create = [&](const gles3::CrowdFrames& frames, std::uint32_t capacity, const gles3::Caps& caps = {}) {
    return gles3::create_crowd_mesh(gl(), caps, mesh, {}, frames, capacity, enough, out);
  };
  EXPECT_EQ(create(reel.frames, 0), Status::bad_argument);
  EXPECT_EQ(create({}, 1), Status::bad_argument);
  for (const auto& [first, size] : {std::pair{0, enough.size - 1}, {4, enough.size}})
    EXPECT_EQ(gles3::create_crowd_mesh(gl(), {}, mesh, {}, reel.frames, 1, {enough.data + first, size}, out),
              Status::bad_argument)
        << first;
  gles3::CrowdFrames frames = reel.frames;
  --frames.character_from_joint.size;
  EXPECT_EQ(create(frames, 1), Status::bad_argument);
  frames = reel.frames;
  frames.joint_count = 1;
  EXPECT_EQ(create(frames, 1), Status::bad_argument) << "a joint that the frames lack";

  // 2048² texels are 139 810 palettes of ten matrices.
  EXPECT_EQ(gles3::crowd_palettes_that_fit({}, 10), 139810u);
  EXPECT_EQ(gles3::crowd_palettes_that_fit({}, 0), 0u);
  ASSERT_EQ(mesh.palette_size(), 10u);
  const std::vector<Affine> many(std::size_t{139811} * 10, Affine{});
  frames = reel.frames;
  frames.frame_count = 139811;
  frames.character_from_joint = many;
  EXPECT_EQ(create(frames, 1), Status::unsupported) << "too many frames";
  EXPECT_EQ(create(reel.frames, 139811), Status::unsupported) << "too many instances";
  gles3::Caps small;
  small.texture_size = 1024;
  EXPECT_EQ(create(reel.frames, 1, small), Status::unsupported);
  const MorphTarget target{};
  mesh.geometry.targets = {&target, 1};
  EXPECT_EQ(create(reel.frames, 1), Status::unsupported) << "morph targets";
  EXPECT_EQ(state_of(out).frames_texture, 0u);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

TEST(Crowd, CrowdsRefuseBadCalls) {
  const TestCharacter character = make_character(3, 10, 5, false);
  const Reel reel(character.skeleton.view(), {{character.clip.view(), true}}, 10);
  const Reel other(character.skeleton.view(), {{character.clip.view(), true}}, 20);
  gles3::Crowd crowd;
  std::vector<SoaTransform> memory;
  constexpr std::uint32_t kMost = 256 * 2048;
  const Span<std::byte> room = room_for(memory, (kMost + 1) * gles3::kCrowdInstanceBytes);
  EXPECT_EQ(gles3::create_crowd(gl(), {}, 0, room, crowd), Status::bad_argument);
  EXPECT_EQ(gles3::create_crowd(gl(), {}, 2, {room.data, 255}, crowd), Status::bad_argument);
  EXPECT_EQ(gles3::create_crowd(gl(), {}, 2, {room.data + 2, 256}, crowd), Status::bad_argument);
  EXPECT_EQ(gles3::create_crowd(gl(), {}, kMost + 1, room, crowd), Status::unsupported);
  EXPECT_EQ(crowd.texture, 0u);
  Troop troop(with_box(character.mesh), reel, 10);
  ASSERT_TRUE(troop.ok());
  std::vector<CrowdInstance> instances = some_of_each(reel.frames, 11, 0, 5);
  EXPECT_EQ(troop.set(0, {instances.data(), 0}), Status::bad_argument) << "empty";
  EXPECT_EQ(troop.set(1, {instances.data(), 1}), Status::bad_argument) << "a gap";
  EXPECT_EQ(troop.set(0, {instances.data(), 11}), Status::unsupported);
  instances[4].b.clip = 1;
  EXPECT_EQ(troop.set(0, {instances.data(), 10}), Status::bad_argument) << "no such clip";
  EXPECT_EQ(troop.crowd().count, 0u);
  EXPECT_EQ(troop.blend(0, 1, 0), Status::bad_argument) << "none is set";
  ASSERT_EQ(troop.set(0, {instances.data(), 4}), Status::ok);
  EXPECT_EQ(gles3::set_instances(gl(), troop.crowd(), other.frames, 4, {instances.data(), 1}), Status::bad_argument)
      << "other frames";
  EXPECT_EQ(troop.blend(0, 0, 0), Status::ok);
  EXPECT_EQ(troop.blend(0, 4, 0), Status::ok);
  EXPECT_EQ(troop.blend(1, 4, 0), Status::bad_argument);
  EXPECT_EQ(troop.blend(5, 0, 0), Status::bad_argument);
  EXPECT_EQ(troop.blend(0, 4, std::nan("")), Status::bad_argument);
  EXPECT_EQ(gles3::blend_crowd(gl(), troop.crowd(), troop.mesh(), 0, 4, 0, 0, {}), Status::bad_argument);
  EXPECT_EQ(gles3::blend_crowd(gl(), troop.crowd(), {}, 0, 4, 0, 0, crowd_program()), Status::bad_argument);
  gles3::CrowdMesh smaller = troop.mesh();
  smaller.capacity = 3;
  EXPECT_EQ(gles3::blend_crowd(gl(), troop.crowd(), smaller, 0, 4, 0, 0, crowd_program()), Status::unsupported);
  EXPECT_EQ(gles3::bind_crowd(gl(), troop.crowd(), troop.mesh(), 0, 4, 0, crowd_program()), Status::bad_argument)
      << "a program of another kind";
  gles3::PaletteTexture texture;
  texture.capacity = texture.count = 10;
  gles3::Program for_crowds = {.id = 1};
  gles3::ProgramState state = {.reads = gles3::Palettes::crowd};
  state.palettes = 0;
  set_state(for_crowds, state);
  EXPECT_EQ(gles3::bind_palette(gl(), texture, 0, 10, 0, for_crowds), Status::bad_argument);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
}

}  // namespace
}  // namespace marrow::test
