// Vertices in float that something has skinned already: a buffer for them, and how it is drawn.
#include "gles3/skinned.h"

#include "core/check.h"
#include "core/zone.h"
#include "gles3/errors.h"
#include "gles3/gl_size.h"
#include "gles3/label.h"
#include "gles3/mesh/attributes.h"

namespace marrow::gles3 {
namespace {

bool fits(Span<float> values, std::uint32_t bytes) {
  return values.empty() || (holds(values) && values.size * sizeof(float) == bytes);
}

void put(const Api& api, std::uint32_t offset, Span<float> values) {
  if (values.empty()) return;
  api.BufferSubData(kGlArrayBuffer, gl_size(offset), gl_size(values.size * sizeof(float)), values.data);
}

}  // namespace

SkinnedBlocks blocks_of(const SkinnedMesh& mesh) {
  SkinnedBlocks out;
  out.position_bytes = 12 * mesh.slot_count;
  out.normal_bytes = (mesh.features & kNormals) != 0 ? 12 * mesh.slot_count : 0;
  out.tangent_bytes = (mesh.features & kTangents) != 0 ? 16 * mesh.slot_count : 0;
  out.normals = out.position_bytes;
  out.tangents = out.normals + out.normal_bytes;
  out.bytes = out.tangents + out.tangent_bytes;
  return out;
}

Status create_skinned(const Api& api, const GpuMesh& mesh, SkinnedMesh& out) {
  return make_skinned(api, mesh, "marrow", out);
}

Status make_skinned(const Api& api, const GpuMesh& mesh, const char* name, SkinnedMesh& out) {
  SkinnedMesh made;
  made.slot_count = mesh.slot_count;
  made.features = mesh.features & (kNormals | kTangents | kUvs | kColours);
  const SkinnedBlocks blocks = blocks_of(made);
  forget_errors(api);
  api.GenVertexArrays(1, &made.array);
  api.BindVertexArray(made.array);
  api.BindBuffer(kGlElementArrayBuffer, mesh.index_buffer);
  api.GenBuffers(1, &made.buffer);
  api.BindBuffer(kGlArrayBuffer, made.buffer);
  api.BufferData(kGlArrayBuffer, gl_size(blocks.bytes), nullptr, kGlDynamicCopy);
  attribute(api, kPositionLocation, 3, kGlFloat, false, 12, 0);
  if (blocks.normal_bytes != 0) attribute(api, kNormalLocation, 3, kGlFloat, false, 12, blocks.normals);
  if (blocks.tangent_bytes != 0) attribute(api, kTangentLocation, 4, kGlFloat, false, 16, blocks.tangents);
  if (mesh.surface_buffer != 0) api.BindBuffer(kGlArrayBuffer, mesh.surface_buffer);
  describe_looks(api, mesh.layout, made.features);
  api.BindVertexArray(0);
  api.BindBuffer(kGlArrayBuffer, 0);
  if (api.GetError() != kGlNoError) {
    destroy(api, made);
    return Status::gl_error;
  }
  label(api, kGlVertexArray, made.array, {name, ": skinned vertices"});
  label(api, kGlBuffer, made.buffer, {name, ": skinned vertices"});
  out = made;
  return Status::ok;
}

void destroy(const Api& api, SkinnedMesh& mesh) {
  api.DeleteVertexArrays(1, &mesh.array);
  api.DeleteBuffers(1, &mesh.buffer);
  mesh = {};
}

Status set_previous(const Api& api, const SkinnedMesh& mesh, const SkinnedMesh& previous) {
  MARROW_REQUIRE(mesh.slot_count == previous.slot_count);
  api.BindVertexArray(mesh.array);
  api.BindBuffer(kGlArrayBuffer, previous.buffer);
  attribute(api, kPreviousLocation, 3, kGlFloat, false, 12, 0);
  api.BindVertexArray(0);
  api.BindBuffer(kGlArrayBuffer, 0);
  return Status::ok;
}

Status upload_skinned(const Api& api, SkinnedMesh& mesh, const SkinOutput& vertices) {
  MARROW_ZONE;
  const SkinnedBlocks blocks = blocks_of(mesh);
  MARROW_REQUIRE(!vertices.positions.empty() && fits(vertices.positions, blocks.position_bytes));
  MARROW_REQUIRE(fits(vertices.normals, blocks.normal_bytes));
  MARROW_REQUIRE(fits(vertices.tangents, blocks.tangent_bytes));
  api.BindBuffer(kGlArrayBuffer, mesh.buffer);
  api.BufferData(kGlArrayBuffer, gl_size(blocks.bytes), nullptr, kGlStreamDraw);
  put(api, 0, vertices.positions);
  put(api, blocks.normals, vertices.normals);
  put(api, blocks.tangents, vertices.tangents);
  api.BindBuffer(kGlArrayBuffer, 0);
  return Status::ok;
}

void draw(const Api& api, const GpuMesh& mesh, const SkinnedMesh& skinned) {
  MARROW_ZONE;
  api.BindVertexArray(skinned.array);
  api.DrawElements(mesh.primitive, static_cast<int>(mesh.index_count), mesh.index_type, nullptr);
  api.BindVertexArray(0);
}

}  // namespace marrow::gles3
