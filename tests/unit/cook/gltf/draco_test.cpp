// Reading glTF: Draco data, what it promises and how it is damaged.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <draco/point_cloud/point_cloud_builder.h>
#include <gtest/gtest.h>

#include "unit/cook/gltf/gltf_text.h"

namespace marrow::cook {
namespace {

struct DracoTriangle {
  std::vector<std::byte> bytes;
  int position = 0, joints = 0, weights = 0;  // unique ids
};

// Two triangles over four points. Joints and weights have numbers of the types named.
struct DracoOptions {
  bool with_metadata = false;
  draco::DataType joint_type = draco::DT_UINT8, weight_type = draco::DT_FLOAT32;
  double joint = 0, weight = 1;
  std::int8_t joint_components = 4;
};

// Four numbers of a type, the first one as given and zeros.
std::vector<std::byte> four_of(draco::DataType type, double number) {
  std::vector<std::byte> bytes(32);
  const auto put = [&]<class T>(draco::DataType of, T) {
    if (type != of) return;
    const T value = static_cast<T>(number);
    std::memcpy(bytes.data(), &value, sizeof value);
  };
  put(draco::DT_UINT8, std::uint8_t{});
  put(draco::DT_UINT16, std::uint16_t{});
  put(draco::DT_UINT32, std::uint32_t{});
  put(draco::DT_INT8, std::int8_t{});
  put(draco::DT_INT16, std::int16_t{});
  put(draco::DT_INT32, std::int32_t{});
  put(draco::DT_FLOAT32, float{});
  put(draco::DT_FLOAT64, double{});
  return bytes;
}

DracoTriangle encode_draco(const DracoOptions& options = {}) {
  draco::TriangleSoupMeshBuilder soup;
  soup.Start(2);
  const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int joints = soup.AddAttribute(draco::GeometryAttribute::GENERIC, options.joint_components, options.joint_type);
  const int weights = soup.AddAttribute(draco::GeometryAttribute::GENERIC, 4, options.weight_type);
  const float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5F}};
  const std::vector<std::byte> joint_bytes = four_of(options.joint_type, options.joint);
  const std::vector<std::byte> weight_bytes = four_of(options.weight_type, options.weight);
  const void *joint = joint_bytes.data(), *weight = weight_bytes.data();
  const int faces[2][3] = {{0, 1, 2}, {1, 3, 2}};
  for (int f = 0; f < 2; ++f) {
    const draco::FaceIndex face(static_cast<std::uint32_t>(f));
    soup.SetAttributeValuesForFace(position, face, corners[faces[f][0]], corners[faces[f][1]], corners[faces[f][2]]);
    soup.SetAttributeValuesForFace(joints, face, joint, joint, joint);
    soup.SetAttributeValuesForFace(weights, face, weight, weight, weight);
  }
  const std::unique_ptr<draco::Mesh> mesh = soup.Finalize();
  if (options.with_metadata) {
    auto whole = std::make_unique<draco::GeometryMetadata>();
    auto branch = std::make_unique<draco::Metadata>();
    branch->AddEntryString("author", std::string(300, 'a'));
    whole->AddSubMetadata("branch", std::move(branch));
    whole->AddEntryInt("number", 7);
    mesh->AddMetadata(std::move(whole));
    auto of_joints = std::make_unique<draco::AttributeMetadata>();
    of_joints->AddEntryString("name", "joints");
    mesh->AddAttributeMetadata(joints, std::move(of_joints));
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(draco::MESH_SEQUENTIAL_ENCODING);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  DracoTriangle result;
  const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
  result.bytes.assign(begin, begin + buffer.size());
  result.position = static_cast<int>(mesh->attribute(position)->unique_id());
  result.joints = static_cast<int>(mesh->attribute(joints)->unique_id());
  result.weights = static_cast<int>(mesh->attribute(weights)->unique_id());
  return result;
}

Builder with_draco(const DracoTriangle& encoded = encode_draco()) {
  Builder b;
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  b.root["nodes"] = {{{"mesh", 0}, {"skin", 0}}, Json::object()};
  b.root["scenes"][0]["nodes"] = {0, 1};
  b.root["skins"] = {{{"joints", {1}}}};
  const int positions =
      b.accessor({{"componentType", kF32}, {"type", "VEC3"}, {"count", 4}, {"min", {0, 0, 0}}, {"max", {1, 1, 0.5}}});
  const int joints = b.accessor({{"componentType", kU8}, {"type", "VEC4"}, {"count", 4}});
  const int weights = b.accessor({{"componentType", kF32}, {"type", "VEC4"}, {"count", 4}});
  const int indices = b.accessor({{"componentType", kU16}, {"type", "SCALAR"}, {"count", 6}});
  Json& primitive = b.primitive({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}});
  primitive["indices"] = indices;
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", b.view(encoded.bytes)},
      {"attributes", {{"POSITION", encoded.position}, {"JOINTS_0", encoded.joints}, {"WEIGHTS_0", encoded.weights}}}};
  return b;
}

