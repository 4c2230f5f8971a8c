#include "unpack/geometry.h"

#include <algorithm>
#include <new>

#include "unpack/residual.h"

namespace marrow {
namespace {

constexpr std::uint32_t kMaxVertices = 1u << 28;  // counts times components and bytes stay below 2^36
constexpr std::uint32_t kMaxTriangles = 1u << 28;
constexpr std::uint32_t kMaxTargets = 1u << 16;
constexpr std::size_t kStreamBytes = 32;  // of a Stream in memory_bytes, for any size of pointers
static_assert(sizeof(Stream) <= kStreamBytes);

bool is_sane(float x) {
  return x > -1e30f && x < 1e30f;  // false for NaN
}

// A record that is read, or only measured. Measuring has no memory: each stream replaces the one before, in `last`.
struct Reading {
  ByteReader& reader;
  Memory& memory;
  MeshStreams& out;
  bool measures = false;
  Stream last = {};

  Stream& add(const Stream& stream) {
    if (measures) memory.take<std::int32_t>(std::uint64_t{out.vertex_count} * stream.components);
    Stream& s = measures ? last : out.streams[out.stream_count];
    ++out.stream_count;
    s = stream;
    return s;
  }
  Stream& add(StreamKind kind, std::uint32_t components, std::uint32_t bits) {
    Stream s;
    s.kind = kind;
    s.components = static_cast<std::uint8_t>(components);
    s.bits = static_cast<std::uint8_t>(bits);
    return add(s);
  }
};

// bits, origin of `axes`, step.
bool read_values(ByteReader& reader, std::uint32_t axes, Stream& s) {
  s.bits = reader.take<std::uint8_t>();
  bool sane = s.bits >= 1 && s.bits <= packed::kMaxValueBits;
  for (std::uint32_t c = 0; c < axes; ++c) {
    s.origin[c] = reader.take<float>();
    sane = sane && is_sane(s.origin[c]);
  }
  s.step = reader.take<float>();
  return sane && is_sane(s.step);
}

bool read_bits(ByteReader& reader, std::uint32_t least, std::uint32_t most, Stream& s) {
  s.bits = reader.take<std::uint8_t>();
  return s.bits >= least && s.bits <= most;
}

// u8 attributes; for each u8 bits, f32 step.
bool read_target(Reading& in, std::uint32_t target) {
  const MeshStreams& out = in.out;
  const std::uint32_t attributes = in.reader.take<std::uint8_t>();
  const std::uint32_t allowed = kMorphsPositions | ((out.flags & format::kHasNormals) != 0 ? kMorphsNormals : 0u) |
                                ((out.flags & format::kHasTangents) != 0 ? kMorphsTangents : 0u);
  if ((attributes & ~allowed) != 0) return false;
  for (std::uint8_t a = 0; a < 3; ++a) {
    if ((attributes >> a & 1) == 0) continue;
    Stream& s = in.add(StreamKind::target, 3, 0);
    s.target = target;
    s.attribute = a;
    if (!read_values(in.reader, 0, s) || s.bits > packed::kMaxTargetBits) return false;
  }
  return true;
}

// u8 bits, f32 step, varint root; a stream an influence.
bool read_multi_weights(Reading& in) {
  Stream first;
  if (!read_values(in.reader, 0, first)) return false;
  in.out.mwe_root = in.reader.take_varint();
  for (std::uint32_t j = 0; j < in.out.influences; ++j) {
    Stream& s = in.add(StreamKind::multi_weight, 12, first.bits);
    s.step = first.step;
    s.target = j;
  }
  return true;
}

// f32 sigma; a varint a palette entry: 0 without a parent, else 1 + which; then of each example u8 bits and, unless
// they are 0, f32 step; and four i16 for each entry with a parent.
bool read_pose_space(Reading& in) {
  MeshStreams& out = in.out;
  ByteReader& reader = in.reader;
  const std::uint64_t joints = out.joint_count;
  auto* const parents = in.memory.take<std::uint16_t>(joints).data;
  auto* const rotations = in.memory.take<std::int16_t>(4 * joints * out.example_count).data;
  if (in.memory.failed) return false;
  out.parents = parents;
  out.rotations = rotations;
  out.sigma = reader.take<float>();
  std::size_t given = 0;  // entries with a parent
  for (std::uint64_t j = 0; j < joints; ++j) {
    const std::uint32_t parent = reader.take_varint();
    if (parent > joints) return false;
    given += parent != 0 ? 1 : 0;
    if (!in.measures) parents[j] = parent == 0 ? kNoJoint : static_cast<std::uint16_t>(parent - 1);
  }
  std::int16_t* rotation = rotations;
  for (std::uint32_t k = 0; k < out.example_count; ++k) {
    Stream s;
    s.bits = reader.take<std::uint8_t>();
    if (s.bits > packed::kMaxTargetBits) return false;
    if (s.bits > 0) {
      s.step = reader.take<float>();
      if (!is_sane(s.step)) return false;
      Stream& added = in.add(StreamKind::pose_delta, 3, s.bits);
      added.step = s.step;
      added.target = k;
    }
    if (in.measures) {
      reader.take_bytes(given * 8);
      continue;
    }
    for (std::uint64_t j = 0; j < joints; ++j, rotation += 4) {
      constexpr std::int16_t kUnturned[4] = {0, 0, 0, 32767};
      for (int c = 0; c < 4; ++c) rotation[c] = parents[j] == kNoJoint ? kUnturned[c] : reader.take<std::int16_t>();
    }
  }
  return true;
}

const char* read_counts(ByteReader& reader, MeshStreams& out) {
  out = {};
  out.flags = reader.take_varint();
  out.vertex_count = reader.take_varint();
  out.triangle_count = reader.take_varint();
  out.joint_count = reader.take_varint();
  out.influences = reader.take_varint();
  if ((out.flags & format::kHasSourceSlots) != 0) out.source_vertex_count = reader.take_varint();
  if ((out.flags & format::kHasMorphTargets) != 0) out.target_count = reader.take_varint();
  const bool has_examples = (out.flags & format::kHasPoseSpace) != 0;
  if (has_examples) out.example_count = reader.take_varint();
  const bool is_apart = (out.flags & packed::kResidualIsApart) != 0;
  out.flags &= ~packed::kResidualIsApart;
  if (is_apart) out.apart.influences = reader.take_varint();
  if (out.example_count > kMaxPoseExamples || (out.example_count == 0) == has_examples)
    return "a count of examples out of range";
  if ((out.flags & ~std::uint32_t{format::kAllGeometryFlags}) != 0) return "unknown geometry flags";
  if (out.vertex_count < 1 || out.vertex_count > kMaxVertices || out.triangle_count > kMaxTriangles ||
      out.source_vertex_count > kMaxVertices || out.target_count > kMaxTargets ||
      (out.target_count == 0) != ((out.flags & format::kHasMorphTargets) == 0))
    return "a count out of range";
  if (out.joint_count < 1 || out.joint_count > kMaxJoints || out.influences < 1 || out.influences > kMaxInfluences)
    return "joint_count or influences out of range";
  if ((out.flags & format::kHasTangents) != 0 && (out.flags & format::kHasNormals) == 0)
    return "tangents without normals";
  if (out.influences > out.joint_count || out.apart.influences > out.joint_count) return "more influences than joints";
  if (is_apart &&
      ((out.flags & format::kHasAsResidual) == 0 || (out.flags & format::kHasMwe) != 0 || out.influences < 2 ||
       out.apart.influences < out.influences || out.apart.influences > kMaxInfluences))
    return "a residual apart that none can be";
  return nullptr;
}

// Streams, whose counts have been read.
const char* read_streams(Reading& in) {
  ByteReader& reader = in.reader;
  MeshStreams& out = in.out;
  const std::uint64_t most = geometry_stream_count(out.target_count, out.example_count);
  if (in.measures) {
    in.memory.take<std::byte>(most * kStreamBytes);
  } else {
    out.streams = in.memory.take<Stream>(most).data;
  }
  if (in.memory.failed) return "memory_bytes too small";
  const auto has = [&](std::uint32_t flag) { return (out.flags & flag) != 0; };
  bool sane = read_values(reader, 3, in.add(StreamKind::position, 3, 0));
  if (has(format::kHasNormals))
    sane = sane && read_bits(reader, 2, packed::kMaxDirectionBits, in.add(StreamKind::normal, 2, 0));
  if (has(format::kHasTangents)) {
    sane = sane && read_bits(reader, 2, packed::kMaxDirectionBits, in.add(StreamKind::tangent, 2, 0));
    in.add(StreamKind::tangent_sign, 1, 1);
  }
  if (has(format::kHasUvs)) sane = sane && read_values(reader, 2, in.add(StreamKind::uv, 2, 0));
  if (has(format::kHasColours)) in.add(StreamKind::colour, 4, 8);
  if (out.joint_count > 1) in.add(StreamKind::joints, out.influences, 15);
  if (out.influences > 1) {
    Stream& weights = in.add(StreamKind::weights, out.influences - 1, 0);
    sane = sane && read_bits(reader, 1, packed::kMaxWeightBits, weights);
    if (sane) weights.step = weight_step(weights.bits);
  }
  if (out.apart.influences > 0) {
    sane = sane && read_residual_apart(reader, out);
  } else if (has(format::kHasAsResidual)) {
    Stream& first = in.add(StreamKind::residual, 4, 0);
    sane = sane && read_values(reader, 1, first);
    for (std::uint32_t j = 1; j < out.influences; ++j) in.add(Stream{first}).target = j;
  }
  const std::uint32_t before = out.stream_count;
  if (has(format::kHasMwe)) sane = sane && read_multi_weights(in);
  const std::uint32_t behind = out.stream_count;
  for (std::uint32_t t = 0; t < out.target_count; ++t) sane = sane && read_target(in, t);
  // Multi-weights are coded behind targets.
  if (!in.measures) std::rotate(out.streams + before, out.streams + behind, out.streams + out.stream_count);
  if (out.example_count > 0) sane = sane && read_pose_space(in);
  if (in.memory.failed) return "memory_bytes too small";
  return sane && !reader.failed() ? nullptr : "a stream's bits, origin or step out of range";
}

// Scratch memory for what comes after decoding. The arrangement reuses what a residual frees.
std::uint64_t work_bytes(const MeshStreams& mesh) {
  const std::uint64_t arranging = expand_scratch_bytes(mesh);
  if (mesh.apart.influences == 0) return arranging;
  const ResidualBytes residual = residual_apart_bytes(mesh);
  return residual.kept + std::max(residual.freed, arranging);
}

// At most: each vertex may be in a run of its own, and be moved by all targets and examples.
std::uint64_t most_section_bytes(const MeshStreams& mesh) {
  format::GeometryHeader h{};
  h.flags = mesh.flags;
  h.block_count = h.run_count = mesh.vertex_count;
  h.influence_blocks = h.set_count = mesh.vertex_count * std::max(mesh.influences, mesh.apart.influences);
  h.index_count = 3 * mesh.triangle_count;
  h.source_vertex_count = mesh.source_vertex_count;
  const std::uint64_t moves = std::uint64_t{mesh.target_count} + mesh.example_count, blocks = mesh.vertex_count;
  std::uint64_t bytes = layout(h).bytes;
  if (moves == 0) return bytes;
  bytes += 2 * (3 + sizeof(format::MorphHeader)) + moves * (sizeof(MorphTarget) + 4 * blocks);
  bytes += mesh.stream_count * blocks * format::kMorphRecordBytes;
  return bytes + std::uint64_t{mesh.joint_count} * (8 * std::uint64_t{mesh.example_count} + 2);
}

// Reads what stands in front of the codec's bytes and the map; takes memory for all that is to be decoded.
const char* begin_streams(Span<const std::byte> record, Span<std::byte> scratch, GeometryInWork& out) {
  ByteReader reader(record.data, record.size);
  out.scratch = {scratch.data, 0, scratch.size};
  Memory& memory = out.scratch;
  MeshStreams& mesh = out.streams;
  if (const char* const rule = read_geometry_record(reader, memory, mesh)) return rule;
  mesh.indices = memory.take<std::uint32_t>(std::uint64_t{mesh.triangle_count} * 3).data;
  for (std::uint32_t i = 0; i < mesh.stream_count; ++i)
    mesh.streams[i].values =
        memory.take<std::int32_t>(std::uint64_t{mesh.vertex_count} * mesh.streams[i].components).data;
  mesh.source_map = memory.take<std::uint32_t>(mesh.source_vertex_count).data;
  out.decoding.read = static_cast<std::uint32_t>(record.size - reader.left());
  return memory.failed ? "memory_bytes too small" : nullptr;
}

// Reads which vertex each source vertex has become: one step's worth, or all. False if the record ends too soon.
bool map_source(Span<const std::byte> record, const MeshStreams& mesh, Decoding& work, bool a_step) {
  const std::uint32_t count = mesh.source_vertex_count, end = a_step ? step_end(work.mapped, count) : count;
  ByteReader reader(record.data + work.read, record.size - work.read);
  for (; work.mapped < end; ++work.mapped) mesh.source_map[work.mapped] = reader.take_varint();
  work.read = static_cast<std::uint32_t>(record.size - reader.left());
  return !reader.failed();
}

}  // namespace

const char* read_geometry_record(ByteReader& reader, Memory& memory, MeshStreams& out) {
  if (const char* const rule = read_counts(reader, out)) return rule;
  Reading in{reader, memory, out};
  return read_streams(in);
}

const char* measure_geometry_record(Span<const std::byte> record, GeometryNeeds& out) {
  ByteReader reader(record.data, record.size);
  Memory memory;
  MeshStreams mesh;
  if (const char* const rule = read_counts(reader, mesh)) return rule;
  Reading in{reader, memory, mesh, true};
  if (const char* const rule = read_streams(in)) return rule;
  memory.take<std::uint32_t>(std::uint64_t{mesh.triangle_count} * 3);
  memory.take<std::uint32_t>(mesh.source_vertex_count);
  if (memory.failed) return "more memory than there can be";
  out = {memory.whole() + work_bytes(mesh), most_section_bytes(mesh)};
  return nullptr;
}

static_assert(alignof(WritingInWork) <= 16 && sizeof(WritingInWork) <= 256);

std::uint64_t geometry_scratch_bytes(const MeshStreams& mesh) {
  const auto array = [](std::uint64_t count) { return (count * 4 + 15) / 16 * 16; };
  std::uint64_t bytes = array(std::uint64_t{mesh.triangle_count} * 3) + array(mesh.source_vertex_count);
  bytes += (geometry_stream_count(mesh.target_count, mesh.example_count) * kStreamBytes + 15) / 16 * 16;
  if (mesh.example_count > 0)
    bytes += format::align16(std::uint64_t{mesh.joint_count} * 2) +
             format::align16(std::uint64_t{mesh.joint_count} * mesh.example_count * 8);
  for (std::uint32_t i = 0; i < mesh.stream_count; ++i)
    bytes += array(std::uint64_t{mesh.vertex_count} * mesh.streams[i].components);
  return bytes + work_bytes(mesh);
}

const char* decode_geometry(Span<const std::byte> record, const MeshDecoder& decoder, Span<std::byte> scratch,
                            GeometryInWork& out, Status& decoded, bool* done) {
  if (out.streams.streams == nullptr)
    if (const char* const rule = begin_streams(record, scratch, out)) return rule;
  MeshStreams& mesh = out.streams;
  Decoding& work = out.decoding;
  if (!map_source(record, mesh, work, done != nullptr)) return "a record that ends too soon";
  if (done != nullptr) *done = false;
  if (work.mapped < mesh.source_vertex_count) return nullptr;
  mesh.decoding = done != nullptr ? &work : nullptr;
  decoded = decoder.decode({record.data + work.read, record.size - work.read}, mesh);
  mesh.decoding = nullptr;
  if (done != nullptr) *done = work.parts == 0 || work.parts > mesh.stream_count;
  if (decoded == Status::ok) return nullptr;
  return decoded == Status::out_of_memory ? to_string(decoded) : "damaged mesh data";
}

const char* finish_streams(GeometryInWork& mesh, bool& done) {
  done = mesh.streams.apart.influences == 0;
  if (done) return nullptr;
  if (mesh.residual == nullptr) return begin_residual_apart(mesh.streams, mesh.scratch, mesh.residual);
  return unpack_residual_apart(*mesh.residual, mesh.scratch, mesh.streams, done);
}

const char* arrange_geometry(GeometryInWork& mesh, bool& done) {
  std::uint32_t left = kStepNumbers;
  const char* const rule = arrange_geometry(mesh.streams, mesh.scratch, mesh.arranging, mesh.arrangement, left);
  done = mesh.arranging.place == ArrangingInWork::Place::done;
  return rule;
}

const char* write_geometry(GeometryInWork& mesh, Span<std::byte> out, std::uint32_t& bytes, bool& done) {
  done = true;
  // A small mesh is written at once: its array stretch_of, which is free by now, has no room for a WritingInWork.
  if (mesh.streams.vertex_count < sizeof(WritingInWork) / sizeof(std::uint32_t))
    return write_geometry(mesh.streams, mesh.arrangement, out, bytes);
  if (mesh.writing == nullptr) mesh.writing = ::new (mesh.arranging.stretch_of) WritingInWork;
  std::uint32_t left = kStepNumbers;
  const char* const rule = write_geometry(mesh.streams, mesh.arrangement, *mesh.writing, out, bytes, left);
  done = mesh.writing->place == WritingInWork::Place::done;
  return rule;
}

}  // namespace marrow
