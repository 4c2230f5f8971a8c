// The GLES road on whatever processor this is built for, without the tools: a context, the self-test, a mesh read back.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "marrow/egl.h"
#include "marrow/gles3_self_test.h"
#include "marrow/marrow.h"
#include "support/rig.h"

namespace marrow::test {
namespace {

constexpr unsigned kFeedbackBuffer = 0x8C8E, kMapRead = 1;
constexpr unsigned kTexture2d = 0x0DE1, kRgba = 0x1908, kUnsignedByte = 0x1401;
constexpr int kRgba8 = 0x8058;
constexpr unsigned kFramebuffer = 0x8D40, kColour0 = 0x8CE0, kComplete = 0x8CD5;
constexpr double kMostPosition = 2e-4;  // of the mesh's size
constexpr double kMostNormal = 0.01;    // of unit vectors
constexpr double kLeastLength = 0.05;

class Smoke : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(context_.create(), Status::ok) << context_.error();
    ASSERT_EQ(gles3::load_api(api_, egl::load_proc), Status::ok);
    ASSERT_EQ(gles3::query_caps(api_, caps_), Status::ok);
    // A draw call wants a complete framebuffer even if nothing is rasterised.
    unsigned texture = 0, framebuffer = 0;
    api_.GenTextures(1, &texture);
    api_.BindTexture(kTexture2d, texture);
    api_.TexImage2D(kTexture2d, 0, kRgba8, 1, 1, 0, kRgba, kUnsignedByte, nullptr);
    api_.BindTexture(kTexture2d, 0);
    api_.GenFramebuffers(1, &framebuffer);
    api_.BindFramebuffer(kFramebuffer, framebuffer);
    api_.FramebufferTexture2D(kFramebuffer, kColour0, kTexture2d, texture, 0);
    ASSERT_EQ(api_.CheckFramebufferStatus(kFramebuffer), kComplete);
    std::printf("%s, %s, %s\n", reinterpret_cast<const char*>(api_.GetString(0x1F01)),
                reinterpret_cast<const char*>(api_.GetString(0x1F02)), caps_.compute ? "compute" : "no compute");
  }
  Span<std::byte> room(std::size_t bytes) {
    memory_.resize(bytes / sizeof(SoaTransform) + 1);
    return {reinterpret_cast<std::byte*>(memory_.data()), bytes};
  }

  egl::HeadlessContext context_;
  gles3::Api api_;
  gles3::Caps caps_;
  std::vector<SoaTransform> memory_;
};

TEST_F(Smoke, EveryPathIsUsable) {
  const gles3::SelfTestOptions options;
  gles3::SelfTest test;
  ASSERT_EQ(gles3::self_test(api_, caps_, options, room(gles3::self_test_bytes(options)), test), Status::ok);
  for (std::uint32_t i = 0; i < gles3::kPathCount; ++i) {
    const auto path = static_cast<gles3::SkinningPath>(i);
    const bool can = path != gles3::SkinningPath::compute || caps_.compute;
    const gles3::PathResult& result = test.paths[i];
    std::printf("%-8s position %.5f normal %.5f\n", to_string(path), static_cast<double>(result.position_error),
                static_cast<double>(result.normal_error));
    EXPECT_EQ(result.verdict, can ? gles3::Verdict::usable : gles3::Verdict::unsupported) << to_string(path);
  }
  EXPECT_EQ(api_.GetError(), 0u);
}

std::vector<float> contents(unsigned buffer, std::size_t floats, const gles3::Api& api) {
  const auto map = reinterpret_cast<void* (*)(unsigned, std::ptrdiff_t, std::ptrdiff_t, unsigned)>(
      egl::load_proc("glMapBufferRange"));
  const auto unmap = reinterpret_cast<unsigned char (*)(unsigned)>(egl::load_proc("glUnmapBuffer"));
  api.BindBuffer(kFeedbackBuffer, buffer);
  const auto* const got =
      static_cast<const float*>(map(kFeedbackBuffer, 0, static_cast<std::ptrdiff_t>(floats * sizeof(float)), kMapRead));
  std::vector<float> out(floats, NAN);
  if (got != nullptr) std::copy_n(got, floats, out.begin());
  unmap(kFeedbackBuffer);
  api.BindBuffer(kFeedbackBuffer, 0);
  return out;
}

