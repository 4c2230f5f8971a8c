// Reading glTF: views that EXT_meshopt_compression or KHR_meshopt_compression compresses. Streams are made by
// meshoptimizer's own encoders, vertices of version 1 by the tests'; filters are held against its decoders and against
// hand arithmetic.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include "cook/gltf/document/meshopt.h"
#include "support/rig.h"
#include "unit/cook/gltf/gltf_text.h"
#include "unit/cook/gltf/meshopt_stream.h"

namespace marrow::cook {
namespace {

using Bytes = std::vector<std::byte>;

Bytes encode_attributes(const std::byte* from, std::size_t count, std::size_t stride, int version = 0) {
  if (version == 1) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(from);
    test::Random random(stride);
    const Octets modes(stride / 4, static_cast<std::uint8_t>(random.below(3)));
    const Octets octets =
        encode_vertices_1({bytes, bytes + count * stride}, stride, modes, [&](unsigned n) { return random.below(n); });
    const auto coded = std::as_bytes(std::span(octets));
    return {coded.begin(), coded.end()};
  }
  std::vector<unsigned char> coded(meshopt_encodeVertexBufferBound(count, stride));
  coded.resize(meshopt_encodeVertexBuffer(coded.data(), coded.size(), from, count, stride));
  const auto* begin = reinterpret_cast<const std::byte*>(coded.data());
  return {begin, begin + coded.size()};
}

Bytes encode_indices(const std::vector<std::uint32_t>& indices, bool as_triangles) {
  std::vector<unsigned char> coded(as_triangles ? meshopt_encodeIndexBufferBound(indices.size(), 65536)
                                                : meshopt_encodeIndexSequenceBound(indices.size(), 65536));
  const std::uint32_t* from = indices.data();
  coded.resize(as_triangles ? meshopt_encodeIndexBuffer(coded.data(), coded.size(), from, indices.size())
                            : meshopt_encodeIndexSequence(coded.data(), coded.size(), from, indices.size()));
  const auto* begin = reinterpret_cast<const std::byte*>(coded.data());
  return {begin, begin + coded.size()};
}

// skinned() with a compressed view in the place of each plain one: what is plain lies in a buffer without bytes.
Json compressed(const std::string& name, bool as_triangles = true, int version = 0) {
  Builder plain = skinned();
  Builder coded;
  Json root = plain.root;
  const std::size_t strides[] = {12, 4, 16, 2, 64, 4, 16};
  for (std::size_t v = 0; v < root["bufferViews"].size(); ++v) {
    Json& view = root["bufferViews"][v];
    const std::size_t stride = strides[v], count = view["byteLength"].get<std::size_t>() / stride;
    const std::byte* from = plain.bytes.data() + view["byteOffset"].get<std::size_t>();
    const bool are_indices = stride == 2;
    const std::vector<std::uint32_t> indices = {0, 1, 2, 1, 3, 2};
    const int at = coded.view(are_indices ? encode_indices(indices, as_triangles)
                                          : encode_attributes(from, count, stride, version));
    Json extension = coded.root["bufferViews"][static_cast<std::size_t>(at)];
    extension.update({{"byteStride", stride},
                      {"count", count},
                      {"mode", !are_indices   ? "ATTRIBUTES"
                               : as_triangles ? "TRIANGLES"
                                              : "INDICES"}});
    view["buffer"] = 1;
    view["extensions"][name] = extension;
  }
  root["extensionsUsed"] = root["extensionsRequired"] = {name};
  root["buffers"] = Json::parse(coded.text())["buffers"];
  root["buffers"].push_back({{"byteLength", plain.bytes.size()}, {"extensions", {{name, {{"fallback", true}}}}}});
  return root;
}

// A triangle's corners from the least one on: the codec may turn it.
std::vector<std::array<std::uint32_t, 3>> triangles(const RawPrimitive& primitive) {
  std::vector<std::array<std::uint32_t, 3>> found;
  for (std::size_t i = 0; i + 2 < primitive.indices.size(); i += 3) {
    std::array<std::uint32_t, 3> corners = {primitive.indices[i], primitive.indices[i + 1], primitive.indices[i + 2]};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    found.push_back(corners);
  }
  return found;
}

TEST(GltfMeshopt, ViewsAreDecoded) {
  Builder b = skinned();
  const RawScene plain = read(b);
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    for (const auto& [as_triangles, version] : {std::pair(true, 0), {false, 0}, {true, 1}}) {
      const RawScene scene = read_text(compressed(name, as_triangles, version).dump());
      EXPECT_TRUE(scene.warnings.empty());
      const RawPrimitive &ours = scene.meshes.at(0).primitives.at(0), &theirs = plain.meshes[0].primitives[0];
      EXPECT_EQ(ours.positions, theirs.positions);
      EXPECT_EQ(triangles(ours), triangles(theirs));
      ASSERT_EQ(ours.influences.size(), theirs.influences.size());
      for (std::size_t v = 0; v < ours.influences.size(); ++v) {
        ASSERT_EQ(ours.influences[v].size(), theirs.influences[v].size());
        for (std::size_t i = 0; i < ours.influences[v].size(); ++i) {
          EXPECT_EQ(ours.influences[v][i].joint, theirs.influences[v][i].joint);
          EXPECT_EQ(ours.influences[v][i].weight, theirs.influences[v][i].weight);
        }
      }
      EXPECT_EQ(scene.skins.at(0).inverse_bind, plain.skins[0].inverse_bind);
      EXPECT_EQ(scene.clips.at(0).channels.at(0).values, plain.clips[0].channels[0].values);
      EXPECT_EQ(scene.clips.at(0).channels.at(0).times_s, plain.clips[0].channels[0].times_s);
    }
  }
}

