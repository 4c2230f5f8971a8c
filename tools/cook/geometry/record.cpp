#include "cook/geometry/record.h"

namespace marrow::cook {
namespace {

void add_pose_space(const OwnedStreams& s, std::vector<std::byte>& out) {
  add_value(s.mesh.sigma, out);
  for (const std::uint16_t parent : s.parents) add_varint(parent == kNoJoint ? 0u : parent + 1u, out);
  for (std::uint32_t k = 0; k < s.mesh.example_count; ++k) {
    const Stream* deltas = nullptr;
    for (const Stream& stream : s.streams)
      if (stream.kind == StreamKind::pose_delta && stream.target == k) deltas = &stream;
    add_value(deltas == nullptr ? std::uint8_t{0} : deltas->bits, out);
    if (deltas != nullptr) add_value(deltas->step, out);
    for (std::size_t j = 0; j < s.parents.size(); ++j)
      if (s.parents[j] != kNoJoint)
        for (std::size_t c = 0; c < 4; ++c) add_value(s.rotations[(k * s.parents.size() + j) * 4 + c], out);
  }
}

void add_targets(const OwnedStreams& s, std::vector<std::byte>& out) {
  std::vector<std::vector<const Stream*>> streams(s.mesh.target_count);
  for (const Stream& stream : s.streams)
    if (stream.kind == StreamKind::target) streams[stream.target].push_back(&stream);
  for (const std::vector<const Stream*>& of_target : streams) {
    std::uint8_t attributes = 0;
    for (const Stream* const stream : of_target)
      attributes = static_cast<std::uint8_t>(attributes | 1u << stream->attribute);
    add_value(attributes, out);
    for (const Stream* const stream : of_target) {
      add_value(stream->bits, out);
      add_value(stream->step, out);
    }
  }
}

void add_residual_apart(const ResidualApart& apart, const std::vector<std::byte>& bits, std::vector<std::byte>& out) {
  add_varint(apart.iterations, out);
  add_value(static_cast<std::uint16_t>(apart.share), out);
  add_value(apart.step_of_w, out);
  add_value(apart.step, out);
  add_varint(static_cast<std::uint32_t>(bits.size()), out);
  out.insert(out.end(), bits.begin(), bits.end());
}

}  // namespace

std::vector<std::byte> geometry_record(const OwnedStreams& s, const std::vector<std::byte>& encoded) {
  std::vector<std::byte> out;
  const bool has_map = !s.source_map.empty();
  const ResidualApart& apart = s.mesh.apart;
  add_varint(
      s.mesh.flags | (has_map ? format::kHasSourceSlots : 0u) | (apart.influences > 0 ? packed::kResidualIsApart : 0u),
      out);
  add_varint(s.mesh.vertex_count, out);
  add_varint(static_cast<std::uint32_t>(s.indices.size() / 3), out);
  add_varint(s.mesh.joint_count, out);
  add_varint(s.mesh.influences, out);
  if (has_map) add_varint(static_cast<std::uint32_t>(s.source_map.size()), out);
  if (s.mesh.target_count > 0) add_varint(s.mesh.target_count, out);
  if (s.mesh.example_count > 0) add_varint(s.mesh.example_count, out);
  if (apart.influences > 0) add_varint(apart.influences, out);
  for (std::size_t i = 0; i < s.streams.size(); ++i) {
    const Stream& stream = s.streams[i];
    if (stream.kind == StreamKind::residual && stream.target > 0) continue;  // as the first
    switch (stream.kind) {
      case StreamKind::position:
      case StreamKind::uv:
      case StreamKind::residual: {
        const int axes = stream.kind == StreamKind::position ? 3 : stream.kind == StreamKind::uv ? 2 : 1;
        add_value(stream.bits, out);
        for (int c = 0; c < axes; ++c) add_value(stream.origin[c], out);
        add_value(stream.step, out);
        break;
      }
      case StreamKind::normal:
      case StreamKind::tangent:
      case StreamKind::weights:
        add_value(stream.bits, out);
        break;
      default:
        break;
    }
  }
  if (apart.influences > 0) add_residual_apart(apart, s.residual_bits, out);
  if (const Stream* const weights = s.find(StreamKind::multi_weight)) {
    add_value(weights->bits, out);
    add_value(weights->step, out);
    add_varint(s.mesh.mwe_root, out);
  }
  add_targets(s, out);
  if (s.mesh.example_count > 0) add_pose_space(s, out);
  for (const std::uint32_t vertex : s.source_map) add_varint(vertex, out);
  out.insert(out.end(), encoded.begin(), encoded.end());
  return out;
}

}  // namespace marrow::cook