// Slots whose position or, where it has a length, normal is off.
std::size_t wrong_slots(const std::vector<float>& got, const std::vector<float>& positions,
                        const std::vector<float>& normals, double size) {
  std::size_t out = 0;
  for (std::size_t slot = 0; slot < positions.size() / 3; ++slot) {
    double position = 0, normal = 0, length = 0;
    for (std::size_t c = 3 * slot; c < 3 * slot + 3; ++c) {
      position = std::max(position, std::fabs(static_cast<double>(got[c] - positions[c])));
      normal = std::max(normal, std::fabs(static_cast<double>(got[positions.size() + c] - normals[c])));
      length += static_cast<double>(normals[c]) * static_cast<double>(normals[c]);
    }
    const bool good = position <= kMostPosition * size && (length < kLeastLength || normal <= kMostNormal);
    out += !good;
  }
  return out;
}

TEST_F(Smoke, AMeshReadBackIsTheCpus) {
  const TestCharacter character = make_character(41, 20, 13, true);
  const Skeleton skeleton = character.skeleton.view();
  const Clip clip = character.clip.view();
  const Mesh mesh = with_box(character.mesh);
  const std::size_t slots = mesh.geometry.slot_count;
  std::vector<SoaTransform> local(skeleton.soa_size());
  std::vector<Affine> scene(skeleton.joint_count), palette(mesh.palette_size());
  ASSERT_EQ(sample(skeleton, clip, 0.4f * clip.duration_s, local), Status::ok);
  ASSERT_EQ(local_to_model(skeleton, local, scene), Status::ok);
  ASSERT_EQ(build_palette(mesh, scene, palette), Status::ok);
  std::vector<float> positions(3 * slots), normals(3 * slots);
  ASSERT_EQ(skin_ssd(mesh, palette, {positions, normals, {}}), Status::ok);
  const auto [low, high] = std::minmax_element(positions.begin(), positions.end());
  ASSERT_GT(slots, 100u);

  gles3::ProgramSet programs;
  programs.roles[0] = {"void main() { gl_Position = vec4(marrow_skin().position, 1.0); }",
                       "precision highp float; out vec4 colour; void main() { colour = vec4(1.0); }",
                       {}};
  int paths = 0;
  for (const gles3::SkinningPath path :
       {gles3::SkinningPath::feedback, gles3::SkinningPath::compute, gles3::SkinningPath::cpu}) {
    if (path == gles3::SkinningPath::compute && !caps_.compute) continue;
    gles3::SkinnerOptions options;
    options.path = path;
    gles3::Skinner skinner;
    ASSERT_EQ(
        gles3::create_skinner(api_, caps_, mesh, options, programs, room(gles3::skinner_bytes(mesh, options)), skinner),
        Status::ok)
        << to_string(path);
    EXPECT_EQ(gles3::pose(skinner, 0, scene), Status::ok);
    EXPECT_EQ(gles3::update(api_, skinner, programs, 1), Status::ok);
    EXPECT_EQ(api_.GetError(), 0u) << to_string(path);
    const std::vector<float> got = contents(skinner.skinned[0].buffer, 6 * slots, api_);
    EXPECT_LE(wrong_slots(got, positions, normals, static_cast<double>(*high - *low)), slots / 50) << to_string(path);
    std::printf("%-8s %zu slots\n", to_string(path), slots);
    gles3::destroy(api_, skinner);
    ++paths;
  }
  gles3::destroy(api_, programs);
  EXPECT_GE(paths, 2);
  EXPECT_EQ(api_.GetError(), 0u);
}

}  // namespace
}  // namespace marrow::test