TEST(GltfMeshopt, FallbacksAreNotRead) {
  Json root = compressed("EXT_meshopt_compression");
  const std::size_t length = root["buffers"][1]["byteLength"];
  root["buffers"][1]["uri"] = "data:application/octet-stream;base64," + base64(Bytes(length));
  EXPECT_EQ(read_text(root.dump()).meshes.at(0).primitives.at(0).positions.at(3), glm::vec3(3, 9, 0));
}

// Changes to compressed() and how they are refused. V is the first view's extension.
const std::pair<std::string, std::string> kBadViews[] = {
    {R"("V/mode": "POINTS")", "invalid V/mode: unknown value"},
    {R"("V/mode": 7)", "invalid V/mode: wrong type"},
    {R"("V/mode": null)", "invalid V/mode: missing"},
    {R"("V/filter": "SOFT")", "invalid V/filter: unknown value"},
    {R"("V/filter": "QUATERNION")", "invalid V/filter: not as the extension"},
    {R"("V/filter": "COLOR")", "invalid V/filter: not as the extension"},
    {R"("V/mode": "INDICES")", "invalid V/byteStride: not as the extension"},
    {R"("V/byteStride": 6)", "invalid V/byteStride: not as the extension"},
    {R"("V/byteStride": 260)", "invalid V/byteStride: out of range"},
    {R"("V/count": 5)", "invalid V/count: not as the extension"},
    {R"("V/count": 9007199254740991)", "invalid V/count: not as the extension"},
    {R"("V/count": 0)", "invalid V/count: out of range"},
    {R"("V/buffer": 2)", "invalid V/buffer: reference to nothing"},
    {R"("V/buffer": 1)", "invalid V/buffer: no data"},
    {R"("V/byteLength": 100000)", "invalid V/byteLength: beyond the buffer"},
    {R"("V/byteOffset": 9007199254740991)", "invalid V/byteLength: beyond the buffer"},
    {R"("V/byteLength": 4)", "invalid V: damaged meshopt data"},
    {R"("V/byteOffset": 1)", "invalid V: damaged meshopt data"},
    {R"("/bufferViews/0/byteStride": 16)", "invalid V/byteStride: not as the extension"},
    {R"("/bufferViews/3/extensions/EXT_meshopt_compression/filter": "OCTAHEDRAL")",
     "invalid /bufferViews/3/extensions/EXT_meshopt_compression/filter: "},
};

TEST(GltfMeshopt, WhatCannotBeIsLocated) {
  Builder b;
  b.root = compressed("EXT_meshopt_compression");
  b.is_whole = true;
  const auto with_view = [](std::string text, const std::string& before) {
    for (std::size_t at; (at = text.find(before + "V")) != std::string::npos;)
      text.replace(at + 1, 1, "/bufferViews/0/extensions/EXT_meshopt_compression");
    return text;
  };
  for (const auto& [change, said] : kBadViews) expect_rows(b, {{said, with_view(change, "\""), with_view(said, " ")}});
}