constexpr const char* kDracoPointer = "/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";

TEST(GltfDraco, GeometryJointsAndWeightsAreDecoded) {
  Builder b = with_draco();
  const RawScene scene = read(b);
  EXPECT_TRUE(scene.warnings.empty());
  const RawPrimitive& primitive = scene.meshes[0].primitives.at(0);
  ASSERT_EQ(primitive.positions.size(), 4U);
  ASSERT_EQ(primitive.indices.size(), 6U);
  // The coder may renumber vertices; the triangles' corners in space stay.
  std::vector<glm::vec3> corners;
  for (const std::uint32_t index : primitive.indices) corners.push_back(primitive.positions[index]);
  const std::vector<glm::vec3> expected = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}};
  EXPECT_EQ(corners, expected);
  ASSERT_EQ(primitive.influences.size(), 4U);
  EXPECT_EQ(primitive.influences[3].size(), 1U);
  EXPECT_EQ(primitive.influences[3][0].weight, 1.0F);
}

TEST(GltfDraco, MetadataIsPassedOver) {
  Builder b = with_draco(encode_draco({.with_metadata = true}));
  EXPECT_EQ(read(b).meshes[0].primitives[0].positions.size(), 4U);
}

// Four bytes that claim 2^28 - 1 points, with metadata before them and without.
TEST(GltfDraco, CountsAreComparedBeforeAnythingIsDecoded) {
  for (const bool with_metadata : {false, true}) {
    DracoTriangle bomb = encode_draco({.with_metadata = with_metadata});
    // Sequential data states its 2 triangles and 4 points, each in a byte, and then how they are connected.
    std::size_t at = 11;
    while (at + 1 < bomb.bytes.size() && !(bomb.bytes[at] == std::byte{2} && bomb.bytes[at + 1] == std::byte{4})) ++at;
    ASSERT_LT(at + 1, bomb.bytes.size());
    ASSERT_TRUE(with_metadata ? at > 300 : at == 11) << at;
    const std::vector<std::byte> huge = {std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}, std::byte{0x7F}};
    const auto place = bomb.bytes.erase(bomb.bytes.begin() + static_cast<std::ptrdiff_t>(at + 1));
    bomb.bytes.insert(place, huge.begin(), huge.end());
    Builder b = with_draco(bomb);
    expect_failure([&] { read(b); }, Exit::invalid, kDracoPointer, "differs from the accessors");
  }
}

TEST(GltfDraco, OtherBitstreamsAreUnsupported) {
  DracoTriangle old = encode_draco();
  old.bytes[6] = std::byte{1};
  Builder b = with_draco(old);
  expect_failure([&] { read(b); }, Exit::unsupported, kDracoPointer, "Draco bitstream");
}

TEST(GltfDraco, EveryPrefixIsRefused) {
  const std::size_t size = encode_draco().bytes.size();
  std::size_t refused = 0;
  for (std::size_t length = 1; length < size; ++length) {
    Builder b = with_draco();
    b.root["bufferViews"][0]["byteLength"] = length;
    expect_failure([&] { read(b); }, Exit::invalid, kDracoPointer, "Draco");
    ++refused;
  }
  EXPECT_EQ(refused, size - 1);
}

TEST(GltfDraco, PromisesAreChecked) {
  const std::string differs = std::string("invalid ") + kDracoPointer + ": differs from the accessors";
  expect_rows(
      with_draco(),
      {{"other counts", R"("/accessors/0/count": 5, "/accessors/1/count": 5, "/accessors/2/count": 5)", differs},
       {"no such attribute", R"("/P/extensions/KHR_draco_mesh_compression/attributes/JOINTS_0": 77)",
        "invalid /P/attributes/JOINTS_0: wrong Draco attribute"},
       {"fewer indices: seen before anything is unfolded", R"("/accessors/3/count": 3)", differs},
       {"more indices", R"("/accessors/3/count": 9)", "invalid /P/indices: differs from the Draco data"}});
}

