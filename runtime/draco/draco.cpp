// Decodes what encode_draco() has made: a varint, how many bytes of a skin apart follow; then Draco's, whose attribute
// with unique id i is the i-th stream, of 32-bit numbers, of all or of those that are no skin.
#include "marrow/draco.h"

#include <cstring>
#include <new>
#include <vector>

#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include "core/byte_reader.h"
#include "draco/bounded_decoder.h"
#include "draco/counts.h"
#include "draco/decode_skin.h"
#include "unpack/streams.h"

namespace marrow {
namespace {

// Of the GPU's vertex cache, for which this is as good as an order for any cache, in a seventh of the time.
constexpr unsigned kCacheEntries = 16;

bool copy_indices(const ::draco::Mesh& mesh, const MeshStreams& out) {
  if (mesh.num_points() != out.vertex_count || mesh.num_faces() != out.triangle_count) return false;
  std::uint32_t* index = out.indices;
  for (::draco::FaceIndex f(0); f < mesh.num_faces(); ++f)
    for (const ::draco::PointIndex& p : mesh.face(f)) {
      if (p.value() >= out.vertex_count) return false;
      *index++ = p.value();
    }
  return true;
}

bool copy_stream(const ::draco::PointAttribute& attribute, const Stream& s, std::uint32_t vertex_count) {
  const ::draco::DataType type = attribute.data_type();
  if (type != ::draco::DT_INT32 && type != ::draco::DT_UINT32) return false;
  if (attribute.num_components() != s.components) return false;
  const bool mapped = !attribute.is_mapping_identity();
  if (mapped && attribute.indices_map_size() < vertex_count) return false;
  const std::size_t bytes = s.components * sizeof(std::int32_t), size = attribute.size();
  if (attribute.byte_stride() != static_cast<std::int64_t>(bytes) || attribute.byte_offset() != 0 ||
      std::uint64_t{size} * bytes > attribute.buffer()->data_size())
    return false;
  const std::uint8_t* const first = attribute.buffer()->data();
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const std::size_t value = attribute.mapped_index(::draco::PointIndex(v)).value();
    if (value >= size) return false;
    std::memcpy(s.values + std::size_t{v} * s.components, first + value * bytes, bytes);
  }
  return true;
}

bool decode_mesh(Span<const std::byte> skin, Span<const std::byte> bytes, bool edgebreaker, const MeshStreams& out) {
  std::vector<const Stream*> streams;
  for (std::uint32_t i = 0; i < out.stream_count; ++i)
    if (skin.empty() || !is_skin(out.streams[i].kind)) streams.push_back(&out.streams[i]);
  ::draco::Mesh mesh;
  if (!decode_bounded(bytes, edgebreaker, out, streams, mesh) || !copy_indices(mesh, out)) return false;
  // Draco walks over the surface in an order of its own; this one is for the GPU's vertex cache.
  const std::size_t index_count = std::size_t{out.triangle_count} * 3;
  meshopt_optimizeVertexCacheFifo(out.indices, out.indices, index_count, out.vertex_count, kCacheEntries);
  for (std::uint32_t id = 0; id < streams.size(); ++id) {
    const ::draco::PointAttribute* const attribute = mesh.GetAttributeByUniqueId(id);
    if (attribute == nullptr || !copy_stream(*attribute, *streams[id], out.vertex_count)) return false;
  }
  return skin.empty() || decode_skin(skin, out);
}

Status decode(Span<const std::byte> record, const MeshStreams& out) {
  ByteReader reader(record.data, record.size);
  const Span<const std::byte> skin = reader.take_bytes(reader.take_varint());
  if (reader.failed()) return Status::bad_data;
  const Span<const std::byte> bytes(reader.at(), reader.left());
  DracoCounts claimed;
  if (const Status status = draco_counts(bytes, claimed); status != Status::ok) return status;
  if (claimed.points > out.vertex_count || claimed.faces > out.triangle_count || claimed.seams > out.stream_count)
    return Status::bad_data;
#if defined(__cpp_exceptions)
  try {
    return decode_mesh(skin, bytes, claimed.edgebreaker, out) ? Status::ok : Status::bad_data;
  } catch (const std::bad_alloc&) {
    return Status::out_of_memory;
  } catch (...) {  // Draco's containers, asked for more than they can hold
    return Status::bad_data;
  }
#else
  return decode_mesh(skin, bytes, claimed.edgebreaker, out) ? Status::ok : Status::bad_data;
#endif
}

}  // namespace

MeshDecoder draco_decoder() {
  return {packed::kDraco, decode};
}

}  // namespace marrow