// Bytes of the compressed document's buffer, as it has them.
Bytes coded_bytes(const Json& root) {
  std::string text = root["buffers"][0]["uri"];
  text.erase(0, text.find(',') + 1);
  Bytes bytes;
  unsigned bits = 0, held = 0;
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | static_cast<unsigned>(digits.find(c));
    if ((held += 6) >= 8) bytes.push_back(static_cast<std::byte>(bits >> (held -= 8)));
  }
  return bytes;
}

TEST(GltfMeshopt, DamageIsReadOrLocated) {
  for (const int version : {0, 1}) {
    const Json whole = compressed("EXT_meshopt_compression", true, version);
    const Bytes bytes = coded_bytes(whole);
    std::size_t read_anyway = 0, refused = 0;
    const std::size_t step = version == 0 ? 1 : 5;
    for (std::size_t at = 0; at < bytes.size(); at += step) {
      for (const int flip : {1, 0x80, 0xFF}) {
        Bytes damaged = bytes;
        damaged[at] ^= std::byte(flip);
        Json root = whole;
        root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(damaged);
        try {
          read_text(root.dump());
          ++read_anyway;
        } catch (const Failure& failure) {
          EXPECT_FALSE(failure.where().empty());
          ++refused;
        }
      }
    }
    EXPECT_EQ(read_anyway + refused, 3 * ((bytes.size() + step - 1) / step));
    EXPECT_GT(refused, bytes.size() / step / 4);
  }
}

TEST(GltfMeshopt, EveryPrefixIsRefused) {
  for (const int version : {0, 1}) {
    const Json whole = compressed("KHR_meshopt_compression", true, version);
    std::size_t refused = 0;
    for (std::size_t v = 0; v < whole["bufferViews"].size(); ++v) {
      const Json& extension = whole["bufferViews"][v]["extensions"]["KHR_meshopt_compression"];
      for (std::size_t length = 1; length < extension["byteLength"].get<std::size_t>(); ++length) {
        Json root = whole;
        root["bufferViews"][v]["extensions"]["KHR_meshopt_compression"]["byteLength"] = length;
        expect_refused(root.dump(), Exit::invalid,
                       "/bufferViews/" + std::to_string(v) + "/extensions/KHR_meshopt_compression",
                       "damaged meshopt data");
        ++refused;
      }
    }
    EXPECT_GT(refused, 100U);
  }
}

// A few bytes may stand for many, but memory is not for the asking.
TEST(GltfMeshopt, WhatUnfoldsTooFarIsRefused) {
  const std::size_t count = 1 << 20;
  const Bytes coded = encode_attributes(Bytes(count * 64).data(), count, 64);
  ASSERT_LT(coded.size() * 16, count * 64);
  Builder b;
  const std::size_t at = static_cast<std::size_t>(b.view(coded));
  Json extension = b.root["bufferViews"][at];
  extension.update({{"byteStride", 64}, {"count", count}, {"mode", "ATTRIBUTES"}});
  Json root = Json::parse(b.text());
  root["buffers"].push_back({{"byteLength", count * 64}});
  root["bufferViews"][at] = {
      {"buffer", 1}, {"byteLength", count * 64}, {"extensions", {{"EXT_meshopt_compression", extension}}}};
  root["extensionsUsed"] = {"EXT_meshopt_compression"};
  const std::string where = "/bufferViews/0/extensions/EXT_meshopt_compression";
  expect_refused(root.dump(), Exit::unsupported, where, "unfolds too far");
  Json& lying = root["bufferViews"][at]["extensions"]["EXT_meshopt_compression"];
  lying["count"] = root["bufferViews"][at]["byteLength"] = 1 << 14;
  lying["byteStride"] = 256;
  lying["byteLength"] = 64;
  root["bufferViews"][at]["byteLength"] = (1 << 14) * 256;
  expect_refused(root.dump(), Exit::invalid, where, "damaged meshopt data");
}