TEST(GltfDraco, NumbersOfEveryTypeAreRead) {
  for (const draco::DataType type : {draco::DT_INT8, draco::DT_UINT8, draco::DT_INT16, draco::DT_UINT16,
                                     draco::DT_INT32, draco::DT_UINT32, draco::DT_FLOAT32}) {
    Builder b = with_draco(encode_draco({.joint_type = type, .joint = 1, .weight = 0.5}));
    b.root["nodes"].push_back(Json::object());
    b.root["scenes"][0]["nodes"].push_back(2);
    b.root["skins"][0]["joints"] = {1, 2};
    const RawPrimitive primitive = read(b).meshes.at(0).primitives.at(0);
    for (const std::vector<RawInfluence>& vertex : primitive.influences) {
      ASSERT_EQ(vertex.size(), 1U) << type;
      EXPECT_EQ(vertex[0].joint, 1U) << type;
      EXPECT_EQ(vertex[0].weight, 0.5F) << type;
    }
  }
  const std::string joints = "/meshes/0/primitives/0/attributes/JOINTS_0";
  const auto refused = [&](const DracoOptions& options, const char* rule) {
    Builder b = with_draco(encode_draco(options));
    expect_failure([&] { read(b); }, Exit::invalid, joints, rule);
  };
  // Draco does not see that equal ones are equal: three points a triangle.
  Builder wide = with_draco(encode_draco({.joint_type = draco::DT_FLOAT64}));
  for (std::size_t a = 0; a < 3; ++a) wide.root["accessors"][a]["count"] = 6;
  expect_failure([&] { read(wide); }, Exit::invalid, joints, "wrong Draco attribute");
  refused({.joint_components = 3}, "wrong Draco attribute");
  refused({.joint_type = draco::DT_INT8, .joint = -1}, "not a joint");
  refused({.joint_type = draco::DT_UINT32, .joint = 65536}, "not a joint");
  refused({.joint_type = draco::DT_FLOAT32, .joint = 0.5}, "not a joint");
}

TEST(GltfDraco, NormalisedNumbersAreFractions) {
  struct Row {
    draco::DataType type;
    int component;
    double number;
    float weight;
  };
  for (const Row& row : {Row{draco::DT_UINT8, kU8, 51, 0.2F}, Row{draco::DT_UINT16, kU16, 13107, 0.2F}}) {
    Builder b = with_draco(encode_draco({.weight_type = row.type, .weight = row.number}));
    b.root["accessors"][2].update({{"componentType", row.component}, {"normalized", true}});
    EXPECT_EQ(read(b).meshes.at(0).primitives.at(0).influences.at(0).at(0).weight, row.weight);
  }
}

// The same floats to the bit as by Draco's own library, of 40 points on a bent sheet, in 11 and 8 bits.
TEST(GltfDraco, QuantisedNumbersAreRestored) {
  draco::TriangleSoupMeshBuilder soup;
  soup.Start(38);
  const int position = soup.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int normal = soup.AddAttribute(draco::GeometryAttribute::NORMAL, 3, draco::DT_FLOAT32);
  const auto place = [](int i) {
    return glm::vec3(0.3F * static_cast<float>(i), i % 2, std::sin(static_cast<float>(i)));
  };
  const auto up = [](int i) { return glm::normalize(glm::vec3(std::cos(static_cast<float>(i)), 1, 0.2F)); };
  for (int f = 0; f < 38; ++f) {
    const int second = f + 1 + f % 2, third = f + 2 - f % 2;  // all turn the same way
    const glm::vec3 p[3] = {place(f), place(second), place(third)}, n[3] = {up(f), up(second), up(third)};
    const draco::FaceIndex face(static_cast<std::uint32_t>(f));
    soup.SetAttributeValuesForFace(position, face, &p[0], &p[1], &p[2]);
    soup.SetAttributeValuesForFace(normal, face, &n[0], &n[1], &n[2]);
  }
  draco::Encoder encoder;
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 11);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, 8);
  draco::EncoderBuffer coded;
  ASSERT_TRUE(encoder.EncodeMeshToBuffer(*soup.Finalize(), &coded).ok());
  draco::DecoderBuffer buffer;
  buffer.Init(coded.data(), coded.size());
  const std::unique_ptr<draco::Mesh> theirs = draco::Decoder().DecodeMeshFromBuffer(&buffer).value();
  ASSERT_EQ(theirs->num_points(), 40U);

  Builder b;
  b.root["extensionsUsed"] = b.root["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  const auto promise = [&](const char* type, int component, std::size_t count) {
    return b.accessor({{"componentType", component}, {"type", type}, {"count", count}});
  };
  const int positions = promise("VEC3", kF32, 40), normals = promise("VEC3", kF32, 40);
  Json& primitive = b.primitive({{"POSITION", positions}, {"NORMAL", normals}});
  primitive["indices"] = promise("SCALAR", kU16, 38 * 3);
  const auto* begin = reinterpret_cast<const std::byte*>(coded.data());
  const draco::PointAttribute& at = *theirs->GetNamedAttribute(draco::GeometryAttribute::POSITION);
  const draco::PointAttribute& to = *theirs->GetNamedAttribute(draco::GeometryAttribute::NORMAL);
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", b.view(std::vector<std::byte>(begin, begin + coded.size()))},
      {"attributes", {{"POSITION", at.unique_id()}, {"NORMAL", to.unique_id()}}}};
  const RawPrimitive ours = read(b).meshes.at(0).primitives.at(0);
  ASSERT_EQ(ours.positions.size(), 40U);
  double furthest = 0;
  for (std::uint32_t i = 0; i < 40; ++i) {
    glm::vec3 p, n;
    at.GetMappedValue(draco::PointIndex(i), &p);
    to.GetMappedValue(draco::PointIndex(i), &n);
    EXPECT_EQ(ours.positions[i], p) << i;
    EXPECT_LE(glm::distance(ours.normals[i], glm::normalize(n)), 2e-7F) << i << ": normalised once more";
    const int nearest = static_cast<int>(std::lround(p.x / 0.3F));
    furthest = std::max(furthest, double{glm::distance(p, place(nearest))});
  }
  EXPECT_LE(furthest, 12.0 / 2047) << "and near what was encoded";
}

