// Once a mesh: compact attributes into vertex buffers, and the bind matrices that undo their quantisation.
#include "gles3/mesh/prepare.h"
#include "core/check.h"
#include "core/zone.h"
#include "gles3/compile.h"
#include "gles3/errors.h"
#include "gles3/gl_constants.h"
#include "gles3/gl_size.h"
#include "gles3/label.h"
#include "gles3/mesh/attributes.h"
#include "gles3/mesh/encode.h"
#include "gles3/mesh/morph.h"
#include "gles3/mesh/pose_examples.h"
#include "marrow/gles3.h"
#include "marrow/skin.h"
#include "math/finite.h"

namespace marrow::gles3 {
namespace {

std::size_t larger(std::size_t a, std::size_t b) {
  return a > b ? a : b;
}

const void* at(std::uint32_t offset) {
  return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset));
}

std::uint32_t upload(const Api& api, GlEnum target, const void* data, std::size_t bytes) {
  std::uint32_t buffer = 0;
  api.GenBuffers(1, &buffer);
  api.BindBuffer(target, buffer);
  api.BufferData(target, gl_size(bytes), data, kGlStaticDraw);
  return buffer;
}

void describe_joints(const Api& api, const VertexLayout& layout, std::uint32_t stride, std::uint32_t offset) {
  if (reads_joint_pairs(api, layout.influences)) {
    api.EnableVertexAttribArray(kJointsLocation);
    api.VertexAttribIPointer(kJointsLocation, 4, layout.joint_bytes == 1 ? kGlUnsignedShort : kGlUnsignedInt,
                             static_cast<int>(stride), at(offset));
    return;
  }
  for (std::uint32_t i = 0; i < joint_places(layout) / 4; ++i) {
    api.EnableVertexAttribArray(kJointsLocation + i);
    api.VertexAttribIPointer(kJointsLocation + i, 4, layout.joint_bytes == 1 ? kGlUnsignedByte : kGlUnsignedShort,
                             static_cast<int>(stride), at(offset + 4 * i * layout.joint_bytes));
  }
}

// Describes the words from `begin` to the joints, sixteen bytes per attribute, and all others that skin.glsl declares:
// of these nothing is used, but WebGL draws nothing where an integer is declared and no array is there.
void describe_words(const Api& api, const VertexLayout& layout, std::uint32_t begin, const std::uint32_t* location,
                    std::uint32_t declared) {
  for (std::uint32_t i = 0; i < declared; ++i) {
    const std::uint32_t offset = begin + 16 * i < layout.as_joints ? begin + 16 * i : begin;
    api.EnableVertexAttribArray(location[i]);
    api.VertexAttribIPointer(location[i], layout.as_joints - offset < 16 ? 2 : 4, kGlUnsignedInt,
                             static_cast<int>(layout.as_stride), at(offset));
  }
}

void describe_coordinates(const Api& api, const VertexLayout& layout, Words words) {
  if (words == Words::all || words == Words::all_whole)
    return describe_words(api, layout, 0, kWordLocations, layout.surface_normals ? 12 : 4);
  for (std::uint32_t i = 0; i < layout.influences; ++i)
    attribute(api, kPositionLocation + i, 4, kGlShort, true, layout.as_stride, 8 * i);
  if (words == Words::tangents_whole) return describe_words(api, layout, layout.as_tangents, kWordLocations + 6, 6);
  for (std::uint32_t i = 0; layout.surface_normals && i < 8; ++i)
    attribute(api, kSurfaceLocations[i], 4, kGlShort, true, layout.as_stride, layout.as_tangents + 8 * i);
}

// directions: normals and tangents too.
void describe_surface(const Api& api, const Geometry& g, const VertexLayout& layout, bool directions,
                      const GpuMesh& mesh) {
  if (mesh.morph_buffer != 0) {
    api.BindBuffer(kGlArrayBuffer, mesh.morph_buffer);
    api.EnableVertexAttribArray(kMorphRowLocation);
    api.VertexAttribIPointer(kMorphRowLocation, 1, kGlUnsignedInt, 4, nullptr);
  }
  if (layout.surface_stride == 0) return;
  api.BindBuffer(kGlArrayBuffer, mesh.surface_buffer);
  const std::uint32_t stride = layout.surface_stride;
  if (directions && g.normals != nullptr) attribute(api, kNormalLocation, 2, kGlShort, true, stride, layout.normal);
  if (directions && g.tangents != nullptr) attribute(api, kTangentLocation, 2, kGlShort, true, stride, layout.tangent);
  describe_looks(api, layout, mesh.features);
}

std::uint32_t begin_array(const Api& api, const GpuMesh& mesh) {
  std::uint32_t array = 0;
  api.GenVertexArrays(1, &array);
  api.BindVertexArray(array);
  api.BindBuffer(kGlElementArrayBuffer, mesh.index_buffer);
  return array;
}

