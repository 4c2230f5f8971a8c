// Draco data that holds more than it was asked for: properties that nobody wants, numbers of bits that nothing needs.
#include <cstring>
#include <string>
#include <vector>

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>
#include <gtest/gtest.h>

#include "draco/counts.h"
#include "marrow/draco.h"
#include "unpack/streams.h"

namespace marrow::test {
namespace {

constexpr std::uint32_t kGridSide = 12, kGridVertices = kGridSide * kGridSide,
                        kGridTriangles = 2 * (kGridSide - 1) * (kGridSide - 1);

struct Grid {
  bool edgebreaker = true;
  std::uint8_t uv_components = 2;
  std::uint32_t more = 0;  // properties behind positions and UVs
};

void add_attribute(::draco::Mesh& mesh, ::draco::GeometryAttribute::Type type, std::uint8_t components) {
  ::draco::GeometryAttribute description;
  description.Init(type, nullptr, components, ::draco::DT_INT32, false, 4 * std::int64_t{components}, 0);
  ::draco::PointAttribute& attribute = *mesh.attribute(mesh.AddAttribute(description, true, kGridVertices));
  for (std::uint32_t v = 0; v < kGridVertices; ++v) {
    std::vector<std::int32_t> numbers(components);
    for (std::uint32_t c = 0; c < components; ++c)
      numbers[c] = static_cast<std::int32_t>(c == 0 ? v % kGridSide : c == 1 ? v / kGridSide : v * v % 7);
    attribute.SetAttributeValue(::draco::AttributeValueIndex(v), numbers.data());
  }
}

// As encode_draco() writes it: no skin apart, then Draco's.
std::vector<std::byte> encoded(const Grid& grid) {
  ::draco::Mesh mesh;
  mesh.set_num_points(kGridVertices);
  for (std::uint32_t y = 0; y + 1 < kGridSide; ++y)
    for (std::uint32_t x = 0; x + 1 < kGridSide; ++x) {
      const ::draco::PointIndex a(y * kGridSide + x), b(a.value() + 1), c(a.value() + kGridSide), d(c.value() + 1);
      mesh.AddFace({a, b, c});
      mesh.AddFace({b, d, c});
    }
  add_attribute(mesh, ::draco::GeometryAttribute::POSITION, 3);
  add_attribute(mesh, ::draco::GeometryAttribute::TEX_COORD, grid.uv_components);
  for (std::uint32_t i = 0; i < grid.more; ++i) add_attribute(mesh, ::draco::GeometryAttribute::GENERIC, 4);
  ::draco::ExpertEncoder encoder(mesh);
  encoder.SetEncodingMethod(grid.edgebreaker ? ::draco::MESH_EDGEBREAKER_ENCODING : ::draco::MESH_SEQUENTIAL_ENCODING);
  encoder.SetSpeedOptions(2, 2);
  if (grid.edgebreaker && grid.uv_components == 2)
    static_cast<void>(encoder.SetAttributePredictionScheme(1, ::draco::MESH_PREDICTION_TEX_COORDS_PORTABLE));
  ::draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeToBuffer(&buffer).ok());
  std::vector<std::byte> out(1 + buffer.size());
  std::memcpy(out.data() + 1, buffer.data(), buffer.size());
  return out;
}

// Positions and UVs are asked for.
Status decode(const std::vector<std::byte>& bytes) {
  std::vector<std::int32_t> positions(3 * kGridVertices), uvs(2 * kGridVertices);
  std::vector<std::uint32_t> indices(3 * kGridTriangles);
  Stream streams[2];
  streams[0] = {StreamKind::position, 3};
  streams[0].values = positions.data();
  streams[1] = {StreamKind::uv, 2};
  streams[1].values = uvs.data();
  MeshStreams mesh;
  mesh.vertex_count = kGridVertices;
  mesh.triangle_count = kGridTriangles;
  mesh.indices = indices.data();
  mesh.streams = streams;
  mesh.stream_count = 2;
  return draco_decoder().decode({bytes.data(), bytes.size()}, mesh);
}

TEST(DracoBounds, PropertiesThatNobodyAskedForAreRefused) {
  for (const bool edgebreaker : {true, false}) {
    EXPECT_EQ(decode(encoded({edgebreaker})), Status::ok);
    EXPECT_EQ(decode(encoded({edgebreaker, 2, 1})), Status::bad_data) << "one more";
    EXPECT_EQ(decode(encoded({edgebreaker, 2, 60})), Status::bad_data) << "many";
    EXPECT_EQ(decode(encoded({edgebreaker, 100})), Status::bad_data) << "of more numbers";
  }
}

// Each takes a table of all corners before any property is seen.
TEST(DracoBounds, TablesOfSeamsAreCounted) {
  for (const std::uint32_t more : {0u, 5u}) {
    const std::vector<std::byte> bytes = encoded({true, 2, more});
    DracoCounts counts;
    ASSERT_EQ(draco_counts({bytes.data() + 1, bytes.size() - 1}, counts), Status::ok);
    EXPECT_EQ(counts.seams, 1 + more) << "all but positions";
  }
}

// UVs come last. At the end: how many bits (4 bytes), how likely 0 is (1), the coded bits' bytes (1) and they, the
// least number (4) and the largest (4).
std::size_t place_of_bit_count(const std::vector<std::byte>& bytes) {
  for (std::size_t coded = 0; coded < 100; ++coded) {
    const std::size_t at = bytes.size() - 8 - coded - 6;
    std::uint32_t bits = 0;
    std::memcpy(&bits, &bytes[at], 4);
    if (bytes[at + 5] == static_cast<std::byte>(coded) && bits > 0 && bits <= kGridVertices) return at;
  }
  return 0;
}

TEST(DracoBounds, BitsThatNoVertexHasAreRefused) {
  std::vector<std::byte> bytes = encoded({});
  const std::size_t at = place_of_bit_count(bytes);
  ASSERT_GT(at, 0u);
  bytes[at + 1] = std::byte{1};  // 256 more; Draco is content with 2^31 - 1
  EXPECT_EQ(decode(bytes), Status::bad_data);
}

}  // namespace
}  // namespace marrow::test
