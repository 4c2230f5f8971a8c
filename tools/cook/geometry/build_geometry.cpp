#include "cook/geometry/build_geometry.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <optional>

#include "common/failure.h"
#include "common/parallel.h"
#include "cook/geometry/encode_streams.h"
#include "cook/geometry/record.h"
#include "marrow/draco.h"
#include "marrow/meshopt.h"
#include "unpack/expand.h"
#include "unpack/geometry.h"

namespace marrow::cook {
namespace {

template <class T>
T place_of(const std::vector<T>& ascending, T value) {
  return static_cast<T>(std::ranges::lower_bound(ascending, value) - ascending.begin());
}

// The first `kept` of the `width` numbers of each row.
void narrow(std::vector<std::int32_t>& values, std::size_t width, std::size_t kept) {
  std::size_t to = 0;
  for (std::size_t row = 0; row < values.size(); row += width)
    for (std::size_t i = 0; i < kept; ++i) values[to++] = values[row + i];
  values.resize(to);
}

// As many influences as the part's vertices have at most.
void narrow_influences(OwnedStreams& s) {
  const std::size_t width = s.mesh.influences;
  std::size_t most = 1;
  std::vector<std::int32_t>* const joints = s.values_of(StreamKind::joints);
  for (std::size_t row = 0; joints != nullptr && row < joints->size(); row += width) {
    std::size_t count = 1;  // the last repeats
    while (count < width && (*joints)[row + count] > (*joints)[row + count - 1]) ++count;
    most = std::max(most, count);
  }
  s.mesh.influences = static_cast<std::uint32_t>(most);
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    Stream& stream = s.streams[i];
    if (stream.kind != StreamKind::joints && stream.kind != StreamKind::weights) continue;
    const std::size_t kept = stream.kind == StreamKind::joints ? most : most - 1;
    narrow(s.values[i], stream.components, kept);
    stream.components = static_cast<std::uint8_t>(kept);
  }
  s.drop([&](const Stream& stream, const std::vector<std::int32_t>&) {
    const bool of_influence = stream.kind == StreamKind::residual || stream.kind == StreamKind::multi_weight;
    return stream.components == 0 || (of_influence && stream.target >= most) ||
           (stream.kind == StreamKind::joints && s.mesh.joint_count < 2);
  });
}

// Of morph targets and examples that move nothing of the part. They remain targets, so that all parts have as many.
void drop_still(OwnedStreams& s) {
  s.drop([](const Stream& stream, const std::vector<std::int32_t>& values) {
    if (stream.kind != StreamKind::target && stream.kind != StreamKind::pose_delta) return false;
    const std::int32_t nothing = 1 << (stream.bits - 1);
    return std::ranges::all_of(values, [&](std::int32_t n) { return n == nothing; });
  });
}

void take_palette(const OwnedStreams& whole, const std::vector<std::uint16_t>& entries, OwnedStreams& out) {
  out.mesh.joint_count = static_cast<std::uint32_t>(entries.size());
  if ((whole.mesh.flags & format::kHasMwe) != 0)
    out.mesh.mwe_root = place_of(entries, static_cast<std::uint16_t>(whole.mesh.mwe_root));
  if (whole.mesh.example_count == 0) return;
  // An entry whose parent the part lacks has no weight in it; without a parent nothing turns.
  for (const std::uint16_t entry : entries) {
    const std::uint16_t parent = whole.parents[entry];
    out.parents.push_back(std::ranges::binary_search(entries, parent) ? place_of(entries, parent) : kNoJoint);
  }
  constexpr std::int16_t kIdentity[] = {0, 0, 0, 32767};
  for (std::size_t k = 0; k < whole.mesh.example_count; ++k)
    for (std::size_t j = 0; j < entries.size(); ++j) {
      const std::size_t at = (k * whole.mesh.joint_count + entries[j]) * 4;
      const std::int16_t* const from = out.parents[j] == kNoJoint ? kIdentity : &whole.rotations[at];
      out.rotations.insert(out.rotations.end(), from, from + 4);
    }
}

// Some vertices, ascending, some triangles of those, and the palette entries that they need, ascending. Numbers stay
// what they are, so that parts agree to the bit where they meet. Precondition: streams that are not welded.
OwnedStreams part_of_streams(const OwnedStreams& whole, const std::vector<std::uint32_t>& vertices,
                             const std::vector<std::uint32_t>& indices, const std::vector<std::uint16_t>& entries) {
  OwnedStreams out;
  out.mesh = whole.mesh;
  out.mesh.vertex_count = static_cast<std::uint32_t>(vertices.size());
  out.mesh.triangle_count = static_cast<std::uint32_t>(indices.size() / 3);
  for (const std::uint32_t v : indices) out.indices.push_back(place_of(vertices, v));
  out.streams = whole.streams;
  for (std::size_t i = 0; i < whole.streams.size(); ++i)
    out.values.push_back(
        numbers_of(whole.streams[i], whole.values[i], vertices.size(), [&](std::size_t v) { return vertices[v]; }));
  if (std::vector<std::int32_t>* const joints = out.values_of(StreamKind::joints))
    for (std::int32_t& joint : *joints) joint = place_of(entries, static_cast<std::uint16_t>(joint));
  take_palette(whole, entries, out);
  narrow_influences(out);
  drop_still(out);
  return out;
}

// Draco counts a mesh's attributes in a byte, and crashes rather than refuse more. Only meshes with a hundred morph
// targets or so have as many.
constexpr std::size_t kMostDracoStreams = 240;

// The section that these streams become in the runtime.
tools::AlignedBytes expand(OwnedStreams& streams) {
  const MeshStreams mesh = streams.view();
  tools::AlignedBytes scratch(expand_scratch_bytes(mesh));
  // Each vertex in a block of its own, every stream as floats, is more than there can be.
  std::uint64_t bound = sizeof(format::GeometryHeader) + 64 + 4 * std::uint64_t{mesh.source_vertex_count} +
                        12 * std::uint64_t{mesh.triangle_count};
  bound += std::uint64_t{mesh.vertex_count} * (16 * (3 + mesh.influences + 3 + 4 + 2 + 1) + 8 + 2 * mesh.influences);
  bound += 64 + std::uint64_t{mesh.target_count} * sizeof(MorphTarget);
  bound += std::uint64_t{mesh.stream_count} * mesh.vertex_count * (format::kMorphRecordBytes + 4);
  bound += 64 + std::uint64_t{mesh.example_count} * (sizeof(MorphTarget) + 8 * std::uint64_t{mesh.joint_count}) +
           2 * std::uint64_t{mesh.joint_count};
  if (mesh.find(StreamKind::multi_weight) != nullptr) bound += std::uint64_t{mesh.vertex_count} * 192 * mesh.influences;
  if (mesh.find(StreamKind::residual) != nullptr) bound += std::uint64_t{mesh.vertex_count} * 64 * mesh.influences;
  tools::AlignedBytes section(bound);
  Memory memory{scratch.data(), 0, scratch.size()};
  Arrangement arrangement;
  std::uint32_t bytes = 0;
  const char* rule = arrange_geometry(mesh, memory, arrangement);
  if (rule == nullptr) rule = write_geometry(mesh, arrangement, {section.data(), section.size()}, bytes);
  if (rule != nullptr) throw tools::Failure(tools::Exit::internal, "", "", "geometry", rule);
  return tools::AlignedBytes(std::span<const std::byte>(section.data(), bytes));
}

// What the runtime makes of the record.
tools::AlignedBytes unpack_record(const BuiltGeometry& g, const MeshDecoder& decoder, std::size_t section_bytes) {
  tools::AlignedBytes scratch(g.scratch_bytes), section(section_bytes);
  std::uint32_t bytes = 0;
  Status decoded = Status::ok;
  const char* const rule =
      unpack_geometry({g.record.data(), g.record.size()}, decoder, {scratch.data(), scratch.size()},
                      {section.data(), section.size()}, bytes, decoded);
  if (decoded == Status::out_of_memory) throw std::bad_alloc();
  if (rule != nullptr) throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", rule);
  return section;
}

// Whether Draco takes time and memory in proportion to the mesh. It looks for a triangle's neighbours among all that
// meet it in a place, and has a table with 8 bytes for each number that a stream may hold: a UV of 30 000 alone makes
// it 128 MB.
bool suits_draco(const OwnedStreams& s) {
  constexpr unsigned kFewBits = 22;
  constexpr std::uint64_t kNumbersAVertex = 16;
  for (const Stream& stream : s.streams)
    if (stream.bits > kFewBits && std::uint64_t{1} << stream.bits > kNumbersAVertex * s.mesh.vertex_count) return false;
  return s.streams.size() <= kMostDracoStreams && !meets_too_often(s, Meeting::place);
}

bool is_packed(const MeshOptions& options) {
  return options.codec != MeshCodec::none;
}

// Vertices as numbers; writes error.
OwnedStreams make_streams(const RawPrimitive& primitive, const std::vector<Binding>& bindings, std::size_t joint_count,
                          const MeshGrid& grid, const MeshOptions& options, const DeformerData& deformers,
                          MeshError& error) {
  OwnedStreams out = is_packed(options)
                         ? quantised_streams(primitive, bindings, joint_count, grid, options.precision, error)
                         : verbatim_streams(primitive, bindings, joint_count, error);
  add_deformers(primitive, bindings, deformers, is_packed(options) ? grid : MeshGrid{}, out, error);
  return out;
}

// Of welded streams.
void finish(OwnedStreams& streams, const MeshGrid& grid, const MeshOptions& options, BuiltGeometry& out) {
  // A smoothed residual is what the file makes of its joints and their weights: more joints would be another guess.
  if (!grid.residual_source.is_all) merge_runs(streams);
  optimise_order(streams);
  if (is_packed(options)) {
    const bool draco = options.codec != MeshCodec::meshopt && suits_draco(streams) &&
                       !streams.has_collapsed;  // Draco drops triangles that name a vertex twice
    const DracoAim aim = options.codec == MeshCodec::draco_smallest ? DracoAim::smallest : DracoAim::quick;
    const auto encode = [&](OwnedStreams& s) { return draco ? encode_draco(s, aim) : encode_meshopt(s); };
    std::optional<PackedApart> apart = pack_apart(streams, grid.residual_source, encode);
    const std::vector<std::byte> encoded = apart ? std::move(apart->encoded) : encode(streams);
    OwnedStreams& stored = apart ? apart->streams : streams;
    out.codec = draco ? packed::kDraco : packed::kMeshopt;
    out.position_step = grid.step;
    out.record = geometry_record(stored, encoded);
    out.scratch_bytes = geometry_scratch_bytes(stored.view());
  }
  streams.mesh.flags |= streams.source_map.empty() ? 0u : format::kHasSourceSlots;
  out.section = expand(streams);
  out.influences = streams.mesh.influences;
  out.target_count = streams.mesh.target_count;
  std::memcpy(&out.header, out.section.data(), sizeof out.header);
  if (!is_packed(options)) return;
  const MeshDecoder decoder = out.codec == packed::kDraco ? draco_decoder() : meshopt_decoder();
  const tools::AlignedBytes again = unpack_record(out, decoder, out.section.size());
  if (std::memcmp(again.data(), out.section.data(), out.section.size()) != 0)
    throw tools::Failure(tools::Exit::internal, "", "", "packed-geometry", "the record does not unpack to itself");
}

}  // namespace

