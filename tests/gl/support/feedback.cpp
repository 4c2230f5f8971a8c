#include "gl/support/feedback.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "common/failure.h"
#include "gles3/compile.h"
#include "gles3/mesh/morph.h"
#include "gles3/mesh/pose_examples.h"
#include "gles3/mesh/prepare.h"
#include "gles3/palettes.h"
#include "gles3/program.h"
#include "gles3/skinned.h"
#include "marrow/egl.h"
#include "marrow/palette.h"

namespace marrow::test {
namespace {

constexpr const char* kVertex = R"(
out vec3 out_position;
out vec3 out_normal;
out vec4 out_tangent;
void main() {
  MarrowVertex v = marrow_skin();
  out_position = v.position;
  out_normal = v.normal;
  out_tangent = v.tangent;
  gl_Position = vec4(v.position, 1.0);
  gl_PointSize = 1.0;
}
)";
constexpr const char* kFragment = R"(
precision highp float;
out vec4 colour;
void main() { colour = vec4(1.0); }
)";

// Functions that only read-back needs.
struct More {
  void* (*MapBufferRange)(GLenum, std::ptrdiff_t, std::ptrdiff_t, GLbitfield) = nullptr;
  GLboolean (*UnmapBuffer)(GLenum) = nullptr;
};

const More& more() {
  static const More functions = [] {
    More m;
    m.MapBufferRange = reinterpret_cast<void* (*)(GLenum, std::ptrdiff_t, std::ptrdiff_t, GLbitfield)>(
        egl::load_proc("glMapBufferRange"));
    m.UnmapBuffer = reinterpret_cast<GLboolean (*)(GLenum)>(egl::load_proc("glUnmapBuffer"));
    return m;
  }();
  return functions;
}

// One program a key and way for the whole binary: compiling is most of the time on a software driver.
const gles3::Program& program(const gles3::ProgramKey& key, Way way) {
  static std::map<std::tuple<gles3::Deformer, int, int, Way>, gles3::Program> programs;
  const auto [at, added] = programs.try_emplace({key.deformer, key.influences, key.features, way});
  if (!added) return at->second;
  std::vector<char> log(4096);
  if (way == Way::feedback || way == Way::compute) {
    const gles3::Preskin method = way == Way::compute ? gles3::Preskin::compute : gles3::Preskin::feedback;
    EXPECT_EQ(gles3::create_preskin(gl(), gl().caps(), key, method, 0, at->second, log), Status::ok) << log.data();
    return at->second;
  }
  EXPECT_EQ(gles3::create_program(gl(), key, feedback_source(), 0, at->second, log), Status::ok) << log.data();
  return at->second;
}

const tools::Gl* make_gl() {
  try {
    auto* const made = new tools::Gl;
    tools::watch_all_errors(*made, nullptr);  // tests cause some, and watch for themselves
    const auto is_another = [&](const char* name) {
      return name != nullptr && made->driver().find(name) == std::string::npos;
    };
    const char* const expected = std::getenv("MARROW_EXPECT_DRIVER");
    if (is_another(expected)) {
      std::fprintf(stderr, "expected %s, got %s\n", expected, made->driver().c_str());
      std::exit(1);
    }
    const char* const only_on = std::getenv("MARROW_ONLY_ON");
    if (is_another(only_on)) {
      std::fprintf(stderr, "SKIPPED: this is for %s, the driver is %s\n", only_on, made->driver().c_str());
      std::exit(77);
    }
    std::printf("driver: %s\n", made->driver().c_str());
    return made;
  } catch (const tools::Failure& failure) {
    std::fprintf(stderr, "no OpenGL ES to test: %s\n", failure.what());
    std::exit(1);
  }
}

}  // namespace

gles3::ProgramSource feedback_source() {
  static const char* const varyings[] = {"out_position", "out_normal", "out_tangent"};
  return {kVertex, kFragment, Span<const char* const>(varyings, 3)};
}

std::vector<float> read_feedback(GLuint buffer, std::size_t floats) {
  gl().BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
  const auto bytes = static_cast<std::ptrdiff_t>(floats * sizeof(float));
  const auto* const mapped =
      static_cast<const float*>(more().MapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT));
  EXPECT_NE(mapped, nullptr);
  std::vector<float> out(floats);
  if (mapped != nullptr) out.assign(mapped, mapped + floats);
  more().UnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  gl().BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
  return out;
}

const char* name_of(Way way) {
  switch (way) {
    case Way::block:
      return "uniform block";
    case Way::texture:
      return "texture";
    case Way::feedback:
      return "feedback";
    case Way::compute:
      return "compute";
  }
  return "";
}

bool can(Way way) {
  return way != Way::compute || gl().caps().compute;
}

const tools::Gl& gl() {
  // Lives as long as the process: programs and static objects still hold names in it.
  static const tools::Gl* const context = make_gl();
  return *context;
}