TEST(GltfDraco, OnlyTrianglesAreInIt) {
  Builder strip = with_draco();
  strip.root["meshes"][0]["primitives"][0]["mode"] = 5;
  EXPECT_EQ(read(strip).meshes.at(0).primitives.at(0).indices.size(), 6U);
  strip.root["meshes"][0]["primitives"][0]["mode"] = 6;
  expect_failure([&] { read(strip); }, Exit::invalid, "/meshes/0/primitives/0/mode", "not triangles");

  draco::PointCloudBuilder builder;
  builder.Start(4);
  const int id = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const float place[3] = {0, 0, 0};
  for (std::uint32_t point = 0; point < 4; ++point)
    builder.SetAttributeValueForPoint(id, draco::PointIndex(point), place);
  draco::EncoderBuffer buffer;
  ASSERT_TRUE(draco::Encoder().EncodePointCloudToBuffer(*builder.Finalize(false), &buffer).ok());
  DracoTriangle cloud = encode_draco();
  const auto* begin = reinterpret_cast<const std::byte*>(buffer.data());
  cloud.bytes.assign(begin, begin + buffer.size());
  cloud.bytes[6] = std::byte{2};  // that of meshes, where clouds have another one
  Builder b = with_draco(cloud);
  expect_failure([&] { read(b); }, Exit::invalid, kDracoPointer, "differs from the accessors");
}

TEST(GltfDraco, WhatIsNotInItComesFromTheAccessor) {
  Builder b = with_draco();
  Json& primitive = b.root["meshes"][0]["primitives"][0];
  primitive["attributes"]["TEXCOORD_0"] = b.numbers<float>(kF32, "VEC2", 2, {1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_EQ(read(b).meshes.at(0).primitives.at(0).uvs.at(3), glm::vec2(7, 8));
  b.root["bufferViews"][0]["buffer"] = 1;
  Json root = Json::parse(b.text());
  root["buffers"].push_back({{"byteLength", 4096}});
  expect_refused(root.dump(), Exit::invalid, std::string(kDracoPointer) + "/bufferView", "no data");
}

// Each byte in turn, made three others.
TEST(GltfDraco, DamageIsReadOrLocated) {
  const DracoTriangle whole = encode_draco();
  std::size_t read_anyway = 0, refused = 0;
  for (std::size_t at = 0; at < whole.bytes.size(); ++at) {
    for (const int flip : {1, 0x80, 0xFF}) {
      DracoTriangle damaged = whole;
      damaged.bytes[at] ^= std::byte(flip);
      Builder b = with_draco(damaged);
      try {
        read(b);
        ++read_anyway;
      } catch (const Failure& failure) {
        EXPECT_TRUE(failure.where().starts_with("/meshes/0/primitives/0")) << failure.what();
        ++refused;
      }
    }
  }
  EXPECT_EQ(read_anyway + refused, 3 * whole.bytes.size());
  EXPECT_GT(refused, 50U);
}

}  // namespace
}  // namespace marrow::cook
