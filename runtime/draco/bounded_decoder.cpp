#include "draco/bounded_decoder.h"

#include <algorithm>

#include <draco/compression/entropy/symbol_decoding.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>

namespace marrow {
namespace {

struct Wanted {
  const MeshStreams& mesh;
  const std::vector<const Stream*>& streams;
};

// Directions may be unit vectors, of three numbers.
bool fits(const Wanted& wanted, const ::draco::Mesh& mesh) {
  if (mesh.num_points() != wanted.mesh.vertex_count || mesh.num_faces() != wanted.mesh.triangle_count) return false;
  if (mesh.num_attributes() != static_cast<int>(wanted.streams.size())) return false;
  for (int i = 0; i < mesh.num_attributes(); ++i) {
    const ::draco::PointAttribute& attribute = *mesh.attribute(i);
    if (attribute.unique_id() >= wanted.streams.size()) return false;
    const int most = std::max<int>(wanted.streams[attribute.unique_id()]->components, 3);
    if (attribute.num_components() > most) return false;
  }
  return true;
}

// UVs may come with a bit each, whose number stands behind them and is believed by Draco: a few bytes can claim two
// billion. So what stands before is decoded once more. At `at`: how they are packed.
bool has_bits_for_each(::draco::DecoderBuffer at, const ::draco::PointAttribute& attribute) {
  const std::size_t values = attribute.size(), numbers = values * attribute.num_components();
  std::uint8_t compressed = 0, width = 0;
  std::int32_t bits = 0;
  if (!at.Decode(&compressed)) return false;
  if (compressed == 0) {
    if (!at.Decode(&width) || static_cast<std::uint64_t>(at.remaining_size()) < numbers * width) return false;
    at.Advance(static_cast<std::int64_t>(numbers * width));
  } else {
    std::vector<std::uint32_t> unused(numbers);
    if (!::draco::DecodeSymbols(static_cast<std::uint32_t>(numbers), attribute.num_components(), &at, unused.data()))
      return false;
  }
  return at.Decode(&bits) && bits >= 0 && static_cast<std::size_t>(bits) <= values;
}

template <class Decoder>
class Bounded : public Decoder {
 public:
  explicit Bounded(const Wanted& wanted) : wanted_(wanted) {}

 protected:
  bool DecodeAllAttributes() override { return fits(wanted_, *this->mesh()) && Decoder::DecodeAllAttributes(); }

 private:
  const Wanted wanted_;
};

class BoundedEdgebreaker final : public Bounded<::draco::MeshEdgebreakerDecoder> {
 public:
  using Bounded::Bounded;

  // Asked for before an attribute's numbers are decoded along the mesh; behind the bytes that say how. Without an
  // answer they are decoded in another way, which is bounded, to numbers that nobody uses.
  const ::draco::MeshAttributeIndicesEncodingData* GetAttributeEncodingData(int id) const override {
    auto& self = const_cast<BoundedEdgebreaker&>(*this);  // Draco asks as if nothing could be wrong
    const auto way = self.buffer()->data_head()[-2];
    const bool is_bounded = way != ::draco::MESH_PREDICTION_TEX_COORDS_DEPRECATED &&
                            (way != ::draco::MESH_PREDICTION_TEX_COORDS_PORTABLE ||
                             has_bits_for_each(*self.buffer(), *point_cloud()->attribute(id)));
    if (is_bounded) return MeshEdgebreakerDecoder::GetAttributeEncodingData(id);
    self.refused_ = true;
    return nullptr;
  }

 protected:
  bool OnAttributesDecoded() override { return !refused_ && MeshEdgebreakerDecoder::OnAttributesDecoded(); }

 private:
  bool refused_ = false;
};

template <class Decoder>
bool decode(const Wanted& wanted, Span<const std::byte> bytes, ::draco::Mesh& out) {
  ::draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data), bytes.size);
  ::draco::DecoderOptions options;  // ours unfold the same directions on every processor
  options.SetAttributeBool(::draco::GeometryAttribute::NORMAL, "skip_attribute_transform", true);
  Decoder decoder(wanted);
  return decoder.Decode(options, &buffer, &out).ok();
}

}  // namespace

bool decode_bounded(Span<const std::byte> bytes, bool edgebreaker, const MeshStreams& mesh,
                    const std::vector<const Stream*>& streams, ::draco::Mesh& out) {
  const Wanted wanted{mesh, streams};
  return edgebreaker ? decode<BoundedEdgebreaker>(wanted, bytes, out)
                     : decode<Bounded<::draco::MeshSequentialDecoder>>(wanted, bytes, out);
}

}  // namespace marrow
