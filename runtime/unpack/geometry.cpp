#include "unpack/geometry.h"

#include "unpack/expand.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMaxVertices = 1u << 28;  // counts times components and bytes stay below 2^36
constexpr std::uint32_t kMaxTriangles = 1u << 28;

bool is_sane(float x) {
  return x > -1e30f && x < 1e30f;  // false for NaN
}

Stream& add(MeshStreams& mesh, StreamKind kind, std::uint32_t components, std::uint32_t bits) {
  Stream& s = mesh.streams[mesh.stream_count++];
  s.kind = kind;
  s.components = static_cast<std::uint8_t>(components);
  s.bits = static_cast<std::uint8_t>(bits);
  return s;
}

// bits, origin of `axes`, step.
bool read_values(Reader& reader, std::uint32_t axes, Stream& s) {
  s.bits = reader.take<std::uint8_t>();
  bool sane = s.bits >= 1 && s.bits <= packed::kMaxValueBits;
  for (std::uint32_t c = 0; c < axes; ++c) {
    s.origin[c] = reader.take<float>();
    sane = sane && is_sane(s.origin[c]);
  }
  s.step = reader.take<float>();
  return sane && is_sane(s.step);
}

bool read_bits(Reader& reader, std::uint32_t least, std::uint32_t most, Stream& s) {
  s.bits = reader.take<std::uint8_t>();
  return s.bits >= least && s.bits <= most;
}

}  // namespace

const char* read_geometry_record(Reader& reader, MeshStreams& out) {
  out = {};
  out.flags = reader.take_varint();
  out.vertex_count = reader.take_varint();
  out.triangle_count = reader.take_varint();
  out.joint_count = reader.take_varint();
  out.influences = reader.take_varint();
  if ((out.flags & format::kHasSourceSlots) != 0) out.source_vertex_count = reader.take_varint();
  if ((out.flags & ~std::uint32_t{format::kAllGeometryFlags}) != 0) return "unknown geometry flags";
  if (out.vertex_count < 1 || out.vertex_count > kMaxVertices || out.triangle_count > kMaxTriangles ||
      out.source_vertex_count > kMaxVertices)
    return "a count out of range";
  if (out.joint_count < 1 || out.joint_count > kMaxJoints || out.influences < 1 || out.influences > kMaxInfluences)
    return "joint_count or influences out of range";
  if ((out.flags & format::kHasTangents) != 0 && (out.flags & format::kHasNormals) == 0)
    return "tangents without normals";

  const auto has = [&](std::uint32_t flag) { return (out.flags & flag) != 0; };
  bool sane = read_values(reader, 3, add(out, StreamKind::position, 3, 0));
  if (has(format::kHasNormals))
    sane = sane && read_bits(reader, 2, packed::kMaxDirectionBits, add(out, StreamKind::normal, 2, 0));
  if (has(format::kHasTangents)) {
    sane = sane && read_bits(reader, 2, packed::kMaxDirectionBits, add(out, StreamKind::tangent, 2, 0));
    add(out, StreamKind::tangent_sign, 1, 1);
  }
  if (has(format::kHasUvs)) sane = sane && read_values(reader, 2, add(out, StreamKind::uv, 2, 0));
  if (has(format::kHasColours)) add(out, StreamKind::colour, 4, 8);
  if (out.joint_count > 1) add(out, StreamKind::joints, out.influences, 15);
  if (out.influences > 1) {
    Stream& weights = add(out, StreamKind::weights, out.influences - 1, 0);
    sane = sane && read_bits(reader, 1, packed::kMaxWeightBits, weights);
    if (sane) weights.step = weight_step(weights.bits);
  }
  if (has(format::kHasAsResidual))
    sane = sane && read_values(reader, 0, add(out, StreamKind::residual, 4 * out.influences, 0));
  if (out.influences > out.joint_count) return "more influences than joints";
  return sane && !reader.failed() ? nullptr : "a stream's bits, origin or step out of range";
}

std::uint64_t geometry_scratch_bytes(const MeshStreams& mesh) {
  const auto array = [](std::uint64_t count) { return (count * 4 + 15) / 16 * 16; };
  std::uint64_t bytes = array(std::uint64_t{mesh.triangle_count} * 3) + array(mesh.source_vertex_count);
  for (std::uint32_t i = 0; i < mesh.stream_count; ++i)
    bytes += array(std::uint64_t{mesh.vertex_count} * mesh.streams[i].components);
  return bytes + expand_scratch_bytes(mesh);
}

const char* unpack_geometry(Span<const std::byte> record, const MeshDecoder& decoder, Span<std::byte> scratch,
                            Span<std::byte> out, std::uint32_t& bytes) {
  Reader reader(record.data, record.size);
  MeshStreams mesh;
  if (const char* const rule = read_geometry_record(reader, mesh)) return rule;
  Arena arena(scratch.data, scratch.size);
  mesh.indices = arena.take<std::uint32_t>(std::uint64_t{mesh.triangle_count} * 3);
  for (std::uint32_t i = 0; i < mesh.stream_count; ++i)
    mesh.streams[i].values = arena.take<std::int32_t>(std::uint64_t{mesh.vertex_count} * mesh.streams[i].components);
  std::uint32_t* const source_map = arena.take<std::uint32_t>(mesh.source_vertex_count);
  if (arena.failed()) return "memory_bytes too small";
  for (std::uint32_t i = 0; i < mesh.source_vertex_count; ++i) source_map[i] = reader.take_varint();
  mesh.source_map = source_map;
  if (reader.failed()) return "a record that ends too soon";
  if (decoder.decode({reader.at(), reader.left()}, mesh) != Status::ok) return "damaged mesh data";
  return expand_geometry(mesh, arena, out, bytes);
}

}  // namespace marrow
