// Every frame: a mesh's vertices through a palette into a buffer, by transform feedback or by compute shader.
#include "core/check.h"
#include "core/zone.h"
#include "gles3/compile.h"
#include "gles3/gl_size.h"
#include "gles3/program.h"
#include "gles3/skinned.h"

namespace marrow::embedded {
extern const unsigned char shader_preskin_vert[], shader_preskin_comp[], shader_nothing_frag[];
}

namespace marrow::gles3 {
namespace {

constexpr std::uint32_t kGroup = 64;  // invocations; as the text has it

const char* text(const unsigned char* embedded) {
  return reinterpret_cast<const char*>(embedded);
}

void by_feedback(const Api& api, std::uint32_t array, const SkinnedMesh& to) {
  const SkinnedBlocks blocks = blocks_of(to);
  std::uint32_t count = 0;
  const auto capture = [&](std::uint32_t offset, std::uint32_t bytes) {
    if (bytes == 0) return;
    api.BindBufferRange(kGlTransformFeedbackBuffer, count++, to.buffer, gl_size(offset), gl_size(bytes));
  };
  capture(0, blocks.position_bytes);
  capture(blocks.normals, blocks.normal_bytes);
  capture(blocks.tangents, blocks.tangent_bytes);
  api.BindVertexArray(array);
  api.Enable(kGlRasterizerDiscard);
  api.BeginTransformFeedback(kGlPoints);
  api.DrawArrays(kGlPoints, 0, static_cast<int>(to.slot_count));
  api.EndTransformFeedback();
  api.Disable(kGlRasterizerDiscard);
  api.BindVertexArray(0);
  for (std::uint32_t i = 0; i < count; ++i) api.BindBufferBase(kGlTransformFeedbackBuffer, i, 0);
}

void by_compute(const Api& api, const GpuMesh& mesh, bool as, const Program& program, const SkinnedMesh& to) {
  const VertexLayout& layout = mesh.layout;
  const std::uint32_t bytes[] = {as ? layout.as_stride : layout.ssd_stride, layout.ssd_weights, layout.as_tangents,
                                 as ? layout.as_joints : layout.ssd_joints};
  const std::uint32_t surface[] = {layout.surface_stride, layout.normal, layout.tangent};
  int values[10] = {static_cast<int>(mesh.slot_count)};
  for (std::size_t i = 0; i < 4; ++i) values[1 + i] = static_cast<int>(bytes[i] / 4);
  values[5] = static_cast<int>(layout.joint_bytes);
  for (std::size_t i = 0; i < 3; ++i) values[6 + i] = static_cast<int>(surface[i] / 4);
  values[9] = static_cast<int>(layout.example_row / 4);
  api.Uniform1iv(state_of(program).vertex_layout, 10, values);
  // A block that the program has must be bound to something, whatever it reads.
  const std::uint32_t skin = as ? mesh.as_buffer : mesh.ssd_buffer;
  const std::uint32_t buffers[] = {skin, mesh.surface_buffer != 0 ? mesh.surface_buffer : skin,
                                   mesh.morph_buffer != 0 ? mesh.morph_buffer : skin, to.buffer};
  for (std::uint32_t i = 0; i < 4; ++i) api.BindBufferBase(kGlShaderStorageBuffer, i, buffers[i]);
  api.DispatchCompute((mesh.slot_count + kGroup - 1) / kGroup, 1, 1);
  api.MemoryBarrier(kGlVertexAttribArrayBarrier);
  for (std::uint32_t i = 0; i < 4; ++i) api.BindBufferBase(kGlShaderStorageBuffer, i, 0);
}

}  // namespace

Status create_preskin(const Api& api, const Caps& caps, const ProgramKey& key, Preskin method,
                      std::uint32_t palette_binding, Program& out, Span<char> log) {
  MARROW_REQUIRE(holds(log));
  clear(log);
  MARROW_REQUIRE(key.palettes < Palettes::crowd);
  MARROW_REQUIRE(skins(key.deformer));
  MARROW_REQUIRE(method <= Preskin::compute);
  MARROW_REQUIRE(key.influences >= 4 && key.influences <= kMaxInfluences);
  ProgramKey of = key;
  of.features = key.features & (kNormals | kTangents | kMorphs | kSurfaceNormals);
  if (method == Preskin::compute) {
    if (!caps.compute) return Status::unsupported;
    ShaderTexts texts{nullptr, nullptr, text(embedded::shader_preskin_comp), {}};
    texts.role = "pre-skinning by compute shader";
    return compile_program(api, of, texts, palette_binding, out, log);
  }
  const char* varyings[3] = {"out_position"};
  std::size_t count = 1;
  if ((of.features & kNormals) != 0) varyings[count++] = "out_normal";
  if ((of.features & kTangents) != 0) varyings[count++] = "out_tangent";
  const ShaderTexts texts{text(embedded::shader_preskin_vert),
                          text(embedded::shader_nothing_frag),
                          nullptr,
                          {varyings, count},
                          kGlSeparateAttribs,
                          "pre-skinning by feedback"};
  return compile_program(api, of, texts, palette_binding, out, log);
}

Status preskin(const Api& api, const GpuMesh& mesh, Deformer deformer, const Program& program, const SkinnedMesh& to) {
  MARROW_ZONE;
  const bool as = deformer == Deformer::as;
  const std::uint32_t array = as ? mesh.as_array : mesh.ssd_array;
  MARROW_REQUIRE(skins(deformer) && array != 0 && "prepared for this deformer");
  MARROW_REQUIRE((deformer != Deformer::psd || mesh.example_texture != 0) && "prepared for this deformer");
  MARROW_REQUIRE(to.slot_count == mesh.slot_count);
  tell_of_vertices(api, mesh, program);
  if (state_of(program).vertex_layout >= 0) {
    by_compute(api, mesh, as, program, to);
  } else {
    by_feedback(api, array, to);
  }
  return Status::ok;
}

}  // namespace marrow::gles3
