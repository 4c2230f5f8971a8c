#include "gl/support/troop.h"

#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include "gles3/compile.h"
#include "gles3/crowd/crowd.h"
#include "gles3/mesh/prepare.h"
#include "gles3/program.h"
#include "marrow/egl.h"

namespace marrow::test {
namespace {

const gles3::Program& drawing_program(const gles3::ProgramKey& key) {
  static std::map<std::tuple<gles3::Deformer, int, int>, gles3::Program> programs;
  const auto [at, added] = programs.try_emplace({key.deformer, key.influences, key.features});
  std::vector<char> log(4096);
  if (!added) return at->second;
  EXPECT_EQ(gles3::create_program(gl(), key, feedback_source(), 0, at->second, log), Status::ok) << log.data();
  return at->second;
}

}  // namespace

const gles3::Program& crowd_program() {
  static const gles3::Program program = [] {
    gles3::Program made;
    std::vector<char> log(4096);
    EXPECT_EQ(gles3::create_crowd_program(gl(), made, log), Status::ok) << log.data();
    return made;
  }();
  return program;
}

Reel::Reel(const Skeleton& of, std::vector<gles3::CrowdSource> what, float rate_hz)
    : skeleton(of), sources(std::move(what)), clips(sources.size()) {
  std::uint32_t count = 0;
  EXPECT_EQ(gles3::plan_crowd(sources, rate_hz, clips, count), Status::ok);
  matrices.resize(std::size_t{count} * skeleton.joint_count);
  std::vector<SoaTransform> scratch(skeleton.soa_size());
  EXPECT_EQ(gles3::bake_crowd(skeleton, sources, clips, scratch, matrices, frames), Status::ok);
}

Troop::Troop(const Mesh& mesh, const Reel& reel, std::uint32_t capacity, Span<const float> tangents) : reel_(reel) {
  gles3::CrowdMeshOptions options;
  options.as_tangents = tangents;
  const gles3::Caps caps;  // the least that GLES 3.0 promises
  ok_ = gles3::create_crowd_mesh(gl(), caps, mesh, options, reel.frames, capacity,
                                 room_for(mesh_memory_, gles3::crowd_mesh_bytes(mesh, options)),
                                 crowd_mesh_) == Status::ok &&
        gles3::create_crowd(gl(), caps, capacity, room_for(crowd_memory_, capacity * gles3::kCrowdInstanceBytes),
                            crowd_) == Status::ok;
  EXPECT_TRUE(ok_);
  // A draw call wants a complete framebuffer even if nothing is rasterised.
  colour_ = tools::GlRenderbuffer(gl());
  target_ = tools::GlFramebuffer(gl());
  gl().BindRenderbuffer(GL_RENDERBUFFER, colour_);
  gl().RenderbufferStorageMultisample(GL_RENDERBUFFER, 0, GL_RGBA8, 1, 1);
  gl().BindFramebuffer(GL_FRAMEBUFFER, target_);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
}

Troop::~Troop() {
  gles3::destroy(gl(), crowd_mesh_);
  gles3::destroy(gl(), crowd_);
}

Status Troop::set(std::uint32_t first, Span<const gles3::CrowdInstance> instances) {
  return gles3::set_instances(gl(), crowd_, reel_.frames, first, instances);
}

Status Troop::blend(std::uint32_t first, std::uint32_t count, double time_s, const gles3::Api& api) {
  gl().UseProgram(crowd_program().id);
  return gles3::blend_crowd(api, crowd_, crowd_mesh_, first, count, time_s, 3, crowd_program());
}

std::vector<Skinned> Troop::capture(gles3::Deformer deformer, std::uint32_t first, std::uint32_t count,
                                    std::uint32_t vertices) {
  static const auto draw_instanced =
      reinterpret_cast<void (*)(GLenum, GLint, GLsizei, GLsizei)>(egl::load_proc("glDrawArraysInstanced"));
  if (vertices == 0) vertices = gpu().slot_count;
  gles3::ProgramKey key{deformer, gpu().influences, gpu().features, gles3::Palettes::crowd};
  const gles3::Program& with = drawing_program(key);
  gl().UseProgram(with.id);
  EXPECT_EQ(gles3::bind_crowd(gl(), crowd_, crowd_mesh_, first, count, 1, with), Status::ok);
  gles3::tell_of_vertices(gl(), gpu(), with);

  const tools::GlBuffer buffer(gl());
  const std::size_t floats = kFeedbackFloats * vertices * count;
  gl().BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
  gl().BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, static_cast<std::ptrdiff_t>(floats * sizeof(float)), nullptr,
                  GL_STREAM_READ);
  gl().BindFramebuffer(GL_FRAMEBUFFER, target_);
  gl().Enable(GL_RASTERIZER_DISCARD);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  gl().BindVertexArray(deformer == gles3::Deformer::as ? gpu().as_array : gpu().ssd_array);
  gl().BeginTransformFeedback(GL_POINTS);
  draw_instanced(GL_POINTS, 0, static_cast<GLsizei>(vertices), static_cast<GLsizei>(count));
  gl().EndTransformFeedback();
  gl().BindVertexArray(0);
  gl().BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  gl().Disable(GL_RASTERIZER_DISCARD);

  const std::vector<float> got = read_feedback(buffer, floats);
  std::vector<Skinned> out(count);
  for (std::size_t i = 0; i < std::size_t{vertices} * count; ++i)
    out[i / vertices].add(got.data() + kFeedbackFloats * i);
  EXPECT_EQ(gl().GetError(), static_cast<unsigned>(GL_NO_ERROR));
  return out;
}

}  // namespace marrow::test