Status make_ssd(const Api& api, const Geometry& g, const VertexLayout& layout, const Quantisation& q,
                Span<std::byte> scratch, GpuMesh& mesh) {
  const std::size_t bytes = std::size_t{layout.ssd_stride} * g.slot_count;
  encode_ssd(g, layout, q, scratch.data);
  if (layout.example_row != 0) {
    const Status status =
        make_examples(api, g, q.half_extent, scratch.data, {scratch.data + bytes, scratch.size - bytes}, mesh);
    if (status != Status::ok) return status;
  }
  mesh.ssd_array = begin_array(api, mesh);
  mesh.ssd_buffer = upload(api, kGlArrayBuffer, scratch.data, bytes);
  attribute(api, kPositionLocation, 4, kGlShort, true, layout.ssd_stride, 0);
  attribute(api, kWeightsLocation, layout.influences > 4 ? 4 : 2, kGlUnsignedShort, true, layout.ssd_stride,
            layout.ssd_weights);
  if (layout.influences > 6)
    attribute(api, kWeightsLocation + 1, 2, kGlUnsignedShort, true, layout.ssd_stride, layout.ssd_weights + 8);
  describe_joints(api, layout, layout.ssd_stride, layout.ssd_joints);
  if (layout.example_row != 0) {
    api.EnableVertexAttribArray(kExampleRowLocation);
    api.VertexAttribIPointer(kExampleRowLocation, 1, kGlUnsignedInt, static_cast<int>(layout.ssd_stride),
                             at(layout.example_row));
  }
  describe_surface(api, g, layout, true, mesh);
  return Status::ok;
}

void make_as(const Api& api, const Geometry& g, const VertexLayout& layout, const Quantisation& q,
             Span<std::byte> scratch, const float* tangents, GpuMesh& mesh) {
  const Words words = words_read(api, layout.influences, layout.surface_normals);
  encode_as(g, layout, q, tangents, words == Words::all_whole, scratch.data);
  mesh.as_array = begin_array(api, mesh);
  mesh.as_buffer = upload(api, kGlArrayBuffer, scratch.data, std::size_t{layout.as_stride} * g.slot_count);
  describe_coordinates(api, layout, words);
  describe_joints(api, layout, layout.as_stride, layout.as_joints);
  describe_surface(api, g, layout, !layout.surface_normals, mesh);
}

// bind · [h·I | c]
Affine dequantising_bind(const Affine& bind, const Quantisation& q) {
  Affine out;
  for (int r = 0; r < 3; ++r) {
    const float* row = bind.rows[r];
    for (int c = 0; c < 3; ++c) out.rows[r][c] = row[c] * q.half_extent;
    out.rows[r][3] = row[0] * q.centre[0] + row[1] * q.centre[1] + row[2] * q.centre[2] + row[3];
  }
  return out;
}

GpuMesh describe(const Mesh& mesh, const VertexLayout& layout, const Quantisation& q, const PrepareOptions& options) {
  const Geometry& g = mesh.geometry;
  const bool on_gpu = options.ssd || options.as;
  GpuMesh out;
  out.index_count = g.index_count;
  out.index_type = g.index_bytes == 2 ? kGlUnsignedShort : kGlUnsignedInt;
  out.slot_count = g.slot_count;
  out.joint_count = mesh.palette_size();
  out.vertex_bytes = g.slot_count * ((options.ssd ? layout.ssd_stride : 0) + (options.as ? layout.as_stride : 0) +
                                     layout.surface_stride);
  out.influences = static_cast<std::uint8_t>(layout.influences);
  out.features = static_cast<std::uint8_t>(
      (g.normals != nullptr ? kNormals : 0) | (g.tangents != nullptr ? kTangents : 0) | (g.uvs != nullptr ? kUvs : 0) |
      (g.colours != nullptr ? kColours : 0) | (g.targets.empty() || !on_gpu ? 0 : kMorphs) |
      (options.as && layout.surface_normals ? kSurfaceNormals : 0));
  out.layout = layout;
  out.coordinate_scale = 32767.0f / static_cast<float>(q.coordinate_one);
  return out;
}

void label_mesh(const Api& api, const Mesh& mesh, const GpuMesh& gpu) {
  const char* const name = label_of(mesh);
  label(api, kGlVertexArray, gpu.ssd_array, {name, ": skin"});
  label(api, kGlVertexArray, gpu.as_array, {name, ": animation space"});
  label(api, kGlBuffer, gpu.ssd_buffer, {name, ": skin"});
  label(api, kGlBuffer, gpu.as_buffer, {name, ": animation space"});
  label(api, kGlBuffer, gpu.surface_buffer, {name, ": surface"});
  label(api, kGlBuffer, gpu.index_buffer, {name, ": indices"});
  label(api, kGlBuffer, gpu.morph_buffer, {name, ": morph rows"});
  label(api, kGlTexture, gpu.morph_texture, {name, ": morph targets"});
  label(api, kGlTexture, gpu.example_texture, {name, ": pose space"});
}

}  // namespace

BadCall check_mesh(const Mesh& mesh, const PrepareOptions& options) {
  const Geometry& g = mesh.geometry;
  MARROW_CHECK(g.slot_count > 0 && mesh.joint_count > 0);
  MARROW_CHECK(g.joint_count <= mesh.palette_size() && "the mesh's own geometry");
  MARROW_CHECK(all_finite(g.box_min, 3) && all_finite(g.box_max, 3));
  MARROW_CHECK(options.as_tangents.empty() || holds(options.as_tangents, as_tangent_count(g)));
  MARROW_CHECK(!options.psd || g.pose_space.examples.size <= kMaxPoseExamples);
  return {};
}