Feedback::Feedback(const Mesh& mesh, Span<const float> tangents) : mesh_(mesh), bind_(mesh.joint_count) {
  gles3::PrepareOptions options;
  options.as_tangents = tangents;
  options.psd = true;
  std::vector<std::byte> scratch(gles3::prepare_scratch_bytes(mesh, options));
  // The least that GLES 3.0 promises, whatever this driver can do.
  gles3::Caps caps;
  caps.uniform_offset_alignment = std::max(caps.uniform_offset_alignment, gl().caps().uniform_offset_alignment);
  prepared_ = gles3::prepare(gl(), caps, mesh, options, scratch, bind_, gpu_);
  if (!ok()) return;
  EXPECT_EQ(gles3::create_palette_ring(gl(), caps, 2 * mesh.palette_size(), 2, ring_), Status::ok);
  EXPECT_EQ(gles3::create_palette_texture(gl(), caps, mesh.palette_size() + 3, texture_), Status::ok);
  if (gpu_.distances != 0) {
    EXPECT_EQ(gles3::create_palette_texture(gl(), caps, gpu_.distances + 3, distances_), Status::ok);
  }
  EXPECT_EQ(gles3::create_skinned(gl(), gpu_, skinned_), Status::ok);
  // A draw call wants a complete framebuffer even if nothing is rasterised.
  colour_ = tools::GlRenderbuffer(gl());
  target_ = tools::GlFramebuffer(gl());
  gl().BindRenderbuffer(GL_RENDERBUFFER, colour_);
  gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, 1, 1);
  gl().BindFramebuffer(GL_FRAMEBUFFER, target_);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
  capture_ = tools::GlBuffer(gl());
  gl().BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, capture_);
  const std::size_t bytes = kFeedbackFloats * sizeof(float) * mesh.geometry.slot_count;
  gl().BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<std::ptrdiff_t>(bytes), nullptr, GL_STREAM_READ);
}

Feedback::~Feedback() {
  gles3::destroy(gl(), gpu_);
  gles3::destroy(gl(), ring_);
  gles3::destroy(gl(), texture_);
  gles3::destroy(gl(), distances_);
  gles3::destroy(gl(), skinned_);
}

// Behind other matrices, so that its offset is not zero.
void Feedback::bind(const gles3::Program& with, Span<const Affine> palette, Way way) {
  if (way == Way::texture) {
    two_palettes_.assign(3, palette[0]);
    two_palettes_.insert(two_palettes_.end(), palette.begin(), palette.end());
    EXPECT_EQ(gles3::upload_palettes(gl(), texture_, two_palettes_), Status::ok);
    EXPECT_EQ(gles3::bind_palette(gl(), texture_, 3, mesh_.palette_size(), 3, with), Status::ok);
    return;
  }
  std::uint32_t other = 0, offset = 0;
  gles3::begin_frame(gl(), ring_);
  EXPECT_EQ(gles3::push_palette(gl(), ring_, Span<const Affine>(palette.data, 1), other), Status::ok);
  EXPECT_EQ(gles3::push_palette(gl(), ring_, palette, offset), Status::ok);
  EXPECT_GT(offset, 0u);
  gles3::bind_palette(gl(), ring_, offset, 0);
}

void Feedback::capture(gles3::Deformer deformer) {
  gl().Enable(GL_RASTERIZER_DISCARD);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, capture_);
  gl().BindVertexArray(deformer == gles3::Deformer::as ? gpu_.as_array : gpu_.ssd_array);
  gl().BeginTransformFeedback(GL_POINTS);
  gl().DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(mesh_.geometry.slot_count));
  gl().EndTransformFeedback();
  gl().BindVertexArray(0);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl().Disable(GL_RASTERIZER_DISCARD);
}

Skinned Feedback::skin(gles3::Deformer deformer, Span<const Affine> model_from_joint, Span<const float> weights,
                       Way way) {
  const std::size_t slots = mesh_.geometry.slot_count;
  std::vector<Affine> palette(mesh_.palette_size());
  EXPECT_EQ(build_palette({mesh_.joints, mesh_.joint_count}, bind_, model_from_joint, palette, mesh_.helpers,
                          mesh_.helper_centres),
            Status::ok);
  gles3::ProgramKey key{deformer, gpu_.influences, gpu_.features};
  if (way == Way::texture) key.palettes = gles3::Palettes::texture;
  const gles3::Program& with = program(key, way);
  gl().UseProgram(with.id);
  // What goes up leaves its texture unit without a texture, so before any is bound.
  if (deformer == gles3::Deformer::psd) {
    std::vector<Affine> distances(3 + gpu_.distances);
    EXPECT_EQ(gles3::pack_distances(mesh_.geometry, palette, {distances.data() + 3, gpu_.distances}), Status::ok);
    EXPECT_EQ(gles3::upload_palettes(gl(), distances_, distances), Status::ok);
  }
  bind(with, palette, way);
  gles3::tell_of_vertices(gl(), gpu_, with);
  if (!mesh_.geometry.targets.empty()) {
    EXPECT_EQ(gles3::set_morphs(gl(), mesh_, gpu_, weights, 2, with), Status::ok);
  }
  if (deformer == gles3::Deformer::psd) {
    EXPECT_EQ(gles3::bind_examples(gl(), gpu_, distances_, 3, 4, with), Status::ok);
  }
  gl().BindFramebuffer(GL_FRAMEBUFFER, target_);

  Skinned out;
  if (way == Way::feedback || way == Way::compute) {
    EXPECT_EQ(gles3::preskin(gl(), gpu_, deformer, with, skinned_), Status::ok);
    const bool normals = (gpu_.features & gles3::kNormals) != 0, tangents = (gpu_.features & gles3::kTangents) != 0;
    const std::vector<float> got =
        read_feedback(skinned_.buffer, slots * (3u + (normals ? 3u : 0u) + (tangents ? 4u : 0u)));
    const auto at = [&](std::size_t n) { return got.begin() + static_cast<std::ptrdiff_t>(n * slots); };
    out.positions.assign(at(0), at(3));
    out.normals.assign(3 * slots, 0);
    out.tangents.assign(4 * slots, 0);
    if (normals) out.normals.assign(at(3), at(6));
    if (tangents) out.tangents.assign(at(normals ? 6 : 3), at(normals ? 10 : 7));
  } else {
    capture(deformer);
    const std::vector<float> got = read_feedback(capture_, kFeedbackFloats * slots);
    for (std::size_t slot = 0; slot < slots; ++slot) out.add(got.data() + kFeedbackFloats * slot);
  }
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
  return out;
}

}  // namespace marrow::test