MeshError worst_of(const MeshError& a, const MeshError& b) {
  MeshError out = a;
  for (std::vector<double> MeshError::*const field : {&MeshError::targets, &MeshError::targets_rest_m}) {
    (out.*field).resize(std::max((a.*field).size(), (b.*field).size()), 0);
    for (std::size_t t = 0; t < (b.*field).size(); ++t) (out.*field)[t] = std::max((out.*field)[t], (b.*field)[t]);
  }
  for (double MeshError::*const field :
       {&MeshError::position, &MeshError::normal_deg, &MeshError::uv, &MeshError::weight, &MeshError::bind,
        &MeshError::rest_m, &MeshError::multi_weight, &MeshError::pose_space})
    out.*field = std::max(a.*field, b.*field);
  return out;
}

BuiltGeometry build_geometry(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                             std::size_t joint_count, const MeshGrid& grid, const MeshOptions& options,
                             const DeformerData& deformers) {
  BuiltGeometry out;
  OwnedStreams streams = make_streams(primitive, bindings, joint_count, grid, options, deformers, out.error);
  weld(streams, options.keep_vertex_order);
  finish(streams, grid, options, out);
  return out;
}

std::vector<BuiltGeometry> build_geometries(const RawPrimitive& primitive, const std::vector<Binding>& bindings,
                                            std::size_t joint_count, const std::vector<GeometryPart>& parts,
                                            const MeshGrid& grid, const MeshOptions& options,
                                            const DeformerData& deformers) {
  MeshError error;
  const OwnedStreams whole = make_streams(primitive, bindings, joint_count, grid, options, deformers, error);
  std::vector<BuiltGeometry> out(parts.size());
  tools::for_each_in_parallel(parts.size(), [&](std::size_t i) {
    const GeometryPart& part = parts[i];
    OwnedStreams streams = part_of_streams(whole, part.vertices, part.indices, part.entries);
    weld(streams, options.keep_vertex_order);
    if (options.keep_vertex_order) {
      std::vector<std::uint32_t> source_map(primitive.positions.size(), kNoSlot);
      for (std::size_t v = 0; v < part.vertices.size(); ++v) source_map[part.vertices[v]] = streams.source_map[v];
      streams.source_map = std::move(source_map);
    }
    out[i].error = error;
    finish(streams, grid, options, out[i]);
  });
  return out;
}
}  // namespace marrow::cook