std::size_t prepare_scratch_bytes(const Mesh& mesh, const PrepareOptions& options) {
  const Geometry& g = mesh.geometry;
  const VertexLayout layout = make_layout(mesh, !options.as_tangents.empty(), options.psd);
  std::size_t stride = layout.surface_stride;
  if (options.as) stride = larger(stride, layout.as_stride);
  std::size_t bytes = larger(stride * g.slot_count, morph_scratch_bytes(g));
  if (options.ssd)
    bytes = larger(bytes, std::size_t{layout.ssd_stride} * g.slot_count + (options.psd ? example_scratch_bytes(g) : 0));
  return bytes;
}

Status prepare(const Api& api, const Caps& caps, const Mesh& mesh, const PrepareOptions& options,
               Span<std::byte> scratch, Span<Affine> bind, GpuMesh& out) {
  MARROW_ZONE;
  const Geometry& g = mesh.geometry;
  MARROW_REQUIRE_GOOD(check_mesh(mesh, options));
  MARROW_REQUIRE(holds(bind, mesh.joint_count));
  MARROW_REQUIRE(holds(scratch, prepare_scratch_bytes(mesh, options)));
  MARROW_REQUIRE(reinterpret_cast<std::uintptr_t>(scratch.data) % alignof(std::uint32_t) == 0);
  const Span<const float> tangents = options.as_tangents;
  const VertexLayout layout = make_layout(mesh, !tangents.empty(), options.psd);
  // Eight influences in animation space need locations up to the last.
  if (caps.vertex_attributes <= kSurfaceLocations[7]) return Status::unsupported;

  const Quantisation quantisation = make_quantisation(g);
  GpuMesh made = describe(mesh, layout, quantisation, options);
  forget_errors(api);
  api.BindVertexArray(0);
  if ((made.features & kMorphs) != 0) {
    const Status morphs = make_morphs(api, g, quantisation.half_extent, scratch, made);
    if (morphs != Status::ok) return morphs;
  }
  // In WebGL a buffer that was ever bound to another target cannot be an index buffer.
  made.index_buffer = upload(api, kGlElementArrayBuffer, g.indices, std::size_t{g.index_count} * g.index_bytes);
  api.BindBuffer(kGlElementArrayBuffer, 0);
  if (layout.surface_stride != 0) {
    encode_surface(g, layout, scratch.data);
    made.surface_buffer = upload(api, kGlArrayBuffer, scratch.data, std::size_t{layout.surface_stride} * g.slot_count);
  }
  const Status status = options.ssd ? make_ssd(api, g, layout, quantisation, scratch, made) : Status::ok;
  if (options.as && status == Status::ok) make_as(api, g, layout, quantisation, scratch, tangents.data, made);
  api.BindVertexArray(0);
  api.BindBuffer(kGlArrayBuffer, 0);
  if (status != Status::ok || api.GetError() != kGlNoError) {
    destroy(api, made);
    return status != Status::ok ? status : Status::gl_error;
  }
  for (std::uint32_t i = 0; i < mesh.joint_count; ++i) bind[i] = dequantising_bind(mesh.inverse_bind[i], quantisation);
  label_mesh(api, mesh, made);
  out = made;
  return Status::ok;
}

void destroy(const Api& api, GpuMesh& mesh) {
  const std::uint32_t arrays[] = {mesh.ssd_array, mesh.as_array};
  const std::uint32_t buffers[] = {mesh.ssd_buffer, mesh.as_buffer, mesh.surface_buffer, mesh.index_buffer,
                                   mesh.morph_buffer};
  api.DeleteVertexArrays(2, arrays);
  api.DeleteBuffers(5, buffers);
  const std::uint32_t textures[] = {mesh.morph_texture, mesh.example_texture};
  api.DeleteTextures(2, textures);
  mesh = {};
}

Status draw(const Api& api, const GpuMesh& mesh, Deformer deformer, const Program& program, std::uint32_t instances) {
  MARROW_ZONE;
  const std::uint32_t array = deformer == Deformer::as     ? mesh.as_array
                              : deformer == Deformer::none ? 0
                                                           : mesh.ssd_array;
  MARROW_REQUIRE(skins(deformer) && array != 0 && "prepared for this deformer");
  MARROW_REQUIRE((deformer != Deformer::psd || mesh.example_texture != 0) && "prepared for this deformer");
  tell_of_vertices(api, mesh, program);
  api.BindVertexArray(array);
  const auto count = static_cast<int>(mesh.index_count);
  if (instances == 1) {
    api.DrawElements(mesh.primitive, count, mesh.index_type, nullptr);
  } else {
    api.DrawElementsInstanced(mesh.primitive, count, mesh.index_type, nullptr, static_cast<int>(instances));
  }
  api.BindVertexArray(0);
  return Status::ok;
}

}  // namespace marrow::gles3