// Four unit vectors and more in K bits, by the library's encoder; its decoder may be off by one unit.
template <class T>
void expect_directions(int bits) {
  test::Random random(7);
  std::vector<float> directions;
  for (int i = 0; i < 400; ++i) {
    const glm::vec3 v = glm::normalize(
        glm::vec3(random.between(-1, 1), random.between(-1, 1), i % 50 == 0 ? 0 : random.between(-1, 1)));
    directions.insert(directions.end(), {v.x, v.y, v.z, i % 2 == 0 ? 1.0F : -1.0F});
  }
  std::vector<T> coded(directions.size());
  meshopt_encodeFilterOct(coded.data(), 400, 4 * sizeof(T), bits, directions.data());
  std::vector<T> theirs = coded, ours = coded;
  meshopt_decodeFilterOct(theirs.data(), 400, 4 * sizeof(T));
  gltf::unfold_octahedra(std::as_writable_bytes(std::span(ours)), 4 * sizeof(T));
  const double one = std::numeric_limits<T>::max(), coarse = 2.0 / (1 << (bits - 1)) + 1 / one;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    EXPECT_LE(std::abs(ours[i] - theirs[i]), 1) << i;
    if (i % 4 == 3) {
      EXPECT_EQ(ours[i], coded[i]);
    } else {
      EXPECT_NEAR(ours[i] / one, directions[i], coarse) << i;
    }
  }
}

TEST(GltfMeshopt, Octahedra) {
  expect_directions<std::int8_t>(8);
  expect_directions<std::int8_t>(6);
  expect_directions<std::int16_t>(12);
  expect_directions<std::int16_t>(16);
  std::array<std::int8_t, 8> none = {1, 2, 0, 9, -128, -128, -128, 9};
  gltf::unfold_octahedra(std::as_writable_bytes(std::span(none)), 4);
  EXPECT_EQ(none[3], 9);
}

TEST(GltfMeshopt, Quaternions) {
  test::Random random(8);
  std::vector<float> rotations;
  for (int i = 0; i < 400; ++i) {
    glm::vec4 q(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    q /= glm::length(q);
    rotations.insert(rotations.end(), {q.x, q.y, q.z, q.w});
  }
  for (const int bits : {6, 12, 16}) {
    std::vector<std::int16_t> coded(rotations.size());
    meshopt_encodeFilterQuat(coded.data(), 400, 8, bits, rotations.data());
    std::vector<std::int16_t> theirs = coded, ours = coded;
    meshopt_decodeFilterQuat(theirs.data(), 400, 8);
    gltf::restore_quaternions(std::as_writable_bytes(std::span(ours)));
    for (std::size_t i = 0; i < ours.size(); i += 4) {
      double cosine = 0;
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_LE(std::abs(ours[i + c] - theirs[i + c]), 1) << i;
        cosine += ours[i + c] / 32767.0 * double{rotations[i + c]};
      }
      EXPECT_GE(std::abs(cosine), 1 - 4.0 / (1 << (2 * bits - 2)) - 1e-4) << "the same turn, of either sign";
    }
  }
}

TEST(GltfMeshopt, Exponents) {
  std::vector<float> numbers = {0, 1, -1, 0.1F, -3e10F, 1e-10F, 65504, -1.0F / 3};
  std::vector<std::uint32_t> coded(numbers.size());
  meshopt_encodeFilterExp(coded.data(), 2, 16, 23, numbers.data());
  std::vector<std::uint32_t> theirs = coded, ours = coded;
  meshopt_decodeFilterExp(theirs.data(), 2, 16);
  gltf::restore_exponents(std::as_writable_bytes(std::span(ours)));
  EXPECT_EQ(ours, theirs) << "exactly";
  std::uint32_t half = 0xFF000003;  // 2^-1 · 3
  gltf::restore_exponents(std::as_writable_bytes(std::span(&half, 1)));
  EXPECT_EQ(std::bit_cast<float>(half), 1.5F);
}

// Luma and chromas by hand: r = y + o − g, green = y + g, b = y − o − g.
TEST(GltfMeshopt, Colours) {
  std::array<std::uint8_t, 12> four = {113, 74, 243 /* −13 */, 255, 31, 16, 240 /* −16 */, 32, 9, 9, 9, 0};
  gltf::restore_colours(std::as_writable_bytes(std::span(four)), 4);
  EXPECT_EQ(four, (std::array<std::uint8_t, 12>{200, 100, 52, 255, 255, 61, 125, 0, 0, 0, 0, 0}));
  std::array<std::uint16_t, 4> eight = {1000, 24, 65036 /* −500 */, 0x0FFF};  // twelve bits
  gltf::restore_colours(std::as_writable_bytes(std::span(eight)), 8);
  EXPECT_EQ(eight, (std::array<std::uint16_t, 4>{24390, 8002, 23621, 65535}));
}

}  // namespace
}  // namespace marrow::cook
